# Words of figures.

figure-section = Section
figure-plan = From above
figure-chip-breaking = Chip breaking
figure-decreasing-infeeds = Decreasing infeeds
figure-deepened-start = Deepened starting point
figure-centring-diameter = Centring to a diameter
figure-rotation = Angle of rotation
figure-pocket-position = Position at the call
figure-milling-type = Climb and up-cut milling
figure-allowances = Finishing allowances
figure-slot-position = Position at the call
figure-stud-position = Position at the call
figure-approach = Approach position
figure-stepping-angle = Stepping angle
figure-traverse = Path from operation to operation
figure-plunging = Plunging
figure-side = From the side
figure-new-datum = The new datum
figure-probe-axis = Datum in the touch probe axis
figure-heights = Clearance heights
figure-corner-a = Corner A
figure-corner-b = Corner B
figure-corner-c = Corner C
figure-corner-d = Corner D
figure-corner-1 = Corner 1
figure-corner-2 = Corner 2
figure-corner-3 = Corner 3
figure-corner-4 = Corner 4
figure-front = Countersinking at the front
figure-wall = Clearance to the side
figure-drilling = Drilling
figure-strategy = Strategy
figure-pattern = Several slots
figure-side-allowance = Finishing allowance for side
figure-rounding = Inside corner radius
figure-between-points = Path between the touch points
figure-between-holes = Way between the positions
figure-depth-or-diameter = Depth or diameter
figure-threads-per-step = Turns or helices
figure-countersinking-moment = When it is countersunk
figure-finishing-counter-clockwise = Finishing counter-clockwise, Q9 = +1
figure-finishing-clockwise = Finishing clockwise, Q9 = −1
figure-train-climb = Climb milling, Q15 = +1
figure-train-up-cut = Up-cut milling, Q15 = −1
figure-train-to-and-fro = There and back, Q15 = 0
figure-operation = Machining operation
figure-no-contact = Path without a touch point
way-rapid = rapid traverse
way-feed = feed
way-probing = probing

cli-figure = Write the figures of a cycle as SVG files
cli-figure-out = The directory for the figures; it is made if it does not exist
cli-examples-figure =
    ciklo figure 205 --control tnc640 --lang sl --out figures
cli-coverage-figures = { $count } of { $of } lengths, angles and positions in no figure: { $ids }

diag-figure-example-missing = The figure { $name } of { $cycle } is to be drawn from the example { $example }, which the cycle does not have.
diag-figure-moment-never = The run of the figure { $name } of { $cycle } never comes to the moment that it shows ({ $reason }).
diag-figure-name-taken = Two figures of { $cycle } are both called { $name }.
diag-figure-no-value = The figure { $figure } of { $cycle } shows { $name } between places that have no value at that moment.
diag-figure-no-centre = The figure { $figure } of { $cycle } shows { $name } as an angle, but its centre is missing or is not a point.
diag-figure-axis-not-visible = The figure { $figure } of { $cycle } shows { $name } along an axis that its view does not have.
diag-figure-mixed-places = The figure { $figure } of { $cycle } shows { $name } between a coordinate and a point: both places must be of the same kind.
diag-figure-measured-otherwise = The figure { $figure } of { $cycle } shows { $name } between places that are { $measured } apart in the run; its value is { $value }.
diag-figure-nothing-to-see = The figure { $figure } of { $cycle } shows { $name } with the value 0: there is nothing to see.
diag-figure-place-not-reached = The figure { $figure } of { $cycle } shows { $name } up to a place ({ $place }) to which neither the tool nor the workpiece comes.
diag-figure-none = The cycle { $cycle } has no figure on this control.
diag-figure-parameter-not-shown = No figure of { $cycle } shows { $name }, and the specification gives no reason.
figure-teeth = Cutting edges at the tool setter
figure-turning-tool = Rotating tool
figure-single-teeth = Single cutting edges
figure-line-angle = Angle of the lines
figure-rotary-a = Along rotary axis A
figure-rotary-b = Along rotary axis B
figure-rotary-c = Along rotary axis C
figure-backlash = Backlash
figure-sphere = Probing of the calibration sphere
figure-basic-rotation = Basic rotation
figure-greatest-dimension = Maximum limit
figure-least-dimension = Minimum limit
figure-centre-tolerance = Tolerance of the centre
figure-spatial-angle-a = Spatial angle A
figure-spatial-angle-b = Spatial angle B
figure-spatial-angle-c = Spatial angle C
figure-counterbore = Counterboring
figure-disengaging = Disengaging direction
figure-pre-drilled = Pre-drilled hole
figure-touch-points = Touch points
figure-measuring-axis = Measuring axis
figure-traverse-direction = Traverse direction
figure-straight-or-circle = Straight or on a circle
figure-program = The program from above
figure-program-turned = The program: half of the part cut open
figure-program-recess = The program: the recess
figure-program-side = The program from the side
figure-program-across = The program, seen along the rotary axis
figure-program-tilted = The tilted plane of the program
figure-wide-slot = Wide slot
