# Tapping and thread milling.

# --- tapping ---
cycle-tapping = Roscar com mandril compensador (novo)
    .nc = ROSCAR NOVO
    .purpose = Corta uma rosca num só passo, com mandril compensador.
cycle-rigid-tapping = Roscar rígido sem mandril compensador (novo)
    .nc = ROSCAR RÍGIDO NOVO
    .purpose = Corta uma rosca num só passo, sem mandril compensador.
cycle-tapping-with-chip-breaking = Roscar com rotura de apara
    .nc = ROSCAR ROTURA DE APARA
    .purpose = Corta uma rosca em vários passos, sem mandril compensador. Um parâmetro determina se a ferramenta sai totalmente do furo na rotura de apara.
step-tap-in-one-movement = A ferramenta desloca-se num só movimento até à profundidade da rosca { $q-thread-depth }.
step-reverse-dwell-and-retract = O sentido de rotação do cabeçote é invertido e, depois do tempo de espera { $q-dwell-at-bottom }, a ferramenta recua para a distância de segurança { $q-set-up-clearance }.
step-reverse-and-retract = O sentido de rotação do cabeçote é invertido e a ferramenta recua para a distância de segurança { $q-set-up-clearance }.
step-reverse-spindle-again = À distância de segurança, o sentido de rotação do cabeçote é invertido de novo.
step-stop-spindle-at-set-up-clearance = O comando detém o cabeçote à distância de segurança.
step-rapid-to-set-up-clearance-and-orient = O comando desloca a ferramenta no eixo do cabeçote, em avanço rápido (FMAX), para a distância de segurança { $q-set-up-clearance } acima da superfície da peça e orienta aí o cabeçote para { $q-spindle-orientation-angle }.
step-tap-to-next-depth = A ferramenta desce mais um passo { $q-depth-for-chip-breaking }.
step-reverse-and-break-chip = O sentido de rotação do cabeçote é invertido, a ferramenta recua (com as rotações aumentadas pelo fator { $q-retraction-speed-factor }, se tiver sido introduzido) e o sentido é de novo invertido para o passo seguinte. O recuo faz-se assim:
say-tap-leaves-hole = { $q-chip-breaking-turns } = 0: a ferramenta sai totalmente do furo, para arrefecer
say-tap-goes-back-some-turns = caso contrário, a ferramenta recua { $q-chip-breaking-turns } vezes o passo de rosca { $q-thread-pitch }
step-tap-back-to-set-up-clearance = A ferramenta recua para a distância de segurança { $q-set-up-clearance }.
note-sign-of-thread-depth = O sinal da profundidade da rosca { $q-thread-depth } determina a direção da maquinação. Com a profundidade da rosca 0, o comando não executa o ciclo.
note-thread-depth-gives-direction = O sinal da profundidade da rosca { $q-thread-depth } determina a direção da maquinação.
note-positive-thread-depth-reverses = Perigo de colisão! Com uma profundidade positiva, o comando inverte o cálculo da posição prévia: a ferramenta desloca-se no eixo da ferramenta, em avanço rápido, para a distância de segurança abaixo da superfície da peça.
note-floating-tap-holder = A ferramenta tem de estar fixada num mandril compensador, que compensa as tolerâncias do avanço e das rotações durante a maquinação.
note-overrides-while-tapping = Enquanto o ciclo é executado, o potenciómetro das rotações do cabeçote não atua. O do avanço ainda atua em parte; o fabricante da máquina determina como (consulte o manual da máquina).
note-right-hand-with-m3 = Ligue o cabeçote com M3 para roscas à direita, com M4 para roscas à esquerda.
note-feed-from-speed-and-pitch = Determine o avanço com F = S × p. F: avanço (mm/min), S: rotações do cabeçote (rpm), p: passo de rosca (mm).
note-retract-after-interruption = Se durante a roscagem for premida a tecla externa de paragem, o comando mostra uma softkey com que se pode retirar a ferramenta.
note-feed-follows-spindle-speed = O comando calcula o avanço a partir das rotações do cabeçote. Se durante a roscagem se rodar o potenciómetro do avanço, o comando adapta automaticamente o avanço. O potenciómetro das rotações do cabeçote não está ativo.
note-spindle-stopped-after-tapping = No fim do ciclo, o cabeçote fica parado. Ligue-o de novo com M3 (ou M4) antes da maquinação seguinte.
note-retract-by-soft-key = Se durante a roscagem for premida a tecla externa de paragem, o comando mostra a softkey de deslocação manual. Depois de premida esta softkey, a ferramenta pode ser retirada de forma controlada com a tecla de direção positiva do eixo do cabeçote ativo.
note-retraction-speed-is-limited = Se em { $q-retraction-speed-factor } estiver definido um fator de rotações para um recuo mais rápido, o comando limita as rotações ao maior valor permitido na gama de velocidades ativa.

# --- thread milling: cycles ---
cycle-thread-milling = Fresar rosca
    .nc = FRESAR ROSCA
    .purpose = Fresa uma rosca em material previamente furado.
cycle-thread-milling-countersinking = Fresar rosca com rebaixamento
    .nc = FRESAR ROSCA REBAIXAM.
    .purpose = Fresa uma rosca em material previamente furado e maquina um chanfre por rebaixamento.
cycle-thread-drilling-milling = Furar e fresar rosca
    .nc = FURAR E FRESAR ROSCA
    .purpose = Fura em material maciço e fresa depois a rosca com a mesma ferramenta.
cycle-helical-thread-drilling-milling = Furar e fresar rosca em hélice
    .nc = FRESAR ROSCA EM HÉLICE
    .purpose = Fresa uma rosca em hélice em material maciço.
cycle-outside-thread-milling = Fresar rosca exterior
    .nc = FRESAR ROSCA EXTERIOR
    .purpose = Fresa uma rosca exterior e maquina um chanfre por rebaixamento.

# --- thread milling: steps ---
group-countersinking = Rebaixamento
group-countersinking-at-front = Rebaixamento frontal
group-drilling-the-hole = Furação
group-milling-the-thread = Fresagem da rosca
step-feed-to-start-plane-of-threads = A ferramenta desloca-se com o avanço de posicionamento prévio { $q-in-and-out-feed } para o plano de partida, que resulta do sinal do passo de rosca { $q-thread-pitch }, do tipo de fresagem { $q-milling-type } e do número de filetes por passo { $q-threads-per-step }.
step-feed-to-start-plane-of-thread = A ferramenta desloca-se com o avanço de posicionamento prévio { $q-in-and-out-feed } para o plano de partida da rosca, que resulta do sinal do passo de rosca { $q-thread-pitch } e do tipo de fresagem { $q-milling-type }.
step-feed-to-start-plane-of-helix = A ferramenta desloca-se com o avanço de posicionamento prévio { $q-in-and-out-feed } para o plano de partida da rosca.
step-approach-thread-and-compensate = A ferramenta desloca-se tangencialmente em hélice para o diâmetro da rosca { $q-nominal-diameter }. Ao mesmo tempo, faz um movimento de compensação no eixo da ferramenta, para que a trajetória da rosca comece no plano de partida programado.
step-approach-thread = A ferramenta desloca-se tangencialmente em hélice para o diâmetro da rosca { $q-nominal-diameter }.
step-approach-and-mill-one-turn = A ferramenta desloca-se tangencialmente em hélice para o diâmetro da rosca { $q-nominal-diameter } e fresa a rosca com um movimento helicoidal de 360°.
step-mill-thread-in-turns = A ferramenta fresa a rosca com o avanço { $q-milling-feed }, conforme os filetes por passo { $q-threads-per-step }:
say-thread-in-one-turn = { $q-threads-per-step } = 0: num só movimento helicoidal
say-thread-on-continuous-helix = { $q-threads-per-step } = 1: num movimento helicoidal contínuo
say-thread-on-several-helices = { $q-threads-per-step } > 1: em vários movimentos helicoidais desfasados
step-mill-thread-downwards = O comando desloca a ferramenta para baixo numa hélice contínua, até ser atingida a profundidade da rosca { $q-thread-depth }.
step-depart-from-thread = A ferramenta sai tangencialmente do contorno e regressa ao ponto de partida no plano de maquinação.
step-end-of-thread-milling = No fim do ciclo, o comando desloca a ferramenta em avanço rápido:
step-feed-to-countersinking-depth = Se não tiver sido introduzida nenhuma distância lateral { $q-clearance-to-wall }, a ferramenta desloca-se com o avanço de posicionamento prévio { $q-in-and-out-feed } até à profundidade de rebaixamento { $q-countersinking-depth }, descontada a distância de segurança, e depois com o avanço de rebaixamento { $q-countersinking-feed } até à profundidade de rebaixamento.
step-feed-directly-to-countersinking-depth = Se tiver sido introduzida uma distância lateral { $q-clearance-to-wall }, o comando desloca a ferramenta logo com o avanço de posicionamento prévio { $q-in-and-out-feed } até à profundidade de rebaixamento { $q-countersinking-depth }.
step-countersink-on-circle = Consoante o espaço disponível, o comando aproxima a ferramenta suavemente, a partir do centro ou com um posicionamento prévio lateral, e executa um movimento circular.
step-feed-to-depth-at-front = A ferramenta desloca-se com o avanço de posicionamento prévio { $q-in-and-out-feed } até à profundidade de rebaixamento frontal { $q-depth-at-front }.
step-feed-to-depth-at-front-before-or-after = Se o rebaixamento for feito antes da rosca ({ $q-countersinking-moment } = 0), a ferramenta desloca-se com o avanço de rebaixamento { $q-countersinking-feed } até à profundidade de rebaixamento frontal { $q-depth-at-front }; se for feito depois da rosca, com o avanço de posicionamento prévio { $q-in-and-out-feed }.
step-countersink-at-front = Sem correção de raio, o comando desloca a ferramenta num semicírculo desde o centro até ao desvio frontal { $q-offset-at-front } e executa um movimento circular com o avanço de rebaixamento { $q-countersinking-feed }.
step-countersink-at-front__thread-drilling-milling = Sem correção de raio, o comando desloca a ferramenta num semicírculo desde o centro até ao desvio frontal { $q-offset-at-front } e executa um movimento circular com o avanço { $q-plunging-feed }.
step-leave-countersink-at-front = O comando volta a levar a ferramenta num semicírculo ao centro do furo.
step-leave-countersink-at-front__outside-thread-milling = O comando volta a levar a ferramenta num semicírculo ao ponto de partida.
step-countersink-after-thread = Se o rebaixamento for feito depois da rosca ({ $q-countersinking-moment } = 1), é executado agora, como acima descrito.
step-drill-towards-plunging-depth = A ferramenta fura com o avanço { $q-plunging-feed } em direção à profundidade de passo { $q-plunging-depth }; com rotura de apara, detém-se cada vez que tiver descido { $q-depth-for-chip-breaking }.
step-retract-to-break-chip = Para a rotura de apara, a ferramenta recua { $q-chip-breaking-retraction }.
step-retract-and-return-to-one-stop-distance = O comando retira a ferramenta em avanço rápido para a distância de segurança e fá-la voltar em avanço rápido (FMAX) até à distância de paragem prévia { $q-upper-advanced-stop-distance } acima da profundidade atingida.
until-hole-depth-reached = seja atingida a profundidade total do furo { $q-total-hole-depth }
step-move-beside-stud = O comando desloca a ferramenta do centro da ilha, ao longo do eixo principal do plano de maquinação, para o ponto de partida do rebaixamento frontal. Este resulta do raio da rosca, do raio da ferramenta e do passo de rosca.
step-move-beside-stud-without-countersinking = Se não houver rebaixamento frontal, o comando desloca a ferramenta para o ponto de partida da fresagem da rosca, que é o mesmo do rebaixamento frontal.

# --- thread milling: conditions and guards ---
guard-no-depth-entered = Todas as profundidades são 0: nada é maquinado.
guard-depth-signs-differ = As profundidades têm sinais diferentes. Introduza o mesmo sinal para todas.
guard-thread-near-countersinking-depth = A profundidade da rosca tem de ser menor do que a profundidade de rebaixamento em, pelo menos, um terço do passo de rosca.
guard-thread-near-hole-depth = A profundidade da rosca tem de ser menor do que a profundidade total do furo em, pelo menos, um terço do passo de rosca.

# --- thread milling: notes ---
note-thread-approach-on-half-circle = A aproximação ao diâmetro da rosca faz-se num semicírculo, do centro para fora. Se o diâmetro da ferramenta for apenas um quarto do diâmetro da rosca, a ferramenta é previamente posicionada de lado.
note-compensation-before-approach = Antes da aproximação, o comando faz um movimento de compensação no eixo da ferramenta, que é, no máximo, de metade do passo de rosca. Certifique-se de que há espaço suficiente no furo.
note-thread-depth-moves-start = Se a profundidade da rosca for alterada, o comando altera automaticamente o ponto de partida do movimento helicoidal.
note-depths-give-direction = Os sinais dos parâmetros de profundidade determinam a direção da maquinação, por esta ordem: 1. profundidade da rosca { $q-thread-depth }, 2. profundidade de rebaixamento { $q-countersinking-depth }, 3. profundidade frontal { $q-depth-at-front }.
note-depths-give-direction__thread-drilling-milling = Os sinais dos parâmetros de profundidade determinam a direção da maquinação, por esta ordem: 1. profundidade da rosca { $q-thread-depth }, 2. profundidade total do furo { $q-total-hole-depth }, 3. profundidade frontal { $q-depth-at-front }.
note-two-depths-give-direction = Os sinais dos parâmetros de profundidade determinam a direção da maquinação, por esta ordem: 1. profundidade da rosca { $q-thread-depth }, 2. profundidade frontal { $q-depth-at-front }.
note-depth-zero-leaves-out-step = Se for introduzido 0 numa das profundidades, o comando não executa esse passo de trabalho.
note-no-countersinking-depth-for-front = Para um rebaixamento frontal, defina a profundidade de rebaixamento { $q-countersinking-depth } como 0.
note-thread-depth-above-countersinking-depth = Introduza uma profundidade da rosca { $q-thread-depth } menor do que a profundidade de rebaixamento { $q-countersinking-depth } em, pelo menos, um terço do passo de rosca.
note-thread-depth-above-hole-depth = Introduza uma profundidade da rosca { $q-thread-depth } menor do que a profundidade total do furo { $q-total-hole-depth } em, pelo menos, um terço do passo de rosca.
note-helix-goes-into-workpiece = O tipo de fresagem (sentido sincronizado ou sentido contrário) resulta da rosca (à direita ou à esquerda) e do sentido de rotação da ferramenta, porque a única direção de maquinação possível é da superfície da peça para dentro da peça.
note-position-over-stud-centre = Programe uma frase de posicionamento para o ponto de partida (centro da ilha) no plano de maquinação com correção de raio R0.
note-offset-at-front-determined-before = Determine o desvio para o rebaixamento frontal antes de utilizar o ciclo. Introduza-o como distância do centro da ilha ao centro da ferramenta, sem correção.
note-internal-coolant-for-thread-milling = A máquina deve ter refrigeração interna através do cabeçote: refrigerante a, pelo menos, 30 bar, ar comprimido a, pelo menos, 6 bar.
note-profile-correction-by-delta-radius = Ao fresar roscas, o perfil da rosca fica muitas vezes distorcido, pelo que são necessárias correções próprias da ferramenta. Encontram-se no catálogo de ferramentas ou são indicadas pelo fabricante da ferramenta. A correção introduz-se na frase TOOL CALL com o valor delta { $mp-delta-radius }.
note-clockwise-tools-only = O ciclo só pode ser utilizado com ferramentas que rodem em sentido horário.
note-tools-of-both-rotations = O ciclo pode ser utilizado com ferramentas que rodem em sentido horário e com ferramentas que rodem em sentido anti-horário.
note-direction-of-inside-thread = A direção da maquinação depende do sinal do passo de rosca { $q-thread-pitch } e do tipo de fresagem { $q-milling-type }. Com ferramentas que rodem em sentido horário, uma rosca interior é fresada para Z+ se for à direita (+) em sentido sincronizado (+1, RL) ou à esquerda (−) em sentido contrário (−1, RR), e para Z− se for à direita (+) em sentido contrário (−1, RR) ou à esquerda (−) em sentido sincronizado (+1, RL).
note-direction-of-outside-thread = A direção da maquinação depende do sinal do passo de rosca { $q-thread-pitch } e do tipo de fresagem { $q-milling-type }. Com ferramentas que rodem em sentido horário, uma rosca exterior é fresada para Z− se for à direita (+) em sentido sincronizado (+1, RL) ou à esquerda (−) em sentido contrário (−1, RR), e para Z+ se for à direita (+) em sentido contrário (−1, RR) ou à esquerda (−) em sentido sincronizado (+1, RL).
note-feed-of-cutting-edge = Na fresagem de roscas, o avanço programado refere-se à navalha da ferramenta. O comando mostra o avanço do centro da ferramenta, pelo que o valor visualizado difere do programado.
note-mirroring-turns-thread = O sentido da rosca muda se o ciclo for executado juntamente com o ciclo 8 (espelhamento) em apenas um eixo.
note-same-signs-of-depths = Perigo de colisão! Introduza sempre o mesmo sinal em todas as profundidades, porque os ciclos contêm várias sequências independentes entre si. Para repetir, por exemplo, apenas o rebaixamento, introduza 0 como profundidade da rosca; é então a profundidade de rebaixamento que determina a direção da maquinação.
note-same-signs-of-depths__outside-thread-milling = Perigo de colisão! Introduza sempre o mesmo sinal em todas as profundidades, porque os ciclos contêm várias sequências independentes entre si. Para repetir, por exemplo, apenas o rebaixamento frontal, introduza 0 como profundidade da rosca; é então a profundidade frontal que determina a direção da maquinação.
note-tool-breakage-in-thread = Se a ferramenta partir durante o corte da rosca: pare a execução do programa, passe ao modo de funcionamento Posicionamento com introdução manual e desloque a ferramenta em linha reta para o centro do furo. Retire-a depois no eixo em que se faz o passo e substitua-a.
note-tool-breakage-in-thread__outside-thread-milling = Se a ferramenta partir durante o corte da rosca: pare a execução do programa, passe ao modo de funcionamento Posicionamento com introdução manual e afaste a ferramenta da rosca em linha reta. Retire-a depois no eixo em que se faz o passo e substitua-a.
