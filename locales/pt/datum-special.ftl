# Ciclos que memorizam o ponto de referência no círculo de furos, no eixo do apalpador, entre quatro furos e num só eixo.

# --- 416 ---
cycle-datum-bolt-hole-circle = Ponto de referência: centro do círculo de furos
    .nc = PONTO REF CENTRO CÍRCULO DE FUROS
    .nc-aliases = PONTO REF CENTRO CÍRCULO FUROS
    .purpose = Calcula o centro de um círculo de furos medindo três dos seus furos e memoriza-o como ponto de referência. Se pretendido, o comando escreve também o centro numa tabela de pontos zero ou na tabela de presets.
cycle-datum-bolt-hole-circle__tnc426-430 =
    .purpose = Calcula o centro de um círculo de furos medindo três dos seus furos e memoriza-o como ponto de referência. Se pretendido, o comando escreve também o centro numa tabela de pontos zero.
title-datum-at-top-and-bolt-hole-circle = Memorizar o ponto de referência no lado superior da peça e no centro de um círculo de furos
title-top-and-bolt-hole-circle-into-datum-table = Escrever numa tabela de pontos zero o lado superior da peça e o centro de um círculo de furos

# --- 417 ---
cycle-datum-probe-axis = Ponto de referência: eixo do apalpador
    .nc = PONTO REF EIXO TS
    .nc-aliases = PONTO REF EIXO APALP
    .purpose = Mede uma coordenada qualquer no eixo do apalpador e memoriza-a como ponto de referência. Se pretendido, o comando escreve também a coordenada medida numa tabela de pontos zero ou na tabela de presets.
cycle-datum-probe-axis__tnc426-430 =
    .purpose = Mede uma coordenada qualquer no eixo do apalpador e memoriza-a como ponto de referência. Se pretendido, o comando escreve também a coordenada medida numa tabela de pontos zero.
step-position-above-touch-point = O comando posiciona o apalpador no ponto de apalpação programado, em avanço rápido (valor da coluna { $mp-positioning-feed }) e com lógica de posicionamento. Desvia o apalpador no valor da distância de segurança, na direção positiva do eixo do apalpador.
step-position-above-touch-point__tnc426-430 = O comando posiciona o apalpador no ponto de apalpação programado, em avanço rápido (valor de { $mp-positioning-feed } ou { $mp-analog-positioning-feed }) e com lógica de posicionamento. Desvia o apalpador no valor da distância de segurança, na direção positiva do eixo do apalpador.
step-probe-touch-point-in-probe-axis = O apalpador desloca-se no eixo do apalpador para a coordenada introduzida { $q-first-point-tool } do ponto de apalpação e mede a posição real com uma apalpação.
note-datum-set-in-probe-axis = O comando memoriza o ponto de referência no eixo do apalpador, definido pela chamada da ferramenta antes do ciclo.
note-positioning-logic__datum-probe-axis = Lógica de posicionamento: com o polo sul da haste de apalpação abaixo da altura segura { $q-clearance-height }, o comando faz primeiro recuar o apalpador, no seu eixo, para a altura segura e só depois o leva, no plano de maquinação, ao primeiro ponto de apalpação. Com o polo sul acima da altura segura, o apalpador desloca-se primeiro, no plano de maquinação, para o primeiro ponto de apalpação e depois, no seu eixo, diretamente para a altura de medição.
note-no-transformation-with-probe-axis-datum__datum-probe-axis = Se um ciclo memorizar um ponto de referência com { $q-measured-value-transfer }=0 e apalpar também no eixo do apalpador (Q381=1), não pode estar ativa nenhuma conversão de coordenadas.
result-measured-point-actual = Valor real do ponto medido
title-datum-at-top-and-arc-centre = Memorizar o ponto de referência no lado superior da peça e no centro de um segmento de círculo

# --- 418 ---
cycle-datum-four-holes = Ponto de referência: centro de 4 furos
    .nc = PONTO REF 4 FUROS
    .purpose = Calcula o ponto de intersecção das retas que unem dois a dois os centros de quatro furos e memoriza-o como ponto de referência. Se pretendido, o comando escreve também o ponto de intersecção numa tabela de pontos zero ou na tabela de presets.
cycle-datum-four-holes__tnc426-430 =
    .purpose = Calcula o ponto de intersecção das retas que unem dois a dois os centros de quatro furos e memoriza-o como ponto de referência. Se pretendido, o comando escreve também o ponto de intersecção numa tabela de pontos zero.
step-repeat-for-third-and-fourth-hole = O comando repete os dois passos anteriores para o terceiro e o quarto furo.
step-retract-and-store-intersection = O comando faz regressar o apalpador à altura segura { $q-clearance-height }, calcula o ponto de referência como intersecção das retas entre os centros dos furos 1 e 3 e dos furos 2 e 4, guarda os valores reais nos parâmetros de resultado e define ou memoriza o ponto de referência conforme { $q-measured-value-transfer } e { $q-datum-row-number }:
step-retract-and-store-intersection__tnc426-430 = O comando faz regressar o apalpador à altura segura { $q-clearance-height }, calcula o ponto de referência como intersecção das retas entre os centros dos furos 1 e 3 e dos furos 2 e 4 e trata-o conforme { $q-datum-row-number }:
result-intersection-main-actual = Valor real do ponto de intersecção no eixo principal
result-intersection-minor-actual = Valor real do ponto de intersecção no eixo secundário

# --- 419 ---
cycle-datum-one-axis = Ponto de referência num eixo
    .nc = PONTO REF NUM EIXO
    .purpose = Mede uma coordenada qualquer num eixo à escolha e memoriza-a como ponto de referência. Se pretendido, o comando escreve também a coordenada medida numa tabela de pontos zero ou na tabela de presets.
step-position-against-probing-direction = O comando posiciona o apalpador no ponto de apalpação programado, em avanço rápido (valor da coluna { $mp-positioning-feed }) e com lógica de posicionamento. Desvia o apalpador no valor da distância de segurança, no sentido oposto à direção de apalpação programada { $q-traverse-direction }.
step-move-to-measuring-height-and-probe = O apalpador desloca-se para a altura de medição { $q-measuring-height } e mede a posição real com uma apalpação.
step-retract-and-store-datum__datum-one-axis = O comando faz regressar o apalpador à altura segura { $q-clearance-height } e define ou memoriza o ponto de referência medido conforme { $q-measured-value-transfer } e { $q-datum-row-number }:
note-measuring-axes-by-probe-axis = Os eixos que { $q-measuring-axis } seleciona dependem do eixo do apalpador ativo ({ $q-measuring-axis }=3): com Z, o eixo principal ({ $q-measuring-axis }=1) é X e o eixo secundário ({ $q-measuring-axis }=2) é Y; com Y, são Z e X; com X, são Y e Z.
note-activate-preset-after-each-axis = Para guardar o ponto de referência em vários eixos da tabela de presets executando este ciclo várias vezes seguidas, ative depois de cada execução o número de preset em que o ciclo escreveu. Isto não é necessário se for substituído o preset ativo.
