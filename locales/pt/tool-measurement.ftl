# Cycles that measure the tool on a tool touch probe.

# --- parameters ---
parameter-tool-check = Medir a ferramenta=0 / verificar=1
    .label = VERIFICAR
    .word = VERIFICAR:
    .prompt = Medir a ferramenta=0 / verificar=1
    .help = Determina se se trata da primeira medição da ferramenta ou da verificação de uma ferramenta já medida. Na primeira medição, o comando substitui a longitude da ferramenta { $mp-tool-length } em TOOL.T, a memória central de ferramentas, e coloca a 0 o valor delta { $mp-delta-length }. A verificação compara a longitude medida com a longitude da ferramenta { $mp-tool-length }; o desvio, com o seu sinal, é introduzido como valor delta { $mp-delta-length } e está também disponível em Q115. Se for excedida a tolerância de desgaste ou de rotura admissível para a longitude, o comando bloqueia a ferramenta (estado L em TOOL.T).
choice-tool-first-measurement = medir a ferramenta pela primeira vez
choice-tool-check = verificar uma ferramenta já medida
parameter-tool-status-parameter = N.º do parâmetro para o resultado
    .prompt = Nº do Parâmetro para Resultado?
    .help = Número do parâmetro em que o comando guarda o estado da medição: 0,0: ferramenta dentro da tolerância; 1,0: ferramenta desgastada ({ $mp-wear-tolerance-length } excedido); 2,0: ferramenta partida ({ $mp-break-tolerance-length } excedido). Se o resultado não for utilizado no programa, responda à pergunta com a tecla NO ENT.
parameter-tool-clearance-height = Altura de segurança
    .label = ALTURA SEGURA
    .label-aliases = ALTURA SEGURANÇA
    .word = ALTURA:
    .prompt = Altura de segurança
    .help = Posição no eixo do cabeçote à qual a ferramenta não pode colidir com peças nem com dispositivos de fixação. Refere-se ao ponto de referência ativo da peça. Se, com o valor introduzido, a ponta da ferramenta ficar abaixo da aresta superior do prato, o comando posiciona automaticamente a ferramenta acima do prato (zona de segurança definida em { $mp-setter-safety-distance }).
parameter-tooth-measurement = Medição de navalhas 0=Não / 1=Sim
    .label = MEDIÇÃO DE NAVALHAS
    .label-aliases = MEDIÇÃO NAVALHAS
    .word = MEDIÇÃO DE NAVALHAS:
    .prompt = Medição de navalhas 0=Não / 1=Sim
    .help = Determina se as navalhas são medidas individualmente. Podem medir-se no máximo 20 navalhas.
parameter-tooth-measurement__itnc530 =
    .help = Determina se as navalhas são medidas individualmente. Podem medir-se no máximo 99 navalhas.
parameter-tooth-measurement__tnc426-430 =
    .help = Determina se as navalhas são medidas individualmente.
choice-no-tooth-measurement = não medir as navalhas individualmente
choice-tooth-measurement = medir as navalhas individualmente

# --- 31 and 481 ---
cycle-tool-length = Medir a longitude da ferramenta
    .nc = LONGITUDE DA FERRAMENTA
    .purpose = Mede ou verifica a longitude da ferramenta com o apalpador de ferramentas. O comando guarda o resultado na memória central de ferramentas TOOL.T e tem-no automaticamente em conta no fim do ciclo.
cycle-tool-length__tnc426-430 =
    .purpose = Mede ou verifica a longitude da ferramenta com o apalpador de ferramentas. O comando guarda o resultado na memória central de ferramentas TOOL.T e utiliza-o na chamada seguinte da ferramenta.
cycle-tool-length-old = Medir a longitude da ferramenta
    .nc = LONGITUDE DA FERRAMENTA
    .purpose = Mede ou verifica a longitude da ferramenta com o apalpador de ferramentas. O comando guarda o resultado na memória central de ferramentas TOOL.T e tem-no automaticamente em conta no fim do ciclo. Formato antigo do ciclo 481.
cycle-tool-length-old__tnc426-430 =
    .purpose = Mede ou verifica a longitude da ferramenta com o apalpador de ferramentas. O comando guarda o resultado na memória central de ferramentas TOOL.T e utiliza-o na chamada seguinte da ferramenta. Formato antigo do ciclo 481.
step-position-tool-over-setter = O comando posiciona a ferramenta à altura segura { $q-tool-clearance-height }, mas não abaixo da zona de segurança acima do prato.
step-touch-tool-setter = O comando mede a longitude:
say-measure-tooth-by-tooth = com { $q-tooth-measurement }=1, navalha a navalha: a ferramenta é posicionada ao lado da cabeça do apalpador, com a face abaixo da aresta superior desta, à distância { $mp-setter-axis-offset } (mais o desvio adicional da longitude { $mp-setter-offset-length }, se tiver sido introduzido na tabela de ferramentas). O comando apalpa radialmente a ferramenta a rodar para encontrar o ângulo inicial e mede depois a longitude de todas as navalhas, modificando a orientação do cabeçote
say-measure-rotating-or-stationary = caso contrário, se o diâmetro da ferramenta for maior do que a superfície de medição, com a ferramenta a rodar: a ferramenta é desviada do centro do apalpador no valor { $mp-setter-offset-radius } da tabela de ferramentas e desloca-se, a rodar, sobre a superfície de medição, para que seja encontrada a navalha mais comprida. Se o diâmetro for menor, ou no caso de brocas e fresas esféricas, com a ferramenta parada: desloca-se para o centro acima da superfície de medição e depois, com o cabeçote parado, até à superfície; para isso, { $mp-setter-offset-radius } na tabela de ferramentas é 0
step-store-tool-length = O comando guarda o resultado:
say-overwrite-tool-length = com { $q-tool-check }=0, substitui a longitude da ferramenta { $mp-tool-length } em TOOL.T e coloca a 0 o valor delta { $mp-delta-length }
say-enter-delta-length = com { $q-tool-check }=1, compara a longitude medida com a longitude da ferramenta { $mp-tool-length }, introduz o desvio, com o seu sinal, como valor delta { $mp-delta-length } e em Q115 e bloqueia a ferramenta (estado L) se for excedida a tolerância de desgaste ou de rotura
result-tool-length-deviation = Desvio da longitude da ferramenta
result-tool-status = Estado da medição: 0,0 = dentro da tolerância, 1,0 = desgastada, 2,0 = partida
guard-tool-call-missing = Não está chamada nenhuma ferramenta. Chame com TOOL CALL a ferramenta que pretende medir.
note-enter-tool-data-first = Antes de medir uma ferramenta pela primeira vez, introduza na tabela de ferramentas TOOL.T o número de navalhas, a direção de corte e valores aproximados do raio e da longitude.
note-most-teeth-measurable = As navalhas podem ser medidas individualmente em ferramentas com até 20 navalhas.
note-most-teeth-measurable__itnc530 = As navalhas podem ser medidas individualmente em ferramentas com até 99 navalhas. A visualização de estados mostra os valores de até 24 navalhas.
note-tool-table-must-be-active = Os ciclos de medição só funcionam se estiver ativa a memória central de ferramentas TOOL.T.
note-tool-call-before-tool-measurement = Antes de utilizar os ciclos de medição, introduza na memória central de ferramentas todos os dados necessários para a medição e chame com TOOL CALL a ferramenta que pretende medir.
note-three-ways-to-measure-length = A longitude pode ser medida de três formas: com a ferramenta a rodar, se o seu diâmetro for maior do que a superfície de medição do apalpador; com a ferramenta parada, se o diâmetro for menor ou se se tratar de brocas ou fresas esféricas; navalha a navalha com a ferramenta parada, se o diâmetro for maior do que a superfície de medição.
note-tool-measurement-feed-and-speed = Com a ferramenta parada, o comando utiliza o avanço de apalpação de { $mp-stationary-probing-feed }. Com a ferramenta a rodar, calcula as rotações da ferramenta n = { $mp-max-peripheral-speed } / (r · 0,0063) em rpm, a partir da velocidade periférica máxima admissível em m/min e do raio da ferramenta ativo r em mm, e o avanço de apalpação v = tolerância de medição · n em mm/min.
note-tool-measurement-tolerance = { $mp-probing-feed-calculation } determina a tolerância de medição. ConstantTolerance: permanece constante, pelo que o avanço de ferramentas muito grandes desce para zero, tanto mais cedo quanto menores forem { $mp-max-peripheral-speed } e { $mp-measuring-tolerance }. VariableTolerance: é { $mp-measuring-tolerance } para raios da ferramenta até 30 mm, o dobro até 60 mm, o triplo até 90 mm, o quádruplo até 120 mm. ConstantFeed: o avanço permanece constante e o erro de medição aumenta com o raio: (r · { $mp-measuring-tolerance }) / 5 mm.
note-tool-measurement-tolerance__itnc530 = { $mp-probing-feed-calculation } determina a tolerância de medição. 0: permanece constante, pelo que o avanço de ferramentas muito grandes desce para zero, tanto mais cedo quanto menores forem { $mp-max-peripheral-speed } e { $mp-measuring-tolerance }. 1: é { $mp-measuring-tolerance } para raios da ferramenta até 30 mm, o dobro até 60 mm, o triplo até 90 mm, o quádruplo até 120 mm. 2: o avanço permanece constante e o erro de medição aumenta com o raio: (r · { $mp-measuring-tolerance }) / 5 mm.
note-tool-measurement-tolerance__tnc426-430 = { $mp-probing-feed-calculation } determina a tolerância de medição. 0: permanece constante, pelo que o avanço de ferramentas muito grandes desce para zero, tanto mais cedo quanto menores forem { $mp-max-peripheral-speed } e { $mp-measuring-tolerance }. 1: é { $mp-measuring-tolerance } para raios da ferramenta até 30 mm, o dobro até 60 mm, o triplo até 90 mm, o quádruplo até 120 mm. 2: o avanço permanece constante e o erro de medição aumenta com o raio: (r · { $mp-measuring-tolerance }) / 5 mm.
note-check-tool-measurement-parameters = Antes de utilizar os ciclos de apalpação, verifique todos os parâmetros de máquina em { $mp-probe-settings } > { $mp-tool-measurement-config } e { $mp-round-stylus-config }.
note-tool-table-entries = Entradas da tabela de ferramentas: { $mp-teeth } é o número de navalhas, no máximo 20. { $mp-wear-tolerance-length } e { $mp-wear-tolerance-radius } são os desvios admissíveis da longitude e do raio para a deteção de desgaste, { $mp-break-tolerance-length } e { $mp-break-tolerance-radius } para a deteção de rotura, cada um de 0 a 0,9999 mm; se um valor for excedido, o comando bloqueia a ferramenta (estado L). { $mp-cutting-direction } é a direção de corte para a medição com a ferramenta a rodar. { $mp-setter-offset-radius } é o desvio entre o centro da haste e o centro da ferramenta na medição da longitude; por predefinição não tem valor (desvio = raio da ferramenta). { $mp-setter-offset-length } é o desvio entre o lado superior da haste e o lado inferior da ferramenta na medição do raio, adicionalmente a { $mp-setter-axis-offset }; o ajuste prévio é 0.
note-tool-table-entries__itnc530 = Entradas da tabela de ferramentas: { $mp-teeth } é o número de navalhas. { $mp-wear-tolerance-length } e { $mp-wear-tolerance-radius } são os desvios admissíveis da longitude e do raio para a deteção de desgaste, { $mp-break-tolerance-length } e { $mp-break-tolerance-radius } para a deteção de rotura, cada um de 0 a 0,9999 mm; se um valor for excedido, o comando bloqueia a ferramenta (estado L). { $mp-cutting-direction } é a direção de corte para a medição com a ferramenta a rodar. { $mp-setter-offset-radius } é o desvio entre o centro da haste e o centro da ferramenta na medição da longitude; o ajuste prévio é o raio R da ferramenta (introduzido com a tecla NO ENT). { $mp-setter-offset-length } é o desvio entre o lado superior da haste e o lado inferior da ferramenta na medição do raio, adicionalmente a { $mp-setter-axis-offset }; o ajuste prévio é 0.
note-usual-tool-table-entries = Valores habituais na tabela de ferramentas. Broca: { $mp-teeth } sem função, { $mp-setter-offset-radius } = 0 (mede-se a ponta da broca), { $mp-setter-offset-length } vazio. Fresa cilíndrica com diâmetro inferior a 19 mm: { $mp-teeth } = 4 (navalhas), { $mp-setter-offset-radius } = 0 (a ferramenta é mais estreita do que o prato), { $mp-setter-offset-length } = 0. Fresa cilíndrica com diâmetro superior a 19 mm: { $mp-teeth } = 4, { $mp-setter-offset-radius } = R (o desvio é necessário, porque a ferramenta é mais larga do que o prato), { $mp-setter-offset-length } = 0. Nenhuma das fresas cilíndricas precisa de um desvio adicional na medição do raio, porque se utiliza o desvio de { $mp-setter-axis-offset }. Fresa esférica: { $mp-teeth } = 4, { $mp-setter-offset-radius } = 0 (mede-se o polo sul da esfera), { $mp-setter-offset-length } = 5 (sempre o raio da ferramenta, para que o diâmetro não seja medido no raio da esfera).
note-old-and-new-form = Os ciclos 31 a 33 e 481 a 483 funcionam de forma idêntica. As únicas diferenças: 481 a 483 estão disponíveis também em DIN/ISO como G481 a G483 e, em vez de um parâmetro de livre escolha, utilizam o parâmetro fixo Q199 para o estado da medição.
note-status-parameter-optional = Sem um parâmetro de resultado, o estado da medição não é guardado.
note-tool-measurement-in-tilted-plane = As ferramentas podem ser medidas também com o plano de maquinação inclinado.
note-tool-status-display = A visualização adicional de estados pode mostrar os resultados (nos modos de funcionamento da máquina): à esquerda o programa, à direita os resultados. Os valores que excedem a tolerância de desgaste são assinalados com *, os que excedem a tolerância de rotura com B.
note-tool-status-display__tnc426-430 = A softkey PROVAR ESTADO FERR.TA mostra os resultados na visualização adicional de estados (nos modos de funcionamento da máquina): à esquerda o programa, à direita os resultados. Os valores que excedem a tolerância de desgaste são assinalados com *, os que excedem a tolerância de rotura com B.
note-from-software-280476 = Disponível a partir do software NC 280 476-xx.
note-not-in-iso = O formato antigo não está disponível em DIN/ISO.
note-prepare-for-tool-probe = O fabricante da máquina tem de preparar a máquina e o comando para o apalpador de ferramentas. É possível que alguns ciclos e funções não estejam disponíveis. Consulte o manual da máquina.
title-first-measurement-rotating-old = Primeira medição com a ferramenta a rodar; formato antigo
title-first-measurement-rotating-status = Primeira medição com a ferramenta a rodar, estado guardado em Q1
title-check-teeth-status-old = Verificação com medição individual de navalhas, estado guardado em Q5; formato antigo
title-check-teeth-without-status = Verificação com medição individual de navalhas, estado não guardado
