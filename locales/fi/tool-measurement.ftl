# Työkierrot, jotka mittaavat työkalun pöytäkosketusjärjestelmällä.

# --- parametrit ---
parameter-tool-check = Työkalun mittaus =0 / testaus=1
    .label = TESTAUS
    .word = TESTAUS:
    .prompt = Työkalun mittaus =0 / testaus=1
    .help = Määrää, mitataanko työkalu ensimmäistä kertaa vai tarkastetaanko jo aiemmin mitattu työkalu. Ensimmäinen mittaus korvaa työkalun pituuden { $mp-tool-length } työkalutaulukossa TOOL.T ja asettaa sarakkeen { $mp-delta-length } arvoksi 0. Tarkastuksessa mitattua pituutta verrataan työkalun pituuteen { $mp-tool-length }; poikkeama kirjataan etumerkkeineen delta-arvoon { $mp-delta-length }, ja se on käytettävissä myös parametrissa Q115. Jos delta-arvo ylittää pituudelle sallitun kulumis- tai rikkotoleranssin, ohjaus estää työkalun käytön (tila L työkalutaulukossa TOOL.T).
choice-tool-first-measurement = Työkalun mittaus ensimmäistä kertaa
choice-tool-check = Aiemmin mitatun työkalun tarkastus
parameter-tool-status-parameter = Parametri no. tulokselle?
    .prompt = Parametri no. tulokselle?
    .help = Sen parametrin numero, johon ohjaus tallentaa mittauksen tilan: 0,0: työkalu toleranssin sisäpuolella; 1,0: työkalu kulunut ({ $mp-wear-tolerance-length } ylitetty); 2,0: työkalu rikkoutunut ({ $mp-break-tolerance-length } ylitetty). Jos tulosta ei käytetä ohjelmassa, vastaa kysymykseen näppäimellä NO ENT.
parameter-tool-clearance-height = Varmuuskorkeus
    .label = VARMUUSKORKEUS
    .word = KORKEUS:
    .prompt = Varmuuskorkeus
    .help = Karan akselin asema, jossa työkalu ei voi törmätä työkappaleisiin eikä kiinnittimiin. Se perustuu voimassa olevaan työkappaleen peruspisteeseen. Jos arvo on niin pieni, että työkalun kärki jäisi kosketuspään yläreunan alapuolelle, ohjaus paikoittaa työkalun automaattisesti kosketuspään yläpuolelle (varmuusalue { $mp-setter-safety-distance }).
parameter-tooth-measurement = Terän mittaus 0=Ei / 1=Kyllä
    .label = TERÄN MITTAUS
    .word = TERÄN MITTAUS:
    .prompt = Terän mittaus 0=Ei / 1=Kyllä
    .help = Määrää, mitataanko terät yksitellen. Mitattavissa on enintään 20 terää.
parameter-tooth-measurement__itnc530 =
    .help = Määrää, mitataanko terät yksitellen. Mitattavissa on enintään 99 terää.
parameter-tooth-measurement__tnc426-430 =
    .help = Määrää, mitataanko terät yksitellen.
choice-no-tooth-measurement = Teriä ei mitata yksitellen
choice-tooth-measurement = Terät mitataan yksitellen

# --- 31 ja 481 ---
cycle-tool-length = Työkalun pituuden mittaus
    .nc = TYÖKALUN PITUUS
    .purpose = Työkierto mittaa tai tarkastaa työkalun pituuden pöytäkosketusjärjestelmällä. Ohjaus tallentaa tuloksen työkalutaulukkoon TOOL.T ja ottaa sen automaattisesti huomioon työkierron lopussa.
cycle-tool-length__tnc426-430 =
    .purpose = Työkierto mittaa tai tarkastaa työkalun pituuden pöytäkosketusjärjestelmällä. Ohjaus tallentaa tuloksen työkalutaulukkoon TOOL.T ja käyttää sitä seuraavasta työkalukutsusta lähtien.
cycle-tool-length-old = Työkalun pituuden mittaus
    .nc = TYÖKALUN PITUUS
    .purpose = Työkierto mittaa tai tarkastaa työkalun pituuden pöytäkosketusjärjestelmällä. Ohjaus tallentaa tuloksen työkalutaulukkoon TOOL.T ja ottaa sen automaattisesti huomioon työkierron lopussa. Tämä on työkierron 481 vanha lausemuoto.
cycle-tool-length-old__tnc426-430 =
    .purpose = Työkierto mittaa tai tarkastaa työkalun pituuden pöytäkosketusjärjestelmällä. Ohjaus tallentaa tuloksen työkalutaulukkoon TOOL.T ja käyttää sitä seuraavasta työkalukutsusta lähtien. Tämä on työkierron 481 vanha lausemuoto.
step-position-tool-over-setter = Ohjaus paikoittaa työkalun varmuuskorkeudelle { $q-tool-clearance-height }, ei kuitenkaan kosketuspään yläpuolella olevaa varmuusaluetta alemmas.
step-touch-tool-setter = Ohjaus mittaa pituuden:
say-measure-tooth-by-tooth = yksittäisterän mittauksella, jos { $q-tooth-measurement } = 1: työkalu paikoitetaan kosketuspään sivulle niin, että sen otsapinta on kosketuspään yläreunan alapuolella arvon { $mp-setter-axis-offset } verran, ja jos työkalutaulukossa on pituuden lisäsiirtymä { $mp-setter-offset-length }, vielä sen verran. Ohjaus koskettaa pyörivää työkalua säteen suunnassa ja etsii näin aloituskulman, minkä jälkeen se mittaa jokaisen terän pituuden muuttamalla karan suuntausta
say-measure-rotating-or-stationary = pyörivällä työkalulla, jos sen halkaisija on suurempi kuin mittauspinta: työkalua siirretään kosketusjärjestelmän keskipisteestä työkalutaulukon arvon { $mp-setter-offset-radius } verran ja ajetaan pyörivänä mittauspintaan, jolloin löytyy pisin terä. Muussa tapauksessa, samoin aina porilla ja sädejyrsimillä, mitataan paikallaan olevalla työkalulla: se siirtyy mittauspinnan keskikohdan yläpuolelle ja ajaa sitten karan ollessa pysähdyksissä mittauspintaan; tätä varten { $mp-setter-offset-radius } on työkalutaulukossa 0
step-store-tool-length = Ohjaus tallentaa tuloksen:
say-overwrite-tool-length = jos { $q-tool-check } = 0, se korvaa työkalun pituuden { $mp-tool-length } työkalutaulukossa TOOL.T ja asettaa sarakkeen { $mp-delta-length } arvoksi 0
say-enter-delta-length = jos { $q-tool-check } = 1, se vertaa mitattua pituutta työkalun pituuteen { $mp-tool-length }, kirjaa poikkeaman etumerkkeineen delta-arvoon { $mp-delta-length } ja parametriin Q115 ja asettaa työkalulle eston (tila L), jos kulumis- tai rikkotoleranssi on ylitetty
result-tool-length-deviation = Työkalun pituuden poikkeama
result-tool-status = Mittauksen tila: 0,0 = toleranssin sisäpuolella, 1,0 = kulunut, 2,0 = rikkoutunut
guard-tool-call-missing = Työkalua ei ole kutsuttu. Kutsu mitattava työkalu käskyllä TOOL CALL.
note-enter-tool-data-first = Ennen kuin mittaat työkalun ensimmäistä kertaa, syötä työkalutaulukkoon TOOL.T sen likimääräinen säde ja pituus, terien lukumäärä ja terän suunta.
note-most-teeth-measurable = Terät voidaan mitata yksitellen työkaluista, joissa on enintään 20 terää.
note-most-teeth-measurable__itnc530 = Terät voidaan mitata yksitellen työkaluista, joissa on enintään 99 terää. Tilanäyttö esittää enintään 24 terän arvot.
note-tool-table-must-be-active = Mittaustyökierrot toimivat vain, jos työkalutaulukko TOOL.T on aktiivinen.
note-tool-call-before-tool-measurement = Ennen kuin käytät mittaustyökiertoja, syötä kaikki mittauksessa tarvittavat tiedot työkalutaulukkoon TOOL.T ja kutsu mitattava työkalu käskyllä TOOL CALL.
note-three-ways-to-measure-length = Pituus voidaan mitata kolmella tavalla: pyörivällä työkalulla, jos sen halkaisija on suurempi kuin kosketusjärjestelmän mittauspinta; paikallaan olevalla työkalulla, jos sen halkaisija on pienempi tai kyse on porasta tai sädejyrsimestä; yksittäisterän mittauksella paikallaan olevalla työkalulla, jos sen halkaisija on suurempi kuin mittauspinta.
note-tool-measurement-feed-and-speed = Kun työkalu on paikallaan, ohjaus käyttää parametrin { $mp-stationary-probing-feed } kosketussyöttöarvoa. Kun työkalu pyörii, ohjaus laskee karan kierrosluvun n = { $mp-max-peripheral-speed } / (r · 0,0063) yksikössä r/min suurimmasta sallitusta kehänopeudesta (m/min) ja aktiivisesta työkalun säteestä r (mm) sekä kosketussyöttöarvon v = mittaustoleranssi · n yksikössä mm/min.
note-tool-measurement-tolerance = { $mp-probing-feed-calculation } määrää mittaustoleranssin. ConstantTolerance: toleranssi säilyy vakiona, joten erittäin suurilla työkaluilla syöttöarvo pienenee nollaan, sitä aiemmin, mitä pienemmät { $mp-max-peripheral-speed } ja { $mp-measuring-tolerance } ovat. VariableTolerance: toleranssi on { $mp-measuring-tolerance } työkalun säteeseen 30{"\u00A0"}mm asti, kaksinkertainen säteeseen 60{"\u00A0"}mm, kolminkertainen säteeseen 90{"\u00A0"}mm ja nelinkertainen säteeseen 120{"\u00A0"}mm asti. ConstantFeed: syöttöarvo säilyy vakiona ja mittausvirhe kasvaa säteen mukana: (r · { $mp-measuring-tolerance }) / 5{"\u00A0"}mm.
note-tool-measurement-tolerance__itnc530 = { $mp-probing-feed-calculation } määrää mittaustoleranssin. 0: toleranssi säilyy vakiona, joten erittäin suurilla työkaluilla syöttöarvo pienenee nollaan, sitä aiemmin, mitä pienemmät { $mp-max-peripheral-speed } ja { $mp-measuring-tolerance } ovat. 1: toleranssi on { $mp-measuring-tolerance } työkalun säteeseen 30{"\u00A0"}mm asti, kaksinkertainen säteeseen 60{"\u00A0"}mm, kolminkertainen säteeseen 90{"\u00A0"}mm ja nelinkertainen säteeseen 120{"\u00A0"}mm asti. 2: syöttöarvo säilyy vakiona ja mittausvirhe kasvaa säteen mukana: (r · { $mp-measuring-tolerance }) / 5{"\u00A0"}mm.
note-tool-measurement-tolerance__tnc426-430 = { $mp-probing-feed-calculation } määrää mittaustoleranssin. 0: toleranssi säilyy vakiona, joten erittäin suurilla työkaluilla syöttöarvo pienenee nollaan, sitä aiemmin, mitä pienemmät { $mp-max-peripheral-speed } ja { $mp-measuring-tolerance } ovat. 1: toleranssi on { $mp-measuring-tolerance } työkalun säteeseen 30{"\u00A0"}mm asti, kaksinkertainen säteeseen 60{"\u00A0"}mm, kolminkertainen säteeseen 90{"\u00A0"}mm ja nelinkertainen säteeseen 120{"\u00A0"}mm asti. 2: syöttöarvo säilyy vakiona ja mittausvirhe kasvaa säteen mukana: (r · { $mp-measuring-tolerance }) / 5{"\u00A0"}mm.
note-check-tool-measurement-parameters = Tarkasta ennen kosketustyökiertojen käyttöä kaikki koneparametrit kohdissa { $mp-probe-settings } > { $mp-tool-measurement-config } ja { $mp-round-stylus-config }.
note-tool-table-entries = Työkalutaulukon tiedot: { $mp-teeth }: terien lukumäärä, enintään 20. { $mp-wear-tolerance-length } ja { $mp-wear-tolerance-radius }: pituuden ja säteen sallittu ero kulumisen tunnistusta varten, { $mp-break-tolerance-length } ja { $mp-break-tolerance-radius } rikkotunnistusta varten, kukin 0–0,9999{"\u00A0"}mm; jos arvo ylittyy, ohjaus estää työkalun käytön (tila L). { $mp-cutting-direction }: terän suunta mitattaessa pyörivällä työkalulla. { $mp-setter-offset-radius }: kosketuspään keskipisteen ja työkalun keskipisteen välinen siirtymä pituutta mitattaessa; perusasetus: ei arvoa (siirtymä = työkalun säde). { $mp-setter-offset-length }: kosketuspään yläreunan ja työkalun alareunan välinen siirtymä sädettä mitattaessa, arvon { $mp-setter-axis-offset } lisäksi; perusasetus: 0.
note-tool-table-entries__itnc530 = Työkalutaulukon tiedot: { $mp-teeth }: terien lukumäärä. { $mp-wear-tolerance-length } ja { $mp-wear-tolerance-radius }: pituuden ja säteen sallittu ero kulumisen tunnistusta varten, { $mp-break-tolerance-length } ja { $mp-break-tolerance-radius } rikkotunnistusta varten, kukin 0–0,9999{"\u00A0"}mm; jos arvo ylittyy, ohjaus estää työkalun käytön (tila L). { $mp-cutting-direction }: terän suunta mitattaessa pyörivällä työkalulla. { $mp-setter-offset-radius }: kosketuspään keskipisteen ja työkalun keskipisteen välinen siirtymä pituutta mitattaessa; perusasetus: työkalun säde R (syötetään näppäimellä NO ENT). { $mp-setter-offset-length }: kosketuspään yläreunan ja työkalun alareunan välinen siirtymä sädettä mitattaessa, arvon { $mp-setter-axis-offset } lisäksi; perusasetus: 0.
note-usual-tool-table-entries = Tavalliset arvot työkalutaulukossa. Pora: { $mp-teeth } ei käytössä, { $mp-setter-offset-radius } = 0 (mitataan poran kärki), { $mp-setter-offset-length } tyhjä. Lieriöjyrsin, halkaisija alle 19{"\u00A0"}mm: { $mp-teeth } = 4 (terää), { $mp-setter-offset-radius } = 0 (työkalu on kosketuspäätä kapeampi), { $mp-setter-offset-length } = 0. Lieriöjyrsin, halkaisija yli 19{"\u00A0"}mm: { $mp-teeth } = 4, { $mp-setter-offset-radius } = R (siirtymä tarvitaan, koska työkalu on kosketuspäätä leveämpi), { $mp-setter-offset-length } = 0. Kumpikaan lieriöjyrsin ei tarvitse lisäsiirtymää säteen mittauksessa, koska käytetään arvon { $mp-setter-axis-offset } siirtymää. Sädejyrsin: { $mp-teeth } = 4, { $mp-setter-offset-radius } = 0 (mitataan pallomaisen kärjen alin piste), { $mp-setter-offset-length } = 5 (aina työkalun säde, jotta halkaisijaa ei mitata pyöristyksestä).
note-old-and-new-form = Työkierrot 31–33 ja 481–483 toimivat samalla tavalla. Eroja on vain kaksi: 481–483 ovat käytettävissä myös DIN/ISO-muodossa (G481–G483), ja ne käyttävät mittauksen tilalle vapaasti valittavan parametrin sijasta kiinteää parametria Q199.
note-status-parameter-optional = Ilman tulosparametria mittauksen tilaa ei tallenneta.
note-tool-measurement-in-tilted-plane = Työkaluja voidaan mitata myös koneistustason ollessa käännettynä.
note-tool-status-display = Lisätilanäyttö voi esittää tulokset (koneen käyttötavoilla): ohjelma vasemmalla, tulokset oikealla. Kulumistoleranssin ylittävien arvojen merkkinä on *, rikkotoleranssin ylittävien B.
note-tool-status-display__tnc426-430 = Ohjelmanäppäin, joka näyttää työkalun mittauksen tilan, tuo tulokset lisätilanäyttöön (koneen käyttötavoilla): ohjelma vasemmalla, tulokset oikealla. Kulumistoleranssin ylittävien arvojen merkkinä on *, rikkotoleranssin ylittävien B.
note-from-software-280476 = Käytettävissä NC-ohjelmistosta 280 476-xx lähtien.
note-not-in-iso = Vanhaa lausemuotoa ei voi käyttää DIN/ISO-ohjelmissa.
note-prepare-for-tool-probe = Koneen valmistajan on valmisteltava kone ja ohjaus pöytäkosketusjärjestelmää varten. Kaikkia työkiertoja ja toimintoja ei ehkä ole käytettävissä. Katso koneen käyttöohjekirjaa.
title-first-measurement-rotating-old = Ensimmäinen mittaus pyörivällä työkalulla; vanha muoto
title-first-measurement-rotating-status = Ensimmäinen mittaus pyörivällä työkalulla, tila parametriin Q1
title-check-teeth-status-old = Tarkastus mittaamalla terät yksitellen, tila parametriin Q5; vanha muoto
title-check-teeth-without-status = Tarkastus mittaamalla terät yksitellen, tilaa ei tallenneta
