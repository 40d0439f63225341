# Parameters of recess turning, recessing and thread turning; see the English file.

# --- recess turning and recessing ---
parameter-recess-clearance = Distanza di sicurezza

# --- threads ---
parameter-thread-clearance = Distanza di sicurezza
parameter-turned-thread-pitch = Passo del filetto
    .label = PASSO FILETTO
parameter-turned-thread-depth = Profondità di filettatura
parameter-thread-starting-angle = Angolo di partenza
    .label = ANGOLO DI PARTENZA
