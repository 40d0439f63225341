# Coordinate transformations.

# --- common ---
form-coordinates = Coordenadas do ponto zero
form-table = Linha de uma tabela de pontos zero
note-transform-acts-until-reset = Uma conversão de coordenadas atua a partir da sua definição; não é chamada. Permanece ativa até ser anulada ou definida de novo.
note-transform-reset-ways = Uma conversão de coordenadas anula-se definindo de novo o ciclo com os valores do estado básico (por exemplo, fator de escala 1,0), com as funções auxiliares M2 e M30 ou a frase END PGM (dependendo do parâmetro de máquina { $mp-clear-mode }) e selecionando outro programa.

# --- 7 ---
cycle-datum-shift = Deslocação do ponto zero
    .nc = PONTO ZERO
    .purpose = Desloca o ponto zero, para que as maquinações possam ser repetidas em qualquer posição da peça. Depois da definição, todas as coordenadas se referem ao novo ponto zero. A deslocação é indicada no programa ou retirada de uma tabela de pontos zero, por exemplo para maquinações que se repetem em várias posições ou para uma deslocação que é necessária com frequência.
step-shift-datum = O comando desloca o ponto zero:
say-shift-by-table-row = com um número de linha: nos valores dessa linha da tabela de pontos zero ativa
say-shift-by-coordinates = com coordenadas: em cada eixo programado, para a coordenada indicada; os valores absolutos referem-se ao ponto zero da peça, os incrementais ao último ponto zero válido
note-reset-datum-shift = Para anular a deslocação do ponto zero, programe numa nova definição do ciclo uma deslocação para as coordenadas X=0, Y=0 etc. ou chame da tabela de pontos zero uma deslocação para as coordenadas X=0, Y=0 etc.
note-rotary-axes-may-be-shifted = Também podem ser introduzidos eixos rotativos.
note-datum-shift-in-status-display = A visualização adicional de estados mostra a deslocação do ponto zero em cada eixo.
note-datum-table-refers-to-preset = Perigo de colisão! Os pontos zero de uma tabela de pontos zero referem-se sempre e exclusivamente ao preset atual.
note-select-datum-table-in-program = Se os pontos zero forem retirados de uma tabela de pontos zero, ative no programa a tabela pretendida com a função SEL TABLE, numa frase antes deste ciclo. A tabela permanece ativa até que seja selecionada outra tabela de pontos zero com SEL TABLE ou com PGM MGT. Para programar SEL TABLE, prima a tecla PGM CALL e a softkey da tabela de pontos zero, introduza o caminho completo da tabela ou selecione o ficheiro com uma softkey e confirme com a tecla END.
note-select-datum-table-before-run = Sem SEL TABLE, a tabela de pontos zero pretendida tem de ser ativada com a gestão de ficheiros antes do teste ou da execução do programa (isto vale também para o gráfico de programação): no modo de funcionamento Teste do programa fica com o estado S, num modo de funcionamento de execução do programa com o estado M.
note-datum-table-is-absolute = Os valores das coordenadas das tabelas de pontos zero atuam apenas como valores absolutos.
note-datum-table-rows-at-end = Só podem ser acrescentadas linhas novas no fim da tabela de pontos zero.
note-datum-table-name-begins-with-letter = O nome de ficheiro de uma nova tabela de pontos zero tem de começar por uma letra.
note-save-datum-table-changes = Depois de modificar um valor numa tabela de pontos zero, guarde a modificação com a tecla ENT. Caso contrário, ela não é tida em conta na execução do programa.
note-edit-datum-table = Uma tabela de pontos zero edita-se no modo de funcionamento Memorização/Edição do Programa: chame a gestão de ficheiros com a tecla PGM MGT, mostre com as softkeys os ficheiros do tipo .D e selecione uma tabela ou introduza um novo nome de ficheiro. Com as softkeys é possível ir para o princípio, o fim, a página seguinte ou anterior, ou o princípio ou o fim de uma linha, inserir uma ou várias linhas no fim, apagar uma linha, procurar, e copiar e inserir um valor. Para sair da tabela, mostre outro tipo de ficheiro na gestão de ficheiros e selecione o ficheiro pretendido.
note-datum-table-columns = Se não se pretender nenhum ponto zero para um eixo ativo, apague a sua introdução com a tecla DEL. As propriedades das colunas podem ser editadas depois de introduzido o código 555343 no menu MOD; a softkey EDITAR FORMATO mostra então as colunas com as suas propriedades. As modificações só valem para a tabela aberta.
note-datum-row-in-status-display = A visualização adicional de estados mostra o nome e o caminho da tabela de pontos zero ativa, o número do ponto zero ativo e o seu comentário da coluna DOC.

# --- 10 ---
cycle-rotation = Rotação
    .nc = ROTAÇÃO
    .purpose = Roda, dentro de um programa, o sistema de coordenadas no plano de maquinação em torno do ponto zero ativo.
step-rotate-coordinate-system = O comando roda o sistema de coordenadas no ângulo programado, em torno do ponto zero ativo. Um ângulo incremental soma-se ao ativo.
step-cancel-radius-compensation = O comando anula uma correção de raio ativa.
step-move-both-axes = Desloque os dois eixos do plano de maquinação para ativar a rotação.
note-reset-rotation = Para anular a rotação, programe de novo o ciclo com o ângulo 0°.
note-reference-axis-of-rotation = Eixo de referência do ângulo: eixo X no plano X/Y, eixo Y no plano Y/Z, eixo Z no plano Z/X.
note-acts-in-manual-data-input = O ciclo atua também no modo de funcionamento Posicionamento com introdução manual.
note-rotation-in-status-display = A visualização adicional de estados mostra o ângulo de rotação ativo.
note-program-radius-compensation-again = A definição do ciclo anula uma correção de raio ativa. Programe-a de novo, se necessário.

# --- 247 ---
cycle-activate-preset = Memorização do ponto de referência
    .nc = MEMORIZAR PONTO REF
    .purpose = Ativa um preset da tabela de presets como novo ponto de referência.
step-activate-preset = O comando ativa o preset { $q-preset-number } da tabela de presets como ponto de referência.
step-cancel-transforms-of-preset = Anula a deslocação do ponto zero, o espelhamento, a rotação, o fator de escala e o fator de escala específico do eixo.
note-coordinates-refer-to-new-preset = Depois da definição, todas as coordenadas e deslocações do ponto zero (absolutas e incrementais) se referem ao novo preset.
note-preset-cancels-transforms = Ao ativar um ponto de referência da tabela de presets, o comando anula a deslocação do ponto zero, o espelhamento, a rotação, o fator de escala e o fator de escala específico do eixo.
note-preset-zero = O preset número 0 (linha 0) ativa o ponto de referência memorizado manualmente em último lugar no modo de funcionamento Manual.
note-preset-not-in-test-run = O ciclo não atua no modo de funcionamento Teste do programa.
note-preset-in-status-display = A visualização de estados mostra o número do preset ativo a seguir ao símbolo do ponto de referência; a visualização adicional de estados (visualização de posições) mostra-o a seguir ao ponto de referência.
