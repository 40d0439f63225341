# Cycles that measure the workpiece.

# --- 421 ---
cycle-measure-hole = Measure hole
    .nc = MEASURE HOLE
    .purpose = Measures the centre and the diameter of a hole (circular pocket). If tolerances are defined in the cycle, the control compares nominal and actual values and stores the deviations in parameters.
step-retract-and-store-results = The control returns the touch probe to the clearance height { $q-clearance-height } and stores the actual values and the deviations from the nominal values in the result parameters.
step-set-measuring-status = The control sets the measuring status:
say-hole-is-scrap = scrap (Q182=1) if the hole is larger than { $q-hole-greatest-diameter }, or its centre deviates by more than { $q-centre-tolerance-main } or { $q-centre-tolerance-minor }
say-hole-needs-rework = rework (Q181=1) if the hole is smaller than { $q-hole-least-diameter }
say-hole-is-good = otherwise within tolerance (Q180=1), even if no tolerances or limits are entered
step-write-measuring-log = The control creates the measuring log as defined in { $q-measuring-log }:
say-log-to-file = with { $q-measuring-log }=1 it stores the log in the file TCHPR{ $cycle }.TXT
say-log-on-screen = with { $q-measuring-log }=2 it interrupts the program run and shows the log on the screen; NC start continues the program
say-no-log = otherwise it creates no log
message-measuring-log-on-screen = The measuring log is on the screen. Continue with NC start.
step-monitor-tool = The control monitors the tool as defined in { $q-monitored-tool }:
say-correct-tool-radius = with { $q-monitored-tool } not 0 it adds the deviation of the radius to the delta radius in the column DR of the tool table; if the deviation is greater than the breakage tolerance RBREAK, it shows an error message, stops the program run and locks the tool (column TL = L)
say-no-tool-monitoring = with { $q-monitored-tool }=0 no tool is monitored
step-stop-on-tolerance-error = If a tolerance is exceeded, the control reacts as defined in { $q-stop-on-tolerance-error }:
say-stop-with-tolerance-error = with { $q-stop-on-tolerance-error }=1 it interrupts the program run and shows an error message
say-stop-with-tolerance-error__probing-3d = with { $q-tolerance-error-reaction }=1 it interrupts the program run and shows an error message
say-continue-program = otherwise the program continues
result-centre-main-deviation = Deviation of centre in main axis
result-centre-minor-deviation = Deviation of centre in secondary axis
result-diameter-deviation = Deviation of diameter
result-status-good = 1: the measured values are within tolerance
result-status-rework = 1: rework is required
result-status-scrap = 1: scrap
note-measuring-log-contents = The measuring log contains date, time and measuring program, the nominal values, the limits, the actual values, the deviations and further results (measuring height).
note-measuring-log-contents__tnc426-430 = The measuring log contains date, time and measuring program, the nominal values, the limits, the actual values and the deviations.
note-measuring-log-in-tnc-directory = The control stores the measuring log as an ASCII file, by default in the directory TNC:\.
note-measuring-log-in-program-directory = The control stores the measuring log as an ASCII file, by default in the directory from which the measuring program is run. Alternatively the log can be sent through the data interface to a printer or a PC: set the function Print in the interface menu to RS232:\.
note-measuring-log-transfer = Use the data transfer software TNCremo from HEIDENHAIN to transfer the measuring log through the data interface.
note-measuring-log-datum = All measured values in the log file refer to the datum that was active when the cycle was executed.
note-measuring-log-manual-datum = Without an active datum shift, all measured values in the log file refer to the datum that was set in the mode Manual Operation.
note-status-also-without-limits = The control sets the measuring status even if no tolerances or limits are entered.
note-which-value-is-out = The control marks rework or scrap as soon as one measured value is out of tolerance. To find out which one, see the measuring log, or compare the results with their limits.
note-limit-zero-not-monitored = With 0 (the preset value) in a limit or tolerance the control does not monitor it.
note-tool-monitoring-needs = Tool monitoring and correction act only if the tool table is active and { $q-monitored-tool } is not 0. If several correction measurements are made, the control adds each deviation to the value stored in the tool table.
note-tool-monitoring-needs__tnc426-430 = Tool monitoring and correction act only if the tool table is active and { $q-monitored-tool } is not 0.
note-tool-radius-always-corrected = The control always corrects the tool radius in the column DR of the tool table, even if the deviation is within tolerance. The program can check with Q181 whether rework is required (Q181=1: rework required).
note-tool-breakage-needs = Tool breakage monitoring acts only if the tool table is active, { $q-monitored-tool } is not 0 and the breakage tolerance RBREAK of the tool in the tool table is greater than 0.
note-tool-by-name = The tool can also be entered with its name, selected by soft key. The control does not show the closing quotation mark.

# --- 0 ---
cycle-reference-plane = Reference plane
    .nc = REF. PLANE
    .purpose = Measures a coordinate in a selectable axis and assigns it to a Q parameter.
step-position-in-space = The touch probe moves in a 3-D movement at rapid traverse (value from the column { $mp-positioning-feed }) to the pre-position programmed in the cycle.
step-position-in-space__tnc426-430 = The touch probe moves at rapid traverse (value from { $mp-positioning-feed } or { $mp-analog-positioning-feed }) to the pre-position programmed in the cycle.
step-probe-in-chosen-direction = The touch probe carries out the probing at the probing feed rate (column { $mp-probing-feed }) in the direction programmed in the cycle.
step-probe-in-chosen-direction__tnc426-430 = The touch probe carries out the probing at the probing feed rate ({ $mp-probing-feed } or { $mp-analog-probing-feed }) in the direction programmed in the cycle.
step-return-and-store-coordinate = After the position has been measured, the touch probe returns to the starting point of the probing. The control stores the measured coordinate in the programmed Q parameter, and the coordinates of the position at which the touch probe was at the switching signal in the parameters Q115 to Q119.
result-measured-coordinate = Measured coordinate
result-trigger-position-axis-1 = Position at the switching signal, 1st axis
result-trigger-position-axis-2 = Position at the switching signal, 2nd axis
result-trigger-position-axis-3 = Position at the switching signal, 3rd axis
result-trigger-position-axis-4 = Position at the switching signal, 4th axis
result-trigger-position-axis-5 = Position at the switching signal, 5th axis
note-pre-position-without-collision = Danger of collision! Position the touch probe so that it cannot collide when it moves to the programmed pre-position.
note-pre-position-without-collision__tnc426-430 = Danger of collision! Pre-position the touch probe by hand so that it cannot collide when it moves to the programmed pre-position.
note-trigger-position-uncompensated = The values in Q115 to Q119 do not take the length and the radius of the stylus into account.
note-no-log-for-reference-plane = The control creates no measuring log for this cycle.

# --- 444 ---
cycle-probing-3d = Probing in 3-D
    .nc = PROBING IN 3-D
    .purpose = Checks a single point on the surface of a part, for example of a free-form surface. The cycle determines whether the point lies above or below its nominal position along the normal vector, so that rework, for example, can follow. It can monitor a tolerance, writes a log and stores the results in parameters.
step-position-on-normal = The touch probe moves from its present position to a point on the normal vector. Its distance from the nominal coordinates is the radius of the ball tip plus { $mp-set-up } plus { $q-probing-clearance }. Pre-positioning takes the clearance height { $q-clearance-height } into account.
step-probe-nominal-point = The touch probe moves to the nominal coordinates. The probing path is defined by { $mp-probing-distance }, not by the normal vector, which only serves to calculate the coordinates correctly.
step-return-and-store-position = When the control has measured the position, the touch probe retracts and stops. The control stores the measured coordinates and the deviations in the result parameters.
step-retract-against-probing-direction = The control moves the touch probe back, opposite to the probing direction, by the value defined in the parameter MB.
step-set-workpiece-status = The control sets the workpiece status Q183:
say-surface-status-undefined = −1 (not defined) if { $q-tolerance-specification } defines no tolerance
say-surface-needs-rework = 1 (rework) if the point is above the tolerance band
say-surface-is-scrap = 2 (scrap) if the point is below the tolerance band
say-surface-is-good = 0 (good) otherwise
step-write-surface-log = The control creates the log and stores it in HTML format.
step-react-to-tolerance-error = If the point is out of tolerance, the control reacts as defined in { $q-tolerance-error-reaction }:
say-stop-below-nominal = with { $q-tolerance-error-reaction }=2 and a point below the nominal coordinate it shows a message and interrupts the program
result-position-main-actual = Measured position in main axis
result-position-minor-actual = Measured position in secondary axis
result-position-tool-actual = Measured position in tool axis
result-position-main-deviation = Measured deviation in main axis
result-position-minor-deviation = Measured deviation in secondary axis
result-position-tool-deviation = Measured deviation in tool axis
result-deviation-3d = Measured 3-D deviation; less than 0: undersize, greater than 0: oversize
result-workpiece-status = Workpiece status: −1 = not defined, 0 = good, 1 = rework, 2 = scrap
guard-zero-normal-vector = All components of the normal vector are 0.
guard-rotary-axes-askew = The positions of the rotary axes do not match the tilting angles of the working plane.
guard-mill-mode-only = The cycle can only be executed in the mode FUNCTION MODE MILL.
guard-surface-below-nominal = The point is below its nominal coordinate and out of tolerance.
note-function-must-be-enabled = The machine builder must enable and adapt this function. Refer to the machine manual.
note-mill-mode-only = The cycle can only be executed in the mode FUNCTION MODE MILL.
note-calibrate-in-3d = For accurate results, calibrate the touch probe in 3-D before this cycle. 3-D calibration needs option 92, 3D-ToolComp.
note-surface-log-contents = For each of the main, secondary and tool axes the log contains the actual probing direction (a vector in the input coordinate system, as long as the configured probing path), the nominal and the actual coordinate and, if { $q-tolerance-specification } defines a tolerance, the upper and lower deviation and the deviation along the normal vector. The colour of a value shows the result: green for good, orange for rework, red for scrap. The log also contains the 3-D deviation.
note-surface-log-directory = The control stores the log as an HTML file in the directory of the NC program if a path is configured for FN 16.
note-mirror-or-scaling-is-an-error = The control shows an error message if mirroring (cycle 8), scaling (cycle 11) or axis-specific scaling (cycle 26) is in effect when the cycle is activated.
note-tcpm-considered = An active TCPM is taken into account during probing. With TCPM, positions can be probed even if the tilting of the working plane and the rotary axes do not agree.
note-track-with-controlled-spindle = If the machine has a controlled spindle, activate the tracking of the angle in the touch probe table (column { $mp-track }). This generally improves the accuracy of measurements with a 3-D touch probe.
note-coordinates-in-input-system = All coordinates of the cycle refer to the input coordinate system.
note-results-in-parameters = The control writes the measured values to the result parameters.
note-status-independent-of-reaction = The workpiece status good, rework or scrap in Q183 is set independently of { $q-tolerance-error-reaction }.
note-normal-from-cad = The normal vector ({ $q-surface-normal-main }, { $q-surface-normal-minor }, { $q-surface-normal-tool }) is perpendicular to the imagined plane in which the nominal coordinates lie, and points away from the surface. It is best taken from a CAD or CAM system.
note-normal-does-not-set-path = The normal vector does not determine the probing path.
note-tolerance-grammar = Examples of a tolerance: with "0.4-0.1" the band reaches from 0.1 below the nominal coordinate to 0.4 above it, with "0.4" from the nominal coordinate to 0.4 above it, with "-0.1" from 0.1 below the nominal coordinate to that coordinate. With " ", "0" and "0.1+0.1" no tolerance is monitored.
note-tilting-angles-compared = Depending on the machine parameter chkTiltingAxes (no. 204600) the control checks during probing whether the positions of the rotary axes match the tilting angles (3-D ROT). If they do not, it shows an error message.
note-adapt-nc-programs = NC programs shown as examples are suggestions. Before you use them, adapt the following to the machine: tools, cutting data, feed rates, the clearance height or safe positions, positions that depend on the machine (such as with M91) and the paths in program calls. Adapt programs that depend on the kinematics to the kinematics of the machine before the first test run.
note-simulate-nc-programs = Test the NC program in the simulation before it is run. The program test shows whether it can be used with the available software options, the active machine kinematics and the present machine configuration.
