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
cli-lint-only = Only what concerns this cycle, without the pages and the comparison of the languages; may be repeated
cli-lint-summary = Count the findings of each file and show the next twenty
cli-lint-narrow = Pages and the comparison of the languages were left out (--only).
cli-lint-file = { $path }: errors { $errors }, others { $others }
