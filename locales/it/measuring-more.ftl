# Cycles that measure angles, studs, rectangles, widths, coordinates, bolt-hole circles and planes; see the English file.

# --- what several of them share ---
say-part-is-scrap = scarto (Q182=1) se un valore misurato è fuori tolleranza e non può essere corretto
say-part-needs-rework = ripresa (Q181=1) se un valore misurato è fuori tolleranza e può essere corretto

# --- 422 ---
cycle-measure-stud = Misurazione cerchio esterno (isola)
    .nc = MISURARE CERCHIO EST.
    .purpose = Misura il centro e il diametro di un’isola circolare. Se nel ciclo sono definite tolleranze, il controllo confronta i valori nominali con quelli reali e memorizza gli scostamenti nei parametri di risultato.
say-part-is-scrap__measure-stud = scarto (Q182=1) se l’isola è più piccola di { $q-stud-least-diameter } o il suo centro si scosta di più di { $q-centre-tolerance-main } o { $q-centre-tolerance-minor }
say-part-needs-rework__measure-stud = ripresa (Q181=1) se l’isola è più grande di { $q-stud-greatest-diameter }
note-smallest-stepping-angle__measure-stud = Quanto più piccolo è l’angolo incrementale { $q-probing-stepping-angle }, tanto meno precise sono le dimensioni dell’isola calcolate dal controllo. Valore minimo di immissione: 5°.

# --- 423, 424 ---
cycle-measure-rectangular-pocket = Misurazione rettangolo interno
    .nc = MISURARE RETTANGOLO INT.
    .purpose = Misura il centro, la lunghezza e la larghezza di una tasca rettangolare. Se nel ciclo sono definite tolleranze, il controllo confronta i valori nominali con quelli reali e memorizza gli scostamenti nei parametri di risultato.
cycle-measure-rectangular-stud = Misurazione rettangolo esterno
    .nc = MISURARE RETTANGOLO EST.
    .purpose = Misura il centro, la lunghezza e la larghezza di un’isola rettangolare. Se nel ciclo sono definite tolleranze, il controllo confronta i valori nominali con quelli reali e memorizza gli scostamenti nei parametri di risultato.
say-part-is-scrap__measure-rectangular-pocket = scarto (Q182=1) se un lato è più lungo di { $q-first-side-greatest-length } o { $q-second-side-greatest-length } o il centro si scosta di più di { $q-centre-tolerance-main } o { $q-centre-tolerance-minor }
say-part-needs-rework__measure-rectangular-pocket = ripresa (Q181=1) se un lato è più corto di { $q-first-side-least-length } o { $q-second-side-least-length }
say-part-is-scrap__measure-rectangular-stud = scarto (Q182=1) se un lato è più corto di { $q-first-side-least-length } o { $q-second-side-least-length } o il centro si scosta di più di { $q-centre-tolerance-main } o { $q-centre-tolerance-minor }
say-part-needs-rework__measure-rectangular-stud = ripresa (Q181=1) se un lato è più lungo di { $q-first-side-greatest-length } o { $q-second-side-greatest-length }
result-side-main-deviation = Scostamento lunghezza lato asse principale
result-side-minor-deviation = Scostamento lunghezza lato asse secondario
title-measure-and-rework-rectangular-stud = Misurazione di un’isola rettangolare e finitura con i valori misurati
title-measure-rectangular-pocket-with-log = Misurazione di una tasca rettangolare con registrazione dei risultati

# --- 425, 426 ---
cycle-measure-slot-width = Misurazione larghezza interna (scanalatura)
    .nc = MISURARE LARGHEZZA INT.
    .purpose = Misura la posizione e la larghezza di una scanalatura (tasca). Se nel ciclo sono definite tolleranze, il controllo confronta i valori nominali con quelli reali e memorizza lo scostamento in un parametro.
cycle-measure-ridge-width = Misurazione larghezza esterna (isola)
    .nc = MISURARE LARGHEZZA EST.
    .purpose = Misura la posizione e la larghezza di un’isola. Se nel ciclo sono definite tolleranze, il controllo confronta i valori nominali con quelli reali e memorizza lo scostamento in un parametro.
step-probe-first-in-positive-direction = Il sistema di tastatura esegue la prima tastatura con l’avanzamento di tastatura (colonna { $mp-probing-feed }), sempre in direzione positiva dell’asse programmato.
step-probe-first-in-positive-direction__tnc426-430 = Il sistema di tastatura esegue la prima tastatura con l’avanzamento di tastatura ({ $mp-probing-feed } o { $mp-analog-probing-feed }), sempre in direzione positiva dell’asse programmato.
step-probe-first-in-negative-direction = Il sistema di tastatura esegue la prima tastatura con l’avanzamento di tastatura (colonna { $mp-probing-feed }), sempre in direzione negativa dell’asse programmato.
step-probe-first-in-negative-direction__tnc426-430 = Il sistema di tastatura esegue la prima tastatura con l’avanzamento di tastatura ({ $mp-probing-feed } o { $mp-analog-probing-feed }), sempre in direzione negativa dell’asse programmato.
step-probe-second-side-of-slot = Il sistema di tastatura esegue la seconda tastatura in base a { $q-second-measurement-offset }:
step-probe-second-side-of-slot__tnc640 = Se la lunghezza nominale è grande, il controllo si porta in rapido al secondo punto di tastatura. Il sistema di tastatura esegue la seconda tastatura in base a { $q-second-measurement-offset }:
say-offset-second-measurement = con { $q-second-measurement-offset } diverso da 0 il controllo sposta il sistema di tastatura di questo offset, parallelamente agli assi, fino al punto di tastatura successivo ed esegue qui la tastatura
say-offset-second-measurement__tnc640 = con { $q-second-measurement-offset } diverso da 0 il controllo sposta il sistema di tastatura di questo offset fino al punto di tastatura successivo, con { $q-traverse-to-clearance-height }=1 all’altezza di sicurezza { $q-clearance-height }, ed esegue qui la tastatura
say-measure-in-opposite-direction = con { $q-second-measurement-offset }=0 misura la larghezza direttamente nella direzione opposta
step-probe-second-side-of-ridge = Il sistema di tastatura si porta, all’altezza di sicurezza { $q-clearance-height }, al punto di tastatura successivo ed esegue qui la seconda tastatura.
say-part-is-scrap__measure-slot-width = scarto (Q182=1) se la scanalatura è più larga di { $q-greatest-dimension }
say-part-needs-rework__measure-slot-width = ripresa (Q181=1) se la scanalatura è più stretta di { $q-least-dimension }
say-part-is-scrap__measure-ridge-width = scarto (Q182=1) se l’isola è più stretta di { $q-least-dimension }
say-part-needs-rework__measure-ridge-width = ripresa (Q181=1) se l’isola è più larga di { $q-greatest-dimension }
note-clearance-acts-in-probe-axis-only = La distanza di sicurezza { $q-probing-clearance } ha effetto solo nella tastatura dell’origine nell’asse del tastatore.
result-measured-length-actual = Valore reale lunghezza misurata
result-measured-length-deviation = Scostamento lunghezza misurata

# --- 427 ---
cycle-measure-coordinate = Misurazione coordinata in un asse selezionabile
    .nc = MISURARE COORDINATA
    .purpose = Misura una coordinata in un asse selezionabile e memorizza il valore in un parametro. Se nel ciclo sono definite tolleranze, il controllo confronta i valori nominali con quelli reali e memorizza gli scostamenti nei parametri di risultato.
step-position-against-traverse-direction = Il controllo posiziona il sistema di tastatura sul punto di tastatura programmato, in rapido (valore della colonna { $mp-positioning-feed }) e con logica di posizionamento, arretrandolo della distanza di sicurezza in senso opposto alla direzione di spostamento { $q-traverse-direction }.
step-position-against-traverse-direction__tnc426-430 = Il controllo posiziona il sistema di tastatura sul punto di tastatura programmato, in rapido (valore di { $mp-positioning-feed } o { $mp-analog-positioning-feed }) e con logica di posizionamento, arretrandolo della distanza di sicurezza in senso opposto alla direzione di spostamento { $q-traverse-direction }.
step-probe-coordinate = Il controllo posiziona il sistema di tastatura nel piano di lavoro sul punto di tastatura programmato e misura qui il valore reale nell’asse selezionato.
step-retract-and-store-measured-coordinate = Il controllo riporta il sistema di tastatura all’altezza di sicurezza { $q-clearance-height } e memorizza la coordinata rilevata nel parametro di risultato.
say-part-is-scrap__measure-coordinate = scarto (Q182=1) se la coordinata misurata è minore di { $q-least-dimension }
say-part-needs-rework__measure-coordinate = ripresa (Q181=1) se la coordinata misurata è maggiore di { $q-greatest-dimension }
say-correct-tool-length = con { $q-monitored-tool } diverso da 0 e { $q-measuring-axis }=3 corregge la lunghezza utensile nella colonna DL della tabella utensili; se lo scostamento è maggiore della tolleranza di rottura RBREAK, visualizza un messaggio d’errore, arresta l’esecuzione del programma e blocca l’utensile (colonna TL = L)
say-correct-tool-radius__measure-coordinate = con { $q-monitored-tool } diverso da 0 e { $q-measuring-axis }=1 o 2 corregge il valore delta del raggio nella colonna DR della tabella utensili, nel senso che risulta da { $q-traverse-direction }; se lo scostamento è maggiore della tolleranza di rottura RBREAK, visualizza un messaggio d’errore, arresta l’esecuzione del programma e blocca l’utensile (colonna TL = L)
note-coordinate-is-outside-dimension = Il controllo presuppone che venga misurata una quota esterna (isola). Per ottenere lo stato corretto in altri casi, scegliere in modo adeguato la quota massima, la quota minima e la direzione di tastatura.
note-coordinate-corrects-radius-or-length = Se l’asse di misura è un asse del piano di lavoro ({ $q-measuring-axis }=1 o 2), il controllo corregge il raggio utensile; il senso della correzione risulta dalla direzione di spostamento { $q-traverse-direction }. Se l’asse di misura è l’asse del tastatore ({ $q-measuring-axis }=3), corregge la lunghezza utensile.

# --- 430 ---
cycle-measure-bolt-hole-circle = Misurazione cerchio di fori
    .nc = MISURARE CERCHIO DI FORI
    .purpose = Misura il centro e il diametro di un cerchio di fori misurando tre dei suoi fori. Se nel ciclo sono definite tolleranze, il controllo confronta i valori nominali con quelli reali e memorizza gli scostamenti nei parametri di risultato.
step-measure-centre-of-hole = Il sistema di tastatura si porta all’altezza di misura { $q-measuring-height } e rileva il centro del foro con quattro tastature.
step-travel-to-next-hole = Il sistema di tastatura ritorna all’altezza di sicurezza { $q-clearance-height } e viene posizionato sul centro inserito del foro successivo.
until-three-holes-measured = non sono stati rilevati i centri di tutti e tre i fori
say-part-is-scrap__measure-bolt-hole-circle = scarto (Q182=1) se il diametro è maggiore di { $q-greatest-dimension } o minore di { $q-least-dimension } o il centro si scosta di più di { $q-centre-tolerance-main } o { $q-centre-tolerance-minor }
say-monitor-tool-breakage = con { $q-monitored-tool } diverso da 0 confronta lo scostamento con la tolleranza di rottura RBREAK; se lo scostamento è maggiore, visualizza un messaggio d’errore, arresta l’esecuzione del programma e blocca l’utensile (colonna TL = L). Non corregge l’utensile
note-only-breakage-monitoring = Questo ciclo esegue solo il controllo rottura dell’utensile; non corregge l’utensile.
result-bolt-circle-diameter-actual = Valore reale diametro cerchio di fori
result-bolt-circle-diameter-deviation = Scostamento diametro cerchio di fori

# --- 420 ---
cycle-measure-angle = Misurazione angolo
    .nc = MISURARE ANGOLO
    .purpose = Misura l’angolo tra una retta e l’asse principale del piano di lavoro.
say-travel-to-point-at-clearance-height = con { $q-traverse-to-clearance-height }=1 all’altezza di sicurezza { $q-clearance-height }
say-travel-to-point-at-measuring-height = con { $q-traverse-to-clearance-height }=0 all’altezza di misura { $q-measuring-height }
step-retract-and-store-angle = Il controllo riporta il sistema di tastatura all’altezza di sicurezza { $q-clearance-height } e memorizza l’angolo rilevato nel parametro di risultato.
note-angle-about-a-or-b = Se l’asse di misura è l’asse del tastatore ({ $q-measuring-axis }=3): per misurare l’angolo intorno all’asse A, inserire lo stesso valore in { $q-first-point-main } e { $q-second-point-main }; per misurare l’angolo intorno all’asse B, inserirvi valori diversi.
note-results-shown-in-help-graphic = Durante la definizione del ciclo la grafica di supporto visualizza anche i parametri di risultato; quello evidenziato appartiene al parametro di immissione selezionato.
note-results-shown-in-help-graphic__tnc426-430 = Durante la definizione del ciclo la grafica di supporto visualizza anche i parametri di risultato.
result-measured-angle = Angolo misurato riferito all’asse principale del piano di lavoro

# --- 431 ---
cycle-measure-plane = Misurazione piano
    .nc = MISURARE PIANO
    .purpose = Misura gli angoli di un piano misurando tre punti e memorizza i valori in parametri.
step-measure-first-point-of-plane = Il controllo posiziona il sistema di tastatura sul primo punto di tastatura programmato, in rapido (valore della colonna { $mp-positioning-feed }) e con logica di posizionamento, arretrandolo della distanza di sicurezza in senso opposto alla direzione di tastatura, e misura qui il primo punto del piano.
step-measure-first-point-of-plane__tnc426-430 = Il controllo posiziona il sistema di tastatura sul primo punto di tastatura programmato, in rapido (valore di { $mp-positioning-feed } o { $mp-analog-positioning-feed }) e con logica di posizionamento, arretrandolo della distanza di sicurezza in senso opposto alla direzione di tastatura, e misura qui il primo punto del piano.
step-measure-second-point-of-plane = Il sistema di tastatura ritorna all’altezza di sicurezza { $q-clearance-height } e si porta nel piano di lavoro al secondo punto di tastatura, dove il controllo misura il valore reale del secondo punto del piano.
step-measure-third-point-of-plane = Il sistema di tastatura ritorna all’altezza di sicurezza { $q-clearance-height } e si porta nel piano di lavoro al terzo punto di tastatura, dove il controllo misura il valore reale del terzo punto del piano.
step-retract-and-store-plane-angles = Il controllo riporta il sistema di tastatura all’altezza di sicurezza { $q-clearance-height } e memorizza gli angoli nei parametri di risultato.
guard-points-on-one-line = I tre punti di misura si trovano su una retta. Il controllo non può calcolare gli angoli del piano.
note-positioning-logic__measure-plane = Logica di posizionamento: se il polo sud dello stilo si trova al di sotto dell’altezza di sicurezza { $q-clearance-height }, il controllo ritrae dapprima il sistema di tastatura nell’asse del tastatore all’altezza di sicurezza e lo posiziona poi nel piano di lavoro sul primo punto di tastatura. Se si trova al di sopra dell’altezza di sicurezza, il controllo posiziona dapprima il sistema di tastatura nel piano di lavoro sul primo punto di tastatura e lo porta poi nell’asse del tastatore direttamente all’altezza di misura.
note-three-points-not-on-a-line = I tre punti di misura non devono trovarsi su una retta: solo così il controllo può calcolare gli angoli.
note-spatial-angles-for-tilting = I parametri da Q170 a Q172 contengono gli angoli solidi necessari per la funzione di rotazione del piano di lavoro. I primi due punti di misura determinano la direzione dell’asse principale nella rotazione del piano di lavoro.
note-third-point-sets-tool-axis = Il terzo punto di misura determina la direzione dell’asse utensile. Definirlo in direzione dell’asse Y positivo, in modo che l’asse utensile sia disposto correttamente nel sistema di coordinate destrorso.
note-spatial-angle-in-tilted-plane = Se il ciclo viene eseguito con piano di lavoro ruotato attivo, gli angoli solidi misurati si riferiscono al sistema di coordinate ruotato. Utilizzarli nella funzione di rotazione del piano di lavoro come valori incrementali.
result-projection-angle-a = Angolo di proiezione dell’asse A
result-projection-angle-a__tnc426-430 = Angolo dell’asse A
result-projection-angle-b = Angolo di proiezione dell’asse B
result-projection-angle-b__tnc426-430 = Angolo dell’asse B
result-spatial-angle-a = Angolo solido A
result-spatial-angle-b = Angolo solido B
result-spatial-angle-c = Angolo solido C
result-first-value-in-probe-axis = Valore misurato nell’asse del tastatore (prima misurazione)
result-first-value-in-probe-axis__tnc320 = Valore misurato nell’asse del tastatore
result-second-value-in-probe-axis = Valore misurato nell’asse del tastatore (seconda misurazione)
result-third-value-in-probe-axis = Valore misurato nell’asse del tastatore (terza misurazione)

# --- 1 ---
cycle-polar-reference-plane = Origine polare
    .nc = ORIGINE POLARE
    .purpose = Misura una posizione qualsiasi del pezzo in una direzione di tastatura qualsiasi, indicata da un angolo.
step-probe-at-polar-angle = Il sistema di tastatura esegue la tastatura con l’avanzamento di tastatura (colonna { $mp-probing-feed }). Durante la tastatura il sistema di tastatura si sposta contemporaneamente in due assi, in funzione dell’angolo di tastatura. La direzione di tastatura viene definita nel ciclo da un angolo polare.
step-probe-at-polar-angle__tnc426-430 = Il sistema di tastatura esegue la tastatura con l’avanzamento di tastatura ({ $mp-probing-feed } o { $mp-analog-probing-feed }). Durante la tastatura il sistema di tastatura si sposta contemporaneamente in due assi, in funzione dell’angolo di tastatura. La direzione di tastatura viene definita nel ciclo da un angolo polare.
step-return-and-store-trigger-position = Dopo il rilevamento della posizione il sistema di tastatura ritorna al punto di partenza della tastatura. Il controllo memorizza nei parametri da Q115 a Q119 le coordinate della posizione in cui il sistema di tastatura si trovava al momento del segnale di commutazione.
step-return-and-store-trigger-position__tnc426-430 = Dopo il rilevamento della posizione il sistema di tastatura ritorna al punto di partenza della tastatura. Il controllo memorizza nei parametri da Q115 a Q119 le coordinate del centro della sfera al momento del contatto con il pezzo.
note-probing-plane-by-axis = L’asse di tastatura definito nel ciclo determina il piano di tastatura: asse di tastatura X: piano X/Y; Y: piano Y/Z; Z: piano Z/X.
note-trigger-position-of-ball-centre = I parametri da Q115 a Q119 contengono le coordinate del centro della sfera di tastatura al momento del contatto con il pezzo.

# --- 3 ---
cycle-measuring = Misurazione
    .nc = MISURARE
    .purpose = Misura una posizione qualsiasi del pezzo in una direzione di tastatura selezionabile. A differenza degli altri cicli di misura, il percorso di misura e l’avanzamento di misura vengono inseriti direttamente in questo ciclo; si inserisce anche la ritrazione dopo la misurazione. Serve per realizzare cicli del costruttore della macchina.
cycle-measuring__tnc426-430 =
    .purpose = Misura una posizione qualsiasi del pezzo in una direzione di tastatura selezionabile. A differenza degli altri cicli di misura, l’avanzamento di misura viene inserito direttamente in questo ciclo. È un ciclo di misura per impieghi speciali.
step-move-in-polar-direction = Il sistema di tastatura si sposta dalla posizione attuale con l’avanzamento inserito nella direzione di tastatura programmata. La direzione di tastatura viene definita nel ciclo da un angolo polare.
step-stop-and-store-ball-centre = Dopo che il controllo ha rilevato la posizione, il sistema di tastatura si ferma. Il controllo memorizza le coordinate X, Y e Z del centro della sfera in tre parametri Q consecutivi, senza correggere lunghezza e raggio. Il numero del primo parametro di risultato viene definito nel ciclo.
step-stop-and-store-ball-centre__tnc426-430 = Dopo che il controllo ha rilevato la posizione, il sistema di tastatura si ferma. Il controllo memorizza le coordinate del centro della sfera in tre parametri Q consecutivi. Il numero del primo parametro viene definito nel ciclo.
result-ball-centre-and-status = Centro della sfera in X; i due parametri successivi contengono Y e Z, il quarto −1 se non c’è stato un punto di tastatura valido
result-ball-centre-and-status__tnc426-430 = Prima coordinata del centro della sfera; i due parametri successivi contengono le altre
note-probe-data-without-effect = I dati del sistema di tastatura { $mp-probing-distance } (percorso massimo fino al punto di tastatura) e { $mp-probing-feed } (avanzamento di tastatura), attivi negli altri cicli di misura, non hanno effetto in questo ciclo.
note-four-parameters-overwritten = Il controllo scrive sempre quattro parametri Q consecutivi.
note-no-touch-point-no-error = Se il controllo non rileva un punto di tastatura valido, il programma prosegue senza messaggio d’errore. Il controllo assegna allora −1 al quarto parametro di risultato, in modo che il programma possa reagire all’errore.
note-retraction-not-beyond-start = Il controllo ritrae il sistema di tastatura al massimo del percorso di ritrazione MB, ma non oltre il punto di partenza della misurazione. Durante la ritrazione non possono quindi verificarsi collisioni.
note-probe-input-by-function = La funzione FN17: SYSWRITE ID 990 NR 6 determina se il ciclo agisce sull’ingresso del tastatore X12 o X13.
note-available-from-software-474 = Questo ciclo è disponibile a partire dal software NC 280 474-xx.
note-behaviour-defined-by-builder = Il costruttore della macchina o il fornitore del software definisce il funzionamento dettagliato di questo ciclo; viene impiegato all’interno di cicli di tastatura speciali.
