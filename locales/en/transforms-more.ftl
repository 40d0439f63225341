# Mirroring, scaling and tilting.

# --- 8 ---
cycle-mirroring = Mirror image
    .nc = MIRROR IMAGE
    .purpose = Mirrors the coordinate system, so that the mirror image of a contour is machined in the working plane.
step-mirror-coordinate-system = From the definition on, the control mirrors the entered axes of the coordinate system about the active datum.
note-reset-mirroring = To reset mirroring, program the cycle again and answer with NO ENT.
note-mirroring-in-status-display = The additional status display shows the mirrored axes.
note-mirroring-and-machining-direction = If only one axis is mirrored, the machining direction of the tool changes; this does not apply to SL cycles. If two axes are mirrored, the machining direction remains the same.
note-mirroring-depends-on-datum = The result of mirroring depends on the position of the datum. If the datum lies on the contour to be mirrored, the element is mirrored directly at the datum. If it lies outside the contour, the element is also displaced.
note-mirroring-and-milling-cycles = If only one axis is mirrored, the machining direction changes in the milling cycles with the numbers 2xx. Exception: cycle 208, in which the direction of rotation defined in the cycle is kept.
note-mirroring-and-thread-direction = The direction of a thread changes if a thread milling cycle is combined with mirroring of only one axis.

# --- 11 ---
cycle-scaling = Scaling
    .nc = SCALING
    .purpose = Enlarges or reduces contours within a program, for example to take shrinkage and allowances into account.
step-scale-coordinate-system = From the definition on, the control multiplies coordinates and radii by the factor.
note-reset-scaling = To reset scaling, program the cycle again with the factor 1.
note-scaling-in-status-display = The additional status display shows the active scaling factor.
note-scaling-acts-on = The factor acts on all three coordinate axes at the same time, and on dimensions entered in cycles.
note-shift-datum-before-scaling = Before enlarging or reducing, the datum should be shifted to an edge or a corner of the contour.
note-scaling-limits = Enlargement: factor greater than 1 up to 99.999999. Reduction: factor less than 1 down to 0.000001.

# --- 26 ---
cycle-axis-scaling = Axis-specific scaling
    .nc = AXIS-SPECIFIC SCALING
    .purpose = Takes shrinkage and allowances into account with a separate factor in each axis.
step-scale-each-axis = From the definition on, the control stretches or compresses the contour in each entered axis by its factor, outwards from the centre or towards it.
note-reset-axis-scaling = To reset the factors, program the cycle again with the factor 1 for the respective axis.
note-arcs-need-equal-factors = Two axes in which arcs are programmed must not be stretched or compressed by different factors.
note-factor-for-each-axis = A separate axis-specific scaling factor can be entered for each coordinate axis.
note-centre-for-all-factors = In addition, the coordinates of a centre can be programmed for all scaling factors.
note-scaled-from-centre = The contour is stretched outwards from the centre or compressed towards it, not necessarily from and to the present datum as in cycle 11.

# --- 19 ---
cycle-working-plane = Working plane
    .nc = WORKING PLANE
    .purpose = Defines the position of the working plane, that is the position of the tool axis with respect to the coordinate system of the machine, by entering tilt angles, for machines with swivel heads or tilting tables.
step-tilt-working-plane = From the definition on, the control tilts the working plane about the active datum.
step-compute-rotary-positions = If the position is programmed with spatial angles, the control calculates the angular positions of the tilting axes that are necessary for it and stores them in the parameters Q120 (A-axis) to Q122 (C-axis). If there are two solutions, it takes the shorter path from the zero position of the rotary axes.
step-position-rotary-axes = If the machine builder has provided for it, the control positions the rotary axes automatically. Otherwise position them in a separate L block after the definition.
step-move-all-axes-after-tilting = Move all axes to let the compensation act in all of them: it acts in an axis as soon as that axis moves in the tilted system.
result-tilted-position-of-a = Computed position of the A-axis
result-tilted-position-of-b = Computed position of the B-axis
result-tilted-position-of-c = Computed position of the C-axis
note-tilting-is-adapted-by-builder = The machine builder adapts the functions for tilting the working plane to the control and the machine. With some swivel heads (tilting tables) the machine builder determines whether the angles programmed in the cycle are taken as coordinates of the rotary axes or as angular components of a tilted plane. Refer to the machine manual.
note-builder-decides-on-rotary-positioning = The machine builder determines whether the cycle positions the rotary axes automatically or whether they must be positioned in the program. Refer to the machine manual.
note-two-ways-to-tilt = The position of the working plane can be defined in two ways: by entering the positions of the tilting axes directly, or by up to three rotations (spatial angles) of the machine's coordinate system. To find the spatial angles, imagine a section perpendicularly through the tilted working plane and look at it along the axis of rotation. Two spatial angles already define any tool position in space.
note-tilted-movements-depend-on-description = The position of the tilted coordinate system, and with it the movements in the tilted system, depend on how the tilted plane is described.
note-tilting-sequence = The sequence of the rotations from which the control calculates the plane is fixed: first the A-axis, then the B-axis, and last the C-axis.
note-tilting-overrides-manual-menu = If tilting for the program run was set to active in the mode Manual Operation, the cycle overwrites the angle entered in that menu.
note-define-all-spatial-angles = Values of rotary axes that are not programmed are always taken as unchanged. Therefore always define all three spatial angles, even if one or more of them are 0.
note-tilting-cancels-look-ahead = If the cycle is used while M120 is active, the control cancels the radius compensation and with it M120.
note-reset-tilt-angles = To reset the tilt angles, define the cycle again with 0° for all rotary axes. Then define it once more and answer the dialog question with NO ENT: this switches the function off.
note-position-rotary-axes-by-hand = When the cycle does not position the rotary axes automatically: with axis angles enter the axis values directly in the L block; with spatial angles use the parameters Q120 (A-axis), Q121 (B-axis) and Q122 (C-axis) that the cycle has written.
note-use-computed-rotary-positions = When positioning by program, always use the positions of the rotary axes stored in Q120 to Q122.
note-avoid-reduced-angles = Avoid functions such as M94 (reduced display of angles), so that actual and nominal positions of the rotary axes do not disagree after several calls.
note-automatic-rotary-positioning = When the cycle positions the rotary axes automatically: only controlled axes can be positioned; besides the tilt angles, a set-up clearance and a feed rate for positioning must be entered in the cycle definition; only preset tools may be used (the full tool length must be defined); the position of the tool tip with respect to the workpiece remains almost unchanged while tilting; the control tilts at the feed rate programmed last, and the greatest feed rate that can be reached depends on the complexity of the swivel head (tilting table).
note-positions-in-tilted-system = After the cycle has been activated, the displayed positions (nominal and actual) and the datum in the additional status display refer to the tilted coordinate system. Directly after the definition the displayed position may therefore differ from the coordinates programmed last before the cycle.
note-limit-switches-in-tilted-system = In the tilted coordinate system the control checks the limit switches only of axes that move. It may report an error.
note-positioning-in-tilted-system = With M130, positions that refer to the untilted coordinate system can be approached in the tilted system, too. Positioning with straight-line blocks that refer to the machine coordinate system (blocks with M91 or M92) is also possible in the tilted working plane, with limitations: there is no length compensation, no compensation of the machine geometry, and radius compensation is not permitted.
note-tilting-with-other-transforms = A datum shift before the cycle shifts the machine coordinate system; a datum shift after it shifts the tilted coordinate system.
note-reset-in-reverse-order = Important: reset the cycles in the reverse order of their definition. Activate the datum shift, then the tilting, then the rotation; machine the workpiece; then reset the rotation, the tilting, and the datum shift.
note-datum-setting-with-tilting = The datum can be set manually by touching, controlled with a HEIDENHAIN 3-D touch probe, or automatically with a HEIDENHAIN 3-D touch probe.
title-rotary-axes-by-hand = Rotary axes positioned in the program
title-rotary-axes-by-control = Rotary axes positioned by the control
