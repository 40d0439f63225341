# Relações de valores que nenhum comando recusa e que dificilmente são pretendidas; ver o ficheiro inglês.
guard-clearance-height-not-above-surface = A altura segura não está acima da superfície da peça.
guard-corner-radius-too-great = O raio da esquina é maior do que metade do lado mais curto.
guard-decrement-too-great = O valor de redução não é inferior à profundidade de passo: do segundo passo não resta nada.
guard-end-above-start = O ponto final no eixo da ferramenta está acima do ponto inicial: a superfície é fresada a partir de baixo.
guard-greatest-below-least = A medida maior é inferior à medida menor: nenhuma peça está dentro de tais limites.
guard-hole-angles-equal = Dois dos furos têm o mesmo ângulo: não determinam um círculo.
guard-least-plunging-depth-too-great = A profundidade de passo mínima é maior do que a profundidade de passo.
guard-measuring-angles-equal = O ângulo inicial e o ângulo final da medição são iguais.
guard-points-identical = Dois dos pontos são iguais: deles não resulta nem uma direção nem uma interseção.
guard-pre-drilled-too-wide = O diâmetro do furo prévio não é inferior ao diâmetro nominal: nada resta para fresar.
guard-slot-wider-than-long = A ranhura é mais larga do que comprida.
guard-thread-pitch-too-great = O passo de rosca não é inferior ao diâmetro nominal.
