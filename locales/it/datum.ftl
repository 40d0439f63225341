# Cycles that set a datum; see the English file.

# --- 412 ---
cycle-datum-inside-circle = Impostazione origine cerchio interno (foro)
    .nc = ORIGINE CERCHIO INT.
    .purpose = Misura il centro di una tasca circolare o di un foro e lo imposta come origine. A scelta, il controllo scrive il centro anche in una tabella origini o nella tabella Preset.
cycle-datum-inside-circle__tnc426-430 =
    .purpose = Misura il centro di una tasca circolare o di un foro e lo imposta come origine. A scelta, il controllo scrive il centro anche in una tabella origini.
step-retract-and-store-datum = Il controllo riporta il sistema di tastatura all’altezza di sicurezza { $q-clearance-height }, memorizza i valori reali nei parametri di risultato e imposta o memorizza l’origine rilevata in base a { $q-measured-value-transfer } e { $q-datum-row-number }:
step-retract-and-store-datum__tnc426-430 = Il controllo riporta il sistema di tastatura all’altezza di sicurezza { $q-clearance-height } e imposta o memorizza l’origine rilevata in base a { $q-datum-row-number }:
say-datum-into-display-and-row-zero = con { $q-datum-row-number }=0 imposta l’origine rilevata nella visualizzazione; l’origine è subito attiva e viene memorizzata anche nella riga 0 della tabella Preset
say-datum-into-display = con { $q-datum-row-number }=0 imposta l’origine rilevata nella visualizzazione; l’origine è subito attiva
say-datum-into-datum-table = con { $q-datum-row-number } diverso da 0 e { $q-measured-value-transfer }=0 scrive l’origine rilevata nella riga { $q-datum-row-number } della tabella origini attiva; il sistema di riferimento è il sistema di coordinate del pezzo attivo
say-datum-into-datum-table__tnc426-430 = con { $q-datum-row-number } diverso da 0 scrive l’origine rilevata nella riga { $q-datum-row-number } della tabella origini attiva
say-datum-into-preset-table = con { $q-datum-row-number } diverso da 0 e { $q-measured-value-transfer }=1 scrive l’origine rilevata nella riga { $q-datum-row-number } della tabella Preset; il sistema di riferimento è il sistema di coordinate della macchina (coordinate REF)
step-probe-in-probe-axis = A scelta, il controllo rileva poi con una tastatura separata l’origine nell’asse del tastatore:
say-datum-in-probe-axis = con { $q-probing-in-probe-axis }=1 tasta il punto { $q-probe-axis-point-main }, { $q-probe-axis-point-minor }, { $q-probe-axis-point-tool } nell’asse del tastatore, ritrae il sistema di tastatura e imposta o memorizza l’origine { $q-new-datum-probe-axis } come quella del piano di lavoro
guard-datum-transfer-undefined = { $q-datum-row-number } è diverso da 0 e { $q-measured-value-transfer } è −1: definire dove deve essere memorizzata l’origine rilevata.
guard-transformation-with-probe-axis-datum = È attivo uno spostamento origine o una rotazione, ma { $q-measured-value-transfer }=0 e { $q-probing-in-probe-axis }=1 non ammettono alcuna conversione di coordinate.
note-nominal-diameter-rather-small = Pericolo di collisione! Per evitare una collisione tra il sistema di tastatura e il pezzo, inserire per la tasca (foro) un diametro nominale approssimato per difetto.
note-probing-from-centre-if-narrow = Se le dimensioni della tasca e la distanza di sicurezza non consentono un preposizionamento vicino ai punti di tastatura, il controllo inizia sempre la tastatura dal centro della tasca. In tal caso, tra i punti di misura il sistema di tastatura non si porta all’altezza di sicurezza.
note-no-transformation-with-probe-axis-datum = Se il ciclo imposta un’origine con { $q-measured-value-transfer }=0 ed esegue anche la tastatura nell’asse del tastatore ({ $q-probing-in-probe-axis }=1), non deve essere attiva alcuna conversione di coordinate.
note-no-tilting-with-datum-cycles = La rotazione del piano di lavoro non è ammessa in combinazione con i cicli di impostazione dell’origine da 408 a 419.
note-datum-cycles-with-basic-rotation = I cicli di impostazione dell’origine da 408 a 419 possono essere eseguiti anche con una rotazione base attiva.
note-datum-cycles-with-basic-rotation__tnc640 = I cicli di impostazione dell’origine da 408 a 419 possono essere eseguiti anche con una rotazione attiva (rotazione base o ciclo 10).
note-basic-rotation-must-stay = Non modificare l’angolo della rotazione base se dopo il ciclo di misura viene utilizzato uno spostamento origine (ciclo 7) dalla tabella origini.
note-no-datum-cycles-with-basic-rotation = I cicli di impostazione dell’origine da 410 a 418 non devono essere eseguiti con una rotazione base attiva. In caso contrario il controllo visualizza un messaggio d’errore.
note-datum-axes-by-probe-axis = L’asse del tastatore definito nel programma di misura determina gli assi in cui viene impostata l’origine: Z: X e Y; Y: Z e X; X: Y e Z.
note-datum-axes-by-probe-axis__tnc426-430 = L’asse del tastatore definito nel programma di misura determina gli assi in cui viene impostata l’origine: Z o W: X e Y; Y o V: Z e X; X o U: Y e Z.
note-transfer-minus-one = { $q-datum-row-number } diverso da 0 insieme a { $q-measured-value-transfer }=−1 si presenta solo con programmi contenenti i cicli da 410 a 418 provenienti da un TNC 4xx o da versioni software precedenti dell’iTNC 530, oppure se il trasferimento non è stato definito nella definizione del ciclo. In tal caso il controllo visualizza un messaggio d’errore, poiché la gestione delle tabelle origini riferite all’origine della macchina è cambiata; definire il trasferimento.
note-activate-stored-datum = Un’origine memorizzata nella tabella origini viene attivata nel programma con il ciclo 7, una memorizzata nella tabella Preset con il ciclo 247.
note-datum-table-must-be-active = Per scrivere l’origine rilevata in una tabella origini, attivarne una in un modo operativo di esecuzione del programma (stato M) prima di avviare il programma di misura.
note-datum-table-reference = Durante la scrittura nella tabella origini il controllo tiene conto di { $mp-datum-table-reference }: 0: valori riferiti all’origine del pezzo; 1: valori riferiti all’origine della macchina. Se { $mp-datum-table-reference } viene modificato in seguito, il controllo converte i valori memorizzati nelle tabelle origini.
