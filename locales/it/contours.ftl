# Contour, cylinder surface and engraving cycles; see the English file.

# --- common ---
step-retract-to-contour-clearance-height = L’utensile si ritrae all’altezza di sicurezza con l’avanzamento { $q-contour-retraction-feed }, oppure con { $q-roughing-feed } se { $q-contour-retraction-feed } è 0.
step-leave-to-contour-clearance-height = L’utensile si porta all’altezza di sicurezza.
until-contour-depth-reached = non è raggiunta la profondità programmata
until-parts-of-contour-cleared = non sono lavorate tutte le aree separate del profilo
note-contour-element-limit = La memoria per un ciclo SL è limitata. In un ciclo SL si possono programmare al massimo 16384 elementi di profilo.
note-sign-of-milling-depth = Il segno della profondità di fresatura determina la direzione di lavoro. Con profondità 0 il controllo non esegue il ciclo.
note-both-axes-after-contour-cycle = Pericolo di collisione! Dopo un ciclo SL programmare il primo spostamento nel piano di lavoro con entrambe le coordinate, ad esempio L X+80 Y+0 R0 FMAX.
note-contour-cycle-properties = Prima di ogni ciclo il controllo posiziona automaticamente l’utensile alla distanza di sicurezza. Ogni livello viene fresato senza sollevare l’utensile; le isole vengono aggirate lateralmente. Il raggio degli spigoli interni è programmabile: l’utensile non si ferma e non lascia segni (ciò vale per la traiettoria più esterna nello svuotamento e per la finitura laterale). Nella finitura laterale l’utensile si accosta al profilo su un arco tangente, nella finitura del fondo si accosta al pezzo ugualmente su un arco tangente (con asse del mandrino Z nel piano Z/X). Il profilo viene lavorato interamente con fresatura concorde o con fresatura discorde.
note-contour-tool-by-name = L’utensile può essere indicato con il numero o con il nome. Per inserire il nome premere il softkey NOME UTENSILE; all’uscita dal campo il controllo aggiunge automaticamente le virgolette.
note-global-def-for-contours = La funzione GLOBAL DEF per la fresatura di profili predefinisce distanza di sicurezza, altezza di sicurezza, fattore di sovrapposizione e tipo di fresatura per i cicli 20, 22, 23, 24 e 25.

# --- 14 ---
cycle-contour = Profilo
    .nc = PROFILO
    .purpose = Elenca tutti i sottoprogrammi che vengono sovrapposti in un profilo complessivo. Il controllo calcola il profilo complessivo da questi segmenti di profilo, che sono tasche o isole.
step-remember-contour-labels = Il controllo memorizza i numeri dei label. I cicli successivi lavorano il profilo descritto dai sottoprogrammi.
note-contour-acts-from-definition = Il ciclo è attivo dalla sua definizione nel programma.
note-most-contour-labels = Si possono elencare al massimo 12 sottoprogrammi (segmenti di profilo).
note-transformations-in-contour = Le conversioni di coordinate sono ammesse. Se vengono programmate all’interno di un segmento di profilo, hanno effetto anche nei sottoprogrammi successivi; non è necessario annullarle dopo la chiamata del ciclo.
note-pocket-and-island-recognized = Il controllo riconosce una tasca se l’utensile percorre il profilo all’interno, ad esempio in senso orario con correzione del raggio RR. Riconosce un’isola se l’utensile percorre il profilo all’esterno, ad esempio in senso orario con correzione del raggio RL.
note-contour-without-spindle-axis = I sottoprogrammi non devono contenere coordinate nell’asse del mandrino.
note-contour-begins-with-both-axes = Nel primo blocco del sottoprogramma programmare sempre entrambi gli assi.
note-parameters-within-contour = Se si utilizzano parametri Q, eseguire calcoli e assegnazioni solo all’interno del relativo sottoprogramma del profilo.
note-contours-may-overlap = Tasche e isole possono essere sovrapposte per formare un nuovo profilo. Una tasca sovrapposta ingrandisce l’area di una tasca o riduce quella di un’isola.
note-contour-intersections-computed = Il controllo calcola i punti di intersezione dei segmenti di profilo; non occorre programmarli.
note-contour-sum = Area di unione (entrambe le aree A e B, compresa quella comune): A e B devono essere tasche. La prima tasca dell’elenco deve iniziare all’esterno della seconda.
note-contour-difference = Area di differenza (A senza la parte coperta da B): A deve essere una tasca, B un’isola. A deve iniziare all’esterno di B, B all’interno di A.
note-contour-intersection = Area di intersezione (solo la parte coperta sia da A sia da B): A e B devono essere tasche. A deve iniziare all’interno di B.
note-machining-data-in-contour-data = I dati di lavorazione, come profondità di fresatura, sovrametalli e distanza di sicurezza, vengono inseriti centralmente nel ciclo 20.
note-contour-cycle-or-sel-contour = Il ciclo non è necessario se il profilo viene selezionato con SEL CONTOUR.
note-contour-for-turning = Anche i cicli di tornitura che lavorano un profilo richiedono questo ciclo: deve essere programmato prima della loro chiamata e indica il numero del sottoprogramma.

# --- 20 ---
cycle-contour-data = Dati profilo
    .nc = DATI PROFILO
    .purpose = Contiene i dati di lavorazione per i sottoprogrammi con i segmenti di profilo.
step-remember-contour-data = Il controllo memorizza i dati di lavorazione per i cicli da 21 a 24.
note-contour-data-act-from-definition = Il ciclo è attivo dalla sua definizione nel programma. I dati di lavorazione valgono solo per i cicli da 21 a 24.
note-parameters-reserved-for-contours = Se si utilizzano cicli SL in programmi con parametri Q, i parametri da Q1 a Q20 non devono essere utilizzati come parametri di programma.
note-contour-data-at-interruption = Durante un’interruzione del programma i parametri di lavorazione possono essere verificati e, se necessario, sovrascritti.

# --- 21 ---
cycle-pilot-drilling = Preforatura
    .nc = PREFORATURA
    .purpose = Fora nei punti di penetrazione del profilo, che sono anche i punti di partenza per lo svuotamento.
step-position-at-pilot-holes = Il controllo determina i punti di penetrazione del profilo.
step-move-over-pilot-hole = Il controllo posiziona l’utensile sopra il punto di penetrazione alla distanza di sicurezza.
step-drill-pilot-hole-to-plunging-depth = L’utensile fora con l’avanzamento { $q-contour-plunging-feed } fino alla profondità incremento, che a ogni incremento aumenta di { $q-contour-plunging-depth }.
step-retract-and-return-to-stop-distance = Il controllo ritrae l’utensile in rapido (FMAX) e lo riporta fino alla distanza di prearresto t sopra la profondità raggiunta.
until-drilling-depth-reached = non è raggiunta la profondità di foratura
step-dwell-and-retract-to-start = Sul fondo del foro l’utensile sosta per eseguire la spoglia e poi si ritrae in rapido (FMAX) alla posizione di partenza.
until-pilot-holes-drilled = non sono stati forati tutti i punti di penetrazione
note-stop-distance-determined = Il controllo determina automaticamente la distanza di prearresto t: 0,6 mm con una profondità di foratura fino a 30 mm, un cinquantesimo della profondità di foratura se supera 30 mm, ma mai più di 7 mm.
note-infeed-points-consider = Per i punti di penetrazione il controllo tiene conto dei sovrametalli di finitura laterale e del fondo e del raggio dell’utensile di svuotamento.
note-delta-radius-not-considered-for-infeed-points = Nel calcolo dei punti di penetrazione il controllo non tiene conto di un valore delta DR programmato nel blocco TOOL CALL.
note-narrow-places-not-pre-drilled = In punti stretti il controllo potrebbe non essere in grado di preforare con un utensile più grande di quello di svuotamento.

# --- 22 ---
cycle-rough-out = Svuotamento
    .nc = SVUOTAMENTO
    .purpose = Svuota il profilo fino al sovrametallo del fondo, livello per livello, oppure lavora soltanto ciò che ha lasciato un utensile più grande.
step-position-over-infeed-point = Il controllo posiziona l’utensile sopra il punto di penetrazione, tenendo conto del sovrametallo di finitura laterale.
step-take-depths-of-partial-contours = Il controllo lavora un segmento di profilo con una profondità propria fino a tale profondità, tutti gli altri fino alla profondità di fresatura dei dati del profilo.
step-go-to-infeed-point = L’utensile si porta in rapido sopra il punto di penetrazione e scende fino alla distanza di sicurezza dalla superficie già lavorata.
step-plunge-to-contour-level = L’utensile scende di { $q-contour-plunging-depth } alla profondità incremento successiva:
say-plunge-vertically-without-reciprocation = { $q-reciprocation-feed } = 0: in verticale con l’avanzamento { $q-contour-plunging-feed }, anche se per l’utensile attivo è definito un angolo di penetrazione { $mp-plunging-angle }
say-plunge-vertically-at-reciprocation-feed = { $mp-plunging-angle } = 90°: in verticale con l’avanzamento con pendolamento { $q-reciprocation-feed }
say-plunge-on-helix-or-in-strokes = altrimenti lungo un’elica con l’angolo di penetrazione { $mp-plunging-angle }, oppure con pendolamento dove un’elica non è possibile
step-rough-contour-level = A questa profondità l’utensile fresa il profilo dall’interno verso l’esterno con l’avanzamento { $q-roughing-feed }; intorno alle isole fresa su traiettorie che si avvicinano sempre più al profilo della tasca. L’utensile lavora:
say-rough-what-coarser-tool-left = se è inserito un utensile di sgrossatura { $q-coarse-roughing-tool }, soltanto ciò che questo utensile non ha potuto lavorare
say-rough-whole-region = altrimenti l’intera area
message-contour-material-left = L’utensile non raggiunge tutto il profilo: lascia materiale negli angoli o nei punti stretti.
note-centre-cutting-or-pilot-drilling = Se necessario, utilizzare una fresa con tagliente al centro (DIN 844) oppure preforare con il ciclo 21.
note-rough-out-plunging = Il modo in cui l’utensile penetra è determinato dal parametro { $q-reciprocation-feed } e dalle colonne { $mp-plunging-angle } e { $mp-cutting-edge-length } della tabella utensili. Con { $q-reciprocation-feed } = 0 penetra sempre in verticale. Con { $mp-plunging-angle } = 90° penetra in verticale con l’avanzamento { $q-reciprocation-feed }. Con un avanzamento con pendolamento e { $mp-plunging-angle } da 0,1 a 89,999 penetra lungo un’elica con questo angolo. Con un avanzamento con pendolamento e senza { $mp-plunging-angle } nella tabella utensili il controllo emette un messaggio d’errore. Se non c’è spazio per un’elica (ad esempio in una scanalatura), il controllo tenta di penetrare con pendolamento; la lunghezza di pendolamento è { $mp-cutting-edge-length } / tan { $mp-plunging-angle }.
note-overlap-greater-than-one = Con un fattore di sovrapposizione maggiore di 1, nei profili di tasche con spigoli interni acuti può rimanere del materiale. Verificare la traiettoria più interna nel test grafico e, se necessario, modificare leggermente il fattore di sovrapposizione. In questo modo la suddivisione dei tagli cambia, il che spesso porta al risultato desiderato.
note-wear-of-coarse-tool-not-considered = Nella finitura dello svuotamento il controllo non tiene conto di un valore di usura DR definito per l’utensile di sgrossatura.
note-fine-roughing-needs-tool-data = Se l’area per la finitura dello svuotamento non può essere raggiunta di lato, l’utensile penetra con pendolamento. A tale scopo definire nella tabella utensili la lunghezza del tagliente { $mp-cutting-edge-length } e il massimo angolo di penetrazione { $mp-plunging-angle } dell’utensile; in caso contrario il controllo può emettere un messaggio d’errore.

# --- 23 ---
cycle-floor-finishing = Finitura fondo
    .nc = FINITURA FONDO
    .purpose = Asporta il sovrametallo di finitura che lo svuotamento ha lasciato sul fondo.
step-approach-contour-floor = Se lo spazio è sufficiente, l’utensile si accosta dolcemente al fondo su un arco tangente verticale. Altrimenti si porta alla profondità in verticale con l’avanzamento { $q-contour-plunging-feed }.
step-find-start-of-floor-finishing = Il controllo numerico determina il punto di partenza della finitura del fondo.
step-finish-contour-floor = L’utensile asporta, con l’avanzamento { $q-roughing-feed }, il sovrametallo di finitura lasciato dallo svuotamento.
note-starting-point-by-itself = Il controllo determina automaticamente il punto di partenza per la finitura, che dipende dallo spazio disponibile nella tasca.
note-approach-radius-is-fixed = Il raggio per l’accostamento alla profondità finale è definito internamente e non dipende dall’angolo di penetrazione dell’utensile.

# --- 24 ---
cycle-side-finishing = Finitura laterale
    .nc = FINITURA LATERALE
    .purpose = Esegue la finitura dei lati del profilo. Ogni segmento di profilo viene finito separatamente.
step-find-start-of-side-finishing = Il controllo determina il punto di partenza per la finitura.
step-finish-partial-contour = Con l’avanzamento { $q-contour-plunging-feed } il controllo fa scendere l’utensile di { $q-contour-plunging-depth } alla profondità incremento successiva, lo accosta tangenzialmente al segmento di profilo su un arco ed esegue la finitura del segmento con l’avanzamento { $q-roughing-feed }.
until-partial-contours-finished = non è stata eseguita la finitura di ogni segmento di profilo
note-side-finishing-allowances = La somma del sovrametallo laterale { $q-remaining-side-allowance } e del raggio dell’utensile di finitura deve essere minore della somma del sovrametallo laterale del ciclo 20 e del raggio dell’utensile di svuotamento.
note-side-finishing-without-roughing = Lo stesso vale se il ciclo viene eseguito senza precedente svuotamento con il ciclo 22; in tal caso il raggio dell’utensile di svuotamento vale 0.
note-side-finishing-mills-contours = Il ciclo può essere utilizzato anche per fresare profili. A tale scopo definire il profilo come isola singola (senza delimitazione di una tasca) e inserire nel ciclo 20 un sovrametallo di finitura laterale maggiore della somma del sovrametallo { $q-remaining-side-allowance } e del raggio dell’utensile.
note-start-depends-on-room-and-allowance = Il controllo determina automaticamente il punto di partenza per la finitura, che dipende dallo spazio disponibile nella tasca e dal sovrametallo programmato nel ciclo 20.
note-start-depends-on-sequence = Il punto di partenza dipende anche dalla sequenza di lavorazione. Se il ciclo di finitura viene selezionato con il tasto GOTO e il programma viene poi avviato, il punto di partenza può trovarsi in una posizione diversa da quella risultante eseguendo il programma nella sua sequenza.

# --- 25 ---
cycle-contour-train = Contornatura profilo
    .nc = CONTORNATURA PROFILO
    .purpose = Lavora profili aperti e chiusi, insieme al ciclo 14. Rispetto ai blocchi di posizionamento lungo il profilo, il controllo sorveglia la lavorazione, fresa interamente in concorde o in discorde e può fresare in andata e ritorno e con sovrametalli.
step-position-over-contour-start = Il controllo porta l’utensile all’altezza di sicurezza { $q-contour-clearance-height } e sopra il punto di partenza del profilo.
step-plunge-beside-contour = Con l’avanzamento { $q-contour-plunging-feed } l’utensile scende di { $q-contour-plunging-depth } alla profondità incremento successiva.
step-mill-along-contour = L’utensile fresa lungo il profilo con l’avanzamento { $q-contour-milling-feed }, tenendo conto del sovrametallo di finitura { $q-side-allowance }:
say-mill-to-and-fro = { $q-contour-milling-type } = 0: in andata e ritorno, alternando a ogni incremento fresatura concorde e discorde
say-mill-in-one-direction = { $q-contour-milling-type } = +1 o −1: in ogni incremento con fresatura concorde o con fresatura discorde
until-milling-depth-reached = non è raggiunta la profondità di fresatura { $q-milling-depth }
note-contour-damage-monitored = Il controllo sorveglia la lavorazione in modo da evitare sottosquadri e danneggiamenti del profilo. Verificare il profilo con un test grafico.
note-inside-corners-may-need-reworking = Se il raggio dell’utensile è troppo grande, può essere necessario riprendere gli spigoli interni del profilo.
note-milling-type-kept-when-mirrored = Il profilo può essere lavorato interamente con fresatura concorde o discorde. Il tipo di fresatura si mantiene anche con profili speculari.
note-several-infeeds-to-and-fro = Con più incrementi il controllo può spostare l’utensile in andata e ritorno, riducendo il tempo di lavorazione.
note-contour-in-several-operations = È possibile inserire sovrametalli, in modo da eseguire sgrossatura e finitura in più passate.
note-only-first-contour-label = Il controllo considera solo il primo label del ciclo 14.
note-contour-data-not-needed = Il ciclo 20 non è necessario.
note-corner-feed-functions-without-effect = Le funzioni ausiliarie M109 e M110 non hanno effetto nella lavorazione di un profilo con questo ciclo.
note-no-incremental-after-contour-train = Pericolo di collisione! Dopo il ciclo non programmare quote incrementali, perché si riferirebbero alla posizione dell’utensile al termine del ciclo.
note-absolute-position-after-contour-train = Pericolo di collisione! Dopo il ciclo portare l’utensile in una posizione definita (assoluta) in tutti gli assi principali, poiché la sua posizione al termine del ciclo non è quella iniziale.

# --- 27 to 29 ---
step-plunge-into-cylinder = Con l’avanzamento { $q-contour-plunging-feed } l’utensile scende di { $q-contour-plunging-depth } alla profondità incremento successiva.
until-cylinder-milling-depth-reached = non è raggiunta la profondità di fresatura programmata { $q-cylinder-milling-depth }
step-return-in-tool-axis = L’utensile ritorna nell’asse utensile all’altezza di sicurezza o all’ultima posizione programmata prima del ciclo.
guard-clearance-within-tool-radius = La distanza di sicurezza non è maggiore del raggio dell’utensile.
guard-spindle-not-across-rotary-axis = L’asse del mandrino non è perpendicolare all’asse della tavola rotante.
guard-datum-off-rotary-axis = L’origine non si trova sull’asse della tavola rotante: il cilindro non girerebbe concentrico.
guard-depth-out-of-cylinder = La profondità di fresatura è positiva: l’utensile si allontanerebbe dall’asse del cilindro.
guard-slot-core-left = La scanalatura è larga più del doppio dell’utensile: tra le pareti rimane del materiale.
note-contour-in-development = Descrivere il profilo in un sottoprogramma selezionato con il ciclo 14, sempre con le coordinate X e Y, indipendentemente dagli assi rotativi presenti sulla macchina. La descrizione del profilo risulta così indipendente dalla configurazione della macchina.
note-prepare-for-cylinder-interpolation = Macchina e controllo devono essere predisposti dal costruttore della macchina per l’interpolazione su superficie cilindrica. Consultare il manuale della macchina.
note-contour-begins-with-both-coordinates-of-cylinder = Nel primo blocco NC del sottoprogramma del profilo programmare sempre entrambe le coordinate della superficie cilindrica.
note-centre-cutting-end-mill = Utilizzare una fresa con tagliente al centro (DIN 844).
note-cylinder-centred-on-rotary-table = Il cilindro deve essere serrato al centro della tavola rotante.
note-datum-in-centre-of-rotary-table = Impostare l’origine al centro della tavola rotante.
note-spindle-across-rotary-axis = Alla chiamata del ciclo l’asse del mandrino deve essere perpendicolare all’asse della tavola rotante. In caso contrario il controllo emette un messaggio d’errore. Può essere necessario commutare la cinematica.
note-cylinder-in-tilted-plane = Il ciclo può essere impiegato anche con piano di lavoro ruotato.
note-clearance-greater-than-tool-radius = La distanza di sicurezza { $q-cylinder-set-up-clearance } deve essere maggiore del raggio dell’utensile.
note-many-contour-elements-take-time = La lavorazione può durare più a lungo se il profilo è formato da molti elementi di profilo non tangenti.

# --- 27 ---
cycle-cylinder-surface = Superficie cilindrica
    .nc = SUPERFICIE CILINDRICA
    .purpose = Trasferisce sulla superficie di un cilindro un profilo definito nello sviluppo.
step-mill-along-developed-contour = L’utensile fresa lungo il profilo programmato con l’avanzamento { $q-contour-milling-feed }.
step-back-over-infeed-point = Alla fine del profilo il controllo porta l’utensile alla distanza di sicurezza { $q-cylinder-set-up-clearance } e di nuovo sopra il punto di penetrazione.
step-end-at-cylinder-clearance = L’utensile si porta alla distanza di sicurezza { $q-cylinder-set-up-clearance }.
note-functions-for-developed-contour = Per la traiettoria dell’utensile sono disponibili le funzioni L, CHF, CR, RND e CT.
note-angular-axis-unit = I valori per l’asse angolare (coordinate X) possono essere inseriti in gradi oppure in millimetri (pollici); la scelta avviene con { $q-development-dimension-type }.
note-guide-slots-with-other-cycle = Per fresare scanalature di guida su un cilindro utilizzare il ciclo 28.

# --- 28 ---
cycle-cylinder-surface-slot = Superficie cilindrica, fresatura di scanalature
    .nc = SUPERFICIE CILINDRICA
    .purpose = Trasferisce sulla superficie di un cilindro una scanalatura di guida definita nello sviluppo, con pareti quasi parallele.
step-position-over-slot-infeed-point = Il controllo posiziona l’utensile sopra il punto di penetrazione.
step-mill-along-slot-wall = L’utensile fresa lungo la parete della scanalatura con l’avanzamento { $q-contour-milling-feed }, tenendo conto del sovrametallo di finitura laterale { $q-side-allowance }.
step-mill-back-along-opposite-wall = Alla fine del profilo il controllo porta l’utensile alla parete opposta della scanalatura e lo riporta al punto di penetrazione.
step-rework-slot-walls = Se è definita una tolleranza { $q-cylinder-slot-tolerance }, il controllo riprende la scanalatura in modo che le pareti siano il più possibile parallele.
note-walls-nearly-parallel = A differenza del ciclo 27, questo ciclo orienta l’utensile in modo che con la correzione del raggio attiva le pareti siano quasi parallele. Le pareti sono esattamente parallele con un utensile largo esattamente quanto la scanalatura.
note-small-tool-distorts-slot = Quanto più piccolo è l’utensile rispetto alla larghezza della scanalatura, tanto maggiori sono le distorsioni su archi e rette oblique. Per ridurle, definire la tolleranza { $q-cylinder-slot-tolerance }: il controllo rende allora la scanalatura simile a una eseguita con un utensile largo quanto la scanalatura.
note-program-centre-path-of-slot = Programmare la traiettoria centrale del profilo con correzione del raggio. La correzione del raggio determina se il controllo esegue la scanalatura con fresatura concorde o discorde.

# --- 29 ---
cycle-cylinder-surface-ridge = Isola su superficie cilindrica
    .nc = ISOLA SU SUP. CILINDRICA
    .purpose = Trasferisce sulla superficie di un cilindro un’isola definita nello sviluppo, con pareti parallele.
step-position-over-ridge-start = Il controllo posiziona l’utensile sopra il punto di partenza della lavorazione, che calcola dalla larghezza dell’isola e dal diametro dell’utensile: a fianco del primo punto del sottoprogramma del profilo, spostato di metà della larghezza dell’isola più il diametro dell’utensile. La correzione del raggio determina il lato: a sinistra dell’isola (fresatura concorde) o a destra (fresatura discorde).
step-approach-ridge-wall = A questa profondità l’utensile si accosta al profilo su un arco tangente con l’avanzamento { $q-contour-milling-feed }, tenendo conto del sovrametallo di finitura laterale { $q-side-allowance }, se presente.
step-mill-along-ridge-wall = L’utensile fresa lungo la parete dell’isola con l’avanzamento { $q-contour-milling-feed } fino a completare l’isola.
step-leave-ridge-wall = L’utensile lascia tangenzialmente la parete dell’isola e ritorna al punto di partenza della lavorazione.
note-ridge-walls-parallel = Il ciclo orienta l’utensile in modo che con la correzione del raggio attiva le pareti siano sempre parallele.
note-program-centre-path-of-ridge = Programmare la traiettoria centrale dell’isola con correzione del raggio. La correzione del raggio determina se il controllo esegue l’isola con fresatura concorde o discorde.
note-ridge-ends-in-semicircles = Alle estremità dell’isola il controllo aggiunge sempre un semicerchio, il cui raggio è metà della larghezza dell’isola.

# --- 225 ---
cycle-engraving = Scrittura
    .nc = SCRITTURA
    .purpose = Incide testi su una superficie piana del pezzo, lungo una retta o lungo un arco di cerchio.
step-move-to-first-character = Il controllo posiziona l’utensile nel piano di lavoro sul punto di partenza del primo carattere.
step-engrave-character = L’utensile penetra in verticale con l’avanzamento { $q-plunging-feed } fino al fondo dell’incisione e fresa il carattere con l’avanzamento { $q-milling-feed }. Se deve essere sollevato all’interno del carattere, si porta alla distanza di sicurezza { $q-set-up-clearance }. Alla fine del carattere l’utensile si trova alla distanza di sicurezza sopra la superficie del pezzo.
step-move-over-next-character = Il controllo porta l’utensile, alla distanza di sicurezza, sul punto di partenza del carattere successivo.
until-characters-engraved = non sono stati incisi tutti i caratteri
step-end-engraving-at-second-clearance = Il controllo porta l’utensile alla 2ª distanza di sicurezza { $q-second-set-up-clearance }.
condition-text-runs-on-arc = { $q-text-arrangement } prevede un testo su un arco di cerchio
note-straight-text-starts-at-tool = Per un testo lungo una retta ({ $q-text-arrangement } = 0) la posizione dell’utensile alla chiamata del ciclo è il punto di partenza del primo carattere.
note-circle-text-centre-at-tool = Per un testo lungo un arco di cerchio ({ $q-text-arrangement } = 1) la posizione dell’utensile alla chiamata del ciclo è il centro del cerchio.
note-text-from-string-parameter = Il testo può essere fornito anche da una variabile stringa (QS).
note-engraving-characters = Caratteri che si possono incidere: lettere minuscole, lettere maiuscole, cifre e i caratteri speciali ! # $ % & ' ( ) * + , - . / : ; < = > ? @ [ \ ] _
note-engraving-doubled-characters = Il controllo utilizza i caratteri speciali % e \ per funzioni speciali. Per incidere uno di essi, inserirlo due volte nel testo, ad esempio %%.
note-engraving-control-characters = Il carattere speciale \ introduce inoltre caratteri non stampabili che dispongono il testo: \n è un’interruzione di riga, \t un tabulatore orizzontale (ampiezza di tabulazione 8 caratteri), \v un tabulatore verticale (ampiezza di tabulazione una riga).
note-proportional-font = Il font è proporzionale: ogni carattere ha una propria larghezza. Il fattore di distanza { $q-character-spacing-factor } scala la distanza tra i caratteri.
note-engraving-since-software = Il ciclo esiste a partire dal software 34059x-02.
