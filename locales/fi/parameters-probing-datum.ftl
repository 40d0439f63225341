# Vinon asennon ja peruspisteen asetuksen työkiertojen parametrit: nimi, teksti NC-lauseessa, ohje.

# --- peruspisteen asetus: erot reikään ---
parameter-probing-centre-main__datum-inside-rectangle =
    .help = Taskun keskipiste koneistustason pääakselilla.
parameter-probing-centre-minor__datum-inside-rectangle =
    .help = Taskun keskipiste koneistustason sivuakselilla.
parameter-probing-centre-main__datum-outside-rectangle =
    .help = Kaulan keskipiste koneistustason pääakselilla.
parameter-probing-centre-minor__datum-outside-rectangle =
    .help = Kaulan keskipiste koneistustason sivuakselilla.
parameter-probing-centre-main__datum-outside-circle =
    .help = Kaulan keskipiste koneistustason pääakselilla.
parameter-probing-centre-minor__datum-outside-circle =
    .help = Kaulan keskipiste koneistustason sivuakselilla.
parameter-probing-nominal-diameter__datum-outside-circle =
    .help = Kaulan likimääräinen halkaisija. Anna mieluummin liian suuri kuin liian pieni arvo.
parameter-number-of-touch-points__datum-outside-circle =
    .help = Mitataanko kaula neljällä vai kolmella kosketuksella.
parameter-first-side-length__datum-outside-rectangle =
    .help = Kaulan pituus koneistustason pääakselin suunnassa.
parameter-second-side-length__datum-outside-rectangle =
    .help = Kaulan pituus koneistustason sivuakselin suunnassa.
parameter-datum-row-number__datum-outside-rectangle =
    .help = Nollapiste- tai esiasetustaulukon rivin numero, jolle kaulan keskipisteen koordinaatit tallennetaan. Arvolla 0 ohjaus asettaa näytön niin, että uusi peruspiste on kaulan keskellä.
parameter-datum-row-number__datum-outside-rectangle__tnc426-430 =
    .help = Nollapistetaulukon rivin numero, jolle kaulan keskipisteen koordinaatit tallennetaan. Arvolla 0 ohjaus asettaa näytön niin, että uusi peruspiste on kaulan keskellä.
parameter-datum-row-number__datum-outside-circle =
    .help = Nollapiste- tai esiasetustaulukon rivin numero, jolle kaulan keskipisteen koordinaatit tallennetaan. Arvolla 0 ohjaus asettaa näytön niin, että uusi peruspiste on kaulan keskellä.
parameter-datum-row-number__datum-outside-circle__tnc426-430 =
    .help = Nollapistetaulukon rivin numero, jolle kaulan keskipisteen koordinaatit tallennetaan. Arvolla 0 ohjaus asettaa näytön niin, että uusi peruspiste on kaulan keskellä.
parameter-new-datum-main__datum-outside-rectangle =
    .help = Pääakselin koordinaatti, johon mitattu kaulan keskipiste asetetaan. Perusasetus: 0.
parameter-new-datum-minor__datum-outside-rectangle =
    .help = Sivuakselin koordinaatti, johon mitattu kaulan keskipiste asetetaan. Perusasetus: 0.
parameter-new-datum-main__datum-outside-circle =
    .help = Pääakselin koordinaatti, johon mitattu kaulan keskipiste asetetaan. Perusasetus: 0.
parameter-new-datum-minor__datum-outside-circle =
    .help = Sivuakselin koordinaatti, johon mitattu kaulan keskipiste asetetaan. Perusasetus: 0.
choice-travel-paraxially-at-measuring-height = Mittauspisteiden välinen ajo akselin suuntaisesti mittauskorkeudella
choice-travel-linearly-at-clearance-height = Mittauspisteiden välinen ajo suoraa pitkin varmuuskorkeudella

# --- 408 ja 409 ---
parameter-slot-width = Uran leveys
    .label = URAN LEVEYS
parameter-ridge-width = Uuman leveys
    .label = ASKELLEVEYS
parameter-datum-row-number__datum-slot-centre = Numero taulukossa
parameter-datum-row-number__datum-ridge-centre = Numero taulukossa
parameter-new-datum-measuring-axis = Uusi peruspiste
    .label = PERUSPISTE
parameter-measuring-axis__datum-slot-centre = Mittausakseli (1=1. akseli/2=2. akseli)
parameter-measuring-axis__datum-ridge-centre = Mittausakseli (1=1. akseli/2=2. akseli)
parameter-probe-axis-point-main__datum-slot-centre = Kosketus kosk.akselilla: 1. akselin 1. koordinaatti
parameter-probe-axis-point-minor__datum-slot-centre = Kosketus kosk.akselilla: 2. akselin 2. koordinaatti

# --- 414 ja 415 ---
parameter-third-point-main = 3. akselin 1. mittauspiste
    .label = 1. AKSELIN 3. PISTE
    .label-aliases = 3. AKSELIN 1. PISTE
parameter-third-point-minor = 3. akselin 2. mittauspiste
    .label = 2. AKSELIN 3. PISTE
    .label-aliases = 3. AKSELIN 2. PISTE
parameter-point-distance-main = 1. akselin etäisyys
    .label = ETÄISYYS 1. AKSELILLA
parameter-point-distance-minor = 2. akselin etäisyys
    .label = ETÄISYYS 2. AKSELILLA
parameter-corner-number = Nurkka
    .label = NURKKA
parameter-corner-basic-rotation = Peruskäännön suorittaminen
    .label = PERUSKÄÄNTÖ
parameter-first-point-minor__datum-outside-corner =
    .label = 2. AKSELIN 1. PISTE
    .label-aliases = 1. AKSELIN 2. PISTE
parameter-first-point-minor__datum-inside-corner =
    .label = 2. AKSELIN 1. PISTE
    .label-aliases = 1. AKSELIN 2. PISTE

# --- kaksi pistettä suoralla ---
parameter-first-point-main = 1. akselin 1. mittauspiste
    .label = 1. AKSELIN 1. PISTE
parameter-first-point-minor = 1. akselin 2. mittauspiste
    .label = 1. AKSELIN 2. PISTE
    .label-aliases = 2. AKSELIN 1. PISTE
parameter-second-point-main = 2. akselin 1. mittauspiste
    .label = 2. AKSELIN 1. PISTE
    .label-aliases = 1. AKSELIN 2. PISTE
parameter-second-point-minor = 2. akselin 2. mittauspiste
    .label = 2. AKSELIN 2. PISTE
parameter-measuring-axis = Mittausakseli
    .label = MITTAUSAKSELI
parameter-measuring-axis__rotation-by-rotary-axis = Mittausakseli
parameter-traverse-direction = Liikesuunta 1
    .label = LIIKESUUNTA
parameter-probing-clearance__basic-rotation =
    .label = VARMUUSETÄISYYS
    .label-aliases = VARMUUSETÄIS.
parameter-probing-clearance__rotation-two-studs =
    .label = VARMUUSETÄISYYS
    .label-aliases = VARMUUSETÄIS.
parameter-probing-clearance__rotation-by-rotary-axis =
    .label = VARMUUSETÄISYYS
    .label-aliases = VARMUUSETÄIS.
parameter-traverse-to-clearance-height__basic-rotation =
    .label = AJO VARMUUSKORKEUTEEN
    .label-aliases = AJO VARM.KORKEUTEEN
parameter-traverse-to-clearance-height__rotation-two-studs =
    .label = AJO VARMUUSKORKEUTEEN
    .label-aliases = AJO VARM.KORKEUTEEN
parameter-traverse-to-clearance-height__rotation-by-rotary-axis =
    .label = AJO VARMUUSKORKEUTEEN
    .label-aliases = AJO VARM.KORKEUTEEN

# --- kaksi reikää tai kaulaa ---
parameter-first-centre-main = 1. reikä: 1. akselin keskipiste
    .label = 1. AKS. 1. KESKIPISTE
    .label-aliases = 1. AKSELIN 1. KESKIP.
parameter-first-centre-minor = 1. reikä: 2. akselin keskipiste
    .label = 1. AKS. 2. KESKIPISTE
    .label-aliases = 1. AKSELIN 2. KESKIP.
parameter-second-centre-main = 2. reikä: 1. akselin keskipiste
    .label = 2. AKS. 1. KESKIPISTE
    .label-aliases = 2. AKSELIN 1. KESKIP.
parameter-second-centre-minor = 2. reikä: 2. akselin keskipiste
    .label = 2. AKS. 2. KESKIPISTE
    .label-aliases = 2. AKSELIN 2. KESKIP.
parameter-first-centre-main__rotation-two-studs = 1. kaula: 1. akselin keskipiste
parameter-first-centre-minor__rotation-two-studs = 1. kaula: 2. akselin keskipiste
parameter-second-centre-main__rotation-two-studs = 2. kaula: 1. akselin keskipiste
parameter-second-centre-minor__rotation-two-studs = 2. kaula: 2. akselin keskipiste
parameter-first-stud-diameter = Kaulan 1 halkaisija
    .label = KAULAN 1 HALKAISIJA
parameter-second-stud-diameter = Kaulan 2 halkaisija
    .label = KAULAN 2 HALKAISIJA
parameter-measuring-height__rotation-two-studs = Kaulan 1 mittauskorkeus kosketusakselilla
    .label = MITTAUSKORKEUS 1
parameter-second-measuring-height = Kaulan 2 mittauskorkeus kosketusakselilla
    .label = MITTAUSKORKEUS 2

# --- mitä kulmalle tehdään ---
parameter-reference-line-angle = Peruskäännön esiasetus
    .label = PERUSK. ESIASETUS
parameter-basic-rotation-angle = Peruskäännön esiasetus
    .label = PERUSK. ESIASETUS
parameter-basic-rotation-row = Esiasetusnumero taulukossa
    .label = NO. TAULUKOSSA
parameter-misalignment-compensation = Peruskääntö/Suuntaus
    .label = SUUNTAUS
parameter-zero-after-alignment = Asetus nollaan suuntauksen jälkeen
    .label = ASETA NOLLA
parameter-zero-or-row-after-alignment = Asetus nollaan suuntauksen jälkeen
    .label = ASETA NOLLA
parameter-compensation-axis = Kompensointiliikkeen akseli
    .label = KORJAUSAKSELI
parameter-rotary-axis-row = Numero taulukossa
    .label = NO. TAULUKOSSA
parameter-alignment-angle = Peruskulma ?(0=pääakseli)
    .label = PERUSKULMA
