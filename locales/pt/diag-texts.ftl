diag-texts-nothing-chosen = Indique o que deve ser aceite: --text KEY, --changed ou --all.
diag-texts-unknown-key = Nenhuma tradução tem um texto com a chave «{ $key }».
diag-locale-same-as-source = O texto «{ $key }» no idioma «{ $language }» é igual ao inglês.
diag-texts-no-file = «texts import» precisa do ficheiro a ler.
diag-texts-no-language = «{ $language }» não é um idioma para o qual se possa traduzir; indique-o com --to, por exemplo «--to fi».
diag-texts-file-unreadable = Não é possível ler o ficheiro: { $reason ->
        [document-type] não se aceitam declarações de tipo de documento nem entidades próprias
        [entity] contém uma entidade desconhecida
        [encoding] a codificação não é UTF-8
        [depth] os elementos estão encaixados a demasiada profundidade
        [columns] faltam à tabela as colunas concept e language
        [empty] o ficheiro está vazio
        [quote] aqui começa uma célula entre aspas que não termina
        [size] é maior do que 64 MB
        [xliff] não é XLIFF 1.2 nem XLIFF 2.0
       *[form] a forma está errada a partir daqui
    }.
diag-texts-unit-unknown = Nenhum texto corresponde à unidade «{ $key }».
diag-texts-unit-twice = A unidade «{ $key }» aparece várias vezes no ficheiro.
diag-texts-unit-source-changed = O texto de partida da unidade «{ $key }» não é o atual: exporte o texto de novo.
diag-texts-unit-not-read = A unidade «{ $key }» não tem tradução, ou tem uma com elementos desconhecidos.
diag-texts-unit-codes = Os códigos da unidade «{ $key }» não correspondem: em falta { $missing }, não permitidos { $foreign }.
diag-texts-unit-exchanged = Na unidade «{ $key }» os códigos trocaram de lugar entre as mesmas palavras.
diag-texts-unit-incomplete = A unidade «{ $key }» é uma das variantes de um texto novo; as outras faltam ou foram recusadas.
diag-texts-unit-refused = A unidade «{ $key }» foi recusada ({ $code }): { $finding }
diag-texts-unit-markup = A tradução da unidade «{ $key }» mudaria a forma da página: as suas marcas ou os blocos em redor.
diag-texts-unit-numbers = Os números da unidade «{ $key }» não são os do texto de partida: em falta { $missing }, alheios { $foreign }.
diag-texts-unknown-topic = Não existe a página de prosa «{ $topic }».
diag-draft-language = Um rascunho é de um só idioma: indique-o com --lang, por exemplo «--draft --lang de».
diag-texts-unit-swapped = As unidades «{ $key }» e «{ $other }» ficaram com as palavras uma da outra.
diag-texts-unit-negation = Na unidade «{ $key }» foi retirada uma palavra que nega; o texto diz o contrário.
