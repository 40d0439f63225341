# Cycles that digitize a part with a touch probe; see the English file.

# --- 5 and 15 ---
cycle-digitize-range = Campo di digitalizzazione
    .nc = CAMPO
    .purpose = Definisce il campo a forma di parallelepipedo nel quale i cicli di digitalizzazione rilevano un pezzo, il file per i dati digitalizzati e l’altezza di sicurezza.
cycle-digitize-range-from-points = Campo di digitalizzazione da tabella punti
    .nc = CAMPO
    .purpose = Definisce un campo di forma qualsiasi per la digitalizzazione con un sistema di tastatura analogico: una tabella punti ne indica il contorno nel piano di lavoro. Il ciclo definisce anche il file per i dati digitalizzati e l’altezza di sicurezza.
step-remember-digitizing-range = Il controllo memorizza il campo tra il punto MIN e il punto MAX, l’altezza di sicurezza e il nome del file per i cicli di digitalizzazione successivi.
step-remember-digitizing-range-from-points = Il controllo memorizza il campo, delimitato nel piano di lavoro dai punti della tabella e nell’asse del tastatore dai punti MIN e MAX, l’altezza di sicurezza e il nome del file per i cicli di digitalizzazione successivi.
table-digitizing-points = Tabella punti per la digitalizzazione
title-range-with-rotary-axis-a = Campo con asse rotativo A, per il ciclo 18
title-range-for-meander-with-rotary-axis = Campo con asse rotativo A, per il ciclo 6
title-range-with-rotary-axis-c = Campo con asse rotativo C, per il ciclo 7

# --- 6 and 16 ---
cycle-digitize-meander = Meandro
    .nc = MEANDRO
    .purpose = Digitalizza un pezzo 3D a meandri con un sistema di tastatura digitale.
cycle-digitize-meander-analog = Meandro (sistema di tastatura analogico)
    .nc = MEANDRO
    .purpose = Digitalizza un pezzo 3D a meandri con un sistema di tastatura analogico.
step-approach-digitizing-start = Il controllo porta automaticamente il sistema di tastatura al punto di partenza, dapprima nell’asse utensile all’altezza di sicurezza, poi nel piano di lavoro sul punto MIN del campo del ciclo 5 o del ciclo 15.
step-approach-workpiece-downwards = Il sistema di tastatura si avvicina al pezzo in direzione negativa dell’asse utensile. Il controllo memorizza le coordinate della posizione in cui il sistema di tastatura tocca il pezzo.
step-scan-meander = Dal punto MIN il sistema di tastatura si sposta lungo il pezzo in direzione positiva dell’asse di riga fino al limite del campo, si sposta della distanza tra le righe e ritorna lungo la riga successiva; all’altra estremità si sposta di nuovo della distanza tra le righe. L’operazione si ripete finché l’intero campo è digitalizzato.
step-return-to-clearance-after-digitizing = Al termine il sistema di tastatura ritorna all’altezza di sicurezza.
title-meander-with-rotary-axis = Meandro con un asse rotativo come direzione di riga

# --- 7 and 17 ---
cycle-digitize-contour-lines = Linee di livello
    .nc = LINEE DI LIVELLO
    .purpose = Digitalizza un pezzo 3D lungo linee di livello, un livello dopo l’altro, con un sistema di tastatura digitale.
cycle-digitize-contour-lines-analog = Linee di livello (sistema di tastatura analogico)
    .nc = LINEE DI LIVELLO
    .purpose = Digitalizza un pezzo 3D lungo linee di livello, un livello dopo l’altro, con un sistema di tastatura analogico.
step-approach-contour-line-start = Il controllo porta automaticamente il sistema di tastatura al punto di partenza, dapprima nell’asse utensile all’altezza di sicurezza, poi nel piano di lavoro sulle coordinate definite nel ciclo. La coordinata del punto di partenza nell’asse utensile è quella del punto MIN del ciclo 5 se la distanza tra le righe è positiva, quella del punto MAX se è negativa.
step-approach-workpiece-in-direction = Il sistema di tastatura si avvicina al pezzo nella direzione di avvicinamento programmata. Il controllo memorizza le coordinate della posizione in cui il sistema di tastatura tocca il pezzo.
step-scan-contour-line = Dopo la memorizzazione del primo punto, il sistema di tastatura percorre il contorno del pezzo ad altezza costante fino a raggiungere di nuovo il primo punto.
step-go-on-by-line-spacing = Poi si sposta della distanza tra le righe in direzione positiva o negativa dell’asse utensile e percorre di nuovo il contorno del pezzo ad altezza costante, fino al primo punto memorizzato a questa altezza. L’operazione si ripete finché l’intero campo è digitalizzato.
step-return-to-contour-line-start = Al termine il sistema di tastatura si porta all’altezza di sicurezza e ritorna al punto di partenza programmato.

# --- 8 and 18 ---
cycle-digitize-lines = Riga
    .nc = RIGA
    .purpose = Digitalizza un pezzo 3D riga per riga con un sistema di tastatura digitale.
cycle-digitize-lines-analog = Riga (sistema di tastatura analogico)
    .nc = RIGA
    .purpose = Digitalizza un pezzo 3D riga per riga con un sistema di tastatura analogico.
step-approach-line-start = Il controllo porta automaticamente il sistema di tastatura al punto di partenza, dapprima nell’asse utensile all’altezza di sicurezza, poi nel piano di lavoro. Il punto di partenza si trova sul limite positivo o negativo del campo nella direzione di riga programmata (in funzione della direzione di digitalizzazione) e per il resto ha le coordinate del punto MIN del campo del ciclo 5 o del ciclo 15.
step-scan-line = Il sistema di tastatura si sposta lungo il pezzo in direzione positiva dell’asse selezionato del piano di lavoro fino al limite del campo.
step-return-for-next-line = Poi si porta all’altezza di sicurezza e ritorna in rapido all’inizio della riga successiva. Qui si sposta in rapido in direzione negativa dell’asse utensile fino all’altezza per la riduzione dell’avanzamento e da questa prosegue con l’avanzamento di tastatura fino a toccare il pezzo. L’operazione si ripete finché l’intero campo è digitalizzato.
title-lines-with-rotary-axis = Riga con asse rotativo, senza avanzamento per la prima riga

# --- guards ---
guard-digitizing-with-transformation = È attiva una conversione di coordinate. Durante la digitalizzazione non deve esserne attiva alcuna.

# --- notes: programming ---
note-range-before-digitizing = Nel programma di lavorazione definire un ciclo di digitalizzazione CAMPO (5 o 15) prima del ciclo che digitalizza.
note-range-before-contour-lines = Nel programma di lavorazione definire il ciclo di digitalizzazione 5 CAMPO prima del ciclo di digitalizzazione LINEE DI LIVELLO.
note-not-with-contour-lines = Il ciclo { $cycle } non può essere combinato con il ciclo di digitalizzazione 17 LINEE DI LIVELLO.
note-not-with-range-from-points = Il ciclo { $cycle } non può essere combinato con il ciclo di digitalizzazione 15 CAMPO.
note-no-transformation-while-digitizing = Durante la digitalizzazione non devono essere attive conversioni di coordinate né una rotazione base.
note-analog-probe-only = Solo per sistemi di tastatura analogici.
note-complete-path-of-data = Nel menu dell’interfaccia dati inserire il percorso completo con il quale il controllo memorizza i dati digitalizzati.
note-digitizing-not-in-iso = I cicli di digitalizzazione non sono disponibili in DIN/ISO.

# --- notes: what is needed ---
note-digitizing-needs-option = Per la digitalizzazione occorrono un sistema di tastatura, il modulo software Opzione digitalizzazione e, se necessario, il software di elaborazione SUSA di HEIDENHAIN per i dati digitalizzati con il ciclo MEANDRO.
note-calibrate-before-digitizing = Calibrare il sistema di tastatura prima della digitalizzazione.
note-digitizing-axes = I cicli di digitalizzazione si programmano con gli assi principali X, Y e Z e con gli assi rotativi A, B e C.
note-digitizing-speed-touch-trigger = Con un sistema di tastatura digitale la velocità di digitalizzazione è compresa tra 200 e 800 mm/min, con una distanza tra i punti di 1 mm.
note-digitizing-speed-analog = Con un sistema di tastatura analogico la velocità di digitalizzazione viene definita nel ciclo, fino a 3000 mm/min.

# --- notes: how it is digitized ---
note-meander-for-flat-parts = La digitalizzazione a meandri è adatta soprattutto per pezzi relativamente piani.
note-meander-for-evaluation-software = Digitalizzare a meandri se i dati digitalizzati devono essere elaborati con il software di elaborazione SUSA di HEIDENHAIN.
note-contour-lines-for-steep-parts = La digitalizzazione per linee di livello è particolarmente adatta per pezzi irregolari (ad esempio stampi a iniezione) o se deve essere rilevata una sola linea di livello (ad esempio il contorno di una camma a disco).
note-range-for-contour-lines = Nell’asse del tastatore il campo deve essere più basso del punto più alto del pezzo almeno del raggio del sistema di tastatura. Nel piano di lavoro il campo deve essere più grande del pezzo almeno del raggio del sistema di tastatura.
note-single-contour-line = Per digitalizzare una sola linea di livello, inserire 0 per la distanza tra le righe e, se richiesta dal ciclo, per la distanza minima tra le righe.
note-lines-for-one-milling-direction = Questo ciclo si impiega soprattutto per pezzi relativamente piani i cui dati digitalizzati devono essere fresati interamente in concorde o in discorde, senza software di elaborazione.
note-lines-for-rotary-axes = Con un sistema di tastatura analogico questo ciclo si impiega soprattutto per la digitalizzazione con un asse rotativo.
note-normal-retraction-recommended = Corsa consigliata in direzione delle normali alla riga: tra metà della distanza tra i punti e la distanza tra i punti. Quanto più piccola è la sfera di tastatura, tanto maggiore dovrebbe essere la corsa.
note-climb-or-up-cut-by-direction = La direzione di digitalizzazione determina anche se la fresatura successiva sarà concorde o discorde.
note-sudden-changes-of-direction = Il controllo memorizza le posizioni in cui la direzione cambia bruscamente, fino a 1000 per riga. Nella riga successiva riduce automaticamente l’avanzamento di tastatura quando il sistema di tastatura si avvicina a una di queste posizioni. In questo modo si ottengono risultati migliori.
note-feed-reduction-only-up-to-1000 = La riduzione dell’avanzamento funziona solo se una riga non contiene più di 1000 punti in cui l’avanzamento deve essere ridotto.
note-corner-reduction-entered-by-control = Rispondere con NO ENT alla domanda sulla riduzione dell’avanzamento sugli spigoli. Il controllo inserisce automaticamente un valore.

# --- notes: rotary axes ---
note-rotary-axes-touch-trigger = Con un sistema di tastatura digitale gli assi rotativi possono essere digitalizzati a meandri (ciclo 6), per righe (ciclo 8) o per linee di livello (ciclo 7). In ogni caso inserire l’asse rotativo nel ciclo CAMPO. Il controllo interpreta i valori degli assi rotativi come gradi.
note-rotary-axes-analog = Con un sistema di tastatura analogico gli assi rotativi possono essere digitalizzati solo con il ciclo 18 RIGA. L’asse rotativo viene definito come asse di colonna.
note-digitizing-range-with-rotary-axis = Per la digitalizzazione con un asse rotativo inserire l’asse rotativo nel campo. Il controllo ne interpreta i valori come gradi. Il file dei dati digitalizzati contiene gli assi definiti nel campo; non viene emesso alcun BLK FORM, poiché gli assi rotativi non possono essere rappresentati graficamente.
note-digitizing-display-of-rotary-axis = Durante la digitalizzazione e durante la fresatura il modo di visualizzazione dell’asse rotativo deve essere lo stesso (ridotto a un valore inferiore a 360° oppure non ridotto).
note-meander-with-rotary-axis = Se la direzione di riga è un asse lineare (ad esempio X), alla fine di una riga lo spostamento pari alla distanza tra le righe avviene nell’asse rotativo (ad esempio A) del ciclo CAMPO; il sistema di tastatura oscilla allora ad esempio nel piano Z/X. Se la direzione di riga è un asse rotativo (ad esempio A), alla fine di una riga lo spostamento pari alla distanza tra le righe avviene nell’asse lineare (ad esempio X); il sistema di tastatura oscilla allora ad esempio nel piano Z/A.
note-contour-lines-with-rotary-axis = Il punto di partenza viene definito in un asse lineare (ad esempio X) e in un asse rotativo (ad esempio C); lo stesso vale per la sequenza di avvicinamento. Il sistema di tastatura oscilla allora ad esempio nel piano X/C. Il procedimento è adatto anche per macchine con due soli assi lineari (ad esempio Z e X) e un asse rotativo (ad esempio C). Il senso di rotazione definito nella sequenza di avvicinamento vale per tutte le linee di livello.
note-lines-with-rotary-axis = Se la direzione di riga è un asse lineare (ad esempio X), alla fine di una riga lo spostamento pari alla distanza tra le righe avviene nell’asse rotativo (ad esempio A) del ciclo CAMPO.

# --- notes: the data ---
note-digitized-data-on-disk = Il controllo memorizza le posizioni rilevate direttamente sul disco fisso. La funzione di interfaccia PRINT determina la directory.
note-digitized-data-with-same-radius = Se i dati digitalizzati vengono fresati con un utensile di raggio uguale a quello dello stilo, possono essere eseguiti direttamente con il ciclo 30.
note-block-form-in-data = Il controllo inserisce un BLK FORM nel file dei dati digitalizzati. A tale scopo ingrandisce il parallelepipedo definito nel ciclo CAMPO del doppio del valore di { $mp-stylus-deflection-depth } (per sistemi di tastatura analogici).
note-digitized-data-in-programs = I dati digitalizzati possono essere eseguiti con il ciclo di lavorazione 30 se sono necessarie più passate (solo dati dei cicli MEANDRO e RIGA), oppure con un programma ausiliario se si tratta della sola finitura: definire un utensile con il raggio dello stilo, chiamarlo, impostare avanzamento, funzioni M e correzione del raggio R0 e chiamare il file con CALL PGM.
note-digitized-data-size = Il file dei dati digitalizzati può avere al massimo 1500 MByte, lo spazio disponibile sul disco fisso del controllo se non è memorizzato alcun programma.

# --- notes: point tables ---
note-point-table-recording = I punti vengono rilevati nel modo operativo Introduzione manuale dati con il sistema di tastatura analogico, per il quale occorre l’opzione software per la digitalizzazione con sistema di tastatura analogico. Il softkey PNT seleziona una tabella punti. I punti vengono rilevati manualmente (TEACH-IN: deflettere lo stilo a mano e acquisire la posizione reale) oppure automaticamente (a una distanza tra i punti inserita, mentre lo stilo viene guidato a mano intorno al pezzo). È possibile inserire un avanzamento con cui il sistema di tastatura reagisce a una deflessione e scegliere per ogni asse le coordinate da memorizzare. Solo le coordinate del piano di lavoro definiscono il campo.
note-point-table-size = Una tabella punti che serve da campo può contenere al massimo 893 punti. Per attivare la relativa sorveglianza impostare il softkey CAMPO/DATI PROFILO su CAMPO.
note-point-table-closed = I punti vengono collegati da rette che delimitano il campo. Il controllo collega automaticamente l’ultimo punto della tabella con il primo.
