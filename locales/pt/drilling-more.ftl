# Drilling cycles: reaming, boring, universal drilling, back boring, bore milling, centring, single-lip drilling.

# --- shared sentences ---
step-retract-at-retraction-feed = A ferramenta recua com o avanço { $q-retraction-feed } para a distância de segurança { $q-set-up-clearance }.

# --- 201 ---
cycle-reaming = Alargar furo
    .nc = ALARGAR FURO
    .purpose = Alarga um furo num só passo. A ferramenta sai do furo com um avanço próprio.
step-ream-to-depth = A ferramenta alarga o furo com o avanço { $q-plunging-feed } até à profundidade programada { $q-depth }.

# --- 203 ---
cycle-universal-drilling = Furar universal
    .nc = FURAR UNIVERSAL
    .purpose = Abre um furo em passos que podem ir diminuindo. A apara pode ser quebrada várias vezes antes de a ferramenta ser retirada do furo.
step-drill-to-decreasing-plunging-depth = A ferramenta fura com o avanço { $q-plunging-feed } até à profundidade de passo seguinte. Se tiver sido introduzido um valor de redução { $q-decrement }, a profundidade de passo { $q-plunging-depth } diminui nesse valor em cada passo.
step-break-chip-or-retract = Entre dois passos, a ferramenta recua:
say-break-chip-by-retraction = com rotura de apara, no valor de { $q-chip-breaking-retraction }, tantas vezes quantas { $q-chip-breaks-before-retraction } indicar antes de a ferramenta ser retirada do furo
say-retract-and-return-at-rapid = sem rotura de apara, com o avanço { $q-retraction-feed } para a distância de segurança, onde permanece durante { $q-dwell-at-top }, se este tiver sido introduzido; daí desloca-se em avanço rápido (FMAX) até à distância de segurança acima da profundidade atingida

# --- 240 ---
cycle-centring = Centrar
    .nc = CENTRAR
    .purpose = Centra um furo até uma profundidade ou até um diâmetro.
step-centre-to-depth-or-diameter = A ferramenta centra com o avanço { $q-plunging-feed }:
say-centre-to-diameter = { $q-depth-or-diameter } = 1: até ao diâmetro de centragem { $q-centring-diameter }
say-centre-to-depth = { $q-depth-or-diameter } = 0: até à profundidade de centragem { $q-depth }
step-dwell-at-centring-bottom = A ferramenta permanece no fundo da centragem durante { $q-dwell-at-bottom }, se este tiver sido introduzido.
condition-centring-to-depth = { $q-depth-or-diameter } = 0
condition-centring-to-diameter = { $q-depth-or-diameter } = 1
guard-point-angle-missing = Para centrar até um diâmetro, defina na tabela de ferramentas o ângulo de ponta { $mp-drill-point-angle } da ferramenta.
guard-depth-zero__centring = A profundidade ou o diâmetro selecionado é 0: o comando não executa o ciclo.
guard-depth-positive__centring = A profundidade ou o diâmetro selecionado é positivo. Introduza um valor negativo ou permita valores positivos com o parâmetro de máquina { $mp-display-depth-err }.
note-sign-of-depth-or-diameter = O sinal do diâmetro { $q-centring-diameter } ou da profundidade { $q-depth }, conforme o que estiver selecionado, determina a direção da maquinação. Com o diâmetro ou a profundidade 0, o comando não executa o ciclo.
note-positive-diameter-or-depth-reverses = Perigo de colisão! Com um diâmetro ou uma profundidade positivos, o comando inverte o cálculo da posição prévia: a ferramenta desloca-se no eixo da ferramenta, em avanço rápido, para a distância de segurança abaixo da superfície da peça.

# --- 202 ---
cycle-boring = Mandrilar
    .nc = MANDRILAR
    .purpose = Mandrila um furo. No fundo, o cabeçote é orientado e a ferramenta pode afastar-se da parede antes de ser retirada.
step-bore-to-depth = A ferramenta mandrila com o avanço { $q-plunging-feed } até à profundidade { $q-depth }.
step-dwell-with-spindle-turning = Para cortar livremente, a ferramenta permanece no fundo do furo durante { $q-dwell-at-bottom }, se tiver sido introduzido, com o cabeçote a rodar.
step-orient-spindle-to-angle = O comando orienta o cabeçote para a posição definida em { $q-spindle-orientation-angle }.
step-disengage-from-wall = Se estiver selecionado um afastamento livre, a ferramenta desloca-se 0,2 mm (valor fixo) na direção { $q-disengaging-direction }.
step-retract-bored-tool = A ferramenta recua com o avanço { $q-retraction-feed } para a distância de segurança { $q-set-up-clearance }. Se { $q-disengaging-direction } = 0, recua ao longo da parede do furo.
step-restore-spindle-and-coolant = O comando repõe os estados do cabeçote e do refrigerante que estavam ativos antes da chamada do ciclo.
note-machine-and-control-prepared = O fabricante da máquina tem de ter preparado a máquina e o comando para este ciclo.
note-servo-controlled-spindle-only = O ciclo só pode ser utilizado em máquinas com cabeçote regulado.
note-spindle-and-coolant-restored = No fim do ciclo voltam a estar ativos os estados do refrigerante e do cabeçote anteriores à chamada do ciclo.
note-disengage-away-from-edge = Perigo de colisão! Escolha a direção de afastamento livre { $q-disengaging-direction } de modo que a ferramenta se afaste do bordo do furo.
note-check-position-of-tool-tip = Perigo de colisão! Oriente o cabeçote para o ângulo programado em { $q-spindle-orientation-angle } (por exemplo, no modo de funcionamento Posicionamento com introdução manual) e verifique onde está a ponta da ferramenta. Escolha o ângulo de modo que a ponta da ferramenta fique paralela a um eixo de coordenadas.
note-disengaging-considers-rotation = No afastamento livre, o comando tem automaticamente em conta uma rotação ativa do sistema de coordenadas.

# --- 204 ---
cycle-back-boring = Rebaixamento invertido
    .nc = REBAIXAMENTO INVERTIDO
    .purpose = Maquina rebaixos na face inferior da peça.
step-orient-and-offset-tool = O comando orienta o cabeçote para { $q-spindle-orientation-angle } e desloca a ferramenta na direção { $q-disengaging-direction } no valor da medida excêntrica { $q-off-centre-distance }.
step-feed-through-bore = A ferramenta penetra com o avanço de posicionamento prévio { $q-in-and-out-feed } no furo existente, até a navalha ficar à distância de segurança { $q-set-up-clearance } abaixo da aresta inferior da peça.
step-centre-tool-and-counterbore = O comando volta a levar a ferramenta ao centro do furo, liga o cabeçote e, se necessário, o refrigerante, e desloca-a depois com o avanço de rebaixamento { $q-countersinking-feed } até à profundidade { $q-counterbore-depth }.
step-dwell-and-leave-counterbore = Se { $q-counterbore-dwell } tiver sido introduzido, a ferramenta permanece no fundo do rebaixo. Sai depois do rebaixo; o comando orienta o cabeçote e volta a deslocar a ferramenta no valor da medida excêntrica.
step-feed-out-of-bore = A ferramenta desloca-se com o avanço de posicionamento prévio { $q-in-and-out-feed } para a distância de segurança { $q-set-up-clearance } acima da superfície da peça.
note-back-boring-bars-only = O ciclo só funciona com barras de mandrilar para rebaixamento invertido.
note-sign-of-counterbore-depth = O sinal da profundidade { $q-counterbore-depth } determina a direção da maquinação. Atenção: com sinal positivo, rebaixa-se na direção positiva do eixo do cabeçote.
note-length-to-lower-edge-of-bar = Introduza a longitude da ferramenta medida até à aresta inferior da barra de mandrilar e não até à navalha.
note-edge-height-and-thickness-considered = Ao calcular o ponto de partida do rebaixamento, o comando tem em conta a altura da navalha { $q-cutting-edge-height } da barra de mandrilar e a espessura do material { $q-material-thickness }.

# --- 208 ---
cycle-bore-milling = Fresar furo
    .nc = FRESAR FURO
    .purpose = Fresa um furo em hélice. Se o furo tiver o diâmetro da ferramenta, é furado diretamente.
step-rapid-and-approach-hole-circumference = O comando desloca a ferramenta no eixo do cabeçote, em avanço rápido (FMAX), para a distância de segurança { $q-set-up-clearance } acima da superfície da peça e depois, em arco, até ao perímetro do furo { $q-nominal-diameter }, se houver espaço suficiente.
step-drill-directly-if-diameters-equal = Se o diâmetro { $q-nominal-diameter } for igual ao diâmetro da ferramenta, a ferramenta fura sem interpolação em hélice, diretamente até à profundidade { $q-depth }.
step-mill-on-helix = A ferramenta fresa com o avanço { $q-plunging-feed } numa hélice que desce { $q-infeed-per-helix } em cada volta.
step-mill-full-circle-at-depth = Atingida a profundidade, a ferramenta percorre mais um círculo completo, para eliminar o material deixado pela penetração.
step-return-to-centre-of-hole = O comando volta a levar a ferramenta ao centro do furo.
step-rapid-back-to-clearance = A ferramenta regressa em avanço rápido (FMAX) à distância de segurança { $q-set-up-clearance }.
guard-tool-wider-than-hole = O diâmetro do furo é menor do que o da ferramenta.
guard-hole-too-wide-for-tool = O diâmetro do furo é maior do que o dobro do da ferramenta. Introduza o diâmetro do furo prévio ou utilize uma ferramenta maior.
note-equal-diameters-are-drilled = Se o diâmetro do furo introduzido for o diâmetro da ferramenta, o comando fura sem interpolação em hélice, diretamente até à profundidade introduzida.
note-mirroring-keeps-milling-type = Um espelhamento ativo não altera o tipo de fresagem definido no ciclo.
note-infeed-too-large-does-damage = Um passo demasiado grande danifica tanto a ferramenta como a peça.
note-plunging-angle-limits-infeed = Para evitar passos demasiado grandes, introduza o maior ângulo de penetração possível da ferramenta na coluna { $mp-plunging-angle } da tabela de ferramentas. O comando calcula então automaticamente o maior passo permitido e, se necessário, altera o valor introduzido.

# --- 241 ---
cycle-single-lip-drilling = Furar com broca de gume único
    .nc = FURAR GUME ÚNICO
    .purpose = Abre um furo profundo com uma broca de gume único, também a partir de um ponto abaixo da superfície da peça, com rotações e sentido de rotação próprios para a entrada e a saída e com funções M para o refrigerante.
step-feed-in-and-switch-on = O comando desloca a ferramenta com o avanço de posicionamento prévio { $q-pre-positioning-feed } até à distância de segurança acima do ponto de partida aprofundado { $q-deepened-starting-point } e liga aí as rotações de furar { $q-drilling-speed } com M3 e o refrigerante com { $q-coolant-on-function }. Na entrada, o cabeçote roda em sentido horário ou anti-horário com as rotações { $q-speed-in-and-out } ou está parado, conforme { $q-rotation-in-and-out }.
step-drill-in-one-infeed = A ferramenta fura com o avanço { $q-plunging-feed } até à profundidade { $q-depth }.
step-switch-off-coolant-and-reset-speed = O comando desliga o refrigerante com { $q-coolant-off-function } e repõe para a saída as rotações { $q-speed-in-and-out }.
