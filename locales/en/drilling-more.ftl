# Drilling cycles: reaming, boring, universal drilling, back boring, bore milling, centring, single-lip drilling.

# --- shared sentences ---
step-retract-at-retraction-feed = The tool retracts at the feed rate { $q-retraction-feed } to the set-up clearance { $q-set-up-clearance }.

# --- 201 ---
cycle-reaming = Reaming
    .nc = REAMING
    .purpose = Reams a hole in one infeed. The tool leaves the hole at a separate feed rate.
step-ream-to-depth = The tool reams at the feed rate { $q-plunging-feed } to the programmed depth { $q-depth }.

# --- 203 ---
cycle-universal-drilling = Universal drilling
    .nc = UNIVERSAL DRILLING
    .purpose = Drills a hole in several infeeds, each of which may be smaller than the one before. Chips can be broken several times before the tool is retracted from the hole.
step-drill-to-decreasing-plunging-depth = The tool drills at the feed rate { $q-plunging-feed } to the next plunging depth. The plunging depth { $q-plunging-depth } becomes smaller by the decrement { $q-decrement } with each infeed, if one is entered.
step-break-chip-or-retract = Between two infeeds the tool moves back:
say-break-chip-by-retraction = with chip breaking, by the retraction { $q-chip-breaking-retraction }, as often as defined in { $q-chip-breaks-before-retraction } before the tool is retracted from the hole
say-retract-and-return-at-rapid = without chip breaking, at the feed rate { $q-retraction-feed } to the set-up clearance, where it dwells for { $q-dwell-at-top } if entered; from there it moves at rapid traverse (FMAX) to the set-up clearance above the depth reached

# --- 240 ---
cycle-centring = Centring
    .nc = CENTERING
    .purpose = Centres a hole to a depth or to a diameter.
step-centre-to-depth-or-diameter = The tool centres at the feed rate { $q-plunging-feed }:
say-centre-to-diameter = { $q-depth-or-diameter } = 1: to the centring diameter { $q-centring-diameter }
say-centre-to-depth = { $q-depth-or-diameter } = 0: to the centring depth { $q-depth }
step-dwell-at-centring-bottom = The tool dwells at the bottom of the centring for { $q-dwell-at-bottom }, if entered.
condition-centring-to-depth = { $q-depth-or-diameter } = 0
condition-centring-to-diameter = { $q-depth-or-diameter } = 1
guard-point-angle-missing = To centre to a diameter, define the point angle { $mp-drill-point-angle } of the tool in the tool table.
guard-depth-zero__centring = The selected depth or diameter is 0: the control does not execute the cycle.
guard-depth-positive__centring = The selected depth or diameter is positive. Enter a negative value, or permit positive values with the machine parameter { $mp-display-depth-err }.
note-sign-of-depth-or-diameter = The sign of the diameter { $q-centring-diameter } or of the depth { $q-depth }, whichever is selected, determines the working direction. With diameter or depth 0 the control does not execute the cycle.
note-positive-diameter-or-depth-reverses = Danger of collision! With a positive diameter or a positive depth the control calculates the pre-position the other way round: the tool moves in the tool axis at rapid traverse to the set-up clearance below the workpiece surface.

# --- 202 ---
cycle-boring = Boring
    .nc = BORING
    .purpose = Bores a hole. At the bottom the spindle is oriented, and the tool can move away from the wall before it is retracted.
step-bore-to-depth = The tool bores at the feed rate { $q-plunging-feed } to the depth { $q-depth }.
step-dwell-with-spindle-turning = To cut free, the tool dwells at the bottom of the hole for { $q-dwell-at-bottom } with the spindle turning, if a time is entered.
step-orient-spindle-to-angle = The control orients the spindle to the position defined in { $q-spindle-orientation-angle }.
step-disengage-from-wall = If a disengagement is selected, the tool moves 0.2 mm (fixed value) in the direction { $q-disengaging-direction }.
step-retract-bored-tool = The tool retracts at the feed rate { $q-retraction-feed } to the set-up clearance { $q-set-up-clearance }. If { $q-disengaging-direction } = 0, it returns along the wall of the hole.
step-restore-spindle-and-coolant = The control restores the spindle and coolant conditions that were active before the cycle call.
note-machine-and-control-prepared = The machine builder must have prepared machine and control for this cycle.
note-servo-controlled-spindle-only = The cycle can only be used on machines with a servo-controlled spindle.
note-spindle-and-coolant-restored = At the end of the cycle the coolant and spindle conditions from before the cycle call are in effect again.
note-disengage-away-from-edge = Danger of collision! Select the disengaging direction { $q-disengaging-direction } so that the tool moves away from the edge of the hole.
note-check-position-of-tool-tip = Danger of collision! Orient the spindle to the angle that is programmed in { $q-spindle-orientation-angle } (for example in the mode Positioning with Manual Data Input) and check where the tool tip is. Select the angle so that the tool tip is parallel to a coordinate axis.
note-disengaging-considers-rotation = When it disengages the tool, the control automatically takes an active rotation of the coordinate system into account.

# --- 204 ---
cycle-back-boring = Back boring
    .nc = BACK BORING
    .purpose = Machines counterbores on the underside of the workpiece.
step-orient-and-offset-tool = The control orients the spindle to { $q-spindle-orientation-angle } and offsets the tool by the off-centre distance { $q-off-centre-distance } in the direction { $q-disengaging-direction }.
step-feed-through-bore = The tool moves at the feed rate for pre-positioning { $q-in-and-out-feed } into the existing hole, until the cutting edge is at the set-up clearance { $q-set-up-clearance } below the lower edge of the workpiece.
step-centre-tool-and-counterbore = The control moves the tool back to the centre of the hole, switches on the spindle and, if necessary, the coolant, and then moves at the feed rate { $q-countersinking-feed } to the depth { $q-counterbore-depth }.
step-dwell-and-leave-counterbore = If { $q-counterbore-dwell } is entered, the tool dwells at the bottom of the counterbore. It then leaves the counterbore; the control orients the spindle and offsets the tool by the off-centre distance again.
step-feed-out-of-bore = The tool moves at the feed rate for pre-positioning { $q-in-and-out-feed } to the set-up clearance { $q-set-up-clearance } above the workpiece surface.
note-back-boring-bars-only = The cycle only works with boring bars for back boring.
note-sign-of-counterbore-depth = The sign of the depth { $q-counterbore-depth } determines the working direction. Caution: with a positive sign the cycle counterbores in the positive direction of the spindle axis.
note-length-to-lower-edge-of-bar = Enter the tool length so that the lower edge of the boring bar is measured, not the cutting edge.
note-edge-height-and-thickness-considered = When it calculates the starting point of the counterbore, the control takes into account the cutting edge height { $q-cutting-edge-height } of the boring bar and the material thickness { $q-material-thickness }.

# --- 208 ---
cycle-bore-milling = Bore milling
    .nc = BORE MILLING
    .purpose = Mills a hole on a helix. If the hole is as wide as the tool, it is drilled directly.
step-rapid-and-approach-hole-circumference = The control moves the tool in the spindle axis at rapid traverse (FMAX) to the set-up clearance { $q-set-up-clearance } above the workpiece surface and then on an arc to the circumference of the hole { $q-nominal-diameter }, if there is enough room.
step-drill-directly-if-diameters-equal = If the diameter { $q-nominal-diameter } equals the tool diameter, the tool drills without a helix directly to the depth { $q-depth }.
step-mill-on-helix = The tool mills at the feed rate { $q-plunging-feed } on a helix that goes down by { $q-infeed-per-helix } with each turn.
step-mill-full-circle-at-depth = At the depth the tool moves in a full circle once more, to remove the material that was left by plunging.
step-return-to-centre-of-hole = The control moves the tool back to the centre of the hole.
step-rapid-back-to-clearance = The tool returns at rapid traverse (FMAX) to the set-up clearance { $q-set-up-clearance }.
guard-tool-wider-than-hole = The diameter of the hole is less than that of the tool.
guard-hole-too-wide-for-tool = The diameter of the hole is more than twice that of the tool. Enter the diameter of the pre-drilled hole, or use a larger tool.
note-equal-diameters-are-drilled = If the entered diameter of the hole is the tool diameter, the control drills without helical interpolation directly to the entered depth.
note-mirroring-keeps-milling-type = An active mirror image does not change the type of milling that is defined in the cycle.
note-infeed-too-large-does-damage = An infeed that is too large damages both the tool and the workpiece.
note-plunging-angle-limits-infeed = To prevent infeeds that are too large, enter the greatest possible plunging angle of the tool in the column { $mp-plunging-angle } of the tool table. The control then calculates the greatest permitted infeed automatically and changes the entered value if necessary.

# --- 241 ---
cycle-single-lip-drilling = Single-lip deep-hole drilling
    .nc = SINGLE-LIP D.H.DRLNG
    .purpose = Drills a deep hole with a single-lip drill, also from a starting point below the workpiece surface. The cycle defines a separate speed and direction of rotation for entering and leaving the hole, and the M functions for the coolant.
step-feed-in-and-switch-on = The control moves the tool at the feed rate for pre-positioning { $q-pre-positioning-feed } to the set-up clearance above the deepened starting point { $q-deepened-starting-point } and there switches on the drilling speed { $q-drilling-speed } with M3 and the coolant with { $q-coolant-on-function }. On the way in, the spindle turns clockwise or counter-clockwise at the speed { $q-speed-in-and-out } or is stationary, as defined in { $q-rotation-in-and-out }.
step-drill-in-one-infeed = The tool drills at the feed rate { $q-plunging-feed } to the depth { $q-depth }.
step-switch-off-coolant-and-reset-speed = The control switches off the coolant with { $q-coolant-off-function } and resets the speed to the value { $q-speed-in-and-out } for the way out.
