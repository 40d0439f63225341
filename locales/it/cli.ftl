# La riga di comando: guida, messaggi e segnalazioni su file e parole.

cli-about = Specifiche di cicli CNC come dialoghi, blocchi NC, manuali, verifica ed esecuzione dei programmi
cli-explain-more = «ciklo explain { $code }» spiega una segnalazione e il rimedio.
cli-heading-usage = Uso:
cli-heading-commands = Comandi
cli-heading-arguments = Argomenti
cli-heading-options = Opzioni
cli-heading-examples = Esempi:

cli-build = Scrive i manuali, i dialoghi e le tabelle delle etichette
cli-build-out = Cartella da scrivere; viene sostituita solo quando tutto è completo (predefinita: out)
cli-build-control = Solo questo controllo numerico; ripetibile
cli-build-lang = Solo questa lingua; ripetibile
cli-build-base-url = Indirizzo che avrà il sito: aggiunge indirizzi canonici, una mappa del sito e link assoluti in 404.html
cli-schema = Stampa lo schema JSON delle specifiche
cli-lint = Segnala tutto ciò che è errato nelle specifiche e nelle lingue
cli-lint-accept = Approva le traduzioni nuove o modificate dopo l’ultima approvazione
cli-coverage = Mostra che cosa è completo, mancante, superato, non realizzato e non provato
cli-dialog = Mostra il dialogo di un ciclo
cli-block = Scrive il blocco NC di un ciclo
cli-block-values = Numero del ciclo e valori dei parametri, ad esempio Q321=50; gli altri hanno i valori dell’esempio del manuale
cli-block-number = Numero del primo blocco (predefinito: quello dell’esempio del manuale)
cli-block-form = Forma del ciclo, per i cicli meno recenti che ne hanno più d’una
cli-block-without = Campo facoltativo da tralasciare; ripetibile
cli-parse = Scompone un programma in blocchi, in formato JSON
cli-parse-print = Stampa il programma invariato, byte per byte
cli-check = Verifica programmi per un controllo numerico
cli-check-lang = Lingua delle etichette nei programmi (predefinita: riconosciuta)
cli-explain = Spiega il codice di una segnalazione
cli-explain-code = Il codice; senza, vengono elencati tutti i codici
cli-explain-renamed = Il codice «{ $old }» si chiama ora «{ $code }».
cli-translate = Scrive un programma con i nomi e le etichette di un’altra lingua; nient’altro cambia
cli-translate-to = Lingua dei nomi e delle etichette
cli-translate-control = Controllo numerico del programma (predefinito: riconosciuto dai cicli)
cli-translate-out = File da scrivere (predefinito: uscita standard)
cli-run = Esegue un programma in una scena
cli-run-tool-table = Tabella degli utensili o degli utensili per tornire (.trn) da usare al posto di quella nella scena; può essere indicata per ciascuna
cli-run-out = Cartella per le tabelle e i protocolli scritti dal programma
cli-run-events = Stampa ogni evento come riga JSON
cli-run-skip-blocks = Salta i blocchi che cominciano con /
cli-run-lang = Lingua dei protocolli (predefinita: quella delle etichette del programma NC, altrimenti quella dei testi del programma stesso)
cli-run-envelope = Mostra, al posto dei risultati, che cosa farebbe nel caso peggiore ogni ciclo di tastatura
cli-conform = Esegue gli esempi delle specifiche
cli-conform-engine = Esegue gli esempi su un altro motore, un comando che usa il protocollo di docs/conform-protocol.md
cli-conform-time-limit = Tempo massimo per un caso di prova, in secondi (predefinito: 10)
cli-conform-serve = Risponde alle richieste di questo protocollo dall’ingresso standard
cli-export = Stampa tutti i cicli di un controllo numerico in una lingua, in formato JSON

cli-arg-cycle = Numero del ciclo, ad esempio 412 o TCH PROBE 412
cli-arg-file = Programma NC; «-» legge l’ingresso standard
cli-arg-control = Controllo numerico, ad esempio tnc640
cli-arg-lang = Lingua, ad esempio fi (predefinita: quella dei testi del programma stesso)
cli-arg-scene = File della scena: macchina, utensili, pezzo
cli-arg-format = Forma dell’uscita: text (predefinita), json
cli-arg-report = Forma dell’uscita: text (predefinita), json, junit
cli-arg-data = Cartella con cycle-specs, locales e templates da usare al posto dei dati incorporati
cli-arg-ui-lang = Lingua dei testi del programma stesso (predefinita: quella dell’ambiente)
cli-arg-help = Mostra questa guida
cli-arg-version = Mostra la versione

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
                [0] Nessuna segnalazione.
               *[other] Nessun errore, nessun avviso.
            }
            [one] Nessun errore, { $warnings } avviso.
           *[other] Nessun errore, { $warnings } avvisi.
        }
        [one] { $errors } errore, { $warnings ->
            [one] { $warnings } avviso.
           *[other] { $warnings } avvisi.
        }
       *[other] { $errors } errori, { $warnings ->
            [one] { $warnings } avviso.
           *[other] { $warnings } avvisi.
        }
    }
cli-written = Scritto: { $path }
cli-building = Pagine
cli-built = Pagine: { $pages }, file: { $files }: { $path }
cli-coverage-control = { $control } ({ $title }): cicli descritti { $described }, solo nominati { $named }
cli-coverage-complete = completo
cli-coverage-missing = { $language }: testi mancanti: { $count } su { $of }: { $ids }
cli-coverage-stale = { $language }: { $count } testi superati su { $of }: { $ids }
cli-coverage-unexecuted = Frasi che nessun esempio esegue: { $count } su { $of }: { $ids }
cli-coverage-unprovoked = Mai provocati da un esempio: { $ids }

cli-translated = { $count ->
        [one] { $count } modifica: { $path }
       *[other] { $count } modifiche: { $path }
    }
cli-run-status = Il programma { $status ->
        [done] è stato eseguito fino alla fine
        [stopped] si è arrestato e non è stato ripreso
        [limit] ha raggiunto un limite della simulazione
        [unsupported] richiede una funzione che non si può simulare
       *[error] è terminato con un errore
    }.
cli-envelope-cycle = Riga { $line }: { $cycle } { $name }
cli-envelope-still = Nessun movimento.
cli-envelope-lowest = Punto più basso della punta dello stilo: { $axis } = { $height } mm
cli-envelope-highest = Punto più alto della punta dello stilo: { $axis } = { $height } mm
cli-envelope-travelled = Altezze dei movimenti nel piano di lavoro: { $axis } = { $heights } mm
cli-envelope-probing = { $count ->
        [one] { $count } tastatura
       *[other] { $count } tastature
    }, percorso più lungo { $length } mm
cli-envelope-near = { $what ->
        [stock] Pezzo grezzo
       *[part] Corpo { $number }
    }: distanza minima { $distance } mm, con la punta a X = { $x }, Y = { $y }, Z = { $z }; { $probed ->
        [yes] entro la
       *[no] fuori dalla
    } portata dei movimenti di tastatura
cli-envelope-touches = { $what ->
        [stock] Pezzo grezzo, prima della lavorazione: la punta è al suo interno,
       *[part] Corpo { $number }: COLLISIONE,
    } con la punta a X = { $x }, Y = { $y }, Z = { $z }
cli-envelope-near-unknown = { $what ->
        [stock] Pezzo grezzo
       *[part] Corpo { $number }
    }: la distanza minima non si può calcolare; { $probed ->
        [yes] entro la
       *[no] fuori dalla
    } portata dei movimenti di tastatura
cli-envelope-fails = In questa scena il ciclo termina con l’errore { $code }: { $message }
cli-envelope-none = Il programma non esegue alcun ciclo di tastatura.
cli-conform-pass = riuscito
cli-conform-fail = FALLITO
cli-conform-out = non supportato
cli-conform-skipped = tralasciato
cli-conform-mismatch = { $what }: atteso { $expected }, trovato { $found }
cli-conform-summary = Riusciti: { $pass }, falliti: { $fail }, non supportati: { $out }, tralasciati: { $skipped }.

cli-usage-hint = Si intendeva { $suggestion }?
cli-usage-help = Vedere --help.

diag-unknown-software = «{ $found }» non è una versione software: immettere il numero che il controllo mostra, ad esempio 340590-05.
diag-usage = { $reason ->
        [no-value] { $subject } richiede un valore.
        [invalid-value] «{ $value }» non è un valore valido per { $subject }.
        [unknown-argument] L’argomento { $subject } non esiste.
        [unknown-command] Il comando { $subject } non esiste.
        [no-command] Manca un comando.
        [missing-argument] Manca: { $subject }.
        [conflict] { $subject } compare due volte o non si può combinare con gli altri argomenti.
        [too-many-values] { $subject } ha troppi valori.
        [not-text] Un argomento non è testo valido.
       *[other] La riga di comando è errata.
    } { $hint }
diag-io-read = Impossibile leggere { $path }: { $reason ->
        [not-found] non esiste
        [permission] permesso negato
        [is-directory] è una cartella
        [not-directory] non è una cartella
        [link] è un collegamento a una cartella, che non viene seguito
       *[other] { $detail }
    }.
diag-io-write = Impossibile scrivere { $path }: { $reason ->
        [not-found] la cartella non esiste
        [permission] permesso negato
        [is-directory] è una cartella
        [not-directory] una parte del percorso non è una cartella
        [full] non c’è più spazio
        [read-only] il file system è di sola lettura
        [too-large] un file non può essere così grande
       *[other] { $detail }
    }.
diag-engine-start = Impossibile avviare il motore «{ $path }»: { $reason ->
        [not-found] il programma non esiste
        [permission] permesso negato
       *[other] { $detail }
    }.
diag-engine-not-responding = Il motore non ha risposto a { $silent } casi di prova di seguito, perciò i rimanenti non vengono inviati: { $left ->
        [one] { $left } caso di prova.
       *[other] { $left } casi di prova.
    }
diag-io-foreign-directory = { $path } contiene file che Ciklo non ha scritto, perciò non viene sostituita. Scegliere una cartella vuota o nuova.
diag-not-an-address = «{ $url }» non è un indirizzo che inizia con https:// o http://.
diag-data-directory-missing = Manca la cartella { $name } in { $path }.
diag-no-data = { $path } non contiene né la cartella cycle-specs né locales né templates.
diag-data-encoding = { $path } non è in UTF-8.
diag-unknown-code = Il codice «{ $code }» non esiste; «ciklo explain» li elenca tutti.
diag-needs-data = { $option } richiede una copia di lavoro: --data DIR.
diag-unknown-control = Il controllo numerico «{ $control }» non esiste; i controlli numerici sono { $known }.
diag-unknown-language = La lingua «{ $language }» non esiste; le lingue sono { $known }.
diag-cycle-name = «{ $cycle }» non è il numero di un ciclo; sono validi, ad esempio, 412 e "TCH PROBE 412".
diag-cycle-not-here = Il controllo { $control } non ha il ciclo { $cycle }.
diag-cycle-ambiguous = { $control } ha due cicli con il numero { $cycle }: { $keys }.
diag-cycle-only-named = Il manuale di { $control } menziona { $cycle } ({ $name }) soltanto per nome e non lo descrive.
diag-internal = Errore interno di Ciklo: { $detail }.
diag-locale-unknown-suffix = «{ $name }» non è né il nome di un ciclo né un controllo numerico.
diag-not-encodable = Il carattere «{ $sign }» non può essere scritto nella codifica di questo file (Windows-1252).
cli-examples-plot =
    ciklo plot part.h --control tnc640 --out part.svg
    ciklo plot part.h --control tnc640 --scene part.scene.yaml --view top --out path.svg
cli-arg-resolution = Distanza massima tra le colonne del pezzo grezzo, in mm (predefinito: un duecentesimo della sua estensione massima)
cli-plot = Disegna la traiettoria dell’utensile e il pezzo di un programma in formato SVG
cli-plot-out = File per il disegno
cli-plot-view = Direzione di vista: top, side, isometric (valore predefinito)
cli-run-stock = File per il pezzo finito (STL), con un rapporto sulla lavorazione
cli-stock-depth = Profondità di taglio massima: { $value } mm (riga { $line })
cli-stock-finding = { $program }:{ $line }{ $count ->
        [one] :
       *[other] {" "}({ $count } movimenti):
    } { $kind ->
        [rapid-in-material] Movimento in rapido attraverso { $amount } mm di materiale.
        [spindle-stopped] Il mandrino è fermo mentre l’utensile attraversa { $amount } mm di materiale.
        [edges-too-short] Il materiale viene asportato fino a { $amount } mm sopra la punta dell’utensile, oltre la lunghezza dei taglienti.
        [turns-together] Gli assi rotativi ruotano mentre l’utensile si sposta: il materiale asportato non è noto.
        [turned] Il pezzo viene tornito, ma non è un solido di rotazione attorno all’asse di tornitura oppure è stato fresato in precedenza: ciò che l’utensile { $amount } asporta non viene seguito.
        [insert-unknown] Nessun ciclo indica come l’inserto dell’utensile { $amount } incontra il pezzo: il materiale asportato non è noto.
        [thread-turned] L’utensile { $amount } tornisce una filettatura, che non fa parte del solido seguito.
       *[no-radius] L’utensile { $amount } non ha raggio: il materiale asportato non è noto.
    }
cli-stock-length = Percorso: { $feed } mm in avanzamento, di cui { $cut } mm in movimenti che asportano materiale; { $rapid } mm in rapido
cli-stock-more = { $count ->
        [one] Ancora { $count } osservazione.
       *[other] Ancora { $count } osservazioni.
    }
cli-stock-rate = Portata di truciolo massima: { $value } mm³/min (riga { $line })
cli-stock-time = Tempo: { $all } s; { $feed } s in avanzamento, { $rapid } s in rapido, { $dwell } s di tempo di sosta
cli-stock-volume = Volume: { $removed } mm³ asportati su { $blank } mm³
cli-stock-width = Larghezza di taglio massima: { $value } mm (riga { $line })
