# Parameters of the workpiece touch-probe cycles: name, label in the NC block, help.

# --- old form ---
parameter-result-parameter = Parameter number for result
    .help = Number of the Q parameter to which the coordinate is assigned.
parameter-probing-direction = Probing axis / probing direction
    .help = Probing axis, entered with the axis key or the alphabetic keyboard, and the sign of the probing direction. Confirm with ENT.
parameter-probing-position = Position value
    .help = All coordinates for pre-positioning the touch probe, entered with the axis keys or the alphabetic keyboard. Finish the entry with the key ENT.
parameter-probing-position__tnc640 =
    .help = All coordinates for pre-positioning the touch probe, entered with the axis keys or the alphabetic keyboard. Finish the entry with the key END.

# --- the feature ---
parameter-probing-centre-main = Centre in 1st axis
    .label = CENTER IN 1ST AXIS
    .help = Centre of the hole in the main axis of the working plane.
parameter-probing-centre-main__datum-inside-circle =
    .help = Centre of the pocket in the main axis of the working plane.
parameter-probing-centre-minor = Centre in 2nd axis
    .label = CENTER IN 2ND AXIS
    .help = Centre of the hole in the secondary axis of the working plane.
parameter-probing-centre-minor__datum-inside-circle =
    .help = Centre of the pocket in the secondary axis of the working plane.
parameter-probing-nominal-diameter = Nominal diameter
    .label = NOMINAL DIAMETER
    .help = Diameter of the hole.
parameter-probing-nominal-diameter__datum-inside-circle =
    .help = Approximate diameter of the circular pocket (hole). Enter a value that is too small rather than too large.
parameter-probing-starting-angle = Starting angle
    .label = STARTING ANGLE
    .help = Angle between the main axis of the working plane and the first touch point.
parameter-probing-stepping-angle = Stepping angle
    .label = STEPPING ANGLE
    .help = Angle between two measuring points. The sign of the stepping angle determines the direction of rotation in which the touch probe moves to the next measuring point (negative: clockwise). To probe an arc instead of a full circle, program a stepping angle smaller than 90°.

# --- probing ---
parameter-measuring-height = Measuring height in the touch probe axis
    .label = MEASURING HEIGHT
    .help = Coordinate of the ball centre (touch point) in the touch probe axis in which the measurement is made.
parameter-probing-clearance = Set-up clearance
    .label = SET-UP CLEARANCE
    .help = Additional distance between the measuring point and the ball tip. It is added to { $mp-set-up }.
parameter-clearance-height = Clearance height
    .label = CLEARANCE HEIGHT
    .help = Coordinate in the touch probe axis at which the touch probe and the workpiece (or its clamping) cannot collide.
parameter-clearance-height__probing-3d =
    .help = Coordinate in the tool axis at which the touch probe and the workpiece (or its clamping) cannot collide.
parameter-traverse-to-clearance-height = Traversing to clearance height
    .label = MOVE TO CLEARANCE
    .help = How the touch probe moves between the measuring points.
choice-travel-at-measuring-height = move at measuring height between the measuring points
choice-travel-at-measuring-height__tnc426-430 = move on a circular arc at measuring height between the measuring points
choice-travel-at-clearance-height = move at clearance height between the measuring points
choice-travel-at-clearance-height__tnc426-430 = move on a circular arc at clearance height between the measuring points
parameter-number-of-touch-points = Number of measuring points (4/3)
    .label = NO. OF PROBE POINTS
    .help = Whether the hole is measured with four or three probings.
choice-four-touch-points = use four measuring points (standard setting)
choice-three-touch-points = use three measuring points
parameter-probing-traverse-type = Type of traverse? Line=0/circle=1
    .prompt = Type of traverse? Line=0/circle=1
    .label = TYPE OF TRAVERSE
    .prompt = Type of traverse? Line=0/circle=1
    .help = The path on which the touch probe moves between the measuring points if it moves at clearance height ({ $q-traverse-to-clearance-height }=1).
choice-traverse-straight = move on a straight line
choice-traverse-on-circle = move on an arc of the pitch circle diameter

# --- the datum ---
parameter-datum-row-number = Datum number in table
    .label = NO. IN TABLE
    .help = Number in the datum table or preset table under which the coordinates of the pocket centre are stored. With 0 the control sets the display so that the new datum is at the pocket centre.
parameter-datum-row-number__tnc426-430 =
    .help = Number in the datum table under which the coordinates of the pocket centre are stored. With 0 the control sets the display so that the new datum is at the pocket centre.
parameter-new-datum-main = New datum in the main axis
    .label = DATUM
    .help = Coordinate in the main axis to which the measured pocket centre is set. Basic setting: 0.
parameter-new-datum-minor = New datum in the secondary axis
    .label = DATUM
    .help = Coordinate in the secondary axis to which the measured pocket centre is set. Basic setting: 0.
parameter-measured-value-transfer = Measured-value transfer (0,1)
    .label = MEAS. VALUE TRANSFER
    .help = Whether the measured datum is stored in the datum table or in the preset table.
choice-transfer-from-old-program = do not use; the control enters this value when old programs are read in
choice-transfer-to-datum-table = write the measured datum to the active datum table; the reference system is the active workpiece coordinate system
choice-transfer-to-preset-table = write the measured datum to the preset table; the reference system is the machine coordinate system (REF system)
parameter-probing-in-probe-axis = Probing in the touch probe axis
    .label = PROBE IN TS AXIS
    .help = Whether the datum is also set in the touch probe axis.
choice-no-datum-in-probe-axis = do not set the datum in the touch probe axis
choice-datum-in-probe-axis = set the datum in the touch probe axis
parameter-probe-axis-point-main = Probing in the touch probe axis: coordinate in 1st axis
    .label = 1ST CO. FOR TS AXIS
    .help = Coordinate in the main axis of the working plane of the point at which the datum is set in the touch probe axis.
parameter-probe-axis-point-minor = Probing in the touch probe axis: coordinate in 2nd axis
    .label = 2ND CO. FOR TS AXIS
    .help = Coordinate in the secondary axis of the working plane of the point at which the datum is set in the touch probe axis.
parameter-probe-axis-point-tool = Probing in the touch probe axis: coordinate in 3rd axis
    .label = 3RD CO. FOR TS AXIS
    .help = Coordinate in the touch probe axis of the point at which the datum is set in the touch probe axis.
parameter-new-datum-probe-axis = New datum in the touch probe axis
    .label = DATUM
    .help = Coordinate in the touch probe axis to which the datum is set. Basic setting: 0.

# --- limits and reports ---
parameter-hole-greatest-diameter = Maximum limit of hole
    .label = MAXIMUM LIMIT
    .help = Greatest diameter permitted for the hole (circular pocket).
parameter-hole-least-diameter = Minimum limit of hole
    .label = MINIMUM LIMIT
    .help = Least diameter permitted for the hole (circular pocket).
parameter-centre-tolerance-main = Tolerance for centre in 1st axis
    .label = TOLERANCE 1ST CENTER
    .help = Permitted deviation of the position in the main axis of the working plane.
parameter-centre-tolerance-minor = Tolerance for centre in 2nd axis
    .label = TOLERANCE 2ND CENTER
    .help = Permitted deviation of the position in the secondary axis of the working plane.
parameter-measuring-log = Measuring log
    .label = MEASURING LOG
    .help = Whether the control makes a measuring log.
choice-no-measuring-log = make no measuring log
choice-measuring-log-to-file = make a measuring log: the control stores the log file TCHPR{ $cycle }.TXT in the directory TNC:\ as standard
choice-measuring-log-to-file__tnc426-430 = make a measuring log: the control stores the log file TCHPR{ $cycle }.TXT in the directory of the measuring program as standard
choice-measuring-log-on-screen = interrupt the program run and show the measuring log on the screen; continue the program with NC start
parameter-stop-on-tolerance-error = Program stop on tolerance error
    .label = PGM STOP IF ERROR
    .help = Whether the control interrupts the program run and shows an error message when a tolerance is exceeded.
choice-no-stop-on-tolerance-error = do not interrupt the program run, show no error message
choice-stop-on-tolerance-error = interrupt the program run, show an error message
parameter-monitored-tool = Tool for monitoring
    .label = TOOL
    .help = Whether the control monitors a tool. The number or the name of the tool.
parameter-monitored-tool__tnc320 = Tool number for monitoring
    .label = TOOL NUMBER
    .help = Whether the control monitors a tool. The number of the tool.
parameter-monitored-tool__tnc426-430 = Tool number for monitoring
    .label = TOOL NUMBER
    .help = Whether the control monitors a tool. The number of the tool.
choice-no-tool-monitoring = monitoring not active
choice-monitored-tool-number = tool number in the tool table TOOL.T

# --- a point on a surface ---
parameter-surface-point-main = 1st measuring point in 1st axis
    .label = 1ST POINT 1ST AXIS
    .prompt = 1st measuring point in 1st axis?
    .help = Nominal coordinate of the touch point in the main axis of the working plane.
parameter-surface-point-minor = 1st measuring point in 2nd axis
    .label = 1ST POINT 2ND AXIS
    .prompt = 1st measuring point in 2nd axis?
    .help = Nominal coordinate of the touch point in the secondary axis of the working plane.
parameter-surface-point-tool = 1st measuring point in 3rd axis
    .label = 1ST POINT 3RD AXIS
    .prompt = 1st measuring point in 3rd axis?
    .help = Nominal coordinate of the touch point in the touch probe axis.
parameter-surface-normal-main = Surface normal in the main axis
    .label = NORMAL IN MAIN AXIS
    .prompt = Surface normal in the main axis?
    .help = Component of the surface normal in the main axis. The normal of a point usually comes from a CAD/CAM system.
parameter-surface-normal-minor = Surface normal in the secondary axis
    .label = NORMAL IN 2ND AXIS
    .prompt = Surface normal in the secondary axis?
    .help = Component of the surface normal in the secondary axis. The normal of a point usually comes from a CAD/CAM system.
parameter-surface-normal-tool = Surface normal in the tool axis
    .label = NORMAL IN TOOL AXIS
    .prompt = Surface normal in the tool axis?
    .help = Component of the surface normal in the tool axis. The normal of a point usually comes from a CAD/CAM system.
parameter-tolerance-specification = Tolerance specification
    .label = TOLERANCE
    .prompt = Tolerance specification?
    .help = Tolerance band that the cycle monitors: the permitted deviation of the actual from the nominal coordinates along the surface normal ({ $q-surface-normal-main }, { $q-surface-normal-minor }, { $q-surface-normal-tool }). It is divided among the axes according to the normal vector.
parameter-tolerance-error-reaction = Reaction to tolerance error
    .label = ERROR REACTION
    .prompt = Reaction to tolerance error?
    .help = Whether the control interrupts the program run and shows a message when the point deviates.
choice-reaction-none = if the tolerance is exceeded, the program run is not interrupted and no message is shown
choice-reaction-stop = if the tolerance is exceeded, the program run is interrupted
choice-reaction-stop-below-nominal = if the actual position along the surface normal lies below the nominal coordinate, the control shows a message and interrupts the program; if it lies above, there is no reaction
