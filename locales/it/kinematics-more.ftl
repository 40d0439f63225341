# Cycles that save the kinematics and compensate the preset.

# --- 450 ---
cycle-save-kinematics = Salva cinematica
    .nc = SALVA CINEMATICA
    .purpose = Salva la cinematica attiva della macchina o ripristina una cinematica salvata in precedenza. I dati salvati possono essere visualizzati e cancellati.
cycle-save-kinematics__itnc530 =
    .purpose = Salva la cinematica attiva della macchina, ripristina una cinematica salvata in precedenza o visualizza lo stato attuale della memoria sullo schermo e in un protocollo.
condition-memory-location-used = { $q-kinematics-memory-mode } è diverso da 2
step-treat-saved-kinematics = Il controllo elabora la cinematica in base al modo { $q-kinematics-memory-mode }:
say-save-active-kinematics = 0: salva la cinematica attiva in { $q-kinematics-memory-location }
say-restore-saved-kinematics = 1: ripristina la cinematica salvata in { $q-kinematics-memory-location }
say-show-saved-kinematics = 2: visualizza lo stato attuale della memoria
say-delete-saved-kinematics = 3: cancella i record di dati indicati in { $q-kinematics-memory-location }
note-save-before-optimization = Prima di ottimizzare la cinematica salvare sempre la cinematica attiva.
note-kinematics-memory-size = Sono disponibili 16 locazioni di memoria.
note-kinematics-memory-size__itnc530 = Sono disponibili 10 locazioni di memoria, con i numeri da 0 a 9.
note-restore-only-into-identical-kinematics = Con il modo ripristino i dati salvati possono essere ripristinati solo in una descrizione della cinematica identica a quella di origine.
note-preset-changes-with-kinematics__save-kinematics = Una modifica della cinematica, e quindi anche il suo ripristino, modifica sempre anche il Preset. Se necessario, impostare di nuovo il Preset.
note-kinematics-memory-wildcards = Se più record di dati corrispondono ai caratteri jolly di { $q-kinematics-memory-location }, il controllo ripristina i valori medi dei dati (modo 1) oppure, dopo conferma, li cancella tutti (modo 3).
note-kinematics-memory-file = Il controllo memorizza i dati salvati nel file TNC:\table\DATA450.KD. Questo file può essere salvato su un computer esterno, ad esempio con TNCremo, in modo da poterlo ripristinare in caso di guasto del disco. Se il file viene cancellato, i dati salvati vanno persi. Se non esiste, il controllo lo crea all’esecuzione del ciclo 450.
note-kinematics-memory-file-by-hand = Non modificare manualmente i dati salvati nel file TNC:\table\DATA450.KD: i record di dati potrebbero danneggiarsi e diventare inutilizzabili.
note-kinematics-memory-code-number = Nel modo «salva» il controllo memorizza sempre anche l’ultimo numero codice inserito in MOD; è possibile definire un numero codice qualsiasi. In seguito la locazione di memoria può essere sovrascritta solo inserendo questo numero codice.
note-overwritten-without-question = Se una cinematica è stata salvata senza numero codice, al salvataggio successivo il controllo ne sovrascrive la locazione di memoria senza richiesta di conferma.
note-kinematics-memory-log-contents = Dopo il ciclo 450 il controllo crea un protocollo (TCHPR450.TXT) che contiene data e ora, il percorso del programma NC, il modo (0=salva/1=ripristina/2=stato memoria/3=cancella), l’identificativo della cinematica attiva e l’identificativo del record di dati inserito. Il modo 0 aggiunge tutte le voci di assi e trasformazioni della catena cinematica salvata, il modo 1 tutte le voci delle trasformazioni prima e dopo il ripristino, il modo 2 un elenco dei record di dati salvati, il modo 3 un elenco dei record cancellati.
note-kinematics-memory-log-contents__itnc530 = Dopo il ciclo 450 il controllo crea un protocollo (TCHPR450.TXT) che contiene data e ora, il percorso del programma NC, il modo (0=salva/1=ripristina/2=stato memoria), il numero della locazione di memoria (da 0 a 9), il numero di riga della cinematica nella tabella cinematica e il numero codice, se inserito direttamente prima del ciclo 450. Il modo 0 aggiunge tutte le voci di assi e trasformazioni della catena cinematica salvata, il modo 1 tutte le voci delle trasformazioni prima e dopo il ripristino, il modo 2 un elenco dello stato attuale della memoria, sullo schermo e nel protocollo, con locazione di memoria, numeri codice, numero della cinematica e data di salvataggio.
title-save-active-kinematics = Salvare la cinematica attiva
title-restore-saved-kinematics = Ripristinare record di dati
title-show-saved-kinematics = Visualizzare tutti i record di dati salvati
title-delete-saved-kinematics = Cancellare record di dati
title-save-before-calibration = Salvare la cinematica prima di un programma di calibrazione
table-kinematics-memory = Cinematiche salvate

# --- 452 ---
cycle-preset-compensation = Compensazione Preset
    .nc = COMPENSAZ. PRESET
    .purpose = Ottimizza la catena di trasformazione cinematica della macchina. Il controllo corregge poi anche il sistema di coordinate del pezzo nel modello cinematico, in modo che dopo l’ottimizzazione il Preset si trovi al centro della sfera calibrata. In questo modo è possibile tarare tra loro teste intercambiabili o compensare la deriva della macchina.
    .nc-aliases = COMPENSAZIONE PRESET
group-match-interchangeable-heads = Taratura di teste intercambiabili
group-compensate-drift = Compensazione della deriva, se durante la lavorazione la sfera calibrata può rimanere sulla tavola della macchina
group-measure-and-compensate = Misurazione e compensazione
step-clamp-calibration-sphere = Serrare la sfera calibrata.
step-measure-reference-head = Misurare completamente la testa di riferimento con il ciclo 451, facendo impostare al ciclo 451 anche il Preset al centro della sfera.
step-insert-second-head = Inserire la seconda testa.
step-measure-second-head = Misurare la testa intercambiabile con il ciclo { $cycle } fino all’interfaccia di cambio testa.
step-match-further-heads = Tarare le altre teste intercambiabili sulla testa di riferimento con il ciclo { $cycle }.
step-set-preset-in-sphere = Impostare il Preset nella sfera calibrata.
step-set-preset-on-workpiece = Impostare il Preset sul pezzo e avviare la lavorazione.
step-compensate-at-intervals = Compensare il Preset a intervalli regolari con il ciclo { $cycle }: il controllo determina la deriva degli assi interessati e la corregge nella cinematica.
step-optimize-transformation-chain = Il controllo ottimizza la catena di trasformazione cinematica della macchina.
step-correct-workpiece-system = Il controllo corregge il sistema di coordinate del pezzo nel modello cinematico, in modo che il Preset si trovi al centro della sfera calibrata.
note-datum-in-sphere-first__preset-compensation = Prima della definizione del ciclo impostare e attivare l’origine al centro della sfera calibrata.
note-one-degree-before-limit-switch = Per assi senza encoder di posizione separato scegliere i punti di misura in modo che fino al finecorsa rimanga una corsa di 1°. Il controllo ha bisogno di questo percorso per la compensazione interna del gioco.
note-kinematics-limit-exceeded__preset-compensation = Se i dati cinematici superano il limite ammesso ({ $mp-max-modification }), il controllo emette un avvertimento. Confermare con Avvio NC l’acquisizione dei valori.
note-match-heads-purpose = La taratura di teste intercambiabili lascia invariato il Preset del pezzo dopo il cambio di assi rotativi (teste). Inserire una delle teste come testa di riferimento, serrare la sfera calibrata, inserire il sistema di tastatura, misurare la cinematica completa con il ciclo 451, che imposta anche il Preset dopo la misurazione (Q431=2 o 3). Inserire poi la testa successiva e il sistema di tastatura e misurarla con il ciclo { $cycle }. Tutte le altre teste possono essere tarate nello stesso modo.
note-match-heads-only-changed-axes = Misurare soltanto gli assi effettivamente sostituiti. Esempio: una testa a forcella con gli assi A e C, di cui viene sostituito solo l’asse A; l’asse C viene escluso con { $q-rotary-measuring-points-c }=0.
note-preset-and-sphere-stay = Per tutta la procedura lasciare invariati il Preset e la posizione della sfera calibrata.
note-drift-purpose = Durante la lavorazione i componenti della macchina sono soggetti a deriva a causa delle mutevoli influenze ambientali. Se la deriva è sufficientemente costante sul campo di traslazione e la sfera calibrata può rimanere sulla tavola della macchina, il ciclo { $cycle } la determina e la compensa. Serrare la sfera calibrata, inserire il sistema di tastatura, misurare la cinematica completa con il ciclo 451 prima dell’inizio della lavorazione, facendo impostare il Preset dopo la misurazione (Q431=2 o 3), quindi impostare i Preset dei pezzi e avviare la lavorazione. A intervalli regolari inserire il sistema di tastatura, attivare il Preset nella sfera calibrata e misurare la cinematica con il ciclo { $cycle }.
note-drift-without-rotary-axes = La deriva può essere compensata anche su macchine senza assi rotativi.
note-kinematics-prepared-for-preset = La cinematica deve essere predisposta per la compensazione Preset. Consultare il manuale della macchina.
note-head-change-is-machine-function = Il cambio testa è una funzione della macchina. Consultare il manuale della macchina.
note-kinematics-log-contents__preset-compensation = Il protocollo contiene data e ora, il percorso del programma NC, il numero della cinematica attiva e il raggio della sfera inserito; per ogni asse rotativo misurato: angolo di partenza, angolo finale, angolo di registrazione, numero dei punti di misura, dispersione (scostamento standard), errore massimo, errore angolare, gioco medio, errore di posizionamento medio, raggio del cerchio di misura, valori di correzione in tutti gli assi (spostamento Preset) e imprecisione di misura degli assi rotativi.
note-kinematics-log-contents__preset-compensation__itnc530 = Il protocollo contiene data e ora, il percorso del programma NC, il numero della cinematica attiva e il raggio della sfera inserito; per ogni asse rotativo misurato: angolo di partenza, angolo finale, angolo di registrazione, numero dei punti di misura, dispersione (scostamento standard), errore massimo, errore angolare, gioco medio, errore di posizionamento medio, raggio del cerchio di misura, valori di correzione in tutti gli assi (spostamento Preset), valutazione dei punti di misura e imprecisione di misura degli assi rotativi.
note-kinematics-log-explained__preset-compensation = Dispersione misurata: il 68,3% degli errori nello spazio misurati rientra in ± questo valore; ottimizzata: il 68,3% degli errori previsti dopo la correzione. La valutazione dei punti di misura è una misura della qualità delle posizioni di misura rispetto alle trasformazioni modificabili del modello: quanto più è alta, tanto migliore è l’ottimizzazione. Non dovrebbe essere inferiore a 2 per nessun asse rotativo, meglio se 4 o più; se è bassa, ampliare il campo di misura dell’asse o aumentare il numero dei punti. Se ciò non basta, la descrizione della cinematica potrebbe essere errata; se necessario, rivolgersi al Servizio Assistenza.
title-compensate-preset = Programma di calibrazione
title-match-interchangeable-head = Taratura di una testa intercambiabile
title-compensate-drift = Compensazione deriva

# --- kinematics ---
message-backlash-angle-too-small = Il gioco rilevato non è molto minore dell’angolo inserito in { $q-backlash-angle }: può essere maggiore di quello misurato. Inserire un angolo più grande e ripetere la misura.
message-kinematics-limit-exceeded = I dati cinematici cambiano oltre il valore limite ammesso. Confermarne l’acquisizione con Avvio NC.
message-delete-saved-kinematics = Al nome corrispondono più cinematiche salvate. Confermare la cancellazione di tutte.
