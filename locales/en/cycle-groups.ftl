# Titles of the groups of cycles.
cycle-group-drilling = Drilling
cycle-group-threads = Tapping and thread milling
cycle-group-pockets = Pockets, studs and slots
cycle-group-patterns = Point patterns
cycle-group-contours = Contours and cylinder surfaces
cycle-group-surfaces = Multipass milling of surfaces
cycle-group-transforms = Coordinate transformations
cycle-group-special = Special functions
cycle-group-turning = Turning
cycle-group-rotation = Workpiece misalignment
cycle-group-datum = Datum setting
cycle-group-measuring = Workpiece measurement
cycle-group-calibration = Touch-probe calibration
cycle-group-kinematics = Kinematics measurement
cycle-group-tool-measurement = Tool measurement
cycle-group-digitizing = Digitizing

# Cycles that a manual only names, and that no specification describes.
named-cycl-def-30 = Executing 3-D data
named-cycl-def-39 = Outside contour on a cylinder surface
named-cycl-def-212 = Cycle 212
named-cycl-def-213 = Stud finishing
named-cycl-def-270 = Contour train data
named-cycl-def-275 = Trochoidal contour slot
named-cycl-def-290 = Interpolation turning
named-tch-probe-4 = Measuring in 3-D
named-tch-probe-9 = Calibrating the length of the touch probe
named-tch-probe-440 = Measuring an axis shift
named-tch-probe-441 = Fast probing
