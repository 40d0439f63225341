# Texts that do not agree with each other; see the English file.
diag-accord-number = Il testo { $key } nella lingua { $language } indica numeri diversi dalle lingue { $others }: { $found } invece di { $expected }.
diag-accord-unit = Il testo { $key } nella lingua { $language } indica unità diverse dalle lingue { $others }: { $found } invece di { $expected }.
diag-accord-code = Il testo { $key } nella lingua { $language } nomina parametri, funzioni o colonne diversi dalle lingue { $others }: { $found } invece di { $expected }.
diag-accord-argument = Il testo { $key } nella lingua { $language } richiede argomenti diversi dalle lingue { $others }: { $found } invece di { $expected }.
diag-accord-label-twice = Nella lingua { $language } i parametri «{ $parameter }» e «{ $other }» di un ciclo hanno la stessa etichetta { $label }.
diag-accord-label-of-another = Nella lingua { $language } l'etichetta { $label } del parametro «{ $parameter }» è quella del parametro «{ $other }».
diag-accord-swapped = Nella lingua { $language } i testi { $key } e { $other } sembrano scambiati; confrontarli con le lingue { $others }.
diag-accord-quantity = { $parameter } misura { $found }, ma il suo nome nella lingua { $language } («{ $name }») parla di { $expected }.
diag-accord-reference = { $parameter } è { $found }, ma il suo nome nella lingua { $language } («{ $name }») parla di ciò che è { $expected }.
related-said-here = il testo si trova qui
diag-spec-odd-q = { $cycle } chiama { $q } «{ $name }», che altrove è { $usual }; altrove { $q } è «{ $other }».
diag-spec-odd-choice = La scelta «{ $name }» ha qui il valore { $value } e altrove { $usual }.
diag-spec-odd-limit = Il limite { $value } di { $name } non è utilizzato in nessun altro punto per questa grandezza; si utilizza { $usual }.
diag-spec-odd-condition = La condizione «{ $name }» indica che { $q } è { $found }, ma la scelta con questo nome ha il valore { $value }.
diag-spec-example-guarded = L'esempio stampato viene rifiutato dalla verifica «{ $code }».
diag-spec-unused-parameter = Nulla nell'esecuzione, nelle verifiche o nelle frasi di { $cycle } utilizza { $q }.
