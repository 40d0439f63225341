# Drilling cycles; see the English file.

# --- shared sentences ---
step-retract-at-retraction-feed = L’utensile si ritrae con l’avanzamento { $q-retraction-feed } alla distanza di sicurezza { $q-set-up-clearance }.

# --- 201 ---
cycle-reaming = Alesatura
    .nc = ALESATURA
    .purpose = Alesa un foro in un unico incremento. L’utensile lascia il foro con un avanzamento proprio.
step-ream-to-depth = L’utensile alesa con l’avanzamento { $q-plunging-feed } fino alla profondità programmata { $q-depth }.

# --- 203 ---
cycle-universal-drilling = Foratura universale
    .nc = FORATURA UNIVERSALE
    .purpose = Esegue un foro in più incrementi, che possono essere decrescenti. Il truciolo può essere rotto più volte prima che l’utensile venga ritratto dal foro.
step-drill-to-decreasing-plunging-depth = L’utensile fora con l’avanzamento { $q-plunging-feed } fino alla profondità incremento successiva. A ogni incremento la profondità incremento { $q-plunging-depth } si riduce del decremento { $q-decrement }, se inserito.
step-break-chip-or-retract = Tra un incremento e l’altro l’utensile arretra:
say-break-chip-by-retraction = con rottura truciolo, di { $q-chip-breaking-retraction }, per il numero di volte indicato in { $q-chip-breaks-before-retraction }, prima che l’utensile venga ritratto dal foro
say-retract-and-return-at-rapid = senza rottura truciolo, con l’avanzamento { $q-retraction-feed } alla distanza di sicurezza, dove sosta per { $q-dwell-at-top }, se inserito; da qui si porta in rapido (FMAX) alla distanza di sicurezza sopra la profondità raggiunta

# --- 240 ---
cycle-centring = Centrinatura
    .nc = CENTRINATURA
    .purpose = Centrina un foro fino a una profondità o a un diametro.
step-centre-to-depth-or-diameter = L’utensile centrina con l’avanzamento { $q-plunging-feed }:
say-centre-to-diameter = { $q-depth-or-diameter } = 1: fino al diametro di centrinatura { $q-centring-diameter }
say-centre-to-depth = { $q-depth-or-diameter } = 0: fino alla profondità di centrinatura { $q-depth }
step-dwell-at-centring-bottom = L’utensile sosta sul fondo della centrinatura per { $q-dwell-at-bottom }, se inserito.
condition-centring-to-depth = { $q-depth-or-diameter } = 0
condition-centring-to-diameter = { $q-depth-or-diameter } = 1
guard-point-angle-missing = Per centrinare fino a un diametro, definire nella tabella utensili l’angolo del tagliente { $mp-drill-point-angle } dell’utensile.
guard-depth-zero__centring = La profondità o il diametro selezionato è 0: il controllo non esegue il ciclo.
guard-depth-positive__centring = La profondità o il diametro selezionato è positivo. Inserire un valore negativo oppure ammettere valori positivi con il parametro macchina { $mp-display-depth-err }.
note-sign-of-depth-or-diameter = Il segno del diametro { $q-centring-diameter } o della profondità { $q-depth }, a seconda di quale dei due è selezionato, determina la direzione di lavoro. Con diametro o profondità 0 il controllo non esegue il ciclo.
note-positive-diameter-or-depth-reverses = Pericolo di collisione! Con un diametro positivo o una profondità positiva il controllo inverte il calcolo della posizione preliminare: l’utensile si porta in rapido nell’asse utensile alla distanza di sicurezza sotto la superficie del pezzo.

# --- 202 ---
cycle-boring = Barenatura
    .nc = BARENATURA
    .purpose = Barena un foro. Sul fondo il mandrino viene orientato e l’utensile può essere disimpegnato dalla parete prima di essere ritratto.
step-bore-to-depth = L’utensile barena con l’avanzamento { $q-plunging-feed } fino alla profondità { $q-depth }.
step-dwell-with-spindle-turning = Se è inserito un tempo, per eseguire la spoglia l’utensile sosta sul fondo del foro per { $q-dwell-at-bottom } con il mandrino in rotazione.
step-orient-spindle-to-angle = Il controllo orienta il mandrino nella posizione definita in { $q-spindle-orientation-angle }.
step-disengage-from-wall = Se è selezionato un disimpegno, l’utensile si sposta di 0,2 mm (valore fisso) nella direzione { $q-disengaging-direction }.
step-retract-bored-tool = L’utensile si ritrae con l’avanzamento { $q-retraction-feed } alla distanza di sicurezza { $q-set-up-clearance }. Se { $q-disengaging-direction } = 0, ritorna lungo la parete del foro.
step-restore-spindle-and-coolant = Il controllo ripristina gli stati del mandrino e del refrigerante che erano attivi prima della chiamata del ciclo.
note-machine-and-control-prepared = Macchina e controllo devono essere predisposti dal costruttore della macchina per questo ciclo.
note-servo-controlled-spindle-only = Il ciclo può essere impiegato solo su macchine con mandrino controllato.
note-spindle-and-coolant-restored = Al termine del ciclo sono di nuovo attivi gli stati del refrigerante e del mandrino precedenti la chiamata del ciclo.
note-disengage-away-from-edge = Pericolo di collisione! Selezionare la direzione di disimpegno { $q-disengaging-direction } in modo che l’utensile si allontani dal bordo del foro.
note-check-position-of-tool-tip = Pericolo di collisione! Orientare il mandrino all’angolo programmato in { $q-spindle-orientation-angle } (ad esempio nel modo operativo Introduzione manuale dati) e verificare dove si trova la punta dell’utensile. Selezionare l’angolo in modo che la punta dell’utensile sia parallela a un asse di coordinate.
note-disengaging-considers-rotation = Durante il disimpegno il controllo tiene conto automaticamente di una rotazione attiva del sistema di coordinate.

# --- 204 ---
cycle-back-boring = Controforatura invertita
    .nc = CONTROFORATURA INVERTITA
    .purpose = Esegue lamature sul lato inferiore del pezzo.
step-orient-and-offset-tool = Il controllo orienta il mandrino a { $q-spindle-orientation-angle } e sposta l’utensile dell’eccentricità { $q-off-centre-distance } nella direzione { $q-disengaging-direction }.
step-feed-through-bore = L’utensile penetra con l’avanzamento di avvicinamento { $q-in-and-out-feed } nel foro esistente, finché il tagliente si trova alla distanza di sicurezza { $q-set-up-clearance } al di sotto dello spigolo inferiore del pezzo.
step-centre-tool-and-counterbore = Il controllo riporta l’utensile al centro del foro, inserisce il mandrino ed eventualmente il refrigerante e poi porta l’utensile con l’avanzamento { $q-countersinking-feed } alla profondità { $q-counterbore-depth }.
step-dwell-and-leave-counterbore = Se è inserito { $q-counterbore-dwell }, l’utensile sosta sul fondo della lamatura. Poi lascia la lamatura; il controllo orienta il mandrino e sposta di nuovo l’utensile dell’eccentricità.
step-feed-out-of-bore = L’utensile si porta con l’avanzamento di avvicinamento { $q-in-and-out-feed } alla distanza di sicurezza { $q-set-up-clearance } sopra la superficie del pezzo.
note-back-boring-bars-only = Il ciclo funziona solo con bareni per lavorazione a tirare (controforatura invertita).
note-sign-of-counterbore-depth = Il segno della profondità { $q-counterbore-depth } determina la direzione di lavoro. Attenzione: con segno positivo la lamatura viene eseguita in direzione positiva dell’asse del mandrino.
note-length-to-lower-edge-of-bar = Inserire la lunghezza utensile in modo che sia misurato lo spigolo inferiore del bareno e non il tagliente.
note-edge-height-and-thickness-considered = Nel calcolo del punto di partenza della lamatura il controllo tiene conto dell’altezza del tagliente { $q-cutting-edge-height } del bareno e dello spessore del materiale { $q-material-thickness }.

# --- 208 ---
cycle-bore-milling = Fresatura foro
    .nc = FRESATURA FORO
    .purpose = Fresa un foro su una traiettoria elicoidale. Se il foro ha lo stesso diametro dell’utensile, viene forato direttamente.
step-rapid-and-approach-hole-circumference = Il controllo porta l’utensile nell’asse del mandrino in rapido (FMAX) alla distanza di sicurezza { $q-set-up-clearance } sopra la superficie del pezzo e poi, se lo spazio è sufficiente, su un arco fino alla circonferenza del foro { $q-nominal-diameter }.
step-drill-directly-if-diameters-equal = Se il diametro { $q-nominal-diameter } è uguale al diametro dell’utensile, l’utensile fora direttamente, senza interpolazione elicoidale, fino alla profondità { $q-depth }.
step-mill-on-helix = L’utensile fresa con l’avanzamento { $q-plunging-feed } su una traiettoria elicoidale che a ogni giro scende di { $q-infeed-per-helix }.
step-mill-full-circle-at-depth = Raggiunta la profondità, l’utensile percorre ancora un cerchio completo per asportare il materiale rimasto dopo la penetrazione.
step-return-to-centre-of-hole = Il controllo riporta l’utensile al centro del foro.
step-rapid-back-to-clearance = L’utensile ritorna in rapido (FMAX) alla distanza di sicurezza { $q-set-up-clearance }.
guard-tool-wider-than-hole = Il diametro del foro è minore di quello dell’utensile.
guard-hole-too-wide-for-tool = Il diametro del foro è più del doppio di quello dell’utensile. Inserire il diametro del foro preforato oppure utilizzare un utensile più grande.
note-equal-diameters-are-drilled = Se il diametro del foro inserito è quello dell’utensile, il controllo fora senza interpolazione elicoidale direttamente fino alla profondità inserita.
note-mirroring-keeps-milling-type = Una lavorazione speculare attiva non modifica il tipo di fresatura definito nel ciclo.
note-infeed-too-large-does-damage = Un incremento troppo grande danneggia sia l’utensile sia il pezzo.
note-plunging-angle-limits-infeed = Per evitare incrementi troppo grandi, inserire nella colonna { $mp-plunging-angle } della tabella utensili il massimo angolo di penetrazione possibile dell’utensile. Il controllo calcola allora automaticamente l’incremento massimo ammesso e, se necessario, modifica il valore inserito.

# --- 241 ---
cycle-single-lip-drilling = Foratura con punte a cannone monotaglienti
    .nc = FOR. PROF. MONOTAGLIENTE
    .purpose = Fora con una punta a cannone monotagliente, anche da un punto di partenza sotto la superficie del pezzo, con numero di giri e senso di rotazione propri per l’entrata e l’uscita e con funzioni M per il refrigerante.
step-feed-in-and-switch-on = Il controllo porta l’utensile con l’avanzamento di avvicinamento { $q-pre-positioning-feed } alla distanza di sicurezza sopra il punto di partenza abbassato { $q-deepened-starting-point } e qui inserisce il numero di giri di foratura { $q-drilling-speed } con M3 e il refrigerante con { $q-coolant-on-function }. In entrata il mandrino ruota in senso orario o antiorario con il numero di giri { $q-speed-in-and-out } oppure è fermo, come indica { $q-rotation-in-and-out }.
step-drill-in-one-infeed = L’utensile fora con l’avanzamento { $q-plunging-feed } fino alla profondità { $q-depth }.
step-switch-off-coolant-and-reset-speed = Il controllo disinserisce il refrigerante con { $q-coolant-off-function } e per l’uscita riporta il numero di giri al valore { $q-speed-in-and-out }.
