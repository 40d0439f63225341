# Cycles that save the kinematics and compensate the preset.

# --- 450 ---
cycle-save-kinematics = Guardar cinemática
    .nc = GUARDAR CINEMÁTICA
    .purpose = Guarda a cinemática ativa da máquina ou restaura uma cinemática guardada anteriormente. Os dados guardados podem ser mostrados e apagados.
cycle-save-kinematics__itnc530 =
    .purpose = Guarda a cinemática ativa da máquina, restaura uma cinemática guardada anteriormente ou mostra o estado atual da memória no ecrã e num registo.
condition-memory-location-used = { $q-kinematics-memory-mode } for diferente de 2
step-treat-saved-kinematics = O comando trata a cinemática conforme o modo { $q-kinematics-memory-mode }:
say-save-active-kinematics = 0: guarda a cinemática ativa em { $q-kinematics-memory-location }
say-restore-saved-kinematics = 1: restaura a cinemática guardada em { $q-kinematics-memory-location }
say-show-saved-kinematics = 2: mostra o estado atual da memória
say-delete-saved-kinematics = 3: apaga os registos de dados que { $q-kinematics-memory-location } designa
note-save-before-optimization = Antes de uma otimização da cinemática, guarde sempre a cinemática ativa.
note-kinematics-memory-size = Estão disponíveis 16 posições de memória.
note-kinematics-memory-size__itnc530 = Estão disponíveis 10 posições de memória, com os números 0 a 9.
note-restore-only-into-identical-kinematics = No modo «restaurar», o comando só pode repor os dados guardados se a descrição da cinemática for idêntica.
note-preset-changes-with-kinematics__save-kinematics = Uma alteração da cinemática, e portanto também o seu restauro, altera sempre o preset. Se necessário, volte a memorizar o preset.
note-kinematics-memory-wildcards = Se vários registos de dados corresponderem aos caracteres de substituição de { $q-kinematics-memory-location }, o comando restaura os valores médios dos seus dados (modo 1) ou apaga-os todos, depois de confirmação (modo 3).
note-kinematics-memory-file = O comando guarda os dados no ficheiro TNC:\table\DATA450.KD. Pode fazer-se uma cópia de segurança deste ficheiro num computador externo, por exemplo com o TNCremo, para que possa ser restaurado depois de um defeito do disco. Se o ficheiro for apagado, os dados guardados perdem-se. Se não existir, o comando cria-o ao executar o ciclo 450.
note-kinematics-memory-file-by-hand = Não altere à mão os dados guardados no ficheiro TNC:\table\DATA450.KD: os registos de dados podem ficar corrompidos e inutilizáveis.
note-kinematics-memory-code-number = No modo «guardar», o comando guarda sempre também o último código introduzido em MOD; pode definir-se qualquer código. Depois disso, o conteúdo da posição de memória só pode ser substituído se for introduzido esse código.
note-overwritten-without-question = Se uma cinemática tiver sido guardada sem código, o comando substitui-a, ao guardar de novo na mesma posição de memória, sem pedir confirmação.
note-kinematics-memory-log-contents = Depois do ciclo 450, o comando cria um registo (TCHPR450.TXT). Contém a data e a hora, o caminho do programa NC, o modo (0=guardar/1=restaurar/2=estado da memória/3=apagar), o identificador da cinemática ativa e o identificador do registo de dados introduzido. O modo 0 acrescenta todas as entradas de eixos e de transformações da cadeia cinemática guardada, o modo 1 todas as entradas de transformações antes e depois do restauro, o modo 2 uma lista dos registos de dados guardados, o modo 3 uma lista dos registos de dados apagados.
note-kinematics-memory-log-contents__itnc530 = Depois do ciclo 450, o comando cria um registo (TCHPR450.TXT). Contém a data e a hora, o caminho do programa NC, o modo (0=guardar/1=restaurar/2=estado da memória), o número da posição de memória (0 a 9), o número da linha da cinemática na tabela de cinemáticas e o código, se tiver sido introduzido um imediatamente antes do ciclo 450. O modo 0 acrescenta todas as entradas de eixos e de transformações da cadeia cinemática guardada, o modo 1 todas as entradas de transformações antes e depois do restauro, o modo 2 uma lista do estado atual da memória, no ecrã e no registo, com posição de memória, códigos, número da cinemática e data da gravação.
title-save-active-kinematics = Guardar a cinemática ativa
title-restore-saved-kinematics = Restaurar registos de dados
title-show-saved-kinematics = Mostrar todos os registos de dados guardados
title-delete-saved-kinematics = Apagar registos de dados
title-save-before-calibration = Guardar a cinemática antes de um programa de calibração
table-kinematics-memory = Cinemáticas guardadas

# --- 452 ---
cycle-preset-compensation = Compensação de preset
    .nc = COMPENSAÇÃO DE PRESET
    .purpose = Otimiza a cadeia de transformação cinemática da máquina. O comando corrige depois também o sistema de coordenadas da peça no modelo cinemático, de modo que, depois da otimização, o preset fique no centro da esfera de calibração. Assim podem ajustar-se entre si cabeças intercambiáveis ou compensar-se a deriva da máquina.
group-match-interchangeable-heads = Ajuste de cabeças intercambiáveis
group-compensate-drift = Compensação da deriva, se a esfera de calibração puder ficar na mesa da máquina durante a maquinação
group-measure-and-compensate = Medição e compensação
step-clamp-calibration-sphere = Fixe a esfera de calibração.
step-measure-reference-head = Meça a cabeça de referência por completo com o ciclo 451 e memorize com o ciclo 451 o preset no centro da esfera.
step-insert-second-head = Coloque a segunda cabeça.
step-measure-second-head = Meça a cabeça intercambiável com o ciclo { $cycle } até à interface da troca de cabeça.
step-match-further-heads = Ajuste as outras cabeças intercambiáveis à cabeça de referência com o ciclo { $cycle }.
step-set-preset-in-sphere = Memorize o preset na esfera de calibração.
step-set-preset-on-workpiece = Memorize o preset na peça e inicie a maquinação.
step-compensate-at-intervals = Compense o preset a intervalos regulares com o ciclo { $cycle }: o comando determina a deriva dos eixos em causa e corrige-a na cinemática.
step-optimize-transformation-chain = O comando otimiza a cadeia de transformação cinemática da máquina.
step-correct-workpiece-system = O comando corrige o sistema de coordenadas da peça no modelo cinemático, de modo que o preset fique no centro da esfera de calibração.
note-datum-in-sphere-first__preset-compensation = Antes da definição do ciclo, memorize e ative o ponto de referência no centro da esfera de calibração.
note-one-degree-before-limit-switch = Em eixos sem encoder de posição próprio, escolha os pontos de medição de modo que reste um percurso (1°) até ao interruptor de fim de curso. O comando precisa deste percurso para a compensação interna da folga.
note-kinematics-limit-exceeded__preset-compensation = Se os dados da cinemática ultrapassarem o limite permitido ({ $mp-max-modification }), o comando emite um aviso. Confirme com o arranque NC que os valores devem ser aceites.
note-match-heads-purpose = Com o ajuste de cabeças intercambiáveis, o preset da peça mantém-se inalterado ao trocar eixos rotativos (cabeças). Coloque uma das cabeças como cabeça de referência, fixe a esfera de calibração, coloque o apalpador, meça a cinemática completa com o ciclo 451 e memorize o preset depois da medição (Q431=2 ou 3). Coloque então a cabeça seguinte e o apalpador e meça-a com o ciclo { $cycle }. Todas as outras cabeças podem ser ajustadas da mesma forma.
note-match-heads-only-changed-axes = Meça só os eixos que foram realmente trocados. Exemplo: uma cabeça de forquilha com os eixos A e C, da qual só se troca o eixo A; o eixo C exclui-se com { $q-rotary-measuring-points-c }=0.
note-preset-and-sphere-stay = O preset e a posição da esfera de calibração não podem mudar durante todo o processo.
note-drift-purpose = Durante a maquinação, os componentes da máquina sofrem uma deriva, devido às influências variáveis do ambiente. Se a deriva for suficientemente constante na margem de deslocação e se a esfera de calibração puder ficar na mesa da máquina, o ciclo { $cycle } determina-a e compensa-a. Fixe a esfera de calibração, coloque o apalpador, meça a cinemática completa com o ciclo 451 antes de iniciar a maquinação e memorize o preset depois da medição (Q431=2 ou 3), memorize depois os presets das peças e inicie a maquinação. A intervalos regulares, coloque o apalpador, ative o preset na esfera de calibração e meça a cinemática com o ciclo { $cycle }.
note-drift-without-rotary-axes = A deriva também pode ser compensada em máquinas sem eixos rotativos.
note-kinematics-prepared-for-preset = A cinemática tem de estar preparada para a compensação de preset. Consulte o manual da máquina.
note-head-change-is-machine-function = A troca de cabeças é uma função da máquina. Consulte o manual da máquina.
note-kinematics-log-contents__preset-compensation = O registo contém a data e a hora, o caminho do programa NC, o número da cinemática ativa e o raio da esfera introduzido; para cada eixo rotativo medido: ângulo inicial, ângulo final, ângulo de incidência, número de pontos de medição, dispersão (desvio padrão), erro máximo, erro angular, folga média, erro de posicionamento médio, raio do círculo de medição, valores de correção em todos os eixos (deslocação do preset) e incerteza de medição dos eixos rotativos.
note-kinematics-log-contents__preset-compensation__itnc530 = O registo contém a data e a hora, o caminho do programa NC, o número da cinemática ativa e o raio da esfera introduzido; para cada eixo rotativo medido: ângulo inicial, ângulo final, ângulo de incidência, número de pontos de medição, dispersão (desvio padrão), erro máximo, erro angular, folga média, erro de posicionamento médio, raio do círculo de medição, valores de correção em todos os eixos (deslocação do preset), avaliação dos pontos de medição e incerteza de medição dos eixos rotativos.
note-kinematics-log-explained__preset-compensation = Dispersão medida: 68,3% dos erros espaciais medidos ficam dentro de ± este valor; otimizada: 68,3% dos erros esperados depois da correção. A avaliação dos pontos de medição é uma medida da qualidade das posições de medição relativamente às transformações do modelo que podem ser alteradas: quanto mais alta, melhor é a otimização. Não deve ser inferior a 2 para nenhum eixo rotativo, sendo preferível 4 ou mais; se for pequena, aumente o campo de medição do eixo ou o número de pontos. Se isso não ajudar, a descrição da cinemática pode estar errada; se necessário, contacte o serviço de assistência.
title-compensate-preset = Programa de calibração
title-match-interchangeable-head = Ajustar uma cabeça intercambiável
title-compensate-drift = Compensar a deriva

# --- kinematics ---
message-backlash-angle-too-small = A folga encontrada não é muito menor do que o ângulo introduzido em { $q-backlash-angle }: pode ser maior do que a medida. Introduza um ângulo maior e meça de novo.
message-kinematics-limit-exceeded = Os dados da cinemática alteram-se mais do que o valor limite permitido. Confirme a aceitação com arranque NC.
message-delete-saved-kinematics = Ao nome correspondem várias cinemáticas guardadas. Confirme que todas devem ser apagadas.
