# Taskut, urat, kaulat, suorat pistekuviot ja rivijyrsintä.

# --- taskuille, urille ja kauloille yhteiset ---
guard-tool-wider-than-slot = Työkalu ei mahdu uraan: kun sivun työvarat vähennetään, ura on kapeampi kuin työkalu.
guard-stud-blank-too-small = Aihio ei ole suurempi kuin valmis kaula.
note-finishing-only-rapid-to-first-depth = Törmäysvaara! Jos työkierto kutsutaan koneistuksen laajuudella 2 (vain silitys), ohjaus siirtää työkalun pikaliikkeellä ensimmäiseen asetussyvyyteen.

# --- 252 ---
cycle-circular-pocket = Ympyrätasku
    .nc = YMPYRÄTASKU
    .purpose = Työkierto koneistaa ympyrätaskun kokonaan: rouhinta, pohjan silitys ja sivun silitys. Mahdollista on myös pelkkä rouhinta, pelkkä pohjan ja sivun silitys, pelkkä pohjan silitys tai pelkkä sivun silitys.
guard-plunging-angle-not-vertical = Kohtisuora sisäänpisto edellyttää, että työkalutaulukon sisäänpistokulma { $mp-plunging-angle } on 0 tai 90.
note-position-at-pocket-centre = Paikoita työkalu koneistustason alkupisteeseen (ympyrän keskipisteeseen) sädekorjauksella R0.

# --- 253 ---
cycle-slot = Uran jyrsintä
    .nc = URAN JYRSINTÄ
    .purpose = Työkierto koneistaa uran kokonaan: rouhinta, pohjan silitys ja sivun silitys. Mahdollista on myös pelkkä rouhinta, pelkkä pohjan ja sivun silitys, pelkkä pohjan silitys tai pelkkä sivun silitys.
step-move-over-left-slot-arc = Ohjaus paikoittaa työkalun pikaliikkeellä ensin työkaluakselin suunnassa 2. varmuusetäisyydelle { $q-second-set-up-clearance } (ellei sitä ole annettu, varmuusetäisyydelle), sitten uran vasemman kaaren keskipisteen yläpuolelle ja sen jälkeen varmuusetäisyydelle { $q-set-up-clearance }.
step-plunge-at-left-slot-arc = Työkalu tunkeutuu uran vasemman kaaren keskipisteestä alkaen seuraavaan asetussyvyyteen { $q-plunging-depth }. Parametri { $q-plunging-strategy } määrää sisäänpistotavan:
say-plunge-to-and-fro-along-slot = { $q-plunging-strategy } = 1 tai 2: edestakaisin uraa pitkin työkalutaulukon sisäänpistokulmalla { $mp-plunging-angle } ja syöttöarvolla { $q-plunging-feed }
step-clear-slot-level = Ohjaus rouhii uran sisältä ulospäin ja ottaa huomioon silitystyövarat { $q-side-allowance } ja { $q-floor-allowance }.
step-rapid-to-first-plunging-depth-of-slot = Jos vain silitys on ohjelmoitu ({ $q-machining-operation } = 2), ohjaus siirtää työkalun pikaliikkeellä ensimmäiseen asetussyvyyteen.
step-finish-slot-side = Jos sivun silitystyövara { $q-side-allowance } on määritelty, ohjaus silittää ensin uran seinämät; jos { $q-finishing-infeed } on annettu, useilla asetusliikkeillä. Se lähestyy seinämää tangentiaalisesti uran vasemmassa kaaressa.
step-finish-slot-side__circular-slot = Jos sivun silitystyövara { $q-side-allowance } on määritelty, ohjaus silittää ensin uran seinämät; jos { $q-finishing-infeed } on annettu, useilla asetusliikkeillä. Se lähestyy seinämää tangentiaalisesti.
until-slot-side-finished = seinämät on silitetty syvyyteen { $q-depth }
step-finish-slot-floor = Jos pohjan silitystyövara { $q-floor-allowance } on määritelty, ohjaus silittää sen jälkeen uran pohjan sisältä ulospäin.
step-leave-slot = Työkalu poistuu urasta pikaliikkeellä 2. varmuusetäisyydelle { $q-second-set-up-clearance } (ellei sitä ole annettu, varmuusetäisyydelle).
step-end-of-slot = Työkalun asema työkierron lopussa riippuu uran sijainnista { $q-slot-position }:
say-back-to-slot-centre = { $q-slot-position } = 0: ohjaus palauttaa työkalun koneistustasossa uran keskelle
say-stays-in-working-plane = muussa tapauksessa ohjaus ei paikoita työkalua koneistustasossa
note-position-at-slot-start = Paikoita työkalu koneistustason alkupisteeseen sädekorjauksella R0. Ota huomioon uran sijainti { $q-slot-position }.
note-position-at-slot-start__circular-slot = Paikoita työkalu koneistustason alkupisteeseen sädekorjauksella R0. Ota huomioon uran sijainnin perusta { $q-slot-position-reference }.
note-slot-end-position = Työkierron lopussa ohjaus palauttaa työkalun koneistustasossa uran keskelle. Poikkeus: jos uran sijainti { $q-slot-position } ei ole 0, se paikoittaa työkalun vain työkaluakselin suunnassa 2. varmuusetäisyydelle. Aja työkalu takaisin aloitusasemaan ennen työkierron uutta kutsua tai ohjelmoi ennen kutsua absoluuttiset liikkeet.
note-wide-slot-is-cleared = Jos ura on leveämpi kuin kaksi kertaa työkalun halkaisija, ohjaus rouhii sen vastaavasti sisältä ulospäin. Näin minkä levyisiä uria tahansa voidaan jyrsiä myös pienillä työkaluilla.

# --- 254 ---
cycle-circular-slot = Pyöreä ura
    .nc = PYÖREÄ URA
    .purpose = Työkierto koneistaa pyöreän uran tai useita uria jakoympyrällä kokonaan: rouhinta, pohjan silitys ja sivun silitys. Mahdollista on myös pelkkä rouhinta, pelkkä pohjan ja sivun silitys, pelkkä pohjan silitys tai pelkkä sivun silitys.
step-move-over-circular-slot = Ohjaus paikoittaa työkalun pikaliikkeellä ensin työkaluakselin suunnassa 2. varmuusetäisyydelle { $q-second-set-up-clearance } (ellei sitä ole annettu, varmuusetäisyydelle), sitten uran alkupisteen yläpuolelle ja sen jälkeen varmuusetäisyydelle { $q-set-up-clearance }.
step-plunge-in-circular-slot = Työkalu tunkeutuu uran leveyden keskellä seuraavaan asetussyvyyteen { $q-plunging-depth }. Parametri { $q-plunging-strategy } määrää sisäänpistotavan:
until-all-slots-milled = kaikki urat ({ $q-number-of-operations }) on jyrsitty; jokainen on käännetty edellisestä kulman { $q-pattern-stepping-angle } verran jakoympyrän keskipisteen ympäri
step-end-of-circular-slot = Työkalun asema työkierron lopussa riippuu uran sijainnin perustasta { $q-slot-position-reference }:
say-back-to-pitch-circle-centre = { $q-slot-position-reference } = 0: ohjaus palauttaa työkalun koneistustasossa alkupisteeseen (jakoympyrän keskipisteeseen)
condition-slot-at-entered-centre = uran sijainti määräytyy jakoympyrän annetusta keskipisteestä ({ $q-slot-position-reference } = 0)
note-circular-slot-end-position = Työkierron lopussa ohjaus palauttaa työkalun koneistustasossa alkupisteeseen (jakoympyrän keskipisteeseen). Poikkeus: jos uran sijainti { $q-slot-position-reference } ei ole 0, se paikoittaa työkalun vain työkaluakselin suunnassa 2. varmuusetäisyydelle. Ohjelmoi tällöin työkierron kutsun jälkeen aina absoluuttiset liikkeet.
note-circular-slot-with-pattern = Jos työkierto 254 (pyöreä ura) yhdistetään työkiertoon 221, uran sijainnille ei saa antaa arvoa 0.

# --- 256 ---
cycle-rectangular-stud = Suorakulmakaula
    .nc = SUORAKULMAKAULA
    .purpose = Työkierto koneistaa suorakulmakaulan. Jos aihio on suurempi kuin suurin mahdollinen sivuttaisasetus, ohjaus tekee useita sivuttaisasetuksia, kunnes valmismitat on saavutettu.
step-move-to-stud-approach = Työkalu siirtyy työkierron aloitusasemasta (kaulan keskipisteestä) kaulan koneistuksen aloitusasemaan. Sen määrää parametri { $q-stud-approach-position }:
say-approach-beside-blank = { $q-stud-approach-position } = 0 (perusasetus): 2{"\u00A0"}mm kaulan aihiosta oikealle
say-approach-at-stud-corner = muussa tapauksessa valitussa nurkassa
step-rapid-down-to-set-up-clearance = Jos työkalu on 2. varmuusetäisyydellä, ohjaus siirtää sen pikaliikkeellä (FMAX) varmuusetäisyydelle { $q-set-up-clearance }.
step-feed-to-plunging-depth-of-stud = Työkalu siirtyy syvyysasetuksen syöttöarvolla { $q-plunging-feed } seuraavaan asetussyvyyteen { $q-plunging-depth }.
step-mill-around-stud = Sen jälkeen työkalu lähestyy kaulan muotoa tangentiaalisesti ja jyrsii yhden kierroksen.
step-mill-around-stud-again = Jos valmismittoja ei saavuteta yhdellä kierroksella, ohjaus tekee sivuttaisasetuksen hetkellisessä asetussyvyydessä ja jyrsii uuden kierroksen ottaen huomioon aihion mitat, valmismitat ja sallitun sivuttaisasetuksen. Tämä toistetaan, kunnes valmismitat on saavutettu. Jos alkupiste on nurkassa ({ $q-stud-approach-position } ei ole 0), ohjaus jyrsii alkupisteestä spiraalirataa sisäänpäin, kunnes valmismitat on saavutettu.
step-leave-stud-to-start = Jos tarvitaan lisää asetusliikkeitä, työkalu irtautuu muodosta tangentiaalisesti ja palaa kaulan alkupisteeseen.
until-stud-depth-reached = kaulan ohjelmoitu syvyys { $q-depth } on saavutettu
step-retract-from-stud = Työkierron loppuasema ei ole sama kuin aloitusasema, koska ohjaus paikoittaa työkalun lopussa vain työkaluakselin suunnassa:
note-position-at-stud-start = Paikoita työkalu koneistustason alkupisteeseen sädekorjauksella R0. Ota huomioon kaulan sijainti { $q-stud-position }.
note-room-beside-stud = Törmäysvaara! Jätä kaulan oikealle puolelle riittävästi tilaa työkalun lähestymistä varten: vähintään työkalun halkaisija + 2{"\u00A0"}mm.
note-stud-end-position = Törmäysvaara! Lopussa ohjaus palauttaa työkalun varmuusetäisyydelle tai, jos se on annettu, 2. varmuusetäisyydelle. Työkalun loppuasema työkierron jälkeen ei siis ole sama kuin sen aloitusasema.
note-choose-other-approach-position = Jos lähestyminen asetuksella { $q-stud-approach-position } = 0 jättää jälkiä kaulan pintaan, valitse toinen lähestymisasema.

# --- 257 ---
cycle-circular-stud = Ympyräkaula
    .nc = YMPYRÄKAULA
    .purpose = Työkierto koneistaa ympyräkaulan. Jos aihion halkaisija on suurempi kuin suurin mahdollinen sivuttaisasetus, ohjaus tekee useita sivuttaisasetuksia, kunnes valmis halkaisija on saavutettu.
step-move-to-circular-stud-approach = Työkalu siirtyy työkierron aloitusasemasta (kaulan keskipisteestä) kaulan koneistuksen aloitusasemaan. Sen määrää parametri { $q-stud-starting-angle } napakulmana kaulan keskipisteen suhteen.
step-mill-spiral-around-stud = Sen jälkeen työkalu lähestyy kaulan muotoa tangentiaalisesti spiraalirataa pitkin ja jyrsii yhden kierroksen.
step-keep-spiral-to-finished-diameter = Jos valmista halkaisijaa ei saavuteta yhdellä kierroksella, ohjaus jatkaa asetusliikettä spiraalirataa pitkin, kunnes se on saavutettu, ja ottaa huomioon aihion halkaisijan, valmiin halkaisijan ja sallitun sivuttaisasetuksen.
step-leave-stud-on-spiral = Ohjaus irrottaa työkalun muodosta spiraalirataa pitkin.
step-next-infeed-near-departure = Jos tarvitaan useita asetusliikkeitä, seuraava tehdään irtautumiskohtaa lähinnä olevassa pisteessä.
step-retract-and-return-to-stud-centre = Kun työkalu on työkierron lopussa irtautunut spiraalirataa pitkin, ohjaus paikoittaa sen työkaluakselin suunnassa 2. varmuusetäisyydelle { $q-second-set-up-clearance } (ellei sitä ole annettu, varmuusetäisyydelle) ja sen jälkeen kaulan keskipisteeseen.
note-position-at-stud-centre = Paikoita työkalu koneistustason alkupisteeseen (kaulan keskipisteeseen) sädekorjauksella R0.
note-circular-stud-end-height = Törmäysvaara! Lopussa ohjaus palauttaa työkalun varmuusetäisyydelle tai, jos se on annettu, 2. varmuusetäisyydelle. Työkaluakselin suunnassa loppuasema työkierron jälkeen voi siis poiketa aloitusasemasta.

# --- 221 ---
cycle-line-pattern = Pistekuvio suorilla
    .nc = RIVIKUVIO
    .purpose = Työkierto suorittaa viimeksi määritellyn koneistustyökierron riveihin ja sarakkeisiin järjestetyissä pisteissä.
until-line-done = rivin kaikki koneistukset ({ $q-number-of-columns }) on tehty; työkalu on rivin viimeisessä pisteessä
step-move-to-next-column = Sen jälkeen ohjaus siirtää työkalun seuraavan koneistuksen alkupisteeseen, ensimmäisellä, kolmannella, viidennellä … rivillä pääakselin positiiviseen suuntaan, toisella, neljännellä, kuudennella … rivillä negatiiviseen suuntaan, ja siellä varmuusetäisyydelle { $q-set-up-clearance }.
step-height-between-lines = Rivin viimeisessä pisteessä työkalu siirtyy karan akselin suunnassa koneistusten väliselle korkeudelle parametrin { $q-pattern-clearance-mode } mukaan.
step-move-to-next-line = Sen jälkeen ohjaus siirtää työkalun seuraavalle riville suoraan saman sarakkeen pisteeseen ja siellä varmuusetäisyydelle { $q-set-up-clearance }. Kaikki seuraavat rivit koneistetaan näin edestakaisin.
until-all-lines-done = kaikki rivit ({ $q-number-of-lines }) on tehty
note-pattern-overrides-heights-and-rotation = Jos jokin koneistustyökierroista 200–209 tai 251–267 yhdistetään tähän työkiertoon, voimassa ovat tämän työkierron varmuusetäisyys { $q-set-up-clearance }, työkappaleen yläpinnan koordinaatti { $q-surface-coordinate }, 2. varmuusetäisyys { $q-second-set-up-clearance } ja kiertokulma { $q-angle-of-rotation }.

# --- pinnoille yhteiset ---
until-surface-milled = annettu pinta on jyrsitty kokonaan
note-pre-position-for-surface = Törmäysvaara! Esipaikoita työkalu niin, ettei se voi törmätä työkappaleeseen eikä sen kiinnittimiin.

# --- 230 ---
cycle-multipass-milling = Rivijyrsintä
    .nc = RIVIJYRSINTÄ
    .purpose = Työkierto jyrsii tasaisen suorakulmaisen pinnan riveittäin edestakaisin.
step-rapid-to-start-of-lines = Ohjaus paikoittaa työkalun pikaliikkeellä (FMAX) hetkellisasemasta koneistustasossa alkupisteeseen 1. Se siirtää työkalua työkalun säteen verran vasemmalle ja ylös.
step-down-to-start-of-lines = Sen jälkeen työkalu siirtyy karan akselin suunnassa pikaliikkeellä (FMAX) varmuusetäisyydelle { $q-set-up-clearance } ja sieltä syvyysasetuksen syöttöarvolla { $q-plunging-feed } karan akselin ohjelmoituun aloitusasemaan { $q-starting-point-tool }.
step-mill-line = Sen jälkeen työkalu jyrsii ohjelmoidulla syöttöarvolla { $q-milling-feed } loppupisteeseen 2, jonka ohjaus laskee alkupisteestä, ohjelmoidusta pituudesta { $q-first-side-length } ja työkalun säteestä.
step-step-over-to-next-line = Ohjaus siirtää työkalun sivusuunnassa syöttöarvolla { $q-stepover-feed } seuraavan rivin alkupisteeseen. Siirtymän se laskee ohjelmoidusta leveydestä { $q-second-side-length } ja lastujen lukumäärästä { $q-number-of-cuts }.
step-mill-back-in-next-line = Sen jälkeen työkalu jyrsii takaisin 1. akselin negatiiviseen suuntaan.
step-rapid-back-to-clearance-over-surface = Lopuksi ohjaus vetää työkalun pikaliikkeellä (FMAX) varmuusetäisyydelle { $q-set-up-clearance }.
note-plane-first-then-spindle-axis = Ohjaus paikoittaa työkalun hetkellisasemasta alkupisteeseen ensin koneistustasossa ja sen jälkeen karan akselin suunnassa.

# --- 231 ---
cycle-ruled-surface = Viivoitinpinta
    .nc = VIIVOITINPINTA
    .purpose = Työkierto jyrsii neljällä kulmapisteellä annetun vinon, kaltevan tai kiertyneen pinnan samansuuntaisina riveinä.
step-straight-to-starting-point = Ohjaus siirtää työkalun hetkellisasemasta suoraa pitkin avaruudessa alkupisteeseen 1.
step-mill-line-to-its-end = Sen jälkeen työkalu jyrsii ohjelmoidulla syöttöarvolla { $q-milling-feed } rivin loppupisteeseen: ensimmäisellä rivillä pisteeseen 2 puolella syöttöarvolla; jokaisella seuraavalla rivillä pisteeseen, jonka ohjaus laskee pisteestä 2 ja siirtymästä kohti pistettä 3.
step-rapid-back-to-start-of-line = Sieltä ohjaus siirtää työkalua pikaliikkeellä (FMAX) karan akselin positiiviseen suuntaan työkalun halkaisijan verran rivin korkeamman pään yläpuolelle ja sen jälkeen takaisin rivin alkupisteeseen (ensimmäisellä rivillä pisteeseen 1).
step-down-to-last-height = Siellä ohjaus siirtää työkalun karan akselilla siihen asemaan, jossa se alkupisteessä viimeksi oli.
step-move-to-start-of-next-line = Sen jälkeen ohjaus siirtää työkalun kaikilla kolmella akselilla pisteestä 1 kohti pistettä 4 seuraavalle riville.
step-above-highest-point = Lopuksi ohjaus paikoittaa työkalun sen halkaisijan verran karan akselin suunnassa ylimmän annetun pisteen yläpuolelle.
note-cutting-direction-of-surface = Alkupiste ja sen myötä jyrsintäsuunta ovat vapaasti valittavissa: ohjaus ajaa yksittäiset lastut pisteestä 1 pisteeseen 2, ja kokonaisuus etenee pisteistä 1 ja 2 pisteisiin 3 ja 4. Piste 1 voi olla pinnan missä tahansa kulmassa.
note-surface-quality-with-end-mills = Varsijyrsimillä pinnanlaatua voidaan parantaa seuraavasti: työntävällä lastulla (pisteen 1 karan akselin koordinaatti on suurempi kuin pisteen 2) loivasti kaltevilla pinnoilla; vetävällä lastulla (pisteen 1 karan akselin koordinaatti on pienempi kuin pisteen 2) jyrkillä pinnoilla; kiertyneillä pinnoilla asettamalla päälastuamissuunta (pisteestä 1 pisteeseen 2) jyrkemmän kaltevuuden suuntaan.
note-surface-quality-with-ball-end-mills = Sädejyrsimillä kiertyneiden pintojen laatua voidaan parantaa asettamalla päälastuamissuunta (pisteestä 1 pisteeseen 2) kohtisuoraan jyrkintä kaltevuutta vastaan.
note-straight-to-start-without-collision = Törmäysvaara! Ohjaus siirtää työkalun hetkellisasemasta suoraa pitkin avaruudessa alkupisteeseen 1. Esipaikoita työkalu niin, ettei se voi törmätä työkappaleeseen eikä sen kiinnittimiin.
note-positions-with-r0 = Ohjaus siirtää työkalua annettujen asemien välillä sädekorjauksella R0.
note-centre-cut-or-pilot-drill = Käytä tarvittaessa varsijyrsintä, jossa on keskeltä lastuava terä (DIN 844), tai esiporaa työkierrolla 21.

# --- 232 ---
cycle-face-milling = Tasojyrsintä
    .nc = TASOJYRSINTÄ
    .purpose = Työkierto jyrsii tasaisen pinnan useilla asetusliikkeillä jollakin kolmesta strategiasta ja ottaa silitystyövaran huomioon.
step-position-beside-surface = Ohjaus paikoittaa työkalun hetkellisasemasta pikaliikkeellä (FMAX) ja paikoituslogiikalla alkupisteeseen 1, joka on työkappaleen vieressä työkalun säteen ja sivuetäisyyden { $q-side-clearance } päässä siitä:
say-plane-then-spindle-axis = jos työkalu on 2. varmuusetäisyyden { $q-second-set-up-clearance } yläpuolella: ensin koneistustasossa, sitten karan akselin suunnassa
say-second-clearance-then-plane = muussa tapauksessa ensin 2. varmuusetäisyydelle { $q-second-set-up-clearance }, sitten koneistustasossa
step-feed-to-face-infeed = Sen jälkeen työkalu siirtyy karan akselin suunnassa esipaikoituksen syöttöarvolla { $q-pre-positioning-feed } seuraavaan ohjauksen laskemaan asetussyvyyteen.
step-mill-face-line = Työkalu jyrsii ohjelmoidulla syöttöarvolla { $q-milling-feed } loppupisteeseen 2:
say-line-ends-outside-surface = { $q-face-milling-strategy } = 0: pinnan ulkopuolelle; ohjaus laskee sen ohjelmoidusta alkupisteestä, pituudesta ja sivuetäisyydestä { $q-side-clearance } sekä työkalun säteestä
say-line-ends-inside-surface = { $q-face-milling-strategy } = 1: pinnan sisäpuolelle; ohjaus laskee sen ohjelmoidusta alkupisteestä ja pituudesta sekä työkalun säteestä
say-line-ends-outside-surface-by-lines = { $q-face-milling-strategy } = 2: pinnan ulkopuolelle; ohjaus laskee sen ohjelmoidusta alkupisteestä, pituudesta ja sivuetäisyydestä { $q-side-clearance } sekä työkalun säteestä
step-step-over-on-face = Ohjaus laskee siirtymän ohjelmoidusta leveydestä { $q-second-side-length }, työkalun säteestä ja suurimmasta ratalimityskertoimesta { $q-max-path-overlap } ja siirtää työkalun sivusuunnassa seuraavan rivin alkupisteeseen:
say-step-over-outside = { $q-face-milling-strategy } = 0: esipaikoituksen syöttöarvolla { $q-pre-positioning-feed }
say-step-over-inside = { $q-face-milling-strategy } = 1: työkappaleen sisäpuolella, jyrsinnän syöttöarvolla { $q-milling-feed }
say-retract-and-return-to-next-line = { $q-face-milling-strategy } = 2: työkalu siirtyy karan akselin suunnassa varmuusetäisyydelle { $q-set-up-clearance } hetkellisen asetussyvyyden yläpuolelle ja esipaikoituksen syöttöarvolla { $q-pre-positioning-feed } suoraan takaisin seuraavan rivin alkupisteeseen
step-mill-next-face-line = Sen jälkeen työkalu jyrsii seuraavan rivin:
say-back-towards-start = { $q-face-milling-strategy } = 0: takaisin alkupisteen 1 suuntaan
say-back-towards-start-inside = { $q-face-milling-strategy } = 1: takaisin alkupisteen 1 suuntaan; siirtyminen seuraavalle riville tapahtuu taas työkappaleen sisäpuolella
say-down-and-towards-end = { $q-face-milling-strategy } = 2: se siirtyy takaisin hetkelliseen asetussyvyyteen ja sieltä loppupisteen 2 suuntaan
step-repeat-until-face-milled = Tämä toistetaan, kunnes annettu pinta on jyrsitty kokonaan. Viimeisen radan lopussa työkalu asetetaan seuraavaan koneistussyvyyteen. Tyhjien liikkeiden välttämiseksi pinta koneistetaan sen jälkeen käänteisessä järjestyksessä.
until-face-infeeds-done = kaikki asetusliikkeet viimeistä lukuun ottamatta on tehty
step-finish-face = Viimeisellä asetusliikkeellä jyrsitään vain annettu silitystyövara { $q-floor-allowance } silityksen syöttöarvolla { $q-finishing-feed }.
step-rapid-back-to-second-clearance = Lopuksi ohjaus vetää työkalun pikaliikkeellä (FMAX) 2. varmuusetäisyydelle { $q-second-set-up-clearance }.
note-three-face-milling-strategies = Valittavana on kolme strategiaa. { $q-face-milling-strategy } = 0: mutkittelevat radat, sivuttaisasetus koneistettavan pinnan ulkopuolella. { $q-face-milling-strategy } = 1: mutkittelevat radat, sivuttaisasetus koneistettavan pinnan sisäpuolella. { $q-face-milling-strategy } = 2: rivi kerrallaan, vetäytyminen ja sivuttaisasetus paikoituksen syöttöarvolla.
note-levels-in-reverse-order = Tyhjien liikkeiden välttämiseksi jokainen seuraava taso koneistetaan käänteisessä järjestyksessä.
note-second-clearance-without-collision = Anna 2. varmuusetäisyys { $q-second-set-up-clearance } niin, ettei työkalu voi törmätä työkappaleeseen eikä sen kiinnittimiin.
note-equal-end-and-start-do-nothing = Jos 3. akselin alkupiste { $q-starting-point-tool } ja 3. akselin loppupiste { $q-end-point-tool } ovat yhtä suuret, ohjaus ei suorita työkiertoa (ohjelmoitu syvyys on 0).
