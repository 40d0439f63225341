# Findings of the program checker and of the translation of programs.

diag-approach-twice = The contour is approached here while radius compensation is active: the one before it was not left.
diag-approach-without-compensation =
    { $what ->
        [approach] The contour is approached here without RL or RR.
       *[departure] The contour is left here, but no radius compensation is active.
    }
diag-arc-in-unequal-scaling = { $cycle } scales the axes of this arc by different factors.
diag-arc-too-narrow = The radius { $radius } on the inside of the contour is less than that of the tool, { $tool }.
diag-arc-without-tangent = No contour element precedes this tangential arc.
diag-arc-wrong =
    The arc cannot end here: { $what ->
        [radius] its radius is { $first }, and start and end are { $second } apart
        [full] it ends where it begins; the centre of a full circle does not follow from its radius
        [sense] its angle is { $first }, and DR turns the other way
       *[centre] its start is { $first } from the centre, its end { $second }
    }.
diag-axis-twice = Axis { $axis } is programmed twice in this block.
diag-blocks-after-end = Blocks after END PGM are not executed.
diag-blank-wrong =
    { $what ->
        [again] The blank has a BLK FORM 0.1 before it already.
        [axis] { $axis } is missing here: a corner of the blank has three coordinates.
        [first] BLK FORM 0.2 has no BLK FORM 0.1 before it.
        [cylinder] The cylinder has no radius or diameter, or no length.
        [second] BLK FORM 0.1 is not followed by BLK FORM 0.2.
        [tool] The blank names no tool axis.
       *[order] In the axis { $axis } the coordinate of the second corner of the blank is not greater than that of the first one.
    }
diag-block-numbers = The block number { $number } follows { $before }.
diag-call-of-def-active-cycle = { $cycle } acts as soon as it is defined; it must not be called.
diag-called-but-not-defined = A cycle is called here, but none is defined before.
diag-called-program-in-other-unit = This program is in { $own }, the called program { $name } in { $other }.
diag-called-program-missing = The called program { $name } is not in the folder of this program, where the control looks for it.
diag-centre-in-other-plane = The arc leads through another plane than the one in which its centre lies.
diag-choice-not-offered = { $parameter }={ $value } is none of the choices: { $offered }.
diag-clearance-height-too-low = { $cycle } touches at { $touched }: the clearance height { $parameter }={ $value } must lie above { $least }.
diag-compensation-at-cycle =
    { $cycle } is executed here while radius compensation is active.
diag-compensation-left-on = Radius compensation is still active here.
diag-compensation-on-arc = Radius compensation begins in an arc here.
diag-compensation-switched = Radius compensation changes its side here without R0 in between.
diag-contour-data-missing = { $cycle } is called, but { $data } has not been defined before.
diag-contour-def-wrong =
    { $what ->
        [number] { $found }: another contour has this number already.
        [many] { $found }: CONTOUR DEF has nine contours at most.
       *[island] { $found }: the first contour of CONTOUR DEF is a pocket, the deepest one.
    }
diag-contour-depth-missing = { $contour } has no DEPTH, other contours have one.
diag-contour-undeclared =
    { $what ->
        [twice] { $contour } is declared before already.
       *[nothing] The formula reads { $contour }, which nothing names before it.
    }
diag-contour-not-selected =
    { $cycle } is called here, but no contour has been named before.
diag-contour-wrong =
    { $cycle } cannot machine the contour like this: { $what ->
        [axis] it moves the tool axis { $word }
        [approach] it contains { $word }
        [tool] it contains { $word }
        [call] it contains { $word }
        [path] the cycle does not read { $word }
        [first] its first point does not name both coordinates of the plane
        [uncompensated] it has neither RL nor RR
        [many] the cycle machines only the first contour, not { $word }
        [corner] no element follows { $word }
        [local] { $word } is read and not assigned in it
       *[open] it does not end where it begins
    }.
diag-coordinate-out-of-place = The coordinates do not fit { $path }.
diag-corner-wrong =
    This corner cannot be machined: { $what ->
        [twice] the element before it is already a rounding or chamfer
        [arc] a chamfer lies between straight lines, and there is an arc
        [first] no contour element precedes it
        [alone] no contour element follows it
        [back] the line after it runs back over the line before it
        [size] its radius or length is not positive
       *[long] it takes more than the shorter line has, { $least }
    }.
diag-cutting-without-tool = The tool moves at feed rate before any tool call.
diag-cycle-line-zero-missing = The line { $line } has no line { $head } before it.
diag-cycle-line-empty = Line { $line } of { $cycle } is empty.
diag-cycle-line-missing = The line { $missing } is missing before { $line }.
diag-cycle-line-twice = Line { $line } is given twice in this definition.
diag-cycle-not-covered =
    { $other ->
        [none] { $cycle } is not checked: the manuals of the { $control } that are known here do not treat such cycles.
       *[other] The manuals of the { $control } that are known here do not treat cycles such as { $cycle }: it is measured by the manual of the { $other }.
    }
diag-cycle-not-described =
    { $other ->
        [none] { $cycle } ({ $name }) is named by the manuals and not described: its parameters are not checked.
       *[other] { $cycle } ({ $name }) is named by the manuals and not described: it is measured by the manual of the { $other }.
    }
diag-cycle-not-on-control = { $cycle } does not exist on the { $control }; it exists on: { $controls }.
diag-cycle-of-previous-tool = { $cycle } was defined for the tool before and has machined with it.
diag-datum-table-late = The preceding datum shift took its row from another table: program SEL TABLE before it.
diag-defined-but-never-called = { $cycle } is defined here and never called.
diag-digitizing-wrong =
    { $what ->
        [swapped] { $word } is less than the MIN point of the range, { $other }.
        [low] The clearance height { $word } is below the MAX point of the range, { $other }.
        [missing] { $cycle } digitizes, but no range has been defined before.
       *[combined] { $cycle } cannot be combined with { $range }, which defines the range here.
    }
diag-arc-direction-missing = This arc does not say which way round it goes: DR+ or DR− is missing.
diag-doubtful-value =
    { $parameter }={ $value } is hardly meant in { $cycle }: { $is ->
        [zero] the value is 0
        [negative] the value is negative
       *[positive] the value is positive and leads away from the workpiece
    }.
diag-duplicate-parameter = { $parameter } is given twice in { $cycle }.
diag-empty-word = This { $word } has no value and does nothing.
diag-feed-negative = The feed is negative here.
diag-feed-zero = The feed is zero here.
diag-field-word-missing = The value has no word; the control shows it with one: { $shown }.
diag-begin-end-mismatch = END PGM says { $end }, BEGIN PGM says { $begin }.
diag-free-contour-wrong =
    { $what ->
        [label] A free contour cannot begin directly after a label.
        [again] CLSD+ is programmed again before CLSD- has closed the contour.
        [unbegun] CLSD- closes a contour here that no CLSD+ has begun.
        [unclosed] The contour that CLSD+ has begun ends here without CLSD-.
        [length] The length LEN is not positive.
        [auxiliary] The distance D has no auxiliary point (PDX, PDY).
        [distance] The auxiliary point has no distance D.
        [selected] FSELECT does not follow an element of a free contour.
        [solution] FSELECT takes the number of a solution, counted from 1.
        [fpol] The pole of a free contour has two coordinates.
        [pole] Polar data need a pole (FPOL).
       *[open] The free contour is not determined: too little is known of its elements.
    }
diag-function-misspelled = No control knows { $word } here; { $meant } may be meant.
diag-function-not-on-control = The { $control } does not have { $function }.
diag-functions-contradict = { $first } and { $second } are in one block; only one of them can be meant.
diag-global-def-wrong =
    { $what ->
        [unknown] There is no GLOBAL DEF { $number }.
        [missing] GLOBAL DEF { $number } lacks { $parameter }.
        [foreign] GLOBAL DEF { $number } does not give { $parameter }.
        [twice] { $parameter } is given twice in GLOBAL DEF { $number }.
        [again] GLOBAL DEF { $number } was programmed before, and no cycle has used its values.
        [nothing] { $parameter } is PREDEF in { $value }, and no GLOBAL DEF gives it.
        [later] { $parameter } is PREDEF in { $value }, and the GLOBAL DEF that gives it comes only later.
       *[value] No cycle takes { $parameter }={ $value }.
    }
diag-guard = The control objects to these values.
diag-hole-outside-blank =
    { $what ->
        [beside] The hole at { $value }, { $other } is next to the blank.
        [surface] The surface at { $value } is not on the blank.
       *[through] The hole reaches down to { $value }, far through the blank.
    }
diag-iso-incomplete =
    This block is incomplete: { $what ->
        [value] a letter has no value
        [label] the label is missing (L)
        [radius] the radius or length is missing (R)
        [cycle] the words of the cycle are missing (P01, P02, …)
       *[operand] an operand or the label of a jump is missing (P01, P02, P03)
    }.
diag-label-duplicate = The label { $label } is set a second time here.
diag-label-missing = The language “{ $language }” has no label for { $parameter } of { $cycle }.
diag-label-not-encodable = “{ $label }” has the character “{ $character }”, which the file's encoding cannot write.
diag-label-of-another-language = “{ $label }” is a label in another language ({ $language }); most of the program calls { $parameter } “{ $right }”.
diag-label-of-another-parameter = “{ $label }” is the label of { $other }, not of { $parameter }.
diag-label-twice = { $parameter } and { $other } both have the label “{ $label }”: one of them has another label.
diag-label-undefined = No block sets the label { $label }.
diag-labels-of-unknown-language =
    { $count ->
        [one] This definition has labels in a language that is not known here; it was read by its numbers.
       *[other] { $count } definitions, this is the first, have labels in a language that is not known here; they were read by their numbers.
    }
diag-languages-mixed = Most labels are in one language ({ $language }); the definitions in these lines are in another ({ $others }): { $lines }.
diag-loop-endless = Nothing in the loop that this jump closes can end it.
diag-machine-coordinates-compensated = Machine coordinates (M91, M92) are programmed here with radius compensation.
diag-main-runs-into-subprogram = The main part runs into the subprogram { $label } here: neither M2 nor M30 ends it.
diag-measuring-height-below-floor = { $cycle } measures at { $parameter }={ $value }, below the floor that { $milling } leaves there, { $floor }.
diag-metric-values-in-inch = The program is in inches, and { $value } looks like millimetres.
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
       *[again] so that the tool machines the last position once more
    }.
diag-mode-wrong =
    { $what ->
        [milling] { $cycle } mills or drills, but FUNCTION MODE TURN is active here.
        [turning] { $cycle } turns, but FUNCTION MODE TURN is not active here.
       *[data] { $cycle } is used outside of turning mode.
    }
diag-name-of-another-cycle = “{ $name }” is the name of { $other }, but this is { $cycle }.
diag-no-result =
    This formula has no result: { $why ->
        [division] it divides by zero
        [large] the number is too large
       *[domain] a function is given a value that it is not defined for
    }.
diag-no-table-open = FN 27 and FN 28 work on the table that FN 26 opened.
diag-not-a-program = This file is no NC program.
diag-number-does-not-exist = { $name } does not exist: the numbers go up to { $greatest }.
diag-older-parameter-set = { $cycle } has the parameters of an earlier software version; the control adds { $parameter }.
diag-out-of-range =
    { $side ->
        [below] { $parameter }={ $value } is too small: the least value is { $limit }.
        [long] The text of { $parameter } is too long: it may have { $limit } characters.
        [many] { $parameter } lists too many labels: it may list { $limit }.
        [axes] { $parameter } names too many axes: it may name { $limit }.
       *[above] { $parameter }={ $value } is too great: the greatest value is { $limit }.
    }
diag-out-of-usual-range =
    { $parameter }={ $value } is hardly meant: { $where ->
        [control] the { $control } takes no value { $side ->
                [below] below
               *[above] above
            } { $limit } there.
       *[any] no manual prints a range for such parameters that goes { $side ->
                [below] below
               *[above] above
            } { $limit }.
    }
diag-parameter-of-later-software = { $parameter } in { $cycle } needs a later software version than { $software }, which the manual describes.
diag-parameter-unassigned =
    { $parameter } is read here, but nothing gives it a value before.
diag-pattern-combination =
    { $what ->
        [value] { $cycle } cannot call { $called } with { $value }.
       *[cycle] { $cycle } cannot call { $called }.
    }
diag-pattern-wrong =
    { $what ->
        [count] { $word } is a whole number of positions, at least 1.
        [many] { $word }: PATTERN DEF has nine single positions at most.
        [rapid] { $word } is not taken here: between the points of a table the tool moves at a feed.
        [distance] { $word } is 0: all positions are the same one.
        [angle] { $word } is more than a full turn.
        [same] { $word } is the same position as one before it.
       *[diameter] The diameter { $word } of a circle of positions is greater than 0.
    }
diag-plane-incomplete = This PLANE lacks { $word }.
diag-plane-not-positioned = STAY leaves the rotary axes where they are, and no block of the program moves one to the angles of this plane.
diag-plane-not-reset = The program ends here with a tilted working plane.
diag-position-after-contour = This is the first position after { $cycle }, and it does not name both coordinates of the plane absolutely.
diag-probe-while-turning = { $cycle } probes here while the spindle turns.
diag-probed-axis-missing = { $direction } is probed, but the position does not name { $axis }.
diag-program-begin-missing = The program does not begin with BEGIN PGM.
diag-program-begin-twice = BEGIN PGM is programmed a second time.
diag-program-calls-itself = The program calls itself: { $name }.
diag-program-empty = The file holds no block.
diag-program-end-missing =
    The program ends here without { $end ->
        [iso] a block that begins with % and ends it
       *[pgm] END PGM
    }.
diag-programs-call-in-circle = The program { $name } calls this one back, be it through others.
diag-rapid-into-blank = The tool moves into the blank at rapid here: Z goes to { $value }, and the blank reaches up to { $top }.
diag-repeat-count-wrong = A part of a program is repeated a whole number of times from 0 to 65534.
diag-repeat-of-later-label = The label { $label } comes after this repeat.
diag-reserved-parameter =
    { $parameter } is written here, but the control itself writes Q100 to Q199.
diag-reset-order-wrong =
    { $what ->
        [tilt] The tilted plane is reset here while the rotation that was switched on after it is still active.
       *[shift] The datum shift is reset here while the plane that was tilted after it is still tilted.
    }
diag-retract-missing =
    The tool is at { $value }, in or just above the blank, when { $what ->
        [change] it is changed
       *[turn] a rotary axis turns at rapid traverse
    }: it was not retracted.
diag-row-not-in-table =
    { $table ->
        [preset] The preset table has no row { $row }.
       *[datum] The datum table has no row { $row }.
    }
diag-program-not-selected = A selected program is called here, but none has been selected.
diag-speed-missing = The spindle is turned on here, but no speed has been programmed.
diag-speed-out-of-range =
    { $what ->
        [feed] The feed { $value }
       *[speed] The spindle speed { $value }
    } is hardly meant: { $side ->
        [below] it is negative
       *[above] { $limit } is the greatest that the manuals let anybody enter
    }.
diag-spindle-direction = { $cycle } needs a spindle that turns clockwise, and it turns counter-clockwise here.
diag-spindle-off = Material is removed while the spindle is not turning.
diag-sql-handle-missing =
    { $what ->
        [ended] COMMIT or ROLLBACK has ended the transaction with the handle { $handle } before.
       *[missing] No query has given the handle { $handle } before.
    }
diag-subprogram-end-without-label = This LBL 0 ends no subprogram.
diag-subprogram-recursive = The subprogram { $label } calls itself here.
diag-subprogram-runs-on = The subprogram { $label } runs into the subprogram { $next }: there is no LBL 0 between them.
diag-subprogram-without-end = The subprogram { $label } comes to the end of the program without LBL 0.
diag-tcpm-left-on =
    { $what ->
        [tool] A tool is called here while M128 or FUNCTION TCPM is active.
       *[end] The program ends here while M128 or FUNCTION TCPM is active.
    }
diag-text-for-number =
    { $what ->
        [text] { $parameter } takes a number, and this is a text.
        [number] { $parameter } takes a text, and this is a number.
       *[calculation] This is a text; it cannot be calculated with.
    }
diag-text-wrong =
    { $what ->
        [empty] The text of { $parameter } is empty.
        [alone] “{ $found }” in the text of { $parameter } is neither doubled nor followed by a letter.
       *[character] { $parameter } takes no “{ $found }”.
    }
diag-tool-axis-missing = This tool call names no tool axis, and none was named before.
diag-tool-axis-other =
    { $what ->
        [pattern] PATTERN DEF works with the tool axis { $axis } only, and another one is active here.
       *[blank] The blank names the tool axis { $axis }, and no tool of the program has it.
    }
diag-tool-definition-wrong =
    { $what ->
        [zero] Tool 0 is no tool and cannot be defined.
        [twice] Tool { $tool } is defined with other measures before already.
       *[after-call] Tool { $tool } is defined here, and has been called before.
    }
diag-tool-feed-missing = The feed of the tool call is taken here, but it has none.
diag-tool-missing = A cycle moves here, but no tool call has named the tool axis before.
diag-tool-not-listed = The tool table has no tool { $tool }.
diag-wrong-tool-type =
    { $what ->
        [probe] { $cycle } probes here with the tool that has just machined.
       *[mill] { $cycle } machines here with the tool that has just probed.
    }
diag-tool-unused = The tool { $tool } is called here and changed for another one at once.
diag-transfer-parameter-overwritten =
    { $what ->
        [passed] { $cycle } has read { $parameter } when it was defined: what is written here does not change its call.
        [filled] { $cycle } fills four parameters from the one named here, and with them { $parameter }, which the program has written before and reads later.
        [lost] { $cycle } writes over { $parameter } before the program reads what is written here.
       *[call] { $parameter } belongs to { $cycle }, which is called later: the call takes the value that is written here.
    }
diag-transformation-forbidden =
    { $cycle } is used although { $what ->
        [datum-shift] a datum shift is active
        [rotation] a rotation is active
        [tcpm] M128 or FUNCTION TCPM is active
        [other-axis] the tool axis is not Z
        [turning] the control turns (FUNCTION MODE TURN)
       *[tilting] the working plane is tilted
    }, which its manual forbids.
diag-transformation-left-on =
    The program ends here with an active { $what ->
        [datum-shift] datum shift
        [rotation] rotation
        [mirroring] mirror image
       *[scaling] scaling factor
    }.
diag-turning-feed-unit =
    { $what ->
        [revolution] { $parameter }={ $value } is a feed for a revolution here, as M136 is active.
       *[minute] { $parameter }={ $value } is a feed for a minute here, as M136 is not active.
    }
diag-turning-system-missing = { $cycle } is called here, but since the tool call { $aligning } has not been defined.
diag-two-signs = The number has two signs; they are read as { $right }.
diag-unknown-cycle =
    { $name ->
        [none] { $cycle } is a cycle of which no manual here speaks.
       *[other] { $cycle } ({ $name }) is a cycle of the first controls: it still runs, and its values are not checked.
    }
diag-unknown-parameter = { $cycle } has no { $parameter } on this control.
diag-differs-from-other-control =
    { $what ->
        [missing] { $cycle } has { $parameter } on the { $control }, and here it is missing.
        [value] { $parameter }={ $value } in { $cycle } is a value that the { $control } refuses.
        [twice] { $parameter } is given twice in { $cycle }.
        [foreign] { $cycle } has no { $parameter } on the { $control }.
        [order] { $parameter } comes after { $before }; in { $cycle } on the { $control } it precedes it.
        [label] “{ $label }” belongs to { $other } in { $cycle } on the { $control }, not to { $parameter }.
        [doubt] { $cycle } is doubtful: { $message }
        [alone] { $parameter }={ $value } in { $cycle } is a value that no cycle with this parameter takes.
       *[guard] On the { $control } { $cycle } is refused: { $message }
    }
diag-unreachable =
    { $part ->
        [label] Nothing leads to this label.
       *[block] The run never comes to this block.
    }
diag-meaningless-value = The value is { $value } here, which makes no sense.
diag-word-missing = This block lacks { $word }.
diag-word-twice = { $word } is programmed twice in this block.
diag-word-wrong =
    { $what ->
        [below] { $word } is { $value }, which is too little.
        [above] { $word } is { $value }, which is too much.
        [whole] { $word } is { $value }, and takes whole numbers only.
        [offers] { $word } is followed by one of: { $value }.
        [contradict] { $word } and { $value } exclude each other.
        [zero] { $word } must not all be 0.
        [not-below] { $word } must be less than { $value }.
        [operator] “{ $word }” is written instead of { $value }.
        [empty] The name is empty.
        [value] { $word } has no value.
        [place] { $word } has no place in this block.
        [line] The three points lie on one line and give no plane.
        [parallel] The two vectors are parallel and give no plane.
        [number] The text of { $word } is no number: “{ $value }”.
        [beyond] { $word } is { $value }, which is beyond the end of the text.
        [file] { $value } is no { $word } file.
       *[tool] { $value } is no tool number: one digit follows the point.
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
        [label-list] numbers of labels with bars between them, such as 1/2/3
       *[number] a number
    }{ $words-count ->
        [0] {""}
       *[other] {" "}or { $words }
    }.
