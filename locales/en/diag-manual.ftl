# What can go wrong while a manual is built.

diag-manual-template = The template { $template } cannot be used (line { $line }): { $reason }.
diag-manual-json = The data cannot be written as JSON: { $reason }.
diag-manual-empty = There is no control or no language to build a manual for.
