## Por que motivo uma execução termina antes do fim.

diag-angle-missing = Falta o ângulo PA do círculo.
diag-axis-limit = O eixo { $axis } iria para { NUMBER($found) } { $unit }, para lá dos limites da máquina de { NUMBER($min) } a { NUMBER($max) } { $unit }.
diag-block-limit = A execução foi terminada: foram executadas mais de { NUMBER($limit) } frases.
diag-block-unreadable = Não é possível ler a frase: { $found }
diag-call-depth-limit = As chamadas estão encadeadas em mais de { NUMBER($limit) } níveis.
related-called-here = chamado aqui
diag-collision = Colisão: a haste de apalpação toca na peça fora de um movimento de apalpação, em X { NUMBER($x) } Y { NUMBER($y) } Z { NUMBER($z) }.
diag-conform-no-value = O caso não indica um valor para { $name } e a especificação não tem valor de exemplo.
diag-conform-unknown-clause = O caso afirma provar { $name }, que { $cycle } não tem.
diag-cycle-depth-limit = Os ciclos estão encadeados em mais de { NUMBER($limit) } níveis.
diag-cycle-error = O ciclo é interrompido com o erro { $code }.
diag-cycle-unknown = Os manuais do comando { $control } não descrevem { $cycle }: não pode ser simulado.
diag-direction-contradicts = O sinal do ângulo incremental contradiz o sentido de rotação DR.
diag-direction-missing = Falta o sentido de rotação DR do círculo.
diag-direction-undefined = Os dois pontos distam apenas { NUMBER($distance) } mm: não determinam nenhuma direção.
diag-division-by-zero = Divisão por zero.
diag-elements-overlap = Os elementos em duas esquinas do contorno sobrepõem-se: juntos ocupam { NUMBER($least) } mm do lado que os separa, com { NUMBER($found) } mm de comprimento.
diag-end-off-circle = O ponto final não está no círculo: raio { NUMBER($start_radius, maximumFractionDigits: 4) } mm no início, { NUMBER($end_radius, maximumFractionDigits: 4) } mm no fim.
diag-feed-missing = Não está ativo nenhum avanço maior do que 0.
diag-field-missing = Falta o campo { $field } de { $cycle }.
diag-field-unknown = { $cycle } não tem este campo: { $found }
diag-fit-collinear = Os { NUMBER($points) } pontos de apalpação estão em linha reta: nenhum círculo se lhes ajusta.
diag-fit-failed = Nenhum círculo se ajusta aos { NUMBER($points) } pontos de apalpação.
diag-fit-too-few = Os pontos de apalpação são demasiado poucos para um círculo: { NUMBER($points) }.
diag-infeeds-never-reach-depth = Os passos nunca atingem a profundidade de { NUMBER($depth) } mm: o primeiro é de { NUMBER($first) } mm, cada um é { NUMBER($less) } mm menor, o mínimo é de { NUMBER($least) } mm; terminam em { NUMBER($reached) } mm.
diag-insert-askew = Os ciclos de torneamento não podem ser simulados enquanto a ferramenta está inclinada e M144, M128 ou FUNCTION TCPM está ativa.
diag-insert-direction = A pastilha da ferramenta { $tool } não aponta para a peça ou para a direção dos cortes: a sua orientação (TO) é { $orientation }.
diag-jump-limit = A execução foi terminada: foram executados mais de { NUMBER($limit) } saltos, repetições e chamadas.
diag-jump-target-missing = Não existe o label { $label }.
diag-jump-target-twice = O label { $label } aparece duas vezes no programa.
diag-kinematics-unknown = A cinemática «{ $name }» a seguir a FUNCTION MODE não é a da máquina simulada, «{ $machine }».
diag-lines-parallel = As duas retas são paralelas: não têm intersecção.
diag-log-failed = Não é possível escrever o registo { $name }: { $reason }
diag-log-template = O registo { $name } não tem modelo.
diag-log-text = Falta o texto { $name } do registo ({ $reason }).
diag-machine-parameter-missing = O parâmetro de máquina { $name }, com as suas três coordenadas, não está definido.
diag-milling-mode-missing = { $cycle } só é executado em modo de fresagem, mas está ativo o modo de torneamento (FUNCTION MODE TURN).
diag-move-limit = A execução foi terminada: foram executados mais de { NUMBER($limit) } movimentos da ferramenta.
diag-no-cycle-to-call = É chamado um ciclo, mas não foi definido nenhum ciclo de maquinação.
diag-no-such-parameter = Não existe o parâmetro { $q }.
diag-number-too-large = O resultado é demasiado grande para o formato numérico.
diag-orientation-missing = A correção de raio ao tornear precisa da orientação (TO) da ferramenta { $tool }: indica onde está a ponta em relação ao centro do raio.
diag-outside-domain = { $function } não está definido para { NUMBER($value) }.
diag-parameter-missing = Falta { $q } em { $cycle }.
diag-parameter-out-of-range = { $q } não aceita o valor { NUMBER($value) }.
diag-parameter-undefined = { $q } não tem valor.
diag-parameter-in-addition = { $q } em { $cycle } pertence a uma versão de software mais recente do que a aqui descrita; o seu efeito não é conhecido.
diag-parameter-unknown = { $cycle } não tem o parâmetro { $q }.
diag-plan-mistake = A especificação de { $cycle } tem um erro: { $reason }
diag-plane-through-line = Os três pontos estão em linha reta: não determinam nenhum plano.
diag-pole-missing = Não está definido nenhum centro do círculo nem polo (CC).
diag-probe-deflected = A haste de apalpação já está defletida antes de começar a apalpação.
diag-probe-measurements-differ = As medições do mesmo ponto diferem { NUMBER($found) } mm; a margem de confiança é de { NUMBER($range) } mm.
diag-probe-missing = Não há nenhum apalpador no cabeçote.
diag-probe-no-contact = O apalpador não toca em nada ao longo de { NUMBER($distance) } mm.
diag-probe-no-direction = A haste de apalpação já está no ponto a apalpar, e por isso não há direção de apalpação.
diag-program-missing = Não existe o programa { $name }.
diag-radius-missing = Falta o raio R nesta frase.
diag-radius-too-small = O raio de { NUMBER($radius) } mm não chega para uma corda de { NUMBER($chord, maximumFractionDigits: 4) } mm.
diag-recess-impossible = Não há espaço para a ranhura, falta o seu centro, a profundidade ou a largura, ou não está num elemento reto.
diag-recursive-call = Uma parte do programa chama-se a si própria.
diag-repeat-count = REP exige um número inteiro de 0 a 65534, não { NUMBER($found) }.
diag-rotary-axis-missing = A máquina não tem um eixo rotativo { $axis }.
diag-rotary-axis-unsuitable = O eixo rotativo { $axis } não roda no plano da inclinação e não a pode compensar.
diag-series-count = O número de repetições tem de ser um número inteiro e não negativo, e não { NUMBER($found) }.
diag-series-limit = O ciclo repetiria os seus passos mais de { NUMBER($limit) } vezes.
diag-strategy-argument = Falta um argumento de uma estratégia.
diag-text-or-number = Há texto onde se exige um número, ou vice-versa.
diag-text-too-long = Um parâmetro de texto ultrapassaria { NUMBER($limit) } caracteres.
diag-tool-locked = A ferramenta { $tool } está bloqueada.
diag-tool-not-in-table = A ferramenta { $tool } não está na tabela de ferramentas.
diag-turn-limit = A execução foi terminada: um movimento tem mais de { NUMBER($limit) } voltas.
diag-undercut-form = UDC { $form } não pode ser simulado: nenhum manual descreve a sua forma.
diag-undercut-impossible = Não há espaço para o rebaixo, falta uma medida, ou este não está entre uma superfície ao longo do eixo rotativo e uma face perpendicular a ela.
diag-unsupported-axis = A máquina simulada não tem um eixo { $axis }.
diag-unsupported-block = { $word } não pode ser simulado.
diag-unsupported-cycle = O manual do comando { $control } só menciona o nome de { $cycle }: não pode ser simulado.
diag-unsupported-feed = Este avanço numa chamada da ferramenta não pode ser simulado: { $word }
diag-unsupported-m = A função M { $word } não pode ser simulada.
diag-unsupported-path = { $word } não pode ser simulado nesta frase.
diag-unsupported-tcpm = Com TCPM ativo, o apalpador não está perpendicular ao plano de maquinação; { $cycle } não pode então ser simulado.
diag-unsupported-transformation = Não é possível simular movimentos enquanto está ativa esta conversão de coordenadas: { $name }
diag-value-missing = Falta um valor, ou não é um número.
diag-value-not-bound = Uma fórmula da especificação lê um valor que ainda não existe: { $place }
diag-word-not-offered = A palavra { $word } não é permitida aqui.
diag-arc-scaled-unequally = Os eixos do plano têm fatores de escala diferentes: um arco passaria a elipse.
diag-scaling-factor-zero = Um fator de escala tem de ser maior do que zero, e não { NUMBER($found) }.
diag-shaft-collision = A haste de apalpação, e não a esfera, toca na peça em X { NUMBER($x) } Y { NUMBER($y) } Z { NUMBER($z) }.
diag-shape-impossible = Esta ferramenta não consegue maquinar a forma: são necessários pelo menos { NUMBER($least) } mm, há { NUMBER($found) } mm.
diag-cutting-width-missing = A ferramenta { $tool } não é uma ferramenta de ranhurar: a largura de corte (CUTWIDTH) tem de ser superior a 0 e, no mínimo, o dobro do raio de corte (RS).
diag-m144-together = M144 não pode estar ativa juntamente com { $word }.
diag-spline-start = A spline começa a { NUMBER($distance, maximumFractionDigits: 4) } mm ou graus da posição atual; é permitido 0.001.
diag-tool-direction-unreachable = Os eixos rotativos da máquina não conseguem levar a ferramenta à direção que esta frase indica.
diag-tilting-unreachable = Os eixos rotativos da máquina não conseguem posicionar a ferramenta perpendicular a este plano.
diag-pattern-missing = { $name ->
        [none] Não está definida nenhuma figura nem tabela de pontos para a chamada do ciclo.
       *[other] Não existe a tabela de pontos «{ $name }».
    }
diag-pattern-too-long = PATTERN DEF aceita no máximo { $limit } posições escritas uma a uma; aqui há { $count }.
diag-pattern-tool-axis = As figuras só podem ser utilizadas com o eixo da ferramenta Z; o eixo da ferramenta ativo é { $axis }.
diag-pattern-unreadable = «{ $found }» não pode ser utilizado em PATTERN DEF.
diag-position-incomplete = CYCL CALL POS precisa das coordenadas dos três eixos.
diag-value-not-predefined = Está programado PREDEF, mas nenhum GLOBAL DEF definiu o valor.
diag-contour-crossing = O contorno do label { $label } cruza-se ou toca-se a si próprio no ponto com eixo principal { NUMBER($x) } mm e eixo secundário { NUMBER($y) } mm.
diag-contour-begin-incomplete = O contorno { $label } não começa com as duas coordenadas do plano de maquinação.
diag-contour-data-undefined = Nenhum ciclo definiu ainda os dados do contorno.
diag-contour-count = O contorno é formado por mais de { NUMBER($limit) } contornos parciais.
diag-contour-depth =
    { $what ->
        [first] Um contorno parcial é mais fundo do que o primeiro de CONTOUR DEF, que tem de ser a caixa mais funda.
       *[cycle] Um contorno parcial tem uma profundidade de { NUMBER($depth) } mm, maior do que a profundidade de fresagem dos dados do contorno.
    }
diag-contour-elements = Os contornos têm, no total, mais de { NUMBER($limit) } elementos.
diag-contour-empty = O subprograma do label { $label } não descreve nenhum contorno que delimite uma área.
diag-contour-lead = Um contorno que um ciclo maquina não pode conter { $word }: o próprio ciclo faz a aproximação e a saída.
diag-contour-not-defined = Nenhum ciclo indicou ainda os subprogramas do contorno.
diag-contour-open = O contorno do label { $label } está aberto: termina a { NUMBER($distance) } mm do ponto inicial.
diag-contour-side-missing = O contorno do label { $label } não tem correção de raio RL ou RR, que indica se se trata de uma caixa ou de uma ilha.
diag-contour-tool-axis = O contorno do label { $label } contém uma coordenada no eixo da ferramenta.
diag-free-contour-contradicts = Nenhum contorno cumpre todos os valores indicados para este elemento e para os anteriores.
diag-free-contour-open =
    { $what ->
        [line] A posição ou a direção desta reta não está determinada. Valores ainda em falta: { $values }.
        [arc] O centro ou o raio deste arco não está determinado. Valores ainda em falta: { $values }.
       *[end] O fim deste elemento não está determinado. Valores ainda em falta: { $values }.
    }
diag-free-contour-reference = A frase { $block } não é um elemento deste contorno livre nem a frase de posicionamento anterior.
diag-free-contour-selection = Não é possível selecionar FSELECT { $wanted }: o número de soluções aqui é { $solutions }.
diag-free-contour-several = A partir deste elemento o contorno livre tem várias soluções ({ $solutions }) e FSELECT não seleciona nenhuma.
diag-free-contour-word = { $word } não pode ser utilizado assim num contorno livre.
