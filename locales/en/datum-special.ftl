# Datum cycles for bolt-hole circles, for the touch probe axis, for four holes and for one axis.

# --- 416 ---
cycle-datum-bolt-hole-circle = Datum at centre of bolt-hole circle
    .nc = DATUM CIRCLE CENTER
    .purpose = Calculates the centre of a bolt-hole circle by measuring three of its holes and sets it as the datum. If desired, the control also writes the centre to a datum table or preset table.
cycle-datum-bolt-hole-circle__tnc426-430 =
    .purpose = Calculates the centre of a bolt-hole circle by measuring three of its holes and sets it as the datum. If desired, the control also writes the centre to a datum table.
title-datum-at-top-and-bolt-hole-circle = Set the datum at the top of the workpiece and at the centre of a bolt-hole circle
title-top-and-bolt-hole-circle-into-datum-table = Write the top of the workpiece and the centre of a bolt-hole circle to a datum table

# --- 417 ---
cycle-datum-probe-axis = Datum in the touch probe axis
    .nc = DATUM IN TS AXIS
    .purpose = Measures any coordinate in the touch probe axis and sets it as the datum. If desired, the control also writes the measured coordinate to a datum table or preset table.
cycle-datum-probe-axis__tnc426-430 =
    .purpose = Measures any coordinate in the touch probe axis and sets it as the datum. If desired, the control also writes the measured coordinate to a datum table.
step-position-above-touch-point = The control positions the touch probe at the programmed touch point, at rapid traverse (value from the column { $mp-positioning-feed }) and with positioning logic, offset by the set-up clearance in the positive direction of the touch probe axis.
step-position-above-touch-point__tnc426-430 = The control positions the touch probe at the programmed touch point, at rapid traverse (value from { $mp-positioning-feed } or { $mp-analog-positioning-feed }) and with positioning logic, offset by the set-up clearance in the positive direction of the touch probe axis.
step-probe-touch-point-in-probe-axis = The touch probe moves in the touch probe axis to the entered coordinate { $q-first-point-tool } of the touch point and measures the actual position by probing once.
note-datum-set-in-probe-axis = The control sets the datum in the touch probe axis, which the tool call before the cycle defines.
note-positioning-logic__datum-probe-axis = Positioning logic: if the south pole of the stylus is below the clearance height { $q-clearance-height }, the control first retracts the touch probe in the probe axis to the clearance height and then positions it in the working plane at the first touch point. If it is above the clearance height, the control first positions the touch probe in the working plane at the first touch point and then moves it in the probe axis directly to the measuring height.
note-no-transformation-with-probe-axis-datum__datum-probe-axis = If a cycle sets a datum with { $q-measured-value-transfer }=0 and also probes in the touch probe axis (Q381=1), no coordinate transformation may be active.
result-measured-point-actual = Actual value of measured point
title-datum-at-top-and-arc-centre = Set the datum at the top of the workpiece and at the centre of a circle segment

# --- 418 ---
cycle-datum-four-holes = Datum at centre between 4 holes
    .nc = DATUM FROM 4 HOLES
    .purpose = Calculates the intersection of the lines that connect two pairs of hole centres and sets it as the datum. If desired, the control also writes the intersection to a datum table or preset table.
cycle-datum-four-holes__tnc426-430 =
    .purpose = Calculates the intersection of the lines that connect two pairs of hole centres and sets it as the datum. If desired, the control also writes the intersection to a datum table.
step-repeat-for-third-and-fourth-hole = The control repeats the previous two steps for the third and the fourth hole.
step-retract-and-store-intersection = The control returns the touch probe to the clearance height { $q-clearance-height }, calculates the datum as the intersection of the lines between the centres of holes 1 and 3 and of holes 2 and 4, stores the actual values in the result parameters and sets or stores the datum as defined in { $q-measured-value-transfer } and { $q-datum-row-number }:
step-retract-and-store-intersection__tnc426-430 = The control returns the touch probe to the clearance height { $q-clearance-height }, calculates the datum as the intersection of the lines between the centres of holes 1 and 3 and of holes 2 and 4 and processes it as defined in { $q-datum-row-number }:
result-intersection-main-actual = Actual value of intersection in main axis
result-intersection-minor-actual = Actual value of intersection in secondary axis

# --- 419 ---
cycle-datum-one-axis = Datum in one axis
    .nc = DATUM IN ONE AXIS
    .purpose = Measures any coordinate in a selectable axis and sets it as the datum. If desired, the control also writes the measured coordinate to a datum table or preset table.
step-position-against-probing-direction = The control positions the touch probe at the programmed touch point, at rapid traverse (value from the column { $mp-positioning-feed }) and with positioning logic, offset by the set-up clearance opposite to the programmed probing direction { $q-traverse-direction }.
step-move-to-measuring-height-and-probe = The touch probe moves to the measuring height { $q-measuring-height } and measures the actual position by probing once.
step-retract-and-store-datum__datum-one-axis = The control returns the touch probe to the clearance height { $q-clearance-height } and sets or stores the measured datum as defined in { $q-measured-value-transfer } and { $q-datum-row-number }:
note-measuring-axes-by-probe-axis = The axes that { $q-measuring-axis } selects depend on the active touch probe axis ({ $q-measuring-axis }=3): with Z the main axis ({ $q-measuring-axis }=1) is X and the secondary axis ({ $q-measuring-axis }=2) is Y; with Y they are Z and X; with X they are Y and Z.
note-activate-preset-after-each-axis = To store the datum in several axes of the preset table by executing this cycle several times, activate after each execution the preset number to which the cycle last wrote. This is not necessary if the active preset is overwritten.
