# Parameters of the machining cycles: name, label in the NC block, help.

# --- heights and depths ---
parameter-set-up-clearance = Distância de segurança
    .label = DISTÂNCIA SEGURANÇA
    .help = Distância entre a ponta da ferramenta e a superfície da peça.
parameter-set-up-clearance__drilling =
    .help = Distância entre a ponta da ferramenta e a superfície da peça. Introduza um valor positivo.
parameter-set-up-clearance__centring =
    .help = Distância entre a ponta da ferramenta e a superfície da peça. Introduza um valor positivo.
parameter-set-up-clearance__circular-pattern =
    .help = Distância entre a ponta da ferramenta e a superfície da peça. Vale também para o ciclo de maquinação que a figura chama.
parameter-set-up-clearance__rectangular-pocket =
    .help = Distância entre a ponta da ferramenta e a superfície da peça. PREDEF assume o valor da frase GLOBAL DEF.
parameter-set-up-clearance__circular-pocket =
    .help = Distância entre a ponta da ferramenta e a superfície da peça. PREDEF assume o valor da frase GLOBAL DEF.
parameter-set-up-clearance__slot =
    .help = Distância entre a ponta da ferramenta e a superfície da peça. PREDEF assume o valor da frase GLOBAL DEF.
parameter-set-up-clearance__circular-slot =
    .help = Distância entre a ponta da ferramenta e a superfície da peça. PREDEF assume o valor da frase GLOBAL DEF.
parameter-set-up-clearance__rectangular-stud =
    .help = Distância entre a ponta da ferramenta e a superfície da peça. PREDEF assume o valor da frase GLOBAL DEF.
parameter-set-up-clearance__circular-stud =
    .help = Distância entre a ponta da ferramenta e a superfície da peça. PREDEF assume o valor da frase GLOBAL DEF.
parameter-second-set-up-clearance = 2ª distância de segurança
    .label = 2ª DISTÂNCIA SEGURANÇA
    .help = Altura no eixo do cabeçote à qual a ferramenta não pode colidir com a peça nem com os dispositivos de fixação.
parameter-second-set-up-clearance__circular-pattern =
    .help = Altura no eixo do cabeçote à qual a ferramenta não pode colidir com a peça nem com os dispositivos de fixação. Vale também para o ciclo de maquinação que a figura chama.
parameter-second-set-up-clearance__rectangular-pocket =
    .help = Altura no eixo do cabeçote à qual a ferramenta não pode colidir com a peça nem com os dispositivos de fixação. PREDEF assume o valor da frase GLOBAL DEF.
parameter-second-set-up-clearance__circular-pocket =
    .help = Altura no eixo do cabeçote à qual a ferramenta não pode colidir com a peça nem com os dispositivos de fixação. PREDEF assume o valor da frase GLOBAL DEF.
parameter-second-set-up-clearance__slot =
    .help = Altura no eixo do cabeçote à qual a ferramenta não pode colidir com a peça nem com os dispositivos de fixação. PREDEF assume o valor da frase GLOBAL DEF.
parameter-second-set-up-clearance__circular-slot =
    .help = Altura no eixo do cabeçote à qual a ferramenta não pode colidir com a peça nem com os dispositivos de fixação. PREDEF assume o valor da frase GLOBAL DEF.
parameter-second-set-up-clearance__rectangular-stud =
    .help = Altura no eixo do cabeçote à qual a ferramenta não pode colidir com a peça nem com os dispositivos de fixação. PREDEF assume o valor da frase GLOBAL DEF.
parameter-second-set-up-clearance__circular-stud =
    .help = Altura no eixo do cabeçote à qual a ferramenta não pode colidir com a peça nem com os dispositivos de fixação. PREDEF assume o valor da frase GLOBAL DEF.
parameter-second-set-up-clearance__face-milling =
    .help = Altura no eixo do cabeçote à qual a ferramenta não pode colidir com a peça nem com os dispositivos de fixação. PREDEF assume o valor da frase GLOBAL DEF.
parameter-surface-coordinate = Coordenada da superfície da peça
    .label = COOR. SUPERFÍCIE
    .help = Coordenada da superfície da peça.
parameter-surface-coordinate__circular-pattern =
    .help = Coordenada da superfície da peça. Vale também para o ciclo de maquinação que a figura chama.
parameter-depth = Profundidade
    .label = PROFUNDIDADE
    .help = Distância entre a superfície da peça e o fundo do furo, medida até à ponta do cone da broca.
parameter-depth__rectangular-pocket =
    .help = Distância entre a superfície da peça e o fundo da caixa.
parameter-plunging-depth = Profundidade de passo
    .label = PROFUNDIDADE DE PASSO
    .help = Profundidade que a ferramenta avança em cada passo. A profundidade não tem de ser um múltiplo da profundidade de passo. A ferramenta avança até à profundidade num só movimento se os dois valores forem iguais ou se a profundidade de passo for maior do que a profundidade.
parameter-plunging-depth__rectangular-pocket =
    .help = Profundidade que a ferramenta avança em cada passo. Introduza um valor maior do que 0.
parameter-decrement = Valor de redução
    .label = VALOR DE REDUÇÃO
    .help = Valor em que a profundidade de passo { $q-plunging-depth } diminui em cada passo.
parameter-least-plunging-depth = Profundidade de passo mínima
    .label = PROFUNDIDADE MÍN. DE PASSO
    .help = Se tiver sido introduzido um valor de redução { $q-decrement }, nenhum passo é menor do que esta profundidade.
parameter-upper-advanced-stop-distance = Distância de paragem prévia em cima
    .label = DIST. PARAGEM PRÉVIA EM CIMA
    .help = Distância acima da profundidade de passo atual até à qual a ferramenta, depois de um recuo, volta ao furo em avanço rápido: valor para o primeiro passo.
parameter-lower-advanced-stop-distance = Distância de paragem prévia em baixo
    .label = DIST. PARAGEM PRÉVIA EM BAIXO
    .help = Distância acima da profundidade de passo atual até à qual a ferramenta, depois de um recuo, volta ao furo em avanço rápido: valor para o último passo.
parameter-depth-for-chip-breaking = Profundidade até à rotura de apara
    .label = PROFUND. ATÉ ROTURA DE APARA
    .help = Passo após o qual se faz a rotura de apara. Com 0 não há rotura de apara.
parameter-chip-breaking-retraction = Recuo na rotura de apara
    .label = RECUO NA ROTURA DE APARA
    .help = Distância que a ferramenta recua para a rotura de apara. A ferramenta recua a 3000 mm/min.
parameter-deepened-starting-point = Ponto de partida aprofundado
    .label = PONTO DE PARTIDA
    .help = Ponto de partida da furação propriamente dita, medido a partir da superfície da peça, quando uma ferramenta mais curta já abriu o furo até certa profundidade. A ferramenta desloca-se para aí, a partir da distância de segurança, com o avanço de posicionamento prévio { $q-pre-positioning-feed }.

# --- feeds and times ---
parameter-plunging-feed = Avanço do passo em profundidade
    .label = AVANÇO PASSO EM PROFUNDID.
    .help = Velocidade de deslocação da ferramenta ao furar.
parameter-plunging-feed__rectangular-pocket =
    .help = Velocidade de deslocação da ferramenta ao descer à profundidade.
parameter-pre-positioning-feed = Avanço de posicionamento prévio
    .label = AVANÇO PRÉ-POSICIONAM.
    .help = Velocidade de deslocação da ferramenta da distância de segurança até ao ponto de partida aprofundado. Só atua se { $q-deepened-starting-point } for diferente de 0.
parameter-milling-feed = Avanço de fresagem
    .label = AVANÇO FRESAGEM
    .help = Velocidade de deslocação da ferramenta ao fresar.
parameter-finishing-feed = Avanço de acabamento
    .label = AVANÇO ACABAMENTO
    .help = Velocidade de deslocação da ferramenta no acabamento lateral e do fundo.
parameter-dwell-at-top = Tempo de espera em cima
    .label = TEMPO DE ESPERA EM CIMA
    .help = Tempo que a ferramenta permanece à distância de segurança depois de ter sido retirada do furo para arrefecer.
parameter-dwell-at-bottom = Tempo de espera em baixo
    .label = TEMPO DE ESPERA EM BAIXO
    .help = Tempo que a ferramenta permanece no fundo do furo.

# --- milling of pockets ---
parameter-machining-operation = Tipo de maquinação
    .label = TIPO DE MAQUINAÇÃO
    .help = Determina o que é maquinado. O acabamento lateral e o do fundo só se fazem se estiver definida a respetiva medida excedente ({ $q-side-allowance }, { $q-floor-allowance }).
parameter-first-side-length = Longitude lado 1
    .label = LONGITUDE LADO 1
    .help = Longitude da caixa paralela ao eixo principal do plano de maquinação.
parameter-second-side-length = Longitude lado 2
    .label = LONGITUDE LADO 2
    .help = Longitude da caixa paralela ao eixo secundário do plano de maquinação.
parameter-corner-radius = Raio da esquina
    .label = RAIO DA ESQUINA
    .help = Raio das esquinas da caixa. Com 0, o comando assume o raio da ferramenta como raio da esquina.
parameter-side-allowance = Medida excedente lateral
    .label = MEDIDA EXCEDENTE LATERAL
    .help = Medida excedente de acabamento no plano de maquinação.
parameter-floor-allowance = Medida excedente do fundo
    .label = MEDIDA EXCEDENTE FUNDO
    .help = Medida excedente de acabamento em profundidade.
parameter-angle-of-rotation = Ângulo de rotação
    .label = ÂNGULO DE ROTAÇÃO
    .help = Ângulo em que é rodada toda a maquinação. O centro de rotação é a posição da ferramenta na chamada do ciclo.
parameter-pocket-position = Posição da caixa
    .label = POSIÇÃO DA CAIXA
    .help = Posição da caixa em relação à posição da ferramenta na chamada do ciclo.
parameter-milling-type = Tipo de fresagem
    .label = TIPO DE FRESAGEM
    .help = Tipo de fresagem com o cabeçote a rodar em sentido horário (M3). PREDEF assume o valor da frase GLOBAL DEF.
parameter-finishing-infeed = Passo de acabamento
    .label = PASSO DE ACABAMENTO
    .help = Distância que a ferramenta avança no eixo do cabeçote em cada passagem de acabamento. Com 0, o acabamento faz-se num só passo.
parameter-path-overlap = Fator de sobreposição de trajetórias
    .label = SOBREPOSIÇÃO TRAJETÓRIAS
    .help = Este fator multiplicado pelo raio da ferramenta dá o passo lateral k. PREDEF assume o valor da frase GLOBAL DEF.
parameter-plunging-strategy = Estratégia de penetração
    .label = PENETRAÇÃO
    .help = Determina como a ferramenta entra no material. PREDEF assume o valor da frase GLOBAL DEF.

# --- patterns ---
parameter-pitch-circle-centre-main = Centro 1.º eixo
    .label = CENTRO 1º EIXO
    .label-aliases = CENTRO 1.º EIXO | CENTRO 1° EIXO
    .help = Centro do círculo teórico no eixo principal do plano de maquinação.
parameter-pitch-circle-centre-minor = Centro 2.º eixo
    .label = CENTRO 2º EIXO
    .label-aliases = CENTRO 2.º EIXO | CENTRO 2° EIXO
    .help = Centro do círculo teórico no eixo secundário do plano de maquinação.
parameter-pitch-circle-diameter = Diâmetro do círculo teórico
    .label = DIÂMETRO CÍRCULO TEÓRICO
    .help = Diâmetro do círculo teórico.
parameter-pattern-starting-angle = Ângulo inicial
    .label = ÂNGULO INICIAL
    .help = Ângulo entre o eixo principal do plano de maquinação e o ponto de partida da primeira maquinação no círculo teórico.
parameter-pattern-stopping-angle = Ângulo final
    .label = ÂNGULO FINAL
    .help = Ângulo entre o eixo principal do plano de maquinação e o ponto de partida da última maquinação no círculo teórico; não vale para círculos completos. Tem de ser diferente do ângulo inicial { $q-pattern-starting-angle }. Se for maior do que o ângulo inicial, a maquinação faz-se em sentido anti-horário; caso contrário, em sentido horário.
parameter-pattern-stepping-angle = Passo angular
    .label = PASSO ANGULAR
    .help = Ângulo entre duas maquinações no círculo teórico. Com 0, o comando calcula-o a partir do ângulo inicial, do ângulo final e do número de maquinações. Se tiver sido introduzido, o ângulo final { $q-pattern-stopping-angle } não é tido em conta. O sinal determina a direção (− = sentido horário).
parameter-number-of-operations = Número de maquinações
    .label = NÚMERO DE MAQUINAÇÕES
    .help = Número de maquinações no círculo teórico.
parameter-pattern-clearance-mode = Deslocação à altura de segurança
    .label = DESLOCAÇÃO À ALTURA SEG.
    .label-aliases = DESLOCAR À ALTURA SEG
    .help = Altura à qual a ferramenta se desloca entre as maquinações.
parameter-pattern-traverse-type = Tipo de deslocação
    .label = TIPO DE DESLOCAÇÃO
    .help = Tipo de trajetória com que a ferramenta se desloca entre as maquinações.
    .prompt = Tipo de deslocação? Reta=0/círculo=1

# --- coordinate transforms ---
parameter-datum-shift = Deslocação
    .help = Coordenadas do novo ponto zero. Os valores absolutos referem-se ao ponto zero da peça determinado pela memorização do ponto de referência; os valores incrementais referem-se sempre ao último ponto zero válido, que pode já estar deslocado. Até 6 eixos NC.
parameter-datum-row = Deslocação
    .help = Número do ponto zero na tabela de pontos zero, ou um parâmetro Q. Com um parâmetro Q, o comando ativa o ponto zero cujo número está no parâmetro.
parameter-rotation-angle = Rotação
    .help = Ângulo de rotação em graus, absoluto ou incremental.
parameter-preset-number = Número do ponto de referência
    .label = NÚMERO PONTO DE REF.
    .help = Número do ponto de referência da tabela de presets que se pretende ativar.
    .prompt = Número do ponto de referência?

# --- choices ---
choice-roughing-and-finishing = Desbaste e acabamento
choice-roughing-only = Só desbaste
choice-finishing-only = Acabamento lateral e do fundo
choice-tool-at-pocket-centre = Posição da ferramenta = centro da caixa
choice-tool-at-lower-left-corner = Posição da ferramenta = esquina inferior esquerda
choice-tool-at-lower-right-corner = Posição da ferramenta = esquina inferior direita
choice-tool-at-upper-right-corner = Posição da ferramenta = esquina superior direita
choice-tool-at-upper-left-corner = Posição da ferramenta = esquina superior esquerda
choice-climb-milling = Fresagem em sentido sincronizado
choice-up-cut-milling = Fresagem em sentido contrário
choice-vertical-plunging = Penetração vertical, qualquer que seja o ângulo de penetração { $mp-plunging-angle } na tabela de ferramentas
choice-helical-plunging = Penetração em hélice. O ângulo de penetração { $mp-plunging-angle } da ferramenta ativa tem de ser diferente de 0 na tabela de ferramentas; caso contrário, o comando emite um aviso de erro
choice-reciprocating-plunging = Penetração pendular. O ângulo de penetração { $mp-plunging-angle } da ferramenta ativa tem de ser diferente de 0 na tabela de ferramentas; caso contrário, o comando emite um aviso de erro. A longitude do movimento pendular depende do ângulo de penetração; é, no mínimo, o dobro do diâmetro da ferramenta
choice-at-set-up-clearance = Deslocar-se entre as maquinações à distância de segurança
choice-at-second-set-up-clearance = Deslocar-se entre as maquinações à 2ª distância de segurança
choice-straight-between-operations = Deslocar-se entre as maquinações em linha reta
choice-on-the-pitch-circle = Deslocar-se entre as maquinações sobre o círculo teórico
