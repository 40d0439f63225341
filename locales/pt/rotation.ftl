# Ciclos que registam e compensam a inclinação da peça.

# --- run, shared ---
step-position-offset-at-first-touch-point = O comando posiciona o apalpador no primeiro ponto de apalpação, em avanço rápido (valor da coluna { $mp-positioning-feed }) e com lógica de posicionamento. Desvia o apalpador no valor da distância de segurança, no sentido oposto à direção de deslocação.
step-position-offset-at-first-touch-point__tnc426-430 = O comando posiciona o apalpador no primeiro ponto de apalpação, em avanço rápido (valor de { $mp-positioning-feed } ou { $mp-analog-positioning-feed }) e com lógica de posicionamento. Desvia o apalpador no valor da distância de segurança, no sentido oposto à direção de deslocação.
step-travel-to-and-probe-second-point = O apalpador desloca-se para o segundo ponto de apalpação e executa aí a segunda apalpação.
step-retract-and-carry-out-basic-rotation = O comando faz regressar o apalpador à altura segura { $q-clearance-height } e executa a rotação básica que determinou.
note-basic-rotation-reset-at-start = No início do ciclo, o comando anula uma rotação básica ativa.
note-known-reference-direction = Com { $q-reference-line-angle }, o comando corrige o valor medido com um ângulo conhecido. A rotação básica pode assim ser medida em qualquer reta da peça e, ainda assim, referir-se à direção real de 0°.

# --- 400 ---
cycle-basic-rotation = Rotação básica
    .nc = ROTAÇÃO BÁSICA
    .purpose = Determina a inclinação de uma peça medindo dois pontos que têm de situar-se sobre uma reta. O comando compensa-a por meio de uma rotação básica.
step-store-basic-rotation = O comando guarda a rotação básica:
say-rotation-into-preset-row = com { $q-basic-rotation-row } diferente de 0, na linha { $q-basic-rotation-row } da tabela de presets
say-rotation-into-rot-menu = com { $q-basic-rotation-row }=0, no menu ROT do modo de funcionamento Manual

# --- 401 and 402 ---
cycle-rotation-two-holes = Rotação básica através de dois furos
    .nc = ROT 2 FUROS
    .purpose = Mede os centros de dois furos e calcula o ângulo entre o eixo principal do plano de maquinação e a reta que une os centros. O comando compensa o ângulo por meio de uma rotação básica ou por rotação da mesa rotativa.
cycle-rotation-two-holes__tnc426-430 =
    .purpose = Mede os centros de dois furos e calcula o ângulo entre o eixo principal do plano de maquinação e a reta que une os centros. O comando compensa o ângulo por meio de uma rotação básica.
cycle-rotation-two-studs = Rotação básica através de duas ilhas
    .nc = ROT 2 ILHAS
    .nc-aliases = PROT 2 ILHA
    .purpose = Mede os centros de duas ilhas e calcula o ângulo entre o eixo principal do plano de maquinação e a reta que une os centros. O comando compensa o ângulo por meio de uma rotação básica ou por rotação da mesa rotativa.
cycle-rotation-two-studs__tnc426-430 =
    .purpose = Mede os centros de duas ilhas e calcula o ângulo entre o eixo principal do plano de maquinação e a reta que une os centros. O comando compensa o ângulo por meio de uma rotação básica.
step-position-at-first-hole = O comando posiciona o apalpador no centro programado do primeiro furo, em avanço rápido (valor da coluna { $mp-positioning-feed }) e com lógica de posicionamento.
step-position-at-first-hole__tnc426-430 = O comando posiciona o apalpador no centro programado do primeiro furo, em avanço rápido (valor de { $mp-positioning-feed } ou { $mp-analog-positioning-feed }) e com lógica de posicionamento.
step-measure-first-hole = O apalpador desloca-se para a altura de medição { $q-measuring-height } e determina o centro do primeiro furo com quatro apalpações.
step-position-at-second-hole = O apalpador regressa à altura segura { $q-clearance-height } e é posicionado no centro programado do segundo furo.
step-measure-second-hole = O apalpador desloca-se para a altura de medição { $q-measuring-height } e determina o centro do segundo furo com quatro apalpações.
step-position-at-first-stud = O comando posiciona o apalpador no primeiro ponto de apalpação da primeira ilha, em avanço rápido (valor da coluna { $mp-positioning-feed }) e com lógica de posicionamento.
step-position-at-first-stud__tnc426-430 = O comando posiciona o apalpador no primeiro ponto de apalpação da primeira ilha, em avanço rápido (valor de { $mp-positioning-feed } ou { $mp-analog-positioning-feed }) e com lógica de posicionamento.
step-measure-first-stud = O apalpador desloca-se para a altura de medição { $q-measuring-height } e determina o centro da primeira ilha com quatro apalpações. Entre os pontos de apalpação, que distam 90° entre si, desloca-se sobre um arco de círculo: com { $q-traverse-to-clearance-height }=0, à altura de medição; com { $q-traverse-to-clearance-height }=1, à altura segura.
step-measure-first-stud__tnc426-430 = O apalpador desloca-se para a altura de medição { $q-measuring-height } e determina o centro da primeira ilha com quatro apalpações. Entre os pontos de apalpação desloca-se à altura de medição com { $q-traverse-to-clearance-height }=0 e à altura segura com { $q-traverse-to-clearance-height }=1.
step-position-at-second-stud = O apalpador regressa à altura segura { $q-clearance-height } e é posicionado no primeiro ponto de apalpação da segunda ilha.
step-measure-second-stud = O apalpador desloca-se para a altura de medição { $q-second-measuring-height } e determina o centro da segunda ilha com quatro apalpações.
step-compensate-as-chosen = O comando compensa a inclinação conforme a escolha em { $q-misalignment-compensation }:
say-rotation-into-preset-row-if-chosen = com { $q-misalignment-compensation }=0 e { $q-basic-rotation-row } diferente de 0, guarda a rotação básica na linha { $q-basic-rotation-row } da tabela de presets
say-rotation-into-rot-menu-if-chosen = com { $q-misalignment-compensation }=0 e { $q-basic-rotation-row }=0, guarda a rotação básica no menu ROT do modo de funcionamento Manual
say-turn-rotary-table = com { $q-misalignment-compensation }=1, roda a mesa rotativa em vez de guardar uma rotação básica; com { $q-zero-after-alignment }=1, coloca depois a 0 a visualização do eixo rotativo
note-rotary-axis-by-tool-axis = Para compensar a inclinação por rotação da mesa rotativa, o comando utiliza automaticamente estes eixos rotativos: C com o eixo da ferramenta Z, B com o eixo da ferramenta Y, A com o eixo da ferramenta X.
note-no-tilting-with-this-cycle = Este ciclo não é permitido com o plano de maquinação inclinado.
title-rotation-from-two-holes = Determinar uma rotação básica através de dois furos

# --- 403 ---
cycle-rotation-by-rotary-axis = Compensar rotação básica através de um eixo rotativo
    .nc = ROT ATRAVÉS DE EIXO C
    .nc-aliases = ROT ATRAVÉS DE EIXO ROTATIVO
    .purpose = Determina a inclinação de uma peça medindo dois pontos que têm de situar-se sobre uma reta. O comando compensa-a rodando o eixo A, B ou C. A peça pode estar fixada em qualquer local da mesa rotativa.
step-retract-and-turn-rotary-axis = O comando faz regressar o apalpador à altura segura { $q-clearance-height } e roda o eixo rotativo { $q-compensation-axis } no valor calculado. Guarda também o ângulo no parâmetro de resultado. Se pretendido, coloca a visualização a 0 depois de alinhar.
step-retract-and-turn-rotary-axis__tnc426-430 = O comando faz regressar o apalpador à altura segura { $q-clearance-height } e roda o eixo rotativo { $q-compensation-axis } no valor calculado.
note-compensation-may-be-turned-180 = Perigo de colisão! O comando só verifica de forma aproximada se os pontos de apalpação e o eixo de compensação fazem sentido em conjunto. Por isso, pode haver movimentos de compensação rodados 180°.
note-compensation-axis-combinations = Combinações permitidas do eixo de medição { $q-measuring-axis } e do eixo de compensação { $q-compensation-axis }. Eixo do apalpador Z: 1 com 6, 2 com 6, 3 com 5 ou 4. Eixo do apalpador Y: 1 com 5, 2 com 5, 3 com 6 ou 4. Eixo do apalpador X: 1 com 4, 2 com 4, 3 com 5 ou 6.
note-only-without-tilting = Utilize este ciclo só enquanto a função de inclinação do plano de maquinação não estiver ativa.

# --- 404 ---
cycle-set-basic-rotation = Memorizar rotação básica
    .nc = ROTAÇÃO BÁSICA
    .nc-aliases = MEMORIZAR ROTAÇÃO BÁSICA
    .purpose = Memoriza automaticamente, durante a execução do programa, uma rotação básica qualquer. Destina-se sobretudo a anular uma rotação básica executada anteriormente.
step-set-basic-rotation = O comando memoriza a rotação básica com o ângulo { $q-basic-rotation-angle }.
note-available-from-nc-software = Disponível a partir do software NC 280 474-xx.

# --- 405 ---
cycle-rotation-by-c-axis = Ajustar a inclinação de uma peça através do eixo C
    .nc = ROT ATRAVÉS DE EIXO C
    .nc-aliases = ROT ATRAVÉS DE EIXO-C
    .purpose = Determina o desvio angular entre o eixo Y positivo do sistema de coordenadas ativo e a linha central de um furo, ou entre a posição nominal e a posição real do centro de um furo. O comando compensa-o rodando o eixo C. A peça pode estar fixada em qualquer local da mesa rotativa.
say-travel-on-circle-at-clearance-height__rotation-by-c-axis = com { $q-traverse-to-clearance-height }=1, sobre um arco de círculo, à altura segura { $q-clearance-height }
step-move-to-measured-centre = O comando posiciona o apalpador no centro medido do furo.
step-retract-and-turn-to-y-axis = O comando faz regressar o apalpador à altura segura { $q-clearance-height } e alinha a peça por rotação da mesa rotativa: depois da compensação, tanto com o eixo do apalpador vertical como horizontal, o centro do furo fica na direção do eixo Y positivo ({ $q-probing-centre-minor }=0) ou na sua posição nominal. O desvio angular medido é também guardado no parâmetro de resultado.
step-store-angular-offset = O comando trata o desvio angular conforme { $q-zero-or-row-after-alignment }:
say-zero-display-of-c-axis = com { $q-zero-or-row-after-alignment }=0, coloca a 0 a visualização do eixo C
say-offset-into-column-c = com { $q-zero-or-row-after-alignment } maior do que 0, escreve o desvio angular, com o seu sinal, na coluna C da linha { $q-zero-or-row-after-alignment } da tabela de pontos zero; soma-se a um desvio de C que a linha já tenha
note-smallest-stepping-angle__rotation-by-c-axis = Quanto menor for o passo angular { $q-probing-stepping-angle }, menos exato é o centro do círculo que o comando calcula. Valor de introdução mínimo: 5°.
note-hole-with-positive-y = A coordenada Y do furo tem de ser positiva.
note-repeat-with-horizontal-probe = Se o desvio angular do furo for medido com o eixo do apalpador Y (furo horizontal), pode ser necessário executar o ciclo várias vezes: o modo de medição provoca uma inexatidão de cerca de 1% da inclinação.

# --- results ---
result-alignment-angle-determined = Ângulo determinado
result-angular-offset-measured = Desvio angular medido
