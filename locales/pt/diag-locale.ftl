# Observações sobre os ficheiros de idiomas.

diag-locale-encoding = Este ficheiro não está em UTF-8.
diag-locale-tag = O nome da pasta «{ $tag }» não é um código de idioma.
diag-locale-nesting = As chavetas ultrapassam { $most } níveis; o ficheiro não é lido.
diag-locale-long-number = Um número tem mais de { $most } algarismos seguidos; o ficheiro não é lido.
diag-locale-syntax =
    Isto não é Fluent: { $kind ->
        [expected-token] espera-se aqui «{ $detail }»
        [expected-character] espera-se aqui um dos caracteres { $detail }
        [empty-message] a mensagem «{ $detail }» não tem valor nem atributos
        [empty-term] o termo «-{ $detail }» não tem valor
        [bad-function-name] o nome de uma função tem maiúsculas, algarismos, «-» e «_»
        [no-default] uma seleção precisa de um caso predefinido, marcado com «*»
        [two-defaults] uma seleção tem só um caso predefinido
        [no-value] espera-se aqui um valor
        [bad-selector] seleciona-se por um argumento, uma função ou um atributo de um termo
        [term-attribute] o atributo de um termo não pode ser mostrado
        [open-string] a cadeia de texto não está fechada
        [argument-order] os argumentos sem nome vêm primeiro
        [argument-twice] o argumento «{ $detail }» é indicado duas vezes
        [bad-escape] «{ $detail }» não é uma sequência de escape
        [closing-brace] uma chaveta de fecho sem a de abertura
       *[no-expression] espera-se aqui uma expressão
    }.
diag-locale-isolation-mark = Está aqui uma marca de isolamento da direção; não pode chegar aos programas NC.
diag-locale-duplicate = «{ $key }» está definido duas vezes; conta também uma mensagem com o nome de um termo.
related-first-definition = primeira definição
diag-locale-variant = «{ $key }» não é um nome com dois sufixos no máximo, para o ciclo e o comando.
diag-locale-unit-form = «{ $key }» não é um modelo: uma unidade tem texto e um { "{ $value }" }, uma lista tem { "{ $first }" } e { "{ $last }" } no valor e no atributo «more».
diag-locale-unknown-reference = «{ $name }» não existe.
diag-locale-unknown-function = A função «{ $name }» não existe.
diag-locale-function-option = «{ $name }: { $value }» não é uma opção de { $function }.
diag-locale-function-arguments = { $function } tem um número errado de valores.
diag-locale-unknown-unit = A unidade «{ $name }» não existe: o ficheiro units.ftl não tem uma mensagem para ela.
diag-locale-term-argument = O termo «-{ $term }» não usa «{ $name }».
diag-locale-term-value = O termo «-{ $term }» não tem a forma «{ $value }» para «{ $name }».
diag-locale-term-needs = O termo «-{ $term }» precisa aqui de «{ $name }».
diag-locale-cyclic = «{ $key }» contém-se a si próprio.
diag-locale-unknown-language = Não há ficheiros para o idioma «{ $language }».
diag-locale-missing-text = O idioma «{ $language }» não tem o texto «{ $key }»{ $file ->
        [none] {""}.
       *[other] ; o seu lugar é em { $file }.
    }
diag-locale-missing-argument = O texto «{ $key }» ({ $language }) usa «{ $name }», que aqui não está disponível.
diag-locale-function-failed =
    No texto «{ $key }» ({ $language }) não se pode aplicar { $name }: { $reason ->
        [not-a-number] o valor não é um número
        [not-finite] o número não é finito
        [no-unit] falta a unidade
        [unknown-unit] a unidade é desconhecida
        [not-a-list] o valor não é uma lista
       *[unknown-type] o tipo de lista é desconhecido
    }.
diag-locale-too-long = O texto «{ $key }» ({ $language }) tem demasiados campos.
diag-locale-lock-line = Uma linha deste ficheiro tem um identificador e oito algarismos hexadecimais.
diag-locale-missing-translation = «{ $key }» não está traduzido para o idioma «{ $language }».
diag-locale-unfinished = Faltam { $count } textos no idioma «{ $language }». «ciklo texts status --lang { $language }» conta-os por ficheiro e indica os seguintes.
diag-locale-orphan = «{ $key }» ({ $language }) é um resto: o texto inglês já não existe.
diag-locale-stale =
    { $change ->
        [none] O texto inglês de «{ $key }» mudou depois da tradução para o idioma «{ $language }».
       *[other] O texto inglês de «{ $key }» mudou depois da tradução para o idioma «{ $language }»: { $change }.
    }
diag-locale-unrecorded = A tradução de «{ $key }» para o idioma «{ $language }» ainda não foi aceite.
diag-locale-moved = A tradução de «{ $key }» para o idioma «{ $language }» tem agora as palavras aceites para «{ $name }».
diag-locale-unknown-argument = «{ $key }» ({ $language }) usa o argumento «{ $name }», que o texto inglês não tem.
