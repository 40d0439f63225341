# Parâmetros dos ciclos que medem ângulos, ilhas, retângulos, larguras, coordenadas, círculos de furos e planos.

# --- 422 ---
parameter-probing-centre-main__measure-stud =
    .help = Centro da ilha no eixo principal do plano de maquinação.
parameter-probing-centre-minor__measure-stud =
    .help = Centro da ilha no eixo secundário do plano de maquinação.
parameter-probing-nominal-diameter__measure-stud =
    .help = Diâmetro da ilha.
parameter-number-of-touch-points__measure-stud =
    .help = Determina se a ilha é medida com quatro ou com três apalpações.
parameter-stud-greatest-diameter = Medida maior da ilha
    .label = MEDIDA MAIOR
    .help = Maior diâmetro permitido para a ilha.
parameter-stud-least-diameter = Medida menor da ilha
    .label = MEDIDA MENOR
    .help = Menor diâmetro permitido para a ilha.

# --- 423, 424 ---
parameter-probing-centre-main__measure-rectangular-pocket =
    .help = Centro da caixa no eixo principal do plano de maquinação.
parameter-probing-centre-minor__measure-rectangular-pocket =
    .help = Centro da caixa no eixo secundário do plano de maquinação.
parameter-probing-centre-main__measure-rectangular-stud =
    .help = Centro da ilha no eixo principal do plano de maquinação.
parameter-probing-centre-minor__measure-rectangular-stud =
    .help = Centro da ilha no eixo secundário do plano de maquinação.
parameter-probing-first-side-length = Longitude lado 1
    .label = LONGITUDE LADO 1
    .help = Longitude da caixa, paralela ao eixo principal do plano de maquinação.
parameter-probing-first-side-length__measure-rectangular-stud =
    .help = Longitude da ilha, paralela ao eixo principal do plano de maquinação.
parameter-probing-second-side-length = Longitude lado 2
    .label = LONGITUDE LADO 2
    .help = Longitude da caixa, paralela ao eixo secundário do plano de maquinação.
parameter-probing-second-side-length__measure-rectangular-stud =
    .help = Longitude da ilha, paralela ao eixo secundário do plano de maquinação.
parameter-first-side-greatest-length = Medida maior longitude lado 1
    .label = MEDIDA MAIOR 1.º LADO
    .help = Maior longitude permitida para a caixa.
parameter-first-side-greatest-length__measure-rectangular-stud =
    .help = Maior longitude permitida para a ilha.
parameter-first-side-least-length = Medida menor longitude lado 1
    .label = MEDIDA MENOR 1.º LADO
    .help = Menor longitude permitida para a caixa.
parameter-first-side-least-length__measure-rectangular-stud =
    .help = Menor longitude permitida para a ilha.
parameter-second-side-greatest-length = Medida maior longitude lado 2
    .label = MEDIDA MAIOR 2.º LADO
    .help = Maior largura permitida para a caixa.
parameter-second-side-greatest-length__measure-rectangular-stud =
    .help = Maior largura permitida para a ilha.
parameter-second-side-least-length = Medida menor longitude lado 2
    .label = MEDIDA MENOR 2.º LADO
    .help = Menor largura permitida para a caixa.
parameter-second-side-least-length__measure-rectangular-stud =
    .help = Menor largura permitida para a ilha.

# --- 425, 426 ---
parameter-probing-start-main = Ponto de partida 1º eixo
    .label = PONTO DE PARTIDA 1º EIXO
    .help = Ponto de partida da apalpação no eixo principal do plano de maquinação.
parameter-probing-start-minor = Ponto de partida 2º eixo
    .label = PONTO DE PARTIDA 2º EIXO
    .help = Ponto de partida da apalpação no eixo secundário do plano de maquinação.
parameter-second-measurement-offset = Desvio para a 2.ª medição
    .label = DESVIO 2.ª MEDIÇÃO
    .help = Distância em que o apalpador é desviado antes da segunda medição. Com 0, o comando não desvia o apalpador.
parameter-nominal-length = Longitude nominal
    .label = LONGITUDE NOMINAL
    .help = Valor nominal da longitude a medir.
parameter-greatest-dimension = Medida maior
    .label = MEDIDA MAIOR
    .help = Maior longitude permitida.
parameter-least-dimension = Medida menor
    .label = MEDIDA MENOR
    .help = Menor longitude permitida.
parameter-probing-clearance__measure-slot-width =
    .help = Distância adicional entre o ponto de medição e a esfera do apalpador. Soma-se a { $mp-set-up } e só atua na apalpação do ponto de referência no eixo do apalpador.

# --- 427 ---
parameter-measuring-axis__measure-coordinate = Eixo de medição (1...3: 1=eixo principal)
    .help = Eixo em que se faz a medição.
parameter-greatest-dimension__measure-coordinate =
    .help = Maior valor medido permitido.
parameter-least-dimension__measure-coordinate =
    .help = Menor valor medido permitido.

# --- 430 ---
parameter-probing-centre-main__measure-bolt-hole-circle = Centro 1.º eixo
    .help = Centro do círculo de furos (valor nominal) no eixo principal do plano de maquinação.
parameter-probing-centre-minor__measure-bolt-hole-circle =
    .help = Centro do círculo de furos (valor nominal) no eixo secundário do plano de maquinação.
parameter-probing-nominal-diameter__measure-bolt-hole-circle =
    .help = Diâmetro do círculo de furos.
parameter-first-hole-angle = Ângulo 1.º furo
    .label = ÂNGULO 1.º FURO
    .help = Ângulo, em coordenadas polares, do centro do primeiro furo no plano de maquinação.
parameter-second-hole-angle = Ângulo 2.º furo
    .label = ÂNGULO 2.º FURO
    .help = Ângulo, em coordenadas polares, do centro do segundo furo no plano de maquinação.
parameter-third-hole-angle = Ângulo 3.º furo
    .label = ÂNGULO 3.º FURO
    .help = Ângulo, em coordenadas polares, do centro do terceiro furo no plano de maquinação.
parameter-greatest-dimension__measure-bolt-hole-circle =
    .help = Maior diâmetro permitido para o círculo de furos.
parameter-least-dimension__measure-bolt-hole-circle =
    .help = Menor diâmetro permitido para o círculo de furos.
parameter-monitored-tool__measure-bolt-hole-circle =
    .help = Número ou nome da ferramenta cuja rotura o comando deve supervisionar, se for o caso.
parameter-monitored-tool__measure-bolt-hole-circle__tnc320 =
    .help = Número da ferramenta cuja rotura o comando deve supervisionar, se for o caso.
parameter-monitored-tool__measure-bolt-hole-circle__tnc426-430 =
    .help = Número da ferramenta cuja rotura o comando deve supervisionar, se for o caso.

# --- 420, 431 ---
parameter-first-point-tool = 1.º ponto de medição 3.º eixo
    .label = 1º PONTO 3º EIXO
    .help = Coordenada do primeiro ponto de apalpação no eixo do apalpador.
parameter-second-point-tool = 2.º ponto de medição 3.º eixo
    .label = 2º PONTO 3º EIXO
    .help = Coordenada do segundo ponto de apalpação no eixo do apalpador.
parameter-third-point-tool = 3.º ponto de medição 3º eixo
    .label = 3º PONTO 3º EIXO
    .help = Coordenada do terceiro ponto de apalpação no eixo do apalpador.
parameter-measuring-axis__measure-angle =
    .help = Eixo em que se faz a medição.

# --- 416 ---
parameter-probing-centre-main__datum-bolt-hole-circle = Centro 1.º eixo
    .help = Centro do círculo de furos (valor nominal) no eixo principal do plano de maquinação.
parameter-probing-centre-minor__datum-bolt-hole-circle =
    .help = Centro do círculo de furos (valor nominal) no eixo secundário do plano de maquinação.
parameter-probing-nominal-diameter__datum-bolt-hole-circle =
    .help = Diâmetro aproximado do círculo de furos. Quanto menor for o diâmetro dos furos, mais exato tem de ser este valor.
parameter-datum-row-number__datum-bolt-hole-circle =
    .help = Número na tabela de pontos zero ou na tabela de presets em que são guardadas as coordenadas do centro do círculo de furos. Com 0, o comando define a visualização de modo que o novo ponto de referência fique no centro do círculo de furos.
parameter-datum-row-number__datum-bolt-hole-circle__tnc426-430 =
    .help = Número na tabela de pontos zero em que são guardadas as coordenadas do centro do círculo de furos. Com 0, o comando define a visualização de modo que o novo ponto de referência fique no centro do círculo de furos.
parameter-new-datum-main__datum-bolt-hole-circle =
    .help = Coordenada no eixo principal que é atribuída ao centro do círculo de furos medido. Ajuste básico: 0.
parameter-new-datum-minor__datum-bolt-hole-circle =
    .help = Coordenada no eixo secundário que é atribuída ao centro do círculo de furos medido. Ajuste básico: 0.
parameter-probing-clearance__datum-bolt-hole-circle =
    .help = Distância adicional entre o ponto de medição e a esfera do apalpador. Soma-se a { $mp-set-up } e só atua na apalpação do ponto de referência no eixo do apalpador.

# --- 417 ---
parameter-datum-row-number__datum-probe-axis =
    .help = Número na tabela de pontos zero ou na tabela de presets em que é guardada a coordenada. Com 0, o comando define a visualização de modo que o novo ponto de referência fique na superfície apalpada.
parameter-datum-row-number__datum-probe-axis__tnc426-430 =
    .help = Número na tabela de pontos zero em que é guardada a coordenada. Com 0, o comando define a visualização de modo que o novo ponto de referência fique na superfície apalpada.

# --- 418 ---
parameter-third-centre-main = Centro 3 do 1.º eixo
    .label = 3.º CENTRO 1.º EIXO
    .help = Centro do terceiro furo no eixo principal do plano de maquinação.
parameter-third-centre-minor = Centro 3 do 2.º eixo
    .label = 3.º CENTRO 2.º EIXO
    .help = Centro do terceiro furo no eixo secundário do plano de maquinação.
parameter-fourth-centre-main = Centro 4 do 1.º eixo
    .label = 4.º CENTRO 1.º EIXO
    .help = Centro do quarto furo no eixo principal do plano de maquinação.
parameter-fourth-centre-minor = Centro 4 do 2.º eixo
    .label = 4.º CENTRO 2.º EIXO
    .help = Centro do quarto furo no eixo secundário do plano de maquinação.
parameter-datum-row-number__datum-four-holes =
    .help = Número na tabela de pontos zero ou na tabela de presets em que são guardadas as coordenadas do ponto de intersecção das retas de união. Com 0, o comando define a visualização de modo que o novo ponto de referência fique no ponto de intersecção das retas de união.
parameter-datum-row-number__datum-four-holes__tnc426-430 =
    .help = Número na tabela de pontos zero em que são guardadas as coordenadas do ponto de intersecção das retas de união. Com 0, o comando define a visualização de modo que o novo ponto de referência fique no ponto de intersecção das retas de união.
parameter-new-datum-main__datum-four-holes =
    .help = Coordenada no eixo principal que é atribuída ao ponto de intersecção medido das retas de união. Ajuste básico: 0.
parameter-new-datum-minor__datum-four-holes =
    .help = Coordenada no eixo secundário que é atribuída ao ponto de intersecção medido das retas de união. Ajuste básico: 0.

# --- 419 ---
parameter-measuring-axis__datum-one-axis = Eixo de medição (1...3: 1=eixo principal)
    .help = Eixo em que se faz a medição.
parameter-datum-row-number__datum-one-axis =
    .help = Número na tabela de pontos zero ou na tabela de presets em que é guardada a coordenada. Com 0, o comando define a visualização de modo que o novo ponto de referência fique na superfície apalpada.
parameter-new-datum-one-axis = Novo ponto de referência
    .label = PONTO DE REFª
    .help = Coordenada que é atribuída ao ponto de referência. Ajuste básico: 0.

# --- 1, 3 ---
parameter-polar-probing-axis = Eixo de apalpação
    .help = Eixo de apalpação, introduzido com a tecla de seleção de eixos ou com o teclado alfanumérico. Confirme com a tecla ENT.
parameter-polar-probing-axis__measuring =
    .help = Eixo em cuja direção se faz a apalpação. Confirme com a tecla ENT.
parameter-polar-probing-axis__measuring__tnc426-430 =
    .help = Eixo principal do plano de maquinação: X com o eixo da ferramenta Z, Z com o eixo da ferramenta Y, Y com o eixo da ferramenta X. Confirme com a tecla ENT.
parameter-polar-probing-angle = Ângulo de apalpação
    .word = ÂNGULO:
    .help = Ângulo, em relação ao eixo de apalpação, segundo o qual o apalpador se desloca.
parameter-result-parameter__measuring =
    .help = Número do parâmetro Q a que o comando atribui a primeira coordenada medida (X). Y e Z ficam nos parâmetros Q seguintes.
parameter-greatest-measuring-path = Máximo caminho de medição
    .word = DIST
    .help = Percurso do apalpador a partir do ponto de partida. Confirme com a tecla ENT.
parameter-measuring-feed = Avanço
    .help = Avanço de medição em mm/min.
parameter-greatest-retraction-path = Percurso de recuo máximo
    .help = Percurso no sentido oposto à direção de apalpação depois da deflexão da haste de apalpação. O comando faz recuar o apalpador, no máximo, até ao ponto de partida, pelo que não pode haver colisão.
parameter-probing-reference-system = Sistema de referência (0=REAL/1=REF)
    .word = SISTEMA DE REFERÊNCIA:
    .help = Determina se a direção de apalpação e o resultado se referem ao sistema de coordenadas atual (REAL, que pode estar deslocado ou rodado) ou ao sistema de coordenadas da máquina (REF).
parameter-probing-reference-system__tnc320 =
    .help = Determina se o resultado se refere ao sistema de coordenadas atual (REAL, que pode estar deslocado ou rodado) ou ao sistema de coordenadas da máquina (REF).
choice-probe-in-actual-system = apalpar no sistema atual e guardar o resultado no sistema REAL
choice-probe-in-machine-system = apalpar no sistema da máquina REF e guardar o resultado no sistema REF
parameter-probing-error-mode = Modo de erro (0=OFF/1=ON)
    .help = Determina se o comando emite um aviso de erro quando a haste de apalpação está defletida no início do ciclo. Com 1, o comando guarda −1 no quarto parâmetro de resultado e continua o ciclo.
parameter-probing-error-mode__tnc320 =
    .help = Determina se o comando emite um aviso de erro quando a haste de apalpação está defletida no início do ciclo. Com 1, o comando guarda 2,0 no quarto parâmetro de resultado e continua o ciclo.
choice-show-probing-error = emitir aviso de erro
choice-probing-error-off = não emitir aviso de erro

parameter-new-datum-probe-axis__datum-probe-axis = Novo ponto de referência eixo TS
parameter-first-point-main__datum-probe-axis = 1.º ponto de medição 1.º eixo
parameter-first-centre-main__datum-four-holes = Centro 1 do 1.º eixo
parameter-first-centre-minor__datum-four-holes = Centro 1 do 2.º eixo
parameter-second-centre-main__datum-four-holes = Centro 2 do 1.º eixo
parameter-second-centre-minor__datum-four-holes = Centro 2 do 2.º eixo
