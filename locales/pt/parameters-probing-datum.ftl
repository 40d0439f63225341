# Parâmetros dos ciclos de inclinação e de ponto de referência: nome, texto na frase NC, ajuda.

# --- 414 e 415 ---
parameter-third-point-main = 3.º ponto de medição 1º eixo
    .label = 3º PONTO 1º EIXO
parameter-third-point-minor = 3.º ponto de medição 2º eixo
    .label = 3º PONTO 2.º EIXO
parameter-point-distance-main = Distância 1.º eixo
    .label = DISTÂNCIA 1º EIXO
parameter-point-distance-minor = Distância 2.º eixo
    .label = DISTÂNCIA 2º EIXO
parameter-corner-number = Esquina
    .label = ESQUINA
parameter-corner-basic-rotation = Executar rotação básica
    .label = ROTAÇÃO BÁSICA
parameter-traverse-to-clearance-height__datum-inside-corner = Deslocação à Altura Segura

# --- dois pontos numa reta ---
parameter-first-point-main = 1.º ponto de medição 1º eixo
    .label = 1.º PONTO 1.º EIXO
parameter-first-point-minor = 1.º ponto de medição 2.º eixo
    .label = 1º PONTO 2.º EIXO
    .label-aliases = 1° PONTO 2.° EIXO | 1.º PONTO 2.º EIXO
parameter-second-point-main = 2.º ponto de medição 1.º eixo
    .label = 2.º PONTO 1.º EIXO
parameter-second-point-minor = 2.º ponto de medição 2.º eixo
    .label = 2.º PONTO 2.º EIXO
parameter-measuring-axis = Eixo de medição
    .label = EIXO DE MEDIÇÃO
parameter-measuring-axis__rotation-by-rotary-axis = Eixo de medição
parameter-traverse-direction = Direcção de deslocação 1
    .label = DIRECÇÃO DE DESLOCAÇÃO
parameter-clearance-height__basic-rotation = Altura de segurança
parameter-clearance-height__rotation-by-rotary-axis =
    .label = ALTURA SEGURANÇA
    .label-aliases = ALTURA SEGURA

# --- dois furos ou ilhas ---
parameter-first-centre-main = 1.º furo: centro do 1º eixo
    .label = 1.º CENTRO 1.º EIXO
parameter-first-centre-minor = 1.º furo: centro do 2º eixo
    .label = 1.º CENTRO 2.º EIXO
parameter-second-centre-main = 2.º furo: centro do 1º eixo
    .label = 2.º CENTRO 1.º EIXO
parameter-second-centre-minor = 2.º furo: centro do 2º eixo
    .label = 2.º CENTRO 2.º EIXO
parameter-first-centre-main__rotation-two-studs = 1.ª ilha: centro do 1º eixo
parameter-first-centre-minor__rotation-two-studs = 1.ª ilha: centro do 2º eixo
parameter-second-centre-main__rotation-two-studs = 2.ª ilha: centro do 1º eixo
parameter-second-centre-minor__rotation-two-studs = 2.ª ilha: centro do 2º eixo
parameter-first-stud-diameter = Diâmetro ilha 1
    .label = DIÂMETRO ILHA 1
parameter-second-stud-diameter = Diâmetro ilha 2
    .label = DIÂMETRO ILHA 2
parameter-measuring-height__rotation-two-studs = Altura de medição ilha 1 no eixo TS
    .label = ALTURA DE MEDIÇÃO 1
parameter-second-measuring-height = Altura de medição ilha 2 no eixo TS
    .label = ALTURA DE MEDIÇÃO 2

# --- o que se faz com o ângulo ---
parameter-reference-line-angle = Ajuste prévio da rotação básica
    .label = AJUSTE PRÉVIO ROTAÇ. BÁSICA
    .label-aliases = AJUSTE PRÉVIO ROTAÇ.BÁSICA
parameter-reference-line-angle__tnc320 =
    .label = AJUSTE PRÉVIO ROT.BÁSICA
    .label-aliases = AJUSTE PRÉVIO ROTAÇ. BÁSICA | AJUSTE PRÉVIO ROTAÇ.BÁSICA
parameter-reference-line-angle__rotation-two-studs =
    .label = AJUSTE PRÉVIO ROTAÇ.BÁSICA
    .label-aliases = AJUSTE PRÉVIO ROTAÇ. BÁSICA
parameter-reference-line-angle__rotation-two-studs__tnc320 =
    .label = AJUSTE PRÉVIO ROT.BÁSICA
    .label-aliases = AJUSTE PRÉVIO ROTAÇ. BÁSICA | AJUSTE PRÉVIO ROTAÇ.BÁSICA
parameter-basic-rotation-angle = Ajuste prévio rotação básica
    .label = AJUSTE PRÉVIO ROTAÇ.BÁSICA
    .label-aliases = AJUSTE PRÉVIO ROTAÇ. BÁSICA
parameter-basic-rotation-angle__tnc320 =
    .label = AJUSTE PRÉVIO ROT.BÁSICA
    .label-aliases = AJUSTE PRÉVIO ROTAÇ. BÁSICA | AJUSTE PRÉVIO ROTAÇ.BÁSICA
parameter-zero-or-row-after-alignment = Memorizar zero depois de centrar
    .label = MEMORIZAR ZERO
parameter-compensation-axis = Eixo para deslocação de compensação
    .label = EIXO DE COMPENSAÇÃO
