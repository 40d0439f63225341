## Errori nelle specifiche. $expected e $found provengono dal file o indicano un tipo di valore.

diag-spec-both-forms = Il ciclo ha parametri e righe nel vecchio formato; può essere scritto in una sola forma.
diag-spec-case-incomplete = Il caso { $name } richiede una scena e un risultato atteso, oppure un motivo per saltarlo.
diag-spec-case-never-reached = Questo caso non viene mai raggiunto: un caso precedente vale ogni volta che vale questo.
diag-spec-case-proves-nothing = Il caso { $name } non indica che cosa dimostra.
diag-spec-duplicate-choice = La scelta { $value } è presente due volte.
diag-spec-duplicate-cycle = { $cycle } ({ $name }) è descritto due volte per un controllo numerico.
diag-spec-duplicate-key = La chiave { $key } è presente due volte.
diag-spec-duplicate-name = Il nome { $name } è presente due volte.
diag-spec-duplicate-parameter = { $q } è presente due volte nel ciclo.
diag-spec-empty-range = Il campo di immissione è vuoto: { $min } non è inferiore a { $max }.
diag-spec-example-out-of-range = Il parametro { $name } non accetta il proprio valore di esempio { $value }.
diag-spec-expected = Atteso: { $expected ->
        [mapping] chiavi con valori
        [list] un elenco
        [number] un numero
        [whole-number] un numero intero
        [text] un testo
        [true-or-false] true o false
        [q-parameter] un parametro Q
        [axis] la lettera di un asse
        [action] un’azione
        [one-verb] esattamente un verbo
        [one-series] esattamente una serie
        [cell] file, row, column e value
        [column] at e is
        [pair] due numeri
        [end-word] done, stopped, error, limit o unsupported
       *[other] { $expected }
    }, trovato: { $found }.
diag-spec-expression = Non è un’espressione; atteso: { $expected }, trovato: «{ $found }».
diag-spec-foreign-manual = Il manuale { $manual } non appartiene al controllo { $control }.
diag-spec-guard-keys = Una verifica richiede code, when e then, oppure indica un frammento con use.
diag-spec-id-form = L’identificatore { $name } non è in kebab case.
diag-spec-lines-form = Le righe «{ $lines }» non sono numeri o intervalli in ordine.
diag-spec-missing-key = Manca la chiave { $key }.
diag-spec-no-example = { $name } non ha un valore di esempio.
diag-spec-no-parameters = Il ciclo non ha né parametri né righe nel vecchio formato.
diag-spec-no-source = Per questo controllo numerico manca il punto di un manuale.
diag-spec-no-steps = L’esecuzione non ha passi.
diag-spec-note-without-section = { $note } non ha una sezione in pages.yaml: aggiungerlo alla sezione adatta.
diag-spec-only-and-except = Una voce può avere solo only oppure except, non entrambi.
diag-spec-otherwise-last = Un caso senza condizioni deve essere l’ultimo.
diag-spec-range-of-text = { $name } non è un numero e non può avere un campo di immissione.
diag-spec-result-target = Il risultato { $name } richiede un parametro Q oppure un campo di questo ciclo.
diag-spec-run-item = La voce dell’esecuzione non è ben formata: { $reason ->
    [one-head] deve contenere esattamente uno tra step, group ed each.
    [series-keys] in, until, between e collect appartengono a each.
    [series-body] each richiede una serie in in e voci dell’esecuzione in do.
    [step-body] un passo contiene azioni, non voci dell’esecuzione.
    [group-body] un gruppo contiene voci e nient’altro.
   *[step-keys] choose, then e by appartengono a un passo.
}
diag-spec-text-parameter = { $name }: un parametro QS accetta un testo, e solo un parametro QS lo accetta.
diag-spec-unknown-condition = Non esiste una condizione di nome { $name }.
diag-spec-unknown-control = Non esiste un controllo numerico di nome { $control }; i controlli sono { $known }.
diag-spec-unknown-cycle = Il controllo { $control } non ha { $cycle }.
diag-spec-unknown-cycle-name = Nessun ciclo di questo controllo numerico si chiama { $name }.
diag-spec-unknown-datum = Il controllo { $control } non ha un dato macchina di nome { $name }.
diag-spec-unknown-form = Il ciclo non ha una forma di nome { $name }.
diag-spec-unknown-fragment = Non esiste un frammento di nome { $name }.
diag-spec-unknown-key = La chiave { $key } non è possibile in questo punto; chiavi possibili: { $known }.
diag-spec-unknown-meaning = Il dizionario non ha un parametro di nome { $name }.
diag-spec-unknown-option = Il controllo { $control } non ha l’opzione software { $option }.
diag-spec-unknown-parameter = { $cycle } non ha il parametro { $name }.
diag-spec-unknown-topic = Non esiste l’argomento { $topic }.
diag-spec-unused = { $name } non è utilizzato.
diag-spec-word-shape = { $name }: la forma word richiede la chiave word, che nessun’altra forma può avere.
diag-spec-yaml-feature = { $feature ->
    [anchor] Nelle specifiche non si utilizzano ancore e tag.
    [alias] Nelle specifiche non si utilizzano alias.
    [depth] Il file ha troppi livelli di annidamento.
    [no-document] Il file è vuoto.
    [second-document] Un file contiene un solo documento.
   *[structured-key] Una chiave deve essere una parola semplice.
}
diag-spec-yaml-syntax = Non è YAML: { $reason }.
related-first-place = la prima occorrenza è qui
related-other-place = l’altro è qui
related-defined-here = è definito qui
related-written-over-here = sovrascritto qui
related-for-this-control = necessario per questo controllo
diag-spec-measure = In { $cycle } { $reason ->
        [different-quantities] vengono sommate o confrontate due grandezze di natura diversa
        [coordinates-added] vengono sommate due coordinate
        [distance-as-coordinate] una distanza occupa il posto di una coordinata
        [coordinate-as-distance] una coordinata occupa il posto di una distanza
        [not-a-feed] al posto di un avanzamento c’è qualcosa che non lo è
        [not-a-length] al posto di una posizione c’è qualcosa che non è una lunghezza
        [not-a-time] al posto di un tempo c’è qualcosa che non lo è
        [not-a-speed] al posto di un numero di giri c’è qualcosa che non lo è
        [not-a-number] al posto di un numero senza unità c’è una grandezza con unità
        [bare-number] una lunghezza o un avanzamento viene confrontato con un numero senza unità
        [same-operands] si sceglie o si confronta tra due formule uguali
        [never-negative] si prende il segno o il modulo di un parametro che non è mai negativo
       *[not-an-angle] al posto di un angolo c’è qualcosa che non lo è
    }.
