## Perché un'esecuzione termina prima della fine.

diag-angle-missing = Al cerchio manca l’angolo PA.
diag-axis-limit = L’asse { $axis } andrebbe a { NUMBER($found) } { $unit }, oltre i limiti della macchina da { NUMBER($min) } a { NUMBER($max) } { $unit }.
diag-block-limit = L’esecuzione è stata terminata: sono stati eseguiti più di { NUMBER($limit) } blocchi.
diag-block-unreadable = Il blocco non è leggibile: { $found }
diag-call-depth-limit = Le chiamate sono annidate per più di { NUMBER($limit) } livelli.
related-called-here = chiamato qui
diag-collision = Collisione: lo stilo tocca il pezzo fuori da un movimento di tastatura, in X { NUMBER($x) } Y { NUMBER($y) } Z { NUMBER($z) }.
diag-conform-no-value = Il caso di prova non indica un valore per { $name }, e la specifica non ha un valore d’esempio.
diag-conform-unknown-clause = Il caso dichiara di dimostrare { $name }, che { $cycle } non ha.
diag-cycle-depth-limit = I cicli sono annidati per più di { NUMBER($limit) } livelli.
diag-cycle-error = Il ciclo si arresta con l’errore { $code }.
diag-cycle-unknown = I manuali di { $control } non descrivono { $cycle }: non si può simulare.
diag-direction-contradicts = Il segno del valore incrementale dell’angolo contraddice il senso di rotazione DR.
diag-direction-missing = Al cerchio manca il senso di rotazione DR.
diag-direction-undefined = I due punti distano solo { NUMBER($distance) } mm: non determinano una direzione.
diag-division-by-zero = Divisione per zero.
diag-elements-overlap = Gli elementi su due spigoli del profilo si sovrappongono: insieme occupano { NUMBER($least) } mm del lato che li separa, lungo { NUMBER($found) } mm.
diag-end-off-circle = Il punto finale non è sul cerchio: raggio { NUMBER($start_radius, maximumFractionDigits: 4) } mm all’inizio, { NUMBER($end_radius, maximumFractionDigits: 4) } mm alla fine.
diag-feed-missing = Non è attivo alcun avanzamento maggiore di 0.
diag-field-missing = Manca il campo { $field } di { $cycle }.
diag-field-unknown = { $cycle } non ha questo campo: { $found }
diag-fit-collinear = I { NUMBER($points) } punti di tastatura sono su una retta: nessun cerchio vi si adatta.
diag-fit-failed = Nessun cerchio approssima i { NUMBER($points) } punti di tastatura.
diag-fit-too-few = I punti di tastatura sono troppo pochi per un cerchio: { NUMBER($points) }.
diag-infeeds-never-reach-depth = Gli incrementi non raggiungono mai la profondità di { NUMBER($depth) } mm: il primo è di { NUMBER($first) } mm, ciascuno è minore di { NUMBER($less) } mm, il minimo è di { NUMBER($least) } mm; finiscono a { NUMBER($reached) } mm.
diag-insert-askew = I cicli di tornitura non si possono simulare mentre l’utensile è inclinato ed è attiva M144, M128 o FUNCTION TCPM.
diag-insert-direction = L’inserto dell’utensile { $tool } non è rivolto verso il pezzo o nella direzione dei tagli: il suo orientamento (TO) è { $orientation }.
diag-jump-limit = L’esecuzione è stata terminata: sono stati eseguiti più di { NUMBER($limit) } salti, ripetizioni e chiamate.
diag-jump-target-missing = Manca il label { $label }.
diag-jump-target-twice = Il label { $label } compare due volte nel programma.
diag-kinematics-unknown = La cinematica «{ $name }» dopo FUNCTION MODE non è quella della macchina simulata, «{ $machine }».
diag-lines-parallel = Le due rette sono parallele: non hanno un’intersezione.
diag-log-failed = Impossibile scrivere il protocollo { $name }: { $reason }
diag-log-template = Il protocollo { $name } non ha un modello.
diag-log-text = Manca il testo { $name } del protocollo ({ $reason }).
diag-milling-mode-missing = { $cycle } si esegue solo nel modo fresatura, ma è attivo il modo tornitura (FUNCTION MODE TURN).
diag-move-limit = L’esecuzione è stata terminata: sono stati eseguiti più di { NUMBER($limit) } movimenti dell’utensile.
diag-machine-parameter-missing = Il parametro macchina { $name } con le sue tre coordinate non è definito.
diag-no-cycle-to-call = Viene chiamato un ciclo, ma non è stato definito alcun ciclo di lavorazione.
diag-no-such-parameter = Non esiste il parametro { $q }.
diag-number-too-large = Il risultato è troppo grande per il formato numerico.
diag-orientation-missing = La correzione del raggio in tornitura richiede l’orientamento (TO) dell’utensile { $tool }: indica dove si trova la punta rispetto al centro del raggio.
diag-outside-domain = { $function } non è definita per { NUMBER($value) }.
diag-parameter-missing = { $q } manca in { $cycle }.
diag-parameter-out-of-range = { $q } non accetta il valore { NUMBER($value) }.
diag-parameter-undefined = { $q } non ha un valore.
diag-parameter-in-addition = { $q } in { $cycle } appartiene a una versione software più recente di quella qui descritta; il suo effetto non è noto.
diag-parameter-unknown = { $cycle } non ha il parametro { $q }.
diag-plan-mistake = La specifica di { $cycle } contiene un errore: { $reason }
diag-plane-through-line = I tre punti sono su una retta: non determinano un piano.
diag-pole-missing = Non è definito alcun centro del cerchio né polo (CC).
diag-probe-deflected = Lo stilo è già deflesso prima che la tastatura cominci.
diag-probe-missing = Nel mandrino non c’è alcun sistema di tastatura.
diag-probe-measurements-differ = Le misure di un punto differiscono di { NUMBER($found) } mm; il campo di confidenza è di { NUMBER($range) } mm.
diag-probe-no-contact = Il tastatore non tocca nulla entro { NUMBER($distance) } mm.
diag-probe-no-direction = Lo stilo è già nel punto da tastare, perciò non c’è una direzione di tastatura.
diag-program-missing = Manca il programma { $name }.
diag-radius-missing = Il raggio R manca in questo blocco.
diag-radius-too-small = Il raggio di { NUMBER($radius) } mm non basta per una corda di { NUMBER($chord, maximumFractionDigits: 4) } mm.
diag-recess-impossible = Non c’è spazio per la gola, mancano il suo centro, la profondità o la larghezza, oppure non è su un elemento rettilineo.
diag-recursive-call = Una parte di programma chiama sé stessa.
diag-repeat-count = REP richiede un numero intero da 0 a 65534, non { NUMBER($found) }.
diag-rotary-axis-missing = La macchina non ha un asse rotativo { $axis }.
diag-rotary-axis-unsuitable = L’asse rotativo { $axis } non ruota nel piano della posizione obliqua e non la può compensare.
diag-shaft-collision = Il gambo dello stilo tocca il pezzo in X { NUMBER($x) } Y { NUMBER($y) } Z { NUMBER($z) }.
diag-shape-impossible = Questo utensile non può lavorare la forma: occorrono almeno { NUMBER($least) } mm, sono disponibili { NUMBER($found) } mm.
diag-cutting-width-missing = L’utensile { $tool } non è un utensile per gole: la larghezza di taglio (CUTWIDTH) deve essere maggiore di 0 e almeno doppia del raggio del tagliente (RS).
diag-series-count = Il numero di ripetizioni deve essere intero e non negativo, non { NUMBER($found) }.
diag-series-limit = Il ciclo ripeterebbe i suoi passi più di { NUMBER($limit) } volte.
diag-strategy-argument = Manca un argomento di una strategia.
diag-text-or-number = Testo dove occorre un numero, o viceversa.
diag-text-too-long = Un parametro stringa supererebbe { NUMBER($limit) } caratteri.
diag-tool-locked = L’utensile { $tool } è bloccato.
diag-tool-not-in-table = L’utensile { $tool } non è nella tabella utensili.
diag-turn-limit = L’esecuzione è stata terminata: un movimento ha più di { NUMBER($limit) } giri.
diag-undercut-form = UDC { $form } non si può simulare: nessun manuale ne descrive la forma.
diag-undercut-impossible = Non c’è spazio per la gola di scarico, manca una misura, oppure la gola non si trova tra una superficie lungo l’asse di rotazione e una faccia ad angolo retto.
diag-unsupported-axis = La macchina simulata non ha l’asse { $axis }.
diag-unsupported-block = { $word } non si può simulare.
diag-unsupported-cycle = Il manuale di { $control } menziona { $cycle } soltanto per nome: non si può simulare.
diag-unsupported-feed = Questo avanzamento in una chiamata utensile non si può simulare: { $word }
diag-unsupported-m = La funzione M { $word } non si può simulare.
diag-unsupported-path = { $word } non si può simulare in questo blocco.
diag-unsupported-tcpm = Con TCPM attivo il sistema di tastatura non è perpendicolare al piano di lavoro; in tal caso { $cycle } non si può simulare.
diag-unsupported-transformation = Mentre questa conversione è attiva i movimenti non si possono simulare: { $name }
diag-value-missing = Manca un valore, oppure non è un numero.
diag-value-not-bound = Una formula della specifica legge un valore che non esiste ancora: { $place }
diag-word-not-offered = La parola { $word } qui non è ammessa.
diag-arc-scaled-unequally = Gli assi del piano hanno fattori di scala diversi: un arco diventerebbe un’ellisse.
diag-scaling-factor-zero = Un fattore di scala deve essere maggiore di zero, non { NUMBER($found) }.
diag-m144-together = M144 non può essere attiva insieme a { $word }.
diag-spline-start = La spline inizia a { NUMBER($distance, maximumFractionDigits: 4) } mm o gradi dalla posizione attuale; è ammesso 0.001.
diag-tool-direction-unreachable = Gli assi rotativi della macchina non possono portare l’utensile nella direzione indicata da questo blocco.
diag-tilting-unreachable = Gli assi rotativi della macchina non possono posizionare l’utensile perpendicolare a questo piano.
diag-pattern-missing = { $name ->
    [none] Per la chiamata del ciclo non è definita alcuna sagoma né tabella punti.
   *[other] La tabella punti «{ $name }» non esiste.
}
diag-pattern-too-long = PATTERN DEF accetta al massimo { $limit } posizioni singole; qui sono { $count }.
diag-pattern-tool-axis = Le sagome si possono usare solo con l’asse utensile Z; l’asse utensile attivo è { $axis }.
diag-pattern-unreadable = «{ $found }» non si può usare in PATTERN DEF.
diag-position-incomplete = CYCL CALL POS richiede le coordinate di tutti e tre gli assi.
diag-value-not-predefined = È programmato PREDEF, ma nessun GLOBAL DEF ha definito il valore.
diag-contour-crossing = Il profilo del label { $label } interseca o tocca sé stesso nel punto con asse principale { NUMBER($x) } mm e asse secondario { NUMBER($y) } mm.
diag-contour-begin-incomplete = Il profilo { $label } non inizia con entrambe le coordinate del piano di lavoro.
diag-contour-data-undefined = Nessun ciclo ha ancora definito i dati del profilo.
diag-contour-count = Il profilo è formato da più di { NUMBER($limit) } segmenti di profilo.
diag-contour-depth =
    { $what ->
        [first] Un segmento di profilo è più profondo del primo di CONTOUR DEF, che deve essere la tasca più profonda.
       *[cycle] Un segmento di profilo ha una profondità di { NUMBER($depth) } mm, maggiore della profondità di fresatura dei dati del profilo.
    }
diag-contour-elements = I profili hanno in totale più di { NUMBER($limit) } elementi.
diag-contour-empty = Il sottoprogramma del label { $label } non descrive un profilo che racchiuda un’area.
diag-contour-lead = Un profilo lavorato da un ciclo non può contenere { $word }: il ciclo vi si avvicina e se ne allontana automaticamente.
diag-contour-not-defined = Nessun ciclo ha ancora indicato i sottoprogrammi del profilo.
diag-contour-open = Il profilo del label { $label } è aperto: termina a { NUMBER($distance) } mm dal punto di partenza.
diag-contour-side-missing = Nel profilo del label { $label } manca la correzione del raggio RL o RR, che stabilisce se si tratta di una tasca o di un’isola.
diag-contour-tool-axis = Il profilo del label { $label } contiene una coordinata nell’asse utensile.
diag-free-contour-contradicts = Nessun profilo soddisfa tutti i valori indicati per questo elemento e per quelli precedenti.
diag-free-contour-open =
    { $what ->
        [line] La posizione o la direzione di questa retta non è determinata. Valori ancora mancanti: { $values }.
        [arc] Il centro o il raggio di questo arco non è determinato. Valori ancora mancanti: { $values }.
       *[end] La fine di questo elemento non è determinata. Valori ancora mancanti: { $values }.
    }
diag-free-contour-reference = Il blocco { $block } non è un elemento di questo profilo libero né il blocco di posizionamento che lo precede.
diag-free-contour-selection = FSELECT { $wanted } non si può selezionare: il numero di soluzioni qui è { $solutions }.
diag-free-contour-several = Da questo elemento in poi il profilo libero ha più soluzioni ({ $solutions }) e FSELECT non ne seleziona nessuna.
diag-free-contour-word = { $word } non si può usare così in un profilo libero.
