# Cycles that measure the tool: radius, complete tool, calibration of the tool touch probe.

# --- parameters ---
help-tool-check-radius = Determina se se trata da primeira medição da ferramenta ou da verificação de uma ferramenta já medida. Na primeira medição, o comando substitui o raio da ferramenta { $mp-tool-radius } em TOOL.T, a memória central de ferramentas, e coloca a 0 o valor delta { $mp-delta-radius }. A verificação compara o raio medido com o raio da ferramenta { $mp-tool-radius }; o desvio, com o seu sinal, é introduzido como valor delta { $mp-delta-radius } e está também disponível em Q116. Se for excedida a tolerância de desgaste ou de rotura admissível para o raio, o comando bloqueia a ferramenta (estado L em TOOL.T).
help-tool-check-complete = Determina se se trata da primeira medição da ferramenta ou da verificação de uma ferramenta já medida. Na primeira medição, o comando substitui o raio da ferramenta { $mp-tool-radius } e a longitude da ferramenta { $mp-tool-length } em TOOL.T, a memória central de ferramentas, e coloca a 0 os valores delta { $mp-delta-radius } e { $mp-delta-length }. A verificação compara os dados medidos com os da memória de ferramentas; os desvios, com o seu sinal, são introduzidos como valores delta { $mp-delta-radius } e { $mp-delta-length } e estão também disponíveis em Q115 e Q116. Se um dos valores delta exceder a tolerância de desgaste ou de rotura admissível, o comando bloqueia a ferramenta (estado L em TOOL.T).
help-additional-tooth-measurement = Determina se, além disso, as navalhas são medidas individualmente. Podem medir-se no máximo 20 navalhas.
help-additional-tooth-measurement__itnc530 = Determina se, além disso, as navalhas são medidas individualmente. Podem medir-se no máximo 99 navalhas.
help-additional-tooth-measurement__tnc426-430 = Determina se, além disso, as navalhas são medidas individualmente.
help-calibration-tool-height = Posição no eixo do cabeçote à qual a ferramenta de calibração não pode colidir com peças nem com dispositivos de fixação. Refere-se ao ponto de referência ativo da peça. Se, com o valor introduzido, a ponta da ferramenta de calibração ficar abaixo da aresta superior do prato, o comando posiciona-a automaticamente acima do prato (zona de segurança definida em { $mp-setter-safety-distance }).
parameter-tool-check__tool-radius =
    .help = { help-tool-check-radius }
parameter-tool-check__tool-radius-old =
    .help = { help-tool-check-radius }
parameter-tool-check__tool-complete =
    .help = { help-tool-check-complete }
parameter-tool-check__tool-complete-old =
    .help = { help-tool-check-complete }
parameter-tool-check__tool-radius__tnc426-430 = MEDIR FERRAMENTA=0 / VERIFICAR=1
    .prompt = MEDIR FERRAMENTA=0 / VERIFICAR=1
parameter-tool-check__tool-radius-old__tnc426-430 = MEDIR FERRAMENTA=0 / VERIFICAR=1
    .prompt = MEDIR FERRAMENTA=0 / VERIFICAR=1
parameter-tooth-measurement__tool-radius =
    .help = { help-additional-tooth-measurement }
parameter-tooth-measurement__tool-radius-old =
    .help = { help-additional-tooth-measurement }
parameter-tooth-measurement__tool-complete =
    .help = { help-additional-tooth-measurement }
parameter-tooth-measurement__tool-complete-old =
    .help = { help-additional-tooth-measurement }
parameter-tooth-measurement__tool-radius__tnc426-430 = Medição de navalhas 0=NÃO / 1=SIM
    .prompt = Medição de navalhas 0=NÃO / 1=SIM
parameter-tooth-measurement__tool-radius-old__tnc426-430 = Medição de navalhas 0=NÃO / 1=SIM
    .word = MEDIÇÃO NAVALHAS:
    .prompt = Medição de navalhas 0=NÃO / 1=SIM
parameter-tool-status-parameter__tool-radius-old =
    .help = Número do parâmetro em que o comando guarda o estado da medição: 0,0: ferramenta dentro da tolerância; 1,0: ferramenta desgastada ({ $mp-wear-tolerance-radius } excedido); 2,0: ferramenta partida ({ $mp-break-tolerance-radius } excedido). Se o resultado não for utilizado no programa, responda à pergunta com a tecla NO ENT.
parameter-tool-status-parameter__tool-complete-old =
    .help = Número do parâmetro em que o comando guarda o estado da medição: 0,0: ferramenta dentro da tolerância; 1,0: ferramenta desgastada ({ $mp-wear-tolerance-length } ou { $mp-wear-tolerance-radius } excedido, ou ambos); 2,0: ferramenta partida ({ $mp-break-tolerance-length } ou { $mp-break-tolerance-radius } excedido, ou ambos). Se o resultado não for utilizado no programa, responda à pergunta com a tecla NO ENT.
parameter-tool-clearance-height__calibrate-tool-probe = Altura segura
    .help = { help-calibration-tool-height }
    .prompt = Altura Segura
parameter-tool-clearance-height__calibrate-tool-probe-old = Altura segura
    .help = { help-calibration-tool-height }
    .prompt = Altura Segura
parameter-tool-clearance-height__tool-complete =
    .label = ALTURA SEGURANÇA
    .label-aliases = ALTURA SEGURA

# --- 32 and 482 ---
cycle-tool-radius = Medir o raio da ferramenta
    .nc = RAIO DA FERR.TA
    .nc-aliases = RAIO DA FERRAMENTA
    .purpose = Mede ou verifica o raio da ferramenta com o apalpador de ferramentas: com a ferramenta a rodar, ou com a ferramenta a rodar e depois navalha a navalha. O comando guarda o resultado na memória central de ferramentas TOOL.T e tem-no automaticamente em conta no fim do ciclo.
cycle-tool-radius__tnc426-430 =
    .purpose = Mede ou verifica o raio da ferramenta com o apalpador de ferramentas: com a ferramenta a rodar, ou com a ferramenta a rodar e depois navalha a navalha. O comando guarda o resultado na memória central de ferramentas TOOL.T e utiliza-o na chamada seguinte da ferramenta.
cycle-tool-radius-old = Medir o raio da ferramenta
    .nc = RAIO DA FERRAMENTA
    .nc-aliases = RAIO DA FERR.TA
    .purpose = Mede ou verifica o raio da ferramenta com o apalpador de ferramentas: com a ferramenta a rodar, ou com a ferramenta a rodar e depois navalha a navalha. O comando guarda o resultado na memória central de ferramentas TOOL.T e tem-no automaticamente em conta no fim do ciclo. Formato antigo do ciclo 482.
cycle-tool-radius-old__tnc426-430 =
    .purpose = Mede ou verifica o raio da ferramenta com o apalpador de ferramentas: com a ferramenta a rodar, ou com a ferramenta a rodar e depois navalha a navalha. O comando guarda o resultado na memória central de ferramentas TOOL.T e utiliza-o na chamada seguinte da ferramenta. Formato antigo do ciclo 482.
step-position-tool-beside-setter = O comando posiciona a ferramenta ao lado da cabeça do apalpador, com a face abaixo da aresta superior desta, à distância { $mp-setter-axis-offset } (mais o desvio adicional da longitude { $mp-setter-offset-length }, se tiver sido introduzido na tabela de ferramentas).
step-probe-rotating-tool-radially = O comando apalpa radialmente a ferramenta a rodar.
step-measure-teeth-radially = O comando determina o raio:
say-measure-radii-of-teeth = com { $q-tooth-measurement }=1, mede depois os raios de todas as navalhas por meio da orientação do cabeçote
say-radius-of-rotating-tool = com { $q-tooth-measurement }=0, o raio resulta da medição com a ferramenta a rodar
step-store-tool-radius = O comando guarda o resultado:
say-overwrite-tool-radius = com { $q-tool-check }=0, substitui o raio da ferramenta { $mp-tool-radius } em TOOL.T e coloca a 0 o valor delta { $mp-delta-radius }
say-enter-delta-radius = com { $q-tool-check }=1, compara o raio medido com o raio da ferramenta { $mp-tool-radius }, introduz o desvio, com o seu sinal, como valor delta { $mp-delta-radius } e em Q116 e bloqueia a ferramenta (estado L) se for excedida a tolerância de desgaste ou de rotura
result-tool-radius-deviation = Desvio do raio da ferramenta
note-diamond-coated-cylinders = As ferramentas cilíndricas com superfície de diamante podem ser medidas com o cabeçote parado. Para isso, defina na tabela de ferramentas o número de navalhas { $mp-teeth } como 0 e adapte o parâmetro de máquina { $mp-tool-measurement-config }. Consulte o manual da máquina.
note-diamond-coated-cylinders__itnc530 = As ferramentas cilíndricas com superfície de diamante podem ser medidas com o cabeçote parado. Para isso, defina na tabela de ferramentas o número de navalhas { $mp-teeth } como 0 e adapte o parâmetro de máquina { $mp-calibration-behaviour }. Consulte o manual da máquina.
note-two-ways-to-measure-tool = A ferramenta pode ser medida de duas formas: com a ferramenta a rodar, ou com a ferramenta a rodar e depois navalha a navalha.

# --- 33 and 483 ---
cycle-tool-complete = Medição completa da ferramenta
    .nc = MEDIR FERR.TA
    .nc-aliases = MEDIR FERRAMENTA
    .purpose = Mede ou verifica a longitude e o raio da ferramenta com o apalpador de ferramentas: com a ferramenta a rodar, ou com a ferramenta a rodar e depois navalha a navalha. O comando guarda os resultados na memória central de ferramentas TOOL.T e tem-nos automaticamente em conta no fim do ciclo.
cycle-tool-complete__tnc426-430 =
    .purpose = Mede ou verifica a longitude e o raio da ferramenta com o apalpador de ferramentas: com a ferramenta a rodar, ou com a ferramenta a rodar e depois navalha a navalha. O comando guarda os resultados na memória central de ferramentas TOOL.T e utiliza-os na chamada seguinte da ferramenta.
cycle-tool-complete-old = Medição completa da ferramenta
    .nc = MEDIR FERR.TA
    .nc-aliases = MEDIR FERRAMENTA
    .purpose = Mede ou verifica a longitude e o raio da ferramenta com o apalpador de ferramentas: com a ferramenta a rodar, ou com a ferramenta a rodar e depois navalha a navalha. O comando guarda os resultados na memória central de ferramentas TOOL.T e tem-nos automaticamente em conta no fim do ciclo. Formato antigo do ciclo 483.
cycle-tool-complete-old__tnc426-430 =
    .purpose = Mede ou verifica a longitude e o raio da ferramenta com o apalpador de ferramentas: com a ferramenta a rodar, ou com a ferramenta a rodar e depois navalha a navalha. O comando guarda os resultados na memória central de ferramentas TOOL.T e utiliza-os na chamada seguinte da ferramenta. Formato antigo do ciclo 483.
step-measure-radius-first = O comando mede a ferramenta segundo uma sequência fixa. Mede primeiro o raio, como os ciclos 32 e 482: posiciona a ferramenta ao lado da cabeça do apalpador, com a face abaixo da aresta superior desta (valores { $mp-setter-axis-offset } e { $mp-setter-offset-length }), e apalpa radialmente a ferramenta a rodar.
step-then-measure-length = Mede depois a longitude, como os ciclos 31 e 481:
step-store-radius-and-length = O comando guarda os resultados:
say-overwrite-radius-and-length = com { $q-tool-check }=0, substitui o raio da ferramenta { $mp-tool-radius } e a longitude da ferramenta { $mp-tool-length } em TOOL.T e coloca a 0 os valores delta { $mp-delta-radius } e { $mp-delta-length }
say-enter-both-delta-values = com { $q-tool-check }=1, compara os dados medidos com os de TOOL.T, introduz os desvios, com o seu sinal, como valores delta { $mp-delta-radius } e { $mp-delta-length } e em Q116 (raio) e Q115 (longitude) e bloqueia a ferramenta (estado L) se for excedida uma tolerância de desgaste ou de rotura
note-complete-measurement-saves-time = O ciclo adequa-se especialmente à primeira medição de ferramentas: em comparação com a medição da longitude e do raio em separado, poupa muito tempo.
title-first-measurement-rotating = Primeira medição com a ferramenta a rodar
title-check-teeth = Verificação com medição individual das navalhas

# --- 30 and 480 ---
cycle-calibrate-tool-probe = Calibrar o apalpador de ferramentas
    .nc = CALIBRAR TT
    .purpose = Calibra automaticamente o apalpador de ferramentas com uma ferramenta de calibração cilíndrica. O comando determina também a excentricidade da ferramenta de calibração. Guarda os valores de calibração e tem-nos em conta nas medições de ferramentas posteriores.
cycle-calibrate-tool-probe-old = Calibrar o apalpador de ferramentas
    .nc = CALIBRAR TT
    .purpose = Calibra automaticamente o apalpador de ferramentas com uma ferramenta de calibração cilíndrica. O comando determina também a excentricidade da ferramenta de calibração. Guarda os valores de calibração e tem-nos em conta nas medições de ferramentas posteriores. Formato antigo do ciclo 480.
guard-tool-call-missing__calibrate-tool-probe = Não está chamada nenhuma ferramenta. Chame a ferramenta de calibração com TOOL CALL.
guard-tool-call-missing__calibrate-tool-probe-old = Não está chamada nenhuma ferramenta. Chame a ferramenta de calibração com TOOL CALL.
step-position-calibration-tool-over-setter = O comando posiciona a ferramenta de calibração à altura segura { $q-tool-clearance-height }, mas não abaixo da zona de segurança { $mp-setter-safety-distance } acima do prato.
step-calibrate-tool-probe = O comando calibra automaticamente o apalpador com a ferramenta de calibração.
step-turn-spindle-for-centre-misalignment = A meio da calibração, o comando roda o cabeçote 180°. Assim determina também a excentricidade da ferramenta de calibração.
step-store-tool-probe-calibration = O comando guarda os valores de calibração e tem-nos em conta nas medições de ferramentas seguintes.
note-enter-calibration-tool-data = Antes de calibrar, introduza na tabela de ferramentas TOOL.T o raio exato e a longitude exata da ferramenta de calibração.
note-cylindrical-calibration-tool = Utilize como ferramenta de calibração uma peça exatamente cilíndrica, como um pino cilíndrico.
note-calibration-tool-size = O diâmetro da ferramenta de calibração deve ser superior a 15 mm, e esta deve sobressair cerca de 50 mm do mandril. A flexão é então de 0,1 µm por 1 N de força de apalpação.
note-tool-probe-position-known = A posição do apalpador no espaço de trabalho da máquina tem de estar definida nos parâmetros de máquina { $mp-setter-centre } > [0] a [2].
note-tool-probe-position-known__itnc530 = A posição do apalpador no espaço de trabalho da máquina tem de estar definida nos parâmetros de máquina { $mp-setter-centre }.0 a { $mp-setter-centre }.2.
note-tool-probe-position-known__tnc426-430 = A posição do apalpador no espaço de trabalho da máquina tem de estar definida nos parâmetros de máquina { $mp-setter-centre }.0 a { $mp-setter-centre }.2.
note-recalibrate-after-position-data-change = Depois de alterar um dos parâmetros de máquina { $mp-setter-centre } > [0] a [2], calibre de novo.
note-recalibrate-after-position-data-change__itnc530 = Depois de alterar um dos parâmetros de máquina { $mp-setter-centre }.0 a { $mp-setter-centre }.2, calibre de novo.
note-recalibrate-after-position-data-change__tnc426-430 = Depois de alterar um dos parâmetros de máquina { $mp-setter-centre }.0 a { $mp-setter-centre }.2, calibre de novo.
note-keep-fixtures-off-tool-probe = Ao calibrar, certifique-se de que não há dispositivos de fixação montados à volta do apalpador. Recomendação: deixe um espaço igual ao dobro do diâmetro da ferramenta de calibração.
note-calibration-cycle-behaviour = O funcionamento do ciclo de calibração depende do parâmetro de máquina { $mp-tool-measurement-config }. Consulte o manual da máquina.
note-calibration-cycle-behaviour__tnc320 = O fabricante da máquina define o funcionamento do ciclo de calibração. Consulte o manual da máquina.
note-calibration-cycle-behaviour__itnc530 = O funcionamento do ciclo de calibração depende do parâmetro de máquina { $mp-calibration-behaviour }. Consulte o manual da máquina.
note-calibration-cycle-behaviour__tnc426-430 = O funcionamento do ciclo de calibração depende do parâmetro de máquina { $mp-calibration-behaviour }. Consulte o manual da máquina.

# --- 484 ---
cycle-calibrate-wireless-tool-probe = Calibrar o apalpador de ferramentas sem cabo TT 449
    .nc = CALIBRAR IR TT
    .purpose = Calibra o apalpador de ferramentas de infravermelhos sem cabo TT 449. A calibração é semiautomática, porque a posição do apalpador na mesa da máquina não está definida. O comando determina também a excentricidade da ferramenta de calibração, guarda os valores de calibração e tem-nos em conta nas medições de ferramentas posteriores.
step-insert-calibration-tool = Coloque a ferramenta de calibração.
step-define-and-start-calibration = Defina e inicie o ciclo de calibração.
step-position-calibration-tool-by-hand = Posicione manualmente a ferramenta de calibração por cima do centro do apalpador e siga as instruções da janela sobreposta. Certifique-se de que a ferramenta de calibração está por cima da superfície de medição da cabeça do apalpador.
step-calibrate-wireless-tool-probe = O comando calibra de forma semiautomática o apalpador com a ferramenta de calibração.
message-calibration-tool-over-setter = Posicione a ferramenta de calibração por cima do centro do apalpador e continue.
note-wireless-calibration-by-hand = A calibração não é totalmente automática, porque a posição do apalpador na mesa da máquina não está definida.
note-recalibrate-after-move = Se a posição do apalpador na mesa mudar, calibre de novo.
note-calibration-tool-size__tnc640 = O diâmetro da ferramenta de calibração tem de ser superior a 15 mm, e esta tem de sobressair 50 mm do mandril. A flexão é então de 0,1 µm por 1 N de força de apalpação.
guard-tool-call-missing__calibrate-wireless-tool-probe = Não está chamada nenhuma ferramenta. Chame a ferramenta de calibração com TOOL CALL.
