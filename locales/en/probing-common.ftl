# What several touch-probe cycles share.

# --- run ---
step-position-at-first-touch-point = The control positions the touch probe at the first touch point, at rapid traverse (value from the column { $mp-positioning-feed }) and with positioning logic. It calculates the touch points from the values entered in the cycle and the set-up clearance in the column { $mp-set-up }.
step-position-at-first-touch-point__tnc426-430 = The control positions the touch probe at the first touch point, at rapid traverse (value from { $mp-positioning-feed } or { $mp-analog-positioning-feed }) and with positioning logic. It calculates the touch points from the values entered in the cycle and the set-up clearance in { $mp-set-up }.
step-move-to-measuring-height = The touch probe moves to the measuring height { $q-measuring-height }.
step-probe-outward = The touch probe probes the workpiece at the probing feed rate (column { $mp-probing-feed }). The control derives the probing direction from the starting angle { $q-probing-starting-angle } and the stepping angle { $q-probing-stepping-angle }.
step-probe-outward__tnc426-430 = The touch probe probes the workpiece at the probing feed rate ({ $mp-probing-feed } or { $mp-analog-probing-feed }). The control derives the probing direction from the starting angle { $q-probing-starting-angle } and the stepping angle { $q-probing-stepping-angle }.
step-travel-to-next-touch-point = The touch probe moves to the next touch point:
say-start-again-from-centre = if the pocket and the set-up clearance leave no room for pre-positioning near the touch points, it stays at the centre and does not move to clearance height
say-travel-straight-at-clearance-height = with { $q-traverse-to-clearance-height }=1 and { $q-probing-traverse-type }=0 on a straight line at clearance height { $q-clearance-height }
say-travel-on-circle-at-clearance-height = with { $q-traverse-to-clearance-height }=1 on a circular arc at clearance height { $q-clearance-height }
say-travel-on-circle-at-clearance-height__tnc640 = with { $q-traverse-to-clearance-height }=1 and { $q-probing-traverse-type }=1 on a circular arc at clearance height { $q-clearance-height }
say-travel-on-circle-at-measuring-height = with { $q-traverse-to-clearance-height }=0 on a circular arc at measuring height { $q-measuring-height }
until-all-touch-points-probed = all touch points have been probed

# --- conditions ---
condition-travel-at-clearance-height = the touch probe moves at clearance height ({ $q-traverse-to-clearance-height }=1)
condition-probe-axis-wanted = { $q-probing-in-probe-axis }=1

# --- guards ---
guard-probe-axis-undefined = There is no tool call before the cycle definition, so the touch probe axis is not defined.
guard-transformation-active = Mirroring, scaling or axis-specific scaling is active. None of them may be active during a touch-probe cycle.
guard-basic-rotation-active = A basic rotation is active. This cycle must not be executed with a basic rotation.
guard-stepping-angle-too-small = The stepping angle { $q-probing-stepping-angle } is smaller than 5°.
guard-tolerance-exceeded = A tolerance is exceeded.
guard-tool-broken = The deviation is greater than the breakage tolerance of the tool. The tool is locked.

# --- notes: probing in general ---
note-positioning-logic = Positioning logic: if the south pole of the stylus is below the clearance height { $q-clearance-height }, the control first retracts the touch probe in the probe axis to the clearance height and then positions it in the working plane at the first touch point. If it is above the clearance height, the control first positions the touch probe in the working plane at the first touch point and then moves it in the probe axis directly to the measuring height { $q-measuring-height }.
note-tool-call-before-definition = Before the cycle definition, program a tool call that defines the touch probe axis.
note-no-mirror-or-scaling-while-probing = While touch-probe cycles run, mirroring (cycle 8), scaling (cycle 11) and axis-specific scaling (cycle 26) must not be active.
note-transformations-while-probing = While touch-probe cycles run, no cycle for coordinate transformation may be active: datum shift (7), mirroring (8), rotation (10), scaling (11 and 26), working plane (19).
note-heidenhain-probes-only = The function of the touch-probe cycles is guaranteed only with HEIDENHAIN touch probes.
note-prepare-for-3d-probes = The machine builder must prepare the control for 3-D touch probes. Refer to the machine manual.
note-compensation-data-for-probing = Make sure that the compensation data (length, radius) at the start of the cycle are the ones you intend to use: the calibration data, or the data of the last TOOL CALL block. { $mp-calibration-data-source } selects them.
note-no-contact-within-distance = If the stylus is not deflected within the distance { $mp-probing-distance }, the control shows an error message.
note-set-up-is-pre-position = { $mp-set-up } is the distance from the touch point at which the control pre-positions the touch probe. The smaller it is, the more accurately the touch points must be defined.
note-track-orients-probe = With { $mp-track } = ON the control orients an infrared touch probe in the programmed probing direction before each probing, so that the stylus is always deflected in the same direction; this makes the measurement more accurate. Calibrate the touch probe again after changing { $mp-track }.
note-pre-positioning-speed = { $mp-pre-positioning } selects the speed of pre-positioning: FMAX_PROBE is the feed rate of the column { $mp-positioning-feed }, FMAX_MACHINE the rapid traverse of the machine.
note-multiple-measurement = To make measurements more reliable, the control can carry out each probing up to three times in succession; the machine parameters under { $mp-probe-settings } (probing behaviour, automatic mode) determine how often, and the confidence range. If the measured values differ by more than the confidence range, the control shows an error message, otherwise it stores their mean. Measuring errors caused by dirt, for example, can be detected in this way.
note-multiple-measurement__tnc426-430 = To make measurements more reliable, the control can carry out each probing up to three times in succession; { $mp-multiple-measurement } determines how often, { $mp-confidence-range } the confidence range. If the measured values differ by more than the confidence range, the control shows an error message, otherwise it stores their mean. Measuring errors caused by dirt, for example, can be detected in this way.
note-step-below-90-for-arcs = To measure an arc instead of a full circle, program a stepping angle { $q-probing-stepping-angle } smaller than 90°.
note-smallest-stepping-angle = The smaller the stepping angle { $q-probing-stepping-angle }, the less accurately the control calculates the datum. Smallest input value: 5°.
note-smallest-stepping-angle__measure-hole = The smaller the stepping angle { $q-probing-stepping-angle }, the less accurately the control calculates the dimensions of the hole. Smallest input value: 5°.
note-small-stepping-angle-less-exact = The smaller the stepping angle { $q-probing-stepping-angle }, the less accurately the control calculates the centre.
note-small-stepping-angle-less-exact__datum-inside-circle = The smaller the stepping angle { $q-probing-stepping-angle }, the less accurately the control calculates the datum.
note-results-in-active-system = The control gives all results, in the result parameters and in the log file, in the active coordinate system, which may be shifted, rotated or tilted.
note-results-in-active-system__tnc320 = The control gives all results, in the result parameters and in the log file, in the active coordinate system, which may be shifted or rotated, or both.
note-results-in-active-system__tnc426-430 = The control gives all results, in the result parameters and in the log file, in the active coordinate system, which may be shifted.
note-results-in-q-parameters = The control stores the measured results in the globally effective Q parameters Q150 to Q160; they can be used further in the program.
note-deviations-in-q-parameters = The control stores the measured results in the globally effective Q parameters Q150 to Q160, the deviations from the nominal values in Q161 to Q166. During the cycle definition the help graphic also shows the result parameters; the one highlighted belongs to the selected input parameter.
note-deviations-in-q-parameters__tnc426-430 = The control stores the measured results in the globally effective Q parameters Q150 to Q160, the deviations from the nominal values in Q161 to Q166. During the cycle definition the help graphic also shows the result parameters.

# --- results ---
result-centre-main-actual = Actual value of centre in main axis
result-centre-minor-actual = Actual value of centre in secondary axis
result-diameter-actual = Actual value of diameter
