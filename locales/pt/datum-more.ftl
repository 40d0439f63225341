# Outros ciclos que memorizam um ponto de referência.

# --- 410 and 411 ---
cycle-datum-inside-rectangle = Ponto de referência: retângulo interior
    .nc = PONTREF RECTÂNG INTERN
    .nc-aliases = PONTO REF RECTÂNG INTERIOR
    .purpose = Mede o centro de uma caixa retangular e memoriza-o como ponto de referência. Se pretendido, o comando escreve também o centro numa tabela de pontos zero ou na tabela de presets.
cycle-datum-inside-rectangle__tnc426-430 =
    .purpose = Mede o centro de uma caixa retangular e memoriza-o como ponto de referência. Se pretendido, o comando escreve também o centro numa tabela de pontos zero.
cycle-datum-outside-rectangle = Ponto de referência: retângulo exterior
    .nc = PONTO REF RECTÂNGULO EXT.
    .nc-aliases = PONTO REF RECTÂNG EXTERIOR
    .purpose = Mede o centro de uma ilha retangular e memoriza-o como ponto de referência. Se pretendido, o comando escreve também o centro numa tabela de pontos zero ou na tabela de presets.
cycle-datum-outside-rectangle__tnc426-430 =
    .purpose = Mede o centro de uma ilha retangular e memoriza-o como ponto de referência. Se pretendido, o comando escreve também o centro numa tabela de pontos zero.
step-probe-first-point = O apalpador executa a primeira apalpação com o avanço de apalpação (coluna { $mp-probing-feed }).
step-probe-first-point__tnc426-430 = O apalpador executa a primeira apalpação com o avanço de apalpação ({ $mp-probing-feed } ou { $mp-analog-probing-feed }).
step-travel-to-second-touch-point = O apalpador desloca-se para o segundo ponto de apalpação:
say-travel-linearly-at-clearance-height = com { $q-traverse-to-clearance-height }=1, em linha reta, à altura segura { $q-clearance-height }
say-travel-paraxially-at-measuring-height = com { $q-traverse-to-clearance-height }=0, paralelamente aos eixos, à altura de medição { $q-measuring-height }
step-probe-second-point = O apalpador executa aí a segunda apalpação.
step-probe-third-and-fourth-point = O comando posiciona o apalpador no terceiro e depois no quarto ponto de apalpação e executa aí a terceira e a quarta apalpação.
step-retract-and-treat-datum = O comando faz regressar o apalpador à altura segura { $q-clearance-height } e define ou memoriza o ponto de referência medido conforme { $q-measured-value-transfer } e { $q-datum-row-number }:
step-retract-and-treat-datum__tnc426-430 = O comando faz regressar o apalpador à altura segura { $q-clearance-height } e define ou memoriza o ponto de referência medido conforme { $q-datum-row-number }:
step-store-actual-values = O comando guarda os valores reais nos parâmetros de resultado.
note-pocket-sides-rather-small = Perigo de colisão! Para que o apalpador não colida com a peça, introduza as longitudes dos lados 1 e 2 da caixa aproximadas por defeito.
note-stud-sides-rather-large = Perigo de colisão! Para que o apalpador não colida com a peça, introduza as longitudes dos lados 1 e 2 da ilha aproximadas por excesso.
title-introduction-to-probing = Outro exemplo

# --- 413 ---
cycle-datum-outside-circle = Ponto de referência: círculo exterior
    .nc = PONTO REF CÍRCULO EXTERIOR
    .purpose = Mede o centro de uma ilha circular e memoriza-o como ponto de referência. Se pretendido, o comando escreve também o centro numa tabela de pontos zero ou na tabela de presets.
cycle-datum-outside-circle__tnc426-430 =
    .purpose = Mede o centro de uma ilha circular e memoriza-o como ponto de referência. Se pretendido, o comando escreve também o centro numa tabela de pontos zero.
note-stud-diameter-rather-large = Perigo de colisão! Para que o apalpador não colida com a peça, introduza o diâmetro nominal da ilha aproximado por excesso.
note-small-stepping-angle-less-exact__datum-outside-circle = Quanto menor for o passo angular { $q-probing-stepping-angle }, menos exato é o ponto de referência que o comando calcula.
title-datum-at-arc-centre-and-top = Memorizar o ponto de referência no centro de um segmento de círculo e no lado superior da peça
title-datum-at-arc-centre-and-top__tnc426-430 = Memorizar o ponto de referência no centro de um segmento de círculo

# --- results ---
result-side-main-actual = Valor real longitude do lado eixo principal
result-side-minor-actual = Valor real longitude do lado eixo secundário
result-slot-width-actual = Valor real da largura da ranhura medida
result-ridge-width-actual = Valor real da largura da nervura medida
result-centre-axis-actual = Valor real posição eixo central
result-corner-main-actual = Valor real da esquina no eixo principal
result-corner-minor-actual = Valor real da esquina no eixo secundário

# --- 408 and 409 ---
cycle-datum-slot-centre = Ponto de referência: centro da ranhura
    .nc = PONTO REF CENTRO RANHURA
    .purpose = Mede o centro de uma ranhura e memoriza-o como ponto de referência. Se pretendido, o comando escreve também o centro numa tabela de pontos zero ou na tabela de presets.
cycle-datum-ridge-centre = Ponto de referência: centro da nervura
    .nc = PONTO REF CENTRO NERVURA
    .purpose = Mede o centro de uma nervura e memoriza-o como ponto de referência. Se pretendido, o comando escreve também o centro numa tabela de pontos zero ou na tabela de presets.
step-travel-at-clearance-height-to-second = O apalpador desloca-se, à altura segura { $q-clearance-height }, para o segundo ponto de apalpação.
say-start-again-from-centre__datum-slot-centre = se a ranhura e a distância de segurança não deixarem espaço para um posicionamento prévio perto dos pontos de apalpação, permanece no centro e não se desloca à altura segura
note-slot-width-rather-small = Perigo de colisão! Para que o apalpador não colida com a peça, introduza a largura da ranhura aproximada por defeito.
note-ridge-width-rather-large = Perigo de colisão! Para que o apalpador não colida com a peça, introduza a largura da nervura aproximada por excesso.
note-probing-from-centre-if-narrow__datum-slot-centre = Se a largura da ranhura e a distância de segurança não permitirem um posicionamento prévio perto dos pontos de apalpação, o comando começa sempre a apalpar a partir do centro da ranhura. O apalpador não se desloca então à altura segura entre os dois pontos de medição.
note-feature-content-level-3 = Este ciclo é uma função do nível de desenvolvimento Feature Content Level 3 (FCL 3).

# --- 414 and 415 ---
cycle-datum-outside-corner = Ponto de referência: esquina exterior
    .nc = PONTO REF ESQUINA EXTERIOR
    .purpose = Mede duas retas pelo exterior e memoriza a sua intersecção como ponto de referência. Se pretendido, o comando escreve também o ponto de intersecção numa tabela de pontos zero ou na tabela de presets.
cycle-datum-outside-corner__tnc426-430 =
    .purpose = Mede duas retas pelo exterior e memoriza a sua intersecção como ponto de referência. Se pretendido, o comando escreve também o ponto de intersecção numa tabela de pontos zero.
cycle-datum-inside-corner = Ponto de referência: esquina interior
    .nc = PONTO REF ESQUINA INTERIOR
    .purpose = Mede duas retas pelo interior e memoriza a sua intersecção como ponto de referência. Se pretendido, o comando escreve também o ponto de intersecção numa tabela de pontos zero ou na tabela de presets.
cycle-datum-inside-corner__tnc426-430 =
    .purpose = Mede duas retas pelo interior e memoriza a sua intersecção como ponto de referência. Se pretendido, o comando escreve também o ponto de intersecção numa tabela de pontos zero.
step-probe-first-point-by-third-point = O apalpador executa a primeira apalpação com o avanço de apalpação (coluna { $mp-probing-feed }). O comando determina a direção de apalpação a partir do terceiro ponto de medição programado.
step-probe-first-point-by-third-point__tnc426-430 = O apalpador executa a primeira apalpação com o avanço de apalpação ({ $mp-probing-feed } ou { $mp-analog-probing-feed }). O comando determina a direção de apalpação a partir do terceiro ponto de medição programado.
step-probe-first-point-by-corner-number = O apalpador executa a primeira apalpação com o avanço de apalpação (coluna { $mp-probing-feed }). O comando determina a direção de apalpação a partir do número da esquina { $q-corner-number }.
step-probe-first-point-by-corner-number__tnc426-430 = O apalpador executa a primeira apalpação com o avanço de apalpação ({ $mp-probing-feed } ou { $mp-analog-probing-feed }). O comando determina a direção de apalpação a partir do número da esquina { $q-corner-number }.
step-retract-and-store-corner = O comando faz regressar o apalpador à altura segura { $q-clearance-height }, guarda as coordenadas da esquina medida nos parâmetros de resultado e define ou memoriza o ponto de referência medido conforme { $q-measured-value-transfer } e { $q-datum-row-number }:
step-retract-and-store-corner__tnc426-430 = O comando faz regressar o apalpador à altura segura { $q-clearance-height } e define ou memoriza como ponto de referência o ponto de intersecção das retas medidas, conforme { $q-datum-row-number }:
step-carry-out-basic-rotation-on-request = Com { $q-corner-basic-rotation }=1, o comando compensa a inclinação da peça por meio de uma rotação básica.
note-corner-from-first-and-third-point = As posições dos pontos de medição 1 e 3 determinam a esquina em que o comando memoriza o ponto de referência. Esquina A: a coordenada do ponto 1 é maior do que a do ponto 3 em X e menor em Y. Esquina B: menor em X, menor em Y. Esquina C: menor em X, maior em Y. Esquina D: maior em X, maior em Y.
note-first-line-in-secondary-direction = O comando mede a primeira reta sempre na direção do eixo secundário do plano de maquinação.
note-basic-rotation-with-immediate-datum = Execute a rotação básica só se o ponto de referência for memorizado de imediato, e não se for escrito na tabela de pontos zero para uma maquinação posterior.
