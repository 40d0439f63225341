# Usealle kosketustyökierrolle yhteistä.

# --- kulku ---
step-position-at-first-touch-point = Ohjaus paikoittaa kosketusjärjestelmän ensimmäiseen kosketuspisteeseen pikaliikkeellä (arvo sarakkeesta { $mp-positioning-feed }) ja paikoituslogiikalla. Se laskee kosketuspisteet työkierron tiedoista ja sarakkeen { $mp-set-up } varmuusetäisyydestä.
step-position-at-first-touch-point__tnc426-430 = Ohjaus paikoittaa kosketusjärjestelmän ensimmäiseen kosketuspisteeseen pikaliikkeellä (arvo koneparametrista { $mp-positioning-feed } tai { $mp-analog-positioning-feed }) ja paikoituslogiikalla. Se laskee kosketuspisteet työkierron tiedoista ja koneparametrin { $mp-set-up } varmuusetäisyydestä.
step-move-to-measuring-height = Kosketusjärjestelmä siirtyy mittauskorkeudelle { $q-measuring-height }.
step-probe-outward = Kosketusjärjestelmä tekee kosketuksen kosketussyöttöarvolla (sarake { $mp-probing-feed }). Ohjaus päättelee kosketussuunnan aloituskulmasta { $q-probing-starting-angle } ja kulma-askeleesta { $q-probing-stepping-angle }.
step-probe-outward__tnc426-430 = Kosketusjärjestelmä tekee kosketuksen kosketussyöttöarvolla ({ $mp-probing-feed } tai { $mp-analog-probing-feed }). Ohjaus päättelee kosketussuunnan aloituskulmasta { $q-probing-starting-angle } ja kulma-askeleesta { $q-probing-stepping-angle }.
step-travel-to-next-touch-point = Kosketusjärjestelmä siirtyy seuraavaan kosketuspisteeseen:
say-start-again-from-centre = jos tasku ja varmuusetäisyys eivät jätä tilaa esipaikoitukselle kosketuspisteiden lähellä, se pysyy keskipisteessä eikä aja varmuuskorkeudelle
say-travel-straight-at-clearance-height = jos { $q-traverse-to-clearance-height } = 1 ja { $q-probing-traverse-type } = 0, suoraa pitkin varmuuskorkeudella { $q-clearance-height }
say-travel-on-circle-at-clearance-height = jos { $q-traverse-to-clearance-height } = 1, ympyränkaarta pitkin varmuuskorkeudella { $q-clearance-height }
say-travel-on-circle-at-clearance-height__tnc640 = jos { $q-traverse-to-clearance-height } = 1 ja { $q-probing-traverse-type } = 1, ympyränkaarta pitkin varmuuskorkeudella { $q-clearance-height }
say-travel-on-circle-at-measuring-height = jos { $q-traverse-to-clearance-height } = 0, ympyränkaarta pitkin mittauskorkeudella { $q-measuring-height }
until-all-touch-points-probed = kaikkia kosketuspisteitä on kosketettu

# --- ehdot ---
condition-travel-at-clearance-height = kosketusjärjestelmä siirtyy varmuuskorkeudella ({ $q-traverse-to-clearance-height } = 1)
condition-probe-axis-wanted = { $q-probing-in-probe-axis } = 1

# --- tarkastukset ---
guard-probe-axis-undefined = Työkierron määrittelyä ei edellä työkalukutsu, joten kosketusakselia ei ole määritelty.
guard-transformation-active = Peilaus, mittakerroin tai akselikohtainen mittakerroin on voimassa. Mikään niistä ei saa olla voimassa kosketustyökierron aikana.
guard-basic-rotation-active = Peruskääntö on voimassa. Tätä työkiertoa ei saa suorittaa peruskäännön kanssa.
guard-stepping-angle-too-small = Kulma-askel { $q-probing-stepping-angle } on pienempi kuin 5°.
guard-tolerance-exceeded = Toleranssi on ylittynyt.
guard-tool-broken = Poikkeama on suurempi kuin työkalun rikkotoleranssi. Työkalulle on asetettu esto.

# --- ohjeet: kosketus yleensä ---
note-positioning-logic = Paikoituslogiikka: jos kosketusvarren etelänapa on varmuuskorkeuden { $q-clearance-height } alapuolella, ohjaus vetää kosketusjärjestelmän ensin kosketusakselin suunnassa varmuuskorkeudelle ja paikoittaa sen sitten koneistustasossa ensimmäiseen kosketuspisteeseen. Jos se on varmuuskorkeuden yläpuolella, ohjaus paikoittaa kosketusjärjestelmän ensin koneistustasossa ensimmäiseen kosketuspisteeseen ja ajaa sen sitten kosketusakselin suunnassa suoraan mittauskorkeudelle { $q-measuring-height }.
note-tool-call-before-definition = Ohjelmoi ennen työkierron määrittelyä työkalukutsu, joka määrittelee kosketusakselin.
note-no-mirror-or-scaling-while-probing = Kosketustyökiertojen suorituksen aikana peilaus (työkierto 8), mittakerroin (työkierto 11) ja akselikohtainen mittakerroin (työkierto 26) eivät saa olla voimassa.
note-transformations-while-probing = Kosketustyökiertojen suorituksen aikana mikään koordinaattimuunnoksen työkierto ei saa olla voimassa: nollapiste (7), peilaus (8), kierto (10), mittakerroin (11 ja 26), koneistustaso (19).
note-heidenhain-probes-only = Kosketustyökiertojen toiminta taataan vain HEIDENHAIN-kosketusjärjestelmillä.
note-prepare-for-3d-probes = Koneen valmistajan on valmisteltava ohjaus 3D-kosketusjärjestelmiä varten. Katso koneen käyttöohjekirjaa.
note-compensation-data-for-probing = Varmista, että työkierron alussa ovat voimassa halutut korjaustiedot (pituus, säde): kalibrointitiedot tai viimeisen TOOL CALL -lauseen tiedot. Ne valitaan koneparametrilla { $mp-calibration-data-source }.
note-no-contact-within-distance = Jos kosketusvarsi ei taivu matkalla { $mp-probing-distance }, ohjaus antaa virheilmoituksen.
note-set-up-is-pre-position = { $mp-set-up } on etäisyys kosketuspisteestä, jolle ohjaus esipaikoittaa kosketusjärjestelmän. Mitä pienempi se on, sitä tarkemmin kosketuspisteet on määriteltävä.
note-track-orients-probe = Kun { $mp-track } = ON, ohjaus suuntaa infrapunakosketusjärjestelmän ennen jokaista kosketusta ohjelmoituun kosketussuuntaan, jolloin kosketusvarsi taipuu aina samaan suuntaan; se parantaa mittaustarkkuutta. Kalibroi kosketusjärjestelmä uudelleen, jos muutat { $mp-track }-asetusta.
note-pre-positioning-speed = { $mp-pre-positioning } valitsee esipaikoituksen nopeuden: FMAX_PROBE on sarakkeen { $mp-positioning-feed } syöttöarvo, FMAX_MACHINE koneen pikaliike.
note-multiple-measurement = Mittauksen luotettavuuden parantamiseksi ohjaus voi tehdä jokaisen kosketuksen enintään kolme kertaa peräkkäin; kertojen lukumäärän ja suoja-alueen määräävät koneparametrit kohdassa { $mp-probe-settings } (kosketuskäyttäytyminen, automaattikäyttö). Jos mittausarvot poikkeavat toisistaan suoja-aluetta enemmän, ohjaus antaa virheilmoituksen, muuten se tallentaa niiden keskiarvon. Näin voidaan havaita esimerkiksi liasta johtuvat mittausvirheet.
note-multiple-measurement__tnc426-430 = Mittauksen luotettavuuden parantamiseksi ohjaus voi tehdä jokaisen kosketuksen enintään kolme kertaa peräkkäin; kertojen lukumäärän määrää { $mp-multiple-measurement }, suoja-alueen { $mp-confidence-range }. Jos mittausarvot poikkeavat toisistaan suoja-aluetta enemmän, ohjaus antaa virheilmoituksen, muuten se tallentaa niiden keskiarvon. Näin voidaan havaita esimerkiksi liasta johtuvat mittausvirheet.
note-step-below-90-for-arcs = Jos haluat mitata täysympyrän sijasta ympyränkaaren, ohjelmoi alle 90°:n kulma-askel { $q-probing-stepping-angle }.
note-smallest-stepping-angle = Mitä pienempi kulma-askel { $q-probing-stepping-angle } on, sitä epätarkemmin ohjaus laskee peruspisteen. Pienin sisäänsyöttöarvo: 5°.
note-smallest-stepping-angle__measure-hole = Mitä pienempi kulma-askel { $q-probing-stepping-angle } on, sitä epätarkemmin ohjaus laskee reiän mitat. Pienin sisäänsyöttöarvo: 5°.
note-small-stepping-angle-less-exact = Mitä pienempi kulma-askel { $q-probing-stepping-angle } on, sitä epätarkemmin ohjaus laskee keskipisteen.
note-small-stepping-angle-less-exact__datum-inside-circle = Mitä pienempi kulma-askel { $q-probing-stepping-angle } on, sitä epätarkemmin ohjaus laskee peruspisteen.
note-results-in-active-system = Ohjaus antaa kaikki tulokset sekä tulosparametreissa että pöytäkirjatiedostossa aktiivisessa koordinaatistossa, joka voi olla siirretty, kierretty tai käännetty.
note-results-in-active-system__tnc320 = Ohjaus antaa kaikki tulokset sekä tulosparametreissa että pöytäkirjatiedostossa aktiivisessa koordinaatistossa, joka voi olla siirretty ja/tai kierretty.
note-results-in-active-system__tnc426-430 = Ohjaus antaa kaikki tulokset sekä tulosparametreissa että pöytäkirjatiedostossa aktiivisessa koordinaatistossa, joka voi olla siirretty.
note-results-in-q-parameters = Mittaustulokset ovat sen jälkeen yleisesti voimassa olevissa Q-parametreissa Q150 … Q160, joita ohjelma voi käyttää.
note-deviations-in-q-parameters = Mittaustulokset ovat sen jälkeen yleisesti voimassa olevissa Q-parametreissa Q150 … Q160, poikkeamat asetusarvoista parametreissa Q161 … Q166. Työkiertoa määriteltäessä apukuvassa näkyvät myös tulosparametrit; vaaleataustainen tulosparametri kuuluu valittuun sisäänsyöttöparametriin.
note-deviations-in-q-parameters__tnc426-430 = Mittaustulokset ovat sen jälkeen yleisesti voimassa olevissa Q-parametreissa Q150 … Q160, poikkeamat asetusarvoista parametreissa Q161 … Q166. Työkiertoa määriteltäessä apukuvassa näkyvät myös tulosparametrit.

# --- tulokset ---
result-centre-main-actual = Keskipisteen todellisarvo pääakselilla
result-centre-minor-actual = Keskipisteen todellisarvo sivuakselilla
result-diameter-actual = Halkaisijan todellisarvo
