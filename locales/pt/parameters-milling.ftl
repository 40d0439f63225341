# Parameters of pockets, slots, studs, line patterns and multipass milling: name, label in the NC block, help.

# --- pockets, slots and studs ---
parameter-circle-diameter = Diâmetro do círculo
    .label = DIÂMETRO DO CÍRCULO
    .help = Diâmetro da caixa acabada.
parameter-slot-length = Longitude da ranhura
    .label = LONGITUDE DA RANHURA
    .help = Lado maior da ranhura, paralelo ao eixo principal do plano de maquinação.
parameter-milled-slot-width = Largura da ranhura
    .label = LARGURA DA RANHURA
    .help = Largura da ranhura, paralela ao eixo secundário do plano de maquinação. Se for igual ao diâmetro da ferramenta, o comando faz só o desbaste (fresa um furo oblongo). Maior largura da ranhura no desbaste: o dobro do diâmetro da ferramenta.
parameter-angle-of-rotation__slot =
    .help = Ângulo em que é rodada toda a ranhura. O centro de rotação é a posição da ferramenta na chamada do ciclo.
parameter-angle-of-rotation__line-pattern =
    .help = Ângulo em que é rodada toda a figura. O centro de rotação é o ponto de partida. Vale também para o ciclo de maquinação que a figura chama.
parameter-slot-position = Posição da ranhura
    .label = POSIÇÃO DA RANHURA
    .help = Posição da ranhura em relação à posição da ferramenta na chamada do ciclo.
parameter-slot-position-reference = Referência da posição da ranhura
    .label = REF. POSIÇÃO DA RANHURA
    .help = Posição da ranhura em relação à posição da ferramenta na chamada do ciclo.
parameter-slot-starting-angle = Ângulo inicial
    .label = ÂNGULO INICIAL
    .help = Ângulo polar do ponto de partida.
parameter-slot-opening-angle = Ângulo de abertura da ranhura
    .label = ÂNGULO DE ABERTURA
    .help = Ângulo que a ranhura abrange.
parameter-pattern-stepping-angle__circular-slot =
    .help = Ângulo em que é rodada toda a ranhura em cada maquinação seguinte. O centro de rotação é o centro do círculo teórico.
parameter-stud-first-side-length = Longitude lado 1
    .label = LONGITUDE LADO 1
    .help = Longitude da ilha paralela ao eixo principal do plano de maquinação.
parameter-blank-first-side-length = Longitude lado 1 do bloco
    .label = LADO 1 DO BLOCO
    .help = Longitude do bloco da ilha paralela ao eixo principal do plano de maquinação. Introduza um valor maior do que a longitude lado 1 { $q-stud-first-side-length }. Se a diferença entre as duas for superior ao passo lateral permitido (raio da ferramenta vezes sobreposição de trajetórias { $q-path-overlap }), o comando executa vários passos laterais. Calcula sempre um passo lateral constante.
parameter-stud-second-side-length = Longitude lado 2
    .label = LONGITUDE LADO 2
    .help = Longitude da ilha paralela ao eixo secundário do plano de maquinação.
parameter-blank-second-side-length = Longitude lado 2 do bloco
    .label = LADO 2 DO BLOCO
    .help = Longitude do bloco da ilha paralela ao eixo secundário do plano de maquinação. Introduza um valor maior do que a longitude lado 2 { $q-stud-second-side-length }. Se a diferença entre as duas for superior ao passo lateral permitido (raio da ferramenta vezes sobreposição de trajetórias { $q-path-overlap }), o comando executa vários passos laterais. Calcula sempre um passo lateral constante.
parameter-corner-radius__rectangular-stud =
    .help = Raio das esquinas da ilha.
parameter-side-allowance__rectangular-stud =
    .help = Medida excedente de acabamento que o comando deixa no plano de maquinação.
parameter-stud-position = Posição da ilha
    .label = POSIÇÃO DA ILHA
    .help = Posição da ilha em relação à posição da ferramenta na chamada do ciclo.
parameter-stud-approach-position = Posição de aproximação
    .label = POSIÇÃO DE APROXIMAÇÃO
    .help = Determina onde a ferramenta se aproxima da ilha.
parameter-finished-part-diameter = Diâmetro da peça acabada
    .label = DIÂMETRO PEÇA ACABADA
    .help = Diâmetro da ilha acabada.
parameter-blank-diameter = Diâmetro do bloco
    .label = DIÂMETRO DO BLOCO
    .help = Diâmetro do bloco. Tem de ser maior do que o diâmetro da peça acabada { $q-finished-part-diameter }. Se a diferença entre os dois for superior ao passo lateral permitido (raio da ferramenta vezes sobreposição de trajetórias { $q-path-overlap }), o comando executa vários passos laterais. Calcula sempre um passo lateral constante.
parameter-stud-starting-angle = Ângulo inicial
    .label = ÂNGULO INICIAL
    .help = Ângulo polar, em relação ao centro da ilha, do ponto em que a ferramenta se aproxima dela.
parameter-depth__slot =
    .help = Distância entre a superfície da peça e o fundo da ranhura.
parameter-depth__circular-slot =
    .help = Distância entre a superfície da peça e o fundo da ranhura.
parameter-depth__circular-pocket =
    .help = Distância entre a superfície da peça e o fundo da caixa.
parameter-depth__rectangular-stud =
    .help = Distância entre a superfície da peça e a base da ilha.
parameter-depth__circular-stud =
    .help = Distância entre a superfície da peça e a base da ilha.
parameter-plunging-depth__circular-pocket =
    .help = Profundidade que a ferramenta avança em cada passo. Introduza um valor maior do que 0.
parameter-plunging-depth__slot =
    .help = Profundidade que a ferramenta avança em cada passo. Introduza um valor maior do que 0.
parameter-plunging-depth__circular-slot =
    .help = Profundidade que a ferramenta avança em cada passo. Introduza um valor maior do que 0.
parameter-plunging-depth__rectangular-stud =
    .help = Profundidade que a ferramenta avança em cada passo. Introduza um valor maior do que 0.
parameter-plunging-depth__circular-stud =
    .help = Profundidade que a ferramenta avança em cada passo. Introduza um valor maior do que 0.
parameter-plunging-feed__circular-pocket =
    .help = Velocidade de deslocação da ferramenta ao descer à profundidade.
parameter-plunging-feed__slot =
    .help = Velocidade de deslocação da ferramenta ao descer à profundidade.
parameter-plunging-feed__circular-slot =
    .help = Velocidade de deslocação da ferramenta ao descer à profundidade.
parameter-plunging-feed__rectangular-stud =
    .help = Velocidade de deslocação da ferramenta ao descer à profundidade.
parameter-plunging-feed__circular-stud =
    .help = Velocidade de deslocação da ferramenta ao descer à profundidade.
parameter-plunging-feed__multipass-milling =
    .help = Velocidade de deslocação da ferramenta ao descer à profundidade.

# --- line patterns ---
parameter-pattern-spacing-main = Distância 1.º eixo
    .label = DISTÂNCIA 1.º EIXO
    .help = Distância entre os pontos de uma linha.
parameter-pattern-spacing-minor = Distância 2.º eixo
    .label = DISTÂNCIA 2.º EIXO
    .help = Distância entre as linhas.
parameter-number-of-columns = Número de colunas
    .label = NÚMERO DE COLUNAS
    .help = Número de maquinações numa linha.
parameter-number-of-lines = Número de linhas
    .label = NÚMERO DE LINHAS
    .help = Número de linhas.
parameter-starting-point-main__line-pattern =
    .help = Coordenada do ponto de partida no eixo principal do plano de maquinação.
parameter-starting-point-minor__line-pattern =
    .help = Coordenada do ponto de partida no eixo secundário do plano de maquinação.
parameter-set-up-clearance__line-pattern =
    .help = Distância entre a ponta da ferramenta e a superfície da peça. Vale também para o ciclo de maquinação que a figura chama.
parameter-surface-coordinate__line-pattern =
    .help = Coordenada da superfície da peça. Vale também para o ciclo de maquinação que a figura chama.
parameter-second-set-up-clearance__line-pattern =
    .help = Altura no eixo do cabeçote à qual a ferramenta não pode colidir com a peça nem com os dispositivos de fixação. Vale também para o ciclo de maquinação que a figura chama.

# --- multipass milling of surfaces ---
parameter-starting-point-main = Ponto de partida 1.º eixo
    .label = PONTO DE PARTIDA 1.º EIXO
    .help = Coordenada do ponto de partida da superfície a maquinar, no eixo principal do plano de maquinação.
parameter-starting-point-minor = Ponto de partida 2.º eixo
    .label = PONTO DE PARTIDA 2.º EIXO
    .help = Coordenada do ponto de partida da superfície a maquinar, no eixo secundário do plano de maquinação.
parameter-starting-point-tool = Ponto de partida 3.º eixo
    .label = PONTO DE PARTIDA 3.º EIXO
    .help = Altura no eixo do cabeçote à qual a superfície é fresada.
parameter-starting-point-tool__ruled-surface =
    .help = Coordenada do ponto de partida da superfície a fresar, no eixo do cabeçote.
parameter-starting-point-tool__face-milling =
    .help = Coordenada da superfície da peça a partir da qual são calculados os passos.
parameter-first-side-length__multipass-milling =
    .help = Longitude da superfície a fresar no eixo principal do plano de maquinação, a partir do ponto de partida do 1.º eixo.
parameter-first-side-length__face-milling =
    .help = Longitude da superfície a maquinar no eixo principal do plano de maquinação. O sinal determina a direção da primeira trajetória de fresagem em relação ao ponto de partida do 1.º eixo.
parameter-second-side-length__multipass-milling =
    .help = Longitude da superfície a fresar no eixo secundário do plano de maquinação, a partir do ponto de partida do 2.º eixo.
parameter-second-side-length__face-milling =
    .help = Longitude da superfície a maquinar no eixo secundário do plano de maquinação. O sinal determina a direção do primeiro passo lateral em relação ao ponto de partida do 2.º eixo.
parameter-number-of-cuts = Número de cortes
    .label = NÚMERO DE CORTES
    .help = Número de linhas em que o comando desloca a ferramenta na largura.
parameter-number-of-cuts__ruled-surface =
    .help = Número de linhas que o comando maquina entre os pontos 1 e 4 ou entre os pontos 2 e 3.
parameter-stepover-feed = Avanço lateral
    .label = AVANÇO LATERAL
    .help = Velocidade de deslocação da ferramenta para a linha seguinte. Num passo lateral dentro do material, introduza um valor menor do que { $q-milling-feed }; num passo lateral acima da peça, { $q-stepover-feed } pode ser maior do que { $q-milling-feed }.
parameter-set-up-clearance__multipass-milling =
    .help = Distância entre a ponta da ferramenta e a profundidade de fresagem para o posicionamento no início e no fim do ciclo.
parameter-set-up-clearance__face-milling =
    .help = Distância entre a ponta da ferramenta e a posição de partida no eixo da ferramenta. Com a estratégia { $q-face-milling-strategy } = 2, é a esta distância acima da profundidade de passo atual que a ferramenta se desloca para o ponto de partida da linha seguinte.
parameter-surface-second-point-main = 2.º ponto 1.º eixo
    .label = 2.º PONTO 1.º EIXO
    .help = Coordenada do ponto final da superfície a fresar, no eixo principal do plano de maquinação.
parameter-surface-second-point-minor = 2.º ponto 2.º eixo
    .label = 2.º PONTO 2.º EIXO
    .help = Coordenada do ponto final da superfície a fresar, no eixo secundário do plano de maquinação.
parameter-surface-second-point-tool = 2.º ponto 3.º eixo
    .label = 2.º PONTO 3.º EIXO
    .help = Coordenada do ponto final da superfície a fresar, no eixo do cabeçote.
parameter-surface-third-point-main = 3.º ponto 1.º eixo
    .label = 3.º PONTO 1.º EIXO
    .help = Coordenada do ponto 3 no eixo principal do plano de maquinação.
parameter-surface-third-point-minor = 3.º ponto 2.º eixo
    .label = 3.º PONTO 2.º EIXO
    .help = Coordenada do ponto 3 no eixo secundário do plano de maquinação.
parameter-surface-third-point-tool = 3.º ponto 3.º eixo
    .label = 3.º PONTO 3.º EIXO
    .help = Coordenada do ponto 3 no eixo do cabeçote.
parameter-surface-fourth-point-main = 4.º ponto 1.º eixo
    .label = 4.º PONTO 1.º EIXO
    .help = Coordenada do ponto 4 no eixo principal do plano de maquinação.
parameter-surface-fourth-point-minor = 4.º ponto 2.º eixo
    .label = 4.º PONTO 2.º EIXO
    .help = Coordenada do ponto 4 no eixo secundário do plano de maquinação.
parameter-surface-fourth-point-tool = 4.º ponto 3.º eixo
    .label = 4.º PONTO 3.º EIXO
    .help = Coordenada do ponto 4 no eixo do cabeçote.
parameter-milling-feed__ruled-surface =
    .help = Velocidade de deslocação da ferramenta ao fresar. O comando executa o primeiro corte com metade do valor programado.
parameter-face-milling-strategy = Estratégia de maquinação
    .label = ESTRATÉGIA
    .help = Determina como o comando maquina a superfície.
parameter-end-point-tool = Ponto final 3.º eixo
    .label = PONTO FINAL 3.º EIXO
    .help = Coordenada no eixo do cabeçote até à qual a superfície é fresada.
parameter-max-plunging-depth = Profundidade de passo máxima
    .label = PROFUNDIDADE MÁX. DE PASSO
    .help = Maior profundidade que a ferramenta avança num passo. O comando calcula a profundidade de passo real a partir da diferença entre o ponto final e o ponto de partida no eixo da ferramenta, de modo que todos os passos sejam iguais; tem em conta a medida excedente de acabamento { $q-floor-allowance }.
parameter-floor-allowance__face-milling =
    .help = Profundidade do último passo.
parameter-max-path-overlap = Fator máximo de sobreposição de trajetórias
    .label = SOBREPOSIÇÃO MÁXIMA
    .help = Fator para o maior passo lateral k. O comando calcula o passo lateral real a partir da longitude lado 2 { $q-second-side-length } e do raio da ferramenta, de modo que todos os passos laterais sejam iguais. Se na tabela de ferramentas tiver sido introduzido um raio { $mp-tool-radius-2 } (como o raio das pastilhas de uma fresa de facejar), o comando reduz o passo lateral em conformidade.
parameter-finishing-feed__face-milling =
    .help = Velocidade de deslocação da ferramenta ao fresar o último passo.
parameter-pre-positioning-feed__face-milling =
    .help = Velocidade de deslocação da ferramenta para a posição de partida e para a linha seguinte. Se o passo lateral se fizer dentro do material ({ $q-face-milling-strategy } = 1), o comando executa-o com o avanço de fresagem { $q-milling-feed }.
parameter-side-clearance = Distância lateral
    .label = DISTÂNCIA LATERAL
    .help = Distância entre a ferramenta e o lado da peça quando a ferramenta se desloca para a primeira profundidade de passo, e distância à qual se fazem os passos laterais com as estratégias { $q-face-milling-strategy } = 0 e { $q-face-milling-strategy } = 2.

# --- choices ---
choice-vertical-plunging-with-angle-0-or-90 = Penetração vertical. O ângulo de penetração { $mp-plunging-angle } da ferramenta ativa tem de ser 0 ou 90 na tabela de ferramentas; caso contrário, o comando emite um aviso de erro
choice-reciprocating-plunging-by-angle = Penetração pendular. O ângulo de penetração { $mp-plunging-angle } da ferramenta ativa tem de ser diferente de 0 na tabela de ferramentas; caso contrário, o comando emite um aviso de erro
choice-tool-at-slot-centre = Posição da ferramenta = centro da ranhura
choice-tool-at-left-slot-end = Posição da ferramenta = extremidade esquerda da ranhura
choice-tool-at-left-slot-arc-centre = Posição da ferramenta = centro do arco esquerdo da ranhura
choice-tool-at-right-slot-arc-centre = Posição da ferramenta = centro do arco direito da ranhura
choice-tool-at-right-slot-end = Posição da ferramenta = extremidade direita da ranhura
choice-tool-position-not-considered = A posição da ferramenta não é tida em conta. A posição da ranhura resulta do centro do círculo teórico introduzido e do ângulo inicial
choice-slot-begins-at-tool = Posição da ferramenta = centro do arco esquerdo da ranhura. O ângulo inicial { $q-slot-starting-angle } refere-se a esta posição. O centro do círculo teórico introduzido não é tido em conta
choice-slot-middle-at-tool = Posição da ferramenta = centro do eixo médio. O ângulo inicial { $q-slot-starting-angle } refere-se a esta posição. O centro do círculo teórico introduzido não é tido em conta
choice-slot-ends-at-tool = Posição da ferramenta = centro do arco direito da ranhura. O ângulo inicial { $q-slot-starting-angle } refere-se a esta posição. O centro do círculo teórico introduzido não é tido em conta
choice-tool-at-stud-centre = Posição da ferramenta = centro da ilha
choice-approach-right-of-stud = À direita da ilha (ajuste prévio)
choice-approach-at-lower-left-corner = Esquina inferior esquerda
choice-approach-at-lower-right-corner = Esquina inferior direita
choice-approach-at-upper-right-corner = Esquina superior direita
choice-approach-at-upper-left-corner = Esquina superior esquerda
choice-meander-stepover-outside = Trajetórias em meandro, passo lateral fora da superfície a maquinar
choice-meander-stepover-inside = Trajetórias em meandro, passo lateral dentro da superfície a maquinar
choice-line-by-line-with-retraction = Linha a linha, com recuo e passo lateral com o avanço de posicionamento

# --- coordinate transforms ---
parameter-mirrored-axes = Eixos espelhados
    .help = Eixos a espelhar. Podem ser espelhados todos os eixos, incluindo os eixos rotativos, exceto o eixo do cabeçote e o eixo secundário paralelo a ele. Até três dos eixos NC X, Y, Z, U, V, W, A, B, C.
    .prompt = Eixo espelhado?
parameter-scaling-factor = Fator
    .word = SCL
    .help = Fator de escala SCL. O comando multiplica por ele as coordenadas e os raios.
    .prompt = Fator?
parameter-axis-scaling-factors = Eixo e fator
    .help = Eixos de coordenadas e fatores de dilatação ou contração de cada um deles.
parameter-axis-scaling-centre = Coordenadas do centro
    .help = Centro a partir do qual o contorno é dilatado ou para o qual é contraído.
parameter-tilting-angles = Eixo e ângulo de rotação
    .help = Eixos rotativos com os seus ângulos de inclinação; os eixos rotativos A, B e C programam-se com softkeys.
    .prompt = Eixo e ângulo de rotação?
parameter-tilting-feed = Avanço
    .help = Velocidade de deslocação do eixo rotativo quando é o próprio comando a posicioná-lo.
    .prompt = Avanço? F=
parameter-tilting-clearance = Distância de segurança
    .help = O comando posiciona a cabeça basculante de modo que a posição na extremidade da ferramenta, prolongada pela distância de segurança, não se altere em relação à peça. Introduz-se quando é o próprio comando a posicionar os eixos rotativos.
    .prompt = Distância de segurança?

# --- special functions ---
parameter-programmed-dwell = Tempo de espera em segundos
    .word = ESPERA
    .help = Tempo durante o qual a execução do programa fica parada, até 1 hora em incrementos de 0,001 s.
parameter-program-to-call = Nome do programa
    .word = PGM
    .help = Nome do programa a chamar, se necessário com o caminho.
parameter-orientation-angle = Ângulo de orientação
    .word = ÂNGULO
    .help = Ângulo em relação ao eixo de referência angular do plano de maquinação.
parameter-contour-tolerance = Valor de tolerância T
    .help = Desvio permitido em relação ao contorno programado, em milímetros (em polegadas nos programas em polegadas).
parameter-hsc-mode = Modo HSC, acabamento=0, desbaste=1
    .help = Filtro que o comando ativa.
parameter-rotary-axis-tolerance = Tolerância para eixos rotativos TA
    .help = Desvio permitido dos eixos rotativos em graus com M128 (FUNCTION TCPM) ativa. O comando reduz sempre o avanço de modo que, em movimentos de vários eixos, o mais lento se desloque com o seu maior avanço. Em geral, os eixos rotativos são muito mais lentos do que os lineares. Uma tolerância maior (como 10°) pode encurtar consideravelmente o tempo de maquinação de programas de vários eixos, porque o comando não tem de levar sempre os eixos rotativos à posição nominal indicada. O contorno não é danificado; só se altera a posição do eixo rotativo em relação à superfície da peça.

# --- choices of the special functions ---
choice-milling-with-higher-accuracy = Fresar com maior exatidão do contorno. O comando utiliza ajustes de filtro internos para o acabamento
choice-milling-at-higher-feed = Fresar com maior avanço. O comando utiliza ajustes de filtro internos para o desbaste
