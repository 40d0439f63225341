# Parameters of the drilling, tapping and thread-milling cycles: name, label in the NC block, help.

# --- parameters that other cycles have, too ---
parameter-depth__reaming =
    .help = Distance between the workpiece surface and the bottom of the hole.
parameter-depth__centring =
    .help = Distance between the workpiece surface and the bottom of the centring, measured to the tip of the centring cone. It acts only if { $q-depth-or-diameter } = 0.
parameter-plunging-depth__universal-drilling =
    .help = Depth that the tool advances with each infeed. The depth need not be a multiple of it. The tool goes to the depth in one movement if both are equal, or if the plunging depth is greater than the depth and no chip breaking is defined.
parameter-chip-breaking-retraction__universal-drilling =
    .help = Distance by which the tool is retracted to break the chip.
parameter-plunging-feed__reaming =
    .help = Traversing speed of the tool while reaming.
parameter-plunging-feed__centring =
    .help = Traversing speed of the tool while centring.

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

# --- choices ---
choice-centre-to-entered-depth = Centre to the entered depth
choice-centre-to-entered-diameter = Centre to the entered diameter
