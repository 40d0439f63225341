# What can go wrong while a manual is built.

diag-manual-template = The template { $template } cannot be used (line { $line }): { $reason }.
diag-manual-json = The data cannot be written as JSON: { $reason }.
diag-manual-empty = There is no control or no language to build a manual for.
diag-manual-topic-missing = The topic { $topic } has no page in the language { $language }.
diag-manual-topic-title = The page of the topic { $topic } in the language { $language } does not begin with a title, a line such as "# Title".
