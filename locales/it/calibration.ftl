# Cycles that calibrate touch probes; see the English file.

# --- 460 ---
cycle-calibrate-on-sphere = Calibrazione TS: calibrazione del raggio e della lunghezza con sfera
    .nc = CALIBRAZIONE TS SU SFERA
    .purpose = Calibra automaticamente un sistema di tastatura 3D digitale su una sfera calibrata precisa: solo il raggio, oppure raggio e lunghezza.
condition-length-calibration-wanted = { $q-length-calibration }=1
step-position-probe-over-sphere = Posizionare il sistema di tastatura sopra la sfera calibrata nell’asse del tastatore e al centro della sfera nel piano di lavoro.
step-approach-sphere-downwards = Il primo movimento del ciclo avviene in direzione negativa dell’asse del tastatore.
step-find-sphere-centre = Il controllo determina il centro esatto della sfera nell’asse del tastatore.
step-calibrate-radius-on-sphere = Il controllo calibra il raggio con { $q-calibration-sphere-probings } tastature nel piano. Tra i punti di misura il sistema di tastatura si sposta:
say-travel-at-clearance-height-between-points = con { $q-traverse-to-clearance-height }=1 all’altezza di sicurezza
say-travel-at-measuring-height-between-points = con { $q-traverse-to-clearance-height }=0 all’altezza di misura
step-calibrate-length-on-sphere = Dopo il raggio il controllo elabora la lunghezza in base a { $q-length-calibration }:
say-length-from-sphere-centre = con { $q-length-calibration }=1 calibra la lunghezza; { $q-length-reference } è la coordinata del centro della sfera
say-length-unchanged = con { $q-length-calibration }=0 non calibra la lunghezza
step-store-calibration-values = Il controllo memorizza i valori di calibrazione, che diventano subito attivi.
note-position-above-sphere-in-program = Nel programma posizionare il sistema di tastatura in modo che si trovi approssimativamente sopra il centro della sfera.
note-effective-length-reference = La lunghezza attiva del sistema di tastatura si riferisce sempre al punto di riferimento dell’utensile. Di regola il costruttore della macchina colloca questo punto sul naso del mandrino.
note-when-to-calibrate = Calibrare sempre il sistema di tastatura alla messa in funzione, dopo la rottura o la sostituzione di uno stilo, dopo una modifica dell’avanzamento di tastatura, in caso di anomalie impreviste (ad esempio per il riscaldamento della macchina) e dopo un cambio dell’asse utensile attivo.
note-when-to-calibrate__tnc426-430 = Calibrare sempre il sistema di tastatura alla messa in funzione, dopo la rottura o la sostituzione di uno stilo, dopo una modifica dell’avanzamento di tastatura e in caso di irregolarità (ad esempio per il riscaldamento della macchina).
note-known-ring-or-stud = La calibrazione determina la lunghezza attiva dello stilo e il raggio attivo della sfera di tastatura. Per la calibrazione serrare sulla tavola della macchina un anello di calibrazione o un’isola di altezza e raggio noti.
note-known-ring-or-stud__tnc426-430 = La calibrazione determina la lunghezza attiva dello stilo e il raggio attivo della sfera di tastatura. Per la calibrazione collocare sulla tavola della macchina un anello di calibrazione di altezza e raggio interno noti.
note-calibration-values-at-once = I valori di calibrazione del sistema di tastatura attivo hanno effetto subito dopo la calibrazione. Non occorre richiamare l’utensile.
note-calibration-values-in-tables = Il controllo memorizza la lunghezza attiva e il raggio attivo del sistema di tastatura nella tabella utensili e il suo offset centrale nelle colonne { $mp-probe-offset-main } (asse principale) e { $mp-probe-offset-minor } (asse secondario) della tabella del sistema di tastatura. Il softkey della tabella del sistema di tastatura visualizza i valori memorizzati.
note-right-tool-number-for-probe = Quando si impiega un sistema di tastatura deve essere attivo il numero utensile corretto, indipendentemente dal fatto che un ciclo di tastatura venga eseguito in un modo automatico o manuale.

# --- 461 ---
cycle-calibrate-probe-length = Calibrazione lunghezza TS
    .nc = CALIBRAZIONE LUNGHEZZA TS
    .purpose = Calibra la lunghezza attiva di un sistema di tastatura 3D digitale su una superficie di altezza nota, ad esempio un anello di calibrazione.
step-prepare-length-calibration = Prima dell’avvio del ciclo impostare l’origine nell’asse del mandrino in modo che sulla tavola della macchina sia Z=0 e posizionare il sistema di tastatura sopra l’anello di calibrazione.
step-orient-to-calibration-angle = Il controllo orienta il sistema di tastatura all’angolo { $mp-probe-calibration-angle } della tabella del sistema di tastatura, se il sistema di tastatura è orientabile.
step-probe-down-from-here = Dalla posizione attuale il controllo esegue una tastatura in direzione negativa dell’asse del mandrino con l’avanzamento di tastatura (colonna { $mp-probing-feed }).
step-return-to-start-of-calibration = Il controllo riporta il sistema di tastatura in rapido (colonna { $mp-positioning-feed }) alla posizione di partenza.
step-store-probe-length = Il controllo memorizza la lunghezza attiva nella tabella utensili.

# --- 462 and 463 ---
cycle-calibrate-in-ring = Calibrazione raggio TS interno
    .nc = CALIBRAZIONE TS SU ANELLO
    .purpose = Calibra il raggio attivo della sfera di tastatura di un sistema di tastatura 3D digitale in un anello di calibrazione e, se il sistema di tastatura lo consente, il suo offset centrale.
cycle-calibrate-on-stud = Calibrazione raggio TS esterno
    .nc = CALIBRAZIONE TS SU ISOLA
    .purpose = Calibra il raggio attivo della sfera di tastatura di un sistema di tastatura 3D digitale su un’isola o su una spina di calibrazione e, se il sistema di tastatura lo consente, il suo offset centrale.
step-pre-position-in-ring = Prima dell’avvio del ciclo preposizionare il sistema di tastatura al centro dell’anello di calibrazione e all’altezza di misura desiderata.
step-pre-position-over-stud = Prima dell’avvio del ciclo preposizionare il sistema di tastatura al centro sopra la spina di calibrazione, nell’asse del tastatore circa alla distanza di sicurezza sopra di essa (valore della colonna { $mp-set-up } + { $q-probing-clearance }).
step-rough-measurement-of-part = Nella prima passata il controllo determina il centro dell’anello di calibrazione (misurazione grossolana) e posiziona il sistema di tastatura al centro.
step-rough-measurement-of-part__calibrate-on-stud = Nella prima passata il controllo determina il centro dell’isola o del perno di calibrazione (misurazione grossolana) e posiziona il sistema di tastatura al centro.
step-fine-measurement-of-part = La calibrazione vera e propria (misurazione fine) determina poi il raggio della sfera di tastatura.
step-travel-between-calibration-points = Tra i punti di misura il sistema di tastatura si sposta:
step-reverse-measurement = Se il sistema di tastatura è orientabile in due direzioni o in qualsiasi direzione, il controllo lo ruota di 180° ed esegue altre quattro tastature. Questa misurazione determina anche l’offset centrale.
step-store-radius-and-offset = Il controllo memorizza il raggio attivo della sfera di tastatura nella colonna { $mp-tool-radius } della tabella utensili e l’offset centrale nelle colonne { $mp-probe-offset-main } e { $mp-probe-offset-minor } della tabella del sistema di tastatura.
note-orientation-decides-calibration = La calibrazione dipende dalla possibilità di orientare il sistema di tastatura. Se non è orientabile, o lo è in una sola direzione, il controllo esegue una misurazione grossolana e una fine e determina il raggio attivo della sfera di tastatura. Se è orientabile in due direzioni (come i sistemi di tastatura HEIDENHAIN con cavo), il controllo esegue una misurazione grossolana e una fine, ruota il sistema di tastatura di 180° ed esegue altre quattro tastature, che determinano oltre al raggio anche l’offset centrale. Se è orientabile in qualsiasi direzione (come i sistemi di tastatura HEIDENHAIN a infrarossi), la calibrazione avviene come con due direzioni.
note-centre-offset-needs-suitable-probe = L’offset centrale può essere determinato solo con un sistema di tastatura adatto.
note-centre-offset-prepared = Per determinare l’offset centrale dello stilo, il controllo deve essere predisposto dal costruttore della macchina. Consultare il manuale della macchina.
guard-too-few-calibration-points = Servono almeno tre tastature: { $q-calibration-ring-probings } è troppo piccolo.
guard-too-few-calibration-points__calibrate-on-sphere = Servono almeno tre tastature: { $q-calibration-sphere-probings } è troppo piccolo.
note-orientation-predefined = Per i sistemi di tastatura HEIDENHAIN è predefinito se e come possono essere orientati. Altri sistemi di tastatura vengono configurati dal costruttore della macchina.

# --- 2 ---
cycle-calibrate-touch-probe = Calibrazione raggio TS
    .nc = CALIBRAZIONE TS
    .purpose = Calibra automaticamente un sistema di tastatura digitale in un anello di calibrazione o su un’isola di calibrazione.
step-rise-to-clearance-height = Il sistema di tastatura si porta in rapido (valore di { $mp-positioning-feed } o { $mp-analog-positioning-feed }) all’altezza di sicurezza, se la posizione attuale si trova al di sotto di essa.
step-position-over-calibration-part = Il controllo posiziona il sistema di tastatura nel piano di lavoro:
say-near-first-touch-point = vicino al primo punto di tastatura (calibrazione esterna)
say-at-centre-of-ring = al centro dell’anello di calibrazione (calibrazione interna)
step-probe-calibration-part = Il sistema di tastatura si porta alla profondità di misura, che risulta dai parametri macchina { $mp-calibration-part-centre }.2 (in altri campi di traslazione { $mp-calibration-part-centre-2 }.2, { $mp-calibration-part-centre-3 }.2) e { $mp-calibration-part-depth }.x, e tasta il pezzo di calibrazione in successione in X+, Y+, X− e Y−.
step-retract-and-store-ball-radius = Il controllo ritrae il sistema di tastatura all’altezza di sicurezza e scrive il raggio attivo della sfera di tastatura nei dati di calibrazione.
note-calibration-part-centre-known = Prima della calibrazione definire il centro del pezzo di calibrazione nell’area di lavoro della macchina nei parametri macchina da { $mp-calibration-part-centre }.0 a { $mp-calibration-part-centre }.2 (coordinate REF).
note-calibration-part-per-traverse-range = Se si utilizzano più campi di traslazione, per ciascuno di essi può essere memorizzato un proprio record di dati per il centro del pezzo di calibrazione: da { $mp-calibration-part-centre-2 }.0 a { $mp-calibration-part-centre-2 }.2 e da { $mp-calibration-part-centre-3 }.0 a { $mp-calibration-part-centre-3 }.2.
note-probe-type-selected = Se si impiegano alternativamente sistemi di tastatura digitali e analogici, assicurarsi che con { $mp-probe-selection } sia selezionato il sistema di tastatura corretto. I due sistemi non devono mai essere collegati contemporaneamente al controllo. Il controllo non è in grado di rilevare quale sistema di tastatura si trovi effettivamente sulla macchina.
