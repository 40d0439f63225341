# O comando «texts».
cli-texts = Mostra o estado das traduções e aceita-as
cli-texts-action = O que fazer: status mostra o que está por fazer, accept regista que as traduções correspondem aos textos ingleses
cli-texts-lang = Só este idioma; pode ser repetido
cli-texts-file = status: só este ficheiro do idioma, por exemplo drilling.ftl; pode ser repetido
cli-texts-text = accept: o texto com esta chave ou, se KEY terminar em *, todos aqueles cuja chave começa assim; pode ser repetido
cli-texts-changed = accept: as traduções novas ou alteradas desde a última aceitação
cli-texts-all = accept: todas as traduções, também as que não foram alteradas apesar de o texto inglês ter mudado
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
