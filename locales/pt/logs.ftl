# Words of the measuring logs.

# --- log of cycle 421 ---
log-hole-title = Registo de medição ciclo de apalpação { $cycle } Medir furo
log-date = Data:
log-time = Hora:
log-program = Programa de medição:
log-nominal-values = Valores nominais:
log-limits = Valores limite indicados previamente:
log-actual-values = Valores reais:
log-deviations = Desvios:
log-centre-main = Centro eixo principal:
log-centre-minor = Centro eixo secundário:
log-diameter = Diâmetro:
log-centre-main-greatest = Medida maior centro eixo principal:
log-centre-main-least = Medida menor centro eixo principal:
log-centre-minor-greatest = Medida maior centro eixo secundário:
log-centre-minor-least = Medida menor centro eixo secundário:
log-hole-greatest = Medida maior furo:
log-hole-least = Medida menor furo:
log-further-results = Outros resultados de medição:
log-measuring-height = Altura de medição:
log-end = Fim do registo de medição

# --- log of cycle 444 ---
log-surface-title = Registo de medição ciclo de apalpação { $cycle } Apalpação 3D
log-main-axis = Eixo principal
log-minor-axis = Eixo secundário
log-tool-axis = Eixo da ferramenta
log-probing-direction = Direção de apalpação real
log-nominal-coordinate = Coordenada nominal
log-actual-coordinate = Coordenada real
log-upper-deviation = Desvio superior
log-lower-deviation = Desvio inferior
log-deviation-along-normal = Desvio ao longo do vetor normal
log-deviation-3d = Desvio 3D
log-workpiece-status = Estado da peça
log-status-undefined = não definido
log-status-good = bom
log-status-rework = trabalho de acabamento
log-status-scrap = desperdício
