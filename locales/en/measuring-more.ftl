# Cycles that measure angles, studs, rectangles, widths, coordinates, bolt-hole circles and planes.

# --- what several of them share ---
step-probe-first-point-at-measuring-height = The touch probe moves to the measuring height { $q-measuring-height } and carries out the first probing at the probing feed rate (column { $mp-probing-feed }).
step-probe-first-point-at-measuring-height__tnc426-430 = The touch probe moves to the measuring height { $q-measuring-height } and carries out the first probing at the probing feed rate ({ $mp-probing-feed } or { $mp-analog-probing-feed }).
step-travel-to-second-touch-point = The touch probe moves to the second touch point:
say-travel-linearly-at-clearance-height = with { $q-traverse-to-clearance-height }=1 in a straight line at clearance height { $q-clearance-height }
say-travel-paraxially-at-measuring-height = with { $q-traverse-to-clearance-height }=0 parallel to the axes at measuring height { $q-measuring-height }
step-probe-second-point = At the second touch point the touch probe carries out the second probing.
step-probe-third-and-fourth-point = In the same way the control positions the touch probe at the third and then at the fourth touch point, and carries out the third and the fourth probing there.
say-part-is-scrap = scrap (Q182=1) if a measured value is out of tolerance and cannot be mended
say-part-needs-rework = rework (Q181=1) if a measured value is out of tolerance and can be mended

# --- 422 ---
cycle-measure-stud = Measure circle outside
    .nc = MEAS. CIRCLE OUTSIDE
    .purpose = Measures the centre and the diameter of a circular stud. If tolerances are defined in the cycle, the control compares nominal and actual values and stores the deviations in parameters.
say-part-is-scrap__measure-stud = scrap (Q182=1) if the stud is smaller than { $q-stud-least-diameter }, or its centre deviates by more than { $q-centre-tolerance-main } or { $q-centre-tolerance-minor }
say-part-needs-rework__measure-stud = rework (Q181=1) if the stud is larger than { $q-stud-greatest-diameter }
note-smallest-stepping-angle__measure-stud = The smaller the stepping angle { $q-probing-stepping-angle }, the less exactly the control calculates the dimensions of the stud. Smallest input value: 5°.

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
result-first-side-length-actual = Actual value of side length in main axis
result-second-side-length-actual = Actual value of side length in secondary axis
result-first-side-length-deviation = Deviation of side length in main axis
result-second-side-length-deviation = Deviation of side length in secondary axis
title-measure-and-rework-rectangular-stud = Measure a rectangular stud and finish it with the measured values
title-measure-rectangular-pocket-with-log = Measure a rectangular pocket and record the results
