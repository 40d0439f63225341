# Relations of values that no control refuses and hardly anybody means; the checker warns.
guard-clearance-height-not-above-surface = The clearance height does not lie above the workpiece surface.
guard-corner-radius-too-great = The corner radius is greater than half of the shorter side.
guard-decrement-too-great = The decrement is not less than the plunging depth: nothing is left of the second infeed.
guard-end-above-start = The end point in the tool axis lies above the starting point: the surface is milled from below.
guard-greatest-below-least = The greatest dimension is below the least one: no workpiece is within such limits.
guard-hole-angles-equal = Two of the holes have the same angle: they do not determine a circle.
guard-least-plunging-depth-too-great = The least plunging depth is greater than the plunging depth.
guard-measuring-angles-equal = Starting angle and end angle of the measurement are equal.
guard-points-identical = Two of the points are the same: no direction or intersection follows from them.
guard-pre-drilled-too-wide = The pre-drilled diameter is not less than the nominal diameter: nothing is left to be milled.
guard-slot-wider-than-long = The slot is wider than long.
guard-thread-pitch-too-great = The thread pitch is not less than the nominal diameter.
