# O comando «texts».
cli-texts = Mostra o estado das traduções, aceita-as e troca-as com tradutores
cli-texts-action = O que fazer: status mostra o que está por fazer, accept regista que as traduções correspondem aos textos ingleses, export escreve um ficheiro para tradutores, import lê um de volta
cli-texts-input = import: os ficheiros dos tradutores, XLIFF ou PO, ou termos em TBX ou CSV; vários são aplicados em conjunto
cli-texts-lang = Só este idioma; pode ser repetido
cli-texts-file = status: só este ficheiro do idioma, por exemplo drilling.ftl; pode ser repetido
cli-texts-text = accept: o texto com esta chave ou, se KEY terminar em *, todos aqueles cuja chave começa assim; pode ser repetido
cli-texts-changed = accept: as traduções novas ou alteradas desde a última aceitação
cli-texts-all = accept: todas as traduções, também as que não foram alteradas apesar de o texto inglês ter mudado
cli-texts-to = export: o idioma para o qual se traduz; import: o idioma do ficheiro (predefinição: o que o ficheiro indica)
cli-texts-stale = export: só os textos desatualizados ou por aceitar; com --missing, ambos
cli-texts-missing = export: só os textos em falta; com --stale, ambos
cli-texts-cycle = export: só os textos deste ciclo; pode ser repetido
cli-texts-copy-source = export: escreve o texto inglês onde falta a tradução; para programas que traduzem no próprio lugar
cli-texts-out = export: ficheiro a escrever (predefinição: saída padrão)
cli-texts-any-state = import: considera definitivas todas as unidades traduzidas; para programas que não guardam estados
cli-texts-dry-run = import: verifica o ficheiro e informa, sem alterar nada
cli-texts-format = Forma da saída: text (predefinição), json; de export: xliff (1.2, predefinição), xliff2 (2.0), po, tmx (textos aceites de todos os idiomas), tbx e csv (glossário e parâmetros)
cli-texts-exported = { $count ->
        [one] { $count } unidade exportada.
       *[other] { $count } unidades exportadas.
    }
cli-texts-imported = { $language }: { $dry ->
        [yes] a adotar { $taken }
       *[no] adotadas { $taken }
    }, inalteradas { $unchanged }, não definitivas { $open }, recusadas { $refused }.
cli-texts-count = { $name }: { $translated } de { $texts } traduzidos, { $missing } em falta, { $stale } desatualizados, { $unaccepted } por aceitar, { $same } iguais ao inglês, { $long } demasiado longos, { $words } palavras por traduzir
cli-texts-group = grupo { $name }
cli-texts-accepted = { $language }: { $count ->
        [one] { $count } texto aceite.
       *[other] { $count } textos aceites.
    }
cli-texts-left = { $language }: não aceites, porque o texto inglês mudou e a tradução não: { $keys }. Para aceitar um texto tal como está, indique-o com «ciklo texts accept --text KEY».
cli-texts-moved = { $language }: não aceites, porque têm agora as palavras de outros textos: { $keys }. Para aceitar um texto tal como está, indique-o com «ciklo texts accept --text KEY».
cli-texts-new = { $language }: não aceites, porque são novos: { $keys }. «ciklo texts accept --changed» aceita-os.
cli-texts-open =
    { $state ->
        [missing] em falta: { $key } ({ $file })
        [stale] { $change ->
            [none] desatualizado: { $key } ({ $file })
           *[other] desatualizado: { $key } ({ $file }): { $change }
        }
        [unaccepted] por aceitar: { $key } ({ $file })
       *[same] igual ao inglês: { $key } ({ $file })
    }
cli-texts-more = { $count ->
        [one] e mais { $count }
       *[other] e mais { $count }
    }
cli-examples-texts =
    ciklo texts status
    ciklo texts status --lang fi --file drilling.ftl --format json
    ciklo texts accept --changed
    ciklo texts accept --lang it --text step-approach
    ciklo texts export --to fi --stale --missing --out fi.xlf
    ciklo texts import fi.xlf --dry-run
    ciklo texts export --format tbx --out terms.tbx
cli-texts-topic = export: só a página deste tema; pode ser repetido
cli-texts-base-url = export: o endereço do sítio gerado, para as ligações às páginas nas notas
# What a translator is told about a text.
cli-texts-note-kind = Este texto é { $kind ->
        [inserted] uma palavra que outros textos inserem na forma pedida
        [topic] um segmento de uma página de prosa
        [group] o nome de um grupo de ciclos
        [cycle] o nome de um ciclo
        [parameter] o nome de um parâmetro
        [step] uma frase da execução de um ciclo
        [until] uma condição com que termina uma repetição
        [condition] uma condição que completa «só se»
        [choice] uma opção de um parâmetro
        [result] um resultado de um ciclo
        [note] uma nota sobre um ciclo
        [guard] o motivo por que o comando recusa um ciclo
        [message] uma mensagem do comando ao operador
        [figure] o título de uma figura
        [form] o nome de uma forma do bloco de um ciclo
        [table] o título de uma tabela
        [title] o título de um exemplo
        [comment] um comentário num programa de exemplo
        [term] um termo do glossário
        [log] uma linha de um protocolo que um ciclo escreve
        [diagnostic] uma ocorrência assinalada pelo programa
        [explanation] a explicação de uma ocorrência
        [gap] uma palavra no lugar de um argumento
        [command] uma ajuda ou mensagem de um comando
        [unit] uma unidade
        [list] o modo de juntar uma lista
        [page] uma palavra das páginas do manual
        [label] o comentário depois de um parâmetro em programas NC
        [nc] o nome do ciclo em programas NC
        [word] a palavra impressa de um campo em programas NC
        [help] o significado de um parâmetro
        [purpose] a finalidade de um ciclo
        [definition] a definição de um termo
        [prompt] a pergunta do diálogo
        [symbol] o símbolo de uma unidade
       *[other] um texto do programa
    }.
cli-texts-note-unit = Unidade: { $unit }.
cli-texts-note-range = Gama permitida: { $range } ({ $controls }).
cli-texts-note-label = No máximo { $most } caracteres: maiúsculas, algarismos, espaços e { $signs }
cli-texts-note-capitals = Só maiúsculas, algarismos, espaços e { $signs }
cli-texts-note-length = No máximo { $most } caracteres
cli-texts-note-cycles = { $more ->
        [none] { $control }: { $cycles }
       *[other] { $control }: { $cycles } e mais { $more }
    }
cli-texts-note-lines = Fonte nos manuais do { $control }, { $cycle }: { $lines }.
cli-texts-note-page = Página: { $page }
# Languages in the making, and the pseudo-language.
cli-build-draft = Gera um idioma que não está completo: o que falta fica em inglês, assinalado, e cada página o diz
cli-draft = { $language }: faltam { $count } textos; estão em inglês, entre ⟦ ⟧.
cli-arg-pseudo = Mostra os textos num pseudoidioma, para ver o que é cortado ou não está traduzido: accents (palavras mais longas com acentos) ou bidi (também da direita para a esquerda)
