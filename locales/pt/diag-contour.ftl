## Por que motivo um contorno não pode ser executado.

diag-approach-impossible = APPR ou DEP não tem solução: LN e CT precisam de RL ou RR, e LCT precisa de um ponto fora do seu arco.
diag-approach-word = Esta forma de APPR ou DEP precisa de { $word }.
diag-compensation-begin = A correção de raio tem de começar e terminar numa reta, não num arco.
diag-compensation-side = Entre RL e RR é necessária uma frase com R0.
diag-compensation-too-large = O raio da ferramenta de { NUMBER($radius, maximumFractionDigits: 4) } mm é demasiado grande para uma esquina interior, um arco interior ou um degrau do contorno.
diag-contour-limit = A execução termina: há mais de { NUMBER($limit) } eventos entre dois elementos de um contorno.
diag-contour-missing = Não se segue nenhum elemento de contorno ao qual a ferramenta se possa aproximar.
diag-rounding-impossible = Um arredondamento ou chanfre de { NUMBER($size, maximumFractionDigits: 4) } mm não cabe nesta esquina. Um chanfre precisa de uma reta de ambos os lados.
diag-rounding-misplaced = RND e CHF precisam de um elemento no plano de maquinação diretamente antes e depois, e não podem iniciar um contorno.
diag-tangent-missing = A direção tangencial é desconhecida: um elemento de contorno tem de terminar neste ponto, e o fim de um arco tangencial não pode ficar exatamente em frente dele.
diag-unsupported-compensation = O motor de execução não executa isto enquanto a correção de raio está ativa: { $word }
