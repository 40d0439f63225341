# Pockets.
cycle-rectangular-pocket = Rectangular pocket
    .nc = RECTANGULAR POCKET
    .purpose = Machines a rectangular pocket completely: roughing, floor finishing and side finishing. It can also do only roughing, only floor and side finishing, only floor finishing or only side finishing.
step-move-over-pocket-centre = The control positions the tool in the tool axis at the 2nd set-up clearance { $q-second-set-up-clearance } (at the set-up clearance if none is entered), then over the centre of the pocket, and then at the set-up clearance { $q-set-up-clearance }, all at rapid traverse.
group-roughing = Roughing
step-plunge-at-centre = The tool plunges into the workpiece at the centre of the pocket to the next plunging depth { $q-plunging-depth }. The parameter { $q-plunging-strategy } determines how:
say-plunge-vertically = { $q-plunging-strategy } = 0: vertically at the feed rate { $q-plunging-feed }
say-plunge-helically = { $q-plunging-strategy } = 1: on a helix at the feed rate { $q-plunging-feed }
say-plunge-reciprocating = { $q-plunging-strategy } = 2: with reciprocating movements at the feed rate { $q-plunging-feed }
step-clear-level = The control clears the pocket from the inside out, allowing for the path overlap { $q-path-overlap } and the finishing allowances { $q-side-allowance } and { $q-floor-allowance }. At the end the tool leaves the wall of the pocket tangentially.
step-leave-wall-and-return = The tool moves to the set-up clearance above the present plunging depth and from there at rapid traverse back to the centre of the pocket.
until-roughing-depth-reached = the depth { $q-depth } is reached, less the floor allowance { $q-floor-allowance }
group-finishing = Finishing
step-rapid-to-first-plunging-depth = If only finishing is programmed ({ $q-machining-operation } = 2), the control moves the tool at the centre of the pocket at rapid traverse to the first plunging depth.
step-finish-side = If an allowance { $q-side-allowance } is defined, the control first finishes the side of the pocket, approaching it tangentially; with { $q-finishing-infeed } in several infeeds.
until-side-finished = the side is finished to the depth { $q-depth }
step-finish-floor = If an allowance { $q-floor-allowance } is defined, the control then finishes the floor of the pocket from the inside out, approaching it tangentially.
step-leave-pocket = The tool leaves the pocket at rapid traverse:
step-return-to-starting-point = The control returns the tool to the starting point in the working plane.
guard-plunging-depth-zero = The plunging depth must be greater than 0.
guard-tool-wider-than-pocket = The tool does not fit into the pocket: less the side allowances, the pocket is narrower than the tool.
guard-plunging-angle-missing = Helical and reciprocating plunging need a plunging angle { $mp-plunging-angle } other than 0 in the tool table.
guard-helix-too-small = The diameter of the helix for plunging is less than twice the tool diameter. The machine parameter { $mp-suppress-plunge-err } switches this check off for centre-cutting tools.
note-without-tool-table-plunge-vertically = If no tool table is active, plunging must always be vertical ({ $q-plunging-strategy } = 0), because no plunging angle can be defined.
note-position-at-pocket-start = Position the tool at the starting point in the working plane with radius compensation R0. Take the pocket position { $q-pocket-position } into account.
note-positions-in-tool-axis-itself = The control positions the tool in the tool axis automatically. Take the 2nd set-up clearance { $q-second-set-up-clearance } into account.
note-returns-to-starting-point = At the end of the cycle the control returns the tool in the working plane to the starting point.
note-clearance-above-chips = Each time a level has been cleared, the tool returns at rapid traverse to the centre of the pocket, at the set-up clearance above the present plunging depth. Choose the set-up clearance so that the tool cannot jam on chips while it moves.
note-helix-diameter-monitored = When plunging on a helix, the control reports an error if the helix diameter it has calculated is less than twice the tool diameter. For centre-cutting tools this check can be switched off with the machine parameter { $mp-suppress-plunge-err }.
note-cutting-edge-limits-infeed = If the cutting edge is shorter than the plunging depth { $q-plunging-depth }, the control reduces the plunging depth to the length { $mp-cutting-edge-length } of the tool table.
note-finishing-only-starts-at-first-depth = Danger of collision! If the cycle is called with machining operation 2 (only finishing), the control moves the tool at rapid traverse at the centre of the pocket to the first plunging depth.
note-point-table-starting-points = If the cycle is called with a point table, the points of the working plane are the starting points of the cycle. To use the spindle-axis coordinate of the table as the coordinate of the starting point, enter 0 as the workpiece surface coordinate { $q-surface-coordinate }.
note-point-table-shifts-datum = If the cycle is called with a point table, the control takes each point as an additional datum shift.
