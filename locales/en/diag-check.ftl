# Findings of the program checker and of the translation of programs.

diag-call-of-def-active-cycle = { $cycle } acts as soon as it is defined; it must not be called.
diag-called-but-not-defined = A cycle is called here, but none is defined before.
diag-choice-not-offered = { $parameter }={ $value } is none of the choices: { $offered }.
diag-clearance-height-too-low = { $cycle } touches at { $touched }: the clearance height { $parameter }={ $value } must lie above { $least }.
diag-cycle-not-described = { $cycle } ({ $name }) is named by the manuals and not described: its parameters are not checked.
diag-cycle-not-on-control = { $cycle } does not exist on the { $control }; it exists on: { $controls }.
diag-defined-but-never-called = { $cycle } is defined here and never called.
diag-duplicate-parameter = { $parameter } stands twice in { $cycle }.
diag-guard = The control objects to these values.
diag-label-missing = The language “{ $language }” has no label for { $parameter } of { $cycle }.
diag-label-not-encodable = “{ $label }” has the character “{ $character }”, which the file's encoding cannot write.
diag-label-of-another-language = “{ $label }” is a label in another language ({ $language }); most of the program calls { $parameter } “{ $right }”.
diag-label-of-another-parameter = “{ $label }” is the label of { $other }, not of { $parameter }.
diag-misordered-parameter = In { $cycle } the control shows { $parameter } before { $before }.
diag-missing-parameter = { $cycle } lacks { $parameter }.
diag-out-of-range =
    { $side ->
        [below] { $parameter }={ $value } is too small: the least value is { $limit }.
        [long] The text of { $parameter } is too long: it may have { $limit } characters.
        [many] { $parameter } lists too many labels: it may list { $limit }.
       *[above] { $parameter }={ $value } is too great: the greatest value is { $limit }.
    }
diag-spindle-off = A machining cycle is called here while the spindle stands.
diag-tool-missing = A cycle moves here, but no tool call has named the tool axis before.
diag-unknown-cycle = { $cycle } is a cycle of no control known here.
diag-unknown-parameter = { $cycle } has no { $parameter } on this control.
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
