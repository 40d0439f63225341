# Cycles that measure the kinematics of the machine.

# --- parameters ---
parameter-kinematics-mode = Mode (0=check/1=measure)
    .label = MODE
    .help = Defines whether the control checks or optimizes the active kinematics.
parameter-kinematics-mode__itnc530 = Mode (0/1/2)
choice-kinematics-check = check the active machine kinematics: the control measures the rotary axes defined, but changes nothing; it shows the results in a measuring log
choice-kinematics-optimize-position = optimize the active machine kinematics: the control measures the rotary axes defined and optimizes their position
choice-kinematics-optimize-position-and-angle = optimize the active machine kinematics: the control measures the rotary axes defined, optimizes their position and compensates their angle; this needs the option KinematicsComp
parameter-sphere-radius = Exact radius of calibration sphere
    .label = SPHERE RADIUS
    .help = Exact radius of the calibration sphere that is used.
parameter-retraction-height = Retraction height
    .label = RETR. HEIGHT
    .help = Defines whether and where the touch probe retracts before a rotary axis is positioned.
choice-no-retraction = do not move to a retraction height: the control moves to the next measuring position in the axis to be measured, and to the first one in the order A, B, C; not permitted with Hirth axes
choice-retraction = retraction height in the untilted workpiece coordinate system to which the control moves the spindle axis before it positions a rotary axis; in the working plane it moves the touch probe to the datum; probe monitoring is not active in this mode, so define the positioning speed in { $q-kinematics-positioning-feed }
parameter-kinematics-positioning-feed = Feed rate for pre-positioning
    .label = F PRE-POSITIONING
    .help = Traversing speed of the tool during positioning.
parameter-kinematics-reference-angle = Reference angle
    .label = REFERENCE ANGLE
    .help = Reference angle (basic rotation) for measuring the points in the active workpiece coordinate system. It can enlarge the measuring range of an axis considerably.
parameter-rotary-start-angle-a = Start angle A-axis
    .label = START ANGLE A-AXIS
    .help = Angle in the A-axis at which the first measurement is made.
parameter-rotary-end-angle-a = End angle A-axis
    .label = END ANGLE A-AXIS
    .help = Angle in the A-axis at which the last measurement is made.
parameter-rotary-incidence-angle-a = Angle of incidence A-axis
    .label = INCID. ANGLE A-AXIS
    .help = Angle of incidence in the A-axis at which the other rotary axes are measured.
parameter-rotary-measuring-points-a = Number of measuring points A-axis
    .label = MEAS. POINTS A-AXIS
    .help = Number of measurements with which the control measures the A-axis. With 0 the axis is not measured.
parameter-rotary-start-angle-b = Start angle B-axis
    .label = START ANGLE B-AXIS
    .help = Angle in the B-axis at which the first measurement is made.
parameter-rotary-end-angle-b = End angle B-axis
    .label = END ANGLE B-AXIS
    .help = Angle in the B-axis at which the last measurement is made.
parameter-rotary-incidence-angle-b = Angle of incidence B-axis
    .label = INCID. ANGLE B-AXIS
    .help = Angle of incidence in the B-axis at which the other rotary axes are measured.
parameter-rotary-measuring-points-b = Number of measuring points B-axis
    .label = MEAS. POINTS B-AXIS
    .help = Number of measurements with which the control measures the B-axis. With 0 the axis is not measured.
parameter-rotary-start-angle-c = Start angle C-axis
    .label = START ANGLE C-AXIS
    .help = Angle in the C-axis at which the first measurement is made.
parameter-rotary-end-angle-c = End angle C-axis
    .label = END ANGLE C-AXIS
    .help = Angle in the C-axis at which the last measurement is made.
parameter-rotary-incidence-angle-c = Angle of incidence C-axis
    .label = INCID. ANGLE C-AXIS
    .help = Angle of incidence in the C-axis at which the other rotary axes are measured.
parameter-rotary-measuring-points-c = Number of measuring points C-axis
    .label = MEAS. POINTS C-AXIS
    .help = Number of measurements with which the control measures the C-axis. With 0 the axis is not measured.
parameter-sphere-touch-points = Number of measuring points (3-8)
    .label = NO. OF PROBE POINTS
    .help = Number of points at which the control probes the calibration sphere in the plane. Fewer points save time, more points give a more accurate result.
parameter-sphere-touch-points__itnc530 = Number of measuring points
    .help = Number of points at which the control probes the calibration sphere in the plane.
parameter-sphere-preset = Set preset (0/1/2/3)
    .label = PRESET
    .help = Defines whether the control automatically sets the active preset (datum) at the centre of the sphere.
choice-sphere-preset-none = do not set the preset at the sphere centre automatically: set it manually before the cycle starts
choice-sphere-preset-before = set the preset at the sphere centre automatically before the measurement: pre-position the touch probe manually above the calibration sphere before the cycle starts
choice-sphere-preset-after = set the preset at the sphere centre automatically after the measurement: set the preset manually before the cycle starts
choice-sphere-preset-before-and-after = set the preset at the sphere centre before and after the measurement: pre-position the touch probe manually above the calibration sphere before the cycle starts
parameter-backlash-angle = Backlash, angle range
    .label = BACKLASH, ANG. RANGE
    .help = Angle by which the rotary axes overtravel to measure their backlash. It must be considerably larger than the actual backlash. With 0 the backlash is not measured.

# --- 451 ---
cycle-measure-kinematics = Measure kinematics
    .nc = MEASURE KINEMATICS
    .purpose = Checks the kinematics of the machine and, if desired, optimizes them. A 3-D touch probe measures a HEIDENHAIN calibration sphere on the machine table. The control evaluates the static tilting accuracy; the software minimizes the spatial error that tilting causes and stores the machine geometry in the machine constants of the kinematics description.
step-clamp-sphere = Clamp the calibration sphere so that no collision can occur.
step-set-datum-in-sphere = In the mode Manual Operation, set the datum at the centre of the sphere. With { $q-sphere-preset }=1 or { $q-sphere-preset }=3, position the touch probe manually above the calibration sphere in the touch probe axis and at the centre of the sphere in the working plane instead.
step-start-calibration-program = Select a program run mode and start the calibration program.
step-set-preset-before-measuring = { $q-sphere-preset } determines which preset applies to the measurement:
say-preset-into-sphere-before = with { $q-sphere-preset }=1 or 3 the control sets the preset at the centre of the sphere before the measurement
say-preset-set-by-hand = otherwise it uses the datum that was set manually
step-move-to-measuring-positions = The touch probe moves to the measuring positions:
say-move-without-retraction = with { $q-retraction-height }=0 without retraction, in the axis to be measured; to the first measuring position in the order A, B, C
say-move-over-retraction-height = otherwise the spindle axis first moves to the retraction height { $q-retraction-height } and the touch probe to the datum in the working plane
step-measure-rotary-axes = The control automatically measures all rotary axes in succession with the accuracy defined. The reference measurement is made at 0°.
step-measure-backlash = { $q-backlash-angle } determines whether the control measures the backlash:
say-backlash-from-two-measurements = with an angle in { $q-backlash-angle } it determines the backlash by measuring each rotary axis twice
say-no-backlash-measurement = with { $q-backlash-angle }=0 it does not measure the backlash
step-adapt-kinematics = The control evaluates the measurement according to the mode { $q-kinematics-mode }:
say-report-possible-optimization = check: it determines the static tilting accuracy from the measured positions, logs what an optimization of the positions could achieve, and adapts nothing
say-optimize-axis-positions = optimize position: it determines the static tilting accuracy, tries to change the position of the rotary axes in the kinematic model so that the accuracy improves, and adapts the machine data automatically
say-optimize-angles-then-positions = optimize position and angle: it determines the static tilting accuracy, first tries to optimize the angular position of the rotary axes by compensation (option 52, KinematicsComp), and, if that succeeded, optimizes the position in another series of measurements
step-store-scatter-and-offsets = The control stores the measured values in the result parameters.
step-set-preset-after-measuring = After the measurement { $q-sphere-preset } determines whether the control sets the preset:
say-preset-into-sphere-after = with { $q-sphere-preset }=2 or 3 it sets it at the centre of the sphere
say-no-preset-after = otherwise it leaves the preset as it is
step-write-kinematics-log = The control creates a log (TCHPR{ $cycle }.TXT).
result-scatter-measured-a = Measured standard deviation of the A-axis (−1 if the axis was not measured)
result-scatter-measured-b = Measured standard deviation of the B-axis (−1 if the axis was not measured)
result-scatter-measured-c = Measured standard deviation of the C-axis (−1 if the axis was not measured)
result-scatter-optimized-a = Optimized standard deviation of the A-axis (−1 if the axis was not optimized)
result-scatter-optimized-b = Optimized standard deviation of the B-axis (−1 if the axis was not optimized)
result-scatter-optimized-c = Optimized standard deviation of the C-axis (−1 if the axis was not optimized)
result-offset-error-x = Offset error in the X direction, for manual transfer to the machine parameter concerned
result-offset-error-y = Offset error in the Y direction, for manual transfer to the machine parameter concerned
result-offset-error-z = Offset error in the Z direction, for manual transfer to the machine parameter concerned
note-place-sphere-without-collision = Choose the position of the calibration sphere on the machine table so that no collision can occur during the measurement.
note-hirth-axes-leave-their-grid = Danger of collision! To be positioned, a Hirth axis must move out of the Hirth grid. Make sure that the clearance is large enough to prevent collisions between the touch probe and the calibration sphere, and that there is enough room to reach it (software limit switches).
note-save-kinematics-first = If the cycle is interrupted during the measurement, the kinematics data may no longer be in their original condition. Save the active kinematics with cycle 450 before an optimization, so that they can be restored in case of an error.
note-kinematics-options = The software options 48 (KinematicsOpt), 8 (software option 1) and 17 (touch-probe functions) must be enabled.
note-kinematics-options__itnc530 = The software options 48 (KinematicsOpt) and 8 (software option 1) and FCL 3 must be enabled.
note-kinematics-comp-option = Compensating angular positions (mode 2) needs the software option 52, KinematicsComp.
note-probe-must-be-calibrated = The 3-D touch probe used for the measurement must be calibrated.
note-tool-axis-z-only = The cycle can only be executed with tool axis Z.
note-recommended-spheres = A calibration sphere with an exactly known radius and sufficient rigidity must be fixed on the machine table, at any position. HEIDENHAIN recommends the calibration spheres KKH 250 (order no. 655475-01) and KKH 100 (order no. 655475-02), which are particularly rigid and designed for machine calibration. If necessary, contact HEIDENHAIN.
note-kinematics-description-complete = The description of the machine kinematics must be complete and correct, with transformation dimensions accurate to about 1 mm, and the machine must have been measured geometrically in full (by the machine builder during commissioning).
note-model-differs-from-machine = Where the kinematic model stored in the control differs from the machine, positioning rotary axes causes errors on the workpiece. The cycle measures the rotary axes of tables and heads alike, fully automatically and with a resolution that can be chosen; its definition only states the range to be measured for each rotary axis.
note-kinematics-machine-data = { $mp-max-modification } is the limit of changes of the kinematics data above which the control shows a warning. { $mp-max-ball-deviation } is the permitted deviation of the measured sphere radius from the radius entered. { $mp-rotary-axis-m-function } is the M function that positions the rotary axes, or −1 if the control positions them itself.
note-kinematics-config-stored = The machine builder must have stored the machine parameters of { $mp-kinematics-config } in the configuration data.
note-string-parameters-used = The KinematicsOpt cycles use the global string parameters QS0 to QS99. They may have changed after the cycles are executed.
note-rotary-axes-at-zero = If { $mp-rotary-axis-m-function } defines an M function (not −1), start the measurement only when all rotary axes are at 0° (actual-value system).
note-restart-after-change = If the cycle has changed a machine parameter, restart the control. Otherwise the change may be lost.
note-positioning-direction = The positioning direction of the rotary axis to be measured results from the start angle and the end angle. A reference measurement is made automatically at 0°.
note-angular-step-of-axis = The measuring positions are spaced by (end angle − start angle) / (number of measuring points − 1). Example: +90° to −90° with 4 points gives steps of −60°: +90°, +30°, −30°, −90°. +90° to +270° with 4 points gives steps of +60°: +90°, +150°, +210°, +270°.
note-no-position-twice = Choose start angle and end angle so that no position is measured twice (such as +90° and −270°). This makes no sense, but causes no error message.
note-point-at-zero-ignored = A measuring point at 0° is ignored, because the reference measurement is always made at 0°.
note-point-at-zero-is-an-error = No measuring point may be at 0° or 360°. These positions provide no useful data and cause an error message.
note-hirth-positions-rounded = The control rounds the measuring positions of Hirth axes to the Hirth grid. Example with a grid of 3°: −30°, +10°, +50°, +90° become −30°, 9°, 51°, 90°.
note-hirth-needs-retraction-height = For Hirth axes define a retraction height { $q-retraction-height } greater than 0 if the software option 2 (M128, FUNCTION TCPM) is not available.
note-number-of-measuring-points = To save time, make a rough optimization with 1 or 2 measuring points, then a fine one with a medium number (about 4). More points usually give no better results. Distribute the points evenly over the tilting range: an axis with a range of 0° to 360° is best measured with 3 points at 90°, 180° and 270°. To check the accuracy, more points can be entered in the mode “check”.
note-where-to-place-the-sphere = The sphere can be fixed at any accessible position of the machine table, also on fixtures or workpieces. On machines with rotary or tilting tables, place it as far from the centre of rotation as possible; on machines with long traverse paths, as close to the later machining position as possible.
note-accuracy-of-kinematics = Errors of geometry and positioning of the machine influence the measured values and thus the optimization of a rotary axis; a residual error always remains. Without such errors the values could be reproduced at any point of the machine at a given time. The greater these errors, the more the results scatter when the sphere is measured at different positions. If several rotary axes move at once, the errors are superposed and in the worst case added.
note-scatter-meaning = The scatter in the log is a measure of the accuracy of the static tilting movements of a machine. The radius of the measuring circle and the number and position of the measuring points must also be taken into account. With a single measuring point no scatter can be calculated; the value is then the spatial error of that point.
note-track-for-kinematics = If the machine has a controlled spindle, activate the tracking of the angle ({ $mp-track }). This generally improves the accuracy of measurements with a 3-D touch probe.
note-unclamp-rotary-axes = If necessary, deactivate the clamping of the rotary axes during the measurement. Otherwise the results may be wrong. Refer to the machine manual.
note-calibration-rough = Rough optimization during commissioning, after approximate dimensions were entered: 1 or 2 measuring points, angular step of the rotary axes about 90°.
note-calibration-fine = Fine optimization over the whole traverse range: 3 to 6 measuring points; start angle and end angle should cover the largest possible range; place the sphere so that rotary table axes have a large measuring circle, or rotary head axes can be measured at a representative position (such as the middle of the range).
note-calibration-one-position = Optimization of a special position of a rotary axis: 2 or 3 measuring points; measure at the angle at which machining takes place later, with the sphere at the place of machining.
note-calibration-check = Checking the accuracy of the machine: 4 to 8 measuring points; start angle and end angle should cover the largest possible range.
note-calibration-backlash = Determining the backlash of the rotary axes: 8 to 12 measuring points; start angle and end angle should cover the largest possible range.
note-backlash-measured-twice = Backlash is a small play between rotary encoder and table that arises at a reversal of direction. Outside the control loop (for example with the motor encoder) it can cause considerable errors. { $q-backlash-angle } activates its measurement; the cycle then measures each rotary axis twice.
note-backlash-not-compensated = The control does not compensate backlash automatically.
note-backlash-not-determined = The backlash is not determined if the radius of the measuring circle is smaller than 1 mm, if { $mp-rotary-axis-m-function } defines an M function, or if the axis is a Hirth axis. The larger the radius of the measuring circle, the more accurately the backlash is determined.
note-reset-tilting = Make sure that all functions for tilting the working plane are reset.
note-tcpm-switched-off = M128 and FUNCTION TCPM are switched off.
note-tcpm-must-be-off = M128 and FUNCTION TCPM must not be active.
note-datum-in-sphere-first = Before the cycle definition, set and activate the datum at the centre of the calibration sphere, or enter { $q-sphere-preset }=1 or 3.
note-preposition-for-preset = If the preset is set before the measurement ({ $q-sphere-preset }=1 or 3), position the touch probe before the cycle starts approximately above the centre of the calibration sphere, at the set-up clearance ({ $q-probing-clearance } + { $mp-set-up }).
note-preposition-for-preset__itnc530 = If the preset is set before the measurement ({ $q-sphere-preset }=1 or 3), position the touch probe before the cycle starts approximately above the centre of the calibration sphere.
note-kinematics-feeds = For moving to the probing height in the touch probe axis the control uses the smaller value of { $q-kinematics-positioning-feed } and { $mp-positioning-feed }. Rotary axes move at the feed rate { $q-kinematics-positioning-feed }, with probe monitoring not active.
note-kinematics-limit-exceeded = If the kinematics data exceed, in the mode “optimize”, the permitted limit ({ $mp-max-modification }), the control shows a warning. Confirm with NC start that the values are to be accepted.
note-preset-changes-with-kinematics = A change of the kinematics always changes the preset as well. Set the preset again after an optimization.
note-sphere-radius-checked = At each probing the control first measures the radius of the calibration sphere. If it deviates from the radius entered by more than { $mp-max-ball-deviation }, the control shows an error message and ends the measurement.
note-sphere-radius-checked__itnc530 = At each probing the control first measures the radius of the calibration sphere. If it deviates from the radius entered by more than { $mp-max-ball-deviation }, the control shows a warning and ends the measurement.
note-interrupted-kinematics = If the result does not meet expectations, or an error such as a power failure occurs, the saved kinematics can be restored.
note-results-in-mm = The results and the log are in millimetres, even in inch programs.
note-inactive-axes-ignored = Entries of the cycle definition for axes that are not active are ignored.
note-status-window = A window shows the state of the measurement. The control hides it as soon as a path longer than the radius of the sphere is traversed.
note-kinematics-log-contents = The log contains date and time, the path of the NC program, the mode, the number of the active kinematics and the sphere radius entered; for each rotary axis measured: start angle, end angle, angle of incidence, number of measuring points, scatter (standard deviation), greatest error, angular error, mean backlash, mean positioning error, radius of the measuring circle, compensation values in all axes (preset shift) and the measuring uncertainty of rotary axes.
note-kinematics-log-contents__itnc530 = The log contains date and time, the path of the NC program, the mode, the number of the active kinematics and the sphere radius entered; for each rotary axis measured: start angle, end angle, angle of incidence, number of measuring points, scatter (standard deviation), greatest error, angular error, mean backlash, mean positioning error, radius of the measuring circle, compensation values in all axes (preset shift), rating of the measuring points and the measuring uncertainty of rotary axes.
note-kinematics-log-explained = In the mode “check” the log gives the accuracy that an optimization could reach, in the other modes the accuracy reached. If the angular position of a rotary axis could not be calculated, the measured data are logged all the same. Scatter measured: 68.3% of the spatial errors measured lie within ± this value; optimized: 68.3% of the errors expected after the correction. The rating of the measuring points is a measure of the quality of the measuring positions with respect to the changeable transformations of the model: the higher it is, the better the optimization. It should not be below 2 for any rotary axis, better 4 or more; if it is small, enlarge the measuring range of the axis or the number of points. If that does not help, the kinematics description may be wrong; if necessary, contact customer service.
note-measuring-uncertainty = The measuring uncertainty is given in degrees per 1 µm of system uncertainty and serves to judge the positioning errors measured or the backlash of a rotary axis. The control does not know the accuracy of the whole system, so it must be estimated: system uncertainty = SQRT(3 · u² + p²), with the positioning uncertainty (or, for backlash, the repeatability) u of each linear axis and the uncertainty p of the touch probe. Examples: u = 10 µm, p = 2 µm: 17.4 µm, with 0.0002°/µm 0.0034°; u = 5 µm, p = 2 µm: 8.9 µm, with 0.0002°/µm 0.0018°.
note-reference-head = To match interchangeable heads, insert one as the reference head, clamp the calibration sphere, insert the touch probe, measure the complete kinematics with this cycle, and set the preset after the measurement ({ $q-sphere-preset }=2 or 3). The other heads are then matched with cycle 452.
note-drift-reference = To compensate drift, clamp the calibration sphere, measure the complete kinematics with this cycle before machining starts, set the preset after the measurement ({ $q-sphere-preset }=2 or 3), then set the presets of the workpieces and start machining. Cycle 452 compensates the drift at intervals.
note-rotary-m-function = Depending on the configuration of the machine, the control may not be able to position the rotary axes automatically. A special M function of the machine builder is then needed, whose number is in { $mp-rotary-axis-m-function }.
note-angle-optimization-prepared = For optimizing angles the machine builder must have adapted the configuration. Optimizing angles can improve small, compact machines in particular. Ask the machine builder whether the configuration has been adapted and whether the optimization is worthwhile.
title-save-and-check-kinematics = Check the kinematics
title-calibration-program = Calibration program
title-optimize-position-with-backlash = Optimize the position of the rotary axes after automatic datum setting, and measure their backlash
title-optimize-position-and-angle = Optimize angle and position of the rotary axes after automatic datum setting
title-measure-reference-head = Measure the reference head
title-reference-for-drift = Reference measurement for drift compensation
