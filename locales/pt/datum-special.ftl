# Ciclos que memorizam o ponto de referência no círculo de furos, no eixo do apalpador, entre quatro furos e num só eixo.

# --- 416 ---
cycle-datum-bolt-hole-circle = Ponto de referência centro do círculo de furos
    .nc = PONTO REF CENTRO CÍRCULO DE FUROS
    .nc-aliases = PONTO REF CENTRO CÍRCULO FUROS

# --- 417 ---
cycle-datum-probe-axis = Ponto de referência eixo do apalpador
    .nc = PONTO REF EIXO TS
    .nc-aliases = PONTO REF EIXO APALP

# --- 418 ---
cycle-datum-four-holes = Ponto de referência centro de 4 furos
    .nc = PONTO REF 4 FUROS
