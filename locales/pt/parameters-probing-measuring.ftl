# Parâmetros dos ciclos que medem ângulos, ilhas, retângulos, larguras, coordenadas, círculos de furos e planos.

# --- 422 ---
parameter-stud-greatest-diameter = Medida maior Ilha
    .label = MEDIDA MAIOR
parameter-stud-least-diameter = Medida menor Ilha
    .label = MEDIDA MENOR

# --- 423, 424 ---
parameter-probing-first-side-length = Longitude lado 1
    .label = LONGITUDE LADO 1
parameter-probing-second-side-length = Longitude lado 2
    .label = LONGITUDE LADO 2
parameter-first-side-greatest-length = Medida maior longitude lado 1
    .label = MEDIDA MAIOR 1.º LADO
parameter-first-side-least-length = Medida menor longitude lado 1
    .label = MEDIDA MENOR 1.º LADO
parameter-second-side-greatest-length = Medida maior longitude lado 2
    .label = MEDIDA MAIOR 2.º LADO
parameter-second-side-least-length = Medida menor longitude lado 2
    .label = MEDIDA MENOR 2.º LADO

# --- 425, 426 ---
parameter-probing-start-main = Ponto de partida 1º eixo
    .label = PONTO DE PARTIDA 1º EIXO
parameter-probing-start-minor = Ponto de partida 2º eixo
    .label = PONTO DE PARTIDA 2º EIXO
parameter-second-measurement-offset = Desvio para a 2.ª medição
    .label = DESVIO 2.ª MEDIÇÃO
parameter-nominal-length = Longitude nominal
    .label = LONGITUDE NOMINAL
parameter-greatest-dimension = Medida maior
    .label = MEDIDA MAIOR
parameter-least-dimension = Medida menor
    .label = MEDIDA MENOR

# --- 427 ---
parameter-measuring-axis__measure-coordinate = Eixo de medição (1...3: 1=eixo principal)

# --- 430 ---
parameter-first-hole-angle = Ângulo 1.º furo
    .label = ÂNGULO 1.º FURO
parameter-second-hole-angle = Ângulo 2.º furo
    .label = ÂNGULO 2.º FURO
parameter-third-hole-angle = Ângulo 3.º furo
    .label = ÂNGULO 3.º FURO

# --- 420, 431 ---
parameter-first-point-tool = 1.º ponto de medição 3.º eixo
    .label = 1º PONTO 3º EIXO
parameter-second-point-tool = 2.º ponto de medição 3.º eixo
    .label = 2º PONTO 3º EIXO
parameter-third-point-tool = 3.º ponto de medição 3º eixo
    .label = 3º PONTO 3º EIXO

# --- 417 ---
parameter-new-datum-probe-axis__datum-probe-axis = Novo ponto de referência eixo TS

# --- 418 ---
parameter-first-centre-main__datum-four-holes = Centro 1 do 1.º eixo
parameter-first-centre-minor__datum-four-holes = Centro 1 do 2.º eixo
parameter-second-centre-main__datum-four-holes = Centro 2 do 1.º eixo
parameter-second-centre-minor__datum-four-holes = Centro 2 do 2.º eixo
parameter-third-centre-main = Centro 3 do 1.º eixo
    .label = 3.º CENTRO 1.º EIXO
parameter-third-centre-minor = Centro 3 do 2.º eixo
    .label = 3.º CENTRO 2.º EIXO
parameter-fourth-centre-main = Centro 4 do 1.º eixo
    .label = 4.º CENTRO 1.º EIXO
parameter-fourth-centre-minor = Centro 4 do 2.º eixo
    .label = 4.º CENTRO 2.º EIXO

# --- 1, 3 ---
parameter-polar-probing-axis = Eixo de apalpação
parameter-polar-probing-angle = Ângulo de apalpação
    .word = ÂNGULO:
parameter-greatest-measuring-path = Máximo caminho de medição
    .word = DIST
parameter-measuring-feed = Avanço
