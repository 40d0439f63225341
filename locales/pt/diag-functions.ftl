# Blocks that end a program or speak with the machine.
diag-error-of-program = O programa termina por si próprio com o erro { $number } (FN 14).
explain-error-of-program = FN 14: ERROR termina o programa com um erro próprio; o número escolhe a mensagem que o comando mostra. Os programas usam-no quando não podem continuar, por exemplo porque o valor de um parâmetro não serve. Exemplo: «FN 14: ERROR = 1010». Solução: verificar a condição antes da frase e dar aos parâmetros valores com que o programa possa trabalhar.
diag-tool-setter-askew = A ferramenta não está perpendicular à face do apalpador de ferramentas.
explain-tool-setter-askew = A cabeça ou o plano de maquinação está inclinado de modo diferente da montagem do apalpador de ferramentas: a ferramenta tocá-lo-ia obliquamente e o resultado não seria nem a longitude nem o raio. Exemplo: uma ferramenta na horizontal sobre um apalpador cuja face aponta para cima. Solução: antes do ciclo, rode os eixos rotativos de modo que a ferramenta fique alinhada com o apalpador, ou monte o apalpador da cena em conformidade («rotate»).
diag-tool-setter-collision = Colisão: a ferramenta embate no apalpador de ferramentas num movimento a partir de X { NUMBER($x) } Y { NUMBER($y) } Z { NUMBER($z) }.
explain-tool-setter-collision = A ferramenta embate no apalpador de ferramentas da cena num movimento que não mede: a ferramenta tal como é na realidade, com a navalha mais comprida e a mais larga. Na máquina, ambos poderiam partir-se. Muitas vezes a altura segura é demasiado baixa, ou a longitude e o raio na tabela de ferramentas estão mais longe da realidade do que permite a distância de segurança do apalpador. Introduza valores aproximados antes da primeira medição, ou contorne o apalpador.
diag-tool-setter-missing = A cena não tem apalpador de ferramentas.
explain-tool-setter-missing = Um ciclo de medição da ferramenta precisa de um apalpador de ferramentas na cena: onde está a sua superfície e que largura tem. Exemplo: «tool_setter:» com «at: [300, 200, -50]» e «diameter: 40». Solução: acrescentá-lo à cena; docs/scene.md descreve as chaves.

# --- kinematics ---
diag-kinematics-not-saved = Não há nenhuma cinemática guardada com o nome «{ $name }».
explain-kinematics-not-saved = Só se pode restaurar ou apagar uma cinemática guardada. Exemplo: modo 1 com o nome AB antes de guardar no modo 0. Solução: guardar primeiro, corrigir o nome ou acrescentar a posição em «kinematics: saved:» da cena.
diag-kinematics-differs = A cinemática guardada como «{ $name }» descreve outra máquina.
explain-kinematics-differs = Os dados guardados só podem ser restaurados numa descrição de cinemática idêntica: o mesmo nome e os mesmos eixos rotativos pela mesma ordem. Exemplo: dados de uma máquina com A e C numa máquina com B e C. Solução: escolher dados desta máquina.
diag-kinematics-memory-full = Todas as posições de memória para cinemáticas ({ $count }) estão ocupadas.
explain-kinematics-memory-full = O comando conserva um número limitado de cinemáticas guardadas. Exemplo: um décimo sétimo nome num comando com 16 posições. Solução: apagar uma que já não seja necessária ou guardar com um nome em uso.
diag-tool-edges-too-many = As navalhas só podem ser medidas individualmente em ferramentas com até { $most } navalhas; a tabela de ferramentas indica { $count }.
explain-tool-edges-too-many = O manual limita a medição individual de navalhas. Exemplo: CUT = 24 na tabela de ferramentas e Q341=1, quando se podem medir no máximo 20 navalhas. Solução: medir a ferramenta em rotação (Q341=0) ou corrigir CUT. A tabela de ferramentas fica como estava.
diag-kinematics-tool-axis = Este ciclo só pode ser utilizado com o eixo da ferramenta Z; o eixo da ferramenta ativo é { $axis }.
explain-kinematics-tool-axis = A cinemática mede-se com o apalpador ao longo de Z: os manuais não permitem outro eixo da ferramenta. Exemplo: TOOL CALL 1 Y antes do ciclo 451. Solução: chamar o apalpador com o eixo da ferramenta Z. A cinemática fica como estava.
diag-kinematics-undetermined = As posições de medição não permitem determinar a posição do eixo { $axis }.
explain-kinematics-undetermined = Para corrigir a posição de um eixo rotativo, as posições de medição têm de diferir claramente da posição de referência a 0°. Exemplo: um ponto a 0,05° ou só um ponto a 0°, que é ignorado. Solução: maior intervalo entre ângulo inicial e final ou mais pontos de medição. A cinemática fica como estava.
diag-sphere-radius-differs = O raio medido da esfera de calibração, { $found } mm, desvia-se demasiado do raio introduzido, { $entered } mm.
explain-sphere-radius-differs = Em cada posição o comando mede primeiro o raio da esfera; um parâmetro de máquina limita o desvio em relação ao introduzido. Exemplo: introduzido 12,5, esfera de 12,6 e limite 0,05. Solução: introduzir o raio exato ou calibrar o apalpador.
diag-measuring-position-at-zero = Uma posição de medição do eixo { $axis } está a 0° ou 360°.
explain-measuring-position-at-zero = A medição de referência é feita a 0°, pelo que uma posição de medição aí nada diz e o iTNC 530 recusa-a. Exemplo: −90 a +90 com 3 pontos. Solução: outro número de pontos ou outros ângulos.
diag-measuring-position-near-limit = A posição de medição do eixo { $axis } a { $angle }° está a menos de { $way }° do limite do eixo.
explain-measuring-position-near-limit = O ângulo do eixo é medido com o encoder do motor, e o comando precisa de { $way }° de percurso para lá de cada posição de medição para a compensação interna da folga. Exemplo: um ponto a 119,5° com «max: 120» e «encoder: motor» na máquina. Solução: escolher o ângulo inicial e o final mais longe dos limites.
diag-hirth-without-retraction = O eixo { $axis } tem dentado Hirth e precisa de uma altura de recuo.
explain-hirth-without-retraction = Um eixo com dentado Hirth sai dele para ser posicionado, pelo que não pode ser medido sem recuo. Exemplo: altura de recuo 0 com «hirth: 3» na máquina. Solução: introduzir uma altura acima da esfera.
diag-mask-missing = A máscara { $name } não existe.
explain-mask-missing = FN 16 escreve segundo uma máscara, um ficheiro de texto ao lado do programa ou em «masks» na cena, e esta não está em nenhum dos dois sítios. A unidade e as pastas no nome não contam. Exemplo: «FN 16: F-PRINT TNC:\MASK.A / TNC:\LOG.TXT» sem um ficheiro MASK.A. Acrescente a máscara ou corrija o nome.
diag-mask-unreadable = { $file }, linha { $line }: não é possível ler a máscara: { $found }
explain-mask-unreadable = Uma máscara é composta por textos entre aspas, com um lugar para cada valor que se lhes segue, e por palavras-chave; cada elemento termina com um ponto e vírgula. Exemplo: «"X = %9.3LF", Q31;». São causas frequentes um ponto e vírgula em falta, mais lugares do que valores ou uma palavra-chave que não pode ser simulada. Corrija a linha.
diag-output-path = O caminho { $path } leva para fora da pasta dos resultados.
explain-output-path = O que FN 16 escreve vai para a pasta indicada com --out, com o nome do seu ficheiro, seja qual for a pasta no comando. Um caminho que leva para cima, ou para a unidade ou a pasta raiz de outro sistema, poderia substituir outros ficheiros e é recusado. Exemplo: «TNC:\LOG\..\PART.TXT». Utilize um caminho em TNC: sem «..».
diag-open-table-missing = Não há nenhuma tabela aberta.
explain-open-table-missing = FN 27 e FN 28 escrevem e leem a tabela que FN 26: TABOPEN abriu, e antes desta frase não foi aberta nenhuma. Exemplo: «FN 28: TABREAD Q10 = 6/"X,Y"» no início de um programa. Abra primeiro a tabela: «FN 26: TABOPEN TNC:\TAB1.TAB».
