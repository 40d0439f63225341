# Turning: longitudinal and face.

# --- common sentences of the turning cycles ---
group-turning-roughing = Roughing
group-turning-finishing = Finishing
step-rapid-radial-infeed = The control advances the tool in the radial direction, paraxially, at rapid traverse. It calculates the infeed from the maximum cutting depth { $q-max-cutting-depth }.
step-cut-longitudinally = The control machines the area between the starting position and the end point in the longitudinal direction at the feed rate { $q-turning-roughing-feed }.
step-retract-by-infeed = The control retracts the tool by the infeed at the defined feed rate:
say-follow-contour-within-infeed = with { $q-contour-smoothing } = 0 along the contour, within the infeed range
say-lift-off-at-45-degrees = otherwise at an angle of 45°
step-rapid-to-start-of-cut = The control returns the tool at rapid traverse to the start of the cut.
until-turning-contour-finished = the contour is finished
step-smooth-after-last-cut = With { $q-contour-smoothing } = 1 the control smooths the entire contour after the last cut.
step-rapid-to-starting-point-of-cycle = The control returns the tool at rapid traverse to the starting point of the cycle.
step-rapid-back-after-finishing = { step-rapid-to-starting-point-of-cycle }
step-rapid-in-z-by-clearance = The control moves the tool in Z by the set-up clearance { $q-turning-clearance } at rapid traverse.
step-rapid-paraxial-infeed = The control advances the tool paraxially at rapid traverse.
step-finish-turned-contour = The control finishes the contour of the workpiece at the feed rate { $q-turning-finishing-feed }.
step-retract-by-clearance = The control retracts the tool by the set-up clearance { $q-turning-clearance } at the defined feed rate.
guard-turning-mode-missing = Turning cycles can only be executed in the turning mode FUNCTION MODE TURN.
note-turning-mode-only = Turning cycles can only be used in the turning mode FUNCTION MODE TURN.
note-program-before-turning-cycle = Before the cycle is called, always program: the turning mode FUNCTION MODE TURN, the tool call TOOL CALL, the direction of rotation of the turning spindle (for example M303), the speed or cutting speed with FUNCTION TURNDATA SPIN, M136 if feed rates per revolution (mm/rev) are used, a positioning block to a suitable starting point (for example L X+130 Y+0 R0 FMAX), and cycle 800 to adapt the coordinate system and to align the tool.
note-call-turning-cycle = Call the cycle with CYCL CALL or M99.
note-outside-or-inside-by-tool-position = The cycle machines the outside if the tool is outside the contour to be machined when the cycle is called, and the inside if the tool is inside it.
note-outside-or-inside-by-diameters = If the starting diameter { $q-contour-start-diameter } is greater than the end diameter { $q-contour-end-diameter }, the cycle machines the outside; if it is smaller, the inside.
note-outside-or-inside-by-contour = If the coordinate of the starting point of the contour is greater than that of its end point, the cycle machines the outside; if it is smaller, the inside.
note-check-after-change-of-side = After changing between outside and inside machining, check the tool settings and the direction of rotation.
note-area-from-tool-position-to-end-point = In roughing, the cycle machines the area from the position of the tool at the cycle call (the starting point of the cycle) to the end point defined in the cycle.
note-position-at-starting-position = Before the cycle call, program a positioning block to the starting position with radius compensation R0.
note-position-at-safe-position = Before the cycle call, program a positioning block to a safe position with radius compensation R0.
note-tool-position-determines-area = The position of the tool at the cycle call (the starting point of the cycle) determines the size of the area to be machined.
note-tool-position-influences-area = The position of the tool at the cycle call (the starting point of the cycle) influences the area to be machined.
note-pre-positioning-influences-time = The pre-positioning of the tool strongly influences the working range of the cycle and therefore the machining time. In roughing, the starting point of the cycle is the position of the tool at the cycle call. The control calculates the area to be machined from the starting point and from the end point or contour defined in the cycle. If the starting point lies within this area, some cycles first move the tool to the set-up clearance.
note-finishing-approach-from-envelope = Danger to tool and workpiece! In finishing, the cycle moves the tool to the starting point automatically. How it approaches depends on the position of the tool at the cycle call: inside or outside the envelope, which is the programmed contour enlarged by the set-up clearance { $q-turning-clearance }. If the tool is inside the envelope, it moves at the defined feed rate on a direct path to the starting position, which can damage the contour: position the tool so that it can reach the starting position without damage to the contour. If the tool is outside the envelope, it moves at rapid traverse up to the envelope, and at the programmed feed rate within it.
note-cutting-geometry-considered = The control takes into account the cutting geometry of the tool ({ $mp-tool-orientation }, { $mp-cutting-edge-radius }, { $mp-point-angle }, { $mp-tool-angle }) so that the defined contour elements cannot be damaged. If the contour cannot be machined completely with the active tool, the control shows a warning.
note-feed-rates-with-m136 = If M136 is programmed before the cycle, the control interprets the feed rates in the cycle in mm/rev, without M136 in mm/min.
note-inclined-turning = If the cycle is executed during inclined machining (M144), the angles of the tool relative to the contour change. The control automatically takes this change into account and thus also monitors machining in the inclined position for damage to the contour.
note-blank-form-update = With blank form update (FUNCTION TURNDATA BLANK) the control recognizes areas that are already machined and adapts all approach and departure paths to the individual operations. It is available only in a machining cycle in the turning mode; the blank must be a closed contour (starting position = end position) and is the cross-section of a rotationally symmetric body.
note-finished-part-beyond-blank = With blank form update the control adapts approach and retraction to the updated blank. If areas of the finished part extend beyond the blank, workpiece and tool can be damaged.
step-rapid-axial-infeed = The control advances the tool in the axial direction, paraxially, at rapid traverse. It calculates the infeed from the maximum cutting depth { $q-max-axial-cutting-depth }.
step-cut-across-axis = The control machines the area between the starting position and the end point in the transverse direction at the feed rate { $q-turning-roughing-feed }.
step-cut-contour-longitudinally = The control machines the area between the starting position and the end point in the longitudinal direction. The longitudinal cut is paraxial and runs at the feed rate { $q-turning-roughing-feed }.
step-cut-contour-across-axis = The control machines the area between the starting position and the end point in the transverse direction. The face cut is paraxial and runs at the feed rate { $q-turning-roughing-feed }.
step-cut-parallel-to-contour = The control machines the area between the starting position and the end point. The cut runs parallel to the contour at the feed rate { $q-turning-roughing-feed }.
step-retract-to-starting-position-in-x = The control retracts the tool at the defined feed rate to the starting position in X.
step-clear-area-in-x-then-z = If the starting point (the position of the tool at the cycle call) lies within the area to be machined, the control positions the tool in X and then in Z at the set-up clearance { $q-turning-clearance } and starts the cycle from there.
step-clear-area-in-z-then-x = If the starting point (the position of the tool at the cycle call) lies within the area to be machined, the control positions the tool in Z and then in X at the set-up clearance { $q-turning-clearance } and starts the cycle from there.
step-clear-area-in-z = If the starting point lies within the area to be machined, the control first positions the tool in Z at the set-up clearance { $q-turning-clearance }.
step-clear-plunging-start-in-z = If the Z coordinate of the starting point (the position of the tool at the cycle call) is less than the contour start { $q-plunging-start-z }, the control positions the tool in Z at the set-up clearance { $q-turning-clearance } and starts the cycle from there.
step-clear-contour-start-in-z = If the Z coordinate of the starting point (the position of the tool at the cycle call) is less than that of the starting point of the contour, the control positions the tool in Z at the set-up clearance { $q-turning-clearance } and starts the cycle from there.
step-clear-contour-start-before-finishing = { step-clear-contour-start-in-z }
step-position-at-contour-start-in-z = If the Z coordinate of the starting point (the position of the tool at the cycle call) is less than that of the starting point of the contour, the control positions the tool in Z at the starting point of the contour and starts the cycle from there.
step-rapid-infeed = The control advances the tool at rapid traverse.
step-finish-turned-contour-to-end = The control finishes the contour of the workpiece, from the starting point to the end point of the contour, at the feed rate { $q-turning-finishing-feed }.
condition-start-element-added = { $q-start-element-type } adds an element at the start of the contour
condition-end-element-added = { $q-end-element-type } adds an element at the end of the contour
condition-undercuts-machined = { $q-undercut-machining } allows plunging elements to be machined
note-area-from-starting-point-to-end-point = In roughing, the cycle machines the area from the starting point of the cycle to the end point defined in the cycle.
note-infeed-within-undercut = Within the undercut the control advances the tool at the feed rate { $q-turning-roughing-feed }. Each retraction there is equal to the set-up clearance { $q-turning-clearance }.
note-contour-direction-decides = The programmed direction of the contour determines the direction of machining.
title-shoulder-with-recess = Shoulder with recess

# --- 811 ---
cycle-turn-shoulder-longitudinal = Turn shoulder longitudinal
    .nc = SHOULDER, LONGITDNL.
    .purpose = Turns right-angled shoulders in the longitudinal direction, outside or inside: roughing, finishing or both. The roughing cuts are paraxial.

# --- 812 ---
cycle-turn-shoulder-longitudinal-extended = Turn shoulder longitudinal, extended
    .nc = SHOULDER, LONG. EXT.
    .purpose = Turns shoulders in the longitudinal direction, outside or inside: roughing, finishing or both. A chamfer or a rounding can be added at the start and at the end of the contour, angles can be defined for the face and the circumferential surface, and the corner of the contour can have a radius. The roughing cuts are paraxial.

# --- 813 ---
cycle-turn-plunge-longitudinal = Turn plunge longitudinal
    .nc = TURN, LONG. PLUNGE
    .purpose = Turns shoulders with plunging elements (undercuts) in the longitudinal direction, outside or inside: roughing, finishing or both. The roughing cuts are paraxial.

# --- 814 ---
cycle-turn-plunge-longitudinal-extended = Turn plunge longitudinal, extended
    .nc = TURN, LONG. PLUNGE EXT.
    .purpose = Turns shoulders with plunging elements (undercuts) in the longitudinal direction, outside or inside: roughing, finishing or both. A chamfer or a rounding can be added at the start and at the end of the contour, and an angle of the face and a radius of the contour corner can be defined. The roughing cuts are paraxial.

# --- 810 ---
cycle-turn-contour-longitudinal = Turn contour longitudinal
    .nc = TURN CONTOUR LONG.
    .purpose = Turns workpieces with any turning contour described in a subprogram, in the longitudinal direction, outside or inside: roughing, finishing or both. The roughing cuts are paraxial.

# --- 815 ---
cycle-turn-contour-parallel = Turn contour-parallel
    .nc = CONTOUR-PARALLEL
    .purpose = Turns workpieces with any turning contour described in a subprogram, outside or inside: roughing, finishing or both. The roughing cuts run parallel to the contour.

# --- 821 ---
cycle-turn-shoulder-face = Turn shoulder face
    .nc = SHOULDER, FACE
    .purpose = Turns right-angled shoulders in the transverse direction (face turning), outside or inside: roughing, finishing or both. The roughing cuts are paraxial.

# --- 822 ---
cycle-turn-shoulder-face-extended = Turn shoulder face, extended
    .nc = SHOULDER, FACE EXT.
    .purpose = Turns shoulders in the transverse direction (face turning), outside or inside: roughing, finishing or both. A chamfer or a rounding can be added at the start and at the end of the contour, angles can be defined for the face and the circumferential surface, and the corner of the contour can have a radius. The roughing cuts are paraxial.

# --- 823 ---
cycle-turn-plunge-face = Turn plunge face
    .nc = TURN, FACE PLUNGE
    .purpose = Turns plunging elements (undercuts) in the transverse direction (face turning), outside or inside: roughing, finishing or both. The roughing cuts are paraxial.

# --- 824 ---
cycle-turn-plunge-face-extended = Turn plunge face, extended
    .nc = TURN, FACE PLUNGE EXT.
    .purpose = Turns plunging elements (undercuts) in the transverse direction (face turning), outside or inside: roughing, finishing or both. A chamfer or a rounding can be added at the start and at the end of the contour, and an angle of the face and a radius of the contour corner can be defined. The roughing cuts are paraxial.

# --- 820 ---
cycle-turn-contour-face = Turn contour face
    .nc = TURN CONTOUR FACE
    .purpose = Turns workpieces with any turning contour described in a subprogram, in the transverse direction (face turning) outside or inside: roughing, finishing or both. The roughing cuts are paraxial.

# --- 800 ---
cycle-adapt-turning-system = Adapt rotary coordinate system
    .nc = ADAPT ROTARY COORDINATE SYSTEM
    .purpose = Aligns the workpiece coordinate system for turning and orients the cutting edge of the tool; can mirror the tool, so that it serves for inside as well as outside machining.
step-align-turning-system = The control aligns the workpiece coordinate system to the precession angle { $q-precession-angle } and orients the cutting edge of the tool accordingly: for outside machining to the centre of the rotary table, for inside machining in the opposite direction.
step-reverse-turning-tool = With { $q-tool-reversal } the coordinate system of the tool can be mirrored: the control then turns the spindle by 180° and mirrors the tool orientation { $mp-tool-orientation }. In this way a tool can be used for inside as well as outside machining.
note-before-turning = Before turning, bring the tool to the correct position and orient its cutting edge.
note-position-over-turning-spindle = To bring the tool to a suitable position, program a positioning block to the centre of the turning spindle, for example L Y+0 R0 FMAX.
note-purpose-of-precession-angle = The precession angle { $q-precession-angle } defines where on the circumference of the workpiece it is machined. This can be necessary if the tool has to be brought to a certain machining position for lack of space; the machining position can also be turned so that machining can be watched more easily.
note-precession-in-inclined-turning = In inclined turning, use the precession angle { $q-precession-angle } to bring the cutting edge and the coordinate system to a suitable position.
note-turning-system-until-tool-call = The cycle is effective from its definition until the next tool call.
note-turning-tool-clamped-and-measured = The tool must be clamped in the correct position and measured.
note-turning-tool-selected = The cycle can only be used if a turning tool is selected.
note-check-tool-orientation = Check the orientation of the tool before machining.
note-own-functions-for-tool-alignment = The machine builder may provide special functions for aligning the tool. Refer to the machine manual.
note-cycle-depends-on-machine = Cycle { $cycle } depends on the machine. Refer to the machine manual.

# --- 801 ---
cycle-reset-turning-system = Reset rotary coordinate system
    .nc = RESET ROTARY COORDINATE SYSTEM
    .purpose = Resets the settings that were made with cycle 800.
step-reset-turning-system = The control resets all settings programmed with cycle 800: the precession angle Q497 and the reversal of the tool Q498.
note-tool-stays-oriented = The tool is not returned to its initial orientation. If cycle 800 has oriented it, it stays in this position after the reset.
note-cycle-without-parameters = The cycle has no cycle parameters. Close its entry with the END key.
message-turning-contour-left = The tool cannot machine the contour completely: its insert does not reach all of it.
