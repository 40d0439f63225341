# Pockets, slots, studs, line patterns and multipass milling.

# --- common to pockets, slots and studs ---
guard-tool-wider-than-slot = A ferramenta não cabe na ranhura: descontadas as medidas excedentes laterais, a ranhura é mais estreita do que a ferramenta.
guard-stud-blank-too-small = O bloco não é maior do que a ilha acabada.
note-finishing-only-rapid-to-first-depth = Perigo de colisão! Se o ciclo for chamado com o tipo de maquinação 2 (só acabamento), o comando desloca a ferramenta em avanço rápido até à primeira profundidade de passo.

# --- 252 ---
cycle-circular-pocket = Caixa circular
    .nc = CAIXA CIRCULAR
    .purpose = Maquina por completo uma caixa circular: desbaste, acabamento do fundo e acabamento lateral. Também é possível fazer só o desbaste, só o acabamento do fundo e lateral, só o acabamento do fundo ou só o acabamento lateral.
guard-plunging-angle-not-vertical = A penetração vertical precisa de um ângulo de penetração { $mp-plunging-angle } de 0 ou 90 na tabela de ferramentas.
note-position-at-pocket-centre = Posicione a ferramenta no ponto de partida (centro do círculo) no plano de maquinação com correção de raio R0.

# --- 253 ---
cycle-slot = Fresar ranhura
    .nc = FRESAR RANHURA
    .purpose = Maquina por completo uma ranhura: desbaste, acabamento do fundo e acabamento lateral. Também é possível fazer só o desbaste, só o acabamento do fundo e lateral, só o acabamento do fundo ou só o acabamento lateral.
step-move-over-left-slot-arc = O comando posiciona a ferramenta no eixo da ferramenta à 2ª distância de segurança { $q-second-set-up-clearance } (ou à distância de segurança, se aquela não tiver sido introduzida), depois sobre o centro do arco esquerdo da ranhura e a seguir à distância de segurança { $q-set-up-clearance }, sempre em avanço rápido.
step-plunge-at-left-slot-arc = A partir do centro do arco esquerdo da ranhura, a ferramenta penetra na peça até à profundidade de passo seguinte { $q-plunging-depth }. O parâmetro { $q-plunging-strategy } determina como:
say-plunge-to-and-fro-along-slot = { $q-plunging-strategy } = 1 ou 2: em vaivém ao longo da ranhura, com o ângulo de penetração { $mp-plunging-angle } da tabela de ferramentas e o avanço { $q-plunging-feed }
step-clear-slot-level = O comando desbasta a ranhura de dentro para fora, tendo em conta as medidas excedentes de acabamento { $q-side-allowance } e { $q-floor-allowance }.
step-rapid-to-first-plunging-depth-of-slot = Se só estiver programado o acabamento ({ $q-machining-operation } = 2), o comando desloca a ferramenta em avanço rápido até à primeira profundidade de passo.
step-finish-slot-side = Se estiver definida uma medida excedente { $q-side-allowance }, o comando faz primeiro o acabamento das paredes da ranhura; se { $q-finishing-infeed } tiver sido introduzido, em vários passos. Aproxima-se tangencialmente da parede no arco esquerdo da ranhura.
step-finish-slot-side__circular-slot = Se estiver definida uma medida excedente { $q-side-allowance }, o comando faz primeiro o acabamento das paredes da ranhura; se { $q-finishing-infeed } tiver sido introduzido, em vários passos. Aproxima-se tangencialmente da parede.
until-slot-side-finished = o acabamento das paredes chegue à profundidade { $q-depth }
step-finish-slot-floor = Se estiver definida uma medida excedente { $q-floor-allowance }, o comando faz depois o acabamento do fundo da ranhura de dentro para fora.
step-leave-slot = A ferramenta sai da ranhura em avanço rápido para a 2ª distância de segurança { $q-second-set-up-clearance } (ou para a distância de segurança, se aquela não tiver sido introduzida).
step-end-of-slot = O local em que a ferramenta fica no fim do ciclo depende da posição da ranhura { $q-slot-position }:
say-back-to-slot-centre = { $q-slot-position } = 0: o comando faz regressar a ferramenta no plano de maquinação ao centro da ranhura
say-stays-in-working-plane = caso contrário: o comando não posiciona a ferramenta no plano de maquinação
note-position-at-slot-start = Posicione a ferramenta no ponto de partida no plano de maquinação com correção de raio R0. Tenha em conta a posição da ranhura { $q-slot-position }.
note-position-at-slot-start__circular-slot = Posicione a ferramenta no ponto de partida no plano de maquinação com correção de raio R0. Tenha em conta a referência da posição da ranhura { $q-slot-position-reference }.
note-slot-end-position = No fim do ciclo, o comando faz regressar a ferramenta no plano de maquinação ao centro da ranhura. Exceção: se estiver definida uma posição da ranhura { $q-slot-position } diferente de 0, posiciona-a apenas no eixo da ferramenta, à 2ª distância de segurança. Antes de chamar de novo o ciclo, volte a levar a ferramenta à posição de partida ou programe deslocações absolutas antes da chamada.
note-wide-slot-is-cleared = Se a ranhura for mais larga do que o dobro do diâmetro da ferramenta, o comando desbasta-a de dentro para fora. Assim também se podem fresar ranhuras de qualquer largura com ferramentas pequenas.

# --- 254 ---
cycle-circular-slot = Ranhura circular
    .nc = RANHURA CIRCULAR
    .purpose = Maquina por completo uma ranhura circular, ou várias sobre um círculo teórico: desbaste, acabamento do fundo e acabamento lateral. Também é possível fazer só o desbaste, só o acabamento do fundo e lateral, só o acabamento do fundo ou só o acabamento lateral.
step-move-over-circular-slot = O comando posiciona a ferramenta no eixo da ferramenta à 2ª distância de segurança { $q-second-set-up-clearance } (ou à distância de segurança, se aquela não tiver sido introduzida), depois sobre o ponto de partida da ranhura e a seguir à distância de segurança { $q-set-up-clearance }, sempre em avanço rápido.
step-plunge-in-circular-slot = A ferramenta penetra na peça a meio da largura da ranhura até à profundidade de passo seguinte { $q-plunging-depth }. O parâmetro { $q-plunging-strategy } determina como:
until-all-slots-milled = estejam fresadas todas as ranhuras ({ $q-number-of-operations }), cada uma com uma rotação de { $q-pattern-stepping-angle } em torno do centro do círculo teórico
step-end-of-circular-slot = O local em que a ferramenta fica no fim do ciclo depende da referência da posição da ranhura { $q-slot-position-reference }:
say-back-to-pitch-circle-centre = { $q-slot-position-reference } = 0: o comando faz regressar a ferramenta no plano de maquinação ao ponto de partida (centro do círculo teórico)
condition-slot-at-entered-centre = a posição da ranhura resultar do centro do círculo teórico introduzido ({ $q-slot-position-reference } = 0)
note-circular-slot-end-position = No fim do ciclo, o comando faz regressar a ferramenta no plano de maquinação ao ponto de partida (centro do círculo teórico). Exceção: se estiver definida uma posição da ranhura { $q-slot-position-reference } diferente de 0, posiciona-a apenas no eixo da ferramenta, à 2ª distância de segurança. Neste caso, programe sempre deslocações absolutas depois da chamada do ciclo.
note-circular-slot-with-pattern = Se o ciclo 254 (ranhura circular) for combinado com o ciclo 221, não é permitido o valor 0 para a posição da ranhura.

# --- 256 ---
cycle-rectangular-stud = Ilha retangular
    .nc = ILHA RETANGULAR
    .nc-aliases = ILHA RECTANGULAR
    .purpose = Maquina uma ilha retangular. Se o bloco for maior do que o maior passo lateral possível, o comando executa vários passos laterais até serem atingidas as medidas acabadas.
step-move-to-stud-approach = A ferramenta desloca-se da posição de partida do ciclo (centro da ilha) para a posição de partida da maquinação da ilha. Esta é determinada pelo parâmetro { $q-stud-approach-position }:
say-approach-beside-blank = { $q-stud-approach-position } = 0 (ajuste normal): 2 mm ao lado do bloco da ilha, à direita
say-approach-at-stud-corner = caso contrário: na esquina escolhida
step-rapid-down-to-set-up-clearance = Se a ferramenta se encontrar à 2ª distância de segurança, o comando desloca-a em avanço rápido (FMAX) para a distância de segurança { $q-set-up-clearance }.
step-feed-to-plunging-depth-of-stud = A ferramenta desloca-se com o avanço do passo em profundidade { $q-plunging-feed } até à profundidade de passo seguinte { $q-plunging-depth }.
step-mill-around-stud = A ferramenta aproxima-se depois tangencialmente do contorno da ilha e fresa uma volta.
step-mill-around-stud-again = Se uma volta não bastar para atingir as medidas acabadas, à profundidade de passo atual, o comando avança lateralmente e fresa outra volta, tendo em conta as medidas do bloco, as medidas acabadas e o passo lateral permitido. O processo repete-se até serem atingidas as medidas acabadas. Se o ponto de partida ficar numa esquina ({ $q-stud-approach-position } diferente de 0), o comando fresa em espiral, do ponto de partida para dentro, até serem atingidas as medidas acabadas.
step-leave-stud-to-start = Se forem necessários mais passos em profundidade, a ferramenta sai tangencialmente do contorno e regressa ao ponto de partida da ilha.
until-stud-depth-reached = seja atingida a profundidade programada { $q-depth } da ilha
step-retract-from-stud = No fim do ciclo, o comando posiciona a ferramenta apenas no eixo da ferramenta. A posição final difere por isso da posição de partida:
note-position-at-stud-start = Posicione a ferramenta no ponto de partida no plano de maquinação com correção de raio R0. Tenha em conta a posição da ilha { $q-stud-position }.
note-room-beside-stud = Perigo de colisão! Deixe à direita da ilha espaço suficiente para a aproximação da ferramenta: pelo menos o diâmetro da ferramenta + 2 mm.
note-stud-end-position = Perigo de colisão! No fim, o comando faz regressar a ferramenta à distância de segurança ou, se tiver sido introduzida, à 2ª distância de segurança. A posição final da ferramenta depois do ciclo não coincide, portanto, com a posição de partida.
note-choose-other-approach-position = Se a aproximação com { $q-stud-approach-position } = 0 deixar marcas na superfície da ilha, escolha outra posição de aproximação.

# --- 257 ---
cycle-circular-stud = Ilha circular
    .nc = ILHA CIRCULAR
    .purpose = Maquina uma ilha circular. Se o diâmetro do bloco for maior do que o maior passo lateral possível, o comando executa vários passos laterais até ser atingido o diâmetro acabado.
step-move-to-circular-stud-approach = A ferramenta desloca-se da posição de partida do ciclo (centro da ilha) para a posição de partida da maquinação da ilha. Esta é determinada pelo parâmetro { $q-stud-starting-angle }, como ângulo polar em relação ao centro da ilha.
step-mill-spiral-around-stud = A ferramenta aproxima-se depois em espiral, tangencialmente, do contorno da ilha e fresa uma volta.
step-keep-spiral-to-finished-diameter = Se uma volta não bastar para atingir o diâmetro acabado, o comando continua a avançar em espiral até o atingir, tendo em conta o diâmetro do bloco, o diâmetro acabado e o passo lateral permitido.
step-leave-stud-on-spiral = O comando afasta a ferramenta do contorno em espiral.
step-next-infeed-near-departure = Se forem necessários vários passos em profundidade, o seguinte faz-se no ponto mais próximo da saída.
step-retract-and-return-to-stud-centre = No fim do ciclo, depois da saída em espiral, o comando posiciona a ferramenta no eixo da ferramenta à 2ª distância de segurança { $q-second-set-up-clearance } (ou à distância de segurança, se aquela não tiver sido introduzida) e depois no centro da ilha.
note-position-at-stud-centre = Posicione a ferramenta no ponto de partida (centro da ilha) no plano de maquinação com correção de raio R0.
note-circular-stud-end-height = Perigo de colisão! No fim, o comando faz regressar a ferramenta à distância de segurança ou, se tiver sido introduzida, à 2ª distância de segurança. No eixo da ferramenta, a posição final depois do ciclo pode, portanto, diferir da posição de partida.

# --- 221 ---
cycle-line-pattern = Figura de pontos sobre linhas
    .nc = FIGURA LINHAS
    .purpose = Executa o ciclo de maquinação definido em último lugar em pontos dispostos em linhas e colunas.
until-line-done = estejam executadas todas as { $q-number-of-columns } maquinações da linha; a ferramenta fica no último ponto da linha
step-move-to-next-column = O comando desloca depois a ferramenta para o ponto de partida da maquinação seguinte, na primeira, terceira, quinta linha … na direção positiva do eixo principal, na segunda, quarta, sexta linha … na direção negativa, e, aí, para a distância de segurança { $q-set-up-clearance }.
step-height-between-lines = No último ponto da linha, a ferramenta desloca-se no eixo do cabeçote para a altura entre as maquinações, conforme { $q-pattern-clearance-mode }.
step-move-to-next-line = O comando desloca depois a ferramenta para a linha seguinte, diretamente para o ponto da mesma coluna, e, aí, para a distância de segurança { $q-set-up-clearance }. Todas as restantes linhas são maquinadas desta forma, em vaivém.
until-all-lines-done = estejam executadas todas as { $q-number-of-lines } linhas
note-pattern-overrides-heights-and-rotation = Se um dos ciclos de maquinação 200 a 209 e 251 a 267 for combinado com este ciclo, são válidas a distância de segurança { $q-set-up-clearance }, a coordenada da superfície da peça { $q-surface-coordinate }, a 2ª distância de segurança { $q-second-set-up-clearance } e o ângulo de rotação { $q-angle-of-rotation } deste ciclo.

# --- common to surfaces ---
until-surface-milled = a superfície definida esteja totalmente fresada
note-pre-position-for-surface = Perigo de colisão! Posicione previamente a ferramenta de modo que não possa colidir com a peça nem com os dispositivos de fixação.

# --- 230 ---
cycle-multipass-milling = Facejar por linhas
    .nc = FACEJAR POR LINHAS
    .purpose = Fresa em linhas, em vaivém, uma superfície plana retangular.
step-rapid-to-start-of-lines = O comando posiciona a ferramenta em avanço rápido (FMAX), da posição atual, no ponto de partida 1 do plano de maquinação. Para isso, desloca-a para a esquerda e para cima no valor do raio da ferramenta.
step-down-to-start-of-lines = A ferramenta desloca-se depois no eixo do cabeçote em avanço rápido (FMAX) para a distância de segurança { $q-set-up-clearance } e daí, com o avanço do passo em profundidade { $q-plunging-feed }, para a posição de partida programada { $q-starting-point-tool } no eixo do cabeçote.
step-mill-line = A ferramenta fresa depois com o avanço programado { $q-milling-feed } até ao ponto final 2, que o comando calcula a partir do ponto de partida, da longitude programada { $q-first-side-length } e do raio da ferramenta.
step-step-over-to-next-line = O comando desloca a ferramenta lateralmente com o avanço { $q-stepover-feed } para o ponto de partida da linha seguinte. Calcula a deslocação a partir da largura programada { $q-second-side-length } e do número de cortes { $q-number-of-cuts }.
step-mill-back-in-next-line = A ferramenta regressa depois na direção negativa do 1.º eixo.
step-rapid-back-to-clearance-over-surface = No fim, o comando retira a ferramenta em avanço rápido (FMAX) para a distância de segurança { $q-set-up-clearance }.
note-plane-first-then-spindle-axis = A partir da posição atual, o comando posiciona a ferramenta no ponto de partida primeiro no plano de maquinação e depois no eixo do cabeçote.

# --- 231 ---
cycle-ruled-surface = Superfície regrada
    .nc = SUPERFÍCIE REGRADA
    .purpose = Fresa, em linhas todas no mesmo sentido, uma superfície oblíqua, inclinada ou torcida, definida por quatro vértices.
step-straight-to-starting-point = O comando desloca a ferramenta da posição atual, em linha reta no espaço, para o ponto de partida 1.
step-mill-line-to-its-end = A ferramenta fresa depois com o avanço programado { $q-milling-feed } até ao ponto final da linha: na primeira linha, até ao ponto 2, com metade do avanço; em cada uma das seguintes, até um ponto que o comando calcula a partir do ponto 2 e da deslocação em direção ao ponto 3.
step-rapid-back-to-start-of-line = Daí o comando desloca a ferramenta em avanço rápido (FMAX) na direção positiva do eixo do cabeçote, até um diâmetro da ferramenta acima da extremidade mais alta da linha, e depois de volta ao ponto de partida da linha (na primeira linha, o ponto 1).
step-down-to-last-height = No ponto de partida, o comando leva a ferramenta ao último valor que ela tinha aí no eixo do cabeçote.
step-move-to-start-of-next-line = O comando desloca depois a ferramenta nos três eixos, do ponto 1 em direção ao ponto 4, para a linha seguinte.
step-above-highest-point = No fim, o comando posiciona a ferramenta um diâmetro da ferramenta acima do ponto mais alto introduzido no eixo do cabeçote.
note-cutting-direction-of-surface = O ponto de partida, e com ele a direção de fresagem, pode escolher-se livremente: o comando executa os cortes do ponto 1 para o ponto 2 e, no conjunto, avança dos pontos 1 e 2 para os pontos 3 e 4. O ponto 1 pode ficar em qualquer vértice da superfície.
note-surface-quality-with-end-mills = Com fresas cilíndricas, a qualidade da superfície pode ser melhorada: em superfícies pouco inclinadas, com um corte a empurrar (coordenada do ponto 1 no eixo do cabeçote maior do que a do ponto 2); em superfícies muito inclinadas, com um corte a puxar (coordenada do ponto 1 no eixo do cabeçote menor do que a do ponto 2); em superfícies torcidas, com a direção principal de corte (do ponto 1 para o ponto 2) orientada segundo a maior inclinação.
note-surface-quality-with-ball-end-mills = Com fresas esféricas, a qualidade das superfícies torcidas pode ser melhorada se a direção principal de corte (do ponto 1 para o ponto 2) for perpendicular à direção da maior inclinação.
note-straight-to-start-without-collision = Perigo de colisão! O comando desloca a ferramenta da posição atual, em linha reta no espaço, para o ponto de partida 1. Posicione previamente a ferramenta de modo que não possa colidir com a peça nem com os dispositivos de fixação.
note-positions-with-r0 = O comando desloca a ferramenta entre as posições introduzidas com correção de raio R0.
note-centre-cut-or-pilot-drill = Se necessário, utilize uma fresa com navalha frontal que corte ao centro (DIN 844) ou faça um furo prévio com o ciclo 21.

# --- 232 ---
cycle-face-milling = Fresar plano
    .nc = FRESAR PLANO
    .purpose = Fresa uma superfície plana em vários passos, com uma medida excedente de acabamento e segundo uma de três estratégias.
step-position-beside-surface = A partir da posição atual, o comando posiciona a ferramenta em avanço rápido (FMAX) e com lógica de posicionamento no ponto de partida 1, que fica ao lado da peça, afastado dela no valor do raio da ferramenta mais a distância lateral { $q-side-clearance }:
say-plane-then-spindle-axis = se a ferramenta estiver acima da 2ª distância de segurança { $q-second-set-up-clearance }: primeiro no plano de maquinação, depois no eixo do cabeçote
say-second-clearance-then-plane = caso contrário: primeiro para a 2ª distância de segurança { $q-second-set-up-clearance }, depois no plano de maquinação
step-feed-to-face-infeed = A ferramenta desloca-se depois no eixo do cabeçote com o avanço de posicionamento prévio { $q-pre-positioning-feed } até à profundidade de passo seguinte, calculada pelo comando.
step-mill-face-line = A ferramenta fresa com o avanço programado { $q-milling-feed } até ao ponto final 2:
say-line-ends-outside-surface = { $q-face-milling-strategy } = 0: fora da superfície; o comando calcula-o a partir do ponto de partida, da longitude e da distância lateral { $q-side-clearance } programados e do raio da ferramenta
say-line-ends-inside-surface = { $q-face-milling-strategy } = 1: dentro da superfície; o comando calcula-o a partir do ponto de partida e da longitude programados e do raio da ferramenta
say-line-ends-outside-surface-by-lines = { $q-face-milling-strategy } = 2: fora da superfície; o comando calcula-o a partir do ponto de partida, da longitude e da distância lateral { $q-side-clearance } programados e do raio da ferramenta
step-step-over-on-face = O comando calcula a deslocação lateral a partir da largura programada { $q-second-side-length }, do raio da ferramenta e do fator máximo de sobreposição de trajetórias { $q-max-path-overlap }. Desloca a ferramenta lateralmente para o ponto de partida da linha seguinte:
say-step-over-outside = { $q-face-milling-strategy } = 0: com o avanço de posicionamento prévio { $q-pre-positioning-feed }
say-step-over-inside = { $q-face-milling-strategy } = 1: dentro da peça, com o avanço de fresagem { $q-milling-feed }
say-retract-and-return-to-next-line = { $q-face-milling-strategy } = 2: a ferramenta desloca-se no eixo do cabeçote para a distância de segurança { $q-set-up-clearance } acima da profundidade de passo atual e regressa com o avanço de posicionamento prévio { $q-pre-positioning-feed } diretamente ao ponto de partida da linha seguinte
step-mill-next-face-line = A ferramenta fresa depois a linha seguinte:
say-back-towards-start = { $q-face-milling-strategy } = 0: de volta em direção ao ponto de partida 1
say-back-towards-start-inside = { $q-face-milling-strategy } = 1: de volta em direção ao ponto de partida 1; a deslocação para a linha seguinte faz-se de novo dentro da peça
say-down-and-towards-end = { $q-face-milling-strategy } = 2: volta à profundidade de passo atual e segue depois em direção ao ponto final 2
step-repeat-until-face-milled = O processo repete-se até a superfície definida estar totalmente fresada. No fim da última trajetória, a ferramenta avança para a profundidade de maquinação seguinte. Para evitar percursos em vazio, a superfície é então maquinada pela ordem inversa.
until-face-infeeds-done = estejam executados todos os passos exceto o último
step-finish-face = No último passo é fresada apenas a medida excedente de acabamento introduzida { $q-floor-allowance }, com o avanço de acabamento { $q-finishing-feed }.
step-rapid-back-to-second-clearance = No fim, o comando retira a ferramenta em avanço rápido (FMAX) para a 2ª distância de segurança { $q-second-set-up-clearance }.
note-three-face-milling-strategies = Estão disponíveis três estratégias. { $q-face-milling-strategy } = 0: trajetórias em meandro, passo lateral fora da superfície a maquinar. { $q-face-milling-strategy } = 1: trajetórias em meandro, passo lateral dentro da superfície a maquinar. { $q-face-milling-strategy } = 2: linha a linha, com recuo e passo lateral com o avanço de posicionamento.
note-levels-in-reverse-order = Para evitar percursos em vazio, cada nível seguinte é maquinado pela ordem inversa.
note-second-clearance-without-collision = Introduza a 2ª distância de segurança { $q-second-set-up-clearance } de modo que a ferramenta não possa colidir com a peça nem com os dispositivos de fixação.
note-equal-end-and-start-do-nothing = Se o ponto de partida do 3.º eixo { $q-starting-point-tool } e o ponto final do 3.º eixo { $q-end-point-tool } forem iguais, o comando não executa o ciclo (a profundidade programada é 0).
