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

# --- logs of the other measuring cycles ---
log-angle-title = Registo de medição ciclo de apalpação { $cycle } Medir ângulo
log-stud-title = Registo de medição ciclo de apalpação { $cycle } Medir círculo exterior
log-pocket-title = Registo de medição ciclo de apalpação { $cycle } Medir caixa rectangular
log-rectangular-stud-title = Registo de medição ciclo de apalpação { $cycle } Medir ilha rectangular
log-slot-title = Registo de medição ciclo de apalpação { $cycle } Medir largura interior
log-ridge-title = Registo de medição ciclo de apalpação { $cycle } Medir nervura exterior
log-coordinate-title = Registo de medição ciclo de apalpação { $cycle } Medir coordenadas
log-bolt-circle-title = Registo de medição ciclo de apalpação { $cycle } Medir círculo de furos
log-plane-title = Registo de medição ciclo de apalpação { $cycle } Medir plano
log-stud-greatest = Medida maior ilha:
log-stud-least = Medida menor ilha:
log-side-main = Longitude do lado eixo principal:
log-side-minor = Longitude do lado eixo secundário:
log-side-main-greatest = Medida maior longitude do lado eixo principal:
log-side-main-least = Medida menor longitude do lado eixo principal:
log-side-minor-greatest = Medida maior longitude do lado eixo secundário:
log-side-minor-least = Medida menor longitude do lado eixo secundário:
log-greatest = Medida maior:
log-least = Medida menor:
log-length = Longitude:
log-centre-line = Posição eixo central:
log-angle = Ângulo:
log-coordinate = Coordenada:
log-bolt-circle-diameter = Diâmetro do círculo de furos:
log-plane-angle-a = Ângulo de projeção do eixo A:
log-plane-angle-a__tnc426-430 = Ângulo do eixo A:
log-plane-angle-b = Ângulo de projeção do eixo B:
log-plane-angle-b__tnc426-430 = Ângulo do eixo B:
log-spatial-angle-a = Ângulo espacial A:
log-spatial-angle-b = Ângulo espacial B:
log-spatial-angle-c = Ângulo espacial C:
log-first-in-probe-axis = Valor medido no eixo do apalpador (primeira medição):
log-first-in-probe-axis__tnc320 = Valor medido no eixo do apalpador:
log-second-in-probe-axis = Valor medido no eixo do apalpador (segunda medição):
log-third-in-probe-axis = Valor medido no eixo do apalpador (terceira medição):

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

# --- kinematics ---
log-kinematics-memory-title = Registo ciclo de apalpação { $cycle } Guardar cinemática
log-measure-kinematics-title = Registo de medição ciclo de apalpação { $cycle } Medir cinemática
log-preset-compensation-title = Registo de medição ciclo de apalpação { $cycle } Compensação de preset
log-mode = Modo:
log-kinematics = Cinemática ativa:
log-memory = Posição de memória:
log-memories = Cinemáticas guardadas:
log-kinematics-saved = Eixos e transformações guardados:
log-kinematics-before = Transformações antes do restauro:
log-kinematics-after = Transformações após o restauro:
log-rotary-axis = Eixo rotativo
log-centre-of-axis = centro
log-direction-of-axis = inclinação
log-preset-shift = Deslocação do preset:
log-sphere-radius = Raio da esfera introduzido:
log-start-angle = Ângulo inicial:
log-end-angle = Ângulo final:
log-incidence-angle = Ângulo de incidência:
log-measuring-points = Número de pontos de medição:
log-scatter-measured = Dispersão medida:
log-scatter-optimized = Dispersão otimizada:
log-greatest-error = Erro máximo:
log-angular-error = Erro angular:
log-mean-backlash = Folga média:
log-mean-positioning-error = Erro de posicionamento médio:
log-measuring-circle = Raio do círculo de medição:
log-compensation = Valores de correção:
log-rating = Avaliação dos pontos de medição:
log-uncertainty = Incerteza de medição (graus por µm):

# --- masks of formatted output (FN 16): how the keywords of a control name this language ---
log-mask-language = Portuguese
