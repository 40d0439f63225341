# Cycles that measure the tool on a tool touch probe; see the English file.

# --- parameters ---
parameter-tool-check = Misura=0/verifica utensile=1
    .label = VERIFICA
    .word = VERIFICA:
    .prompt = Misura=0/verifica utensile=1
    .help = Definire se si tratta della prima misurazione dell’utensile o della verifica di un utensile già misurato. Alla prima misurazione la lunghezza utensile { $mp-tool-length } in TOOL.T, la memoria utensili centrale, viene sovrascritta e il valore delta { $mp-delta-length } impostato a 0. La verifica confronta la lunghezza misurata con la lunghezza utensile { $mp-tool-length }; lo scostamento viene registrato con il suo segno come valore delta { $mp-delta-length } ed è disponibile anche in Q115. Oltre la tolleranza di usura o di rottura ammessa per la lunghezza il controllo blocca l’utensile (stato L in TOOL.T).
parameter-tool-check__itnc530 = MISURA=0/VERIFICA UTENSILE=1
    .prompt = MISURA=0/VERIFICA UTENSILE=1
choice-tool-first-measurement = misurare l’utensile per la prima volta
choice-tool-check = verificare un utensile già misurato
parameter-tool-status-parameter = Nr. parametro per risultato?
    .prompt = Nr. parametro per risultato?
    .help = Numero del parametro in cui il controllo memorizza lo stato della misurazione: 0,0: utensile in tolleranza; 1,0: utensile usurato (superato il valore { $mp-wear-tolerance-length }); 2,0: utensile rotto (superato il valore { $mp-break-tolerance-length }). Se il risultato non viene elaborato nel programma, rispondere alla domanda con NO ENT.
parameter-tool-status-parameter__itnc530 = NR. PARAMETRO PER RISULTATO?
    .prompt = NR. PARAMETRO PER RISULTATO?
parameter-tool-clearance-height = Altezza di sicurezza
    .label = ALTEZZA DI SICUREZZA
    .word = ALT.:
    .prompt = Altezza di sicurezza
    .help = Posizione nell’asse del mandrino che esclude qualsiasi collisione dell’utensile con pezzi o dispositivi di bloccaggio. Si riferisce all’origine attiva del pezzo. Se con questo valore la punta dell’utensile venisse a trovarsi al di sotto del bordo superiore del piatto, il controllo posiziona automaticamente l’utensile sopra il piatto (zona di sicurezza definita in { $mp-setter-safety-distance }).
parameter-tool-clearance-height__itnc530 = ALTEZZA DI SICUREZZA
    .prompt = ALTEZZA DI SICUREZZA
parameter-tooth-measurement = Tastatura taglienti? 0=No/1=Sì
    .label = TASTATURA TAGLIENTI
    .word = TASTATURA TAGLIENTI:
    .prompt = Tastatura taglienti? 0=No/1=Sì
    .help = Definire se viene eseguita la misurazione dei singoli taglienti. È possibile misurare al massimo 20 taglienti.
parameter-tooth-measurement__itnc530 = TASTATURA TAGLIENTI? 0=No/1=Si
    .prompt = TASTATURA TAGLIENTI? 0=No/1=Si
    .help = Definire se viene eseguita la misurazione dei singoli taglienti. È possibile misurare al massimo 99 taglienti.
parameter-tooth-measurement__tnc426-430 =
    .help = Definire se viene eseguita la misurazione dei singoli taglienti.
choice-no-tooth-measurement = senza misurazione dei singoli taglienti
choice-tooth-measurement = con misurazione dei singoli taglienti

# --- 31 and 481 ---
cycle-tool-length = Misurazione lunghezza utensile
    .nc = LUNGHEZZA UTENSILE
    .purpose = Misura o verifica la lunghezza dell’utensile con il sistema di tastatura TT. Il controllo memorizza il risultato nella memoria utensili centrale TOOL.T e ne tiene conto automaticamente al termine del ciclo.
cycle-tool-length__tnc426-430 =
    .purpose = Misura o verifica la lunghezza dell’utensile con il sistema di tastatura TT. Il controllo memorizza il risultato nella memoria utensili centrale TOOL.T e lo utilizza alla successiva chiamata utensile.
cycle-tool-length-old = Misurazione lunghezza utensile
    .nc = LUNGHEZZA UTENSILE
    .purpose = Misura o verifica la lunghezza dell’utensile con il sistema di tastatura TT. Il controllo memorizza il risultato nella memoria utensili centrale TOOL.T e ne tiene conto automaticamente al termine del ciclo. Vecchio formato del ciclo 481.
cycle-tool-length-old__tnc426-430 =
    .purpose = Misura o verifica la lunghezza dell’utensile con il sistema di tastatura TT. Il controllo memorizza il risultato nella memoria utensili centrale TOOL.T e lo utilizza alla successiva chiamata utensile. Vecchio formato del ciclo 481.
step-position-tool-over-setter = Il controllo posiziona l’utensile all’altezza di sicurezza { $q-tool-clearance-height }, ma non al di sotto della zona di sicurezza sopra il piatto.
step-touch-tool-setter = Il controllo misura la lunghezza:
say-measure-tooth-by-tooth = con { $q-tooth-measurement }=1, singolarmente per ogni tagliente: l’utensile viene posizionato a lato dell’elemento di tastatura, con la superficie frontale al di sotto del bordo superiore dell’elemento, alla distanza definita in { $mp-setter-axis-offset } più l’offset di lunghezza supplementare { $mp-setter-offset-length }, se inserito nella tabella utensili. Il controllo tasta radialmente l’utensile rotante per determinare l’angolo di partenza e cambia poi l’orientamento del mandrino per misurare tutti i taglienti in lunghezza
say-measure-rotating-or-stationary = negli altri casi, in base al diametro dell’utensile. Se il diametro è maggiore della superficie di misura, il controllo misura l’utensile rotante: lo sposta di { $mp-setter-offset-radius } (tabella utensili) rispetto al centro del sistema di tastatura e lo porta in rotazione sulla superficie di misura, in modo da rilevare il tagliente più lungo. Se il diametro è inferiore, oppure per punte e frese a raggio frontale, misura l’utensile fermo: lo porta al centro sopra la superficie di misura e poi, a mandrino fermo, sulla superficie; a tale scopo { $mp-setter-offset-radius } nella tabella utensili deve essere 0
step-store-tool-length = Il controllo memorizza il risultato:
say-overwrite-tool-length = con { $q-tool-check }=0 sovrascrive la lunghezza utensile { $mp-tool-length } in TOOL.T e imposta il valore delta { $mp-delta-length } a 0
say-enter-delta-length = con { $q-tool-check }=1 confronta la lunghezza misurata con la lunghezza utensile { $mp-tool-length }, registra lo scostamento con il suo segno come valore delta { $mp-delta-length } e in Q115 e blocca l’utensile (stato L) se la tolleranza di usura o di rottura è superata
result-tool-length-deviation = Scostamento della lunghezza utensile
result-tool-status = Stato della misurazione: 0,0 = in tolleranza, 1,0 = usurato, 2,0 = rotto
guard-tool-call-missing = Non è stato chiamato alcun utensile. Chiamare l’utensile da misurare con TOOL CALL.
note-enter-tool-data-first = Prima di misurare un utensile per la prima volta, inserire nella tabella utensili TOOL.T numero dei taglienti, direzione di taglio e valori approssimativi di raggio e lunghezza.
note-most-teeth-measurable = La misurazione dei singoli taglienti è possibile per utensili con un massimo di 20 taglienti.
note-most-teeth-measurable__itnc530 = La misurazione dei singoli taglienti è possibile per utensili con un massimo di 99 taglienti. L’indicazione di stato visualizza i valori di un massimo di 24 taglienti.
note-tool-table-must-be-active = I cicli di misura funzionano solo se la memoria utensili centrale TOOL.T è attiva.
note-tool-call-before-tool-measurement = Prima di utilizzare i cicli di misura, tutti i dati richiesti per la misurazione devono essere inseriti nella memoria utensili centrale e l’utensile in questione deve essere chiamato con TOOL CALL.
note-three-ways-to-measure-length = La lunghezza può essere misurata in tre modi: con utensile rotante, se il suo diametro è maggiore della superficie di misura del sistema di tastatura; con utensile fermo, se il suo diametro è inferiore o per punte e frese a raggio frontale; singolarmente per ogni tagliente con utensile fermo, se il suo diametro è maggiore della superficie di misura.
note-tool-measurement-feed-and-speed = Con utensile fermo il controllo utilizza l’avanzamento di tastatura di { $mp-stationary-probing-feed }. Con utensile rotante calcola il numero di giri del mandrino n = { $mp-max-peripheral-speed } / (r · 0,0063) in giri/min dalla velocità periferica massima ammessa in m/min e dal raggio utensile attivo r in mm, e l’avanzamento di tastatura v = tolleranza di misura · n in mm/min.
note-tool-measurement-tolerance = { $mp-probing-feed-calculation } determina la tolleranza di misura. ConstantTolerance: rimane costante, perciò l’avanzamento di utensili molto grandi scende a zero, tanto prima quanto più piccoli sono { $mp-max-peripheral-speed } e { $mp-measuring-tolerance }. VariableTolerance: è pari a { $mp-measuring-tolerance } per raggi utensile fino a 30 mm, al doppio fino a 60 mm, al triplo fino a 90 mm, al quadruplo fino a 120 mm. ConstantFeed: l’avanzamento rimane costante e l’errore di misura aumenta con il raggio: (r · { $mp-measuring-tolerance }) / 5 mm.
note-tool-measurement-tolerance__itnc530 = { $mp-probing-feed-calculation } determina la tolleranza di misura. 0: rimane costante, perciò l’avanzamento di utensili molto grandi scende a zero, tanto prima quanto più piccoli sono { $mp-max-peripheral-speed } e { $mp-measuring-tolerance }. 1: è pari a { $mp-measuring-tolerance } per raggi utensile fino a 30 mm, al doppio fino a 60 mm, al triplo fino a 90 mm, al quadruplo fino a 120 mm. 2: l’avanzamento rimane costante e l’errore di misura aumenta con il raggio: (r · { $mp-measuring-tolerance }) / 5 mm.
note-tool-measurement-tolerance__tnc426-430 = { $mp-probing-feed-calculation } determina la tolleranza di misura. 0: rimane costante, perciò l’avanzamento di utensili molto grandi scende a zero, tanto prima quanto più piccoli sono { $mp-max-peripheral-speed } e { $mp-measuring-tolerance }. 1: è pari a { $mp-measuring-tolerance } per raggi utensile fino a 30 mm, al doppio fino a 60 mm, al triplo fino a 90 mm, al quadruplo fino a 120 mm. 2: l’avanzamento rimane costante e l’errore di misura aumenta con il raggio: (r · { $mp-measuring-tolerance }) / 5 mm.
note-check-tool-measurement-parameters = Prima di utilizzare i cicli di tastatura verificare tutti i parametri macchina in { $mp-probe-settings } > { $mp-tool-measurement-config } e { $mp-round-stylus-config }.
note-tool-table-entries = Voci della tabella utensili: { $mp-teeth } è il numero dei taglienti, al massimo 20. { $mp-wear-tolerance-length } e { $mp-wear-tolerance-radius } sono lo scostamento ammesso di lunghezza e raggio per il rilevamento dell’usura, { $mp-break-tolerance-length } e { $mp-break-tolerance-radius } per il rilevamento della rottura, ciascuno da 0 a 0,9999 mm; se un valore viene superato, il controllo blocca l’utensile (stato L). { $mp-cutting-direction } è la direzione di taglio per la misurazione con utensile rotante. { $mp-setter-offset-radius } è l’offset tra il centro dello stilo e il centro dell’utensile nella misurazione della lunghezza; la preimpostazione è nessun valore (offset = raggio utensile). { $mp-setter-offset-length } è l’offset tra il bordo superiore dello stilo e il bordo inferiore dell’utensile nella misurazione del raggio, in aggiunta a { $mp-setter-axis-offset }; la preimpostazione è 0.
note-tool-table-entries__itnc530 = Voci della tabella utensili: { $mp-teeth } è il numero dei taglienti. { $mp-wear-tolerance-length } e { $mp-wear-tolerance-radius } sono lo scostamento ammesso di lunghezza e raggio per il rilevamento dell’usura, { $mp-break-tolerance-length } e { $mp-break-tolerance-radius } per il rilevamento della rottura, ciascuno da 0 a 0,9999 mm; se un valore viene superato, il controllo blocca l’utensile (stato L). { $mp-cutting-direction } è la direzione di taglio per la misurazione con utensile rotante. { $mp-setter-offset-radius } è l’offset tra il centro dello stilo e il centro dell’utensile nella misurazione della lunghezza; la preimpostazione è il raggio utensile R (inserito con il tasto NO ENT). { $mp-setter-offset-length } è l’offset tra il bordo superiore dello stilo e il bordo inferiore dell’utensile nella misurazione del raggio, in aggiunta a { $mp-setter-axis-offset }; la preimpostazione è 0.
note-usual-tool-table-entries = Valori usuali nella tabella utensili. Punta: { $mp-teeth } senza funzione, { $mp-setter-offset-radius } = 0 (si misura la punta dell’utensile), { $mp-setter-offset-length } vuoto. Fresa cilindrica con diametro inferiore a 19 mm: { $mp-teeth } = 4 (taglienti), { $mp-setter-offset-radius } = 0 (il diametro dell’utensile è minore di quello del piatto), { $mp-setter-offset-length } = 0. Fresa cilindrica con diametro superiore a 19 mm: { $mp-teeth } = 4, { $mp-setter-offset-radius } = R (l’offset è necessario perché il diametro dell’utensile è maggiore di quello del piatto), { $mp-setter-offset-length } = 0. Per nessuna delle due frese cilindriche serve un offset aggiuntivo nella misurazione del raggio, perché si utilizza l’offset di { $mp-setter-axis-offset }. Fresa a raggio frontale: { $mp-teeth } = 4, { $mp-setter-offset-radius } = 0 (si misura il polo sud della sfera), { $mp-setter-offset-length } = 5 (sempre il raggio utensile, affinché il diametro non venga misurato nel raggio della sfera).
note-old-and-new-form = I cicli da 31 a 33 e da 481 a 483 funzionano allo stesso modo. Le uniche differenze: i cicli da 481 a 483 sono disponibili anche in DIN/ISO, da G481 a G483, e per lo stato della misurazione utilizzano il parametro fisso Q199 invece di un parametro a scelta.
note-status-parameter-optional = Senza parametro per il risultato lo stato della misurazione non viene memorizzato.
note-tool-measurement-in-tilted-plane = La misurazione degli utensili è possibile anche con piano di lavoro ruotato.
note-tool-status-display = L’indicazione di stato supplementare può visualizzare i risultati nei modi operativi di macchina: il programma a sinistra, i risultati a destra. I valori oltre la tolleranza di usura sono contrassegnati con *, quelli oltre la tolleranza di rottura con B.
note-tool-status-display__tnc426-430 = Il softkey per lo stato della misurazione dell’utensile visualizza i risultati nell’indicazione di stato supplementare (nei modi operativi di macchina): il programma a sinistra, i risultati a destra. I valori oltre la tolleranza di usura sono contrassegnati con *, quelli oltre la tolleranza di rottura con B.
note-from-software-280476 = Disponibile a partire dal software NC 280 476-xx.
note-not-in-iso = Il vecchio formato non è disponibile in DIN/ISO.
note-prepare-for-tool-probe = La macchina e il controllo devono essere predisposti dal costruttore della macchina per il sistema di tastatura TT. Alcuni cicli e alcune funzioni potrebbero non essere disponibili. Consultare il manuale della macchina.
title-first-measurement-rotating-old = Prima misurazione con utensile rotante; vecchio formato
title-first-measurement-rotating-status = Prima misurazione con utensile rotante, stato memorizzato in Q1
title-check-teeth-status-old = Verifica con misurazione dei singoli taglienti, stato memorizzato in Q5; vecchio formato
title-check-teeth-without-status = Verifica con misurazione dei singoli taglienti, stato non memorizzato
