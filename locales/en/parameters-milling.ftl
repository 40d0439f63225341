# Parameters of pockets, slots, studs, line patterns and multipass milling: name, label in the NC block, help.

# --- pockets, slots and studs ---
parameter-circle-diameter = Circle diameter
    .label = CIRCLE DIAMETER
    .help = Diameter of the finished pocket.
parameter-slot-length = Slot length
    .label = SLOT LENGTH
    .help = Longer side of the slot, parallel to the main axis of the working plane.
parameter-milled-slot-width = Slot width
    .label = SLOT WIDTH
    .help = Width of the slot, parallel to the secondary axis of the working plane. If it equals the tool diameter, the control only roughs (it mills an oblong hole). Greatest slot width for roughing: twice the tool diameter.
parameter-angle-of-rotation__slot =
    .help = Angle by which the whole slot is rotated. The centre of rotation is the position of the tool when the cycle is called.
parameter-angle-of-rotation__line-pattern =
    .help = Angle by which the whole pattern is rotated. The centre of rotation is the starting point. It also applies to the machining cycle that the pattern calls.
parameter-slot-position = Slot position
    .label = SLOT POSITION
    .help = Position of the slot with respect to the tool position when the cycle is called.
parameter-slot-position-reference = Reference for slot position
    .label = REF. SLOT POSITION
    .help = Position of the slot with respect to the tool position when the cycle is called.
parameter-slot-starting-angle = Starting angle
    .label = STARTING ANGLE
    .help = Polar angle of the starting point.
parameter-slot-opening-angle = Angular length of slot
    .label = ANGULAR LENGTH
    .help = Angle over which the slot extends.
parameter-pattern-stepping-angle__circular-slot =
    .help = Angle by which the whole slot is rotated for each further machining operation. The centre of rotation is the centre of the pitch circle.
parameter-stud-first-side-length = 1st side length
    .label = FIRST SIDE LENGTH
    .help = Length of the stud parallel to the main axis of the working plane.
parameter-blank-first-side-length = Workpiece blank side length 1
    .label = WORKPC. BLANK SIDE 1
    .help = Length of the stud blank parallel to the main axis of the working plane. Enter a value greater than the 1st side length { $q-stud-first-side-length }. If the two differ by more than the permitted stepover (tool radius times path overlap { $q-path-overlap }), the control takes several stepovers. It always calculates a constant stepover.
parameter-stud-second-side-length = 2nd side length
    .label = 2ND SIDE LENGTH
    .help = Length of the stud parallel to the secondary axis of the working plane.
parameter-blank-second-side-length = Workpiece blank side length 2
    .label = WORKPC. BLANK SIDE 2
    .help = Length of the stud blank parallel to the secondary axis of the working plane. Enter a value greater than the 2nd side length { $q-stud-second-side-length }. If the two differ by more than the permitted stepover (tool radius times path overlap { $q-path-overlap }), the control takes several stepovers. It always calculates a constant stepover.
parameter-corner-radius__rectangular-stud =
    .help = Radius of the stud corners.
parameter-side-allowance__rectangular-stud =
    .help = Finishing allowance in the working plane that the control leaves when machining.
parameter-stud-position = Stud position
    .label = STUD POSITION
    .help = Position of the stud with respect to the tool position when the cycle is called.
parameter-stud-approach-position = Approach position
    .label = APPROACH POSITION
    .help = Defines where the tool approaches the stud.
parameter-finished-part-diameter = Diameter of finished part
    .label = FINISHED PART DIA.
    .help = Diameter of the finished stud.
parameter-blank-diameter = Workpiece blank diameter
    .label = WORKPIECE BLANK DIA.
    .help = Diameter of the blank. It must be greater than the diameter of the finished part { $q-finished-part-diameter }. If the two differ by more than the permitted stepover (tool radius times path overlap { $q-path-overlap }), the control takes several stepovers. It always calculates a constant stepover.
parameter-stud-starting-angle = Starting angle
    .label = STARTING ANGLE
    .help = Polar angle with respect to the centre of the stud at which the tool approaches the stud.
parameter-depth__slot =
    .help = Distance between the workpiece surface and the bottom of the slot.
parameter-depth__circular-slot =
    .help = Distance between the workpiece surface and the bottom of the slot.
parameter-depth__circular-pocket =
    .help = Distance between the workpiece surface and the bottom of the pocket.
parameter-depth__rectangular-stud =
    .help = Distance between the workpiece surface and the bottom of the stud.
parameter-depth__circular-stud =
    .help = Distance between the workpiece surface and the bottom of the stud.
parameter-plunging-depth__circular-pocket =
    .help = Depth that the tool advances with each infeed. Enter a value greater than 0.
parameter-plunging-depth__slot =
    .help = Depth that the tool advances with each infeed. Enter a value greater than 0.
parameter-plunging-depth__circular-slot =
    .help = Depth that the tool advances with each infeed. Enter a value greater than 0.
parameter-plunging-depth__rectangular-stud =
    .help = Depth that the tool advances with each infeed. Enter a value greater than 0.
parameter-plunging-depth__circular-stud =
    .help = Depth that the tool advances with each infeed. Enter a value greater than 0.
parameter-plunging-feed__circular-pocket =
    .help = Traversing speed of the tool while it moves to the depth.
parameter-plunging-feed__slot =
    .help = Traversing speed of the tool while it moves to the depth.
parameter-plunging-feed__circular-slot =
    .help = Traversing speed of the tool while it moves to the depth.
parameter-plunging-feed__rectangular-stud =
    .help = Traversing speed of the tool while it moves to the depth.
parameter-plunging-feed__circular-stud =
    .help = Traversing speed of the tool while it moves to the depth.
parameter-plunging-feed__multipass-milling =
    .help = Traversing speed of the tool while it moves to the depth.

# --- line patterns ---
parameter-pattern-spacing-main = Spacing in 1st axis
    .label = SPACING IN 1ST AXIS
    .help = Distance between the points of a line.
parameter-pattern-spacing-minor = Spacing in 2nd axis
    .label = SPACING IN 2ND AXIS
    .help = Distance between the lines.
parameter-number-of-columns = Number of columns
    .label = NUMBER OF COLUMNS
    .help = Number of machining operations in a line.
parameter-number-of-lines = Number of lines
    .label = NUMBER OF LINES
    .help = Number of lines.
parameter-starting-point-main__line-pattern =
    .help = Coordinate of the starting point in the main axis of the working plane.
parameter-starting-point-minor__line-pattern =
    .help = Coordinate of the starting point in the secondary axis of the working plane.
parameter-set-up-clearance__line-pattern =
    .help = Distance between the tool tip and the workpiece surface. It also applies to the machining cycle that the pattern calls.
parameter-surface-coordinate__line-pattern =
    .help = Coordinate of the workpiece surface. It also applies to the machining cycle that the pattern calls.
parameter-second-set-up-clearance__line-pattern =
    .help = Height in the spindle axis at which the tool cannot collide with the workpiece or its clamping. It also applies to the machining cycle that the pattern calls.

# --- multipass milling of surfaces ---
parameter-starting-point-main = Starting point in 1st axis
    .label = STARTNG PNT 1ST AXIS
    .help = Coordinate of the starting point of the surface to be machined, in the main axis of the working plane.
parameter-starting-point-minor = Starting point in 2nd axis
    .label = STARTNG PNT 2ND AXIS
    .help = Coordinate of the starting point of the surface to be machined, in the secondary axis of the working plane.
parameter-starting-point-tool = Starting point in 3rd axis
    .label = STARTNG PNT 3RD AXIS
    .help = Height in the spindle axis at which the surface is milled.
parameter-starting-point-tool__ruled-surface =
    .help = Coordinate of the starting point of the surface to be milled, in the spindle axis.
parameter-starting-point-tool__face-milling =
    .help = Coordinate of the workpiece surface from which the infeeds are calculated.
parameter-first-side-length__multipass-milling =
    .help = Length of the surface to be milled in the main axis of the working plane, from the starting point in the 1st axis.
parameter-first-side-length__face-milling =
    .help = Length of the surface to be machined in the main axis of the working plane. The sign determines the direction of the first milling path with respect to the starting point in the 1st axis.
parameter-second-side-length__multipass-milling =
    .help = Length of the surface to be milled in the secondary axis of the working plane, from the starting point in the 2nd axis.
parameter-second-side-length__face-milling =
    .help = Length of the surface to be machined in the secondary axis of the working plane. The sign determines the direction of the first stepover with respect to the starting point in the 2nd axis.
parameter-number-of-cuts = Number of cuts
    .label = NUMBER OF CUTS
    .help = Number of lines in which the control moves the tool over the width.
parameter-number-of-cuts__ruled-surface =
    .help = Number of lines that the control machines between points 1 and 4, or between points 2 and 3.
parameter-stepover-feed = Stepover feed rate
    .label = STEPOVER FEED RATE
    .help = Traversing speed of the tool while it moves to the next line. For a stepover within the material enter a value less than { $q-milling-feed }; for a stepover above the workpiece { $q-stepover-feed } may be greater than { $q-milling-feed }.
parameter-set-up-clearance__multipass-milling =
    .help = Distance between the tool tip and the milling depth for positioning at the beginning and at the end of the cycle.
parameter-set-up-clearance__face-milling =
    .help = Distance between the tool tip and the starting position in the tool axis. With the strategy { $q-face-milling-strategy } = 2 the tool moves at this distance above the present infeed depth to the starting point of the next line.
parameter-surface-second-point-main = 2nd point in 1st axis
    .label = 2ND POINT 1ST AXIS
    .help = Coordinate of the end point of the surface to be milled, in the main axis of the working plane.
parameter-surface-second-point-minor = 2nd point in 2nd axis
    .label = 2ND POINT 2ND AXIS
    .help = Coordinate of the end point of the surface to be milled, in the secondary axis of the working plane.
parameter-surface-second-point-tool = 2nd point in 3rd axis
    .label = 2ND POINT 3RD AXIS
    .help = Coordinate of the end point of the surface to be milled, in the spindle axis.
parameter-surface-third-point-main = 3rd point in 1st axis
    .label = 3RD POINT 1ST AXIS
    .help = Coordinate of point 3 in the main axis of the working plane.
parameter-surface-third-point-minor = 3rd point in 2nd axis
    .label = 3RD POINT 2ND AXIS
    .help = Coordinate of point 3 in the secondary axis of the working plane.
parameter-surface-third-point-tool = 3rd point in 3rd axis
    .label = 3RD POINT 3RD AXIS
    .help = Coordinate of point 3 in the spindle axis.
parameter-surface-fourth-point-main = 4th point in 1st axis
    .label = 4TH POINT 1ST AXIS
    .help = Coordinate of point 4 in the main axis of the working plane.
parameter-surface-fourth-point-minor = 4th point in 2nd axis
    .label = 4TH POINT 2ND AXIS
    .help = Coordinate of point 4 in the secondary axis of the working plane.
parameter-surface-fourth-point-tool = 4th point in 3rd axis
    .label = 4TH POINT 3RD AXIS
    .help = Coordinate of point 4 in the spindle axis.
parameter-milling-feed__ruled-surface =
    .help = Traversing speed of the tool while milling. The control takes the first cut at half the programmed value.
parameter-face-milling-strategy = Machining strategy
    .label = STRATEGY
    .help = Defines how the control machines the surface.
parameter-end-point-tool = End point in 3rd axis
    .label = END POINT 3RD AXIS
    .help = Coordinate in the spindle axis to which the surface is face-milled.
parameter-max-plunging-depth = Maximum plunging depth
    .label = MAX. PLUNGING DEPTH
    .help = Greatest depth that the tool advances with one infeed. The control calculates the actual plunging depth from the difference between end point and starting point in the tool axis so that all infeeds are equal; it takes the finishing allowance { $q-floor-allowance } into account.
parameter-floor-allowance__face-milling =
    .help = Depth of the last infeed.
parameter-max-path-overlap = Maximum path overlap factor
    .label = MAX. OVERLAP
    .help = Factor for the greatest stepover k. The control calculates the actual stepover from the 2nd side length { $q-second-side-length } and the tool radius so that all stepovers are equal. If a radius { $mp-tool-radius-2 } is entered in the tool table (such as the insert radius of a face-milling cutter), the control reduces the stepover accordingly.
parameter-finishing-feed__face-milling =
    .help = Traversing speed of the tool while milling the last infeed.
parameter-pre-positioning-feed__face-milling =
    .help = Traversing speed of the tool while it moves to the starting position and to the next line. If the stepover is within the material ({ $q-face-milling-strategy } = 1), the control takes it at the feed rate for milling { $q-milling-feed }.
parameter-side-clearance = Clearance to side
    .label = CLEARANCE TO SIDE
    .help = Distance between the tool and the side of the workpiece when the tool moves to the first plunging depth, and distance at which the stepovers take place with the strategies { $q-face-milling-strategy } = 0 and { $q-face-milling-strategy } = 2.

# --- choices ---
choice-vertical-plunging-with-angle-0-or-90 = Vertical plunging. The plunging angle { $mp-plunging-angle } of the active tool must be 0 or 90 in the tool table; otherwise the control reports an error
choice-reciprocating-plunging-by-angle = Reciprocating plunging. The plunging angle { $mp-plunging-angle } of the active tool must be other than 0 in the tool table; otherwise the control reports an error
choice-tool-at-slot-centre = Tool position = centre of slot
choice-tool-at-left-slot-end = Tool position = left end of slot
choice-tool-at-left-slot-arc-centre = Tool position = centre of left slot arc
choice-tool-at-right-slot-arc-centre = Tool position = centre of right slot arc
choice-tool-at-right-slot-end = Tool position = right end of slot
choice-tool-position-not-considered = The tool position is ignored. The position of the slot follows from the entered centre of the pitch circle and the starting angle
choice-slot-begins-at-tool = Tool position = centre of left slot arc. The starting angle { $q-slot-starting-angle } refers to this position. The entered centre of the pitch circle is ignored
choice-slot-middle-at-tool = Tool position = centre of the middle axis. The starting angle { $q-slot-starting-angle } refers to this position. The entered centre of the pitch circle is ignored
choice-slot-ends-at-tool = Tool position = centre of right slot arc. The starting angle { $q-slot-starting-angle } refers to this position. The entered centre of the pitch circle is ignored
choice-tool-at-stud-centre = Tool position = centre of stud
choice-approach-right-of-stud = Right of the stud (default setting)
choice-approach-at-lower-left-corner = Lower left corner
choice-approach-at-lower-right-corner = Lower right corner
choice-approach-at-upper-right-corner = Upper right corner
choice-approach-at-upper-left-corner = Upper left corner
choice-meander-stepover-outside = Meandering paths, stepover outside the surface to be machined
choice-meander-stepover-inside = Meandering paths, stepover inside the surface to be machined
choice-line-by-line-with-retraction = Line by line, with retraction and stepover at the feed rate for positioning

# --- coordinate transforms ---
parameter-mirrored-axes = Mirrored axes
    .help = Axes to be mirrored. All axes may be mirrored, rotary axes included, except the spindle axis and the secondary axis parallel to it. Up to three of the NC axes X, Y, Z, U, V, W, A, B, C.
    .prompt = Mirrored axis?
parameter-scaling-factor = Factor
    .help = Scaling factor SCL. The control multiplies coordinates and radii by it.
    .prompt = Factor?
    .word = SCL
parameter-axis-scaling-factors = Axis and factor
    .help = Coordinate axes and the factors by which each of them is stretched or compressed.
parameter-axis-scaling-centre = Centre coordinates
    .help = Centre from which the contour is stretched or towards which it is compressed.
parameter-tilting-angles = Rotary axis and angle
    .help = Rotary axes with their tilt angles; the rotary axes A, B and C are programmed with soft keys.
    .prompt = Rotary axis and angle?
parameter-tilting-feed = Feed rate
    .help = Traversing speed of the rotary axis when the control positions it automatically.
    .prompt = Feed rate? F=
parameter-tilting-clearance = Set-up clearance
    .help = The control positions the swivel head so that the position at the end of the tool, extended by the set-up clearance, does not change with respect to the workpiece. It is entered if the control positions the rotary axes automatically.
    .prompt = Set-up clearance?

# --- special functions ---
parameter-programmed-dwell = Dwell time in seconds
    .help = Time for which the program run stops, up to 1 hour in steps of 0.001 s.
    .word = DWELL
parameter-program-to-call = Program name
    .help = Name of the program to be called, with its path if necessary.
    .word = PGM
parameter-orientation-angle = Angle of orientation
    .help = Angle with respect to the angle reference axis of the working plane.
    .word = ANGLE
parameter-contour-tolerance = Tolerance value T
    .help = Permitted deviation from the programmed contour in millimetres (in inches in inch programs).
parameter-hsc-mode = HSC mode, finishing=0, roughing=1
    .help = Defines which filter the control activates.
parameter-rotary-axis-tolerance = Tolerance for rotary axes TA
    .help = Permitted deviation of rotary axes in degrees while M128 (FUNCTION TCPM) is active. The control always reduces the feed rate so that with movements in several axes the slowest one moves at its greatest feed rate. Rotary axes are usually much slower than linear axes. A greater tolerance (such as 10°) can considerably shorten the machining time of multi-axis programs, because the control need not always move the rotary axes to the given nominal position. The contour is not damaged; only the position of the rotary axis with respect to the workpiece surface changes.

# --- choices of the special functions ---
choice-milling-with-higher-accuracy = Milling with higher contour accuracy. The control uses internally set filter settings for finishing
choice-milling-at-higher-feed = Milling at a higher feed rate. The control uses internally set filter settings for roughing
