# Cycles that determine and compensate a misaligned workpiece; see the English file.

# --- run, shared ---
step-position-offset-at-first-touch-point = Il controllo posiziona il sistema di tastatura sul primo punto di tastatura, in rapido (valore della colonna { $mp-positioning-feed }) e con logica di posizionamento, arretrandolo della distanza di sicurezza in senso opposto alla direzione di spostamento.
step-position-offset-at-first-touch-point__tnc426-430 = Il controllo posiziona il sistema di tastatura sul primo punto di tastatura, in rapido (valore di { $mp-positioning-feed } o { $mp-analog-positioning-feed }) e con logica di posizionamento, arretrandolo della distanza di sicurezza in senso opposto alla direzione di spostamento.
step-travel-to-and-probe-second-point = Il sistema di tastatura si porta al secondo punto di tastatura ed esegue la seconda tastatura.
step-retract-and-carry-out-basic-rotation = Il controllo riporta il sistema di tastatura all’altezza di sicurezza { $q-clearance-height } ed esegue la rotazione base rilevata.
note-basic-rotation-reset-at-start = All’inizio del ciclo il controllo annulla una rotazione base attiva.
note-known-reference-direction = Con { $q-reference-line-angle } il controllo corregge di un angolo noto il valore misurato. La rotazione base può così essere misurata su una retta qualsiasi del pezzo e riferirsi comunque alla direzione effettiva 0°.

# --- 400 ---
cycle-basic-rotation = Rotazione base su due punti
    .nc = ROTAZIONE BASE
    .purpose = Determina la posizione obliqua di un pezzo misurando due punti che devono trovarsi su una retta. Il controllo la compensa mediante una rotazione base.
step-store-basic-rotation = Il controllo memorizza la rotazione base:
say-rotation-into-preset-row = con { $q-basic-rotation-row } diverso da 0 nella riga { $q-basic-rotation-row } della tabella Preset
say-rotation-into-rot-menu = con { $q-basic-rotation-row }=0 nel menu ROT del modo operativo Funzionamento manuale

# --- 401 and 402 ---
cycle-rotation-two-holes = Rotazione base su due fori
    .nc = ROTAZIONE SU 2 FORI
    .purpose = Misura i centri di due fori e calcola l’angolo tra l’asse principale del piano di lavoro e la retta che congiunge i centri. Il controllo compensa l’angolo mediante una rotazione base o ruotando la tavola rotante.
cycle-rotation-two-holes__tnc426-430 =
    .purpose = Misura i centri di due fori e calcola l’angolo tra l’asse principale del piano di lavoro e la retta che congiunge i centri. Il controllo compensa l’angolo mediante una rotazione base.
cycle-rotation-two-studs = Rotazione base su due isole
    .nc = ROTAZIONE SU 2 ISOLE
    .purpose = Misura i centri di due isole e calcola l’angolo tra l’asse principale del piano di lavoro e la retta che congiunge i centri. Il controllo compensa l’angolo mediante una rotazione base o ruotando la tavola rotante.
cycle-rotation-two-studs__tnc426-430 =
    .purpose = Misura i centri di due isole e calcola l’angolo tra l’asse principale del piano di lavoro e la retta che congiunge i centri. Il controllo compensa l’angolo mediante una rotazione base.
step-position-at-first-hole = Il controllo posiziona il sistema di tastatura sul centro programmato del primo foro, in rapido (valore della colonna { $mp-positioning-feed }) e con logica di posizionamento.
step-position-at-first-hole__tnc426-430 = Il controllo posiziona il sistema di tastatura sul centro programmato del primo foro, in rapido (valore di { $mp-positioning-feed } o { $mp-analog-positioning-feed }) e con logica di posizionamento.
step-measure-first-hole = Il sistema di tastatura si porta all’altezza di misura { $q-measuring-height } e rileva il centro del primo foro con quattro tastature.
step-position-at-second-hole = Il sistema di tastatura ritorna all’altezza di sicurezza { $q-clearance-height } e viene posizionato sul centro programmato del secondo foro.
step-measure-second-hole = Il sistema di tastatura si porta all’altezza di misura { $q-measuring-height } e rileva il centro del secondo foro con quattro tastature.
step-position-at-first-stud = Il controllo posiziona il sistema di tastatura sul primo punto di tastatura della prima isola, in rapido (valore della colonna { $mp-positioning-feed }) e con logica di posizionamento.
step-position-at-first-stud__tnc426-430 = Il controllo posiziona il sistema di tastatura sul primo punto di tastatura della prima isola, in rapido (valore di { $mp-positioning-feed } o { $mp-analog-positioning-feed }) e con logica di posizionamento.
step-measure-first-stud = Il sistema di tastatura si porta all’altezza di misura { $q-measuring-height } e rileva il centro della prima isola con quattro tastature. Tra i punti di tastatura, distanti 90° l’uno dall’altro, si sposta su un arco di cerchio: con { $q-traverse-to-clearance-height }=0 all’altezza di misura, con { $q-traverse-to-clearance-height }=1 all’altezza di sicurezza.
step-measure-first-stud__tnc426-430 = Il sistema di tastatura si porta all’altezza di misura { $q-measuring-height } e rileva il centro della prima isola con quattro tastature. Tra i punti di tastatura si sposta all’altezza di misura con { $q-traverse-to-clearance-height }=0, all’altezza di sicurezza con { $q-traverse-to-clearance-height }=1.
step-position-at-second-stud = Il sistema di tastatura ritorna all’altezza di sicurezza { $q-clearance-height } e viene posizionato sul primo punto di tastatura della seconda isola.
step-measure-second-stud = Il sistema di tastatura si porta all’altezza di misura { $q-second-measuring-height } e rileva il centro della seconda isola con quattro tastature.
step-compensate-as-chosen = Il controllo compensa la posizione obliqua come selezionato con { $q-misalignment-compensation }:
say-rotation-into-preset-row-if-chosen = con { $q-misalignment-compensation }=0 e { $q-basic-rotation-row } diverso da 0 memorizza la rotazione base nella riga { $q-basic-rotation-row } della tabella Preset
say-rotation-into-rot-menu-if-chosen = con { $q-misalignment-compensation }=0 e { $q-basic-rotation-row }=0 memorizza la rotazione base nel menu ROT del modo operativo Funzionamento manuale
say-turn-rotary-table = con { $q-misalignment-compensation }=1 ruota la tavola rotante invece di memorizzare una rotazione base; con { $q-zero-after-alignment }=1 imposta poi a 0 la visualizzazione dell’asse rotativo
note-rotary-axis-by-tool-axis = Per compensare la posizione obliqua ruotando la tavola rotante il controllo utilizza automaticamente i seguenti assi rotativi: C con asse utensile Z, B con asse utensile Y, A con asse utensile X.
note-no-tilting-with-this-cycle = Questo ciclo non è ammesso con piano di lavoro ruotato.
title-rotation-from-two-holes = Determinazione della rotazione base da due fori

# --- 403 ---
cycle-rotation-by-rotary-axis = Compensazione posizione obliqua con asse rotativo
    .nc = ROTAZIONE CON ASSE ROT.
    .purpose = Determina la posizione obliqua di un pezzo misurando due punti che devono trovarsi su una retta. Il controllo la compensa ruotando l’asse A, B o C. Il pezzo può essere serrato in un punto qualsiasi della tavola rotante.
step-retract-and-turn-rotary-axis = Il controllo riporta il sistema di tastatura all’altezza di sicurezza { $q-clearance-height } e ruota l’asse rotativo { $q-compensation-axis } del valore calcolato. Memorizza inoltre l’angolo nel parametro di risultato. A scelta, dopo l’allineamento imposta la visualizzazione a 0.
step-retract-and-turn-rotary-axis__tnc426-430 = Il controllo riporta il sistema di tastatura all’altezza di sicurezza { $q-clearance-height } e ruota l’asse rotativo { $q-compensation-axis } del valore calcolato.
note-compensation-may-be-turned-180 = Pericolo di collisione! Il controllo verifica soltanto in modo approssimativo se i punti di tastatura e l’asse di compensazione sono compatibili. I movimenti di compensazione possono quindi risultare ruotati di 180°.
note-compensation-axis-combinations = Combinazioni ammesse tra asse di misura { $q-measuring-axis } e asse di compensazione { $q-compensation-axis }. Asse del tastatore Z: 1 con 6, 2 con 6, 3 con 5 o 4. Asse del tastatore Y: 1 con 5, 2 con 5, 3 con 6 o 4. Asse del tastatore X: 1 con 4, 2 con 4, 3 con 5 o 6.
note-only-without-tilting = Utilizzare questo ciclo solo se la funzione di rotazione del piano di lavoro non è attiva.

# --- 404 ---
cycle-set-basic-rotation = Impostazione rotazione base
    .nc = IMPOSTA ROTAZIONE BASE
    .purpose = Imposta automaticamente una rotazione base qualsiasi durante l’esecuzione del programma. È previsto soprattutto per annullare una rotazione base eseguita in precedenza.
step-set-basic-rotation = Il controllo imposta la rotazione base all’angolo { $q-basic-rotation-angle }.
note-available-from-nc-software = Disponibile a partire dal software NC 280 474-xx.

# --- 405 ---
cycle-rotation-by-c-axis = Compensazione posizione obliqua con asse C
    .nc = ROTAZIONE CON ASSE C
    .purpose = Determina l’offset angolare tra l’asse Y positivo del sistema di coordinate attivo e l’asse di un foro, oppure tra la posizione nominale e la posizione reale del centro di un foro. Il controllo lo compensa ruotando l’asse C. Il pezzo può essere serrato in un punto qualsiasi della tavola rotante.
say-travel-on-circle-at-clearance-height__rotation-by-c-axis = con { $q-traverse-to-clearance-height }=1 su un arco di cerchio all’altezza di sicurezza { $q-clearance-height }
step-move-to-measured-centre = Il controllo posiziona il sistema di tastatura sul centro rilevato del foro.
step-retract-and-turn-to-y-axis = Il controllo riporta il sistema di tastatura all’altezza di sicurezza { $q-clearance-height } e allinea il pezzo ruotando la tavola rotante: dopo la compensazione, sia con asse del tastatore verticale sia con asse orizzontale, il centro del foro si trova in direzione dell’asse Y positivo ({ $q-probing-centre-minor }=0) o nella sua posizione nominale. L’offset angolare misurato viene memorizzato anche nel parametro di risultato.
step-store-angular-offset = Il controllo elabora l’offset angolare in base a { $q-zero-or-row-after-alignment }:
say-zero-display-of-c-axis = con { $q-zero-or-row-after-alignment }=0 imposta a 0 la visualizzazione dell’asse C
say-offset-into-column-c = con { $q-zero-or-row-after-alignment } maggiore di 0 scrive l’offset angolare, con il suo segno, nella colonna C della riga { $q-zero-or-row-after-alignment } della tabella origini; viene sommato a un offset di C già presente nella riga
note-smallest-stepping-angle__rotation-by-c-axis = Quanto più piccolo è l’angolo incrementale { $q-probing-stepping-angle }, tanto meno preciso è il centro del cerchio calcolato dal controllo. Valore minimo di immissione: 5°.
note-hole-with-positive-y = La coordinata Y del foro deve essere positiva.
note-repeat-with-horizontal-probe = Se l’offset angolare del foro viene misurato con asse del tastatore Y (foro orizzontale), può essere necessario eseguire il ciclo più volte: il tipo di misurazione comporta un’imprecisione di circa l’1% della posizione obliqua.

# --- results ---
result-alignment-angle-determined = Angolo rilevato
result-angular-offset-measured = Offset angolare misurato
