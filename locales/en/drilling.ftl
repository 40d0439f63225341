# Drilling cycles.

# --- 200 ---
cycle-drilling = Drilling
    .nc = DRILLING
    .purpose = Drills a hole in one or several infeeds. Between the infeeds the tool is retracted from the hole at rapid traverse.
step-drill-to-plunging-depth = The tool drills at the feed rate { $q-plunging-feed } to the plunging depth, which is { $q-plunging-depth } deeper with each infeed.
step-retract-and-return-to-set-up-clearance = The control retracts the tool at rapid traverse (FMAX) to the set-up clearance, lets it dwell there for { $q-dwell-at-top } if entered, and returns it at rapid traverse (FMAX) to the set-up clearance above the depth reached.
step-dwell-at-hole-bottom = The tool dwells at the bottom of the hole for { $q-dwell-at-bottom }, if entered.
step-rapid-out-of-hole = The tool leaves the bottom of the hole at rapid traverse (FMAX):
say-rapid-to-second-set-up-clearance = to the 2nd set-up clearance { $q-second-set-up-clearance }, if one is entered
say-rapid-back-to-set-up-clearance = otherwise to the set-up clearance { $q-set-up-clearance }
note-position-over-hole-centre = Program a positioning block to the starting point (the centre of the hole) in the working plane with radius compensation R0.
note-point-table-hole-centres = If the cycle is called with a point table, the points of the working plane are the hole centres. To use the spindle-axis coordinate of the table as the coordinate of the starting point, enter 0 as the workpiece surface coordinate { $q-surface-coordinate }.

# --- 205 ---
cycle-universal-pecking = Universal pecking
    .nc = UNIVERSAL PECKING
    .purpose = Drills deep holes in several infeeds, each of which may be smaller than the one before, with chip breaking, an advanced stop distance for the return into the hole, and a starting point below the workpiece surface for pre-drilled holes.
step-feed-to-deepened-starting-point = If a deepened starting point { $q-deepened-starting-point } is entered, the tool moves at the pre-positioning feed rate { $q-pre-positioning-feed } to the set-up clearance above the deepened starting point.
step-drill-on-to-plunging-depth = The tool drills at the feed rate { $q-plunging-feed } towards the plunging depth { $q-plunging-depth }; with chip breaking it stops each time it is { $q-depth-for-chip-breaking } deeper. The plunging depth becomes smaller by the decrement { $q-decrement } with each infeed, if one is entered.
step-break-chip = For chip breaking the tool retracts by { $q-chip-breaking-retraction } at 3000 mm/min.
until-plunging-depth-reached = the plunging depth is reached
step-retract-and-return-to-advanced-stop = The control retracts the tool at rapid traverse (FMAX) to the set-up clearance and returns it at rapid traverse (FMAX) to the advanced stop distance above the depth reached: { $q-upper-advanced-stop-distance } at first, { $q-lower-advanced-stop-distance } at last.
step-dwell-to-cut-free = To cut free, the tool dwells at the bottom of the hole for { $q-dwell-at-bottom }, if entered.
step-feed-back-to-set-up-clearance = The tool retracts at the feed rate { $q-plunging-feed } to the set-up clearance { $q-set-up-clearance }.
step-rapid-on-to-second-set-up-clearance = If a 2nd set-up clearance { $q-second-set-up-clearance } is entered, the tool moves there at rapid traverse (FMAX).
condition-infeeds-decrease = a decrement { $q-decrement } is entered
condition-starting-point-deepened = the deepened starting point { $q-deepened-starting-point } is not 0
guard-starting-point-below-depth = The deepened starting point lies at or below the depth: nothing is left to be drilled.
note-advanced-stop-changes-evenly = If { $q-upper-advanced-stop-distance } and { $q-lower-advanced-stop-distance } differ, the control changes the advanced stop distance evenly between the first and the last infeed.
note-deepened-start-changes-infeed-only = A deepened starting point { $q-deepened-starting-point } only changes the starting point of the infeed. Retractions refer to the workpiece surface coordinate as before.
