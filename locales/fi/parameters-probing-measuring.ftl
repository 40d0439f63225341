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
