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
