## Erros nas execuções dos ciclos.

diag-plan-argument = O argumento não está bem formado: { $expected ->
    [mapping] esperam-se argumentos com nome.
    [one-transform] espera-se exatamente uma conversão de coordenadas.
    [point-or-axes] espera-se um ponto ou pelo menos um de main, minor e tool.
    [add-or-value] espera-se add ou value, não ambos.
    [read-or-write] espera-se add ou value (escrita) ou as (leitura).
    [list-of-points] espera-se uma lista de pontos.
    [q-parameter] espera-se um parâmetro Q.
    [q-number-field] espera-se um campo que indique um parâmetro Q.
    [no-result] a estratégia não tem resultado a que dar nome.
    [type-word] espera-se number, truth, point ou text.
    [spindle-word] espera-se clockwise, counter-clockwise ou stop.
    [coolant-word] espera-se flood ou stop.
    [cancel-word] espera-se radius-compensation, datum-shift, mirroring, rotation, scaling ou axis-scaling.
   *[other] espera-se: { $expected }.
}
diag-plan-missing-argument = Falta o argumento { $name }.
diag-plan-modifier = O verbo { $verb } não aceita { $modifier }.
diag-plan-name-form = O nome { $name } só pode conter letras minúsculas, algarismos e _.
diag-plan-name-taken = O nome { $name } já está ocupado aqui.
diag-plan-recursive-fragment = O fragmento { $name } utiliza-se a si próprio.
diag-plan-too-many-fragments = O ciclo utiliza mais de { NUMBER($limit) } fragmentos, incluindo os que estão dentro de outros.
diag-plan-type = Esperado: { $expected }, encontrado: { $found }.
diag-plan-unknown-argument = Não existe o argumento { $name }; são possíveis { $known }.
diag-plan-unknown-field = O ciclo não tem o campo { $name }.
diag-plan-unknown-fragment = Não existe o fragmento { $name }.
diag-plan-unknown-name = O nome { $name } não está definido aqui.
diag-plan-unknown-series = Não existe a série { $name }; são possíveis { $known }.
diag-plan-unknown-strategy = Não existe a estratégia { $name }; nomes parecidos são { $near }.
diag-plan-unknown-table = Não existe a tabela { $name }; são possíveis { $known }.
