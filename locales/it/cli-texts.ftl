# Il comando «texts».
cli-texts = Mostra lo stato delle traduzioni, le approva e le scambia con i traduttori
cli-texts-action = Operazione: status mostra che cosa resta da fare, accept registra che le traduzioni corrispondono ai testi inglesi, export scrive un file per i traduttori, import ne rilegge uno
cli-texts-input = import: il file del traduttore, XLIFF o PO
cli-texts-lang = Solo questa lingua; si può ripetere
cli-texts-file = status: solo questo file della lingua, ad esempio drilling.ftl; si può ripetere
cli-texts-text = accept: il testo con questa chiave o, se KEY termina con *, tutti quelli la cui chiave inizia così; si può ripetere
cli-texts-changed = accept: le traduzioni nuove o modificate dopo l’ultima approvazione
cli-texts-all = accept: tutte le traduzioni, anche quelle non modificate il cui testo inglese è cambiato
cli-texts-to = export: la lingua in cui tradurre; import: la lingua del file (predefinita: quella indicata nel file)
cli-texts-stale = export: solo i testi superati o non approvati; con --missing, entrambi
cli-texts-missing = export: solo i testi mancanti; con --stale, entrambi
cli-texts-cycle = export: solo i testi di questo ciclo; si può ripetere
cli-texts-out = export: file da scrivere (predefinito: uscita standard)
cli-texts-dry-run = import: verifica il file e ne riferisce, senza modificare nulla
cli-texts-format = Forma dell’uscita: text (predefinita), json; per export: xliff (1.2, predefinita), xliff2 (2.0), po
cli-texts-exported = { $count ->
        [one] { $count } unità esportata.
       *[other] { $count } unità esportate.
    }
cli-texts-imported = { $language }: { $dry ->
        [yes] da riprendere { $taken }
       *[no] riprese { $taken }
    }, invariate { $unchanged }, non definitive { $open }, rifiutate { $refused }.
cli-texts-count = { $name }: { $translated } di { $texts } tradotti, { $missing } mancanti, { $stale } superati, { $unaccepted } non approvati, { $same } uguali all’inglese, { $long } troppo lunghi, { $words } parole da tradurre
cli-texts-accepted = { $language }: { $count ->
        [one] { $count } testo approvato.
       *[other] { $count } testi approvati.
    }
cli-texts-left = { $language }: non approvati perché il testo inglese è cambiato e la traduzione no: { $keys }. Per approvare un testo così com’è, indicarlo con «ciklo texts accept --text KEY».
cli-texts-open =
    { $state ->
        [missing] mancante: { $key } ({ $file })
        [stale] { $change ->
            [none] superato: { $key } ({ $file })
           *[other] superato: { $key } ({ $file }): { $change }
        }
        [unaccepted] non approvato: { $key } ({ $file })
       *[same] uguale all’inglese: { $key } ({ $file })
    }
cli-texts-more = { $count ->
        [one] e un altro
       *[other] e altri { $count }
    }
cli-examples-texts =
    ciklo texts status
    ciklo texts status --lang fi --file drilling.ftl --format json
    ciklo texts accept --changed
    ciklo texts accept --lang it --text step-approach
    ciklo texts export --to fi --stale --missing --out fi.xlf
    ciklo texts import fi.xlf --dry-run
