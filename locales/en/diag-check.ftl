# Findings of the program checker and of the translation of programs.

diag-approach-twice =
    { $what ->
        [call] The subprogram begins a contour with RL or RR, but is called here while the compensation of its last call is still active.
       *[approach] The contour is approached while radius compensation is still active: the previous contour was not left.
    }
diag-approach-without-compensation =
    { $what ->
        [approach] The contour is approached here without RL or RR.
        [contour] The tool goes round this closed contour without RL or RR, and R0 switches off behind it what was never on.
       *[departure] The contour is left here, but no radius compensation is active.
    }
diag-arc-direction-wrong =
    { $what ->
        [sign] This arc joins the elements before and after it only with the other sign of its radius: as it is written, it is the greater part of the circle.
        [full] The tool goes round a full circle within the contour here: the end of the arc is its beginning.
        [beyond] This arc goes beyond the blank; with the other direction of rotation it would stay inside.
       *[direction] This arc joins the elements before and after it only with the other direction of rotation.
    }
diag-arc-in-unequal-scaling = { $cycle } scales the axes of this arc by different factors: the result is not an arc.
diag-arc-too-narrow = The radius { $radius } on the inside of the contour is less than that of the tool, { $tool }.
diag-arc-without-tangent = No contour element precedes this tangential arc.
diag-arc-wrong =
    The arc cannot end here: { $what ->
        [radius] its radius is { $first }, but start and end are { $second } apart
        [full] it ends where it begins; the centre of a full circle does not follow from its radius
        [sense] its angle is { $first }, but DR has the opposite direction
       *[centre] its start is { $first } away from the centre, its end { $second }
    }.
diag-axis-twice = Axis { $axis } is programmed twice in this block.
diag-back-boring-inside =
    { $what ->
        [hole] The cutting edge reaches { $value } from the axis of the hole, whose radius is only { $other }: the tool does not go through.
       *[thickness] The material is { $value } thick according to the cycle, and the blank goes { $other } below the surface.
    }
diag-blocks-after-end = Blocks after END PGM are not executed.
diag-blank-wrong =
    { $what ->
        [again] The blank already has a BLK FORM 0.1.
        [axis] { $axis } is missing here: a corner of the blank has three coordinates.
        [first] BLK FORM 0.2 has no BLK FORM 0.1 before it.
        [cylinder] The cylinder has no radius or diameter, or no length.
        [second] BLK FORM 0.1 is not followed by BLK FORM 0.2.
        [tool] The blank names no tool axis.
       *[order] In axis { $axis }, the second corner of the blank must have a greater coordinate than the first.
    }
diag-block-numbers = The block number { $number } follows { $before }.
diag-call-of-def-active-cycle = { $cycle } takes effect when it is defined; it must not be called.
diag-called-but-not-defined = A cycle is called here, but no cycle has been defined.
diag-called-program-in-other-unit = This program is in { $own }, but the called program { $name } is in { $other }.
diag-called-program-missing = The called program { $name } is not in the folder of this program, where the control looks for it.
diag-centre-in-other-plane = The arc and its centre are not in the same plane.
diag-chamfer-wrong-side = The tip of the chamfering tool goes { $value } deep through solid material, { $other } inside the edge of the blank: outside the edge it would chamfer it.
diag-choice-not-offered = { $parameter }={ $value } is not one of the choices: { $offered }.
diag-clearance-height-too-low =
    { $what ->
        [stud] { $cycle } moves from hole to hole at { $parameter }={ $value }, and a stud in between reaches up to { $least }.
       *[touched] { $cycle } touches at { $touched }: the clearance height { $parameter }={ $value } must be above { $least }.
    }
diag-compensation-at-cycle =
    { $cycle } is executed here while radius compensation is active.
diag-compensation-left-on = Radius compensation is still active here.
diag-compensation-missing = This contour is machined with RL or RR elsewhere; here the middle of the tool goes along it with R0.
diag-compensation-on-arc = Radius compensation must not begin in an arc.
diag-compensation-other-side = The same contour was machined with the opposite radius compensation before: here the tool is on its other side.
diag-compensation-switched = Radius compensation changes sides here without R0 in between.
diag-contour-at-rapid = The tool moves along a contour with radius compensation at rapid traverse here.
diag-contour-data-missing = { $cycle } is called, but { $data } has not been defined before.
diag-contour-def-wrong =
    { $what ->
        [number] { $found }: another contour already has this number.
        [many] { $found }: CONTOUR DEF can have at most nine contours.
       *[island] { $found }: the first contour of CONTOUR DEF must be a pocket, the deepest one.
    }
diag-contour-depth-missing = { $contour } has no DEPTH, but other contours have one.
diag-contour-returns =
    { $what ->
        [back] The contour goes back here along the line on which it has come to { $value }, { $other }.
       *[corner] The contour comes back to { $value }, { $other }, a corner that it already has.
    }
diag-contour-undeclared =
    { $what ->
        [twice] { $contour } has already been declared.
       *[nothing] The formula uses { $contour }, which has not been declared before it.
    }
diag-contour-not-selected =
    { $cycle } is called here, but no contour has been selected.
diag-contour-wrong =
    { $cycle } cannot machine the contour like this: { $what ->
        [axis] it moves in the tool axis { $word }
        [approach] it contains { $word }
        [tool] it contains { $word }
        [call] it contains { $word }
        [path] the cycle does not read { $word }
        [first] its first point does not have both coordinates of the plane
        [uncompensated] it has neither RL nor RR
        [many] the cycle machines only the first contour and ignores { $word }
        [corner] no element follows { $word }
        [local] { $word } is read but not assigned in it
        [same] the contour { $word } is the same one
        [islands] all of them are islands by their RL and RR, and there is no pocket around them
        [round] along both axes it is longer than the circumference of the cylinder
        [nested] it is a pocket by its RL or RR and lies completely in another pocket, so that it removes nothing
        [beside] it is an island by its RL or RR and lies beside all pockets, so that nothing is machined there
       *[open] it does not end where it begins
    }.
diag-coordinate-out-of-place = { $path } does not take these coordinates.
diag-core-hole-too-large =
    { $what ->
        [removed] The drill with a diameter of { $other } removes the thread { $value } that was tapped here before.
       *[core] The hole has a diameter of { $other }, the thread { $value }: no material is left for the thread.
    }
diag-core-hole-too-small =
    { $what ->
        [milled] The thread mill of { $value } goes into a hole of { $other }: the hole is too narrow.
       *[tapped] A thread of { $value } is tapped in a hole of { $other }: the hole is too narrow.
    }
diag-corner-wrong =
    This corner cannot be machined: { $what ->
        [twice] it directly follows another rounding or chamfer
        [arc] a chamfer must be between two straight lines, but one of the elements is an arc
        [first] no contour element precedes it
        [alone] no contour element follows it
        [back] the line after it leads back along the line before it
        [size] its radius or length is not positive
       *[long] it needs more than the length of the shorter line, { $least }
    }.
diag-cutting-speed-unusual =
    { $side ->
        [above] A cutting speed of { $value } m/min is far too high for this tool with a diameter of { $other }.
        [reamed] The reamer with a diameter of { $other } takes only { $value } per revolution: its speed is far too high or its feed rate far too low.
       *[below] A cutting speed of { $value } m/min is far too low for this tool with a diameter of { $other }.
    }
diag-cutting-without-tool = The tool moves at feed rate before any tool call.
diag-cycle-line-zero-missing = Line { $line } is not preceded by line { $head }.
diag-cycle-line-empty = Line { $line } of { $cycle } is empty.
diag-cycle-line-missing =
    { $line ->
        [none] Line { $missing } is missing: the definition consists of its name alone.
       *[other] Line { $missing } is missing before { $line }.
    }
diag-cycle-line-twice = Line { $line } is given twice in this definition.
diag-cycle-not-covered =
    { $other ->
        [none] { $cycle } is not checked: the manuals of the { $control } known to Ciklo do not cover such cycles.
       *[other] The manuals of the { $control } known to Ciklo do not cover cycles such as { $cycle }: it is checked against the manual of the { $other }.
    }
diag-cycle-not-described =
    { $other ->
        [none] The manuals mention { $cycle } ({ $name }) but do not describe it: its parameters are not checked.
       *[other] The manuals mention { $cycle } ({ $name }) but do not describe it: it is checked against the manual of the { $other }.
    }
diag-cycle-not-on-control = { $cycle } does not exist on the { $control }; it exists on: { $controls }.
diag-cycle-of-previous-tool = { $cycle } was defined for the previous tool, which has already machined with it.
diag-cycle-removes-nothing = { $cycle } removes nothing here: there is no material where its tool goes.
diag-datum-table-late = The preceding datum shift takes its row from another table: program SEL TABLE before it.
diag-defined-but-never-called = { $cycle } is defined here but never called.
diag-deviation-compared =
    { $what ->
        [deviation] { $parameter } is the deviation from the nominal size { $other }, and is compared with { $value } as if it were the size itself.
       *[size] { $parameter } is the measured size, nominally { $other }, and is compared with { $value } as if it were the deviation.
    }
diag-digitizing-wrong =
    { $what ->
        [swapped] { $word } is less than the MIN point of the range, { $other }.
        [low] The clearance height { $word } is below the MAX point of the range, { $other }.
        [missing] { $cycle } digitizes, but no range has been defined before.
       *[combined] { $cycle } cannot be combined with { $range }, which defines the range here.
    }
diag-arc-direction-missing = The direction of rotation of this arc, DR+ or DR−, is missing.
diag-doubtful-value =
    { $parameter }={ $value } is hardly intended in { $cycle }: { $is ->
        [zero] the value is 0
        [negative] the value is negative
        [small] the value is much smaller than usual
        [large] the value is much larger than usual
       *[positive] the value is positive and leads away from the workpiece
    }.
diag-duplicate-parameter = { $parameter } is given twice in { $cycle }.
diag-early-cycle-wrong =
    { $what ->
        [corner] The corner radius { $value } of the pocket is less than the radius { $other } of the tool.
        [clearance] The set-up clearance { $value } is negative: the cycle would begin below its surface.
        [depth] The depth { $value } is positive: the cycle moves the tool away from the workpiece.
        [infeed] With a plunging depth of 0 the cycle cannot machine.
        [feed] The feed rate of the cycle is 0.
        [narrow] The tool with the diameter { $other } does not fit into a slot or pocket of { $value }.
        [pitch] The thread has a pitch of { $value }, but the tap has { $other }.
        [peck] The hole is drilled in one infeed of { $value }: more than eight times the diameter { $other } of the drill.
        [wide] The round pocket is { $value } wide, and the blank only { $other }: a diameter may have been entered for the radius.
        [sides] With the sides { $value } and { $other } the pocket goes over the edge of the blank; exchanged, it would lie inside.
       *[tapped] A feed rate of { $value } does not fit the tap: pitch times spindle speed is { $other }.
    }
diag-empty-word = This { $word } has no value and does nothing.
diag-feed-negative = The feed is negative here.
diag-feed-zero = The feed is zero here.
diag-field-word-missing = The value has no word; the control shows it with one: { $shown }.
diag-begin-end-mismatch = END PGM says { $end }, BEGIN PGM says { $begin }.
diag-free-contour-wrong =
    { $what ->
        [label] A free contour cannot begin directly after a label.
        [again] CLSD+ is programmed again before CLSD- has closed the contour.
        [unbegun] CLSD- closes a contour that no CLSD+ has begun.
        [unclosed] The contour begun with CLSD+ ends here without CLSD-.
        [length] The length LEN is not positive.
        [auxiliary] The distance D has no auxiliary point (PDX, PDY).
        [distance] The auxiliary point has no distance D.
        [selected] FSELECT does not follow an element of a free contour.
        [solution] FSELECT takes the number of a solution, counted from 1.
        [fpol] The pole of a free contour needs two coordinates.
        [pole] Polar coordinates need a pole (FPOL).
        [turn] The contour begins and ends on the same circle, but in different directions.
       *[open] The free contour has no solution: too few values of its elements are given.
    }
diag-function-misspelled = No control accepts { $word } here; perhaps { $meant } is intended.
diag-function-not-on-control = The { $control } does not have { $function }.
diag-functions-contradict = { $first } and { $second } exclude each other but are in the same block.
diag-global-def-wrong =
    { $what ->
        [unknown] There is no GLOBAL DEF { $number }.
        [missing] GLOBAL DEF { $number } lacks { $parameter }.
        [foreign] GLOBAL DEF { $number } has no { $parameter }.
        [twice] { $parameter } is given twice in GLOBAL DEF { $number }.
        [again] GLOBAL DEF { $number } has been programmed before, but no cycle has used its values.
        [nothing] { $parameter } is PREDEF in { $value }, but no GLOBAL DEF sets it.
        [later] { $parameter } is PREDEF in { $value }, but the GLOBAL DEF that sets it comes later.
       *[value] No cycle accepts { $parameter }={ $value }.
    }
diag-guard = The control does not accept these values.
diag-hole-outside-blank =
    { $what ->
        [beside] The hole at { $value }, { $other } is beside the blank.
        [edge] The hole at { $value }, { $other } is cut by the edge of the blank.
        [surface] The surface at { $value } is far from the blank.
        [tilted] The holes of this cycle do not meet the blank: in the tilted plane they lie beside it or above it.
       *[through] The hole goes down to { $value }, far through the blank.
    }
diag-incremental-left-on = The coordinates of this contour are incremental; only as absolute ones do they lead back to its beginning.
diag-pattern-not-called = The cycle is called at one position here, but not at the positions of the pattern of line { $line }.
diag-plunge-beside-hole = The block has plunged into a hole before, but at { $value }, { $other } it plunges into solid material.
diag-polygon-incomplete =
    { $what ->
        [rectangle] A rectangle lacks its corner at { $value }, { $other }: this line cuts it off.
       *[polar] A regular polygon with { $count } corners lacks the one at { $value }°.
    }
diag-position-without-call = The tool goes to { $value }, { $other } between two calls and does nothing there: a call (M99, CYCL CALL) may be missing.
diag-result-of-other-axis =
    { $what ->
        [size] { $value } is the nominal value for { $other }, but { $parameter } is compared with it here.
       *[axis] { $parameter } is the result for the axis { $axis }, but it is used for { $other } here.
    }
diag-holes-overlap =
    { $what ->
        [pockets] The pocket or slot about { $value }, { $other } runs into another one of the same definition.
        [pocket] The hole at { $value }, { $other } is cut by a pocket or slot that was milled before.
        [hole] The hole at { $value }, { $other } is cut over its whole length by a wider one that was made before.
        [inside] The pocket or slot about { $value }, { $other } lies for the most part in another one that was milled before and is as deep, unlike the others of its definition.
        [beside] A hole is milled wider at { $value }, { $other }, but the holes of the pre-drilled diameter are elsewhere.
       *[holes] Two holes with a diameter of { $other } are only { $value } apart here: they overlap.
    }
diag-insert-points-away = The insert cannot cut where { $cycle } goes: its orientation (TO) is { $orientation }, so its tip points away from the part or from the feed.
diag-iso-incomplete =
    This block is incomplete: { $what ->
        [value] a letter has no value
        [label] the label is missing (L)
        [radius] the radius or length is missing (R)
        [cycle] the words of the cycle are missing (P01, P02, …)
       *[operand] an operand or the label of a jump is missing (P01, P02, P03)
    }.
diag-label-duplicate = The label { $label } is set twice; this is the second time.
diag-label-missing = The language “{ $language }” has no label for { $parameter } of { $cycle }.
diag-label-not-encodable = “{ $label }” contains the character “{ $character }”, which does not exist in the encoding of the file.
diag-label-of-another-language = “{ $label }” is a label in another language ({ $language }); in the language of the program, { $parameter } is “{ $right }”.
diag-label-of-another-parameter = “{ $label }” is the label of { $other }, not of { $parameter }.
diag-label-twice = { $parameter } and { $other } both have the label “{ $label }”, which can be right for only one of them.
diag-label-undefined = No block sets the label { $label }.
diag-labels-of-unknown-language =
    { $count ->
        [one] The labels of this definition are in a language that Ciklo does not know; it was read by its parameter numbers.
       *[other] The labels of { $count } definitions, of which this is the first, are in a language that Ciklo does not know; they were read by their parameter numbers.
    }
diag-languages-mixed = Most labels are in one language ({ $language }); the definitions in these lines are in another ({ $others }): { $lines }.
diag-loop-endless =
    { $what ->
        [counter] This jump waits for { $parameter }, but nothing in the loop counts it.
       *[jump] This jump closes a loop that never ends.
    }
diag-machine-coordinates-compensated = Machine coordinates (M91, M92) are programmed here with radius compensation.
diag-machine-coordinates-missing = Elsewhere the program retracts to { $value } with M91; here M91 is missing, and the height counts from the workpiece datum.
diag-main-runs-into-subprogram = The main program runs into the subprogram { $label } here: neither M2 nor M30 ends it.
diag-measuring-height-above-surface = The measuring height { $value } is above the workpiece, which ends at { $other }.
diag-measuring-height-below-floor = { $cycle } measures at { $parameter }={ $value }, below the floor at { $floor } that { $milling } leaves there.
diag-metric-values-in-inch = The program is in inches, but { $value } looks like millimetres.
diag-mirror-of-tool-axis = The tool axis { $axis } cannot be mirrored.
diag-misordered-parameter = In { $cycle } the control shows { $parameter } before { $before }.
diag-missing-parameter =
    { $count ->
        [one] { $cycle } lacks { $parameter }.
       *[other] { $cycle } lacks the parameters { $parameter }.
    }
diag-modal-call-left-on =
    M89 still calls the cycle in this block, { $what ->
        [beside] which moves to a position outside the blank
       *[again] so that the last position is machined again
    }.
diag-mode-wrong =
    { $what ->
        [milling] { $cycle } mills or drills, but the control is in turning mode (FUNCTION MODE TURN) here.
        [turning] { $cycle } turns, but the control is not in turning mode (FUNCTION MODE TURN) here.
       *[data] { $cycle } is used outside of turning mode.
    }
diag-name-of-another-cycle = “{ $name }” is the name of { $other }, but this is { $cycle }.
diag-no-result =
    This formula has no result: { $why ->
        [division] it divides by zero
        [large] the number is too large
       *[domain] a function is not defined for its value
    }.
diag-no-table-open = FN 27 and FN 28 need a table that FN 26 has opened.
diag-nominal-differs = The nominal diameter is { $value } here, and the pocket at this place is { $other } wide.
diag-not-a-program = This file is not an NC program.
diag-nothing-left = The hole is already { $other } wide here: a tool of { $value } removes nothing.
diag-number-does-not-exist = { $name } does not exist: the greatest number is { $greatest }.
diag-older-parameter-set = { $cycle } has the parameters of an earlier software version; the control adds { $parameter }.
diag-out-of-range =
    { $side ->
        [below] { $parameter }={ $value } is too small: the least value is { $limit }.
        [long] The text of { $parameter } is too long: at most { $limit } characters are permitted.
        [many] { $parameter } lists too many labels: at most { $limit } are permitted.
        [axes] { $parameter } names too many axes: at most { $limit } are permitted.
       *[above] { $parameter }={ $value } is too great: the greatest value is { $limit }.
    }
diag-out-of-usual-range =
    { $parameter }={ $value } is hardly intended: { $where ->
        [control] the { $control } accepts no value { $side ->
                [below] below
               *[above] above
            } { $limit } there.
       *[any] no manual permits such a parameter to be { $side ->
                [below] below
               *[above] above
            } { $limit }.
    }
diag-parameter-of-later-software = { $parameter } in { $cycle } needs a later software version than { $software }, which the manual describes.
diag-parameter-unassigned =
    { $parameter } is read here, but nothing has given it a value.
diag-path-twice =
    { $what ->
        [repeated] The tool goes this way for the third time: nothing is left to remove.
        [air] Under this transformation the path from here on removes nothing, although the same blocks have cut under another one.
        [copied] The contour from here on has already been machined with this tool by other blocks, although the tool has been positioned elsewhere.
       *[transformed] The whole path from here on has already been machined with this tool under another transformation.
    }
diag-path-not-closed = This subprogram does not come back to its beginning, although it is called again at the same place: the step is { $value }, and { $other } would close the path.
diag-pattern-combination =
    { $what ->
        [value] { $cycle } cannot call { $called } with { $value }.
       *[cycle] { $cycle } cannot call { $called }.
    }
diag-pattern-wrong =
    { $what ->
        [count] { $word } must be a whole number of positions, at least 1.
        [many] { $word }: PATTERN DEF can have at most nine single positions.
        [rapid] { $word } is not permitted here: between the points of a table the tool moves at a feed rate.
        [distance] { $word } is 0: all positions are the same.
        [angle] { $word } is more than a full turn.
        [same] { $word } repeats an earlier position.
       *[diameter] The diameter { $word } of a pitch circle must be greater than 0.
    }
diag-pilot-hole-too-shallow =
    { $what ->
        [bored] The tool turns inside down to { $value }, and the hole that was drilled ends at { $other }.
       *[start] The deepened starting point is at { $value }, and the hole that is there ends at { $other }.
    }
diag-pilot-hole-elsewhere = Nothing else is done at the hole at { $value }, { $other }, and a pocket begins in solid material where both coordinates are exchanged.
diag-plane-incomplete = This PLANE lacks { $word }.
diag-plane-not-positioned =
    { $what ->
        [cycle] No block positions the rotary axes after this tilt; whether the cycle does so depends on the machine.
        [reset] PLANE RESET with STAY leaves the rotary axes turned, and machining goes on before a block moves them back.
       *[plane] STAY does not move the rotary axes, and no block of the program moves them to the angles of this plane.
    }
diag-plane-not-reset =
    { $what ->
        [zero] { $cycle } sets all angles to 0 here, but nothing switches the tilted working plane off.
       *[tilted] The program ends here with a tilted working plane.
    }
diag-plunge-too-fast =
    { $what ->
        [sideways] The tool goes through solid material here with { $value } times the feed of its tool call.
        [tenfold] The tool goes through solid material here with { $value } times the feed of its other cuts.
        [turn] The tool mills { $value } per revolution here, far more than a tool of its diameter can take.
       *[plunge] The tool plunges into the material by { $value } per revolution here.
    }
diag-position-after-contour = This is the first position after { $cycle }, but it does not have absolute values for both coordinates of the plane.
diag-position-missing = The tool goes down to { $value } before the program has positioned it in the plane.
diag-position-twice =
    { $what ->
        [definition] The definition is word for word the one that was called before, and the tool has not moved since: nothing is left to machine.
       *[place] The point { $value }, { $other } has already been machined with this definition and this tool.
    }
diag-probe-while-turning = { $cycle } probes here while the spindle turns.
diag-probed-axis-missing = { $direction } is probed, but the position has no { $axis }.
diag-program-begin-missing = The program does not begin with BEGIN PGM.
diag-program-begin-twice = BEGIN PGM is programmed a second time.
diag-program-calls-itself = The program calls itself: { $name }.
diag-program-empty = The file contains no blocks.
diag-program-end-missing =
    The program ends here without { $end ->
        [iso] a final block that begins with %
       *[pgm] END PGM
    }.
diag-programs-call-in-circle = The program { $name } calls this one back, directly or through others.
diag-rapid-into-blank = The tool moves into the blank at rapid traverse here: it goes to Z { $value }, and the top of the blank is at { $top }.
diag-rapid-through-material = The tool moves through up to { $value } mm of material at rapid traverse here.
diag-reaming-wrong =
    { $what ->
        [none] There is no hole to be reamed here.
        [deep] The reamer goes down to { $value }, and the hole only to { $other }.
        [bored] The boring bar goes down to { $value }, and the hole only to { $other }.
        [stock] The hole is { $other } wide: a boring bar of { $value } cannot take away so much.
       *[allowance] The hole is { $other } wide: for a reamer of { $value } this leaves far too much.
    }
diag-repeat-count-wrong = The number of repeats must be a whole number from 0 to 65534.
diag-repeat-of-later-label = The label { $label } must come before the repeat, not after it.
diag-repeated-infeed =
    { $what ->
        [absolute] The transformation in the repeated part is absolute: from its second pass on it does the same each time.
        [deep] The repetitions lead down to { $value }, far below the blank.
       *[same] Each repetition goes to { $value } again and does the same as the first pass.
    }
diag-reserved-parameter =
    { $parameter } is written here, but Q100 to Q199 belong to the control, which overwrites them.
diag-reset-order-wrong =
    { $what ->
        [tilt] Tilting is reset here, but a rotation that was activated after it is still active.
       *[shift] The datum shift is reset here, but the plane that was tilted after it is still tilted.
    }
diag-retract-missing =
    { $what ->
        [change] The tool is still at { $value }, in, beside or just above the blank, when it is changed: it was not retracted.
        [tilt] The tool is still at { $value }, in, beside or just above the blank, when the plane is tilted with MOVE: it was not retracted.
        [end] The tool is still at { $value }, in, beside or just above the blank, when the program ends: it was not retracted.
        [others] The axes turn here after a retraction to { $value } only; before all other turns the tool is retracted farther.
        [unretracted] The axes turn here although the tool was not retracted since it has machined; before all other turns it is.
        [rapid] The tool is still at { $value }, in, beside or just above the blank, when it goes on at rapid traverse, unlike after the other lines of the surface: it was not retracted.
       *[turn] The tool is still at { $value }, in, beside or just above the blank, when a rotary axis moves at rapid traverse: it was not retracted.
    }
diag-rotary-axis-jumps = The rotary axis swings from { $other } to { $value } here and back in the next block.
diag-row-not-in-table =
    { $table ->
        [preset] The preset table has no row { $row }.
       *[datum] The datum table has no row { $row }.
    }
diag-program-not-selected = A selected program is called here, but none has been selected.
diag-shift-in-tilted-plane = The datum is shifted in the tilted plane to { $parameter }, which was measured in the untilted one.
diag-speed-missing = The spindle is turned on here, but no speed has been programmed for this tool.
diag-speed-out-of-range =
    { $what ->
        [feed] The feed { $value }
       *[speed] The spindle speed { $value }
    } is hardly intended: { $side ->
        [below] it is negative
       *[above] the manuals permit at most { $limit }
    }.
diag-stepover-too-wide = The lines are { $value } apart, and the tool is only { $other } wide: ribs stay between them.
diag-spindle-direction = { $cycle } needs a spindle that turns clockwise, but it turns counter-clockwise here.
diag-spindle-off = The tool cuts here while the spindle is not turning.
diag-sql-handle-missing =
    { $what ->
        [ended] COMMIT or ROLLBACK has already ended the transaction with the handle { $handle }.
       *[missing] No query has returned the handle { $handle }.
    }
diag-subprogram-end-without-label = This LBL 0 ends no subprogram.
diag-subprogram-recursive = The subprogram { $label } calls itself here.
diag-subprogram-runs-on = The subprogram { $label } runs into the subprogram { $next }: there is no LBL 0 between them.
diag-subprogram-without-end = The subprogram { $label } runs to the end of the program without LBL 0.
diag-tcpm-left-on =
    { $what ->
        [tool] A tool is called here while M128 or FUNCTION TCPM is active.
       *[end] The program ends here while M128 or FUNCTION TCPM is active.
    }
diag-text-for-number =
    { $what ->
        [text] { $parameter } takes a number, but this is a text.
        [number] { $parameter } takes a text, but this is a number.
       *[calculation] Texts cannot be used in calculations.
    }
diag-text-wrong =
    { $what ->
        [empty] The text of { $parameter } is empty.
        [alone] “{ $found }” in the text of { $parameter } is neither doubled nor followed by a letter.
       *[character] The character “{ $found }” is not permitted in { $parameter }.
    }
diag-thread-pitch-unusual = A pitch of { $value } is not a standard one for a thread with a diameter of { $other }.
diag-tool-axis-missing = This tool call has no tool axis, and no earlier one has named it.
diag-tool-axis-other =
    { $what ->
        [pattern] PATTERN DEF works only with tool axis { $axis }, but another one is active here.
        [lifted] This tool call names another tool axis than the blank, but the tool is only ever retracted along { $axis }.
       *[blank] The blank has the tool axis { $axis }, but no tool of the program has it.
    }
diag-tool-cuts-sideways = A drill, tap or reamer moves sideways through the material here.
diag-tool-definition-wrong =
    { $what ->
        [zero] Tool 0 means no tool and cannot be defined.
        [twice] Tool { $tool } has already been defined with other dimensions.
       *[after-call] Tool { $tool } is defined here, but has already been called.
    }
diag-tool-feed-missing = The feed rate of the tool call is used here, but the tool call has none.
diag-tool-missing = A cycle moves here, but no tool call has set the tool axis.
diag-tool-not-changed = { $cycle } is called with the tool that has already been used for { $before }: it needs another tool.
diag-tool-not-listed = The tool table has no tool { $tool }.
diag-tool-radius-outdated = This is calculated with the radius of the tool before (Q108), and read only after another tool is called.
diag-turning-start-wrong =
    { $what ->
        [positive] The turning cycle does not begin where the tool is: the contour goes to positive Z, away from the part.
        [z] The turning cycle does not begin where the tool is: the tool is beyond the end of the contour in Z.
        [bar] A tool for inside turns outside here: the cycle takes the side from the position of the tool.
        [outer] A tool for outside turns inside here: the cycle takes the side from the position of the tool.
        [inwards] This tool has turned outside before and turns inside here: the cycle takes the side from the position of the tool.
        [outwards] This tool has turned inside before and turns outside here: the cycle takes the side from the position of the tool.
        [start] Turning inside begins at the diameter { $value }, and the hole is only { $other } wide: the tool goes into solid material.
        [thick] The bar is { $value } wide, and the hole only { $other }.
       *[diameter] The turning cycle does not begin where the tool is: the tool is beyond the end diameter of the contour.
    }
diag-uncalculable-contour =
    The control cannot calculate the contour here: { $what ->
        [open] data are missing that determine this element
        [contradicts] the data of this element contradict each other
        [several] several elements fit the data, and none is selected
        [rounding] the rounding or chamfer does not fit between its elements
        [crossing] the contour crosses itself
       *[approach] the contour cannot be approached like this
    }.
diag-value-unlike-others =
    { $what ->
        [feed] The feed is { $value } here, and { $other } in the tool call.
        [sign] The height is { $value } here, between lower ones on the same path; { $other } would fit.
        [depth] The depth is { $value } here; in the other cycles of the program depths are negative.
        [path] The coordinate is { $value } here, far beside its neighbours on the same path; { $other } would fit.
        [angle] The angle is { $value } here; { $other } would fit the steps of the other angles.
       *[others] The value is { $value } here, and { $other } in all other places of this kind.
    }
diag-wall-left = The open contour leaves a wall { $value } mm wide at the edge of the blank: RL and RR may be exchanged.
diag-wrong-tool-type =
    { $what ->
        [probe] { $cycle } probes here with the tool that has just machined.
        [measured] { $cycle } measures the tool that has just probed here.
        [contour] The tool that has just probed moves along a contour here.
        [named] { $cycle } measures a touch probe here, if the name of the tool is right.
        [calibrates] { $cycle } calibrates the tool touch probe here with a tool that cuts.
       *[mill] { $cycle } machines here with the tool that has just probed.
    }
diag-tool-unused = Tool { $tool } is called here, and the next block calls another one.
diag-tool-zero = { $cycle } is executed with tool 0: there is no tool in the spindle.
diag-transfer-parameter-overwritten =
    { $what ->
        [passed] { $cycle } read { $parameter } when it was defined: the value written here does not affect its call.
        [filled] { $cycle } fills four parameters, starting with the one named here, and overwrites { $parameter }, which the program has written before and reads later.
        [lost] { $cycle } overwrites { $parameter } before the program reads the value written here.
        [result] { $parameter } is copied twice after one measurement: the result of the measurement before it was overwritten unread.
       *[call] { $parameter } belongs to { $cycle }, which is called later: the call uses the value written here.
    }
diag-transformation-forbidden =
    { $cycle } is used although { $what ->
        [datum-shift] a datum shift is active
        [rotation] a rotation is active
        [tcpm] M128 or FUNCTION TCPM is active
        [other-axis] the tool axis is not Z
        [turning] the control is in turning mode (FUNCTION MODE TURN)
       *[tilting] the working plane is tilted
    }, which its manual forbids.
diag-transformation-without-effect =
    { $what ->
        [again] { $cycle } defines the transformation that is active already, and the same subprogram is called again.
       *[ended] { $other } ends the transformation of { $cycle } before anything uses it.
    }
diag-transformation-left-on =
    The program ends here with an active { $what ->
        [datum-shift] datum shift
        [rotation] rotation
        [mirroring] mirror image
       *[scaling] scaling factor
    }.
diag-feed-unit =
    { $what ->
        [revolution] { $parameter }={ $value } is a feed per revolution here, because M136 is active.
        [revolving] { $parameter }{ $value } is a feed per revolution here, because M136 is active.
        [large] { $parameter }={ $value } is a feed per revolution here, and far too large for turning.
        [moving] { $parameter }{ $value } is a feed per minute here, because M136 is not active.
       *[minute] { $parameter }={ $value } is a feed per minute here, because M136 is not active.
    }
diag-turning-system-missing = { $cycle } is called here, but { $aligning } has not been defined since the tool call.
diag-cutting-speed-unlimited = The cutting speed is constant and the speed has no limit, but in line { $line } the tool comes to the rotary axis.
diag-two-signs = The number has two signs; they are read as { $right }.
diag-unknown-cycle =
    { $name ->
        [none] No manual known to Ciklo mentions { $cycle }.
       *[other] { $cycle } ({ $name }) is a cycle of the first controls: it still runs, and its values are not checked.
    }
diag-unknown-parameter = { $cycle } has no { $parameter } on this control.
diag-differs-from-other-control =
    { $what ->
        [missing] { $cycle } has { $parameter } on the { $control }, but it is missing here.
        [value] The { $control } does not accept { $parameter }={ $value } in { $cycle }.
        [twice] { $parameter } is given twice in { $cycle }.
        [foreign] { $cycle } has no { $parameter } on the { $control }.
        [order] { $parameter } comes after { $before }, but before it in { $cycle } on the { $control }.
        [label] “{ $label }” belongs to { $other } in { $cycle } on the { $control }, not to { $parameter }.
        [doubt] { $cycle } is doubtful: { $message }
        [alone] No cycle with this parameter accepts { $parameter }={ $value }, as in { $cycle }.
       *[guard] The { $control } would refuse { $cycle }: { $message }
    }
diag-unreachable =
    { $part ->
        [label] Nothing leads to this label.
       *[block] This block is never executed.
    }
diag-meaningless-value = The value { $value } is not possible here.
diag-word-missing = This block lacks { $word }.
diag-word-twice = { $word } is programmed twice in this block.
diag-word-wrong =
    { $what ->
        [below] { $word } is { $value }, which is too small.
        [above] { $word } is { $value }, which is too large.
        [whole] { $word } is { $value }, but must be a whole number.
        [offers] { $word } must be followed by one of: { $value }.
        [contradict] { $word } and { $value } exclude each other.
        [zero] { $word } must not all be 0.
        [not-below] { $word } must be less than { $value }.
        [operator] “{ $word }” is written instead of { $value }.
        [empty] The name is empty.
        [value] { $word } has no value.
        [place] { $word } is not permitted in this block.
        [line] The three points are on one line and do not determine a plane.
        [parallel] The two vectors are parallel and do not determine a plane.
        [number] The text of { $word } is not a number: “{ $value }”.
        [beyond] { $word } is { $value }, which is beyond the end of the text.
        [file] { $value } is not a { $word } file.
        [shorter] { $word } is { $value }: the control takes the tool for so much shorter, and everything becomes deeper by that.
        [askew] The base vector and the normal vector must be perpendicular to each other.
       *[tool] { $value } is not a tool number: only one digit may follow the point.
    }
diag-wrong-value-kind =
    { $parameter } of { $cycle } takes { $kind ->
        [integer] a whole number
        [number-or-name] a number or a name in quotation marks
        [text] a text in quotation marks
        [q-number] a Q parameter
        [axis-direction] an axis with a sign, such as X-
        [position] coordinates by axis, such as X+5 Y+0
        [row] a row of a table, such as #5
        [axis] an axis
        [label-list] label numbers separated by slashes, such as 1/2/3
       *[number] a number
    }{ $words-count ->
        [0] {""}
       *[other] {" "}or { $words }
    }.
diag-coolant-forgotten = This tool cuts without coolant; all other tools of the program turn it on.
diag-comment-contradicts =
    { $what ->
        [digits] The value is { $value } here, and { $other } in the comment: two digits are exchanged.
        [result] The result is { $value }, and not { $other } as the comment says.
        [scale] The scaling factor { $value } does not belong to the { $other } percent of the comment.
        [parameter] { $value } is read here, and the comment above names { $other }.
       *[holes] The program makes { $value } holes after this tool call, and the comment says { $other }.
    }
diag-decimal-comma = This value has a decimal comma, other values of the program have a decimal point.
diag-definitions-differ =
    { $what ->
        [deep] The infeed { $value } takes the whole depth { $other } at once, which is more than the diameter of the tool.
        [infeed] The infeed is { $value } here, and { $other } in the other definition of the same pocket or slot.
        [operation] Both definitions of this pocket or slot only rough: the allowance of { $other } stays.
        [turned] The value is { $value } here, and { $other } in the definition that roughs the same turned contour.
       *[size] The value is { $value } here, and { $other } in the definition that roughs the same pocket or slot.
    }
diag-helix-too-steep =
    { $what ->
        [up] The helix goes up by { $value }, although a full circle follows as at a floor: its sign is wrong.
        [pitch] The helix has a pitch of { $value }, and the thread mill has { $other }.
        [left] This helix cuts a left-hand thread; neither the tool nor a comment says that it is one.
       *[steep] The helix goes down by { $value } in one turn; more than { $other } no tool cuts here.
    }
diag-holes-differ =
    { $what ->
        [stray] The hole at { $value }, { $other } was not centred, and a place that was centred has no hole.
        [untapped] The core hole at { $value }, { $other } is not tapped, but others of the same row are.
        [unreamed] The hole at { $value }, { $other } is not reamed, but others of the same row are.
        [uncentred] The hole at { $value }, { $other } was not centred, but all others of the same row were.
        [unused] The place { $value }, { $other } was centred and stays without a hole, unlike all others of the same row.
        [gap] The circle of holes lacks the one at { $value }, { $other }.
        [corner] This hole does not lie at the corner { $value }, { $other } of the rectangle that the three others form.
        [passed] The tool stops at { $value }, { $other } and does nothing there; the blocks before and after call the cycle.
        [rotation] The tool machines at { $value } of { $other } equal angles of a full turn here: one is missing.
       *[arc] The centre misses the hole at { $value }, { $other }; the other arcs lie about holes.
    }
diag-probing-place-wrong =
    { $what ->
        [angle] A hole is measured at { $value } degrees, but the pattern makes none there.
        [apart] The second hole is only { $value } from the first one, whose diameter is { $other }.
        [side] A side of { $value } is probed here, and the blank is { $other } wide there: the probe goes down onto it.
        [centre] Nothing was machined at this centre, but something was at { $value }, { $other }.
        [corner] The corner is probed on the other side of the blank than the datum { $value }.
        [size] A size of { $value } is probed here, and the blank is only { $other } wide there.
        [axis] Measured is the axis in which the place is at { $value }, but the greatest dimension is { $other }: the limits are those of another axis.
        [later] A diameter of { $value } is probed here, and later one of { $other } at the same centre: the probe goes down beside the hole.
        [removed] The surface at { $value } that is probed here has been milled away before, down to { $other }.
        [across] A width of { $value } is probed in this axis, but what was milled here is { $other } wide along it: it lies the other way.
       *[outside] The place { $value }, { $other } is beside the blank: there is nothing to probe.
    }
diag-rough-out-tool-other =
    { $what ->
        [pilot] Tool { $value } is named here, but tool { $other } roughs out.
       *[coarse] Tool { $value } has not roughed out before; tool { $other } has.
    }
diag-speed-and-feed-exchanged = The tool is called with a speed of { $value } and a feed of { $other }: the two seem to be exchanged.
diag-stud-in-solid = The raw size { $value } is far less than the blank around the stud, which is { $other } wide here.
diag-surface-wrong =
    { $what ->
        [unlike] The surface is at { $value }, that of the other cycles at these places at { $other }, and nothing has been machined so deep before.
        [opposite] The surface at { $value } is above the blank; others begin or end at { $other }.
        [pattern] The surface of the pattern is at { $value }, that of the cycle which it calls at { $other }: the one of the pattern acts.
        [air] The cycle works in the air here: it goes down to { $value }, where everything has been milled away before.
        [high] The cycle works from where it is called, at { $value }: its surface then lies at { $other }, above the blank.
        [low] The cycle is called inside the blank, at { $value }, and nothing has been machined down to its surface at { $other }.
        [below] The cycle comes down at rapid to { $value }, but here others have gone only to { $other }: it goes into the material.
        [cylinder] The cylinder has the radius { $value }, but the blank about its axis has { $other }.
       *[faced] The surface is at { $value }, but the face was milled down to { $other }.
    }
diag-turned-thread-wrong =
    { $what ->
        [pitch] The pitch { $value } is far too large for a thread with the diameter { $other }.
        [tool] The thread has a pitch of { $value }, but the tool is made for { $other }.
        [end] The thread goes to { $value }, behind the end of its cylinder at { $other }.
        [groove] The thread goes to { $value }, past the groove that ends at { $other }.
        [inside] An inside thread is cut at the diameter { $value }, which was turned outside.
        [speed] The thread is turned at a constant cutting speed (VCONST:ON): the spindle speed changes from pass to pass.
       *[diameter] The thread has the diameter { $value }, but { $other } was turned there.
    }
diag-tilted-work =
    { $what ->
        [beside] In the tilted plane this cycle meets nothing of the blank.
       *[stands] The cycle begins at { $value }, but in the tilted plane the blank stands up to { $other } here.
    }
diag-circle-point-wrong =
    { $what ->
        [angle] { $parameter } is calculated with the angle { $value }, and { $other } with { $angle }: the two coordinates of a point on a circle have the same angle.
       *[function] { $parameter } and { $other } are both calculated with { $value } of the same angle: a point on a circle has the sine in one coordinate and the cosine in the other.
    }
diag-formula-wrong =
    { $what ->
        [square] { $parameter } is a sum or difference of squares and is used as a length: the square root is missing.
       *[radius] { $parameter } is calculated with the other sign of the tool radius Q108 than before the previous call: the tool is on the other side of the same size.
    }
diag-correction-wrong =
    { $what ->
        [side] { $parameter } is corrected by { $other }, which is the deviation of the other side.
        [actual] { $other } is the measured size itself, not its deviation: next to nothing is left of the size { $parameter }.
        [radius] { $parameter } is the deviation of a diameter or a width, and corrects the radius of the tool without being halved.
        [turned] The deviation { $parameter } corrects the radius of the tool with the wrong sign: the error is doubled.
       *[added] The deviation { $other } is added to the size { $parameter }: it must be taken away.
    }
diag-monitored-tool-idle =
    { $what ->
        [elsewhere] { $cycle } monitors or corrects tool { $tool }, which has not milled what is measured: that was tool { $other }.
       *[idle] { $cycle } monitors or corrects tool { $tool }, which has not been called before.
    }
