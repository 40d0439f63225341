# Units and lists; see the English file.

unit-mm = { $value }{"\u00A0"}mm
    .symbol = mm
unit-mm-min = { $value }{"\u00A0"}mm/min
    .symbol = mm/min
unit-mm-rev = { $value }{"\u00A0"}mm/giro
    .symbol = mm/giro
unit-rpm = { $value }{"\u00A0"}giri/min
    .symbol = giri/min
unit-inch = { $value }{"\u00A0"}pollici
    .symbol = pollici
unit-deg = { $value }°
    .symbol = °
unit-s = { $value }{"\u00A0"}s
    .symbol = s
unit-percent = { $value }%
    .symbol = %

list-and = { $first } e { $last }
    .more = { $first }, { $last }
list-or = { $first } o { $last }
    .more = { $first }, { $last }
