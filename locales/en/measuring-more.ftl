# Cycles that measure angles, studs, rectangles, widths, coordinates, bolt-hole circles and planes.

# --- what several of them share ---
say-part-is-scrap = scrap (Q182=1) if a measured value is out of tolerance and cannot be corrected
say-part-needs-rework = rework (Q181=1) if a measured value is out of tolerance and can be corrected

# --- 422 ---
cycle-measure-stud = Measure circle outside
    .nc = MEAS. CIRCLE OUTSIDE
    .purpose = Measures the centre and the diameter of a circular stud. If tolerances are defined in the cycle, the control compares nominal and actual values and stores the deviations in parameters.
say-part-is-scrap__measure-stud = scrap (Q182=1) if the stud is smaller than { $q-stud-least-diameter }, or its centre deviates by more than { $q-centre-tolerance-main } or { $q-centre-tolerance-minor }
say-part-needs-rework__measure-stud = rework (Q181=1) if the stud is larger than { $q-stud-greatest-diameter }
note-smallest-stepping-angle__measure-stud = The smaller the stepping angle { $q-probing-stepping-angle }, the less accurately the control calculates the dimensions of the stud. Smallest input value: 5°.

# --- 423, 424 ---
cycle-measure-rectangular-pocket = Measure rectangle inside
    .nc = MEAS. RECTAN. INSIDE
    .purpose = Measures the centre, the length and the width of a rectangular pocket. If tolerances are defined in the cycle, the control compares nominal and actual values and stores the deviations in parameters.
cycle-measure-rectangular-stud = Measure rectangle outside
    .nc = MEAS. RECTAN. OUTS.
    .purpose = Measures the centre, the length and the width of a rectangular stud. If tolerances are defined in the cycle, the control compares nominal and actual values and stores the deviations in parameters.
say-part-is-scrap__measure-rectangular-pocket = scrap (Q182=1) if a side is longer than { $q-first-side-greatest-length } or { $q-second-side-greatest-length }, or the centre deviates by more than { $q-centre-tolerance-main } or { $q-centre-tolerance-minor }
say-part-needs-rework__measure-rectangular-pocket = rework (Q181=1) if a side is shorter than { $q-first-side-least-length } or { $q-second-side-least-length }
say-part-is-scrap__measure-rectangular-stud = scrap (Q182=1) if a side is shorter than { $q-first-side-least-length } or { $q-second-side-least-length }, or the centre deviates by more than { $q-centre-tolerance-main } or { $q-centre-tolerance-minor }
say-part-needs-rework__measure-rectangular-stud = rework (Q181=1) if a side is longer than { $q-first-side-greatest-length } or { $q-second-side-greatest-length }
result-side-main-deviation = Deviation of side length in main axis
result-side-minor-deviation = Deviation of side length in secondary axis
title-measure-and-rework-rectangular-stud = Measure a rectangular stud and finish it with the measured values
title-measure-rectangular-pocket-with-log = Measure a rectangular pocket and record the results

# --- 425, 426 ---
cycle-measure-slot-width = Measure inside width
    .nc = MEASURE INSIDE WIDTH
    .purpose = Measures the position and the width of a slot (pocket). If tolerances are defined in the cycle, the control compares nominal and actual values and stores the deviation in a parameter.
cycle-measure-ridge-width = Measure ridge outside
    .nc = MEASURE RIDGE WIDTH
    .purpose = Measures the position and the width of a ridge. If tolerances are defined in the cycle, the control compares nominal and actual values and stores the deviation in a parameter.
step-probe-first-in-positive-direction = The touch probe carries out the first probing at the probing feed rate (column { $mp-probing-feed }), always in the positive direction of the programmed axis.
step-probe-first-in-positive-direction__tnc426-430 = The touch probe carries out the first probing at the probing feed rate ({ $mp-probing-feed } or { $mp-analog-probing-feed }), always in the positive direction of the programmed axis.
step-probe-first-in-negative-direction = The touch probe carries out the first probing at the probing feed rate (column { $mp-probing-feed }), always in the negative direction of the programmed axis.
step-probe-first-in-negative-direction__tnc426-430 = The touch probe carries out the first probing at the probing feed rate ({ $mp-probing-feed } or { $mp-analog-probing-feed }), always in the negative direction of the programmed axis.
step-probe-second-side-of-slot = The touch probe carries out the second probing as defined in { $q-second-measurement-offset }:
step-probe-second-side-of-slot__tnc640 = With a large nominal length the control moves to the second touch point at rapid traverse. The touch probe carries out the second probing as defined in { $q-second-measurement-offset }:
say-offset-second-measurement = with { $q-second-measurement-offset } not 0 the control moves the touch probe parallel to the axis by this offset to the next touch point and probes there
say-offset-second-measurement__tnc640 = with { $q-second-measurement-offset } not 0 the control moves the touch probe by this offset to the next touch point, with { $q-traverse-to-clearance-height }=1 at clearance height { $q-clearance-height }, and probes there
say-measure-in-opposite-direction = with { $q-second-measurement-offset }=0 it measures the width directly in the opposite direction
step-probe-second-side-of-ridge = The touch probe moves at clearance height { $q-clearance-height } to the next touch point and carries out the second probing there.
say-part-is-scrap__measure-slot-width = scrap (Q182=1) if the slot is wider than { $q-greatest-dimension }
say-part-needs-rework__measure-slot-width = rework (Q181=1) if the slot is narrower than { $q-least-dimension }
say-part-is-scrap__measure-ridge-width = scrap (Q182=1) if the ridge is narrower than { $q-least-dimension }
say-part-needs-rework__measure-ridge-width = rework (Q181=1) if the ridge is wider than { $q-greatest-dimension }
note-clearance-acts-in-probe-axis-only = The set-up clearance { $q-probing-clearance } acts only when the datum in the touch probe axis is probed.
result-measured-length-actual = Actual value of measured length
result-measured-length-deviation = Deviation of measured length

# --- 427 ---
cycle-measure-coordinate = Measure coordinate
    .nc = MEASURE COORDINATE
    .purpose = Measures a coordinate in a selectable axis and stores the value in a parameter. If tolerances are defined in the cycle, the control compares nominal and actual values and stores the deviations in parameters.
step-position-against-traverse-direction = The control positions the touch probe at the programmed touch point, at rapid traverse (value from the column { $mp-positioning-feed }) and with positioning logic, offset by the set-up clearance opposite to the traverse direction { $q-traverse-direction }.
step-position-against-traverse-direction__tnc426-430 = The control positions the touch probe at the programmed touch point, at rapid traverse (value from { $mp-positioning-feed } or { $mp-analog-positioning-feed }) and with positioning logic, offset by the set-up clearance opposite to the traverse direction { $q-traverse-direction }.
step-probe-coordinate = The control positions the touch probe in the working plane at the programmed touch point and measures the actual value in the selected axis there.
step-retract-and-store-measured-coordinate = The control returns the touch probe to the clearance height { $q-clearance-height } and stores the measured coordinate in the result parameter.
say-part-is-scrap__measure-coordinate = scrap (Q182=1) if the measured coordinate is less than { $q-least-dimension }
say-part-needs-rework__measure-coordinate = rework (Q181=1) if the measured coordinate is greater than { $q-greatest-dimension }
say-correct-tool-length = with { $q-monitored-tool } not 0 and { $q-measuring-axis }=3 it corrects the tool length in the column DL of the tool table; if the deviation is greater than the breakage tolerance RBREAK, it shows an error message, stops the program run and locks the tool (column TL = L)
say-correct-tool-radius__measure-coordinate = with { $q-monitored-tool } not 0 and { $q-measuring-axis }=1 or 2 it corrects the delta radius in the column DR of the tool table, in the sense that follows from { $q-traverse-direction }; if the deviation is greater than the breakage tolerance RBREAK, it shows an error message, stops the program run and locks the tool (column TL = L)
note-coordinate-is-outside-dimension = The control assumes that an outside dimension (stud) is measured. In other cases the measuring status can be put right by a suitable choice of the greatest and the least dimension together with the probing direction.
note-coordinate-corrects-radius-or-length = If an axis of the working plane is the measuring axis ({ $q-measuring-axis }=1 or 2), the control corrects the tool radius; the sense of the correction follows from the traverse direction { $q-traverse-direction }. If the touch probe axis is the measuring axis ({ $q-measuring-axis }=3), it corrects the tool length.

# --- 430 ---
cycle-measure-bolt-hole-circle = Measure bolt-hole circle
    .nc = MEAS. BOLT HOLE CIRC
    .purpose = Measures the centre and the diameter of a bolt-hole circle by measuring three of its holes. If tolerances are defined in the cycle, the control compares nominal and actual values and stores the deviations in parameters.
step-measure-centre-of-hole = The touch probe moves to the measuring height { $q-measuring-height } and determines the centre of the hole by probing four points.
step-travel-to-next-hole = The touch probe returns to the clearance height { $q-clearance-height } and is positioned at the entered centre of the next hole.
until-three-holes-measured = the centres of all three holes have been determined
say-part-is-scrap__measure-bolt-hole-circle = scrap (Q182=1) if the diameter is greater than { $q-greatest-dimension } or less than { $q-least-dimension }, or the centre deviates by more than { $q-centre-tolerance-main } or { $q-centre-tolerance-minor }
say-monitor-tool-breakage = with { $q-monitored-tool } not 0 it compares the deviation with the breakage tolerance RBREAK; if the deviation is greater, it shows an error message, stops the program run and locks the tool (column TL = L). It does not correct the tool
note-only-breakage-monitoring = This cycle monitors the tool for breakage only; it does not correct the tool.
result-bolt-circle-diameter-actual = Actual value of bolt-hole circle diameter
result-bolt-circle-diameter-deviation = Deviation of bolt-hole circle diameter

# --- 420 ---
cycle-measure-angle = Measure angle
    .nc = MEASURE ANGLE
    .purpose = Measures the angle between a straight line and the main axis of the working plane.
say-travel-to-point-at-clearance-height = with { $q-traverse-to-clearance-height }=1 at clearance height { $q-clearance-height }
say-travel-to-point-at-measuring-height = with { $q-traverse-to-clearance-height }=0 at measuring height { $q-measuring-height }
step-retract-and-store-angle = The control returns the touch probe to the clearance height { $q-clearance-height } and stores the measured angle in the result parameter.
note-angle-about-a-or-b = If the touch probe axis is the measuring axis ({ $q-measuring-axis }=3): to measure the angle about the A-axis, enter the same value in { $q-first-point-main } and { $q-second-point-main }; to measure the angle about the B-axis, enter different values there.
note-results-shown-in-help-graphic = During the cycle definition the help graphic also shows the result parameters; the one highlighted belongs to the selected input parameter.
note-results-shown-in-help-graphic__tnc426-430 = During the cycle definition the help graphic also shows the result parameters.
result-measured-angle = Measured angle referenced to the main axis of the working plane

# --- 431 ---
cycle-measure-plane = Measure plane
    .nc = MEASURE PLANE
    .purpose = Measures the angles of a plane by measuring three points and stores the values in parameters.
step-measure-first-point-of-plane = The control positions the touch probe at the programmed first touch point, at rapid traverse (value from the column { $mp-positioning-feed }) and with positioning logic, offset by the set-up clearance opposite to the probing direction, and measures the first point of the plane there.
step-measure-first-point-of-plane__tnc426-430 = The control positions the touch probe at the programmed first touch point, at rapid traverse (value from { $mp-positioning-feed } or { $mp-analog-positioning-feed }) and with positioning logic, offset by the set-up clearance opposite to the probing direction, and measures the first point of the plane there.
step-measure-second-point-of-plane = The touch probe returns to the clearance height { $q-clearance-height } and moves in the working plane to the second touch point, where the control measures the actual value of the second point of the plane.
step-measure-third-point-of-plane = The touch probe returns to the clearance height { $q-clearance-height } and moves in the working plane to the third touch point, where the control measures the actual value of the third point of the plane.
step-retract-and-store-plane-angles = The control returns the touch probe to the clearance height { $q-clearance-height } and stores the angles in the result parameters.
guard-points-on-one-line = The three measuring points lie on a straight line. The control cannot calculate the angles of the plane.
note-positioning-logic__measure-plane = Positioning logic: if the south pole of the stylus is below the clearance height { $q-clearance-height }, the control first retracts the touch probe in the probe axis to the clearance height and then positions it in the working plane at the first touch point. If it is above the clearance height, the control first positions the touch probe in the working plane at the first touch point and then moves it in the probe axis directly to the measuring height.
note-three-points-not-on-a-line = The three measuring points must not lie on a straight line; otherwise the control cannot calculate the angles.
note-spatial-angles-for-tilting = The parameters Q170 to Q172 hold the spatial angles that the function for tilting the working plane needs. The first two measuring points determine the direction of the main axis when the working plane is tilted.
note-third-point-sets-tool-axis = The third measuring point determines the direction of the tool axis. Define it in the direction of the positive Y axis, so that the tool axis has the correct orientation in a right-handed coordinate system.
note-spatial-angle-in-tilted-plane = If the cycle is executed with an active tilted working plane, the measured spatial angles refer to the tilted coordinate system. Use them in the function for tilting the working plane as incremental values.
result-projection-angle-a = Projection angle of the A-axis
result-projection-angle-a__tnc426-430 = Angle of the A-axis
result-projection-angle-b = Projection angle of the B-axis
result-projection-angle-b__tnc426-430 = Angle of the B-axis
result-spatial-angle-a = Spatial angle A
result-spatial-angle-b = Spatial angle B
result-spatial-angle-c = Spatial angle C
result-first-value-in-probe-axis = Measured value in the touch probe axis (first measurement)
result-first-value-in-probe-axis__tnc320 = Measured value in the touch probe axis
result-second-value-in-probe-axis = Measured value in the touch probe axis (second measurement)
result-third-value-in-probe-axis = Measured value in the touch probe axis (third measurement)

# --- 1 ---
cycle-polar-reference-plane = Polar reference plane
    .nc = POLAR REF. PLANE
    .purpose = Measures any position of the workpiece in any probing direction, which is given by an angle.
step-probe-at-polar-angle = The touch probe carries out the probing at the probing feed rate (column { $mp-probing-feed }). During the probing the control moves in two axes at the same time, depending on the probing angle. The probing direction is defined in the cycle by a polar angle.
step-probe-at-polar-angle__tnc426-430 = The touch probe carries out the probing at the probing feed rate ({ $mp-probing-feed } or { $mp-analog-probing-feed }). During the probing the control moves in two axes at the same time, depending on the probing angle. The probing direction is defined in the cycle by a polar angle.
step-return-and-store-trigger-position = After the position has been measured, the touch probe returns to the starting point of the probing. The control stores the coordinates of the position at which the touch probe was at the switching signal in the parameters Q115 to Q119.
step-return-and-store-trigger-position__tnc426-430 = After the position has been measured, the touch probe returns to the starting point of the probing. The control stores the coordinates of the ball centre at the contact with the workpiece in the parameters Q115 to Q119.
note-probing-plane-by-axis = The probing axis defined in the cycle determines the probing plane: probing axis X: X/Y plane; Y: Y/Z plane; Z: Z/X plane.
note-trigger-position-of-ball-centre = Q115 to Q119 hold the coordinates of the centre of the ball tip at the contact with the workpiece.

# --- 3 ---
cycle-measuring = Measuring
    .nc = MEASURING
    .purpose = Measures any position of the workpiece in a selectable probing direction. Unlike in the other measuring cycles, the measuring path and the measuring feed rate are entered directly in this cycle, as is the retraction after the measurement. It is intended for special cycles created by the machine builder.
cycle-measuring__tnc426-430 =
    .purpose = Measures any position of the workpiece in a selectable probing direction. Unlike in the other measuring cycles, the measuring feed rate is entered directly in this cycle. It is a measuring cycle for special uses.
step-move-in-polar-direction = The touch probe moves from its present position at the entered feed rate in the programmed probing direction. The probing direction is defined in the cycle by a polar angle.
step-stop-and-store-ball-centre = When the control has measured the position, the touch probe stops. The control stores the coordinates X, Y and Z of the ball centre in three successive Q parameters, without correcting length and radius. The number of the first result parameter is defined in the cycle.
step-stop-and-store-ball-centre__tnc426-430 = When the control has measured the position, the touch probe stops. The control stores the coordinates of the ball centre in three successive Q parameters. The number of the first parameter is defined in the cycle.
result-ball-centre-and-status = Ball centre in X; the next two parameters hold Y and Z, the fourth −1 if there was no valid touch point
result-ball-centre-and-status__tnc426-430 = First coordinate of the ball centre; the next two parameters hold the others
note-probe-data-without-effect = The touch probe data { $mp-probing-distance } (greatest path to the touch point) and { $mp-probing-feed } (probing feed rate), which act in the other measuring cycles, have no effect in this cycle.
note-four-parameters-overwritten = The control always writes four successive Q parameters.
note-no-touch-point-no-error = If the control finds no valid touch point, the program continues without an error message. The control then assigns −1 to the fourth result parameter, so that the program can react to the error.
note-retraction-not-beyond-start = The control retracts the touch probe by the retraction path MB at most, but not beyond the starting point of the measurement. There can therefore be no collision during the retraction.
note-probe-input-by-function = The function FN17: SYSWRITE ID 990 NR 6 determines whether the cycle acts on the probe input X12 or X13.
note-available-from-software-474 = This cycle is available from the NC software 280 474-xx.
note-behaviour-defined-by-builder = The machine builder or the supplier of the software defines how this cycle works in detail; it is used within special touch-probe cycles.
