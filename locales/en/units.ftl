# Units and lists. A message `unit-NAME` is a template for UNIT($x, "NAME") with { $value } in it; its
# attribute `symbol` stands in column heads. A message `list-TYPE` is a template for LIST($items,
# type: "TYPE"): the value joins the last two, `more` those before.

unit-mm = { $value }{"\u00A0"}mm
    .symbol = mm
unit-mm-min = { $value }{"\u00A0"}mm/min
    .symbol = mm/min
unit-mm-rev = { $value }{"\u00A0"}mm/rev
    .symbol = mm/rev
unit-rpm = { $value }{"\u00A0"}rpm
    .symbol = rpm
unit-inch = { $value }{"\u00A0"}in
    .symbol = in
unit-deg = { $value }°
    .symbol = °
unit-s = { $value }{"\u00A0"}s
    .symbol = s
unit-percent = { $value }%
    .symbol = %

list-and = { $first } and { $last }
    .more = { $first }, { $last }
list-or = { $first } or { $last }
    .more = { $first }, { $last }
