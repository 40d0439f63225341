# Cycles that save the kinematics and compensate the preset.

# --- 450 ---
cycle-save-kinematics = Shranjevanje kinematike
    .nc = SHRANJEVANJE KINEMATIKE

# --- 452 ---
cycle-preset-compensation = Kompenzacija prednastavitve
    .nc = IZRAVNAVA PREDNASTAVITVE
    .nc-aliases = KOMPENZACIJA PREDNASTAVITVE
