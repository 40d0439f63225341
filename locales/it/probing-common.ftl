# What several touch-probe cycles share; see the English file.

# --- run ---
step-position-at-first-touch-point = Il controllo posiziona il sistema di tastatura sul primo punto di tastatura, in rapido (valore della colonna { $mp-positioning-feed }) e con logica di posizionamento. Calcola i punti di tastatura dai dati inseriti nel ciclo e dalla distanza di sicurezza della colonna { $mp-set-up }.
step-position-at-first-touch-point__tnc426-430 = Il controllo posiziona il sistema di tastatura sul primo punto di tastatura, in rapido (valore di { $mp-positioning-feed } o { $mp-analog-positioning-feed }) e con logica di posizionamento. Calcola i punti di tastatura dai dati inseriti nel ciclo e dalla distanza di sicurezza di { $mp-set-up }.
step-move-to-measuring-height = Il sistema di tastatura si porta all’altezza di misura { $q-measuring-height }.
step-probe-outward = Il sistema di tastatura esegue una tastatura con l’avanzamento di tastatura (colonna { $mp-probing-feed }). Il controllo determina la direzione di tastatura dall’angolo di partenza { $q-probing-starting-angle } e dall’angolo incrementale { $q-probing-stepping-angle }.
step-probe-outward__tnc426-430 = Il sistema di tastatura esegue una tastatura con l’avanzamento di tastatura ({ $mp-probing-feed } o { $mp-analog-probing-feed }). Il controllo determina la direzione di tastatura dall’angolo di partenza { $q-probing-starting-angle } e dall’angolo incrementale { $q-probing-stepping-angle }.
step-travel-to-next-touch-point = Il sistema di tastatura si porta al punto di tastatura successivo:
say-start-again-from-centre = se la tasca e la distanza di sicurezza non lasciano spazio per un preposizionamento vicino ai punti di tastatura, rimane al centro e non si porta all’altezza di sicurezza
say-travel-straight-at-clearance-height = con { $q-traverse-to-clearance-height }=1 e { $q-probing-traverse-type }=0 su una retta all’altezza di sicurezza { $q-clearance-height }
say-travel-on-circle-at-clearance-height = con { $q-traverse-to-clearance-height }=1 su un arco di cerchio all’altezza di sicurezza { $q-clearance-height }
say-travel-on-circle-at-clearance-height__tnc640 = con { $q-traverse-to-clearance-height }=1 e { $q-probing-traverse-type }=1 su un arco di cerchio all’altezza di sicurezza { $q-clearance-height }
say-travel-on-circle-at-measuring-height = con { $q-traverse-to-clearance-height }=0 su un arco di cerchio all’altezza di misura { $q-measuring-height }
until-all-touch-points-probed = non sono stati tastati tutti i punti di tastatura

# --- conditions ---
condition-travel-at-clearance-height = il sistema di tastatura si sposta all’altezza di sicurezza ({ $q-traverse-to-clearance-height }=1)
condition-probe-axis-wanted = { $q-probing-in-probe-axis }=1

# --- guards ---
guard-probe-axis-undefined = Prima della definizione del ciclo manca una chiamata utensile, perciò l’asse del tastatore non è definito.
guard-transformation-active = È attiva la lavorazione speculare, un fattore di scala o un fattore di scala specifico per asse. Nessuna di queste funzioni può essere attiva durante un ciclo di tastatura.
guard-basic-rotation-active = È attiva una rotazione base. Questo ciclo non può essere eseguito con una rotazione base.
guard-stepping-angle-too-small = L’angolo incrementale { $q-probing-stepping-angle } è minore di 5°.
guard-tolerance-exceeded = Una tolleranza è stata superata.
guard-tool-broken = Lo scostamento è maggiore della tolleranza di rottura dell’utensile. L’utensile viene bloccato.

# --- notes: probing in general ---
note-positioning-logic = Logica di posizionamento: se il polo sud dello stilo si trova al di sotto dell’altezza di sicurezza { $q-clearance-height }, il controllo ritrae dapprima il sistema di tastatura nell’asse del tastatore all’altezza di sicurezza e lo posiziona poi nel piano di lavoro sul primo punto di tastatura. Se si trova al di sopra dell’altezza di sicurezza, il controllo posiziona dapprima il sistema di tastatura nel piano di lavoro sul primo punto di tastatura e lo porta poi nell’asse del tastatore direttamente all’altezza di misura { $q-measuring-height }.
note-tool-call-before-definition = Prima della definizione del ciclo programmare una chiamata utensile che definisca l’asse del tastatore.
note-no-mirror-or-scaling-while-probing = Durante l’esecuzione dei cicli di tastatura non devono essere attivi la lavorazione speculare (ciclo 8), il fattore di scala (ciclo 11) e il fattore di scala specifico per asse (ciclo 26).
note-transformations-while-probing = Durante l’esecuzione dei cicli di tastatura non deve essere attivo alcun ciclo di conversione di coordinate: spostamento origine (7), lavorazione speculare (8), rotazione (10), fattore di scala (11 e 26), rotazione del piano di lavoro (19).
note-heidenhain-probes-only = Il funzionamento dei cicli di tastatura è garantito solo con sistemi di tastatura HEIDENHAIN.
note-prepare-for-3d-probes = Il controllo deve essere predisposto dal costruttore della macchina per l’impiego di sistemi di tastatura 3D. Consultare il manuale della macchina.
note-compensation-data-for-probing = Assicurarsi che i dati di correzione (lunghezza, raggio) all’inizio del ciclo siano quelli desiderati: i dati di calibrazione oppure i dati dell’ultimo blocco TOOL CALL. La scelta avviene con { $mp-calibration-data-source }.
note-no-contact-within-distance = Se lo stilo non viene deflesso entro il percorso { $mp-probing-distance }, il controllo visualizza un messaggio d’errore.
note-set-up-is-pre-position = { $mp-set-up } è la distanza dal punto di tastatura alla quale il controllo preposiziona il sistema di tastatura. Quanto minore è questa distanza, tanto maggiore deve essere la precisione con cui vengono definiti i punti di tastatura.
note-track-orients-probe = Con { $mp-track } = ON il controllo orienta un sistema di tastatura a infrarossi nella direzione di tastatura programmata prima di ogni tastatura, in modo che lo stilo venga sempre deflesso nella stessa direzione; ciò aumenta la precisione di misura. Dopo una modifica di { $mp-track } calibrare di nuovo il sistema di tastatura.
note-pre-positioning-speed = { $mp-pre-positioning } determina la velocità di preposizionamento: FMAX_PROBE è l’avanzamento della colonna { $mp-positioning-feed }, FMAX_MACHINE il rapido della macchina.
note-multiple-measurement = Per aumentare l’affidabilità delle misurazioni il controllo può eseguire ogni tastatura fino a tre volte in successione; il numero delle misurazioni e il campo di confidenza sono definiti dai parametri macchina in { $mp-probe-settings } (comportamento di tastatura, funzionamento automatico). Se i valori misurati differiscono tra loro più del campo di confidenza, il controllo visualizza un messaggio d’errore, altrimenti ne memorizza il valore medio. In questo modo si possono rilevare errori di misura dovuti ad esempio allo sporco.
note-multiple-measurement__tnc426-430 = Per aumentare l’affidabilità delle misurazioni il controllo può eseguire ogni tastatura fino a tre volte in successione; { $mp-multiple-measurement } ne definisce il numero, { $mp-confidence-range } il campo di confidenza. Se i valori misurati differiscono tra loro più del campo di confidenza, il controllo visualizza un messaggio d’errore, altrimenti ne memorizza il valore medio. In questo modo si possono rilevare errori di misura dovuti ad esempio allo sporco.
note-step-below-90-for-arcs = Per misurare un arco di cerchio invece di un cerchio completo, programmare un angolo incrementale { $q-probing-stepping-angle } minore di 90°.
note-smallest-stepping-angle = Quanto più piccolo è l’angolo incrementale { $q-probing-stepping-angle }, tanto meno precisa è l’origine calcolata dal controllo. Valore minimo di immissione: 5°.
note-smallest-stepping-angle__measure-hole = Quanto più piccolo è l’angolo incrementale { $q-probing-stepping-angle }, tanto meno precise sono le dimensioni del foro calcolate dal controllo. Valore minimo di immissione: 5°.
note-small-stepping-angle-less-exact = Quanto più piccolo è l’angolo incrementale { $q-probing-stepping-angle }, tanto meno preciso è il centro calcolato dal controllo.
note-small-stepping-angle-less-exact__datum-inside-circle = Quanto più piccolo è l’angolo incrementale { $q-probing-stepping-angle }, tanto meno precisa è l’origine calcolata dal controllo.
note-results-in-active-system = Il controllo fornisce tutti i risultati, nei parametri di risultato e nel file di protocollo, nel sistema di coordinate attivo, che può essere spostato, ruotato o inclinato.
note-results-in-active-system__tnc320 = Il controllo fornisce tutti i risultati, nei parametri di risultato e nel file di protocollo, nel sistema di coordinate attivo, che può essere spostato e/o ruotato.
note-results-in-active-system__tnc426-430 = Il controllo fornisce tutti i risultati, nei parametri di risultato e nel file di protocollo, nel sistema di coordinate attivo, che può essere spostato.
note-results-in-q-parameters = Il controllo memorizza i risultati di misura nei parametri Q globali da Q150 a Q160, che possono essere utilizzati nel seguito del programma.
note-deviations-in-q-parameters = Il controllo memorizza i risultati di misura nei parametri Q globali da Q150 a Q160 e gli scostamenti dai valori nominali nei parametri da Q161 a Q166. Durante la definizione del ciclo la grafica di supporto visualizza anche i parametri di risultato; quello evidenziato appartiene al parametro di immissione selezionato.
note-deviations-in-q-parameters__tnc426-430 = Il controllo memorizza i risultati di misura nei parametri Q globali da Q150 a Q160 e gli scostamenti dai valori nominali nei parametri da Q161 a Q166. Durante la definizione del ciclo la grafica di supporto visualizza anche i parametri di risultato.

# --- results ---
result-centre-main-actual = Valore reale centro asse principale
result-centre-minor-actual = Valore reale centro asse secondario
result-diameter-actual = Valore reale diametro
