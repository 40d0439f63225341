# Texts that do not agree with each other; see the English file.
diag-accord-number = Il testo { $key } nella lingua { $language } indica numeri diversi dalle lingue { $others }: { $found } invece di { $expected }.
diag-accord-unit = Il testo { $key } nella lingua { $language } indica unità diverse dalle lingue { $others }: { $found } invece di { $expected }.
diag-accord-code = Il testo { $key } nella lingua { $language } nomina parametri, funzioni o colonne diversi dalle lingue { $others }: { $found } invece di { $expected }.
diag-accord-argument = Il testo { $key } nella lingua { $language } richiede argomenti diversi dalle lingue { $others }: { $found } invece di { $expected }.
diag-accord-label-twice = Nella lingua { $language } i parametri «{ $parameter }» e «{ $other }» di un ciclo hanno la stessa etichetta { $label }.
diag-accord-label-of-another = Nella lingua { $language } l'etichetta { $label } del parametro «{ $parameter }» è quella del parametro «{ $other }».
diag-accord-swapped = Nella lingua { $language } i testi { $key } e { $other } sembrano scambiati; confrontarli con le lingue { $others }.
