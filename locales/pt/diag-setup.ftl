# Findings of the checker on tools, the spindle, presets and what the machine and the blank allow.
diag-approach-wrong =
    { $what ->
        [arc] O arco com o raio { $value } não cabe entre este ponto e o contorno.
        [left] A ferramenta sai do contorno ao longo do seu eixo, sem DEP.
       *[plunged] O contorno começa onde a ferramenta penetrou.
    }
diag-config-unknown-machine = Não há a definição da máquina «{ $key }»; há { $expected }.
diag-coordinate-out-of-range = A coordenada { $value } está fora do intervalo: { $limit } é o maior valor que os manuais permitem.
diag-labels-not-known =
    { $count ->
        [one] Um texto aqui tem a forma de uma designação, mas nenhum idioma o tem para este parâmetro: fica como está. --relabel substitui-o.
       *[other] A partir daqui, { $count } textos têm a forma de designações, mas nenhum idioma os tem para os seus parâmetros: ficam como estão. --relabel substitui-os.
    }
diag-machine-limit =
    { $what ->
        [speed] As rotações { $value } excedem { $limit }, o máximo da máquina.
        [feed] O avanço { $value } excede { $limit }, o máximo da máquina.
        [helix] A hélice de { $value } graus excede { $limit }, o máximo da máquina.
        [angle] { $word } { $value } está além de { $limit }, o fim de curso do eixo.
        [position] { $word } { $value } está além de { $limit }, o fim de curso do eixo.
       *[travel] O programa usa { $value } mm do eixo { $word }, que só tem { $limit } mm.
    }
diag-machining-outside-blank =
    { $what ->
        [across] O lado de { $value } fica atravessado na face fresada neste plano, que só tem { $other } de largura: rodado 90 graus caberia nela.
        [above] O ciclo não desce abaixo de { $value }, que fica acima do bloco: não remove nada.
        [below] A ferramenta corta à altura { $value }, muito abaixo do bloco.
        [over] O que é maquinado em { $value }; { $other } ultrapassa o bordo do bloco.
        [contour] O contorno é chamado em { $value }, acima do bloco, e noutro lugar dentro dele: aqui não remove nada.
        [curve] A curva começa e termina no bloco, mas pelo caminho sai dele em { $value }; { $other }.
        [corner] A posição da caixa conta aqui a partir de um canto, pelo que a partir de { $value }; { $other }, o meio do bloco, ultrapassa o bordo.
       *[outside] O que é maquinado em { $value }; { $other } está longe do bloco.
    }
diag-milling-deeper-than-edges = Aqui a ferramenta fresa a uma profundidade de { $value }, maior do que a longitude das suas navalhas (LCUTS).
diag-plane-left-on =
    { $what ->
        [axes] O plano foi anulado, mas os eixos rotativos não voltaram a zero: a ferramenta corta a peça inclinada.
       *[tool] O plano de maquinação ainda está inclinado quando esta ferramenta é chamada.
    }
diag-preset-row-wrong =
    { $what ->
        [again] O preset { $row } volta a ser escrito aqui, noutro ponto, e entretanto nada o ativou.
        [other] Aqui é ativado o preset { $other }, mas o que foi apalpado é o preset { $row }, que nunca é ativado.
        [datum] A linha { $row } da tabela de pontos zero é escrita aqui e nunca é ativada: a maquinação prossegue com outro ponto zero.
        [same] O preset { $row } já está ativo; aqui é ativado de novo, depois de o programa ter parado para o operador.
        [table] Aqui é escrita a linha { $row } da tabela de pontos zero, mas depois é ativado o preset { $row }, que nada escreveu.
       *[unused] O preset { $row } é escrito aqui e nunca é ativado: a maquinação prossegue com outro preset.
    }
diag-repeat-without-effect =
    { $what ->
        [same] O contorno é repetido à mesma profundidade { $value }: com passos incrementais desse valor atravessaria o bloco.
        [place] O movimento repetido leva a um ponto em coordenadas absolutas onde a ferramenta já está: as repetições não fazem nada.
        [jump] Este salto leva à frase que o segue de qualquer maneira: falta aquilo que devia saltar.
       *[zero] Uma repetição de zero vezes não tem efeito.
    }
diag-slot-too-narrow = A ferramenta com o diâmetro { $tool } não cabe aqui entre as paredes: esta reta só tem { $value } de comprimento.
diag-spindle-start-wrong =
    { $what ->
        [missing] O cabeçote não foi ligado desde a chamada desta ferramenta.
       *[direction] O cabeçote roda no sentido anti-horário (M4) enquanto esta ferramenta corta.
    }
diag-tap-without-hole =
    { $what ->
        [missing] Em { $value }; { $other } não foi feito nenhum furo para este macho.
        [floor] A rosca desce até { $value }, mas o fundo ao lado está em { $other }: a fresa de roscar entra no material maciço.
       *[shallow] O macho desce até { $value }, mas o furo termina em { $other }.
    }
diag-tcpm-missing = Aqui os eixos rotativos movem-se com os eixos lineares sem TCPM, embora o programa desative TCPM mais tarde.
diag-tool-called-twice = A ferramenta { $tool } volta a ser chamada aqui, sem nada entre as duas chamadas.
diag-tool-table-contradicts =
    { $what ->
        [speed] As rotações { $value } excedem { $other }, as rotações máximas da ferramenta { $tool } na tabela de ferramentas (NMAX).
        [locked] A ferramenta { $tool } está bloqueada na tabela de ferramentas (TL) e não há ferramenta gémea indicada (RT).
        [point] { $value } centra aqui até ao diâmetro, mas a ferramenta { $tool } não tem ângulo de ponta na tabela de ferramentas (T-ANGLE).
        [turning] { $value } não serve para a ferramenta { $tool }, que na tabela de ferramentas de tornear é do tipo { $other } (TYPE).
        [size] A ferramenta { $tool } tem na tabela de ferramentas o diâmetro { $other }, mas o nome diz { $value }.
        [oversize] A medida excedente { $value } (DR) não deixa nada do raio { $other } da ferramenta { $tool }.
        [left] O passo { $value } é o de uma rosca à esquerda, e nada diz que a ferramenta { $tool } seja um macho à esquerda.
        [length] A ferramenta { $tool } não tem comprimento na tabela de ferramentas (L), ao contrário das outras.
        [teeth] { $value } mede cada navalha, mas a ferramenta { $tool } não tem o número de navalhas na tabela de ferramentas (CUT).
        [large] A medida excedente { $value } (DR) é maior do que o raio { $other } da ferramenta { $tool }.
        [called] { $value } não serve para a ferramenta { $tool }, que se chama { $other }.
       *[type] { $value } não serve para a ferramenta { $tool }, que na tabela de ferramentas é do tipo { $other } (TYP).
    }
diag-translate-encoding = O ficheiro é escrito em { $encoding }: tem aí os mesmos bytes e existem todas as letras das novas designações.
diag-translate-encoding-unknown = Não existe a codificação «{ $encoding }»; existem { $known }.
diag-translate-encoding-wrong = { $path } não está em { $encoding }: alguns bytes não têm aí significado.
diag-translate-unread = { $cycle } tem uma linha que não pode ser lida, por isso o nome e as designações ficam como estão.
related-preset-written-here = escrito aqui
diag-character-unknown = O texto contém «{ $character }», que o tipo de letra não tem.
diag-allowance-left =
    { $what ->
        [order] Aqui o contorno é maquinado com a medida excedente { $value } (DR) e depois, com a mesma ferramenta, com a medida maior { $other }: nada resta para a segunda passagem.
        [below] O contorno do label { $label } é maquinado primeiro com a medida excedente negativa { $value }: não fica nada para a ferramenta que o maquina depois.
        [cycle] Também com esta ferramenta { $label } maquina o contorno com a medida excedente { $value }, que fica na peça.
       *[left] O contorno do label { $label } também é maquinado com esta ferramenta com a medida excedente { $value }: a medida excedente fica na peça.
    }
diag-contour-crossed =
    { $what ->
        [back] Este contorno fechado volta de uma esquina diretamente à anterior.
        [away] A ferramenta sai deste contorno fechado para o outro lado: no caminho corta o que acabou de terminar.
        [start] A aproximação a este contorno fechado é feita numa esquina interior: ali a ferramenta corta o último elemento.
        [short] Este contorno termina na sua primeira reta antes do início: o resto da reta fica por maquinar.
        [itself] Este contorno volta antes do fim a uma das suas próprias retas: a ferramenta corta o que acabou de terminar.
       *[side] Com esta correção de raio a ferramenta atravessa o contorno fechado: vem do outro lado dele.
    }
diag-contour-depths-differ =
    { $what ->
        [chamfer] O chanfro é cortado em { $value }, abaixo do fundo do contorno em { $other }.
        [deep] Aqui o contorno termina em { $value }, mas a ferramenta anterior cortou uma passada mais abaixo, até { $other }.
       *[shallow] Aqui o contorno é cortado numa passagem até { $value }, e a ferramenta anterior só desceu até { $other }.
    }
diag-error-branch-entered =
    { $what ->
        [turned] O salto por cima da paragem é executado quando { $parameter } indica um defeito.
        [implied] Este salto e o anterior levam ao mesmo label e comparam { $parameter } no mesmo sentido: um dos dois limites não tem efeito.
        [branch] A condição deste salto não se ajusta ao seu ramo: com este valor, { $parameter } significa algo diferente do label ou do comentário desse ramo.
        [good] Este salto para um ramo de defeitos é executado também quando está tudo bem: com este valor, { $parameter } não indica nenhum defeito.
        [unchecked] Aqui o ciclo mede a ferramenta de novo e não a compara com nada: { $parameter }, que é consultado depois, não indica defeitos.
        [greater] O salto para a mensagem de erro é sempre executado aqui: { $value } é maior do que { $other }.
        [less] O salto para a mensagem de erro é sempre executado aqui: { $value } é menor do que { $other }.
       *[entered] A execução chega a este ramo mesmo sem o salto, e para: nem M2 nem M30 terminam o programa antes dele.
    }
diag-finishing-before-roughing =
    { $what ->
        [pilot] { $other } indica a ferramenta que fura aqui; tem de indicar a que desbasta a seguir.
       *[order] { $cycle } faz aqui o acabamento do contorno, antes de { $other } o desbastar.
    }
diag-label-unused = Nada chama ou repete o label { $label } deste subprograma, e nenhum salto conduz a ele.
diag-loop-runs-once =
    { $what ->
        [again] A partir da segunda vez esta repetição só é executada uma vez: nada repõe o seu contador.
        [other] O contador desta repetição é calculado em cada passagem a partir de outro parâmetro: o número com que começa não tem efeito.
        [inner] A repetição interior também conta com { $parameter }, pelo que esta termina cedo demais ou nunca: este salto não conta as suas próprias passagens.
       *[never] Este salto para trás nunca é executado: o contador não cumpre a condição em nenhuma passagem.
    }
diag-parameter-unused =
    { $what ->
        [late] { $parameter } recebe aqui um valor que já nenhuma chamada lê: cada chamada tem os seus próprios valores, e a destes está antes deles.
       *[never] { $parameter } recebe aqui um valor, e nada o lê.
    }
diag-probing-direction-wrong =
    { $what ->
        [up] { $cycle } apalpa com { $value }, para cima ao longo do eixo da ferramenta: o apalpador viria de dentro da peça.
       *[edge] { $cycle } apalpa a aresta em { $axis } com a direção { $value }: a peça está no lado de onde vem o apalpador.
    }
diag-same-datum-twice =
    { $what ->
        [loop] A repetição conta, mas ativa a linha { $row } em todas as passagens: é maquinado sempre o mesmo.
        [turned] A mesa não foi rodada para a linha { $row }: está no ângulo de outro lado.
        [cycle] A linha { $row } é ativada de novo antes da mesma chamada de ciclo no mesmo sítio: o mesmo é maquinado duas vezes.
       *[again] A linha { $row } volta a ser ativada antes do mesmo subprograma: o mesmo é maquinado duas vezes.
    }
diag-selected-table-missing = A tabela { $name } não está na pasta do programa.
diag-turned-contour-wrong =
    { $what ->
        [above] O contorno termina em Z { $value }, acima do bloco, que termina em { $limit }.
        [narrow] A ranhura tem { $value } de largura, a ferramenta { $limit }.
        [side] A ranhura vai do diâmetro { $limit } a { $value }; noutro lugar a mesma ferramenta faz ranhuras na outra direção.
        [dip] O contorno desce ao diâmetro { $value }, abaixo do seu primeiro diâmetro { $limit }, e o ciclo não maquina rebaixos.
        [deep] A ranhura tem { $value } de profundidade, e a ferramenta só corta { $limit }.
        [ridge] A face sobe ao diâmetro { $value } e desce logo a { $limit }: fica uma aresta sem largura.
        [corner] Uma esquina do contorno fica em Z { $value }, para lá do fim do bloco em { $limit }, e o contorno volta de lá.
        [wall] Aqui a ferramenta corta a parede da peça de lado a lado: do outro lado o diâmetro é { $limit }.
        [air] O ciclo só torneia em vazio: chega ao diâmetro { $value }, e aí a peça tem o diâmetro { $limit }.
       *[rounding] Para o arredondamento { $value } a reta é demasiado curta; é possível no máximo { $limit }.
    }
diag-called-program-wants =
    { $name } lê { $parameter }, e nada lhe atribuiu um valor antes desta chamada.
diag-branch-runs-on =
    { $what ->
        [variant] O ramo termina aqui sem um salto e a execução continua no outro: nada leva ao label { $parameter } depois dele.
       *[values] O ramo termina aqui sem salto: o seguinte dá outros valores a { $parameter } antes de alguma coisa ler estes.
    }
diag-finishing-tool-too-wide = A medida excedente e o raio da ferramenta somam aqui { $value }; a soma tem de ser menor do que no desbaste, { $other }.
