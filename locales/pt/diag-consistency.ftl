# Texts that do not agree with each other; see src/accord.

diag-consistency-negation = O texto { $key } no idioma { $language } não contém uma negação, ao contrário dos idiomas { $others }.
diag-consistency-number = O texto { $key } no idioma { $language } indica números diferentes dos dos idiomas { $others }: { $found } em vez de { $expected }.
diag-consistency-unit = O texto { $key } no idioma { $language } indica unidades diferentes das dos idiomas { $others }: { $found } em vez de { $expected }.
diag-consistency-variant = O texto { $key } no idioma { $language } serve também para { $variant }, para o qual o inglês tem uma variante com outros dados: { $found } em vez de { $expected }. Falta uma variante.
diag-consistency-code = O texto { $key } no idioma { $language } refere parâmetros, funções ou colunas diferentes dos dos idiomas { $others }: { $found } em vez de { $expected }.
diag-consistency-argument = O texto { $key } no idioma { $language } utiliza argumentos diferentes dos dos idiomas { $others }: { $found } em vez de { $expected }.
diag-consistency-label-twice = No idioma { $language }, os parâmetros «{ $parameter }» e «{ $other }» de um ciclo têm a mesma designação { $label }.
diag-consistency-label-of-another = No idioma { $language }, a designação { $label } do parâmetro «{ $parameter }» é a do parâmetro «{ $other }».
diag-consistency-swapped = No idioma { $language }, os textos { $key } e { $other } parecem ter sido trocados; compare com os idiomas { $others }.
diag-consistency-quantity = { $parameter } mede { $found }, mas o seu nome no idioma { $language } («{ $name }») sugere { $expected }.
diag-consistency-reference = { $parameter } é { $found }, mas o seu nome no idioma { $language } («{ $name }») fala do que é { $expected }.
related-said-here = o texto está aqui
diag-spec-odd-q = Em { $cycle }, { $q } é «{ $name }», que noutros ciclos é { $usual }; nesses ciclos, { $q } é «{ $other }».
diag-spec-odd-choice = A opção «{ $name }» tem aqui o valor { $value }, mas { $usual } noutros ciclos.
diag-spec-odd-limit = Nenhum outro parâmetro desta grandeza tem o limite { $value } de { $name }; a maioria tem { $usual }.
diag-spec-odd-condition = A condição «{ $name }» diz que { $q } é { $found }, mas a opção com esse nome tem o valor { $value }.
diag-spec-odd-formula = O ciclo { $cycle } calcula «{ $name }» a partir de { $q }, mas outros ciclos calculam-no a partir de { $usual }, que este ciclo também tem.
diag-spec-example-guarded = O exemplo impresso é recusado pela verificação «{ $code }».
diag-spec-unused-parameter = Nada no desenvolvimento, nas verificações ou nas frases de { $cycle } utiliza { $q }.
diag-spec-odd-result = { $reason ->
        [parameter] { $q } é um resultado e também um parâmetro de { $cycle }
       *[not-a-result] O desenvolvimento de { $cycle } define { $q }, que não é resultado nem parâmetro desse ciclo
    }.
diag-consistency-reference-word = O texto { $key } no idioma { $language } não diz absoluto ou incremental como os idiomas { $others }: { $found } em vez de { $expected }.
diag-locale-unused = Nenhuma especificação e nenhum texto utiliza o texto { $key }.
diag-spec-example-fails = O exemplo «{ $name }» no { $control } não tem o resultado esperado: { $what } devia ser { $expected }, mas é { $found }.
diag-consistency-term = Ao texto { $key } no idioma { $language } falta o termo «{ $term }» para «{ $source }».
diag-consistency-forbidden = O texto { $key } no idioma { $language } diz «{ $word }»; o termo é «{ $term }».
