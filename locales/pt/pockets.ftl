# Pockets.
cycle-rectangular-pocket = Caixa retangular
    .nc = CAIXA RETANGULAR
    .nc-aliases = CAIXA RECTANGULAR
    .purpose = Maquina por completo uma caixa retangular: desbaste, acabamento do fundo e acabamento lateral. Também é possível fazer só o desbaste, só o acabamento do fundo e lateral, só o acabamento do fundo ou só o acabamento lateral.
step-move-over-pocket-centre = O comando posiciona a ferramenta no eixo da ferramenta à 2ª distância de segurança { $q-second-set-up-clearance } (ou à distância de segurança, se aquela não tiver sido introduzida), depois sobre o centro da caixa e a seguir à distância de segurança { $q-set-up-clearance }, sempre em avanço rápido.
group-roughing = Desbaste
step-plunge-at-centre = A ferramenta penetra na peça no centro da caixa até à profundidade de passo seguinte { $q-plunging-depth }. O parâmetro { $q-plunging-strategy } determina como:
say-plunge-vertically = { $q-plunging-strategy } = 0: na vertical, com o avanço { $q-plunging-feed }
say-plunge-helically = { $q-plunging-strategy } = 1: em hélice, com o avanço { $q-plunging-feed }
say-plunge-reciprocating = { $q-plunging-strategy } = 2: em movimento pendular, com o avanço { $q-plunging-feed }
step-clear-level = O comando desbasta a caixa de dentro para fora, tendo em conta a sobreposição de trajetórias { $q-path-overlap } e as medidas excedentes de acabamento { $q-side-allowance } e { $q-floor-allowance }. No fim, a ferramenta afasta-se tangencialmente da parede da caixa.
step-leave-wall-and-return = A ferramenta desloca-se para a distância de segurança acima da profundidade de passo atual e regressa daí em avanço rápido ao centro da caixa.
until-roughing-depth-reached = seja atingida a profundidade { $q-depth }, descontada a medida excedente do fundo { $q-floor-allowance }
group-finishing = Acabamento
step-rapid-to-first-plunging-depth = Se só estiver programado o acabamento ({ $q-machining-operation } = 2), o comando desloca a ferramenta no centro da caixa, em avanço rápido, até à primeira profundidade de passo.
step-finish-side = Se estiver definida uma medida excedente { $q-side-allowance }, o comando faz primeiro o acabamento lateral da caixa, com aproximação tangencial; se { $q-finishing-infeed } tiver sido introduzido, em vários passos.
until-side-finished = o acabamento lateral chegue à profundidade { $q-depth }
step-finish-floor = Se estiver definida uma medida excedente { $q-floor-allowance }, o comando faz depois o acabamento do fundo da caixa de dentro para fora, com aproximação tangencial.
step-leave-pocket = A ferramenta sai da caixa em avanço rápido:
step-return-to-starting-point = O comando faz regressar a ferramenta ao ponto de partida no plano de maquinação.
guard-plunging-depth-zero = A profundidade de passo tem de ser maior do que 0.
guard-tool-wider-than-pocket = A ferramenta não cabe na caixa: descontadas as medidas excedentes laterais, a caixa é mais estreita do que a ferramenta.
guard-plunging-angle-missing = A penetração em hélice e a penetração pendular precisam de um ângulo de penetração { $mp-plunging-angle } diferente de 0 na tabela de ferramentas.
guard-helix-too-small = O diâmetro da hélice de penetração é menor do que o dobro do diâmetro da ferramenta. O parâmetro de máquina { $mp-suppress-plunge-err } desliga esta verificação para ferramentas que cortam ao centro.
note-without-tool-table-plunge-vertically = Se não estiver ativa nenhuma tabela de ferramentas, a penetração tem de ser sempre vertical ({ $q-plunging-strategy } = 0), porque não é possível definir um ângulo de penetração.
note-position-at-pocket-start = Posicione a ferramenta no ponto de partida no plano de maquinação com correção de raio R0. Tenha em conta a posição da caixa { $q-pocket-position }.
note-positions-in-tool-axis-itself = O comando posiciona automaticamente a ferramenta no eixo da ferramenta. Tenha em conta a 2ª distância de segurança { $q-second-set-up-clearance }.
note-returns-to-starting-point = No fim do ciclo, o comando faz regressar a ferramenta, no plano de maquinação, ao ponto de partida.
note-clearance-above-chips = Depois de desbastar cada nível, a ferramenta regressa em avanço rápido ao centro da caixa, à distância de segurança acima da profundidade de passo atual. Escolha a distância de segurança de modo que a ferramenta não possa ficar presa em aparas durante a deslocação.
note-helix-diameter-monitored = Na penetração em hélice, o comando emite um aviso de erro se o diâmetro da hélice que calculou for menor do que o dobro do diâmetro da ferramenta. Para ferramentas que cortam ao centro, esta verificação pode ser desligada com o parâmetro de máquina { $mp-suppress-plunge-err }.
note-cutting-edge-limits-infeed = Se a navalha for mais curta do que a profundidade de passo { $q-plunging-depth }, o comando reduz a profundidade de passo à longitude { $mp-cutting-edge-length } da tabela de ferramentas.
note-finishing-only-starts-at-first-depth = Perigo de colisão! Se o ciclo for chamado com o tipo de maquinação 2 (só acabamento), o comando desloca a ferramenta no centro da caixa, em avanço rápido, até à primeira profundidade de passo.
note-point-table-starting-points = Se o ciclo for chamado com uma tabela de pontos, os pontos do plano de maquinação são os pontos de partida do ciclo. Para utilizar a coordenada do eixo da ferramenta da tabela como coordenada do ponto de partida, introduza 0 como coordenada da superfície da peça { $q-surface-coordinate }.
note-point-table-shifts-datum = Se o ciclo for chamado com uma tabela de pontos, o comando interpreta cada ponto como uma deslocação adicional do ponto zero.
