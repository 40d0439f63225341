# A linha de comandos: cenas de programas que não as têm.
cli-scene = Escreve um ficheiro da cena para um programa: as suas ferramentas, o bloco e o que tem de se supor
cli-scene-out = Ficheiro a escrever (predefinição: saída padrão)
cli-scene-head = Obtido de { $path }. Corrija o que é apenas suposto.
cli-scene-is-assumed = suposto
cli-scene-from-table = da tabela de ferramentas
cli-scene-tool = ferramenta { $tool }: raio { $radius } mm, longitude { $length } mm
cli-scene-turning-tool = ferramenta de tornear { $tool }: raio da ponta { $radius } mm, aresta principal a { $angle }°, ângulo da ponta { $point }°
cli-scene-recessing-tool = ferramenta de ranhurar { $tool }: largura de corte { $width } mm, raio dos cantos { $radius } mm
cli-scene-probing-tool = apalpador { $tool }: longitude { $length } mm
cli-scene-probe = a esfera do apalpador tem um raio de { $ball } mm e pode tocar no bloco
cli-scene-no-tools = nenhuma ferramenta
cli-plot-no-blank = Não há bloco: só se desenha a trajetória da ferramenta.
diag-assumed-scene = Não foi indicada nenhuma cena. Supõe-se: { $assumed }. «ciklo scene» escreve um ficheiro da cena que se pode corrigir.
cli-examples-scene =
    ciklo scene part.h --control tnc640 > part.scene.yaml
    ciklo scene part.h --control tnc640 --tool-table TOOL.T --out part.scene.yaml
cli-run-scene = Ficheiro da cena: máquina, ferramentas, peça (predefinição: o que consta do programa, o resto é suposto)
