# Palavras das figuras.

figure-section = Corte
figure-plan = Vista de cima
figure-chip-breaking = Quebra de apara
figure-deepened-start = Ponto inicial aprofundado
figure-centring-diameter = Centragem até ao diâmetro
figure-rotation = Ângulo de rotação
figure-pocket-position = Posição na chamada
figure-milling-type = Fresagem sincronizada e em sentido contrário
figure-allowances = Medidas excedentes de acabamento
figure-slot-position = Posição na chamada
figure-stud-position = Posição na chamada
figure-approach = Posição de aproximação
figure-stepping-angle = Passo angular
figure-traverse = Percurso entre maquinagens
figure-plunging = Afundamento
figure-side = Vista lateral
figure-new-datum = O novo ponto de referência
figure-probe-axis = Ponto de referência no eixo do apalpador
figure-heights = Alturas de segurança
figure-corner-a = Esquina A
figure-corner-b = Esquina B
figure-corner-c = Esquina C
figure-corner-d = Esquina D
figure-corner-1 = Esquina 1
figure-corner-2 = Esquina 2
figure-corner-3 = Esquina 3
figure-corner-4 = Esquina 4
figure-front = Rebaixamento frontal
figure-wall = Distância lateral
figure-drilling = Furação
figure-strategy = Estratégia de maquinagem
figure-pattern = Várias ranhuras
figure-side-allowance = Medida excedente lateral
figure-rounding = Raio das esquinas interiores
figure-between-points = Percurso entre os pontos de apalpação
way-rapid = marcha rápida
way-feed = avanço
way-probing = apalpação

cli-figure = Escrever as figuras de um ciclo como ficheiros SVG
cli-figure-out = A pasta das figuras; é criada se não existir
cli-examples-figure =
    ciklo figure 205 --control tnc640 --lang sl --out figures
cli-coverage-figures = { $count } de { $of } comprimentos, ângulos e posições sem figura: { $ids }

diag-figure-example-missing = A figura { $name } de { $cycle } deve ser desenhada a partir do exemplo { $example }, que o ciclo não tem.
diag-figure-moment-never = A execução da figura { $name } de { $cycle } nunca chega ao momento a mostrar ({ $reason }).
diag-figure-no-value = A figura { $figure } de { $cycle } mostra { $name } entre pontos que nesse momento não têm valor.
diag-figure-no-centre = A figura { $figure } de { $cycle } mostra { $name } como ângulo, mas o centro falta ou não é um ponto.
diag-figure-axis-not-visible = A figura { $figure } de { $cycle } mostra { $name } ao longo de um eixo que a vista não contém.
diag-figure-mixed-places = A figura { $figure } de { $cycle } mostra { $name } entre uma coordenada e um ponto: as duas extremidades têm de ser do mesmo tipo.
diag-figure-measured-otherwise = A figura { $figure } de { $cycle } mostra { $name } entre pontos que na execução distam { $measured }; o valor é { $value }.
diag-figure-nothing-to-see = A figura { $figure } de { $cycle } mostra { $name } com o valor 0: não há nada para ver.
diag-figure-place-not-reached = A figura { $figure } de { $cycle } mostra { $name } até um ponto ({ $place }) que nem a ferramenta nem a peça alcançam.
diag-figure-none = O ciclo { $cycle } não tem figuras neste comando.
diag-figure-parameter-not-shown = Nenhuma figura de { $cycle } mostra { $name } e a especificação não indica o motivo.
