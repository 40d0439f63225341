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
