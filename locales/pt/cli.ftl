# A linha de comandos: ajuda, mensagens e indicações sobre ficheiros e palavras.

cli-about = Especificações de ciclos CNC como diálogos, frases NC, manuais, verificação e execução de programas
cli-explain-more = «ciklo explain { $code }» explica uma indicação e o que fazer.
cli-heading-usage = Utilização:
cli-heading-commands = Comandos
cli-heading-arguments = Argumentos
cli-heading-options = Opções
cli-heading-examples = Exemplos:

cli-build = Escreve os manuais, os diálogos e as tabelas de designações
cli-build-out = Pasta a escrever; só é substituída quando tudo estiver completo (predefinição: out)
cli-build-control = Só este comando numérico; pode repetir-se
cli-build-lang = Só este idioma; pode repetir-se
cli-build-base-url = Endereço que o site terá: acrescenta endereços canónicos, um mapa do site e ligações absolutas em 404.html
cli-schema = Mostra o esquema JSON das especificações
cli-lint = Indica tudo o que está errado nas especificações e nos idiomas
cli-lint-accept = Aceita as traduções novas ou alteradas desde a última aceitação
cli-coverage = Mostra o que está completo, em falta, desatualizado, não implementado e não testado
cli-dialog = Mostra o diálogo de um ciclo
cli-block = Escreve a frase NC de um ciclo
cli-block-values = Número do ciclo e valores de parâmetros, por exemplo Q321=50; os outros têm os valores do exemplo do manual
cli-block-number = Número da primeira frase (predefinição: o do exemplo do manual)
cli-block-form = Forma do ciclo, nos ciclos antigos que têm várias
cli-block-without = Campo opcional a omitir; pode repetir-se
cli-parse = Divide um programa em frases, como JSON
cli-parse-print = Escreve o programa inalterado, byte a byte
cli-check = Verifica programas para um comando numérico
cli-check-lang = Idioma das designações nos programas (predefinição: reconhecido)
cli-explain = Explica o código de uma indicação
cli-explain-code = O código; sem ele, são apresentados todos os códigos
cli-explain-renamed = O código «{ $old }» chama-se agora «{ $code }».
cli-translate = Escreve um programa com os nomes e designações de outro idioma; nada mais muda
cli-translate-to = Idioma dos nomes e designações
cli-translate-control = Comando numérico do programa (predefinição: reconhecido pelos ciclos)
cli-translate-out = Ficheiro a escrever (predefinição: saída padrão)
cli-run = Executa um programa numa cena
cli-run-tool-table = Tabela de ferramentas ou de ferramentas de tornear (.trn) a utilizar em vez da que está na cena; pode ser indicada para cada uma
cli-run-out = Pasta para as tabelas e os registos que o programa escreve
cli-run-events = Mostra cada evento como uma linha JSON
cli-run-skip-blocks = Salta as frases que começam por /
cli-run-lang = Idioma dos registos (predefinição: o das designações do programa NC, ou então o dos textos do próprio programa)
cli-run-envelope = Mostrar, em vez dos resultados, o que cada ciclo de apalpação faria no pior dos casos
cli-conform = Executa os exemplos das especificações
cli-conform-engine = Executa os exemplos com outro motor de execução, um programa que utiliza o protocolo de docs/conform-protocol.md
cli-conform-time-limit = Tempo máximo para um caso, em segundos (predefinição: 10)
cli-conform-serve = Responde a pedidos deste protocolo vindos da entrada padrão
cli-export = Escreve todos os ciclos de um comando numérico num só idioma, como JSON

cli-arg-cycle = Número do ciclo, por exemplo 412 ou TCH PROBE 412
cli-arg-file = Programa NC; «-» lê a entrada padrão
cli-arg-control = Comando numérico, por exemplo tnc640
cli-arg-lang = Idioma, por exemplo fi (predefinição: o dos textos do próprio programa)
cli-arg-scene = Ficheiro da cena: máquina, ferramentas, peça
cli-arg-format = Forma da saída: text (predefinição), json
cli-arg-report = Forma da saída: text (predefinição), json, junit
cli-arg-data = Pasta com cycle-specs, locales e templates a usar em vez dos dados incorporados
cli-arg-ui-lang = Idioma dos textos do próprio programa (predefinição: o do ambiente)
cli-arg-help = Mostra esta ajuda
cli-arg-version = Mostra a versão

cli-examples-build =
    ciklo build
    ciklo build --out manuals --control tnc640 --lang fi --lang sl
cli-examples-dialog =
    ciklo dialog 412 --control tnc640 --lang fi
    ciklo dialog TCH PROBE 0 --control tnc320 --lang it --format json
cli-examples-block =
    ciklo block 200 Q201=-30 Q202=5 --control tnc640 --lang sl
    ciklo block CYCL DEF 7 --control tnc640 --lang fi --number 13
cli-examples-parse =
    ciklo parse part.h
    ciklo parse part.h --print > copy.h
cli-examples-check =
    ciklo check part.h --control tnc640
    ciklo check programs --control itnc530 --format sarif > findings.sarif
    ciklo check programs --fix
cli-examples-translate =
    ciklo translate part.h --to it > pezzo.h
    ciklo translate part.h --to pt --control tnc426-430 --out peca.h
    ciklo translate teil.h --to en --relabel
cli-examples-run =
    ciklo run part.h --control tnc640
    ciklo run part.h --control tnc640 --scene part.scene.yaml --out results
    ciklo run part.h --control tnc640 --scene part.scene.yaml --events
    ciklo run part.h --control tnc640 --scene part.scene.yaml --stock part.stl --resolution 0.2
    ciklo run part.h --control tnc640 --scene part.scene.yaml --envelope
cli-examples-conform =
    ciklo conform
    ciklo conform --control tnc640 --cycle 200 --case three-infeeds
    ciklo conform --cycle "TCH PROBE 412" --list
    ciklo conform --control tnc320 --format junit > conform.xml
    ciklo conform --engine "my-engine --jsonl" --time-limit 5
cli-examples-coverage =
    ciklo coverage
    ciklo coverage --format json
cli-examples-lint =
    ciklo lint
    ciklo lint --data . --format json
    ciklo lint --only 200
    ciklo lint --summary
    ciklo lint --accept-translations
cli-examples-schema =
    ciklo schema > cycle.schema.json
cli-examples-explain =
    ciklo explain locale-missing-text
    ciklo explain
cli-examples-export =
    ciklo export --control tnc640 --lang sl > tnc640.json

cli-summary = { $errors ->
        [0] { $warnings ->
            [0] { $notes ->
                [0] Nada a assinalar.
               *[other] Sem erros nem avisos.
            }
            [one] Sem erros, { $warnings } aviso.
           *[other] Sem erros, { $warnings } avisos.
        }
        [one] { $errors } erro, { $warnings ->
            [0] nenhum aviso.
            [one] { $warnings } aviso.
           *[other] { $warnings } avisos.
        }
       *[other] { $errors } erros, { $warnings ->
            [0] nenhum aviso.
            [one] { $warnings } aviso.
           *[other] { $warnings } avisos.
        }
    }
cli-written = Escrito: { $path }
cli-building = Páginas
cli-built = Páginas: { $pages }, ficheiros: { $files }: { $path }
cli-coverage-control = { $control } ({ $title }): ciclos descritos { $described }, apenas mencionados { $named }
cli-coverage-complete = completo
cli-coverage-missing = { $language }: textos em falta { $count } de { $of }: { $ids }
cli-coverage-stale = { $language }: { $count } de { $of } textos desatualizados: { $ids }
cli-coverage-unexecuted = Passos não executados por nenhum exemplo: { $count } de { $of }: { $ids }
cli-coverage-unprovoked = Não provocado por nenhum exemplo: { $ids }

cli-translated = { $count ->
        [0] Nenhuma alteração: { $path }
        [one] { $count } alteração: { $path }
       *[other] { $count } alterações: { $path }
    }
cli-run-status = O programa { $status ->
        [done] foi executado até ao fim
        [stopped] parou e não foi continuado
        [limit] atingiu um limite da simulação
        [unsupported] precisa de uma função que não pode ser simulada
       *[error] terminou com um erro
    }.
cli-envelope-cycle = Linha { $line }: { $cycle } { $name }
cli-envelope-still = Nenhum movimento.
cli-envelope-lowest = Ponto mais baixo da ponta da haste: { $axis } = { $height } mm
cli-envelope-highest = Ponto mais alto da ponta da haste: { $axis } = { $height } mm
cli-envelope-travelled = Alturas dos movimentos no plano de maquinação: { $axis } = { $heights } mm
cli-envelope-probing = { $count ->
        [one] { $count } apalpação
       *[other] { $count } apalpações
    }, o percurso mais longo { $length } mm
cli-envelope-near = { $what ->
        [stock] Bloco
       *[part] Corpo { $number }
    }: distância mínima { $distance } mm, com a ponta em X = { $x }, Y = { $y }, Z = { $z }; { $probed ->
        [yes] ao alcance
       *[no] fora do alcance
    } dos movimentos de apalpação
cli-envelope-touches = { $what ->
        [stock] Peça em bruto, antes da maquinação: a ponta fica dentro dela,
       *[part] Corpo { $number }: COLISÃO,
    } com a ponta em X = { $x }, Y = { $y }, Z = { $z }
cli-envelope-near-unknown = { $what ->
        [stock] Bloco
       *[part] Corpo { $number }
    }: não é possível calcular a distância mínima; { $probed ->
        [yes] ao alcance
       *[no] fora do alcance
    } dos movimentos de apalpação
cli-envelope-fails = Nesta cena o ciclo termina com o erro { $code }: { $message }
cli-envelope-none = O programa não executa nenhum ciclo de apalpação.
cli-conform-pass = passou
cli-conform-fail = FALHOU
cli-conform-out = não suportado
cli-conform-skipped = omitido
cli-conform-mismatch = { $what }: esperado { $expected }, obtido { $found }
cli-conform-summary = Passaram: { $pass }, falharam: { $fail }, não suportados: { $out }, omitidos: { $skipped }.

cli-usage-hint = Queria dizer { $suggestion }?
cli-usage-help = Ver --help.

diag-unknown-software = «{ $found }» não é uma versão de software: introduza o número que o comando mostra, por exemplo 340590-05.
diag-usage = { $reason ->
        [no-value] { $subject } precisa de um valor.
        [invalid-value] «{ $value }» não é um valor válido para { $subject }.
        [unknown-argument] Não existe o argumento { $subject }.
        [unknown-command] Não existe o comando { $subject }.
        [no-command] Falta um comando.
        [missing-argument] Falta: { $subject }.
        [conflict] { $subject } aparece duas vezes ou não se pode combinar com os outros argumentos.
        [too-many-values] { $subject } tem demasiados valores.
        [not-text] Um argumento não é texto válido.
       *[other] A linha de comandos está errada.
    } { $hint }
diag-io-read = Não é possível ler { $path }: { $reason ->
        [not-found] não existe
        [permission] sem permissão
        [is-directory] é uma pasta
        [not-directory] não é uma pasta
        [link] é uma ligação a uma pasta, que não é seguida
       *[other] { $detail }
    }.
diag-io-write = Não é possível escrever { $path }: { $reason ->
        [not-found] a pasta não existe
        [permission] sem permissão
        [is-directory] é uma pasta
        [not-directory] uma parte do caminho não é uma pasta
        [full] não há mais espaço
        [read-only] o sistema de ficheiros é só de leitura
        [too-large] um ficheiro não pode ser tão grande
       *[other] { $detail }
    }.
diag-engine-start = Não é possível iniciar o motor «{ $path }»: { $reason ->
        [not-found] o programa não existe
        [permission] sem permissão
       *[other] { $detail }
    }.
diag-engine-not-responding = O motor de execução não respondeu a { $silent } casos seguidos, e os restantes não são enviados: { $left ->
        [one] { $left } caso.
       *[other] { $left } casos.
    }
diag-io-foreign-directory = { $path } contém ficheiros que o Ciklo não escreveu, e por isso não é substituída. Escolha uma pasta vazia ou nova.
diag-not-an-address = «{ $url }» não é um endereço que comece por https:// ou http://.
diag-data-directory-missing = Falta a pasta { $name } em { $path }.
diag-no-data = { $path } não contém nenhuma das pastas cycle-specs, locales e templates.
diag-data-encoding = { $path } não está em UTF-8.
diag-unknown-code = O código «{ $code }» não existe; «ciklo explain» indica todos.
diag-needs-data = { $option } precisa de uma cópia de trabalho: --data DIR.
diag-unknown-control = Não existe o comando numérico «{ $control }»; os comandos são { $known }.
diag-unknown-language = Não existe o idioma «{ $language }»; os idiomas são { $known }.
diag-cycle-name = «{ $cycle }» não é o número de um ciclo; são válidos, por exemplo, 412 e "TCH PROBE 412".
diag-cycle-not-here = O comando { $control } não tem o ciclo { $cycle }.
diag-cycle-ambiguous = O comando { $control } tem dois ciclos com o número { $cycle }: { $keys }.
diag-cycle-only-named = O manual do comando { $control } só menciona o nome de { $cycle } ({ $name }) e não o descreve.
diag-internal = Erro interno do Ciklo: { $detail }.
diag-locale-unknown-suffix = «{ $name }» não é o nome de um ciclo nem um comando numérico.
diag-not-encodable = O carácter «{ $sign }» não pode ser escrito na codificação deste ficheiro (Windows-1252).
cli-examples-plot =
    ciklo plot part.h --control tnc640 --out part.svg
    ciklo plot part.h --control tnc640 --scene part.scene.yaml --view top --out path.svg
cli-arg-resolution = Distância máxima entre as colunas do bloco, mm (predefinição: um ducentésimo da sua maior extensão)
cli-plot = Desenhar a trajetória da ferramenta e a peça de um programa em SVG
cli-plot-out = Ficheiro para o desenho
cli-plot-view = Direção da vista: top, side, isometric (predefinição)
cli-run-stock = Ficheiro para a peça acabada (STL), com um relatório da maquinação
cli-stock-depth = Maior profundidade de corte: { $value } mm (linha { $line })
cli-stock-finding = { $program }:{ $line }{ $count ->
        [one] :
       *[other] {" "}({ $count } movimentos):
    } { $kind ->
        [rapid-in-material] Avanço rápido através de { $amount } mm de material.
        [spindle-stopped] O cabeçote não roda enquanto a ferramenta atravessa { $amount } mm de material.
        [edges-too-short] O material é cortado até { $amount } mm acima da ponta da ferramenta, para lá da longitude das navalhas.
        [turns-together] Os eixos rotativos rodam enquanto a ferramenta se desloca: não se conhece o material retirado.
        [turned] A peça está a ser torneada, mas não é um sólido de revolução em torno do eixo de torneamento, ou foi fresada antes: o que a ferramenta { $amount } remove não é acompanhado.
        [insert-unknown] Nenhum ciclo indica como a pastilha da ferramenta { $amount } encontra a peça: não se conhece o material retirado.
        [thread-turned] A ferramenta { $amount } torneia uma rosca, que não faz parte do sólido acompanhado.
       *[no-radius] A ferramenta { $amount } não tem raio: não se conhece o material retirado.
    }
cli-stock-length = Percurso: { $feed } mm em avanço, dos quais { $cut } mm em movimentos que retiram material; { $rapid } mm em avanço rápido
cli-stock-more = { $count ->
        [one] Mais { $count } indicação.
       *[other] Mais { $count } indicações.
    }
cli-stock-rate = Maior taxa de remoção: { $value } mm³/min (linha { $line })
cli-stock-time = Tempo: { $all } s; { $feed } s em avanço, { $rapid } s em avanço rápido, { $dwell } s de tempo de espera
cli-stock-volume = Volume: { $removed } mm³ retirados de { $blank } mm³
cli-stock-width = Maior largura de corte: { $value } mm (linha { $line })
