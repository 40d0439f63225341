# Pockets, slots, studs, line patterns and multipass milling; see the English file.

# --- common to pockets, slots and studs ---
guard-tool-wider-than-slot = L’utensile non entra nella scanalatura: tolti i sovrametalli laterali, la scanalatura è più stretta dell’utensile.
guard-stud-blank-too-small = Il pezzo grezzo non è più grande dell’isola finita.
note-finishing-only-rapid-to-first-depth = Pericolo di collisione! Se il ciclo viene chiamato con il tipo di lavorazione 2 (solo finitura), il controllo porta l’utensile in rapido alla prima profondità incremento.

# --- 252 ---
cycle-circular-pocket = Tasca circolare
    .nc = TASCA CIRCOLARE
    .purpose = Esegue la lavorazione completa di una tasca circolare: sgrossatura, finitura del fondo e finitura laterale. È possibile eseguire anche solo la sgrossatura, solo la finitura del fondo e laterale, solo la finitura del fondo o solo la finitura laterale.
guard-plunging-angle-not-vertical = Per la penetrazione verticale, nella tabella utensili deve essere presente un angolo di penetrazione { $mp-plunging-angle } di 0 o 90.
note-position-at-pocket-centre = Posizionare l’utensile sul punto di partenza (centro del cerchio) nel piano di lavoro con correzione del raggio R0.

# --- 253 ---
cycle-slot = Fresatura di scanalature
    .nc = FRES. SCANALATURA
    .purpose = Esegue la lavorazione completa di una scanalatura: sgrossatura, finitura del fondo e finitura laterale. È possibile eseguire anche solo la sgrossatura, solo la finitura del fondo e laterale, solo la finitura del fondo o solo la finitura laterale.
step-move-over-left-slot-arc = Il controllo posiziona l’utensile nell’asse utensile alla 2ª distanza di sicurezza { $q-second-set-up-clearance } (se non è inserita, alla distanza di sicurezza), poi sopra il centro dell’arco sinistro della scanalatura e infine alla distanza di sicurezza { $q-set-up-clearance }, sempre in rapido.
step-plunge-at-left-slot-arc = Partendo dal centro dell’arco sinistro della scanalatura, l’utensile penetra fino alla profondità incremento { $q-plunging-depth } successiva. Il parametro { $q-plunging-strategy } determina in che modo:
say-plunge-to-and-fro-along-slot = { $q-plunging-strategy } = 1 o 2: con pendolamento lungo la scanalatura con l’angolo di penetrazione { $mp-plunging-angle } della tabella utensili, con l’avanzamento { $q-plunging-feed }
step-clear-slot-level = Il controllo svuota la scanalatura dall’interno verso l’esterno, tenendo conto dei sovrametalli di finitura { $q-side-allowance } e { $q-floor-allowance }.
step-rapid-to-first-plunging-depth-of-slot = Se è programmata solo la finitura ({ $q-machining-operation } = 2), il controllo porta l’utensile in rapido alla prima profondità incremento.
step-finish-slot-side = Se è definito un sovrametallo { $q-side-allowance }, il controllo esegue dapprima la finitura delle pareti della scanalatura, in più incrementi se è inserito { $q-finishing-infeed }. L’accostamento alla parete è tangenziale nell’arco sinistro della scanalatura.
step-finish-slot-side__circular-slot = Se è definito un sovrametallo { $q-side-allowance }, il controllo esegue dapprima la finitura delle pareti della scanalatura, in più incrementi se è inserito { $q-finishing-infeed }. L’accostamento alla parete è tangenziale.
until-slot-side-finished = la finitura delle pareti non ha raggiunto la profondità { $q-depth }
step-finish-slot-floor = Se è definito un sovrametallo { $q-floor-allowance }, il controllo esegue poi la finitura del fondo della scanalatura dall’interno verso l’esterno.
step-leave-slot = L’utensile lascia la scanalatura in rapido fino alla 2ª distanza di sicurezza { $q-second-set-up-clearance } (se non è inserita, alla distanza di sicurezza).
step-end-of-slot = La posizione dell’utensile al termine del ciclo dipende dalla posizione della scanalatura { $q-slot-position }:
say-back-to-slot-centre = { $q-slot-position } = 0: il controllo riporta l’utensile nel piano di lavoro al centro della scanalatura
say-stays-in-working-plane = altrimenti: il controllo non posiziona l’utensile nel piano di lavoro
note-position-at-slot-start = Posizionare l’utensile sul punto di partenza nel piano di lavoro con correzione del raggio R0. Tenere conto della posizione della scanalatura { $q-slot-position }.
note-position-at-slot-start__circular-slot = Posizionare l’utensile sul punto di partenza nel piano di lavoro con correzione del raggio R0. Tenere conto del riferimento per la posizione della scanalatura { $q-slot-position-reference }.
note-slot-end-position = Al termine del ciclo il controllo riporta l’utensile nel piano di lavoro al centro della scanalatura. Eccezione: se è definita una posizione della scanalatura { $q-slot-position } diversa da 0, lo posiziona solo nell’asse utensile alla 2ª distanza di sicurezza. Prima di richiamare il ciclo riportare l’utensile nella posizione di partenza oppure programmare spostamenti assoluti prima della chiamata.
note-wide-slot-is-cleared = Se la scanalatura è più larga del doppio del diametro dell’utensile, il controllo la svuota dall’interno verso l’esterno. Si possono quindi fresare scanalature di qualsiasi larghezza anche con utensili piccoli.

# --- 254 ---
cycle-circular-slot = Scanalatura circolare
    .nc = SCANALATURA CIRCOLARE
    .purpose = Esegue la lavorazione completa di una scanalatura circolare o di più scanalature su un cerchio parziale: sgrossatura, finitura del fondo e finitura laterale. È possibile eseguire anche solo la sgrossatura, solo la finitura del fondo e laterale, solo la finitura del fondo o solo la finitura laterale.
step-move-over-circular-slot = Il controllo posiziona l’utensile nell’asse utensile alla 2ª distanza di sicurezza { $q-second-set-up-clearance } (se non è inserita, alla distanza di sicurezza), poi sopra il punto di partenza della scanalatura e infine alla distanza di sicurezza { $q-set-up-clearance }, sempre in rapido.
step-plunge-in-circular-slot = L’utensile penetra al centro della larghezza della scanalatura fino alla profondità incremento { $q-plunging-depth } successiva. Il parametro { $q-plunging-strategy } determina in che modo:
until-all-slots-milled = non sono state fresate tutte le scanalature ({ $q-number-of-operations }); ciascuna è ruotata di { $q-pattern-stepping-angle } intorno al centro del cerchio parziale
step-end-of-circular-slot = La posizione dell’utensile al termine del ciclo dipende dal riferimento per la posizione della scanalatura { $q-slot-position-reference }:
say-back-to-pitch-circle-centre = { $q-slot-position-reference } = 0: il controllo riporta l’utensile nel piano di lavoro sul punto di partenza (centro del cerchio parziale)
condition-slot-at-entered-centre = la posizione della scanalatura risulta dal centro del cerchio parziale inserito ({ $q-slot-position-reference } = 0)
note-circular-slot-end-position = Al termine del ciclo il controllo riporta l’utensile nel piano di lavoro sul punto di partenza (centro del cerchio parziale). Eccezione: se è definita una posizione della scanalatura { $q-slot-position-reference } diversa da 0, lo posiziona solo nell’asse utensile alla 2ª distanza di sicurezza. In questo caso programmare sempre spostamenti assoluti dopo la chiamata del ciclo.
note-circular-slot-with-pattern = Se il ciclo 254 (scanalatura circolare) viene combinato con il ciclo 221, il valore 0 per la posizione della scanalatura non è ammesso.

# --- 256 ---
cycle-rectangular-stud = Isola rettangolare
    .nc = ISOLA RETTANGOLARE
    .purpose = Lavora un’isola rettangolare. Se il pezzo grezzo è più grande del massimo incremento laterale possibile, il controllo esegue più incrementi laterali fino a raggiungere la quota finita.
step-move-to-stud-approach = L’utensile si porta dalla posizione di partenza del ciclo (centro dell’isola) alla posizione di partenza per la lavorazione dell’isola, determinata dal parametro { $q-stud-approach-position }:
say-approach-beside-blank = { $q-stud-approach-position } = 0 (impostazione standard): 2 mm a destra dell’isola grezza
say-approach-at-stud-corner = altrimenti: sullo spigolo selezionato
step-rapid-down-to-set-up-clearance = Se l’utensile si trova alla 2ª distanza di sicurezza, il controllo lo porta in rapido (FMAX) alla distanza di sicurezza { $q-set-up-clearance }.
step-feed-to-plunging-depth-of-stud = L’utensile si porta con l’avanzamento in profondità { $q-plunging-feed } alla profondità incremento { $q-plunging-depth } successiva.
step-mill-around-stud = L’utensile si accosta poi tangenzialmente al profilo dell’isola e fresa un giro.
step-mill-around-stud-again = Se con un giro non si raggiunge la quota finita, il controllo esegue un incremento laterale alla profondità attuale e fresa un altro giro, tenendo conto della quota del grezzo, della quota finita e dell’incremento laterale ammesso. L’operazione si ripete fino a raggiungere la quota finita. Se il punto di partenza si trova su uno spigolo ({ $q-stud-approach-position } diverso da 0), il controllo fresa a spirale dal punto di partenza verso l’interno fino a raggiungere la quota finita.
step-leave-stud-to-start = Se sono necessari altri incrementi, l’utensile si distacca tangenzialmente dal profilo e ritorna al punto di partenza dell’isola.
until-stud-depth-reached = non è raggiunta la profondità programmata { $q-depth } dell’isola
step-retract-from-stud = Al termine del ciclo il controllo posiziona l’utensile soltanto nell’asse utensile. La posizione finale è quindi diversa dalla posizione di partenza:
note-position-at-stud-start = Posizionare l’utensile sul punto di partenza nel piano di lavoro con correzione del raggio R0. Tenere conto della posizione dell’isola { $q-stud-position }.
note-room-beside-stud = Pericolo di collisione! Lasciare a destra dell’isola spazio sufficiente per l’accostamento dell’utensile: almeno il diametro dell’utensile + 2 mm.
note-stud-end-position = Pericolo di collisione! Al termine il controllo riporta l’utensile alla distanza di sicurezza oppure, se inserita, alla 2ª distanza di sicurezza. La posizione finale dell’utensile dopo il ciclo non coincide quindi con la sua posizione di partenza.
note-choose-other-approach-position = Se l’accostamento con { $q-stud-approach-position } = 0 lascia segni sulla superficie dell’isola, scegliere un’altra posizione di accostamento.

# --- 257 ---
cycle-circular-stud = Isola circolare
    .nc = ISOLA CIRCOLARE
    .purpose = Lavora un’isola circolare. Se il diametro del pezzo grezzo è più grande del massimo incremento laterale possibile, il controllo esegue più incrementi laterali fino a raggiungere il diametro della parte finita.
step-move-to-circular-stud-approach = L’utensile si porta dalla posizione di partenza del ciclo (centro dell’isola) alla posizione di partenza per la lavorazione dell’isola, che il parametro { $q-stud-starting-angle } definisce come angolo polare riferito al centro dell’isola.
step-mill-spiral-around-stud = L’utensile si accosta poi tangenzialmente al profilo dell’isola su una traiettoria a spirale e fresa un giro.
step-keep-spiral-to-finished-diameter = Se con un giro non si raggiunge il diametro della parte finita, il controllo continua ad avanzare sulla spirale fino a raggiungerlo, tenendo conto del diametro del grezzo, del diametro della parte finita e dell’incremento laterale ammesso.
step-leave-stud-on-spiral = L’utensile si distacca dal profilo su una traiettoria a spirale.
step-next-infeed-near-departure = Se sono necessari più incrementi, quello successivo avviene nel punto più vicino al distacco.
step-retract-and-return-to-stud-centre = Al termine del ciclo, dopo il distacco a spirale, il controllo posiziona l’utensile nell’asse utensile alla 2ª distanza di sicurezza { $q-second-set-up-clearance } (se non è inserita, alla distanza di sicurezza) e poi al centro dell’isola.
note-position-at-stud-centre = Posizionare l’utensile sul punto di partenza (centro dell’isola) nel piano di lavoro con correzione del raggio R0.
note-circular-stud-end-height = Pericolo di collisione! Al termine il controllo riporta l’utensile alla distanza di sicurezza oppure, se inserita, alla 2ª distanza di sicurezza. Nell’asse utensile, la posizione finale dopo il ciclo può quindi essere diversa dalla sua posizione di partenza.

# --- 221 ---
cycle-line-pattern = Sagome di punti su linee
    .nc = LINEE DI FIGURE
    .purpose = Esegue l’ultimo ciclo di lavorazione definito in punti disposti su righe e colonne.
until-line-done = non sono state eseguite tutte le { $q-number-of-columns } lavorazioni della riga; l’utensile si trova allora sull’ultimo punto della riga
step-move-to-next-column = Il controllo porta poi l’utensile sul punto di partenza della lavorazione successiva, nella prima, terza, quinta riga … in direzione positiva dell’asse principale, nella seconda, quarta, sesta riga … in direzione negativa, e qui alla distanza di sicurezza { $q-set-up-clearance }.
step-height-between-lines = Sull’ultimo punto della riga l’utensile si porta nell’asse del mandrino all’altezza prevista da { $q-pattern-clearance-mode } tra una lavorazione e l’altra.
step-move-to-next-line = Il controllo porta poi l’utensile alla riga successiva, direttamente sul punto della stessa colonna, e qui alla distanza di sicurezza { $q-set-up-clearance }. Tutte le altre righe vengono lavorate in questo modo, in andata e ritorno.
until-all-lines-done = non sono state eseguite tutte le { $q-number-of-lines } righe
note-pattern-overrides-heights-and-rotation = Se uno dei cicli di lavorazione da 200 a 209 e da 251 a 267 viene combinato con questo ciclo, valgono la distanza di sicurezza { $q-set-up-clearance }, la coordinata della superficie del pezzo { $q-surface-coordinate }, la 2ª distanza di sicurezza { $q-second-set-up-clearance } e l’angolo di rotazione { $q-angle-of-rotation } di questo ciclo.

# --- common to surfaces ---
until-surface-milled = la superficie definita non è completamente fresata
note-pre-position-for-surface = Pericolo di collisione! Preposizionare l’utensile in modo da escludere collisioni con il pezzo o i dispositivi di bloccaggio.

# --- 230 ---
cycle-multipass-milling = Spianatura
    .nc = SPIANATURA
    .purpose = Fresa una superficie piana rettangolare per righe, in andata e ritorno.
step-rapid-to-start-of-lines = Il controllo posiziona l’utensile in rapido (FMAX) dalla posizione attuale nel piano di lavoro sul punto di partenza 1, spostandolo del raggio dell’utensile verso sinistra e verso l’alto.
step-down-to-start-of-lines = L’utensile si porta poi nell’asse del mandrino in rapido (FMAX) alla distanza di sicurezza { $q-set-up-clearance } e da qui, con l’avanzamento in profondità { $q-plunging-feed }, alla posizione di partenza programmata { $q-starting-point-tool } nell’asse del mandrino.
step-mill-line = L’utensile fresa poi con l’avanzamento programmato { $q-milling-feed } fino al punto finale 2, che il controllo calcola dal punto di partenza, dalla lunghezza programmata { $q-first-side-length } e dal raggio dell’utensile.
step-step-over-to-next-line = Il controllo sposta l’utensile trasversalmente con l’avanzamento { $q-stepover-feed } sul punto di partenza della riga successiva. Calcola lo spostamento dalla larghezza programmata { $q-second-side-length } e dal numero di tagli { $q-number-of-cuts }.
step-mill-back-in-next-line = L’utensile ritorna poi in direzione negativa del 1° asse.
step-rapid-back-to-clearance-over-surface = Al termine il controllo ritrae l’utensile in rapido (FMAX) alla distanza di sicurezza { $q-set-up-clearance }.
note-plane-first-then-spindle-axis = Dalla posizione attuale il controllo posiziona l’utensile sul punto di partenza dapprima nel piano di lavoro e poi nell’asse del mandrino.

# --- 231 ---
cycle-ruled-surface = Superficie regolare
    .nc = SUPERFICIE REGOLARE
    .purpose = Fresa una superficie obliqua, inclinata o svergolata, definita da quattro punti d’angolo, con righe nella stessa direzione.
step-straight-to-starting-point = Il controllo porta l’utensile dalla posizione attuale su una retta nello spazio al punto di partenza 1.
step-mill-line-to-its-end = L’utensile fresa poi con l’avanzamento programmato { $q-milling-feed } fino al punto finale della riga: nella prima riga fino al punto 2, con avanzamento dimezzato; in ogni riga successiva fino a un punto che il controllo calcola dal punto 2 e dallo spostamento verso il punto 3.
step-rapid-back-to-start-of-line = Da qui il controllo sposta l’utensile in rapido (FMAX) in direzione positiva dell’asse del mandrino, fino a una distanza pari al diametro dell’utensile sopra l’estremità più alta della riga, e poi lo riporta al punto di partenza della riga (nella prima riga il punto 1).
step-down-to-last-height = Sul punto di partenza il controllo riporta l’utensile all’ultimo valore raggiunto in quel punto nell’asse del mandrino.
step-move-to-start-of-next-line = Il controllo porta poi l’utensile alla riga successiva, in tutti e tre gli assi, dal punto 1 in direzione del punto 4.
step-above-highest-point = Al termine il controllo posiziona l’utensile nell’asse del mandrino, a una distanza pari al diametro dell’utensile sopra il punto più alto inserito.
note-cutting-direction-of-surface = Il punto di partenza, e quindi la direzione di fresatura, può essere scelto liberamente: il controllo esegue i singoli tagli dal punto 1 al punto 2, mentre la lavorazione complessiva procede dai punti 1 e 2 ai punti 3 e 4. Il punto 1 può trovarsi su un angolo qualsiasi della superficie.
note-surface-quality-with-end-mills = Con frese a candela la qualità della superficie può essere migliorata: con un taglio in spinta (coordinata dell’asse del mandrino del punto 1 maggiore di quella del punto 2) su superfici poco inclinate; con un taglio in trazione (coordinata dell’asse del mandrino del punto 1 minore di quella del punto 2) su superfici molto inclinate; su superfici svergolate disponendo la direzione di taglio principale (dal punto 1 al punto 2) nella direzione dell’inclinazione maggiore.
note-surface-quality-with-ball-end-mills = Con frese sferiche la qualità di superfici svergolate può essere migliorata disponendo la direzione di taglio principale (dal punto 1 al punto 2) perpendicolarmente alla direzione dell’inclinazione maggiore.
note-straight-to-start-without-collision = Pericolo di collisione! Il controllo porta l’utensile dalla posizione attuale su una retta nello spazio al punto di partenza 1. Preposizionare l’utensile in modo da escludere collisioni con il pezzo o i dispositivi di bloccaggio.
note-positions-with-r0 = Tra le posizioni inserite il controllo sposta l’utensile con correzione del raggio R0.
note-centre-cut-or-pilot-drill = Se necessario, utilizzare una fresa con tagliente al centro (DIN 844) oppure preforare con il ciclo 21.

# --- 232 ---
cycle-face-milling = Fresatura a spianare
    .nc = FRESATURA A SPIANARE
    .purpose = Fresa una superficie piana in più incrementi con una strategia a scelta fra tre, tenendo conto di un sovrametallo di finitura.
step-position-beside-surface = Dalla posizione attuale il controllo posiziona l’utensile in rapido (FMAX) con logica di posizionamento sul punto di partenza 1, situato a fianco del pezzo, a una distanza pari al raggio dell’utensile più la distanza laterale { $q-side-clearance }:
say-plane-then-spindle-axis = se l’utensile si trova sopra la 2ª distanza di sicurezza { $q-second-set-up-clearance }: dapprima nel piano di lavoro, poi nell’asse del mandrino
say-second-clearance-then-plane = altrimenti: dapprima alla 2ª distanza di sicurezza { $q-second-set-up-clearance }, poi nel piano di lavoro
step-feed-to-face-infeed = L’utensile si porta poi nell’asse del mandrino con l’avanzamento di avvicinamento { $q-pre-positioning-feed } alla profondità incremento successiva, calcolata dal controllo.
step-mill-face-line = L’utensile fresa con l’avanzamento programmato { $q-milling-feed } fino al punto finale 2:
say-line-ends-outside-surface = { $q-face-milling-strategy } = 0: all’esterno della superficie; il controllo lo calcola dal punto di partenza, dalla lunghezza e dalla distanza laterale { $q-side-clearance } programmati e dal raggio dell’utensile
say-line-ends-inside-surface = { $q-face-milling-strategy } = 1: all’interno della superficie; il controllo lo calcola dal punto di partenza e dalla lunghezza programmati e dal raggio dell’utensile
say-line-ends-outside-surface-by-lines = { $q-face-milling-strategy } = 2: all’esterno della superficie; il controllo lo calcola dal punto di partenza, dalla lunghezza e dalla distanza laterale { $q-side-clearance } programmati e dal raggio dell’utensile
step-step-over-on-face = Il controllo calcola lo spostamento dalla larghezza programmata { $q-second-side-length }, dal raggio dell’utensile e dal fattore di sovrapposizione massimo { $q-max-path-overlap } e sposta l’utensile trasversalmente sul punto di partenza della riga successiva:
say-step-over-outside = { $q-face-milling-strategy } = 0: con l’avanzamento di avvicinamento { $q-pre-positioning-feed }
say-step-over-inside = { $q-face-milling-strategy } = 1: all’interno del pezzo, con l’avanzamento di fresatura { $q-milling-feed }
say-retract-and-return-to-next-line = { $q-face-milling-strategy } = 2: l’utensile si porta nell’asse del mandrino alla distanza di sicurezza { $q-set-up-clearance } sopra la profondità attuale e con l’avanzamento di avvicinamento { $q-pre-positioning-feed } direttamente sul punto di partenza della riga successiva
step-mill-next-face-line = L’utensile fresa poi la riga successiva:
say-back-towards-start = { $q-face-milling-strategy } = 0: indietro in direzione del punto di partenza 1
say-back-towards-start-inside = { $q-face-milling-strategy } = 1: indietro in direzione del punto di partenza 1; anche lo spostamento alla riga successiva avviene all’interno del pezzo
say-down-and-towards-end = { $q-face-milling-strategy } = 2: si riporta alla profondità incremento attuale e poi procede in direzione del punto finale 2
step-repeat-until-face-milled = L’operazione si ripete finché la superficie definita non è completamente fresata. Al termine dell’ultima traiettoria l’utensile avanza alla profondità di lavorazione successiva. Per evitare percorsi a vuoto, la superficie viene poi lavorata in sequenza inversa.
until-face-infeeds-done = non sono stati eseguiti tutti gli incrementi tranne l’ultimo
step-finish-face = Con l’ultimo incremento viene fresato solo il sovrametallo di finitura inserito { $q-floor-allowance }, con l’avanzamento di finitura { $q-finishing-feed }.
step-rapid-back-to-second-clearance = Al termine il controllo ritrae l’utensile in rapido (FMAX) alla 2ª distanza di sicurezza { $q-second-set-up-clearance }.
note-three-face-milling-strategies = Sono disponibili tre strategie. { $q-face-milling-strategy } = 0: lavorazione a meandri, incremento laterale all’esterno della superficie da lavorare. { $q-face-milling-strategy } = 1: lavorazione a meandri, incremento laterale all’interno della superficie da lavorare. { $q-face-milling-strategy } = 2: lavorazione per righe, con ritrazione e incremento laterale con l’avanzamento di avvicinamento.
note-levels-in-reverse-order = Per evitare percorsi a vuoto, ogni livello successivo viene lavorato in sequenza inversa.
note-second-clearance-without-collision = Inserire la 2ª distanza di sicurezza { $q-second-set-up-clearance } in modo da escludere collisioni dell’utensile con il pezzo o i dispositivi di bloccaggio.
note-equal-end-and-start-do-nothing = Se il punto di partenza 3° asse { $q-starting-point-tool } e il punto finale 3° asse { $q-end-point-tool } sono uguali, il controllo non esegue il ciclo (la profondità programmata è 0).
