diag-texts-nothing-chosen = Indicare che cosa approvare: --text KEY, --changed o --all.
diag-texts-unknown-key = Nessuna traduzione ha un testo con la chiave «{ $key }».
diag-locale-same-as-source = Il testo «{ $key }» nella lingua «{ $language }» è uguale a quello inglese.
