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

# --- calibration of touch probes ---
parameter-calibration-sphere-probings = Number of probings in the plane (4/3)
    .label = NO. OF PROBE POINTS
    .help = Number of measuring points on the diameter.
parameter-calibration-ring-probings = Number of probings
    .label = NO. OF PROBE POINTS
    .help = Number of measuring points on the diameter.
parameter-kinematics-reference-angle__calibrate-in-ring =
    .help = Angle between the main axis of the working plane and the first touch point.
parameter-kinematics-reference-angle__calibrate-on-stud =
    .help = Angle between the main axis of the working plane and the first touch point.
parameter-length-calibration = Calibrate length (0/1)
    .label = CALIBRATE LENGTH
    .help = Whether the control also calibrates the length of the touch probe after calibrating the radius.
choice-no-length-calibration = do not calibrate the length of the touch probe
choice-length-calibration = calibrate the length of the touch probe
parameter-length-reference = Datum for length
    .label = DATUM
    .help = Coordinate of the centre of the calibration sphere. It is only needed if the length is calibrated.
parameter-length-reference__calibrate-probe-length = Datum
    .help = Reference for the length, such as the height of the setting ring.
parameter-calibration-ring-radius = Ring radius
    .label = RING RADIUS
    .help = Radius of the setting ring.
parameter-calibration-stud-radius = Stud radius
    .label = STUD RADIUS
    .help = Radius of the stud.
parameter-calibration-clearance-height = Clearance height
    .word = HEIGHT:
    .help = Coordinate in the touch probe axis at which the touch probe cannot collide with the calibration part or its clamping.
parameter-calibration-part-radius = Radius of calibration ring
    .help = Radius of the calibration part.
parameter-calibration-inside-or-outside = Calibrate inside=0/calibrate outside=1
    .word = MEASURING MODE:
    .help = Whether the control calibrates inside a ring or outside on a stud.
choice-calibrate-inside = calibrate inside
choice-calibrate-outside = calibrate outside
