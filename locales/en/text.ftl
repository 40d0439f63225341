# Texts that follow from the specifications by a pattern: dialog questions, repetitions, ranges.

# The question of a dialog, where the manual prints none of its own. $name: the name of the parameter.
prompt-from-name = { $name }?

# A numbered sentence of a run. $from, $to: numbers of steps. $until: a clause from until-….
repeat-steps = Steps { $from } to { $to } are repeated until { $until }.
repeat-step = Step { $from } is repeated until { $until }.

# Ranges of entry; the unit stands with the last number.
range-both = { $min } to { $max }
range-from = from { $min }
range-to = up to { $max }
range-length = at most { $length } characters
