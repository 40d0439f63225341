diag-texts-nothing-chosen = Indique o que deve ser aceite: --text KEY, --changed ou --all.
diag-texts-unknown-key = Nenhuma tradução tem um texto com a chave «{ $key }».
diag-locale-same-as-source = O texto «{ $key }» no idioma «{ $language }» é igual ao inglês.
