# Parameters of pockets, slots, studs, line patterns and multipass milling; see the English file.

# --- pockets, slots and studs ---
parameter-circle-diameter = Diametro cerchio
    .label = DIAMETRO CERCHIO
    .help = Diametro della tasca finita.
parameter-slot-length = Lunghezza scanalatura
    .label = LUNGH. SCANALATURA
    .help = Lato più lungo della scanalatura, parallelo all’asse principale del piano di lavoro.
parameter-milled-slot-width = Larghezza scanalatura
    .label = LARGHEZZA SCANALATURA
    .help = Larghezza della scanalatura, parallela all’asse secondario del piano di lavoro. Se è uguale al diametro dell’utensile, il controllo esegue soltanto la sgrossatura (fresatura di un’asola). Larghezza massima per la sgrossatura: il doppio del diametro dell’utensile.
parameter-angle-of-rotation__slot =
    .help = Angolo di cui viene ruotata l’intera scanalatura. Il centro di rotazione è la posizione dell’utensile alla chiamata del ciclo.
parameter-angle-of-rotation__line-pattern =
    .help = Angolo di cui viene ruotata l’intera sagoma di punti. Il centro di rotazione è il punto di partenza. Vale anche per il ciclo di lavorazione chiamato dalla sagoma.
parameter-slot-position = Posizione scanalatura
    .label = POSIZIONE SCANALATURA
    .help = Posizione della scanalatura rispetto alla posizione dell’utensile alla chiamata del ciclo.
parameter-slot-position-reference = Riferimento posizione scanalatura
    .label = RIF. POS. SCANALATURA
    .help = Posizione della scanalatura rispetto alla posizione dell’utensile alla chiamata del ciclo.
parameter-slot-starting-angle = Angolo di partenza
    .label = ANGOLO DI PARTENZA
    .help = Angolo polare del punto di partenza.
parameter-slot-opening-angle = Angolo di apertura scanalatura
    .label = ANGOLO DI APERTURA
    .help = Angolo sul quale si estende la scanalatura.
parameter-pattern-stepping-angle__circular-slot =
    .help = Angolo di cui viene ruotata l’intera scanalatura a ogni ulteriore lavorazione. Il centro di rotazione è il centro del cerchio parziale.
parameter-stud-first-side-length = Lunghezza 1° lato
    .label = LUNGHEZZA 1° LATO
    .help = Lunghezza dell’isola, parallela all’asse principale del piano di lavoro.
parameter-blank-first-side-length = Quota grezza lunghezza lato 1
    .label = QUOTA GREZZA 1° LATO
    .help = Lunghezza dell’isola grezza, parallela all’asse principale del piano di lavoro. Inserire un valore maggiore della lunghezza del 1° lato { $q-stud-first-side-length }. Se la differenza tra i due valori supera l’incremento laterale ammesso (raggio dell’utensile moltiplicato per il fattore di sovrapposizione { $q-path-overlap }), il controllo esegue più incrementi laterali. Calcola sempre un incremento laterale costante.
parameter-stud-second-side-length = Lunghezza 2° lato
    .label = LUNGHEZZA 2° LATO
    .help = Lunghezza dell’isola, parallela all’asse secondario del piano di lavoro.
parameter-blank-second-side-length = Quota grezza lunghezza lato 2
    .label = QUOTA GREZZA 2° LATO
    .help = Lunghezza dell’isola grezza, parallela all’asse secondario del piano di lavoro. Inserire un valore maggiore della lunghezza del 2° lato { $q-stud-second-side-length }. Se la differenza tra i due valori supera l’incremento laterale ammesso (raggio dell’utensile moltiplicato per il fattore di sovrapposizione { $q-path-overlap }), il controllo esegue più incrementi laterali. Calcola sempre un incremento laterale costante.
parameter-corner-radius__rectangular-stud =
    .help = Raggio degli spigoli dell’isola.
parameter-side-allowance__rectangular-stud =
    .help = Sovrametallo di finitura nel piano di lavoro che il controllo lascia durante la lavorazione.
parameter-stud-position = Posizione isola
    .label = POSIZIONE ISOLA
    .help = Posizione dell’isola rispetto alla posizione dell’utensile alla chiamata del ciclo.
parameter-stud-approach-position = Posizione di accostamento
    .label = POS. DI ACCOSTAMENTO
    .help = Punto in cui l’utensile si accosta all’isola.
parameter-finished-part-diameter = Diametro parte finita
    .label = DIAM. PARTE FINITA
    .help = Diametro dell’isola finita.
parameter-blank-diameter = Diametro pezzo grezzo
    .label = DIAM. PEZZO GREZZO
    .help = Diametro del pezzo grezzo. Deve essere maggiore del diametro della parte finita { $q-finished-part-diameter }. Se la differenza tra i due valori supera l’incremento laterale ammesso (raggio dell’utensile moltiplicato per il fattore di sovrapposizione { $q-path-overlap }), il controllo esegue più incrementi laterali. Calcola sempre un incremento laterale costante.
parameter-stud-starting-angle = Angolo di partenza
    .label = ANGOLO DI PARTENZA
    .help = Angolo polare, riferito al centro dell’isola, in cui l’utensile si accosta all’isola.
parameter-depth__slot =
    .help = Distanza tra la superficie del pezzo e il fondo della scanalatura.
parameter-depth__circular-slot =
    .help = Distanza tra la superficie del pezzo e il fondo della scanalatura.
parameter-depth__circular-pocket =
    .help = Distanza tra la superficie del pezzo e il fondo della tasca.
parameter-depth__rectangular-stud =
    .help = Distanza tra la superficie del pezzo e il fondo dell’isola.
parameter-depth__circular-stud =
    .help = Distanza tra la superficie del pezzo e il fondo dell’isola.
parameter-plunging-depth__circular-pocket =
    .help = Profondità di cui l’utensile avanza a ogni incremento. Inserire un valore maggiore di 0.
parameter-plunging-depth__slot =
    .help = Profondità di cui l’utensile avanza a ogni incremento. Inserire un valore maggiore di 0.
parameter-plunging-depth__circular-slot =
    .help = Profondità di cui l’utensile avanza a ogni incremento. Inserire un valore maggiore di 0.
parameter-plunging-depth__rectangular-stud =
    .help = Profondità di cui l’utensile avanza a ogni incremento. Inserire un valore maggiore di 0.
parameter-plunging-depth__circular-stud =
    .help = Profondità di cui l’utensile avanza a ogni incremento. Inserire un valore maggiore di 0.
parameter-plunging-feed__circular-pocket =
    .help = Velocità di spostamento dell’utensile durante la discesa in profondità.
parameter-plunging-feed__slot =
    .help = Velocità di spostamento dell’utensile durante la discesa in profondità.
parameter-plunging-feed__circular-slot =
    .help = Velocità di spostamento dell’utensile durante la discesa in profondità.
parameter-plunging-feed__rectangular-stud =
    .help = Velocità di spostamento dell’utensile durante la discesa in profondità.
parameter-plunging-feed__circular-stud =
    .help = Velocità di spostamento dell’utensile durante la discesa in profondità.
parameter-plunging-feed__multipass-milling =
    .help = Velocità di spostamento dell’utensile durante la discesa in profondità.

# --- line patterns ---
parameter-pattern-spacing-main = Distanza 1° asse
    .label = DISTANZA 1° ASSE
    .help = Distanza tra i punti di una riga.
parameter-pattern-spacing-minor = Distanza 2° asse
    .label = DISTANZA 2° ASSE
    .help = Distanza tra le righe.
parameter-number-of-columns = Numero di colonne
    .label = NUMERO COLONNE
    .help = Numero di lavorazioni in una riga.
parameter-number-of-lines = Numero di righe
    .label = NUMERO RIGHE
    .help = Numero di righe.
parameter-starting-point-main__line-pattern =
    .help = Coordinata del punto di partenza nell’asse principale del piano di lavoro.
parameter-starting-point-minor__line-pattern =
    .help = Coordinata del punto di partenza nell’asse secondario del piano di lavoro.
parameter-set-up-clearance__line-pattern =
    .help = Distanza tra la punta dell’utensile e la superficie del pezzo. Vale anche per il ciclo di lavorazione chiamato dalla sagoma.
parameter-surface-coordinate__line-pattern =
    .help = Coordinata della superficie del pezzo. Vale anche per il ciclo di lavorazione chiamato dalla sagoma.
parameter-second-set-up-clearance__line-pattern =
    .help = Altezza nell’asse del mandrino che esclude qualsiasi collisione tra l’utensile e il pezzo o i dispositivi di bloccaggio. Vale anche per il ciclo di lavorazione chiamato dalla sagoma.

# --- multipass milling of surfaces ---
parameter-starting-point-main = Punto di partenza 1° asse
    .label = PUNTO PARTENZA 1° ASSE
    .help = Coordinata del punto di partenza della superficie da lavorare nell’asse principale del piano di lavoro.
parameter-starting-point-minor = Punto di partenza 2° asse
    .label = PUNTO PARTENZA 2° ASSE
    .help = Coordinata del punto di partenza della superficie da lavorare nell’asse secondario del piano di lavoro.
parameter-starting-point-tool = Punto di partenza 3° asse
    .label = PUNTO PARTENZA 3° ASSE
    .help = Altezza nell’asse del mandrino alla quale viene fresata la superficie.
parameter-starting-point-tool__ruled-surface =
    .help = Coordinata del punto di partenza della superficie da fresare nell’asse del mandrino.
parameter-starting-point-tool__face-milling =
    .help = Coordinata della superficie del pezzo da cui vengono calcolati gli incrementi.
parameter-first-side-length__multipass-milling =
    .help = Lunghezza della superficie da fresare nell’asse principale del piano di lavoro, dal punto di partenza 1° asse.
parameter-first-side-length__face-milling =
    .help = Lunghezza della superficie da lavorare nell’asse principale del piano di lavoro. Il segno determina la direzione della prima traiettoria di fresatura rispetto al punto di partenza 1° asse.
parameter-second-side-length__multipass-milling =
    .help = Lunghezza della superficie da fresare nell’asse secondario del piano di lavoro, dal punto di partenza 2° asse.
parameter-second-side-length__face-milling =
    .help = Lunghezza della superficie da lavorare nell’asse secondario del piano di lavoro. Il segno determina la direzione del primo incremento laterale rispetto al punto di partenza 2° asse.
parameter-number-of-cuts = Numero di tagli
    .label = NUMERO TAGLI
    .help = Numero di righe con cui il controllo sposta l’utensile sulla larghezza.
parameter-number-of-cuts__ruled-surface =
    .help = Numero di righe che il controllo esegue tra i punti 1 e 4 o tra i punti 2 e 3.
parameter-stepover-feed = Avanzamento trasversale
    .label = AVANZ. TRASVERSALE
    .help = Velocità di spostamento dell’utensile nel passaggio alla riga successiva. Per uno spostamento trasversale nel materiale inserire un valore minore di { $q-milling-feed }; per uno spostamento sopra il pezzo { $q-stepover-feed } può essere maggiore di { $q-milling-feed }.
parameter-set-up-clearance__multipass-milling =
    .help = Distanza tra la punta dell’utensile e la profondità di fresatura per il posizionamento all’inizio e alla fine del ciclo.
parameter-set-up-clearance__face-milling =
    .help = Distanza tra la punta dell’utensile e la posizione di partenza nell’asse utensile. Con la strategia { $q-face-milling-strategy } = 2 l’utensile si porta a questa distanza sopra la profondità incremento attuale sul punto di partenza della riga successiva.
parameter-surface-second-point-main = 2° punto 1° asse
    .label = 2° PUNTO 1° ASSE
    .help = Coordinata del punto finale della superficie da fresare nell’asse principale del piano di lavoro.
parameter-surface-second-point-minor = 2° punto 2° asse
    .label = 2° PUNTO 2° ASSE
    .help = Coordinata del punto finale della superficie da fresare nell’asse secondario del piano di lavoro.
parameter-surface-second-point-tool = 2° punto 3° asse
    .label = 2° PUNTO 3° ASSE
    .help = Coordinata del punto finale della superficie da fresare nell’asse del mandrino.
parameter-surface-third-point-main = 3° punto 1° asse
    .label = 3° PUNTO 1° ASSE
    .help = Coordinata del punto 3 nell’asse principale del piano di lavoro.
parameter-surface-third-point-minor = 3° punto 2° asse
    .label = 3° PUNTO 2° ASSE
    .help = Coordinata del punto 3 nell’asse secondario del piano di lavoro.
parameter-surface-third-point-tool = 3° punto 3° asse
    .label = 3° PUNTO 3° ASSE
    .help = Coordinata del punto 3 nell’asse del mandrino.
parameter-surface-fourth-point-main = 4° punto 1° asse
    .label = 4° PUNTO 1° ASSE
    .help = Coordinata del punto 4 nell’asse principale del piano di lavoro.
parameter-surface-fourth-point-minor = 4° punto 2° asse
    .label = 4° PUNTO 2° ASSE
    .help = Coordinata del punto 4 nell’asse secondario del piano di lavoro.
parameter-surface-fourth-point-tool = 4° punto 3° asse
    .label = 4° PUNTO 3° ASSE
    .help = Coordinata del punto 4 nell’asse del mandrino.
parameter-milling-feed__ruled-surface =
    .help = Velocità di spostamento dell’utensile durante la fresatura. Il controllo esegue il primo taglio con metà del valore programmato.
parameter-face-milling-strategy = Strategia di lavorazione
    .label = STRATEGIA
    .help = Modo in cui il controllo lavora la superficie.
parameter-end-point-tool = Punto finale 3° asse
    .label = PUNTO FINALE 3° ASSE
    .help = Coordinata nell’asse del mandrino fino alla quale viene spianata la superficie.
parameter-max-plunging-depth = Profondità incremento massima
    .label = PROF. INCREM. MASSIMA
    .help = Massima profondità di cui l’utensile avanza a ogni incremento. Il controllo calcola la profondità incremento effettiva dalla differenza tra punto finale e punto di partenza nell’asse utensile, in modo che tutti gli incrementi siano uguali; tiene conto del sovrametallo di finitura { $q-floor-allowance }.
parameter-floor-allowance__face-milling =
    .help = Profondità dell’ultimo incremento.
parameter-max-path-overlap = Fattore di sovrapposizione traiettorie massimo
    .label = SOVRAPP. MASSIMA
    .help = Fattore per il massimo incremento laterale k. Il controllo calcola l’incremento laterale effettivo dalla lunghezza del 2° lato { $q-second-side-length } e dal raggio dell’utensile, in modo che tutti gli incrementi laterali siano uguali. Se nella tabella utensili è inserito un raggio { $mp-tool-radius-2 } (ad esempio il raggio degli inserti di una fresa a spianare), il controllo riduce di conseguenza l’incremento laterale.
parameter-finishing-feed__face-milling =
    .help = Velocità di spostamento dell’utensile durante la fresatura dell’ultimo incremento.
parameter-pre-positioning-feed__face-milling =
    .help = Velocità di spostamento dell’utensile verso la posizione di partenza e nel passaggio alla riga successiva. Se l’incremento laterale avviene nel materiale ({ $q-face-milling-strategy } = 1), il controllo lo esegue con l’avanzamento di fresatura { $q-milling-feed }.
parameter-side-clearance = Distanza laterale
    .label = DISTANZA LATERALE
    .help = Distanza tra l’utensile e il lato del pezzo quando l’utensile si porta alla prima profondità incremento, e distanza alla quale avvengono gli incrementi laterali con le strategie { $q-face-milling-strategy } = 0 e { $q-face-milling-strategy } = 2.

# --- choices ---
choice-vertical-plunging-with-angle-0-or-90 = Penetrazione verticale. Nella tabella utensili l’angolo di penetrazione { $mp-plunging-angle } dell’utensile attivo deve essere 0 o 90; in caso contrario il controllo emette un messaggio d’errore
choice-reciprocating-plunging-by-angle = Penetrazione con pendolamento. Nella tabella utensili l’angolo di penetrazione { $mp-plunging-angle } dell’utensile attivo deve essere diverso da 0; in caso contrario il controllo emette un messaggio d’errore
choice-tool-at-slot-centre = Posizione utensile = centro della scanalatura
choice-tool-at-left-slot-end = Posizione utensile = estremità sinistra della scanalatura
choice-tool-at-left-slot-arc-centre = Posizione utensile = centro dell’arco sinistro della scanalatura
choice-tool-at-right-slot-arc-centre = Posizione utensile = centro dell’arco destro della scanalatura
choice-tool-at-right-slot-end = Posizione utensile = estremità destra della scanalatura
choice-tool-position-not-considered = La posizione dell’utensile non viene considerata. La posizione della scanalatura risulta dal centro del cerchio parziale e dall’angolo di partenza inseriti
choice-slot-begins-at-tool = Posizione utensile = centro dell’arco sinistro della scanalatura. L’angolo di partenza { $q-slot-starting-angle } si riferisce a questa posizione. Il centro del cerchio parziale inserito non viene considerato
choice-slot-middle-at-tool = Posizione utensile = centro dell’asse mediano. L’angolo di partenza { $q-slot-starting-angle } si riferisce a questa posizione. Il centro del cerchio parziale inserito non viene considerato
choice-slot-ends-at-tool = Posizione utensile = centro dell’arco destro della scanalatura. L’angolo di partenza { $q-slot-starting-angle } si riferisce a questa posizione. Il centro del cerchio parziale inserito non viene considerato
choice-tool-at-stud-centre = Posizione utensile = centro dell’isola
choice-approach-right-of-stud = A destra dell’isola (impostazione standard)
choice-approach-at-lower-left-corner = Spigolo in basso a sinistra
choice-approach-at-lower-right-corner = Spigolo in basso a destra
choice-approach-at-upper-right-corner = Spigolo in alto a destra
choice-approach-at-upper-left-corner = Spigolo in alto a sinistra
choice-meander-stepover-outside = Lavorazione a meandri, incremento laterale all’esterno della superficie da lavorare
choice-meander-stepover-inside = Lavorazione a meandri, incremento laterale all’interno della superficie da lavorare
choice-line-by-line-with-retraction = Lavorazione per righe, con ritrazione e incremento laterale con l’avanzamento di avvicinamento

# --- coordinate transforms ---
parameter-mirrored-axes = Assi speculari
    .help = Assi da rendere speculari. Si possono rendere speculari tutti gli assi, compresi gli assi rotativi, tranne l’asse del mandrino e l’asse secondario parallelo ad esso. Fino a tre degli assi NC X, Y, Z, U, V, W, A, B, C.
    .prompt = Asse speculare?
parameter-scaling-factor = Fattore
    .help = Fattore di scala SCL. Il controllo moltiplica per esso coordinate e raggi.
    .prompt = Fattore?
    .word = SCL
parameter-axis-scaling-factors = Asse e fattore
    .help = Assi di coordinate e fattori con i quali ciascuno di essi viene allungato o compresso.
parameter-axis-scaling-centre = Coordinate del centro
    .help = Centro dal quale il profilo viene allungato o verso il quale viene compresso.
parameter-tilting-angles = Asse e angolo di rotazione
    .help = Assi rotativi con i relativi angoli di rotazione; gli assi rotativi A, B e C si programmano con softkey.
    .prompt = Asse e angolo di rotazione?
parameter-tilting-feed = Avanzamento
    .help = Velocità di spostamento dell’asse rotativo nel posizionamento automatico da parte del controllo.
    .prompt = Avanzamento? F=
parameter-tilting-clearance = Distanza di sicurezza
    .help = Il controllo posiziona la testa orientabile in modo che la posizione all’estremità dell’utensile, prolungato della distanza di sicurezza, non cambi rispetto al pezzo. Si inserisce se è il controllo a posizionare gli assi rotativi.
    .prompt = Distanza di sicurezza?

# --- special functions ---
parameter-programmed-dwell = Tempo di sosta in secondi
    .help = Tempo per il quale l’esecuzione del programma si arresta, fino a 1 ora in passi di 0,001 s.
    .word = T.SOSTA
parameter-program-to-call = Nome programma
    .help = Nome del programma da chiamare, se necessario con il percorso.
    .word = PGM
parameter-orientation-angle = Angolo di orientamento
    .help = Angolo riferito all’asse di riferimento angolare del piano di lavoro.
    .word = ANGOLO
parameter-contour-tolerance = Valore di tolleranza T
    .help = Scostamento ammesso dal profilo programmato in millimetri (in pollici nei programmi in pollici).
parameter-hsc-mode = Modo HSC, finitura=0, sgrossatura=1
    .help = Filtro attivato dal controllo.
parameter-rotary-axis-tolerance = Tolleranza per assi rotativi TA
    .help = Scostamento ammesso degli assi rotativi in gradi con M128 (FUNCTION TCPM) attiva. Il controllo riduce sempre l’avanzamento in modo che, nei movimenti in più assi, l’asse più lento si sposti con il suo avanzamento massimo. Gli assi rotativi sono di solito molto più lenti degli assi lineari. Una tolleranza maggiore (ad esempio 10°) può ridurre notevolmente il tempo di lavorazione di programmi a più assi, poiché il controllo non deve sempre portare gli assi rotativi alla posizione nominale indicata. Il profilo non viene danneggiato; cambia soltanto la posizione dell’asse rotativo rispetto alla superficie del pezzo.

# --- choices of the special functions ---
choice-milling-with-higher-accuracy = Fresatura con maggiore precisione del profilo. Il controllo utilizza impostazioni di filtro interne per la finitura
choice-milling-at-higher-feed = Fresatura con avanzamento più elevato. Il controllo utilizza impostazioni di filtro interne per la sgrossatura
