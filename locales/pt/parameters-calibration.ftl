# Parameters of the cycles that save the kinematics, calibrate touch probes and digitize: name, label in the NC block, help.

# --- calibration of touch probes ---
parameter-calibration-clearance-height = Distância segura
    .word = ALTURA:
parameter-calibration-part-radius = Raio Anel de calibração
parameter-calibration-inside-or-outside = Calibrar interior=0/Calibrar exterior=1
    .word = MODO DE MEDIÇÃO:
