# Turning: longitudinal and face.

# --- common sentences of the turning cycles ---
group-turning-roughing = Roughing
group-turning-finishing = Finishing
step-rapid-radial-infeed = The control advances the tool in radial direction, parallel to the axis, at rapid traverse. It computes the infeed from the maximum cutting depth { $q-max-cutting-depth }.
step-cut-longitudinally = The control machines the area between the starting position and the end point in longitudinal direction at the feed rate { $q-turning-roughing-feed }.
step-retract-by-infeed = The control retracts the tool by the infeed at the defined feed rate:
say-follow-contour-within-infeed = with { $q-contour-smoothing } = 0 along the contour, within the infeed range
say-lift-off-at-45-degrees = otherwise at an angle of 45°
step-rapid-to-start-of-cut = The control returns the tool at rapid traverse to the start of the cut.
until-turning-contour-finished = the contour is finished
step-smooth-after-last-cut = With { $q-contour-smoothing } = 1 the control smooths the entire contour after the last cut.
step-rapid-to-starting-point-of-cycle = The control returns the tool at rapid traverse to the starting point of the cycle.
step-rapid-back-after-finishing = { step-rapid-to-starting-point-of-cycle }
step-rapid-in-z-by-clearance = The control moves the tool in Z by the set-up clearance { $q-turning-clearance } at rapid traverse.
step-rapid-paraxial-infeed = The control advances the tool parallel to the axis at rapid traverse.
step-finish-turned-contour = The control finishes the contour of the workpiece at the feed rate { $q-turning-finishing-feed }.
step-retract-by-clearance = The control retracts the tool by the set-up clearance { $q-turning-clearance } at the defined feed rate.
condition-smoothing-each-cut = { $q-contour-smoothing } asks for smoothing after each cut
guard-turning-mode-missing = Turning cycles can only be executed in the turning mode FUNCTION MODE TURN.
note-turning-mode-only = Turning cycles can only be used in the turning mode FUNCTION MODE TURN.
note-program-before-turning-cycle = Before the cycle is called, always program: the turning mode FUNCTION MODE TURN, the tool call TOOL CALL, the direction of rotation of the turning spindle (for example M303), the speed or cutting speed with FUNCTION TURNDATA SPIN, M136 if feed rates per revolution (mm/rev) are used, a positioning block to a suitable starting point (for example L X+130 Y+0 R0 FMAX), and cycle 800 to adapt the coordinate system and to align the tool.
note-call-turning-cycle = Call the cycle with CYCL CALL or M99.
note-outside-or-inside-by-tool-position = The cycle machines the outside if the tool is outside the contour to be machined when the cycle is called, and the inside if the tool is inside it.
note-outside-or-inside-by-diameters = If the starting diameter { $q-contour-start-diameter } is greater than the end diameter { $q-contour-end-diameter }, the cycle machines the outside; if it is smaller, the inside.
note-outside-or-inside-by-contour = If the starting point of the contour is greater than its end point, the cycle machines the outside; if it is smaller, the inside.
note-check-after-change-of-side = After changing between outside and inside machining, check the tool settings and the direction of rotation.
note-area-from-tool-position-to-end-point = In roughing, the cycle machines the area from the position of the tool at the cycle call (the starting point of the cycle) to the end point defined in the cycle.
note-position-at-starting-position = Before the cycle call, program a positioning block to the starting position with radius compensation R0.
note-position-at-safe-position = Before the cycle call, program a positioning block to a safe position with radius compensation R0.
note-tool-position-determines-area = The position of the tool at the cycle call (the starting point of the cycle) determines the size of the area to be machined.
note-tool-position-influences-area = The position of the tool at the cycle call (the starting point of the cycle) influences the area to be machined.
note-pre-positioning-influences-time = The pre-positioning of the tool strongly influences the working range of the cycle and therefore the machining time. In roughing, the starting point of the cycle is the position of the tool at the cycle call. The control computes the area to be machined from the starting point and from the end point or contour defined in the cycle. If the starting point lies within this area, some cycles first move the tool to the set-up clearance.
note-finishing-approach-from-envelope = Danger to tool and workpiece! In finishing, the cycle moves the tool to the starting point automatically. How it approaches depends on the position of the tool at the cycle call: inside or outside the envelope, which is the programmed contour enlarged by the set-up clearance { $q-turning-clearance }. If the tool is inside the envelope, it moves at the defined feed rate on a direct path to the starting position, which can damage the contour: position the tool so that it can reach the starting position without damage to the contour. If the tool is outside the envelope, it moves at rapid traverse up to the envelope, and at the programmed feed rate within it.
note-cutting-geometry-considered = The control considers the cutting geometry of the tool ({ $mp-tool-orientation }, { $mp-cutting-edge-radius }, { $mp-point-angle }, { $mp-tool-angle }) so that the defined contour elements cannot be damaged. If the contour cannot be machined completely with the active tool, the control shows a warning.
note-feed-rates-with-m136 = If M136 is programmed before the cycle, the control interprets the feed rates in the cycle in mm/rev, without M136 in mm/min.
note-inclined-turning = If the cycle is executed during inclined machining (M144), the angles of the tool relative to the contour change. The control considers this change automatically and thus also monitors machining in the inclined position for damage to the contour.
note-blank-form-update = With blank form update (FUNCTION TURNDATA BLANK) the control recognizes areas that are already machined and adapts all approach and departure paths to the individual operations. It is available only in a machining cycle in the turning mode; the blank must be a closed contour (starting position = end position) and is the cross-section of a rotationally symmetric body.
note-finished-part-beyond-blank = With blank form update the control adapts approach and retraction to the updated blank. If areas of the finished part extend beyond the blank, workpiece and tool can be damaged.

# --- 811 ---
cycle-turn-shoulder-longitudinal = Turn shoulder longitudinal
    .nc = SHOULDER, LONGITDNL.
    .purpose = Turns right-angled shoulders in longitudinal direction, outside or inside: roughing, finishing or both. The roughing cuts run parallel to the axis.
