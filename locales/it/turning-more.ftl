# Turning; see the English file.

# --- 841, 842, 840, 851, 852, 850 ---
cycle-simple-radial-recess-turning = Tornitura gola radiale semplice
    .nc = TORNITURA GOLA RAD. SEMPLICE
    .purpose = Lavora gole rettangolari in direzione longitudinale mediante tornitura di gole: sgrossatura, finitura o entrambe. I tagli di sgrossatura sono paralleli agli assi.
cycle-extended-radial-recess-turning = Tornitura gola radiale estesa
    .nc = TORNITURA GOLA RAD. ESTESA
    .purpose = Lavora gole in direzione longitudinale mediante tornitura di gole: sgrossatura, finitura o entrambe. I tagli di sgrossatura sono paralleli agli assi. La gola può avere pareti laterali inclinate, spigoli arrotondati e uno smusso o un raccordo all’inizio e alla fine del profilo.
cycle-radial-contour-recess-turning = Tornitura gola profilo radiale
    .nc = TORNITURA GOLA PROFILO RAD.
    .purpose = Lavora gole di forma qualsiasi in direzione longitudinale mediante tornitura di gole: sgrossatura, finitura o entrambe. I tagli di sgrossatura sono paralleli agli assi.
cycle-simple-axial-recess-turning = Tornitura gola assiale semplice
    .nc = TORNITURA GOLA ASS. SEMPLICE
    .purpose = Lavora gole rettangolari in direzione trasversale (su una superficie frontale) mediante tornitura di gole: sgrossatura, finitura o entrambe. I tagli di sgrossatura sono paralleli agli assi.
cycle-extended-axial-recess-turning = Tornitura gola assiale estesa
    .nc = TORNITURA GOLA ASS. ESTESA
    .purpose = Lavora gole in direzione trasversale mediante tornitura di gole: sgrossatura, finitura o entrambe. I tagli di sgrossatura sono paralleli agli assi. La gola può avere pareti laterali inclinate, spigoli arrotondati e uno smusso o un raccordo all’inizio e alla fine del profilo.
cycle-axial-contour-recess-turning = Tornitura gola profilo assiale
    .nc = TORNITURA GOLA PROFILO ASS.
    .purpose = Lavora gole di forma qualsiasi in direzione trasversale mediante tornitura di gole: sgrossatura, finitura o entrambe. I tagli di sgrossatura sono paralleli agli assi.

# --- 861, 862, 860, 871, 872, 870 ---
cycle-radial-recessing = Gola radiale
    .nc = GOLA RADIALE
    .purpose = Esegue gole rettangolari in direzione radiale: sgrossatura, finitura o entrambe. I tagli di sgrossatura sono paralleli agli assi.
cycle-extended-radial-recessing = Gola radiale estesa
    .nc = GOLA RADIALE ESTESA
    .purpose = Esegue gole in direzione radiale: sgrossatura, finitura o entrambe. I tagli di sgrossatura sono paralleli agli assi. La gola può avere pareti laterali inclinate, spigoli arrotondati e uno smusso o un raccordo all’inizio e alla fine del profilo.
cycle-radial-contour-recessing = Gola profilo radiale
    .nc = GOLA PROFILO RADIALE
    .purpose = Esegue gole di forma qualsiasi in direzione radiale: sgrossatura, finitura o entrambe. I tagli di sgrossatura sono paralleli agli assi.
cycle-axial-recessing = Gola assiale
    .nc = GOLA ASSIALE
    .purpose = Esegue gole rettangolari in direzione assiale (gole frontali): sgrossatura, finitura o entrambe. I tagli di sgrossatura sono paralleli agli assi.
cycle-extended-axial-recessing = Gola assiale estesa
    .nc = GOLA ASSIALE ESTESA
    .purpose = Esegue gole in direzione assiale (gole frontali): sgrossatura, finitura o entrambe. I tagli di sgrossatura sono paralleli agli assi. La gola può avere pareti laterali inclinate, spigoli arrotondati e uno smusso o un raccordo all’inizio e alla fine del profilo.
cycle-axial-contour-recessing = Gola profilo assiale
    .nc = GOLA PROFILO ASSIALE
    .purpose = Esegue gole di forma qualsiasi in direzione assiale (gole frontali): sgrossatura, finitura o entrambe. I tagli di sgrossatura sono paralleli agli assi.

# --- 831, 832, 830 ---
cycle-longitudinal-thread = Filettatura longitudinale
    .nc = FILETTATURA LONGITUDINALE
    .purpose = Tornisce filetti longitudinali a uno o più principi.
cycle-extended-thread = Filettatura estesa
    .nc = FILETTATURA ESTESA
    .purpose = Tornisce filetti longitudinali, radiali o conici a uno o più principi.
cycle-contour-parallel-thread = Filettatura parallela al profilo
    .nc = FILETTATURA PARALL. PROFILO
    .purpose = Tornisce filetti longitudinali o radiali di forma qualsiasi a uno o più principi.

# --- roughing of grooves ---
step-take-tool-position-as-start = Il controllo assume come punto di partenza del ciclo la posizione dell’utensile alla chiamata del ciclo.
step-start-recess-at-contour-start-diameter = Se la coordinata X del punto di partenza è minore del diametro inizio profilo { $q-contour-start-diameter }, il controllo posiziona l’utensile in X su { $q-contour-start-diameter } e inizia il ciclo da qui.
step-start-recess-at-contour-start-z = Se la coordinata Z del punto di partenza è minore dell’inizio profilo Z { $q-contour-start-z }, il controllo posiziona l’utensile in Z su { $q-contour-start-z } e inizia il ciclo da qui.
step-start-recess-at-contour-point-x = Se la coordinata X del punto di partenza è minore di quella del punto di partenza del profilo, il controllo posiziona l’utensile in X sul punto di partenza del profilo e inizia il ciclo da qui.
step-start-recess-at-contour-point-z = Se la coordinata Z del punto di partenza è minore di quella del punto di partenza del profilo, il controllo posiziona l’utensile in Z sul punto di partenza del profilo e inizia il ciclo da qui.
step-rapid-to-first-recess-z = Il controllo posiziona l’utensile in Z in rapido (prima posizione di tuffo).
step-rapid-to-first-recess-x = Il controllo posiziona l’utensile in X in rapido (prima posizione di tuffo).
step-recess-from-start-to-first-depth = Il controllo lavora a tuffo dal punto di partenza del ciclo fino alla prima profondità incremento.
step-recess-to-first-depth = Il controllo lavora a tuffo fino alla prima profondità incremento.
step-rough-groove-lengthwise = Il controllo sgrossa l’area tra la posizione di partenza e il punto finale in direzione longitudinale con l’avanzamento { $q-turning-roughing-feed }.
step-rough-groove-crosswise = Il controllo sgrossa l’area tra la posizione di partenza e il punto finale in direzione trasversale con l’avanzamento { $q-turning-roughing-feed }.
step-choose-side-of-next-recess = La direzione di lavorazione { $q-recess-direction } determina dove avviene l’incremento successivo:
say-lift-off-and-return = { $q-recess-direction } = 1 (una sola direzione): il controllo allontana l’utensile della distanza di sicurezza, lo riporta indietro in rapido e lo accosta di nuovo al profilo con l’avanzamento definito
say-infeed-at-both-sides = { $q-recess-direction } = 0 (entrambe le direzioni): l’incremento avviene su entrambi i lati
step-recess-to-next-depth = L’utensile lavora a tuffo fino alla profondità incremento successiva.
until-groove-depth-reached = non è raggiunta la profondità della gola
step-recess-at-both-walls = Il controllo posiziona di nuovo l’utensile alla distanza di sicurezza ed esegue un tuffo su ciascuna parete laterale.
step-infeed-parallel-to-axis = Il controllo esegue in rapido un incremento parallelo agli assi. L’incremento laterale è pari a 0,8 volte la larghezza del tagliente.
step-recess-radially = Il controllo lavora l’area tra la posizione di partenza e il punto finale in direzione radiale con l’avanzamento { $q-turning-roughing-feed }.
step-recess-axially = Il controllo lavora l’area tra la posizione di partenza e il punto finale in direzione assiale con l’avanzamento { $q-turning-roughing-feed }.
until-groove-width-reached = non è raggiunta la larghezza della gola
until-groove-shape-reached = non è raggiunta la forma della gola

# --- finishing of grooves ---
step-rapid-to-first-flank = Il controllo posiziona l’utensile in rapido sul primo fianco della gola.
step-rapid-again-to-first-flank = { step-rapid-to-first-flank }
step-rapid-to-second-flank = Il controllo posiziona l’utensile in rapido sul secondo fianco della gola.
step-finish-groove-wall = Il controllo esegue la finitura della parete laterale della gola con l’avanzamento { $q-turning-finishing-feed }.
step-finish-second-groove-wall = { step-finish-groove-wall }
step-finish-groove-walls = Il controllo esegue la finitura delle pareti laterali della gola con l’avanzamento { $q-turning-finishing-feed }.
step-finish-groove-floor = Il controllo esegue la finitura del fondo della gola con l’avanzamento definito.
step-finish-groove-floor-or-all = Il controllo esegue la finitura del fondo della gola con l’avanzamento definito:
say-finish-whole-groove = se per lo spigolo del profilo è inserito un raggio { $q-contour-corner-radius }, il controllo esegue la finitura dell’intera gola in un’unica passata
say-finish-floor-only = altrimenti solo del fondo
step-retract-from-groove = Il controllo ritrae l’utensile in rapido.
step-finish-half-of-width = Il controllo esegue la finitura di metà della larghezza della gola con l’avanzamento definito.
step-finish-other-half-of-width = Il controllo esegue la finitura dell’altra metà della larghezza della gola con l’avanzamento definito.
step-finish-half-of-groove = Il controllo esegue la finitura di metà della gola con l’avanzamento definito.
step-finish-other-half-of-groove = Il controllo esegue la finitura dell’altra metà della gola con l’avanzamento definito.

# --- threads ---
step-move-before-thread-and-infeed = Il controllo posiziona l’utensile in rapido alla distanza di sicurezza davanti al filetto ed esegue un incremento.
step-cut-thread-parallel-to-axis = Il controllo esegue un taglio longitudinale parallelo all’asse. Sincronizza avanzamento e numero di giri in modo da ottenere il passo definito.
step-cut-thread-along-line = Il controllo taglia il filetto tra il punto di partenza e il punto finale. Sincronizza avanzamento e numero di giri in modo da ottenere il passo definito.
step-cut-thread-along-contour = Il controllo taglia il filetto parallelamente al profilo del filetto definito. Sincronizza avanzamento e numero di giri in modo da ottenere il passo definito.
step-lift-off-thread = Il controllo distacca l’utensile in rapido della distanza di sicurezza.
step-infeed-at-angle = Il controllo esegue un incremento. Gli incrementi seguono l’angolo di incremento { $q-thread-infeed-angle }.
until-thread-depth-reached = non è raggiunta la profondità del filetto
step-make-air-cuts = Il controllo esegue tante passate a vuoto quante ne definisce { $q-number-of-air-cuts }.
step-infeed-for-next-start = Per il principio successivo il controllo riporta l’utensile al primo incremento. Il taglio inizia a un angolo del mandrino spostato del passo angolare tra i principi.
until-all-thread-starts-cut = non sono stati tagliati tanti principi quanti ne definisce { $q-number-of-thread-starts }

# --- conditions ---
condition-cutting-limit-wanted = { $q-cutting-limit } = 1
condition-taper-angle-given = { $q-taper-dimensioning } definisce il cono mediante l’angolo
condition-start-diameter-given = { $q-taper-dimensioning } definisce il cono mediante il diametro inizio profilo
condition-start-z-given = { $q-taper-dimensioning } definisce il cono mediante la coordinata Z dell’inizio del profilo
condition-end-diameter-given = { $q-taper-dimensioning } definisce il cono mediante il diametro fine profilo
condition-end-z-given = { $q-taper-dimensioning } definisce il cono mediante la coordinata Z della fine del profilo

# --- errors ---
guard-recess-offset-too-great = L’offset laterale supera l’80% della larghezza effettiva del tagliente, ossia della larghezza del tagliente meno il doppio del raggio del tagliente.

# --- notes: grooves ---
note-recess-turning-alternates = Nella tornitura di gole si alternano tagli a tuffo alla profondità incremento e tagli di sgrossatura. La lavorazione richiede così il minor numero possibile di ritrazioni e incrementi.
note-groove-extended-scope = Funzioni estese: all’inizio e alla fine del profilo è possibile aggiungere uno smusso o un raccordo; per le pareti laterali della gola si possono definire angoli; sugli spigoli del profilo si possono aggiungere raggi.
note-recess-cuts-get-shorter = Dopo il secondo incremento il controllo riduce ogni taglio successivo di 0,1 mm. Ciò diminuisce la sollecitazione laterale dell’utensile. Se nel ciclo è inserita una larghezza di offset { $q-recess-offset-width }, il taglio viene invece ridotto di questo valore. Il materiale residuo viene asportato con un ultimo tuffo. Se l’offset laterale supera l’80% della larghezza effettiva del tagliente (larghezza del tagliente − 2 × raggio del tagliente), il controllo visualizza un messaggio d’errore.
title-groove-with-chamfers = Gola con smussi in uno spallamento tornito (programma di esempio)

# --- notes: threads ---
note-threads-with-several-starts = Il ciclo può eseguire filetti a uno o più principi.
note-standard-thread-depth = Se nel ciclo non è inserita una profondità di filettatura, il ciclo utilizza una profondità di filettatura standard.
note-standard-thread-depth__longitudinal-thread = Se nel ciclo non è inserita una profondità di filettatura, il ciclo utilizza la profondità di filettatura secondo la norma ISO 1502.
note-thread-outside-or-inside = Il ciclo può essere impiegato per lavorazioni esterne e interne.
note-extended-thread-scope = Funzioni estese: è possibile selezionare un filetto longitudinale o radiale; i parametri per il tipo di quotatura del cono, l’angolo del cono e il punto di partenza del profilo in X definiscono diversi filetti conici; il percorso di avvicinamento e il percorso di oltrecorsa definiscono i tratti in cui l’asse di avanzamento viene accelerato e decelerato.
note-overrun-after-contour = Pericolo di collisione! Dopo il profilo programmato il ciclo { $cycle } prosegue per il percorso di oltrecorsa { $q-overrun-path }. Tenere conto dello spazio disponibile.
note-clearance-is-starting-path = Il controllo utilizza la distanza di sicurezza { $q-thread-clearance } come percorso di avvicinamento. Deve essere sufficiente per accelerare gli assi di avanzamento alla velocità richiesta.
note-pitch-is-overrun-path = Il controllo utilizza il passo del filetto { $q-turned-thread-pitch } come percorso di oltrecorsa. Deve essere sufficiente per decelerare gli assi di avanzamento.
note-extended-thread-has-paths = Il ciclo 832 dispone di parametri per il percorso di avvicinamento e il percorso di oltrecorsa.
note-starting-path-long-enough = Il percorso di avvicinamento { $q-starting-path } deve essere sufficiente per accelerare gli assi di avanzamento alla velocità richiesta.
note-overrun-path-long-enough = Il percorso di oltrecorsa { $q-overrun-path } deve essere sufficiente per decelerare gli assi di avanzamento.
note-paths-outside-contour = Sia il percorso di avvicinamento sia il percorso di oltrecorsa si trovano all’esterno del profilo definito.
note-override-while-thread-cutting = Durante il taglio del filetto l’override dell’avanzamento non ha effetto. L’override del numero di giri mandrino rimane attivo entro i limiti definiti dal costruttore della macchina. Consultare il manuale della macchina.
note-thread-with-separate-holder = Su alcuni tipi di macchina l’utensile per tornire non è serrato nel mandrino di fresatura, ma in un supporto separato accanto ad esso. In tal caso l’utensile non può essere ruotato di 180°, ad esempio per eseguire filetti esterni e interni con un unico utensile. Per impiegare un utensile per esterni per la lavorazione interna su una macchina di questo tipo, lavorare nel campo negativo del diametro (−X) e invertire il senso di rotazione del pezzo. Con preposizionamento nel campo negativo del diametro il controllo inverte l’effetto della posizione del filetto { $q-thread-position }: allora 1 è un filetto esterno e 0 un filetto interno.
note-thread-retracts-directly = Pericolo di collisione! L’utensile si ritrae alla posizione di partenza su un percorso diretto. Preposizionarlo sempre in modo che al termine del ciclo il controllo possa raggiungere il punto di partenza senza collisioni.

# --- notes: contours from a subprogram ---
note-contour-by-cycle-14 = Il profilo viene descritto in un sottoprogramma con funzioni di traiettoria o funzioni FK. Prima della chiamata del ciclo programmare il ciclo 14 (profilo) per definire il numero del sottoprogramma.
note-local-parameters-in-contour = Se nel sottoprogramma del profilo si utilizzano parametri locali QL, anche le relative assegnazioni o i relativi calcoli devono avvenire nel sottoprogramma del profilo.
note-cutting-limit-limits-area = La limitazione del taglio delimita l’area del profilo che viene lavorata. I percorsi di avvicinamento e allontanamento possono superare la limitazione.
note-cutting-limit-by-tool-position = La posizione dell’utensile prima della chiamata del ciclo influisce sull’effetto della limitazione del taglio: il controllo asporta il materiale dal lato della limitazione sul quale si trova l’utensile prima della chiamata del ciclo.
