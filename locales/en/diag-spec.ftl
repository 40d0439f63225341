## Mistakes in specifications. $expected and $found come from the file or name a kind of value.

diag-spec-both-forms = The cycle has parameters and old-style lines; it can be written in one form only.
diag-spec-case-incomplete = The case { $name } needs a scene and an expectation, or a reason to skip it.
diag-spec-case-never-reached = This case is never reached: an earlier case applies whenever this one does.
diag-spec-case-proves-nothing = The case { $name } does not state what it proves.
diag-spec-duplicate-choice = The choice { $value } occurs twice.
diag-spec-duplicate-cycle = { $cycle } ({ $name }) is described twice for one control.
diag-spec-duplicate-key = The key { $key } occurs twice.
diag-spec-duplicate-name = The name { $name } occurs twice.
diag-spec-duplicate-parameter = { $q } occurs twice in the cycle.
diag-spec-empty-range = The range is empty: { $min } is not less than { $max }.
diag-spec-example-out-of-range = The parameter { $name } does not accept its example value { $value }.
diag-spec-expected = Expected { $expected ->
        [mapping] keys with values
        [list] a list
        [number] a number
        [whole-number] a whole number
        [text] a text
        [true-or-false] true or false
        [q-parameter] a Q parameter
        [axis] the letter of an axis
        [action] an action
        [one-verb] exactly one verb
        [one-series] exactly one series
        [cell] file, row, column and value
        [column] at and is
        [pair] two numbers
        [end-word] done, stopped, error, limit or unsupported
       *[other] { $expected }
    }, found { $found }.
diag-spec-expression = Not an expression: expected { $expected }, found "{ $found }".
diag-spec-foreign-manual = Manual { $manual } does not belong to { $control }.
diag-spec-guard-keys = A guard needs code, when and then, or names a fragment with use.
diag-spec-id-form = The id { $name } is not in kebab case.
diag-spec-lines-form = The lines "{ $lines }" are not numbers or ranges in order.
diag-spec-missing-key = The key { $key } is missing.
diag-spec-no-example = { $name } has no example value.
diag-spec-no-parameters = The cycle has neither parameters nor old-style lines.
diag-spec-no-source = The place in a manual is missing for this control.
diag-spec-no-steps = The run has no steps.
diag-spec-note-without-section = { $note } has no section in pages.yaml: add it to the section that fits.
diag-spec-only-and-except = An item may have only or except, not both.
diag-spec-otherwise-last = A case without conditions must be the last one.
diag-spec-range-of-text = { $name } is not a number and can have no range.
diag-spec-result-target = The result { $name } needs either a Q parameter or a field of this cycle.
diag-spec-run-item = The run item is not well formed: { $reason ->
    [one-head] it must be exactly one of step, group and each.
    [series-keys] in, until, between and collect belong to each.
    [series-body] each needs a series under in and run items under do.
    [step-body] a step has actions, not run items.
    [group-body] a group has items and nothing else.
   *[step-keys] choose, then and by belong to a step.
}
diag-spec-text-parameter = { $name }: a QS parameter takes a text, and only a QS parameter does.
diag-spec-unknown-condition = No condition is named { $name }.
diag-spec-unknown-control = No control is named { $control }; the controls are { $known }.
diag-spec-unknown-cycle = { $control } does not have { $cycle }.
diag-spec-unknown-cycle-name = No cycle of this control is named { $name }.
diag-spec-unknown-datum = { $control } has no machine datum named { $name }.
diag-spec-unknown-form = The cycle has no form named { $name }.
diag-spec-unknown-fragment = No fragment is named { $name }.
diag-spec-unknown-key = The key { $key } is not possible here; possible keys are { $known }.
diag-spec-unknown-meaning = The dictionary has no parameter named { $name }.
diag-spec-unknown-option = { $control } has no software option { $option }.
diag-spec-unknown-parameter = { $cycle } has no parameter { $name }.
diag-spec-unknown-topic = There is no topic { $topic }.
diag-spec-unused = { $name } is not used.
diag-spec-word-shape = { $name }: the shape word needs the key word, which no other shape may have.
diag-spec-yaml-feature = { $feature ->
    [anchor] Anchors and tags are not used in specifications.
    [alias] Aliases are not used in specifications.
    [depth] The file is nested too deeply.
    [no-document] The file is empty.
    [second-document] A file holds one document.
   *[structured-key] A key must be a plain word.
}
diag-spec-yaml-syntax = Not YAML: { $reason }.
related-first-place = the first one is here
related-other-place = the other one is here
related-defined-here = it is defined here
related-written-over-here = overwritten here
related-for-this-control = needed for this control
diag-spec-measure = In { $cycle } { $reason ->
        [different-quantities] two quantities are added or compared that are not of the same kind
        [coordinates-added] two coordinates are added
        [distance-as-coordinate] a distance is given where a coordinate belongs
        [coordinate-as-distance] a coordinate is given where a distance belongs
        [not-a-feed] a value that is no feed is given as a feed
        [not-a-length] a value that is no length is given as a position
        [not-a-time] a value that is no time is given as a time
        [not-a-speed] a value that is no spindle speed is given as one
        [not-a-number] a value with a unit is given where a number without unit belongs
        [bare-number] a length or feed is compared with a number that has no unit
        [same-operands] a choice or comparison is between two formulas that are the same
        [never-negative] the sign or magnitude of a parameter that is never negative is taken
       *[not-an-angle] a value that is no angle is given as an angle
    }.
