# O comando «texts».
cli-texts = Mostra o estado das traduções, aceita-as e troca-as com tradutores
cli-texts-action = O que fazer: status mostra o que está por fazer, accept regista que as traduções correspondem aos textos ingleses, export escreve um ficheiro para tradutores, import lê um de volta
cli-texts-input = import: o ficheiro do tradutor, XLIFF ou PO
cli-texts-lang = Só este idioma; pode ser repetido
cli-texts-file = status: só este ficheiro do idioma, por exemplo drilling.ftl; pode ser repetido
cli-texts-text = accept: o texto com esta chave ou, se KEY terminar em *, todos aqueles cuja chave começa assim; pode ser repetido
cli-texts-changed = accept: as traduções novas ou alteradas desde a última aceitação
cli-texts-all = accept: todas as traduções, também as que não foram alteradas apesar de o texto inglês ter mudado
cli-texts-to = export: o idioma para o qual se traduz; import: o idioma do ficheiro (predefinição: o que o ficheiro indica)
cli-texts-stale = export: só os textos desatualizados ou por aceitar; com --missing, ambos
cli-texts-missing = export: só os textos em falta; com --stale, ambos
cli-texts-cycle = export: só os textos deste ciclo; pode ser repetido
cli-texts-out = export: ficheiro a escrever (predefinição: saída padrão)
cli-texts-dry-run = import: verifica o ficheiro e informa, sem alterar nada
cli-texts-format = Forma da saída: text (predefinição), json; de export: xliff (1.2, predefinição), xliff2 (2.0), po
cli-texts-exported = { $count ->
        [one] { $count } unidade exportada.
       *[other] { $count } unidades exportadas.
    }
cli-texts-imported = { $language }: { $dry ->
        [yes] a adotar { $taken }
       *[no] adotadas { $taken }
    }, inalteradas { $unchanged }, não definitivas { $open }, recusadas { $refused }.
cli-texts-count = { $name }: { $translated } de { $texts } traduzidos, { $missing } em falta, { $stale } desatualizados, { $unaccepted } por aceitar, { $same } iguais ao inglês, { $long } demasiado longos, { $words } palavras por traduzir
cli-texts-accepted = { $language }: { $count ->
        [one] { $count } texto aceite.
       *[other] { $count } textos aceites.
    }
cli-texts-left = { $language }: não aceites, porque o texto inglês mudou e a tradução não: { $keys }. Para aceitar um texto tal como está, indique-o com «ciklo texts accept --text KEY».
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
