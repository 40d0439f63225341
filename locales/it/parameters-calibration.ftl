# Parameters of the cycles that save the kinematics, calibrate touch probes and digitize: name, label in the NC block, help.

# --- saved kinematics ---
parameter-kinematics-memory-mode =
    .label = MODO
parameter-kinematics-memory-mode__itnc530 = MODO (0/1/2)
parameter-kinematics-memory-location__itnc530 = LOCAZIONE DI MEMORIA (0…9)
    .label = LOCAZIONE DI MEMORIA

# --- preset compensation ---
parameter-sphere-touch-points__preset-compensation = N. PUNTI MISURATI
    .help = Numero di tastature con cui il controllo misura la sfera calibrata nel piano.
parameter-sphere-touch-points__preset-compensation__itnc530 = N. PUNTI MISURATI

# --- calibration of touch probes ---
parameter-calibration-sphere-probings =
    .label = N. PUNTI MISURATI
parameter-calibration-ring-probings =
    .label = N. PUNTI MISURATI
parameter-kinematics-reference-angle__calibrate-in-ring =
    .help = Angolo tra l'asse principale del piano di lavoro e il primo punto di tastatura.
parameter-kinematics-reference-angle__calibrate-on-stud =
    .help = Angolo tra l'asse principale del piano di lavoro e il primo punto di tastatura.
parameter-length-reference =
    .label = ORIGINE
parameter-calibration-clearance-height = Altezza di sicurezza
    .word = ALT.:

# --- digitizing: the range ---
parameter-digitizing-clearance-height = Altezza di sicurezza
    .word = ALT.:

# --- digitizing: the lines ---
parameter-feed-reduction-height =
    .word = ALT.:

# --- digitizing: feed rates, distances, tolerance ---
parameter-digitizing-feed = Avanzamento F
