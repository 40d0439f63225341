# The command line: the command conform.
cli-conform-cycle = Only this cycle, such as 200 or "TCH PROBE 412"; may be repeated
cli-conform-case = Only the cases of this name; may be repeated
cli-conform-list = Only list the cases and what they prove
cli-conform-proves = proves: { $text }
cli-conform-why = why: { $text }
cli-conform-place = case: { $text }
cli-conform-manual = manual (file:lines): { $text }
cli-conform-lists = { $what }: { $expected } expected (left), { $found } found (right)
diag-conform-no-case = No case has been chosen: “ciklo conform --list” shows the cases that there are.
