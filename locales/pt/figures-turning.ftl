# Títulos das figuras dos ciclos de torneamento.

figure-turning-roughing = Desbaste
figure-turning-finishing = Acabamento
figure-turning-inside = Lado interior
figure-turning-system = Sistema de coordenadas
figure-turning-reversed-tool = Ferramenta invertida
figure-turning-smoothing = Alisamento do contorno
figure-turning-start-element = Elemento no início
figure-turning-end-element = Elemento no fim
figure-turning-elements = Chanfre, arredondamento e raio da esquina
figure-turning-angles = Ângulos
figure-turning-limit = Limite de corte
figure-turning-reversal = Direção do contorno
figure-turning-undercut = Afundamento
figure-turning-cutting-lines = Linhas de corte
figure-turned-thread = Rosca
figure-thread-position = Rosca exterior ou interior
figure-thread-orientation = Longitudinal ou transversal
figure-turning-infeed = Passo
figure-turning-infeed-type = Tipo de passo
figure-turning-depth = Profundidade e saída
figure-recess-offset = Largura de deslocação
figure-recess-compensation = Correção da profundidade
figure-recess-direction = Direção de maquinação
figure-text-on-arc = Texto num arco
figure-text-arrangement = Texto em linha reta ou em arco
figure-around-cylinder = Em torno do cilindro
