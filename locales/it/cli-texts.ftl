# Il comando «texts».
cli-texts = Mostra lo stato delle traduzioni, le approva e le scambia con i traduttori
cli-texts-action = Operazione: status mostra che cosa resta da fare, accept registra che le traduzioni corrispondono ai testi inglesi, export scrive un file per i traduttori, import ne rilegge uno
cli-texts-input = import: i file dei traduttori, XLIFF o PO, oppure termini in TBX o CSV; più file sono ripresi insieme
cli-texts-lang = Solo questa lingua; si può ripetere
cli-texts-file = status: solo questo file della lingua, ad esempio drilling.ftl; si può ripetere
cli-texts-text = accept: il testo con questa chiave o, se KEY termina con *, tutti quelli la cui chiave inizia così; si può ripetere
cli-texts-changed = accept: le traduzioni nuove o modificate dopo l’ultima approvazione
cli-texts-all = accept: tutte le traduzioni, anche quelle non modificate il cui testo inglese è cambiato
cli-texts-to = export: la lingua in cui tradurre; import: la lingua del file (predefinita: quella indicata nel file)
cli-texts-stale = export: solo i testi superati o non approvati; con --missing, entrambi
cli-texts-missing = export: solo i testi mancanti; con --stale, entrambi
cli-texts-cycle = export: solo i testi di questo ciclo; si può ripetere
cli-texts-copy-source = export: scrive il testo inglese dove manca la traduzione; per programmi che traducono sul posto
cli-texts-out = export: file da scrivere (predefinito: uscita standard)
cli-texts-any-state = import: considera definitiva ogni unità tradotta; per programmi che non conservano gli stati
cli-texts-dry-run = import: verifica il file e ne riferisce, senza modificare nulla
cli-texts-format = Forma dell’uscita: text (predefinita), json; per export: xliff (1.2, predefinita), xliff2 (2.0), po, tmx (testi approvati di tutte le lingue), tbx e csv (glossario e parametri)
cli-texts-exported = { $count ->
        [one] { $count } unità esportata.
       *[other] { $count } unità esportate.
    }
cli-texts-imported = { $language }: { $dry ->
        [yes] da riprendere { $taken }
       *[no] riprese { $taken }
    }, invariate { $unchanged }, non definitive { $open }, rifiutate { $refused }.
cli-texts-count = { $name }: { $translated } di { $texts } tradotti, { $missing } mancanti, { $stale } superati, { $unaccepted } non approvati, { $same } uguali all’inglese, { $long } troppo lunghi, { $words } parole da tradurre
cli-texts-group = gruppo { $name }
cli-texts-accepted = { $language }: { $count ->
        [one] { $count } testo approvato.
       *[other] { $count } testi approvati.
    }
cli-texts-left = { $language }: non approvati perché il testo inglese è cambiato e la traduzione no: { $keys }. Per approvare un testo così com’è, indicarlo con «ciklo texts accept --text KEY».
cli-texts-moved = { $language }: non approvati perché hanno ora le parole di altri testi: { $keys }. Per approvare un testo così com’è, indicarlo con «ciklo texts accept --text KEY».
cli-texts-new = { $language }: non approvati perché nuovi: { $keys }. «ciklo texts accept --changed» li approva.
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
    ciklo texts export --format tbx --out terms.tbx
cli-texts-topic = export: solo la pagina di questo argomento; si può ripetere
cli-texts-base-url = export: l’indirizzo del sito generato, per i collegamenti alle pagine nelle note
# What a translator is told about a text.
cli-texts-note-kind = Questo testo è { $kind ->
        [inserted] una parola che altri testi inseriscono nella forma richiesta
        [topic] un segmento di una pagina di prosa
        [group] il nome di un gruppo di cicli
        [cycle] il nome di un ciclo
        [parameter] il nome di un parametro
        [step] una frase dell’esecuzione di un ciclo
        [until] una condizione con cui termina una ripetizione
        [condition] una condizione che completa «solo se»
        [choice] una scelta di un parametro
        [result] un risultato di un ciclo
        [note] una nota su un ciclo
        [guard] il motivo per cui il controllo rifiuta un ciclo
        [message] un messaggio del controllo all’operatore
        [figure] il titolo di una figura
        [form] il nome di una forma del blocco di un ciclo
        [table] il titolo di una tabella
        [title] il titolo di un esempio
        [comment] un commento in un programma di esempio
        [term] un termine del glossario
        [log] una riga di un protocollo scritto da un ciclo
        [diagnostic] una segnalazione del programma
        [explanation] la spiegazione di una segnalazione
        [gap] una parola al posto di un argomento
        [command] un aiuto o messaggio di un comando
        [unit] un’unità
        [list] il modo di unire un elenco
        [page] una parola delle pagine del manuale
        [label] il commento dopo un parametro nei programmi NC
        [nc] il nome del ciclo nei programmi NC
        [word] la parola stampata di un campo nei programmi NC
        [help] il significato di un parametro
        [purpose] lo scopo di un ciclo
        [definition] la definizione di un termine
        [prompt] la domanda del dialogo
        [symbol] il simbolo di un’unità
       *[other] un testo del programma
    }.
cli-texts-note-unit = Unità: { $unit }.
cli-texts-note-range = Campo ammesso: { $range } ({ $controls }).
cli-texts-note-label = Al massimo { $most } caratteri: maiuscole, cifre, spazi e { $signs }
cli-texts-note-capitals = Solo maiuscole, cifre, spazi e { $signs }
cli-texts-note-length = Al massimo { $most } caratteri
cli-texts-note-cycles = { $more ->
        [none] { $control }: { $cycles }
       *[other] { $control }: { $cycles } e altri { $more }
    }
cli-texts-note-lines = Fonte nei manuali del { $control }, { $cycle }: { $lines }.
cli-texts-note-page = Pagina: { $page }
# Languages in the making, and the pseudo-language.
cli-build-draft = Genera una lingua non completa: ciò che manca è in inglese, contrassegnato, e ogni pagina lo dice
cli-draft = { $language }: mancano { $count } testi; sono in inglese, tra ⟦ ⟧.
cli-arg-pseudo = Mostra i testi in una pseudolingua, per vedere che cosa è tagliato o non tradotto: accents (parole più lunghe con accenti) o bidi (anche da destra a sinistra)
