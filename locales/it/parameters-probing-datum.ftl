# Parameters of the misalignment and datum cycles; see the English file.

# --- datum cycles: what differs from the hole ---
parameter-probing-centre-main__datum-inside-rectangle =
    .help = Centro della tasca nell'asse principale del piano di lavoro.
parameter-probing-centre-minor__datum-inside-rectangle =
    .help = Centro della tasca nell'asse secondario del piano di lavoro.
parameter-first-side-length__datum-outside-rectangle =
    .help = Lunghezza dell'isola, parallela all'asse principale del piano di lavoro.

# --- 408 and 409 ---
parameter-slot-width = Larghezza scanalatura
    .label = LARGHEZZA SCANALATURA
parameter-ridge-width = Larghezza isola
    .label = LARGHEZZA ISOLA
parameter-new-datum-measuring-axis =
    .label = ORIGINE

# --- 414 and 415 ---
parameter-third-point-main =
    .label = 3° PUNTO 1° ASSE
parameter-third-point-minor =
    .label = 3° PUNTO 2° ASSE
parameter-point-distance-main = Distanza 1° asse
    .label = DISTANZA 1° ASSE
parameter-point-distance-minor = Distanza 2° asse
    .label = DISTANZA 2° ASSE

# --- two points on a line ---
parameter-first-point-main =
    .label = 1° PUNTO 1° ASSE
parameter-first-point-minor =
    .label = 1° PUNTO 2° ASSE
parameter-second-point-main =
    .label = 2° PUNTO 1° ASSE
parameter-second-point-minor =
    .label = 2° PUNTO 2° ASSE
choice-travel-directly-at-measuring-height = spostamento all'altezza di misura tra i punti di misura
choice-travel-directly-at-clearance-height = spostamento all'altezza di sicurezza tra i punti di misura

# --- what is done with the angle ---
parameter-basic-rotation-row =
    .label = NR. NELLA TABELLA
parameter-rotary-axis-row =
    .label = NR. NELLA TABELLA
parameter-alignment-angle =
    .label = ANGOLO DI RIFERIM.
parameter-probing-nominal-diameter__rotation-by-c-axis =
    .help = Diametro approssimativo della tasca circolare (foro). Inserire un valore piuttosto troppo piccolo che troppo grande.
