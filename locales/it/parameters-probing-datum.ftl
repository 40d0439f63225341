# Parameters of the misalignment and datum cycles; see the English file.

# --- datum cycles: what differs from the hole ---
parameter-probing-centre-main__datum-inside-rectangle =
    .help = Centro della tasca nell'asse principale del piano di lavoro.
parameter-probing-centre-minor__datum-inside-rectangle =
    .help = Centro della tasca nell'asse secondario del piano di lavoro.
parameter-first-side-length__datum-outside-rectangle =
    .help = Lunghezza dell'isola, parallela all'asse principale del piano di lavoro.
