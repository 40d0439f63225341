# Parameters of the contour, cylinder surface and engraving cycles; see the English file.

# --- contour and its data ---
parameter-contour-clearance-height = Altezza di sicurezza
    .label = ALTEZZA DI SICUREZZA

# --- machining ---
parameter-contour-plunging-depth = Profondità incremento
    .label = PROF. INCREMENTO
parameter-contour-plunging-feed = Avanzamento in profondità
    .label = AVANZ. IN PROFONDITÀ
parameter-roughing-feed = Avanzamento di fresatura
parameter-contour-milling-feed = Avanzamento di fresatura
    .label = AVANZ. FRESATURA
parameter-contour-retraction-feed =
    .label = AVANZ. RITORNO
parameter-remaining-side-allowance = Sovrametallo finitura laterale
    .label = SOVRAMETALLO LATERALE
parameter-contour-milling-type = Fresatura concorde o discorde
    .label = TIPO DI FRESATURA

# --- cylinder surface ---
parameter-cylinder-set-up-clearance = Distanza di sicurezza
    .label = DISTANZA SICUREZZA
parameter-cylinder-slot-width = Larghezza scanalatura
    .label = LARGHEZZA SCANALATURA
parameter-cylinder-slot-tolerance =
    .label = TOLLERANZA

# --- engraving ---
parameter-text-rotation = Angolo di rotazione
    .label = ANGOLO DI ROTAZIONE
parameter-plunging-feed__engraving =
    .help = Velocità di spostamento dell'utensile durante la discesa in profondità.
parameter-set-up-clearance__engraving =
    .help = Distanza tra la punta dell'utensile e la superficie del pezzo. PREDEF acquisisce il valore dal blocco GLOBAL DEF.
parameter-second-set-up-clearance__engraving =
    .help = Altezza nell'asse del mandrino che esclude qualsiasi collisione tra l'utensile e il pezzo o i dispositivi di bloccaggio. PREDEF acquisisce il valore dal blocco GLOBAL DEF.
