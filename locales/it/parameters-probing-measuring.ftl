# Parameters of the cycles that measure angles, studs, rectangles, widths, coordinates, bolt-hole circles and planes; see the English file.

# --- 422 ---
parameter-probing-centre-main__measure-stud =
    .help = Centro dell'isola nell'asse principale del piano di lavoro.
parameter-probing-centre-minor__measure-stud =
    .help = Centro dell'isola nell'asse secondario del piano di lavoro.
parameter-probing-nominal-diameter__measure-stud =
    .help = Diametro dell'isola.
parameter-number-of-touch-points__measure-stud =
    .help = Definire se l'isola viene misurata con quattro o con tre tastature.
parameter-stud-greatest-diameter = Quota massima isola
    .label = QUOTA MASSIMA
    .help = Diametro massimo ammesso dell'isola.
parameter-stud-least-diameter = Quota minima isola
    .label = QUOTA MINIMA
    .help = Diametro minimo ammesso dell'isola.

# --- 423, 424 ---
parameter-probing-centre-main__measure-rectangular-pocket =
    .help = Centro della tasca nell'asse principale del piano di lavoro.
parameter-probing-centre-minor__measure-rectangular-pocket =
    .help = Centro della tasca nell'asse secondario del piano di lavoro.
parameter-probing-centre-main__measure-rectangular-stud =
    .help = Centro dell'isola nell'asse principale del piano di lavoro.
parameter-probing-centre-minor__measure-rectangular-stud =
    .help = Centro dell'isola nell'asse secondario del piano di lavoro.
parameter-probing-first-side-length = Lunghezza 1° lato
    .label = LUNGHEZZA 1° LATO
    .help = Lunghezza della tasca, parallela all'asse principale del piano di lavoro.
parameter-probing-first-side-length__measure-rectangular-stud =
    .help = Lunghezza dell'isola, parallela all'asse principale del piano di lavoro.
parameter-probing-second-side-length = Lunghezza 2° lato
    .label = LUNGHEZZA 2° LATO
    .help = Lunghezza della tasca, parallela all'asse secondario del piano di lavoro.
parameter-probing-second-side-length__measure-rectangular-stud =
    .help = Lunghezza dell'isola, parallela all'asse secondario del piano di lavoro.
parameter-first-side-greatest-length = Quota massima lunghezza 1° lato
    .label = QUOTA MASSIMA 1° LATO
    .help = Lunghezza massima ammessa della tasca.
parameter-first-side-greatest-length__measure-rectangular-stud =
    .help = Lunghezza massima ammessa dell'isola.
parameter-first-side-least-length = Quota minima lunghezza 1° lato
    .label = QUOTA MINIMA 1° LATO
    .help = Lunghezza minima ammessa della tasca.
parameter-first-side-least-length__measure-rectangular-stud =
    .help = Lunghezza minima ammessa dell'isola.
parameter-second-side-greatest-length = Quota massima lunghezza 2° lato
    .label = QUOTA MASSIMA 2° LATO
    .help = Larghezza massima ammessa della tasca.
parameter-second-side-greatest-length__measure-rectangular-stud =
    .help = Larghezza massima ammessa dell'isola.
parameter-second-side-least-length = Quota minima lunghezza 2° lato
    .label = QUOTA MINIMA 2° LATO
    .help = Larghezza minima ammessa della tasca.
parameter-second-side-least-length__measure-rectangular-stud =
    .help = Larghezza minima ammessa dell'isola.
