# Cycles that measure the workpiece.

# --- 421 ---
cycle-measure-hole = Medir furo
    .nc = MEDIR FURO
    .nc-aliases = MEDIÇÃO DUM FURO
    .purpose = Mede o centro e o diâmetro de um furo (caixa circular). Se no ciclo estiverem definidas tolerâncias, o comando compara os valores nominais com os reais e guarda os desvios em parâmetros.
step-retract-and-store-results = O comando faz regressar o apalpador à altura segura { $q-clearance-height } e guarda os valores reais e os desvios em relação aos valores nominais nos parâmetros de resultado.
step-set-measuring-status = O comando determina o estado da medição:
say-hole-is-scrap = desperdício (Q182=1) se o furo for maior do que { $q-hole-greatest-diameter } ou se o seu centro apresentar um desvio superior a { $q-centre-tolerance-main } ou { $q-centre-tolerance-minor }
say-hole-needs-rework = trabalho de acabamento (Q181=1) se o furo for menor do que { $q-hole-least-diameter }
say-hole-is-good = caso contrário, dentro da tolerância (Q180=1), mesmo que não tenham sido introduzidas tolerâncias nem valores limite
step-write-measuring-log = O comando cria o registo de medição conforme { $q-measuring-log }:
say-log-to-file = com { $q-measuring-log }=1, guarda o registo no ficheiro TCHPR{ $cycle }.TXT
say-log-on-screen = com { $q-measuring-log }=2, interrompe a execução do programa e mostra o registo no ecrã; o arranque NC continua o programa
say-no-log = caso contrário, não cria nenhum registo
message-measuring-log-on-screen = O registo de medição está no ecrã. Continue com o arranque NC.
step-monitor-tool = O comando supervisiona a ferramenta conforme { $q-monitored-tool }:
say-correct-tool-radius = com { $q-monitored-tool } diferente de 0, soma o desvio do raio ao valor delta da coluna DR da tabela de ferramentas; se o desvio for maior do que a tolerância de rotura RBREAK, emite um aviso de erro, detém a execução do programa e bloqueia a ferramenta (coluna TL = L)
say-no-tool-monitoring = com { $q-monitored-tool }=0, não é supervisionada nenhuma ferramenta
step-stop-on-tolerance-error = O comando reage a uma tolerância excedida conforme { $q-stop-on-tolerance-error }:
say-stop-with-tolerance-error = com { $q-stop-on-tolerance-error }=1, interrompe a execução do programa e emite um aviso de erro
say-stop-with-tolerance-error__probing-3d = com { $q-tolerance-error-reaction }=1, interrompe a execução do programa e emite um aviso de erro
say-continue-program = caso contrário, o programa continua
result-centre-main-deviation = Desvio centro eixo principal
result-centre-minor-deviation = Desvio centro eixo secundário
result-diameter-deviation = Desvio diâmetro
result-status-good = 1: os valores de medição situam-se dentro da tolerância
result-status-rework = 1: necessário trabalho de acabamento
result-status-scrap = 1: desperdício
note-measuring-log-contents = O registo de medição contém a data, a hora e o programa de medição, os valores nominais, os valores limite, os valores reais, os desvios e outros resultados (altura de medição).
note-measuring-log-contents__tnc426-430 = O registo de medição contém a data, a hora e o programa de medição, os valores nominais, os valores limite, os valores reais e os desvios.
note-measuring-log-in-tnc-directory = O comando guarda o registo de medição como ficheiro ASCII, por predefinição no diretório TNC:\.
note-measuring-log-in-program-directory = O comando guarda o registo de medição como ficheiro ASCII, por predefinição no diretório a partir do qual é executado o programa de medição. Em alternativa, o registo pode ser enviado pela interface de dados para uma impressora ou um PC: para isso, defina a função Print do menu de configuração de interfaces como RS232:\.
note-measuring-log-transfer = O registo de medição pode ser transmitido pela interface de dados com o TNCremo, o software de transmissão de dados da HEIDENHAIN.
note-measuring-log-datum = Todos os valores medidos do ficheiro do registo referem-se ao ponto de referência que estava ativo quando o ciclo foi executado.
note-measuring-log-manual-datum = Sem uma deslocação do ponto zero ativa, todos os valores medidos do ficheiro do registo referem-se ao ponto de referência memorizado no modo de funcionamento Manual.
note-status-also-without-limits = O comando determina o estado da medição mesmo que não tenham sido introduzidas tolerâncias nem valores limite.
note-which-value-is-out = O comando assinala trabalho de acabamento ou desperdício assim que um dos valores medidos fique fora da tolerância. Para saber qual, consulte o registo de medição ou compare os resultados com os seus valores limite.
note-limit-zero-not-monitored = Com 0 (o valor pré-ajustado) num valor limite ou numa tolerância, o comando não o supervisiona.
note-tool-monitoring-needs = A supervisão e a correção da ferramenta só atuam se a tabela de ferramentas estiver ativa e { $q-monitored-tool } for diferente de 0. Se forem feitas várias medições de correção, o comando soma cada desvio ao valor guardado na tabela de ferramentas.
note-tool-monitoring-needs__tnc426-430 = A supervisão e a correção da ferramenta só atuam se a tabela de ferramentas estiver ativa e { $q-monitored-tool } for diferente de 0.
note-tool-radius-always-corrected = O comando corrige sempre o raio da ferramenta na coluna DR da tabela de ferramentas, mesmo que o desvio esteja dentro da tolerância. No programa pode consultar-se com Q181 se é necessário trabalho de acabamento (Q181=1: necessário).
note-tool-breakage-needs = A supervisão da rotura da ferramenta só atua se a tabela de ferramentas estiver ativa, { $q-monitored-tool } for diferente de 0 e a tolerância de rotura RBREAK da ferramenta na tabela de ferramentas for maior do que 0.
note-tool-by-name = A ferramenta também pode ser indicada pelo nome, que se seleciona por softkey. O comando não mostra as aspas finais.

# --- 0 ---
cycle-reference-plane = Plano de referência
    .nc = SUPERF. REF.
    .nc-aliases = PLANO DE REFERÊNCIA
    .purpose = Mede uma coordenada num eixo à escolha e atribui-a a um parâmetro Q.
step-position-in-space = O apalpador desloca-se num movimento 3D em avanço rápido (valor da coluna { $mp-positioning-feed }) para a posição prévia programada no ciclo.
step-position-in-space__tnc426-430 = O apalpador desloca-se em avanço rápido (valor de { $mp-positioning-feed } ou { $mp-analog-positioning-feed }) para a posição prévia programada no ciclo.
step-probe-in-chosen-direction = O apalpador executa a apalpação com o avanço de apalpação (coluna { $mp-probing-feed }) na direção programada no ciclo.
step-probe-in-chosen-direction__tnc426-430 = O apalpador executa a apalpação com o avanço de apalpação ({ $mp-probing-feed } ou { $mp-analog-probing-feed }) na direção programada no ciclo.
step-return-and-store-coordinate = Depois de medida a posição, o apalpador regressa ao ponto de partida da apalpação. O comando guarda a coordenada medida no parâmetro Q programado e, nos parâmetros Q115 a Q119, as coordenadas da posição em que o apalpador se encontrava no momento do sinal de comutação.
result-measured-coordinate = Coordenada medida
result-trigger-position-axis-1 = Posição no momento do sinal de comutação, 1.º eixo
result-trigger-position-axis-2 = Posição no momento do sinal de comutação, 2.º eixo
result-trigger-position-axis-3 = Posição no momento do sinal de comutação, 3.º eixo
result-trigger-position-axis-4 = Posição no momento do sinal de comutação, 4.º eixo
result-trigger-position-axis-5 = Posição no momento do sinal de comutação, 5.º eixo
note-pre-position-without-collision = Perigo de colisão! Posicione o apalpador de modo que não possa colidir ao deslocar-se para a posição prévia programada.
note-pre-position-without-collision__tnc426-430 = Perigo de colisão! Posicione previamente o apalpador à mão, de modo que não possa colidir ao deslocar-se para a posição prévia programada.
note-trigger-position-uncompensated = Os valores em Q115 a Q119 não têm em conta a longitude nem o raio da haste de apalpação.
note-no-log-for-reference-plane = Para este ciclo, o comando não cria nenhum registo de medição.

# --- 444 ---
cycle-probing-3d = Apalpação 3D
    .nc = APALPAÇÃO 3D
    .purpose = Verifica um único ponto da superfície de uma peça, por exemplo de uma superfície de forma livre. O ciclo determina se o ponto se situa acima ou abaixo da sua posição nominal ao longo do vetor normal, para que se possa fazer, por exemplo, um trabalho de acabamento. Pode supervisionar uma tolerância, cria um registo e guarda os resultados em parâmetros.
step-position-on-normal = O apalpador desloca-se da posição atual para um ponto do vetor normal. A distância desse ponto às coordenadas nominais é o raio da esfera do apalpador mais { $mp-set-up } mais { $q-probing-clearance }. O posicionamento prévio tem em conta a altura segura { $q-clearance-height }.
step-probe-nominal-point = O apalpador desloca-se para as coordenadas nominais. O percurso de apalpação é definido por { $mp-probing-distance } e não pelo vetor normal, que só serve para calcular corretamente as coordenadas.
step-return-and-store-position = Depois de o comando ter medido a posição, o apalpador recua e detém-se. O comando guarda as coordenadas medidas e os desvios nos parâmetros de resultado.
step-retract-against-probing-direction = O comando faz recuar o apalpador, no sentido oposto à direção de apalpação, no valor definido no parâmetro MB.
step-set-workpiece-status = O comando determina o estado da peça Q183:
say-surface-status-undefined = −1 (não definido) se { $q-tolerance-specification } não definir nenhuma tolerância
say-surface-needs-rework = 1 (trabalho de acabamento) se o ponto ficar acima da margem de tolerância
say-surface-is-scrap = 2 (desperdício) se o ponto ficar abaixo da margem de tolerância
say-surface-is-good = 0 (bom) nos restantes casos
step-write-surface-log = O comando cria o registo e guarda-o em formato HTML.
step-react-to-tolerance-error = O comando reage a um ponto fora da tolerância conforme { $q-tolerance-error-reaction }:
say-stop-below-nominal = com { $q-tolerance-error-reaction }=2 e um ponto abaixo da coordenada nominal, emite uma mensagem e interrompe o programa
result-position-main-actual = Posição medida no eixo principal
result-position-minor-actual = Posição medida no eixo secundário
result-position-tool-actual = Posição medida no eixo da ferramenta
result-position-main-deviation = Desvio medido no eixo principal
result-position-minor-deviation = Desvio medido no eixo secundário
result-position-tool-deviation = Desvio medido no eixo da ferramenta
result-deviation-3d = Desvio 3D medido; menor do que 0: medida insuficiente, maior do que 0: medida excedente
result-workpiece-status = Estado da peça: −1 = não definido, 0 = bom, 1 = trabalho de acabamento, 2 = desperdício
guard-zero-normal-vector = Todas as componentes do vetor normal são 0.
guard-rotary-axes-askew = As posições dos eixos rotativos não correspondem aos ângulos de inclinação do plano de maquinação.
guard-mill-mode-only = O ciclo só pode ser executado no modo FUNCTION MODE MILL.
guard-surface-below-nominal = O ponto fica abaixo da sua coordenada nominal e fora da tolerância.
note-function-must-be-enabled = O fabricante da máquina tem de ativar e adaptar esta função. Consulte o manual da máquina.
note-mill-mode-only = O ciclo só pode ser executado no modo FUNCTION MODE MILL.
note-calibrate-in-3d = Para obter resultados exatos, calibre o apalpador em 3D antes deste ciclo. A calibração 3D precisa da opção 92, 3D-ToolComp.
note-surface-log-contents = Para o eixo principal, o eixo secundário e o eixo da ferramenta, o registo contém a direção de apalpação real (um vetor no sistema de coordenadas de introdução, tão longo quanto o percurso de apalpação configurado), as coordenadas nominal e real e, se { $q-tolerance-specification } definir uma tolerância, o desvio superior e inferior e o desvio ao longo do vetor normal. A cor de um valor mostra o resultado: verde para bom, laranja para trabalho de acabamento, vermelho para desperdício. O registo contém também o desvio 3D.
note-surface-log-directory = O comando guarda o registo como ficheiro HTML no diretório do programa NC, se estiver configurado um caminho para FN 16.
note-mirror-or-scaling-is-an-error = O comando emite um aviso de erro se, na ativação do ciclo, estiver ativo o espelhamento (ciclo 8), o fator de escala (ciclo 11) ou o fator de escala específico do eixo (ciclo 26).
note-tcpm-considered = A apalpação tem em conta um TCPM ativo. Com TCPM, também se podem apalpar posições quando a inclinação do plano de maquinação e os eixos rotativos não coincidem.
note-track-with-controlled-spindle = Se a máquina tiver um cabeçote regulado, ative o seguimento do ângulo na tabela de apalpadores (coluna { $mp-track }). Em geral, isso melhora a exatidão das medições com um apalpador 3D.
note-coordinates-in-input-system = Todas as coordenadas do ciclo se referem ao sistema de coordenadas de introdução.
note-results-in-parameters = O comando escreve os valores medidos nos parâmetros de resultado.
note-status-independent-of-reaction = O estado da peça em Q183 (bom, trabalho de acabamento ou desperdício) é determinado independentemente de { $q-tolerance-error-reaction }.
note-normal-from-cad = O vetor normal ({ $q-surface-normal-main }, { $q-surface-normal-minor }, { $q-surface-normal-tool }) é perpendicular ao plano imaginário em que se situam as coordenadas nominais e aponta para fora da superfície. É preferível obtê-lo de um sistema CAD ou CAM.
note-normal-does-not-set-path = O vetor normal não determina o percurso de apalpação.
note-tolerance-grammar = Exemplos de tolerância: com "0.4-0.1", a margem vai de 0,1 abaixo da coordenada nominal até 0,4 acima dela; com "0.4", da coordenada nominal até 0,4 acima dela; com "-0.1", de 0,1 abaixo da coordenada nominal até essa coordenada. Com " ", "0" e "0.1+0.1", não é supervisionada nenhuma tolerância.
note-tilting-angles-compared = Conforme o parâmetro de máquina chkTiltingAxes (n.º 204600), o comando verifica durante a apalpação se as posições dos eixos rotativos correspondem aos ângulos de inclinação (3D ROT). Se não corresponderem, emite um aviso de erro.
note-adapt-nc-programs = Os programas NC apresentados como exemplos são propostas. Antes de os utilizar, adapte à máquina as ferramentas, os dados de corte, os avanços, a altura segura ou as posições seguras, as posições específicas da máquina (por exemplo, com M91) e os caminhos das chamadas de programa. Adapte os programas que dependem da cinemática à cinemática da máquina antes da primeira execução de teste.
note-simulate-nc-programs = Teste o programa NC na simulação antes de o executar. O teste de programa mostra se pode ser utilizado com as opções de software disponíveis, a cinemática ativa e a configuração atual da máquina.
