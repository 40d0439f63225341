# Values that a block cannot have, and labels that a control cannot print.

diag-block-unknown-form = { $cycle } has no form “{ $form }”. It has: { $forms }.
diag-block-unknown-parameter = { $cycle } has no parameter “{ $name }”. It has: { $known }.
diag-block-duplicate-parameter = { $name } is given twice.
diag-block-wrong-kind =
    { $name } ({ $parameter }) cannot be “{ $value }”: it takes { $kind ->
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
    }.
diag-block-below-minimum = { $name } ({ $parameter }) cannot be { $value }: the least value is { $min }.
diag-block-above-maximum = { $name } ({ $parameter }) cannot be { $value }: the greatest value is { $max }.
diag-block-too-long =
    { $kind ->
        [label-list] { $name } ({ $parameter }) cannot be { $value }: at most { $most } labels are permitted.
        [axes] { $name } ({ $parameter }) cannot be { $value }: at most { $most } axes are permitted.
       *[text] { $name } ({ $parameter }) cannot be { $value }: at most { $most } characters are permitted.
    }
diag-block-not-offered = { $name } ({ $parameter }) cannot be { $value }: the choices are { $offered }.
diag-block-no-value = { $cycle } needs a value for { $name }; the manual prints no example.
diag-label-character = The label “{ $label }” of { $cycle } ({ $control }, { $language }) contains the character “{ $character }”, which the control cannot show.
diag-label-lower-case = The label “{ $label }” of { $cycle } ({ $control }, { $language }) contains lower-case letters.
diag-label-too-long = The label “{ $label }” of { $cycle } ({ $control }, { $language }) has { $length } characters; the control shows { $most }.
diag-prompt-too-long = The prompt “{ $label }” of { $cycle } ({ $control }, { $language }) has { $length } characters; the control shows { $most }.
