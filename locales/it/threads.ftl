# Tapping and thread milling; see the English file.

# --- tapping ---
cycle-tapping = Maschiatura con compensatore utensile, nuovo
    .nc = MASCHIATURA NUOVO
    .purpose = Maschia un filetto in un unico movimento con compensatore utensile.
cycle-rigid-tapping = Maschiatura senza compensatore utensile, nuovo
    .nc = MASCHIATURA RIGIDA NUOVO
    .purpose = Maschia un filetto in un unico movimento senza compensatore utensile.
cycle-tapping-with-chip-breaking = Maschiatura con rottura truciolo
    .nc = MASCH. CON ROTT. TRUCIOLO
    .purpose = Maschia un filetto in più incrementi senza compensatore utensile. Un parametro determina se per la rottura truciolo l’utensile esce completamente dal foro.
step-tap-in-one-movement = L’utensile si porta in un unico movimento alla profondità di filettatura { $q-thread-depth }.
step-reverse-dwell-and-retract = Il senso di rotazione del mandrino viene invertito e dopo il tempo di sosta { $q-dwell-at-bottom } l’utensile si ritrae alla distanza di sicurezza { $q-set-up-clearance }.
step-reverse-and-retract = Il senso di rotazione del mandrino viene invertito e l’utensile si ritrae alla distanza di sicurezza { $q-set-up-clearance }.
step-reverse-spindle-again = Alla distanza di sicurezza il senso di rotazione del mandrino viene di nuovo invertito.
step-stop-spindle-at-set-up-clearance = Il controllo arresta il mandrino alla distanza di sicurezza.
step-rapid-to-set-up-clearance-and-orient = Il controllo porta l’utensile nell’asse del mandrino in rapido (FMAX) alla distanza di sicurezza { $q-set-up-clearance } sopra la superficie del pezzo e qui orienta il mandrino a { $q-spindle-orientation-angle }.
step-tap-to-next-depth = L’utensile avanza in profondità dell’incremento { $q-depth-for-chip-breaking }.
step-reverse-and-break-chip = Il senso di rotazione del mandrino viene invertito e, dopo la ritrazione, di nuovo invertito per l’incremento successivo. Con un numero di giri aumentato del fattore { $q-retraction-speed-factor }, se inserito, l’utensile arretra:
say-tap-leaves-hole = { $q-chip-breaking-turns } = 0: completamente dal foro, per il raffreddamento
say-tap-goes-back-some-turns = altrimenti di { $q-chip-breaking-turns } volte il passo del filetto { $q-thread-pitch }
step-tap-back-to-set-up-clearance = L’utensile ritorna alla distanza di sicurezza { $q-set-up-clearance }.
note-sign-of-thread-depth = Il segno della profondità di filettatura { $q-thread-depth } determina la direzione di lavoro. Con profondità di filettatura 0 il controllo non esegue il ciclo.
note-thread-depth-gives-direction = Il segno della profondità di filettatura { $q-thread-depth } determina la direzione di lavoro.
note-positive-thread-depth-reverses = Pericolo di collisione! Con una profondità positiva il controllo inverte il calcolo della posizione preliminare: l’utensile si porta in rapido nell’asse utensile alla distanza di sicurezza sotto la superficie del pezzo.
note-floating-tap-holder = L’utensile deve essere serrato in un compensatore utensile, che durante la lavorazione compensa le tolleranze di avanzamento e numero di giri.
note-overrides-while-tapping = Durante l’esecuzione del ciclo il potenziometro del numero di giri mandrino non ha effetto. Quello dell’avanzamento ha ancora un effetto limitato, definito dal costruttore della macchina (consultare il manuale della macchina).
note-right-hand-with-m3 = Attivare il mandrino con M3 per filetti destrorsi, con M4 per filetti sinistrorsi.
note-feed-from-speed-and-pitch = Determinare l’avanzamento con F = S × p. F: avanzamento (mm/min), S: numero di giri mandrino (giri/min), p: passo del filetto (mm).
note-retract-after-interruption = Se durante la maschiatura viene premuto il tasto di stop esterno, il controllo visualizza un softkey con cui è possibile ritrarre l’utensile.
note-feed-follows-spindle-speed = Il controllo calcola l’avanzamento dal numero di giri del mandrino. Se durante la maschiatura viene azionato il potenziometro dell’avanzamento, il controllo adatta automaticamente l’avanzamento. Il potenziometro del numero di giri mandrino non è attivo.
note-spindle-stopped-after-tapping = Al termine del ciclo il mandrino è fermo. Prima della lavorazione successiva reinserirlo con M3 (o M4).
note-retract-by-soft-key = Se durante la maschiatura viene premuto il tasto di stop esterno, il controllo visualizza il softkey per lo spostamento manuale. Premuto il softkey, è possibile ritrarre l’utensile in modo controllato con il tasto di direzione positiva dell’asse del mandrino attivo.
note-retraction-speed-is-limited = Se in { $q-retraction-speed-factor } è definito un fattore del numero di giri per una ritrazione più rapida, il controllo limita il numero di giri a quello massimo ammesso per la gamma attiva.

# --- thread milling: cycles ---
cycle-thread-milling = Fresatura di filetti
    .nc = FRES. FILETTO
    .purpose = Fresa un filetto nel materiale preforato.
cycle-thread-milling-countersinking = Fresatura di filetti con smusso
    .nc = FRES. FILETTO CON SMUSSO
    .purpose = Fresa un filetto nel materiale preforato ed esegue uno smusso svasato.
cycle-thread-drilling-milling = Fresatura di filetti dal pieno
    .nc = FRES. FILETTO DAL PIENO
    .purpose = Fora nel materiale pieno e poi fresa il filetto con lo stesso utensile.
cycle-helical-thread-drilling-milling = Fresatura di filetti elicoidali
    .nc = FRES. FILETTO ELICOIDALE
    .purpose = Fresa un filetto nel materiale pieno su una traiettoria elicoidale.
cycle-outside-thread-milling = Fresatura di filetti esterni
    .nc = FRES. FILETTO ESTERNO
    .purpose = Fresa un filetto esterno ed esegue uno smusso svasato.

# --- thread milling: steps ---
group-countersinking = Svasatura
group-countersinking-at-front = Svasatura frontale
group-drilling-the-hole = Foratura
group-milling-the-thread = Fresatura di filetti
step-feed-to-start-plane-of-threads = L’utensile si porta con l’avanzamento di avvicinamento { $q-in-and-out-feed } sul piano di partenza, che risulta dal segno del passo del filetto { $q-thread-pitch }, dal tipo di fresatura { $q-milling-type } e dal numero di filetti per passata { $q-threads-per-step }.
step-feed-to-start-plane-of-thread = L’utensile si porta con l’avanzamento di avvicinamento { $q-in-and-out-feed } sul piano di partenza del filetto, che risulta dal segno del passo del filetto { $q-thread-pitch } e dal tipo di fresatura { $q-milling-type }.
step-feed-to-start-plane-of-helix = L’utensile si porta con l’avanzamento di avvicinamento { $q-in-and-out-feed } sul piano di partenza del filetto.
step-approach-thread-and-compensate = L’utensile si accosta tangenzialmente su un’elica al diametro del filetto { $q-nominal-diameter }. Al tempo stesso esegue un movimento di compensazione nell’asse utensile, in modo che la traiettoria del filetto inizi sul piano di partenza programmato.
step-approach-thread = L’utensile si accosta tangenzialmente su un’elica al diametro del filetto { $q-nominal-diameter }.
step-approach-and-mill-one-turn = L’utensile si accosta tangenzialmente su un’elica al diametro del filetto { $q-nominal-diameter } e fresa il filetto con un movimento elicoidale di 360°.
step-mill-thread-in-turns = L’utensile fresa il filetto con l’avanzamento { $q-milling-feed }, in base ai filetti per passata { $q-threads-per-step }:
say-thread-in-one-turn = { $q-threads-per-step } = 0: in un unico movimento elicoidale
say-thread-on-continuous-helix = { $q-threads-per-step } = 1: in un movimento elicoidale continuo
say-thread-on-several-helices = { $q-threads-per-step } > 1: in più movimenti elicoidali spostati
step-mill-thread-downwards = Il controllo sposta l’utensile verso il basso su un’elica continua fino alla profondità di filettatura { $q-thread-depth }.
step-depart-from-thread = L’utensile si distacca tangenzialmente dal profilo e ritorna al punto di partenza nel piano di lavoro.
step-end-of-thread-milling = Al termine del ciclo il controllo porta l’utensile in rapido:
step-feed-to-countersinking-depth = Se non è inserita alcuna distanza laterale { $q-clearance-to-wall }, l’utensile si porta con l’avanzamento di avvicinamento { $q-in-and-out-feed } alla profondità di svasatura { $q-countersinking-depth } meno la distanza di sicurezza e poi con l’avanzamento di lamatura { $q-countersinking-feed } alla profondità di svasatura.
step-feed-directly-to-countersinking-depth = Se è inserita una distanza laterale { $q-clearance-to-wall }, il controllo porta l’utensile subito con l’avanzamento di avvicinamento { $q-in-and-out-feed } alla profondità di svasatura { $q-countersinking-depth }.
step-countersink-on-circle = A seconda dello spazio disponibile, l’utensile si accosta dolcemente dal centro oppure con un preposizionamento laterale ed esegue un movimento circolare.
step-feed-to-depth-at-front = L’utensile si porta con l’avanzamento di avvicinamento { $q-in-and-out-feed } alla profondità di svasatura frontale { $q-depth-at-front }.
step-feed-to-depth-at-front-before-or-after = Se la svasatura precede il filetto ({ $q-countersinking-moment } = 0), l’utensile si porta con l’avanzamento di lamatura { $q-countersinking-feed } alla profondità di svasatura frontale { $q-depth-at-front }; se segue il filetto, con l’avanzamento di avvicinamento { $q-in-and-out-feed }.
step-countersink-at-front = Il controllo sposta l’utensile, senza correzione del raggio, su un semicerchio dal centro all’offset frontale { $q-offset-at-front } ed esegue un movimento circolare con l’avanzamento di lamatura { $q-countersinking-feed }.
step-countersink-at-front__thread-drilling-milling = Il controllo sposta l’utensile, senza correzione del raggio, su un semicerchio dal centro all’offset frontale { $q-offset-at-front } ed esegue un movimento circolare con l’avanzamento { $q-plunging-feed }.
step-leave-countersink-at-front = Il controllo riporta l’utensile su un semicerchio al centro del foro.
step-leave-countersink-at-front__outside-thread-milling = Il controllo riporta l’utensile su un semicerchio al punto di partenza.
step-countersink-after-thread = Se la svasatura segue il filetto ({ $q-countersinking-moment } = 1), viene eseguita ora, come descritto sopra.
step-drill-towards-plunging-depth = L’utensile fora con l’avanzamento { $q-plunging-feed } verso la profondità incremento { $q-plunging-depth }; con la rottura truciolo si ferma ogni volta che è sceso di { $q-depth-for-chip-breaking }.
step-retract-to-break-chip = Per la rottura truciolo l’utensile si ritrae di { $q-chip-breaking-retraction }.
step-retract-and-return-to-one-stop-distance = Il controllo ritrae l’utensile in rapido alla distanza di sicurezza e lo riporta in rapido (FMAX) fino alla distanza di prearresto { $q-upper-advanced-stop-distance } sopra la profondità raggiunta.
until-hole-depth-reached = non è raggiunta la profondità totale foro { $q-total-hole-depth }
step-move-beside-stud = Il controllo porta l’utensile dal centro dell’isola, lungo l’asse principale del piano di lavoro, al punto di partenza per la svasatura frontale. La sua posizione risulta dal raggio del filetto, dal raggio dell’utensile e dal passo.
step-move-beside-stud-without-countersinking = Se non è prevista la svasatura frontale, il controllo porta l’utensile al punto di partenza della fresatura del filetto, che è lo stesso della svasatura frontale.

# --- thread milling: conditions and guards ---
guard-no-depth-entered = Tutte le profondità sono 0: non viene lavorato nulla.
guard-depth-signs-differ = Le profondità hanno segni diversi. Inserire lo stesso segno per tutte.
guard-thread-near-countersinking-depth = La profondità di filettatura deve essere minore della profondità di svasatura di almeno un terzo del passo.
guard-thread-near-hole-depth = La profondità di filettatura deve essere minore della profondità totale foro di almeno un terzo del passo.

# --- thread milling: notes ---
note-thread-approach-on-half-circle = L’accostamento al diametro del filetto avviene su un semicerchio dal centro verso l’esterno. Se il diametro dell’utensile è solo un quarto del diametro del filetto, l’utensile viene preposizionato lateralmente.
note-compensation-before-approach = Prima dell’accostamento il controllo esegue un movimento di compensazione nell’asse utensile, pari al massimo a metà del passo del filetto. Assicurarsi che nel foro vi sia spazio sufficiente.
note-thread-depth-moves-start = Se viene modificata la profondità di filettatura, il controllo modifica automaticamente il punto di partenza del movimento elicoidale.
note-depths-give-direction = I segni dei parametri di profondità determinano la direzione di lavoro nel seguente ordine: 1. profondità di filettatura { $q-thread-depth }, 2. profondità di svasatura { $q-countersinking-depth }, 3. profondità frontale { $q-depth-at-front }.
note-depths-give-direction__thread-drilling-milling = I segni dei parametri di profondità determinano la direzione di lavoro nel seguente ordine: 1. profondità di filettatura { $q-thread-depth }, 2. profondità totale foro { $q-total-hole-depth }, 3. profondità frontale { $q-depth-at-front }.
note-two-depths-give-direction = I segni dei parametri di profondità determinano la direzione di lavoro nel seguente ordine: 1. profondità di filettatura { $q-thread-depth }, 2. profondità frontale { $q-depth-at-front }.
note-depth-zero-leaves-out-step = Se per una delle profondità è inserito 0, il controllo non esegue il relativo passo di lavorazione.
note-no-countersinking-depth-for-front = Per eseguire la svasatura frontale impostare a 0 la profondità di svasatura { $q-countersinking-depth }.
note-thread-depth-above-countersinking-depth = Inserire una profondità di filettatura { $q-thread-depth } minore della profondità di svasatura { $q-countersinking-depth } di almeno un terzo del passo del filetto.
note-thread-depth-above-hole-depth = Inserire una profondità di filettatura { $q-thread-depth } minore della profondità totale foro { $q-total-hole-depth } di almeno un terzo del passo del filetto.
note-helix-goes-into-workpiece = Il tipo di fresatura (concorde o discorde) risulta dal filetto (destrorso o sinistrorso) e dal senso di rotazione dell’utensile, poiché l’unica direzione di lavoro possibile va dalla superficie del pezzo verso l’interno del pezzo.
note-position-over-stud-centre = Programmare un blocco di posizionamento sul punto di partenza (centro dell’isola) nel piano di lavoro con correzione del raggio R0.
note-offset-at-front-determined-before = Determinare l’offset per la svasatura frontale prima di utilizzare il ciclo. Inserirlo come distanza dal centro dell’isola al centro dell’utensile, senza compensazione.
note-internal-coolant-for-thread-milling = La macchina dovrebbe essere dotata di raffreddamento interno attraverso il mandrino: refrigerante almeno 30 bar, aria compressa almeno 6 bar.
note-profile-correction-by-delta-radius = La fresatura di filetti deforma spesso il profilo del filetto e richiede quindi correzioni specifiche per l’utensile, riportate nel catalogo utensili o fornite dal produttore dell’utensile. La correzione si inserisce nel blocco TOOL CALL con il valore delta { $mp-delta-radius }.
note-clockwise-tools-only = Il ciclo può essere impiegato solo con utensili a rotazione oraria.
note-tools-of-both-rotations = Il ciclo può essere impiegato con utensili a rotazione oraria e antioraria.
note-direction-of-inside-thread = La direzione di lavoro dipende dal segno del passo del filetto { $q-thread-pitch } e dal tipo di fresatura { $q-milling-type }. Con utensili a rotazione oraria un filetto interno viene fresato verso Z+ se è destrorso (+) con fresatura concorde (+1, RL) o sinistrorso (−) con fresatura discorde (−1, RR), e verso Z− se è destrorso (+) con fresatura discorde (−1, RR) o sinistrorso (−) con fresatura concorde (+1, RL).
note-direction-of-outside-thread = La direzione di lavoro dipende dal segno del passo del filetto { $q-thread-pitch } e dal tipo di fresatura { $q-milling-type }. Con utensili a rotazione oraria un filetto esterno viene fresato verso Z− se è destrorso (+) con fresatura concorde (+1, RL) o sinistrorso (−) con fresatura discorde (−1, RR), e verso Z+ se è destrorso (+) con fresatura discorde (−1, RR) o sinistrorso (−) con fresatura concorde (+1, RL).
note-feed-of-cutting-edge = Nella fresatura di filetti l’avanzamento programmato vale per il tagliente. Il controllo visualizza l’avanzamento del centro dell’utensile, perciò il valore visualizzato è diverso da quello programmato.
note-mirroring-turns-thread = Il senso del filetto cambia se il ciclo viene eseguito insieme al ciclo 8 (lavorazione speculare) in un solo asse.
note-same-signs-of-depths = Pericolo di collisione! Inserire sempre lo stesso segno per tutte le profondità, poiché i cicli contengono più sequenze indipendenti tra loro. Per ripetere ad esempio soltanto la svasatura, inserire 0 come profondità di filettatura; la direzione di lavoro viene allora determinata dalla profondità di svasatura.
note-same-signs-of-depths__outside-thread-milling = Pericolo di collisione! Inserire sempre lo stesso segno per tutte le profondità, poiché i cicli contengono più sequenze indipendenti tra loro. Per ripetere ad esempio soltanto la svasatura frontale, inserire 0 come profondità di filettatura; la direzione di lavoro viene allora determinata dalla profondità frontale.
note-tool-breakage-in-thread = Se l’utensile si rompe durante il taglio del filetto: arrestare l’esecuzione del programma, passare al modo operativo Introduzione manuale dati e portare l’utensile su una retta al centro del foro. Poi disimpegnare l’utensile nell’asse di incremento e sostituirlo.
note-tool-breakage-in-thread__outside-thread-milling = Se l’utensile si rompe durante il taglio del filetto: arrestare l’esecuzione del programma, passare al modo operativo Introduzione manuale dati e allontanare l’utensile dal filetto su una retta. Poi disimpegnare l’utensile nell’asse di incremento e sostituirlo.
