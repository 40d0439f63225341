# Drilling cycles.

# --- 200 ---
cycle-drilling = Furar
    .nc = FURAR
    .purpose = Abre um furo num só passo ou em vários. Entre os passos, a ferramenta é retirada do furo em avanço rápido.
step-drill-to-plunging-depth = A ferramenta fura com o avanço { $q-plunging-feed } e avança mais uma profundidade de passo { $q-plunging-depth }.
step-retract-and-return-to-set-up-clearance = O comando retira a ferramenta em avanço rápido (FMAX) para a distância de segurança, mantém-na aí durante { $q-dwell-at-top }, se este tiver sido introduzido, e fá-la voltar em avanço rápido (FMAX) até à distância de segurança acima da profundidade atingida.
step-dwell-at-hole-bottom = A ferramenta permanece no fundo do furo durante { $q-dwell-at-bottom }, se este tiver sido introduzido.
step-rapid-out-of-hole = A ferramenta sai do fundo do furo em avanço rápido (FMAX):
say-rapid-to-second-set-up-clearance = para a 2ª distância de segurança { $q-second-set-up-clearance }, se tiver sido introduzida
say-rapid-back-to-set-up-clearance = caso contrário, para a distância de segurança { $q-set-up-clearance }
note-position-over-hole-centre = Programe uma frase de posicionamento para o ponto de partida (centro do furo) no plano de maquinação com correção de raio R0.
note-point-table-hole-centres = Se o ciclo for chamado com uma tabela de pontos, os pontos do plano de maquinação são os centros dos furos. Para utilizar a coordenada do eixo da ferramenta da tabela como coordenada do ponto de partida, introduza 0 como coordenada da superfície da peça { $q-surface-coordinate }.

# --- 205 ---
cycle-universal-pecking = Furar em profundidade universal
    .nc = FURAR PROFUND. UNIVERSAL
    .purpose = Abre furos profundos com passos que podem ir diminuindo, com rotura de apara, com uma distância de paragem prévia para o regresso ao furo e com um ponto de partida abaixo da superfície da peça para furos já iniciados.
step-feed-to-deepened-starting-point = Se tiver sido introduzido um ponto de partida aprofundado { $q-deepened-starting-point }, a ferramenta desloca-se com o avanço de posicionamento prévio { $q-pre-positioning-feed } até à distância de segurança acima do ponto de partida aprofundado.
step-drill-on-to-plunging-depth = A ferramenta fura com o avanço { $q-plunging-feed } em direção à profundidade de passo { $q-plunging-depth }; com rotura de apara, detém-se cada vez que tiver avançado { $q-depth-for-chip-breaking }. Se tiver sido introduzido um valor de redução { $q-decrement }, a profundidade de passo diminui nesse valor em cada passo.
step-break-chip = Para a rotura de apara, a ferramenta recua { $q-chip-breaking-retraction } a 3000 mm/min.
until-plunging-depth-reached = seja atingida a profundidade de passo
step-retract-and-return-to-advanced-stop = O comando retira a ferramenta em avanço rápido (FMAX) para a distância de segurança e fá-la voltar em avanço rápido (FMAX) até à distância de paragem prévia acima da profundidade atingida: { $q-upper-advanced-stop-distance } no início, { $q-lower-advanced-stop-distance } no fim.
step-dwell-to-cut-free = Para cortar livremente, a ferramenta permanece no fundo do furo durante { $q-dwell-at-bottom }, se este tiver sido introduzido.
step-feed-back-to-set-up-clearance = A ferramenta recua com o avanço { $q-plunging-feed } para a distância de segurança { $q-set-up-clearance }.
step-rapid-on-to-second-set-up-clearance = Se tiver sido introduzida uma 2ª distância de segurança { $q-second-set-up-clearance }, a ferramenta desloca-se para aí em avanço rápido (FMAX).
condition-infeeds-decrease = tiver sido introduzido um valor de redução { $q-decrement }
condition-starting-point-deepened = o ponto de partida aprofundado { $q-deepened-starting-point } for diferente de 0
guard-starting-point-below-depth = O ponto de partida aprofundado fica à cota da profundidade ou abaixo dela: não resta nada para furar.
note-advanced-stop-changes-evenly = Se { $q-upper-advanced-stop-distance } e { $q-lower-advanced-stop-distance } forem diferentes, o comando altera uniformemente a distância de paragem prévia entre o primeiro e o último passo.
note-deepened-start-changes-infeed-only = Um ponto de partida aprofundado { $q-deepened-starting-point } altera apenas o ponto de partida do passo. Os recuos continuam a referir-se à coordenada da superfície da peça.
