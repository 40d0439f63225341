# Units and lists; see the English file.

unit-mm = { $value }{"\u00A0"}mm
    .symbol = mm
unit-mm-min = { $value }{"\u00A0"}mm/min
    .symbol = mm/min
unit-mm-rev = { $value }{"\u00A0"}mm/rot.
    .symbol = mm/rot.
unit-rpm = { $value }{"\u00A0"}rpm
    .symbol = rpm
unit-inch = { $value }{"\u00A0"}pol.
    .symbol = pol.
unit-deg = { $value }°
    .symbol = °
unit-s = { $value }{"\u00A0"}s
    .symbol = s
unit-percent = { $value }%
    .symbol = %

list-and = { $first } e { $last }
    .more = { $first }, { $last }
list-or = { $first } ou { $last }
    .more = { $first }, { $last }
