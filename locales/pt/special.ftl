# Special functions.

# --- 9 ---
cycle-dwell = Tempo de espera
    .nc = TEMPO DE ESPERA
    .purpose = Detém a execução do programa durante o tempo de espera, por exemplo para a rotura de apara.
step-dwell-for-programmed-time = O comando detém a execução do programa durante o tempo de espera programado.
note-dwell-acts-from-definition = O ciclo atua a partir da sua definição no programa.
note-dwell-keeps-modal-states = Os estados modais, como a rotação do cabeçote, não são afetados.

# --- 12 ---
cycle-program-call = Chamada de programa
    .nc = PGM CALL
    .purpose = Equipara a um ciclo de maquinação qualquer programa, por exemplo um ciclo de furar especial ou um módulo geométrico. O programa é então chamado como um ciclo.
step-call-program-as-cycle = Na chamada do ciclo, o comando executa o programa.
note-program-becomes-cycle = Introduza o nome do programa a chamar, se necessário com o caminho; ou ative a seleção de ficheiros com a softkey SELECIONAR e selecione o programa.
note-called-program-on-hard-disk = O programa chamado tem de estar guardado no disco duro do comando.
note-called-program-in-same-directory = Se só for introduzido o nome do programa, este tem de estar no mesmo diretório do programa que o chama.
note-called-program-with-path = Se o programa não estiver no mesmo diretório do programa que o chama, introduza o caminho completo.
note-called-iso-program = Para fazer de um programa DIN/ISO um ciclo, introduza o tipo de ficheiro .I a seguir ao nome do programa.
note-q-parameters-act-globally = Na chamada de um programa com este ciclo, os parâmetros Q atuam sempre de forma global. Por isso, as modificações de parâmetros Q no programa chamado podem afetar o programa que o chama.
note-ways-to-call-the-program = Chame o programa com CYCL CALL (frase própria), com M99 (numa frase) ou com M89 (executado depois de cada frase de posicionamento).
title-program-50-as-cycle = Programa 50 como ciclo, chamado com M99

# --- 13 ---
cycle-spindle-orientation = Orientação do cabeçote
    .nc = ORIENTAÇÃO
    .purpose = Define o ângulo para o qual o comando roda o cabeçote principal da máquina-ferramenta.
step-keep-orientation-angle = O comando memoriza o ângulo para a orientação seguinte do cabeçote.
step-program-m19-or-m20 = Programe M19 ou M20 (consoante a máquina): o comando posiciona então o cabeçote no ângulo definido no ciclo.
note-prepare-for-spindle-orientation = O fabricante da máquina tem de preparar a máquina e o comando.
note-orientation-is-needed-for = A orientação do cabeçote é necessária, por exemplo, em sistemas de troca de ferramenta com uma posição de troca definida e para alinhar as janelas de emissão e receção de apalpadores 3D com transmissão por infravermelhos.
note-orientation-by-m19-or-m20 = O comando posiciona o cabeçote no ângulo definido no ciclo quando é programado M19 ou M20 (consoante a máquina).
note-orientation-without-cycle = Se M19 ou M20 for programado sem este ciclo antes, o comando posiciona o cabeçote principal num ângulo determinado pelo fabricante da máquina (ver o manual da máquina).
note-orientation-used-by-cycles = Os ciclos de maquinação 202, 204 e 209 utilizam internamente este ciclo. Se necessário, programe-o de novo depois de um deles.

# --- 32 ---
cycle-tolerance = Tolerância
    .nc = TOLERÂNCIA
    .purpose = Influencia o resultado da maquinação a alta velocidade quanto a exatidão, qualidade da superfície e velocidade, desde que o comando tenha sido adaptado à máquina.
step-smooth-contour = O comando alisa o contorno entre quaisquer elementos de contorno, corrigidos ou não. A ferramenta desloca-se assim continuamente sobre a superfície da peça e poupa a mecânica da máquina.
step-reduce-feed-to-run-smoothly = Se necessário, o comando reduz o avanço programado, de modo que o programa seja sempre executado sem solavancos à maior velocidade possível.
note-prepare-for-tolerance = O fabricante da máquina tem de preparar a máquina e o comando.
note-preset-tolerance-by-builder = O alisamento provoca um desvio do contorno. O fabricante da máquina determinou o desvio (valor de tolerância) num parâmetro de máquina. O ciclo altera o valor de tolerância predefinido e seleciona outros ajustes de filtro, desde que o fabricante da máquina utilize estas possibilidades.
note-tolerance-is-always-used = Mesmo que o comando não reduza a velocidade, utiliza sempre a tolerância definida. Quanto maior for a tolerância, mais depressa o comando pode deslocar os eixos.
note-tolerance-on-arcs = A tolerância definida no ciclo atua também nos movimentos em arco de círculo.
note-chord-error-of-cam = A influência mais importante ao criar programas NC com um sistema CAM é o erro de corda S que aí se pode definir. Determina a distância máxima entre os pontos de um programa NC criado por um pós-processador. Se o erro de corda for igual ou inferior ao valor de tolerância T do ciclo, o comando pode alisar os pontos do contorno, a não ser que ajustes especiais da máquina limitem o avanço programado.
note-best-smoothing = O alisamento é melhor se o valor de tolerância do ciclo ficar entre 1,1 e 2 vezes o erro de corda do sistema CAM.
note-very-small-tolerance = Com valores de tolerância muito pequenos, a máquina já não consegue maquinar o contorno sem solavancos. A causa não é a falta de capacidade de cálculo do comando: este percorre as transições do contorno com quase total exatidão e pode ter de reduzir consideravelmente a velocidade de deslocação.
note-tolerance-is-def-active = O ciclo fica ativo logo que é definido no programa.
note-reset-tolerance = O comando anula o ciclo se este for definido de novo e se se responder com NO ENT à pergunta sobre o valor de tolerância, ou se for selecionado outro programa com a tecla PGM MGT. Depois da anulação volta a estar ativa a tolerância predefinida por parâmetro de máquina.
note-unit-of-tolerance = O comando considera o valor de tolerância T introduzido em milímetros num programa em milímetros e em polegadas num programa em polegadas.
note-tolerance-alone-adds-zeros = Se for lido um programa que contenha apenas o valor de tolerância T como parâmetro do ciclo, o comando acrescenta, se necessário, os outros dois parâmetros com o valor 0.
note-tolerance-changes-circle-diameter = Ao aumentar a tolerância, o diâmetro dos movimentos circulares, em geral, diminui. Se na máquina estiver ativo um filtro HSC (se necessário, pergunte ao fabricante da máquina), o círculo também pode ficar maior.
note-tolerance-in-status-display = Se o ciclo estiver ativo, a visualização adicional de estados mostra os seus parâmetros no separador CYC.
