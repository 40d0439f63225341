# Palavras das figuras.

figure-section = Corte
figure-plan = Vista de cima
figure-chip-breaking = Rotura de apara
figure-decreasing-infeeds = Passos decrescentes
figure-deepened-start = Ponto de partida aprofundado
figure-centring-diameter = Centragem até ao diâmetro
figure-rotation = Ângulo de rotação
figure-pocket-position = Posição na chamada
figure-milling-type = Fresagem em sentido sincronizado e em sentido contrário
figure-allowances = Medidas excedentes de acabamento
figure-slot-position = Posição na chamada
figure-stud-position = Posição na chamada
figure-approach = Posição de aproximação
figure-stepping-angle = Passo angular
figure-traverse = Percurso entre maquinações
figure-plunging = Penetração
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
figure-strategy = Estratégia de maquinação
figure-pattern = Várias ranhuras
figure-side-allowance = Medida excedente lateral
figure-rounding = Raio das esquinas interiores
figure-between-points = Percurso entre os pontos de apalpação
figure-between-holes = Percurso entre as posições
figure-depth-or-diameter = Profundidade ou diâmetro
figure-threads-per-step = Voltas ou hélices
figure-countersinking-moment = Momento do rebaixamento
figure-finishing-counter-clockwise = Acabamento em sentido anti-horário, Q9 = +1
figure-finishing-clockwise = Acabamento em sentido horário, Q9 = −1
figure-train-climb = Fresagem em sentido sincronizado, Q15 = +1
figure-train-up-cut = Fresagem em sentido contrário, Q15 = −1
figure-train-to-and-fro = Em vaivém, Q15 = 0
figure-operation = Tipo de maquinação
figure-no-contact = Percurso sem contacto
way-rapid = avanço rápido
way-feed = avanço
way-probing = apalpação

cli-figure = Escrever as figuras de um ciclo como ficheiros SVG
cli-figure-out = A pasta das figuras; é criada se não existir
cli-examples-figure =
    ciklo figure 205 --control tnc640 --lang sl --out figures
cli-coverage-figures = { $count } de { $of } comprimentos, ângulos e posições sem figura: { $ids }

diag-figure-example-missing = A figura { $name } de { $cycle } deve ser desenhada a partir do exemplo { $example }, que o ciclo não tem.
diag-figure-moment-never = A execução da figura { $name } de { $cycle } nunca chega ao momento a mostrar ({ $reason }).
diag-figure-name-taken = Duas figuras de { $cycle } têm o mesmo nome { $name }.
diag-figure-no-value = A figura { $figure } de { $cycle } mostra { $name } entre pontos que nesse momento não têm valor.
diag-figure-no-centre = A figura { $figure } de { $cycle } mostra { $name } como ângulo, mas o centro falta ou não é um ponto.
diag-figure-axis-not-visible = A figura { $figure } de { $cycle } mostra { $name } ao longo de um eixo que a vista não contém.
diag-figure-mixed-places = A figura { $figure } de { $cycle } mostra { $name } entre uma coordenada e um ponto: as duas extremidades têm de ser do mesmo tipo.
diag-figure-measured-otherwise = A figura { $figure } de { $cycle } mostra { $name } entre pontos que na execução distam { $measured }; o valor é { $value }.
diag-figure-nothing-to-see = A figura { $figure } de { $cycle } mostra { $name } com o valor 0: não há nada para ver.
diag-figure-place-not-reached = A figura { $figure } de { $cycle } mostra { $name } até um ponto ({ $place }) que nem a ferramenta nem a peça alcançam.
diag-figure-none = O ciclo { $cycle } não tem figuras neste comando.
diag-figure-parameter-not-shown = Nenhuma figura de { $cycle } mostra { $name } e a especificação não indica o motivo.
figure-teeth = Navalhas no apalpador de ferramentas
figure-turning-tool = Ferramenta a rodar
figure-single-teeth = Navalhas individuais
figure-line-angle = Ângulo das linhas
figure-rotary-a = Ao longo do eixo rotativo A
figure-rotary-b = Ao longo do eixo rotativo B
figure-rotary-c = Ao longo do eixo rotativo C
figure-backlash = Folga
figure-sphere = Apalpação da esfera de calibração
figure-basic-rotation = Rotação básica
figure-greatest-dimension = Medida maior
figure-least-dimension = Medida menor
figure-centre-tolerance = Tolerância do centro
figure-spatial-angle-a = Ângulo espacial A
figure-spatial-angle-b = Ângulo espacial B
figure-spatial-angle-c = Ângulo espacial C
figure-counterbore = Rebaixo
figure-disengaging = Direção de afastamento livre
figure-pre-drilled = Furo prévio
figure-touch-points = Pontos de apalpação
figure-measuring-axis = Eixo de medição
figure-traverse-direction = Direção de deslocação
figure-straight-or-circle = Em linha reta ou em círculo
figure-program = O programa visto de cima
figure-program-turned = O programa: metade da peça em corte
figure-program-recess = O programa: a ranhura
figure-program-side = O programa visto de lado
figure-program-across = O programa ao longo do eixo rotativo
figure-program-tilted = O plano inclinado do programa
figure-wide-slot = Ranhura larga
