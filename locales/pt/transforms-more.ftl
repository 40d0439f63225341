# Mirroring, scaling and tilting.

# --- 8 ---
cycle-mirroring = Espelhamento
    .nc = ESPELHAMENTO
    .purpose = Espelha o sistema de coordenadas, para que se maquine a imagem espelhada de um contorno no plano de maquinação.
step-mirror-coordinate-system = A partir da definição, o comando espelha os eixos introduzidos do sistema de coordenadas em torno do ponto zero ativo.
note-reset-mirroring = Para anular o espelhamento, programe de novo o ciclo e responda com NO ENT.
note-mirroring-in-status-display = A visualização adicional de estados mostra os eixos espelhados.
note-mirroring-and-machining-direction = Se for espelhado só um eixo, a direção de maquinação da ferramenta muda; isto não se aplica aos ciclos SL. Se forem espelhados dois eixos, a direção de maquinação mantém-se.
note-mirroring-depends-on-datum = O resultado do espelhamento depende da posição do ponto zero. Se o ponto zero ficar sobre o contorno a espelhar, o elemento é espelhado diretamente no ponto zero. Se ficar fora do contorno, o elemento é também deslocado.
note-mirroring-and-milling-cycles = Se for espelhado só um eixo, a direção de maquinação muda nos ciclos de fresar com os números 2xx. Exceção: o ciclo 208, em que se mantém o sentido de rotação definido no ciclo.
note-mirroring-and-thread-direction = O sentido de uma rosca muda se um ciclo de fresar roscas for combinado com o espelhamento de só um eixo.

# --- 11 ---
cycle-scaling = Fator de escala
    .nc = FATOR DE ESCALA
    .purpose = Amplia ou reduz contornos dentro de um programa, por exemplo para ter em conta fatores de contração e medidas excedentes.
step-scale-coordinate-system = A partir da definição, o comando multiplica as coordenadas e os raios pelo fator.
note-reset-scaling = Para anular o fator de escala, programe de novo o ciclo com o fator 1.
note-scaling-in-status-display = A visualização adicional de estados mostra o fator de escala ativo.
note-scaling-acts-on = O fator atua simultaneamente nos três eixos de coordenadas e nas medidas introduzidas em ciclos.
note-shift-datum-before-scaling = Antes de ampliar ou reduzir, o ponto zero deve ser deslocado para uma aresta ou uma esquina do contorno.
note-scaling-limits = Ampliação: fator maior do que 1 até 99,999999. Redução: fator menor do que 1 até 0,000001.

# --- 26 ---
cycle-axis-scaling = Fator de escala específico do eixo
    .nc = FATOR ESCALA ESPECÍF. EIXO
    .purpose = Tem em conta fatores de contração e medidas excedentes com um fator próprio em cada eixo.
step-scale-each-axis = A partir da definição, o comando dilata ou contrai o contorno em cada eixo introduzido segundo o seu fator, a partir do centro ou em direção a ele.
note-reset-axis-scaling = Para anular os fatores, programe de novo o ciclo com o fator 1 para o respetivo eixo.
note-arcs-need-equal-factors = Dois eixos em que estejam programados arcos não podem ser dilatados ou contraídos com fatores diferentes.
note-factor-for-each-axis = Para cada eixo de coordenadas pode introduzir-se um fator de escala próprio.
note-centre-for-all-factors = Além disso, podem programar-se as coordenadas de um centro para todos os fatores de escala.
note-scaled-from-centre = O contorno é dilatado a partir do centro ou contraído em direção a ele, e não necessariamente a partir do ponto zero atual e em direção a ele, como no ciclo 11.

# --- 19 ---
cycle-working-plane = Plano de maquinação
    .nc = PLANO DE MAQUINAÇÃO
    .purpose = Define a posição do plano de maquinação, isto é, a posição do eixo da ferramenta em relação ao sistema de coordenadas da máquina, introduzindo ângulos de inclinação, em máquinas com cabeças ou mesas basculantes.
step-tilt-working-plane = A partir da definição, o comando inclina o plano de maquinação em torno do ponto zero ativo.
step-compute-rotary-positions = Se a posição for programada com ângulos espaciais, o comando calcula as posições angulares dos eixos basculantes necessárias para isso e guarda-as nos parâmetros Q120 (eixo A) a Q122 (eixo C). Se houver duas soluções, escolhe o percurso mais curto a partir da posição zero dos eixos rotativos.
step-position-rotary-axes = Se o fabricante da máquina o tiver previsto, o comando posiciona automaticamente os eixos rotativos. Caso contrário, posicione-os numa frase L própria depois da definição.
step-move-all-axes-after-tilting = Desloque todos os eixos para que a correção atue em todos: ela atua num eixo logo que esse eixo se desloca no sistema inclinado.
result-tilted-position-of-a = Posição calculada do eixo A
result-tilted-position-of-b = Posição calculada do eixo B
result-tilted-position-of-c = Posição calculada do eixo C
note-tilting-is-adapted-by-builder = O fabricante da máquina adapta as funções de inclinação do plano de maquinação ao comando e à máquina. Em algumas cabeças (mesas) basculantes, determina se os ângulos programados no ciclo são considerados coordenadas dos eixos rotativos ou componentes angulares de um plano inclinado. Consulte o manual da máquina.
note-builder-decides-on-rotary-positioning = O fabricante da máquina determina se o ciclo posiciona automaticamente os eixos rotativos ou se estes têm de ser posicionados no programa. Consulte o manual da máquina.
note-two-ways-to-tilt = A posição do plano de maquinação pode ser definida de duas formas: introduzindo diretamente as posições dos eixos basculantes ou por meio de até três rotações (ângulos espaciais) do sistema de coordenadas da máquina. Para determinar os ângulos espaciais, imagine um corte perpendicular ao plano de maquinação inclinado e observe-o a partir do eixo em torno do qual se roda. Bastam dois ângulos espaciais para definir qualquer posição da ferramenta no espaço.
note-tilted-movements-depend-on-description = A posição do sistema de coordenadas inclinado, e com ela os movimentos no sistema inclinado, depende da forma como o plano inclinado é descrito.
note-tilting-sequence = A sequência das rotações a partir das quais o comando calcula o plano é fixa: primeiro o eixo A, depois o eixo B e por último o eixo C.
note-tilting-overrides-manual-menu = Se a inclinação para a execução do programa tiver sido ativada no modo de funcionamento Manual, o ciclo substitui o ângulo introduzido nesse menu.
note-define-all-spatial-angles = Os valores de eixos rotativos não programados são sempre considerados inalterados. Por isso, defina sempre os três ângulos espaciais, mesmo que um ou vários deles sejam 0.
note-tilting-cancels-look-ahead = Se o ciclo for utilizado com M120 ativa, o comando anula a correção de raio e, com ela, M120.
note-reset-tilt-angles = Para anular os ângulos de inclinação, defina de novo o ciclo com 0° para todos os eixos rotativos. Defina-o depois outra vez e responda à pergunta do diálogo com NO ENT: isto desliga a função.
note-position-rotary-axes-by-hand = Quando o ciclo não posiciona automaticamente os eixos rotativos: com ângulos de eixo, introduza os valores dos eixos diretamente na frase L; com ângulos espaciais, utilize os parâmetros Q120 (eixo A), Q121 (eixo B) e Q122 (eixo C) escritos pelo ciclo.
note-use-computed-rotary-positions = Ao posicionar pelo programa, utilize sempre as posições dos eixos rotativos guardadas em Q120 a Q122.
note-avoid-reduced-angles = Evite funções como M94 (visualização reduzida dos ângulos), para que, em várias chamadas, as posições reais e nominais dos eixos rotativos não deixem de coincidir.
note-automatic-rotary-positioning = Quando o ciclo posiciona automaticamente os eixos rotativos: só podem ser posicionados eixos regulados; além dos ângulos de inclinação, têm de ser introduzidos na definição do ciclo uma distância de segurança e um avanço para o posicionamento; só podem ser utilizadas ferramentas previamente ajustadas (tem de estar definida a longitude completa da ferramenta); a posição da ponta da ferramenta em relação à peça mantém-se quase inalterada ao inclinar; o comando inclina com o último avanço programado, e o maior avanço que se pode atingir depende da complexidade da cabeça (mesa) basculante.
note-positions-in-tilted-system = Depois de ativado o ciclo, as posições visualizadas (nominal e real) e o ponto zero da visualização adicional de estados referem-se ao sistema de coordenadas inclinado. Por isso, logo depois da definição, a posição visualizada pode diferir das últimas coordenadas programadas antes do ciclo.
note-limit-switches-in-tilted-system = No sistema de coordenadas inclinado, o comando verifica apenas os interruptores de fim de curso dos eixos que se deslocam. Pode emitir um aviso de erro.
note-positioning-in-tilted-system = Com M130 também se podem alcançar, no sistema inclinado, posições que se refiram ao sistema de coordenadas não inclinado. O posicionamento com frases de reta referidas ao sistema de coordenadas da máquina (frases com M91 ou M92) também é possível com o plano de maquinação inclinado, com limitações: não há correção da longitude nem correção da geometria da máquina, e a correção de raio não é permitida.
note-tilting-with-other-transforms = Uma deslocação do ponto zero antes do ciclo desloca o sistema de coordenadas da máquina; uma deslocação do ponto zero depois dele desloca o sistema de coordenadas inclinado.
note-reset-in-reverse-order = Importante: anule os ciclos pela ordem inversa da sua definição. Ative a deslocação do ponto zero, depois a inclinação e a seguir a rotação; maquine a peça; anule depois a rotação, a inclinação e a deslocação do ponto zero.
note-datum-setting-with-tilting = O ponto de referência pode ser memorizado manualmente por toque, de forma controlada com um apalpador 3D HEIDENHAIN ou automaticamente com um apalpador 3D HEIDENHAIN.
title-rotary-axes-by-hand = Eixos rotativos posicionados no programa
title-rotary-axes-by-control = Eixos rotativos posicionados pelo comando
