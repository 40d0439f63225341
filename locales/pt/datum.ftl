# Cycles that set a datum.

# --- 412 ---
cycle-datum-inside-circle = Ponto de referência: círculo interior
    .nc = PONTO REF CÍRCULO INTERIOR
    .purpose = Mede o centro de uma caixa circular ou de um furo e memoriza-o como ponto de referência. Se pretendido, o comando escreve também o centro numa tabela de pontos zero ou na tabela de presets.
cycle-datum-inside-circle__tnc426-430 =
    .purpose = Mede o centro de uma caixa circular ou de um furo e memoriza-o como ponto de referência. Se pretendido, o comando escreve também o centro numa tabela de pontos zero.
step-retract-and-store-datum = O comando faz regressar o apalpador à altura segura { $q-clearance-height }, guarda os valores reais nos parâmetros de resultado e define ou memoriza o ponto de referência medido conforme { $q-measured-value-transfer } e { $q-datum-row-number }:
step-retract-and-store-datum__tnc426-430 = O comando faz regressar o apalpador à altura segura { $q-clearance-height } e define ou memoriza o ponto de referência medido conforme { $q-datum-row-number }:
say-datum-into-display-and-row-zero = com { $q-datum-row-number }=0, define na visualização o ponto de referência medido; este fica logo ativo e é também guardado na linha 0 da tabela de presets
say-datum-into-display = com { $q-datum-row-number }=0, define na visualização o ponto de referência medido; este fica logo ativo
say-datum-into-datum-table = com { $q-datum-row-number } diferente de 0 e { $q-measured-value-transfer }=0, escreve o ponto de referência medido na linha { $q-datum-row-number } da tabela de pontos zero ativa; o sistema de referência é o sistema de coordenadas da peça ativo
say-datum-into-datum-table__tnc426-430 = com { $q-datum-row-number } diferente de 0, escreve o ponto de referência medido na linha { $q-datum-row-number } da tabela de pontos zero ativa
say-datum-into-preset-table = com { $q-datum-row-number } diferente de 0 e { $q-measured-value-transfer }=1, escreve o ponto de referência medido na linha { $q-datum-row-number } da tabela de presets; o sistema de referência é o sistema de coordenadas da máquina (coordenadas REF)
step-probe-in-probe-axis = Se pretendido, o comando mede a seguir, numa apalpação à parte, o ponto de referência no eixo do apalpador:
say-datum-in-probe-axis = com { $q-probing-in-probe-axis }=1, apalpa no eixo do apalpador o ponto { $q-probe-axis-point-main }, { $q-probe-axis-point-minor }, { $q-probe-axis-point-tool }, recua e define ou memoriza o ponto de referência { $q-new-datum-probe-axis } tal como o do plano de maquinação
guard-datum-transfer-undefined = { $q-datum-row-number } é diferente de 0 e { $q-measured-value-transfer } é −1: defina onde se guarda o ponto de referência medido.
guard-transformation-with-probe-axis-datum = Está ativa uma deslocação do ponto zero ou uma rotação, mas { $q-measured-value-transfer }=0 e { $q-probing-in-probe-axis }=1 não admitem nenhuma conversão de coordenadas.
note-nominal-diameter-rather-small = Perigo de colisão! Para que o apalpador não colida com a peça, introduza o diâmetro nominal da caixa (furo) aproximado por defeito.
note-probing-from-centre-if-narrow = Se as medidas da caixa e a distância de segurança não permitirem um posicionamento prévio perto dos pontos de apalpação, o comando começa sempre a apalpar a partir do centro da caixa. O apalpador não se desloca então à altura segura entre os pontos de medição.
note-no-transformation-with-probe-axis-datum = Se o ciclo memorizar um ponto de referência com { $q-measured-value-transfer }=0 e apalpar também no eixo do apalpador ({ $q-probing-in-probe-axis }=1), não pode estar ativa nenhuma conversão de coordenadas.
note-no-tilting-with-datum-cycles = Não é permitido inclinar o plano de maquinação juntamente com os ciclos de memorização do ponto de referência 408 a 419.
note-datum-cycles-with-basic-rotation = Os ciclos de memorização do ponto de referência 408 a 419 podem ser executados também com uma rotação básica ativa.
note-datum-cycles-with-basic-rotation__tnc640 = Os ciclos de memorização do ponto de referência 408 a 419 podem ser executados também com uma rotação ativa (rotação básica ou ciclo 10).
note-basic-rotation-must-stay = Não modifique o ângulo da rotação básica se, depois do ciclo de medição, se utilizar uma deslocação do ponto zero (ciclo 7) a partir da tabela de pontos zero.
note-no-datum-cycles-with-basic-rotation = Os ciclos de memorização do ponto de referência 410 a 418 não podem ser executados com uma rotação básica ativa. Caso contrário, o comando emite um aviso de erro.
note-datum-axes-by-probe-axis = O eixo do apalpador definido no programa de medição determina os eixos em que é memorizado o ponto de referência: Z: X e Y; Y: Z e X; X: Y e Z.
note-datum-axes-by-probe-axis__tnc426-430 = O eixo do apalpador definido no programa de medição determina os eixos em que é memorizado o ponto de referência: Z ou W: X e Y; Y ou V: Z e X; X ou U: Y e Z.
note-transfer-minus-one = { $q-datum-row-number } diferente de 0 juntamente com { $q-measured-value-transfer }=−1 só ocorre em programas com os ciclos 410 a 418 que provenham de um TNC 4xx ou de um software mais antigo do iTNC 530, ou se a transmissão tiver ficado por definir na definição do ciclo. O comando emite então um aviso de erro, porque mudou o tratamento das tabelas de pontos zero referidas ao ponto zero da máquina; defina a transmissão.
note-activate-stored-datum = No programa, um ponto de referência guardado na tabela de pontos zero é ativado com o ciclo 7; um guardado na tabela de presets, com o ciclo 247.
note-datum-table-must-be-active = Para escrever o ponto de referência medido numa tabela de pontos zero, ative uma tabela de pontos zero num modo de funcionamento de execução do programa (estado M) antes de iniciar o programa de medição.
note-datum-table-reference = Ao escrever na tabela de pontos zero, o comando tem em conta { $mp-datum-table-reference }: 0: valores referidos ao ponto zero da peça; 1: valores referidos ao ponto zero da máquina. Se { $mp-datum-table-reference } for modificado mais tarde, o comando converte os valores guardados nas tabelas de pontos zero.
