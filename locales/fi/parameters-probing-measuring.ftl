# Parametrit työkierroissa, jotka mittaavat kulmia, kauloja, suorakulmioita, leveyksiä, koordinaatteja, reikäympyröitä ja tasoja.

# --- 422 ---
parameter-probing-centre-main__measure-stud =
    .help = Kaulan keskipiste koneistustason pääakselilla.
parameter-probing-centre-minor__measure-stud =
    .help = Kaulan keskipiste koneistustason sivuakselilla.
parameter-probing-nominal-diameter__measure-stud =
    .help = Kaulan halkaisija.
parameter-number-of-touch-points__measure-stud =
    .help = Mitataanko kaula neljällä vai kolmella kosketuksella.
parameter-stud-greatest-diameter = Kaulan suurin mitta
    .label = SUURIN MITTA
    .help = Kaulan suurin sallittu halkaisija.
parameter-stud-least-diameter = Kaulan pienin mitta
    .label = PIENIN MITTA
    .help = Kaulan pienin sallittu halkaisija.

# --- 423, 424 ---
parameter-probing-centre-main__measure-rectangular-pocket =
    .help = Taskun keskipiste koneistustason pääakselilla.
parameter-probing-centre-minor__measure-rectangular-pocket =
    .help = Taskun keskipiste koneistustason sivuakselilla.
parameter-probing-centre-main__measure-rectangular-stud =
    .help = Kaulan keskipiste koneistustason pääakselilla.
parameter-probing-centre-minor__measure-rectangular-stud =
    .help = Kaulan keskipiste koneistustason sivuakselilla.
parameter-probing-first-side-length = 1. sivun pituus
    .label = 1. SIVUN PITUUS
    .help = Taskun pituus koneistustason pääakselin suunnassa.
parameter-probing-first-side-length__measure-rectangular-stud =
    .help = Kaulan pituus koneistustason pääakselin suunnassa.
parameter-probing-second-side-length = 2. sivun pituus
    .label = 2. SIVUN PITUUS
    .help = Taskun pituus koneistustason sivuakselin suunnassa.
parameter-probing-second-side-length__measure-rectangular-stud =
    .help = Kaulan pituus koneistustason sivuakselin suunnassa.
parameter-first-side-greatest-length = 1. sivun pituuden suurin mitta
    .label = 1. SIVUN SUURIN MITTA
    .help = Taskun suurin sallittu pituus.
parameter-first-side-greatest-length__measure-rectangular-stud =
    .help = Kaulan suurin sallittu pituus.
parameter-first-side-least-length = 1. sivun pituuden pienin mitta
    .label = 1. SIVUN PIENIN MITTA
    .help = Taskun pienin sallittu pituus.
parameter-first-side-least-length__measure-rectangular-stud =
    .help = Kaulan pienin sallittu pituus.
parameter-second-side-greatest-length = 2. sivun pituuden suurin mitta
    .label = 2. SIVUN SUURIN MITTA
    .help = Taskun suurin sallittu leveys.
parameter-second-side-greatest-length__measure-rectangular-stud =
    .help = Kaulan suurin sallittu leveys.
parameter-second-side-least-length = 2. sivun pituuden pienin mitta
    .label = 2. SIVUN PIENIN MITTA
    .help = Taskun pienin sallittu leveys.
parameter-second-side-least-length__measure-rectangular-stud =
    .help = Kaulan pienin sallittu leveys.

# --- 425, 426 ---
parameter-probing-start-main = 1. akselin alkupiste
    .label = 1. AKSELIN ALKUPISTE
parameter-probing-start-minor = 2. akselin alkupiste
    .label = 2. AKSELIN ALKUPISTE
parameter-second-measurement-offset = 2. mittauksen siirtymä
    .label = 2. MITTAUKSEN SIIRTO
parameter-nominal-length = Asetuspituus
    .label = ASETUSPITUUS
parameter-greatest-dimension = Suurin mitta
    .label = SUURIN MITTA
parameter-least-dimension = Pienin mitta
    .label = PIENIN MITTA
parameter-probing-clearance__measure-ridge-width =
    .label = VARMUUSETÄISYYS
    .label-aliases = VARMUUSETÄIS.

# --- 427 ---
parameter-probing-clearance__measure-coordinate =
    .label = VARMUUSETÄISYYS
    .label-aliases = VARMUUSETÄIS.
parameter-measuring-axis__measure-coordinate = Mittausakseli (1..3: 1=Pääakseli)

# --- 430 ---
parameter-first-hole-angle = 1. reiän kulma
    .label = 1. REIÄN KULMA
parameter-second-hole-angle = 2. reiän kulma
    .label = 2. REIÄN KULMA
parameter-third-hole-angle = 3. reiän kulma
    .label = 3. REIÄN KULMA

# --- 420, 431 ---
parameter-first-point-minor__measure-angle =
    .label = 2. AKSELIN 1. PISTE
    .label-aliases = 1. AKSELIN 2. PISTE
parameter-second-point-main__measure-angle =
    .label = 1. AKSELIN 2. PISTE
    .label-aliases = 2. AKSELIN 1. PISTE
parameter-probing-clearance__measure-plane =
    .label = VARMUUSETÄISYYS
    .label-aliases = VARMUUSETÄIS.
parameter-first-point-tool = 1. akselin 3. mittauspiste
    .label = 1. AKSELIN 3. PISTE
    .label-aliases = 3. AKSELIN 1. PISTE
parameter-second-point-tool = 2. akselin 3. mittauspiste
    .label = 2. AKSELIN 3. PISTE
parameter-third-point-main__measure-plane =
    .label = 3. AKSELIN 1. PISTE
    .label-aliases = 1. AKSELIN 3. PISTE
parameter-third-point-minor__measure-plane =
    .label = 3. AKSELIN 2. PISTE
    .label-aliases = 2. AKSELIN 3. PISTE
parameter-third-point-tool = 3. akselin 3. mittauspiste
    .label = 3. AKSELIN 3. PISTE

# --- 418 ---
parameter-first-centre-main__datum-four-holes = 1. akselin 1. keskipiste
    .label = 1. AKSELIN 1. KESKIP.
    .label-aliases = 1. AKS. 1. KESKIPISTE
parameter-first-centre-minor__datum-four-holes = 1. akselin 2. keskipiste
parameter-second-centre-main__datum-four-holes = 1. akselin 2. keskipiste
parameter-second-centre-minor__datum-four-holes = 2. akselin 2. keskipiste
parameter-third-centre-main = 1. akselin 3. keskipiste
    .label = 3. AKS. 1. KESKIPISTE
parameter-third-centre-minor = 2. akselin 3. keskipiste
    .label = 3. AKS. 2. KESKIPISTE
parameter-fourth-centre-main = 1. akselin 4. keskipiste
    .label = 4. AKS. 1. KESKIPISTE
parameter-fourth-centre-minor = 2. akselin 4. keskipiste
    .label = 4. AKS. 2. KESKIPISTE

# --- 419 ---
parameter-measuring-axis__datum-one-axis = Mittausakseli (1..3: 1=Pääakseli)
parameter-traverse-direction__datum-one-axis = Liikesuunta
parameter-new-datum-one-axis = Uusi peruspiste
    .label = PERUSPISTE

# --- 1, 3 ---
parameter-polar-probing-axis = Kosketusakseli
parameter-polar-probing-angle = Kosketuskulma
    .word = KULMA:
parameter-result-parameter__measuring = Parametri no. tulokselle?
parameter-greatest-measuring-path = Maksimi mittausliike
    .word = ABST
    .label-aliases = ETÄIS
parameter-measuring-feed = Mittaussyöttöarvo
parameter-greatest-retraction-path = Maksimi vetäytymisliike
parameter-probing-reference-system = PERUSJÄRJESTELMÄ (0=HETK/1=REF)
    .word = PERUSJÄRJESTELMÄ:
parameter-probing-error-mode = Virhetapa (0=POIS/1=PÄÄLLÄ)
