# Ocorrências em cenas, máquinas, tabelas e sólidos.

diag-scene-expected =
    { $expected ->
        [mapping] Aqui devem estar chaves com valores e não «{ $found }».
        [list] Aqui deve estar uma lista e não «{ $found }».
        [number] Aqui deve estar um número e não «{ $found }».
        [text] Aqui deve estar um texto e não «{ $found }».
        [axis] Aqui deve estar a letra de um eixo (X, Y ou Z) e não «{ $found }».
        [two-numbers] Aqui devem estar dois números e não «{ $found }».
        [three-numbers] Aqui devem estar três números e não «{ $found }».
        [row-number] Aqui deve estar o número de uma linha da tabela e não «{ $found }».
        [unit] A unidade de medida é mm ou inch e não «{ $found }».
        [clock] Aqui devem estar a data e a hora, por exemplo 2015-07-03T14:05:00, e não «{ $found }».
        [datum-file] O nome de uma tabela de pontos zero termina em .D.
        [rotary-axis] Aqui deve estar a letra de um eixo rotativo (A, B ou C), e não «{ $found }».
        [carried] Um eixo rotativo leva a peça (workpiece) ou a ferramenta (tool), e não «{ $found }».
        [orientation] A orientação é fixed, two ou any, e não «{ $found }».
        [shaft] A haste de apalpação deve ser mais fina do que a esfera; o seu diâmetro é { $found }.
        [measurements] São possíveis 1, 2 ou 3 medições, e não «{ $found }».
       *[solids] Aqui deve estar pelo menos um sólido.
    }
diag-scene-unknown-key = A chave { $key } não tem significado aqui; chaves conhecidas: { $known }.
diag-scene-missing-key = Falta a chave { $key }.
diag-scene-not-positive = O valor deve ser maior do que zero e não { $found }.
diag-scene-version = Esta versão do formato do ficheiro não é conhecida; versão conhecida: { $known }.
diag-scene-repeated = { $found } está indicado duas vezes.
diag-scene-min-max = Cada valor mínimo deve ser menor do que o respetivo máximo.
diag-scene-no-length = O comprimento é zero.
diag-scene-one-solid = Aqui deve estar exatamente um sólido: { $known }.
diag-scene-unknown-machine = Não existe nenhuma máquina com o nome { $name }; máquinas conhecidas: { $known }.
diag-scene-no-axis = A máquina não tem um eixo { $axis }.
diag-scene-start-outside = O ponto de partida está fora da margem de deslocação do eixo { $axis }: { $found } { $unit } não está entre { $min } e { $max } { $unit }.

diag-solid-not-finite = Uma medida não é um número finito e positivo.
diag-solid-too-many = A forma tem demasiadas superfícies: levaria demasiado tempo a encontrar as suas arestas. Omita aquilo de que nenhuma ferramenta ou apalpador se aproxima.
diag-solid-edge-unsupported = A esfera de apalpação pode tocar numa aresta que não é uma reta nem um círculo; este contacto não pode ser calculado com exatidão.
diag-solid-cusp = A esfera de apalpação pode tocar num ponto em que as superfícies são tangentes e não deixam espessura; este contacto não pode ser calculado com exatidão.
diag-solid-helix-unsupported = A esfera de apalpação pode tocar na peça durante um movimento helicoidal ou enquanto se movem vários eixos; este contacto não pode ser calculado com exatidão.

diag-table-no-header = A tabela deve começar por uma linha com "BEGIN", o nome de um ficheiro { $extension } e a unidade de medida.
diag-table-no-heading = A segunda linha deve conter os nomes das colunas, entre eles { $column }.
diag-table-no-end = Falta a linha [END].
diag-table-not-described = Nenhum manual descreve tabelas deste tipo: só se verifica a moldura.
diag-table-no-row-number = A linha não tem número: «{ $found }».
diag-table-duplicate-row = A linha { $row } aparece duas vezes.
diag-table-bad-number = { $file }, linha { $row }, coluna { $column }: «{ $found }» não é um número.
diag-table-missing = A tabela { $file } não existe.
diag-table-no-row = A tabela { $file } não tem a linha { $row }.
diag-table-no-column = A tabela { $file } não tem a coluna { $column }.
diag-table-too-wide = { $file }, linha { $row }: o valor não cabe na coluna { $column }.
diag-table-text-in-numbers = { $file }, linha { $row }: a coluna { $column } só aceita números.
diag-table-key-column = { $file }, linha { $row }: o número da linha na coluna { $column } não pode ser alterado.
diag-table-duplicate-column = A coluna { $column } aparece duas vezes.
diag-table-unknown-column =
    { $count ->
        [one] Nenhum manual descreve a coluna { $column }: as suas células não são verificadas.
       *[other] Nenhum manual descreve as colunas { $column }: as suas células não são verificadas.
    }
diag-table-doubtful =
    { $what ->
        [unit] A primeira linha não indica a unidade de medida MM ou INCH.
        [kind] A primeira linha nomeia um ficheiro { $found }, mas este é um ficheiro { $column }.
        [column] Falta a coluna { $column }.
        [order] A linha { $row } está depois da linha { $found }.
        [after-end] O que está depois de [END] não é lido.
        [astride] Linha { $row }: o número da coluna { $column } entra na coluna { $found }.
        [empty] Linha { $row }: a coluna { $column } está vazia.
        [corner] Linha { $row }: R2 é maior do que R.
        [same] A linha { $row } é o mesmo ponto que a linha { $found }.
        [zero] A ferramenta 0 significa nenhuma ferramenta; o seu { $column } é 0.
        [less] Na linha { $row }, { $column } é menor do que { $found }.
       *[value] Linha { $row }: «{ $found }» dificilmente é o pretendido na coluna { $column }.
    }
diag-table-value-not-allowed = Linha { $row }: a coluna { $column } não aceita «{ $found }».
diag-stock-blank = Os cantos de BLK FORM têm de ser números e cada mínimo tem de ser inferior ao seu máximo.
diag-stock-extent = O bloco é demasiado grande: estende-se a mais de { $limit } mm do seu ponto zero.
diag-stock-form = BLK FORM { $word } não está descrito nos manuais: indique o bloco na cena, ou um paralelepípedo com BLK FORM 0.1 e 0.2.
diag-stock-missing = Não há bloco: nem a cena o contém, nem o programa tem um BLK FORM.
diag-stock-resolution = { $found } não pode ser a distância entre as colunas do bloco: tem de ser superior a zero e pode haver, no máximo, 10 milhões de colunas.
diag-stock-resolution-mesh = A peça tem mais triângulos do que cabem num ficheiro STL; uma distância maior entre as colunas ajuda.
