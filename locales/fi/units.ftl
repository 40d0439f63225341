# Units and lists; see the English file.

unit-mm = { $value }{"\u00A0"}mm
    .symbol = mm
unit-mm-min = { $value }{"\u00A0"}mm/min
    .symbol = mm/min
unit-mm-rev = { $value }{"\u00A0"}mm/kierros
    .symbol = mm/kierros
unit-rpm = { $value }{"\u00A0"}1/min
    .symbol = 1/min
unit-inch = { $value }{"\u00A0"}in
    .symbol = in
unit-deg = { $value }°
    .symbol = °
unit-s = { $value }{"\u00A0"}s
    .symbol = s
unit-percent = { $value }{"\u00A0"}%
    .symbol = %

list-and = { $first } ja { $last }
    .more = { $first }, { $last }
list-or = { $first } tai { $last }
    .more = { $first }, { $last }
