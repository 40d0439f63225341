# Cycles that determine and compensate a misaligned workpiece.

# --- run, shared ---
step-position-offset-at-first-touch-point = The control positions the touch probe at the first touch point, at rapid traverse (value from the column { $mp-positioning-feed }) and with positioning logic, offset by the set-up clearance opposite to the direction of traverse.
step-position-offset-at-first-touch-point__tnc426-430 = The control positions the touch probe at the first touch point, at rapid traverse (value from { $mp-positioning-feed } or { $mp-analog-positioning-feed }) and with positioning logic, offset by the set-up clearance opposite to the direction of traverse.
step-travel-to-and-probe-second-point = The touch probe moves to the second touch point and carries out the second probing there.
step-retract-and-carry-out-basic-rotation = The control returns the touch probe to the clearance height { $q-clearance-height } and carries out the basic rotation that it has determined.
note-basic-rotation-reset-at-start = The control resets an active basic rotation at the start of the cycle.
note-known-reference-direction = With { $q-reference-line-angle } the control corrects the measured value by a known angle. The basic rotation can thus be measured on any straight line of the workpiece, and the actual 0° direction is set all the same.

# --- 400 ---
cycle-basic-rotation = Basic rotation
    .nc = BASIC ROTATION
    .purpose = Determines the misalignment of a workpiece by measuring two points of a straight edge. The control compensates it by a basic rotation.
step-store-basic-rotation = The control stores the basic rotation:
say-rotation-into-preset-row = with { $q-basic-rotation-row } not 0 in row { $q-basic-rotation-row } of the preset table
say-rotation-into-rot-menu = with { $q-basic-rotation-row }=0 in the ROT menu of the Manual operation mode

# --- 401 and 402 ---
cycle-rotation-two-holes = Basic rotation over two holes
    .nc = ROT OF 2 HOLES
    .purpose = Measures the centres of two holes and calculates the angle between the main axis of the working plane and the line that joins the centres. The control compensates the angle by a basic rotation, or by turning the rotary table.
cycle-rotation-two-holes__tnc426-430 =
    .purpose = Measures the centres of two holes and calculates the angle between the main axis of the working plane and the line that joins the centres. The control compensates the angle by a basic rotation.
cycle-rotation-two-studs = Basic rotation over two studs
    .nc = ROT OF 2 STUDS
    .purpose = Measures the centres of two studs and calculates the angle between the main axis of the working plane and the line that joins the centres. The control compensates the angle by a basic rotation, or by turning the rotary table.
cycle-rotation-two-studs__tnc426-430 =
    .purpose = Measures the centres of two studs and calculates the angle between the main axis of the working plane and the line that joins the centres. The control compensates the angle by a basic rotation.
step-position-at-first-hole = The control positions the touch probe at the programmed centre of the first hole, at rapid traverse (value from the column { $mp-positioning-feed }) and with positioning logic.
step-position-at-first-hole__tnc426-430 = The control positions the touch probe at the programmed centre of the first hole, at rapid traverse (value from { $mp-positioning-feed } or { $mp-analog-positioning-feed }) and with positioning logic.
step-measure-first-hole = The touch probe moves to the measuring height { $q-measuring-height } and determines the centre of the first hole by probing four points.
step-position-at-second-hole = The touch probe returns to the clearance height { $q-clearance-height } and is positioned at the programmed centre of the second hole.
step-measure-second-hole = The touch probe moves to the measuring height { $q-measuring-height } and determines the centre of the second hole by probing four points.
step-position-at-first-stud = The control positions the touch probe at the first touch point of the first stud, at rapid traverse (value from the column { $mp-positioning-feed }) and with positioning logic.
step-position-at-first-stud__tnc426-430 = The control positions the touch probe at the first touch point of the first stud, at rapid traverse (value from { $mp-positioning-feed } or { $mp-analog-positioning-feed }) and with positioning logic.
step-measure-first-stud = The touch probe moves to the measuring height { $q-measuring-height } and determines the centre of the first stud by probing four points. Between the touch points, which are 90° apart, it moves on a circular arc: with { $q-traverse-to-clearance-height }=0 at measuring height, with { $q-traverse-to-clearance-height }=1 at clearance height.
step-measure-first-stud__tnc426-430 = The touch probe moves to the measuring height { $q-measuring-height } and determines the centre of the first stud by probing four points. Between the touch points it moves with { $q-traverse-to-clearance-height }=0 at measuring height, with { $q-traverse-to-clearance-height }=1 at clearance height.
step-position-at-second-stud = The touch probe returns to the clearance height { $q-clearance-height } and is positioned at the first touch point of the second stud.
step-measure-second-stud = The touch probe moves to the measuring height { $q-second-measuring-height } and determines the centre of the second stud by probing four points.
step-compensate-as-chosen = The control compensates the misalignment as chosen with { $q-misalignment-compensation }:
say-rotation-into-preset-row-if-chosen = with { $q-misalignment-compensation }=0 and { $q-basic-rotation-row } not 0 it stores the basic rotation in row { $q-basic-rotation-row } of the preset table
say-rotation-into-rot-menu-if-chosen = with { $q-misalignment-compensation }=0 and { $q-basic-rotation-row }=0 it stores the basic rotation in the ROT menu of the Manual operation mode
say-turn-rotary-table = with { $q-misalignment-compensation }=1 it turns the rotary table instead of storing a basic rotation; with { $q-zero-after-alignment }=1 it then sets the display of the rotary axis to 0
note-rotary-axis-by-tool-axis = To compensate the misalignment by turning the rotary table, the control automatically uses these rotary axes: C with tool axis Z, B with tool axis Y, A with tool axis X.
note-no-tilting-with-this-cycle = This cycle is not permitted while the working plane is tilted.
title-rotation-from-two-holes = Determine a basic rotation from two holes

# --- 403 ---
cycle-rotation-by-rotary-axis = Basic rotation compensated by a rotary axis
    .nc = ROT IN ROTARY AXIS
    .purpose = Determines the misalignment of a workpiece by measuring two points of a straight edge. The control compensates it by turning the A, B or C axis. The workpiece may be clamped anywhere on the rotary table.
step-retract-and-turn-rotary-axis = The control returns the touch probe to the clearance height { $q-clearance-height } and turns the rotary axis { $q-compensation-axis } by the calculated value. It also stores the angle in the result parameter. If selected, it sets the display to 0 after the alignment.
step-retract-and-turn-rotary-axis__tnc426-430 = The control returns the touch probe to the clearance height { $q-clearance-height } and turns the rotary axis { $q-compensation-axis } by the calculated value.
note-compensation-may-be-turned-180 = Danger of collision! The control only checks roughly whether the touch points and the compensating axis make sense together. Compensating movements may therefore be turned by 180°.
note-compensation-axis-combinations = Permitted combinations of the measuring axis { $q-measuring-axis } and the compensating axis { $q-compensation-axis }. Touch probe axis Z: 1 with 6, 2 with 6, 3 with 5 or 4. Touch probe axis Y: 1 with 5, 2 with 5, 3 with 6 or 4. Touch probe axis X: 1 with 4, 2 with 4, 3 with 5 or 6.
note-only-without-tilting = Use this cycle only while the function for tilting the working plane is not active.

# --- 404 ---
cycle-set-basic-rotation = Set basic rotation
    .nc = SET BASIC ROTATION
    .purpose = Sets any basic rotation automatically during program run. Intended above all for resetting a basic rotation that was carried out before.
step-set-basic-rotation = The control sets the basic rotation to the angle { $q-basic-rotation-angle }.
note-available-from-nc-software = Available from NC software 280 474-xx.

# --- 405 ---
cycle-rotation-by-c-axis = Workpiece misalignment compensated by the C-axis
    .nc = ROT IN C AXIS
    .purpose = Determines the angular offset between the positive Y axis of the active coordinate system and the centre line of a hole, or between the nominal position and the actual position of a hole centre. The control compensates it by turning the C-axis. The workpiece may be clamped anywhere on the rotary table.
say-travel-on-circle-at-clearance-height__rotation-by-c-axis = with { $q-traverse-to-clearance-height }=1 on a circular arc at clearance height { $q-clearance-height }
step-move-to-measured-centre = The control positions the touch probe at the measured centre of the hole.
step-retract-and-turn-to-y-axis = The control returns the touch probe to the clearance height { $q-clearance-height } and aligns the workpiece by turning the rotary table: after the compensation, with both a vertical and a horizontal touch probe axis, the hole centre lies in the direction of the positive Y axis ({ $q-probing-centre-minor }=0) or at its nominal position. The measured angular offset is also stored in the result parameter.
step-store-angular-offset = The control processes the angular offset as defined in { $q-zero-or-row-after-alignment }:
say-zero-display-of-c-axis = with { $q-zero-or-row-after-alignment }=0 it sets the display of the C-axis to 0
say-offset-into-column-c = with { $q-zero-or-row-after-alignment } greater than 0 it writes the angular offset, with its sign, to column C of row { $q-zero-or-row-after-alignment } of the datum table; it is added to an offset of C that the row already has
note-smallest-stepping-angle__rotation-by-c-axis = The smaller the stepping angle { $q-probing-stepping-angle }, the less accurately the control calculates the centre of the circle. Smallest input value: 5°.
note-hole-with-positive-y = The Y coordinate of the hole must be positive.
note-repeat-with-horizontal-probe = If the angular offset of the hole is measured with touch probe axis Y (horizontal hole), it may be necessary to execute the cycle several times: the measuring method causes an inaccuracy of about 1% of the misalignment.

# --- results ---
result-alignment-angle-determined = Angle determined
result-angular-offset-measured = Measured angular offset
