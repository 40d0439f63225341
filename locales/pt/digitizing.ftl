# Cycles that digitize a part with a touch probe.

# --- 5 and 15 ---
cycle-digitize-range = Campo
    .nc = CAMPO
    .nc-aliases = ÁREA
cycle-digitize-range-from-points = Campo
    .nc = CAMPO
    .nc-aliases = ÁREA

# --- 6 and 16 ---
cycle-digitize-meander = Meandro
    .nc = MEANDRO
cycle-digitize-meander-analog = Meandro
    .nc = MEANDRO

# --- 7 and 17 ---
cycle-digitize-contour-lines = Linhas de nível
    .nc = LINHAS DE NÍVEL
    .nc-aliases = LINHA DE NÍVEL
cycle-digitize-contour-lines-analog = Linhas de nível
    .nc = LINHAS DE NÍVEL
    .nc-aliases = LINHA DE NÍVEL

# --- 8 and 18 ---
cycle-digitize-lines = Linha
    .nc = LINHA
    .nc-aliases = LINHAS
cycle-digitize-lines-analog = Linha
    .nc = LINHA
    .nc-aliases = LINHAS
