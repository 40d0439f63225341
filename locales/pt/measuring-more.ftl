# Ciclos que medem ângulos, ilhas, retângulos, larguras, coordenadas, círculos de furos e planos.

# --- 422 ---
cycle-measure-stud = Medir círculo exterior
    .nc = MEDIR CÍRCULO EXTERIOR
    .nc-aliases = MEDIÇÃO DUM CÍRCULO EXTERIOR

# --- 423, 424 ---
cycle-measure-rectangular-pocket = Medir rectângulo interior
    .nc = MEDIR RECTÂNGULO INT.
    .nc-aliases = MEDIÇÃO DUM RECTÂNGULO INTERIOR
cycle-measure-rectangular-stud = Medir rectângulo exterior
    .nc = MEDIR RECTÂNGULO EXT.
    .nc-aliases = MEDIR RECTÂNG. EXTERIOR | MEDIÇÃO DUM RECTÂNGULO EXTERIOR
result-side-main-actual = Valor real longitude do lado eixo principal
result-side-minor-actual = Valor real longitude do lado eixo secundário
result-side-main-deviation = Desvio longitude do lado eixo principal
result-side-minor-deviation = Desvio longitude do lado eixo secundário

# --- 425, 426 ---
cycle-measure-slot-width = Medir largura interior
    .nc = MEDIR LARGURA INTERIOR
    .nc-aliases = MEDIÇÃO LARGURA INTERIOR
cycle-measure-ridge-width = Medir nervura exterior
    .nc = MEDIR NERVURA EXTERIOR
    .nc-aliases = MEDIÇÃO NERVURA EXTERIOR
result-measured-length-actual = Valor real longitude medida
result-measured-length-deviation = Desvio da longitude medida
result-centre-axis-actual = Valor real posição eixo central

# --- 427 ---
cycle-measure-coordinate = Medir coordenadas
    .nc = MEDIR COORDENADA
    .nc-aliases = MEDIÇÃO DE COORDENADA

# --- 430 ---
cycle-measure-bolt-hole-circle = Medir círculo de furos
    .nc = MEDIR CÍRCULO DE FUROS
    .nc-aliases = MEDIÇÃO CÍRCULO DE FUROS
result-bolt-circle-diameter-actual = Valor real diâmetro do círculo de furos
result-bolt-circle-diameter-deviation = Desvio diâmetro do círculo de furos

# --- 420 ---
cycle-measure-angle = Medir ângulo
    .nc = MEDIR ÂNGULO
    .nc-aliases = MEDIÇÃO ÂNGULO
result-measured-angle = O ângulo medido referente ao eixo principal do plano de maquinação

# --- 431 ---
cycle-measure-plane = Medir plano
    .nc = MEDIR PLANO
    .nc-aliases = MEDIÇÃO DUM PLANO
result-projection-angle-a__tnc426-430 = Ângulo do eixo A
result-projection-angle-b__tnc426-430 = Ângulo do eixo B

# --- 1 ---
cycle-polar-reference-plane = Plano de referência polar
    .nc = PONTO DE REFERÊNCIA POLAR
    .nc-aliases = PLANO DE REFERÊNCIA POLAR

# --- 3 ---
cycle-measuring = Medir
    .nc = MEDIR
