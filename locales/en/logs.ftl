# Words of the measuring logs.

# --- log of cycle 421 ---
log-hole-title = Measuring log for touch-probe cycle { $cycle }: measure hole
log-date = Date:
log-time = Time:
log-program = Measuring program:
log-nominal-values = Nominal values:
log-limits = Specified limits:
log-actual-values = Actual values:
log-deviations = Deviations:
log-centre-main = Centre in main axis:
log-centre-minor = Centre in secondary axis:
log-diameter = Diameter:
log-centre-main-greatest = Maximum limit of centre in main axis:
log-centre-main-least = Minimum limit of centre in main axis:
log-centre-minor-greatest = Maximum limit of centre in secondary axis:
log-centre-minor-least = Minimum limit of centre in secondary axis:
log-hole-greatest = Maximum limit of hole:
log-hole-least = Minimum limit of hole:
log-further-results = Further measuring results:
log-measuring-height = Measuring height:
log-end = End of measuring log

# --- logs of the other measuring cycles ---
log-angle-title = Measuring log for touch-probe cycle { $cycle }: measure angle
log-stud-title = Measuring log for touch-probe cycle { $cycle }: measure circle outside
log-pocket-title = Measuring log for touch-probe cycle { $cycle }: measure rectangle inside
log-rectangular-stud-title = Measuring log for touch-probe cycle { $cycle }: measure rectangle outside
log-slot-title = Measuring log for touch-probe cycle { $cycle }: measure inside width
log-ridge-title = Measuring log for touch-probe cycle { $cycle }: measure ridge outside
log-coordinate-title = Measuring log for touch-probe cycle { $cycle }: measure coordinate
log-bolt-circle-title = Measuring log for touch-probe cycle { $cycle }: measure bolt-hole circle
log-plane-title = Measuring log for touch-probe cycle { $cycle }: measure plane
log-stud-greatest = Maximum limit of stud:
log-stud-least = Minimum limit of stud:
log-side-main = Side length in main axis:
log-side-minor = Side length in secondary axis:
log-side-main-greatest = Maximum limit of side length in main axis:
log-side-main-least = Minimum limit of side length in main axis:
log-side-minor-greatest = Maximum limit of side length in secondary axis:
log-side-minor-least = Minimum limit of side length in secondary axis:
log-greatest = Maximum limit:
log-least = Minimum limit:
log-length = Length:
log-centre-line = Position of centre line:
log-angle = Angle:
log-coordinate = Coordinate:
log-bolt-circle-diameter = Bolt-hole circle diameter:
log-plane-angle-a = Projection angle of the A-axis:
log-plane-angle-a__tnc426-430 = Angle of the A-axis:
log-plane-angle-b = Projection angle of the B-axis:
log-plane-angle-b__tnc426-430 = Angle of the B-axis:
log-spatial-angle-a = Spatial angle A:
log-spatial-angle-b = Spatial angle B:
log-spatial-angle-c = Spatial angle C:
log-first-in-probe-axis = Measured value in the touch probe axis (first measurement):
log-first-in-probe-axis__tnc320 = Measured value in the touch probe axis:
log-second-in-probe-axis = Measured value in the touch probe axis (second measurement):
log-third-in-probe-axis = Measured value in the touch probe axis (third measurement):

# --- log of cycle 444 ---
log-surface-title = Measuring log for touch-probe cycle { $cycle }: probing in 3-D
log-main-axis = Main axis
log-minor-axis = Secondary axis
log-tool-axis = Tool axis
log-probing-direction = Actual probing direction
log-nominal-coordinate = Nominal coordinate
log-actual-coordinate = Actual coordinate
log-upper-deviation = Upper deviation
log-lower-deviation = Lower deviation
log-deviation-along-normal = Deviation along the normal vector
log-deviation-3d = 3-D deviation
log-workpiece-status = Workpiece status
log-status-undefined = not defined
log-status-good = good
log-status-rework = rework
log-status-scrap = scrap

# --- kinematics ---
log-kinematics-memory-title = Log of touch-probe cycle { $cycle }: save kinematics
log-measure-kinematics-title = Measuring log for touch-probe cycle { $cycle }: measure kinematics
log-preset-compensation-title = Measuring log for touch-probe cycle { $cycle }: preset compensation
log-mode = Mode:
log-kinematics = Active kinematics:
log-memory = Memory:
log-memories = Saved kinematics:
log-kinematics-saved = Saved axes and transformations:
log-kinematics-before = Transformations before restoring:
log-kinematics-after = Transformations after restoring:
log-rotary-axis = Rotary axis
log-centre-of-axis = centre
log-direction-of-axis = inclination
log-preset-shift = Preset shift:
log-sphere-radius = Sphere radius entered:
log-start-angle = Start angle:
log-end-angle = End angle:
log-incidence-angle = Angle of incidence:
log-measuring-points = Number of measuring points:
log-scatter-measured = Scatter measured:
log-scatter-optimized = Scatter optimized:
log-greatest-error = Greatest error:
log-angular-error = Angular error:
log-mean-backlash = Mean backlash:
log-mean-positioning-error = Mean positioning error:
log-measuring-circle = Radius of the measuring circle:
log-compensation = Compensation values:
log-rating = Rating of the measuring points:
log-uncertainty = Measuring uncertainty (degrees per µm):

# --- masks of formatted output (FN 16): how the keywords of a control name this language ---
log-mask-language = English
