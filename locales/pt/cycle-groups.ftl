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
