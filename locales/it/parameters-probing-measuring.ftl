# Parameters of the cycles that measure angles, studs, rectangles, widths, coordinates, bolt-hole circles and planes; see the English file.

# --- 422 ---
parameter-stud-greatest-diameter =
    .label = QUOTA MASSIMA
parameter-stud-least-diameter =
    .label = QUOTA MINIMA

# --- 423, 424 ---
parameter-probing-centre-main__measure-rectangular-pocket =
    .help = Centro della tasca nell'asse principale del piano di lavoro.
parameter-probing-centre-minor__measure-rectangular-pocket =
    .help = Centro della tasca nell'asse secondario del piano di lavoro.
parameter-probing-first-side-length =
    .label = LUNGHEZZA 1° LATO
parameter-probing-second-side-length =
    .label = LUNGHEZZA 2° LATO
