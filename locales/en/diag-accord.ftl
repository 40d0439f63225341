# Texts that do not agree with each other; see src/accord.
diag-accord-number = The text { $key } in the language { $language } states other numbers than the languages { $others }: { $found } instead of { $expected }.
diag-accord-unit = The text { $key } in the language { $language } states other units than the languages { $others }: { $found } instead of { $expected }.
diag-accord-code = The text { $key } in the language { $language } names other parameters, functions or columns than the languages { $others }: { $found } instead of { $expected }.
diag-accord-argument = The text { $key } in the language { $language } asks for other arguments than the languages { $others }: { $found } instead of { $expected }.
diag-accord-label-twice = In the language { $language } the parameters "{ $parameter }" and "{ $other }" of a cycle have the same label { $label }.
diag-accord-label-of-another = In the language { $language } the label { $label } of the parameter "{ $parameter }" is that of the parameter "{ $other }".
diag-accord-swapped = In the language { $language } the texts { $key } and { $other } seem to have changed places; compare with the languages { $others }.
