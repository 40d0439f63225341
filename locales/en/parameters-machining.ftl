# Parameters of the machining cycles: name, label in the NC block, help.

# --- heights and depths ---
parameter-set-up-clearance = Set-up clearance
    .label = SET-UP CLEARANCE
    .help = Distance between the tool tip and the workpiece surface.
parameter-set-up-clearance__drilling =
    .help = Distance between the tool tip and the workpiece surface. Enter a positive value.
parameter-set-up-clearance__centring =
    .help = Distance between the tool tip and the workpiece surface. Enter a positive value.
parameter-set-up-clearance__circular-pattern =
    .help = Distance between the tool tip and the workpiece surface. It also applies to the machining cycle that the pattern calls.
parameter-set-up-clearance__rectangular-pocket =
    .help = Distance between the tool tip and the workpiece surface. PREDEF takes the value from the GLOBAL DEF block.
parameter-set-up-clearance__circular-pocket =
    .help = Distance between the tool tip and the workpiece surface. PREDEF takes the value from the GLOBAL DEF block.
parameter-set-up-clearance__slot =
    .help = Distance between the tool tip and the workpiece surface. PREDEF takes the value from the GLOBAL DEF block.
parameter-set-up-clearance__circular-slot =
    .help = Distance between the tool tip and the workpiece surface. PREDEF takes the value from the GLOBAL DEF block.
parameter-set-up-clearance__rectangular-stud =
    .help = Distance between the tool tip and the workpiece surface. PREDEF takes the value from the GLOBAL DEF block.
parameter-set-up-clearance__circular-stud =
    .help = Distance between the tool tip and the workpiece surface. PREDEF takes the value from the GLOBAL DEF block.
parameter-second-set-up-clearance = 2nd set-up clearance
    .label = 2ND SET-UP CLEARANCE
    .help = Height in the spindle axis at which the tool cannot collide with the workpiece or its clamping.
parameter-second-set-up-clearance__circular-pattern =
    .help = Height in the spindle axis at which the tool cannot collide with the workpiece or its clamping. It also applies to the machining cycle that the pattern calls.
parameter-second-set-up-clearance__rectangular-pocket =
    .help = Height in the spindle axis at which the tool cannot collide with the workpiece or its clamping. PREDEF takes the value from the GLOBAL DEF block.
parameter-second-set-up-clearance__circular-pocket =
    .help = Height in the spindle axis at which the tool cannot collide with the workpiece or its clamping. PREDEF takes the value from the GLOBAL DEF block.
parameter-second-set-up-clearance__slot =
    .help = Height in the spindle axis at which the tool cannot collide with the workpiece or its clamping. PREDEF takes the value from the GLOBAL DEF block.
parameter-second-set-up-clearance__circular-slot =
    .help = Height in the spindle axis at which the tool cannot collide with the workpiece or its clamping. PREDEF takes the value from the GLOBAL DEF block.
parameter-second-set-up-clearance__rectangular-stud =
    .help = Height in the spindle axis at which the tool cannot collide with the workpiece or its clamping. PREDEF takes the value from the GLOBAL DEF block.
parameter-second-set-up-clearance__circular-stud =
    .help = Height in the spindle axis at which the tool cannot collide with the workpiece or its clamping. PREDEF takes the value from the GLOBAL DEF block.
parameter-second-set-up-clearance__face-milling =
    .help = Height in the spindle axis at which the tool cannot collide with the workpiece or its clamping. PREDEF takes the value from the GLOBAL DEF block.
parameter-surface-coordinate = Workpiece surface coordinate
    .label = SURFACE COORDINATE
    .help = Coordinate of the workpiece surface.
parameter-surface-coordinate__circular-pattern =
    .help = Coordinate of the workpiece surface. It also applies to the machining cycle that the pattern calls.
parameter-depth = Depth
    .label = DEPTH
    .help = Distance between the workpiece surface and the bottom of the hole, measured to the tip of the drill point.
parameter-depth__rectangular-pocket =
    .help = Distance between the workpiece surface and the bottom of the pocket.
parameter-plunging-depth = Plunging depth
    .label = PLUNGING DEPTH
    .help = Depth that the tool advances with each infeed. The depth need not be a multiple of it. The tool goes to the depth in one movement if both are equal, or if the plunging depth is greater than the depth.
parameter-plunging-depth__rectangular-pocket =
    .help = Depth that the tool advances with each infeed. Enter a value greater than 0.
parameter-decrement = Decrement
    .label = DECREMENT
    .help = Amount by which the plunging depth { $q-plunging-depth } becomes smaller with each infeed.
parameter-least-plunging-depth = Minimum plunging depth
    .label = MIN. PLUNGING DEPTH
    .help = If a decrement { $q-decrement } is entered, no infeed becomes smaller than this value.
parameter-upper-advanced-stop-distance = Upper advanced stop distance
    .label = UPPER ADV STOP DIST
    .help = Clearance above the present plunging depth when the tool returns into the hole at rapid traverse after a retraction: value for the first infeed.
parameter-lower-advanced-stop-distance = Lower advanced stop distance
    .label = LOWER ADV STOP DIST
    .help = Clearance above the present plunging depth when the tool returns into the hole at rapid traverse after a retraction: value for the last infeed.
parameter-depth-for-chip-breaking = Infeed depth for chip breaking
    .label = DEPTH FOR CHIP BRKNG
    .help = Infeed after which the chip is broken. With 0 there is no chip breaking.
parameter-chip-breaking-retraction = Retraction for chip breaking
    .label = DIST. FOR CHIP BRKNG
    .help = Distance by which the tool is retracted to break the chip. The tool retracts at 3000 mm/min.
parameter-deepened-starting-point = Deepened starting point
    .label = STARTING POINT
    .help = Starting point of the actual drilling, measured from the workpiece surface, where a shorter tool has already drilled the hole to some depth. The tool moves there from the set-up clearance at the pre-positioning feed rate { $q-pre-positioning-feed }.

# --- feeds and times ---
parameter-plunging-feed = Feed rate for plunging
    .label = FEED RATE FOR PLNGNG
    .help = Traversing speed of the tool while drilling.
parameter-plunging-feed__rectangular-pocket =
    .help = Traversing speed of the tool while it moves to the depth.
parameter-pre-positioning-feed = Feed rate for pre-positioning
    .label = F PRE-POSITIONING
    .help = Traversing speed of the tool from the set-up clearance to the deepened starting point. It acts only if { $q-deepened-starting-point } is not 0.
parameter-milling-feed = Feed rate for milling
    .label = FEED RATE FOR MILLNG
    .help = Traversing speed of the tool while milling.
parameter-finishing-feed = Feed rate for finishing
    .label = FINISHING FEED RATE
    .help = Traversing speed of the tool while finishing the side and the floor.
parameter-dwell-at-top = Dwell time at top
    .label = DWELL TIME AT TOP
    .help = Time that the tool stays at the set-up clearance after it has been retracted from the hole to cool.
parameter-dwell-at-bottom = Dwell time at depth
    .label = DWELL TIME AT DEPTH
    .help = Time that the tool stays at the bottom of the hole.

# --- milling of pockets ---
parameter-machining-operation = Machining operation
    .label = MACHINING OPERATION
    .help = Defines what is machined. Side and floor are finished only where the respective allowance ({ $q-side-allowance }, { $q-floor-allowance }) is defined.
parameter-first-side-length = 1st side length
    .label = FIRST SIDE LENGTH
    .help = Length of the pocket parallel to the main axis of the working plane.
parameter-second-side-length = 2nd side length
    .label = 2ND SIDE LENGTH
    .help = Length of the pocket parallel to the secondary axis of the working plane.
parameter-corner-radius = Corner radius
    .label = CORNER RADIUS
    .help = Radius of the pocket corners. With 0 the control takes the tool radius as the corner radius.
parameter-side-allowance = Finishing allowance for side
    .label = ALLOWANCE FOR SIDE
    .help = Finishing allowance in the working plane.
parameter-floor-allowance = Finishing allowance for floor
    .label = ALLOWANCE FOR FLOOR
    .help = Finishing allowance at the depth.
parameter-angle-of-rotation = Angle of rotation
    .label = ANGLE OF ROTATION
    .help = Angle by which the whole machining is rotated. The centre of rotation is the position of the tool when the cycle is called.
parameter-pocket-position = Pocket position
    .label = POCKET POSITION
    .help = Position of the pocket with respect to the tool position when the cycle is called.
parameter-milling-type = Climb or up-cut milling
    .label = CLIMB OR UP-CUT
    .help = Type of milling with the spindle turning clockwise (M3). PREDEF takes the value from the GLOBAL DEF block.
parameter-finishing-infeed = Infeed for finishing
    .label = INFEED FOR FINISHING
    .help = Distance that the tool advances in the spindle axis for each finishing pass. With 0 finishing takes one infeed.
parameter-path-overlap = Path overlap factor
    .label = TOOL PATH OVERLAP
    .help = This factor times the tool radius is the stepover k. PREDEF takes the value from the GLOBAL DEF block.
parameter-plunging-strategy = Plunging strategy
    .label = PLUNGE
    .help = Defines how the tool enters the material. PREDEF takes the value from the GLOBAL DEF block.

# --- patterns ---
parameter-pitch-circle-centre-main = Centre in 1st axis
    .label = CENTER IN 1ST AXIS
    .help = Centre of the pitch circle in the main axis of the working plane.
parameter-pitch-circle-centre-minor = Centre in 2nd axis
    .label = CENTER IN 2ND AXIS
    .help = Centre of the pitch circle in the secondary axis of the working plane.
parameter-pitch-circle-diameter = Pitch circle diameter
    .label = PITCH CIRCLE DIAMETR
    .help = Diameter of the pitch circle.
parameter-pattern-starting-angle = Starting angle
    .label = STARTING ANGLE
    .help = Angle between the main axis of the working plane and the starting point of the first machining operation on the pitch circle.
parameter-pattern-stopping-angle = Stopping angle
    .label = STOPPING ANGLE
    .help = Angle between the main axis of the working plane and the starting point of the last machining operation on the pitch circle; it does not apply to full circles. It must differ from the starting angle { $q-pattern-starting-angle }. If it is greater than the starting angle, machining proceeds counter-clockwise, otherwise clockwise.
parameter-pattern-stepping-angle = Stepping angle
    .label = STEPPING ANGLE
    .help = Angle between two machining operations on the pitch circle. With 0 the control calculates it from starting angle, stopping angle and number of operations. If it is entered, the stopping angle { $q-pattern-stopping-angle } is ignored. The sign gives the direction (− = clockwise).
parameter-number-of-operations = Number of operations
    .label = NR OF REPETITIONS
    .help = Number of machining operations on the pitch circle.
parameter-pattern-clearance-mode = Move to clearance height
    .label = MOVE TO CLEARANCE
    .help = Defines at which height the tool moves between the machining operations.
parameter-pattern-traverse-type = Type of traverse
    .label = TYPE OF TRAVERSE
    .help = Path function with which the tool moves between the machining operations.
    .prompt = Type of traverse? Line=0/arc=1

# --- coordinate transforms ---
parameter-datum-shift = Shift
    .help = Coordinates of the new datum. Absolute values refer to the workpiece datum that was set as datum; incremental values always refer to the datum valid last, which may itself be shifted. Up to 6 NC axes.
parameter-datum-row = Shift
    .help = Number of the datum in the datum table, or a Q parameter. With a Q parameter the control activates the datum whose number is in the parameter.
parameter-rotation-angle = Rotation
    .help = Angle of rotation in degrees, absolute or incremental.
parameter-preset-number = Number for datum
    .label = DATUM NUMBER
    .help = Number of the datum in the preset table that is to be activated.
    .prompt = Number for datum?

# --- choices ---
choice-roughing-and-finishing = Roughing and finishing
choice-roughing-only = Only roughing
choice-finishing-only = Side and floor finishing
choice-tool-at-pocket-centre = Tool position = centre of pocket
choice-tool-at-lower-left-corner = Tool position = lower left corner
choice-tool-at-lower-right-corner = Tool position = lower right corner
choice-tool-at-upper-right-corner = Tool position = upper right corner
choice-tool-at-upper-left-corner = Tool position = upper left corner
choice-climb-milling = Climb milling
choice-up-cut-milling = Up-cut milling
choice-vertical-plunging = Vertical plunging, whatever plunging angle { $mp-plunging-angle } the tool table holds
choice-helical-plunging = Helical plunging. The plunging angle { $mp-plunging-angle } of the active tool must be other than 0 in the tool table; otherwise the control reports an error
choice-reciprocating-plunging = Reciprocating plunging. The plunging angle { $mp-plunging-angle } of the active tool must be other than 0 in the tool table; otherwise the control reports an error. The length of the strokes depends on the plunging angle; it is at least twice the tool diameter
choice-at-set-up-clearance = Move at set-up clearance between operations
choice-at-second-set-up-clearance = Move at 2nd set-up clearance between operations
choice-straight-between-operations = Move in a straight line between operations
choice-on-the-pitch-circle = Move on the pitch circle between operations
