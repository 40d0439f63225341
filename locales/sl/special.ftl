# Special functions.

# --- 9 ---
cycle-dwell = Čas zadrževanja
    .nc = ČAS ZADRŽ.

# --- 12 ---
cycle-program-call = Priklic programa
    .nc = PGM CALL

# --- 13 ---
cycle-spindle-orientation = Orientacija vretena
    .nc = ORIENTACIJA

# --- 32 ---
cycle-tolerance = Toleranca
    .nc = TOLERANCA
