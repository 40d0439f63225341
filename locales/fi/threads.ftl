# Kierreporaus ja kierteen jyrsintä.

# --- kierreporaus ---
cycle-tapping = Kierreporaus tasausistukalla (uusi)
    .nc = KIERREPORAUS UUSI
    .purpose = Työkierto tekee kierteen yhdellä liikkeellä tasausistukkaa käyttäen.
cycle-rigid-tapping = Kierreporaus ilman tasausistukkaa (uusi)
    .nc = JÄYKKÄ KIERREPORAUS UUSI
    .purpose = Työkierto tekee kierteen yhdellä liikkeellä ilman tasausistukkaa.
cycle-tapping-with-chip-breaking = Kierreporaus lastunkatkolla
    .nc = KIERREPORAUS LASTUNKATKOLLA
    .purpose = Työkierto tekee kierteen useilla asetusliikkeillä ilman tasausistukkaa. Parametri määrää, vedetäänkö työkalu lastua katkaistaessa kokonaan ulos reiästä.
step-tap-in-one-movement = Työkalu ajaa kierteen syvyyteen { $q-thread-depth } yhdellä liikkeellä.
step-reverse-dwell-and-retract = Karan pyörintäsuunta vaihdetaan, ja odotusajan { $q-dwell-at-bottom } jälkeen työkalu vetäytyy varmuusetäisyydelle { $q-set-up-clearance }.
step-reverse-and-retract = Karan pyörintäsuunta vaihdetaan, ja työkalu vetäytyy varmuusetäisyydelle { $q-set-up-clearance }.
step-reverse-spindle-again = Varmuusetäisyydellä karan pyörintäsuunta vaihdetaan uudelleen.
step-stop-spindle-at-set-up-clearance = Ohjaus pysäyttää karan varmuusetäisyydellä.
step-rapid-to-set-up-clearance-and-orient = Ohjaus siirtää työkalun karan akselin suunnassa pikaliikkeellä (FMAX) varmuusetäisyydelle { $q-set-up-clearance } työkappaleen yläpinnan yläpuolelle ja suuntaa siellä karan kulmaan { $q-spindle-orientation-angle }.
step-tap-to-next-depth = Työkalu ajaa asetusliikkeen { $q-depth-for-chip-breaking } verran syvemmälle.
step-reverse-and-break-chip = Karan pyörintäsuunta vaihdetaan lastun katkaisemiseksi ja sitten uudelleen seuraavaa asetusliikettä varten. Välillä työkalu liikkuu takaisin kertoimella { $q-retraction-speed-factor } suurennetulla kierrosluvulla, jos kerroin on annettu:
say-tap-leaves-hole = { $q-chip-breaking-turns } = 0: kokonaan reiästä jäähtymään
say-tap-goes-back-some-turns = muussa tapauksessa { $q-chip-breaking-turns } kertaa kierteen nousun { $q-thread-pitch } verran
step-tap-back-to-set-up-clearance = Työkalu palaa varmuusetäisyydelle { $q-set-up-clearance }.
note-sign-of-thread-depth = Kierteen syvyyden { $q-thread-depth } etumerkki määrää työskentelysuunnan. Jos kierteen syvyys on 0, ohjaus ei suorita työkiertoa.
note-thread-depth-gives-direction = Kierteen syvyyden { $q-thread-depth } etumerkki määrää työskentelysuunnan.
note-positive-thread-depth-reverses = Törmäysvaara! Jos syvyys on positiivinen, ohjaus laskee esipaikoituksen käänteisesti: työkalu siirtyy työkaluakselin suunnassa pikaliikkeellä varmuusetäisyydelle työkappaleen yläpinnan alapuolelle.
note-floating-tap-holder = Työkalun on oltava kiinnitetty tasausistukkaan, joka tasaa syöttöarvon ja karan kierrosluvun toleranssit koneistuksen aikana.
note-overrides-while-tapping = Karan kierrosluvun muunnoskytkin ei vaikuta työkierron suorituksen aikana. Syötön muunnoskytkin vaikuttaa osittain; koneen valmistaja määrää, miten (katso koneen käyttöohjekirjaa).
note-right-hand-with-m3 = Käynnistä kara oikeakätisille kierteille koodilla M3, vasenkätisille kierteille koodilla M4.
note-feed-from-speed-and-pitch = Laske syöttöarvo kaavalla F = S × p. F: syöttöarvo (mm/min), S: karan kierrosluku (r/min), p: kierteen nousu (mm).
note-retract-after-interruption = Jos ulkoista pysäytyspainiketta painetaan kierreporauksen aikana, ohjaus näyttää ohjelmanäppäimen, jolla työkalu voidaan vetää irti reiästä.
note-feed-follows-spindle-speed = Ohjaus laskee syöttöarvon karan kierrosluvusta. Jos syötön muunnoskytkintä käännetään kierreporauksen aikana, ohjaus sovittaa syöttöarvon itse. Karan kierrosluvun muunnoskytkin ei ole käytössä.
note-spindle-stopped-after-tapping = Työkierron lopussa kara on pysähdyksissä. Käynnistä se koodilla M3 (tai M4) ennen seuraavaa koneistusta.
note-retract-by-soft-key = Jos ulkoista pysäytyspainiketta painetaan kierreporauksen aikana, ohjaus näyttää käsiajon ohjelmanäppäimen. Kun sitä on painettu, työkalu voidaan vetää irti reiästä hallitusti aktiivisen karan akselin positiivisella suuntapainikkeella.
note-retraction-speed-is-limited = Jos parametrissa { $q-retraction-speed-factor } on määritelty kierroslukukerroin nopeampaa vetäytymistä varten, ohjaus rajoittaa kierrosluvun aktiivisen vaihdealueen suurimpaan sallittuun arvoon.

# --- kierteen jyrsintä: työkierrot ---
cycle-thread-milling = Kierteen jyrsintä
    .nc = KIERTEEN JYRSINTÄ
    .purpose = Työkierto jyrsii kierteen esiporattuun materiaaliin.
cycle-thread-milling-countersinking = Kierteen jyrsintä ja upotus
    .nc = UPOTUSKIERTEEN JYRSINTÄ
    .purpose = Työkierto jyrsii kierteen esiporattuun materiaaliin ja koneistaa upotusviisteen.
cycle-thread-drilling-milling = Kierteen poraus ja jyrsintä
    .nc = KIERTEEN PORAUS/JYRSINTÄ
    .purpose = Työkierto poraa umpimateriaaliin ja jyrsii sen jälkeen kierteen samalla työkalulla.
cycle-helical-thread-drilling-milling = Kierteen kierukkaporaus ja jyrsintä
    .nc = KIERUKKAPORAUS/JYRSINTÄ
    .purpose = Työkierto jyrsii kierteen umpimateriaaliin kierukkarataa pitkin.
cycle-outside-thread-milling = Ulkokierteen jyrsintä
    .nc = ULKOKIERTEEN JYRSINTÄ
    .purpose = Työkierto jyrsii ulkokierteen ja koneistaa upotusviisteen.

# --- kierteen jyrsintä: vaiheet ---
group-countersinking = Upotus
group-countersinking-at-front = Otsapuolen upotus
group-drilling-the-hole = Poraus
group-milling-the-thread = Kierteen jyrsintä
step-feed-to-start-plane-of-threads = Työkalu siirtyy esipaikoituksen syöttöarvolla { $q-in-and-out-feed } aloitustasoon, joka määräytyy kierteen nousun { $q-thread-pitch } etumerkistä, jyrsintämenetelmästä { $q-milling-type } ja kierteiden lukumäärästä askelta kohti { $q-threads-per-step }.
step-feed-to-start-plane-of-thread = Työkalu siirtyy esipaikoituksen syöttöarvolla { $q-in-and-out-feed } kierteen aloitustasoon, joka määräytyy kierteen nousun { $q-thread-pitch } etumerkistä ja jyrsintämenetelmästä { $q-milling-type }.
step-feed-to-start-plane-of-helix = Työkalu siirtyy esipaikoituksen syöttöarvolla { $q-in-and-out-feed } kierteen aloitustasoon.
step-approach-thread-and-compensate = Työkalu ajaa tangentiaalisesti kierukkarataa pitkin kierteen halkaisijalle { $q-nominal-diameter }. Samalla se tekee tasausliikkeen työkaluakselin suunnassa, jotta kierteen rata alkaa ohjelmoidusta aloitustasosta.
step-approach-thread = Työkalu ajaa tangentiaalisesti kierukkarataa pitkin kierteen halkaisijalle { $q-nominal-diameter }.
step-approach-and-mill-one-turn = Työkalu ajaa tangentiaalisesti kierukkarataa pitkin kierteen halkaisijalle { $q-nominal-diameter } ja jyrsii kierteen 360°:n kierukkaliikkeellä.
step-mill-thread-in-turns = Työkalu jyrsii kierteen syöttöarvolla { $q-milling-feed }. Kierteiden lukumäärä askelta kohti ({ $q-threads-per-step }) määrää, miten:
say-thread-in-one-turn = { $q-threads-per-step } = 0: yhdellä kierukkaliikkeellä
say-thread-on-continuous-helix = { $q-threads-per-step } = 1: yhdellä jatkuvalla kierukkaliikkeellä
say-thread-on-several-helices = { $q-threads-per-step } > 1: useilla siirretyillä kierukkaliikkeillä
step-mill-thread-downwards = Ohjaus ajaa työkalua alaspäin jatkuvaa kierukkarataa pitkin, kunnes kierteen syvyys { $q-thread-depth } on saavutettu.
step-depart-from-thread = Työkalu irtautuu muodosta tangentiaalisesti ja palaa koneistustason alkupisteeseen.
step-end-of-thread-milling = Työkierron lopussa ohjaus siirtää työkalun pikaliikkeellä:
step-feed-to-countersinking-depth = Jos sivuetäisyyttä { $q-clearance-to-wall } ei ole annettu, työkalu siirtyy esipaikoituksen syöttöarvolla { $q-in-and-out-feed } upotussyvyyteen { $q-countersinking-depth } vähennettynä varmuusetäisyydellä ja sen jälkeen upotuksen syöttöarvolla { $q-countersinking-feed } upotussyvyyteen.
step-feed-directly-to-countersinking-depth = Jos sivuetäisyys { $q-clearance-to-wall } on annettu, ohjaus siirtää työkalun heti esipaikoituksen syöttöarvolla { $q-in-and-out-feed } upotussyvyyteen { $q-countersinking-depth }.
step-countersink-on-circle = Käytettävissä olevan tilan mukaan työkalu lähestyy seinämää pehmeästi keskeltä tai sivulle tehtävällä esipaikoitusliikkeellä ja tekee ympyräliikkeen.
step-feed-to-depth-at-front = Työkalu siirtyy esipaikoituksen syöttöarvolla { $q-in-and-out-feed } otsapuolen upotussyvyyteen { $q-depth-at-front }.
step-feed-to-depth-at-front-before-or-after = Jos upotus tehdään ennen kierrettä ({ $q-countersinking-moment } = 0), työkalu siirtyy upotuksen syöttöarvolla { $q-countersinking-feed } otsapuolen upotussyvyyteen { $q-depth-at-front }; jos se tehdään kierteen jälkeen, esipaikoituksen syöttöarvolla { $q-in-and-out-feed }.
step-countersink-at-front = Ohjaus siirtää työkalun ilman sädekorjausta puoliympyrää pitkin keskeltä otsapuolen siirtymään { $q-offset-at-front } ja ajaa ympyräliikkeen upotuksen syöttöarvolla { $q-countersinking-feed }.
step-countersink-at-front__thread-drilling-milling = Ohjaus siirtää työkalun ilman sädekorjausta puoliympyrää pitkin keskeltä otsapuolen siirtymään { $q-offset-at-front } ja ajaa ympyräliikkeen syöttöarvolla { $q-plunging-feed }.
step-leave-countersink-at-front = Ohjaus siirtää työkalun puoliympyrää pitkin takaisin reiän keskelle.
step-leave-countersink-at-front__outside-thread-milling = Ohjaus siirtää työkalun puoliympyrää pitkin takaisin alkupisteeseen.
step-countersink-after-thread = Jos upotus tehdään kierteen jälkeen ({ $q-countersinking-moment } = 1), se suoritetaan nyt edellä kuvatulla tavalla.
step-drill-towards-plunging-depth = Työkalu poraa syöttöarvolla { $q-plunging-feed } kohti asetussyvyyttä { $q-plunging-depth }; lastunkatkossa se pysähtyy aina, kun se on edennyt matkan { $q-depth-for-chip-breaking }.
step-retract-to-break-chip = Lastun katkaisemiseksi työkalu vetäytyy matkan { $q-chip-breaking-retraction }.
step-retract-and-return-to-one-stop-distance = Ohjaus vetää työkalun pikaliikkeellä varmuusetäisyydelle ja palauttaa sen pikaliikkeellä (FMAX) esipysäytysetäisyydelle { $q-upper-advanced-stop-distance } saavutetun syvyyden yläpuolelle.
until-hole-depth-reached = reiän kokonaissyvyys { $q-total-hole-depth } on saavutettu
step-move-beside-stud = Ohjaus siirtää työkalun kaulan keskipisteestä koneistustason pääakselia pitkin otsapuolen upotuksen alkupisteeseen. Sen sijainti määräytyy kierteen säteestä, työkalun säteestä ja noususta.
step-move-beside-stud-without-countersinking = Jos otsapuolen upotusta ei tehdä, ohjaus siirtää työkalun kierteen jyrsinnän alkupisteeseen, joka on sama kuin otsapuolen upotuksessa.

# --- kierteen jyrsintä: ehdot ja tarkastukset ---
guard-no-depth-entered = Kaikki syvyydet ovat 0: mitään ei koneisteta.
guard-depth-signs-differ = Syvyyksillä on eri etumerkit. Anna kaikille sama etumerkki.
guard-thread-near-countersinking-depth = Kierteen syvyyden on oltava vähintään kolmasosan noususta pienempi kuin upotussyvyys.
guard-thread-near-hole-depth = Kierteen syvyyden on oltava vähintään kolmasosan noususta pienempi kuin reiän kokonaissyvyys.

# --- kierteen jyrsintä: ohjeet ---
note-thread-approach-on-half-circle = Kierteen halkaisijaa lähestytään puoliympyrää pitkin keskeltä ulospäin. Jos työkalun halkaisija on vain neljäsosa kierteen halkaisijasta, työkalu esipaikoitetaan sivulle.
note-compensation-before-approach = Ennen lähestymistä ohjaus tekee työkaluakselin suunnassa tasausliikkeen, joka on enintään puolet kierteen noususta. Varmista, että reiässä on riittävästi tilaa.
note-thread-depth-moves-start = Jos kierteen syvyyttä muutetaan, ohjaus muuttaa kierukkaliikkeen alkupistettä itse.
note-depths-give-direction = Syvyysparametrien etumerkit määräävät työskentelysuunnan tässä järjestyksessä: 1. kierteen syvyys { $q-thread-depth }, 2. upotussyvyys { $q-countersinking-depth }, 3. otsapuolen upotussyvyys { $q-depth-at-front }.
note-depths-give-direction__thread-drilling-milling = Syvyysparametrien etumerkit määräävät työskentelysuunnan tässä järjestyksessä: 1. kierteen syvyys { $q-thread-depth }, 2. reiän kokonaissyvyys { $q-total-hole-depth }, 3. otsapuolen upotussyvyys { $q-depth-at-front }.
note-two-depths-give-direction = Syvyysparametrien etumerkit määräävät työskentelysuunnan tässä järjestyksessä: 1. kierteen syvyys { $q-thread-depth }, 2. otsapuolen upotussyvyys { $q-depth-at-front }.
note-depth-zero-leaves-out-step = Jos jonkin syvyyden arvoksi on annettu 0, ohjaus ei suorita kyseistä vaihetta.
note-no-countersinking-depth-for-front = Jos haluat upottaa otsapuolelta, määrittele upotussyvyydeksi { $q-countersinking-depth } arvo 0.
note-thread-depth-above-countersinking-depth = Anna kierteen syvyys { $q-thread-depth }, joka on vähintään kolmasosan kierteen noususta pienempi kuin upotussyvyys { $q-countersinking-depth }.
note-thread-depth-above-hole-depth = Anna kierteen syvyys { $q-thread-depth }, joka on vähintään kolmasosan kierteen noususta pienempi kuin reiän kokonaissyvyys { $q-total-hole-depth }.
note-helix-goes-into-workpiece = Jyrsintämenetelmä (myötä- tai vastalastu) määräytyy kierteestä (oikea- tai vasenkätinen) ja työkalun pyörintäsuunnasta, koska ainoa mahdollinen työskentelysuunta on työkappaleen yläpinnasta työkappaleeseen.
note-position-over-stud-centre = Ohjelmoi paikoituslause koneistustason alkupisteeseen (kaulan keskipisteeseen) sädekorjauksella R0.
note-offset-at-front-determined-before = Määritä otsapuolen upotuksen siirtymä jo ennen työkierron käyttöä. Anna siirtymäksi kaulan keskipisteen ja työkalun keskipisteen välinen etäisyys ilman korjausta.
note-internal-coolant-for-thread-milling = Koneessa tulisi olla karan läpi johdettu sisäinen jäähdytys: lastuamisneste vähintään 30{"\u00A0"}bar, paineilma vähintään 6{"\u00A0"}bar.
note-profile-correction-by-delta-radius = Kierteen jyrsintä vääristää usein kierteen profiilia, joten tarvitaan työkalukohtaisia korjauksia. Ne ovat työkaluluettelossa, tai työkalun valmistaja ilmoittaa ne. Korjaus annetaan TOOL CALL -lauseessa delta-arvolla { $mp-delta-radius }.
note-clockwise-tools-only = Työkiertoa voidaan käyttää vain myötäpäivään pyörivillä työkaluilla.
note-tools-of-both-rotations = Työkiertoa voidaan käyttää sekä myötäpäivään että vastapäivään pyörivillä työkaluilla.
note-direction-of-inside-thread = Työskentelysuunta riippuu kierteen nousun { $q-thread-pitch } etumerkistä ja jyrsintämenetelmästä { $q-milling-type }. Myötäpäivään pyörivillä työkaluilla sisäkierre jyrsitään suuntaan Z+, jos se on oikeakätinen (+) ja jyrsitään myötälastulla (+1, RL) tai vasenkätinen (−) ja jyrsitään vastalastulla (−1, RR), ja suuntaan Z−, jos se on oikeakätinen (+) ja jyrsitään vastalastulla (−1, RR) tai vasenkätinen (−) ja jyrsitään myötälastulla (+1, RL).
note-direction-of-outside-thread = Työskentelysuunta riippuu kierteen nousun { $q-thread-pitch } etumerkistä ja jyrsintämenetelmästä { $q-milling-type }. Myötäpäivään pyörivillä työkaluilla ulkokierre jyrsitään suuntaan Z−, jos se on oikeakätinen (+) ja jyrsitään myötälastulla (+1, RL) tai vasenkätinen (−) ja jyrsitään vastalastulla (−1, RR), ja suuntaan Z+, jos se on oikeakätinen (+) ja jyrsitään vastalastulla (−1, RR) tai vasenkätinen (−) ja jyrsitään myötälastulla (+1, RL).
note-feed-of-cutting-edge = Kierteitä jyrsittäessä ohjelmoitu syöttöarvo koskee työkalun terää. Koska ohjaus näyttää työkalun keskipisteen radan syöttöarvon, näytetty arvo poikkeaa ohjelmoidusta.
note-mirroring-turns-thread = Kierteen kätisyys vaihtuu, jos työkierto suoritetaan, kun vain yksi akseli on peilattu (työkierto 8).
note-same-signs-of-depths = Törmäysvaara! Anna syvyyksille aina sama etumerkki, koska työkierrot sisältävät useita toisistaan riippumattomia kulkuja. Jos haluat toistaa esimerkiksi vain upotuksen, anna kierteen syvyydeksi 0; silloin upotussyvyys määrää työskentelysuunnan.
note-same-signs-of-depths__outside-thread-milling = Törmäysvaara! Anna syvyyksille aina sama etumerkki, koska työkierrot sisältävät useita toisistaan riippumattomia kulkuja. Jos haluat toistaa esimerkiksi vain otsapuolen upotuksen, anna kierteen syvyydeksi 0; silloin otsapuolen syvyys määrää työskentelysuunnan.
note-tool-breakage-in-thread = Jos työkalu rikkoutuu kierrettä lastuttaessa: pysäytä ohjelmanajo, vaihda käyttötavalle ”Paikoitus käsin sisäänsyöttäen” ja aja työkalu suoraa pitkin reiän keskelle. Aja se sitten irti asetusakselin suunnassa ja vaihda työkalu.
note-tool-breakage-in-thread__outside-thread-milling = Jos työkalu rikkoutuu kierrettä lastuttaessa: pysäytä ohjelmanajo, vaihda käyttötavalle ”Paikoitus käsin sisäänsyöttäen” ja aja työkalu suoraa pitkin irti kierteestä. Aja se sitten irti asetusakselin suunnassa ja vaihda työkalu.
