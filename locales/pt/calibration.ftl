# Cycles that calibrate touch probes.

# --- 2 ---
cycle-calibrate-touch-probe = Calibrar TS
    .nc = CALIBRAR TS
