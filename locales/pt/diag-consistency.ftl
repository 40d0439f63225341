# Texts that do not agree with each other; see src/accord.

diag-consistency-number = O texto { $key } no idioma { $language } indica números diferentes dos dos idiomas { $others }: { $found } em vez de { $expected }.
diag-consistency-unit = O texto { $key } no idioma { $language } indica unidades diferentes das dos idiomas { $others }: { $found } em vez de { $expected }.
diag-consistency-code = O texto { $key } no idioma { $language } refere parâmetros, funções ou colunas diferentes dos dos idiomas { $others }: { $found } em vez de { $expected }.
diag-consistency-argument = O texto { $key } no idioma { $language } pede argumentos diferentes dos dos idiomas { $others }: { $found } em vez de { $expected }.
diag-consistency-label-twice = No idioma { $language }, os parâmetros «{ $parameter }» e «{ $other }» de um ciclo têm a mesma designação { $label }.
diag-consistency-label-of-another = No idioma { $language }, a designação { $label } do parâmetro «{ $parameter }» é a do parâmetro «{ $other }».
diag-consistency-swapped = No idioma { $language }, os textos { $key } e { $other } parecem ter trocado de lugar; compare com os idiomas { $others }.
diag-consistency-quantity = { $parameter } mede { $found }, mas o seu nome no idioma { $language } («{ $name }») fala de { $expected }.
diag-consistency-reference = { $parameter } é { $found }, mas o seu nome no idioma { $language } («{ $name }») fala do que é { $expected }.
related-said-here = o texto está aqui
diag-spec-odd-q = { $cycle } chama a { $q } «{ $name }», que noutros ciclos é { $usual }; noutros ciclos, { $q } é «{ $other }».
diag-spec-odd-choice = A opção «{ $name }» tem aqui o valor { $value } e { $usual } noutros casos.
diag-spec-odd-limit = O limite { $value } de { $name } não é utilizado em mais nenhum lado para esta grandeza; o habitual é { $usual }.
diag-spec-odd-condition = A condição «{ $name }» diz que { $q } é { $found }, mas a opção com esse nome tem o valor { $value }.
diag-spec-example-guarded = O exemplo impresso é recusado pela verificação «{ $code }».
diag-spec-unused-parameter = Nada no desenvolvimento, nas verificações ou nas frases de { $cycle } utiliza { $q }.
diag-consistency-reference-word = O texto { $key } no idioma { $language } não diz absoluto ou incremental como os idiomas { $others }: { $found } em vez de { $expected }.
diag-locale-unused = Nenhuma especificação e nenhum texto utiliza o texto { $key }.
diag-spec-example-fails = O exemplo «{ $name }» no { $control } não dá o que indica: { $what } deveria ser { $expected } e é { $found }.
diag-consistency-term = Ao texto { $key } no idioma { $language } falta o termo «{ $term }» para «{ $source }».
diag-consistency-forbidden = O texto { $key } no idioma { $language } diz «{ $word }»; o termo é «{ $term }».
