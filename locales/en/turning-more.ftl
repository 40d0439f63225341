# Turning: recess turning, recessing and threads.

# --- 841, 842, 840, 851, 852, 850 ---
cycle-simple-radial-recess-turning = Simple radial recess turning
    .nc = SIMPLE RECESS TURNING, RADIAL
    .purpose = Machines rectangular grooves in the longitudinal direction by recess turning: roughing, finishing or both. The roughing cuts are paraxial.
cycle-extended-radial-recess-turning = Extended radial recess turning
    .nc = EXTENDED RECESS TURNING, RADIAL
    .purpose = Machines grooves in the longitudinal direction by recess turning: roughing, finishing or both. The roughing cuts are paraxial. The groove may have inclined side walls, rounded corners, and a chamfer or rounding at the start and at the end of the contour.
cycle-radial-contour-recess-turning = Radial contour recess turning
    .nc = CONTOUR RECESS TURNING, RADIAL
    .purpose = Machines grooves of any shape in the longitudinal direction by recess turning: roughing, finishing or both. The roughing cuts are paraxial.
cycle-simple-axial-recess-turning = Simple axial recess turning
    .nc = SIMPLE RECESS TURNING, AXIAL
    .purpose = Machines rectangular grooves in the transverse direction (on a face) by recess turning: roughing, finishing or both. The roughing cuts are paraxial.
cycle-extended-axial-recess-turning = Extended axial recess turning
    .nc = EXTENDED RECESS TURNING, AXIAL
    .purpose = Machines grooves in the transverse direction by recess turning: roughing, finishing or both. The roughing cuts are paraxial. The groove may have inclined side walls, rounded corners, and a chamfer or rounding at the start and at the end of the contour.
cycle-axial-contour-recess-turning = Axial contour recess turning
    .nc = CONTOUR RECESS TURNING, AXIAL
    .purpose = Machines grooves of any shape in the transverse direction by recess turning: roughing, finishing or both. The roughing cuts are paraxial.

# --- 861, 862, 860, 871, 872, 870 ---
cycle-radial-recessing = Radial recessing
    .nc = RADIAL RECESSING
    .purpose = Cuts rectangular grooves radially: roughing, finishing or both. The roughing cuts are paraxial.
cycle-extended-radial-recessing = Extended radial recessing
    .nc = EXTENDED RADIAL RECESSING
    .purpose = Cuts grooves radially: roughing, finishing or both. The roughing cuts are paraxial. The groove may have inclined side walls, rounded corners, and a chamfer or rounding at the start and at the end of the contour.
cycle-radial-contour-recessing = Radial contour recessing
    .nc = RADIAL CONTOUR RECESSING
    .purpose = Cuts grooves of any shape radially: roughing, finishing or both. The roughing cuts are paraxial.
cycle-axial-recessing = Axial recessing
    .nc = AXIAL RECESSING
    .purpose = Cuts rectangular grooves axially (face recessing): roughing, finishing or both. The roughing cuts are paraxial.
cycle-extended-axial-recessing = Extended axial recessing
    .nc = EXTENDED AXIAL RECESSING
    .purpose = Cuts grooves axially (face recessing): roughing, finishing or both. The roughing cuts are paraxial. The groove may have inclined side walls, rounded corners, and a chamfer or rounding at the start and at the end of the contour.
cycle-axial-contour-recessing = Axial contour recessing
    .nc = AXIAL CONTOUR RECESSING
    .purpose = Cuts grooves of any shape axially (face recessing): roughing, finishing or both. The roughing cuts are paraxial.

# --- 831, 832, 830 ---
cycle-longitudinal-thread = Longitudinal thread
    .nc = LONGITUDINAL THREAD
    .purpose = Turns longitudinal threads with one or several starts.
cycle-extended-thread = Extended thread
    .nc = EXTENDED THREAD
    .purpose = Turns longitudinal, face or tapered threads with one or several starts.
cycle-contour-parallel-thread = Contour-parallel thread
    .nc = CONTOUR-PARALLEL THREAD
    .purpose = Turns longitudinal or face threads of any shape with one or several starts.

# --- roughing of grooves ---
step-take-tool-position-as-start = The control takes the position of the tool at the cycle call as the starting point of the cycle.
step-start-recess-at-contour-start-diameter = If the X coordinate of the starting point is less than the diameter at contour start { $q-contour-start-diameter }, the control positions the tool in X at { $q-contour-start-diameter } and starts the cycle there.
step-start-recess-at-contour-start-z = If the Z coordinate of the starting point is less than the contour start in Z { $q-contour-start-z }, the control positions the tool in Z at { $q-contour-start-z } and starts the cycle there.
step-start-recess-at-contour-point-x = If the X coordinate of the starting point is less than that of the contour starting point, the control positions the tool in X at the contour starting point and starts the cycle there.
step-start-recess-at-contour-point-z = If the Z coordinate of the starting point is less than that of the contour starting point, the control positions the tool in Z at the contour starting point and starts the cycle there.
step-rapid-to-first-recess-z = The control positions the tool in Z at rapid traverse (first recessing position).
step-rapid-to-first-recess-x = The control positions the tool in X at rapid traverse (first recessing position).
step-recess-from-start-to-first-depth = The control recesses from the starting point of the cycle to the first plunging depth.
step-recess-to-first-depth = The control recesses to the first plunging depth.
step-rough-groove-lengthwise = The control roughs the area between the starting position and the end point in the longitudinal direction at the feed rate { $q-turning-roughing-feed }.
step-rough-groove-crosswise = The control roughs the area between the starting position and the end point in the transverse direction at the feed rate { $q-turning-roughing-feed }.
step-choose-side-of-next-recess = The machining direction { $q-recess-direction } determines where the next infeed is made:
say-lift-off-and-return = { $q-recess-direction } = 1 (one direction only): the control lifts the tool off by the set-up clearance, returns it at rapid traverse and approaches the contour again at the defined feed rate
say-infeed-at-both-sides = { $q-recess-direction } = 0 (both directions): the infeed is made on both sides
step-recess-to-next-depth = The tool recesses to the next plunging depth.
until-groove-depth-reached = the depth of the groove is reached
step-recess-at-both-walls = The control positions the tool at the set-up clearance again and makes one recess at each side wall.
step-infeed-parallel-to-axis = The control makes a paraxial infeed at rapid traverse. The lateral infeed is 0.8 times the cutting width.
step-recess-radially = The control machines the area between the starting position and the end point in the radial direction at the feed rate { $q-turning-roughing-feed }.
step-recess-axially = The control machines the area between the starting position and the end point in the axial direction at the feed rate { $q-turning-roughing-feed }.
until-groove-width-reached = the width of the groove is reached
until-groove-shape-reached = the shape of the groove is reached

# --- finishing of grooves ---
step-rapid-to-first-flank = The control positions the tool at rapid traverse at the first flank of the groove.
step-rapid-again-to-first-flank = { step-rapid-to-first-flank }
step-rapid-to-second-flank = The control positions the tool at rapid traverse at the second flank of the groove.
step-finish-groove-wall = The control finishes the side wall of the groove at the feed rate { $q-turning-finishing-feed }.
step-finish-second-groove-wall = { step-finish-groove-wall }
step-finish-groove-walls = The control finishes the side walls of the groove at the feed rate { $q-turning-finishing-feed }.
step-finish-groove-floor = The control finishes the floor of the groove at the defined feed rate.
step-finish-groove-floor-or-all = The control finishes the floor of the groove at the defined feed rate:
say-finish-whole-groove = if a radius { $q-contour-corner-radius } is entered for the contour edge, the control finishes the whole groove in one pass
say-finish-floor-only = otherwise only the floor
step-retract-from-groove = The control retracts the tool at rapid traverse.
step-finish-half-of-width = The control finishes half of the groove width at the defined feed rate.
step-finish-other-half-of-width = The control finishes the other half of the groove width at the defined feed rate.
step-finish-half-of-groove = The control finishes half of the groove at the defined feed rate.
step-finish-other-half-of-groove = The control finishes the other half of the groove at the defined feed rate.

# --- threads ---
step-move-before-thread-and-infeed = The control positions the tool at rapid traverse at the set-up clearance in front of the thread and makes an infeed.
step-cut-thread-parallel-to-axis = The control makes a longitudinal cut parallel to the axis. It synchronizes feed rate and spindle speed so that the defined pitch is produced.
step-cut-thread-along-line = The control cuts the thread between the starting point and the end point. It synchronizes feed rate and spindle speed so that the defined pitch is produced.
step-cut-thread-along-contour = The control cuts the thread parallel to the defined thread contour. It synchronizes feed rate and spindle speed so that the defined pitch is produced.
step-lift-off-thread = The control lifts the tool off at rapid traverse by the set-up clearance.
step-infeed-at-angle = The control makes an infeed. The infeeds follow the infeed angle { $q-thread-infeed-angle }.
until-thread-depth-reached = the depth of the thread is reached
step-make-air-cuts = The control makes the number of air cuts defined in { $q-number-of-air-cuts }.
step-infeed-for-next-start = For the next start the control takes the tool back to the first infeed. The cut begins at an angle of the spindle that is turned by the spacing of the starts.
until-all-thread-starts-cut = all thread starts ({ $q-number-of-thread-starts }) have been cut

# --- conditions ---
condition-cutting-limit-wanted = { $q-cutting-limit } = 1
condition-taper-angle-given = { $q-taper-dimensioning } defines the taper with its angle
condition-start-diameter-given = { $q-taper-dimensioning } defines the taper with the diameter at contour start
condition-start-z-given = { $q-taper-dimensioning } defines the taper with the Z coordinate of the contour start
condition-end-diameter-given = { $q-taper-dimensioning } defines the taper with the diameter at contour end
condition-end-z-given = { $q-taper-dimensioning } defines the taper with the Z coordinate of the contour end

# --- errors ---
guard-recess-offset-too-great = The lateral offset is more than 80% of the effective cutting width, which is the cutting width less twice the cutting radius.

# --- notes: grooves ---
note-recess-turning-alternates = In recess turning, recesses to the plunging depth and roughing cuts alternate. Machining thus needs as few retractions and infeeds as possible.
note-groove-extended-scope = Extended scope: a chamfer or a rounding can be added at the start and at the end of the contour; angles can be defined for the side walls of the groove; radii can be added at the corners of the contour.
note-recess-cuts-get-shorter = After the second infeed the control shortens each further cut by 0.1 mm. This reduces the lateral load on the tool. If an offset width { $q-recess-offset-width } is entered in the cycle, the cut is shortened by that value instead. The material left over is removed with one recessing movement at the end of recessing. If the lateral offset exceeds 80% of the effective cutting width (cutting width − 2 × cutting radius), the control shows an error message.
title-groove-with-chamfers = Groove with chamfers in a turned shoulder (worked program)

# --- notes: threads ---
note-threads-with-several-starts = The cycle can produce threads with one or with several starts.
note-standard-thread-depth = If no thread depth is entered in the cycle, the cycle uses a standard thread depth.
note-standard-thread-depth__longitudinal-thread = If no thread depth is entered in the cycle, the cycle uses the thread depth according to the standard ISO 1502.
note-thread-outside-or-inside = The cycle can be used for outside and for inside machining.
note-extended-thread-scope = Extended scope: a longitudinal or a face thread can be selected; the parameters for the type of taper dimensioning, the taper angle and the contour starting point in X define various tapered threads; the starting path and the overrun path define the distances in which the feed axis is accelerated and decelerated.
note-overrun-after-contour = Danger of collision! Cycle { $cycle } moves on by the overrun path { $q-overrun-path } after the programmed contour. Take the available space into account.
note-clearance-is-starting-path = The control uses the set-up clearance { $q-thread-clearance } as the starting path. It must be long enough for the feed axes to be accelerated to the required speed.
note-pitch-is-overrun-path = The control uses the thread pitch { $q-turned-thread-pitch } as the overrun path. It must be long enough for the feed axes to be decelerated.
note-extended-thread-has-paths = Cycle 832 has parameters for the starting path and the overrun path.
note-starting-path-long-enough = The starting path { $q-starting-path } must be long enough for the feed axes to be accelerated to the required speed.
note-overrun-path-long-enough = The overrun path { $q-overrun-path } must be long enough for the feed axes to be decelerated.
note-paths-outside-contour = Both the starting path and the overrun path lie outside the defined contour.
note-override-while-thread-cutting = The feed-rate override has no effect while the control cuts the thread. The spindle-speed override is still active within limits that the machine builder defines. Refer to the machine manual.
note-thread-with-separate-holder = On some types of machines the turning tool is not clamped in the milling spindle but in a separate holder next to it. There the turning tool cannot be rotated by 180°, for example to cut outside and inside threads with one tool. To use an outside tool for inside machining on such a machine, machine in the negative diameter range (−X) and reverse the direction of rotation of the workpiece. With pre-positioning in the negative diameter range, the control reverses the effect of the thread position { $q-thread-position }: then 1 is an outside and 0 an inside thread.
note-thread-retracts-directly = Danger of collision! The tool retracts on the direct path to the starting position. Always pre-position it so that the control can approach the starting point at the end of the cycle without collision.

# --- notes: contours from a subprogram ---
note-contour-by-cycle-14 = The contour is described in a subprogram, with path functions or FK functions. Before the cycle call, program cycle 14 (contour) to define the number of the subprogram.
note-local-parameters-in-contour = If local parameters QL are used in the contour subprogram, they must also be assigned or calculated in the contour subprogram.
note-cutting-limit-limits-area = The cutting limit limits the area of the contour that is machined. Approach and departure paths may cross the cutting limit.
note-cutting-limit-by-tool-position = The position of the tool before the cycle call affects how the cutting limit acts: the control removes the material on the side of the cutting limit on which the tool is before the cycle call.
