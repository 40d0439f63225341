# Cycles that measure the tool: radius, complete tool, calibration of the tool touch probe.

# --- parameters ---
help-tool-check-radius = Definire se l’utensile viene misurato per la prima volta o se viene verificato un utensile già misurato. Alla prima misurazione il raggio utensile { $mp-tool-radius } nella memoria utensili centrale TOOL.T viene sovrascritto e il valore delta { $mp-delta-radius } impostato a 0. La verifica confronta il raggio misurato con il raggio utensile { $mp-tool-radius }; lo scostamento viene registrato con il suo segno come valore delta { $mp-delta-radius } ed è disponibile anche in Q116. Se il valore delta supera la tolleranza di usura o di rottura ammessa per il raggio utensile, il controllo blocca l’utensile (stato L in TOOL.T).
help-tool-check-complete = Definire se l’utensile viene misurato per la prima volta o se viene verificato un utensile già misurato. Alla prima misurazione il raggio utensile { $mp-tool-radius } e la lunghezza utensile { $mp-tool-length } nella memoria utensili centrale TOOL.T vengono sovrascritti e i valori delta { $mp-delta-radius } e { $mp-delta-length } impostati a 0. La verifica confronta i dati misurati con quelli della memoria utensili; gli scostamenti vengono registrati con il loro segno come valori delta { $mp-delta-radius } e { $mp-delta-length } e sono disponibili anche in Q115 e Q116. Se uno dei valori delta supera la tolleranza di usura o di rottura ammessa, il controllo blocca l’utensile (stato L in TOOL.T).
help-additional-tooth-measurement = Definire se viene eseguita anche la misurazione dei singoli taglienti. È possibile misurare al massimo 20 taglienti.
help-additional-tooth-measurement__itnc530 = Definire se viene eseguita anche la misurazione dei singoli taglienti. È possibile misurare al massimo 99 taglienti.
help-additional-tooth-measurement__tnc426-430 = Definire se viene eseguita anche la misurazione dei singoli taglienti.
help-calibration-tool-height = Posizione nell’asse del mandrino che esclude qualsiasi collisione dell’utensile di calibrazione con pezzi o dispositivi di bloccaggio. Si riferisce all’origine attiva del pezzo. Se con questo valore la punta dell’utensile di calibrazione venisse a trovarsi al di sotto del bordo superiore del piatto, il controllo lo posiziona automaticamente sopra il piatto (zona di sicurezza definita in { $mp-setter-safety-distance }).
parameter-tool-check__tool-radius =
    .help = { help-tool-check-radius }
parameter-tool-check__tool-radius-old =
    .help = { help-tool-check-radius }
parameter-tool-check__tool-complete =
    .help = { help-tool-check-complete }
parameter-tool-check__tool-complete-old =
    .help = { help-tool-check-complete }
parameter-tooth-measurement__tool-radius =
    .help = { help-additional-tooth-measurement }
parameter-tooth-measurement__tool-radius__itnc530 = TASTATURA TAGLIENTI? 0=NO/1=SI
    .prompt = TASTATURA TAGLIENTI? 0=NO/1=SI
parameter-tooth-measurement__tool-radius-old =
    .help = { help-additional-tooth-measurement }
parameter-tooth-measurement__tool-radius-old__itnc530 = TASTATURA TAGLIENTI? 0=NO/1=SI
    .prompt = TASTATURA TAGLIENTI? 0=NO/1=SI
parameter-tooth-measurement__tool-complete =
    .help = { help-additional-tooth-measurement }
parameter-tooth-measurement__tool-complete__itnc530 = TASTATURA TAGLIENTI? 0=NO/1=SI
    .prompt = TASTATURA TAGLIENTI? 0=NO/1=SI
parameter-tooth-measurement__tool-complete-old =
    .help = { help-additional-tooth-measurement }
parameter-tooth-measurement__tool-complete-old__itnc530 = TASTATURA TAGLIENTI? 0=NO/1=SI
    .prompt = TASTATURA TAGLIENTI? 0=NO/1=SI
parameter-tool-status-parameter__tool-radius-old =
    .help = Numero del parametro in cui il controllo memorizza lo stato della misurazione: 0,0: utensile in tolleranza; 1,0: utensile usurato (superato il valore { $mp-wear-tolerance-radius }); 2,0: utensile rotto (superato il valore { $mp-break-tolerance-radius }). Se il risultato non viene elaborato nel programma, rispondere alla domanda con NO ENT.
parameter-tool-status-parameter__tool-complete-old =
    .help = Numero del parametro in cui il controllo memorizza lo stato della misurazione: 0,0: utensile in tolleranza; 1,0: utensile usurato (superato il valore { $mp-wear-tolerance-length } e/o { $mp-wear-tolerance-radius }); 2,0: utensile rotto (superato il valore { $mp-break-tolerance-length } e/o { $mp-break-tolerance-radius }). Se il risultato non viene elaborato nel programma, rispondere alla domanda con NO ENT.
parameter-tool-clearance-height__calibrate-tool-probe =
    .help = { help-calibration-tool-height }
parameter-tool-clearance-height__calibrate-tool-probe-old =
    .help = { help-calibration-tool-height }

# --- 32 and 482 ---
cycle-tool-radius = Misurazione raggio utensile
    .nc = RAGGIO UTENSILE
    .purpose = Misura o verifica il raggio dell’utensile con il sistema di tastatura TT: con utensile rotante, oppure con utensile rotante e poi singolarmente per ogni tagliente. Il controllo memorizza il risultato nella memoria utensili centrale TOOL.T e ne tiene conto automaticamente al termine del ciclo.
cycle-tool-radius__tnc426-430 =
    .purpose = Misura o verifica il raggio dell’utensile con il sistema di tastatura TT: con utensile rotante, oppure con utensile rotante e poi singolarmente per ogni tagliente. Il controllo memorizza il risultato nella memoria utensili centrale TOOL.T e lo utilizza alla successiva chiamata utensile.
cycle-tool-radius-old = Misurazione raggio utensile
    .nc = RAGGIO UTENSILE
    .purpose = Misura o verifica il raggio dell’utensile con il sistema di tastatura TT: con utensile rotante, oppure con utensile rotante e poi singolarmente per ogni tagliente. Il controllo memorizza il risultato nella memoria utensili centrale TOOL.T e ne tiene conto automaticamente al termine del ciclo. Vecchio formato del ciclo 482.
cycle-tool-radius-old__tnc426-430 =
    .purpose = Misura o verifica il raggio dell’utensile con il sistema di tastatura TT: con utensile rotante, oppure con utensile rotante e poi singolarmente per ogni tagliente. Il controllo memorizza il risultato nella memoria utensili centrale TOOL.T e lo utilizza alla successiva chiamata utensile. Vecchio formato del ciclo 482.
step-position-tool-beside-setter = Il controllo posiziona l’utensile a lato dell’elemento di tastatura, con la superficie frontale al di sotto del bordo superiore dell’elemento, alla distanza definita in { $mp-setter-axis-offset } più, se inserito nella tabella utensili, l’offset di lunghezza supplementare { $mp-setter-offset-length }.
step-probe-rotating-tool-radially = Il controllo tasta radialmente l’utensile rotante.
step-measure-teeth-radially = Il controllo determina il raggio:
say-measure-radii-of-teeth = con { $q-tooth-measurement }=1 misura poi i raggi di tutti i taglienti mediante orientamento del mandrino
say-radius-of-rotating-tool = con { $q-tooth-measurement }=0 il raggio risulta dalla misurazione con utensile rotante
step-store-tool-radius = Il controllo memorizza il risultato:
say-overwrite-tool-radius = con { $q-tool-check }=0 sovrascrive il raggio utensile { $mp-tool-radius } in TOOL.T e imposta il valore delta { $mp-delta-radius } a 0
say-enter-delta-radius = con { $q-tool-check }=1 confronta il raggio misurato con il raggio utensile { $mp-tool-radius }, registra lo scostamento con il suo segno come valore delta { $mp-delta-radius } e in Q116 e blocca l’utensile (stato L) se la tolleranza di usura o di rottura è superata
result-tool-radius-deviation = Scostamento del raggio utensile
note-diamond-coated-cylinders = Gli utensili cilindrici diamantati si possono misurare a mandrino fermo. A tale scopo impostare a 0 il numero dei taglienti { $mp-teeth } nella tabella utensili e adattare il parametro macchina { $mp-tool-measurement-config }. Consultare il manuale della macchina.
note-diamond-coated-cylinders__itnc530 = Gli utensili cilindrici diamantati si possono misurare a mandrino fermo. A tale scopo impostare a 0 il numero dei taglienti { $mp-teeth } nella tabella utensili e adattare il parametro macchina { $mp-calibration-behaviour }. Consultare il manuale della macchina.
note-two-ways-to-measure-tool = L’utensile può essere misurato in due modi: con utensile rotante, oppure con utensile rotante e poi singolarmente per ogni tagliente.

# --- 33 and 483 ---
cycle-tool-complete = Misurazione utensile completa
    .nc = MISURARE UTENSILE
    .purpose = Misura o verifica la lunghezza e il raggio dell’utensile con il sistema di tastatura TT: con utensile rotante, oppure con utensile rotante e poi singolarmente per ogni tagliente. Il controllo memorizza i risultati nella memoria utensili centrale TOOL.T e ne tiene conto automaticamente al termine del ciclo.
cycle-tool-complete__tnc426-430 =
    .purpose = Misura o verifica la lunghezza e il raggio dell’utensile con il sistema di tastatura TT: con utensile rotante, oppure con utensile rotante e poi singolarmente per ogni tagliente. Il controllo memorizza i risultati nella memoria utensili centrale TOOL.T e li utilizza alla successiva chiamata utensile.
cycle-tool-complete-old = Misurazione utensile completa
    .nc = MISURARE UTENSILE
    .purpose = Misura o verifica la lunghezza e il raggio dell’utensile con il sistema di tastatura TT: con utensile rotante, oppure con utensile rotante e poi singolarmente per ogni tagliente. Il controllo memorizza i risultati nella memoria utensili centrale TOOL.T e ne tiene conto automaticamente al termine del ciclo. Vecchio formato del ciclo 483.
cycle-tool-complete-old__tnc426-430 =
    .purpose = Misura o verifica la lunghezza e il raggio dell’utensile con il sistema di tastatura TT: con utensile rotante, oppure con utensile rotante e poi singolarmente per ogni tagliente. Il controllo memorizza i risultati nella memoria utensili centrale TOOL.T e li utilizza alla successiva chiamata utensile. Vecchio formato del ciclo 483.
step-measure-radius-first = Il controllo misura l’utensile in una sequenza fissa. Dapprima misura il raggio, come i cicli 32 e 482: posiziona l’utensile a lato dell’elemento di tastatura, con la superficie frontale al di sotto del bordo superiore dell’elemento (valori { $mp-setter-axis-offset } e { $mp-setter-offset-length }), e tasta radialmente l’utensile rotante.
step-then-measure-length = Poi misura la lunghezza, come i cicli 31 e 481:
step-store-radius-and-length = Il controllo memorizza i risultati:
say-overwrite-radius-and-length = con { $q-tool-check }=0 sovrascrive il raggio utensile { $mp-tool-radius } e la lunghezza utensile { $mp-tool-length } in TOOL.T e imposta i valori delta { $mp-delta-radius } e { $mp-delta-length } a 0
say-enter-both-delta-values = con { $q-tool-check }=1 confronta i dati misurati con quelli di TOOL.T, registra gli scostamenti con il loro segno come valori delta { $mp-delta-radius } e { $mp-delta-length } e in Q116 (raggio) e Q115 (lunghezza) e blocca l’utensile (stato L) se una tolleranza di usura o di rottura è superata
note-complete-measurement-saves-time = Il ciclo è utile soprattutto per misurare utensili la prima volta: rispetto alla misurazione separata di lunghezza e raggio fa risparmiare molto tempo.
title-first-measurement-rotating = Prima misurazione con utensile rotante
title-check-teeth = Verifica con misurazione dei singoli taglienti

# --- 30 and 480 ---
cycle-calibrate-tool-probe = Calibrazione TT
    .nc = CALIBRAZIONE TT
    .purpose = Calibra automaticamente il sistema di tastatura TT con un utensile di calibrazione cilindrico. Il controllo determina anche l’offset centrale dell’utensile di calibrazione. Memorizza i valori di calibrazione e li considera nelle successive misurazioni degli utensili.
cycle-calibrate-tool-probe-old = Calibrazione TT
    .nc = CALIBRAZIONE TT
    .purpose = Calibra automaticamente il sistema di tastatura TT con un utensile di calibrazione cilindrico. Il controllo determina anche l’offset centrale dell’utensile di calibrazione. Memorizza i valori di calibrazione e li considera nelle successive misurazioni degli utensili. Vecchio formato del ciclo 480.
guard-tool-call-missing__calibrate-tool-probe = Non è stato chiamato alcun utensile. Chiamare l’utensile di calibrazione con TOOL CALL.
guard-tool-call-missing__calibrate-tool-probe-old = Non è stato chiamato alcun utensile. Chiamare l’utensile di calibrazione con TOOL CALL.
step-position-calibration-tool-over-setter = Il controllo posiziona l’utensile di calibrazione all’altezza di sicurezza { $q-tool-clearance-height }, ma non al di sotto della zona di sicurezza { $mp-setter-safety-distance } sopra il piatto.
step-calibrate-tool-probe = Il controllo calibra automaticamente il sistema di tastatura con l’utensile di calibrazione.
step-turn-spindle-for-centre-misalignment = A metà della calibrazione il controllo ruota il mandrino di 180°. In questo modo determina anche l’offset centrale dell’utensile di calibrazione.
step-store-tool-probe-calibration = Il controllo memorizza i valori di calibrazione e ne tiene conto nelle misurazioni degli utensili che seguono.
note-enter-calibration-tool-data = Prima della calibrazione inserire nella tabella utensili TOOL.T il raggio esatto e la lunghezza esatta dell’utensile di calibrazione.
note-cylindrical-calibration-tool = Come utensile di calibrazione utilizzare un pezzo esattamente cilindrico, ad esempio una spina cilindrica.
note-calibration-tool-size = Il diametro dell’utensile di calibrazione dovrebbe essere maggiore di 15 mm e l’utensile dovrebbe sporgere di circa 50 mm dal mandrino di serraggio. Una forza di tastatura di 1 N lo flette così di 0,1 µm.
note-tool-probe-position-known = La posizione del sistema di tastatura nell’area di lavoro della macchina deve essere definita nei parametri macchina { $mp-setter-centre } > da [0] a [2].
note-tool-probe-position-known__itnc530 = La posizione del sistema di tastatura nell’area di lavoro della macchina deve essere definita nei parametri macchina da { $mp-setter-centre }.0 a { $mp-setter-centre }.2.
note-tool-probe-position-known__tnc426-430 = La posizione del sistema di tastatura nell’area di lavoro della macchina deve essere definita nei parametri macchina da { $mp-setter-centre }.0 a { $mp-setter-centre }.2.
note-recalibrate-after-position-data-change = Dopo una modifica di uno dei parametri macchina { $mp-setter-centre } > da [0] a [2] ripetere la calibrazione.
note-recalibrate-after-position-data-change__itnc530 = Dopo una modifica di uno dei parametri macchina da { $mp-setter-centre }.0 a { $mp-setter-centre }.2 ripetere la calibrazione.
note-recalibrate-after-position-data-change__tnc426-430 = Dopo una modifica di uno dei parametri macchina da { $mp-setter-centre }.0 a { $mp-setter-centre }.2 ripetere la calibrazione.
note-keep-fixtures-off-tool-probe = Durante la calibrazione assicurarsi che intorno al sistema di tastatura non siano serrati dispositivi di bloccaggio. Consiglio: lasciare libero uno spazio pari al doppio del diametro dell’utensile di calibrazione.
note-calibration-cycle-behaviour = Il funzionamento del ciclo di calibrazione dipende dal parametro macchina { $mp-tool-measurement-config }. Consultare il manuale della macchina.
note-calibration-cycle-behaviour__tnc320 = Il funzionamento del ciclo di calibrazione è definito dal costruttore della macchina. Consultare il manuale della macchina.
note-calibration-cycle-behaviour__itnc530 = Il funzionamento del ciclo di calibrazione dipende dal parametro macchina { $mp-calibration-behaviour }. Consultare il manuale della macchina.
note-calibration-cycle-behaviour__tnc426-430 = Il funzionamento del ciclo di calibrazione dipende dal parametro macchina { $mp-calibration-behaviour }. Consultare il manuale della macchina.

# --- 484 ---
cycle-calibrate-wireless-tool-probe = Calibrazione TT 449 senza cavo
    .nc = CALIBRAZIONE TT 449 SENZA CAVO
    .purpose = Calibra il sistema di tastatura TT 449, a infrarossi e senza cavo. La procedura è semiautomatica, poiché la posizione del sistema di tastatura sulla tavola della macchina non è definita. Il controllo determina anche l’offset centrale dell’utensile di calibrazione, memorizza i valori di calibrazione e li considera nelle successive misurazioni degli utensili.
step-insert-calibration-tool = Inserire l’utensile di calibrazione.
step-define-and-start-calibration = Definire e avviare il ciclo di calibrazione.
step-position-calibration-tool-by-hand = Posizionare manualmente l’utensile di calibrazione sopra il centro del sistema di tastatura e seguire le istruzioni della finestra in primo piano. Assicurarsi che l’utensile di calibrazione si trovi sopra la superficie di misura dell’elemento di tastatura.
step-calibrate-wireless-tool-probe = Il controllo calibra in modo semiautomatico il sistema di tastatura con l’utensile di calibrazione.
message-calibration-tool-over-setter = Posizionare l’utensile di calibrazione sopra il centro del sistema di tastatura e proseguire.
note-wireless-calibration-by-hand = La calibrazione non è completamente automatica, poiché la posizione del sistema di tastatura sulla tavola della macchina non è definita.
note-recalibrate-after-move = Se la posizione del sistema di tastatura sulla tavola cambia, ripetere la calibrazione.
note-calibration-tool-size__tnc640 = Il diametro dell’utensile di calibrazione deve essere maggiore di 15 mm e l’utensile deve sporgere di 50 mm dal mandrino di serraggio. Una forza di tastatura di 1 N lo flette così di 0,1 µm.
guard-tool-call-missing__calibrate-wireless-tool-probe = Non è stato chiamato alcun utensile. Chiamare l’utensile di calibrazione con TOOL CALL.
