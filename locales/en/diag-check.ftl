# Findings of the program checker and of the translation of programs.

diag-call-of-def-active-cycle = { $cycle } acts as soon as it is defined; it must not be called.
    .explain = Patterns, coordinate transforms and touch-probe cycles act when they are defined. A call behind them is a mistake if no machining cycle is defined before, or if it stands directly behind a pattern, which has called the machining cycle already.
diag-called-but-not-defined = A cycle is called here, but none is defined before.
    .explain = CYCL CALL, M99 and M89 execute the machining cycle that was defined last. Without a definition there is nothing to execute. In programs with jumps, subprograms or skipped blocks this is only said if no cycle is defined at all, and never if other programs are called.
diag-choice-not-offered = { $parameter }={ $value } is none of the choices: { $offered }.
    .explain = The parameter offers a choice of values, each with a meaning of its own, and this is none of them. Example: Q215=3 in CYCL DEF 251.
diag-cycle-not-described = { $cycle } ({ $name }) is named by the manuals and not described: its parameters are not checked.
    .explain = The control has the cycle, but no specification describes it here. Its parameters, labels and effect are passed over.
diag-cycle-not-on-control = { $cycle } does not exist on the { $control }; it exists on: { $controls }.
    .explain = The manuals of this control do not know the cycle, those of another one do. The program was written for that control, or the wrong control was chosen with --control.
diag-defined-but-never-called = { $cycle } is defined here and never called.
    .explain = The cycle acts when it is called with CYCL CALL, M99 or M89, or by a pattern, and nothing of that follows before the next such cycle or the end. The definition does nothing, or the call was forgotten.
diag-duplicate-parameter = { $parameter } stands twice in { $cycle }.
    .explain = The definition gives the same parameter or field two values; it cannot be said which one is meant.
diag-guard = The control objects to these values.
    .explain = The specifications state under which conditions a control refuses a cycle, skips it, warns or asks. Each such guard has a code of its own; it is only checked with values that the program writes as numbers or texts.
diag-label-missing = The language “{ $language }” has no label for { $parameter } of { $cycle }.
    .explain = The program cannot be written wholly in this language: a text of the specifications is not translated yet. The old label stays. ciklo coverage lists what is missing.
diag-label-not-encodable = “{ $label }” has the character “{ $character }”, which the file's encoding cannot write.
    .explain = The program is not a UTF-8 file, and its encoding (Windows-1252) lacks a character of the new label. Convert the file to UTF-8 first if the control reads that.
diag-label-of-another-language = “{ $label }” is a label in another language ({ $language }); most of the program calls { $parameter } “{ $right }”.
    .explain = Most labels of the program are in one language, this one is in another. ciklo translate writes them all in one language.
diag-label-of-another-parameter = “{ $label }” is the label of { $other }, not of { $parameter }.
    .explain = The comment behind the value is the label of another parameter of the same cycle. The control reads the number only, but the value may be meant for the other one. Labels that no language has are left alone.
diag-misordered-parameter = In { $cycle } the control shows { $parameter } before { $before }.
    .explain = Controls know parameters by their numbers and accept another order, but the definition was hardly written by one. The first parameter out of order is reported.
diag-missing-parameter = { $cycle } lacks { $parameter }.
    .explain = The control's manual lists the parameter or field for the cycle, and the definition does not have it. Definitions with a line that cannot be read are passed over. Example: CYCL DEF 247 without Q339.
diag-out-of-range =
    { $side ->
        [below] { $parameter }={ $value } is too small: the least value is { $limit }.
        [long] The text of { $parameter } is too long: it may have { $limit } characters.
       *[above] { $parameter }={ $value } is too great: the greatest value is { $limit }.
    }
    .explain = The control's manual prints a range for the parameter, and the value lies outside. Ranges are those of this control only; where its manual prints none, nothing is checked. In programs in inches lengths and feeds are not checked. Example: Q202=-5.
diag-spindle-off = A machining cycle is called here while the spindle stands.
    .explain = Nothing has turned the spindle on (M3, M4, M13, M14), or it was stopped since (M0, M5, M6). Behind a tool call and M functions of the machine builder nothing is said. Said once a program.
diag-tool-missing = A cycle moves here, but no tool call has named the tool axis before.
    .explain = Cycles need the tool axis, which TOOL CALL names: TOOL CALL 5 Z S2000. Said once a program.
diag-unknown-cycle = { $cycle } is a cycle of no control known here.
    .explain = The number stands for no cycle in any manual that the specifications come from, and not for one of the machine builder (300 to 399, 500 to 599). Check keyword and number: CYCL DEF 32 and TCH PROBE 32 are different cycles. Example: CYCL DEF 299.
diag-unknown-parameter = { $cycle } has no { $parameter } on this control.
    .explain = The parameter or field is not among those that the control's manual lists for the cycle. It belongs to another cycle or another control, or its number is mistyped. Example: Q999 in CYCL DEF 247.
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
       *[number] a number
    }{ $words-count ->
        [0] {""}
       *[other] {" "}or { $words }
    }.
    .explain = The value is of a kind that the parameter does not take: a text instead of a number, a fraction where a whole number is needed, a word that the manual does not list for it, or nothing. A Q parameter is always a good value. Example: Q201=FAUTO.
