# Parameters of the cycles that save the kinematics, calibrate touch probes and digitize: name, label in the NC block, help.

# --- saved kinematics ---
parameter-kinematics-memory-mode = Način (0/1/2/3)
    .label = NAČIN
parameter-kinematics-memory-location = Oznaka pomnilnika
    .label = OZNAKA POMNILNIKA
    .label-aliases = MESTO POMNILNIKA

# --- preset compensation ---
parameter-sphere-touch-points__preset-compensation = Število merilnih točk
