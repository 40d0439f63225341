# Cycles that measure the tool: radius, complete tool, calibration of the tool touch probe.

# --- 32 and 482 ---
cycle-tool-radius = Merjenje polmera orodja
    .nc = POLMER ORODJA
cycle-tool-radius-old = Merjenje polmera orodja
    .nc = POLMER ORODJA

# --- 33 and 483 ---
cycle-tool-complete = Popolno merjenje orodja
    .nc = MERJENJE ORODJA
cycle-tool-complete-old = Popolno merjenje orodja
    .nc = MERJENJE ORODJA

# --- 30 and 480 ---
cycle-calibrate-tool-probe = Umerjanje tipalnega sistema
    .nc = UMERJANJE TIP. SIST.
cycle-calibrate-tool-probe-old = Umerjanje tipalnega sistema
    .nc = UMERJANJE TIP. SIST.

# --- 484 ---
cycle-calibrate-wireless-tool-probe = Umerjanje brezžičnega namiznega tipalnega sistema TT 449
    .nc = UMERJANJE BREZŽIČNEGA TT 449
