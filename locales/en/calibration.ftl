# Cycles that calibrate touch probes.

# --- 460 ---
cycle-calibrate-on-sphere = Calibrate touch probe
    .nc = CALIBRATION OF TS ON A SPHERE
    .purpose = Calibrates a touch-trigger 3-D probe automatically on a precise calibration sphere: the radius only, or the radius and the length.
condition-length-calibration-wanted = { $q-length-calibration }=1
step-position-probe-over-sphere = Position the touch probe in the touch probe axis above the calibration sphere, and in the working plane at the centre of the sphere.
step-approach-sphere-downwards = The first movement of the cycle is in the negative direction of the touch probe axis.
step-find-sphere-centre = The control determines the exact centre of the sphere in the touch probe axis.
step-calibrate-radius-on-sphere = The control calibrates the radius by probing { $q-calibration-sphere-probings } points in the plane. Between the measuring points the touch probe moves:
say-travel-at-clearance-height-between-points = with { $q-traverse-to-clearance-height }=1 at clearance height
say-travel-at-measuring-height-between-points = with { $q-traverse-to-clearance-height }=0 at measuring height
step-calibrate-length-on-sphere = After the radius, the control processes the length as defined in { $q-length-calibration }:
say-length-from-sphere-centre = with { $q-length-calibration }=1 it calibrates the length; { $q-length-reference } is the coordinate of the sphere centre
say-length-unchanged = with { $q-length-calibration }=0 it does not calibrate the length
step-store-calibration-values = The control stores the calibration values. They take effect at once.
note-position-above-sphere-in-program = In the program, position the touch probe so that it is approximately above the centre of the sphere.
note-effective-length-reference = The effective length of the touch probe always refers to the tool reference point. As a rule the machine builder places the tool reference point at the spindle nose.
note-when-to-calibrate = Always calibrate the touch probe when it is put into operation, after a stylus has broken or has been exchanged, after a change of the probing feed rate, after unexpected disturbances (when the machine heats up, for example), and after a change of the active tool axis.
note-when-to-calibrate__tnc426-430 = Always calibrate the touch probe when it is put into operation, after a stylus has broken or has been exchanged, after a change of the probing feed rate, and after irregularities (when the machine heats up, for example).
note-known-ring-or-stud = Calibrating determines the effective length of the stylus and the effective radius of the ball tip. For calibrating, clamp a setting ring or a stud of known height and known radius on the machine table.
note-known-ring-or-stud__tnc426-430 = Calibrating determines the effective length of the stylus and the effective radius of the ball tip. For calibrating, place a setting ring of known height and known inside radius on the machine table.
note-calibration-values-at-once = The calibration values take effect for the active touch probe at once after calibrating. The tool need not be called again.
note-calibration-values-in-tables = The control stores the effective length and the effective radius of the touch probe in the tool table, and its centre offset in the columns { $mp-probe-offset-main } (main axis) and { $mp-probe-offset-minor } (secondary axis) of the touch probe table. The soft key for the touch probe table shows the stored values.
note-right-tool-number-for-probe = When a touch probe is used, the right tool number must be active, no matter whether a touch-probe cycle is to run in an automatic mode or manually.

# --- 461 ---
cycle-calibrate-probe-length = Calibrate touch probe length
    .nc = CALIBRATION OF TS LENGTH
    .purpose = Calibrates the effective length of a touch-trigger 3-D probe on a surface of known height, such as a setting ring.
step-prepare-length-calibration = Before the cycle starts, set the datum in the spindle axis so that Z=0 on the machine table, and position the touch probe above the calibration ring.
step-orient-to-calibration-angle = The control orients the touch probe to the angle { $mp-probe-calibration-angle } of the touch probe table, if the touch probe can be oriented.
step-probe-down-from-here = From the present position the control probes in the negative direction of the spindle axis at the probing feed rate (column { $mp-probing-feed }).
step-return-to-start-of-calibration = The control positions the touch probe at rapid traverse (column { $mp-positioning-feed }) back at the starting position.
step-store-probe-length = The control stores the effective length in the tool table.

# --- 462 and 463 ---
cycle-calibrate-in-ring = Calibrate touch probe radius inside
    .nc = CALIBRATION OF TS IN RING
    .purpose = Calibrates the effective radius of the ball tip of a touch-trigger 3-D probe in a calibration ring, and its centre offset if the touch probe permits.
cycle-calibrate-on-stud = Calibrate touch probe radius outside
    .nc = CALIBRATION OF TS ON STUD
    .purpose = Calibrates the effective radius of the ball tip of a touch-trigger 3-D probe on a stud or a calibration pin, and its centre offset if the touch probe permits.
step-pre-position-in-ring = Before the cycle starts, pre-position the touch probe at the centre of the calibration ring and at the desired measuring height.
step-pre-position-over-stud = Before the cycle starts, pre-position the touch probe centrally above the calibration pin, in the touch probe axis about the set-up clearance above it (value of the column { $mp-set-up } + { $q-probing-clearance }).
step-rough-measurement-of-part = In the first run the control determines the centre of the calibration ring (rough measurement) and positions the touch probe at the centre.
step-rough-measurement-of-part__calibrate-on-stud = In the first run the control determines the centre of the stud or calibration pin (rough measurement) and positions the touch probe at the centre.
step-fine-measurement-of-part = Then the calibration proper (fine measurement) determines the radius of the ball tip.
step-travel-between-calibration-points = Between the measuring points the touch probe moves:
step-reverse-measurement = If the touch probe can be oriented in two or in any directions, the control turns it by 180° and carries out four more probings. This measurement also determines the centre offset.
step-store-radius-and-offset = The control stores the effective radius of the ball tip in the column { $mp-tool-radius } of the tool table and the centre offset in the columns { $mp-probe-offset-main } and { $mp-probe-offset-minor } of the touch probe table.
guard-too-few-calibration-points = At least three probings are needed: { $q-calibration-ring-probings } is too small.
guard-too-few-calibration-points__calibrate-on-sphere = At least three probings are needed: { $q-calibration-sphere-probings } is too small.
note-orientation-decides-calibration = The calibration depends on how the touch probe can be oriented. If it cannot be oriented, or in one direction only, the control makes a rough and a fine measurement and determines the effective radius of the ball tip. If it can be oriented in two directions (such as HEIDENHAIN touch probes with cable), the control makes a rough and a fine measurement, turns the touch probe by 180° and carries out four more probings, which determine the centre offset in addition to the radius. If it can be oriented in any direction (such as HEIDENHAIN infrared touch probes), the calibration is the same as with two directions.
note-centre-offset-needs-suitable-probe = The centre offset can only be determined with a suitable touch probe.
note-centre-offset-prepared = The machine builder must have prepared the control for determining the centre offset of the stylus. Refer to the machine manual.
note-orientation-predefined = Whether and how a touch probe can be oriented is predefined for HEIDENHAIN touch probes. Other touch probes are configured by the machine builder.

# --- 2 ---
cycle-calibrate-touch-probe = Calibrate touch-trigger probe
    .nc = CALIBRATE TS
    .purpose = Calibrates a touch-trigger probe automatically in a calibration ring or on a calibration stud.
step-rise-to-clearance-height = The touch probe moves at rapid traverse (value from { $mp-positioning-feed } or { $mp-analog-positioning-feed }) to the clearance height, if its present position is below.
step-position-over-calibration-part = The control positions the touch probe in the working plane:
say-near-first-touch-point = near the first touch point (calibrate outside)
say-at-centre-of-ring = at the centre of the calibration ring (calibrate inside)
step-probe-calibration-part = The touch probe moves to the measuring depth, which results from the machine parameters { $mp-calibration-part-centre }.2 (in other traverse ranges { $mp-calibration-part-centre-2 }.2, { $mp-calibration-part-centre-3 }.2) and { $mp-calibration-part-depth }.x, and probes the calibration part in succession in X+, Y+, X− and Y−.
step-retract-and-store-ball-radius = The control retracts the touch probe to the clearance height and writes the effective radius of the ball tip to the calibration data.
note-calibration-part-centre-known = Before calibrating, define the centre of the calibration part in the working space of the machine in the machine parameters { $mp-calibration-part-centre }.0 to { $mp-calibration-part-centre }.2 (REF coordinates).
note-calibration-part-per-traverse-range = If several traverse ranges are used, a separate data set for the centre of the calibration part can be stored for each of them: { $mp-calibration-part-centre-2 }.0 to { $mp-calibration-part-centre-2 }.2 and { $mp-calibration-part-centre-3 }.0 to { $mp-calibration-part-centre-3 }.2.
note-probe-type-selected = If touch-trigger and analog probes are used alternately, make sure that { $mp-probe-selection } selects the right touch probe. The two must never be connected to the control at the same time. The control cannot detect which touch probe is actually in the machine.
