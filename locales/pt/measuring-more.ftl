# Ciclos que medem ângulos, ilhas, retângulos, larguras, coordenadas, círculos de furos e planos.

# --- what several of them share ---
say-part-is-scrap = desperdício (Q182=1) se um valor medido estiver fora da tolerância e já não puder ser corrigido
say-part-needs-rework = trabalho de acabamento (Q181=1) se um valor medido estiver fora da tolerância e ainda puder ser corrigido

# --- 422 ---
cycle-measure-stud = Medir círculo exterior
    .nc = MEDIR CÍRCULO EXTERIOR
    .nc-aliases = MEDIÇÃO DUM CÍRCULO EXTERIOR
    .purpose = Mede o centro e o diâmetro de uma ilha circular. Se no ciclo estiverem definidas tolerâncias, o comando compara os valores nominais com os reais e guarda os desvios em parâmetros.
say-part-is-scrap__measure-stud = desperdício (Q182=1) se a ilha for menor do que { $q-stud-least-diameter } ou se o seu centro apresentar um desvio superior a { $q-centre-tolerance-main } ou { $q-centre-tolerance-minor }
say-part-needs-rework__measure-stud = trabalho de acabamento (Q181=1) se a ilha for maior do que { $q-stud-greatest-diameter }
note-smallest-stepping-angle__measure-stud = Quanto menor for o passo angular { $q-probing-stepping-angle }, menos exatas são as medidas da ilha que o comando calcula. Valor de introdução mínimo: 5°.

# --- 423, 424 ---
cycle-measure-rectangular-pocket = Medir retângulo interior
    .nc = MEDIR RECTÂNGULO INT.
    .nc-aliases = MEDIÇÃO DUM RECTÂNGULO INTERIOR
    .purpose = Mede o centro, a longitude e a largura de uma caixa retangular. Se no ciclo estiverem definidas tolerâncias, o comando compara os valores nominais com os reais e guarda os desvios em parâmetros.
cycle-measure-rectangular-stud = Medir retângulo exterior
    .nc = MEDIR RECTÂNGULO EXT.
    .nc-aliases = MEDIR RECTÂNG. EXTERIOR | MEDIÇÃO DUM RECTÂNGULO EXTERIOR
    .purpose = Mede o centro, a longitude e a largura de uma ilha retangular. Se no ciclo estiverem definidas tolerâncias, o comando compara os valores nominais com os reais e guarda os desvios em parâmetros.
say-part-is-scrap__measure-rectangular-pocket = desperdício (Q182=1) se um lado for mais longo do que { $q-first-side-greatest-length } ou { $q-second-side-greatest-length }, ou se o centro apresentar um desvio superior a { $q-centre-tolerance-main } ou { $q-centre-tolerance-minor }
say-part-needs-rework__measure-rectangular-pocket = trabalho de acabamento (Q181=1) se um lado for mais curto do que { $q-first-side-least-length } ou { $q-second-side-least-length }
say-part-is-scrap__measure-rectangular-stud = desperdício (Q182=1) se um lado for mais curto do que { $q-first-side-least-length } ou { $q-second-side-least-length }, ou se o centro apresentar um desvio superior a { $q-centre-tolerance-main } ou { $q-centre-tolerance-minor }
say-part-needs-rework__measure-rectangular-stud = trabalho de acabamento (Q181=1) se um lado for mais longo do que { $q-first-side-greatest-length } ou { $q-second-side-greatest-length }
result-side-main-deviation = Desvio longitude do lado eixo principal
result-side-minor-deviation = Desvio longitude do lado eixo secundário
title-measure-and-rework-rectangular-stud = Medir uma ilha retangular e acabá-la com os valores medidos
title-measure-rectangular-pocket-with-log = Medir uma caixa retangular e registar os resultados

# --- 425, 426 ---
cycle-measure-slot-width = Medir largura interior
    .nc = MEDIR LARGURA INTERIOR
    .nc-aliases = MEDIÇÃO LARGURA INTERIOR
    .purpose = Mede a posição e a largura de uma ranhura (caixa). Se no ciclo estiverem definidas tolerâncias, o comando compara os valores nominais com os reais e guarda o desvio num parâmetro.
cycle-measure-ridge-width = Medir nervura exterior
    .nc = MEDIR NERVURA EXTERIOR
    .nc-aliases = MEDIÇÃO NERVURA EXTERIOR
    .purpose = Mede a posição e a largura de uma nervura. Se no ciclo estiverem definidas tolerâncias, o comando compara os valores nominais com os reais e guarda o desvio num parâmetro.
step-probe-first-in-positive-direction = O apalpador executa a primeira apalpação com o avanço de apalpação (coluna { $mp-probing-feed }), sempre na direção positiva do eixo programado.
step-probe-first-in-positive-direction__tnc426-430 = O apalpador executa a primeira apalpação com o avanço de apalpação ({ $mp-probing-feed } ou { $mp-analog-probing-feed }), sempre na direção positiva do eixo programado.
step-probe-first-in-negative-direction = O apalpador executa a primeira apalpação com o avanço de apalpação (coluna { $mp-probing-feed }), sempre na direção negativa do eixo programado.
step-probe-first-in-negative-direction__tnc426-430 = O apalpador executa a primeira apalpação com o avanço de apalpação ({ $mp-probing-feed } ou { $mp-analog-probing-feed }), sempre na direção negativa do eixo programado.
step-probe-second-side-of-slot = O apalpador executa a segunda apalpação conforme { $q-second-measurement-offset }:
step-probe-second-side-of-slot__tnc640 = Com uma longitude nominal grande, o comando desloca o apalpador em avanço rápido para o segundo ponto de apalpação. O apalpador executa a segunda apalpação conforme { $q-second-measurement-offset }:
say-offset-second-measurement = com { $q-second-measurement-offset } diferente de 0, o comando desloca o apalpador paralelamente aos eixos, no valor deste desvio, para o ponto de apalpação seguinte e apalpa aí
say-offset-second-measurement__tnc640 = com { $q-second-measurement-offset } diferente de 0, o comando desloca o apalpador no valor deste desvio para o ponto de apalpação seguinte, com { $q-traverse-to-clearance-height }=1 à altura segura { $q-clearance-height }, e apalpa aí
say-measure-in-opposite-direction = com { $q-second-measurement-offset }=0, mede a largura diretamente na direção oposta
step-probe-second-side-of-ridge = O apalpador desloca-se, à altura segura { $q-clearance-height }, para o ponto de apalpação seguinte e executa aí a segunda apalpação.
say-part-is-scrap__measure-slot-width = desperdício (Q182=1) se a ranhura for mais larga do que { $q-greatest-dimension }
say-part-needs-rework__measure-slot-width = trabalho de acabamento (Q181=1) se a ranhura for mais estreita do que { $q-least-dimension }
say-part-is-scrap__measure-ridge-width = desperdício (Q182=1) se a nervura for mais estreita do que { $q-least-dimension }
say-part-needs-rework__measure-ridge-width = trabalho de acabamento (Q181=1) se a nervura for mais larga do que { $q-greatest-dimension }
note-clearance-acts-in-probe-axis-only = A distância de segurança { $q-probing-clearance } só atua na apalpação do ponto de referência no eixo do apalpador.
result-measured-length-actual = Valor real longitude medida
result-measured-length-deviation = Desvio da longitude medida

# --- 427 ---
cycle-measure-coordinate = Medir coordenadas
    .nc = MEDIR COORDENADA
    .nc-aliases = MEDIÇÃO DE COORDENADA
    .purpose = Mede uma coordenada num eixo à escolha e guarda o valor num parâmetro. Se no ciclo estiverem definidas tolerâncias, o comando compara os valores nominais com os reais e guarda os desvios em parâmetros.
step-position-against-traverse-direction = O comando posiciona o apalpador no ponto de apalpação programado, em avanço rápido (valor da coluna { $mp-positioning-feed }) e com lógica de posicionamento. Desvia o apalpador no valor da distância de segurança, no sentido oposto à direção de deslocação { $q-traverse-direction }.
step-position-against-traverse-direction__tnc426-430 = O comando posiciona o apalpador no ponto de apalpação programado, em avanço rápido (valor de { $mp-positioning-feed } ou { $mp-analog-positioning-feed }) e com lógica de posicionamento. Desvia o apalpador no valor da distância de segurança, no sentido oposto à direção de deslocação { $q-traverse-direction }.
step-probe-coordinate = O comando posiciona o apalpador no plano de maquinação, no ponto de apalpação programado, e mede aí o valor real no eixo selecionado.
step-retract-and-store-measured-coordinate = O comando faz regressar o apalpador à altura segura { $q-clearance-height } e guarda a coordenada medida no parâmetro de resultado.
say-part-is-scrap__measure-coordinate = desperdício (Q182=1) se a coordenada medida for menor do que { $q-least-dimension }
say-part-needs-rework__measure-coordinate = trabalho de acabamento (Q181=1) se a coordenada medida for maior do que { $q-greatest-dimension }
say-correct-tool-length = com { $q-monitored-tool } diferente de 0 e { $q-measuring-axis }=3, corrige a longitude da ferramenta na coluna DL da tabela de ferramentas; se o desvio for maior do que a tolerância de rotura RBREAK, emite um aviso de erro, detém a execução do programa e bloqueia a ferramenta (coluna TL = L)
say-correct-tool-radius__measure-coordinate = com { $q-monitored-tool } diferente de 0 e { $q-measuring-axis }=1 ou 2, corrige o valor delta do raio na coluna DR da tabela de ferramentas, no sentido que resulta de { $q-traverse-direction }; se o desvio for maior do que a tolerância de rotura RBREAK, emite um aviso de erro, detém a execução do programa e bloqueia a ferramenta (coluna TL = L)
note-coordinate-is-outside-dimension = O comando parte do princípio de que a medida é exterior (ilha). Noutros casos, o estado da medição pode ser corrigido com uma escolha adequada da medida maior e da medida menor, juntamente com a direção de apalpação.
note-coordinate-corrects-radius-or-length = Se o eixo de medição for um eixo do plano de maquinação ({ $q-measuring-axis }=1 ou 2), o comando corrige o raio da ferramenta; o sentido da correção resulta da direção de deslocação { $q-traverse-direction }. Se o eixo de medição for o eixo do apalpador ({ $q-measuring-axis }=3), corrige a longitude da ferramenta.

# --- 430 ---
cycle-measure-bolt-hole-circle = Medir círculo de furos
    .nc = MEDIR CÍRCULO DE FUROS
    .nc-aliases = MEDIÇÃO CÍRCULO DE FUROS
    .purpose = Mede o centro e o diâmetro de um círculo de furos medindo três dos seus furos. Se no ciclo estiverem definidas tolerâncias, o comando compara os valores nominais com os reais e guarda os desvios em parâmetros.
step-measure-centre-of-hole = O apalpador desloca-se para a altura de medição { $q-measuring-height } e determina o centro do furo com quatro apalpações.
step-travel-to-next-hole = O apalpador regressa à altura segura { $q-clearance-height } e é posicionado no centro introduzido do furo seguinte.
until-three-holes-measured = tenham sido determinados os centros dos três furos
say-part-is-scrap__measure-bolt-hole-circle = desperdício (Q182=1) se o diâmetro for maior do que { $q-greatest-dimension } ou menor do que { $q-least-dimension }, ou se o centro apresentar um desvio superior a { $q-centre-tolerance-main } ou { $q-centre-tolerance-minor }
say-monitor-tool-breakage = com { $q-monitored-tool } diferente de 0, compara o desvio com a tolerância de rotura RBREAK; se o desvio for maior, emite um aviso de erro, detém a execução do programa e bloqueia a ferramenta (coluna TL = L). Não corrige a ferramenta
note-only-breakage-monitoring = Este ciclo supervisiona apenas a rotura da ferramenta; não corrige a ferramenta.
result-bolt-circle-diameter-actual = Valor real diâmetro do círculo de furos
result-bolt-circle-diameter-deviation = Desvio diâmetro do círculo de furos

# --- 420 ---
cycle-measure-angle = Medir ângulo
    .nc = MEDIR ÂNGULO
    .nc-aliases = MEDIÇÃO ÂNGULO
    .purpose = Mede o ângulo entre uma reta e o eixo principal do plano de maquinação.
say-travel-to-point-at-clearance-height = com { $q-traverse-to-clearance-height }=1, à altura segura { $q-clearance-height }
say-travel-to-point-at-measuring-height = com { $q-traverse-to-clearance-height }=0, à altura de medição { $q-measuring-height }
step-retract-and-store-angle = O comando faz regressar o apalpador à altura segura { $q-clearance-height } e guarda o ângulo medido no parâmetro de resultado.
note-angle-about-a-or-b = Se o eixo de medição for o eixo do apalpador ({ $q-measuring-axis }=3): para medir o ângulo em torno do eixo A, introduza o mesmo valor em { $q-first-point-main } e { $q-second-point-main }; para medir o ângulo em torno do eixo B, introduza aí valores diferentes.
note-results-shown-in-help-graphic = Durante a definição do ciclo, a imagem de ajuda mostra também os parâmetros de resultado; o que está realçado pertence ao parâmetro de introdução selecionado.
note-results-shown-in-help-graphic__tnc426-430 = Durante a definição do ciclo, a imagem de ajuda mostra também os parâmetros de resultado.
result-measured-angle = Ângulo medido em relação ao eixo principal do plano de maquinação

# --- 431 ---
cycle-measure-plane = Medir plano
    .nc = MEDIR PLANO
    .nc-aliases = MEDIÇÃO DUM PLANO
    .purpose = Mede os ângulos de um plano medindo três pontos e guarda os valores em parâmetros.
step-measure-first-point-of-plane = O comando posiciona o apalpador no primeiro ponto de apalpação programado, em avanço rápido (valor da coluna { $mp-positioning-feed }) e com lógica de posicionamento, e mede aí o primeiro ponto do plano. Desvia o apalpador no valor da distância de segurança, no sentido oposto à direção de apalpação.
step-measure-first-point-of-plane__tnc426-430 = O comando posiciona o apalpador no primeiro ponto de apalpação programado, em avanço rápido (valor de { $mp-positioning-feed } ou { $mp-analog-positioning-feed }) e com lógica de posicionamento, e mede aí o primeiro ponto do plano. Desvia o apalpador no valor da distância de segurança, no sentido oposto à direção de apalpação.
step-measure-second-point-of-plane = O apalpador regressa à altura segura { $q-clearance-height } e desloca-se no plano de maquinação para o segundo ponto de apalpação, onde o comando mede o valor real do segundo ponto do plano.
step-measure-third-point-of-plane = O apalpador regressa à altura segura { $q-clearance-height } e desloca-se no plano de maquinação para o terceiro ponto de apalpação, onde o comando mede o valor real do terceiro ponto do plano.
step-retract-and-store-plane-angles = O comando faz regressar o apalpador à altura segura { $q-clearance-height } e guarda os ângulos nos parâmetros de resultado.
guard-points-on-one-line = Os três pontos de medição estão sobre uma reta. O comando não pode calcular os ângulos do plano.
note-positioning-logic__measure-plane = Lógica de posicionamento: com o polo sul da haste de apalpação abaixo da altura segura { $q-clearance-height }, o comando faz primeiro recuar o apalpador, no seu eixo, para a altura segura e só depois o leva, no plano de maquinação, ao primeiro ponto de apalpação. Com o polo sul acima da altura segura, o apalpador desloca-se primeiro, no plano de maquinação, para o primeiro ponto de apalpação e depois, no seu eixo, diretamente para a altura de medição.
note-three-points-not-on-a-line = Os três pontos de medição não podem estar sobre uma reta: só assim o comando pode calcular os ângulos.
note-spatial-angles-for-tilting = Os parâmetros Q170 a Q172 contêm os ângulos espaciais de que a função de inclinação do plano de maquinação necessita. Os dois primeiros pontos de medição determinam a direção do eixo principal ao inclinar o plano de maquinação.
note-third-point-sets-tool-axis = O terceiro ponto de medição determina a direção do eixo da ferramenta. Defina-o na direção do eixo Y positivo, para que o eixo da ferramenta fique na posição correta num sistema de coordenadas direto (regra da mão direita).
note-spatial-angle-in-tilted-plane = Se o ciclo for executado com o plano de maquinação inclinado ativo, os ângulos espaciais medidos referem-se ao sistema de coordenadas inclinado. Utilize-os na função de inclinação do plano de maquinação como valores incrementais.
result-projection-angle-a = Ângulo de projeção do eixo A
result-projection-angle-a__tnc426-430 = Ângulo do eixo A
result-projection-angle-b = Ângulo de projeção do eixo B
result-projection-angle-b__tnc426-430 = Ângulo do eixo B
result-spatial-angle-a = Ângulo espacial A
result-spatial-angle-b = Ângulo espacial B
result-spatial-angle-c = Ângulo espacial C
result-first-value-in-probe-axis = Valor medido no eixo do apalpador (primeira medição)
result-first-value-in-probe-axis__tnc320 = Valor medido no eixo do apalpador
result-second-value-in-probe-axis = Valor medido no eixo do apalpador (segunda medição)
result-third-value-in-probe-axis = Valor medido no eixo do apalpador (terceira medição)

# --- 1 ---
cycle-polar-reference-plane = Plano de referência polar
    .nc = PONTO DE REFERÊNCIA POLAR
    .nc-aliases = PLANO DE REFERÊNCIA POLAR
    .purpose = Mede uma posição qualquer da peça numa direção de apalpação qualquer, definida por um ângulo.
step-probe-at-polar-angle = O apalpador executa a apalpação com o avanço de apalpação (coluna { $mp-probing-feed }). Durante a apalpação, o comando desloca o apalpador em dois eixos ao mesmo tempo, consoante o ângulo de apalpação. A direção de apalpação define-se no ciclo por meio de um ângulo polar.
step-probe-at-polar-angle__tnc426-430 = O apalpador executa a apalpação com o avanço de apalpação ({ $mp-probing-feed } ou { $mp-analog-probing-feed }). Durante a apalpação, o comando desloca o apalpador em dois eixos ao mesmo tempo, consoante o ângulo de apalpação. A direção de apalpação define-se no ciclo por meio de um ângulo polar.
step-return-and-store-trigger-position = Depois de medida a posição, o apalpador regressa ao ponto de partida da apalpação. O comando guarda nos parâmetros Q115 a Q119 as coordenadas da posição em que o apalpador se encontrava no momento do sinal de comutação.
step-return-and-store-trigger-position__tnc426-430 = Depois de medida a posição, o apalpador regressa ao ponto de partida da apalpação. O comando guarda nos parâmetros Q115 a Q119 as coordenadas do centro da esfera no contacto com a peça.
note-probing-plane-by-axis = O eixo de apalpação definido no ciclo determina o plano de apalpação: eixo de apalpação X: plano X/Y; Y: plano Y/Z; Z: plano Z/X.
note-trigger-position-of-ball-centre = Q115 a Q119 contêm as coordenadas do centro da esfera no contacto com a peça.

# --- 3 ---
cycle-measuring = Medir
    .nc = MEDIR
    .purpose = Mede uma posição qualquer da peça numa direção de apalpação à escolha. Ao contrário dos outros ciclos de medição, o percurso e o avanço de medição introduzem-se diretamente neste ciclo, tal como o recuo depois da medição. Destina-se a ciclos especiais criados pelo fabricante da máquina.
cycle-measuring__tnc426-430 =
    .purpose = Mede uma posição qualquer da peça numa direção de apalpação à escolha. Ao contrário dos outros ciclos de medição, o avanço de medição introduz-se diretamente neste ciclo. É um ciclo de medição para utilizações especiais.
step-move-in-polar-direction = O apalpador desloca-se da posição atual, com o avanço introduzido, na direção de apalpação programada. A direção de apalpação define-se no ciclo por meio de um ângulo polar.
step-stop-and-store-ball-centre = Depois de o comando ter medido a posição, o apalpador detém-se. O comando guarda as coordenadas X, Y e Z do centro da esfera em três parâmetros Q seguidos, sem corrigir a longitude nem o raio. O número do primeiro parâmetro de resultado define-se no ciclo.
step-stop-and-store-ball-centre__tnc426-430 = Depois de o comando ter medido a posição, o apalpador detém-se. O comando guarda as coordenadas do centro da esfera em três parâmetros Q seguidos. O número do primeiro parâmetro define-se no ciclo.
result-ball-centre-and-status = Centro da esfera em X; os dois parâmetros seguintes contêm Y e Z, o quarto −1 se não tiver havido um ponto de apalpação válido
result-ball-centre-and-status__tnc426-430 = Primeira coordenada do centro da esfera; os dois parâmetros seguintes contêm as outras
note-probe-data-without-effect = Os dados do apalpador { $mp-probing-distance } (maior percurso até ao ponto de apalpação) e { $mp-probing-feed } (avanço de apalpação), que atuam nos outros ciclos de medição, não têm efeito neste ciclo.
note-four-parameters-overwritten = O comando escreve sempre quatro parâmetros Q seguidos.
note-no-touch-point-no-error = Se o comando não encontrar um ponto de apalpação válido, o programa continua sem aviso de erro. O comando atribui então −1 ao quarto parâmetro de resultado, para que o programa possa reagir ao erro.
note-retraction-not-beyond-start = O comando faz recuar o apalpador, no máximo, no valor do percurso de recuo MB, mas não para além do ponto de partida da medição. Por isso, não pode haver colisão no recuo.
note-probe-input-by-function = A função FN17: SYSWRITE ID 990 NR 6 determina se o ciclo atua sobre a entrada do apalpador X12 ou X13.
note-available-from-software-474 = Este ciclo está disponível a partir do software NC 280 474-xx.
note-behaviour-defined-by-builder = O fabricante da máquina ou o fornecedor do software define o funcionamento deste ciclo em pormenor; utiliza-se dentro de ciclos de apalpação especiais.

