# Turning: recess turning, recessing and threads.

# --- 841, 842, 840, 851, 852, 850 ---
cycle-simple-radial-recess-turning = Tornear ranhura radial, simples
    .nc = TORNEAR RANHURA RADIAL SIMPLES
    .purpose = Maquina ranhuras retangulares em direção longitudinal, alternando movimentos de ranhurar e de tornear: desbaste, acabamento ou ambos. Os cortes de desbaste são paralelos aos eixos.
cycle-extended-radial-recess-turning = Tornear ranhura radial, ampliado
    .nc = TORNEAR RANHURA RADIAL AMPLIADO
    .purpose = Maquina ranhuras em direção longitudinal, alternando movimentos de ranhurar e de tornear: desbaste, acabamento ou ambos. Os cortes de desbaste são paralelos aos eixos. A ranhura pode ter paredes laterais inclinadas, esquinas arredondadas e um chanfre ou um arredondamento no início e no fim do contorno.
cycle-radial-contour-recess-turning = Tornear ranhura radial, contorno
    .nc = TORNEAR RANHURA RADIAL CONTORNO
    .purpose = Maquina ranhuras de qualquer forma em direção longitudinal, alternando movimentos de ranhurar e de tornear: desbaste, acabamento ou ambos. Os cortes de desbaste são paralelos aos eixos.
cycle-simple-axial-recess-turning = Tornear ranhura axial, simples
    .nc = TORNEAR RANHURA AXIAL SIMPLES
    .purpose = Maquina ranhuras retangulares em direção transversal (numa face), alternando movimentos de ranhurar e de tornear: desbaste, acabamento ou ambos. Os cortes de desbaste são paralelos aos eixos.
cycle-extended-axial-recess-turning = Tornear ranhura axial, ampliado
    .nc = TORNEAR RANHURA AXIAL AMPLIADO
    .purpose = Maquina ranhuras em direção transversal, alternando movimentos de ranhurar e de tornear: desbaste, acabamento ou ambos. Os cortes de desbaste são paralelos aos eixos. A ranhura pode ter paredes laterais inclinadas, esquinas arredondadas e um chanfre ou um arredondamento no início e no fim do contorno.
cycle-axial-contour-recess-turning = Tornear ranhura axial, contorno
    .nc = TORNEAR RANHURA AXIAL CONTORNO
    .purpose = Maquina ranhuras de qualquer forma em direção transversal, alternando movimentos de ranhurar e de tornear: desbaste, acabamento ou ambos. Os cortes de desbaste são paralelos aos eixos.

# --- 861, 862, 860, 871, 872, 870 ---
cycle-radial-recessing = Ranhurar radial
    .nc = RANHURAR RADIAL
    .purpose = Abre radialmente ranhuras retangulares: desbaste, acabamento ou ambos. Os cortes de desbaste são paralelos aos eixos.
cycle-extended-radial-recessing = Ranhurar radial, ampliado
    .nc = RANHURAR RADIAL AMPLIADO
    .purpose = Abre radialmente ranhuras: desbaste, acabamento ou ambos. Os cortes de desbaste são paralelos aos eixos. A ranhura pode ter paredes laterais inclinadas, esquinas arredondadas e um chanfre ou um arredondamento no início e no fim do contorno.
cycle-radial-contour-recessing = Ranhurar radial, contorno
    .nc = RANHURAR RADIAL CONTORNO
    .purpose = Abre radialmente ranhuras de qualquer forma: desbaste, acabamento ou ambos. Os cortes de desbaste são paralelos aos eixos.
cycle-axial-recessing = Ranhurar axial
    .nc = RANHURAR AXIAL
    .purpose = Abre axialmente ranhuras retangulares (ranhurar na face): desbaste, acabamento ou ambos. Os cortes de desbaste são paralelos aos eixos.
cycle-extended-axial-recessing = Ranhurar axial, ampliado
    .nc = RANHURAR AXIAL AMPLIADO
    .purpose = Abre axialmente ranhuras (ranhurar na face): desbaste, acabamento ou ambos. Os cortes de desbaste são paralelos aos eixos. A ranhura pode ter paredes laterais inclinadas, esquinas arredondadas e um chanfre ou um arredondamento no início e no fim do contorno.
cycle-axial-contour-recessing = Ranhurar axial, contorno
    .nc = RANHURAR AXIAL CONTORNO
    .purpose = Abre axialmente ranhuras de qualquer forma (ranhurar na face): desbaste, acabamento ou ambos. Os cortes de desbaste são paralelos aos eixos.

# --- 831, 832, 830 ---
cycle-longitudinal-thread = Rosca longitudinal
    .nc = ROSCA LONGITUDINAL
    .purpose = Torneia roscas longitudinais de uma ou várias entradas.
cycle-extended-thread = Rosca ampliada
    .nc = ROSCA AMPLIADA
    .purpose = Torneia roscas longitudinais, transversais ou cónicas, de uma ou várias entradas.
cycle-contour-parallel-thread = Rosca paralela ao contorno
    .nc = ROSCA PARALELA AO CONTORNO
    .purpose = Torneia roscas longitudinais ou transversais de qualquer forma, de uma ou várias entradas.

# --- roughing of grooves ---
step-take-tool-position-as-start = O comando utiliza a posição da ferramenta na chamada do ciclo como ponto de partida do ciclo.
step-start-recess-at-contour-start-diameter = Se a coordenada X do ponto de partida for menor do que o diâmetro no início do contorno { $q-contour-start-diameter }, o comando posiciona a ferramenta no eixo X em { $q-contour-start-diameter } e inicia aí o ciclo.
step-start-recess-at-contour-start-z = Se a coordenada Z do ponto de partida for menor do que o início do contorno em Z { $q-contour-start-z }, o comando posiciona a ferramenta no eixo Z em { $q-contour-start-z } e inicia aí o ciclo.
step-start-recess-at-contour-point-x = Se a coordenada X do ponto de partida for menor do que a do ponto de partida do contorno, o comando posiciona a ferramenta em X no ponto de partida do contorno e inicia aí o ciclo.
step-start-recess-at-contour-point-z = Se a coordenada Z do ponto de partida for menor do que a do ponto de partida do contorno, o comando posiciona a ferramenta em Z no ponto de partida do contorno e inicia aí o ciclo.
step-rapid-to-first-recess-z = O comando posiciona a ferramenta em Z em avanço rápido (primeira posição de ranhurar).
step-rapid-to-first-recess-x = O comando posiciona a ferramenta em X em avanço rápido (primeira posição de ranhurar).
step-recess-from-start-to-first-depth = O comando ranhura do ponto de partida do ciclo até à primeira profundidade de passo.
step-recess-to-first-depth = O comando ranhura até à primeira profundidade de passo.
step-rough-groove-lengthwise = O comando desbasta a zona entre a posição de partida e o ponto final em direção longitudinal, com o avanço { $q-turning-roughing-feed }.
step-rough-groove-crosswise = O comando desbasta a zona entre a posição de partida e o ponto final em direção transversal, com o avanço { $q-turning-roughing-feed }.
step-choose-side-of-next-recess = A direção de maquinação { $q-recess-direction } determina onde se faz o passo seguinte:
say-lift-off-and-return = { $q-recess-direction } = 1 (só numa direção): o comando afasta a ferramenta no valor da distância de segurança, fá-la voltar em avanço rápido e aproxima-a de novo do contorno com o avanço definido
say-infeed-at-both-sides = { $q-recess-direction } = 0 (nas duas direções): o passo faz-se dos dois lados
step-recess-to-next-depth = A ferramenta ranhura até à profundidade de passo seguinte.
until-groove-depth-reached = seja atingida a profundidade da ranhura
step-recess-at-both-walls = O comando volta a posicionar a ferramenta à distância de segurança e ranhura uma vez em cada parede lateral.
step-infeed-parallel-to-axis = O comando executa em avanço rápido um passo paralelo aos eixos. O passo lateral é de 0,8 vezes a largura de corte.
step-recess-radially = O comando maquina a zona entre a posição de partida e o ponto final em direção radial, com o avanço { $q-turning-roughing-feed }.
step-recess-axially = O comando maquina a zona entre a posição de partida e o ponto final em direção axial, com o avanço { $q-turning-roughing-feed }.
until-groove-width-reached = seja atingida a largura da ranhura
until-groove-shape-reached = seja atingida a forma da ranhura

# --- finishing of grooves ---
step-rapid-to-first-flank = O comando posiciona a ferramenta em avanço rápido no primeiro flanco da ranhura.
step-rapid-again-to-first-flank = { step-rapid-to-first-flank }
step-rapid-to-second-flank = O comando posiciona a ferramenta em avanço rápido no segundo flanco da ranhura.
step-finish-groove-wall = O comando faz o acabamento da parede lateral da ranhura com o avanço { $q-turning-finishing-feed }.
step-finish-second-groove-wall = { step-finish-groove-wall }
step-finish-groove-walls = O comando faz o acabamento das paredes laterais da ranhura com o avanço { $q-turning-finishing-feed }.
step-finish-groove-floor = O comando faz o acabamento do fundo da ranhura com o avanço definido.
step-finish-groove-floor-or-all = O comando faz o acabamento com o avanço definido:
say-finish-whole-groove = se tiver sido introduzido um raio { $q-contour-corner-radius } para a esquina do contorno, de toda a ranhura numa só passagem
say-finish-floor-only = caso contrário, só do fundo da ranhura
step-retract-from-groove = O comando faz recuar a ferramenta em avanço rápido.
step-finish-half-of-width = O comando faz o acabamento de metade da largura da ranhura com o avanço definido.
step-finish-other-half-of-width = O comando faz o acabamento da outra metade da largura da ranhura com o avanço definido.
step-finish-half-of-groove = O comando faz o acabamento de metade da ranhura com o avanço definido.
step-finish-other-half-of-groove = O comando faz o acabamento da outra metade da ranhura com o avanço definido.

# --- threads ---
step-move-before-thread-and-infeed = O comando posiciona a ferramenta em avanço rápido à distância de segurança à frente da rosca e executa um passo.
step-cut-thread-parallel-to-axis = O comando executa um corte longitudinal paralelo ao eixo. Sincroniza o avanço e as rotações do cabeçote de modo que resulte o passo de rosca definido.
step-cut-thread-along-line = O comando corta a rosca entre o ponto de partida e o ponto final. Sincroniza o avanço e as rotações do cabeçote de modo que resulte o passo de rosca definido.
step-cut-thread-along-contour = O comando corta a rosca paralelamente ao contorno da rosca definido. Sincroniza o avanço e as rotações do cabeçote de modo que resulte o passo de rosca definido.
step-lift-off-thread = O comando afasta a ferramenta em avanço rápido no valor da distância de segurança.
step-infeed-at-angle = O comando executa um passo. Os passos seguem o ângulo de passo { $q-thread-infeed-angle }.
until-thread-depth-reached = seja atingida a profundidade da rosca
step-make-air-cuts = O comando executa tantas passagens em vazio quantas { $q-number-of-air-cuts } indicar.
step-infeed-for-next-start = Para a entrada de rosca seguinte, o comando leva a ferramenta de novo ao primeiro passo. O corte começa num ângulo do cabeçote deslocado no intervalo angular entre as entradas.
until-all-thread-starts-cut = estejam cortadas tantas entradas de rosca quantas { $q-number-of-thread-starts } indicar

# --- conditions ---
condition-cutting-limit-wanted = { $q-cutting-limit } = 1
condition-taper-angle-given = { $q-taper-dimensioning } definir o cone pelo seu ângulo
condition-start-diameter-given = { $q-taper-dimensioning } definir o cone pelo diâmetro no início do contorno
condition-start-z-given = { $q-taper-dimensioning } definir o cone pela coordenada Z do início do contorno
condition-end-diameter-given = { $q-taper-dimensioning } definir o cone pelo diâmetro no fim do contorno
condition-end-z-given = { $q-taper-dimensioning } definir o cone pela coordenada Z do fim do contorno

# --- errors ---
guard-recess-offset-too-great = A deslocação lateral é superior a 80% da largura de corte efetiva, que é a largura de corte menos o dobro do raio da navalha.

# --- notes: grooves ---
note-recess-turning-alternates = Ao tornear ranhuras, alternam-se movimentos de ranhurar até à profundidade de passo e cortes de desbaste. Assim, a maquinação precisa do menor número possível de recuos e passos.
note-groove-extended-scope = Funções ampliadas: no início e no fim do contorno pode acrescentar-se um chanfre ou um arredondamento; podem definir-se ângulos para as paredes laterais da ranhura; podem acrescentar-se raios nas esquinas do contorno.
note-recess-cuts-get-shorter = Depois do segundo passo, o comando encurta 0,1 mm cada corte seguinte. Isto reduz a carga lateral sobre a ferramenta. Se no ciclo tiver sido introduzida uma largura de deslocação { $q-recess-offset-width }, é esse o valor em que o corte é encurtado. O material restante é eliminado com um único movimento de ranhurar no fim da operação. Se a deslocação lateral exceder 80% da largura de corte efetiva (largura de corte − 2 × raio da navalha), o comando emite um aviso de erro.
title-groove-with-chamfers = Ranhura com chanfres num escalão torneado (programa de exemplo)

# --- notes: threads ---
note-threads-with-several-starts = O ciclo pode fazer roscas de uma ou de várias entradas.
note-standard-thread-depth = Se no ciclo não tiver sido introduzida uma profundidade da rosca, o ciclo utiliza uma profundidade de rosca normalizada.
note-standard-thread-depth__longitudinal-thread = Se no ciclo não tiver sido introduzida uma profundidade da rosca, o ciclo utiliza a profundidade da rosca segundo a norma ISO 1502.
note-thread-outside-or-inside = O ciclo pode ser utilizado para maquinação exterior e interior.
note-extended-thread-scope = Funções ampliadas: pode escolher-se uma rosca longitudinal ou transversal; os parâmetros do tipo de cotagem do cone, do ângulo do cone e do ponto de partida do contorno em X definem diversas roscas cónicas; o percurso de arranque e o percurso de ultrapassagem definem os troços em que o eixo de avanço é acelerado e travado.
note-overrun-after-contour = Perigo de colisão! Depois do contorno programado, o ciclo { $cycle } continua a deslocar a ferramenta ao longo do percurso de ultrapassagem { $q-overrun-path }. Tenha em conta o espaço disponível.
note-clearance-is-starting-path = O comando utiliza a distância de segurança { $q-thread-clearance } como percurso de arranque. Tem de ser suficientemente longa para que os eixos de avanço sejam acelerados até à velocidade necessária.
note-pitch-is-overrun-path = O comando utiliza o passo de rosca { $q-turned-thread-pitch } como percurso de ultrapassagem. Tem de ser suficientemente longo para que os eixos de avanço sejam travados.
note-extended-thread-has-paths = O ciclo 832 tem parâmetros para o percurso de arranque e o percurso de ultrapassagem.
note-starting-path-long-enough = O percurso de arranque { $q-starting-path } tem de ser suficientemente longo para que os eixos de avanço sejam acelerados até à velocidade necessária.
note-overrun-path-long-enough = O percurso de ultrapassagem { $q-overrun-path } tem de ser suficientemente longo para que os eixos de avanço sejam travados.
note-paths-outside-contour = Tanto o percurso de arranque como o percurso de ultrapassagem ficam fora do contorno definido.
note-override-while-thread-cutting = O potenciómetro do avanço não tem efeito enquanto o comando corta a rosca. O potenciómetro das rotações continua ativo dentro de limites definidos pelo fabricante da máquina. Consulte o manual da máquina.
note-thread-with-separate-holder = Em alguns tipos de máquina, a ferramenta de tornear não está fixada no cabeçote de fresar, mas num suporte à parte, ao lado dele. Aí, a ferramenta de tornear não pode ser rodada 180°, por exemplo para fazer roscas exteriores e interiores com uma só ferramenta. Para utilizar numa máquina dessas uma ferramenta de exterior em maquinação interior, maquine no campo de diâmetros negativo (−X) e inverta o sentido de rotação da peça. Com um posicionamento prévio no campo de diâmetros negativo, o comando inverte o efeito da posição da rosca { $q-thread-position }: 1 é então uma rosca exterior e 0 uma rosca interior.
note-thread-retracts-directly = Perigo de colisão! A ferramenta recua em trajetória direta para a posição de partida. Posicione-a sempre de modo que, no fim do ciclo, o comando possa alcançar o ponto de partida sem colisão.

# --- notes: contours from a subprogram ---
note-contour-by-cycle-14 = O contorno é descrito num subprograma, com funções de trajetória ou funções FK. Antes da chamada do ciclo, programe o ciclo 14 (contorno) para definir o número do subprograma.
note-local-parameters-in-contour = Se forem utilizados parâmetros locais QL no subprograma de contorno, têm de ser também atribuídos ou calculados no subprograma de contorno.
note-cutting-limit-limits-area = O limite de corte delimita a zona do contorno que é maquinada. Os percursos de aproximação e de saída podem ultrapassar o limite de corte.
note-cutting-limit-by-tool-position = A posição da ferramenta antes da chamada do ciclo influencia o efeito do limite de corte: o comando retira o material do lado do limite de corte em que a ferramenta se encontra antes da chamada do ciclo.
