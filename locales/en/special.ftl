# Special functions.

# --- 9 ---
cycle-dwell = Dwell time
    .nc = DWELL TIME
    .purpose = Stops the program run for the dwell time, for example to break chips.
step-dwell-for-programmed-time = The control stops the program run for the programmed dwell time.
note-dwell-acts-from-definition = The cycle acts from its definition in the program.
note-dwell-keeps-modal-states = Modal states, such as the rotation of the spindle, are not affected.

# --- 12 ---
cycle-program-call = Program call
    .nc = PGM CALL
    .purpose = Makes any program, such as a special drilling cycle or a geometry module, equal to a machining cycle. The program is then called like a cycle.
step-call-program-as-cycle = When the cycle is called, the control executes the program.
note-program-becomes-cycle = Enter the name of the program to be called, with its path if necessary; or activate the file selection with the soft key SELECT and select the program.
note-called-program-on-hard-disk = The called program must be stored on the hard disk of the control.
note-called-program-in-same-directory = If only the name of the program is entered, the program must be in the same directory as the calling program.
note-called-program-with-path = If the program is not in the same directory as the calling program, enter the complete path.
note-called-iso-program = To make a DIN/ISO program a cycle, enter the file type .I after the program name.
note-q-parameters-act-globally = Q parameters always act globally when a program is called with this cycle. Changes of Q parameters in the called program may therefore affect the calling program.
note-ways-to-call-the-program = Call the program with CYCL CALL (a block of its own), with M99 (in a block), or with M89 (executed after every positioning block).
title-program-50-as-cycle = Program 50 as a cycle, called with M99

# --- 13 ---
cycle-spindle-orientation = Spindle orientation
    .nc = ORIENTATION
    .purpose = Sets the angle to which the control turns the main spindle of the machine tool.
step-keep-orientation-angle = The control keeps the angle for the next orientation of the spindle.
step-program-m19-or-m20 = Program M19 or M20 (depending on the machine): the control then positions the spindle at the angle defined in the cycle.
note-prepare-for-spindle-orientation = Machine and control must be prepared by the machine builder.
note-orientation-is-needed-for = Spindle orientation is needed, for example, for tool changers with a defined tool change position, and to align the transmitter and receiver windows of 3-D touch probes with infrared transmission.
note-orientation-by-m19-or-m20 = The control positions the spindle at the angle defined in the cycle when M19 or M20 is programmed (depending on the machine).
note-orientation-without-cycle = If M19 or M20 is programmed without this cycle before, the control positions the main spindle at an angle that the machine builder has set (see the machine manual).
note-orientation-used-by-cycles = The machining cycles 202, 204 and 209 use this cycle internally. If necessary, program it again after one of them.

# --- 32 ---
cycle-tolerance = Tolerance
    .nc = TOLERANCE
    .purpose = Influences the result of high-speed machining in accuracy, surface quality and speed, as far as the control has been adapted to the machine.
step-smooth-contour = The control smooths the contour between any contour elements, compensated or not. The tool therefore moves continuously on the workpiece surface and spares the mechanics of the machine.
step-reduce-feed-to-run-smoothly = If necessary, the control reduces the programmed feed rate so that it always executes the program at the greatest possible speed without jerks.
note-prepare-for-tolerance = Machine and control must be prepared by the machine builder.
note-preset-tolerance-by-builder = Smoothing makes the contour deviate. The machine builder has set the deviation (tolerance value) in a machine parameter. The cycle changes the preset tolerance value and selects other filter settings, provided the machine builder makes use of these possibilities.
note-tolerance-is-always-used = Even if the control does not reduce the speed, it always uses the defined tolerance. The greater the tolerance, the faster the control can move the axes.
note-tolerance-on-arcs = The tolerance defined in the cycle also acts on movements on arcs.
note-chord-error-of-cam = The most important influence when NC programs are made with a CAM system is the chord error S that can be defined there. It determines the greatest distance between the points of an NC program made by a postprocessor. If the chord error is equal to or less than the tolerance value T of the cycle, the control can smooth the contour points, unless special machine settings limit the programmed feed rate.
note-best-smoothing = Smoothing is best if the tolerance value in the cycle is between 1.1 and 2 times the chord error of the CAM system.
note-very-small-tolerance = With very small tolerance values the machine can no longer machine the contour without jerks. The cause is not a lack of computing power of the control: it approaches the contour transitions almost exactly and may have to reduce the traversing speed considerably.
note-tolerance-is-def-active = The cycle is in effect as soon as it is defined in the program.
note-reset-tolerance = The control resets the cycle if the cycle is defined again and the question for the tolerance value is answered with NO ENT, or if a new program is selected with the key PGM MGT. After the reset the tolerance preset by machine parameter is active again.
note-unit-of-tolerance = The control takes the entered tolerance value T in millimetres in a millimetre program, and in inches in an inch program.
note-tolerance-alone-adds-zeros = If a program is read in that contains only the tolerance value T as parameter of the cycle, the control adds the two other parameters with the value 0 if necessary.
note-tolerance-changes-circle-diameter = With increasing tolerance the diameter of circular movements usually decreases. If an HSC filter is active on the machine (ask the machine builder if necessary), the circle can also become larger.
note-tolerance-in-status-display = If the cycle is active, the additional status display shows its parameters on the tab CYC.
