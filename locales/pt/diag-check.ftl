# Mensagens da verificação e da tradução de programas; ver o ficheiro inglês.

diag-approach-twice = A aproximação ao contorno faz-se aqui com a compensação do raio ativa: o contorno anterior não foi deixado.
diag-approach-without-compensation =
    { $what ->
        [approach] A aproximação ao contorno faz-se aqui sem RL nem RR.
       *[departure] Sai-se aqui do contorno, mas nenhuma compensação do raio está ativa.
    }
diag-arc-in-unequal-scaling = { $cycle } escala os eixos deste arco com fatores diferentes.
diag-arc-too-narrow = O raio { $radius } no interior do contorno é menor do que o da ferramenta, { $tool }.
diag-arc-without-tangent = Antes deste arco tangente não há nenhum elemento de contorno.
diag-arc-wrong =
    O arco não pode terminar aqui: { $what ->
        [radius] o raio é { $first } e a distância entre o início e o fim é { $second }
        [full] acaba onde começa; o centro de um círculo completo não resulta do raio
        [sense] o ângulo é { $first }, mas DR roda no outro sentido
       *[centre] o início fica a { $first } do centro e o fim a { $second }
    }.
diag-axis-twice = O eixo { $axis } aparece duas vezes nesta frase.
diag-blocks-after-end = Há aqui frases depois de END PGM.
diag-blank-wrong =
    { $what ->
        [again] O bloco já tem antes um BLK FORM 0.1.
        [axis] Falta aqui { $axis }: um vértice do bloco tem três coordenadas.
        [first] Antes de BLK FORM 0.2 não há BLK FORM 0.1.
        [cylinder] Falta ao cilindro o raio ou o diâmetro, ou a longitude.
        [second] Depois de BLK FORM 0.1 não há BLK FORM 0.2.
        [tool] O bloco não indica o eixo da ferramenta.
       *[order] No eixo { $axis }, a coordenada do segundo vértice do bloco não é maior do que a do primeiro.
    }
diag-block-numbers = O número de frase { $number } vem depois de { $before }.
diag-call-of-def-active-cycle = { $cycle } atua logo que é definido; não deve ser chamado.
diag-called-but-not-defined = Aqui é chamado um ciclo, mas antes não está definido nenhum.
diag-called-program-in-other-unit = Este programa está em { $own }, o programa chamado { $name } em { $other }.
diag-called-program-missing = O programa { $name } não está junto deste, onde o comando o procura.
diag-centre-in-other-plane = O arco percorre um plano diferente daquele em que está o seu centro.
diag-choice-not-offered = { $parameter }={ $value } não está entre as opções: { $offered }.
diag-clearance-height-too-low = { $cycle } apalpa em { $touched }: a altura segura { $parameter }={ $value } tem de ficar acima de { $least }.
diag-compensation-at-cycle =
    { $cycle } é executado aqui com a correção de raio ativa.
diag-compensation-left-on = A correção de raio ainda está aqui ativa.
diag-compensation-on-arc = A compensação do raio começa aqui num arco.
diag-compensation-switched = A compensação do raio muda aqui de lado sem R0 de permeio.
diag-contour-data-missing = { $cycle } é chamado, mas { $data } não foi definido antes.
diag-contour-def-wrong =
    { $what ->
        [number] { $found }: outro contorno já tem este número.
        [many] { $found }: CONTOUR DEF tem no máximo nove contornos.
       *[island] { $found }: o primeiro contorno de CONTOUR DEF é uma caixa, a mais profunda.
    }
diag-contour-depth-missing = { $contour } não tem DEPTH, outros contornos têm.
diag-contour-undeclared =
    { $what ->
        [twice] { $contour } já está declarado antes.
       *[nothing] A fórmula lê { $contour }, que nada indica antes.
    }
diag-contour-not-selected =
    { $cycle } é chamado aqui, mas antes não foi indicado nenhum contorno.
diag-contour-wrong =
    { $cycle } não pode maquinar o contorno assim: { $what ->
        [axis] nele move-se o eixo da ferramenta { $word }
        [approach] contém { $word }
        [tool] contém { $word }
        [call] contém { $word }
        [path] o ciclo não lê { $word }
        [first] o primeiro ponto não indica ambas as coordenadas do plano
        [uncompensated] não tem RL nem RR
        [many] o ciclo maquina só o primeiro contorno, não { $word }
        [corner] nenhum elemento se segue a { $word }
        [local] nele lê-se { $word }, que nele não é atribuído
       *[open] não acaba onde começa
    }.
diag-coordinate-out-of-place = As coordenadas não são adequadas a { $path }.
diag-corner-wrong =
    Esta esquina não se pode maquinar: { $what ->
        [twice] antes dela já há um arredondamento ou um chanfro
        [arc] um chanfro fica entre retas, e aqui há um arco
        [first] não o precede nenhum elemento de contorno
        [alone] não lhe segue nenhum elemento do contorno
        [back] a reta que lhe segue volta sobre a que a precede
        [size] o seu raio ou comprimento não é positivo
       *[long] exige mais do que mede a reta mais curta, { $least }
    }.
diag-cutting-without-tool = Aqui a ferramenta desloca-se em avanço, mas antes não há nenhuma chamada da ferramenta.
diag-cycle-line-zero-missing = Antes da linha { $line } não há a linha { $head }.
diag-cycle-line-empty = Na linha { $line } de { $cycle } não há nada.
diag-cycle-line-missing = Antes de { $line } falta a linha { $missing }.
diag-cycle-line-twice = A linha { $line } está duas vezes nesta definição.
diag-cycle-not-covered =
    { $other ->
        [none] { $cycle } não é verificado: os manuais do comando { $control } aqui conhecidos não tratam de ciclos deste tipo.
       *[other] Os manuais do comando { $control } aqui conhecidos não tratam de ciclos como { $cycle }: é comparado com o manual de { $other }.
    }
diag-cycle-not-described =
    { $other ->
        [none] { $cycle } ({ $name }) é mencionado nos manuais mas não descrito: os seus parâmetros não são verificados.
       *[other] { $cycle } ({ $name }) é mencionado nos manuais mas não descrito: é comparado com o manual de { $other }.
    }
diag-cycle-not-on-control = { $cycle } não existe no comando { $control }; existe em: { $controls }.
diag-cycle-of-previous-tool = { $cycle } foi definido para a ferramenta anterior, que já o executou.
diag-datum-table-late = A deslocação do ponto zero anterior tirou a sua linha de outra tabela: SEL TABLE tem de ficar antes dela.
diag-defined-but-never-called = { $cycle } é definido aqui e nunca é chamado.
diag-digitizing-wrong =
    { $what ->
        [swapped] { $word } é menor do que o ponto MIN do campo, { $other }.
        [low] A altura segura { $word } está abaixo do ponto MAX do campo, { $other }.
        [missing] { $cycle } digitaliza, mas antes não foi definido nenhum campo.
       *[combined] { $cycle } não pode ser combinado com { $range }, que aqui define o campo.
    }
diag-arc-direction-missing = O arco não indica o sentido de rotação: falta DR+ ou DR−.
diag-doubtful-value =
    { $parameter }={ $value } em { $cycle } dificilmente é o pretendido: { $is ->
        [zero] o valor é 0
        [negative] o valor é negativo
       *[positive] o valor é positivo e afasta da peça
    }.
diag-duplicate-parameter = { $parameter } aparece duas vezes em { $cycle }.
diag-empty-word = Este { $word } não tem valor e não faz nada.
diag-feed-negative = O avanço é aqui negativo.
diag-feed-zero = O avanço é aqui zero.
diag-field-word-missing = Aqui há um valor sem palavra; o comando mostra-o com uma: { $shown }.
diag-begin-end-mismatch = END PGM indica { $end }, BEGIN PGM indica { $begin }.
diag-free-contour-wrong =
    { $what ->
        [label] Um contorno livre não pode começar logo depois de um label.
        [again] CLSD+ aparece de novo antes de CLSD- ter fechado o contorno.
        [unbegun] CLSD- fecha aqui um contorno que nenhum CLSD+ abriu.
        [unclosed] O contorno aberto com CLSD+ acaba aqui sem CLSD-.
        [length] O comprimento LEN não é positivo.
        [auxiliary] Falta à distância D o ponto auxiliar (PDX, PDY).
        [distance] Falta ao ponto auxiliar a distância D.
        [selected] FSELECT não segue nenhum elemento de um contorno livre.
        [solution] FSELECT recebe o número de uma solução, contado a partir de 1.
        [fpol] O polo de um contorno livre tem duas coordenadas.
        [pole] Há aqui dados polares sem polo (FPOL).
       *[open] O contorno livre não está determinado: sabe-se demasiado pouco dos seus elementos.
    }
diag-function-misspelled = Nenhum comando conhece aqui { $word }; talvez se pretenda { $meant }.
diag-function-not-on-control = O { $control } não tem { $function }.
diag-functions-contradict = { $first } e { $second } estão na mesma frase; só uma delas pode ser a pretendida.
diag-global-def-wrong =
    { $what ->
        [unknown] Não existe GLOBAL DEF { $number }.
        [missing] Em GLOBAL DEF { $number } falta { $parameter }.
        [foreign] GLOBAL DEF { $number } não fornece { $parameter }.
        [twice] { $parameter } está duas vezes em GLOBAL DEF { $number }.
        [again] GLOBAL DEF { $number } já está antes e nenhum ciclo usou os seus valores.
        [nothing] Em { $value } está PREDEF para { $parameter }, mas nenhum GLOBAL DEF o fornece.
        [later] Em { $value } está PREDEF para { $parameter }, mas o GLOBAL DEF que o fornece está depois.
       *[value] Nenhum ciclo aceita { $parameter }={ $value }.
    }
diag-guard = O comando não aceita estes valores.
diag-hole-outside-blank =
    { $what ->
        [beside] O furo em { $value }; { $other } fica ao lado do bloco.
        [surface] A superfície em { $value } não está no bloco.
       *[through] O furo chega a { $value }, muito para além do bloco.
    }
diag-iso-incomplete =
    Esta frase está incompleta: { $what ->
        [value] uma letra não tem valor
        [label] falta o label (L)
        [radius] falta o raio ou o comprimento (R)
        [cycle] faltam as palavras do ciclo (P01, P02, …)
       *[operand] falta um operando ou o label de um salto (P01, P02, P03)
    }.
diag-label-duplicate = O label { $label } é definido aqui pela segunda vez.
diag-label-missing = O idioma «{ $language }» não tem designação para { $parameter } de { $cycle }.
diag-label-not-encodable = «{ $label }» tem o carácter «{ $character }», que a codificação do ficheiro não pode escrever.
diag-label-of-another-language = «{ $label }» é uma designação noutro idioma ({ $language }); a maior parte do programa designa { $parameter } por «{ $right }».
diag-label-of-another-parameter = «{ $label }» é a designação de { $other }, não de { $parameter }.
diag-label-twice = «{ $label }» está em { $parameter } e em { $other }: um deles tem outro texto.
diag-label-undefined = Nenhuma frase define o label { $label }.
diag-labels-of-unknown-language =
    { $count ->
        [one] Esta definição tem designações num idioma aqui desconhecido; foi lida pelos seus números.
       *[other] { $count } definições, das quais esta é a primeira, têm designações num idioma aqui desconhecido; foram lidas pelos seus números.
    }
diag-languages-mixed = A maioria das designações está num idioma ({ $language }); as definições nestas linhas estão noutro ({ $others }): { $lines }.
diag-loop-endless = Nada no ciclo que este salto fecha pode terminá-lo.
diag-machine-coordinates-compensated = Programam-se aqui coordenadas da máquina (M91, M92) com compensação do raio.
diag-main-runs-into-subprogram = A parte principal continua aqui para dentro do subprograma { $label }: antes não há M2 nem M30.
diag-measuring-height-below-floor = { $cycle } mede em { $parameter }={ $value }, abaixo do fundo que { $milling } aí deixa, { $floor }.
diag-metric-values-in-inch = O programa está em polegadas e { $value } parece estar em milímetros.
diag-mirror-of-tool-axis = O eixo da ferramenta { $axis } não pode ser espelhado.
diag-misordered-parameter = Em { $cycle }, o comando visualiza { $parameter } antes de { $before }.
diag-missing-parameter =
    { $count ->
        [one] Em { $cycle } falta { $parameter }.
       *[other] Em { $cycle } faltam { $parameter }.
    }
diag-modal-call-left-on =
    M89 ainda chama o ciclo nesta frase, { $what ->
        [beside] que leva a um ponto ao lado do bloco
       *[again] pelo que a ferramenta maquina mais uma vez a última posição
    }.
diag-mode-wrong =
    { $what ->
        [milling] { $cycle } fresa ou fura, mas aqui está ativo FUNCTION MODE TURN.
        [turning] { $cycle } torneia, mas FUNCTION MODE TURN não está aqui ativo.
       *[data] { $cycle } está aqui fora do modo de tornear.
    }
diag-name-of-another-cycle = “{ $name }” é o nome de { $other }, mas aqui está { $cycle }.
diag-no-result =
    Esta fórmula não tem resultado: { $why ->
        [division] divide por zero
        [large] o número é demasiado grande
       *[domain] uma função recebe um valor para o qual não está definida
    }.
diag-no-table-open = FN 27 e FN 28 trabalham na tabela que FN 26 abriu.
diag-not-a-program = Este ficheiro não é um programa NC.
diag-number-does-not-exist = { $name } não existe: os números vão até { $greatest }.
diag-older-parameter-set = { $cycle } tem os parâmetros de uma versão de software anterior; o comando acrescenta { $parameter }.
diag-out-of-range =
    { $side ->
        [below] { $parameter }={ $value } é demasiado pequeno: o valor mínimo é { $limit }.
        [long] O texto de { $parameter } é demasiado longo: são permitidos { $limit } caracteres.
        [many] { $parameter } indica labels a mais: são permitidos { $limit }.
        [axes] { $parameter } indica eixos a mais: pode indicar { $limit }.
       *[above] { $parameter }={ $value } é demasiado grande: o valor máximo é { $limit }.
    }
diag-out-of-usual-range =
    { $parameter }={ $value } dificilmente é o pretendido: { $where ->
        [control] o { $control } não aceita aí valores { $side ->
                [below] inferiores a
               *[above] superiores a
            } { $limit }.
       *[any] nenhum manual admite para tais parâmetros valores { $side ->
                [below] inferiores a
               *[above] superiores a
            } { $limit }.
    }
diag-parameter-of-later-software = { $parameter } em { $cycle } exige uma versão de software posterior à { $software }, que o manual descreve.
diag-parameter-unassigned =
    { $parameter } é lido aqui, mas antes nada lhe atribui um valor.
diag-pattern-combination =
    { $what ->
        [value] { $cycle } não pode chamar { $called } com { $value }.
       *[cycle] { $cycle } não pode chamar { $called }.
    }
diag-pattern-wrong =
    { $what ->
        [count] { $word } é um número inteiro de posições, pelo menos 1.
        [many] { $word }: PATTERN DEF tem no máximo nove posições individuais.
        [rapid] { $word } não é válido aqui: entre os pontos de uma tabela a ferramenta desloca-se em avanço.
        [distance] { $word } é 0: todas as posições são a mesma.
        [angle] { $word } é mais do que uma volta completa.
        [same] { $word } é a mesma posição que uma anterior.
       *[diameter] O diâmetro { $word } de um círculo de posições é maior que 0.
    }
diag-plane-incomplete = Neste PLANE falta { $word }.
diag-plane-not-positioned = STAY deixa os eixos rotativos onde estão e nenhuma frase do programa os leva aos ângulos deste plano.
diag-plane-not-reset = O programa termina aqui com o plano de maquinação inclinado.
diag-position-after-contour = Esta é a primeira posição depois de { $cycle } e não indica ambas as coordenadas do plano em absoluto.
diag-probe-while-turning = { $cycle } apalpa aqui com o cabeçote a rodar.
diag-probed-axis-missing = Apalpa-se na direção { $direction }, mas a posição não indica { $axis }.
diag-program-begin-missing = O programa não começa com BEGIN PGM.
diag-program-begin-twice = BEGIN PGM está aqui pela segunda vez.
diag-program-calls-itself = O programa chama-se a si próprio: { $name }.
diag-program-empty = O ficheiro não contém nenhuma frase.
diag-program-end-missing =
    O programa acaba aqui sem { $end ->
        [iso] uma frase que comece por % e o termine
       *[pgm] END PGM
    }.
diag-programs-call-in-circle = O programa { $name } volta a chamar este, diretamente ou através de outros.
diag-rapid-into-blank = A ferramenta entra aqui no bloco em marcha rápida: Z vai para { $value } e o bloco chega até { $top }.
diag-repeat-count-wrong = Uma parte do programa repete-se um número inteiro de vezes, de 0 a 65534.
diag-repeat-of-later-label = O label { $label } fica depois desta repetição.
diag-reserved-parameter = Aqui escreve-se em { $parameter }, mas é o próprio comando que escreve em Q100 a Q199.
diag-reset-order-wrong =
    { $what ->
        [tilt] O plano inclinado é anulado aqui, mas a rotação que foi ativada depois dele ainda está ativa.
       *[shift] A deslocação do ponto zero é anulada aqui, mas o plano que foi inclinado depois dela ainda está inclinado.
    }
diag-retract-missing =
    A ferramenta está em { $value }, dentro do bloco ou logo acima dele, quando { $what ->
        [change] é trocada
       *[turn] um eixo rotativo roda em marcha rápida
    }: não foi retirada.
diag-row-not-in-table =
    { $table ->
        [preset] A tabela de pontos de referência não tem a linha { $row }.
       *[datum] A tabela de pontos zero não tem a linha { $row }.
    }
diag-program-not-selected = Chama-se aqui um programa selecionado, mas nenhum foi selecionado.
diag-speed-missing = Aqui liga-se o cabeçote, mas não foi programado nenhum número de rotações.
diag-speed-out-of-range =
    { $what ->
        [feed] O avanço { $value }
       *[speed] A velocidade do mandril { $value }
    } dificilmente é o pretendido: { $side ->
        [below] o valor é negativo
       *[above] o valor máximo que os manuais permitem introduzir é { $limit }
    }.
diag-spindle-direction = { $cycle } precisa de um cabeçote que rode no sentido horário, e aqui roda no sentido anti-horário.
diag-spindle-off = Aqui remove-se material com o cabeçote parado.
diag-sql-handle-missing =
    { $what ->
        [ended] COMMIT ou ROLLBACK já terminou a transação com HANDLE { $handle }.
       *[missing] Nenhuma consulta deu antes HANDLE { $handle }.
    }
diag-subprogram-end-without-label = Este LBL 0 não termina nenhum subprograma.
diag-subprogram-recursive = O subprograma { $label } chama-se aqui a si próprio.
diag-subprogram-runs-on = O subprograma { $label } continua para dentro do subprograma { $next }: entre eles não há LBL 0.
diag-subprogram-without-end = O subprograma { $label } chega ao fim do programa sem LBL 0.
diag-tcpm-left-on =
    { $what ->
        [tool] Chama-se aqui uma ferramenta com M128 ou FUNCTION TCPM ativo.
       *[end] O programa termina aqui com M128 ou FUNCTION TCPM ativo.
    }
diag-text-for-number =
    { $what ->
        [text] { $parameter } aceita um número, e isto é um texto.
        [number] { $parameter } aceita um texto, e isto é um número.
       *[calculation] Isto é um texto; não se pode calcular com ele.
    }
diag-text-wrong =
    { $what ->
        [empty] O texto de { $parameter } está vazio.
        [alone] «{ $found }» no texto de { $parameter } não está duplicado nem antes de uma letra.
       *[character] { $parameter } não aceita «{ $found }».
    }
diag-tool-axis-missing = Esta chamada de ferramenta não indica o eixo da ferramenta, e nenhum foi indicado antes.
diag-tool-axis-other =
    { $what ->
        [pattern] PATTERN DEF trabalha só com o eixo da ferramenta { $axis }, e aqui está ativo outro.
       *[blank] O bloco indica o eixo da ferramenta { $axis }, que nenhuma ferramenta do programa tem.
    }
diag-tool-definition-wrong =
    { $what ->
        [zero] A ferramenta 0 significa nenhuma ferramenta e não se pode definir.
        [twice] A ferramenta { $tool } já está definida antes com outras medidas.
       *[after-call] A ferramenta { $tool } é definida aqui, mas já foi chamada.
    }
diag-tool-feed-missing = Usa-se aqui o avanço da chamada da ferramenta, que não o tem.
diag-tool-missing = Aqui um ciclo executa movimentos, mas antes nenhuma chamada da ferramenta indicou o eixo da ferramenta.
diag-tool-not-listed = A tabela de ferramentas não tem a ferramenta { $tool }.
diag-wrong-tool-type =
    { $what ->
        [probe] { $cycle } apalpa aqui com a ferramenta que acabou de maquinar.
       *[mill] { $cycle } maquina aqui com a ferramenta que acabou de apalpar.
    }
diag-tool-unused = A ferramenta { $tool } é chamada aqui e logo trocada por outra.
diag-transfer-parameter-overwritten =
    { $what ->
        [passed] { $cycle } leu { $parameter } na definição: o que aqui se escreve não altera a sua chamada.
        [filled] { $cycle } preenche quatro parâmetros a partir do que aqui se indica, e com eles { $parameter }, que o programa escreveu antes e lê mais adiante.
        [lost] { $cycle } escreve por cima de { $parameter } antes de o programa ler o que aqui se escreve.
       *[call] { $parameter } pertence a { $cycle }, que é chamado mais adiante: a chamada usa o valor aqui escrito.
    }
diag-transformation-forbidden =
    { $cycle } está aqui embora { $what ->
        [datum-shift] esteja ativa uma deslocação do ponto zero
        [rotation] esteja ativa uma rotação
        [tcpm] esteja ativa M128 ou FUNCTION TCPM
        [other-axis] o eixo da ferramenta não seja Z
        [turning] esteja ativo o modo de torneamento (FUNCTION MODE TURN)
       *[tilting] o plano de maquinação esteja inclinado
    }: o manual proíbe-o.
diag-transformation-left-on =
    O programa termina aqui com { $what ->
        [datum-shift] uma deslocação do ponto zero ativa
        [rotation] uma rotação ativa
        [mirroring] um espelho ativo
       *[scaling] um fator de escala ativo
    }.
diag-turning-feed-unit =
    { $what ->
        [revolution] { $parameter }={ $value } é aqui um avanço por rotação, porque M136 está ativo.
       *[minute] { $parameter }={ $value } é aqui um avanço por minuto, porque M136 não está ativo.
    }
diag-turning-system-missing = { $cycle } é chamado aqui, mas depois da chamada da ferramenta { $aligning } não foi definido.
diag-two-signs = Antes do número há dois sinais; são lidos como { $right }.
diag-unknown-cycle =
    { $name ->
        [none] { $cycle } é um ciclo de que nenhum manual aqui considerado fala.
       *[other] { $cycle } ({ $name }) é um ciclo dos primeiros comandos: ainda é executado, mas os seus valores não são verificados.
    }
diag-unknown-parameter = Neste comando, { $cycle } não tem o parâmetro { $parameter }.
diag-differs-from-other-control =
    { $what ->
        [missing] { $cycle } tem no { $control } o parâmetro { $parameter }, que aqui falta.
        [value] O { $control } recusa o valor { $parameter }={ $value } em { $cycle }.
        [twice] { $parameter } está duas vezes em { $cycle }.
        [foreign] { $cycle } não tem no { $control } o parâmetro { $parameter }.
        [order] { $parameter } está depois de { $before }; em { $cycle } no { $control } está antes.
        [label] «{ $label }» em { $cycle } no { $control } pertence a { $other }, não a { $parameter }.
        [doubt] { $cycle } é duvidoso: { $message }
        [alone] { $parameter }={ $value } em { $cycle } é um valor que nenhum ciclo com este parâmetro aceita.
       *[guard] O { $control } recusa { $cycle }: { $message }
    }
diag-unreachable =
    { $part ->
        [label] Nada conduz a este label.
       *[block] A execução nunca chega a esta frase.
    }
diag-meaningless-value = O valor é aqui { $value }, o que não faz sentido.
diag-word-missing = Nesta frase falta { $word }.
diag-word-twice = { $word } está duas vezes nesta frase.
diag-word-wrong =
    { $what ->
        [below] { $word } é { $value }: demasiado pouco.
        [above] { $word } é { $value }: demasiado.
        [whole] { $word } é { $value }, mas só aceita números inteiros.
        [offers] A seguir a { $word } está uma destas palavras: { $value }.
        [contradict] { $word } e { $value } excluem-se mutuamente.
        [zero] { $word } não podem ser todos 0.
        [not-below] { $word } tem de ser menor do que { $value }.
        [operator] Aqui está «{ $word }» em vez de { $value }.
        [empty] O nome está vazio.
        [value] Falta o valor a seguir a { $word }.
        [place] { $word } não tem lugar nesta frase.
        [line] Os três pontos estão numa mesma reta e não definem nenhum plano.
        [parallel] Os dois vetores são paralelos e não definem nenhum plano.
        [number] O texto de { $word } não é um número: «{ $value }».
        [beyond] { $word } é { $value }, para lá do fim do texto.
        [file] { $value } não é um ficheiro { $word }.
       *[tool] { $value } não é um número de ferramenta: depois do ponto há um só algarismo.
    }
diag-wrong-value-kind =
    O parâmetro { $parameter } de { $cycle } aceita { $kind ->
        [integer] um número inteiro
        [number-or-name] um número ou um nome entre aspas
        [text] um texto entre aspas
        [q-number] um parâmetro Q
        [axis-direction] um eixo com sinal, por exemplo X-
        [position] coordenadas por eixo, por exemplo X+5 Y+0
        [row] uma linha da tabela, por exemplo #5
        [axis] um eixo
        [label-list] números de labels separados por barras, por exemplo 1/2/3
       *[number] um número
    }{ $words-count ->
        [0] {""}
       *[other] {" "}ou { $words }
    }.
