# Cycles that digitize a part with a touch probe.

# --- 5 and 15 ---
cycle-digitize-range = Campo
    .nc = CAMPO
    .nc-aliases = ÁREA
    .purpose = Define o campo paralelepipédico em que os ciclos de digitalização registam uma peça, o ficheiro dos dados de digitalização e a altura segura.
cycle-digitize-range-from-points = Campo a partir de tabela de pontos
    .nc = CAMPO
    .nc-aliases = ÁREA
    .purpose = Define um campo de qualquer forma para a digitalização com um apalpador analógico: uma tabela de pontos define o seu limite no plano de maquinação. O ciclo define também o ficheiro dos dados de digitalização e a altura segura.
step-remember-digitizing-range = O comando memoriza o campo entre o ponto MIN e o ponto MAX, a altura segura e o nome do ficheiro para os ciclos de digitalização seguintes.
step-remember-digitizing-range-from-points = O comando memoriza o campo, cujo limite é definido no plano de maquinação pelos pontos da tabela e no eixo do apalpador pelos pontos MIN e MAX, a altura segura e o nome do ficheiro para os ciclos de digitalização seguintes.
table-digitizing-points = Tabela de pontos para digitalização
title-range-with-rotary-axis-a = Campo com eixo rotativo A, para o ciclo 18
title-range-for-meander-with-rotary-axis = Campo com eixo rotativo A, para o ciclo 6
title-range-with-rotary-axis-c = Campo com eixo rotativo C, para o ciclo 7

# --- 6 and 16 ---
cycle-digitize-meander = Meandro
    .nc = MEANDRO
    .purpose = Digitaliza em meandro uma peça 3D com um apalpador digital.
cycle-digitize-meander-analog = Meandro (apalpador analógico)
    .nc = MEANDRO
    .purpose = Digitaliza em meandro uma peça 3D com um apalpador analógico.
step-approach-digitizing-start = O comando desloca automaticamente o apalpador para o ponto de partida, primeiro no eixo da ferramenta para a altura segura, depois no plano de maquinação para o ponto MIN do campo do ciclo 5 ou do ciclo 15.
step-approach-workpiece-downwards = O apalpador desloca-se para a peça na direção negativa do eixo da ferramenta. O comando guarda as coordenadas da posição em que o apalpador toca na peça.
step-scan-meander = A partir do ponto MIN, o apalpador percorre a peça na direção positiva do eixo das linhas até ao limite do campo, desvia-se no valor da distância entre linhas e regressa pela linha seguinte; na outra extremidade, volta a desviar-se no mesmo valor. O processo repete-se até estar digitalizado todo o campo.
step-return-to-clearance-after-digitizing = No fim, o apalpador regressa à altura segura.
title-meander-with-rotary-axis = Meandro com um eixo rotativo como direção das linhas

# --- 7 and 17 ---
cycle-digitize-contour-lines = Linhas de nível
    .nc = LINHAS DE NÍVEL
    .nc-aliases = LINHA DE NÍVEL
    .purpose = Digitaliza uma peça 3D nível a nível, em linhas de nível, com um apalpador digital.
cycle-digitize-contour-lines-analog = Linhas de nível (apalpador analógico)
    .nc = LINHAS DE NÍVEL
    .nc-aliases = LINHA DE NÍVEL
    .purpose = Digitaliza uma peça 3D nível a nível, em linhas de nível, com um apalpador analógico.
step-approach-contour-line-start = O comando desloca automaticamente o apalpador para o ponto de partida, primeiro no eixo da ferramenta para a altura segura, depois no plano de maquinação para as coordenadas que o ciclo define. A coordenada do ponto de partida no eixo da ferramenta é a do ponto MIN do ciclo 5 se a distância entre linhas for positiva, a do ponto MAX se for negativa.
step-approach-workpiece-in-direction = O apalpador desloca-se para a peça na direção de aproximação programada. O comando guarda as coordenadas da posição em que o apalpador toca na peça.
step-scan-contour-line = Depois de guardado o primeiro ponto, o apalpador percorre a peça em volta, a altura constante, até alcançar de novo o primeiro ponto.
step-go-on-by-line-spacing = Desvia-se depois, no valor da distância entre linhas, na direção positiva ou negativa do eixo da ferramenta e percorre de novo a peça em volta, a altura constante, até ao primeiro ponto guardado a esta altura. O processo repete-se até estar digitalizado todo o campo.
step-return-to-contour-line-start = No fim, o apalpador desloca-se para a altura segura e regressa ao ponto de partida programado.

# --- 8 and 18 ---
cycle-digitize-lines = Linha
    .nc = LINHA
    .nc-aliases = LINHAS
    .purpose = Digitaliza uma peça 3D linha a linha com um apalpador digital.
cycle-digitize-lines-analog = Linha (apalpador analógico)
    .nc = LINHA
    .nc-aliases = LINHAS
    .purpose = Digitaliza uma peça 3D linha a linha com um apalpador analógico.
step-approach-line-start = O comando desloca automaticamente o apalpador para o ponto de partida, primeiro no eixo da ferramenta para a altura segura, depois no plano de maquinação. O ponto de partida fica no limite positivo ou negativo do campo na direção das linhas programada (consoante a direção da digitalização) e tem, de resto, as coordenadas do ponto MIN do campo do ciclo 5 ou do ciclo 15.
step-scan-line = O apalpador percorre a peça na direção positiva do eixo selecionado do plano de maquinação até ao limite do campo.
step-return-for-next-line = Desloca-se depois para a altura segura e volta em avanço rápido ao princípio da linha seguinte. Aí, desloca-se em avanço rápido na direção negativa do eixo da ferramenta até à altura para a redução do avanço e, daí, com o avanço de apalpação até tocar na peça. O processo repete-se até estar digitalizado todo o campo.
title-lines-with-rotary-axis = Linha com eixo rotativo, sem avanço para a primeira linha

# --- guards ---
guard-digitizing-with-transformation = Está ativa uma conversão de coordenadas. Durante a digitalização não pode estar ativa nenhuma.

# --- notes: programming ---
note-range-before-digitizing = No programa de maquinação, defina um ciclo de digitalização CAMPO (5 ou 15) antes do ciclo que digitaliza.
note-range-before-contour-lines = No programa de maquinação, defina o ciclo de digitalização 5 CAMPO antes do ciclo de digitalização LINHAS DE NÍVEL.
note-not-with-contour-lines = O ciclo { $cycle } não pode ser combinado com o ciclo de digitalização 17 LINHAS DE NÍVEL.
note-not-with-range-from-points = O ciclo { $cycle } não pode ser combinado com o ciclo de digitalização 15 CAMPO.
note-no-transformation-while-digitizing = Durante a digitalização não pode estar ativa nenhuma conversão de coordenadas nem nenhuma rotação básica.
note-analog-probe-only = Só para apalpadores analógicos.
note-complete-path-of-data = No menu da interface de dados, introduza o caminho completo em que o comando guarda os dados de digitalização.
note-digitizing-not-in-iso = Os ciclos de digitalização não estão disponíveis em DIN/ISO.

# --- notes: what is needed ---
note-digitizing-needs-option = A digitalização precisa de um apalpador, do módulo de software Opção Digitalização e, se necessário, do software de avaliação SUSA da HEIDENHAIN para processar os dados de digitalização do ciclo MEANDRO.
note-calibrate-before-digitizing = Calibre o apalpador antes de digitalizar.
note-digitizing-axes = Os ciclos de digitalização programam-se com os eixos principais X, Y e Z e com os eixos rotativos A, B e C.
note-digitizing-speed-touch-trigger = Com um apalpador digital, a velocidade de digitalização situa-se entre 200 e 800 mm/min, com uma distância entre pontos de 1 mm.
note-digitizing-speed-analog = Com um apalpador analógico, é o ciclo que define a velocidade de digitalização, até 3000 mm/min.

# --- notes: how it is digitized ---
note-meander-for-flat-parts = A digitalização em meandro adequa-se sobretudo a peças relativamente planas.
note-meander-for-evaluation-software = Digitalize em meandro se os dados de digitalização tiverem de ser processados com o software de avaliação SUSA da HEIDENHAIN.
note-contour-lines-for-steep-parts = A digitalização em linhas de nível adequa-se especialmente a peças irregulares (como moldes de injeção) ou quando se quer registar uma única linha de nível (como o contorno de uma placa de came).
note-range-for-contour-lines = No eixo do apalpador, o campo tem de ficar abaixo do ponto mais alto da peça em, pelo menos, o raio do apalpador. No plano de maquinação, o campo tem de exceder a peça em, pelo menos, o raio do apalpador.
note-single-contour-line = Para digitalizar uma única linha de nível, introduza 0 para a distância entre linhas e, se o ciclo a pedir, para a distância mínima entre linhas.
note-lines-for-one-milling-direction = Este ciclo utiliza-se sobretudo para peças relativamente planas cujos dados de digitalização devam ser fresados sempre em sentido sincronizado ou sempre em sentido contrário, sem software de avaliação.
note-lines-for-rotary-axes = Com um apalpador analógico, este ciclo utiliza-se sobretudo para digitalizar com um eixo rotativo.
note-normal-retraction-recommended = Percurso recomendado na direção normal às linhas: entre metade da distância entre pontos e a distância entre pontos. Quanto menor for a esfera do apalpador, maior deve ser o percurso.
note-climb-or-up-cut-by-direction = A direção da digitalização determina também se a fresagem posterior se faz em sentido sincronizado ou em sentido contrário.
note-sudden-changes-of-direction = O comando guarda as posições em que a direção muda bruscamente, até 1000 numa linha. Na linha seguinte, reduz automaticamente o avanço de apalpação quando o apalpador se aproxima de uma dessas posições. Isto melhora os resultados.
note-feed-reduction-only-up-to-1000 = A redução do avanço só funciona se uma linha não tiver mais de 1000 pontos em que o avanço tenha de ser reduzido.
note-corner-reduction-entered-by-control = Responda com NO ENT à pergunta sobre a redução do avanço nas esquinas. O comando introduz automaticamente um valor.

# --- notes: rotary axes ---
note-rotary-axes-touch-trigger = Com um apalpador digital, os eixos rotativos podem ser digitalizados em meandro (ciclo 6), por linhas (ciclo 8) ou em linhas de nível (ciclo 7). Em qualquer dos casos, introduza o eixo rotativo no ciclo CAMPO. O comando interpreta os valores dos eixos rotativos como graus.
note-rotary-axes-analog = Com um apalpador analógico, os eixos rotativos só podem ser digitalizados com o ciclo 18 LINHA. O eixo rotativo é definido como eixo das colunas.
note-digitizing-range-with-rotary-axis = Para digitalizar com um eixo rotativo, introduza o eixo rotativo no campo. O comando interpreta os seus valores como graus. O ficheiro dos dados de digitalização contém os eixos que o campo define; não é emitida nenhuma BLK FORM, porque os eixos rotativos não se podem representar graficamente.
note-digitizing-display-of-rotary-axis = Na digitalização e na fresagem, o modo de visualização do eixo rotativo tem de ser o mesmo (reduzido a um valor inferior a 360° ou não reduzido).
note-meander-with-rotary-axis = Se a direção das linhas for um eixo linear (como X), o comando desloca no fim de cada linha o eixo rotativo (como A) do ciclo CAMPO no valor da distância entre linhas; o apalpador oscila então, por exemplo, no plano Z/X. Se a direção das linhas for um eixo rotativo (como A), o comando desloca no fim de cada linha o eixo linear (como X) no valor da distância entre linhas; o apalpador oscila então, por exemplo, no plano Z/A.
note-contour-lines-with-rotary-axis = O ponto de partida é definido num eixo linear (como X) e num eixo rotativo (como C), e o mesmo vale para a sequência de chegada. O apalpador oscila então, por exemplo, no plano X/C. Isto também serve para máquinas que só têm dois eixos lineares (como Z e X) e um eixo rotativo (como C). O sentido de rotação definido na sequência de chegada vale para todas as linhas de nível.
note-lines-with-rotary-axis = Se a direção das linhas for um eixo linear (como X), o comando desloca no fim de cada linha o eixo rotativo (como A) do ciclo CAMPO no valor da distância entre linhas.

# --- notes: the data ---
note-digitized-data-on-disk = O comando guarda as posições registadas diretamente no disco duro. A função de interface PRINT determina o diretório.
note-digitized-data-with-same-radius = Se os dados de digitalização forem fresados com uma ferramenta cujo raio seja o da haste de apalpação, podem ser executados diretamente com o ciclo 30.
note-block-form-in-data = O comando insere uma BLK FORM no ficheiro dos dados de digitalização. Para isso, aumenta o bloco definido pelo ciclo CAMPO no dobro do valor de { $mp-stylus-deflection-depth } (em apalpadores analógicos).
note-digitized-data-in-programs = Os dados de digitalização podem ser executados com o ciclo de maquinação 30, se forem necessárias várias passagens (só dados dos ciclos MEANDRO e LINHA), ou com um programa auxiliar, só para acabamento: defina uma ferramenta com o raio da haste de apalpação, chame-a, defina o avanço, as funções M e a correção de raio R0 e chame o ficheiro com CALL PGM.
note-digitized-data-size = O ficheiro dos dados de digitalização pode ter, no máximo, 1500 MByte, que é o espaço no disco duro do comando quando não há nenhum programa guardado.

# --- notes: point tables ---
note-point-table-recording = Os pontos registam-se no modo de funcionamento Posicionamento com introdução manual com o apalpador analógico, para o que é necessária a opção de software de digitalização com apalpador analógico. A softkey PNT seleciona uma tabela de pontos. Os pontos registam-se manualmente (TEACH-IN: desviar a haste de apalpação à mão e aceitar a posição real) ou automaticamente (a uma distância entre pontos introduzida, enquanto se desloca à mão a haste de apalpação em volta da peça). Pode introduzir-se um avanço com que o apalpador reage a um desvio, e podem escolher-se para cada eixo as coordenadas a guardar. Só as coordenadas do plano de maquinação definem o campo.
note-point-table-size = Uma tabela de pontos que sirva de campo pode conter, no máximo, 893 pontos. Para que isso seja supervisionado, coloque a softkey RANGE/CONTOUR DATA em RANGE.
note-point-table-closed = Os pontos são unidos por retas, que delimitam o campo. O comando une automaticamente o último ponto da tabela ao primeiro.
