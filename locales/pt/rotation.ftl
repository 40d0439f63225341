# Ciclos que registam e compensam a inclinação da peça.

# --- 400 ---
cycle-basic-rotation = Rotação básica
    .nc = ROTAÇÃO BÁSICA

# --- 401 e 402 ---
cycle-rotation-two-holes = Rotação básica através de dois furos
    .nc = ROT 2 FUROS
cycle-rotation-two-studs = Rotação básica através de duas ilhas
    .nc = ROT 2 ILHAS
    .nc-aliases = PROT 2 ILHA

# --- 403 ---
cycle-rotation-by-rotary-axis = Compensar rotação básica através de um eixo rotativo
    .nc = ROT ATRAVÉS DE EIXO C
    .nc-aliases = ROT ATRAVÉS DE EIXO ROTATIVO

# --- 404 ---
cycle-set-basic-rotation = Memorizar rotação básica
    .nc = ROTAÇÃO BÁSICA
    .nc-aliases = MEMORIZAR ROTAÇÃO BÁSICA

# --- 405 ---
cycle-rotation-by-c-axis = Ajustar a inclinação de uma peça através do eixo C
    .nc = ROT ATRAVÉS DE EIXO C
    .nc-aliases = ROT ATRAVÉS DE EIXO-C
