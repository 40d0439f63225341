## Erros nas especificações. $expected e $found vêm do ficheiro ou designam um tipo de valor.

diag-spec-both-forms = O ciclo tem parâmetros e linhas do formato antigo; só pode ser escrito num dos formatos.
diag-spec-case-incomplete = O caso { $name } precisa de uma cena e de um resultado esperado, ou de um motivo para ser omitido.
diag-spec-case-never-reached = Este caso nunca é alcançado: um caso anterior aplica-se sempre que este se aplica.
diag-spec-case-proves-nothing = O caso { $name } não indica o que prova.
diag-spec-duplicate-choice = A opção { $value } aparece duas vezes.
diag-spec-duplicate-cycle = { $cycle } ({ $name }) está descrito duas vezes para um mesmo comando.
diag-spec-duplicate-key = A chave { $key } aparece duas vezes.
diag-spec-duplicate-name = O nome { $name } aparece duas vezes.
diag-spec-duplicate-parameter = { $q } aparece duas vezes no ciclo.
diag-spec-empty-range = O campo de introdução está vazio: { $min } não é menor do que { $max }.
diag-spec-example-out-of-range = O parâmetro { $name } não aceita o seu valor de exemplo { $value }.
diag-spec-expected = Esperado: { $expected ->
        [mapping] chaves com valores
        [list] uma lista
        [number] um número
        [whole-number] um número inteiro
        [text] um texto
        [true-or-false] true ou false
        [q-parameter] um parâmetro Q
        [axis] a letra de um eixo
        [action] uma ação
        [one-verb] exatamente um verbo
        [one-series] exatamente uma série
        [cell] file, row, column e value
        [column] at e is
        [pair] dois números
        [end-word] done, stopped, error, limit ou unsupported
       *[other] { $expected }
    }, encontrado: { $found }.
diag-spec-expression = Isto não é uma expressão: esperado: { $expected }, encontrado: «{ $found }».
diag-spec-foreign-manual = O manual { $manual } não pertence ao comando { $control }.
diag-spec-guard-keys = Uma verificação precisa de code, when e then, ou indica um fragmento com use.
diag-spec-id-form = O identificador { $name } não está em minúsculas separadas por hífenes.
diag-spec-lines-form = As linhas «{ $lines }» não são números ou intervalos por ordem crescente.
diag-spec-missing-key = Falta a chave { $key }.
diag-spec-no-example = { $name } não tem valor de exemplo.
diag-spec-no-parameters = O ciclo não tem parâmetros nem linhas do formato antigo.
diag-spec-no-source = Falta o lugar num manual para este comando.
diag-spec-no-steps = A execução não tem passos.
diag-spec-note-without-section = { $note } não tem secção em pages.yaml: acrescente-a à secção adequada.
diag-spec-only-and-except = Um elemento pode ter only ou except, não ambos.
diag-spec-otherwise-last = Um caso sem condições tem de ser o último.
diag-spec-range-of-text = { $name } não é um número e não pode ter campo de introdução.
diag-spec-result-target = O resultado { $name } precisa de um parâmetro Q ou de um campo deste ciclo.
diag-spec-run-item = O elemento da execução não está bem formado: { $reason ->
    [one-head] tem de ser exatamente um de step, group e each.
    [series-keys] in, until, between e collect pertencem a each.
    [series-body] each precisa de uma série em in e de elementos da execução em do.
    [step-body] um passo tem ações, não elementos da execução.
    [group-body] um grupo tem elementos e nada mais.
   *[step-keys] choose, then e by pertencem a um passo.
}
diag-spec-text-parameter = { $name }: um parâmetro QS aceita um texto, e só um parâmetro QS o aceita.
diag-spec-unknown-condition = Não existe a condição { $name }.
diag-spec-unknown-control = Não existe o comando { $control }; os comandos são { $known }.
diag-spec-unknown-cycle = O comando { $control } não tem { $cycle }.
diag-spec-unknown-cycle-name = Nenhum ciclo deste comando tem o nome { $name }.
diag-spec-unknown-datum = O comando { $control } não tem nenhum dado de máquina com o nome { $name }.
diag-spec-unknown-form = O ciclo não tem a forma { $name }.
diag-spec-unknown-fragment = Não existe o fragmento { $name }.
diag-spec-unknown-key = A chave { $key } não é possível aqui; as chaves possíveis são { $known }.
diag-spec-unknown-meaning = O dicionário não tem nenhum parâmetro com o nome { $name }.
diag-spec-unknown-option = O comando { $control } não tem a opção de software { $option }.
diag-spec-unknown-parameter = { $cycle } não tem o parâmetro { $name }.
diag-spec-unknown-topic = Não existe o tema { $topic }.
diag-spec-unused = { $name } não é utilizado.
diag-spec-word-shape = { $name }: a forma word precisa da chave word, que nenhuma outra forma pode ter.
diag-spec-yaml-feature = { $feature ->
    [anchor] As âncoras e as etiquetas não são utilizadas nas especificações.
    [alias] Os aliases não são utilizados nas especificações.
    [depth] O ficheiro tem demasiados níveis encadeados.
    [no-document] O ficheiro está vazio.
    [second-document] Um ficheiro contém um só documento.
   *[structured-key] Uma chave tem de ser uma palavra simples.
}
diag-spec-yaml-syntax = Isto não é YAML: { $reason }.
related-first-place = o primeiro está aqui
related-other-place = o outro está aqui
related-defined-here = está definido aqui
related-written-over-here = foi escrito por cima aqui
related-for-this-control = necessário para este comando
diag-spec-measure = Em { $cycle }, { $reason ->
        [different-quantities] somam-se ou comparam-se duas grandezas que não são do mesmo tipo
        [coordinates-added] somam-se duas coordenadas
        [distance-as-coordinate] está uma distância no lugar de uma coordenada
        [coordinate-as-distance] está uma coordenada no lugar de uma distância
        [not-a-feed] está no lugar de um avanço algo que não é um avanço
        [not-a-length] está no lugar de uma posição algo que não é um comprimento
        [not-a-time] está no lugar de um tempo algo que não é um tempo
        [not-a-speed] está no lugar das rotações do cabeçote algo que não são rotações
        [not-a-number] está no lugar de um número sem unidade uma grandeza com unidade
        [bare-number] compara-se um comprimento ou um avanço com um número sem unidade
        [same-operands] escolhe-se ou compara-se entre duas fórmulas iguais
        [never-negative] toma-se o sinal ou o módulo de um parâmetro que nunca é negativo
       *[not-an-angle] está no lugar de um ângulo algo que não é um ângulo
    }.
