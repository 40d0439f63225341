# Koneistustyökiertojen parametrit: nimi, teksti NC-lauseessa, ohje.

# --- korkeudet ja syvyydet ---
parameter-set-up-clearance = Varmuusetäisyys
    .label = VARMUUSETÄISYYS
    .help = Työkalun kärjen ja työkappaleen yläpinnan välinen etäisyys.
parameter-set-up-clearance__drilling =
    .help = Työkalun kärjen ja työkappaleen yläpinnan välinen etäisyys. Anna positiivinen arvo.
parameter-set-up-clearance__centring =
    .help = Työkalun kärjen ja työkappaleen yläpinnan välinen etäisyys. Anna positiivinen arvo.
parameter-set-up-clearance__circular-pattern =
    .help = Työkalun kärjen ja työkappaleen yläpinnan välinen etäisyys. Se koskee myös koneistustyökiertoa, jonka kuvio kutsuu.
parameter-set-up-clearance__rectangular-pocket =
    .help = Työkalun kärjen ja työkappaleen yläpinnan välinen etäisyys. PREDEF ottaa arvon GLOBAL DEF -lauseesta.
parameter-set-up-clearance__circular-pocket =
    .help = Työkalun kärjen ja työkappaleen yläpinnan välinen etäisyys. PREDEF ottaa arvon GLOBAL DEF -lauseesta.
parameter-set-up-clearance__slot =
    .help = Työkalun kärjen ja työkappaleen yläpinnan välinen etäisyys. PREDEF ottaa arvon GLOBAL DEF -lauseesta.
parameter-set-up-clearance__circular-slot =
    .help = Työkalun kärjen ja työkappaleen yläpinnan välinen etäisyys. PREDEF ottaa arvon GLOBAL DEF -lauseesta.
parameter-set-up-clearance__rectangular-stud =
    .help = Työkalun kärjen ja työkappaleen yläpinnan välinen etäisyys. PREDEF ottaa arvon GLOBAL DEF -lauseesta.
parameter-set-up-clearance__circular-stud =
    .help = Työkalun kärjen ja työkappaleen yläpinnan välinen etäisyys. PREDEF ottaa arvon GLOBAL DEF -lauseesta.
parameter-second-set-up-clearance = 2. varmuusetäisyys
    .label = 2. VARMUUSETÄIS.
    .help = Karan akselin korkeus, jolla työkalu ei voi törmätä työkappaleeseen eikä sen kiinnittimiin.
parameter-second-set-up-clearance__circular-pattern =
    .help = Karan akselin korkeus, jolla työkalu ei voi törmätä työkappaleeseen eikä sen kiinnittimiin. Se koskee myös koneistustyökiertoa, jonka kuvio kutsuu.
parameter-second-set-up-clearance__rectangular-pocket =
    .help = Karan akselin korkeus, jolla työkalu ei voi törmätä työkappaleeseen eikä sen kiinnittimiin. PREDEF ottaa arvon GLOBAL DEF -lauseesta.
parameter-second-set-up-clearance__circular-pocket =
    .help = Karan akselin korkeus, jolla työkalu ei voi törmätä työkappaleeseen eikä sen kiinnittimiin. PREDEF ottaa arvon GLOBAL DEF -lauseesta.
parameter-second-set-up-clearance__slot =
    .help = Karan akselin korkeus, jolla työkalu ei voi törmätä työkappaleeseen eikä sen kiinnittimiin. PREDEF ottaa arvon GLOBAL DEF -lauseesta.
parameter-second-set-up-clearance__circular-slot =
    .help = Karan akselin korkeus, jolla työkalu ei voi törmätä työkappaleeseen eikä sen kiinnittimiin. PREDEF ottaa arvon GLOBAL DEF -lauseesta.
parameter-second-set-up-clearance__rectangular-stud =
    .help = Karan akselin korkeus, jolla työkalu ei voi törmätä työkappaleeseen eikä sen kiinnittimiin. PREDEF ottaa arvon GLOBAL DEF -lauseesta.
parameter-second-set-up-clearance__circular-stud =
    .help = Karan akselin korkeus, jolla työkalu ei voi törmätä työkappaleeseen eikä sen kiinnittimiin. PREDEF ottaa arvon GLOBAL DEF -lauseesta.
parameter-second-set-up-clearance__face-milling =
    .help = Karan akselin korkeus, jolla työkalu ei voi törmätä työkappaleeseen eikä sen kiinnittimiin. PREDEF ottaa arvon GLOBAL DEF -lauseesta.
parameter-surface-coordinate = Työkappaleen yläpinnan koordinaatti
    .label = KOORD. YLÄPINTA
    .help = Työkappaleen yläpinnan koordinaatti karan akselilla; syvyydet mitataan siitä.
parameter-surface-coordinate__circular-pattern =
    .help = Työkappaleen yläpinnan koordinaatti karan akselilla; syvyydet mitataan siitä. Se koskee myös koneistustyökiertoa, jonka kuvio kutsuu.
parameter-depth = Syvyys
    .label = SYVYYS
    .help = Työkappaleen yläpinnan ja reiän pohjan välinen etäisyys poranterän kärkeen mitattuna.
parameter-depth__rectangular-pocket =
    .help = Työkappaleen yläpinnan ja taskun pohjan välinen etäisyys.
parameter-plunging-depth = Asetussyvyys
    .label = ASETUSSYVYYS
    .help = Matka, jonka työkalu etenee yhdellä asetusliikkeellä. Syvyyden ei tarvitse olla sen monikerta. Työkalu ajaa syvyyteen yhdellä liikkeellä, jos asetussyvyys on yhtä suuri tai suurempi kuin syvyys.
parameter-plunging-depth__rectangular-pocket =
    .help = Matka, jonka työkalu etenee yhdellä asetusliikkeellä. Anna arvo, joka on suurempi kuin 0.
parameter-decrement = Vähennysarvo
    .label = VÄHENNYSARVO
    .help = Arvo, jonka verran asetussyvyys { $q-plunging-depth } pienenee jokaisella asetusliikkeellä.
parameter-least-plunging-depth = Pienin asetussyvyys
    .label = MIN. ASETUSSYVYYS
    .help = Jos vähennysarvo { $q-decrement } on annettu, mikään asetusliike ei ole tätä arvoa pienempi.
parameter-upper-advanced-stop-distance = Ylempi esipysäytysetäisyys
    .label = ESIPYSÄYTYSETÄIS. YLÄ
    .help = Etäisyys hetkellisestä asetussyvyydestä, kun työkalu palaa vetäytymisen jälkeen pikaliikkeellä reikään: arvo ensimmäiselle asetusliikkeelle.
parameter-lower-advanced-stop-distance = Alempi esipysäytysetäisyys
    .label = ESIPYSÄYTYSETÄIS. ALA
    .help = Etäisyys hetkellisestä asetussyvyydestä, kun työkalu palaa vetäytymisen jälkeen pikaliikkeellä reikään: arvo viimeiselle asetusliikkeelle.
parameter-depth-for-chip-breaking = Asetussyvyys lastunkatkoon
    .label = SYVYYS LASTUNKATKOON
    .help = Asetusmatka, jonka jälkeen lastu katkaistaan. Arvolla 0 lastunkatkoa ei ole.
parameter-chip-breaking-retraction = Vetäytymismatka lastunkatkossa
    .label = VETÄYT. LASTUNKATKOSSA
    .help = Matka, jonka työkalu vetäytyy lastun katkaisemiseksi. Vetäytymisen syöttöarvo on 3000{"\u00A0"}mm/min.
parameter-deepened-starting-point = Syvennetty alkupiste
    .label = ALKUPISTE
    .help = Varsinaisen porauksen alkupiste työkappaleen yläpinnasta mitattuna, kun reikä on jo porattu lyhyemmällä työkalulla johonkin syvyyteen. Työkalu siirtyy sinne varmuusetäisyydeltä esipaikoituksen syöttöarvolla { $q-pre-positioning-feed }.

# --- syöttöarvot ja ajat ---
parameter-plunging-feed = Syvyysasetuksen syöttöarvo
    .label = SYÖTTÖARVON SYVYYSASETUS
    .help = Työkalun liikenopeus porauksessa.
parameter-plunging-feed__rectangular-pocket =
    .help = Työkalun liikenopeus syvyyteen ajettaessa.
parameter-pre-positioning-feed = Esipaikoituksen syöttöarvo
    .label = ESIPAIK. SYÖTTÖARVO
    .help = Työkalun liikenopeus varmuusetäisyydeltä syvennettyyn alkupisteeseen. Vaikuttaa vain, jos { $q-deepened-starting-point } ei ole 0.
parameter-milling-feed = Jyrsinnän syöttöarvo
    .label = JYRSINNÄN SYÖTTÖARVO
    .help = Työkalun liikenopeus jyrsinnässä.
parameter-finishing-feed = Silityksen syöttöarvo
    .label = SILITYKSEN SYÖTTÖARVO
    .help = Työkalun liikenopeus sivun ja pohjan silityksessä.
parameter-dwell-at-top = Odotusaika ylhäällä
    .label = ODOTUSAIKA YLHÄÄLLÄ
    .help = Aika, jonka työkalu odottaa varmuusetäisyydellä sen jälkeen, kun se on vedetty reiästä jäähtymään.
parameter-dwell-at-bottom = Odotusaika alhaalla
    .label = ODOTUSAIKA ALHAALLA
    .help = Aika, jonka työkalu odottaa reiän pohjalla.

# --- taskujen jyrsintä ---
parameter-machining-operation = Koneistuksen laajuus
    .label = KONEISTUSLAAJUUS
    .help = Määrää, mitä koneistetaan. Sivu ja pohja silitetään vain, jos vastaava työvara ({ $q-side-allowance }, { $q-floor-allowance }) on määritelty.
parameter-first-side-length = 1. sivun pituus
    .label = 1. SIVUN PITUUS
    .help = Taskun pituus koneistustason pääakselin suunnassa.
parameter-second-side-length = 2. sivun pituus
    .label = 2. SIVUN PITUUS
    .help = Taskun pituus koneistustason sivuakselin suunnassa.
parameter-corner-radius = Nurkan säde
    .label = NURKAN SÄDE
    .help = Taskun nurkkien säde. Arvolla 0 ohjaus käyttää nurkan säteenä työkalun sädettä.
parameter-side-allowance = Sivun silitystyövara
    .label = SIVUN TYÖVARA
    .help = Silitystyövara koneistustasossa.
parameter-floor-allowance = Pohjan silitystyövara
    .label = POHJAN TYÖVARA
    .help = Silitystyövara syvyyssuunnassa.
parameter-angle-of-rotation = Kiertokulma
    .label = KIERTOKULMA
    .help = Kulma, jonka verran koko koneistusta kierretään. Kierron keskipiste on työkalun asema työkierron kutsuhetkellä.
parameter-pocket-position = Taskun sijainti
    .label = TASKUN SIJAINTI
    .help = Taskun sijainti työkalun asemaan nähden työkierron kutsuhetkellä.
parameter-milling-type = Jyrsintämenetelmä
    .label = JYRSINTÄMENETELMÄ
    .help = Jyrsinnän laji karan pyöriessä myötäpäivään (M3). PREDEF ottaa arvon GLOBAL DEF -lauseesta.
parameter-finishing-infeed = Silityksen asetusliike
    .label = SILITYKSEN ASETUS
    .help = Matka, jonka työkalu etenee karan akselin suunnassa yhtä silityskertaa kohti. Arvolla 0 silitys tehdään yhdellä asetusliikkeellä.
parameter-path-overlap = Ratalimityskerroin
    .label = RATALIMITYS
    .help = Sivuttaisasetus k on tämä kerroin kertaa työkalun säde. PREDEF ottaa arvon GLOBAL DEF -lauseesta.
parameter-plunging-strategy = Sisäänpistotapa
    .label = SISÄÄNPISTO
    .help = Määrää, miten työkalu tunkeutuu materiaaliin. PREDEF ottaa arvon GLOBAL DEF -lauseesta.

# --- kuviot ---
parameter-pitch-circle-centre-main = 1. akselin keskipiste
    .label = KESKIP. 1. AKSELILLA
    .help = Jakoympyrän keskipiste koneistustason pääakselilla.
parameter-pitch-circle-centre-minor = 2. akselin keskipiste
    .label = KESKIP. 2. AKSELILLA
    .help = Jakoympyrän keskipiste koneistustason sivuakselilla.
parameter-pitch-circle-diameter = Jakoympyrän halkaisija
    .label = JAKOYMPYRÄN HALKAISIJA
    .help = Jakoympyrän halkaisija; koneistukset ovat tällä ympyrällä.
parameter-pitch-circle-diameter__circular-slot =
    .help = Jakoympyrän halkaisija; uran keskilinja kulkee tätä ympyrää pitkin.
parameter-pattern-starting-angle = Aloituskulma
    .label = ALKUKULMA
    .help = Koneistustason pääakselin ja jakoympyrällä olevan ensimmäisen koneistuksen alkupisteen välinen kulma.
parameter-pattern-stopping-angle = Lopetuskulma
    .label = LOPPUKULMA
    .help = Koneistustason pääakselin ja jakoympyrällä olevan viimeisen koneistuksen alkupisteen välinen kulma; ei koske täysympyröitä. Sen on oltava eri suuri kuin aloituskulma { $q-pattern-starting-angle }. Jos se on suurempi kuin aloituskulma, koneistus etenee vastapäivään, muuten myötäpäivään.
parameter-pattern-stepping-angle = Kulma-askel
    .label = KULMA-ASKEL
    .help = Kahden jakoympyrällä olevan koneistuksen välinen kulma. Arvolla 0 ohjaus laskee sen aloituskulmasta, lopetuskulmasta ja koneistusten lukumäärästä. Jos kulma-askel on annettu, lopetuskulmaa { $q-pattern-stopping-angle } ei oteta huomioon. Etumerkki määrää suunnan (− = myötäpäivään).
parameter-number-of-operations = Koneistusten lukumäärä
    .label = KONEISTUSTEN LUKUMÄÄRÄ
    .help = Koneistusten lukumäärä jakoympyrällä.
parameter-pattern-clearance-mode = Ajo varmuuskorkeudelle
    .label = AJO VARM.KORKEUTEEN
    .help = Määrää, millä korkeudella työkalu siirtyy koneistusten välillä.
parameter-pattern-traverse-type = Liiketapa
    .label = LIIKETAPA
    .help = Ratatoiminto, jolla työkalu siirtyy koneistusten välillä.
    .prompt = Liiketapa? Suora=0/kaari=1

# --- koordinaattimuunnokset ---
parameter-datum-shift = Siirto
    .help = Uuden nollapisteen koordinaatit. Absoluuttiset arvot perustuvat työkappaleen nollapisteeseen, joka on asetettu peruspisteeksi; inkrementaaliset arvot perustuvat aina viimeksi voimassa olleeseen nollapisteeseen, joka voi itsekin olla siirretty. Enintään 6 NC-akselia.
parameter-datum-row = Siirto
    .help = Nollapisteen numero nollapistetaulukossa tai Q-parametri. Jos annetaan Q-parametri, ohjaus aktivoi nollapisteen, jonka numero on parametrissa.
parameter-rotation-angle = Kierto
    .help = Kiertokulma asteina, absoluuttinen tai inkrementaalinen.
parameter-preset-number = Peruspisteen numero
    .label = PERUSPISTEEN NUMERO
    .help = Aktivoitavan peruspisteen numero esiasetustaulukossa.
    .prompt = Peruspisteen numero?

# --- vaihtoehdot ---
choice-roughing-and-finishing = Rouhinta ja silitys
choice-roughing-only = Vain rouhinta
choice-finishing-only = Sivun ja pohjan silitys
choice-tool-at-pocket-centre = Työkalun asema = taskun keskipiste
choice-tool-at-lower-left-corner = Työkalun asema = vasen alanurkka
choice-tool-at-lower-right-corner = Työkalun asema = oikea alanurkka
choice-tool-at-upper-right-corner = Työkalun asema = oikea ylänurkka
choice-tool-at-upper-left-corner = Työkalun asema = vasen ylänurkka
choice-climb-milling = Myötälastu
choice-up-cut-milling = Vastalastu
choice-vertical-plunging = Kohtisuora sisäänpisto riippumatta työkalutaulukon sisäänpistokulmasta { $mp-plunging-angle }
choice-helical-plunging = Kierukkamainen sisäänpisto. Aktiivisen työkalun sisäänpistokulma { $mp-plunging-angle } ei saa työkalutaulukossa olla 0, muuten ohjaus antaa virheilmoituksen
choice-reciprocating-plunging = Heilurimainen sisäänpisto. Aktiivisen työkalun sisäänpistokulma { $mp-plunging-angle } ei saa työkalutaulukossa olla 0, muuten ohjaus antaa virheilmoituksen. Heiluriliikkeen pituus riippuu sisäänpistokulmasta; se on vähintään kaksi kertaa niin suuri kuin työkalun halkaisija
choice-at-set-up-clearance = Koneistusten välinen ajo varmuusetäisyydellä
choice-at-second-set-up-clearance = Koneistusten välinen ajo 2. varmuusetäisyydellä
choice-straight-between-operations = Koneistusten välinen ajo suoraa pitkin
choice-on-the-pitch-circle = Koneistusten välinen ajo jakoympyrää pitkin
