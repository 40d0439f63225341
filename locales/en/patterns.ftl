# Point patterns.
cycle-circular-pattern = Point pattern on a circle
    .nc = POLAR PATTERN
    .purpose = Executes the machining cycle that was defined last at points on a circle or on an arc.
step-move-to-first-operation = The control moves the tool at rapid traverse from its present position to the starting point of the first machining operation: to the 2nd set-up clearance { $q-second-set-up-clearance } (spindle axis), to the starting point in the working plane, and to the set-up clearance { $q-set-up-clearance } above the workpiece surface (spindle axis).
step-call-last-machining-cycle = From this position the control executes the machining cycle that was defined last.
step-height-between-operations = Between the machining operations the tool moves in the spindle axis:
say-to-second-set-up-clearance = { $q-pattern-clearance-mode } = 1: to the 2nd set-up clearance { $q-second-set-up-clearance }
say-to-set-up-clearance = { $q-pattern-clearance-mode } = 0: to the set-up clearance { $q-set-up-clearance }
step-move-to-next-operation = The control then moves the tool to the starting point of the next machining operation, and there to the set-up clearance { $q-set-up-clearance }:
say-on-the-pitch-circle = { $q-pattern-traverse-type } = 1: on the pitch circle
say-in-a-straight-line = { $q-pattern-traverse-type } = 0: in a straight line
until-all-operations-done = all { $q-number-of-operations } machining operations are done
condition-stepping-angle-computed = no stepping angle { $q-pattern-stepping-angle } is entered
guard-pattern-angles-equal = Starting angle and stopping angle are equal. Enter different angles, or a stepping angle.
note-pattern-is-def-active = The cycle acts from its definition: it automatically calls the machining cycle that was defined last.
note-pattern-overrides-heights = If one of the machining cycles 200 to 209 and 251 to 267 is combined with this cycle, the set-up clearance { $q-set-up-clearance }, the workpiece surface coordinate { $q-surface-coordinate } and the 2nd set-up clearance { $q-second-set-up-clearance } of this cycle apply.
note-pattern-combinations = The cycle can be combined with the machining cycles 200 to 209, 240, 251 to 253, 256, 257, 262 to 265 and 267. Cycle 254 (circular slot) can only be combined with cycle 221.
note-pattern-alternatives = For irregular point patterns use point tables with CYCL CALL PAT. More regular point patterns are available with the function PATTERN DEF.
note-def-active-before-call-active = Cycles that act from their definition should be programmed before cycles that are called. Between the definition and the call of a cycle, program one only if both have no parameters in common that must keep different values.
