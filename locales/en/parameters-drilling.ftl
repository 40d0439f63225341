# Parameters of the drilling, tapping and thread-milling cycles: name, label in the NC block, help.

# --- parameters that other cycles have, too ---
parameter-depth__reaming =
    .help = Distance between the workpiece surface and the bottom of the hole.
parameter-depth__boring =
    .help = Distance between the workpiece surface and the bottom of the hole.
parameter-depth__bore-milling =
    .help = Distance between the workpiece surface and the bottom of the hole.
parameter-depth__single-lip-drilling =
    .help = Distance between the workpiece surface and the bottom of the hole.
parameter-depth__centring =
    .help = Distance between the workpiece surface and the bottom of the centring, measured to the tip of the centring cone. It acts only if { $q-depth-or-diameter } = 0.
parameter-plunging-depth__universal-drilling =
    .help = Depth that the tool advances with each infeed. The depth need not be a multiple of it. The tool goes to the depth in one movement if both are equal, or if the plunging depth is greater than the depth and no chip breaking is defined.
parameter-chip-breaking-retraction__universal-drilling =
    .help = Distance by which the tool is retracted to break the chip.
parameter-plunging-feed__reaming =
    .help = Traversing speed of the tool while reaming.
parameter-plunging-feed__boring =
    .help = Traversing speed of the tool while boring.
parameter-plunging-feed__bore-milling =
    .help = Traversing speed of the tool while it mills on the helix.
parameter-plunging-feed__centring =
    .help = Traversing speed of the tool while centring.
parameter-set-up-clearance__bore-milling =
    .help = Distance between the lower edge of the tool and the workpiece surface.
parameter-milling-type__bore-milling =
    .help = Type of milling with the spindle turning clockwise (M3).
parameter-deepened-starting-point__single-lip-drilling =
    .help = Starting point of the actual drilling, measured from the workpiece surface. The tool moves there from the set-up clearance at the pre-positioning feed rate { $q-pre-positioning-feed }.

# --- drilling ---
parameter-retraction-feed = Retraction feed rate
    .label = RETRACTION FEED RATE
    .help = Traversing speed of the tool while it leaves the hole. With 0 it leaves at the feed rate { $q-plunging-feed }.
parameter-chip-breaks-before-retraction = Number of chip breaks before retraction
    .label = NR OF BREAKS
    .help = How often a chip is broken before the tool is retracted from the hole to cool. To break a chip the tool retracts by { $q-chip-breaking-retraction }.
parameter-depth-or-diameter = Select depth or diameter
    .label = SELECT DEPTH/DIAMETER
    .help = Whether the tool centres to the entered depth or to the entered diameter. For the diameter, the point angle of the tool must be defined in the column { $mp-drill-point-angle } of the tool table.
parameter-centring-diameter = Diameter (sign)
    .label = DIAMETER
    .help = Centring diameter; its sign is the working direction. It acts only if { $q-depth-or-diameter } = 1.

parameter-disengaging-direction = Disengaging direction
    .label = DISENGAGING DIRECTN
    .help = Direction in which the control disengages the tool at the bottom of the hole, after the spindle is oriented.
parameter-disengaging-direction__back-boring =
    .help = Direction in which the control offsets the tool by the off-centre distance, after the spindle is oriented. The value 0 is not permitted.
parameter-spindle-orientation-angle = Angle for spindle orientation
    .label = ANGLE OF SPINDLE
    .help = Angle to which the control orients the tool before it disengages it.
parameter-spindle-orientation-angle__back-boring =
    .help = Angle to which the control orients the tool before it enters the hole and before it leaves it.
parameter-counterbore-depth = Depth of counterbore
    .label = DEPTH OF COUNTERBORE
    .help = Distance between the lower edge of the workpiece and the end of the counterbore. A positive sign counterbores in the positive direction of the spindle axis.
parameter-material-thickness = Material thickness
    .label = MATERIAL THICKNESS
    .help = Thickness of the workpiece.
parameter-off-centre-distance = Off-centre distance
    .label = OFF-CENTER DISTANCE
    .help = Off-centre distance of the boring bar, from the data sheet of the tool.
parameter-cutting-edge-height = Cutting edge height
    .label = TOOL EDGE HEIGHT
    .help = Distance between the lower edge of the boring bar and the main cutting edge, from the data sheet of the tool.
parameter-counterbore-dwell = Dwell time
    .label = DWELL TIME
    .help = Time that the tool stays at the end of the counterbore.
parameter-infeed-per-helix = Infeed per helix
    .label = PLUNGING DEPTH
    .help = Depth that the tool advances with each turn of the helix (360°).
parameter-nominal-diameter = Nominal diameter
    .label = NOMINAL DIAMETER
    .help = Diameter of the thread.
parameter-nominal-diameter__bore-milling =
    .help = Diameter of the hole. If it equals the tool diameter, the control drills without helical interpolation directly to the entered depth.
parameter-pre-drilled-diameter = Diameter of pre-drilled hole
    .label = ROUGHING DIAMETER
    .help = If a value greater than 0 is entered, the control does not check the ratio of hole diameter to tool diameter. In this way holes can be milled that are more than twice as wide as the tool.
parameter-rotation-in-and-out = Direction of rotation on entry and exit
    .label = DIR. OF SPINDLE ROT.
    .help = Direction in which the tool turns while it enters the hole and leaves it.
parameter-speed-in-and-out = Spindle speed on entry and exit
    .label = ROT.SPEED INFEED/OUT
    .help = Speed at which the tool turns while it enters the hole and leaves it.
parameter-drilling-speed = Speed for drilling
    .label = DRILLING SPEED
    .help = Speed at which the tool drills.
parameter-coolant-on-function = M function for coolant on
    .label = COOLANT ON
    .help = Miscellaneous function M that switches on the coolant. The control switches it on when the tool is in the hole at the deepened starting point.
parameter-coolant-off-function = M function for coolant off
    .label = COOLANT OFF
    .help = Miscellaneous function M that switches off the coolant. The control switches it off when the tool is at the depth of the hole.

# --- countersinking, tapping and thread milling ---
parameter-in-and-out-feed = Feed rate for pre-positioning
    .label = F PRE-POSITIONING
    .help = Traversing speed of the tool while it enters the workpiece or leaves it.
parameter-countersinking-feed = Feed rate for countersinking
    .label = F COUNTERBORING
    .help = Traversing speed of the tool while countersinking.

# --- choices ---
choice-centre-to-entered-depth = Centre to the entered depth
choice-centre-to-entered-diameter = Centre to the entered diameter
choice-no-disengagement = Do not disengage the tool
choice-disengage-minus-main = Disengage the tool in the negative direction of the main axis
choice-disengage-minus-minor = Disengage the tool in the negative direction of the minor axis
choice-disengage-plus-main = Disengage the tool in the positive direction of the main axis
choice-disengage-plus-minor = Disengage the tool in the positive direction of the minor axis
choice-in-and-out-clockwise = Turn the spindle with M3
choice-in-and-out-counter-clockwise = Turn the spindle with M4
choice-in-and-out-standing = Move with the spindle standing still
