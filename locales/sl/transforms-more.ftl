# Mirroring, scaling and tilting.

# --- 8 ---
cycle-mirroring = Zrcaljenje
    .nc = ZRCALJENJE

# --- 11 ---
cycle-scaling = Faktor merila
    .nc = FAKTOR MERILA

# --- 26 ---
cycle-axis-scaling = Osni faktor merila
    .nc = FAKTOR MERILA, SPECIF. ZA OS
    .nc-aliases = FAKTOR MERILA, SPECIFIČEN ZA OSI

# --- 19 ---
cycle-working-plane = Obdelovalna ravnina
    .nc = OBDELOVALNA RAVNINA
