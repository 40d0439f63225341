# Sentences that several machining cycles share.

# --- steps ---
step-rapid-to-set-up-clearance = The control moves the tool in the spindle axis at rapid traverse (FMAX) to the set-up clearance { $q-set-up-clearance } above the workpiece surface.
until-depth-reached = the programmed depth { $q-depth } is reached

# --- conditions ---

# --- guards ---
guard-depth-zero = The depth is 0: the control does not execute the cycle.
guard-depth-positive = The depth is positive. Enter a negative depth, or permit positive depths with the machine parameter { $mp-display-depth-err }.

# --- notes ---
note-program-before-call = Before the cycle is called, program the tool call, the direction of spindle rotation (M3 or M4) and the cycle definition; the test graphics also need the workpiece blank (BLK FORM).
note-graphic-test-first = Danger of collision! Cycles may execute extensive operations. For safety, run a graphic program test before machining.
note-sign-of-depth = The sign of the depth { $q-depth } determines the working direction. With depth 0 the control does not execute the cycle.
note-positive-depth-error = Danger of collision with a positive depth! The machine parameter { $mp-display-depth-err } determines whether the control reports an error when such a depth is entered (on) or not (off).
note-positive-depth-reverses = Danger of collision! With a positive depth { $q-depth } the control calculates the pre-position the other way round: the tool moves in the tool axis at rapid traverse to the set-up clearance below the workpiece surface.
note-retraction-between-pattern-points = With CYCL CALL PAT the tool retracts between the points to a safe height: the spindle-axis coordinate at the cycle call or the 2nd set-up clearance { $q-second-set-up-clearance }, whichever is higher.
note-assigned-parameters-are-fixed = If another parameter is assigned to a parameter of the cycle, a change of that other parameter after the cycle definition has no effect.
note-fauto-is-fixed = FAUTO takes the feed rate of the TOOL CALL block when the cycle definition is executed; a later change of the feed rate has no effect.
