# Texts that do not agree with each other; see src/language/consistency.
diag-consistency-negation = The text { $key } in the language { $language } denies nothing, unlike the same text in the languages { $others }.
diag-consistency-number = The text { $key } in the language { $language } states other numbers than the languages { $others }: { $found } instead of { $expected }.
diag-consistency-unit = The text { $key } in the language { $language } states other units than the languages { $others }: { $found } instead of { $expected }.
diag-consistency-variant = The text { $key } in the language { $language } also serves for { $variant }, where English has a variant with other facts: { $expected } instead of { $found }. A variant is missing.
diag-consistency-code = The text { $key } in the language { $language } names other parameters, functions or columns than the languages { $others }: { $found } instead of { $expected }.
diag-consistency-argument = The text { $key } in the language { $language } uses other arguments than the languages { $others }: { $found } instead of { $expected }.
diag-consistency-label-twice = In the language { $language } the parameters "{ $parameter }" and "{ $other }" of a cycle have the same label { $label }.
diag-consistency-label-of-another = In the language { $language } the label { $label } of the parameter "{ $parameter }" is that of the parameter "{ $other }".
diag-consistency-swapped = In the language { $language } the texts { $key } and { $other } seem to have been exchanged; compare with the languages { $others }.
diag-consistency-quantity = { $parameter } measures { $found }, but its name in the language { $language } ("{ $name }") suggests { $expected }.
diag-consistency-reference = { $parameter } is { $found }, but its name in the language { $language } ("{ $name }") speaks of what is { $expected }.
related-said-here = the text is here
diag-spec-odd-q = In { $cycle }, { $q } is "{ $name }", which is { $usual } in other cycles; there { $q } is "{ $other }".
diag-spec-odd-choice = The choice "{ $name }" has the value { $value } here, but { $usual } in other cycles.
diag-spec-odd-limit = No other parameter of this quantity has the limit { $value } of { $name }; most have { $usual }.
diag-spec-odd-condition = The condition "{ $name }" says that { $q } is { $found }, but the choice of that name has the value { $value }.
diag-spec-odd-formula = The cycle { $cycle } calculates “{ $name }” from { $q }, but other cycles calculate it from { $usual }, which this one has as well.
diag-spec-example-guarded = The printed example is refused by the check "{ $code }".
diag-spec-unused-parameter = Nothing in the run, the checks or the sentences of { $cycle } uses { $q }.
diag-spec-odd-result = { $reason ->
        [parameter] { $q } is a result and a parameter of { $cycle }
       *[not-a-result] The run of { $cycle } sets { $q }, which is neither a result nor a parameter of it
    }.
diag-consistency-reference-word = The text { $key } in the language { $language } does not say absolute or incremental as the languages { $others } do: { $found } instead of { $expected }.
diag-locale-unused = No specification and no text uses the text { $key }.
diag-spec-example-fails = The example "{ $name }" on { $control } does not have the expected result: { $what } should be { $expected }, but is { $found }.
diag-consistency-term = The text { $key } in the language { $language } lacks the term "{ $term }" for "{ $source }".
diag-consistency-forbidden = The text { $key } in the language { $language } says "{ $word }"; the term is "{ $term }".
