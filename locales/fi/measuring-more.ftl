# Työkierrot, jotka mittaavat kulmia, kauloja, suorakulmioita, leveyksiä, koordinaatteja, reikäympyröitä ja tasoja.

# --- yhteiset ---
say-part-is-scrap = hylky (Q182 = 1), jos mittausarvo on toleranssin ulkopuolella eikä ole korjattavissa
say-part-needs-rework = jälkityö (Q181 = 1), jos mittausarvo on toleranssin ulkopuolella ja korjattavissa

# --- 422 ---
cycle-measure-stud = Ympyrän ulkopuolinen mittaus (kaula)
    .nc = MITTAUS YMP. ULKOP.
    .nc-aliases = YMPYRÄN MITTAUS ULKOP
    .purpose = Työkierto mittaa ympyräkaulan keskipisteen ja halkaisijan. Jos työkierrossa on määritelty toleranssit, ohjaus vertaa asetusarvoja ja todellisarvoja ja tallentaa poikkeamat parametreihin.
say-part-is-scrap__measure-stud = hylky (Q182 = 1), jos kaula on pienempi kuin { $q-stud-least-diameter } tai sen keskipiste poikkeaa enemmän kuin { $q-centre-tolerance-main } tai { $q-centre-tolerance-minor } sallii
say-part-needs-rework__measure-stud = jälkityö (Q181 = 1), jos kaula on suurempi kuin { $q-stud-greatest-diameter }
note-smallest-stepping-angle__measure-stud = Mitä pienempi kulma-askel { $q-probing-stepping-angle } on, sitä epätarkemmin ohjaus laskee kaulan mitat. Pienin sisäänsyöttöarvo: 5°.

# --- 423, 424 ---
cycle-measure-rectangular-pocket = Suorakulmion sisäpuolinen mittaus (tasku)
    .nc = MITTAUS SUORAK. SISÄP.
    .nc-aliases = SUORAK MITTAUS SISÄP. | SUORAK MITTAUS SISÄP
    .purpose = Työkierto mittaa suorakulmataskun keskipisteen, pituuden ja leveyden. Jos työkierrossa on määritelty toleranssit, ohjaus vertaa asetusarvoja ja todellisarvoja ja tallentaa poikkeamat parametreihin.
cycle-measure-rectangular-stud = Suorakulmion ulkopuolinen mittaus (kaula)
    .nc = MITTAUS SUORAK. ULKOP.
    .nc-aliases = SUORAK MITTAUS ULKOP
    .purpose = Työkierto mittaa suorakulmakaulan keskipisteen, pituuden ja leveyden. Jos työkierrossa on määritelty toleranssit, ohjaus vertaa asetusarvoja ja todellisarvoja ja tallentaa poikkeamat parametreihin.
say-part-is-scrap__measure-rectangular-pocket = hylky (Q182 = 1), jos jokin sivu on pidempi kuin { $q-first-side-greatest-length } tai { $q-second-side-greatest-length } tai keskipiste poikkeaa enemmän kuin { $q-centre-tolerance-main } tai { $q-centre-tolerance-minor } sallii
say-part-needs-rework__measure-rectangular-pocket = jälkityö (Q181 = 1), jos jokin sivu on lyhyempi kuin { $q-first-side-least-length } tai { $q-second-side-least-length }
say-part-is-scrap__measure-rectangular-stud = hylky (Q182 = 1), jos jokin sivu on lyhyempi kuin { $q-first-side-least-length } tai { $q-second-side-least-length } tai keskipiste poikkeaa enemmän kuin { $q-centre-tolerance-main } tai { $q-centre-tolerance-minor } sallii
say-part-needs-rework__measure-rectangular-stud = jälkityö (Q181 = 1), jos jokin sivu on pidempi kuin { $q-first-side-greatest-length } tai { $q-second-side-greatest-length }
result-side-main-deviation = Sivun pituuden poikkeama pääakselilla
result-side-minor-deviation = Sivun pituuden poikkeama sivuakselilla
title-measure-and-rework-rectangular-stud = Suorakulmakaulan mittaus ja silitys mitattujen arvojen mukaan
title-measure-rectangular-pocket-with-log = Suorakulmataskun mittaus ja tulosten kirjaus pöytäkirjaan

# --- 425, 426 ---
cycle-measure-slot-width = Uran leveyden mittaus
    .nc = MITTAUS SISÄLEVEYS
    .nc-aliases = URAN LEV MITTAUS SISÄP
    .purpose = Työkierto mittaa uran (taskun) sijainnin ja leveyden. Jos työkierrossa on määritelty toleranssit, ohjaus vertaa asetusarvoja ja todellisarvoja ja tallentaa poikkeaman parametriin.
cycle-measure-ridge-width = Uuman leveyden mittaus
    .nc = UUMAN MITTAUS ULKOP
    .purpose = Työkierto mittaa uuman sijainnin ja leveyden. Jos työkierrossa on määritelty toleranssit, ohjaus vertaa asetusarvoja ja todellisarvoja ja tallentaa poikkeaman parametriin.
step-probe-first-in-positive-direction = Kosketusjärjestelmä tekee ensimmäisen kosketuksen kosketussyöttöarvolla (sarake { $mp-probing-feed }), aina ohjelmoidun akselin positiiviseen suuntaan.
step-probe-first-in-positive-direction__tnc426-430 = Kosketusjärjestelmä tekee ensimmäisen kosketuksen kosketussyöttöarvolla ({ $mp-probing-feed } tai { $mp-analog-probing-feed }), aina ohjelmoidun akselin positiiviseen suuntaan.
step-probe-first-in-negative-direction = Kosketusjärjestelmä tekee ensimmäisen kosketuksen kosketussyöttöarvolla (sarake { $mp-probing-feed }), aina ohjelmoidun akselin negatiiviseen suuntaan.
step-probe-first-in-negative-direction__tnc426-430 = Kosketusjärjestelmä tekee ensimmäisen kosketuksen kosketussyöttöarvolla ({ $mp-probing-feed } tai { $mp-analog-probing-feed }), aina ohjelmoidun akselin negatiiviseen suuntaan.
step-probe-second-side-of-slot = Kosketusjärjestelmä tekee toisen kosketuksen parametrin { $q-second-measurement-offset } mukaan:
step-probe-second-side-of-slot__tnc640 = Jos asetuspituus on suuri, ohjaus ajaa toiseen kosketuspisteeseen pikaliikkeellä. Kosketusjärjestelmä tekee toisen kosketuksen parametrin { $q-second-measurement-offset } mukaan:
say-offset-second-measurement = jos { $q-second-measurement-offset } ei ole 0, ohjaus siirtää kosketusjärjestelmän akselin suuntaisesti tämän siirtymän verran seuraavaan kosketuspisteeseen ja tekee siellä kosketuksen
say-offset-second-measurement__tnc640 = jos { $q-second-measurement-offset } ei ole 0, ohjaus siirtää kosketusjärjestelmän tämän siirtymän verran seuraavaan kosketuspisteeseen (jos { $q-traverse-to-clearance-height } = 1, varmuuskorkeudella { $q-clearance-height }) ja tekee siellä kosketuksen
say-measure-in-opposite-direction = jos { $q-second-measurement-offset } = 0, se mittaa leveyden suoraan vastakkaiseen suuntaan
step-probe-second-side-of-ridge = Kosketusjärjestelmä siirtyy varmuuskorkeudella { $q-clearance-height } seuraavaan kosketuspisteeseen ja tekee siellä toisen kosketuksen.
say-part-is-scrap__measure-slot-width = hylky (Q182 = 1), jos ura on leveämpi kuin { $q-greatest-dimension }
say-part-needs-rework__measure-slot-width = jälkityö (Q181 = 1), jos ura on kapeampi kuin { $q-least-dimension }
say-part-is-scrap__measure-ridge-width = hylky (Q182 = 1), jos uuma on kapeampi kuin { $q-least-dimension }
say-part-needs-rework__measure-ridge-width = jälkityö (Q181 = 1), jos uuma on leveämpi kuin { $q-greatest-dimension }
note-clearance-acts-in-probe-axis-only = Varmuusetäisyys { $q-probing-clearance } vaikuttaa vain, kun kosketusakselin peruspistettä kosketetaan.
result-measured-length-actual = Mitatun pituuden todellisarvo
result-measured-length-deviation = Mitatun pituuden poikkeama

# --- 427 ---
cycle-measure-coordinate = Koordinaatin mittaus
    .nc = KOORDINAATIN MITTAUS
    .purpose = Työkierto mittaa koordinaatin valittavalla akselilla ja tallentaa arvon parametriin. Jos työkierrossa on määritelty toleranssit, ohjaus vertaa asetusarvoja ja todellisarvoja ja tallentaa poikkeamat parametreihin.
step-position-against-traverse-direction = Ohjaus paikoittaa kosketusjärjestelmän ohjelmoituun kosketuspisteeseen pikaliikkeellä (arvo sarakkeesta { $mp-positioning-feed }) ja paikoituslogiikalla. Se siirtää kosketusjärjestelmää varmuusetäisyyden verran liikesuuntaa { $q-traverse-direction } vastaan.
step-position-against-traverse-direction__tnc426-430 = Ohjaus paikoittaa kosketusjärjestelmän ohjelmoituun kosketuspisteeseen pikaliikkeellä (arvo koneparametrista { $mp-positioning-feed } tai { $mp-analog-positioning-feed }) ja paikoituslogiikalla. Se siirtää kosketusjärjestelmää varmuusetäisyyden verran liikesuuntaa { $q-traverse-direction } vastaan.
step-probe-coordinate = Ohjaus paikoittaa kosketusjärjestelmän koneistustasossa ohjelmoituun kosketuspisteeseen ja mittaa siellä todellisarvon valitulla akselilla.
step-retract-and-store-measured-coordinate = Ohjaus palauttaa kosketusjärjestelmän varmuuskorkeudelle { $q-clearance-height } ja tallentaa mitatun koordinaatin tulosparametriin.
say-part-is-scrap__measure-coordinate = hylky (Q182 = 1), jos mitattu koordinaatti on pienempi kuin { $q-least-dimension }
say-part-needs-rework__measure-coordinate = jälkityö (Q181 = 1), jos mitattu koordinaatti on suurempi kuin { $q-greatest-dimension }
say-correct-tool-length = jos { $q-monitored-tool } ei ole 0 ja { $q-measuring-axis } = 3, se korjaa työkalun pituutta työkalutaulukon sarakkeessa DL; jos poikkeama on suurempi kuin rikkotoleranssi RBREAK, se antaa virheilmoituksen, pysäyttää ohjelmanajon ja asettaa työkalulle eston (sarake TL = L)
say-correct-tool-radius__measure-coordinate = jos { $q-monitored-tool } ei ole 0 ja { $q-measuring-axis } = 1 tai 2, se korjaa delta-sädettä työkalutaulukon sarakkeessa DR parametrista { $q-traverse-direction } määräytyvään suuntaan; jos poikkeama on suurempi kuin rikkotoleranssi RBREAK, se antaa virheilmoituksen, pysäyttää ohjelmanajon ja asettaa työkalulle eston (sarake TL = L)
note-coordinate-is-outside-dimension = Ohjaus olettaa, että mitataan ulkomitta (kaula). Muissa tapauksissa mittauksen tila saadaan oikeaksi valitsemalla suurin ja pienin mitta sekä kosketussuunta sopivasti.
note-coordinate-corrects-radius-or-length = Jos mittausakselina on koneistustason akseli ({ $q-measuring-axis } = 1 tai 2), ohjaus korjaa työkalun sädettä; korjauksen suunta määräytyy liikesuunnasta { $q-traverse-direction }. Jos mittausakselina on kosketusakseli ({ $q-measuring-axis } = 3), se korjaa työkalun pituutta.
result-measured-coordinate__measure-coordinate = Mitattu koordinaatti

# --- 430 ---
cycle-measure-bolt-hole-circle = Reikäympyrän mittaus
    .nc = REIKÄYMPYRÄN MITTAUS
    .purpose = Työkierto mittaa reikäympyrän keskipisteen ja halkaisijan mittaamalla sen kolme reikää. Jos työkierrossa on määritelty toleranssit, ohjaus vertaa asetusarvoja ja todellisarvoja ja tallentaa poikkeamat parametreihin.
step-measure-centre-of-hole = Kosketusjärjestelmä siirtyy mittauskorkeudelle { $q-measuring-height } ja määrittää reiän keskipisteen neljällä kosketuksella.
step-travel-to-next-hole = Kosketusjärjestelmä palaa varmuuskorkeudelle { $q-clearance-height } ja paikoittuu seuraavan reiän annettuun keskipisteeseen.
until-three-holes-measured = kaikkien kolmen reiän keskipisteet on määritetty
say-part-is-scrap__measure-bolt-hole-circle = hylky (Q182 = 1), jos halkaisija on suurempi kuin { $q-greatest-dimension } tai pienempi kuin { $q-least-dimension } tai keskipiste poikkeaa enemmän kuin { $q-centre-tolerance-main } tai { $q-centre-tolerance-minor } sallii
say-monitor-tool-breakage = jos { $q-monitored-tool } ei ole 0, se vertaa poikkeamaa rikkotoleranssiin RBREAK; jos poikkeama on suurempi, se antaa virheilmoituksen, pysäyttää ohjelmanajon ja asettaa työkalulle eston (sarake TL = L). Työkalua se ei korjaa
note-only-breakage-monitoring = Tämä työkierto valvoo vain työkalun rikkoutumista; se ei korjaa työkalua.
result-bolt-circle-diameter-actual = Reikäympyrän halkaisijan todellisarvo
result-bolt-circle-diameter-deviation = Reikäympyrän halkaisijan poikkeama

# --- 420 ---
cycle-measure-angle = Kulman mittaus
    .nc = KULMAN MITTAUS
    .purpose = Työkierto mittaa suoran ja koneistustason pääakselin välisen kulman.
say-travel-to-point-at-clearance-height = jos { $q-traverse-to-clearance-height } = 1, varmuuskorkeudella { $q-clearance-height }
say-travel-to-point-at-measuring-height = jos { $q-traverse-to-clearance-height } = 0, mittauskorkeudella { $q-measuring-height }
step-retract-and-store-angle = Ohjaus palauttaa kosketusjärjestelmän varmuuskorkeudelle { $q-clearance-height } ja tallentaa mitatun kulman tulosparametriin.
note-angle-about-a-or-b = Jos mittausakselina on kosketusakseli ({ $q-measuring-axis } = 3): kun mitataan kulma A-akselin ympäri, anna parametreille { $q-first-point-main } ja { $q-second-point-main } sama arvo; kun mitataan kulma B-akselin ympäri, anna niille eri arvot.
note-results-shown-in-help-graphic = Työkiertoa määriteltäessä apukuvassa näkyvät myös tulosparametrit; vaaleataustainen tulosparametri kuuluu valittuun sisäänsyöttöparametriin.
note-results-shown-in-help-graphic__tnc426-430 = Työkiertoa määriteltäessä apukuvassa näkyvät myös tulosparametrit.
result-measured-angle = Mitattu kulma koneistustason pääakselin suhteen

# --- 431 ---
cycle-measure-plane = Tason mittaus
    .nc = TASON MITTAUS
    .purpose = Työkierto määrittää tason kulmat kolmesta mitatusta pisteestä ja tallentaa arvot parametreihin.
step-measure-first-point-of-plane = Ohjaus paikoittaa kosketusjärjestelmän ohjelmoituun ensimmäiseen kosketuspisteeseen pikaliikkeellä (arvo sarakkeesta { $mp-positioning-feed }) ja paikoituslogiikalla ja mittaa siellä tason ensimmäisen pisteen. Se siirtää kosketusjärjestelmää varmuusetäisyyden verran kosketussuuntaa vastaan.
step-measure-first-point-of-plane__tnc426-430 = Ohjaus paikoittaa kosketusjärjestelmän ohjelmoituun ensimmäiseen kosketuspisteeseen pikaliikkeellä (arvo koneparametrista { $mp-positioning-feed } tai { $mp-analog-positioning-feed }) ja paikoituslogiikalla ja mittaa siellä tason ensimmäisen pisteen. Se siirtää kosketusjärjestelmää varmuusetäisyyden verran kosketussuuntaa vastaan.
step-measure-second-point-of-plane = Kosketusjärjestelmä palaa varmuuskorkeudelle { $q-clearance-height } ja siirtyy koneistustasossa toiseen kosketuspisteeseen, jossa ohjaus mittaa tason toisen pisteen todellisarvon.
step-measure-third-point-of-plane = Kosketusjärjestelmä palaa varmuuskorkeudelle { $q-clearance-height } ja siirtyy koneistustasossa kolmanteen kosketuspisteeseen, jossa ohjaus mittaa tason kolmannen pisteen todellisarvon.
step-retract-and-store-plane-angles = Ohjaus palauttaa kosketusjärjestelmän varmuuskorkeudelle { $q-clearance-height } ja tallentaa kulmat tulosparametreihin.
guard-points-on-one-line = Kaikki kolme mittauspistettä ovat samalla suoralla. Ohjaus ei voi laskea tason kulmia.
note-positioning-logic__measure-plane = Paikoituslogiikka: jos kosketusvarren etelänapa on varmuuskorkeuden { $q-clearance-height } alapuolella, ohjaus vetää kosketusjärjestelmän ensin kosketusakselin suunnassa varmuuskorkeudelle ja paikoittaa sen sitten koneistustasossa ensimmäiseen kosketuspisteeseen. Jos se on varmuuskorkeuden yläpuolella, ohjaus paikoittaa kosketusjärjestelmän ensin koneistustasossa ensimmäiseen kosketuspisteeseen ja ajaa sen sitten kosketusakselin suunnassa suoraan mittauskorkeudelle.
note-three-points-not-on-a-line = Kaikki kolme mittauspistettä eivät saa olla samalla suoralla: vain silloin ohjaus voi laskea kulmat.
note-spatial-angles-for-tilting = Parametreissa Q170–Q172 ovat koneistustason käännössä tarvittavat tilakulmat. Kaksi ensimmäistä mittauspistettä määrää pääakselin suunnan, kun koneistustasoa käännetään.
note-third-point-sets-tool-axis = Kolmas mittauspiste määrää työkaluakselin suunnan. Määrittele se positiivisen Y-akselin suuntaan, jotta työkaluakseli on oikein oikeakätisessä koordinaatistossa.
note-spatial-angle-in-tilted-plane = Jos työkierto suoritetaan koneistustason ollessa käännettynä, mitatut tilakulmat perustuvat käännettyyn koordinaatistoon. Käytä niitä koneistustason käännössä inkrementaalisina arvoina.
result-projection-angle-a = A-akselin projektiokulma
result-projection-angle-a__tnc426-430 = A-akselin kulma
result-projection-angle-b = B-akselin projektiokulma
result-projection-angle-b__tnc426-430 = B-akselin kulma
result-spatial-angle-a = Tilakulma A
result-spatial-angle-b = Tilakulma B
result-spatial-angle-c = Tilakulma C
result-first-value-in-probe-axis = Mittausarvo kosketusakselilla (ensimmäinen mittaus)
result-first-value-in-probe-axis__tnc320 = Mittausarvo kosketusjärjestelmän akselilla
result-second-value-in-probe-axis = Mittausarvo kosketusakselilla (toinen mittaus)
result-third-value-in-probe-axis = Mittausarvo kosketusakselilla (kolmas mittaus)

# --- 1 ---
cycle-polar-reference-plane = Perustaso polaarinen
    .nc = PERUSTASO POLAARINEN
    .purpose = Työkierto mittaa minkä tahansa aseman työkappaleessa missä tahansa kulmalla annetussa kosketussuunnassa.
step-probe-at-polar-angle = Kosketusjärjestelmä tekee kosketuksen kosketussyöttöarvolla (sarake { $mp-probing-feed }). Kosketuksen aikana ohjaus liikuttaa kosketuskulmasta riippuen samanaikaisesti kahta akselia. Kosketussuunta määritellään työkierrossa napakulmalla.
step-probe-at-polar-angle__tnc426-430 = Kosketusjärjestelmä tekee kosketuksen kosketussyöttöarvolla ({ $mp-probing-feed } tai { $mp-analog-probing-feed }). Kosketuksen aikana ohjaus liikuttaa kosketuskulmasta riippuen samanaikaisesti kahta akselia. Kosketussuunta määritellään työkierrossa napakulmalla.
step-return-and-store-trigger-position = Kun asema on mitattu, kosketusjärjestelmä palaa kosketuksen alkupisteeseen. Ohjaus tallentaa parametreihin Q115–Q119 sen aseman koordinaatit, jossa kosketusjärjestelmä oli kytkentäsignaalin hetkellä.
step-return-and-store-trigger-position__tnc426-430 = Kun asema on mitattu, kosketusjärjestelmä palaa kosketuksen alkupisteeseen. Ohjaus tallentaa parametreihin Q115–Q119 kosketuskuulan keskipisteen koordinaatit työkappaleen kosketushetkellä.
note-probing-plane-by-axis = Kosketustaso määräytyy työkierrossa annetusta kosketusakselista. Kosketusakseli X: X/Y-taso; Y: Y/Z-taso; Z: Z/X-taso.
note-trigger-position-of-ball-centre = Parametreissa Q115–Q119 ovat kosketuskuulan keskipisteen koordinaatit työkappaleen kosketushetkellä.

# --- 3 ---
cycle-measuring = Mittaus
    .nc = MITTAUS
    .purpose = Työkierto mittaa minkä tahansa aseman työkappaleessa valittavassa kosketussuunnassa. Toisin kuin muissa mittaustyökierroissa, mittausliike ja mittaussyöttöarvo annetaan suoraan tässä työkierrossa, samoin vetäytyminen mittauksen jälkeen. Sen avulla laaditaan koneen valmistajan työkiertoja.
cycle-measuring__tnc426-430 =
    .purpose = Työkierto mittaa minkä tahansa aseman työkappaleessa valittavassa kosketussuunnassa. Toisin kuin muissa mittaustyökierroissa, mittaussyöttöarvo annetaan suoraan tässä työkierrossa. Se on erikoiskäyttöön tarkoitettu mittaustyökierto.
step-move-in-polar-direction = Kosketusjärjestelmä siirtyy hetkellisasemastaan annetulla syöttöarvolla ohjelmoituun kosketussuuntaan. Kosketussuunta määritellään työkierrossa napakulmalla.
step-stop-and-store-ball-centre = Kun ohjaus on mitannut aseman, kosketusjärjestelmä pysähtyy. Ohjaus tallentaa kosketuskuulan keskipisteen koordinaatit X, Y ja Z kolmeen peräkkäiseen Q-parametriin pituutta ja sädettä korjaamatta. Ensimmäisen tulosparametrin numero määritellään työkierrossa.
step-stop-and-store-ball-centre__tnc426-430 = Kun ohjaus on mitannut aseman, kosketusjärjestelmä pysähtyy. Ohjaus tallentaa kosketuskuulan keskipisteen koordinaatit kolmeen peräkkäiseen Q-parametriin. Ensimmäisen parametrin numero määritellään työkierrossa.
result-ball-centre-and-status = Kosketuskuulan keskipisteen X; kahdessa seuraavassa parametrissa ovat Y ja Z, neljännessä −1, jos kelvollista kosketuspistettä ei ollut
result-ball-centre-and-status__tnc426-430 = Kosketuskuulan keskipisteen ensimmäinen koordinaatti; muut ovat kahdessa seuraavassa parametrissa
note-probe-data-without-effect = Kosketusjärjestelmän tiedot { $mp-probing-distance } (suurin liike kosketuspisteeseen) ja { $mp-probing-feed } (kosketussyöttöarvo), jotka vaikuttavat muissa mittaustyökierroissa, eivät vaikuta tässä työkierrossa.
note-four-parameters-overwritten = Ohjaus kirjoittaa aina neljään peräkkäiseen Q-parametriin.
note-no-touch-point-no-error = Jos ohjaus ei löydä kelvollista kosketuspistettä, ohjelma jatkuu ilman virheilmoitusta. Ohjaus sijoittaa silloin neljänteen tulosparametriin arvon −1, jotta ohjelma voi reagoida virheeseen.
note-retraction-not-beyond-start = Ohjaus vetää kosketusjärjestelmää enintään vetäytymisliikkeen MB verran, ei kuitenkaan mittauksen alkupistettä pitemmälle. Vetäytymisessä ei siksi voi tapahtua törmäystä.
note-probe-input-by-function = Toiminto FN17: SYSWRITE ID 990 NR 6 määrää, vaikuttaako työkierto kosketusjärjestelmän tuloon X12 vai X13.
note-available-from-software-474 = Tämä työkierto on käytettävissä NC-ohjelmistosta 280 474-xx lähtien.
note-behaviour-defined-by-builder = Koneen valmistaja tai ohjelmiston toimittaja määrittelee työkierron tarkan toiminnan; sitä käytetään erityisissä kosketustyökierroissa.
