### Textos das mensagens do analisador. $found é o que se encontra nesse ponto, $expected uma chave para o que aí poderia estar, ou uma palavra de programa.

syntax-expected =
    { $expected ->
        [block] o início de uma frase
        [end] o fim da frase
        [sign] um sinal
        [word] uma coordenada, R0, RL, RR, um avanço ou uma função M
        [number] um número
        [m-function] uma função M
        [blk-form-part] 0.1, 0.2, CYLINDER, ROTATION ou FILE
        [tool-word] S, F, DL, DR ou DR2, cada um uma só vez
        [tool] um número de ferramenta ou um nome de ferramenta entre aspas
        [value] um número ou um parâmetro Q
        [quotation-mark] as aspas finais
        [unit] MM ou INCH
        [label] um número de label ou um nome de label entre aspas
        [call] LBL ou PGM
        [name] um nome
        [selection] TABLE, PATTERN, CONTOUR, PGM ou CYCLE
        [cycle-word] CYCL DEF, CYCL CALL ou TCH PROBE
        [cycle-number] o número de um ciclo
        [text-parameter] um parâmetro QS
        [parameter] um parâmetro Q
        [relation] EQU, NE, GT ou LT
        [relation-of-number] a comparação própria deste número FN
        [less-nesting] uma fórmula mais curta ou menos encadeada
        [field] um campo do ciclo
        [operand] um número, um parâmetro Q ou uma função
        [operator] um operador aritmético
        [closing-bracket] um parêntese final
        [known-function] uma função da linguagem de fórmulas
        [character] um carácter da linguagem de fórmulas
        [arguments] um número diferente de argumentos
        [in-spec-only] apenas operações aritméticas; um programa não pode comparar aqui
        [block-word] uma palavra desta frase
        [approach] LT, LN, CT, LCT, PLT, PLN, PCT ou PLCT
        [plane-form] SPATIAL, PROJECTED, EULER, VECTOR, POINTS, RELATIV, AXIAL ou RESET
        [function] o nome de uma função
        [transformation] DATUM, MIRROR, ROTATION ou SCALE
        [pattern-item] POS, ROW, PAT, FRAME, CIRC ou PITCHCIRC
        [contour-name] um contorno, por exemplo QC1
        [contour-operator] &, |, ^ ou \
       *[other] { $expected }
    }

diag-syntax-unknown-block = Nenhuma frase começa com «{ $found }».
diag-syntax-unexpected = «{ $found }» não pode estar aqui; esperado: { syntax-expected }.
diag-syntax-incomplete = A frase está incompleta; esperado: { syntax-expected }.
diag-syntax-unclosed-text = Faltam ao texto as aspas finais: { $found }
diag-syntax-formula = «{ $found }» não pode estar neste ponto da fórmula; esperado: { syntax-expected }.
diag-syntax-text-after-tab = «{ $found }» está depois de uma tabulação e não pertence a nenhuma frase; o comando recusá-lo-ia. Os comentários começam com ponto e vírgula.
diag-syntax-dangling-continuation = O til (~) indica que a frase continua, mas não se segue nenhuma linha que pertença a ela.
diag-syntax-foreign-line = «{ $found }» não é uma frase desta linguagem; o comando recusá-la-ia. Os comentários começam com ponto e vírgula.
diag-syntax-spelling = Os comandos não escrevem «{ $found }», mas: { syntax-expected }.
diag-syntax-undescribed = «{ $found }» não está descrito em nenhum manual desta família de comandos; não se sabe se um comando o aceita.
diag-syntax-refused-block = Um comando não conseguiu ler esta frase: { $found }
diag-syntax-excluding-codes = «{ $found }» e outro código desta frase excluem-se mutuamente.
diag-syntax-bracket-comment = Um texto entre parênteses não é um comentário nestes comandos: os comentários começam com ponto e vírgula.
diag-syntax-doubled-continuation = Há um segundo til (~); basta um para continuar a frase na linha seguinte.
