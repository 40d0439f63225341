# Tapping and thread milling.

# --- tapping ---
cycle-tapping = Tapping with a floating tap holder (new)
    .nc = TAPPING NEW
    .purpose = Taps a thread in one movement with a floating tap holder.
cycle-rigid-tapping = Rigid tapping without a floating tap holder (new)
    .nc = RIGID TAPPING NEW
    .purpose = Taps a thread in one movement without a floating tap holder.
cycle-tapping-with-chip-breaking = Tapping with chip breaking
    .nc = TAPPING W/ CHIP BRKG
    .purpose = Taps a thread in several infeeds without a floating tap holder. A parameter determines whether the tool leaves the hole entirely when a chip is broken.
step-tap-in-one-movement = The tool moves to the thread depth { $q-thread-depth } in one movement.
step-reverse-dwell-and-retract = The direction of spindle rotation is reversed, and after the dwell time { $q-dwell-at-bottom } the tool retracts to the set-up clearance { $q-set-up-clearance }.
step-reverse-and-retract = The direction of spindle rotation is reversed, and the tool retracts to the set-up clearance { $q-set-up-clearance }.
step-reverse-spindle-again = At the set-up clearance the direction of spindle rotation is reversed again.
step-stop-spindle-at-set-up-clearance = The control stops the spindle at the set-up clearance.
step-rapid-to-set-up-clearance-and-orient = The control moves the tool in the spindle axis at rapid traverse (FMAX) to the set-up clearance { $q-set-up-clearance } above the workpiece surface and there orients the spindle to { $q-spindle-orientation-angle }.
step-tap-to-next-depth = The tool moves deeper by the infeed { $q-depth-for-chip-breaking }.
step-reverse-and-break-chip = The direction of spindle rotation is reversed and the tool moves back, at a speed increased by the factor { $q-retraction-speed-factor } if one is entered; then the direction is reversed again for the next infeed:
say-tap-leaves-hole = { $q-chip-breaking-turns } = 0: out of the hole entirely, to cool
say-tap-goes-back-some-turns = otherwise by { $q-chip-breaking-turns } times the thread pitch { $q-thread-pitch }
step-tap-back-to-set-up-clearance = The tool moves back to the set-up clearance { $q-set-up-clearance }.
note-sign-of-thread-depth = The sign of the thread depth { $q-thread-depth } determines the working direction. With thread depth 0 the control does not execute the cycle.
note-thread-depth-gives-direction = The sign of the thread depth { $q-thread-depth } determines the working direction.
note-positive-thread-depth-reverses = Danger of collision! With a positive depth the control calculates the pre-position the other way round: the tool moves in the tool axis at rapid traverse to the set-up clearance below the workpiece surface.
note-floating-tap-holder = The tool must be clamped in a floating tap holder, which evens out tolerances of feed rate and spindle speed during machining.
note-overrides-while-tapping = While the cycle is executed, the override knob for the spindle speed does not act. The override knob for the feed rate still acts in part; the machine builder determines how (consult the machine manual).
note-right-hand-with-m3 = Activate the spindle with M3 for right-hand threads, with M4 for left-hand threads.
note-feed-from-speed-and-pitch = Determine the feed rate with F = S × p. F: feed rate (mm/min), S: spindle speed (rev/min), p: thread pitch (mm).
note-retract-after-interruption = If the external stop key is pressed during tapping, the control shows a soft key with which the tool can be retracted.
note-feed-follows-spindle-speed = The control calculates the feed rate from the spindle speed. If the override knob for the feed rate is turned during tapping, the control adapts the feed rate automatically. The override knob for the spindle speed is not active.
note-spindle-stopped-after-tapping = At the end of the cycle the spindle is stopped. Switch it on again with M3 (or M4) before the next machining operation.
note-retract-by-soft-key = If the external stop key is pressed during tapping, the control shows the soft key for manual traverse. After it is pressed, the tool can be retracted under control with the positive direction key of the active spindle axis.
note-retraction-speed-is-limited = If a speed factor for a faster retraction is defined in { $q-retraction-speed-factor }, the control limits the speed to the highest one permitted in the active gear range.

# --- thread milling: cycles ---
cycle-thread-milling = Thread milling
    .nc = THREAD MILLING
    .purpose = Mills a thread into pre-drilled material.
cycle-thread-milling-countersinking = Thread milling and countersinking
    .nc = THREAD MLLNG/CNTSNKG
    .purpose = Mills a thread into pre-drilled material and machines a countersunk chamfer.
cycle-thread-drilling-milling = Thread drilling and milling
    .nc = THREAD DRILLNG/MLLNG
    .purpose = Drills into solid material and then mills the thread with the same tool.
cycle-helical-thread-drilling-milling = Helical thread drilling and milling
    .nc = HEL. THREAD DRLG/MLG
    .purpose = Mills a thread on a helix into solid material.
cycle-outside-thread-milling = Outside thread milling
    .nc = OUTSIDE THREAD MLLNG
    .purpose = Mills an outside thread and machines a countersunk chamfer.

# --- thread milling: steps ---
group-countersinking = Countersinking
group-countersinking-at-front = Countersinking at front
group-drilling-the-hole = Drilling
group-milling-the-thread = Thread milling
step-feed-to-start-plane-of-threads = The tool moves at the feed rate for pre-positioning { $q-in-and-out-feed } to the starting plane, which results from the sign of the thread pitch { $q-thread-pitch }, the milling type { $q-milling-type } and the number of threads per step { $q-threads-per-step }.
step-feed-to-start-plane-of-thread = The tool moves at the feed rate for pre-positioning { $q-in-and-out-feed } to the starting plane of the thread, which results from the sign of the thread pitch { $q-thread-pitch } and the milling type { $q-milling-type }.
step-feed-to-start-plane-of-helix = The tool moves at the feed rate for pre-positioning { $q-in-and-out-feed } to the starting plane of the thread.
step-approach-thread-and-compensate = The tool moves tangentially on a helix to the thread diameter { $q-nominal-diameter }. While it does so, it also makes a compensating movement in the tool axis, so that the path of the thread begins in the programmed starting plane.
step-approach-thread = The tool moves tangentially on a helix to the thread diameter { $q-nominal-diameter }.
step-approach-and-mill-one-turn = The tool moves tangentially on a helix to the thread diameter { $q-nominal-diameter } and mills the thread with a helical movement of 360°.
step-mill-thread-in-turns = The tool mills the thread at the feed rate { $q-milling-feed }, as defined by the threads per step { $q-threads-per-step }:
say-thread-in-one-turn = { $q-threads-per-step } = 0: in one helical movement
say-thread-on-continuous-helix = { $q-threads-per-step } = 1: in one continuous helical movement
say-thread-on-several-helices = { $q-threads-per-step } > 1: in several offset helical movements
step-mill-thread-downwards = The control moves the tool downwards on a continuous helix until the thread depth { $q-thread-depth } is reached.
step-depart-from-thread = The tool departs from the contour tangentially and returns to the starting point in the working plane.
step-end-of-thread-milling = At the end of the cycle the control moves the tool at rapid traverse:
step-feed-to-countersinking-depth = If no clearance to the side { $q-clearance-to-wall } is entered, the tool moves at the feed rate for pre-positioning { $q-in-and-out-feed } to the countersinking depth { $q-countersinking-depth } less the set-up clearance, and then at the feed rate for countersinking { $q-countersinking-feed } to the countersinking depth.
step-feed-directly-to-countersinking-depth = If a clearance to the side { $q-clearance-to-wall } is entered, the control moves the tool at once at the feed rate for pre-positioning { $q-in-and-out-feed } to the countersinking depth { $q-countersinking-depth }.
step-countersink-on-circle = As the available space allows, the control approaches smoothly from the centre or with a pre-positioning movement to the side, and executes a circular movement.
step-feed-to-depth-at-front = The tool moves at the feed rate for pre-positioning { $q-in-and-out-feed } to the countersinking depth at front { $q-depth-at-front }.
step-feed-to-depth-at-front-before-or-after = If countersinking comes before the thread ({ $q-countersinking-moment } = 0), the tool moves at the feed rate for countersinking { $q-countersinking-feed } to the countersinking depth at front { $q-depth-at-front }; if it comes after the thread, at the feed rate for pre-positioning { $q-in-and-out-feed }.
step-countersink-at-front = Without radius compensation, the control moves the tool on a half circle from the centre to the offset at front { $q-offset-at-front } and executes a circular movement at the feed rate for countersinking { $q-countersinking-feed }.
step-countersink-at-front__thread-drilling-milling = Without radius compensation, the control moves the tool on a half circle from the centre to the offset at front { $q-offset-at-front } and executes a circular movement at the feed rate { $q-plunging-feed }.
step-leave-countersink-at-front = The control moves the tool on a half circle back to the centre of the hole.
step-leave-countersink-at-front__outside-thread-milling = The control moves the tool on a half circle back to the starting point.
step-countersink-after-thread = If countersinking comes after the thread ({ $q-countersinking-moment } = 1), it is executed now, as described above.
step-drill-towards-plunging-depth = The tool drills at the feed rate { $q-plunging-feed } towards the plunging depth { $q-plunging-depth }; with chip breaking it stops each time it is { $q-depth-for-chip-breaking } deeper.
step-retract-to-break-chip = For chip breaking the tool retracts by { $q-chip-breaking-retraction }.
step-retract-and-return-to-one-stop-distance = The control retracts the tool at rapid traverse to the set-up clearance and returns it at rapid traverse (FMAX) to the advanced stop distance { $q-upper-advanced-stop-distance } above the depth reached.
until-hole-depth-reached = the total hole depth { $q-total-hole-depth } is reached
step-move-beside-stud = The control moves the tool from the centre of the stud along the main axis of the working plane to the starting point for countersinking at front. Its position results from thread radius, tool radius and pitch.
step-move-beside-stud-without-countersinking = If there is no countersinking at front, the control moves the tool to the starting point of thread milling, which is the same as that of countersinking at front.

# --- thread milling: conditions and guards ---
guard-no-depth-entered = All depths are 0: nothing is machined.
guard-depth-signs-differ = The depths have different signs. Enter the same sign for all of them.
guard-thread-near-countersinking-depth = The thread depth must be less than the countersinking depth by at least a third of the pitch.
guard-thread-near-hole-depth = The thread depth must be less than the total hole depth by at least a third of the pitch.

# --- thread milling: notes ---
note-thread-approach-on-half-circle = The thread diameter is approached on a half circle from the centre outwards. If the tool diameter is only a quarter of the thread diameter, the tool is pre-positioned to the side.
note-compensation-before-approach = Before the approach the control makes a compensating movement in the tool axis, which is at most half the thread pitch. Make sure that there is enough room in the hole.
note-thread-depth-moves-start = If the thread depth is changed, the control changes the starting point of the helical movement automatically.
note-depths-give-direction = The signs of the depth parameters determine the working direction, in this order: 1. thread depth { $q-thread-depth }, 2. countersinking depth { $q-countersinking-depth }, 3. depth at front { $q-depth-at-front }.
note-depths-give-direction__thread-drilling-milling = The signs of the depth parameters determine the working direction, in this order: 1. thread depth { $q-thread-depth }, 2. total hole depth { $q-total-hole-depth }, 3. depth at front { $q-depth-at-front }.
note-two-depths-give-direction = The signs of the depth parameters determine the working direction, in this order: 1. thread depth { $q-thread-depth }, 2. depth at front { $q-depth-at-front }.
note-depth-zero-leaves-out-step = If 0 is entered for one of the depths, the control does not execute that step.
note-no-countersinking-depth-for-front = To countersink at the front, define the countersinking depth { $q-countersinking-depth } as 0.
note-thread-depth-above-countersinking-depth = Enter a thread depth { $q-thread-depth } that is less than the countersinking depth { $q-countersinking-depth } by at least a third of the thread pitch.
note-thread-depth-above-hole-depth = Enter a thread depth { $q-thread-depth } that is less than the total hole depth { $q-total-hole-depth } by at least a third of the thread pitch.
note-helix-goes-into-workpiece = The milling type (climb or up-cut) results from the thread (right-hand or left-hand) and the direction of tool rotation, because the only possible working direction is from the workpiece surface into the workpiece.
note-position-over-stud-centre = Program a positioning block to the starting point (the centre of the stud) in the working plane with radius compensation R0.
note-offset-at-front-determined-before = Determine the offset for countersinking at front before you use the cycle. Enter it as the distance from the centre of the stud to the centre of the tool, without compensation.
note-internal-coolant-for-thread-milling = The machine should have internal cooling through the spindle: coolant at least 30 bar, compressed air at least 6 bar.
note-profile-correction-by-delta-radius = Thread milling often distorts the thread profile, so tool-specific corrections are needed. They are found in the tool catalogue or given by the tool manufacturer. The correction is entered in the TOOL CALL block with the delta value { $mp-delta-radius }.
note-clockwise-tools-only = The cycle can only be used with tools that rotate clockwise.
note-tools-of-both-rotations = The cycle can be used with tools that rotate clockwise and with tools that rotate counter-clockwise.
note-direction-of-inside-thread = The working direction depends on the sign of the thread pitch { $q-thread-pitch } and on the milling type { $q-milling-type }. With tools that turn clockwise, an inside thread is milled towards Z+ if it is right-hand (+) with climb milling (+1, RL) or left-hand (−) with up-cut milling (−1, RR), and towards Z− if it is right-hand (+) with up-cut milling (−1, RR) or left-hand (−) with climb milling (+1, RL).
note-direction-of-outside-thread = The working direction depends on the sign of the thread pitch { $q-thread-pitch } and on the milling type { $q-milling-type }. With tools that turn clockwise, an outside thread is milled towards Z− if it is right-hand (+) with climb milling (+1, RL) or left-hand (−) with up-cut milling (−1, RR), and towards Z+ if it is right-hand (+) with up-cut milling (−1, RR) or left-hand (−) with climb milling (+1, RL).
note-feed-of-cutting-edge = When threads are milled, the programmed feed rate is that of the cutting edge. The control displays the feed rate of the tool centre, so the displayed value differs from the programmed one.
note-mirroring-turns-thread = The direction of the thread changes if the cycle is executed together with cycle 8 (mirroring) in only one axis.
note-same-signs-of-depths = Danger of collision! Always enter the same sign for all depths, since the cycles contain several sequences that do not depend on each other. To repeat, for example, only the countersinking, enter 0 as the thread depth; the countersinking depth then determines the working direction.
note-same-signs-of-depths__outside-thread-milling = Danger of collision! Always enter the same sign for all depths, since the cycles contain several sequences that do not depend on each other. To repeat, for example, only the countersinking at front, enter 0 as the thread depth; the depth at front then determines the working direction.
note-tool-breakage-in-thread = If the tool breaks while a thread is cut: stop the program run, change to the mode Positioning with Manual Data Input and move the tool on a straight line to the centre of the hole. Then retract the tool in the infeed axis and change it.
note-tool-breakage-in-thread__outside-thread-milling = If the tool breaks while a thread is cut: stop the program run, change to the mode Positioning with Manual Data Input and move the tool on a straight line away from the thread. Then retract the tool in the infeed axis and change it.
