# Cycles that set a datum, beside that of the hole.

# --- 410 and 411 ---
cycle-datum-inside-rectangle = Datum at centre of rectangular pocket (inside of rectangle)
    .nc = DATUM INSIDE RECTAN.
    .purpose = Measures the centre of a rectangular pocket and sets it as datum. On request the control also writes the centre to a datum table or preset table.
cycle-datum-inside-rectangle__tnc426-430 =
    .purpose = Measures the centre of a rectangular pocket and sets it as datum. On request the control also writes the centre to a datum table.
cycle-datum-outside-rectangle = Datum at centre of rectangular stud (outside of rectangle)
    .nc = DATUM OUTS. RECTAN.
    .purpose = Measures the centre of a rectangular stud and sets it as datum. On request the control also writes the centre to a datum table or preset table.
cycle-datum-outside-rectangle__tnc426-430 =
    .purpose = Measures the centre of a rectangular stud and sets it as datum. On request the control also writes the centre to a datum table.
step-probe-first-point = The touch probe carries out the first probing at the probing feed rate (column { $mp-probing-feed }).
step-probe-first-point__tnc426-430 = The touch probe carries out the first probing at the probing feed rate ({ $mp-probing-feed } or { $mp-analog-probing-feed }).
step-travel-to-second-touch-point = The touch probe moves to the second touch point:
say-travel-linearly-at-clearance-height = with { $q-traverse-to-clearance-height }=1 on a straight line at clearance height { $q-clearance-height }
say-travel-paraxially-at-measuring-height = with { $q-traverse-to-clearance-height }=0 parallel to the axes at measuring height { $q-measuring-height }
step-probe-second-point = The touch probe carries out the second probing there.
step-probe-third-and-fourth-point = The control positions the touch probe at the third touch point and then at the fourth touch point, and carries out the third and fourth probing there.
step-retract-and-treat-datum = The control returns the touch probe to the clearance height { $q-clearance-height } and treats the measured datum according to { $q-measured-value-transfer } and { $q-datum-row-number }:
step-retract-and-treat-datum__tnc426-430 = The control returns the touch probe to the clearance height { $q-clearance-height } and treats the measured datum according to { $q-datum-row-number }:
step-store-actual-values = The control stores the actual values in the result parameters.
note-pocket-sides-rather-small = Danger of collision! To avoid a collision between the touch probe and the workpiece, enter 1st and 2nd side lengths of the pocket that are too small rather than too large.
note-stud-sides-rather-large = Danger of collision! To avoid a collision between the touch probe and the workpiece, enter 1st and 2nd side lengths of the stud that are too large rather than too small.
title-introduction-to-probing = NC block of the introduction to the touch-probe cycles

# --- 413 ---
cycle-datum-outside-circle = Datum at centre of round stud (outside of circle)
    .nc = DATUM OUTSIDE CIRCLE
    .purpose = Measures the centre of a round stud and sets it as datum. On request the control also writes the centre to a datum table or preset table.
cycle-datum-outside-circle__tnc426-430 =
    .purpose = Measures the centre of a round stud and sets it as datum. On request the control also writes the centre to a datum table.
note-stud-diameter-rather-large = Danger of collision! To avoid a collision between the touch probe and the workpiece, enter a nominal diameter of the stud that is too large rather than too small.
note-small-stepping-angle-less-exact__datum-outside-circle = The smaller the stepping angle { $q-probing-stepping-angle }, the less exactly the control calculates the datum.
title-datum-at-arc-centre-and-top = Set the datum at the centre of a circle segment and at the top of the workpiece

# --- results ---
result-side-main-actual = Actual value of side length in main axis
result-side-minor-actual = Actual value of side length in secondary axis
