# Texts that do not agree with each other; see the English file.
diag-consistency-negation = Il testo { $key } nella lingua { $language } non contiene una negazione, a differenza delle lingue { $others }.
diag-consistency-number = Il testo { $key } nella lingua { $language } indica numeri diversi dalle lingue { $others }: { $found } invece di { $expected }.
diag-consistency-unit = Il testo { $key } nella lingua { $language } indica unità diverse dalle lingue { $others }: { $found } invece di { $expected }.
diag-consistency-variant = Il testo { $key } nella lingua { $language } vale anche per { $variant }, per cui l’inglese ha una variante con altri dati: { $found } invece di { $expected }. Manca una variante.
diag-consistency-code = Il testo { $key } nella lingua { $language } nomina parametri, funzioni o colonne diversi dalle lingue { $others }: { $found } invece di { $expected }.
diag-consistency-argument = Il testo { $key } nella lingua { $language } usa argomenti diversi dalle lingue { $others }: { $found } invece di { $expected }.
diag-consistency-label-twice = Nella lingua { $language } i parametri «{ $parameter }» e «{ $other }» di un ciclo hanno la stessa etichetta { $label }.
diag-consistency-label-of-another = Nella lingua { $language } l’etichetta { $label } del parametro «{ $parameter }» è quella del parametro «{ $other }».
diag-consistency-swapped = Nella lingua { $language } i testi { $key } e { $other } sembrano scambiati; confrontarli con le lingue { $others }.
diag-consistency-quantity = { $parameter } misura { $found }, ma il suo nome nella lingua { $language } («{ $name }») fa pensare a { $expected }.
diag-consistency-reference = { $parameter } è { $found }, ma il suo nome nella lingua { $language } («{ $name }») parla di ciò che è { $expected }.
related-said-here = il testo si trova qui
diag-spec-odd-q = In { $cycle } { $q } è «{ $name }», che in altri cicli è { $usual }; lì { $q } è «{ $other }».
diag-spec-odd-choice = La scelta «{ $name }» ha qui il valore { $value }, ma in altri cicli { $usual }.
diag-spec-odd-limit = Nessun altro parametro di questa grandezza ha il limite { $value } di { $name }; i più hanno { $usual }.
diag-spec-odd-condition = La condizione «{ $name }» indica che { $q } è { $found }, ma la scelta con questo nome ha il valore { $value }.
diag-spec-odd-formula = Il ciclo { $cycle } calcola «{ $name }» da { $q }, ma altri cicli lo calcolano da { $usual }, che anche questo ciclo possiede.
diag-spec-example-guarded = L’esempio stampato viene rifiutato dalla verifica «{ $code }».
diag-spec-unused-parameter = Nulla nell’esecuzione, nelle verifiche o nelle frasi di { $cycle } utilizza { $q }.
diag-spec-odd-result = { $reason ->
        [parameter] { $q } è un risultato e anche un parametro di { $cycle }
       *[not-a-result] L’esecuzione di { $cycle } imposta { $q }, che non ne è né un risultato né un parametro
    }.
diag-consistency-reference-word = Il testo { $key } nella lingua { $language } non indica assoluto o incrementale come le lingue { $others }: { $found } invece di { $expected }.
diag-locale-unused = Nessuna specifica e nessun testo utilizza il testo { $key }.
diag-spec-example-fails = L’esempio «{ $name }» su { $control } non dà il risultato atteso: { $what } dovrebbe essere { $expected }, ma è { $found }.
diag-consistency-term = Nel testo { $key } nella lingua { $language } manca il termine «{ $term }» per «{ $source }».
diag-consistency-forbidden = Il testo { $key } nella lingua { $language } utilizza «{ $word }»; il termine è «{ $term }».
