# DIN/ISO: converting programs, and what has no equivalent.

cli-convert-to-iso = From Klartext to DIN/ISO
cli-convert-to-klartext = From DIN/ISO to Klartext
cli-convert-control = Control whose names and labels are written (default: the one that the cycles of the program belong to)
cli-convert-lang = Language of the names and labels (default: that of the program’s own texts)

diag-iso-no-equivalent = DIN/ISO has no equivalent of “{ $found }”; the block becomes a comment.
diag-iso-no-code = No manual prints a DIN/ISO code of { $found }; the block becomes a comment.
diag-klartext-no-equivalent = Klartext has no equivalent of “{ $found }”; the block becomes a comment.
diag-iso-unknown-code = No manual prints a cycle or a function with the code { $found }.
diag-iso-word-not-allowed = { $found } is not permitted in this block.
diag-iso-no-direction = { $found }: G05 continues in the direction of the previous arc, but there is none.
diag-iso-mode-left-on = { $found } of the block before does not act here: a subprogram or a repeat has changed it.
