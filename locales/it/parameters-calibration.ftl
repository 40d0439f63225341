# Parameters of the cycles that save the kinematics, calibrate touch probes and digitize: name, label in the NC block, help.

# --- saved kinematics ---
parameter-kinematics-memory-mode =
    .label = MODO
parameter-kinematics-memory-mode__itnc530 = MODO (0/1/2)
parameter-kinematics-memory-location__itnc530 = LOCAZIONE DI MEMORIA (0…9)
    .label = LOCAZIONE DI MEMORIA

# --- preset compensation ---
parameter-sphere-touch-points__preset-compensation__itnc530 = N. PUNTI MISURATI
