# Mirroring, scaling and tilting; see the English file.

# --- 8 ---
cycle-mirroring = Lavorazione speculare
    .nc = SPECULARITÀ
    .purpose = Consente di lavorare profili specularmente nel piano di lavoro.
step-mirror-coordinate-system = Dalla definizione il controllo rende speculari gli assi inseriti del sistema di coordinate rispetto all’origine attiva.
note-reset-mirroring = Per annullare la lavorazione speculare riprogrammare il ciclo e rispondere con NO ENT.
note-mirroring-in-status-display = L’indicazione di stato supplementare visualizza gli assi speculari attivi.
note-mirroring-and-machining-direction = Se viene reso speculare un solo asse, il senso di lavorazione dell’utensile cambia; ciò non vale per i cicli SL. Se vengono resi speculari due assi, il senso di lavorazione rimane invariato.
note-mirroring-depends-on-datum = Il risultato della lavorazione speculare dipende dalla posizione dell’origine. Se l’origine si trova sul profilo da rendere speculare, l’elemento viene reso speculare direttamente rispetto all’origine. Se si trova all’esterno del profilo, l’elemento viene inoltre spostato.
note-mirroring-and-milling-cycles = Se viene reso speculare un solo asse, il senso di lavorazione cambia nei cicli di fresatura con numeri 2xx. Eccezione: il ciclo 208, nel quale il senso di rotazione definito nel ciclo viene mantenuto.
note-mirroring-and-thread-direction = Il senso di un filetto cambia se un ciclo di fresatura di filetti viene combinato con la lavorazione speculare in un solo asse.

# --- 11 ---
cycle-scaling = Fattore di scala
    .nc = FATTORE DI SCALA
    .purpose = Ingrandisce o riduce profili all’interno di un programma, ad esempio per tenere conto di fattori di ritiro e sovrametalli.
step-scale-coordinate-system = Dalla definizione il controllo moltiplica coordinate e raggi per il fattore.
note-reset-scaling = Per annullare il fattore di scala riprogrammare il ciclo con il fattore 1.
note-scaling-in-status-display = L’indicazione di stato supplementare visualizza il fattore di scala attivo.
note-scaling-acts-on = Il fattore ha effetto contemporaneamente su tutti e tre gli assi di coordinate e sulle quote inserite nei cicli.
note-shift-datum-before-scaling = Prima dell’ingrandimento o della riduzione, l’origine dovrebbe essere spostata su un bordo o uno spigolo del profilo.
note-scaling-limits = Ingrandimento: fattore maggiore di 1 fino a 99,999999. Riduzione: fattore minore di 1 fino a 0,000001.

# --- 26 ---
cycle-axis-scaling = Fattore di scala specifico per asse
    .nc = FATTORE DI SCALA ASSE
    .purpose = Tiene conto di fattori di ritiro e sovrametalli con un fattore proprio in ogni asse.
step-scale-each-axis = Dalla definizione il controllo allunga o comprime il profilo in ogni asse inserito in base al relativo fattore, dal centro verso l’esterno oppure verso il centro.
note-reset-axis-scaling = Per annullare i fattori riprogrammare il ciclo con il fattore 1 per il relativo asse.
note-arcs-need-equal-factors = Due assi nei quali sono programmati archi di cerchio non devono essere allungati o compressi con fattori diversi.
note-factor-for-each-axis = Per ogni asse di coordinate è possibile inserire un proprio fattore di scala specifico per asse.
note-centre-for-all-factors = È inoltre possibile programmare le coordinate di un centro per tutti i fattori di scala.
note-scaled-from-centre = Il profilo viene allungato a partire dal centro o compresso verso il centro, quindi non necessariamente da e verso l’origine attuale come nel ciclo 11.

# --- 19 ---
cycle-working-plane = Rotazione piano di lavoro
    .nc = PIANO DI LAVORO
    .purpose = Definisce la posizione del piano di lavoro, ossia la posizione dell’asse utensile rispetto al sistema di coordinate della macchina, mediante l’inserimento di angoli di rotazione, per macchine con teste orientabili o tavole orientabili.
step-tilt-working-plane = Dalla definizione il controllo ruota il piano di lavoro intorno all’origine attiva.
step-compute-rotary-positions = Se la posizione è programmata con angoli solidi, il controllo calcola le posizioni angolari necessarie degli assi orientabili e le memorizza nei parametri da Q120 (asse A) a Q122 (asse C). Se esistono due soluzioni, sceglie il percorso più breve dalla posizione zero degli assi rotativi.
step-position-rotary-axes = Se il costruttore della macchina lo ha previsto, il controllo posiziona automaticamente gli assi rotativi. In caso contrario posizionarli in un blocco L separato dopo la definizione.
step-move-all-axes-after-tilting = Spostare tutti gli assi in modo che la correzione abbia effetto in tutti: in un asse ha effetto non appena questo si sposta nel sistema ruotato.
result-tilted-position-of-a = Posizione calcolata dell’asse A
result-tilted-position-of-b = Posizione calcolata dell’asse B
result-tilted-position-of-c = Posizione calcolata dell’asse C
note-tilting-is-adapted-by-builder = Le funzioni di rotazione del piano di lavoro vengono adattate al controllo e alla macchina dal costruttore della macchina. Con determinate teste orientabili (tavole orientabili) è il costruttore a definire se gli angoli programmati nel ciclo vengono interpretati come coordinate degli assi rotativi o come componenti angolari di un piano inclinato. Consultare il manuale della macchina.
note-builder-decides-on-rotary-positioning = Il costruttore della macchina definisce se il ciclo posiziona automaticamente gli assi rotativi o se questi devono essere posizionati nel programma. Consultare il manuale della macchina.
note-two-ways-to-tilt = La posizione del piano di lavoro può essere definita in due modi: inserendo direttamente le posizioni degli assi orientabili oppure mediante un massimo di tre rotazioni (angoli solidi) del sistema di coordinate della macchina. Per determinare gli angoli solidi immaginare una sezione perpendicolare attraverso il piano di lavoro ruotato e osservarla lungo l’asse di rotazione. Già due angoli solidi definiscono qualsiasi posizione dell’utensile nello spazio.
note-tilted-movements-depend-on-description = La posizione del sistema di coordinate ruotato, e quindi anche gli spostamenti nel sistema ruotato, dipendono dal modo in cui è descritto il piano ruotato.
note-tilting-sequence = La sequenza delle rotazioni con cui il controllo calcola il piano è fissa: prima l’asse A, poi l’asse B e infine l’asse C.
note-tilting-overrides-manual-menu = Se la rotazione per l’esecuzione del programma è stata impostata su attiva nel modo operativo Funzionamento manuale, il ciclo sovrascrive l’angolo inserito in quel menu.
note-define-all-spatial-angles = I valori di assi rotativi non programmati vengono sempre interpretati come invariati. Definire quindi sempre tutti e tre gli angoli solidi, anche se uno o più di essi sono 0.
note-tilting-cancels-look-ahead = Se il ciclo viene utilizzato con M120 attiva, il controllo annulla la correzione del raggio e con essa M120.
note-reset-tilt-angles = Per annullare gli angoli di rotazione ridefinire il ciclo con 0° per tutti gli assi rotativi. Poi definirlo ancora una volta e rispondere alla domanda di dialogo con NO ENT: in questo modo la funzione viene disattivata.
note-position-rotary-axes-by-hand = Se il ciclo non posiziona automaticamente gli assi rotativi: con angoli asse inserire direttamente i valori degli assi nel blocco L; con angoli solidi utilizzare i parametri Q120 (asse A), Q121 (asse B) e Q122 (asse C) scritti dal ciclo.
note-use-computed-rotary-positions = Nel posizionamento da programma utilizzare sempre le posizioni degli assi rotativi memorizzate nei parametri da Q120 a Q122.
note-avoid-reduced-angles = Evitare funzioni come M94 (visualizzazione ridotta degli angoli), affinché dopo più chiamate non vi siano differenze tra posizioni reali e nominali degli assi rotativi.
note-automatic-rotary-positioning = Se il ciclo posiziona automaticamente gli assi rotativi: si possono posizionare solo assi controllati; oltre agli angoli di rotazione, nella definizione del ciclo devono essere inseriti una distanza di sicurezza e un avanzamento per il posizionamento; si possono utilizzare solo utensili preimpostati (la lunghezza utensile completa deve essere definita); durante la rotazione la posizione della punta dell’utensile rispetto al pezzo rimane quasi invariata; il controllo esegue la rotazione con l’ultimo avanzamento programmato e l’avanzamento massimo raggiungibile dipende dalla complessità della testa orientabile (tavola orientabile).
note-positions-in-tilted-system = Dopo l’attivazione del ciclo le posizioni visualizzate (nominale e reale) e l’origine nell’indicazione di stato supplementare si riferiscono al sistema di coordinate ruotato. Subito dopo la definizione la posizione visualizzata può quindi differire dalle ultime coordinate programmate prima del ciclo.
note-limit-switches-in-tilted-system = Nel sistema di coordinate ruotato il controllo verifica i finecorsa solo degli assi che si spostano. Può emettere un messaggio d’errore.
note-positioning-in-tilted-system = Con M130 è possibile raggiungere anche nel sistema ruotato posizioni riferite al sistema di coordinate non ruotato. Anche nel piano di lavoro ruotato è possibile il posizionamento con blocchi di rette riferiti al sistema di coordinate della macchina (blocchi con M91 o M92), con limitazioni: non avviene alcuna correzione della lunghezza, non avviene alcuna correzione della geometria della macchina e la correzione del raggio non è ammessa.
note-tilting-with-other-transforms = Uno spostamento origine prima del ciclo sposta il sistema di coordinate della macchina; uno spostamento origine dopo il ciclo sposta il sistema di coordinate ruotato.
note-reset-in-reverse-order = Importante: annullare i cicli in sequenza inversa rispetto alla loro definizione. Attivare lo spostamento origine, poi la rotazione del piano di lavoro, poi la rotazione; lavorare il pezzo; poi annullare la rotazione, la rotazione del piano di lavoro e lo spostamento origine.
note-datum-setting-with-tilting = L’origine può essere impostata manualmente a sfioramento, in modo controllato con un sistema di tastatura 3D HEIDENHAIN oppure automaticamente con un sistema di tastatura 3D HEIDENHAIN.
title-rotary-axes-by-hand = Assi rotativi posizionati nel programma
title-rotary-axes-by-control = Assi rotativi posizionati dal controllo
