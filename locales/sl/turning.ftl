# Turning: longitudinal and face.

# --- 811 ---
cycle-turn-shoulder-longitudinal = Vzdolžno struženje segmenta
    .nc = VZDOLŽNO STRUŽENJE SEGMENTA

# --- 812 ---
cycle-turn-shoulder-longitudinal-extended = Vzdolžno struženje segmenta razširjen
    .nc = RAZŠIRJENO VZDOLŽNO STRUŽENJE SEGMENTA
    .nc-aliases = RAZŠIR. VZDOLŽ. SEG. | VZDOLŽNO STRUŽENJE SEGMENTA RAZŠIRJEN

# --- 813 ---
cycle-turn-plunge-longitudinal = Potopno vzdolžno struženje
    .nc = POTOPNO VZDOLŽNO STRUŽENJE

# --- 814 ---
cycle-turn-plunge-longitudinal-extended = Razširjeno potopno vzdolžno struženje
    .nc = RAZŠIRJENO POTOPNO VZDOLŽNO STRUŽENJE

# --- 810 ---
cycle-turn-contour-longitudinal = Vzdolžno struženje konture
    .nc = VZDOLŽNO STRUŽENJE KONTURE

# --- 815 ---
cycle-turn-contour-parallel = Struženje vzporedno s konturo
    .nc = STRUŽENJE VZPOREDNO S KONTURO

# --- 821 ---
cycle-turn-shoulder-face = Čelno struženje segmenta
    .nc = ČELNO STRUŽENJE SEGMENTA

# --- 822 ---
cycle-turn-shoulder-face-extended = Čelno struženje segmenta razširjen
    .nc = RAZŠIRJENO ČELNO STRUŽENJE SEGMENTA
    .nc-aliases = ČELNO STRUŽENJE SEGMENTA RAZŠIRJEN

# --- 823 ---
cycle-turn-plunge-face = Potopno čelno struženje
    .nc = POTOPNO ČELNO STRUŽENJE

# --- 824 ---
cycle-turn-plunge-face-extended = Razširjeno potopno čelno struženje
    .nc = RAZŠIRJENO POTOPNO ČELNO STRUŽENJE

# --- 820 ---
cycle-turn-contour-face = Čelno struženje konture
    .nc = ČELNO STRUŽENJE KONTURE

# --- 800 ---
cycle-adapt-turning-system = Prilagoditev sistema struženja
    .nc = PRILAGODITEV STRUŽNEGA SISTEMA
    .nc-aliases = DREHSYSTEM ANPASSEN | PRILAGODITEV SISTEMA STRUŽENJA

# --- 801 ---
cycle-reset-turning-system = Ponastavitev sistema struženja
    .nc = PONASTAVITEV SISTEMA STRUŽENJA
