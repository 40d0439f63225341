# Cycles that measure angles, studs, rectangles, widths, coordinates, bolt-hole circles and planes.

# --- what several of them share ---
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
result-side-main-deviation = Deviation of side length in main axis
result-side-minor-deviation = Deviation of side length in secondary axis
title-measure-and-rework-rectangular-stud = Measure a rectangular stud and finish it with the measured values
title-measure-rectangular-pocket-with-log = Measure a rectangular pocket and record the results
