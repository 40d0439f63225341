# Cycles that measure the tool: radius, complete tool, calibration of the tool touch probe.

# --- 32 and 482 ---
cycle-tool-radius = Työkalun säteen mittaus
    .nc = TYÖKALUN SÄDE
cycle-tool-radius-old = Työkalun säteen mittaus
    .nc = TYÖKALUN SÄDE

# --- 33 and 483 ---
cycle-tool-complete = Työkalun pituuden ja säteen mittaus
    .nc = TYÖKALUN MITTAUS
cycle-tool-complete-old = Työkalun pituuden ja säteen mittaus
    .nc = TYÖKALUN MITTAUS

# --- 30 and 480 ---
cycle-calibrate-tool-probe = TT-kalibrointi
    .nc = TT KALIBROINTI
cycle-calibrate-tool-probe-old = TT-kalibrointi
    .nc = TT KALIBROINTI
