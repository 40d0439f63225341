# Mensagens da verificação e da tradução de programas; ver o ficheiro inglês.

diag-approach-twice =
    { $what ->
        [call] O subprograma começa um contorno com RL ou RR, mas é chamado aqui com a correção da chamada anterior ainda ativa.
       *[approach] Faz-se a aproximação ao contorno com a correção de raio ainda ativa: não se saiu do contorno anterior.
    }
diag-approach-without-compensation =
    { $what ->
        [approach] A aproximação ao contorno faz-se aqui sem RL nem RR.
        [contour] A ferramenta percorre este contorno fechado sem RL nem RR, e a seguir R0 desliga o que nunca esteve ligado.
       *[departure] Sai-se aqui do contorno, mas nenhuma correção de raio está ativa.
    }
diag-arc-direction-wrong =
    { $what ->
        [sign] Este arco só se liga aos elementos anterior e seguinte com o outro sinal do raio: como está escrito, é a parte maior do círculo.
        [full] A ferramenta percorre aqui um círculo completo dentro do contorno: o fim do arco é o seu início.
        [beyond] Este arco sai do bloco; com o outro sentido de rotação ficaria dentro.
       *[direction] Este arco só liga com os elementos anterior e seguinte no outro sentido de rotação.
    }
diag-arc-in-unequal-scaling = { $cycle } aplica fatores de escala diferentes aos eixos deste arco: o resultado não é um arco.
diag-arc-too-narrow = O raio { $radius } no interior do contorno é menor do que o da ferramenta, { $tool }.
diag-arc-without-tangent = Antes deste arco tangente não há nenhum elemento de contorno.
diag-arc-wrong =
    O arco não pode terminar aqui: { $what ->
        [radius] o raio é { $first }, mas o início e o fim distam { $second }
        [full] acaba onde começa; o centro de um círculo completo não resulta do raio
        [sense] o ângulo é { $first }, mas DR tem o sentido oposto
       *[centre] o início fica a { $first } do centro e o fim a { $second }
    }.
diag-axis-twice = O eixo { $axis } aparece duas vezes nesta frase.
diag-back-boring-inside =
    { $what ->
        [hole] A aresta de corte chega a { $value } do eixo do furo, que tem um raio de apenas { $other }: a ferramenta não passa.
       *[thickness] Segundo o ciclo, a espessura do material é { $value }, mas o bloco vai até { $other } abaixo da superfície.
    }
diag-blocks-after-end = Há aqui frases depois de END PGM.
diag-blank-wrong =
    { $what ->
        [again] O bloco já tem um BLK FORM 0.1.
        [axis] Falta aqui { $axis }: um vértice do bloco tem três coordenadas.
        [first] Antes de BLK FORM 0.2 não há BLK FORM 0.1.
        [cylinder] Falta ao cilindro o raio ou o diâmetro, ou o comprimento.
        [second] Depois de BLK FORM 0.1 não há BLK FORM 0.2.
        [tool] O bloco não indica o eixo da ferramenta.
       *[order] No eixo { $axis }, o segundo vértice do bloco tem de ter uma coordenada maior do que o primeiro.
    }
diag-block-numbers = O número de frase { $number } vem depois de { $before }.
diag-call-of-def-active-cycle = { $cycle } atua quando é definido; não pode ser chamado.
diag-called-but-not-defined = Aqui é chamado um ciclo, mas não foi definido nenhum.
diag-called-program-in-other-unit = Este programa está em { $own }, mas o programa chamado { $name } está em { $other }.
diag-called-program-missing = O programa { $name } não está junto deste, onde o comando o procura.
diag-centre-in-other-plane = O arco e o seu centro não estão no mesmo plano.
diag-chamfer-wrong-side = A ponta da ferramenta de chanfrar passa a { $value } de profundidade por material maciço, { $other } para dentro da aresta do bloco: por fora, chanfraria a aresta.
diag-choice-not-offered = { $parameter }={ $value } não é uma das opções: { $offered }.
diag-clearance-height-too-low =
    { $what ->
        [stud] { $cycle } desloca-se de furo para furo a { $parameter }={ $value }, e uma ilha entre eles chega a { $least }.
       *[touched] { $cycle } apalpa em { $touched }: a altura segura { $parameter }={ $value } tem de estar acima de { $least }.
    }
diag-compensation-at-cycle =
    { $cycle } é executado aqui com a correção de raio ativa.
diag-compensation-left-on = A correção de raio ainda está aqui ativa.
diag-compensation-missing = Noutro sítio este contorno é maquinado com RL ou RR; aqui percorre-o o centro da ferramenta com R0.
diag-compensation-on-arc = A correção de raio não pode começar num arco.
diag-compensation-other-side = O mesmo contorno foi maquinado antes com a correção de raio oposta: aqui a ferramenta está do outro lado.
diag-compensation-switched = A correção de raio muda aqui de lado sem R0 pelo meio.
diag-contour-at-rapid = A ferramenta percorre aqui em avanço rápido um contorno com correção de raio.
diag-contour-data-missing = { $cycle } é chamado, mas { $data } não foi definido antes.
diag-contour-def-wrong =
    { $what ->
        [number] { $found }: outro contorno já tem este número.
        [many] { $found }: CONTOUR DEF pode ter no máximo nove contornos.
       *[island] { $found }: o primeiro contorno de CONTOUR DEF tem de ser uma caixa, a mais profunda.
    }
diag-contour-depth-missing = { $contour } não tem DEPTH, mas outros contornos têm.
diag-contour-returns =
    { $what ->
        [back] Aqui o contorno volta para trás pela linha por que chegou a { $value }, { $other }.
       *[corner] O contorno volta a { $value }; { $other }, um canto que já tem.
    }
diag-contour-undeclared =
    { $what ->
        [twice] { $contour } já foi declarado.
       *[nothing] A fórmula utiliza { $contour }, que não foi declarado antes dela.
    }
diag-contour-not-selected =
    { $cycle } é chamado aqui, mas não foi selecionado nenhum contorno.
diag-contour-wrong =
    { $cycle } não pode maquinar o contorno assim: { $what ->
        [axis] desloca-se no eixo da ferramenta { $word }
        [approach] contém { $word }
        [tool] contém { $word }
        [call] contém { $word }
        [path] o ciclo não lê { $word }
        [first] o primeiro ponto não tem ambas as coordenadas do plano
        [uncompensated] não tem RL nem RR
        [many] o ciclo maquina só o primeiro contorno e ignora { $word }
        [corner] nenhum elemento se segue a { $word }
        [local] { $word } é lido nele, mas nele não é atribuído
        [same] o contorno { $word } é o mesmo
        [islands] segundo RL e RR todos são ilhas, e não há nenhuma caixa à sua volta
        [round] em ambos os eixos é mais comprido do que o perímetro do cilindro
        [nested] segundo RL ou RR é uma caixa e fica inteiramente dentro de outra caixa, pelo que não remove nada
        [beside] segundo RL ou RR é uma ilha e fica ao lado de todas as caixas, pelo que ali não se maquina nada
       *[open] não acaba onde começa
    }.
diag-coordinate-out-of-place = { $path } não aceita estas coordenadas.
diag-core-hole-too-large =
    { $what ->
        [removed] A broca com o diâmetro { $other } remove a rosca { $value } que foi aberta aqui antes.
       *[core] O furo tem o diâmetro { $other }, a rosca { $value }: não fica material para a rosca.
    }
diag-core-hole-too-small =
    { $what ->
        [milled] A fresa de roscar de { $value } entra num furo de { $other }: o furo é demasiado estreito.
       *[tapped] Uma rosca de { $value } é aberta num furo de { $other }: o furo é demasiado estreito.
    }
diag-corner-wrong =
    Esta esquina não se pode maquinar: { $what ->
        [twice] segue-se diretamente a outro arredondamento ou chanfre
        [arc] um chanfre tem de estar entre duas retas, mas um dos elementos é um arco
        [first] não a precede nenhum elemento de contorno
        [alone] não se lhe segue nenhum elemento de contorno
        [back] a reta seguinte volta para trás ao longo da anterior
        [size] o seu raio ou comprimento não é positivo
       *[long] precisa de mais do que o comprimento da reta mais curta, { $least }
    }.
diag-cutting-speed-unusual =
    { $side ->
        [above] Uma velocidade de corte de { $value } m/min é demasiado alta para esta ferramenta com o diâmetro { $other }.
        [reamed] O alargador com o diâmetro { $other } avança só { $value } por rotação: a velocidade do mandril é demasiado alta ou o avanço demasiado baixo.
       *[below] Uma velocidade de corte de { $value } m/min é demasiado baixa para esta ferramenta com o diâmetro { $other }.
    }
diag-cutting-without-tool = Aqui a ferramenta desloca-se em avanço, mas antes não há nenhuma chamada da ferramenta.
diag-cycle-line-zero-missing = A linha { $line } não é precedida da linha { $head }.
diag-cycle-line-empty = Na linha { $line } de { $cycle } não há nada.
diag-cycle-line-missing =
    { $line ->
        [none] Falta a linha { $missing }: a definição tem apenas o nome.
       *[other] Falta a linha { $missing } antes de { $line }.
    }
diag-cycle-line-twice = A linha { $line } está duas vezes nesta definição.
diag-cycle-not-covered =
    { $other ->
        [none] { $cycle } não é verificado: os manuais do { $control } que o Ciklo conhece não tratam de ciclos deste tipo.
       *[other] Os manuais do { $control } que o Ciklo conhece não tratam de ciclos como { $cycle }: é verificado segundo o manual do { $other }.
    }
diag-cycle-not-described =
    { $other ->
        [none] Os manuais mencionam { $cycle } ({ $name }), mas não o descrevem: os seus parâmetros não são verificados.
       *[other] Os manuais mencionam { $cycle } ({ $name }), mas não o descrevem: é verificado segundo o manual do { $other }.
    }
diag-cycle-not-on-control = { $cycle } não existe no comando { $control }; existe em: { $controls }.
diag-cycle-of-previous-tool = { $cycle } foi definido para a ferramenta anterior, que já maquinou com ele.
diag-cycle-removes-nothing = { $cycle } não remove nada aqui: não há material onde a sua ferramenta passa.
diag-datum-table-late = A deslocação do ponto zero anterior vai buscar a sua linha a outra tabela: programe SEL TABLE antes dela.
diag-defined-but-never-called = { $cycle } é definido aqui, mas nunca é chamado.
diag-deviation-compared =
    { $what ->
        [deviation] { $parameter } é o desvio em relação à medida nominal { $other }, mas é comparado com { $value } como se fosse a própria medida.
       *[size] { $parameter } é a medida obtida (nominal { $other }), mas é comparado com { $value } como se fosse o desvio.
    }
diag-digitizing-wrong =
    { $what ->
        [swapped] { $word } é menor do que o ponto MIN do campo, { $other }.
        [low] A altura segura { $word } está abaixo do ponto MAX do campo, { $other }.
        [missing] { $cycle } digitaliza, mas antes não foi definido nenhum campo.
       *[combined] { $cycle } não pode ser combinado com { $range }, que aqui define o campo.
    }
diag-arc-direction-missing = Falta o sentido de rotação deste arco, DR+ ou DR−.
diag-doubtful-value =
    { $parameter }={ $value } dificilmente é intencional em { $cycle }: { $is ->
        [zero] o valor é 0
        [negative] o valor é negativo
        [small] o valor é muito menor do que o habitual
        [large] o valor é muito maior do que o habitual
       *[positive] o valor é positivo e afasta a ferramenta da peça
    }.
diag-duplicate-parameter = { $parameter } aparece duas vezes em { $cycle }.
diag-early-cycle-wrong =
    { $what ->
        [corner] O raio de canto { $value } da caixa é menor do que o raio { $other } da ferramenta.
        [clearance] A distância de segurança { $value } é negativa: o ciclo começaria abaixo da sua superfície.
        [depth] A profundidade { $value } é positiva: o ciclo afasta a ferramenta da peça.
        [infeed] Com uma profundidade de passo de 0 o ciclo não pode maquinar.
        [feed] O avanço do ciclo é 0.
        [narrow] A ferramenta com o diâmetro { $other } não cabe numa ranhura ou caixa de { $value }.
        [pitch] A rosca tem um passo de { $value }, mas o macho tem { $other }.
        [peck] O furo é feito num só passo de { $value }: mais de oito vezes o diâmetro { $other } da broca.
        [wide] A caixa circular tem { $value } de largura e o bloco apenas { $other }: pode ter sido introduzido o diâmetro em vez do raio.
        [sides] Com os lados { $value } e { $other } a caixa ultrapassa o bordo do bloco; trocados, ficaria dentro.
       *[tapped] Um avanço de { $value } não serve para o macho: passo vezes rotações dá { $other }.
    }
diag-empty-word = Este { $word } não tem valor e não faz nada.
diag-feed-negative = O avanço é aqui negativo.
diag-feed-zero = O avanço é aqui zero.
diag-field-word-missing = Aqui há um valor sem palavra; o comando mostra-o com uma: { $shown }.
diag-begin-end-mismatch = END PGM indica { $end }, BEGIN PGM indica { $begin }.
diag-free-contour-wrong =
    { $what ->
        [label] Um contorno livre não pode começar logo depois de um label.
        [again] CLSD+ é programado de novo antes de CLSD- ter fechado o contorno.
        [unbegun] CLSD- fecha um contorno que nenhum CLSD+ começou.
        [unclosed] O contorno começado com CLSD+ acaba aqui sem CLSD-.
        [length] O comprimento LEN não é positivo.
        [auxiliary] Falta à distância D o ponto auxiliar (PDX, PDY).
        [distance] Falta ao ponto auxiliar a distância D.
        [selected] FSELECT não se segue a um elemento de um contorno livre.
        [solution] FSELECT recebe o número de uma solução, contado a partir de 1.
        [fpol] O polo de um contorno livre precisa de duas coordenadas.
        [pole] As coordenadas polares precisam de um polo (FPOL).
        [turn] O contorno começa e acaba na mesma circunferência, mas em direções diferentes.
       *[open] O contorno livre não tem solução: indicam-se poucos valores dos seus elementos.
    }
diag-function-misspelled = Nenhum comando aceita aqui { $word }; talvez se pretenda { $meant }.
diag-function-not-on-control = O { $control } não tem { $function }.
diag-functions-contradict = { $first } e { $second } excluem-se mutuamente, mas estão na mesma frase.
diag-global-def-wrong =
    { $what ->
        [unknown] Não existe GLOBAL DEF { $number }.
        [missing] Em GLOBAL DEF { $number } falta { $parameter }.
        [foreign] GLOBAL DEF { $number } não tem { $parameter }.
        [twice] { $parameter } está indicado duas vezes em GLOBAL DEF { $number }.
        [again] GLOBAL DEF { $number } já foi programado antes, mas nenhum ciclo utilizou os seus valores.
        [nothing] { $parameter } é PREDEF em { $value }, mas nenhum GLOBAL DEF o define.
        [later] { $parameter } é PREDEF em { $value }, mas o GLOBAL DEF que o define vem depois.
       *[value] Nenhum ciclo aceita { $parameter }={ $value }.
    }
diag-guard = O comando não aceita estes valores.
diag-hole-outside-blank =
    { $what ->
        [beside] O furo em { $value }; { $other } fica ao lado do bloco.
        [edge] A borda do bloco corta o furo em { $value }; { $other }.
        [surface] A superfície em { $value } está longe do bloco.
        [tilted] Os furos deste ciclo não atingem o bloco: no plano inclinado ficam ao lado ou por cima dele.
       *[through] O furo desce até { $value }, muito para além do bloco.
    }
diag-incremental-left-on = As coordenadas deste contorno são incrementais; só como absolutas levam de volta ao seu início.
diag-pattern-not-called = Aqui o ciclo é chamado numa só posição, e não nas posições da figura da linha { $line }.
diag-plunge-beside-hole = Antes a frase desceu num furo, mas em { $value }, { $other } penetra em material maciço.
diag-polygon-incomplete =
    { $what ->
        [rectangle] A um retângulo falta o vértice em { $value }, { $other }: esta linha corta-o.
       *[polar] A um polígono regular com { $count } vértices falta o que está a { $value }°.
    }
diag-position-without-call = Entre duas chamadas a ferramenta vai a { $value }, { $other } e não faz lá nada: pode faltar uma chamada (M99, CYCL CALL).
diag-result-of-other-axis =
    { $what ->
        [size] { $value } é o valor nominal de { $other }, mas é comparado aqui com { $parameter }.
       *[axis] { $parameter } é o resultado do eixo { $axis }, mas é usado aqui para { $other }.
    }
diag-holes-overlap =
    { $what ->
        [pockets] A caixa ou ranhura em torno de { $value }, { $other } entra noutra da mesma definição.
        [pocket] O furo em { $value }, { $other } é cortado por uma caixa ou ranhura fresada antes.
        [hole] O furo em { $value }; { $other } é cortado em todo o comprimento por um mais largo, feito antes.
        [inside] A caixa ou ranhura à volta de { $value }; { $other } fica na maior parte dentro de outra fresada antes e pelo menos tão funda, ao contrário das outras da sua definição.
        [beside] Em { $value }; { $other } é alargado um furo, mas os furos com o diâmetro pré-furado estão noutro lugar.
       *[holes] Dois furos com o diâmetro { $other } estão aqui apenas a { $value } um do outro: sobrepõem-se.
    }
diag-insert-points-away = A pastilha não pode cortar para onde vai { $cycle }: a sua orientação (TO) é { $orientation }, pelo que a ponta está virada para o lado oposto à peça ou ao avanço.
diag-iso-incomplete =
    Esta frase está incompleta: { $what ->
        [value] uma letra não tem valor
        [label] falta o label (L)
        [radius] falta o raio ou o comprimento (R)
        [cycle] faltam as palavras do ciclo (P01, P02, …)
       *[operand] falta um operando ou o label de um salto (P01, P02, P03)
    }.
diag-label-duplicate = O label { $label } é definido duas vezes; esta é a segunda.
diag-label-missing = O idioma «{ $language }» não tem designação para { $parameter } de { $cycle }.
diag-label-not-encodable = «{ $label }» contém o carácter «{ $character }», que não existe na codificação do ficheiro.
diag-label-of-another-language = «{ $label }» é uma designação noutro idioma ({ $language }); no idioma do programa, { $parameter } é «{ $right }».
diag-label-of-another-parameter = «{ $label }» é a designação de { $other }, não de { $parameter }.
diag-label-twice = { $parameter } e { $other } têm ambos a designação «{ $label }», que só pode estar certa num deles.
diag-label-undefined = Nenhuma frase define o label { $label }.
diag-labels-of-unknown-language =
    { $count ->
        [one] As designações desta definição estão num idioma que o Ciklo não conhece; foi lida pelos números dos parâmetros.
       *[other] As designações de { $count } definições, das quais esta é a primeira, estão num idioma que o Ciklo não conhece; foram lidas pelos números dos parâmetros.
    }
diag-languages-mixed = A maioria das designações está num idioma ({ $language }); as definições nestas linhas estão noutro ({ $others }): { $lines }.
diag-loop-endless =
    { $what ->
        [counter] Este salto espera por { $parameter }, mas na repetição nada o conta.
       *[jump] Este salto fecha uma repetição que nunca acaba.
    }
diag-machine-coordinates-compensated = Programam-se aqui coordenadas da máquina (M91, M92) com correção de raio.
diag-machine-coordinates-missing = Noutro lugar o programa recua para { $value } com M91; aqui falta M91, e a altura conta a partir do ponto zero da peça.
diag-main-runs-into-subprogram = O programa principal continua aqui para dentro do subprograma { $label }: nem M2 nem M30 o termina.
diag-measuring-height-above-surface = A altura de medição { $value } fica acima da peça, que termina em { $other }.
diag-measuring-height-below-floor = { $cycle } mede em { $parameter }={ $value }, abaixo do fundo em { $floor } que { $milling } aí deixa.
diag-metric-values-in-inch = O programa está em polegadas, mas { $value } parece estar em milímetros.
diag-mirror-of-tool-axis = O eixo da ferramenta { $axis } não pode ser espelhado.
diag-misordered-parameter = Em { $cycle }, o comando mostra { $parameter } antes de { $before }.
diag-missing-parameter =
    { $count ->
        [one] Em { $cycle } falta { $parameter }.
       *[other] Em { $cycle } faltam { $parameter }.
    }
diag-modal-call-left-on =
    M89 ainda chama o ciclo nesta frase, { $what ->
        [beside] que leva a uma posição fora do bloco
       *[again] pelo que a última posição é maquinada de novo
    }.
diag-mode-wrong =
    { $what ->
        [milling] { $cycle } fresa ou fura, mas aqui o comando está em modo de torneamento (FUNCTION MODE TURN).
        [turning] { $cycle } torneia, mas aqui o comando não está em modo de torneamento (FUNCTION MODE TURN).
       *[data] { $cycle } é utilizado fora do modo de torneamento.
    }
diag-name-of-another-cycle = «{ $name }» é o nome de { $other }, mas aqui está { $cycle }.
diag-no-result =
    Esta fórmula não tem resultado: { $why ->
        [division] divide por zero
        [large] o número é demasiado grande
       *[domain] uma função não está definida para o seu valor
    }.
diag-no-table-open = FN 27 e FN 28 precisam de uma tabela que FN 26 tenha aberto.
diag-nominal-differs = O diâmetro nominal é aqui { $value }, e a caixa neste ponto tem { $other } de largura.
diag-not-a-program = Este ficheiro não é um programa NC.
diag-nothing-left = O furo já tem aqui { $other } de largura: uma ferramenta de { $value } não remove nada.
diag-number-does-not-exist = { $name } não existe: o número maior é { $greatest }.
diag-older-parameter-set = { $cycle } tem os parâmetros de uma versão de software anterior; o comando acrescenta { $parameter }.
diag-out-of-range =
    { $side ->
        [below] { $parameter }={ $value } é demasiado pequeno: o valor mínimo é { $limit }.
        [long] O texto de { $parameter } é demasiado longo: são permitidos no máximo { $limit } caracteres.
        [many] { $parameter } indica labels a mais: são permitidos no máximo { $limit }.
        [axes] { $parameter } indica eixos a mais: são permitidos no máximo { $limit }.
       *[above] { $parameter }={ $value } é demasiado grande: o valor máximo é { $limit }.
    }
diag-out-of-usual-range =
    { $parameter }={ $value } dificilmente é intencional: { $where ->
        [control] o { $control } não aceita aí valores { $side ->
                [below] inferiores a
               *[above] superiores a
            } { $limit }.
       *[any] nenhum manual permite que um parâmetro destes tenha valores { $side ->
                [below] inferiores a
               *[above] superiores a
            } { $limit }.
    }
diag-parameter-of-later-software = { $parameter } em { $cycle } exige uma versão de software posterior à { $software }, que o manual descreve.
diag-parameter-unassigned =
    { $parameter } é lido aqui, mas nada lhe atribuiu um valor.
diag-path-twice =
    { $what ->
        [repeated] A ferramenta faz este percurso pela terceira vez: não fica nada para remover.
        [air] Com esta conversão o percurso a partir daqui não retira nada, embora as mesmas frases tenham cortado com outra.
        [copied] O contorno a partir daqui já foi maquinado com esta ferramenta noutras frases, embora a ferramenta tenha sido posicionada noutro lugar.
       *[transformed] Todo o percurso a partir daqui já foi maquinado com esta ferramenta com outra conversão.
    }
diag-path-not-closed = Este subprograma não volta ao seu início, embora seja chamado de novo no mesmo sítio: o passo é { $value }, e { $other } fecharia o percurso.
diag-pattern-combination =
    { $what ->
        [value] { $cycle } não pode chamar { $called } com { $value }.
       *[cycle] { $cycle } não pode chamar { $called }.
    }
diag-pattern-wrong =
    { $what ->
        [count] { $word } tem de ser um número inteiro de posições, pelo menos 1.
        [many] { $word }: PATTERN DEF pode ter no máximo nove posições isoladas.
        [rapid] { $word } não é permitido aqui: entre os pontos de uma tabela a ferramenta desloca-se com um avanço.
        [distance] { $word } é 0: todas as posições são a mesma.
        [angle] { $word } é mais do que uma volta completa.
        [same] { $word } repete uma posição anterior.
       *[diameter] O diâmetro { $word } de um círculo teórico tem de ser maior do que 0.
    }
diag-pilot-hole-too-shallow =
    { $what ->
        [bored] A ferramenta torneia no interior até { $value }, e o furo feito termina em { $other }.
       *[start] O ponto de partida aprofundado está em { $value }, e o furo existente termina em { $other }.
    }
diag-pilot-hole-elsewhere = No furo em { $value }; { $other } nada mais é feito, e uma caixa começa em material maciço no ponto com as duas coordenadas trocadas.
diag-plane-incomplete = Neste PLANE falta { $word }.
diag-plane-not-positioned =
    { $what ->
        [cycle] Nenhuma frase posiciona os eixos rotativos depois desta inclinação; se o ciclo o faz depende da máquina.
        [reset] PLANE RESET com STAY deixa os eixos rotativos rodados, e a maquinação continua antes de uma frase os fazer voltar.
       *[plane] STAY não move os eixos rotativos, e nenhuma frase do programa os leva para os ângulos deste plano.
    }
diag-plane-not-reset =
    { $what ->
        [zero] { $cycle } coloca aqui todos os ângulos a 0, mas nada desliga a inclinação do plano de maquinação.
       *[tilted] O programa termina aqui com o plano de maquinação inclinado.
    }
diag-plunge-too-fast =
    { $what ->
        [sideways] A ferramenta atravessa aqui material maciço com { $value } vezes o avanço da sua chamada.
        [tenfold] A ferramenta atravessa aqui material maciço com { $value } vezes o avanço dos seus outros cortes.
        [turn] A ferramenta fresa aqui { $value } por rotação, muito mais do que suporta uma ferramenta do seu diâmetro.
       *[plunge] A ferramenta penetra aqui no material { $value } por rotação.
    }
diag-position-after-contour = Esta é a primeira posição depois de { $cycle }, mas não tem valores absolutos para ambas as coordenadas do plano.
diag-position-missing = A ferramenta desce até { $value } antes de o programa a ter posicionado no plano.
diag-position-twice =
    { $what ->
        [definition] A definição é, palavra por palavra, a que foi chamada antes, e desde então a ferramenta não se deslocou: não fica nada para maquinar.
       *[place] O ponto { $value }; { $other } já foi maquinado com esta definição e esta ferramenta.
    }
diag-probe-while-turning = { $cycle } apalpa aqui com o cabeçote a rodar.
diag-probed-axis-missing = Apalpa-se na direção { $direction }, mas a posição não tem { $axis }.
diag-program-begin-missing = O programa não começa com BEGIN PGM.
diag-program-begin-twice = BEGIN PGM está aqui pela segunda vez.
diag-program-calls-itself = O programa chama-se a si próprio: { $name }.
diag-program-empty = O ficheiro não contém frases.
diag-program-end-missing =
    O programa acaba aqui sem { $end ->
        [iso] uma frase final que comece por %
       *[pgm] END PGM
    }.
diag-programs-call-in-circle = O programa { $name } chama, por sua vez, este programa, diretamente ou através de outros.
diag-rapid-into-blank = A ferramenta entra aqui no bloco em avanço rápido: vai para Z { $value }, e o topo do bloco está em { $top }.
diag-rapid-through-material = A ferramenta atravessa aqui até { $value }{"\u00A0"}mm de material em avanço rápido.
diag-reaming-wrong =
    { $what ->
        [none] Não há aqui nenhum furo para alargar.
        [deep] O alargador desce até { $value }, e o furo só até { $other }.
        [bored] A barra de mandrilar desce até { $value }, e o furo só até { $other }.
        [stock] O furo tem { $other } de largura: uma barra de mandrilar de { $value } não pode remover tanto.
       *[allowance] O furo tem { $other } de largura: para um alargador de { $value } sobra material a mais.
    }
diag-repeat-count-wrong = O número de repetições tem de ser um número inteiro de 0 a 65534.
diag-repeat-of-later-label = O label { $label } tem de vir antes da repetição, não depois dela.
diag-repeated-infeed =
    { $what ->
        [absolute] A conversão na parte repetida é absoluta: a partir da segunda passagem faz sempre o mesmo.
        [deep] As repetições descem até { $value }, muito abaixo do bloco.
       *[same] Cada repetição volta a { $value } e faz o mesmo que a primeira passagem.
    }
diag-reserved-parameter =
    { $parameter } é escrito aqui, mas Q100 a Q199 pertencem ao comando, que escreve por cima deles.
diag-reset-order-wrong =
    { $what ->
        [tilt] A inclinação é anulada aqui, mas ainda está ativa uma rotação que foi ativada depois dela.
       *[shift] A deslocação do ponto zero é anulada aqui, mas ainda está inclinado o plano que foi inclinado depois dela.
    }
diag-retract-missing =
    { $what ->
        [change] A ferramenta ainda está em { $value }, dentro do bloco, ao lado ou logo acima dele, quando é trocada: não foi recuada.
        [tilt] A ferramenta ainda está em { $value }, dentro do bloco, ao lado ou logo acima dele, quando o plano é inclinado com MOVE: não foi recuada.
        [end] A ferramenta ainda está em { $value }, dentro do bloco, ao lado ou logo acima dele, quando o programa termina: não foi recuada.
        [others] Os eixos rodam aqui depois de um recuo só até { $value }; antes de todas as outras rotações a ferramenta recua mais.
        [unretracted] Os eixos rodam aqui embora a ferramenta não tenha recuado depois de maquinar; antes de todas as outras rotações recua.
        [rapid] A ferramenta ainda está em { $value }, dentro do bloco, ao lado ou logo acima dele, quando continua em avanço rápido, ao contrário do que faz depois das outras passagens da superfície: não foi recuada.
       *[turn] A ferramenta ainda está em { $value }, dentro do bloco, ao lado ou logo acima dele, quando um eixo rotativo se move em avanço rápido: não foi recuada.
    }
diag-rotary-axis-jumps = O eixo rotativo oscila aqui de { $other } para { $value } e volta no bloco seguinte.
diag-row-not-in-table =
    { $table ->
        [preset] A tabela de presets não tem a linha { $row }.
       *[datum] A tabela de pontos zero não tem a linha { $row }.
    }
diag-program-not-selected = Chama-se aqui um programa selecionado, mas nenhum foi selecionado.
diag-shift-in-tilted-plane = O ponto zero é deslocado no plano inclinado para { $parameter }, que foi medido no plano não inclinado.
diag-speed-missing = O cabeçote é ligado aqui, mas não foram programadas rotações para esta ferramenta.
diag-speed-out-of-range =
    { $what ->
        [feed] O avanço { $value }
       *[speed] O número de rotações { $value } do cabeçote
    } dificilmente é intencional: { $side ->
        [below] é negativo
       *[above] os manuais permitem no máximo { $limit }
    }.
diag-stepover-too-wide = As linhas distam { $value }, e a ferramenta tem apenas { $other } de largura: ficam nervuras entre elas.
diag-spindle-direction = { $cycle } precisa de um cabeçote que rode no sentido horário, mas aqui roda no sentido anti-horário.
diag-spindle-off = A ferramenta corta aqui com o cabeçote parado.
diag-sql-handle-missing =
    { $what ->
        [ended] COMMIT ou ROLLBACK já terminou a transação com o handle { $handle }.
       *[missing] Nenhuma consulta devolveu o handle { $handle }.
    }
diag-subprogram-end-without-label = Este LBL 0 não termina nenhum subprograma.
diag-subprogram-recursive = O subprograma { $label } chama-se aqui a si próprio.
diag-subprogram-runs-on = O subprograma { $label } continua para dentro do subprograma { $next }: entre eles não há LBL 0.
diag-subprogram-without-end = O subprograma { $label } continua até ao fim do programa sem LBL 0.
diag-tcpm-left-on =
    { $what ->
        [tool] Chama-se aqui uma ferramenta com M128 ou FUNCTION TCPM ativa.
       *[end] O programa termina aqui com M128 ou FUNCTION TCPM ativa.
    }
diag-text-for-number =
    { $what ->
        [text] { $parameter } aceita um número, mas isto é um texto.
        [number] { $parameter } aceita um texto, mas isto é um número.
       *[calculation] Não se pode calcular com textos.
    }
diag-text-wrong =
    { $what ->
        [empty] O texto de { $parameter } está vazio.
        [alone] «{ $found }» no texto de { $parameter } não está escrito em dobro nem seguido de uma letra.
       *[character] O carácter «{ $found }» não é permitido em { $parameter }.
    }
diag-thread-pitch-unusual = Um passo de { $value } não é normalizado para uma rosca com o diâmetro { $other }.
diag-tool-axis-missing = Esta chamada da ferramenta não tem eixo da ferramenta, e nenhuma anterior o indicou.
diag-tool-axis-other =
    { $what ->
        [pattern] PATTERN DEF só funciona com o eixo da ferramenta { $axis }, mas aqui está ativo outro.
        [lifted] Esta chamada indica um eixo da ferramenta diferente do eixo do bloco, mas a ferramenta só é recuada em { $axis }.
       *[blank] O bloco tem o eixo da ferramenta { $axis }, mas nenhuma ferramenta do programa o tem.
    }
diag-tool-cuts-sideways = Uma broca, um macho ou um alargador move-se aqui lateralmente no material.
diag-tool-definition-wrong =
    { $what ->
        [zero] A ferramenta 0 significa nenhuma ferramenta e não pode ser definida.
        [twice] A ferramenta { $tool } já foi definida com outras medidas.
       *[after-call] A ferramenta { $tool } é definida aqui, mas já antes foi chamada.
    }
diag-tool-feed-missing = Utiliza-se aqui o avanço da chamada da ferramenta, mas esta não tem nenhum.
diag-tool-missing = Aqui um ciclo faz movimentos, mas nenhuma chamada da ferramenta definiu o eixo da ferramenta.
diag-tool-not-changed = { $cycle } é chamado com a ferramenta já usada para { $before }: precisa de outra ferramenta.
diag-tool-not-listed = A tabela de ferramentas não tem a ferramenta { $tool }.
diag-tool-radius-outdated = Isto é calculado com o raio da ferramenta anterior (Q108) e só é lido depois da chamada de outra ferramenta.
diag-turning-start-wrong =
    { $what ->
        [positive] O ciclo de torneamento não começa onde a ferramenta está: o contorno vai para Z positivo, afastando-se da peça.
        [z] O ciclo de torneamento não começa onde a ferramenta está: em Z, a ferramenta está além do fim do contorno.
        [bar] Aqui uma ferramenta para interiores torneia no exterior: o ciclo deduz o lado da posição da ferramenta.
        [outer] Aqui uma ferramenta para exteriores torneia no interior: o ciclo deduz o lado da posição da ferramenta.
        [inwards] Esta ferramenta torneou antes no exterior e aqui torneia no interior: o ciclo deduz o lado da posição da ferramenta.
        [outwards] Esta ferramenta torneou antes no interior e aqui torneia no exterior: o ciclo deduz o lado da posição da ferramenta.
        [start] O torneamento interior começa no diâmetro { $value }, e o furo só tem { $other } de largura: a ferramenta entra em material maciço.
        [thick] A barra tem { $value } de largura, e o furo só { $other }.
       *[diameter] O ciclo de torneamento não começa onde a ferramenta está: a ferramenta está além do diâmetro final do contorno.
    }
diag-uncalculable-contour =
    O comando não consegue calcular aqui o contorno: { $what ->
        [open] faltam dados que determinam este elemento
        [contradicts] os dados deste elemento contradizem-se
        [several] vários elementos correspondem aos dados e nenhum está selecionado
        [rounding] o arredondamento ou o chanfre não cabe entre os seus elementos
        [crossing] o contorno cruza-se a si próprio
       *[approach] não é possível aproximar-se assim do contorno
    }.
diag-value-unlike-others =
    { $what ->
        [feed] O avanço é aqui { $value }, e { $other } na chamada da ferramenta.
        [sign] A altura é aqui { $value }, entre outras mais baixas no mesmo percurso; { $other } seria coerente.
        [depth] A profundidade é aqui { $value }; nos outros ciclos do programa as profundidades são negativas.
        [path] A coordenada é aqui { $value }, longe dos pontos vizinhos no mesmo percurso; { $other } seria coerente.
        [angle] O ângulo é aqui { $value }; { $other } seria coerente com os passos dos outros ângulos.
       *[others] O valor é aqui { $value }, e { $other } em todos os outros sítios deste tipo.
    }
diag-wall-left = O contorno aberto deixa uma parede com { $value } mm de largura na borda do bloco: RL e RR podem estar trocados.
diag-wrong-tool-type =
    { $what ->
        [probe] { $cycle } apalpa aqui com a ferramenta que acabou de maquinar.
        [measured] { $cycle } mede aqui a ferramenta que acabou de apalpar.
        [contour] A ferramenta que acabou de apalpar move-se aqui ao longo de um contorno.
        [named] { $cycle } mede aqui um apalpador, se o nome da ferramenta estiver certo.
        [calibrates] { $cycle } calibra aqui o apalpador de ferramentas com uma ferramenta que corta.
       *[mill] { $cycle } maquina aqui com a ferramenta que acabou de apalpar.
    }
diag-tool-unused = A ferramenta { $tool } é chamada aqui, e a frase seguinte chama outra.
diag-tool-zero = { $cycle } é executado com a ferramenta 0: não há ferramenta no cabeçote.
diag-transfer-parameter-overwritten =
    { $what ->
        [passed] { $cycle } leu { $parameter } ao ser definido: o valor escrito aqui não influi na sua chamada.
        [filled] { $cycle } preenche quatro parâmetros, a começar pelo que aqui se indica, e escreve por cima de { $parameter }, que o programa escreveu antes e lê mais adiante.
        [lost] { $cycle } escreve por cima de { $parameter } antes de o programa ler o valor escrito aqui.
        [result] { $parameter } é copiado duas vezes depois de uma só medição: o resultado da medição anterior foi substituído sem ter sido lido.
       *[call] { $parameter } pertence a { $cycle }, que é chamado mais adiante: a chamada utiliza o valor escrito aqui.
    }
diag-transformation-forbidden =
    { $cycle } é utilizado embora { $what ->
        [datum-shift] esteja ativa uma deslocação do ponto zero
        [rotation] esteja ativa uma rotação
        [tcpm] esteja ativa M128 ou FUNCTION TCPM
        [other-axis] o eixo da ferramenta não seja Z
        [turning] o comando esteja em modo de torneamento (FUNCTION MODE TURN)
       *[tilting] o plano de maquinação esteja inclinado
    }, o que o seu manual proíbe.
diag-transformation-without-effect =
    { $what ->
        [again] { $cycle } define a conversão que já está ativa, e o mesmo subprograma é chamado outra vez.
       *[ended] { $other } anula a conversão de { $cycle } antes de alguma coisa a utilizar.
    }
diag-transformation-left-on =
    O programa termina aqui com { $what ->
        [datum-shift] uma deslocação do ponto zero ativa
        [rotation] uma rotação ativa
        [mirroring] um espelhamento ativo
       *[scaling] um fator de escala ativo
    }.
diag-feed-unit =
    { $what ->
        [revolution] Aqui { $parameter }={ $value } é um avanço por rotação, porque M136 está ativa.
        [revolving] Aqui { $parameter }{ $value } é um avanço por rotação, porque M136 está ativa.
        [large] Aqui { $parameter }={ $value } é um avanço por rotação, demasiado grande para o torneamento.
        [moving] Aqui { $parameter }{ $value } é um avanço por minuto, porque M136 não está ativa.
       *[minute] Aqui { $parameter }={ $value } é um avanço por minuto, porque M136 não está ativa.
    }
diag-turning-system-missing = { $cycle } é chamado aqui, mas { $aligning } não foi definido desde a chamada da ferramenta.
diag-cutting-speed-unlimited = A velocidade de corte é constante e a velocidade de rotação não está limitada, mas na linha { $line } a ferramenta chega ao eixo de rotação.
diag-two-signs = Antes do número há dois sinais; são lidos como { $right }.
diag-unknown-cycle =
    { $name ->
        [none] Nenhum manual que o Ciklo conhece menciona { $cycle }.
       *[other] { $cycle } ({ $name }) é um ciclo dos primeiros comandos: ainda é executado, mas os seus valores não são verificados.
    }
diag-unknown-parameter = Neste comando, { $cycle } não tem o parâmetro { $parameter }.
diag-differs-from-other-control =
    { $what ->
        [missing] { $cycle } tem { $parameter } no { $control }, mas aqui falta.
        [value] O { $control } não aceita { $parameter }={ $value } em { $cycle }.
        [twice] { $parameter } está indicado duas vezes em { $cycle }.
        [foreign] { $cycle } não tem { $parameter } no { $control }.
        [order] { $parameter } vem depois de { $before }, mas em { $cycle } no { $control } vem antes.
        [label] «{ $label }» pertence a { $other } em { $cycle } no { $control }, não a { $parameter }.
        [doubt] { $cycle } é duvidoso: { $message }
        [alone] Nenhum ciclo com este parâmetro aceita { $parameter }={ $value }, como em { $cycle }.
       *[guard] O { $control } recusaria { $cycle }: { $message }
    }
diag-unreachable =
    { $part ->
        [label] Nada conduz a este label.
       *[block] Esta frase nunca é executada.
    }
diag-meaningless-value = O valor { $value } não é possível aqui.
diag-word-missing = Nesta frase falta { $word }.
diag-word-twice = { $word } está duas vezes nesta frase.
diag-word-wrong =
    { $what ->
        [below] { $word } é { $value }: demasiado pequeno.
        [above] { $word } é { $value }: demasiado grande.
        [whole] { $word } é { $value }, mas tem de ser um número inteiro.
        [offers] A seguir a { $word } tem de vir uma destas palavras: { $value }.
        [contradict] { $word } e { $value } excluem-se mutuamente.
        [zero] { $word } não podem ser todos 0.
        [not-below] { $word } tem de ser menor do que { $value }.
        [operator] Está escrito «{ $word }» em vez de { $value }.
        [empty] O nome está vazio.
        [value] { $word } não tem valor.
        [place] { $word } não é permitido nesta frase.
        [line] Os três pontos estão numa só reta e não determinam nenhum plano.
        [parallel] Os dois vetores são paralelos e não determinam nenhum plano.
        [number] O texto de { $word } não é um número: «{ $value }».
        [beyond] { $word } é { $value }, para lá do fim do texto.
        [file] { $value } não é um ficheiro { $word }.
        [shorter] { $word } é { $value }: o comando considera a ferramenta mais curta nessa medida, e tudo fica mais fundo na mesma medida.
        [askew] O vetor base e o vetor normal têm de ser perpendiculares entre si.
       *[tool] { $value } não é um número de ferramenta: depois do ponto só pode haver um algarismo.
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
diag-coolant-forgotten = Esta ferramenta corta sem refrigerante; todas as outras ferramentas do programa ligam-no.
diag-comment-contradicts =
    { $what ->
        [digits] O valor é aqui { $value }, e { $other } no comentário: dois algarismos estão trocados.
        [result] O resultado é { $value }, e não { $other } como diz o comentário.
        [scale] O fator de escala { $value } não corresponde aos { $other } por cento do comentário.
        [parameter] Aqui é lido { $value }, e o comentário acima indica { $other }.
       *[holes] Depois desta chamada de ferramenta são feitos { $value } furos, e o comentário diz { $other }.
    }
diag-decimal-comma = Este valor tem vírgula decimal, outros valores do programa têm ponto decimal.
diag-definitions-differ =
    { $what ->
        [deep] A penetração { $value } corta de uma vez toda a profundidade { $other }, que é maior do que o diâmetro da ferramenta.
        [infeed] A penetração é aqui { $value }, e { $other } na outra definição da mesma caixa ou ranhura.
        [operation] As duas definições desta caixa ou ranhura só desbastam: a medida excedente de { $other } fica.
        [turned] O valor é aqui { $value }, e { $other } na definição que desbasta o mesmo contorno torneado.
       *[size] O valor é aqui { $value }, e { $other } na definição que desbasta a mesma caixa ou ranhura.
    }
diag-helix-too-steep =
    { $what ->
        [up] A hélice sobe { $value }, embora se siga um círculo completo como no fundo: o seu sinal está errado.
        [pitch] A hélice tem um passo de { $value }, mas a fresa de roscar tem { $other }.
        [left] Esta hélice corta uma rosca à esquerda; nem a ferramenta nem um comentário o indicam.
       *[steep] A hélice desce { $value } numa volta; mais de { $other } nenhuma ferramenta corta aqui.
    }
diag-holes-differ =
    { $what ->
        [stray] O furo em { $value }; { $other } não foi centrado, e um lugar centrado está sem furo.
        [untapped] O furo prévio em { $value }; { $other } não é roscado, mas outros da mesma série são.
        [unreamed] O furo em { $value }; { $other } não é alargado, mas outros da mesma série são.
        [uncentred] O furo em { $value }; { $other } não foi centrado, mas todos os outros da mesma série foram.
        [unused] O lugar { $value }; { $other } foi centrado e fica sem furo, ao contrário de todos os outros da mesma série.
        [gap] No círculo de furos falta o furo em { $value }; { $other }.
        [corner] Este furo não está no canto { $value }; { $other } do retângulo que os outros três formam.
        [passed] A ferramenta para em { $value }; { $other } e não faz lá nada; as frases antes e depois chamam o ciclo.
        [rotation] A ferramenta maquina aqui em { $value } de { $other } ângulos iguais de uma volta completa: falta um.
       *[arc] O centro falha o furo em { $value }; { $other }; os outros arcos estão à volta de furos.
    }
diag-probing-place-wrong =
    { $what ->
        [angle] Um furo é medido a { $value } graus, mas a figura não faz aí nenhum.
        [apart] O segundo furo está só a { $value } do primeiro, cujo diâmetro é { $other }.
        [side] Aqui é apalpado um lado de { $value }, e o bloco tem aí { $other } de largura: o apalpador desce sobre ele.
        [centre] Neste centro nada foi maquinado, mas em { $value }; { $other } foi.
        [corner] O canto é apalpado no lado do bloco oposto ao ponto de referência { $value }.
        [size] Aqui apalpa-se uma medida de { $value }, mas o bloco só tem { $other } de largura.
        [axis] Mede-se o eixo em que o lugar está a { $value }, mas a medida máxima é { $other }: os limites são os de outro eixo.
        [later] Aqui apalpa-se um diâmetro de { $value }, e mais tarde no mesmo centro um de { $other }: o apalpador desce ao lado do furo.
        [removed] A superfície a { $value } que aqui se apalpa já foi fresada até { $other }.
        [across] Neste eixo apalpa-se uma largura de { $value }, mas o que aqui foi fresado tem { $other } ao longo dele: está disposto no outro sentido.
       *[outside] O lugar { $value }; { $other } fica ao lado do bloco: não há lá nada para apalpar.
    }
diag-rough-out-tool-other =
    { $what ->
        [pilot] Aqui é indicada a ferramenta { $value }, mas quem desbasta é a ferramenta { $other }.
       *[coarse] A ferramenta { $value } não desbastou antes; quem desbastou foi a ferramenta { $other }.
    }
diag-speed-and-feed-exchanged = A ferramenta é chamada com { $value } rotações e um avanço de { $other }: os dois valores parecem trocados.
diag-stud-in-solid = A medida em bruto { $value } é muito menor do que o bloco à volta da ilha, que tem aqui a largura { $other }.
diag-surface-wrong =
    { $what ->
        [unlike] A superfície está em { $value }, a dos outros ciclos nestas posições em { $other }, e nada foi maquinado antes a essa profundidade.
        [opposite] A superfície em { $value } está acima do bloco; outras maquinações começam ou terminam em { $other }.
        [pattern] A superfície do padrão está em { $value }, a do ciclo que ele chama em { $other }: vale a do padrão.
        [air] O ciclo trabalha aqui no ar: desce até { $value }, onde já tudo foi fresado antes.
        [high] O ciclo parte de onde é chamado, em { $value }: a sua superfície fica então em { $other }, acima do bloco.
        [low] O ciclo é chamado dentro do bloco, em { $value }, e nada foi maquinado até à sua superfície em { $other }.
        [below] O ciclo desce em marcha rápida até { $value }, mas aqui os outros só chegaram a { $other }: entra no material.
        [cylinder] O cilindro tem o raio { $value }, mas o bloco à volta do seu eixo tem { $other }.
       *[faced] A superfície está em { $value }, mas a face foi fresada até { $other }.
    }
diag-turned-thread-wrong =
    { $what ->
        [pitch] O passo { $value } é demasiado grande para uma rosca com o diâmetro { $other }.
        [tool] A rosca tem o passo { $value }, mas a ferramenta é feita para { $other }.
        [end] A rosca vai até { $value }, para lá do fim do seu cilindro em { $other }.
        [groove] A rosca vai até { $value }, para lá do recesso que acaba em { $other }.
        [inside] No diâmetro { $value }, torneado por fora, é aberta uma rosca interior.
        [speed] A rosca é torneada com velocidade de corte constante (VCONST:ON): as rotações mudam de passagem para passagem.
       *[diameter] A rosca tem o diâmetro { $value }, mas ali foi torneado { $other }.
    }
diag-tilted-work =
    { $what ->
        [beside] No plano inclinado este ciclo não encontra o bloco em nenhum ponto.
       *[stands] O ciclo começa em { $value }, mas no plano inclinado o bloco chega aqui a { $other }.
    }
diag-circle-point-wrong =
    { $what ->
        [angle] { $parameter } é calculado com o ângulo { $value } e { $other } com { $angle }: as duas coordenadas de um ponto num círculo têm o mesmo ângulo.
       *[function] { $parameter } e { $other } são calculados ambos com { $value } do mesmo ângulo: um ponto num círculo tem numa coordenada o seno e na outra o cosseno.
    }
diag-formula-wrong =
    { $what ->
        [square] { $parameter } é uma soma ou diferença de quadrados e é usado como comprimento: falta a raiz quadrada.
       *[radius] { $parameter } é calculado com o outro sinal do raio da ferramenta Q108 do que antes da chamada anterior: a ferramenta está do outro lado da mesma medida.
    }
diag-correction-wrong =
    { $what ->
        [side] { $parameter } é corrigido por { $other }, que é o desvio do outro lado.
        [actual] { $other } é o valor medido, não o seu desvio: da medida { $parameter } não fica quase nada.
        [radius] { $parameter } é o desvio de um diâmetro ou de uma largura e corrige o raio da ferramenta sem ser dividido por dois.
        [turned] O desvio { $parameter } corrige o raio da ferramenta com o sinal errado: o erro duplica.
       *[added] O desvio { $other } é somado à medida { $parameter }: tem de ser subtraído.
    }
diag-monitored-tool-idle =
    { $what ->
        [elsewhere] { $cycle } vigia ou corrige a ferramenta { $tool }, que não fresou o que é medido: foi a ferramenta { $other }.
       *[idle] { $cycle } vigia ou corrige a ferramenta { $tool }, que antes não foi chamada.
    }
