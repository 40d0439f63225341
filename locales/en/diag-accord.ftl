# Texts that do not agree with each other; see src/accord.
diag-accord-number = The text { $key } in the language { $language } states other numbers than the languages { $others }: { $found } instead of { $expected }.
diag-accord-unit = The text { $key } in the language { $language } states other units than the languages { $others }: { $found } instead of { $expected }.
diag-accord-code = The text { $key } in the language { $language } names other parameters, functions or columns than the languages { $others }: { $found } instead of { $expected }.
diag-accord-argument = The text { $key } in the language { $language } asks for other arguments than the languages { $others }: { $found } instead of { $expected }.
diag-accord-label-twice = In the language { $language } the parameters "{ $parameter }" and "{ $other }" of a cycle have the same label { $label }.
diag-accord-label-of-another = In the language { $language } the label { $label } of the parameter "{ $parameter }" is that of the parameter "{ $other }".
diag-accord-swapped = In the language { $language } the texts { $key } and { $other } seem to have changed places; compare with the languages { $others }.
diag-accord-quantity = { $parameter } measures { $found }, but its name in the language { $language } ("{ $name }") speaks of { $expected }.
diag-accord-reference = { $parameter } is { $found }, but its name in the language { $language } ("{ $name }") speaks of what is { $expected }.
related-said-here = the text is here
diag-spec-odd-q = { $cycle } calls { $q } "{ $name }", which elsewhere is { $usual }; elsewhere { $q } is "{ $other }".
diag-spec-odd-choice = The choice "{ $name }" has the value { $value } here and { $usual } elsewhere.
diag-spec-odd-limit = The limit { $value } of { $name } is used nowhere else for this quantity; { $usual } is.
diag-spec-odd-condition = The condition "{ $name }" says that { $q } is { $found }, but the choice of that name has the value { $value }.
diag-spec-example-guarded = The printed example is refused by the check "{ $code }".
diag-spec-unused-parameter = Nothing in the run, the checks or the sentences of { $cycle } uses { $q }.
