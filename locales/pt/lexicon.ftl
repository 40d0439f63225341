# Words in the names of parameters that tell what is measured and from where; pieces of words separated by a bar.

lexicon-length = distância | profundidade | coordenada | diâmetro | raio | largura | altura | medida | longitude | recuo | limite | tamanho | passo | deslocação | caminho | percurso | início | fim | inicial | final | posição | chanfre | desvio | tolerância | centro | lado | compensação | correção | ponto | aresta | redução | espessura | saída | contorno | folga | excentricidade | superfície
lexicon-angle = ângulo | angular | rotação | orientação | rotativo | inclinação
lexicon-feed = avanço
lexicon-time = tempo | pausa | espera
lexicon-place = a | à | ao | em | no | na | sobre | sob | entre
lexicon-speed = rotações | velocidade
lexicon-count = número | filetes | roturas | apalpações | pontos | cortes | linhas | passagens
lexicon-factor = fator | sobreposição | multipl | normal à superf
lexicon-absolute = coordenada | centro | altura | referência | posição | nominal | ponto | ângulo | diâmetro | início | fim | inicial | final | rotação | raio | número | distância segura
lexicon-incremental = distância | profundidade | medida excedente | passo | recuo | redução | longitude | percurso | caminho | rebaix | paragem | aresta | espessura | saída | largura | tamanho | aprofundado | navalha | abertura
lexicon-negation = não | nem+ | sem | nenhum- | nunca | jamais | nada | ninguém | exclu- | evita- | falta- | diferente- | imped- | independente-
