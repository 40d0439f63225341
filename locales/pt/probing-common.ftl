# What several touch-probe cycles share.

# --- run ---
step-position-at-first-touch-point = O comando posiciona o apalpador no primeiro ponto de apalpação, em avanço rápido (valor da coluna { $mp-positioning-feed }) e com lógica de posicionamento. Calcula os pontos de apalpação a partir das indicações do ciclo e da distância de segurança da coluna { $mp-set-up }.
step-position-at-first-touch-point__tnc426-430 = O comando posiciona o apalpador no primeiro ponto de apalpação, em avanço rápido (valor de { $mp-positioning-feed } ou { $mp-analog-positioning-feed }) e com lógica de posicionamento. Calcula os pontos de apalpação a partir das indicações do ciclo e da distância de segurança de { $mp-set-up }.
step-move-to-measuring-height = O apalpador desloca-se para a altura de medição { $q-measuring-height }.
step-probe-outward = O apalpador executa uma apalpação com o avanço de apalpação (coluna { $mp-probing-feed }). O comando determina a direção de apalpação a partir do ângulo inicial { $q-probing-starting-angle } e do passo angular { $q-probing-stepping-angle }.
step-probe-outward__tnc426-430 = O apalpador executa uma apalpação com o avanço de apalpação ({ $mp-probing-feed } ou { $mp-analog-probing-feed }). O comando determina a direção de apalpação a partir do ângulo inicial { $q-probing-starting-angle } e do passo angular { $q-probing-stepping-angle }.
step-travel-to-next-touch-point = O apalpador desloca-se para o ponto de apalpação seguinte:
say-start-again-from-centre = se a caixa e a distância de segurança não deixarem espaço para um posicionamento prévio perto dos pontos de apalpação, permanece no centro e não se desloca à altura segura
say-travel-straight-at-clearance-height = com { $q-traverse-to-clearance-height }=1 e { $q-probing-traverse-type }=0, em linha reta, à altura segura { $q-clearance-height }
say-travel-on-circle-at-clearance-height = com { $q-traverse-to-clearance-height }=1, sobre um arco de círculo, à altura segura { $q-clearance-height }
say-travel-on-circle-at-clearance-height__tnc640 = com { $q-traverse-to-clearance-height }=1 e { $q-probing-traverse-type }=1, sobre um arco de círculo, à altura segura { $q-clearance-height }
say-travel-on-circle-at-measuring-height = com { $q-traverse-to-clearance-height }=0, sobre um arco de círculo, à altura de medição { $q-measuring-height }
until-all-touch-points-probed = tenham sido apalpados todos os pontos de apalpação

# --- conditions ---
condition-travel-at-clearance-height = o apalpador se deslocar à altura segura ({ $q-traverse-to-clearance-height }=1)
condition-probe-axis-wanted = { $q-probing-in-probe-axis }=1

# --- guards ---
guard-probe-axis-undefined = Antes da definição do ciclo não há nenhuma chamada da ferramenta, por isso o eixo do apalpador não está definido.
guard-transformation-active = Está ativo o espelhamento, o fator de escala ou o fator de escala específico do eixo. Nenhum deles pode estar ativo durante um ciclo de apalpação.
guard-basic-rotation-active = Está ativa uma rotação básica. Este ciclo não pode ser executado com uma rotação básica.
guard-stepping-angle-too-small = O passo angular { $q-probing-stepping-angle } é menor do que 5°.
guard-tolerance-exceeded = Foi excedida uma tolerância.
guard-tool-broken = O desvio é maior do que a tolerância de rotura da ferramenta. A ferramenta fica bloqueada.

# --- notes: probing in general ---
note-positioning-logic = Lógica de posicionamento: com o polo sul da haste de apalpação abaixo da altura segura { $q-clearance-height }, o comando faz primeiro recuar o apalpador, no seu eixo, para a altura segura e só depois o leva, no plano de maquinação, ao primeiro ponto de apalpação. Com o polo sul acima da altura segura, o apalpador desloca-se primeiro, no plano de maquinação, para o primeiro ponto de apalpação e depois, no seu eixo, diretamente para a altura de medição { $q-measuring-height }.
note-tool-call-before-definition = Antes da definição do ciclo, programe uma chamada da ferramenta que defina o eixo do apalpador.
note-no-mirror-or-scaling-while-probing = Durante a execução dos ciclos de apalpação não podem estar ativos o espelhamento (ciclo 8), o fator de escala (ciclo 11) nem o fator de escala específico do eixo (ciclo 26).
note-transformations-while-probing = Durante a execução dos ciclos de apalpação não pode estar ativo nenhum ciclo de conversão de coordenadas: deslocação do ponto zero (7), espelhamento (8), rotação (10), fator de escala (11 e 26), plano de maquinação (19).
note-heidenhain-probes-only = O funcionamento dos ciclos de apalpação só é garantido com apalpadores HEIDENHAIN.
note-prepare-for-3d-probes = O fabricante da máquina tem de preparar o comando para os apalpadores 3D. Consulte o manual da máquina.
note-compensation-data-for-probing = Verifique se os dados de correção (longitude, raio) no início do ciclo são os pretendidos: os dados de calibração ou os da última frase TOOL CALL. A seleção faz-se com { $mp-calibration-data-source }.
note-no-contact-within-distance = O comando emite um aviso de erro se não houver deflexão da haste de apalpação dentro do percurso { $mp-probing-distance }.
note-set-up-is-pre-position = { $mp-set-up } é a distância do ponto de apalpação à qual o comando posiciona previamente o apalpador. Quanto menor for, maior tem de ser a exatidão com que se definem os pontos de apalpação.
note-track-orients-probe = Com { $mp-track } = ON, o comando orienta um apalpador de infravermelhos na direção de apalpação programada antes de cada apalpação, de modo que a haste de apalpação seja sempre defletida na mesma direção; isto aumenta a exatidão da medição. Depois de alterar { $mp-track }, calibre de novo o apalpador.
note-pre-positioning-speed = { $mp-pre-positioning } determina a velocidade do posicionamento prévio: FMAX_PROBE é o avanço da coluna { $mp-positioning-feed }, FMAX_MACHINE o avanço rápido da máquina.
note-multiple-measurement = Para que as medições sejam mais seguras, o comando pode repetir cada apalpação, até um total de três seguidas; os parâmetros de máquina em { $mp-probe-settings } (comportamento de apalpação, funcionamento automático) determinam quantas vezes, e a margem de confiança. Se os valores medidos diferirem entre si mais do que a margem de confiança, o comando emite um aviso de erro; caso contrário, memoriza o seu valor médio. Assim se podem detetar erros de medição devidos, por exemplo, a sujidade.
note-multiple-measurement__tnc426-430 = Para que as medições sejam mais seguras, o comando pode repetir cada apalpação, até um total de três seguidas; { $mp-multiple-measurement } determina quantas vezes, { $mp-confidence-range } a margem de confiança. Se os valores medidos diferirem entre si mais do que a margem de confiança, o comando emite um aviso de erro; caso contrário, memoriza o seu valor médio. Assim se podem detetar erros de medição devidos, por exemplo, a sujidade.
note-step-below-90-for-arcs = Para medir um arco em vez de um círculo completo, programe um passo angular { $q-probing-stepping-angle } menor do que 90°.
note-smallest-stepping-angle = Quanto menor for o passo angular { $q-probing-stepping-angle }, menos exato é o ponto de referência que o comando calcula. Valor de introdução mínimo: 5°.
note-smallest-stepping-angle__measure-hole = Quanto menor for o passo angular { $q-probing-stepping-angle }, menos exatas são as medidas do furo que o comando calcula. Valor de introdução mínimo: 5°.
note-small-stepping-angle-less-exact = Quanto menor for o passo angular { $q-probing-stepping-angle }, menos exato é o centro que o comando calcula.
note-small-stepping-angle-less-exact__datum-inside-circle = Quanto menor for o passo angular { $q-probing-stepping-angle }, menos exato é o ponto de referência que o comando calcula.
note-results-in-active-system = O comando indica todos os resultados, nos parâmetros de resultado e no ficheiro do registo, no sistema de coordenadas ativo, que pode estar deslocado, rodado ou inclinado.
note-results-in-active-system__tnc320 = O comando indica todos os resultados, nos parâmetros de resultado e no ficheiro do registo, no sistema de coordenadas ativo, que pode estar deslocado e/ou rodado.
note-results-in-active-system__tnc426-430 = O comando indica todos os resultados, nos parâmetros de resultado e no ficheiro do registo, no sistema de coordenadas ativo, que pode estar deslocado.
note-results-in-q-parameters = O comando guarda os resultados de medição nos parâmetros Q de atuação global Q150 a Q160, que podem ser utilizados no resto do programa.
note-deviations-in-q-parameters = O comando guarda os resultados de medição nos parâmetros Q de atuação global Q150 a Q160 e os desvios em relação aos valores nominais nos parâmetros Q161 a Q166. Durante a definição do ciclo, a imagem de ajuda mostra também os parâmetros de resultado; o que está realçado pertence ao parâmetro de introdução selecionado.
note-deviations-in-q-parameters__tnc426-430 = O comando guarda os resultados de medição nos parâmetros Q de atuação global Q150 a Q160 e os desvios em relação aos valores nominais nos parâmetros Q161 a Q166. Durante a definição do ciclo, a imagem de ajuda mostra também os parâmetros de resultado.

# --- results ---
result-centre-main-actual = Valor real centro eixo principal
result-centre-minor-actual = Valor real centro eixo secundário
result-diameter-actual = Valor real diâmetro
