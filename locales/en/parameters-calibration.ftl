# Parameters of the cycles that save the kinematics, calibrate touch probes and digitize: name, label in the NC block, help.

# --- saved kinematics ---
parameter-kinematics-memory-mode = Mode (0/1/2/3)
    .label = MODE
    .help = Whether a kinematics is saved or restored.
parameter-kinematics-memory-mode__itnc530 = Mode (0/1/2)
choice-save-kinematics = save the kinematics
choice-save-kinematics__itnc530 = save the active kinematics
choice-restore-kinematics = restore a saved kinematics
choice-show-saved-kinematics = show the present state of the memory
choice-delete-saved-kinematics = delete a data record
parameter-kinematics-memory-location = Memory designation
    .label = MEMORY DESIGNATION
    .help = Number or name of the data record, at most 16 characters. There are 16 memory locations. It has no function in mode 2. In the modes 1 and 3 (restore and delete) it may contain wildcards. If several records match the wildcards, the mean values of their data are restored (mode 1), or all of them are deleted after confirmation (mode 3). Wildcards: ? is a single undefined character, $ a single letter, # a single undefined digit, * a string of any length.
parameter-kinematics-memory-location__itnc530 = Memory location (0…9)
    .label = MEMORY LOCATION
    .help = Number of the memory location in which the complete kinematics is saved, or from which the saved kinematics is restored. It has no function in mode 2.

# --- preset compensation ---
parameter-sphere-touch-points__preset-compensation = Number of measuring points
    .help = Number of probings with which the control measures the calibration sphere in the plane.
