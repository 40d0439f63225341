# Turning; see the English file.

# --- common sentences of the turning cycles ---
group-turning-roughing = Sgrossatura
group-turning-finishing = Finitura
step-rapid-radial-infeed = Il controllo fa avanzare l’utensile in rapido in direzione radiale, parallelamente agli assi. Calcola l’incremento dalla massima profondità di taglio { $q-max-cutting-depth }.
step-cut-longitudinally = Il controllo lavora l’area tra la posizione di partenza e il punto finale in direzione longitudinale con l’avanzamento { $q-turning-roughing-feed }.
step-retract-by-infeed = Il controllo ritrae l’utensile del valore dell’incremento con l’avanzamento definito:
say-follow-contour-within-infeed = con { $q-contour-smoothing } = 0 lungo il profilo, entro il campo dell’incremento
say-lift-off-at-45-degrees = altrimenti con un angolo di 45°
step-rapid-to-start-of-cut = Il controllo riporta l’utensile in rapido all’inizio del taglio.
until-turning-contour-finished = il profilo non è completato
step-smooth-after-last-cut = Con { $q-contour-smoothing } = 1, dopo l’ultimo taglio il controllo liscia l’intero profilo.
step-rapid-to-starting-point-of-cycle = Il controllo riporta l’utensile in rapido al punto di partenza del ciclo.
step-rapid-back-after-finishing = { step-rapid-to-starting-point-of-cycle }
step-rapid-in-z-by-clearance = Il controllo sposta l’utensile in Z della distanza di sicurezza { $q-turning-clearance } in rapido.
step-rapid-paraxial-infeed = Il controllo fa avanzare l’utensile in rapido parallelamente agli assi.
step-finish-turned-contour = Il controllo esegue la finitura del profilo del pezzo con l’avanzamento { $q-turning-finishing-feed }.
step-retract-by-clearance = Il controllo ritrae l’utensile della distanza di sicurezza { $q-turning-clearance } con l’avanzamento definito.
guard-turning-mode-missing = I cicli di tornitura possono essere eseguiti solo nel modo tornitura FUNCTION MODE TURN.
note-turning-mode-only = I cicli di tornitura possono essere impiegati solo nel modo tornitura FUNCTION MODE TURN.
note-program-before-turning-cycle = Prima della chiamata del ciclo programmare sempre: il modo tornitura FUNCTION MODE TURN, la chiamata utensile TOOL CALL, il senso di rotazione del mandrino di tornitura (ad esempio M303), il numero di giri o la velocità di taglio con FUNCTION TURNDATA SPIN, M136 se si utilizzano avanzamenti al giro (mm/giro), un blocco di posizionamento su un punto di partenza adatto (ad esempio L X+130 Y+0 R0 FMAX) e il ciclo 800 per adattare il sistema di coordinate e allineare l’utensile.
note-call-turning-cycle = Chiamare il ciclo con CYCL CALL o M99.
note-outside-or-inside-by-tool-position = Il ciclo esegue una lavorazione esterna se alla chiamata l’utensile si trova all’esterno del profilo da lavorare, una lavorazione interna se si trova al suo interno.
note-outside-or-inside-by-diameters = Se il diametro iniziale { $q-contour-start-diameter } è maggiore del diametro finale { $q-contour-end-diameter }, il ciclo esegue una lavorazione esterna; se è minore, una lavorazione interna.
note-outside-or-inside-by-contour = Se la coordinata del punto di partenza del profilo è maggiore di quella del punto finale, il ciclo esegue una lavorazione esterna; se è minore, una lavorazione interna.
note-check-after-change-of-side = Dopo il passaggio tra lavorazione esterna e interna verificare le impostazioni dell’utensile e il senso di rotazione.
note-area-from-tool-position-to-end-point = Nella sgrossatura il ciclo lavora l’area dalla posizione dell’utensile alla chiamata del ciclo (punto di partenza del ciclo) fino al punto finale definito nel ciclo.
note-position-at-starting-position = Prima della chiamata del ciclo programmare un blocco di posizionamento sulla posizione di partenza con correzione del raggio R0.
note-position-at-safe-position = Prima della chiamata del ciclo programmare un blocco di posizionamento su una posizione sicura con correzione del raggio R0.
note-tool-position-determines-area = La posizione dell’utensile alla chiamata del ciclo (punto di partenza del ciclo) determina le dimensioni dell’area da lavorare.
note-tool-position-influences-area = La posizione dell’utensile alla chiamata del ciclo (punto di partenza del ciclo) influisce sull’area da lavorare.
note-pre-positioning-influences-time = Il preposizionamento dell’utensile influisce notevolmente sull’area di lavoro del ciclo e quindi sul tempo di lavorazione. Nella sgrossatura il punto di partenza del ciclo è la posizione dell’utensile alla chiamata del ciclo. Il controllo calcola l’area da lavorare dal punto di partenza e dal punto finale o dal profilo definito nel ciclo. Se il punto di partenza si trova all’interno di quest’area, alcuni cicli portano dapprima l’utensile alla distanza di sicurezza.
note-finishing-approach-from-envelope = Pericolo per utensile e pezzo! Nella finitura il ciclo porta automaticamente l’utensile al punto di partenza. La modalità di accostamento dipende dalla posizione dell’utensile alla chiamata del ciclo: all’interno o all’esterno dell’inviluppo, ossia del profilo programmato ingrandito della distanza di sicurezza { $q-turning-clearance }. Se l’utensile si trova all’interno dell’inviluppo, si porta con l’avanzamento definito alla posizione di partenza su un percorso diretto, che può danneggiare il profilo: posizionare l’utensile in modo che possa raggiungere la posizione di partenza senza danneggiare il profilo. Se l’utensile si trova all’esterno dell’inviluppo, si sposta in rapido fino all’inviluppo e al suo interno con l’avanzamento programmato.
note-cutting-geometry-considered = Il controllo tiene conto della geometria del tagliente dell’utensile ({ $mp-tool-orientation }, { $mp-cutting-edge-radius }, { $mp-point-angle }, { $mp-tool-angle }), in modo che gli elementi di profilo definiti non possano essere danneggiati. Se il profilo non può essere lavorato completamente con l’utensile attivo, il controllo emette un avvertimento.
note-feed-rates-with-m136 = Se prima del ciclo è programmata M136, il controllo interpreta gli avanzamenti del ciclo in mm/giro, senza M136 in mm/min.
note-inclined-turning = Se il ciclo viene eseguito durante una lavorazione inclinata (M144), gli angoli dell’utensile rispetto al profilo cambiano. Il controllo tiene conto automaticamente di questa modifica e sorveglia quindi anche la lavorazione inclinata, per evitare danneggiamenti del profilo.
note-blank-form-update = Con l’aggiornamento del pezzo grezzo (FUNCTION TURNDATA BLANK) il controllo riconosce le aree già lavorate e adatta tutti i percorsi di avvicinamento e allontanamento alle singole operazioni. La funzione è disponibile solo in un ciclo di lavorazione nel modo tornitura; il pezzo grezzo deve essere un profilo chiuso (posizione di partenza = posizione finale) e corrisponde alla sezione di un corpo di rivoluzione.
note-finished-part-beyond-blank = Con l’aggiornamento del pezzo grezzo il controllo adatta avvicinamento e ritrazione al pezzo grezzo aggiornato. Se alcune aree della parte finita sporgono dal pezzo grezzo, pezzo e utensile possono essere danneggiati.
step-rapid-axial-infeed = Il controllo fa avanzare l’utensile in rapido in direzione assiale, parallelamente agli assi. Calcola l’incremento dalla massima profondità di taglio { $q-max-axial-cutting-depth }.
step-cut-across-axis = Il controllo lavora l’area tra la posizione di partenza e il punto finale in direzione radiale con l’avanzamento { $q-turning-roughing-feed }.
step-cut-contour-longitudinally = Il controllo lavora l’area tra la posizione di partenza e il punto finale in direzione longitudinale. Il taglio longitudinale procede parallelamente agli assi con l’avanzamento { $q-turning-roughing-feed }.
step-cut-contour-across-axis = Il controllo lavora l’area tra la posizione di partenza e il punto finale in direzione radiale. Il taglio radiale procede parallelamente agli assi con l’avanzamento { $q-turning-roughing-feed }.
step-cut-parallel-to-contour = Il controllo lavora l’area tra la posizione di partenza e il punto finale. Il taglio procede parallelamente al profilo con l’avanzamento { $q-turning-roughing-feed }.
step-retract-to-starting-position-in-x = Il controllo ritrae l’utensile con l’avanzamento definito alla posizione di partenza in X.
step-clear-area-in-x-then-z = Se il punto di partenza (la posizione dell’utensile alla chiamata del ciclo) si trova all’interno dell’area da lavorare, il controllo posiziona l’utensile in X e poi in Z alla distanza di sicurezza { $q-turning-clearance } e inizia il ciclo da qui.
step-clear-area-in-z-then-x = Se il punto di partenza (la posizione dell’utensile alla chiamata del ciclo) si trova all’interno dell’area da lavorare, il controllo posiziona l’utensile in Z e poi in X alla distanza di sicurezza { $q-turning-clearance } e inizia il ciclo da qui.
step-clear-area-in-z = Se il punto di partenza si trova all’interno dell’area da lavorare, il controllo posiziona dapprima l’utensile in Z alla distanza di sicurezza { $q-turning-clearance }.
step-clear-plunging-start-in-z = Se la coordinata Z del punto di partenza (la posizione dell’utensile alla chiamata del ciclo) è minore dell’inizio del profilo { $q-plunging-start-z }, il controllo posiziona l’utensile in Z alla distanza di sicurezza { $q-turning-clearance } e inizia il ciclo da qui.
step-clear-contour-start-in-z = Se la coordinata Z del punto di partenza (la posizione dell’utensile alla chiamata del ciclo) è minore di quella del punto di partenza del profilo, il controllo posiziona l’utensile in Z alla distanza di sicurezza { $q-turning-clearance } e inizia il ciclo da qui.
step-clear-contour-start-before-finishing = { step-clear-contour-start-in-z }
step-position-at-contour-start-in-z = Se la coordinata Z del punto di partenza (la posizione dell’utensile alla chiamata del ciclo) è minore di quella del punto di partenza del profilo, il controllo posiziona l’utensile in Z sul punto di partenza del profilo e inizia il ciclo da qui.
step-rapid-infeed = Il controllo fa avanzare l’utensile in rapido.
step-finish-turned-contour-to-end = Il controllo esegue la finitura del profilo del pezzo, dal punto di partenza al punto finale del profilo, con l’avanzamento { $q-turning-finishing-feed }.
condition-start-element-added = { $q-start-element-type } prevede un elemento all’inizio del profilo
condition-end-element-added = { $q-end-element-type } prevede un elemento alla fine del profilo
condition-undercuts-machined = { $q-undercut-machining } ammette la lavorazione di elementi di entrata
note-area-from-starting-point-to-end-point = Nella sgrossatura il ciclo lavora l’area dal punto di partenza del ciclo fino al punto finale definito nel ciclo.
note-infeed-within-undercut = All’interno dello scarico il controllo fa avanzare l’utensile con l’avanzamento { $q-turning-roughing-feed }. Ogni ritrazione in quest’area è pari alla distanza di sicurezza { $q-turning-clearance }.
note-contour-direction-decides = La direzione programmata del profilo determina la direzione di lavorazione.
title-shoulder-with-recess = Spallamento con gola

# --- 811 ---
cycle-turn-shoulder-longitudinal = Tornitura spallamento longitudinale
    .nc = TORNITURA SPALL. LONG.
    .purpose = Tornisce spallamenti ad angolo retto in direzione longitudinale, all’esterno o all’interno: sgrossatura, finitura o entrambe. I tagli di sgrossatura sono paralleli agli assi.

# --- 812 ---
cycle-turn-shoulder-longitudinal-extended = Tornitura spallamento longitudinale estesa
    .nc = TORNITURA SPALL. LONG. EST.
    .purpose = Tornisce spallamenti in direzione longitudinale, all’esterno o all’interno: sgrossatura, finitura o entrambe. All’inizio e alla fine del profilo è possibile aggiungere uno smusso o un raccordo, per la superficie frontale e per quella perimetrale si possono definire angoli e lo spigolo del profilo può avere un raggio. I tagli di sgrossatura sono paralleli agli assi.

# --- 813 ---
cycle-turn-plunge-longitudinal = Tornitura longitudinale con entrata
    .nc = TORNITURA LONG. ENTRATA
    .purpose = Tornisce spallamenti con elementi di entrata (scarichi) in direzione longitudinale, all’esterno o all’interno: sgrossatura, finitura o entrambe. I tagli di sgrossatura sono paralleli agli assi.

# --- 814 ---
cycle-turn-plunge-longitudinal-extended = Tornitura longitudinale con entrata estesa
    .nc = TORNITURA LONG. ENTRATA EST.
    .purpose = Tornisce spallamenti con elementi di entrata (scarichi) in direzione longitudinale, all’esterno o all’interno: sgrossatura, finitura o entrambe. All’inizio e alla fine del profilo è possibile aggiungere uno smusso o un raccordo e si possono definire un angolo della superficie frontale e un raggio dello spigolo del profilo. I tagli di sgrossatura sono paralleli agli assi.

# --- 810 ---
cycle-turn-contour-longitudinal = Tornitura profilo longitudinale
    .nc = TORNITURA PROFILO LONG.
    .purpose = Tornisce in direzione longitudinale pezzi con un profilo di tornitura qualsiasi, descritto in un sottoprogramma, all’esterno o all’interno: sgrossatura, finitura o entrambe. I tagli di sgrossatura sono paralleli agli assi.

# --- 815 ---
cycle-turn-contour-parallel = Tornitura parallela al profilo
    .nc = PARALLELO AL PROFILO
    .purpose = Tornisce pezzi con un profilo di tornitura qualsiasi, descritto in un sottoprogramma, all’esterno o all’interno: sgrossatura, finitura o entrambe. I tagli di sgrossatura sono paralleli al profilo.

# --- 821 ---
cycle-turn-shoulder-face = Tornitura spallamento radiale
    .nc = TORNITURA SPALL. RAD.
    .purpose = Tornisce in direzione radiale spallamenti ad angolo retto, all’esterno o all’interno: sgrossatura, finitura o entrambe. I tagli di sgrossatura sono paralleli agli assi.

# --- 822 ---
cycle-turn-shoulder-face-extended = Tornitura spallamento radiale estesa
    .nc = TORNITURA SPALL. RAD. EST.
    .purpose = Tornisce in direzione radiale spallamenti, all’esterno o all’interno: sgrossatura, finitura o entrambe. All’inizio e alla fine del profilo è possibile aggiungere uno smusso o un raccordo, per la superficie frontale e per quella perimetrale si possono definire angoli e lo spigolo del profilo può avere un raggio. I tagli di sgrossatura sono paralleli agli assi.

# --- 823 ---
cycle-turn-plunge-face = Tornitura radiale con entrata
    .nc = TORNITURA RAD. ENTRATA
    .purpose = Tornisce in direzione radiale elementi di entrata (scarichi), all’esterno o all’interno: sgrossatura, finitura o entrambe. I tagli di sgrossatura sono paralleli agli assi.

# --- 824 ---
cycle-turn-plunge-face-extended = Tornitura radiale con entrata estesa
    .nc = TORNITURA RAD. ENTRATA EST.
    .purpose = Tornisce in direzione radiale elementi di entrata (scarichi), all’esterno o all’interno: sgrossatura, finitura o entrambe. All’inizio e alla fine del profilo è possibile aggiungere uno smusso o un raccordo e si possono definire un angolo della superficie frontale e un raggio dello spigolo del profilo. I tagli di sgrossatura sono paralleli agli assi.

# --- 820 ---
cycle-turn-contour-face = Tornitura profilo radiale
    .nc = TORNITURA PROFILO RAD.
    .purpose = Tornisce in direzione radiale pezzi con un profilo di tornitura qualsiasi, descritto in un sottoprogramma, all’esterno o all’interno: sgrossatura, finitura o entrambe. I tagli di sgrossatura sono paralleli agli assi.

# --- 800 ---
cycle-adapt-turning-system = Adattamento sistema di coordinate di tornitura
    .nc = ADATTA SISTEMA DI TORNITURA
    .purpose = Allinea il sistema di coordinate del pezzo per la tornitura e orienta il tagliente dell’utensile; può rendere speculare l’utensile, in modo che possa essere impiegato per lavorazioni interne ed esterne.
step-align-turning-system = Il controllo allinea il sistema di coordinate del pezzo all’angolo di precessione { $q-precession-angle } e orienta di conseguenza il tagliente dell’utensile: per la lavorazione esterna verso il centro della tavola rotante, per la lavorazione interna nella direzione opposta.
step-reverse-turning-tool = Con { $q-tool-reversal } si può rendere speculare il sistema di coordinate dell’utensile: il controllo ruota allora il mandrino di 180° e inverte l’orientamento utensile { $mp-tool-orientation }. In questo modo un utensile può essere impiegato per lavorazioni interne ed esterne.
note-before-turning = Prima della tornitura portare l’utensile nella posizione corretta e orientarne il tagliente.
note-position-over-turning-spindle = Per portare l’utensile in una posizione adatta, programmare un blocco di posizionamento sul centro del mandrino di tornitura, ad esempio L Y+0 R0 FMAX.
note-purpose-of-precession-angle = L’angolo di precessione { $q-precession-angle } definisce in quale punto della circonferenza viene lavorato il pezzo. Può essere necessario se, per motivi di spazio, l’utensile deve essere portato in una determinata posizione di lavorazione; la posizione di lavorazione può essere ruotata anche per osservare meglio la lavorazione.
note-precession-in-inclined-turning = Nella tornitura inclinata portare con l’angolo di precessione { $q-precession-angle } il tagliente e il sistema di coordinate in una posizione adatta.
note-turning-system-until-tool-call = Il ciclo è attivo dalla sua definizione fino alla chiamata utensile successiva.
note-turning-tool-clamped-and-measured = L’utensile deve essere serrato nella posizione corretta e misurato.
note-turning-tool-selected = Il ciclo può essere impiegato solo se è selezionato un utensile per tornire.
note-check-tool-orientation = Verificare l’orientamento dell’utensile prima della lavorazione.
note-own-functions-for-tool-alignment = Il costruttore della macchina può mettere a disposizione proprie funzioni per l’allineamento dell’utensile. Consultare il manuale della macchina.
note-cycle-depends-on-machine = Il ciclo { $cycle } dipende dalla macchina. Consultare il manuale della macchina.

# --- 801 ---
cycle-reset-turning-system = Reset sistema di coordinate di tornitura
    .nc = RESET SISTEMA DI TORNITURA
    .purpose = Annulla le impostazioni eseguite con il ciclo 800.
step-reset-turning-system = Il controllo annulla tutte le impostazioni programmate con il ciclo 800: l’angolo di precessione Q497 e l’inversione dell’utensile Q498.
note-tool-stays-oriented = L’utensile non viene riportato nel suo orientamento iniziale. Se il ciclo 800 lo ha orientato, rimane in questa posizione anche dopo il reset.
note-cycle-without-parameters = Il ciclo non ha parametri. Terminarne l’inserimento con il tasto END.
message-turning-contour-left = L’utensile non può lavorare completamente il profilo: l’inserto non lo raggiunge in ogni punto.
