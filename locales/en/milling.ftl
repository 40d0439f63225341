# Pockets, slots, studs, line patterns and multipass milling.

# --- common to pockets, slots and studs ---
guard-tool-wider-than-slot = The tool does not fit into the slot: less the side allowances, the slot is narrower than the tool.
guard-stud-blank-too-small = The blank is not larger than the finished stud.
note-finishing-only-rapid-to-first-depth = Danger of collision! If the cycle is called with machining operation 2 (only finishing), the control moves the tool at rapid traverse to the first plunging depth.

# --- 252 ---
cycle-circular-pocket = Circular pocket
    .nc = CIRCULAR POCKET
    .purpose = Machines a circular pocket completely: roughing, floor finishing and side finishing. It can also do only roughing, only floor and side finishing, only floor finishing or only side finishing.
guard-plunging-angle-not-vertical = Vertical plunging needs a plunging angle { $mp-plunging-angle } of 0 or 90 in the tool table.
note-position-at-pocket-centre = Position the tool at the starting point (the centre of the circle) in the working plane with radius compensation R0.

# --- 253 ---
cycle-slot = Slot milling
    .nc = SLOT MILLING
    .purpose = Machines a slot completely: roughing, floor finishing and side finishing. It can also do only roughing, only floor and side finishing, only floor finishing or only side finishing.
step-move-over-left-slot-arc = The control positions the tool in the tool axis at the 2nd set-up clearance { $q-second-set-up-clearance } (at the set-up clearance if none is entered), then over the centre of the left slot arc, and then at the set-up clearance { $q-set-up-clearance }, all at rapid traverse.
step-plunge-at-left-slot-arc = Starting from the centre of the left slot arc, the tool plunges to the next plunging depth { $q-plunging-depth }. The parameter { $q-plunging-strategy } determines how:
say-plunge-to-and-fro-along-slot = { $q-plunging-strategy } = 1 or 2: back and forth along the slot at the plunging angle { $mp-plunging-angle } of the tool table, at the feed rate { $q-plunging-feed }
step-clear-slot-level = The control clears the slot from the inside out, leaving the finishing allowances { $q-side-allowance } and { $q-floor-allowance }.
step-rapid-to-first-plunging-depth-of-slot = If only finishing is programmed ({ $q-machining-operation } = 2), the control moves the tool at rapid traverse to the first plunging depth.
step-finish-slot-side = If an allowance { $q-side-allowance } is defined, the control first finishes the walls of the slot; with { $q-finishing-infeed } in several infeeds. It approaches the wall tangentially in the left slot arc.
step-finish-slot-side__circular-slot = If an allowance { $q-side-allowance } is defined, the control first finishes the walls of the slot; with { $q-finishing-infeed } in several infeeds. It approaches the wall tangentially.
until-slot-side-finished = the walls are finished to the depth { $q-depth }
step-finish-slot-floor = If an allowance { $q-floor-allowance } is defined, the control then finishes the floor of the slot from the inside out.
step-leave-slot = The tool leaves the slot at rapid traverse to the 2nd set-up clearance { $q-second-set-up-clearance } (to the set-up clearance if none is entered).
step-end-of-slot = Where the tool is at the end of the cycle depends on the slot position { $q-slot-position }:
say-back-to-slot-centre = { $q-slot-position } = 0: the control returns the tool in the working plane to the centre of the slot
say-stays-in-working-plane = otherwise: the control does not position the tool in the working plane
note-position-at-slot-start = Position the tool at the starting point in the working plane with radius compensation R0. Take the slot position { $q-slot-position } into account.
note-position-at-slot-start__circular-slot = Position the tool at the starting point in the working plane with radius compensation R0. Take the reference for the slot position { $q-slot-position-reference } into account.
note-slot-end-position = At the end of the cycle the control returns the tool in the working plane to the centre of the slot. Exception: if a slot position { $q-slot-position } other than 0 is defined, it only positions the tool in the tool axis at the 2nd set-up clearance. Before the cycle is called again, move the tool back to the starting position, or program absolute traverses before the call.
note-wide-slot-is-cleared = If the slot is wider than twice the tool diameter, the control clears it from the inside out accordingly. Slots of any width can therefore be milled with small tools, too.

# --- 254 ---
cycle-circular-slot = Circular slot
    .nc = CIRCULAR SLOT
    .purpose = Machines a circular slot, or several of them on a pitch circle, completely: roughing, floor finishing and side finishing. It can also do only roughing, only floor and side finishing, only floor finishing or only side finishing.
step-move-over-circular-slot = The control positions the tool in the tool axis at the 2nd set-up clearance { $q-second-set-up-clearance } (at the set-up clearance if none is entered), then over the starting point of the slot, and then at the set-up clearance { $q-set-up-clearance }, all at rapid traverse.
step-plunge-in-circular-slot = The tool plunges in the middle of the slot width to the next plunging depth { $q-plunging-depth }. The parameter { $q-plunging-strategy } determines how:
until-all-slots-milled = all slots ({ $q-number-of-operations }) are milled; each one is turned by { $q-pattern-stepping-angle } about the centre of the pitch circle
step-end-of-circular-slot = Where the tool is at the end of the cycle depends on the reference for the slot position { $q-slot-position-reference }:
say-back-to-pitch-circle-centre = { $q-slot-position-reference } = 0: the control returns the tool in the working plane to the starting point (the centre of the pitch circle)
condition-slot-at-entered-centre = the position of the slot follows from the entered centre of the pitch circle ({ $q-slot-position-reference } = 0)
note-circular-slot-end-position = At the end of the cycle the control returns the tool in the working plane to the starting point (the centre of the pitch circle). Exception: if a slot position { $q-slot-position-reference } other than 0 is defined, it only positions the tool in the tool axis at the 2nd set-up clearance. In this case always program absolute traverses after the cycle call.
note-circular-slot-with-pattern = If cycle 254 (circular slot) is combined with cycle 221, the slot position must not have the value 0.

# --- 256 ---
cycle-rectangular-stud = Rectangular stud
    .nc = RECTANGULAR STUD
    .purpose = Machines a rectangular stud. If the blank is larger than the greatest possible stepover, the control takes several stepovers until the finished dimensions are reached.
step-move-to-stud-approach = The tool moves from the starting position of the cycle (the centre of the stud) to the starting position for machining the stud. The parameter { $q-stud-approach-position } determines it:
say-approach-beside-blank = { $q-stud-approach-position } = 0 (standard setting): 2 mm beside the stud blank, to the right of it
say-approach-at-stud-corner = otherwise: at the chosen corner
step-rapid-down-to-set-up-clearance = If the tool is at the 2nd set-up clearance, the control moves it at rapid traverse (FMAX) to the set-up clearance { $q-set-up-clearance }.
step-feed-to-plunging-depth-of-stud = The tool moves at the feed rate for plunging { $q-plunging-feed } to the next plunging depth { $q-plunging-depth }.
step-mill-around-stud = The tool then approaches the contour of the stud tangentially and mills one revolution.
step-mill-around-stud-again = If one revolution does not reach the finished dimensions, the control steps over at the present plunging depth and mills another revolution, allowing for the dimensions of the blank, the finished dimensions and the permitted stepover. This is repeated until the finished dimensions are reached. If the starting point lies at a corner ({ $q-stud-approach-position } not 0), the control mills on a spiral from the starting point inwards until the finished dimensions are reached.
step-leave-stud-to-start = If more infeeds are needed, the tool departs from the contour tangentially and returns to the starting point of the stud.
until-stud-depth-reached = the programmed depth { $q-depth } of the stud is reached
step-retract-from-stud = At the end of the cycle the control positions the tool in the tool axis only. The end position therefore differs from the starting position:
note-position-at-stud-start = Position the tool at the starting point in the working plane with radius compensation R0. Take the stud position { $q-stud-position } into account.
note-room-beside-stud = Danger of collision! Leave enough room on the right of the stud for the approach of the tool: at least the tool diameter + 2 mm.
note-stud-end-position = Danger of collision! At the end the control returns the tool to the set-up clearance, or to the 2nd set-up clearance if one is entered. The end position of the tool after the cycle therefore does not agree with its starting position.
note-choose-other-approach-position = If the approach with { $q-stud-approach-position } = 0 leaves marks on the surface of the stud, choose another approach position.

# --- 257 ---
cycle-circular-stud = Circular stud
    .nc = CIRCULAR STUD
    .purpose = Machines a circular stud. If the diameter of the blank is larger than the greatest possible stepover, the control takes several stepovers until the finished diameter is reached.
step-move-to-circular-stud-approach = The tool moves from the starting position of the cycle (the centre of the stud) to the starting position for machining the stud. The parameter { $q-stud-starting-angle } determines it as a polar angle with respect to the centre of the stud.
step-mill-spiral-around-stud = The tool then approaches the contour of the stud tangentially on a spiral and mills one revolution.
step-keep-spiral-to-finished-diameter = If one revolution does not reach the finished diameter, the control keeps feeding in on the spiral until it does, allowing for the diameter of the blank, the finished diameter and the permitted stepover.
step-leave-stud-on-spiral = The control departs from the contour on a spiral.
step-next-infeed-near-departure = If several infeeds are needed, the next one takes place at the point nearest to the departure.
step-retract-and-return-to-stud-centre = At the end of the cycle, after the departure on a spiral, the control positions the tool in the tool axis at the 2nd set-up clearance { $q-second-set-up-clearance } (at the set-up clearance if none is entered) and then at the centre of the stud.
note-position-at-stud-centre = Position the tool at the starting point (the centre of the stud) in the working plane with radius compensation R0.
note-circular-stud-end-height = Danger of collision! At the end the control returns the tool to the set-up clearance, or to the 2nd set-up clearance if one is entered. In the tool axis its end position after the cycle may therefore differ from its starting position.

# --- 221 ---
cycle-line-pattern = Point pattern on lines
    .nc = CARTESIAN PATTERN
    .purpose = Executes the machining cycle that was defined last at points in lines and columns.
until-line-done = all { $q-number-of-columns } machining operations of the line are done; the tool is at the last point of the line
step-move-to-next-column = The control then moves the tool to the starting point of the next machining operation, in the first, third, fifth line … in the positive direction of the main axis, in the second, fourth, sixth line … in the negative direction, and there to the set-up clearance { $q-set-up-clearance }.
step-height-between-lines = At the last point of the line the tool moves in the spindle axis to the height between the machining operations that { $q-pattern-clearance-mode } defines.
step-move-to-next-line = The control then moves the tool to the next line, straight to the point of the same column, and there to the set-up clearance { $q-set-up-clearance }. All further lines are machined in this way, back and forth.
until-all-lines-done = all { $q-number-of-lines } lines are done
note-pattern-overrides-heights-and-rotation = If one of the machining cycles 200 to 209 and 251 to 267 is combined with this cycle, the set-up clearance { $q-set-up-clearance }, the workpiece surface coordinate { $q-surface-coordinate }, the 2nd set-up clearance { $q-second-set-up-clearance } and the angle of rotation { $q-angle-of-rotation } of this cycle apply.

# --- common to surfaces ---
until-surface-milled = the entered surface is milled completely
note-pre-position-for-surface = Danger of collision! Pre-position the tool so that it cannot collide with the workpiece or its clamping.

# --- 230 ---
cycle-multipass-milling = Multipass milling
    .nc = MULTIPASS MILLING
    .purpose = Mills a flat rectangular surface in lines, to and fro.
step-rapid-to-start-of-lines = The control positions the tool at rapid traverse (FMAX) from its present position in the working plane at starting point 1, offset by the tool radius to the left and upwards.
step-down-to-start-of-lines = The tool then moves in the spindle axis at rapid traverse (FMAX) to the set-up clearance { $q-set-up-clearance } and from there at the feed rate for plunging { $q-plunging-feed } to the programmed starting position { $q-starting-point-tool } in the spindle axis.
step-mill-line = The tool then mills at the programmed feed rate { $q-milling-feed } to end point 2, which the control calculates from the starting point, the programmed length { $q-first-side-length } and the tool radius.
step-step-over-to-next-line = The control moves the tool across at the feed rate { $q-stepover-feed } to the starting point of the next line. It calculates the offset from the programmed width { $q-second-side-length } and the number of cuts { $q-number-of-cuts }.
step-mill-back-in-next-line = The tool then returns in the negative direction of the 1st axis.
step-rapid-back-to-clearance-over-surface = At the end the control retracts the tool at rapid traverse (FMAX) to the set-up clearance { $q-set-up-clearance }.
note-plane-first-then-spindle-axis = From the present position the control positions the tool first in the working plane and then in the spindle axis at the starting point.

# --- 231 ---
cycle-ruled-surface = Ruled surface
    .nc = RULED SURFACE
    .purpose = Mills an oblique, inclined or twisted surface that is defined by four corner points, in lines that all run in the same direction.
step-straight-to-starting-point = The control moves the tool from its present position on a straight line in space to starting point 1.
step-mill-line-to-its-end = The tool then mills at the programmed feed rate { $q-milling-feed } to the end point of the line: in the first line to point 2, at half the feed rate; in each further one to a point that the control calculates from point 2 and the offset towards point 3.
step-rapid-back-to-start-of-line = From there the control moves the tool at rapid traverse (FMAX) in the positive direction of the spindle axis to one tool diameter above the higher end of the line, and then back to the starting point of the line (in the first line point 1).
step-down-to-last-height = At the starting point the control moves the tool to the value in the spindle axis that it had there last.
step-move-to-start-of-next-line = The control then moves the tool in all three axes from point 1 towards point 4 to the next line.
step-above-highest-point = At the end the control positions the tool one tool diameter above the highest entered point in the spindle axis.
note-cutting-direction-of-surface = The starting point, and with it the direction of milling, can be chosen freely: the control takes the individual cuts from point 1 to point 2, and machining as a whole proceeds from points 1 and 2 to points 3 and 4. Point 1 may lie at any corner of the surface.
note-surface-quality-with-end-mills = With end mills the quality of the surface can be improved: by a pushing cut (spindle-axis coordinate of point 1 greater than that of point 2) on slightly inclined surfaces; by a drawing cut (spindle-axis coordinate of point 1 less than that of point 2) on steep surfaces; on twisted surfaces by laying the main cutting direction (from point 1 to point 2) in the direction of the steeper inclination.
note-surface-quality-with-ball-end-mills = With ball-end mills the quality of twisted surfaces can be improved by laying the main cutting direction (from point 1 to point 2) perpendicular to the direction of the steepest inclination.
note-straight-to-start-without-collision = Danger of collision! The control moves the tool from its present position on a straight line in space to starting point 1. Pre-position the tool so that it cannot collide with the workpiece or its clamping.
note-positions-with-r0 = The control moves the tool between the entered positions with radius compensation R0.
note-centre-cut-or-pilot-drill = If necessary, use an end mill with a centre-cutting tooth (DIN 844), or pre-drill with cycle 21.

# --- 232 ---
cycle-face-milling = Face milling
    .nc = FACE MILLING
    .purpose = Mills a flat surface in several infeeds and with a finishing allowance, using one of three strategies.
step-position-beside-surface = From its present position the control positions the tool at rapid traverse (FMAX) with positioning logic at starting point 1, which lies beside the workpiece, offset from it by the tool radius and the clearance to the side { $q-side-clearance }:
say-plane-then-spindle-axis = if the tool is above the 2nd set-up clearance { $q-second-set-up-clearance }: first in the working plane, then in the spindle axis
say-second-clearance-then-plane = otherwise: first to the 2nd set-up clearance { $q-second-set-up-clearance }, then in the working plane
step-feed-to-face-infeed = The tool then moves in the spindle axis at the feed rate for pre-positioning { $q-pre-positioning-feed } to the next infeed depth, which the control has computed.
step-mill-face-line = The tool mills at the programmed feed rate { $q-milling-feed } to end point 2:
say-line-ends-outside-surface = { $q-face-milling-strategy } = 0: outside the surface; the control calculates it from the programmed starting point, length and clearance to the side { $q-side-clearance } and the tool radius
say-line-ends-inside-surface = { $q-face-milling-strategy } = 1: inside the surface; the control calculates it from the programmed starting point and length and the tool radius
say-line-ends-outside-surface-by-lines = { $q-face-milling-strategy } = 2: outside the surface; the control calculates it from the programmed starting point, length and clearance to the side { $q-side-clearance } and the tool radius
step-step-over-on-face = The control calculates the offset from the programmed width { $q-second-side-length }, the tool radius and the maximum path overlap factor { $q-max-path-overlap }, and moves the tool across to the starting point of the next line:
say-step-over-outside = { $q-face-milling-strategy } = 0: at the feed rate for pre-positioning { $q-pre-positioning-feed }
say-step-over-inside = { $q-face-milling-strategy } = 1: within the workpiece, at the feed rate for milling { $q-milling-feed }
say-retract-and-return-to-next-line = { $q-face-milling-strategy } = 2: the tool moves in the spindle axis to the set-up clearance { $q-set-up-clearance } above the present infeed depth and at the feed rate for pre-positioning { $q-pre-positioning-feed } directly back to the starting point of the next line
step-mill-next-face-line = The tool then mills the next line:
say-back-towards-start = { $q-face-milling-strategy } = 0: back in the direction of starting point 1
say-back-towards-start-inside = { $q-face-milling-strategy } = 1: back in the direction of starting point 1; the move to the next line again takes place within the workpiece
say-down-and-towards-end = { $q-face-milling-strategy } = 2: it moves to the present infeed depth again and then in the direction of end point 2
step-repeat-until-face-milled = This is repeated until the entered surface is milled completely. At the end of the last path the tool is fed in to the next machining depth. To avoid idle travel, the surface is then machined in the reverse sequence.
until-face-infeeds-done = all infeeds but the last one are done
step-finish-face = With the last infeed only the entered finishing allowance { $q-floor-allowance } is milled, at the feed rate for finishing { $q-finishing-feed }.
step-rapid-back-to-second-clearance = At the end the control retracts the tool at rapid traverse (FMAX) to the 2nd set-up clearance { $q-second-set-up-clearance }.
note-three-face-milling-strategies = Three strategies are available. { $q-face-milling-strategy } = 0: meandering paths, stepover outside the surface to be machined. { $q-face-milling-strategy } = 1: meandering paths, stepover inside the surface to be machined. { $q-face-milling-strategy } = 2: line by line, with retraction and stepover at the feed rate for positioning.
note-levels-in-reverse-order = To avoid idle travel, each further level is machined in the reverse sequence.
note-second-clearance-without-collision = Enter the 2nd set-up clearance { $q-second-set-up-clearance } so that the tool cannot collide with the workpiece or its clamping.
note-equal-end-and-start-do-nothing = If the starting point in the 3rd axis { $q-starting-point-tool } and the end point in the 3rd axis { $q-end-point-tool } are equal, the control does not execute the cycle (the programmed depth is 0).
