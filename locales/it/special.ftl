# Special functions; see the English file.

# --- 9 ---
cycle-dwell = Tempo di sosta
    .nc = TEMPO DI SOSTA
    .purpose = Arresta l’esecuzione del programma per la durata del tempo di sosta, ad esempio per la rottura truciolo.
step-dwell-for-programmed-time = Il controllo arresta l’esecuzione del programma per il tempo di sosta programmato.
note-dwell-acts-from-definition = Il ciclo è attivo dalla sua definizione nel programma.
note-dwell-keeps-modal-states = Gli stati modali, ad esempio la rotazione del mandrino, non vengono influenzati.

# --- 12 ---
cycle-program-call = Chiamata programma
    .nc = PGM CALL
    .purpose = Rende un programma qualsiasi, ad esempio un ciclo di foratura speciale o un modulo geometrico, equivalente a un ciclo di lavorazione. Il programma viene poi chiamato come un ciclo.
step-call-program-as-cycle = Alla chiamata del ciclo il controllo esegue il programma.
note-program-becomes-cycle = Inserire il nome del programma da chiamare, se necessario con il percorso; oppure attivare la selezione file con il softkey SELEZIONA e selezionare il programma.
note-called-program-on-hard-disk = Il programma chiamato deve essere memorizzato sul disco fisso del controllo.
note-called-program-in-same-directory = Se viene inserito solo il nome del programma, questo deve trovarsi nella stessa directory del programma chiamante.
note-called-program-with-path = Se il programma non si trova nella stessa directory del programma chiamante, inserire il percorso completo.
note-called-iso-program = Per dichiarare come ciclo un programma DIN/ISO, inserire il tipo di file .I dopo il nome del programma.
note-q-parameters-act-globally = Nella chiamata di un programma con questo ciclo i parametri Q hanno sempre effetto globale. Modifiche di parametri Q nel programma chiamato possono quindi influire sul programma chiamante.
note-ways-to-call-the-program = Chiamare il programma con CYCL CALL (blocco separato), con M99 (in un blocco) o con M89 (esecuzione dopo ogni blocco di posizionamento).
title-program-50-as-cycle = Programma 50 come ciclo, chiamato con M99

# --- 13 ---
cycle-spindle-orientation = Orientamento mandrino
    .nc = ORIENTAMENTO
    .purpose = Imposta l’angolo al quale il controllo ruota il mandrino principale della macchina utensile.
step-keep-orientation-angle = Il controllo memorizza l’angolo per il successivo orientamento del mandrino.
step-program-m19-or-m20 = Programmare M19 o M20 (a seconda della macchina): il controllo posiziona allora il mandrino all’angolo definito nel ciclo.
note-prepare-for-spindle-orientation = Macchina e controllo devono essere predisposti dal costruttore della macchina.
note-orientation-is-needed-for = L’orientamento del mandrino è necessario ad esempio per sistemi di cambio utensile con una posizione di cambio definita e per allineare le finestre di trasmissione e ricezione di sistemi di tastatura 3D con trasmissione a infrarossi.
note-orientation-by-m19-or-m20 = Il controllo posiziona il mandrino all’angolo definito nel ciclo quando è programmata M19 o M20 (a seconda della macchina).
note-orientation-without-cycle = Se M19 o M20 è programmata senza che prima sia definito questo ciclo, il controllo posiziona il mandrino principale a un angolo impostato dal costruttore della macchina (vedere il manuale della macchina).
note-orientation-used-by-cycles = I cicli di lavorazione 202, 204 e 209 utilizzano internamente questo ciclo. Se necessario, riprogrammarlo dopo uno di essi.

# --- 32 ---
cycle-tolerance = Tolleranza
    .nc = TOLLERANZA
    .purpose = Influisce sul risultato della lavorazione ad alta velocità in termini di precisione, qualità della superficie e velocità, nella misura in cui il controllo è stato adattato alla macchina.
step-smooth-contour = Il controllo liscia il profilo tra elementi di profilo qualsiasi, corretti o non corretti. L’utensile si sposta così in modo continuo sulla superficie del pezzo e la meccanica della macchina viene salvaguardata.
step-reduce-feed-to-run-smoothly = Se necessario, il controllo riduce l’avanzamento programmato in modo da eseguire sempre il programma senza strappi e alla massima velocità possibile.
note-prepare-for-tolerance = Macchina e controllo devono essere predisposti dal costruttore della macchina.
note-preset-tolerance-by-builder = La lisciatura provoca uno scostamento dal profilo. Il costruttore della macchina ha definito lo scostamento (valore di tolleranza) in un parametro macchina. Il ciclo modifica il valore di tolleranza preimpostato e seleziona altre impostazioni di filtro, purché il costruttore della macchina si avvalga di queste possibilità.
note-tolerance-is-always-used = Anche se il controllo non riduce la velocità, utilizza sempre la tolleranza definita. Quanto maggiore è la tolleranza, tanto più velocemente il controllo può spostare gli assi.
note-tolerance-on-arcs = La tolleranza definita nel ciclo ha effetto anche sui movimenti su archi di cerchio.
note-chord-error-of-cam = Il fattore che più influisce sulla generazione di programmi NC con un sistema CAM è l’errore cordale S che vi si può definire e che determina la massima distanza dei punti di un programma NC generato da un postprocessor. Se l’errore cordale è uguale o minore del valore di tolleranza T del ciclo, il controllo può lisciare i punti del profilo, a meno che impostazioni speciali della macchina limitino l’avanzamento programmato.
note-best-smoothing = La lisciatura è ottimale se il valore di tolleranza nel ciclo è compreso tra 1,1 e 2 volte l’errore cordale del sistema CAM.
note-very-small-tolerance = Con valori di tolleranza molto piccoli la macchina non può più lavorare il profilo senza strappi. La causa non è una carenza di potenza di calcolo del controllo, che raggiunge le transizioni del profilo quasi esattamente e deve eventualmente ridurre notevolmente la velocità di spostamento.
note-tolerance-is-def-active = Il ciclo è attivo non appena è definito nel programma.
note-reset-tolerance = Il controllo annulla il ciclo se il ciclo viene ridefinito e si risponde con NO ENT alla domanda sul valore di tolleranza, oppure se viene selezionato un nuovo programma con il tasto PGM MGT. Dopo l’annullamento è di nuovo attiva la tolleranza preimpostata con il parametro macchina.
note-unit-of-tolerance = Il controllo interpreta il valore di tolleranza T inserito in millimetri in un programma in millimetri, in pollici in un programma in pollici.
note-tolerance-alone-adds-zeros = Se viene caricato un programma che contiene come parametro del ciclo solo il valore di tolleranza T, il controllo aggiunge se necessario gli altri due parametri con il valore 0.
note-tolerance-changes-circle-diameter = All’aumentare della tolleranza il diametro dei movimenti circolari di regola diminuisce. Se sulla macchina è attivo un filtro HSC (chiedere eventualmente al costruttore della macchina), il cerchio può anche diventare più grande.
note-tolerance-in-status-display = Se il ciclo è attivo, l’indicazione di stato supplementare ne visualizza i parametri nella scheda CYC.
