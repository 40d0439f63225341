# Turning: longitudinal and face.

# --- common sentences of the turning cycles ---
group-turning-roughing = Desbaste
group-turning-finishing = Acabamento
step-rapid-radial-infeed = O comando executa em avanço rápido um passo em direção radial, paralelo ao respetivo eixo. Calcula-o a partir da profundidade de corte máxima { $q-max-cutting-depth }.
step-cut-longitudinally = O comando maquina a zona entre a posição de partida e o ponto final em direção longitudinal, com o avanço { $q-turning-roughing-feed }.
step-retract-by-infeed = O comando faz recuar a ferramenta, com o avanço definido, no valor do passo:
say-follow-contour-within-infeed = com { $q-contour-smoothing } = 0, ao longo do contorno, dentro da zona do passo
say-lift-off-at-45-degrees = caso contrário, com um ângulo de 45°
step-rapid-to-start-of-cut = O comando faz regressar a ferramenta em avanço rápido ao início do corte.
until-turning-contour-finished = o contorno esteja terminado
step-smooth-after-last-cut = Com { $q-contour-smoothing } = 1, o comando alisa todo o contorno depois do último corte.
step-rapid-to-starting-point-of-cycle = O comando faz regressar a ferramenta em avanço rápido ao ponto de partida do ciclo.
step-rapid-back-after-finishing = { step-rapid-to-starting-point-of-cycle }
step-rapid-in-z-by-clearance = O comando desloca a ferramenta em Z, em avanço rápido, no valor da distância de segurança { $q-turning-clearance }.
step-rapid-paraxial-infeed = O comando executa em avanço rápido um passo paralelo aos eixos.
step-finish-turned-contour = O comando faz o acabamento do contorno da peça com o avanço { $q-turning-finishing-feed }.
step-retract-by-clearance = O comando faz recuar a ferramenta, com o avanço definido, no valor da distância de segurança { $q-turning-clearance }.
guard-turning-mode-missing = Os ciclos de torneamento só podem ser executados no modo de torneamento FUNCTION MODE TURN.
note-turning-mode-only = Os ciclos de torneamento só podem ser utilizados no modo de torneamento FUNCTION MODE TURN.
note-program-before-turning-cycle = Antes da chamada do ciclo, programe sempre: o modo de torneamento FUNCTION MODE TURN, a chamada da ferramenta TOOL CALL, o sentido de rotação do cabeçote de torneamento (por exemplo, M303), as rotações ou a velocidade de corte com FUNCTION TURNDATA SPIN, M136 se forem utilizados avanços por rotação (mm/rot.), uma frase de posicionamento para um ponto de partida adequado (por exemplo, L X+130 Y+0 R0 FMAX) e o ciclo 800 para adaptar o sistema de coordenadas e alinhar a ferramenta.
note-call-turning-cycle = Chame o ciclo com CYCL CALL ou M99.
note-outside-or-inside-by-tool-position = O ciclo maquina o exterior se, na chamada do ciclo, a ferramenta estiver fora do contorno a maquinar, e o interior se estiver dentro dele.
note-outside-or-inside-by-diameters = Se o diâmetro no início { $q-contour-start-diameter } for maior do que o diâmetro no fim { $q-contour-end-diameter }, o ciclo maquina o exterior; se for menor, o interior.
note-outside-or-inside-by-contour = Se a coordenada do ponto de partida do contorno for maior do que a do ponto final, o ciclo maquina o exterior; se for menor, o interior.
note-check-after-change-of-side = Depois de mudar entre maquinação exterior e interior, verifique os ajustes da ferramenta e o sentido de rotação.
note-area-from-tool-position-to-end-point = No desbaste, o ciclo maquina a zona desde a posição da ferramenta na chamada do ciclo (ponto de partida do ciclo) até ao ponto final definido no ciclo.
note-position-at-starting-position = Antes da chamada do ciclo, programe uma frase de posicionamento para a posição de partida com correção de raio R0.
note-position-at-safe-position = Antes da chamada do ciclo, programe uma frase de posicionamento para uma posição segura com correção de raio R0.
note-tool-position-determines-area = A posição da ferramenta na chamada do ciclo (ponto de partida do ciclo) determina o tamanho da zona a maquinar.
note-tool-position-influences-area = A posição da ferramenta na chamada do ciclo (ponto de partida do ciclo) influencia a zona a maquinar.
note-pre-positioning-influences-time = O posicionamento prévio da ferramenta influencia muito o campo de trabalho do ciclo e, com isso, o tempo de maquinação. No desbaste, o ponto de partida do ciclo é a posição da ferramenta na chamada do ciclo. O comando calcula a zona a maquinar a partir do ponto de partida e do ponto final ou do contorno definido no ciclo. Se o ponto de partida ficar dentro desta zona, alguns ciclos deslocam primeiro a ferramenta para a distância de segurança.
note-finishing-approach-from-envelope = Perigo para a ferramenta e a peça! No acabamento, o ciclo desloca automaticamente a ferramenta para o ponto de partida. A forma da aproximação depende da posição da ferramenta na chamada do ciclo: dentro ou fora da envolvente, que é o contorno programado acrescido da distância de segurança { $q-turning-clearance }. Se a ferramenta estiver dentro da envolvente, desloca-se com o avanço definido em trajetória direta para a posição de partida, o que pode danificar o contorno: posicione a ferramenta de modo que possa alcançar a posição de partida sem danificar o contorno. Se a ferramenta estiver fora da envolvente, desloca-se em avanço rápido até à envolvente e, dentro dela, com o avanço programado.
note-cutting-geometry-considered = O comando tem em conta a geometria de corte da ferramenta ({ $mp-tool-orientation }, { $mp-cutting-edge-radius }, { $mp-point-angle }, { $mp-tool-angle }), de modo que os elementos de contorno definidos não possam ser danificados. Se o contorno não puder ser totalmente maquinado com a ferramenta ativa, o comando mostra um aviso.
note-feed-rates-with-m136 = Se M136 estiver programada antes do ciclo, o comando interpreta os avanços do ciclo em mm/rot.; sem M136, em mm/min.
note-inclined-turning = Se o ciclo for executado numa maquinação inclinada (M144), alteram-se os ângulos da ferramenta em relação ao contorno. O comando tem automaticamente em conta esta alteração e supervisiona assim a maquinação também na posição inclinada, para que o contorno não seja danificado.
note-blank-form-update = Com o seguimento do bloco (FUNCTION TURNDATA BLANK), o comando reconhece as zonas já maquinadas e adapta todos os percursos de aproximação e de saída às diversas operações. Só está disponível num ciclo de maquinação no modo de torneamento; o bloco tem de ser um contorno fechado (posição inicial = posição final) e é a secção de um corpo de revolução.
note-finished-part-beyond-blank = Com o seguimento do bloco, o comando adapta a aproximação e o recuo ao bloco atualizado. Se houver zonas da peça acabada que ultrapassem o bloco, a peça e a ferramenta podem ficar danificadas.
step-rapid-axial-infeed = O comando executa em avanço rápido um passo em direção axial, paralelo ao respetivo eixo. Calcula-o a partir da profundidade de corte máxima { $q-max-axial-cutting-depth }.
step-cut-across-axis = O comando maquina a zona entre a posição de partida e o ponto final em direção transversal, com o avanço { $q-turning-roughing-feed }.
step-cut-contour-longitudinally = O comando maquina a zona entre a posição de partida e o ponto final em direção longitudinal. O corte longitudinal faz-se paralelamente aos eixos, com o avanço { $q-turning-roughing-feed }.
step-cut-contour-across-axis = O comando maquina a zona entre a posição de partida e o ponto final em direção transversal. O corte transversal faz-se paralelamente aos eixos, com o avanço { $q-turning-roughing-feed }.
step-cut-parallel-to-contour = O comando maquina a zona entre a posição de partida e o ponto final. O corte faz-se paralelamente ao contorno, com o avanço { $q-turning-roughing-feed }.
step-retract-to-starting-position-in-x = O comando faz recuar a ferramenta, com o avanço definido, para a posição de partida em X.
step-clear-area-in-x-then-z = Se o ponto de partida (posição da ferramenta na chamada do ciclo) ficar dentro da zona a maquinar, o comando posiciona a ferramenta à distância de segurança { $q-turning-clearance } em X e depois em Z, e inicia o ciclo a partir daí.
step-clear-area-in-z-then-x = Se o ponto de partida (posição da ferramenta na chamada do ciclo) ficar dentro da zona a maquinar, o comando posiciona a ferramenta à distância de segurança { $q-turning-clearance } em Z e depois em X, e inicia o ciclo a partir daí.
step-clear-area-in-z = Se o ponto de partida ficar dentro da zona a maquinar, o comando posiciona primeiro a ferramenta em Z à distância de segurança { $q-turning-clearance }.
step-clear-plunging-start-in-z = Se a coordenada Z do ponto de partida (posição da ferramenta na chamada do ciclo) for menor do que o início do contorno { $q-plunging-start-z }, o comando posiciona a ferramenta em Z à distância de segurança { $q-turning-clearance } e inicia o ciclo a partir daí.
step-clear-contour-start-in-z = Se a coordenada Z do ponto de partida (posição da ferramenta na chamada do ciclo) for menor do que a do ponto de partida do contorno, o comando posiciona a ferramenta em Z à distância de segurança { $q-turning-clearance } e inicia o ciclo a partir daí.
step-clear-contour-start-before-finishing = { step-clear-contour-start-in-z }
step-position-at-contour-start-in-z = Se a coordenada Z do ponto de partida (posição da ferramenta na chamada do ciclo) for menor do que a do ponto de partida do contorno, o comando posiciona a ferramenta em Z no ponto de partida do contorno e inicia o ciclo a partir daí.
step-rapid-infeed = O comando executa um passo em avanço rápido.
step-finish-turned-contour-to-end = O comando faz o acabamento do contorno da peça, do ponto de partida ao ponto final do contorno, com o avanço { $q-turning-finishing-feed }.
condition-start-element-added = { $q-start-element-type } acrescentar um elemento no início do contorno
condition-end-element-added = { $q-end-element-type } acrescentar um elemento no fim do contorno
condition-undercuts-machined = { $q-undercut-machining } permitir maquinar elementos de afundamento
note-area-from-starting-point-to-end-point = No desbaste, o ciclo maquina a zona desde o ponto de partida do ciclo até ao ponto final definido no ciclo.
note-infeed-within-undercut = Dentro do rebaixo, o comando avança a ferramenta com o avanço { $q-turning-roughing-feed }. Aí, cada recuo corresponde à distância de segurança { $q-turning-clearance }.
note-contour-direction-decides = A direção programada do contorno determina a direção da maquinação.
title-shoulder-with-recess = Escalão com ranhura

# --- 811 ---
cycle-turn-shoulder-longitudinal = Tornear escalão longitudinal
    .nc = ESCALÃO LONGITUDINAL
    .purpose = Torneia em direção longitudinal escalões em ângulo reto, no exterior ou no interior: desbaste, acabamento ou ambos. Os cortes de desbaste são paralelos aos eixos.

# --- 812 ---
cycle-turn-shoulder-longitudinal-extended = Tornear escalão longitudinal, ampliado
    .nc = ESCALÃO LONGITUDINAL AMPLIADO
    .purpose = Torneia em direção longitudinal escalões, no exterior ou no interior: desbaste, acabamento ou ambos. No início e no fim do contorno pode acrescentar-se um chanfre ou um arredondamento, podem definir-se ângulos para a face e a superfície periférica, e a esquina do contorno pode ter um raio. Os cortes de desbaste são paralelos aos eixos.

# --- 813 ---
cycle-turn-plunge-longitudinal = Tornear afundamento longitudinal
    .nc = AFUNDAMENTO LONGITUDINAL
    .purpose = Torneia em direção longitudinal escalões com elementos de afundamento (rebaixos), no exterior ou no interior: desbaste, acabamento ou ambos. Os cortes de desbaste são paralelos aos eixos.

# --- 814 ---
cycle-turn-plunge-longitudinal-extended = Tornear afundamento longitudinal, ampliado
    .nc = AFUNDAM. LONGITUDINAL AMPLIADO
    .purpose = Torneia em direção longitudinal escalões com elementos de afundamento (rebaixos), no exterior ou no interior: desbaste, acabamento ou ambos. No início e no fim do contorno pode acrescentar-se um chanfre ou um arredondamento, e podem definir-se um ângulo da face e um raio da esquina do contorno. Os cortes de desbaste são paralelos aos eixos.

# --- 810 ---
cycle-turn-contour-longitudinal = Tornear contorno longitudinal
    .nc = CONTORNO LONGITUDINAL
    .purpose = Torneia em direção longitudinal peças com qualquer contorno de torneamento, descrito num subprograma, no exterior ou no interior: desbaste, acabamento ou ambos. Os cortes de desbaste são paralelos aos eixos.

# --- 815 ---
cycle-turn-contour-parallel = Tornear paralelamente ao contorno
    .nc = PARALELO AO CONTORNO
    .purpose = Torneia peças com qualquer contorno de torneamento, descrito num subprograma, no exterior ou no interior: desbaste, acabamento ou ambos. Os cortes de desbaste são paralelos ao contorno.

# --- 821 ---
cycle-turn-shoulder-face = Tornear escalão transversal
    .nc = ESCALÃO TRANSVERSAL
    .purpose = Torneia em direção transversal escalões em ângulo reto, no exterior ou no interior: desbaste, acabamento ou ambos. Os cortes de desbaste são paralelos aos eixos.

# --- 822 ---
cycle-turn-shoulder-face-extended = Tornear escalão transversal, ampliado
    .nc = ESCALÃO TRANSVERSAL AMPLIADO
    .purpose = Torneia em direção transversal escalões, no exterior ou no interior: desbaste, acabamento ou ambos. No início e no fim do contorno pode acrescentar-se um chanfre ou um arredondamento, podem definir-se ângulos para a face e a superfície periférica, e a esquina do contorno pode ter um raio. Os cortes de desbaste são paralelos aos eixos.

# --- 823 ---
cycle-turn-plunge-face = Tornear afundamento transversal
    .nc = AFUNDAMENTO TRANSVERSAL
    .purpose = Torneia em direção transversal elementos de afundamento (rebaixos), no exterior ou no interior: desbaste, acabamento ou ambos. Os cortes de desbaste são paralelos aos eixos.

# --- 824 ---
cycle-turn-plunge-face-extended = Tornear afundamento transversal, ampliado
    .nc = AFUNDAM. TRANSVERSAL AMPLIADO
    .purpose = Torneia em direção transversal elementos de afundamento (rebaixos), no exterior ou no interior: desbaste, acabamento ou ambos. No início e no fim do contorno pode acrescentar-se um chanfre ou um arredondamento, e podem definir-se um ângulo da face e um raio da esquina do contorno. Os cortes de desbaste são paralelos aos eixos.

# --- 820 ---
cycle-turn-contour-face = Tornear contorno transversal
    .nc = CONTORNO TRANSVERSAL
    .purpose = Torneia em direção transversal peças com qualquer contorno de torneamento, descrito num subprograma, no exterior ou no interior: desbaste, acabamento ou ambos. Os cortes de desbaste são paralelos aos eixos.

# --- 800 ---
cycle-adapt-turning-system = Adaptar sistema de torneamento
    .nc = ADAPTAR SISTEMA DE TORNEAMENTO
    .purpose = Alinha o sistema de coordenadas da peça para tornear e orienta a navalha da ferramenta; pode espelhar a ferramenta, para que sirva tanto para maquinação interior como exterior.
step-align-turning-system = O comando alinha o sistema de coordenadas da peça com o ângulo de precessão { $q-precession-angle } e orienta a navalha da ferramenta em conformidade: na maquinação exterior, para o centro da mesa rotativa; na maquinação interior, na direção oposta.
step-reverse-turning-tool = Com { $q-tool-reversal }, o sistema de coordenadas da ferramenta pode ser espelhado: o comando roda então o cabeçote 180° e espelha a orientação da ferramenta { $mp-tool-orientation }. Assim, uma ferramenta pode ser utilizada tanto para maquinação interior como exterior.
note-before-turning = Antes de tornear, leve a ferramenta à posição correta e oriente a sua navalha.
note-position-over-turning-spindle = Para levar a ferramenta a uma posição adequada, programe uma frase de posicionamento para o centro do cabeçote de torneamento, por exemplo L Y+0 R0 FMAX.
note-purpose-of-precession-angle = O ângulo de precessão { $q-precession-angle } define em que ponto do perímetro da peça se faz a maquinação. Isto pode ser necessário se, por falta de espaço, a ferramenta tiver de ser levada a uma determinada posição de maquinação; a posição de maquinação também pode ser rodada para que a maquinação se possa observar melhor.
note-precession-in-inclined-turning = No torneamento inclinado, utilize o ângulo de precessão { $q-precession-angle } para levar a navalha e o sistema de coordenadas a uma posição adequada.
note-turning-system-until-tool-call = O ciclo atua a partir da sua definição até à chamada da ferramenta seguinte.
note-turning-tool-clamped-and-measured = A ferramenta tem de estar fixada na posição correta e medida.
note-turning-tool-selected = O ciclo só pode ser utilizado se estiver selecionada uma ferramenta de tornear.
note-check-tool-orientation = Verifique a orientação da ferramenta antes da maquinação.
note-own-functions-for-tool-alignment = O fabricante da máquina pode disponibilizar funções próprias para alinhar a ferramenta. Consulte o manual da máquina.
note-cycle-depends-on-machine = O ciclo { $cycle } depende da máquina. Consulte o manual da máquina.

# --- 801 ---
cycle-reset-turning-system = Anular sistema de torneamento
    .nc = ANULAR SISTEMA DE TORNEAMENTO
    .purpose = Anula os ajustes feitos com o ciclo 800.
step-reset-turning-system = O comando anula todos os ajustes programados com o ciclo 800: o ângulo de precessão Q497 e a inversão da ferramenta Q498.
note-tool-stays-oriented = A ferramenta não regressa à sua orientação inicial. Se o ciclo 800 a tiver orientado, permanece nessa posição depois da anulação.
note-cycle-without-parameters = O ciclo não tem parâmetros. Termine a sua introdução com a tecla END.
message-turning-contour-left = A ferramenta não consegue maquinar o contorno por completo: a pastilha não o alcança em todos os pontos.
