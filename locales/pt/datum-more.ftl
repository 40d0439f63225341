# Outros ciclos que memorizam um ponto de referência.

# --- 410 e 411 ---
cycle-datum-inside-rectangle = Ponto ref rectângulo interior
    .nc = PONTREF RECTÂNG INTERN
    .nc-aliases = PONTO REF RECTÂNG INTERIOR
cycle-datum-outside-rectangle = Ponto ref rectângulo exterior
    .nc = PONTO REF RECTÂNGULO EXT.
    .nc-aliases = PONTO REF RECTÂNG EXTERIOR

# --- 413 ---
cycle-datum-outside-circle = Ponto referência círculo exterior
    .nc = PONTO REF CÍRCULO EXTERIOR

# --- 414 e 415 ---
cycle-datum-outside-corner = Ponto de referência esquina exterior
    .nc = PONTO REF ESQUINA EXTERIOR
cycle-datum-inside-corner = Ponto de referência esquina interior
    .nc = PONTO REF ESQUINA INTERIOR
