# Contour, cylinder surface and engraving cycles.

# --- common ---
step-retract-to-contour-clearance-height = The tool retracts to the clearance height at the feed rate { $q-contour-retraction-feed }, or at { $q-roughing-feed } if it is 0.
step-leave-to-contour-clearance-height = The tool moves to the clearance height.
until-contour-depth-reached = the programmed depth is reached
until-parts-of-contour-cleared = all separate areas of the contour are machined
note-contour-element-limit = The memory for an SL cycle is limited. At most 16384 contour elements can be programmed in one SL cycle.
note-sign-of-milling-depth = The sign of the milling depth determines the working direction. With depth 0 the control does not execute the cycle.
note-both-axes-after-contour-cycle = Danger of collision! After an SL cycle, program the first movement in the working plane with both coordinates, for example L X+80 Y+0 R0 FMAX.
note-contour-cycle-properties = The control automatically positions the tool at the set-up clearance before each cycle. Each level is milled without lifting the tool; the tool goes round islands sideways. The radius of inside corners can be programmed: the tool does not stop there and leaves no marks (this applies to the outermost path of roughing and for side finishing). For side finishing the control approaches the contour on a tangential arc, for floor finishing it approaches the workpiece on a tangential arc as well (with the spindle axis Z in the plane Z/X). The contour is machined throughout in climb or in up-cut milling.
note-contour-tool-by-name = The tool can be entered by its number or by its name. To enter the name, press the soft key TOOL NAME; the control adds the quotation marks automatically when you leave the field.
note-global-def-for-contours = The function GLOBAL DEF for contour milling presets set-up clearance, clearance height, overlap factor and type of milling for the cycles 20, 22, 23, 24 and 25.

# --- 14 ---
cycle-contour = Contour
    .nc = CONTOUR
    .purpose = Lists all subprograms that are superimposed to form one contour. The control calculates the whole contour from these partial contours, which are pockets or islands.
step-remember-contour-labels = The control keeps the label numbers. The cycles that follow machine the contour that the subprograms describe.
note-contour-acts-from-definition = The cycle acts from its definition in the program.
note-most-contour-labels = Up to 12 subprograms (partial contours) can be listed.
note-transformations-in-contour = Coordinate transformations are allowed. If they are programmed within a partial contour, they also act in the subprograms that follow; they need not be reset after the cycle call.
note-pocket-and-island-recognized = The control recognizes a pocket if the tool moves inside the contour, for example clockwise with radius compensation RR. It recognizes an island if the tool moves outside the contour, for example clockwise with radius compensation RL.
note-contour-without-spindle-axis = The subprograms must not contain coordinates in the spindle axis.
note-contour-begins-with-both-axes = In the first block of the subprogram always program both axes.
note-parameters-within-contour = If Q parameters are used, calculate and assign them only within the contour subprogram concerned.
note-contours-may-overlap = Pockets and islands can be superimposed to form a new contour. An overlapping pocket makes the area of a pocket larger or an island smaller.
note-contour-intersections-computed = The control calculates the points of intersection of the partial contours; they need not be programmed.
note-contour-sum = Area of inclusion (both areas A and B including the common one): A and B must be pockets. The first pocket in the list must begin outside the second one.
note-contour-difference = Area of exclusion (A without what B covers): A must be a pocket, B an island. A must begin outside B, B must begin inside A.
note-contour-intersection = Area of intersection (only what A and B both cover): A and B must be pockets. A must begin inside B.
note-machining-data-in-contour-data = Machining data such as milling depth, allowances and set-up clearance are entered centrally in cycle 20.
note-contour-cycle-or-sel-contour = The cycle is not needed if the contour is selected with SEL CONTOUR.
note-contour-for-turning = Turning cycles that machine a contour also need this cycle: it must be programmed before their call and gives the number of the subprogram.

# --- 20 ---
cycle-contour-data = Contour data
    .nc = CONTOUR DATA
    .purpose = Holds the machining data for the subprograms with the partial contours.
step-remember-contour-data = The control keeps the machining data for the cycles 21 to 24.
note-contour-data-act-from-definition = The cycle acts from its definition in the program. The machining data hold only for the cycles 21 to 24.
note-parameters-reserved-for-contours = If SL cycles are used in programs with Q parameters, the parameters Q1 to Q20 must not be used as program parameters.
note-contour-data-at-interruption = When the program is interrupted, the machining parameters can be checked and, if necessary, overwritten.

# --- 21 ---
cycle-pilot-drilling = Pilot drilling
    .nc = PILOT DRILLING
    .purpose = Drills at the infeed points of the contour, which are also the starting points for roughing.
step-position-at-pilot-holes = The control determines the infeed points of the contour.
step-move-over-pilot-hole = The control positions the tool over the infeed point at the set-up clearance.
step-drill-pilot-hole-to-plunging-depth = The tool drills at the feed rate { $q-contour-plunging-feed } to the plunging depth, which is { $q-contour-plunging-depth } deeper with each infeed.
step-retract-and-return-to-stop-distance = The control retracts the tool at rapid traverse (FMAX) and returns it to the advanced stop distance t above the depth reached.
until-drilling-depth-reached = the drilling depth is reached
step-dwell-and-retract-to-start = At the bottom of the hole the tool dwells to cut free and then retracts at rapid traverse (FMAX) to the starting position.
until-pilot-holes-drilled = all infeed points are drilled
note-stop-distance-determined = The control determines the advanced stop distance t automatically: 0.6 mm with a drilling depth up to 30 mm, one fiftieth of the drilling depth if that exceeds 30 mm, but never more than 7 mm.
note-infeed-points-consider = For the infeed points the control takes into account the finishing allowances for side and floor and the radius of the rough-out tool.
note-delta-radius-not-considered-for-infeed-points = To calculate the infeed points the control does not take into account a delta value DR programmed in the TOOL CALL block.
note-narrow-places-not-pre-drilled = At narrow places the control may not be able to pre-drill with a tool that is larger than the rough-out tool.

# --- 22 ---
cycle-rough-out = Rough-out
    .nc = ROUGH-OUT
    .purpose = Clears the contour down to the floor allowance, level by level, or machines only what a coarser tool has left.
step-position-over-infeed-point = The control positions the tool over the infeed point, taking the finishing allowance for side into account.
step-take-depths-of-partial-contours = The control machines a partial contour with its own depth down to that depth, all others down to the milling depth of the contour data.
step-go-to-infeed-point = The tool moves at rapid traverse over the infeed point and down to the set-up clearance above what has been machined.
step-plunge-to-contour-level = The tool moves to the next plunging depth, { $q-contour-plunging-depth } deeper:
say-plunge-vertically-without-reciprocation = { $q-reciprocation-feed } = 0: vertically at the feed rate { $q-contour-plunging-feed }, even if a plunging angle { $mp-plunging-angle } is defined for the active tool
say-plunge-vertically-at-reciprocation-feed = { $mp-plunging-angle } = 90°: vertically at the reciprocation feed rate { $q-reciprocation-feed }
say-plunge-on-helix-or-in-strokes = otherwise on a helix at the plunging angle { $mp-plunging-angle }, or with reciprocating movements where a helix is not possible
step-rough-contour-level = At this depth the tool mills the contour from the inside out at the feed rate { $q-roughing-feed }; around islands it mills on paths that come closer to the contour of the pocket. It machines:
say-rough-what-coarser-tool-left = if a coarse roughing tool { $q-coarse-roughing-tool } is entered, only what that tool could not machine
say-rough-whole-region = otherwise the whole area
message-contour-material-left = The tool does not reach all of the contour: it leaves material in corners or narrow places.
note-centre-cutting-or-pilot-drilling = If necessary, use a centre-cutting end mill (DIN 844) or pre-drill with cycle 21.
note-rough-out-plunging = How the tool plunges is determined by the parameter { $q-reciprocation-feed } and by the columns { $mp-plunging-angle } and { $mp-cutting-edge-length } of the tool table. With { $q-reciprocation-feed } = 0 it always plunges vertically. With { $mp-plunging-angle } = 90° it plunges vertically at the feed rate { $q-reciprocation-feed }. With a reciprocation feed rate and { $mp-plunging-angle } from 0.1 to 89.999 it plunges on a helix at that angle. With a reciprocation feed rate and no { $mp-plunging-angle } in the tool table the control reports an error. If there is no room for a helix (as in a slot), the control tries to plunge in strokes; their length is { $mp-cutting-edge-length } / tan { $mp-plunging-angle }.
note-overlap-greater-than-one = With an overlap factor greater than 1, material may remain in pocket contours with sharp inside corners. Check the innermost path in the test graphics and change the overlap factor slightly if necessary. The cuts are then distributed differently, which often gives the desired result.
note-wear-of-coarse-tool-not-considered = For fine roughing the control does not take into account a defined wear value DR of the coarse roughing tool.
note-fine-roughing-needs-tool-data = If the area for fine roughing cannot be approached from the side, the tool plunges in strokes. For this, define the length of the cutting edge { $mp-cutting-edge-length } and the greatest plunging angle { $mp-plunging-angle } of the tool in the tool table; otherwise the control may report an error.

# --- 23 ---
cycle-floor-finishing = Floor finishing
    .nc = FLOOR FINISHING
    .purpose = Removes the finishing allowance that roughing has left on the floor.
step-approach-contour-floor = The tool approaches the floor smoothly on a vertical tangential arc if there is enough room. Otherwise it moves vertically to the depth at the feed rate { $q-contour-plunging-feed }.
step-find-start-of-floor-finishing = The control determines the starting point for finishing the floor.
step-finish-contour-floor = The tool mills off the finishing allowance that roughing has left, at the feed rate { $q-roughing-feed }.
note-starting-point-by-itself = The control determines the starting point for finishing automatically. It depends on the room in the pocket.
note-approach-radius-is-fixed = The radius for the approach to the final depth is fixed internally and does not depend on the plunging angle of the tool.

# --- 24 ---
cycle-side-finishing = Side finishing
    .nc = SIDE FINISHING
    .purpose = Finishes the sides of the contour. Each partial contour is finished separately.
step-find-start-of-side-finishing = The control determines the starting point for finishing.
step-finish-partial-contour = The control moves the tool to the next plunging depth, { $q-contour-plunging-depth } deeper, at the feed rate { $q-contour-plunging-feed }, brings it tangentially on an arc to the partial contour, and finishes the partial contour at the feed rate { $q-roughing-feed }.
until-partial-contours-finished = every partial contour is finished
note-side-finishing-allowances = The sum of the finishing allowance for side { $q-remaining-side-allowance } and the radius of the finishing tool must be smaller than the sum of the finishing allowance for side of cycle 20 and the radius of the rough-out tool.
note-side-finishing-without-roughing = The same holds if the cycle is executed without previous roughing with cycle 22; the radius of the rough-out tool then counts as 0.
note-side-finishing-mills-contours = The cycle can also be used to mill contours. For this, define the contour as a single island (without the limit of a pocket) and enter a finishing allowance for side in cycle 20 that is greater than the sum of the finishing allowance { $q-remaining-side-allowance } and the radius of the tool.
note-start-depends-on-room-and-allowance = The control determines the starting point for finishing automatically. It depends on the room in the pocket and on the allowance programmed in cycle 20.
note-start-depends-on-sequence = The starting point also depends on the sequence of machining. If the finishing cycle is selected with the key GOTO and the program is then started, the starting point can differ from the one that results when the program is executed from start to end.

# --- 25 ---
cycle-contour-train = Contour train
    .nc = CONTOUR TRAIN
    .purpose = Machines open and closed contours, together with cycle 14. Unlike with positioning blocks along the contour, the control monitors the machining, mills throughout in climb or up-cut, and can mill back and forth and with allowances.
step-position-over-contour-start = The control moves the tool to the clearance height { $q-contour-clearance-height } and over the starting point of the contour.
step-plunge-beside-contour = The tool moves at the feed rate { $q-contour-plunging-feed } to the next plunging depth, { $q-contour-plunging-depth } deeper.
step-mill-along-contour = The tool mills along the contour at the feed rate { $q-contour-milling-feed }, leaving the finishing allowance { $q-side-allowance }:
say-mill-to-and-fro = { $q-contour-milling-type } = 0: back and forth, climb and up-cut milling in turn with each infeed
say-mill-in-one-direction = { $q-contour-milling-type } = +1 or −1: in every infeed in climb or in up-cut milling
until-milling-depth-reached = the milling depth { $q-milling-depth } is reached
note-contour-damage-monitored = The control monitors the machining so that neither undercuts nor damage to the contour occur. Check the contour with a graphic test.
note-inside-corners-may-need-reworking = If the tool radius is too large, inside corners of the contour may have to be reworked.
note-milling-type-kept-when-mirrored = The contour can be machined throughout in climb or in up-cut milling. The type of milling is kept even if contours are mirrored.
note-several-infeeds-to-and-fro = With several infeeds the control can move the tool back and forth, which makes the machining time shorter.
note-contour-in-several-operations = Allowances can be entered, so that roughing and finishing can be done in several operations.
note-only-first-contour-label = The control uses only the first label of cycle 14.
note-contour-data-not-needed = Cycle 20 is not needed.
note-corner-feed-functions-without-effect = The miscellaneous functions M109 and M110 have no effect when a contour is machined with this cycle.
note-no-incremental-after-contour-train = Danger of collision! Do not program incremental dimensions after the cycle: they refer to the position of the tool at the end of the cycle.
note-absolute-position-after-contour-train = Danger of collision! After the cycle move the tool to a defined (absolute) position in all main axes, because its position at the end of the cycle is not its position at the beginning.

# --- 27 to 29 ---
step-plunge-into-cylinder = The tool moves at the feed rate { $q-contour-plunging-feed } to the next plunging depth, { $q-contour-plunging-depth } deeper.
until-cylinder-milling-depth-reached = the programmed milling depth { $q-cylinder-milling-depth } is reached
step-return-in-tool-axis = The tool returns in the tool axis to the clearance height or to the position that was programmed last before the cycle.
guard-clearance-within-tool-radius = The set-up clearance is not greater than the tool radius.
guard-spindle-not-across-rotary-axis = The spindle axis is not perpendicular to the axis of the rotary table.
guard-datum-off-rotary-axis = The datum is not on the axis of the rotary table: the cylinder would not run true.
guard-depth-out-of-cylinder = The milling depth is positive: the tool would move away from the cylinder axis.
guard-slot-core-left = The slot is more than twice as wide as the tool: a core of material stays between the walls.
note-contour-in-development = Describe the contour in a subprogram that is selected with cycle 14, always with the coordinates X and Y, whatever rotary axes the machine has. The contour then does not depend on the configuration of the machine.
note-prepare-for-cylinder-interpolation = The machine builder must prepare machine and control for cylinder surface interpolation. Refer to the machine manual.
note-contour-begins-with-both-coordinates-of-cylinder = In the first NC block of the contour subprogram always program both coordinates of the cylinder surface.
note-centre-cutting-end-mill = Use a centre-cutting end mill (DIN 844).
note-cylinder-centred-on-rotary-table = The cylinder must be clamped in the centre of the rotary table.
note-datum-in-centre-of-rotary-table = Set the datum in the centre of the rotary table.
note-spindle-across-rotary-axis = When the cycle is called, the spindle axis must be perpendicular to the axis of the rotary table. Otherwise the control reports an error. It may be necessary to switch the kinematics.
note-cylinder-in-tilted-plane = The cycle can also be used with a tilted working plane.
note-clearance-greater-than-tool-radius = The set-up clearance { $q-cylinder-set-up-clearance } must be greater than the tool radius.
note-many-contour-elements-take-time = Machining can take longer if the contour consists of many contour elements that are not tangential.

# --- 27 ---
cycle-cylinder-surface = Cylinder surface
    .nc = CYLINDER SURFACE
    .purpose = Transfers a contour that is defined on the unrolled surface to the surface of a cylinder.
step-mill-along-developed-contour = The tool mills along the programmed contour at the feed rate { $q-contour-milling-feed }.
step-back-over-infeed-point = At the end of the contour the control moves the tool to the set-up clearance { $q-cylinder-set-up-clearance } and back over the infeed point.
step-end-at-cylinder-clearance = The tool moves to the set-up clearance { $q-cylinder-set-up-clearance }.
note-functions-for-developed-contour = For the path of the tool the functions L, CHF, CR, RND and CT are available.
note-angular-axis-unit = The values for the angular axis (X coordinates) can be entered in degrees or in millimetres (inches); { $q-development-dimension-type } determines which.
note-guide-slots-with-other-cycle = To mill guide slots on a cylinder, use cycle 28.

# --- 28 ---
cycle-cylinder-surface-slot = Cylinder surface – slot milling
    .nc = CYLINDER SURFACE
    .purpose = Transfers a guide slot that is defined on the unrolled surface to the surface of a cylinder, with walls that are nearly parallel.
step-position-over-slot-infeed-point = The control positions the tool over the infeed point.
step-mill-along-slot-wall = The tool mills along the wall of the slot at the feed rate { $q-contour-milling-feed }, leaving the finishing allowance for side { $q-side-allowance }.
step-mill-back-along-opposite-wall = At the end of the contour the control moves the tool to the opposite wall of the slot and back to the infeed point.
step-rework-slot-walls = If a tolerance { $q-cylinder-slot-tolerance } is defined, the control reworks the slot so that its walls are as parallel as possible.
note-walls-nearly-parallel = Unlike cycle 27, this cycle adjusts the tool so that with active radius compensation the walls are nearly parallel. They are exactly parallel with a tool that is exactly as wide as the slot.
note-small-tool-distorts-slot = The smaller the tool is compared with the slot width, the larger are the distortions at arcs and oblique lines. To make them smaller, define the tolerance { $q-cylinder-slot-tolerance }: the control then brings the slot close to one that is milled with a tool as wide as the slot.
note-program-centre-path-of-slot = Program the centre path of the contour with radius compensation. The radius compensation determines whether the control mills the slot in climb or in up-cut milling.

# --- 29 ---
cycle-cylinder-surface-ridge = Cylinder surface – ridge milling
    .nc = CYLINDER SURFACE RIDGE
    .purpose = Transfers a ridge that is defined on the unrolled surface to the surface of a cylinder, with parallel walls.
step-position-over-ridge-start = The control positions the tool over the starting point of machining, which it calculates from the width of the ridge and the diameter of the tool: beside the first point of the contour subprogram, offset by half the ridge width plus the tool diameter. The radius compensation determines the side: left of the ridge (climb milling) or right of it (up-cut milling).
step-approach-ridge-wall = At this depth the tool moves to the contour on a tangential arc at the feed rate { $q-contour-milling-feed }, leaving the finishing allowance for side { $q-side-allowance } if one is defined.
step-mill-along-ridge-wall = The tool mills along the wall of the ridge at the feed rate { $q-contour-milling-feed } until the ridge is complete.
step-leave-ridge-wall = The tool leaves the wall of the ridge tangentially and returns to the starting point of machining.
note-ridge-walls-parallel = The cycle adjusts the tool so that with active radius compensation the walls are always parallel.
note-program-centre-path-of-ridge = Program the centre path of the ridge with radius compensation. The radius compensation determines whether the control mills the ridge in climb or in up-cut milling.
note-ridge-ends-in-semicircles = At the ends of the ridge the control always adds a semicircle; its radius is half the ridge width.

# --- 225 ---
cycle-engraving = Engraving
    .nc = ENGRAVING
    .purpose = Engraves text on a flat surface of the workpiece, along a straight line or along an arc.
step-move-to-first-character = The control positions the tool in the working plane to the starting point of the first character.
step-engrave-character = The tool plunges vertically at the feed rate { $q-plunging-feed } to the floor of the engraving and mills the character at the feed rate { $q-milling-feed }. Where it must be lifted within a character, it moves to the set-up clearance { $q-set-up-clearance }. At the end of the character the tool is at the set-up clearance above the workpiece surface.
step-move-over-next-character = The control moves the tool at the set-up clearance to the starting point of the next character.
until-characters-engraved = all characters are engraved
step-end-engraving-at-second-clearance = The control moves the tool to the 2nd set-up clearance { $q-second-set-up-clearance }.
condition-text-runs-on-arc = { $q-text-arrangement } asks for a text on an arc
note-straight-text-starts-at-tool = For a text along a straight line ({ $q-text-arrangement } = 0) the position of the tool at the cycle call is the starting point of the first character.
note-circle-text-centre-at-tool = For a text along an arc ({ $q-text-arrangement } = 1) the position of the tool at the cycle call is the centre of the circle.
note-text-from-string-parameter = The text can also be given by a string variable (QS).
note-engraving-characters = Characters that can be engraved: small letters, capital letters, digits and the special characters ! # $ % & ' ( ) * + , - . / : ; < = > ? @ [ \ ] _
note-engraving-doubled-characters = The control uses the special characters % and \ for special functions. To engrave one of them, enter it twice in the text, for example %%.
note-engraving-control-characters = The special character \ also introduces characters that are not printed and arrange the text: \n is a line break, \t a horizontal tab (the tab width is 8 characters), \v a vertical tab (the tab width is one line).
note-proportional-font = The font is proportional: each character has its own width. The spacing factor { $q-character-spacing-factor } scales the distance between the characters.
note-engraving-since-software = The cycle exists from software 34059x-02 on.
