# Parameters of the cycles that measure angles, studs, rectangles, widths, coordinates, bolt-hole circles and planes.

# --- 422 ---
parameter-probing-centre-main__measure-stud =
    .help = Centre of the stud in the main axis of the working plane.
parameter-probing-centre-minor__measure-stud =
    .help = Centre of the stud in the secondary axis of the working plane.
parameter-probing-nominal-diameter__measure-stud =
    .help = Diameter of the stud.
parameter-number-of-touch-points__measure-stud =
    .help = Defines whether the stud is measured by probing four or three points.
parameter-stud-greatest-diameter = Maximum limit of stud
    .label = MAXIMUM LIMIT
    .help = Greatest diameter permitted for the stud.
parameter-stud-least-diameter = Minimum limit of stud
    .label = MINIMUM LIMIT
    .help = Least diameter permitted for the stud.

# --- 423, 424 ---
parameter-probing-centre-main__measure-rectangular-pocket =
    .help = Centre of the pocket in the main axis of the working plane.
parameter-probing-centre-minor__measure-rectangular-pocket =
    .help = Centre of the pocket in the secondary axis of the working plane.
parameter-probing-centre-main__measure-rectangular-stud =
    .help = Centre of the stud in the main axis of the working plane.
parameter-probing-centre-minor__measure-rectangular-stud =
    .help = Centre of the stud in the secondary axis of the working plane.
parameter-probing-first-side-length = First side length
    .label = FIRST SIDE LENGTH
    .help = Length of the pocket, parallel to the main axis of the working plane.
parameter-probing-first-side-length__measure-rectangular-stud =
    .help = Length of the stud, parallel to the main axis of the working plane.
parameter-probing-second-side-length = Second side length
    .label = 2ND SIDE LENGTH
    .help = Length of the pocket, parallel to the secondary axis of the working plane.
parameter-probing-second-side-length__measure-rectangular-stud =
    .help = Length of the stud, parallel to the secondary axis of the working plane.
parameter-first-side-greatest-length = Maximum limit of first side length
    .label = MAX. LIMIT 1ST SIDE
    .help = Greatest length permitted for the pocket.
parameter-first-side-greatest-length__measure-rectangular-stud =
    .help = Greatest length permitted for the stud.
parameter-first-side-least-length = Minimum limit of first side length
    .label = MIN. LIMIT 1ST SIDE
    .help = Least length permitted for the pocket.
parameter-first-side-least-length__measure-rectangular-stud =
    .help = Least length permitted for the stud.
parameter-second-side-greatest-length = Maximum limit of second side length
    .label = MAX. LIMIT 2ND SIDE
    .help = Greatest width permitted for the pocket.
parameter-second-side-greatest-length__measure-rectangular-stud =
    .help = Greatest width permitted for the stud.
parameter-second-side-least-length = Minimum limit of second side length
    .label = MIN. LIMIT 2ND SIDE
    .help = Least width permitted for the pocket.
parameter-second-side-least-length__measure-rectangular-stud =
    .help = Least width permitted for the stud.

# --- 425, 426 ---
parameter-probing-start-main = Starting point in 1st axis
    .label = STARTNG PNT 1ST AXIS
    .help = Starting point of the probing in the main axis of the working plane.
parameter-probing-start-minor = Starting point in 2nd axis
    .label = STARTNG PNT 2ND AXIS
    .help = Starting point of the probing in the secondary axis of the working plane.
parameter-second-measurement-offset = Offset for 2nd measurement
    .label = OFFS. 2ND MEASUREMNT
    .help = Distance by which the touch probe is displaced before the second measurement. With 0 the control does not displace the touch probe.
parameter-nominal-length = Nominal length
    .label = NOMINAL LENGTH
    .help = Nominal value of the length to be measured.
parameter-greatest-dimension = Maximum limit
    .label = MAXIMUM LIMIT
    .help = Greatest length permitted.
parameter-least-dimension = Minimum limit
    .label = MINIMUM LIMIT
    .help = Least length permitted.
parameter-probing-clearance__measure-slot-width =
    .help = Additional distance between the measuring point and the ball tip. It is added to { $mp-set-up } and acts only when the datum in the touch probe axis is probed.

# --- 427 ---
parameter-measuring-axis__measure-coordinate = Measuring axis (1...3: 1=main axis)
    .help = Axis in which the measurement is made.
parameter-greatest-dimension__measure-coordinate =
    .help = Greatest measured value permitted.
parameter-least-dimension__measure-coordinate =
    .help = Least measured value permitted.

# --- 430 ---
parameter-probing-centre-main__measure-bolt-hole-circle =
    .help = Centre of the bolt-hole circle (nominal value) in the main axis of the working plane.
parameter-probing-centre-minor__measure-bolt-hole-circle =
    .help = Centre of the bolt-hole circle (nominal value) in the secondary axis of the working plane.
parameter-probing-nominal-diameter__measure-bolt-hole-circle =
    .help = Diameter of the bolt-hole circle.
parameter-first-hole-angle = Angle of 1st hole
    .label = ANGLE OF 1ST HOLE
    .help = Angle, in polar coordinates, of the centre of the first hole in the working plane.
parameter-second-hole-angle = Angle of 2nd hole
    .label = ANGLE OF 2ND HOLE
    .help = Angle, in polar coordinates, of the centre of the second hole in the working plane.
parameter-third-hole-angle = Angle of 3rd hole
    .label = ANGLE OF 3RD HOLE
    .help = Angle, in polar coordinates, of the centre of the third hole in the working plane.
parameter-greatest-dimension__measure-bolt-hole-circle =
    .help = Greatest diameter permitted for the bolt-hole circle.
parameter-least-dimension__measure-bolt-hole-circle =
    .help = Least diameter permitted for the bolt-hole circle.
parameter-monitored-tool__measure-bolt-hole-circle =
    .help = Number or name of the tool that the control monitors for breakage, if any.
parameter-monitored-tool__measure-bolt-hole-circle__tnc320 =
    .help = Number of the tool that the control monitors for breakage, if any.
parameter-monitored-tool__measure-bolt-hole-circle__tnc426-430 =
    .help = Number of the tool that the control monitors for breakage, if any.

# --- 420, 431 ---
parameter-first-point-tool = 1st measuring point in 3rd axis
    .label = 1ST POINT 3RD AXIS
    .help = Coordinate of the first touch point in the touch probe axis.
parameter-second-point-tool = 2nd measuring point in 3rd axis
    .label = 2ND POINT 3RD AXIS
    .help = Coordinate of the second touch point in the touch probe axis.
parameter-third-point-tool = 3rd measuring point in 3rd axis
    .label = 3RD POINT 3RD AXIS
    .help = Coordinate of the third touch point in the touch probe axis.
parameter-measuring-axis__measure-angle =
    .help = Axis in which the measurement is made.

# --- 416 ---
parameter-probing-centre-main__datum-bolt-hole-circle =
    .help = Centre of the bolt-hole circle (nominal value) in the main axis of the working plane.
parameter-probing-centre-minor__datum-bolt-hole-circle =
    .help = Centre of the bolt-hole circle (nominal value) in the secondary axis of the working plane.
parameter-probing-nominal-diameter__datum-bolt-hole-circle =
    .help = Approximate diameter of the bolt-hole circle. The smaller the diameter of the holes, the more accurately this diameter must be entered.
parameter-datum-row-number__datum-bolt-hole-circle =
    .help = Number in the datum table or preset table under which the coordinates of the bolt-hole circle centre are stored. With 0 the control sets the display so that the new datum is at the centre of the bolt-hole circle.
parameter-datum-row-number__datum-bolt-hole-circle__tnc426-430 =
    .help = Number in the datum table under which the coordinates of the bolt-hole circle centre are stored. With 0 the control sets the display so that the new datum is at the centre of the bolt-hole circle.
parameter-new-datum-main__datum-bolt-hole-circle =
    .help = Coordinate in the main axis to which the measured centre of the bolt-hole circle is set. Basic setting: 0.
parameter-new-datum-minor__datum-bolt-hole-circle =
    .help = Coordinate in the secondary axis to which the measured centre of the bolt-hole circle is set. Basic setting: 0.
parameter-probing-clearance__datum-bolt-hole-circle =
    .help = Additional distance between the measuring point and the ball tip. It is added to { $mp-set-up } and acts only when the datum in the touch probe axis is probed.

# --- 417 ---
parameter-datum-row-number__datum-probe-axis =
    .help = Number in the datum table or preset table under which the coordinate is stored. With 0 the control sets the display so that the new datum is on the probed surface.
parameter-datum-row-number__datum-probe-axis__tnc426-430 =
    .help = Number in the datum table under which the coordinate is stored. With 0 the control sets the display so that the new datum is on the probed surface.

# --- 418 ---
parameter-third-centre-main = 3rd centre in 1st axis
    .label = 3RD CENTER 1ST AXIS
    .help = Centre of the third hole in the main axis of the working plane.
parameter-third-centre-minor = 3rd centre in 2nd axis
    .label = 3RD CENTER 2ND AXIS
    .help = Centre of the third hole in the secondary axis of the working plane.
parameter-fourth-centre-main = 4th centre in 1st axis
    .label = 4TH CENTER 1ST AXIS
    .help = Centre of the fourth hole in the main axis of the working plane.
parameter-fourth-centre-minor = 4th centre in 2nd axis
    .label = 4TH CENTER 2ND AXIS
    .help = Centre of the fourth hole in the secondary axis of the working plane.
parameter-datum-row-number__datum-four-holes =
    .help = Number in the datum table or preset table under which the coordinates of the intersection of the connecting lines are stored. With 0 the control sets the display so that the new datum is at the intersection of the connecting lines.
parameter-datum-row-number__datum-four-holes__tnc426-430 =
    .help = Number in the datum table under which the coordinates of the intersection of the connecting lines are stored. With 0 the control sets the display so that the new datum is at the intersection of the connecting lines.
parameter-new-datum-main__datum-four-holes =
    .help = Coordinate in the main axis to which the measured intersection of the connecting lines is set. Basic setting: 0.
parameter-new-datum-minor__datum-four-holes =
    .help = Coordinate in the secondary axis to which the measured intersection of the connecting lines is set. Basic setting: 0.

# --- 419 ---
parameter-measuring-axis__datum-one-axis = Measuring axis (1...3: 1=main axis)
    .help = Axis in which the measurement is made.
parameter-datum-row-number__datum-one-axis =
    .help = Number in the datum table or preset table under which the coordinate is stored. With 0 the control sets the display so that the new datum is on the probed surface.
parameter-new-datum-one-axis = New datum
    .label = DATUM
    .help = Coordinate to which the datum is set. Basic setting: 0.

# --- 1, 3 ---
parameter-polar-probing-axis = Probing axis
    .help = Probing axis, entered with the axis key or the alphabetic keyboard. Confirm with ENT.
parameter-polar-probing-axis__measuring =
    .help = Axis in whose direction the probing is carried out. Confirm with ENT.
parameter-polar-probing-axis__measuring__tnc426-430 =
    .help = Main axis of the working plane: X with tool axis Z, Z with tool axis Y, Y with tool axis X. Confirm with ENT.
parameter-polar-probing-angle = Probing angle
    .word = ANGLE:
    .help = Angle referred to the probing axis in which the touch probe moves.
parameter-result-parameter__measuring =
    .help = Number of the Q parameter to which the control assigns the first measured coordinate (X). Y and Z are in the Q parameters that follow.
parameter-greatest-measuring-path = Maximum measuring path
    .word = DIST
    .help = Path by which the touch probe moves from the starting point. Confirm with ENT.
parameter-measuring-feed = Measuring feed rate
    .help = Measuring feed rate in mm/min.
parameter-greatest-retraction-path = Maximum retraction path
    .help = Path opposite to the probing direction after the stylus has been deflected. The control retracts the touch probe at most to the starting point, so that there can be no collision.
parameter-probing-reference-system = Reference system (0=ACT/1=REF)
    .word = REFERENCE SYSTEM:
    .help = Defines whether the probing direction and the result refer to the actual coordinate system (ACT, which may be shifted or rotated) or to the machine coordinate system (REF).
parameter-probing-reference-system__tnc320 =
    .help = Defines whether the result refers to the actual coordinate system (ACT, which may be shifted or rotated) or to the machine coordinate system (REF).
choice-probe-in-actual-system = probe in the actual system and store the result in the ACT system
choice-probe-in-machine-system = probe in the machine system REF and store the result in the REF system
parameter-probing-error-mode = Error mode (0=OFF/1=ON)
    .help = Defines whether the control shows an error message if the stylus is deflected at the start of the cycle. With 1 the control stores −1 in the fourth result parameter and continues the cycle.
parameter-probing-error-mode__tnc320 =
    .help = Defines whether the control shows an error message if the stylus is deflected at the start of the cycle. With 1 the control stores 2.0 in the fourth result parameter and continues the cycle.
choice-show-probing-error = show an error message
choice-probing-error-off = show no error message
