# Ocorrências em cenas, máquinas, tabelas e sólidos.

diag-scene-expected =
    { $expected ->
        [mapping] Esperam-se chaves com valores, encontrou-se «{ $found }».
        [list] Espera-se uma lista, encontrou-se «{ $found }».
        [number] Espera-se um número, encontrou-se «{ $found }».
        [text] Espera-se um texto, encontrou-se «{ $found }».
        [axis] Espera-se a letra de um eixo (X, Y ou Z), encontrou-se «{ $found }».
        [two-numbers] Esperam-se dois números, encontrou-se «{ $found }».
        [three-numbers] Esperam-se três números, encontrou-se «{ $found }».
        [row-number] Espera-se o número de uma linha da tabela, encontrou-se «{ $found }».
        [unit] A unidade de medida tem de ser mm ou inch, não «{ $found }».
        [clock] Esperam-se uma data e uma hora como 2015-07-03T14:05:00, encontrou-se «{ $found }».
        [datum-file] O nome de uma tabela de pontos zero tem de terminar em .D.
        [table-file] O nome de uma tabela de definição livre tem de terminar em .TAB.
        [rotary-axis] Espera-se a letra de um eixo rotativo (A, B ou C), encontrou-se «{ $found }».
        [parallel-axis] Espera-se a letra de um eixo paralelo (U, V ou W), encontrou-se «{ $found }».
        [carried] Um eixo rotativo leva a peça (workpiece) ou a ferramenta (tool), não «{ $found }».
        [encoder] O encoder de um eixo está no motor (motor) ou no eixo (axis), não «{ $found }».
        [orientation] A orientação tem de ser fixed, two ou any, não «{ $found }».
        [shaft] A haste tem de ser mais fina do que a esfera; o seu diâmetro é { $found }.
        [measurements] São possíveis 1, 2 ou 3 medições, não «{ $found }».
       *[solids] Espera-se pelo menos um sólido.
    }
diag-scene-unknown-key = A chave { $key } não é possível aqui; as chaves possíveis são { $known }.
diag-scene-missing-key = Falta a chave { $key }.
diag-scene-not-positive = O valor deve ser maior do que zero e não { $found }.
diag-scene-version = Esta versão do formato do ficheiro não é suportada; a versão suportada é { $known }.
diag-scene-repeated = { $found } está definido duas vezes.
diag-scene-min-max = Cada valor mínimo deve ser menor do que o respetivo máximo.
diag-scene-no-length = O seu comprimento é zero.
diag-scene-one-solid = Espera-se aqui exatamente um sólido: { $known }.
diag-scene-unknown-machine = Não existe nenhuma máquina com o nome { $name }; as máquinas são { $known }.
diag-scene-no-axis = A máquina não tem um eixo { $axis }.
diag-scene-start-outside = A posição inicial está fora da margem de deslocação do eixo { $axis }: { $found } { $unit } não está entre { $min } e { $max } { $unit }.
diag-scene-stl = { $file }: { $kind ->
        [nowhere] Uma cena dentro de outro ficheiro não pode indicar ficheiros STL.
        [large] Os ficheiros STL de uma cena podem ter ao todo { $most } MB.
        [number] No triângulo { $triangle }, uma coordenada não é um número ou é superior a 1000000.
        [length] O ficheiro não tem o comprimento que o número de triângulos indicado ({ $triangle }) exige.
       *[empty] Nenhum triângulo tem área.
    }
diag-scene-stl-word = Espera-se aqui { $wanted ->
        [number] um número até 1000000
       *[word] { $wanted }
    }, em vez de «{ $found }».

diag-solid-not-finite = Uma medida não é um número finito e positivo.
diag-solid-too-many = A forma tem demasiadas superfícies: levaria demasiado tempo a encontrar as suas arestas. Omita aquilo de que nenhuma ferramenta ou apalpador se aproxima.
diag-solid-edge-unsupported = A esfera de apalpação pode tocar numa aresta que não é uma reta nem um círculo; este contacto não pode ser calculado com exatidão.
diag-solid-cusp = A esfera de apalpação pode tocar num ponto em que as superfícies são tangentes e não deixam espessura; este contacto não pode ser calculado com exatidão.
diag-solid-mesh-cut = Uma superfície de triângulos não pode fazer parte de uma diferença.
diag-solid-helix-unsupported = A esfera de apalpação pode tocar na peça durante um movimento helicoidal ou enquanto se movem vários eixos; este contacto não pode ser calculado com exatidão.

diag-table-no-header = A tabela deve começar por uma linha com "BEGIN", o nome de um ficheiro { $extension } e a unidade de medida.
diag-table-no-heading = A segunda linha tem de conter os nomes das colunas, incluindo { $column }.
diag-table-no-end = Falta a linha [END].
diag-table-not-described = Os manuais não descrevem tabelas deste tipo: só se verificam o início e o fim.
diag-table-no-row-number = A linha não tem número: «{ $found }».
diag-table-duplicate-row = A linha { $row } aparece duas vezes.
diag-table-bad-number = { $file }, linha { $row }, coluna { $column }: «{ $found }» não é um número.
diag-table-missing = A tabela { $file } não existe.
diag-table-no-row = A tabela { $file } não tem a linha { $row }.
diag-table-no-column = A tabela { $file } não tem a coluna { $column }.
diag-table-too-wide = { $file }, linha { $row }: o valor não cabe na coluna { $column }.
diag-table-text-in-numbers = { $file }, linha { $row }: a coluna { $column } aceita só números.
diag-table-key-column = { $file }, linha { $row }: o número da linha na coluna { $column } não pode ser alterado.
diag-table-duplicate-column = A coluna { $column } aparece duas vezes.
diag-table-unknown-column =
    { $count ->
        [one] Os manuais não descrevem a coluna { $column }: as suas células não são verificadas.
       *[other] Os manuais não descrevem as colunas { $column }: as suas células não são verificadas.
    }
diag-table-doubtful =
    { $what ->
        [unit] A primeira linha não contém MM nem INCH.
        [kind] A primeira linha indica um ficheiro { $found }, mas este é um ficheiro { $column }.
        [column] Falta a coluna { $column }.
        [order] A linha { $row } está depois da linha { $found }.
        [after-end] As linhas depois de [END] não são lidas.
        [astride] Linha { $row }: o número da coluna { $column } estende-se para a coluna { $found }.
        [empty] Linha { $row }: a coluna { $column } está vazia.
        [corner] Linha { $row }: R2 é maior do que R.
        [same] A linha { $row } contém o mesmo ponto que a linha { $found }.
        [zero] A ferramenta 0 significa que nenhuma ferramenta é chamada; o seu { $column } devia ser 0.
        [less] Na linha { $row }, { $column } é menor do que { $found }.
       *[value] Linha { $row }: «{ $found }» na coluna { $column } é provavelmente um erro.
    }
diag-table-value-not-allowed = Linha { $row }: a coluna { $column } não admite «{ $found }».
diag-stock-extent = O bloco é demasiado grande: estende-se a mais de { $limit } mm do seu ponto de referência.
diag-stock-form = BLK FORM { $word } não diz aqui como é o bloco: defina-o na cena, como paralelepípedo com BLK FORM 0.1 e 0.2, ou com BLK FORM CYLINDER.
diag-stock-missing = Não há bloco: a cena não tem stock e o programa não tem BLK FORM.
diag-stock-blank = BLK FORM precisa de números que deem uma extensão ao bloco: cada mínimo tem de ser inferior ao seu máximo, um cilindro maior do que o seu furo.
diag-stock-resolution = { $found } não pode ser a distância entre as colunas do bloco: tem de ser superior a zero e pode haver, no máximo, 10 milhões de colunas.
diag-stock-resolution-mesh = A peça tem mais triângulos do que um ficheiro STL pode conter; escolha uma distância maior entre as colunas.
