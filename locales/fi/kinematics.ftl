# Työkierrot, jotka mittaavat koneen kinematiikkaa.

# --- parametrit ---
parameter-kinematics-mode = Tila (0=tarkastus/1=mittaus)
    .label = TILA
    .help = Määrää, tarkastaako vai optimoiko ohjaus aktiivisen kinematiikan.
parameter-kinematics-mode__itnc530 = Tila (0/1/2)
choice-kinematics-check = Aktiivisen konekinematiikan tarkastus: ohjaus mittaa määritellyt kiertoakselit, mutta ei muuta mitään; tulokset esitetään mittauspöytäkirjassa
choice-kinematics-optimize-position = Aktiivisen konekinematiikan optimointi: ohjaus mittaa määritellyt kiertoakselit ja optimoi niiden aseman
choice-kinematics-optimize-position-and-angle = Aktiivisen konekinematiikan optimointi: ohjaus mittaa määritellyt kiertoakselit, optimoi niiden aseman ja kompensoi niiden kulman; edellyttää optiota KinematicsComp
parameter-sphere-radius = Kalibrointikuulan tarkka säde
    .label = KUULAN SÄDE
    .help = Käytettävän kalibrointikuulan tarkka säde.
parameter-retraction-height = Vetäytymiskorkeus
    .label = VETÄYTYMISKORKEUS
    .help = Määrää, vetäytyykö kosketusjärjestelmä ennen kiertoakselin paikoitusta ja mihin.
choice-no-retraction = Vetäytymiskorkeudelle ei ajeta: ohjaus ajaa seuraavaan mittausasemaan mitattavalla akselilla ja ensimmäiseen asemaan järjestyksessä A, B, C; ei sallittu Hirth-akseleilla
choice-retraction = Vetäytymiskorkeus kääntämättömässä työkappaleen koordinaatistossa: ohjaus ajaa karan akselin tälle korkeudelle ennen kiertoakselin paikoitusta; koneistustasossa se siirtää kosketusjärjestelmän nollapisteeseen; kosketusjärjestelmän valvonta ei ole silloin voimassa, joten määrittele paikoitusnopeus parametrissa { $q-kinematics-positioning-feed }
parameter-kinematics-positioning-feed = Esipaikoituksen syöttöarvo
    .label = ESIPAIK. SYÖTTÖARVO
    .help = Työkalun liikenopeus paikoituksessa.
parameter-kinematics-reference-angle = Peruskulma
    .label = PERUSKULMA
    .help = Peruskulma (peruskääntö) pisteiden mittausta varten aktiivisessa työkappaleen koordinaatistossa. Se voi suurentaa akselin mittausaluetta huomattavasti.
parameter-rotary-start-angle-a = A-akselin aloituskulma
    .label = A-AKSELIN ALKUKULMA
    .help = A-akselin kulma, jossa ensimmäinen mittaus tehdään.
parameter-rotary-end-angle-a = A-akselin lopetuskulma
    .label = A-AKSELIN LOPPUKULMA
    .help = A-akselin kulma, jossa viimeinen mittaus tehdään.
parameter-rotary-incidence-angle-a = A-akselin asetuskulma
    .label = A-AKSELIN ASETUSKULMA
    .help = A-akselin asetuskulma, jossa muut kiertoakselit mitataan.
parameter-rotary-measuring-points-a = A-akselin mittauspisteiden lukumäärä
    .label = A-AKSELIN MITT.PIST.
    .help = Kosketusten lukumäärä A-akselia mitattaessa. Arvolla 0 akselia ei mitata.
parameter-rotary-start-angle-b = B-akselin aloituskulma
    .label = B-AKSELIN ALKUKULMA
    .help = B-akselin kulma, jossa ensimmäinen mittaus tehdään.
parameter-rotary-end-angle-b = B-akselin lopetuskulma
    .label = B-AKSELIN LOPPUKULMA
    .help = B-akselin kulma, jossa viimeinen mittaus tehdään.
parameter-rotary-incidence-angle-b = B-akselin asetuskulma
    .label = B-AKSELIN ASETUSKULMA
    .help = B-akselin asetuskulma, jossa muut kiertoakselit mitataan.
parameter-rotary-measuring-points-b = B-akselin mittauspisteiden lukumäärä
    .label = B-AKSELIN MITT.PIST.
    .help = Kosketusten lukumäärä B-akselia mitattaessa. Arvolla 0 akselia ei mitata.
parameter-rotary-start-angle-c = C-akselin aloituskulma
    .label = C-AKSELIN ALKUKULMA
    .help = C-akselin kulma, jossa ensimmäinen mittaus tehdään.
parameter-rotary-end-angle-c = C-akselin lopetuskulma
    .label = C-AKSELIN LOPPUKULMA
    .help = C-akselin kulma, jossa viimeinen mittaus tehdään.
parameter-rotary-incidence-angle-c = C-akselin asetuskulma
    .label = C-AKSELIN ASETUSKULMA
    .help = C-akselin asetuskulma, jossa muut kiertoakselit mitataan.
parameter-rotary-measuring-points-c = C-akselin mittauspisteiden lukumäärä
    .label = C-AKSELIN MITT.PIST.
    .help = Kosketusten lukumäärä C-akselia mitattaessa. Arvolla 0 akselia ei mitata.
parameter-sphere-touch-points = Mittauspisteiden lukumäärä (3-8)
    .label = MITT.PIST. LUKUMÄÄRÄ
    .help = Kosketusten lukumäärä tasossa kalibrointikuulaa mitattaessa. Pienempi määrä säästää aikaa, suurempi lisää tarkkuutta.
parameter-sphere-touch-points__itnc530 = Mittauspisteiden lukumäärä
    .help = Kosketusten lukumäärä tasossa kalibrointikuulaa mitattaessa.
parameter-sphere-preset = Esiasetuksen asetus (0/1/2/3)
    .label = ASETA ESIASETUS
    .help = Määrää, asettaako ohjaus aktiivisen esiasetuksen (peruspisteen) automaattisesti kuulan keskipisteeseen.
choice-sphere-preset-none = Esiasetusta ei aseteta automaattisesti kuulan keskipisteeseen: aseta se käsin ennen työkierron käynnistystä
choice-sphere-preset-before = Esiasetus asetetaan automaattisesti kuulan keskipisteeseen ennen mittausta: esipaikoita kosketusjärjestelmä käsin kalibrointikuulan yläpuolelle ennen työkierron käynnistystä
choice-sphere-preset-after = Esiasetus asetetaan automaattisesti kuulan keskipisteeseen mittauksen jälkeen: aseta esiasetus käsin ennen työkierron käynnistystä
choice-sphere-preset-before-and-after = Esiasetus asetetaan kuulan keskipisteeseen ennen mittausta ja sen jälkeen: esipaikoita kosketusjärjestelmä käsin kalibrointikuulan yläpuolelle ennen työkierron käynnistystä
parameter-backlash-angle = Välyksen kulma-alue
    .label = VÄLYKSEN KULMA-ALUE
    .help = Kulma, jonka verran kiertoakselit ajavat yli välyksen mittaamiseksi. Sen on oltava selvästi suurempi kuin todellinen välys. Arvolla 0 välystä ei mitata.

# --- 451 ---
cycle-measure-kinematics = Kinematiikan mittaus
    .nc = KINEMATIIKAN MITTAUS
    .purpose = Työkierto tarkastaa koneen kinematiikan ja haluttaessa optimoi sen. 3D-kosketusjärjestelmä mittaa koneen pöydälle kiinnitetyn HEIDENHAIN-kalibrointikuulan. Ohjaus arvioi staattisen kääntötarkkuuden; ohjelmisto minimoi kääntöliikkeistä syntyvän tilavirheen ja tallentaa koneen geometrian kinematiikkakuvauksen konevakioihin.
step-clamp-sphere = Kiinnitä kalibrointikuula niin, ettei törmäystä voi tapahtua.
step-set-datum-in-sphere = Aseta peruspiste käsikäyttötavalla kuulan keskipisteeseen. Jos { $q-sphere-preset } = 1 tai { $q-sphere-preset } = 3, paikoita sen sijaan kosketusjärjestelmä käsin kosketusakselilla kalibrointikuulan yläpuolelle ja koneistustasossa kuulan keskelle.
step-start-calibration-program = Valitse ohjelmanajon käyttötapa ja käynnistä kalibrointiohjelma.
step-set-preset-before-measuring = { $q-sphere-preset } määrää, mikä esiasetus mittauksessa on voimassa:
say-preset-into-sphere-before = jos { $q-sphere-preset } = 1 tai 3, ohjaus tekee esiasetuksen kuulan keskipisteeseen ennen mittausta
say-preset-set-by-hand = muussa tapauksessa se käyttää käsin asetettua peruspistettä
step-move-to-measuring-positions = Kosketusjärjestelmä siirtyy mittausasemiin:
say-move-without-retraction = jos { $q-retraction-height } = 0, vetäytymättä mitattavalla akselilla; ensimmäiseen mittausasemaan järjestyksessä A, B, C
say-move-over-retraction-height = muussa tapauksessa karan akseli siirtyy ensin vetäytymiskorkeudelle { $q-retraction-height } ja kosketusjärjestelmä koneistustasossa nollapisteeseen
step-measure-rotary-axes = Ohjaus mittaa automaattisesti kaikki kiertoakselit peräkkäin määritellyllä tarkkuudella. Referenssimittaus tehdään kulmassa 0°.
step-measure-backlash = { $q-backlash-angle } määrää, mittaako ohjaus välyksen:
say-backlash-from-two-measurements = jos parametrissa { $q-backlash-angle } on kulma, ohjaus määrittää välyksen mittaamalla kunkin kiertoakselin kahdesti
say-no-backlash-measurement = jos { $q-backlash-angle } = 0, välystä ei mitata
step-adapt-kinematics = Ohjaus arvioi mittaustulokset tilan { $q-kinematics-mode } mukaan:
say-report-possible-optimization = tarkastus: ohjaus määrittää mitatuista asemista staattisen kääntötarkkuuden, kirjaa pöytäkirjaan, mitä asemien optimoinnilla voitaisiin saavuttaa, eikä muuta mitään
say-optimize-axis-positions = aseman optimointi: ohjaus määrittää staattisen kääntötarkkuuden, pyrkii muuttamaan kiertoakselien asemaa kinematiikkamallissa niin, että tarkkuus paranee, ja mukauttaa konetiedot automaattisesti
say-optimize-angles-then-positions = aseman ja kulman optimointi: ohjaus määrittää staattisen kääntötarkkuuden, pyrkii ensin optimoimaan kiertoakselien kulma-aseman kompensoinnilla (optio 52, KinematicsComp) ja, jos se onnistuu, optimoi aseman toisella mittaussarjalla
step-store-scatter-and-offsets = Ohjaus tallentaa mitatut arvot tulosparametreihin.
step-set-preset-after-measuring = Mittauksen jälkeen { $q-sphere-preset } määrää, asettaako ohjaus esiasetuksen:
say-preset-into-sphere-after = jos { $q-sphere-preset } = 2 tai 3, se asetetaan kuulan keskipisteeseen
say-no-preset-after = muussa tapauksessa sitä ei aseteta
step-write-kinematics-log = Ohjaus laatii pöytäkirjan (TCHPR{ $cycle }.TXT).
result-scatter-measured-a = A-akselin mitattu keskihajonta (−1, jos akselia ei mitattu)
result-scatter-measured-b = B-akselin mitattu keskihajonta (−1, jos akselia ei mitattu)
result-scatter-measured-c = C-akselin mitattu keskihajonta (−1, jos akselia ei mitattu)
result-scatter-optimized-a = A-akselin optimoitu keskihajonta (−1, jos akselia ei optimoitu)
result-scatter-optimized-b = B-akselin optimoitu keskihajonta (−1, jos akselia ei optimoitu)
result-scatter-optimized-c = C-akselin optimoitu keskihajonta (−1, jos akselia ei optimoitu)
result-offset-error-x = Siirtymävirhe X-suunnassa, siirretään käsin vastaavaan koneparametriin
result-offset-error-y = Siirtymävirhe Y-suunnassa, siirretään käsin vastaavaan koneparametriin
result-offset-error-z = Siirtymävirhe Z-suunnassa, siirretään käsin vastaavaan koneparametriin
note-place-sphere-without-collision = Valitse kalibrointikuulan paikka koneen pöydällä niin, ettei mittauksen aikana voi tapahtua törmäystä.
note-hirth-axes-leave-their-grid = Törmäysvaara! Hirth-akselin on paikoitusta varten irtauduttava Hirth-hammastuksestaan. Huolehdi siitä, että varmuusetäisyys on riittävän suuri estämään kosketusjärjestelmän ja kalibrointikuulan törmäyksen ja että kuulan luo ajamiseen on riittävästi tilaa (ohjelmistorajakytkimet).
note-save-kinematics-first = Jos työkierto keskeytetään mittauksen aikana, kinematiikkatiedot eivät ehkä enää ole alkuperäisessä tilassaan. Tallenna aktiivinen kinematiikka työkierrolla 450 ennen optimointia, jotta se voidaan palauttaa virhetilanteessa.
note-kinematics-options = Ohjelmisto-optioiden 48 (KinematicsOpt), 8 (ohjelmisto-optio 1) ja 17 (kosketusjärjestelmätoiminnot) on oltava vapautettuina.
note-kinematics-options__itnc530 = Ohjelmisto-optioiden 48 (KinematicsOpt) ja 8 (ohjelmisto-optio 1) sekä kehitystilan FCL 3 on oltava vapautettuina.
note-kinematics-comp-option = Kulma-asemien kompensointi (tila 2) edellyttää ohjelmisto-optiota 52, KinematicsComp.
note-probe-must-be-calibrated = Mittauksessa käytettävän 3D-kosketusjärjestelmän on oltava kalibroitu.
note-tool-axis-z-only = Työkierto voidaan suorittaa vain työkaluakselilla Z.
note-recommended-spheres = Koneen pöydälle on kiinnitettävä haluttuun paikkaan riittävän jäykkä kalibrointikuula, jonka säde tunnetaan tarkasti. HEIDENHAIN suosittelee kalibrointikuulia KKH 250 (tilausnumero 655475-01) ja KKH 100 (tilausnumero 655475-02), jotka ovat erityisen jäykkiä ja tehty koneen kalibrointiin. Ota tarvittaessa yhteys HEIDENHAINiin.
note-kinematics-description-complete = Koneen kinematiikkakuvauksen on oltava täydellinen ja oikea, muunnosmittojen on pidettävä paikkansa noin 1{"\u00A0"}mm:n tarkkuudella, ja koneen geometrian on oltava kokonaan mitattu (koneen valmistaja mittaa sen käyttöönotossa).
note-model-differs-from-machine = Jos ohjaukseen tallennettu kinematiikkamalli poikkeaa koneesta, kiertoakselien paikoitus aiheuttaa virheitä työkappaleeseen. Työkierto mittaa sekä pöydän että pään kiertoakselit täysin automaattisesti ja valittavalla tarkkuudella; työkierron määrittelyssä annetaan kullekin kiertoakselille vain mitattava alue.
note-kinematics-machine-data = { $mp-max-modification } on kinematiikkatietojen muutosten raja, jonka ylityksestä ohjaus antaa ilmoituksen. { $mp-max-ball-deviation } on mitatun kuulan säteen sallittu poikkeama annetusta säteestä. { $mp-rotary-axis-m-function } on kiertoakselit paikoittava M-toiminto tai −1, jos ohjaus paikoittaa ne itse.
note-kinematics-config-stored = Edellytyksenä on, että koneen valmistaja on tallentanut koneparametrit { $mp-kinematics-config } konfiguraatiotietoihin.
note-string-parameters-used = KinematicsOpt-työkierrot käyttävät yleisesti voimassa olevia merkkijonoparametreja QS0–QS99. Niiden arvot voivat olla muuttuneet, kun työkierrot on suoritettu.
note-rotary-axes-at-zero = Jos { $mp-rotary-axis-m-function } määrittelee M-toiminnon (ei −1), käynnistä mittaus vasta, kun kaikki kiertoakselit ovat asemassa 0° (oloarvot).
note-restart-after-change = Jos työkierto on muuttanut koneparametria, käynnistä ohjaus uudelleen. Muuten muutos voi kadota.
note-positioning-direction = Mitattavan kiertoakselin paikoitussuunta määräytyy aloituskulmasta ja lopetuskulmasta. Kulmassa 0° tehdään automaattisesti referenssimittaus.
note-angular-step-of-axis = Mittausasemien väli on (lopetuskulma − aloituskulma) / (mittauspisteiden lukumäärä − 1). Esimerkki: +90° … −90° 4 pisteellä antaa askeleen −60°: +90°, +30°, −30°, −90°. +90° … +270° 4 pisteellä antaa askeleen +60°: +90°, +150°, +210°, +270°.
note-no-position-twice = Valitse aloituskulma ja lopetuskulma niin, ettei mitään asemaa mitata kahdesti (esimerkiksi +90° ja −270°). Sellaisessa mittauksessa ei ole järkeä, mutta se ei aiheuta virheilmoitusta.
note-point-at-zero-ignored = Kulmassa 0° oleva mittauspiste jätetään huomiotta, koska referenssimittaus tehdään aina kulmassa 0°.
note-point-at-zero-is-an-error = Mikään mittauspiste ei saa olla kulmassa 0° tai 360°. Näistä asemista ei saada käyttökelpoista tietoa, ja ne aiheuttavat virheilmoituksen.
note-hirth-positions-rounded = Ohjaus pyöristää Hirth-akselien mittausasemat Hirth-jakoon. Esimerkki jaolla 3°: asemista −30°, +10°, +50°, +90° tulee −30°, 9°, 51°, 90°.
note-hirth-needs-retraction-height = Määrittele Hirth-akseleille vetäytymiskorkeus { $q-retraction-height } suuremmaksi kuin 0, jos ohjelmisto-optio 2 (M128, FUNCTION TCPM) ei ole käytettävissä.
note-number-of-measuring-points = Tee ajan säästämiseksi ensin karkea optimointi 1 tai 2 mittauspisteellä ja sitten tarkka optimointi keskimääräisellä määrällä (noin 4). Suurempi määrä ei yleensä paranna tuloksia. Jaa pisteet tasaisesti kääntöalueelle: akseli, jonka alue on 0° … 360°, mitataan parhaiten 3 pisteellä kulmissa 90°, 180° ja 270°. Tarkkuuden tarkastamiseen tilassa tarkastus voidaan antaa enemmän pisteitä.
note-where-to-place-the-sphere = Kuula voidaan kiinnittää koneen pöydällä mihin tahansa paikkaan, johon päästään, myös kiinnittimiin tai työkappaleisiin. Sijoita se pyörö- tai kääntöpöydällä varustetuissa koneissa mahdollisimman kauas kiertokeskipisteestä ja pitkäliikkeisissä koneissa mahdollisimman lähelle myöhempää koneistuspaikkaa.
note-accuracy-of-kinematics = Koneen geometria- ja paikoitusvirheet vaikuttavat mittausarvoihin ja siten kiertoakselin optimointiin; jäännösvirhe jää aina. Ilman näitä virheitä arvot olisivat tiettynä hetkenä toistettavissa koneen missä tahansa pisteessä. Mitä suurempia nämä virheet ovat, sitä suurempi on tulosten hajonta, kun kuula mitataan eri paikoissa. Jos useita kiertoakseleita liikkuu samanaikaisesti, virheet yhdistyvät ja pahimmassa tapauksessa summautuvat.
note-scatter-meaning = Pöytäkirjan hajonta on koneen staattisten kääntöliikkeiden tarkkuuden mitta. Lisäksi on otettava huomioon mittausympyrän säde sekä mittauspisteiden lukumäärä ja sijainti. Yhdellä mittauspisteellä hajontaa ei voi laskea; arvo on silloin pisteen tilavirhe.
note-track-for-kinematics = Jos koneessa on ohjattu kara, aktivoi kulman jälkiseuranta ({ $mp-track }). Se parantaa yleensä 3D-kosketusjärjestelmällä tehtävien mittausten tarkkuutta.
note-unclamp-rotary-axes = Poista tarvittaessa kiertoakselien lukitus käytöstä mittauksen ajaksi. Muuten tulokset voivat olla vääriä. Katso koneen käyttöohjekirjaa.
note-calibration-rough = Karkea optimointi käyttöönotossa, likimääräisten mittojen antamisen jälkeen: 1 tai 2 mittauspistettä, kiertoakselien kulma-askel noin 90°.
note-calibration-fine = Tarkka optimointi koko liikealueella: 3–6 mittauspistettä; aloitus- ja lopetuskulman pitäisi kattaa mahdollisimman suuri alue; sijoita kuula niin, että pöydän kiertoakseleilla mittausympyrä on suuri tai että pään kiertoakselit voidaan mitata edustavassa asemassa (esimerkiksi alueen keskellä).
note-calibration-one-position = Kiertoakselin tietyn aseman optimointi: 2 tai 3 mittauspistettä; mittaa kulmassa, jossa koneistetaan myöhemmin, kuula koneistuspaikassa.
note-calibration-check = Koneen tarkkuuden tarkastus: 4–8 mittauspistettä; aloitus- ja lopetuskulman pitäisi kattaa mahdollisimman suuri alue.
note-calibration-backlash = Kiertoakselien välyksen määritys: 8–12 mittauspistettä; aloitus- ja lopetuskulman pitäisi kattaa mahdollisimman suuri alue.
note-backlash-measured-twice = Välys on pieni liikevara kulma-anturin ja pöydän välillä; se syntyy suunnan vaihtuessa. Säätöpiirin ulkopuolella (esimerkiksi moottorin anturia käytettäessä) se voi aiheuttaa huomattavia virheitä. Parametri { $q-backlash-angle } aktivoi sen mittauksen; työkierto mittaa silloin jokaisen kiertoakselin kahdesti.
note-backlash-not-compensated = Ohjaus ei kompensoi välystä automaattisesti.
note-backlash-not-determined = Välystä ei määritetä, jos mittausympyrän säde on pienempi kuin 1{"\u00A0"}mm, jos { $mp-rotary-axis-m-function } määrittelee M-toiminnon tai jos akseli on Hirth-akseli. Mitä suurempi mittausympyrän säde on, sitä tarkemmin välys määritetään.
note-reset-tilting = Varmista, että kaikki koneistustason kääntötoiminnot on peruutettu.
note-tcpm-switched-off = M128 ja FUNCTION TCPM kytkeytyvät pois päältä.
note-tcpm-must-be-off = M128 ja FUNCTION TCPM eivät saa olla voimassa.
note-datum-in-sphere-first = Aseta ja aktivoi peruspiste kalibrointikuulan keskipisteeseen ennen työkierron määrittelyä tai anna { $q-sphere-preset } = 1 tai 3.
note-preposition-for-preset = Jos esiasetus asetetaan ennen mittausta ({ $q-sphere-preset } = 1 tai 3), paikoita kosketusjärjestelmä ennen työkierron käynnistystä suunnilleen kalibrointikuulan keskikohdan yläpuolelle varmuusetäisyyden ({ $q-probing-clearance } + { $mp-set-up }) päähän.
note-preposition-for-preset__itnc530 = Jos esiasetus asetetaan ennen mittausta ({ $q-sphere-preset } = 1 tai 3), paikoita kosketusjärjestelmä ennen työkierron käynnistystä suunnilleen kalibrointikuulan keskikohdan yläpuolelle.
note-kinematics-feeds = Kosketuskorkeudelle ajettaessa ohjaus käyttää kosketusakselilla pienempää arvoista { $q-kinematics-positioning-feed } ja { $mp-positioning-feed }. Kiertoakselit liikkuvat syöttöarvolla { $q-kinematics-positioning-feed }, eikä kosketusjärjestelmän valvonta ole silloin voimassa.
note-kinematics-limit-exceeded = Jos kinematiikkatiedot ylittävät optimoinnissa sallitun raja-arvon ({ $mp-max-modification }), ohjaus antaa varoituksen. Vahvista arvot NC-käynnistyksellä.
note-preset-changes-with-kinematics = Kinematiikan muutos muuttaa aina myös esiasetusta. Aseta esiasetus uudelleen optimoinnin jälkeen.
note-sphere-radius-checked = Ohjaus mittaa jokaisessa kosketuksessa ensin kalibrointikuulan säteen. Jos se poikkeaa annetusta säteestä enemmän kuin { $mp-max-ball-deviation }, ohjaus antaa virheilmoituksen ja lopettaa mittauksen.
note-sphere-radius-checked__itnc530 = Ohjaus mittaa jokaisessa kosketuksessa ensin kalibrointikuulan säteen. Jos se poikkeaa annetusta säteestä enemmän kuin { $mp-max-ball-deviation }, ohjaus antaa varoituksen ja lopettaa mittauksen.
note-interrupted-kinematics = Jos tulos ei vastaa odotuksia tai ilmenee virhe, esimerkiksi virtakatkos, tallennettu kinematiikka voidaan palauttaa.
note-results-in-mm = Tulokset ja pöytäkirja annetaan millimetreinä myös tuumaohjelmissa.
note-inactive-axes-ignored = Työkierron määrittelyn tiedot akseleille, jotka eivät ole aktiivisia, jätetään huomiotta.
note-status-window = Ikkuna esittää mittauksen tilan. Ohjaus piilottaa sen heti, kun ajettava matka on kuulan sädettä pitempi.
note-kinematics-log-contents = Pöytäkirja sisältää päiväyksen ja kellonajan, NC-ohjelman polun, tilan, aktiivisen kinematiikan numeron ja annetun kuulan säteen; jokaisesta mitatusta kiertoakselista: aloituskulman, lopetuskulman, asetuskulman, mittauspisteiden lukumäärän, hajonnan (keskihajonnan), suurimman virheen, kulmavirheen, keskimääräisen välyksen, keskimääräisen paikoitusvirheen, mittausympyrän säteen, kaikkien akselien korjausarvot (esiasetuksen siirtymän) ja kiertoakselien mittausepävarmuuden.
note-kinematics-log-contents__itnc530 = Pöytäkirja sisältää päiväyksen ja kellonajan, NC-ohjelman polun, tilan, aktiivisen kinematiikan numeron ja annetun kuulan säteen; jokaisesta mitatusta kiertoakselista: aloituskulman, lopetuskulman, asetuskulman, mittauspisteiden lukumäärän, hajonnan (keskihajonnan), suurimman virheen, kulmavirheen, keskimääräisen välyksen, keskimääräisen paikoitusvirheen, mittausympyrän säteen, kaikkien akselien korjausarvot (esiasetuksen siirtymän), mittauspisteiden arvioinnin ja kiertoakselien mittausepävarmuuden.
note-kinematics-log-explained = Tilassa tarkastus pöytäkirja ilmoittaa tarkkuuden, joka optimoinnilla voitaisiin saavuttaa, muissa tiloissa saavutetun tarkkuuden. Jos kiertoakselin kulma-asemaa ei voitu laskea, mittaustiedot kirjataan kuitenkin. Mitattu hajonta: 68,3{"\u00A0"}% mitatuista tilavirheistä on tämän arvon sisällä (±); optimoitu hajonta: 68,3{"\u00A0"}% korjauksen jälkeen odotettavista virheistä. Mittauspisteiden arviointi osoittaa, kuinka hyvät mittausasemat ovat mallin muutettavissa olevien muunnosten kannalta: mitä suurempi se on, sitä parempi on optimointi. Sen ei pitäisi olla millään kiertoakselilla alle 2, mieluummin 4 tai enemmän; jos se on pieni, suurenna akselin mittausaluetta tai pisteiden lukumäärää. Jos se ei auta, kinematiikkakuvaus voi olla väärä; ota tarvittaessa yhteys asiakaspalveluun.
note-measuring-uncertainty = Mittausepävarmuus ilmoitetaan asteina 1{"\u00A0"}µm:n järjestelmäepävarmuutta kohti; sen avulla arvioidaan kiertoakselin mitattuja paikoitusvirheitä tai välystä. Ohjaus ei tunne koko järjestelmän tarkkuutta, joten se on arvioitava itse: järjestelmäepävarmuus = SQRT(3 · u² + p²), jossa u on kunkin lineaariakselin paikoitusepävarmuus (välyksessä toistotarkkuus) ja p kosketusjärjestelmän epävarmuus. Esimerkkejä: u = 10{"\u00A0"}µm, p = 2{"\u00A0"}µm: 17,4{"\u00A0"}µm, arvolla 0,0002°/µm 0,0034°; u = 5{"\u00A0"}µm, p = 2{"\u00A0"}µm: 8,9{"\u00A0"}µm, arvolla 0,0002°/µm 0,0018°.
note-reference-head = Kun vaihtopäät sovitetaan toisiinsa, aseta yksi niistä koneeseen referenssipääksi, kiinnitä kalibrointikuula, vaihda kosketusjärjestelmä karaan, mittaa koko kinematiikka tällä työkierrolla ja aseta esiasetus mittauksen jälkeen ({ $q-sphere-preset } = 2 tai 3). Muut päät sovitetaan sen jälkeen työkierrolla 452.
note-drift-reference = Kun haluat kompensoida ryöminnän, kiinnitä kalibrointikuula, mittaa koko kinematiikka tällä työkierrolla ennen koneistuksen alkua, aseta esiasetus mittauksen jälkeen ({ $q-sphere-preset } = 2 tai 3), aseta sitten työkappaleiden esiasetukset ja aloita koneistus. Työkierto 452 kompensoi ryöminnän aika ajoin.
note-rotary-m-function = Koneen konfiguraatiosta riippuen ohjaus ei ehkä voi paikoittaa kiertoakseleita automaattisesti. Silloin tarvitaan koneen valmistajan erityinen M-toiminto, ja sen numero on annettava parametrissa { $mp-rotary-axis-m-function }.
note-angle-optimization-prepared = Kulmien optimointi edellyttää, että koneen valmistaja on mukauttanut konfiguraation. Optimoinnista voi olla hyötyä erityisesti pienissä, kompakteissa koneissa. Kysy koneen valmistajalta, onko konfiguraatio mukautettu ja onko optimointi tarkoituksenmukaista.
title-save-and-check-kinematics = Kinematiikan tarkastus
title-calibration-program = Kalibrointiohjelma
title-optimize-position-with-backlash = Kiertoakselien aseman optimointi automaattisen peruspisteen asetuksen jälkeen ja välyksen mittaus
title-optimize-position-and-angle = Kiertoakselien kulman ja aseman optimointi automaattisen peruspisteen asetuksen jälkeen
title-measure-reference-head = Referenssipään mittaus
title-reference-for-drift = Referenssimittaus ryöminnän kompensointia varten
