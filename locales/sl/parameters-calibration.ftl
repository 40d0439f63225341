# Parameters of the cycles that save the kinematics, calibrate touch probes and digitize: name, label in the NC block, help.

# --- saved kinematics ---
parameter-kinematics-memory-mode = Način (0/1/2/3)
    .label = NAČIN
parameter-kinematics-memory-location = Oznaka pomnilnika
    .label = OZNAKA POMNILNIKA
    .label-aliases = MESTO POMNILNIKA

# --- preset compensation ---
parameter-sphere-touch-points__preset-compensation = Število merilnih točk

# --- calibration of touch probes ---
parameter-calibration-sphere-probings = Število tipanj ravnine (4/3)
    .label = ŠTEVILO TIPANJ
parameter-calibration-ring-probings = ŠTEVILO TIPANJ
    .label = ŠTEVILO TIPANJ
parameter-length-calibration = Umeritev dolžine (0/1)
    .label = UMERJANJE DOLŽINE
parameter-length-reference = Referenčna točka za dolžino
    .label = REFERENČNA TOČKA
parameter-length-reference__calibrate-probe-length = Referenčna točka
parameter-calibration-ring-radius = POLMER KROGA
    .label = POLMER KROGA
parameter-calibration-stud-radius = POLMER ČEPOV
    .label = POLMER ČEPOV
parameter-probing-clearance__calibrate-in-ring = VARNOSTNA RAZDALJA
parameter-probing-clearance__calibrate-on-stud = VARNOSTNA RAZDALJA
parameter-traverse-to-clearance-height__calibrate-on-stud = PREMIK NA VARNO VIŠINO
parameter-kinematics-reference-angle__calibrate-in-ring = REFERENČNI KOT
parameter-kinematics-reference-angle__calibrate-on-stud = REFERENČNI KOT
