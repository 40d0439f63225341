# Texts that follow from the specifications by a pattern: dialog questions, repetitions, ranges.

# The question of a dialog, where the manual prints none of its own. $name: the name of the parameter.
prompt-from-name = { $name }?

# A numbered sentence of a run. $from, $to: numbers of steps. $until: a clause from until-….
repeat-steps = Steps { $from } to { $to } are repeated until { $until }.
repeat-two-steps = Steps { $from } and { $to } are repeated until { $until }.
repeat-step = Step { $from } is repeated until { $until }.

# Ranges of entry; the unit stands with the last number.
range-both = { $min } to { $max }
range-from = from { $min }
range-to = up to { $max }
range-length = at most { $length } characters

# Captions of a field in dialogs and manuals. caption-effective stands before a phrase from condition-….
caption-reference = Reference
reference-absolute = absolute
reference-incremental = incremental
caption-range = Range
caption-unit = Unit
caption-words = Or
caption-effective = Only if
caption-example = Example
optional-field = May be left out.
