# Drilling cycles: reaming, boring, universal drilling, back boring, bore milling, centring, single-lip drilling.

# --- shared sentences ---
step-retract-at-retraction-feed = The tool retracts at the feed rate { $q-retraction-feed } to the set-up clearance { $q-set-up-clearance }.

# --- 201 ---
cycle-reaming = Reaming
    .nc = REAMING
    .purpose = Reams a hole in one infeed. The tool leaves the hole at a feed rate of its own.
step-ream-to-depth = The tool reams at the feed rate { $q-plunging-feed } to the programmed depth { $q-depth }.

# --- 203 ---
cycle-universal-drilling = Universal drilling
    .nc = UNIVERSAL DRILLING
    .purpose = Drills a hole in infeeds that may become smaller. Chips can be broken several times before the tool is retracted from the hole.
step-drill-to-decreasing-plunging-depth = The tool drills at the feed rate { $q-plunging-feed } to the next plunging depth. The plunging depth { $q-plunging-depth } becomes smaller by the decrement { $q-decrement } with each infeed, if one is entered.
step-break-chip-or-retract = Between two infeeds the tool moves back:
say-break-chip-by-retraction = with chip breaking, by the retraction { $q-chip-breaking-retraction }, as often as { $q-chip-breaks-before-retraction } says before the tool is retracted from the hole
say-retract-and-return-at-rapid = without chip breaking, at the feed rate { $q-retraction-feed } to the set-up clearance, where it dwells for { $q-dwell-at-top } if entered; from there it moves at rapid traverse (FMAX) to the set-up clearance above the depth reached
condition-chip-is-broken = the chip breaks { $q-chip-breaks-before-retraction } before the next retraction are not yet done

# --- 240 ---
cycle-centring = Centring
    .nc = CENTERING
    .purpose = Centres a hole to a depth or to a diameter.
step-centre-to-depth-or-diameter = The tool centres at the feed rate { $q-plunging-feed }:
say-centre-to-diameter = { $q-depth-or-diameter } = 1: to the centring diameter { $q-centring-diameter }
say-centre-to-depth = { $q-depth-or-diameter } = 0: to the centring depth { $q-depth }
step-dwell-at-centring-bottom = The tool dwells at the bottom of the centring for { $q-dwell-at-bottom }, if entered.
condition-centring-to-depth = { $q-depth-or-diameter } = 0
condition-centring-to-diameter = { $q-depth-or-diameter } = 1
guard-point-angle-missing = To centre to a diameter, define the point angle { $mp-drill-point-angle } of the tool in the tool table.
guard-depth-zero__centring = The selected depth or diameter is 0: the control does not execute the cycle.
guard-depth-positive__centring = The selected depth or diameter is positive. Enter a negative value, or let the machine parameter { $mp-display-depth-err } allow it.
note-sign-of-depth-or-diameter = The sign of the diameter { $q-centring-diameter } or of the depth { $q-depth }, whichever is selected, determines the working direction. With diameter or depth 0 the control does not execute the cycle.
note-positive-diameter-or-depth-reverses = Danger of collision! With a positive diameter or a positive depth the control reverses the calculation of the pre-position: at rapid traverse the tool moves in the tool axis to the set-up clearance below the workpiece surface.
