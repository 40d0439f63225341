# Rilievi sui file delle lingue.

diag-locale-encoding = Questo file non è in UTF-8.
diag-locale-tag = Il nome della cartella «{ $tag }» non è un codice di lingua.
diag-locale-nesting = Le parentesi graffe superano { $most } livelli; il file non viene letto.
diag-locale-long-number = Un numero ha più di { $most } cifre di seguito; il file non viene letto.
diag-locale-syntax =
    Questo non è Fluent: { $kind ->
        [expected-token] qui è atteso «{ $detail }»
        [expected-character] qui è atteso uno dei caratteri { $detail }
        [empty-message] il messaggio «{ $detail }» non ha né valore né attributi
        [empty-term] il termine «-{ $detail }» non ha un valore
        [bad-function-name] il nome di una funzione ha maiuscole, cifre, «-» e «_»
        [no-default] una selezione richiede un caso predefinito, contrassegnato da «*»
        [two-defaults] una selezione ha un solo caso predefinito
        [no-value] qui è atteso un valore
        [bad-selector] si seleziona in base a un argomento, una funzione o un attributo di un termine
        [term-attribute] l’attributo di un termine non può essere visualizzato
        [open-string] la stringa non è chiusa
        [argument-order] gli argomenti senza nome vanno per primi
        [argument-twice] l’argomento «{ $detail }» è indicato due volte
        [bad-escape] «{ $detail }» non è una sequenza di escape
        [closing-brace] una parentesi chiusa senza quella aperta
       *[no-expression] qui è attesa un’espressione
    }.
diag-locale-isolation-mark = Qui c’è un segno di isolamento della direzione; non deve arrivare nei programmi NC.
diag-locale-duplicate = «{ $key }» è definito due volte; conta anche un messaggio con il nome di un termine.
related-first-definition = prima definizione
diag-locale-variant = «{ $key }» non è un nome con al massimo due suffissi, per ciclo e controllo numerico.
diag-locale-unit-form = «{ $key }» non è un modello: un’unità ha testo e un { "{ $value }" }, un elenco ha { "{ $first }" } e { "{ $last }" } nel valore e nell’attributo «more».
diag-locale-unknown-reference = «{ $name }» non esiste.
diag-locale-unknown-function = La funzione «{ $name }» non esiste.
diag-locale-function-option = «{ $name }: { $value }» non è un’opzione di { $function }.
diag-locale-function-arguments = { $function } ha un numero errato di valori.
diag-locale-unknown-unit = L’unità «{ $name }» non esiste: il file units.ftl non ha un messaggio per essa.
diag-locale-term-argument = Il termine «-{ $term }» non usa «{ $name }».
diag-locale-term-value = Il termine «-{ $term }» non ha la forma «{ $value }» per «{ $name }».
diag-locale-term-needs = Il termine «-{ $term }» richiede qui «{ $name }».
diag-locale-cyclic = «{ $key }» contiene sé stesso.
diag-locale-unknown-language = Non ci sono file per la lingua «{ $language }».
diag-locale-missing-text = La lingua «{ $language }» non ha il testo «{ $key }»{ $file ->
        [none] {""}.
       *[other] ; il suo posto è in { $file }.
    }
diag-locale-missing-argument = Il testo «{ $key }» ({ $language }) usa «{ $name }», che qui non è disponibile.
diag-locale-function-failed =
    Nel testo «{ $key }» ({ $language }) non è possibile applicare { $name }: { $reason ->
        [not-a-number] il valore non è un numero
        [not-finite] il numero non è finito
        [no-unit] manca l’unità
        [unknown-unit] l’unità è sconosciuta
        [not-a-list] il valore non è un elenco
       *[unknown-type] il tipo di elenco è sconosciuto
    }.
diag-locale-too-long = Il testo «{ $key }» ({ $language }) ha troppi segnaposto.
diag-locale-lock-line = Una riga di questo file ha un identificatore e otto cifre esadecimali.
diag-locale-missing-translation = «{ $key }» non è tradotto nella lingua «{ $language }».
diag-locale-unfinished = Nella lingua «{ $language }» mancano { $count } testi. «ciklo texts status --lang { $language }» li conta per file e nomina i prossimi.
diag-locale-orphan = «{ $key }» ({ $language }) è superfluo: il testo inglese non esiste più.
diag-locale-stale =
    { $change ->
        [none] Il testo inglese di «{ $key }» è cambiato dopo la traduzione nella lingua «{ $language }».
       *[other] Il testo inglese di «{ $key }» è cambiato dopo la traduzione nella lingua «{ $language }»: { $change }.
    }
diag-locale-unrecorded = La traduzione di «{ $key }» nella lingua «{ $language }» non è ancora stata approvata.
diag-locale-moved = La traduzione di «{ $key }» nella lingua «{ $language }» ha ora le parole approvate per «{ $name }».
diag-locale-unknown-argument = «{ $key }» ({ $language }) usa l’argomento «{ $name }», che il testo inglese non ha.
