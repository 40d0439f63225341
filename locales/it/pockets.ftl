# Pockets; see the English file.
cycle-rectangular-pocket = Tasca rettangolare
    .nc = TASCA RETTANGOLARE
    .purpose = Esegue la lavorazione completa di una tasca rettangolare: sgrossatura, finitura del fondo e finitura laterale. È possibile eseguire anche solo la sgrossatura, solo la finitura del fondo e laterale, solo la finitura del fondo o solo la finitura laterale.
step-move-over-pocket-centre = Il controllo posiziona l’utensile nell’asse utensile alla 2ª distanza di sicurezza { $q-second-set-up-clearance } (se non è inserita, alla distanza di sicurezza), poi sopra il centro della tasca e infine alla distanza di sicurezza { $q-set-up-clearance }, sempre in rapido.
group-roughing = Sgrossatura
step-plunge-at-centre = L’utensile penetra nel pezzo al centro della tasca fino alla profondità incremento { $q-plunging-depth } successiva. Il parametro { $q-plunging-strategy } determina in che modo:
say-plunge-vertically = { $q-plunging-strategy } = 0: in verticale con l’avanzamento { $q-plunging-feed }
say-plunge-helically = { $q-plunging-strategy } = 1: lungo una traiettoria elicoidale con l’avanzamento { $q-plunging-feed }
say-plunge-reciprocating = { $q-plunging-strategy } = 2: con pendolamento, con l’avanzamento { $q-plunging-feed }
step-clear-level = Il controllo svuota la tasca dall’interno verso l’esterno, tenendo conto del fattore di sovrapposizione { $q-path-overlap } e dei sovrametalli di finitura { $q-side-allowance } e { $q-floor-allowance }. Alla fine l’utensile si allontana tangenzialmente dalla parete della tasca.
step-leave-wall-and-return = L’utensile si porta alla distanza di sicurezza sopra la profondità attuale e da qui ritorna in rapido al centro della tasca.
until-roughing-depth-reached = non è raggiunta la profondità { $q-depth } meno il sovrametallo del fondo { $q-floor-allowance }
group-finishing = Finitura
step-rapid-to-first-plunging-depth = Se è programmata solo la finitura ({ $q-machining-operation } = 2), il controllo porta l’utensile in rapido, al centro della tasca, alla prima profondità incremento.
step-finish-side = Se è definito un sovrametallo { $q-side-allowance }, il controllo esegue dapprima la finitura laterale della tasca con accostamento tangenziale, in più incrementi se è inserito { $q-finishing-infeed }.
until-side-finished = la finitura laterale non ha raggiunto la profondità { $q-depth }
step-finish-floor = Se è definito un sovrametallo { $q-floor-allowance }, il controllo esegue poi la finitura del fondo della tasca dall’interno verso l’esterno con accostamento tangenziale.
step-leave-pocket = L’utensile lascia la tasca in rapido:
step-return-to-starting-point = Il controllo riporta l’utensile sul punto di partenza nel piano di lavoro.
guard-plunging-depth-zero = La profondità incremento deve essere maggiore di 0.
guard-tool-wider-than-pocket = L’utensile non entra nella tasca: tolti i sovrametalli laterali, la tasca è più stretta dell’utensile.
guard-plunging-angle-missing = Per la penetrazione elicoidale o con pendolamento, nella tabella utensili deve essere presente un angolo di penetrazione { $mp-plunging-angle } diverso da 0.
guard-helix-too-small = Il diametro dell’elica di penetrazione è inferiore al doppio del diametro dell’utensile. Il parametro macchina { $mp-suppress-plunge-err } disattiva questa verifica per utensili con tagliente al centro.
note-without-tool-table-plunge-vertically = Se non è attiva alcuna tabella utensili, la penetrazione deve essere sempre verticale ({ $q-plunging-strategy } = 0), poiché non è possibile definire un angolo di penetrazione.
note-position-at-pocket-start = Posizionare l’utensile sul punto di partenza nel piano di lavoro con correzione del raggio R0. Tenere conto della posizione della tasca { $q-pocket-position }.
note-positions-in-tool-axis-itself = Il controllo posiziona l’utensile nell’asse utensile automaticamente. Tenere conto della 2ª distanza di sicurezza { $q-second-set-up-clearance }.
note-returns-to-starting-point = Al termine del ciclo il controllo riporta l’utensile, nel piano di lavoro, sul punto di partenza.
note-clearance-above-chips = Dopo lo svuotamento di ogni livello l’utensile ritorna in rapido al centro della tasca, alla distanza di sicurezza sopra la profondità attuale. Scegliere la distanza di sicurezza in modo che durante lo spostamento l’utensile non possa incastrarsi nei trucioli.
note-helix-diameter-monitored = Nella penetrazione elicoidale il controllo emette un messaggio d’errore se il diametro dell’elica calcolato è inferiore al doppio del diametro dell’utensile. Per utensili con tagliente al centro questa verifica può essere disattivata con il parametro macchina { $mp-suppress-plunge-err }.
note-cutting-edge-limits-infeed = Se il tagliente è più corto della profondità incremento { $q-plunging-depth }, il controllo riduce la profondità incremento alla lunghezza { $mp-cutting-edge-length } della tabella utensili.
note-finishing-only-starts-at-first-depth = Pericolo di collisione! Se il ciclo viene chiamato con il tipo di lavorazione 2 (solo finitura), il controllo porta l’utensile in rapido, al centro della tasca, alla prima profondità incremento.
note-point-table-starting-points = Se il ciclo viene chiamato con una tabella punti, i punti del piano di lavoro sono i punti di partenza del ciclo. Per utilizzare la coordinata dell’asse del mandrino della tabella come coordinata del punto di partenza, inserire 0 come coordinata della superficie del pezzo { $q-surface-coordinate }.
note-point-table-shifts-datum = Se il ciclo viene chiamato con una tabella punti, il controllo considera ogni punto come un ulteriore spostamento origine.
