# Cycles that set a datum, beside that of the hole.

# --- 410 and 411 ---
cycle-datum-inside-rectangle = Datum at centre of rectangular pocket (inside of rectangle)
    .nc = DATUM INSIDE RECTAN.
    .purpose = Measures the centre of a rectangular pocket and sets it as the datum. If desired, the control also writes the centre to a datum table or preset table.
cycle-datum-inside-rectangle__tnc426-430 =
    .purpose = Measures the centre of a rectangular pocket and sets it as the datum. If desired, the control also writes the centre to a datum table.
cycle-datum-outside-rectangle = Datum at centre of rectangular stud (outside of rectangle)
    .nc = DATUM OUTS. RECTAN.
    .purpose = Measures the centre of a rectangular stud and sets it as the datum. If desired, the control also writes the centre to a datum table or preset table.
cycle-datum-outside-rectangle__tnc426-430 =
    .purpose = Measures the centre of a rectangular stud and sets it as the datum. If desired, the control also writes the centre to a datum table.
step-probe-first-point = The touch probe carries out the first probing at the probing feed rate (column { $mp-probing-feed }).
step-probe-first-point__tnc426-430 = The touch probe carries out the first probing at the probing feed rate ({ $mp-probing-feed } or { $mp-analog-probing-feed }).
step-travel-to-second-touch-point = The touch probe moves to the second touch point:
say-travel-linearly-at-clearance-height = with { $q-traverse-to-clearance-height }=1 on a straight line at clearance height { $q-clearance-height }
say-travel-paraxially-at-measuring-height = with { $q-traverse-to-clearance-height }=0 parallel to the axes at measuring height { $q-measuring-height }
step-probe-second-point = The touch probe carries out the second probing there.
step-probe-third-and-fourth-point = The control positions the touch probe at the third touch point and then at the fourth touch point, and carries out the third and fourth probing there.
step-retract-and-treat-datum = The control returns the touch probe to the clearance height { $q-clearance-height } and sets or stores the measured datum as defined in { $q-measured-value-transfer } and { $q-datum-row-number }:
step-retract-and-treat-datum__tnc426-430 = The control returns the touch probe to the clearance height { $q-clearance-height } and sets or stores the measured datum as defined in { $q-datum-row-number }:
step-store-actual-values = The control stores the actual values in the result parameters.
note-pocket-sides-rather-small = Danger of collision! To avoid a collision between the touch probe and the workpiece, enter lengths of the 1st and 2nd side of the pocket that are too small rather than too large.
note-stud-sides-rather-large = Danger of collision! To avoid a collision between the touch probe and the workpiece, enter lengths of the 1st and 2nd side of the stud that are too large rather than too small.
title-introduction-to-probing = Another example

# --- 413 ---
cycle-datum-outside-circle = Datum at centre of round stud (outside of circle)
    .nc = DATUM OUTSIDE CIRCLE
    .purpose = Measures the centre of a round stud and sets it as the datum. If desired, the control also writes the centre to a datum table or preset table.
cycle-datum-outside-circle__tnc426-430 =
    .purpose = Measures the centre of a round stud and sets it as the datum. If desired, the control also writes the centre to a datum table.
note-stud-diameter-rather-large = Danger of collision! To avoid a collision between the touch probe and the workpiece, enter a nominal diameter of the stud that is too large rather than too small.
note-small-stepping-angle-less-exact__datum-outside-circle = The smaller the stepping angle { $q-probing-stepping-angle }, the less accurately the control calculates the datum.
title-datum-at-arc-centre-and-top = Set the datum at the centre of a circle segment and at the top of the workpiece
title-datum-at-arc-centre-and-top__tnc426-430 = Set the datum at the centre of a circle segment

# --- results ---
result-side-main-actual = Actual value of side length in main axis
result-side-minor-actual = Actual value of side length in secondary axis
result-slot-width-actual = Actual value of measured slot width
result-ridge-width-actual = Actual value of measured ridge width
result-centre-axis-actual = Actual value of position of centre line
result-corner-main-actual = Actual value of corner in main axis
result-corner-minor-actual = Actual value of corner in secondary axis

# --- 408 and 409 ---
cycle-datum-slot-centre = Datum at slot centre
    .nc = SLOT CENTER REF PT
    .purpose = Measures the centre of a slot and sets it as the datum. If desired, the control also writes the centre to a datum table or preset table.
cycle-datum-ridge-centre = Datum at ridge centre
    .nc = RIDGE CENTER REF PT
    .purpose = Measures the centre of a ridge and sets it as the datum. If desired, the control also writes the centre to a datum table or preset table.
step-travel-at-clearance-height-to-second = The touch probe moves at clearance height { $q-clearance-height } to the second touch point.
say-start-again-from-centre__datum-slot-centre = if the slot and the set-up clearance leave no room for pre-positioning near the touch points, it stays at the centre and does not move to clearance height
note-slot-width-rather-small = Danger of collision! To avoid a collision between the touch probe and the workpiece, enter a slot width that is too small rather than too large.
note-ridge-width-rather-large = Danger of collision! To avoid a collision between the touch probe and the workpiece, enter a ridge width that is too large rather than too small.
note-probing-from-centre-if-narrow__datum-slot-centre = If the slot width and the set-up clearance do not permit pre-positioning near the touch points, the control always starts probing from the centre of the slot. The touch probe then does not move to clearance height between the two measuring points.
note-feature-content-level-3 = This cycle is a function of the Feature Content Level 3 (FCL 3).

# --- 414 and 415 ---
cycle-datum-outside-corner = Datum at outside of corner
    .nc = DATUM OUTSIDE CORNER
    .purpose = Measures two straight lines from outside and sets their intersection as the datum. If desired, the control also writes the intersection to a datum table or preset table.
cycle-datum-outside-corner__tnc426-430 =
    .purpose = Measures two straight lines from outside and sets their intersection as the datum. If desired, the control also writes the intersection to a datum table.
cycle-datum-inside-corner = Datum at inside of corner
    .nc = DATUM INSIDE CORNER
    .purpose = Measures two straight lines from inside and sets their intersection as the datum. If desired, the control also writes the intersection to a datum table or preset table.
cycle-datum-inside-corner__tnc426-430 =
    .purpose = Measures two straight lines from inside and sets their intersection as the datum. If desired, the control also writes the intersection to a datum table.
step-probe-first-point-by-third-point = The touch probe carries out the first probing at the probing feed rate (column { $mp-probing-feed }). The control derives the probing direction from the programmed third measuring point.
step-probe-first-point-by-third-point__tnc426-430 = The touch probe carries out the first probing at the probing feed rate ({ $mp-probing-feed } or { $mp-analog-probing-feed }). The control derives the probing direction from the programmed third measuring point.
step-probe-first-point-by-corner-number = The touch probe carries out the first probing at the probing feed rate (column { $mp-probing-feed }). The control derives the probing direction from the number of the corner { $q-corner-number }.
step-probe-first-point-by-corner-number__tnc426-430 = The touch probe carries out the first probing at the probing feed rate ({ $mp-probing-feed } or { $mp-analog-probing-feed }). The control derives the probing direction from the number of the corner { $q-corner-number }.
step-retract-and-store-corner = The control returns the touch probe to the clearance height { $q-clearance-height }, stores the coordinates of the measured corner in the result parameters and sets or stores the measured datum as defined in { $q-measured-value-transfer } and { $q-datum-row-number }:
step-retract-and-store-corner__tnc426-430 = The control returns the touch probe to the clearance height { $q-clearance-height } and sets or stores the intersection of the measured lines as the datum, as defined in { $q-datum-row-number }:
step-carry-out-basic-rotation-on-request = With { $q-corner-basic-rotation }=1 the control compensates the misalignment of the workpiece by a basic rotation.
note-corner-from-first-and-third-point = The positions of the measuring points 1 and 3 determine the corner at which the control sets the datum. Corner A: the coordinate of point 1 is greater than that of point 3 in X and smaller in Y. Corner B: smaller in X, smaller in Y. Corner C: smaller in X, greater in Y. Corner D: greater in X, greater in Y.
note-first-line-in-secondary-direction = The control always measures the first line in the direction of the secondary axis of the working plane.
note-basic-rotation-with-immediate-datum = Let the control carry out the basic rotation only if the datum is set at once, not if it is written to the datum table for later machining.
