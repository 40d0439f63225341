# Cycles that calibrate touch probes.

# --- 460 ---
cycle-calibrate-on-sphere = Umerjanje tipalnega sistema
    .nc = UMERJANJE TIPAL. SIST.

# --- 461 ---
cycle-calibrate-probe-length = Umerjanje dolžine tipalnega sistema
    .nc = UMERJANJE DOLŽINE TIPALNEGA SISTEMA

# --- 462 and 463 ---
cycle-calibrate-in-ring = Umerjanje notranjega polmera tipalnega sistema
    .nc = UMERJANJE TIPAL. SIST. V OBROČU
cycle-calibrate-on-stud = Umerjanje zunanjega polmera tipalnega sistema
    .nc = UMERJANJE TIPAL. SIST. NA ČEPIH
