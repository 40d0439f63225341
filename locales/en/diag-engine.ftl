## Why a run ends early.

diag-angle-missing = The circle needs its angle PA.
diag-axis-limit = { $axis } would go to { NUMBER($found) } { $unit }, beyond the limits { NUMBER($min) } to { NUMBER($max) } { $unit } of the machine.
diag-block-limit = The run was ended: more than { NUMBER($limit) } blocks have been executed.
diag-block-unreadable = The block cannot be read: { $found }
diag-call-depth-limit = Calls are nested deeper than { NUMBER($limit) } levels.
related-called-here = called here
diag-collision = Collision: the stylus touches the workpiece outside a probing movement, at X { NUMBER($x) } Y { NUMBER($y) } Z { NUMBER($z) }.
diag-conform-no-value = The case gives no value for { $name }, and the specification has no example value.
diag-conform-unknown-clause = The case claims to prove { $name }, which { $cycle } does not have.
diag-cycle-depth-limit = Cycles are nested deeper than { NUMBER($limit) } levels.
diag-cycle-error = The cycle stops with the error { $code }.
diag-cycle-unknown = The manuals of { $control } do not describe { $cycle }: it cannot be simulated.
diag-direction-contradicts = The sign of the incremental angle contradicts the direction of rotation DR.
diag-direction-missing = The circle needs its direction of rotation DR.
diag-direction-undefined = The two points are only { NUMBER($distance) } mm apart: they do not determine a direction.
diag-division-by-zero = Division by zero.
diag-elements-overlap = The elements at two corners of the contour overlap: together they take { NUMBER($least) } mm of the side between them, which is { NUMBER($found) } mm long.
diag-end-off-circle = The end point is not on the circle: radius { NUMBER($start_radius, maximumFractionDigits: 4) } mm at the start, { NUMBER($end_radius, maximumFractionDigits: 4) } mm at the end.
diag-feed-missing = No feed rate greater than 0 is active.
diag-field-missing = The field { $field } of { $cycle } is missing.
diag-field-unknown = { $cycle } has no such field: { $found }
diag-fit-collinear = The { NUMBER($points) } touch points are on a straight line: no circle fits them.
diag-fit-failed = No circle fits the { NUMBER($points) } touch points.
diag-fit-too-few = { NUMBER($points) } touch points are too few for a circle.
diag-infeeds-never-reach-depth = The infeeds never reach the depth of { NUMBER($depth) } mm: the first is { NUMBER($first) } mm, each one is { NUMBER($less) } mm smaller, the minimum is { NUMBER($least) } mm; they end at { NUMBER($reached) } mm.
diag-insert-askew = Turning cycles cannot be simulated while the tool is inclined and M144, M128 or FUNCTION TCPM is active.
diag-insert-direction = The insert of tool { $tool } does not point to the part, or not in the direction of the cuts: its orientation (TO) is { $orientation }.
diag-jump-limit = The run was ended: more than { NUMBER($limit) } jumps, repeats and calls have been executed.
diag-jump-target-missing = There is no label { $label }.
diag-jump-target-twice = The label { $label } is set twice in the program.
diag-kinematics-unknown = The kinematics “{ $name }” after FUNCTION MODE are not those of the simulated machine, “{ $machine }”.
diag-lines-parallel = The two lines are parallel: they have no intersection.
diag-log-failed = The log { $name } cannot be written: { $reason }
diag-log-template = The log { $name } has no template.
diag-log-text = The text { $name } of the log is missing ({ $reason }).
diag-machine-parameter-missing = The machine parameter { $name } with its three coordinates is not defined.
diag-milling-mode-missing = { $cycle } is executed in milling mode only, but turning mode (FUNCTION MODE TURN) is active.
diag-move-limit = The run was ended: more than { NUMBER($limit) } tool movements have been executed.
diag-no-cycle-to-call = A cycle is called, but no machining cycle has been defined.
diag-no-such-parameter = There is no parameter { $q }.
diag-number-too-large = The result is too large for the number format.
diag-orientation-missing = Radius compensation in turning needs the orientation (TO) of tool { $tool }: it says where its tip is from the centre of the nose.
diag-outside-domain = { $function } is not defined for { NUMBER($value) }.
diag-parameter-missing = { $q } is missing in { $cycle }.
diag-parameter-out-of-range = { $q } does not accept the value { NUMBER($value) }.
diag-parameter-undefined = { $q } has no value.
diag-parameter-in-addition = { $q } in { $cycle } belongs to a later software version than the one described here; its effect is not known.
diag-parameter-unknown = { $cycle } has no parameter { $q }.
diag-plan-mistake = The specification of { $cycle } has a mistake: { $reason }
diag-plane-through-line = The three points are on a straight line: they do not determine a plane.
diag-pole-missing = No circle centre or pole (CC) is defined.
diag-probe-deflected = The stylus is already deflected before probing begins.
diag-probe-measurements-differ = The measurements of one point differ by { NUMBER($found) } mm; the confidence range is { NUMBER($range) } mm.
diag-probe-missing = No touch probe is in the spindle.
diag-probe-no-contact = The probe does not touch anything within { NUMBER($distance) } mm.
diag-probe-no-direction = The stylus is already at the point to be probed, so there is no probing direction.
diag-program-missing = There is no program { $name }.
diag-radius-missing = The radius R is missing in this block.
diag-radius-too-small = The radius of { NUMBER($radius) } mm cannot span a chord of { NUMBER($chord, maximumFractionDigits: 4) } mm.
diag-recess-impossible = There is no room for the recess, its centre, depth or width is missing, or it is not in a straight element.
diag-recursive-call = A program part calls itself.
diag-repeat-count = REP needs a whole number from 0 to 65534, not { NUMBER($found) }.
diag-rotary-axis-missing = The machine has no rotary axis { $axis }.
diag-rotary-axis-unsuitable = The rotary axis { $axis } does not rotate in the plane of the misalignment and cannot compensate for it.
diag-series-count = The number of repetitions must be a whole number and not negative, not { NUMBER($found) }.
diag-shaft-collision = The shaft of the stylus touches the workpiece at X { NUMBER($x) } Y { NUMBER($y) } Z { NUMBER($z) }.
diag-shape-impossible = This tool cannot machine the shape: at least { NUMBER($least) } mm are needed, { NUMBER($found) } mm are available.
diag-cutting-width-missing = Tool { $tool } is no recessing tool: its cutting width (CUTWIDTH) must be greater than 0 and at least twice its cutting radius (RS).
diag-arc-scaled-unequally = The axes of the plane have different scaling factors: an arc would become an ellipse.
diag-scaling-factor-zero = A scaling factor must be greater than zero, not { NUMBER($found) }.
diag-m144-together = M144 cannot be active together with { $word }.
diag-spline-start = The spline starts { NUMBER($distance, maximumFractionDigits: 4) } mm or degrees from the current position; 0.001 is permitted.
diag-tool-direction-unreachable = The rotary axes of the machine cannot bring the tool into the direction that this block gives.
diag-tilting-unreachable = The rotary axes of the machine cannot position the tool perpendicular to this plane.
diag-pattern-missing = { $name ->
    [none] No pattern or point table is defined for the call of the cycle.
   *[other] There is no point table “{ $name }”.
}
diag-pattern-too-long = PATTERN DEF accepts at most { $limit } individual positions; there are { $count } here.
diag-pattern-tool-axis = Patterns can be used with the tool axis Z only; the active tool axis is { $axis }.
diag-pattern-unreadable = “{ $found }” cannot be used in PATTERN DEF.
diag-position-incomplete = CYCL CALL POS needs the coordinates of all three axes.
diag-value-not-predefined = PREDEF is programmed, but no GLOBAL DEF has defined the value.
diag-series-limit = The cycle would repeat its steps more than { NUMBER($limit) } times.
diag-strategy-argument = An argument of a strategy is missing.
diag-text-or-number = Text where a number is required, or vice versa.
diag-text-too-long = A string parameter would exceed { NUMBER($limit) } characters.
diag-tool-locked = Tool { $tool } is locked.
diag-tool-not-in-table = Tool { $tool } is not in the tool table.
diag-turn-limit = The run was ended: one movement has more than { NUMBER($limit) } turns.
diag-undercut-form = UDC { $form } cannot be simulated: no manual describes its shape.
diag-undercut-impossible = There is no room for the undercut, a size is missing, or it is not between a surface along the rotary axis and a face at right angles to it.
diag-unsupported-axis = The simulated machine has no axis { $axis }.
diag-unsupported-block = { $word } cannot be simulated.
diag-unsupported-cycle = The manual of { $control } only mentions { $cycle } by name: it cannot be simulated.
diag-unsupported-feed = This feed rate in a tool call cannot be simulated: { $word }
diag-unsupported-m = The M function { $word } cannot be simulated.
diag-unsupported-path = { $word } cannot be simulated in this block.
diag-unsupported-tcpm = With TCPM active the touch probe is not perpendicular to the working plane; { $cycle } cannot be simulated then.
diag-unsupported-transformation = Movements cannot be simulated while this transformation is active: { $name }
diag-value-missing = A value is missing, or is not a number.
diag-value-not-bound = A formula of the specification reads a value that does not exist yet: { $place }
diag-word-not-offered = The word { $word } is not permitted here.
diag-contour-crossing = The contour of label { $label } crosses or touches itself at main { NUMBER($x) } mm, minor { NUMBER($y) } mm.
diag-contour-begin-incomplete = The contour of { $label } does not begin with both coordinates of the working plane.
diag-contour-data-undefined = No cycle has defined the data of the contour yet.
diag-contour-count = A contour consists of more than { NUMBER($limit) } partial contours.
diag-contour-depth =
    { $what ->
        [first] A partial contour is deeper than the first one of CONTOUR DEF, which must be the deepest pocket.
       *[cycle] A partial contour has a depth of { NUMBER($depth) } mm; that is deeper than the milling depth of the contour data.
    }
diag-contour-elements = The contours have more than { NUMBER($limit) } elements together.
diag-contour-empty = The subprogram of label { $label } describes no contour that encloses an area.
diag-contour-lead = A contour that a cycle machines cannot contain { $word }: the cycle approaches and leaves it by itself.
diag-contour-not-defined = No cycle has named the subprograms of the contour yet.
diag-contour-open = The contour of label { $label } is open: it ends { NUMBER($distance) } mm away from its starting point.
diag-contour-side-missing = The contour of label { $label } has no radius compensation RL or RR, which says whether it is a pocket or an island.
diag-contour-tool-axis = The contour of label { $label } contains a coordinate in the tool axis.
diag-free-contour-contradicts = No contour meets all the values given for this element and those before it.
diag-free-contour-open =
    { $what ->
        [line] The position or direction of this line is not determined. Values still missing: { $values }.
        [arc] The centre or radius of this arc is not determined. Values still missing: { $values }.
       *[end] The end of this element is not determined. Values still missing: { $values }.
    }
diag-free-contour-reference = Block { $block } is neither an element of this free contour nor the positioning block before it.
diag-free-contour-selection = FSELECT { $wanted } cannot be selected: there are { $solutions } solutions here.
diag-free-contour-several = From this element on, the free contour has { $solutions } solutions; none is selected with FSELECT.
diag-free-contour-word = { $word } cannot be used like this in a free contour.
