# Segnalazioni della verifica e della traduzione di programmi; vedere il file inglese.

diag-call-of-def-active-cycle = { $cycle } è attivo appena viene definito; non deve essere chiamato.
diag-called-but-not-defined = Qui viene chiamato un ciclo, ma prima non ne è definito alcuno.
diag-choice-not-offered = { $parameter }={ $value } non è tra le scelte: { $offered }.
diag-clearance-height-too-low = { $cycle } tasta a { $touched }: l’altezza di sicurezza { $parameter }={ $value } deve trovarsi sopra { $least }.
diag-cycle-not-described = { $cycle } ({ $name }) è citato nei manuali ma non descritto: i suoi parametri non vengono verificati.
diag-cycle-not-on-control = { $cycle } non esiste sul controllo { $control }; esiste su: { $controls }.
diag-defined-but-never-called = { $cycle } è definito qui e non viene mai chiamato.
diag-duplicate-parameter = { $parameter } compare due volte in { $cycle }.
diag-guard = Il controllo non accetta questi valori.
diag-label-missing = La lingua «{ $language }» non ha un’etichetta per { $parameter } di { $cycle }.
diag-label-not-encodable = «{ $label }» contiene il carattere «{ $character }», che la codifica del file non può scrivere.
diag-label-of-another-language = «{ $label }» è un’etichetta in un’altra lingua ({ $language }); nel resto del programma { $parameter } si chiama «{ $right }».
diag-label-of-another-parameter = «{ $label }» è l’etichetta di { $other }, non di { $parameter }.
diag-misordered-parameter = In { $cycle } il controllo visualizza { $parameter } prima di { $before }.
diag-missing-parameter = In { $cycle } manca { $parameter }.
diag-out-of-range =
    { $side ->
        [below] { $parameter }={ $value } è troppo piccolo: il valore minimo è { $limit }.
        [long] Il testo di { $parameter } è troppo lungo: sono ammessi { $limit } caratteri.
        [many] { $parameter } elenca troppi label: ne sono ammessi { $limit }.
       *[above] { $parameter }={ $value } è troppo grande: il valore massimo è { $limit }.
    }
diag-spindle-off = Qui viene chiamato un ciclo di lavorazione a mandrino fermo.
diag-tool-missing = Qui un ciclo esegue movimenti, ma prima nessuna chiamata utensile ha indicato l’asse utensile.
diag-unknown-cycle = { $cycle } non è un ciclo di alcun controllo qui noto.
diag-unknown-parameter = Su questo controllo { $cycle } non ha il parametro { $parameter }.
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
        [label-list] numeri di label separati da barre, ad esempio 1/2/3
       *[number] un numero
    }{ $words-count ->
        [0] {""}
       *[other] {" "}oppure { $words }
    }.
