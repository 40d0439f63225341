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
