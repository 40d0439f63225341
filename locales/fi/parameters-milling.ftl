# Taskujen, urien, kaulojen, suorien pistekuvioiden ja rivijyrsinnän parametrit: nimi, teksti NC-lauseessa, ohje.

# --- taskut, urat ja kaulat ---
parameter-circle-diameter = Ympyrän halkaisija
    .label = YMPYRÄN HALKAISIJA
    .help = Valmiin taskun halkaisija.
parameter-slot-length = Uran pituus
    .label = URAN PITUUS
    .help = Uran pidempi sivu koneistustason pääakselin suunnassa.
parameter-milled-slot-width = Uran leveys
    .label = URAN LEVEYS
    .help = Uran leveys koneistustason sivuakselin suunnassa. Jos se on sama kuin työkalun halkaisija, ohjaus vain rouhii (se jyrsii pitkäreiän). Suurin uran leveys rouhinnassa: kaksi kertaa työkalun halkaisija.
parameter-angle-of-rotation__slot =
    .help = Kulma, jonka verran koko uraa kierretään. Kierron keskipiste on työkalun asema työkierron kutsuhetkellä.
parameter-angle-of-rotation__line-pattern =
    .help = Kulma, jonka verran koko kuviota kierretään. Kierron keskipiste on alkupiste. Se koskee myös koneistustyökiertoa, jonka kuvio kutsuu.
parameter-slot-position = Uran sijainti
    .label = URAN SIJAINTI
    .help = Uran sijainti työkalun asemaan nähden työkierron kutsuhetkellä.
parameter-slot-position-reference = Uran sijainnin perusta
    .label = URAN SIJAINNIN PERUSTA
    .help = Uran sijainti työkalun asemaan nähden työkierron kutsuhetkellä.
parameter-slot-starting-angle = Aloituskulma
    .label = ALKUKULMA
    .help = Alkupisteen napakulma.
parameter-slot-opening-angle = Uran avautumiskulma
    .label = AVAUTUMISKULMA
    .help = Kulma, jonka alueelle ura ulottuu.
parameter-pattern-stepping-angle__circular-slot =
    .help = Kulma, jonka verran koko uraa kierretään jokaista seuraavaa koneistusta varten. Kierron keskipiste on jakoympyrän keskipiste.
parameter-stud-first-side-length = 1. sivun pituus
    .label = 1. SIVUN PITUUS
    .help = Kaulan pituus koneistustason pääakselin suunnassa.
parameter-blank-first-side-length = Aihion 1. sivun pituus
    .label = AIHION 1. SIVUN PITUUS
    .help = Kaulan aihion pituus koneistustason pääakselin suunnassa. Anna arvo, joka on suurempi kuin 1. sivun pituus { $q-stud-first-side-length }. Jos ero on suurempi kuin sallittu sivuttaisasetus (työkalun säde kertaa ratalimitys { $q-path-overlap }), ohjaus tekee useita sivuttaisasetuksia. Se laskee aina vakiosuuruisen sivuttaisasetuksen.
parameter-stud-second-side-length = 2. sivun pituus
    .label = 2. SIVUN PITUUS
    .help = Kaulan pituus koneistustason sivuakselin suunnassa.
parameter-blank-second-side-length = Aihion 2. sivun pituus
    .label = AIHION 2. SIVUN PITUUS
    .help = Kaulan aihion pituus koneistustason sivuakselin suunnassa. Anna arvo, joka on suurempi kuin 2. sivun pituus { $q-stud-second-side-length }. Jos ero on suurempi kuin sallittu sivuttaisasetus (työkalun säde kertaa ratalimitys { $q-path-overlap }), ohjaus tekee useita sivuttaisasetuksia. Se laskee aina vakiosuuruisen sivuttaisasetuksen.
parameter-corner-radius__rectangular-stud =
    .help = Kaulan nurkkien säde.
parameter-side-allowance__rectangular-stud =
    .help = Koneistustason silitystyövara, jonka ohjaus jättää koneistamatta.
parameter-stud-position = Kaulan sijainti
    .label = KAULAN SIJAINTI
    .help = Kaulan sijainti työkalun asemaan nähden työkierron kutsuhetkellä.
parameter-stud-approach-position = Lähestymisasema
    .label = LÄHESTYMISASEMA
    .help = Määrää, mistä työkalu lähestyy kaulaa.
parameter-finished-part-diameter = Valmisosan halkaisija
    .label = VALMISOSAN HALKAISIJA
    .help = Valmiin kaulan halkaisija.
parameter-blank-diameter = Aihion halkaisija
    .label = AIHION HALKAISIJA
    .help = Aihion halkaisija. Sen on oltava suurempi kuin valmisosan halkaisija { $q-finished-part-diameter }. Jos ero on suurempi kuin sallittu sivuttaisasetus (työkalun säde kertaa ratalimitys { $q-path-overlap }), ohjaus tekee useita sivuttaisasetuksia. Se laskee aina vakiosuuruisen sivuttaisasetuksen.
parameter-stud-starting-angle = Aloituskulma
    .label = ALKUKULMA
    .help = Kaulan keskipisteestä mitattu napakulma, jossa työkalu lähestyy kaulaa.
parameter-depth__slot =
    .help = Työkappaleen yläpinnan ja uran pohjan välinen etäisyys.
parameter-depth__circular-slot =
    .help = Työkappaleen yläpinnan ja uran pohjan välinen etäisyys.
parameter-depth__circular-pocket =
    .help = Työkappaleen yläpinnan ja taskun pohjan välinen etäisyys.
parameter-depth__rectangular-stud =
    .help = Työkappaleen yläpinnan ja kaulan pohjan välinen etäisyys.
parameter-depth__circular-stud =
    .help = Työkappaleen yläpinnan ja kaulan pohjan välinen etäisyys.
parameter-plunging-depth__circular-pocket =
    .help = Matka, jonka työkalu etenee yhdellä asetusliikkeellä. Anna arvo, joka on suurempi kuin 0.
parameter-plunging-depth__slot =
    .help = Matka, jonka työkalu etenee yhdellä asetusliikkeellä. Anna arvo, joka on suurempi kuin 0.
parameter-plunging-depth__circular-slot =
    .help = Matka, jonka työkalu etenee yhdellä asetusliikkeellä. Anna arvo, joka on suurempi kuin 0.
parameter-plunging-depth__rectangular-stud =
    .help = Matka, jonka työkalu etenee yhdellä asetusliikkeellä. Anna arvo, joka on suurempi kuin 0.
parameter-plunging-depth__circular-stud =
    .help = Matka, jonka työkalu etenee yhdellä asetusliikkeellä. Anna arvo, joka on suurempi kuin 0.
parameter-plunging-feed__circular-pocket =
    .help = Työkalun liikenopeus syvyyteen ajettaessa.
parameter-plunging-feed__slot =
    .help = Työkalun liikenopeus syvyyteen ajettaessa.
parameter-plunging-feed__circular-slot =
    .help = Työkalun liikenopeus syvyyteen ajettaessa.
parameter-plunging-feed__rectangular-stud =
    .help = Työkalun liikenopeus syvyyteen ajettaessa.
parameter-plunging-feed__circular-stud =
    .help = Työkalun liikenopeus syvyyteen ajettaessa.
parameter-plunging-feed__multipass-milling =
    .help = Työkalun liikenopeus syvyyteen ajettaessa.

# --- suorat pistekuviot ---
parameter-pattern-spacing-main = 1. akselin etäisyys
    .label = ETÄISYYS 1. AKSELILLA
    .help = Rivin pisteiden välinen etäisyys.
parameter-pattern-spacing-minor = 2. akselin etäisyys
    .label = ETÄISYYS 2. AKSELILLA
    .help = Rivien välinen etäisyys.
parameter-number-of-columns = Sarakkeiden lukumäärä
    .label = SARAKKEIDEN LUKUMÄÄRÄ
    .help = Koneistusten lukumäärä yhdellä rivillä.
parameter-number-of-lines = Rivien lukumäärä
    .label = RIVIEN LUKUMÄÄRÄ
    .help = Määrää, kuinka monella rivillä työkierto koneistaa.
parameter-starting-point-main__line-pattern =
    .help = Alkupisteen koordinaatti koneistustason pääakselilla.
parameter-starting-point-minor__line-pattern =
    .help = Alkupisteen koordinaatti koneistustason sivuakselilla.
parameter-set-up-clearance__line-pattern =
    .help = Työkalun kärjen ja työkappaleen yläpinnan välinen etäisyys. Se koskee myös koneistustyökiertoa, jonka kuvio kutsuu.
parameter-surface-coordinate__line-pattern =
    .help = Työkappaleen yläpinnan koordinaatti karan akselilla; syvyydet mitataan siitä. Se koskee myös koneistustyökiertoa, jonka kuvio kutsuu.
parameter-second-set-up-clearance__line-pattern =
    .help = Karan akselin korkeus, jolla työkalu ei voi törmätä työkappaleeseen eikä sen kiinnittimiin. Se koskee myös koneistustyökiertoa, jonka kuvio kutsuu.

# --- pintojen rivijyrsintä ---
parameter-starting-point-main = 1. akselin alkupiste
    .label = 1. AKSELIN ALKUPISTE
    .help = Koneistettavan pinnan alkupisteen koordinaatti koneistustason pääakselilla.
parameter-starting-point-minor = 2. akselin alkupiste
    .label = 2. AKSELIN ALKUPISTE
    .help = Koneistettavan pinnan alkupisteen koordinaatti koneistustason sivuakselilla.
parameter-starting-point-tool = 3. akselin alkupiste
    .label = 3. AKSELIN ALKUPISTE
    .help = Karan akselin korkeus, jolla pinta jyrsitään.
parameter-starting-point-tool__ruled-surface =
    .help = Jyrsittävän pinnan alkupisteen koordinaatti karan akselilla.
parameter-starting-point-tool__face-milling =
    .help = Työkappaleen yläpinnan koordinaatti, josta asetusliikkeet lasketaan.
parameter-first-side-length__multipass-milling =
    .help = Jyrsittävän pinnan pituus koneistustason pääakselilla 1. akselin alkupisteestä mitattuna.
parameter-first-side-length__face-milling =
    .help = Koneistettavan pinnan pituus koneistustason pääakselilla. Etumerkki määrää ensimmäisen jyrsintäradan suunnan 1. akselin alkupisteen suhteen.
parameter-second-side-length__multipass-milling =
    .help = Jyrsittävän pinnan pituus koneistustason sivuakselilla 2. akselin alkupisteestä mitattuna.
parameter-second-side-length__face-milling =
    .help = Koneistettavan pinnan pituus koneistustason sivuakselilla. Etumerkki määrää ensimmäisen sivuttaisasetuksen suunnan 2. akselin alkupisteen suhteen.
parameter-number-of-cuts = Lastujen lukumäärä
    .label = LASTUJEN LUKUMÄÄRÄ
    .help = Niiden rivien lukumäärä, joilla ohjaus jyrsii pinnan koko leveydeltä.
parameter-number-of-cuts__ruled-surface =
    .help = Niiden rivien lukumäärä, jotka ohjaus koneistaa pisteiden 1 ja 4 tai pisteiden 2 ja 3 välillä.
parameter-stepover-feed = Sivuttaisasetuksen syöttöarvo
    .label = SIVUTTAISSYÖTTÖARVO
    .help = Työkalun liikenopeus sen siirtyessä seuraavalle riville. Anna materiaalissa tapahtuvaan sivuttaisasetukseen arvo, joka on pienempi kuin { $q-milling-feed }; työkappaleen yläpuolella tapahtuvassa sivuttaisasetuksessa { $q-stepover-feed } saa olla suurempi kuin { $q-milling-feed }.
parameter-set-up-clearance__multipass-milling =
    .help = Työkalun kärjen ja jyrsintäsyvyyden välinen etäisyys, jolla työkierron alussa ja lopussa paikoitetaan.
parameter-set-up-clearance__face-milling =
    .help = Työkalun kärjen ja työkaluakselin aloitusaseman välinen etäisyys. Strategialla { $q-face-milling-strategy } = 2 työkalu siirtyy tällä etäisyydellä hetkellisen asetussyvyyden yläpuolella seuraavan rivin alkupisteeseen.
parameter-surface-second-point-main = 1. akselin 2. piste
    .label = 2. PISTE 1. AKSELILLA
    .help = Jyrsittävän pinnan loppupisteen koordinaatti koneistustason pääakselilla.
parameter-surface-second-point-minor = 2. akselin 2. piste
    .label = 2. PISTE 2. AKSELILLA
    .help = Jyrsittävän pinnan loppupisteen koordinaatti koneistustason sivuakselilla.
parameter-surface-second-point-tool = 3. akselin 2. piste
    .label = 2. PISTE 3. AKSELILLA
    .help = Jyrsittävän pinnan loppupisteen koordinaatti karan akselilla.
parameter-surface-third-point-main = 1. akselin 3. piste
    .label = 3. PISTE 1. AKSELILLA
    .help = Pisteen 3 koordinaatti koneistustason pääakselilla.
parameter-surface-third-point-minor = 2. akselin 3. piste
    .label = 3. PISTE 2. AKSELILLA
    .help = Pisteen 3 koordinaatti koneistustason sivuakselilla.
parameter-surface-third-point-tool = 3. akselin 3. piste
    .label = 3. PISTE 3. AKSELILLA
    .help = Pisteen 3 koordinaatti karan akselilla.
parameter-surface-fourth-point-main = 1. akselin 4. piste
    .label = 4. PISTE 1. AKSELILLA
    .help = Pisteen 4 koordinaatti koneistustason pääakselilla.
parameter-surface-fourth-point-minor = 2. akselin 4. piste
    .label = 4. PISTE 2. AKSELILLA
    .help = Pisteen 4 koordinaatti koneistustason sivuakselilla.
parameter-surface-fourth-point-tool = 3. akselin 4. piste
    .label = 4. PISTE 3. AKSELILLA
    .help = Pisteen 4 koordinaatti karan akselilla.
parameter-milling-feed__ruled-surface =
    .help = Työkalun liikenopeus jyrsinnässä. Ensimmäisen lastun ohjaus ajaa puolella ohjelmoidusta arvosta.
parameter-face-milling-strategy = Koneistusstrategia
    .label = STRATEGIA
    .help = Määrää, miten ohjaus koneistaa pinnan.
parameter-end-point-tool = 3. akselin loppupiste
    .label = 3. AKSELIN LOPPUPISTE
    .help = Karan akselin koordinaatti, johon pinta tasojyrsitään.
parameter-max-plunging-depth = Suurin asetussyvyys
    .label = MAKS. ASETUSSYVYYS
    .help = Suurin matka, jonka työkalu etenee yhdellä asetusliikkeellä. Ohjaus laskee todellisen asetussyvyyden työkaluakselin loppupisteen ja alkupisteen erotuksesta niin, että kaikki asetusliikkeet ovat yhtä suuria; se ottaa huomioon silitystyövaran { $q-floor-allowance }.
parameter-floor-allowance__face-milling =
    .help = Viimeisen asetusliikkeen syvyys.
parameter-max-path-overlap = Suurin ratalimityskerroin
    .label = MAKS. RATALIMITYS
    .help = Kerroin, joka määrää suurimman sivuttaisasetuksen k. Ohjaus laskee todellisen sivuttaisasetuksen 2. sivun pituudesta { $q-second-side-length } ja työkalun säteestä niin, että kaikki sivuttaisasetukset ovat yhtä suuria. Jos työkalutaulukkoon on annettu säde { $mp-tool-radius-2 } (esimerkiksi otsajyrsimen teräpalan säde), ohjaus pienentää sivuttaisasetusta vastaavasti.
parameter-finishing-feed__face-milling =
    .help = Työkalun liikenopeus viimeistä asetusliikettä jyrsittäessä.
parameter-pre-positioning-feed__face-milling =
    .help = Työkalun liikenopeus sen siirtyessä aloitusasemaan ja seuraavalle riville. Jos sivuttaisasetus tapahtuu materiaalissa ({ $q-face-milling-strategy } = 1), ohjaus ajaa sen jyrsinnän syöttöarvolla { $q-milling-feed }.
parameter-side-clearance = Sivuetäisyys
    .label = SIVUETÄISYYS
    .help = Työkalun ja työkappaleen sivun välinen etäisyys, kun työkalu siirtyy ensimmäiseen asetussyvyyteen, ja etäisyys, jolla sivuttaisasetukset tehdään strategioilla { $q-face-milling-strategy } = 0 ja { $q-face-milling-strategy } = 2.

# --- vaihtoehdot ---
choice-vertical-plunging-with-angle-0-or-90 = Kohtisuora sisäänpisto. Aktiivisen työkalun sisäänpistokulman { $mp-plunging-angle } on oltava työkalutaulukossa 0 tai 90, muuten ohjaus antaa virheilmoituksen
choice-reciprocating-plunging-by-angle = Heilurimainen sisäänpisto. Aktiivisen työkalun sisäänpistokulma { $mp-plunging-angle } ei saa työkalutaulukossa olla 0, muuten ohjaus antaa virheilmoituksen
choice-tool-at-slot-centre = Työkalun asema = uran keskipiste
choice-tool-at-left-slot-end = Työkalun asema = uran vasen pää
choice-tool-at-left-slot-arc-centre = Työkalun asema = uran vasemman kaaren keskipiste
choice-tool-at-right-slot-arc-centre = Työkalun asema = uran oikean kaaren keskipiste
choice-tool-at-right-slot-end = Työkalun asema = uran oikea pää
choice-tool-position-not-considered = Työkalun asemaa ei oteta huomioon. Uran sijainti määräytyy jakoympyrän annetusta keskipisteestä ja aloituskulmasta
choice-slot-begins-at-tool = Työkalun asema = uran vasemman kaaren keskipiste. Aloituskulma { $q-slot-starting-angle } perustuu tähän asemaan. Jakoympyrän annettua keskipistettä ei oteta huomioon
choice-slot-middle-at-tool = Työkalun asema = keskiakselin keskipiste. Aloituskulma { $q-slot-starting-angle } perustuu tähän asemaan. Jakoympyrän annettua keskipistettä ei oteta huomioon
choice-slot-ends-at-tool = Työkalun asema = uran oikean kaaren keskipiste. Aloituskulma { $q-slot-starting-angle } perustuu tähän asemaan. Jakoympyrän annettua keskipistettä ei oteta huomioon
choice-tool-at-stud-centre = Työkalun asema = kaulan keskipiste
choice-approach-right-of-stud = Kaulan oikealla puolella (perusasetus)
choice-approach-at-lower-left-corner = Vasen alanurkka
choice-approach-at-lower-right-corner = Oikea alanurkka
choice-approach-at-upper-right-corner = Oikea ylänurkka
choice-approach-at-upper-left-corner = Vasen ylänurkka
choice-meander-stepover-outside = Mutkittelevat radat, sivuttaisasetus koneistettavan pinnan ulkopuolella
choice-meander-stepover-inside = Mutkittelevat radat, sivuttaisasetus koneistettavan pinnan sisäpuolella
choice-line-by-line-with-retraction = Rivi kerrallaan, vetäytyminen ja sivuttaisasetus paikoituksen syöttöarvolla

# --- koordinaattimuunnokset ---
parameter-mirrored-axes = Peilattavat akselit
    .help = Akselit, jotka peilataan. Kaikki akselit voidaan peilata, myös kiertoakselit, lukuun ottamatta karan akselia ja sen suuntaista sivuakselia. Enintään kolme NC-akseleista X, Y, Z, U, V, W, A, B, C.
    .prompt = Peilausakseli?
parameter-scaling-factor = Kerroin
    .help = Mittakerroin SCL. Ohjaus kertoo koordinaatit ja säteet sillä.
    .word = SCL
    .prompt = Kerroin?
parameter-axis-scaling-factors = Akseli ja kerroin
    .help = Koordinaattiakselit ja kertoimet, joilla kutakin niistä venytetään tai kutistetaan.
parameter-axis-scaling-centre = Keskipisteen koordinaatit
    .help = Keskipiste, josta muotoa venytetään tai johon päin sitä kutistetaan.
parameter-tilting-angles = Kiertoakseli ja kulma
    .help = Kiertoakselit ja niiden kääntökulmat; kiertoakselit A, B ja C ohjelmoidaan ohjelmanäppäimillä.
    .prompt = Kiertoakseli ja kulma?
parameter-tilting-feed = Syöttöarvo
    .help = Kiertoakselin liikenopeus, kun ohjaus paikoittaa sen itse.
    .prompt = Syöttöarvo? F=
parameter-tilting-clearance = Varmuusetäisyys
    .help = Ohjaus paikoittaa kääntöpään niin, ettei varmuusetäisyyden verran työkalun jatkeella oleva piste liiku työkappaleeseen nähden. Annetaan, jos ohjaus paikoittaa kiertoakselit itse.
    .prompt = Varmuusetäisyys?

# --- erikoistoiminnot ---
parameter-programmed-dwell = Odotusaika sekunteina
    .help = Aika, jonka ohjelmanajo on pysähdyksissä, enintään 1 tunti 0,001{"\u00A0"}s:n askelin.
    .word = ODOTUSAIKA
parameter-program-to-call = Ohjelman nimi
    .help = Kutsuttavan ohjelman nimi, tarvittaessa polkuineen.
    .word = PGM
parameter-orientation-angle = Suuntauskulma
    .help = Kulma koneistustason kulman perusakselin suhteen.
    .word = KULMA
parameter-contour-tolerance = Toleranssiarvo T
    .help = Sallittu poikkeama ohjelmoidusta muodosta millimetreinä (tuumaohjelmissa tuumina).
parameter-hsc-mode = HSC-tila, silitys=0, rouhinta=1
    .help = Suodatin, jonka ohjaus aktivoi.
parameter-rotary-axis-tolerance = Kiertoakselien toleranssi TA
    .help = Kiertoakselien sallittu poikkeama asteina, kun M128 (FUNCTION TCPM) on voimassa. Ohjaus pienentää syöttöarvoa aina niin, että usean akselin liikkeissä hitain akseli liikkuu suurimmalla syöttöarvollaan. Kiertoakselit ovat yleensä paljon hitaampia kuin lineaariakselit. Suurempi toleranssi (kuten 10°) voi lyhentää moniakseliohjelmien koneistusaikaa huomattavasti, koska ohjauksen ei tarvitse aina ajaa kiertoakseleita annettuun asetusasemaan. Muoto ei vahingoitu; vain kiertoakselin asento työkappaleen pintaan nähden muuttuu.

# --- erikoistoimintojen vaihtoehdot ---
choice-milling-with-higher-accuracy = Jyrsintä suuremmalla muototarkkuudella. Ohjaus käyttää sisäisesti asetettuja silityksen suodatinasetuksia
choice-milling-at-higher-feed = Jyrsintä suuremmalla syöttöarvolla. Ohjaus käyttää sisäisesti asetettuja rouhinnan suodatinasetuksia
