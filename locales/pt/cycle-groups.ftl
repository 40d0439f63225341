# Titles of the groups of cycles.
cycle-group-drilling = Furar
cycle-group-threads = Roscar e fresar roscas
cycle-group-pockets = Caixas, ilhas e ranhuras
cycle-group-patterns = Figuras de pontos
cycle-group-contours = Contornos e superfícies cilíndricas
cycle-group-surfaces = Facejar superfícies
cycle-group-transforms = Conversão de coordenadas
cycle-group-special = Funções especiais
cycle-group-turning = Tornear
cycle-group-rotation = Inclinação da peça
cycle-group-datum = Memorização do ponto de referência
cycle-group-measuring = Medição de peças
cycle-group-calibration = Calibração do apalpador
cycle-group-kinematics = Medição da cinemática
cycle-group-tool-measurement = Medição de ferramentas
cycle-group-digitizing = Digitalização

# Cycles that a manual only names, and that no specification describes.
named-cycl-def-30 = Execução de dados 3D
named-cycl-def-39 = Contorno exterior na superfície cilíndrica
named-cycl-def-212 = Ciclo 212
named-cycl-def-213 = Acabamento da ilha
named-cycl-def-270 = Dados do traçado do contorno
named-cycl-def-275 = Ranhura de contorno trocoidal
named-cycl-def-290 = Torneamento por interpolação
named-tch-probe-4 = Medição 3D
named-tch-probe-9 = Calibração da longitude do apalpador
named-tch-probe-440 = Medição do desvio dos eixos
named-tch-probe-441 = Apalpação rápida
