# Cycles that save the kinematics and compensate the preset.

# --- 450 ---
cycle-save-kinematics = Salva cinematica
    .nc = SALVA CINEMATICA

# --- 452 ---
cycle-preset-compensation = Compensazione Preset
    .nc = COMPENSAZ. PRESET
    .nc-aliases = COMPENSAZIONE PRESET
title-compensate-preset = Programma di calibrazione
