### Texts of the parser's findings. $found is what was read, $expected a key for what could be written there or a word of a program.

syntax-expected =
    { $expected ->
        [block] the beginning of a block
        [end] the end of the block
        [sign] a sign
        [word] a coordinate, R0, RL, RR, a feed or an M function
        [number] a number
        [m-function] an M function
        [blk-form-part] 0.1, 0.2, CYLINDER, ROTATION or FILE
        [tool-word] S, F, DL, DR or DR2, each only once
        [tool] a tool number or a tool name in quotation marks
        [value] a number or a Q parameter
        [quotation-mark] a closing quotation mark
        [unit] MM or INCH
        [label] a label number or a label name in quotation marks
        [call] LBL or PGM
        [name] a name
        [selection] TABLE, PATTERN, CONTOUR, PGM or CYCLE
        [cycle-word] CYCL DEF, CYCL CALL or TCH PROBE
        [cycle-number] the number of a cycle
        [text-parameter] a QS parameter
        [parameter] a Q parameter
        [relation] EQU, NE, GT or LT
        [relation-of-number] the comparison of this FN number
        [less-nesting] a shorter or less nested formula
        [field] a field of the cycle
        [operand] a number, a Q parameter or a function
        [operator] an arithmetic operator
        [closing-bracket] a closing bracket
        [known-function] a function of the formula language
        [character] a character of the formula language
        [arguments] a different number of arguments
        [in-spec-only] arithmetic only; a program cannot compare here
        [block-word] a word of this block
        [approach] LT, LN, CT, LCT, PLT, PLN, PCT or PLCT
        [plane-form] SPATIAL, PROJECTED, EULER, VECTOR, POINTS, RELATIV, AXIAL or RESET
        [function] the name of a function
        [transformation] DATUM, MIRROR, ROTATION or SCALE
        [pattern-item] POS, ROW, PAT, FRAME, CIRC or PITCHCIRC
        [contour-name] a contour such as QC1
        [contour-operator] &, |, ^ or \
       *[other] { $expected }
    }

diag-syntax-unknown-block = No block begins with “{ $found }”.
diag-syntax-unexpected = “{ $found }” is not allowed here; expected: { syntax-expected }.
diag-syntax-incomplete = The block is incomplete; expected: { syntax-expected }.
diag-syntax-unclosed-text = The text has no closing quotation mark: { $found }
diag-syntax-formula = “{ $found }” is not allowed in a formula here; expected: { syntax-expected }.
diag-syntax-text-after-tab = “{ $found }” follows a tab and does not belong to a block; a control would refuse it. Comments begin with a semicolon.
diag-syntax-dangling-continuation = The ~ says that the block continues, but no line that belongs to it follows.
diag-syntax-foreign-line = “{ $found }” is not a block of this language; a control would refuse it. Comments begin with a semicolon.
diag-syntax-spelling = Controls do not write “{ $found }” but: { syntax-expected }.
diag-syntax-undescribed = “{ $found }” is not described in any manual of this control family; it is not known whether a control accepts it.
diag-syntax-refused-block = A control could not read this block: { $found }
diag-syntax-excluding-codes = “{ $found }” and another code of this block exclude each other.
diag-syntax-bracket-comment = Text in brackets is not a comment on these controls: comments begin with a semicolon.
diag-syntax-doubled-continuation = There is a second ~; one is enough to continue the block on the next line.
