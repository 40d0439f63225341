# Cycles that calibrate touch probes.

# --- 460 ---
cycle-calibrate-on-sphere = Calibrar apalpador
    .nc = CALIBRAR TS NA ESFERA
    .purpose = Calibra automaticamente um apalpador digital 3D numa esfera de calibração exata: só o raio, ou o raio e a longitude.
condition-length-calibration-wanted = { $q-length-calibration }=1
step-position-probe-over-sphere = Posicione o apalpador, no eixo do apalpador, por cima da esfera de calibração e, no plano de maquinação, no centro da esfera.
step-approach-sphere-downwards = O primeiro movimento do ciclo faz-se na direção negativa do eixo do apalpador.
step-find-sphere-centre = O comando determina o centro exato da esfera no eixo do apalpador.
step-calibrate-radius-on-sphere = O comando calibra o raio com { $q-calibration-sphere-probings } apalpações no plano. Entre os pontos de medição, o apalpador desloca-se:
say-travel-at-clearance-height-between-points = com { $q-traverse-to-clearance-height }=1, à altura segura
say-travel-at-measuring-height-between-points = com { $q-traverse-to-clearance-height }=0, à altura de medição
step-calibrate-length-on-sphere = Depois do raio, o comando trata a longitude conforme { $q-length-calibration }:
say-length-from-sphere-centre = com { $q-length-calibration }=1, calibra a longitude; { $q-length-reference } é a coordenada do centro da esfera
say-length-unchanged = com { $q-length-calibration }=0, não calibra a longitude
step-store-calibration-values = O comando guarda os valores de calibração. Estes atuam de imediato.
note-position-above-sphere-in-program = No programa, posicione o apalpador de modo que fique aproximadamente por cima do centro da esfera.
note-effective-length-reference = A longitude efetiva do apalpador refere-se sempre ao ponto de referência da ferramenta. Em regra, o fabricante da máquina coloca o ponto de referência da ferramenta no nariz do cabeçote.
note-when-to-calibrate = Calibre sempre o apalpador na colocação em funcionamento, depois da rotura ou da substituição da haste de apalpação, depois de alterar o avanço de apalpação, depois de perturbações inesperadas (por exemplo, o aquecimento da máquina) e depois de alterar o eixo da ferramenta ativo.
note-when-to-calibrate__tnc426-430 = Calibre sempre o apalpador na colocação em funcionamento, depois da rotura ou da substituição da haste de apalpação, depois de alterar o avanço de apalpação e em caso de irregularidades (por exemplo, o aquecimento da máquina).
note-known-ring-or-stud = Na calibração determinam-se a longitude efetiva da haste de apalpação e o raio efetivo da esfera. Para calibrar, fixe na mesa da máquina um anel de ajuste ou uma ilha de altura e raio conhecidos.
note-known-ring-or-stud__tnc426-430 = Na calibração determinam-se a longitude efetiva da haste de apalpação e o raio efetivo da esfera. Para calibrar, coloque na mesa da máquina um anel de ajuste de altura e raio interior conhecidos.
note-calibration-values-at-once = Os valores de calibração atuam para o apalpador ativo logo depois da calibração. Não é necessária uma nova chamada da ferramenta.
note-calibration-values-in-tables = O comando guarda a longitude efetiva e o raio efetivo do apalpador na tabela de ferramentas e a sua excentricidade nas colunas { $mp-probe-offset-main } (eixo principal) e { $mp-probe-offset-minor } (eixo secundário) da tabela de apalpadores. A softkey da tabela de apalpadores mostra os valores guardados.
note-right-tool-number-for-probe = Ao utilizar um apalpador, tem de estar ativo o número de ferramenta correto, quer o ciclo de apalpação seja executado num modo de funcionamento automático, quer manualmente.

# --- 461 ---
cycle-calibrate-probe-length = Calibrar longitude do apalpador
    .nc = CALIBRAR LONGITUDE TS
    .purpose = Calibra a longitude efetiva de um apalpador digital 3D numa superfície de altura conhecida, como a de um anel de ajuste.
step-prepare-length-calibration = Antes do início do ciclo, memorize o ponto de referência no eixo do cabeçote de modo que na mesa da máquina seja Z=0, e posicione o apalpador por cima do anel de calibração.
step-orient-to-calibration-angle = O comando orienta o apalpador para o ângulo { $mp-probe-calibration-angle } da tabela de apalpadores, se o apalpador puder ser orientado.
step-probe-down-from-here = A partir da posição atual, o comando apalpa na direção negativa do eixo do cabeçote com o avanço de apalpação (coluna { $mp-probing-feed }).
step-return-to-start-of-calibration = O comando faz regressar o apalpador em avanço rápido (coluna { $mp-positioning-feed }) à posição de partida.
step-store-probe-length = O comando guarda a longitude efetiva na tabela de ferramentas.

# --- 462 and 463 ---
cycle-calibrate-in-ring = Calibrar raio do apalpador, interior
    .nc = CALIBRAR TS NO ANEL
    .purpose = Calibra num anel de calibração o raio efetivo da esfera de um apalpador digital 3D e, se o apalpador o permitir, a sua excentricidade.
cycle-calibrate-on-stud = Calibrar raio do apalpador, exterior
    .nc = CALIBRAR TS NA ILHA
    .purpose = Calibra numa ilha ou num pino de calibração o raio efetivo da esfera de um apalpador digital 3D e, se o apalpador o permitir, a sua excentricidade.
step-pre-position-in-ring = Antes do início do ciclo, posicione previamente o apalpador no centro do anel de calibração e à altura de medição pretendida.
step-pre-position-over-stud = Antes do início do ciclo, posicione previamente o apalpador por cima do centro do pino de calibração e, no eixo do apalpador, aproximadamente à distância de segurança acima dele (valor da coluna { $mp-set-up } + { $q-probing-clearance }).
step-rough-measurement-of-part = Na primeira passagem, o comando determina o centro do anel de calibração (medição grosseira) e posiciona o apalpador no centro.
step-rough-measurement-of-part__calibrate-on-stud = Na primeira passagem, o comando determina o centro da ilha ou do pino de calibração (medição grosseira) e posiciona o apalpador no centro.
step-fine-measurement-of-part = A calibração propriamente dita (medição fina) determina depois o raio da esfera.
step-travel-between-calibration-points = Entre os pontos de medição, o apalpador desloca-se:
step-reverse-measurement = Se o apalpador puder ser orientado em duas ou em todas as direções, o comando roda-o 180° e executa mais quatro apalpações. Esta medição determina também a excentricidade.
step-store-radius-and-offset = O comando guarda o raio efetivo da esfera na coluna { $mp-tool-radius } da tabela de ferramentas e a excentricidade nas colunas { $mp-probe-offset-main } e { $mp-probe-offset-minor } da tabela de apalpadores.
guard-too-few-calibration-points = São necessárias pelo menos três apalpações: { $q-calibration-ring-probings } é demasiado pequeno.
guard-too-few-calibration-points__calibrate-on-sphere = São necessárias pelo menos três apalpações: { $q-calibration-sphere-probings } é demasiado pequeno.
note-orientation-decides-calibration = A calibração depende da forma como o apalpador pode ser orientado. Se não puder ser orientado, ou só numa direção, o comando faz uma medição grosseira e uma medição fina e determina o raio efetivo da esfera. Se puder ser orientado em duas direções (como os apalpadores por cabo da HEIDENHAIN), o comando faz uma medição grosseira e uma medição fina, roda o apalpador 180° e executa mais quatro apalpações, que, além do raio, determinam a excentricidade. Se puder ser orientado em todas as direções (como os apalpadores de infravermelhos da HEIDENHAIN), a calibração é igual à de duas direções.
note-centre-offset-needs-suitable-probe = A excentricidade só pode ser determinada com um apalpador adequado.
note-centre-offset-prepared = O fabricante da máquina tem de ter preparado o comando para determinar a excentricidade da haste de apalpação. Consulte o manual da máquina.
note-orientation-predefined = A possibilidade e o modo de orientar um apalpador estão predefinidos para os apalpadores HEIDENHAIN. Os outros apalpadores são configurados pelo fabricante da máquina.

# --- 2 ---
cycle-calibrate-touch-probe = Calibrar TS
    .nc = CALIBRAR TS
    .purpose = Calibra automaticamente um apalpador digital num anel de calibração ou numa ilha de calibração.
step-rise-to-clearance-height = O apalpador desloca-se em avanço rápido (valor de { $mp-positioning-feed } ou { $mp-analog-positioning-feed }) para a altura segura, se a sua posição atual for inferior a ela.
step-position-over-calibration-part = O comando posiciona o apalpador no plano de maquinação:
say-near-first-touch-point = perto do primeiro ponto de apalpação (calibrar exterior)
say-at-centre-of-ring = no centro do anel de calibração (calibrar interior)
step-probe-calibration-part = O apalpador desloca-se para a profundidade de medição, que resulta dos parâmetros de máquina { $mp-calibration-part-centre }.2 (noutras margens de deslocação { $mp-calibration-part-centre-2 }.2, { $mp-calibration-part-centre-3 }.2) e { $mp-calibration-part-depth }.x, e apalpa a peça de calibração sucessivamente em X+, Y+, X− e Y−.
step-retract-and-store-ball-radius = O comando faz recuar o apalpador para a altura segura e escreve o raio efetivo da esfera nos dados de calibração.
note-calibration-part-centre-known = Antes de calibrar, defina o centro da peça de calibração no espaço de trabalho da máquina nos parâmetros de máquina { $mp-calibration-part-centre }.0 a { $mp-calibration-part-centre }.2 (coordenadas REF).
note-calibration-part-per-traverse-range = Se forem utilizadas várias margens de deslocação, pode guardar-se para cada uma um conjunto de dados próprio do centro da peça de calibração: { $mp-calibration-part-centre-2 }.0 a { $mp-calibration-part-centre-2 }.2 e { $mp-calibration-part-centre-3 }.0 a { $mp-calibration-part-centre-3 }.2.
note-probe-type-selected = Se forem utilizados alternadamente apalpadores digitais e analógicos, certifique-se de que { $mp-probe-selection } seleciona o apalpador correto. Os dois nunca podem estar ligados ao comando ao mesmo tempo. O comando não consegue determinar qual dos apalpadores está realmente na máquina.
