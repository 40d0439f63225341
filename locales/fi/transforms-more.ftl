# Peilaus, mittakerroin ja kääntö.

# --- 8 ---
cycle-mirroring = Peilaus
    .nc = PEILAUS
    .purpose = Työkierto peilaa koordinaatiston, jolloin koneistustasossa koneistetaan muodon peilikuva.
step-mirror-coordinate-system = Määrittelystä lähtien ohjaus peilaa koordinaatiston annetut akselit voimassa olevan nollapisteen suhteen.
note-reset-mirroring = Peruuta peilaus ohjelmoimalla työkierto uudelleen ja vastaamalla näppäimellä NO ENT.
note-mirroring-in-status-display = Lisätilanäyttö esittää aktiiviset peilausakselit.
note-mirroring-and-machining-direction = Jos vain yksi akseli peilataan, työkalun koneistussuunta vaihtuu; tämä ei koske SL-työkiertoja. Jos kaksi akselia peilataan, koneistussuunta säilyy.
note-mirroring-depends-on-datum = Peilauksen tulos riippuu nollapisteen sijainnista. Jos nollapiste on peilattavalla muodolla, elementti peilataan suoraan nollapisteen suhteen. Jos se on muodon ulkopuolella, elementti myös siirtyy.
note-mirroring-and-milling-cycles = Jos vain yksi akseli peilataan, koneistussuunta vaihtuu jyrsinnän työkierroissa, joiden numerot ovat 2xx. Poikkeus: työkierto 208, jossa työkierrossa määritelty kiertosuunta säilyy.
note-mirroring-and-thread-direction = Kierteen kätisyys vaihtuu, jos kierteen jyrsinnän työkiertoon yhdistetään vain yhden akselin peilaus.

# --- 11 ---
cycle-scaling = Mittakerroin
    .nc = MITTAKERROIN
    .purpose = Työkierto suurentaa tai pienentää muotoja ohjelman sisällä, esimerkiksi kutistumiskertoimien ja työvarojen huomioon ottamiseksi.
step-scale-coordinate-system = Määrittelystä lähtien ohjaus kertoo koordinaatit ja säteet kertoimella.
note-reset-scaling = Peruuta mittakerroin ohjelmoimalla työkierto uudelleen kertoimella 1.
note-scaling-in-status-display = Lisätilanäyttö esittää voimassa olevan mittakertoimen.
note-scaling-acts-on = Kerroin vaikuttaa samanaikaisesti kaikkiin kolmeen koordinaattiakseliin ja työkierroissa annettuihin mittoihin.
note-shift-datum-before-scaling = Ennen suurennusta tai pienennystä nollapiste kannattaa siirtää muodon reunaan tai nurkkaan.
note-scaling-limits = Suurennus: kerroin yli 1 ja enintään 99,999999. Pienennys: kerroin alle 1 ja vähintään 0,000001.

# --- 26 ---
cycle-axis-scaling = Akselikohtainen mittakerroin
    .nc = AKSELIKOHT. MITTAKERROIN
    .purpose = Työkierto ottaa kutistumiskertoimet ja työvarat huomioon kullakin akselilla omalla kertoimella.
step-scale-each-axis = Määrittelystä lähtien ohjaus venyttää tai kutistaa muotoa jokaisella annetulla akselilla sen kertoimen mukaan, keskipisteestä ulospäin tai sitä kohti.
note-reset-axis-scaling = Peruuta kertoimet ohjelmoimalla työkierto uudelleen kyseisen akselin kertoimella 1.
note-arcs-need-equal-factors = Kahta akselia, joilla on ohjelmoitu ympyränkaaria, ei saa venyttää tai kutistaa eri kertoimilla.
note-factor-for-each-axis = Jokaiselle koordinaattiakselille voidaan antaa oma akselikohtainen mittakerroin.
note-centre-for-all-factors = Lisäksi voidaan ohjelmoida kaikille mittakertoimille yhteisen keskipisteen koordinaatit.
note-scaled-from-centre = Muotoa venytetään keskipisteestä ulospäin tai kutistetaan sitä kohti, ei välttämättä voimassa olevan nollapisteen suhteen kuten työkierrossa 11.

# --- 19 ---
cycle-working-plane = Koneistustaso
    .nc = KONEISTUSTASO
    .purpose = Työkierto määrittelee koneistustason asennon eli työkaluakselin asennon koneen koordinaatiston suhteen kääntökulmien avulla koneissa, joissa on kääntöpää tai kääntöpöytä.
step-tilt-working-plane = Määrittelystä lähtien ohjaus kääntää koneistustasoa voimassa olevan nollapisteen ympäri.
step-compute-rotary-positions = Jos asento on ohjelmoitu tilakulmilla, ohjaus laskee siihen tarvittavat kiertoakselien kulma-asemat ja tallentaa ne parametreihin Q120 (A-akseli) – Q122 (C-akseli). Jos ratkaisuja on kaksi, se valitsee lyhimmän matkan kiertoakselien nolla-asemasta.
step-position-rotary-axes = Jos koneen valmistaja on näin määrännyt, ohjaus paikoittaa kiertoakselit itse. Muussa tapauksessa paikoita ne erillisellä L-lauseella määrittelyn jälkeen.
step-move-all-axes-after-tilting = Aja kaikkia akseleita, jotta korjaus vaikuttaa niillä kaikilla: se vaikuttaa akselilla heti, kun akseli liikkuu käännetyssä järjestelmässä.
result-tilted-position-of-a = A-akselin laskettu asema
result-tilted-position-of-b = B-akselin laskettu asema
result-tilted-position-of-c = C-akselin laskettu asema
note-tilting-is-adapted-by-builder = Koneen valmistaja sovittaa koneistustason käännön toiminnot ohjaukseen ja koneeseen. Joissakin kääntöpäissä (kääntöpöydissä) valmistaja määrää, tulkitaanko työkierrossa ohjelmoidut kulmat kiertoakselien koordinaateiksi vai vinon tason kulmakomponenteiksi. Katso koneen käyttöohjekirjaa.
note-builder-decides-on-rotary-positioning = Koneen valmistaja määrää, paikoittaako työkierto kiertoakselit itse vai onko ne paikoitettava ohjelmassa. Katso koneen käyttöohjekirjaa.
note-two-ways-to-tilt = Koneistustason asento voidaan määritellä kahdella tavalla: antamalla kiertoakselien asemat suoraan tai enintään kolmella koneen koordinaatiston kierrolla (tilakulmilla). Tilakulmat löytyvät, kun ajatellaan kohtisuora leikkaus käännetyn koneistustason läpi ja katsotaan sitä kiertoakselin suunnasta. Jo kahdella tilakulmalla voidaan määritellä työkalun mikä tahansa asento avaruudessa.
note-tilted-movements-depend-on-description = Käännetyn koordinaatiston asento ja sen myötä liikkeet käännetyssä järjestelmässä riippuvat siitä, miten käännetty taso on kuvattu.
note-tilting-sequence = Kiertojen järjestys, josta ohjaus laskee tason, on kiinteä: ensin A-akseli, sitten B-akseli ja viimeksi C-akseli.
note-tilting-overrides-manual-menu = Jos ohjelmanajon kääntö on aktivoitu käsikäyttötavalla, työkierto korvaa valikossa annetun kulman.
note-define-all-spatial-angles = Kiertoakselien ohjelmoimattomat arvot tulkitaan aina muuttumattomiksi. Määrittele siksi aina kaikki kolme tilakulmaa, vaikka jokin niistä olisi 0.
note-tilting-cancels-look-ahead = Jos työkiertoa käytetään koodin M120 ollessa voimassa, ohjaus kumoaa sädekorjauksen ja sen mukana koodin M120.
note-reset-tilt-angles = Peruuta kääntökulmat määrittelemällä työkierto uudelleen kaikkien kiertoakselien arvolla 0°. Määrittele se sitten vielä kerran ja vastaa dialogikysymykseen näppäimellä NO ENT: toiminto kytkeytyy pois.
note-position-rotary-axes-by-hand = Kun työkierto ei paikoita kiertoakseleita itse: anna akselikulmia käytettäessä akselien arvot suoraan L-lauseessa; käytä tilakulmia käytettäessä työkierron kirjoittamia parametreja Q120 (A-akseli), Q121 (B-akseli) ja Q122 (C-akseli).
note-use-computed-rotary-positions = Käytä ohjelmassa paikoitettaessa aina parametreihin Q120–Q122 tallennettuja kiertoakselien asemia.
note-avoid-reduced-angles = Vältä sellaisia toimintoja kuin M94 (kulmien supistettu näyttö), jotta kiertoakselien olo- ja asetusasemat eivät useiden kutsujen jälkeen poikkea toisistaan.
note-automatic-rotary-positioning = Kun työkierto paikoittaa kiertoakselit itse: vain ohjattuja akseleita voidaan paikoittaa; työkierron määrittelyssä on kääntökulmien lisäksi annettava varmuusetäisyys ja paikoituksen syöttöarvo; vain esiasetettuja työkaluja saa käyttää (työkalun koko pituuden on oltava määritelty); työkalun kärjen asema työkappaleeseen nähden säilyy käännössä lähes samana; ohjaus kääntää viimeksi ohjelmoidulla syöttöarvolla, ja suurin saavutettava syöttöarvo riippuu kääntöpään (kääntöpöydän) rakenteesta.
note-positions-in-tilted-system = Kun työkierto on aktivoitu, näytetyt asemat (asetus- ja oloasema) ja lisätilanäytön nollapiste perustuvat käännettyyn koordinaatistoon. Heti määrittelyn jälkeen näytetty asema voi siksi poiketa viimeksi ennen työkiertoa ohjelmoiduista koordinaateista.
note-limit-switches-in-tilted-system = Käännetyssä koordinaatistossa ohjaus tarkastaa vain liikkuvien akselien rajakytkimet. Se voi antaa virheilmoituksen.
note-positioning-in-tilted-system = Koodilla M130 voidaan käännetyssäkin järjestelmässä ajaa asemiin, jotka perustuvat kääntämättömään koordinaatistoon. Myös koneen koordinaatistoon perustuvat suoraviivaiset paikoituslauseet (koodilla M91 tai M92) ovat käännetyssä koneistustasossa mahdollisia rajoituksin: pituuskorjausta ja koneen geometrian korjausta ei tehdä, eikä sädekorjaus ole sallittu.
note-tilting-with-other-transforms = Ennen työkiertoa tehty nollapisteen siirto siirtää koneen koordinaatistoa; sen jälkeen tehty siirto siirtää käännettyä koordinaatistoa.
note-reset-in-reverse-order = Tärkeää: peruuta työkierrot käänteisessä järjestyksessä määrittelyyn nähden. Aktivoi nollapisteen siirto, sitten kääntö ja sitten kierto; koneista työkappale; peruuta sitten kierto, kääntö ja nollapisteen siirto.
note-datum-setting-with-tilting = Peruspiste voidaan asettaa käsin hipaisemalla, ohjatusti HEIDENHAIN-3D-kosketusjärjestelmällä tai automaattisesti HEIDENHAIN-3D-kosketusjärjestelmällä.
title-rotary-axes-by-hand = Kiertoakselit paikoitetaan ohjelmassa
title-rotary-axes-by-control = Ohjaus paikoittaa kiertoakselit
