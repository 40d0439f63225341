# Contour, cylinder surface and engraving cycles.

# --- common ---
step-retract-to-contour-clearance-height = A ferramenta recua para a altura segura com o avanço { $q-contour-retraction-feed } ou, se este for 0, com { $q-roughing-feed }.
step-leave-to-contour-clearance-height = A ferramenta desloca-se para a altura segura.
until-contour-depth-reached = seja atingida a profundidade programada
until-parts-of-contour-cleared = estejam maquinadas todas as áreas separadas do contorno
note-contour-element-limit = A memória para um ciclo SL é limitada. Num ciclo SL podem programar-se, no máximo, 16384 elementos de contorno.
note-sign-of-milling-depth = O sinal da profundidade de fresagem determina a direção da maquinação. Com a profundidade 0, o comando não executa o ciclo.
note-both-axes-after-contour-cycle = Perigo de colisão! Depois de um ciclo SL, programe o primeiro movimento no plano de maquinação com as duas coordenadas, por exemplo L X+80 Y+0 R0 FMAX.
note-contour-cycle-properties = Antes de cada ciclo, o comando posiciona automaticamente a ferramenta à distância de segurança. Cada nível é fresado sem levantar a ferramenta; as ilhas são contornadas lateralmente. O raio das esquinas interiores pode ser programado: a ferramenta não se detém aí nem deixa marcas (isto vale para a trajetória mais exterior do desbaste e para o acabamento lateral). No acabamento lateral, a ferramenta aproxima-se do contorno num arco tangente; no acabamento do fundo, aproxima-se da peça também num arco tangente (com o eixo do cabeçote Z, no plano Z/X). O contorno é maquinado todo em sentido sincronizado ou todo em sentido contrário.
note-contour-tool-by-name = A ferramenta pode ser introduzida pelo número ou pelo nome. Para introduzir o nome, prima a softkey NOME DA FERRAMENTA; ao sair do campo, o comando acrescenta automaticamente as aspas.
note-global-def-for-contours = A função GLOBAL DEF para a fresagem de contornos predefine a distância de segurança, a altura segura, o fator de sobreposição e o tipo de fresagem dos ciclos 20, 22, 23, 24 e 25.

# --- 14 ---
cycle-contour = Contorno
    .nc = CONTORNO
    .purpose = Indica todos os subprogramas que são sobrepostos num só contorno. O comando calcula o contorno completo a partir destes contornos parciais, que são caixas ou ilhas.
step-remember-contour-labels = O comando memoriza os números de label. Os ciclos seguintes maquinam o contorno que os subprogramas descrevem.
note-contour-acts-from-definition = O ciclo atua a partir da sua definição no programa.
note-most-contour-labels = Podem ser indicados até 12 subprogramas (contornos parciais).
note-transformations-in-contour = São permitidas conversões de coordenadas. Se forem programadas dentro de um contorno parcial, atuam também nos subprogramas seguintes; não precisam de ser anuladas depois da chamada do ciclo.
note-pocket-and-island-recognized = O comando reconhece uma caixa se a ferramenta percorrer o contorno por dentro, por exemplo em sentido horário com correção de raio RR. Reconhece uma ilha se a ferramenta percorrer o contorno por fora, por exemplo em sentido horário com correção de raio RL.
note-contour-without-spindle-axis = Os subprogramas não podem conter coordenadas no eixo do cabeçote.
note-contour-begins-with-both-axes = Na primeira frase do subprograma, programe sempre os dois eixos.
note-parameters-within-contour = Se forem utilizados parâmetros Q, calcule-os e atribua-os apenas dentro do respetivo subprograma de contorno.
note-contours-may-overlap = Caixas e ilhas podem ser sobrepostas para formar um novo contorno. Uma caixa que se sobrepõe aumenta a superfície de uma caixa ou diminui a de uma ilha.
note-contour-intersections-computed = O comando calcula os pontos de intersecção dos contornos parciais; não precisam de ser programados.
note-contour-sum = Superfície de soma (as duas superfícies A e B, incluindo a comum): A e B têm de ser caixas. A primeira caixa da lista tem de começar fora da segunda.
note-contour-difference = Superfície de diferença (A sem o que B cobre): A tem de ser uma caixa e B uma ilha. A tem de começar fora de B, B tem de começar dentro de A.
note-contour-intersection = Superfície de intersecção (só o que A e B cobrem em comum): A e B têm de ser caixas. A tem de começar dentro de B.
note-machining-data-in-contour-data = Os dados de maquinação, como a profundidade de fresagem, as medidas excedentes e a distância de segurança, introduzem-se centralmente no ciclo 20.
note-contour-cycle-or-sel-contour = O ciclo não é necessário se o contorno for selecionado com SEL CONTOUR.
note-contour-for-turning = Os ciclos de torneamento que maquinam um contorno também precisam deste ciclo: tem de ser programado antes da sua chamada e indica o número do subprograma.

# --- 20 ---
cycle-contour-data = Dados do contorno
    .nc = DADOS DO CONTORNO
    .purpose = Contém os dados de maquinação para os subprogramas com os contornos parciais.
step-remember-contour-data = O comando memoriza os dados de maquinação para os ciclos 21 a 24.
note-contour-data-act-from-definition = O ciclo atua a partir da sua definição no programa. Os dados de maquinação só valem para os ciclos 21 a 24.
note-parameters-reserved-for-contours = Se forem utilizados ciclos SL em programas com parâmetros Q, os parâmetros Q1 a Q20 não podem ser utilizados como parâmetros do programa.
note-contour-data-at-interruption = Quando o programa é interrompido, os parâmetros de maquinação podem ser verificados e, se necessário, substituídos.

# --- 21 ---
cycle-pilot-drilling = Furação prévia
    .nc = FURAÇÃO PRÉVIA
    .purpose = Fura nos pontos de penetração do contorno, que são também os pontos de partida do desbaste.
step-position-at-pilot-holes = O comando determina os pontos de penetração do contorno.
step-move-over-pilot-hole = O comando posiciona a ferramenta sobre o ponto de penetração, à distância de segurança.
step-drill-pilot-hole-to-plunging-depth = A ferramenta fura com o avanço { $q-contour-plunging-feed }; em cada passo, avança mais uma profundidade de passo { $q-contour-plunging-depth }.
step-retract-and-return-to-stop-distance = O comando retira a ferramenta em avanço rápido (FMAX) e fá-la voltar até à distância de paragem prévia t acima da profundidade atingida.
until-drilling-depth-reached = seja atingida a profundidade do furo
step-dwell-and-retract-to-start = No fundo do furo, a ferramenta permanece durante o tempo de espera para cortar livremente e recua depois em avanço rápido (FMAX) para a posição de partida.
until-pilot-holes-drilled = estejam furados todos os pontos de penetração
note-stop-distance-determined = O comando determina automaticamente a distância de paragem prévia t: 0,6 mm com uma profundidade do furo até 30 mm, um quinquagésimo da profundidade do furo se esta exceder 30 mm, mas nunca mais de 7 mm.
note-infeed-points-consider = Nos pontos de penetração, o comando tem em conta as medidas excedentes de acabamento lateral e do fundo e o raio da ferramenta de desbaste.
note-delta-radius-not-considered-for-infeed-points = Ao calcular os pontos de penetração, o comando não tem em conta um valor delta DR programado na frase TOOL CALL.
note-narrow-places-not-pre-drilled = Em locais estreitos, o comando pode não conseguir fazer a furação prévia com uma ferramenta maior do que a ferramenta de desbaste.

# --- 22 ---
cycle-rough-out = Desbaste
    .nc = DESBASTE
    .purpose = Desbasta o contorno, nível a nível, até à medida excedente do fundo, ou maquina apenas o que uma ferramenta mais grossa deixou.
step-position-over-infeed-point = O comando posiciona a ferramenta sobre o ponto de penetração, tendo em conta a medida excedente de acabamento lateral.
step-take-depths-of-partial-contours = O comando maquina um contorno parcial com profundidade própria até essa profundidade, e todos os outros até à profundidade de fresagem dos dados do contorno.
step-go-to-infeed-point = A ferramenta desloca-se em avanço rápido para cima do ponto de penetração e desce até à distância de segurança da superfície já maquinada.
step-plunge-to-contour-level = A ferramenta desce mais uma profundidade de passo { $q-contour-plunging-depth }:
say-plunge-vertically-without-reciprocation = { $q-reciprocation-feed } = 0: na vertical com o avanço { $q-contour-plunging-feed }, mesmo que esteja definido um ângulo de penetração { $mp-plunging-angle } para a ferramenta ativa
say-plunge-vertically-at-reciprocation-feed = { $mp-plunging-angle } = 90°: na vertical com o avanço pendular { $q-reciprocation-feed }
say-plunge-on-helix-or-in-strokes = caso contrário, em hélice com o ângulo de penetração { $mp-plunging-angle } ou, onde a hélice não for possível, em movimento pendular
step-rough-contour-level = A esta profundidade, a ferramenta fresa o contorno de dentro para fora com o avanço { $q-roughing-feed }; à volta das ilhas, em trajetórias que se aproximam do contorno da caixa. O desbaste abrange:
say-rough-what-coarser-tool-left = se tiver sido introduzida uma ferramenta de desbaste prévio { $q-coarse-roughing-tool }, só o que essa ferramenta não pôde maquinar
say-rough-whole-region = caso contrário, toda a superfície
message-contour-material-left = A ferramenta não alcança todo o contorno: deixa material em esquinas ou em locais estreitos.
note-centre-cutting-or-pilot-drilling = Se necessário, utilize uma fresa que corte ao centro (DIN 844) ou faça um furo prévio com o ciclo 21.
note-rough-out-plunging = A forma como a ferramenta penetra na peça é determinada pelo parâmetro { $q-reciprocation-feed } e pelas colunas { $mp-plunging-angle } e { $mp-cutting-edge-length } da tabela de ferramentas. Com { $q-reciprocation-feed } = 0, penetra sempre na vertical. Com { $mp-plunging-angle } = 90°, penetra na vertical com o avanço { $q-reciprocation-feed }. Com um avanço pendular e { $mp-plunging-angle } de 0,1 a 89,999, penetra em hélice com esse ângulo. Com um avanço pendular e sem { $mp-plunging-angle } na tabela de ferramentas, o comando emite um aviso de erro. Se não houver espaço para uma hélice (como numa ranhura), o comando tenta penetrar em movimento pendular, cuja longitude é { $mp-cutting-edge-length } / tan { $mp-plunging-angle }.
note-overlap-greater-than-one = Com um fator de sobreposição maior do que 1, pode ficar material em contornos de caixas com esquinas interiores agudas. Verifique a trajetória mais interior no gráfico de teste e, se necessário, altere ligeiramente o fator de sobreposição. Os cortes ficam então repartidos de outra forma, o que muitas vezes dá o resultado pretendido.
note-wear-of-coarse-tool-not-considered = No desbaste posterior, o comando não tem em conta um valor de desgaste DR definido para a ferramenta de desbaste prévio.
note-fine-roughing-needs-tool-data = Se a zona do desbaste posterior não for acessível de lado, a ferramenta penetra em movimento pendular. Para isso, defina na tabela de ferramentas a longitude da navalha { $mp-cutting-edge-length } e o maior ângulo de penetração { $mp-plunging-angle } da ferramenta; caso contrário, o comando pode emitir um aviso de erro.

# --- 23 ---
cycle-floor-finishing = Acabamento do fundo
    .nc = ACABAMENTO DO FUNDO
    .purpose = Elimina a medida excedente de acabamento que o desbaste deixou no fundo.
step-approach-contour-floor = A ferramenta aproxima-se suavemente do fundo num arco tangente vertical, se houver espaço suficiente. Caso contrário, desce na vertical até à profundidade com o avanço { $q-contour-plunging-feed }.
step-find-start-of-floor-finishing = O comando determina o ponto inicial do acabamento do fundo.
step-finish-contour-floor = A ferramenta fresa a medida excedente de acabamento deixada pelo desbaste, com o avanço { $q-roughing-feed }.
note-starting-point-by-itself = O comando determina automaticamente o ponto de partida do acabamento. Este depende do espaço existente na caixa.
note-approach-radius-is-fixed = O raio de aproximação à profundidade final está fixado internamente e não depende do ângulo de penetração da ferramenta.

# --- 24 ---
cycle-side-finishing = Acabamento lateral
    .nc = ACABAMENTO LATERAL
    .purpose = Faz o acabamento dos lados do contorno. Cada contorno parcial é acabado em separado.
step-find-start-of-side-finishing = O comando determina o ponto de partida do acabamento.
step-finish-partial-contour = O comando faz descer a ferramenta, com o avanço { $q-contour-plunging-feed }, mais uma profundidade de passo { $q-contour-plunging-depth }, aproxima-a do contorno parcial num arco tangente e faz o acabamento deste com o avanço { $q-roughing-feed }.
until-partial-contours-finished = esteja feito o acabamento de todos os contornos parciais
note-side-finishing-allowances = A soma da medida excedente de acabamento lateral { $q-remaining-side-allowance } e do raio da ferramenta de acabamento tem de ser menor do que a soma da medida excedente de acabamento lateral do ciclo 20 e do raio da ferramenta de desbaste.
note-side-finishing-without-roughing = O mesmo vale se o ciclo for executado sem desbaste prévio com o ciclo 22; o raio da ferramenta de desbaste conta então como 0.
note-side-finishing-mills-contours = O ciclo também pode ser utilizado para fresar contornos. Para isso, defina o contorno como uma única ilha (sem limite de caixa) e introduza no ciclo 20 uma medida excedente de acabamento lateral maior do que a soma da medida excedente de acabamento { $q-remaining-side-allowance } e do raio da ferramenta.
note-start-depends-on-room-and-allowance = O comando determina automaticamente o ponto de partida do acabamento. Este depende do espaço existente na caixa e da medida excedente programada no ciclo 20.
note-start-depends-on-sequence = O ponto de partida depende também da sequência da maquinação. Se o ciclo de acabamento for selecionado com a tecla GOTO e o programa for então iniciado, o ponto de partida pode não ser o mesmo que resulta quando o programa é executado do princípio ao fim.

# --- 25 ---
cycle-contour-train = Traçado do contorno
    .nc = TRAÇADO DO CONTORNO
    .purpose = Maquina contornos abertos e fechados, juntamente com o ciclo 14. Ao contrário do que acontece com frases de posicionamento ao longo do contorno, o comando supervisiona a maquinação, fresa todo o contorno em sentido sincronizado ou em sentido contrário e pode fresar em vaivém e com medidas excedentes.
step-position-over-contour-start = O comando desloca a ferramenta para a altura segura { $q-contour-clearance-height } e posiciona-a sobre o ponto de partida do contorno.
step-plunge-beside-contour = A ferramenta desce, com o avanço { $q-contour-plunging-feed }, mais uma profundidade de passo { $q-contour-plunging-depth }.
step-mill-along-contour = A ferramenta fresa ao longo do contorno com o avanço { $q-contour-milling-feed }, tendo em conta a medida excedente de acabamento { $q-side-allowance }:
say-mill-to-and-fro = { $q-contour-milling-type } = 0: em vaivém, alternando o sentido sincronizado e o sentido contrário em cada passo
say-mill-in-one-direction = { $q-contour-milling-type } = +1 ou −1: em todos os passos em sentido sincronizado ou em sentido contrário
until-milling-depth-reached = seja atingida a profundidade de fresagem { $q-milling-depth }
note-contour-damage-monitored = O comando supervisiona a maquinação de modo que não haja recortes nem danos no contorno. Verifique o contorno com um teste gráfico.
note-inside-corners-may-need-reworking = Se o raio da ferramenta for demasiado grande, pode ser necessário retrabalhar as esquinas interiores do contorno.
note-milling-type-kept-when-mirrored = O contorno pode ser maquinado todo em sentido sincronizado ou todo em sentido contrário. O tipo de fresagem mantém-se mesmo que os contornos sejam espelhados.
note-several-infeeds-to-and-fro = Com vários passos, o comando pode deslocar a ferramenta em vaivém, o que encurta o tempo de maquinação.
note-contour-in-several-operations = Podem introduzir-se medidas excedentes, para fazer o desbaste e o acabamento em várias operações.
note-only-first-contour-label = O comando tem em conta apenas o primeiro label do ciclo 14.
note-contour-data-not-needed = O ciclo 20 não é necessário.
note-corner-feed-functions-without-effect = As funções auxiliares M109 e M110 não têm efeito na maquinação de um contorno com este ciclo.
note-no-incremental-after-contour-train = Perigo de colisão! Não programe medidas incrementais depois do ciclo: referem-se à posição da ferramenta no fim do ciclo.
note-absolute-position-after-contour-train = Perigo de colisão! Depois do ciclo, desloque a ferramenta para uma posição definida (absoluta) em todos os eixos principais, porque a sua posição no fim do ciclo não é a do início.

# --- 27 to 29 ---
step-plunge-into-cylinder = A ferramenta desce, com o avanço { $q-contour-plunging-feed }, mais uma profundidade de passo { $q-contour-plunging-depth }.
until-cylinder-milling-depth-reached = seja atingida a profundidade de fresagem programada { $q-cylinder-milling-depth }
step-return-in-tool-axis = A ferramenta regressa no eixo da ferramenta à altura segura ou à última posição programada antes do ciclo.
guard-clearance-within-tool-radius = A distância de segurança não é maior do que o raio da ferramenta.
guard-spindle-not-across-rotary-axis = O eixo do cabeçote não está perpendicular ao eixo da mesa rotativa.
guard-datum-off-rotary-axis = O ponto de referência não está no eixo da mesa rotativa: o cilindro rodaria descentrado.
guard-depth-out-of-cylinder = A profundidade de fresagem é positiva: a ferramenta afastar-se-ia do eixo do cilindro.
guard-slot-core-left = A ranhura tem mais do dobro da largura da ferramenta: fica material entre as paredes.
note-contour-in-development = Descreva o contorno num subprograma selecionado com o ciclo 14, sempre com as coordenadas X e Y, quaisquer que sejam os eixos rotativos da máquina. O contorno não depende então da configuração da máquina.
note-prepare-for-cylinder-interpolation = O fabricante da máquina tem de preparar a máquina e o comando para a interpolação da superfície cilíndrica. Consulte o manual da máquina.
note-contour-begins-with-both-coordinates-of-cylinder = Na primeira frase NC do subprograma de contorno, programe sempre as duas coordenadas da superfície cilíndrica.
note-centre-cutting-end-mill = Utilize uma fresa que corte ao centro (DIN 844).
note-cylinder-centred-on-rotary-table = O cilindro tem de estar fixado no centro da mesa rotativa.
note-datum-in-centre-of-rotary-table = Memorize o ponto de referência no centro da mesa rotativa.
note-spindle-across-rotary-axis = Na chamada do ciclo, o eixo do cabeçote tem de estar perpendicular ao eixo da mesa rotativa. Caso contrário, o comando emite um aviso de erro. Pode ser necessário comutar a cinemática.
note-cylinder-in-tilted-plane = O ciclo também pode ser utilizado com o plano de maquinação inclinado.
note-clearance-greater-than-tool-radius = A distância de segurança { $q-cylinder-set-up-clearance } tem de ser maior do que o raio da ferramenta.
note-many-contour-elements-take-time = A maquinação pode demorar mais se o contorno for composto por muitos elementos não tangentes.

# --- 27 ---
cycle-cylinder-surface = Superfície cilíndrica
    .nc = SUPERF. CILÍNDRICA
    .purpose = Transpõe para a superfície de um cilindro um contorno definido na planificação.
step-mill-along-developed-contour = A ferramenta fresa ao longo do contorno programado com o avanço { $q-contour-milling-feed }.
step-back-over-infeed-point = No fim do contorno, o comando desloca a ferramenta para a distância de segurança { $q-cylinder-set-up-clearance } e volta a posicioná-la sobre o ponto de penetração.
step-end-at-cylinder-clearance = A ferramenta desloca-se para a distância de segurança { $q-cylinder-set-up-clearance }.
note-functions-for-developed-contour = Para a trajetória da ferramenta estão disponíveis as funções L, CHF, CR, RND e CT.
note-angular-axis-unit = Os valores do eixo angular (coordenadas X) podem ser introduzidos em graus ou em milímetros (polegadas); isso é determinado por { $q-development-dimension-type }.
note-guide-slots-with-other-cycle = Para fresar ranhuras de guia num cilindro, utilize o ciclo 28.

# --- 28 ---
cycle-cylinder-surface-slot = Superfície cilíndrica – fresar ranhura
    .nc = SUPERF. CILÍNDRICA
    .purpose = Transpõe para a superfície de um cilindro uma ranhura de guia definida na planificação, com paredes quase paralelas.
step-position-over-slot-infeed-point = O comando posiciona a ferramenta sobre o ponto de penetração.
step-mill-along-slot-wall = A ferramenta fresa ao longo da parede da ranhura com o avanço { $q-contour-milling-feed }, tendo em conta a medida excedente de acabamento lateral { $q-side-allowance }.
step-mill-back-along-opposite-wall = No fim do contorno, o comando desloca a ferramenta para a parede oposta da ranhura e fá-la voltar ao ponto de penetração.
step-rework-slot-walls = Se estiver definida uma tolerância { $q-cylinder-slot-tolerance }, o comando retrabalha a ranhura de modo que as paredes fiquem o mais paralelas possível.
note-walls-nearly-parallel = Ao contrário do ciclo 27, este ciclo ajusta a ferramenta de modo que, com correção de raio ativa, as paredes fiquem quase paralelas. Ficam exatamente paralelas com uma ferramenta que tenha exatamente a largura da ranhura.
note-small-tool-distorts-slot = Quanto menor for a ferramenta em comparação com a largura da ranhura, maiores são as distorções em arcos e retas oblíquas. Para as reduzir, defina a tolerância { $q-cylinder-slot-tolerance }: a ranhura fica então mais próxima da que seria fresada com uma ferramenta da mesma largura.
note-program-centre-path-of-slot = Programe a trajetória do ponto central do contorno com correção de raio. A correção de raio determina se o comando fresa a ranhura em sentido sincronizado ou em sentido contrário.

# --- 29 ---
cycle-cylinder-surface-ridge = Superfície cilíndrica – fresar nervura
    .nc = SUPERF. CILÍNDRICA NERVURA
    .purpose = Transpõe para a superfície de um cilindro uma nervura definida na planificação, com paredes paralelas.
step-position-over-ridge-start = O comando posiciona a ferramenta sobre o ponto de partida da maquinação, que calcula a partir da largura da nervura e do diâmetro da ferramenta: ao lado do primeiro ponto do subprograma de contorno, afastado dele no valor de metade da largura da nervura mais o diâmetro da ferramenta. A correção de raio determina o lado: à esquerda da nervura (sentido sincronizado) ou à direita (sentido contrário).
step-approach-ridge-wall = A esta profundidade, a ferramenta desloca-se para o contorno num arco tangente com o avanço { $q-contour-milling-feed }, tendo em conta a medida excedente de acabamento lateral { $q-side-allowance }, se existir.
step-mill-along-ridge-wall = A ferramenta fresa ao longo da parede da nervura com o avanço { $q-contour-milling-feed }, até a nervura estar completa.
step-leave-ridge-wall = A ferramenta sai tangencialmente da parede da nervura e regressa ao ponto de partida da maquinação.
note-ridge-walls-parallel = O ciclo ajusta a ferramenta de modo que, com correção de raio ativa, as paredes fiquem sempre paralelas.
note-program-centre-path-of-ridge = Programe a trajetória do ponto central da nervura com correção de raio. A correção de raio determina se o comando fresa a nervura em sentido sincronizado ou em sentido contrário.
note-ridge-ends-in-semicircles = Nas extremidades da nervura, o comando acrescenta sempre um semicírculo, cujo raio é metade da largura da nervura.

# --- 225 ---
cycle-engraving = Gravar
    .nc = GRAVAR
    .purpose = Grava texto numa superfície plana da peça, em linha reta ou em arco.
step-move-to-first-character = O comando posiciona a ferramenta no plano de maquinação, no ponto de partida do primeiro carácter.
step-engrave-character = A ferramenta penetra na vertical com o avanço { $q-plunging-feed } até ao fundo da gravação e fresa o carácter com o avanço { $q-milling-feed }. Quando é preciso levantá-la dentro do carácter, sobe até à distância de segurança { $q-set-up-clearance }. No fim do carácter, a ferramenta fica à distância de segurança acima da superfície da peça.
step-move-over-next-character = O comando desloca a ferramenta, à distância de segurança, para o ponto de partida do carácter seguinte.
until-characters-engraved = estejam gravados todos os caracteres
step-end-engraving-at-second-clearance = O comando desloca a ferramenta para a 2ª distância de segurança { $q-second-set-up-clearance }.
condition-text-runs-on-arc = { $q-text-arrangement } indicar um texto em arco
note-straight-text-starts-at-tool = Num texto em linha reta ({ $q-text-arrangement } = 0), a posição da ferramenta na chamada do ciclo é o ponto de partida do primeiro carácter.
note-circle-text-centre-at-tool = Num texto em arco ({ $q-text-arrangement } = 1), a posição da ferramenta na chamada do ciclo é o centro do círculo.
note-text-from-string-parameter = O texto também pode ser dado por uma variável de texto (QS).
note-engraving-characters = Caracteres que podem ser gravados: letras minúsculas, letras maiúsculas, algarismos e os caracteres especiais ! # $ % & ' ( ) * + , - . / : ; < = > ? @ [ \ ] _
note-engraving-doubled-characters = O comando utiliza os caracteres especiais % e \ para funções especiais. Para gravar um deles, introduza-o duas vezes no texto, por exemplo %%.
note-engraving-control-characters = O carácter especial \ introduz também caracteres não imprimíveis que dispõem o texto: \n é uma quebra de linha, \t um tabulador horizontal (a largura do tabulador é de 8 caracteres), \v um tabulador vertical (a largura do tabulador é de uma linha).
note-proportional-font = O tipo de letra é proporcional: cada carácter tem a sua própria largura. O fator de distância { $q-character-spacing-factor } ajusta a distância entre os caracteres.
note-engraving-since-software = O ciclo existe a partir do software 34059x-02.
