# What the codes of the program checker mean, for `ciklo explain`.

explain-call-of-def-active-cycle = Patterns, coordinate transforms and touch-probe cycles act when they are defined. A call behind them is a mistake if no machining cycle is defined before, or if it stands directly behind a pattern, which has called the machining cycle already.
explain-called-but-not-defined = CYCL CALL, M99 and M89 execute the machining cycle that was defined last. Without a definition there is nothing to execute. In programs with jumps, subprograms or skipped blocks this is only said if no cycle is defined at all, and never if other programs are called.
explain-choice-not-offered = The parameter offers a choice of values, each with a meaning of its own, and this is none of them. Example: Q215=3 in CYCL DEF 251.
explain-cycle-not-described = The control has the cycle, but no specification describes it here. Its parameters, labels and effect are passed over.
explain-cycle-not-on-control = The manuals of this control do not know the cycle, those of another one do. The program was written for that control, or the wrong control was chosen with --control.
explain-defined-but-never-called = The cycle acts when it is called with CYCL CALL, M99 or M89, or by a pattern, and nothing of that follows before the next such cycle or the end. The definition does nothing, or the call was forgotten.
explain-duplicate-parameter = The definition gives the same parameter or field two values; it cannot be said which one is meant.
explain-guard = The specifications state under which conditions a control refuses a cycle, skips it, warns or asks. Each such guard has a code of its own; it is only checked with values that the program writes as numbers or texts.
explain-label-missing = The program cannot be written wholly in this language: a text of the specifications is not translated yet. The old label stays. ciklo coverage lists what is missing.
explain-label-not-encodable = The program is not a UTF-8 file, and its encoding (Windows-1252) lacks a character of the new label. Convert the file to UTF-8 first if the control reads that.
explain-label-of-another-language = Most labels of the program are in one language, this one is in another. ciklo translate writes them all in one language.
explain-label-of-another-parameter = The comment behind the value is the label of another parameter of the same cycle. The control reads the number only, but the value may be meant for the other one. Labels that no language has are left alone.
explain-misordered-parameter = Controls know parameters by their numbers and accept another order, but the definition was hardly written by one. The first parameter out of order is reported.
explain-missing-parameter = The control's manual lists the parameter or field for the cycle, and the definition does not have it. Definitions with a line that cannot be read are passed over. Example: CYCL DEF 247 without Q339.
explain-out-of-range = The control's manual prints a range for the parameter, and the value lies outside. Ranges are those of this control only; where its manual prints none, nothing is checked. In programs in inches lengths and feeds are not checked. Example: Q202=-5.
explain-spindle-off = Nothing has turned the spindle on (M3, M4, M13, M14), or it was stopped since (M0, M5, M6). Behind a tool call and M functions of the machine builder nothing is said. Said once a program.
explain-tool-missing = Cycles need the tool axis, which TOOL CALL names: TOOL CALL 5 Z S2000. Said once a program.
explain-unknown-cycle = The number stands for no cycle in any manual that the specifications come from, and not for one of the machine builder (300 to 399, 500 to 599). Check keyword and number: CYCL DEF 32 and TCH PROBE 32 are different cycles. Example: CYCL DEF 299.
explain-unknown-parameter = The parameter or field is not among those that the control's manual lists for the cycle. It belongs to another cycle or another control, or its number is mistyped. Example: Q999 in CYCL DEF 247.
explain-wrong-value-kind = The value is of a kind that the parameter does not take: a text instead of a number, a fraction where a whole number is needed, a word that the manual does not list for it, or nothing. A Q parameter is always a good value. Example: Q201=FAUTO.
