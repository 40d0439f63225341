# Point patterns.
cycle-circular-pattern = Figura de pontos sobre círculo
    .nc = FIGURA CÍRCULO
    .purpose = Executa o ciclo de maquinação definido em último lugar em pontos situados sobre um círculo ou um arco de círculo.
step-move-to-first-operation = O comando desloca a ferramenta em avanço rápido da posição atual para o ponto de partida da primeira maquinação: para a 2ª distância de segurança { $q-second-set-up-clearance } (eixo do cabeçote), para o ponto de partida no plano de maquinação e para a distância de segurança { $q-set-up-clearance } acima da superfície da peça (eixo do cabeçote).
step-call-last-machining-cycle = A partir dessa posição, o comando executa o ciclo de maquinação definido em último lugar.
step-height-between-operations = Entre as maquinações, a ferramenta desloca-se no eixo do cabeçote:
say-to-second-set-up-clearance = { $q-pattern-clearance-mode } = 1: para a 2ª distância de segurança { $q-second-set-up-clearance }
say-to-set-up-clearance = { $q-pattern-clearance-mode } = 0: para a distância de segurança { $q-set-up-clearance }
step-move-to-next-operation = O comando desloca depois a ferramenta para o ponto de partida da maquinação seguinte e, aí, para a distância de segurança { $q-set-up-clearance }:
say-on-the-pitch-circle = { $q-pattern-traverse-type } = 1: sobre o círculo teórico
say-in-a-straight-line = { $q-pattern-traverse-type } = 0: em linha reta
until-all-operations-done = estejam executadas todas as { $q-number-of-operations } maquinações
condition-stepping-angle-computed = não tiver sido introduzido nenhum passo angular { $q-pattern-stepping-angle }
guard-pattern-angles-equal = O ângulo inicial e o ângulo final são iguais. Introduza ângulos diferentes ou um passo angular.
note-pattern-is-def-active = O ciclo atua a partir da sua definição: chama automaticamente o ciclo de maquinação definido em último lugar.
note-pattern-overrides-heights = Se um dos ciclos de maquinação 200 a 209 e 251 a 267 for combinado com este ciclo, são válidas a distância de segurança { $q-set-up-clearance }, a coordenada da superfície da peça { $q-surface-coordinate } e a 2ª distância de segurança { $q-second-set-up-clearance } deste ciclo.
note-pattern-combinations = O ciclo pode ser combinado com os ciclos de maquinação 200 a 209, 240, 251 a 253, 256, 257, 262 a 265 e 267. O ciclo 254 (ranhura circular) só pode ser combinado com o ciclo 221.
note-pattern-alternatives = Para figuras de pontos irregulares, utilize tabelas de pontos com CYCL CALL PAT. A função PATTERN DEF oferece outras figuras de pontos regulares.
note-def-active-before-call-active = Os ciclos que atuam a partir da definição devem ser programados antes dos ciclos que são chamados. Entre a definição e a chamada de um ciclo, só programe um ciclo que atue a partir da definição se os dois não tiverem em comum parâmetros que devam conservar valores diferentes.
