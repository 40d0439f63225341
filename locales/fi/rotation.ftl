# Työkierrot, jotka määrittävät ja kompensoivat työkappaleen vinon asennon.

# --- 400 ---
cycle-basic-rotation = Peruskääntö
    .nc = PERUSKÄÄNTÖ

# --- 401 ja 402 ---
cycle-rotation-two-holes = Peruskääntö kahden reiän avulla
    .nc = ROT 2 REIKÄÄ
    .nc-aliases = ROT 2 BOHRUNGEN
cycle-rotation-two-studs = Peruskääntö kahden kaulan avulla
    .nc = ROT 2 KAULAA

# --- 403 ---
cycle-rotation-by-rotary-axis = Peruskäännön kompensointi kiertoakselin avulla
    .nc = ROT C-AKSELILLA
    .nc-aliases = ROT KIERTOAKSELIN AVULLA

# --- 404 ---
cycle-set-basic-rotation = Peruskäännön asetus
    .nc = PERUSKÄÄNTÖ
    .nc-aliases = PERUSKÄÄNNÖN ASETUS

# --- 405 ---
cycle-rotation-by-c-axis = Työkappaleen vinon aseman korjaus C-akselin avulla
    .nc = ROT C-AKSELILLA
    .nc-aliases = ROT C-AKSELIN AVULLA
