# Segnalazioni della verifica e della traduzione di programmi; vedere il file inglese.

diag-call-of-def-active-cycle = { $cycle } è attivo appena viene definito; non deve essere chiamato.
    .explain = Sagome di punti, conversioni di coordinate e cicli di tastatura sono attivi dalla definizione. Una chiamata dopo di essi è un errore se prima non è definito alcun ciclo di lavorazione, o se segue direttamente una sagoma di punti, che ha già chiamato il ciclo di lavorazione.
diag-called-but-not-defined = Qui viene chiamato un ciclo, ma prima non ne è definito alcuno.
    .explain = CYCL CALL, M99 e M89 eseguono il ciclo di lavorazione definito per ultimo. Senza definizione non c'è nulla da eseguire. Nei programmi con salti, sottoprogrammi o blocchi esclusi la segnalazione compare solo se non è definito alcun ciclo, e mai se vengono chiamati altri programmi.
diag-choice-not-offered = { $parameter }={ $value } non è tra le scelte: { $offered }.
    .explain = Il parametro offre una scelta di valori, ciascuno con un proprio significato, e questo non è tra quelli. Esempio: Q215=3 in CYCL DEF 251.
diag-cycle-not-described = { $cycle } ({ $name }) è citato nei manuali ma non descritto: i suoi parametri non vengono verificati.
    .explain = Il controllo dispone del ciclo, ma qui non esiste una specifica che lo descriva. Parametri, testi ed effetto non vengono considerati.
diag-cycle-not-on-control = { $cycle } non esiste sul controllo { $control }; esiste su: { $controls }.
    .explain = I manuali di questo controllo non conoscono il ciclo, quelli di un altro sì. Il programma è stato scritto per l'altro controllo, oppure con --control è stato scelto quello sbagliato.
diag-defined-but-never-called = { $cycle } è definito qui e non viene mai chiamato.
    .explain = Il ciclo è attivo quando viene chiamato con CYCL CALL, M99 o M89 oppure da una sagoma di punti, e nulla di ciò segue prima del successivo ciclo di questo tipo o della fine. La definizione non ha effetto, oppure la chiamata è stata dimenticata.
diag-duplicate-parameter = { $parameter } compare due volte in { $cycle }.
    .explain = La definizione assegna due valori allo stesso parametro o campo; non si può dire quale sia inteso.
diag-guard = Il controllo non accetta questi valori.
    .explain = Le specifiche indicano a quali condizioni un controllo rifiuta un ciclo, lo salta, avverte o chiede. Ciascuna di queste condizioni ha un proprio codice; viene verificata solo con valori che il programma scrive come numeri o testi.
diag-label-missing = La lingua «{ $language }» non ha un testo per { $parameter } di { $cycle }.
    .explain = Il programma non può essere scritto interamente in questa lingua: un testo delle specifiche non è ancora tradotto. Il testo precedente rimane. Il comando ciklo coverage elenca ciò che manca.
diag-label-not-encodable = «{ $label }» contiene il carattere «{ $character }», che la codifica del file non può scrivere.
    .explain = Il programma non è un file UTF-8 e nella sua codifica (Windows-1252) manca un carattere del nuovo testo. Convertire prima il file in UTF-8, se il controllo lo legge.
diag-label-of-another-language = «{ $label }» è un testo in un'altra lingua ({ $language }); nella lingua del programma il testo di { $parameter } è «{ $right }».
    .explain = La maggior parte dei testi del programma è in una lingua, questo è in un'altra. Il comando ciklo translate li scrive tutti in una lingua.
diag-label-of-another-parameter = «{ $label }» è il testo di { $other }, non di { $parameter }.
    .explain = Il commento dopo il valore è il testo di un altro parametro dello stesso ciclo. Il controllo legge solo il numero, ma il valore potrebbe essere destinato all'altro parametro. I testi che non esistono in alcuna lingua non vengono considerati.
diag-misordered-parameter = In { $cycle } il controllo visualizza { $parameter } prima di { $before }.
    .explain = Il controllo riconosce i parametri dal numero e accetta anche un altro ordine, ma difficilmente la definizione è stata creata su un controllo. Viene segnalato il primo parametro fuori ordine.
diag-missing-parameter = In { $cycle } manca { $parameter }.
    .explain = Il manuale del controllo elenca per il ciclo un parametro o campo che nella definizione non c'è. Le definizioni con una riga illeggibile non vengono considerate. Esempio: CYCL DEF 247 senza Q339.
diag-out-of-range =
    { $side ->
        [below] { $parameter }={ $value } è troppo piccolo: il valore minimo è { $limit }.
        [long] Il testo di { $parameter } è troppo lungo: sono ammessi { $limit } caratteri.
       *[above] { $parameter }={ $value } è troppo grande: il valore massimo è { $limit }.
    }
    .explain = Il manuale del controllo indica per il parametro un campo di immissione, e il valore ne è al di fuori. I campi valgono solo per questo controllo; dove il manuale non li indica, non si verifica nulla. Nei programmi in pollici lunghezze e avanzamenti non vengono verificati. Esempio: Q202=-5.
diag-spindle-off = Qui viene chiamato un ciclo di lavorazione a mandrino fermo.
    .explain = Nulla ha avviato il mandrino (M3, M4, M13, M14), oppure nel frattempo è stato arrestato (M0, M5, M6). Dopo una chiamata utensile e dopo funzioni M del costruttore non si segnala nulla. Segnalato una volta per programma.
diag-tool-missing = Qui un ciclo si muove, ma prima nessuna chiamata utensile ha indicato l'asse utensile.
    .explain = I cicli hanno bisogno dell'asse utensile, indicato da TOOL CALL: TOOL CALL 5 Z S2000. Segnalato una volta per programma.
diag-unknown-cycle = { $cycle } non è un ciclo di alcun controllo qui noto.
    .explain = Il numero non corrisponde ad alcun ciclo nei manuali su cui si basano le specifiche, né a un ciclo del costruttore della macchina (da 300 a 399, da 500 a 599). Verificare parola chiave e numero: CYCL DEF 32 e TCH PROBE 32 sono cicli diversi. Esempio: CYCL DEF 299.
diag-unknown-parameter = Su questo controllo { $cycle } non ha il parametro { $parameter }.
    .explain = Il parametro o campo non è tra quelli che il manuale del controllo elenca per il ciclo. Appartiene a un altro ciclo o a un altro controllo, oppure il numero è errato. Esempio: Q999 in CYCL DEF 247.
diag-wrong-value-kind =
    Il parametro { $parameter } di { $cycle } accetta { $kind ->
        [integer] un numero intero
        [number-or-name] un numero o un nome tra virgolette
        [text] un testo tra virgolette
        [q-number] un parametro Q
        [axis-direction] un asse con segno, ad esempio X-
        [position] coordinate per asse, ad esempio X+5 Y+0
        [row] una riga della tabella, ad esempio #5
        [axis] un asse
       *[number] un numero
    }{ $words-count ->
        [0] {""}
       *[other] {" "}oppure { $words }
    }.
    .explain = Il valore è di un tipo che il parametro non accetta: un testo al posto di un numero, un numero con decimali dove ne serve uno intero, una parola che il manuale non prevede, oppure nulla. Un parametro Q è sempre ammesso. Esempio: Q201=FAUTO.
