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
