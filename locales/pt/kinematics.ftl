# Cycles that measure the kinematics of the machine.

# --- parameters ---
parameter-kinematics-mode = Modo (0=verificar/1=medir)
    .label = MODO
    .help = Determina se o comando verifica ou otimiza a cinemática ativa.
parameter-kinematics-mode__itnc530 = Modo (0/1/2)
choice-kinematics-check = verificar a cinemática da máquina ativa: o comando mede os eixos rotativos definidos, mas não altera nada; mostra os resultados num registo de medição
choice-kinematics-optimize-position = otimizar a cinemática da máquina ativa: o comando mede os eixos rotativos definidos e otimiza a sua posição
choice-kinematics-optimize-position-and-angle = otimizar a cinemática da máquina ativa: o comando mede os eixos rotativos definidos, otimiza a sua posição e compensa o seu ângulo; para isso é necessária a opção KinematicsComp
parameter-sphere-radius = Raio exato da esfera de calibração
    .label = RAIO DA ESFERA
    .help = Raio exato da esfera de calibração utilizada.
parameter-retraction-height = Altura de recuo
    .label = ALTURA DE RECUO
    .help = Determina se e para onde o apalpador recua antes de ser posicionado um eixo rotativo.
choice-no-retraction = não deslocar para a altura de recuo: o comando desloca o apalpador para a posição de medição seguinte no eixo a medir, e para a primeira pela ordem A, B, C; não permitido com eixos Hirth
choice-retraction = altura de recuo, no sistema de coordenadas da peça não inclinado, à qual o comando leva o eixo do cabeçote antes de posicionar um eixo rotativo; no plano de maquinação desloca o apalpador para o ponto zero; a supervisão do apalpador não está ativa neste modo, por isso defina a velocidade de posicionamento em { $q-kinematics-positioning-feed }
parameter-kinematics-positioning-feed = Avanço de posicionamento prévio
    .label = AVANÇO PRÉ-POSICIONAM.
    .help = Velocidade de deslocação da ferramenta ao posicionar.
parameter-kinematics-reference-angle = Ângulo de referência
    .label = ÂNGULO DE REFERÊNCIA
    .help = Ângulo de referência (rotação básica) para a medição dos pontos no sistema de coordenadas da peça ativo. Pode aumentar consideravelmente o campo de medição de um eixo.
parameter-rotary-start-angle-a = Ângulo inicial eixo A
    .label = ÂNGULO INICIAL EIXO A
    .help = Ângulo no eixo A em que se faz a primeira medição.
parameter-rotary-end-angle-a = Ângulo final eixo A
    .label = ÂNGULO FINAL EIXO A
    .help = Ângulo no eixo A em que se faz a última medição.
parameter-rotary-incidence-angle-a = Ângulo de incidência eixo A
    .label = ÂNGULO INCID. EIXO A
    .help = Ângulo de incidência no eixo A em que são medidos os outros eixos rotativos.
parameter-rotary-measuring-points-a = Número de pontos de medição eixo A
    .label = PONTOS MEDIÇÃO EIXO A
    .help = Número de apalpações com que o comando mede o eixo A. Com 0, o eixo não é medido.
parameter-rotary-start-angle-b = Ângulo inicial eixo B
    .label = ÂNGULO INICIAL EIXO B
    .help = Ângulo no eixo B em que se faz a primeira medição.
parameter-rotary-end-angle-b = Ângulo final eixo B
    .label = ÂNGULO FINAL EIXO B
    .help = Ângulo no eixo B em que se faz a última medição.
parameter-rotary-incidence-angle-b = Ângulo de incidência eixo B
    .label = ÂNGULO INCID. EIXO B
    .help = Ângulo de incidência no eixo B em que são medidos os outros eixos rotativos.
parameter-rotary-measuring-points-b = Número de pontos de medição eixo B
    .label = PONTOS MEDIÇÃO EIXO B
    .help = Número de apalpações com que o comando mede o eixo B. Com 0, o eixo não é medido.
parameter-rotary-start-angle-c = Ângulo inicial eixo C
    .label = ÂNGULO INICIAL EIXO C
    .help = Ângulo no eixo C em que se faz a primeira medição.
parameter-rotary-end-angle-c = Ângulo final eixo C
    .label = ÂNGULO FINAL EIXO C
    .help = Ângulo no eixo C em que se faz a última medição.
parameter-rotary-incidence-angle-c = Ângulo de incidência eixo C
    .label = ÂNGULO INCID. EIXO C
    .help = Ângulo de incidência no eixo C em que são medidos os outros eixos rotativos.
parameter-rotary-measuring-points-c = Número de pontos de medição eixo C
    .label = PONTOS MEDIÇÃO EIXO C
    .help = Número de apalpações com que o comando mede o eixo C. Com 0, o eixo não é medido.
parameter-sphere-touch-points = Número de pontos de medição (3-8)
    .label = N.º PONTOS DE MEDIÇÃO
    .help = Número de apalpações com que o comando mede a esfera de calibração no plano. Com menos pontos poupa-se tempo, com mais pontos aumenta a exatidão.
parameter-sphere-touch-points__itnc530 = Número de pontos de medição
    .help = Número de apalpações com que o comando mede a esfera de calibração no plano.
parameter-sphere-preset = Memorizar preset (0/1/2/3)
    .label = MEMORIZAR PRESET
    .help = Determina se o comando memoriza automaticamente o preset ativo (ponto de referência) no centro da esfera.
choice-sphere-preset-none = não memorizar automaticamente o preset no centro da esfera: memorizá-lo manualmente antes do início do ciclo
choice-sphere-preset-before = memorizar automaticamente o preset no centro da esfera antes da medição: posicionar previamente o apalpador à mão por cima da esfera de calibração antes do início do ciclo
choice-sphere-preset-after = memorizar automaticamente o preset no centro da esfera depois da medição: memorizar o preset manualmente antes do início do ciclo
choice-sphere-preset-before-and-after = memorizar o preset no centro da esfera antes e depois da medição: posicionar previamente o apalpador à mão por cima da esfera de calibração antes do início do ciclo
parameter-backlash-angle = Folga, campo angular
    .label = FOLGA, CAMPO ANGULAR
    .help = Ângulo em que os eixos rotativos ultrapassam a posição para se medir a sua folga. Tem de ser consideravelmente maior do que a folga real. Com 0, a folga não é medida.

# --- 451 ---
cycle-measure-kinematics = Medir cinemática
    .nc = MEDIR CINEMÁTICA
    .purpose = Verifica a cinemática da máquina e, se pretendido, otimiza-a. Um apalpador 3D mede uma esfera de calibração HEIDENHAIN fixada na mesa da máquina. O comando avalia a exatidão estática da inclinação; o software reduz ao mínimo o erro espacial causado pela inclinação e guarda a geometria da máquina nas constantes de máquina da descrição da cinemática.
step-clamp-sphere = Fixe a esfera de calibração de modo que não possa ocorrer nenhuma colisão.
step-set-datum-in-sphere = No modo de funcionamento Manual, memorize o ponto de referência no centro da esfera. Com { $q-sphere-preset }=1 ou { $q-sphere-preset }=3, posicione em vez disso o apalpador à mão, no eixo do apalpador por cima da esfera de calibração e no plano de maquinação no centro da esfera.
step-start-calibration-program = Selecione um modo de funcionamento de execução do programa e inicie o programa de calibração.
step-set-preset-before-measuring = { $q-sphere-preset } determina que preset é válido para a medição:
say-preset-into-sphere-before = com { $q-sphere-preset }=1 ou 3, o comando memoriza-o no centro da esfera, antes da medição
say-preset-set-by-hand = caso contrário, utiliza o ponto de referência memorizado manualmente
step-move-to-measuring-positions = O apalpador desloca-se para as posições de medição:
say-move-without-retraction = com { $q-retraction-height }=0, sem recuo, no eixo a medir; para a primeira posição de medição, pela ordem A, B, C
say-move-over-retraction-height = caso contrário, o eixo do cabeçote desloca-se primeiro para a altura de recuo { $q-retraction-height } e o apalpador para o ponto zero no plano de maquinação
step-measure-rotary-axes = O comando mede automaticamente, um após outro, todos os eixos rotativos com a exatidão definida. A medição de referência faz-se a 0°.
step-measure-backlash = { $q-backlash-angle } determina se o comando mede a folga:
say-backlash-from-two-measurements = com um ângulo em { $q-backlash-angle }, determina a folga por meio de duas medições de cada eixo rotativo
say-no-backlash-measurement = com { $q-backlash-angle }=0, não mede a folga
step-adapt-kinematics = O comando avalia a medição conforme o modo { $q-kinematics-mode }:
say-report-possible-optimization = verificar: determina a exatidão estática da inclinação a partir das posições medidas, regista o que uma otimização das posições poderia alcançar e não adapta nada
say-optimize-axis-positions = otimizar a posição: determina a exatidão estática da inclinação, procura alterar a posição dos eixos rotativos no modelo cinemático de modo que a exatidão melhore e adapta automaticamente os dados da máquina
say-optimize-angles-then-positions = otimizar a posição e o ângulo: determina a exatidão estática da inclinação, procura primeiro otimizar a posição angular dos eixos rotativos por compensação (opção 52, KinematicsComp) e, se o conseguir, otimiza a posição noutra série de medições
step-store-scatter-and-offsets = O comando guarda os valores medidos nos parâmetros de resultado.
step-set-preset-after-measuring = Depois da medição, { $q-sphere-preset } determina se o comando memoriza o preset:
say-preset-into-sphere-after = com { $q-sphere-preset }=2 ou 3, memoriza-o no centro da esfera
say-no-preset-after = caso contrário, não o memoriza
step-write-kinematics-log = O comando cria um registo (TCHPR{ $cycle }.TXT).
result-scatter-measured-a = Desvio padrão medido do eixo A (−1 se o eixo não foi medido)
result-scatter-measured-b = Desvio padrão medido do eixo B (−1 se o eixo não foi medido)
result-scatter-measured-c = Desvio padrão medido do eixo C (−1 se o eixo não foi medido)
result-scatter-optimized-a = Desvio padrão otimizado do eixo A (−1 se o eixo não foi otimizado)
result-scatter-optimized-b = Desvio padrão otimizado do eixo B (−1 se o eixo não foi otimizado)
result-scatter-optimized-c = Desvio padrão otimizado do eixo C (−1 se o eixo não foi otimizado)
result-offset-error-x = Erro de desvio na direção X, para transferência manual para o respetivo parâmetro de máquina
result-offset-error-y = Erro de desvio na direção Y, para transferência manual para o respetivo parâmetro de máquina
result-offset-error-z = Erro de desvio na direção Z, para transferência manual para o respetivo parâmetro de máquina
note-place-sphere-without-collision = Escolha a posição da esfera de calibração na mesa da máquina de modo que não possa ocorrer nenhuma colisão durante a medição.
note-hirth-axes-leave-their-grid = Perigo de colisão! Para ser posicionado, um eixo Hirth tem de sair do dentado Hirth. Providencie uma distância de segurança suficientemente grande para evitar colisões entre o apalpador e a esfera de calibração, e espaço suficiente até aos interruptores de fim de curso de software.
note-save-kinematics-first = Se o ciclo for interrompido durante a medição, os dados da cinemática podem já não estar no estado original. Antes de uma otimização, guarde a cinemática ativa com o ciclo 450, para que possa ser restaurada em caso de erro.
note-kinematics-options = Têm de estar ativadas as opções de software 48 (KinematicsOpt), 8 (opção de software 1) e 17 (funções do apalpador).
note-kinematics-options__itnc530 = Têm de estar ativadas as opções de software 48 (KinematicsOpt) e 8 (opção de software 1) e o FCL 3.
note-kinematics-comp-option = A compensação de posições angulares (modo 2) precisa da opção de software 52, KinematicsComp.
note-probe-must-be-calibrated = O apalpador 3D utilizado na medição tem de estar calibrado.
note-tool-axis-z-only = O ciclo só pode ser executado com o eixo da ferramenta Z.
note-recommended-spheres = Tem de estar fixada, em qualquer posição da mesa da máquina, uma esfera de calibração suficientemente rígida e de raio conhecido com exatidão. A HEIDENHAIN recomenda as esferas de calibração KKH 250 (n.º de encomenda 655475-01) e KKH 100 (n.º de encomenda 655475-02), que são especialmente rígidas e concebidas para a calibração de máquinas. Se necessário, contacte a HEIDENHAIN.
note-kinematics-description-complete = A descrição da cinemática da máquina tem de estar completa e correta, com medidas de transformação cuja exatidão seja de cerca de 1 mm, e a máquina tem de ter sido medida geometricamente por completo (pelo fabricante da máquina na colocação em funcionamento).
note-model-differs-from-machine = Se o modelo cinemático memorizado no comando divergir da máquina, o posicionamento dos eixos rotativos provoca erros na peça. O ciclo mede os eixos rotativos tanto da mesa como da cabeça, de forma totalmente automática e com uma resolução que se pode escolher; na definição do ciclo indica-se para cada eixo rotativo apenas a margem a medir.
note-kinematics-machine-data = { $mp-max-modification } é o limite das alterações dos dados da cinemática acima do qual o comando mostra um aviso. { $mp-max-ball-deviation } é o desvio permitido entre o raio medido da esfera e o raio introduzido. { $mp-rotary-axis-m-function } é a função M que posiciona os eixos rotativos, ou −1 se for o próprio comando a posicioná-los.
note-kinematics-config-stored = O fabricante da máquina tem de ter memorizado os parâmetros de máquina de { $mp-kinematics-config } nos dados de configuração.
note-string-parameters-used = Os ciclos KinematicsOpt utilizam os parâmetros de texto globais QS0 a QS99. Estes podem ter mudado depois da execução dos ciclos.
note-rotary-axes-at-zero = Se { $mp-rotary-axis-m-function } definir uma função M (diferente de −1), só inicie a medição quando todos os eixos rotativos estiverem a 0° (sistema de valores reais).
note-restart-after-change = Se o ciclo tiver alterado um parâmetro de máquina, reinicie o comando. Caso contrário, a alteração pode perder-se.
note-positioning-direction = A direção de posicionamento do eixo rotativo a medir resulta do ângulo inicial e do ângulo final. A medição de referência faz-se automaticamente a 0°.
note-angular-step-of-axis = O intervalo entre as posições de medição é (ângulo final − ângulo inicial) / (número de pontos de medição − 1). Exemplo: de +90° a −90° com 4 pontos resultam passos de −60°: +90°, +30°, −30°, −90°. De +90° a +270° com 4 pontos resultam passos de +60°: +90°, +150°, +210°, +270°.
note-no-position-twice = Escolha o ângulo inicial e o ângulo final de modo que nenhuma posição seja medida duas vezes (como +90° e −270°). Medir duas vezes a mesma posição não faz sentido, mas não provoca nenhum aviso de erro.
note-point-at-zero-ignored = Um ponto de medição a 0° é ignorado, porque a medição de referência se faz sempre a 0°.
note-point-at-zero-is-an-error = Nenhum ponto de medição pode estar a 0° ou 360°. Estas posições não fornecem dados úteis e provocam um aviso de erro.
note-hirth-positions-rounded = O comando arredonda as posições de medição dos eixos Hirth ao dentado Hirth. Exemplo com um dentado de 3°: −30°, +10°, +50°, +90° passam a −30°, 9°, 51°, 90°.
note-hirth-needs-retraction-height = Para eixos Hirth, defina uma altura de recuo { $q-retraction-height } maior do que 0 se a opção de software 2 (M128, FUNCTION TCPM) não estiver disponível.
note-number-of-measuring-points = Para poupar tempo, faça uma otimização grosseira com 1 ou 2 pontos de medição e depois uma fina com um número médio (cerca de 4). Mais pontos não dão, em geral, melhores resultados. Distribua os pontos uniformemente pelo campo de inclinação: um eixo com um campo de 0° a 360° mede-se melhor com 3 pontos, a 90°, 180° e 270°. Para verificar a exatidão, podem introduzir-se mais pontos no modo «verificar».
note-where-to-place-the-sphere = A esfera pode ser fixada em qualquer posição acessível da mesa da máquina, também em dispositivos de fixação ou peças. Em máquinas com mesa rotativa ou basculante, coloque-a o mais longe possível do centro de rotação; em máquinas com grandes percursos, o mais perto possível da posição em que se fará a maquinação.
note-accuracy-of-kinematics = Os erros de geometria e de posicionamento da máquina influenciam os valores medidos e, com isso, a otimização de um eixo rotativo; resta sempre um erro residual. Sem esses erros, os valores seriam reproduzíveis num determinado momento em qualquer ponto da máquina. Quanto maiores forem esses erros, mais dispersos são os resultados quando a esfera é medida em posições diferentes. Se vários eixos rotativos se deslocarem ao mesmo tempo, os erros sobrepõem-se e, no pior caso, somam-se.
note-scatter-meaning = A dispersão indicada no registo é uma medida da exatidão dos movimentos de inclinação estáticos de uma máquina. Há que ter em conta também o raio do círculo de medição e o número e a posição dos pontos de medição. Com um único ponto de medição não se pode calcular a dispersão; o valor é então o erro espacial desse ponto.
note-track-for-kinematics = Se a máquina tiver um cabeçote regulado, ative o seguimento do ângulo ({ $mp-track }). Em geral, isso melhora a exatidão das medições com um apalpador 3D.
note-unclamp-rotary-axes = Se necessário, desative o bloqueio dos eixos rotativos durante a medição. Caso contrário, os resultados podem ficar errados. Consulte o manual da máquina.
note-calibration-rough = Otimização grosseira na colocação em funcionamento, depois de introduzidas medidas aproximadas: 1 ou 2 pontos de medição, passo angular dos eixos rotativos de cerca de 90°.
note-calibration-fine = Otimização fina em toda a margem de deslocação: 3 a 6 pontos de medição; o ângulo inicial e o ângulo final devem cobrir o maior campo possível; coloque a esfera de modo que os eixos rotativos da mesa tenham um grande círculo de medição, ou que os eixos rotativos da cabeça possam ser medidos numa posição representativa (como o meio da margem de deslocação).
note-calibration-one-position = Otimização de uma posição especial de um eixo rotativo: 2 ou 3 pontos de medição; meça no ângulo em que mais tarde se fará a maquinação, com a esfera no local da maquinação.
note-calibration-check = Verificação da exatidão da máquina: 4 a 8 pontos de medição; o ângulo inicial e o ângulo final devem cobrir o maior campo possível.
note-calibration-backlash = Determinação da folga dos eixos rotativos: 8 a 12 pontos de medição; o ângulo inicial e o ângulo final devem cobrir o maior campo possível.
note-backlash-measured-twice = A folga é um pequeno jogo entre o encoder rotativo e a mesa que surge ao inverter o sentido. Fora do circuito de regulação (por exemplo, com o encoder do motor) pode causar erros consideráveis. { $q-backlash-angle } ativa a sua medição; o ciclo mede então cada eixo rotativo duas vezes.
note-backlash-not-compensated = O comando não compensa automaticamente a folga.
note-backlash-not-determined = A folga não é determinada se o raio do círculo de medição for menor do que 1 mm, se { $mp-rotary-axis-m-function } definir uma função M ou se o eixo for um eixo Hirth. Quanto maior for o raio do círculo de medição, maior é a exatidão com que se determina a folga.
note-reset-tilting = Certifique-se de que estão anuladas todas as funções de inclinação do plano de maquinação.
note-tcpm-switched-off = M128 e FUNCTION TCPM são desligadas.
note-tcpm-must-be-off = M128 e FUNCTION TCPM não podem estar ativas.
note-datum-in-sphere-first = Antes da definição do ciclo, memorize e ative o ponto de referência no centro da esfera de calibração ou introduza { $q-sphere-preset }=1 ou 3.
note-preposition-for-preset = Se o preset for memorizado antes da medição ({ $q-sphere-preset }=1 ou 3), posicione o apalpador, antes do início do ciclo, aproximadamente por cima do centro da esfera de calibração, à distância de segurança ({ $q-probing-clearance } + { $mp-set-up }).
note-preposition-for-preset__itnc530 = Se o preset for memorizado antes da medição ({ $q-sphere-preset }=1 ou 3), posicione o apalpador, antes do início do ciclo, aproximadamente por cima do centro da esfera de calibração.
note-kinematics-feeds = Na deslocação para a altura de apalpação no eixo do apalpador, o comando utiliza o menor dos valores { $q-kinematics-positioning-feed } e { $mp-positioning-feed }. Os eixos rotativos deslocam-se com o avanço { $q-kinematics-positioning-feed }, sem supervisão ativa do apalpador.
note-kinematics-limit-exceeded = Se no modo «otimizar» os dados da cinemática ultrapassarem o limite permitido ({ $mp-max-modification }), o comando emite um aviso. Confirme com o arranque NC que os valores devem ser aceites.
note-preset-changes-with-kinematics = Uma alteração da cinemática altera sempre também o preset. Depois de uma otimização, volte a memorizar o preset.
note-sphere-radius-checked = Em cada apalpação, o comando mede primeiro o raio da esfera de calibração. Se o desvio em relação ao raio introduzido for superior a { $mp-max-ball-deviation }, o comando emite um aviso de erro e termina a medição.
note-sphere-radius-checked__itnc530 = Em cada apalpação, o comando mede primeiro o raio da esfera de calibração. Se o desvio em relação ao raio introduzido for superior a { $mp-max-ball-deviation }, o comando emite um aviso e termina a medição.
note-interrupted-kinematics = Se o resultado não corresponder às expectativas ou ocorrer um erro como uma falha de energia, pode restaurar-se a cinemática guardada.
note-results-in-mm = Mesmo em programas em polegadas, os resultados e o registo são indicados em mm.
note-inactive-axes-ignored = Os dados introduzidos na definição do ciclo para eixos que não estejam ativos são ignorados.
note-status-window = Uma janela mostra o estado da medição. O comando oculta-a assim que é percorrido um caminho maior do que o raio da esfera.
note-kinematics-log-contents = O registo contém a data e a hora, o caminho do programa NC, o modo, o número da cinemática ativa e o raio da esfera introduzido; para cada eixo rotativo medido: ângulo inicial, ângulo final, ângulo de incidência, número de pontos de medição, dispersão (desvio padrão), erro máximo, erro angular, folga média, erro de posicionamento médio, raio do círculo de medição, valores de correção em todos os eixos (deslocação do preset) e incerteza de medição dos eixos rotativos.
note-kinematics-log-contents__itnc530 = O registo contém a data e a hora, o caminho do programa NC, o modo, o número da cinemática ativa e o raio da esfera introduzido; para cada eixo rotativo medido: ângulo inicial, ângulo final, ângulo de incidência, número de pontos de medição, dispersão (desvio padrão), erro máximo, erro angular, folga média, erro de posicionamento médio, raio do círculo de medição, valores de correção em todos os eixos (deslocação do preset), avaliação dos pontos de medição e incerteza de medição dos eixos rotativos.
note-kinematics-log-explained = No modo «verificar», o registo indica a exatidão que uma otimização poderia alcançar; nos outros modos, a exatidão alcançada. Se não for possível calcular a posição angular de um eixo rotativo, os dados medidos são ainda assim registados. Dispersão medida: 68,3% dos erros espaciais medidos ficam dentro de ± este valor; otimizada: 68,3% dos erros esperados depois da correção. A avaliação dos pontos de medição é uma medida da qualidade das posições de medição relativamente às transformações do modelo que podem ser alteradas: quanto mais alta, melhor é a otimização. Não deve ser inferior a 2 para nenhum eixo rotativo, sendo preferível 4 ou mais; se for pequena, aumente o campo de medição do eixo ou o número de pontos. Se isso não ajudar, a descrição da cinemática pode estar errada; se necessário, contacte o serviço de assistência.
note-measuring-uncertainty = A incerteza de medição é indicada em graus por 1 µm de incerteza do sistema e serve para avaliar os erros de posicionamento medidos ou a folga de um eixo rotativo. O comando não conhece a exatidão do sistema completo, pelo que é preciso estimá-la: incerteza do sistema = SQRT(3 · u² + p²), com a incerteza de posicionamento (ou, para a folga, a repetibilidade) u de cada eixo linear e a incerteza p do apalpador. Exemplos: com u = 10 µm e p = 2 µm resultam 17,4 µm, que a 0,0002°/µm correspondem a 0,0034°; com u = 5 µm e p = 2 µm resultam 8,9 µm, que a 0,0002°/µm correspondem a 0,0018°.
note-reference-head = Para ajustar cabeças intercambiáveis, monte uma delas como cabeça de referência, fixe a esfera de calibração, coloque o apalpador, meça a cinemática completa com este ciclo e memorize o preset depois da medição ({ $q-sphere-preset }=2 ou 3). As outras cabeças são depois ajustadas com o ciclo 452.
note-drift-reference = Para compensar a deriva, fixe a esfera de calibração, meça a cinemática completa com este ciclo antes de iniciar a maquinação, memorize o preset depois da medição ({ $q-sphere-preset }=2 ou 3), memorize então os presets das peças e inicie a maquinação. O ciclo 452 compensa a deriva a intervalos regulares.
note-rotary-m-function = Consoante a configuração da máquina, o comando pode não conseguir posicionar automaticamente os eixos rotativos. É então necessária uma função M especial do fabricante da máquina, com o seu número em { $mp-rotary-axis-m-function }.
note-angle-optimization-prepared = Para a otimização dos ângulos, o fabricante da máquina tem de ter adaptado a configuração. Esta otimização pode trazer melhorias sobretudo em máquinas pequenas e compactas. Pergunte ao fabricante da máquina se isso foi feito e se a otimização é conveniente.
title-save-and-check-kinematics = Verificar a cinemática
title-calibration-program = Programa de calibração
title-optimize-position-with-backlash = Otimizar a posição dos eixos rotativos depois da memorização automática do ponto de referência e medir a sua folga
title-optimize-position-and-angle = Otimizar o ângulo e a posição dos eixos rotativos depois da memorização automática do ponto de referência
title-measure-reference-head = Medir a cabeça de referência
title-reference-for-drift = Medição de referência para a compensação da deriva
