# Parameters of the machining cycles; see the English file.

# --- heights and depths ---
parameter-set-up-clearance = Distanza di sicurezza
    .label = DISTANZA SICUREZZA
    .help = Distanza tra la punta dell’utensile e la superficie del pezzo.
parameter-set-up-clearance__drilling =
    .help = Distanza tra la punta dell’utensile e la superficie del pezzo. Inserire un valore positivo.
parameter-set-up-clearance__centring =
    .help = Distanza tra la punta dell’utensile e la superficie del pezzo. Inserire un valore positivo.
parameter-set-up-clearance__circular-pattern =
    .help = Distanza tra la punta dell’utensile e la superficie del pezzo. Vale anche per il ciclo di lavorazione chiamato dalla sagoma.
parameter-set-up-clearance__rectangular-pocket =
    .help = Distanza tra la punta dell’utensile e la superficie del pezzo. PREDEF acquisisce il valore dal blocco GLOBAL DEF.
parameter-set-up-clearance__circular-pocket =
    .help = Distanza tra la punta dell’utensile e la superficie del pezzo. PREDEF acquisisce il valore dal blocco GLOBAL DEF.
parameter-set-up-clearance__slot =
    .help = Distanza tra la punta dell’utensile e la superficie del pezzo. PREDEF acquisisce il valore dal blocco GLOBAL DEF.
parameter-set-up-clearance__circular-slot =
    .help = Distanza tra la punta dell’utensile e la superficie del pezzo. PREDEF acquisisce il valore dal blocco GLOBAL DEF.
parameter-set-up-clearance__rectangular-stud =
    .help = Distanza tra la punta dell’utensile e la superficie del pezzo. PREDEF acquisisce il valore dal blocco GLOBAL DEF.
parameter-set-up-clearance__circular-stud =
    .help = Distanza tra la punta dell’utensile e la superficie del pezzo. PREDEF acquisisce il valore dal blocco GLOBAL DEF.
parameter-second-set-up-clearance = 2ª distanza di sicurezza
    .label = 2ª DISTANZA SICUREZZA
    .help = Altezza nell’asse del mandrino che esclude qualsiasi collisione tra l’utensile e il pezzo o i dispositivi di bloccaggio.
parameter-second-set-up-clearance__circular-pattern =
    .help = Altezza nell’asse del mandrino che esclude qualsiasi collisione tra l’utensile e il pezzo o i dispositivi di bloccaggio. Vale anche per il ciclo di lavorazione chiamato dalla sagoma.
parameter-second-set-up-clearance__rectangular-pocket =
    .help = Altezza nell’asse del mandrino che esclude qualsiasi collisione tra l’utensile e il pezzo o i dispositivi di bloccaggio. PREDEF acquisisce il valore dal blocco GLOBAL DEF.
parameter-second-set-up-clearance__circular-pocket =
    .help = Altezza nell’asse del mandrino che esclude qualsiasi collisione tra l’utensile e il pezzo o i dispositivi di bloccaggio. PREDEF acquisisce il valore dal blocco GLOBAL DEF.
parameter-second-set-up-clearance__slot =
    .help = Altezza nell’asse del mandrino che esclude qualsiasi collisione tra l’utensile e il pezzo o i dispositivi di bloccaggio. PREDEF acquisisce il valore dal blocco GLOBAL DEF.
parameter-second-set-up-clearance__circular-slot =
    .help = Altezza nell’asse del mandrino che esclude qualsiasi collisione tra l’utensile e il pezzo o i dispositivi di bloccaggio. PREDEF acquisisce il valore dal blocco GLOBAL DEF.
parameter-second-set-up-clearance__rectangular-stud =
    .help = Altezza nell’asse del mandrino che esclude qualsiasi collisione tra l’utensile e il pezzo o i dispositivi di bloccaggio. PREDEF acquisisce il valore dal blocco GLOBAL DEF.
parameter-second-set-up-clearance__circular-stud =
    .help = Altezza nell’asse del mandrino che esclude qualsiasi collisione tra l’utensile e il pezzo o i dispositivi di bloccaggio. PREDEF acquisisce il valore dal blocco GLOBAL DEF.
parameter-second-set-up-clearance__face-milling =
    .help = Altezza nell’asse del mandrino che esclude qualsiasi collisione tra l’utensile e il pezzo o i dispositivi di bloccaggio. PREDEF acquisisce il valore dal blocco GLOBAL DEF.
parameter-surface-coordinate = Coordinata superficie pezzo
    .label = COORD. SUPERFICIE
    .help = Coordinata della superficie del pezzo.
parameter-surface-coordinate__circular-pattern =
    .help = Coordinata della superficie del pezzo. Vale anche per il ciclo di lavorazione chiamato dalla sagoma.
parameter-depth = Profondità
    .label = PROFONDITÀ
    .help = Distanza tra la superficie del pezzo e il fondo del foro, misurata fino alla punta del cono di foratura.
parameter-depth__rectangular-pocket =
    .help = Distanza tra la superficie del pezzo e il fondo della tasca.
parameter-plunging-depth = Profondità incremento
    .label = PROF. INCREMENTO
    .help = Profondità di cui l’utensile avanza a ogni incremento. La profondità non deve essere necessariamente un suo multiplo. L’utensile raggiunge la profondità in un unico movimento se i due valori sono uguali o se la profondità incremento è maggiore della profondità.
parameter-plunging-depth__rectangular-pocket =
    .help = Profondità di cui l’utensile avanza a ogni incremento. Inserire un valore maggiore di 0.
parameter-decrement = Decremento
    .label = DECREMENTO
    .help = Valore di cui la profondità incremento { $q-plunging-depth } si riduce a ogni incremento.
parameter-least-plunging-depth = Profondità incremento minima
    .label = PROF. INCREM. MINIMA
    .help = Se è inserito un decremento { $q-decrement }, nessun incremento diventa inferiore a questo valore.
parameter-upper-advanced-stop-distance = Distanza di prearresto sopra
    .label = DIST. PREARRESTO SOPRA
    .help = Distanza sopra la profondità attuale per il ritorno in rapido dell’utensile nel foro dopo una ritrazione: valore per il primo incremento.
parameter-lower-advanced-stop-distance = Distanza di prearresto sotto
    .label = DIST. PREARRESTO SOTTO
    .help = Distanza sopra la profondità attuale per il ritorno in rapido dell’utensile nel foro dopo una ritrazione: valore per l’ultimo incremento.
parameter-depth-for-chip-breaking = Profondità di foratura per rottura truciolo
    .label = PROF. ROTT. TRUCIOLO
    .help = Incremento dopo il quale viene rotto il truciolo. Con 0 non viene eseguita alcuna rottura truciolo.
parameter-chip-breaking-retraction = Ritrazione per rottura truciolo
    .label = RITRAZ. ROTT. TRUCIOLO
    .help = Distanza di cui l’utensile viene ritratto per rompere il truciolo. L’utensile si ritrae a 3000 mm/min.
parameter-deepened-starting-point = Punto di partenza abbassato
    .label = PUNTO DI PARTENZA
    .help = Punto di partenza della foratura effettiva, misurato dalla superficie del pezzo, quando un utensile più corto ha già eseguito il foro fino a una certa profondità. L’utensile vi si porta dalla distanza di sicurezza con l’avanzamento di avvicinamento { $q-pre-positioning-feed }.

# --- feeds and times ---
parameter-plunging-feed = Avanzamento in profondità
    .label = AVANZ. IN PROFONDITÀ
    .help = Velocità di spostamento dell’utensile durante la foratura.
parameter-plunging-feed__rectangular-pocket =
    .help = Velocità di spostamento dell’utensile durante la discesa in profondità.
parameter-pre-positioning-feed = Avanzamento di avvicinamento
    .label = AVANZ. PRE-POSIZIONAM.
    .help = Velocità di spostamento dell’utensile dalla distanza di sicurezza al punto di partenza abbassato. Ha effetto solo se { $q-deepened-starting-point } è diverso da 0.
parameter-milling-feed = Avanzamento di fresatura
    .label = AVANZ. FRESATURA
    .help = Velocità di spostamento dell’utensile durante la fresatura.
parameter-finishing-feed = Avanzamento di finitura
    .label = AVANZ. FINITURA
    .help = Velocità di spostamento dell’utensile durante la finitura laterale e del fondo.
parameter-dwell-at-top = Tempo di sosta sopra
    .label = TEMPO DI SOSTA SOPRA
    .help = Tempo di permanenza dell’utensile alla distanza di sicurezza dopo che è stato ritratto dal foro per il raffreddamento.
parameter-dwell-at-bottom = Tempo di sosta sotto
    .label = TEMPO DI SOSTA SOTTO
    .help = Tempo di permanenza dell’utensile sul fondo del foro.

# --- milling of pockets ---
parameter-machining-operation = Tipo di lavorazione
    .label = TIPO DI LAVORAZIONE
    .help = Definire che cosa viene lavorato. La finitura laterale e quella del fondo vengono eseguite solo se è definito il rispettivo sovrametallo ({ $q-side-allowance }, { $q-floor-allowance }).
parameter-first-side-length = Lunghezza 1° lato
    .label = LUNGHEZZA 1° LATO
    .help = Lunghezza della tasca, parallela all’asse principale del piano di lavoro.
parameter-second-side-length = Lunghezza 2° lato
    .label = LUNGHEZZA 2° LATO
    .help = Lunghezza della tasca, parallela all’asse secondario del piano di lavoro.
parameter-corner-radius = Raggio spigolo
    .label = RAGGIO SPIGOLO
    .help = Raggio degli spigoli della tasca. Con 0 il controllo adotta il raggio dell’utensile come raggio dello spigolo.
parameter-side-allowance = Sovrametallo finitura laterale
    .label = SOVRAMETALLO LATERALE
    .help = Sovrametallo di finitura nel piano di lavoro.
parameter-floor-allowance = Sovrametallo finitura fondo
    .label = SOVRAMETALLO FONDO
    .help = Sovrametallo di finitura in profondità.
parameter-angle-of-rotation = Angolo di rotazione
    .label = ANGOLO DI ROTAZIONE
    .help = Angolo di cui viene ruotata l’intera lavorazione. Il centro di rotazione è la posizione dell’utensile alla chiamata del ciclo.
parameter-pocket-position = Posizione tasca
    .label = POSIZIONE TASCA
    .help = Posizione della tasca rispetto alla posizione dell’utensile alla chiamata del ciclo.
parameter-milling-type = Fresatura concorde o discorde
    .label = TIPO DI FRESATURA
    .help = Tipo di fresatura con mandrino in rotazione oraria (M3). PREDEF acquisisce il valore dal blocco GLOBAL DEF.
parameter-finishing-infeed = Incremento per finitura
    .label = INCREMENTO FINITURA
    .help = Distanza di cui l’utensile avanza nell’asse del mandrino a ogni passata di finitura. Con 0 la finitura viene eseguita in un unico incremento.
parameter-path-overlap = Fattore di sovrapposizione traiettorie
    .label = SOVRAPP. TRAIETTORIE
    .help = Questo fattore moltiplicato per il raggio dell’utensile dà l’incremento laterale k. PREDEF acquisisce il valore dal blocco GLOBAL DEF.
parameter-plunging-strategy = Strategia di penetrazione
    .label = PENETRAZIONE
    .help = Modalità con cui l’utensile penetra nel materiale. PREDEF acquisisce il valore dal blocco GLOBAL DEF.

# --- patterns ---
parameter-pitch-circle-centre-main = Centro 1° asse
    .label = CENTRO 1° ASSE
    .help = Centro del cerchio parziale nell’asse principale del piano di lavoro.
parameter-pitch-circle-centre-minor = Centro 2° asse
    .label = CENTRO 2° ASSE
    .help = Centro del cerchio parziale nell’asse secondario del piano di lavoro.
parameter-pitch-circle-diameter = Diametro cerchio parziale
    .label = DIAM. CERCHIO PARZIALE
    .help = Diametro del cerchio parziale.
parameter-pattern-starting-angle = Angolo di partenza
    .label = ANGOLO DI PARTENZA
    .help = Angolo tra l’asse principale del piano di lavoro e il punto di partenza della prima lavorazione sul cerchio parziale.
parameter-pattern-stopping-angle = Angolo finale
    .label = ANGOLO FINALE
    .help = Angolo tra l’asse principale del piano di lavoro e il punto di partenza dell’ultima lavorazione sul cerchio parziale; non vale per cerchi completi. Deve essere diverso dall’angolo di partenza { $q-pattern-starting-angle }. Se è maggiore dell’angolo di partenza, la lavorazione procede in senso antiorario, altrimenti in senso orario.
parameter-pattern-stepping-angle = Angolo incrementale
    .label = ANGOLO INCREMENTALE
    .help = Angolo tra due lavorazioni sul cerchio parziale. Con 0 il controllo lo calcola dall’angolo di partenza, dall’angolo finale e dal numero di lavorazioni. Se viene inserito, l’angolo finale { $q-pattern-stopping-angle } non viene considerato. Il segno determina la direzione (− = senso orario).
parameter-number-of-operations = Numero lavorazioni
    .label = NUMERO LAVORAZIONI
    .help = Numero di lavorazioni sul cerchio parziale.
parameter-pattern-clearance-mode = Spostamento ad altezza di sicurezza
    .label = SPOST. AD ALT. SICUR.
    .help = Altezza alla quale l’utensile si sposta tra una lavorazione e l’altra.
parameter-pattern-traverse-type = Tipo di traiettoria
    .label = TIPO DI TRAIETTORIA
    .help = Funzione di traiettoria con cui l’utensile si sposta tra una lavorazione e l’altra.
    .prompt = Tipo di traiettoria? Retta=0/cerchio=1

# --- coordinate transforms ---
parameter-datum-shift = Spostamento
    .help = Coordinate della nuova origine. I valori assoluti si riferiscono all’origine del pezzo impostata; i valori incrementali si riferiscono sempre all’ultima origine valida, che può già essere spostata. Fino a 6 assi NC.
parameter-datum-row = Spostamento
    .help = Numero dell’origine nella tabella origini oppure un parametro Q. Con un parametro Q il controllo attiva l’origine il cui numero è contenuto nel parametro.
parameter-rotation-angle = Rotazione
    .help = Angolo di rotazione in gradi, assoluto o incrementale.
parameter-preset-number = Numero origine
    .label = NUMERO ORIGINE
    .help = Numero dell’origine da attivare nella tabella Preset.
    .prompt = Numero origine?

# --- choices ---
choice-roughing-and-finishing = Sgrossatura e finitura
choice-roughing-only = Solo sgrossatura
choice-finishing-only = Finitura laterale e del fondo
choice-tool-at-pocket-centre = Posizione utensile = centro della tasca
choice-tool-at-lower-left-corner = Posizione utensile = spigolo in basso a sinistra
choice-tool-at-lower-right-corner = Posizione utensile = spigolo in basso a destra
choice-tool-at-upper-right-corner = Posizione utensile = spigolo in alto a destra
choice-tool-at-upper-left-corner = Posizione utensile = spigolo in alto a sinistra
choice-climb-milling = Fresatura concorde
choice-up-cut-milling = Fresatura discorde
choice-vertical-plunging = Penetrazione verticale, indipendentemente dall’angolo di penetrazione { $mp-plunging-angle } della tabella utensili
choice-helical-plunging = Penetrazione elicoidale. Nella tabella utensili l’angolo di penetrazione { $mp-plunging-angle } dell’utensile attivo deve essere diverso da 0; in caso contrario il controllo emette un messaggio d’errore
choice-reciprocating-plunging = Penetrazione con pendolamento. Nella tabella utensili l’angolo di penetrazione { $mp-plunging-angle } dell’utensile attivo deve essere diverso da 0; in caso contrario il controllo emette un messaggio d’errore. La lunghezza del pendolamento dipende dall’angolo di penetrazione ed è almeno il doppio del diametro dell’utensile
choice-at-set-up-clearance = Spostamento alla distanza di sicurezza tra una lavorazione e l’altra
choice-at-second-set-up-clearance = Spostamento alla 2ª distanza di sicurezza tra una lavorazione e l’altra
choice-straight-between-operations = Spostamento su una retta tra una lavorazione e l’altra
choice-on-the-pitch-circle = Spostamento sul cerchio parziale tra una lavorazione e l’altra
