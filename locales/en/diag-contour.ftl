## Why a contour cannot be executed.

diag-approach-impossible = APPR or DEP has no solution: LN and CT need RL or RR, and LCT needs a point outside its arc.
diag-approach-word = This form of APPR or DEP needs { $word }.
diag-compensation-begin = Radius compensation must begin and end in a straight line, not in an arc.
diag-compensation-side = A block with R0 is needed between RL and RR.
diag-compensation-too-large = The tool radius of { NUMBER($radius, maximumFractionDigits: 4) } mm is too large for an inside corner, an inside arc or a step of the contour.
diag-contour-limit = The run ends: more than { NUMBER($limit) } events are between two elements of a contour.
diag-contour-missing = No contour element follows that the tool could approach.
diag-rounding-impossible = A rounding or chamfer of { NUMBER($size, maximumFractionDigits: 4) } mm does not fit into this corner. A chamfer needs a straight line on both sides.
diag-rounding-misplaced = RND and CHF need an element in the working plane directly before and after them, and cannot begin a contour.
diag-tangent-missing = The tangential direction is unknown: a contour element must end at this point, and the end of a tangential arc must not be straight ahead.
diag-unsupported-compensation = The engine does not execute this while radius compensation is active: { $word }
