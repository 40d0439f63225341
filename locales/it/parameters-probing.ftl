# Parameters of the workpiece touch-probe cycles; see the English file.

# --- old form ---
parameter-result-parameter = Nr. parametro per risultato
    .help = Numero del parametro Q al quale viene assegnata la coordinata.
parameter-probing-direction = Asse di tastatura / direzione di tastatura
    .help = Asse di tastatura, inserito con il tasto asse o con la tastiera alfabetica, e segno della direzione di tastatura. Confermare con ENT.
parameter-probing-position = Valore di posizione
    .help = Tutte le coordinate per il preposizionamento del sistema di tastatura, inserite con i tasti asse o con la tastiera alfabetica. Terminare l’inserimento con il tasto ENT.
parameter-probing-position__tnc640 =
    .help = Tutte le coordinate per il preposizionamento del sistema di tastatura, inserite con i tasti asse o con la tastiera alfabetica. Terminare l’inserimento con il tasto END.

# --- the feature ---
parameter-probing-centre-main = Centro 1° asse
    .label = CENTRO 1° ASSE
    .help = Centro del foro nell’asse principale del piano di lavoro.
parameter-probing-centre-main__datum-inside-circle =
    .help = Centro della tasca nell’asse principale del piano di lavoro.
parameter-probing-centre-minor = Centro 2° asse
    .label = CENTRO 2° ASSE
    .help = Centro del foro nell’asse secondario del piano di lavoro.
parameter-probing-centre-minor__datum-inside-circle =
    .help = Centro della tasca nell’asse secondario del piano di lavoro.
parameter-probing-nominal-diameter = Diametro nominale
    .label = DIAMETRO NOMINALE
    .help = Diametro del foro.
parameter-probing-nominal-diameter__datum-inside-circle =
    .help = Diametro approssimativo della tasca circolare (foro). Inserire un valore piuttosto troppo piccolo che troppo grande.
parameter-probing-starting-angle = Angolo di partenza
    .label = ANGOLO DI PARTENZA
    .help = Angolo tra l’asse principale del piano di lavoro e il primo punto di tastatura.
parameter-probing-stepping-angle = Angolo incrementale
    .label = ANGOLO INCREMENTALE
    .help = Angolo tra due punti di misura. Il segno dell’angolo incrementale determina il senso di rotazione in cui il sistema di tastatura si porta al punto di misura successivo (negativo: senso orario). Per tastare un arco di cerchio invece di un cerchio completo, programmare un angolo incrementale minore di 90°.

# --- probing ---
parameter-measuring-height = Altezza di misura nell’asse del tastatore
    .label = ALTEZZA DI MISURA
    .help = Coordinata del centro della sfera (punto di tastatura) nell’asse del tastatore alla quale viene eseguita la misurazione.
parameter-probing-clearance = Distanza di sicurezza
    .label = DISTANZA SICUREZZA
    .help = Distanza addizionale tra il punto di misura e la sfera del tastatore. Si somma a { $mp-set-up }.
parameter-probing-clearance__itnc530 = DISTANZA DI SICUREZZA
parameter-clearance-height = Altezza di sicurezza
    .label = ALTEZZA DI SICUREZZA
    .help = Coordinata nell’asse del tastatore che esclude qualsiasi collisione tra il sistema di tastatura e il pezzo (o i dispositivi di bloccaggio).
parameter-clearance-height__probing-3d =
    .help = Coordinata nell’asse utensile che esclude qualsiasi collisione tra il sistema di tastatura e il pezzo (o i dispositivi di bloccaggio).
parameter-traverse-to-clearance-height = Spostamento ad altezza di sicurezza
    .label = SPOST. AD ALT. SICUR.
    .help = Modalità con cui il sistema di tastatura si sposta tra i punti di misura.
choice-travel-at-measuring-height = spostamento all’altezza di misura tra i punti di misura
choice-travel-at-measuring-height__tnc426-430 = spostamento circolare all’altezza di misura tra i punti di misura
choice-travel-at-clearance-height = spostamento all’altezza di sicurezza tra i punti di misura
choice-travel-at-clearance-height__tnc426-430 = spostamento circolare all’altezza di sicurezza tra i punti di misura
parameter-number-of-touch-points = Numero di punti di misura (4/3)
    .label = N. PUNTI MISURATI
    .help = Definire se il foro viene misurato con quattro o con tre tastature.
choice-four-touch-points = quattro punti di misura (impostazione standard)
choice-three-touch-points = tre punti di misura
parameter-probing-traverse-type = Tipo di traiettoria? Retta=0/cerchio=1
    .prompt = Tipo di traiettoria? Retta=0/cerchio=1
    .label = TIPO DI TRAIETTORIA
    .prompt = Tipo di traiettoria? Retta=0/cerchio=1
    .help = Traiettoria sulla quale il sistema di tastatura si sposta tra i punti di misura, se lo spostamento avviene all’altezza di sicurezza ({ $q-traverse-to-clearance-height }=1).
choice-traverse-straight = spostamento su una retta
choice-traverse-on-circle = spostamento su un arco del diametro del cerchio parziale

# --- the datum ---
parameter-datum-row-number = Numero origine nella tabella
    .label = NR. NELLA TABELLA
    .help = Numero nella tabella origini o nella tabella Preset con il quale vengono memorizzate le coordinate del centro della tasca. Con 0 il controllo imposta la visualizzazione in modo che la nuova origine si trovi al centro della tasca.
parameter-datum-row-number__tnc426-430 =
    .help = Numero nella tabella origini con il quale vengono memorizzate le coordinate del centro della tasca. Con 0 il controllo imposta la visualizzazione in modo che la nuova origine si trovi al centro della tasca.
parameter-new-datum-main = Nuova origine asse principale
    .label = ORIGINE
    .help = Coordinata nell’asse principale sulla quale viene impostato il centro della tasca rilevato. Impostazione base: 0.
parameter-new-datum-minor = Nuova origine asse secondario
    .label = ORIGINE
    .help = Coordinata nell’asse secondario sulla quale viene impostato il centro della tasca rilevato. Impostazione base: 0.
parameter-measured-value-transfer = Trasferimento valore misurato (0,1)
    .label = TRASF. VALORE MISURATO
    .help = Definire se l’origine rilevata viene memorizzata nella tabella origini o nella tabella Preset.
choice-transfer-from-old-program = non utilizzare; il controllo inserisce questo valore al caricamento di vecchi programmi
choice-transfer-to-datum-table = scrivere l’origine rilevata nella tabella origini attiva; il sistema di riferimento è il sistema di coordinate del pezzo attivo
choice-transfer-to-preset-table = scrivere l’origine rilevata nella tabella Preset; il sistema di riferimento è il sistema di coordinate della macchina (sistema REF)
parameter-probing-in-probe-axis = Tastatura nell’asse del tastatore
    .label = TASTATURA ASSE TAST.
    .help = Definire se l’origine viene impostata anche nell’asse del tastatore.
choice-no-datum-in-probe-axis = non impostare l’origine nell’asse del tastatore
choice-datum-in-probe-axis = impostare l’origine nell’asse del tastatore
parameter-probe-axis-point-main = Tastatura asse del tastatore: coordinata 1° asse
    .label = 1ª COORD. ASSE TAST.
    .help = Coordinata nell’asse principale del piano di lavoro del punto in cui viene impostata l’origine nell’asse del tastatore.
parameter-probe-axis-point-minor = Tastatura asse del tastatore: coordinata 2° asse
    .label = 2ª COORD. ASSE TAST.
    .help = Coordinata nell’asse secondario del piano di lavoro del punto in cui viene impostata l’origine nell’asse del tastatore.
parameter-probe-axis-point-tool = Tastatura asse del tastatore: coordinata 3° asse
    .label = 3ª COORD. ASSE TAST.
    .help = Coordinata nell’asse del tastatore del punto in cui viene impostata l’origine nell’asse del tastatore.
parameter-new-datum-probe-axis = Nuova origine asse del tastatore
    .label = ORIGINE
    .help = Coordinata nell’asse del tastatore sulla quale viene impostata l’origine. Impostazione base: 0.

# --- limits and reports ---
parameter-hole-greatest-diameter = Quota massima foro
    .label = QUOTA MASSIMA
    .help = Diametro massimo ammesso del foro (tasca circolare).
parameter-hole-least-diameter = Quota minima foro
    .label = QUOTA MINIMA
    .help = Diametro minimo ammesso del foro (tasca circolare).
parameter-centre-tolerance-main = Tolleranza centro 1° asse
    .label = TOLLERANZA 1° CENTRO
    .help = Scostamento di posizione ammesso nell’asse principale del piano di lavoro.
parameter-centre-tolerance-minor = Tolleranza centro 2° asse
    .label = TOLLERANZA 2° CENTRO
    .help = Scostamento di posizione ammesso nell’asse secondario del piano di lavoro.
parameter-measuring-log = Protocollo di misura
    .label = PROTOCOLLO DI MISURA
    .help = Definire se il controllo crea un protocollo di misura.
choice-no-measuring-log = senza protocollo di misura
choice-measuring-log-to-file = con protocollo di misura: il controllo memorizza per default il file di protocollo TCHPR{ $cycle }.TXT nella directory TNC:\
choice-measuring-log-to-file__tnc426-430 = con protocollo di misura: il controllo memorizza per default il file di protocollo TCHPR{ $cycle }.TXT nella directory del programma di misura
choice-measuring-log-on-screen = interrompere l’esecuzione del programma e visualizzare il protocollo di misura sullo schermo; proseguire il programma con Avvio NC
parameter-stop-on-tolerance-error = Arresto programma per errore di tolleranza
    .label = ARRESTO PGM SE ERRORE
    .help = Definire se in caso di superamento di una tolleranza il controllo interrompe l’esecuzione del programma e visualizza un messaggio d’errore.
choice-no-stop-on-tolerance-error = non interrompere l’esecuzione del programma, nessun messaggio d’errore
choice-stop-on-tolerance-error = interrompere l’esecuzione del programma, visualizzare un messaggio d’errore
parameter-monitored-tool = Utensile per controllo
    .label = UTENSILE
    .help = Definire se viene eseguito il controllo utensile. Numero o nome dell’utensile.
parameter-monitored-tool__tnc320 = Numero utensile per controllo
    .label = NUMERO UTENSILE
    .help = Definire se viene eseguito il controllo utensile. Numero dell’utensile.
parameter-monitored-tool__tnc426-430 = Numero utensile per controllo
    .label = NUMERO UTENSILE
    .help = Definire se viene eseguito il controllo utensile. Numero dell’utensile.
choice-no-tool-monitoring = controllo utensile non attivo
choice-monitored-tool-number = numero utensile della tabella utensili TOOL.T

# --- a point on a surface ---
parameter-surface-point-main = 1° punto di misura 1° asse
    .label = 1° PUNTO 1° ASSE
    .prompt = 1° punto di misura 1° asse?
    .help = Coordinata nominale del punto di tastatura nell’asse principale del piano di lavoro.
parameter-surface-point-minor = 1° punto di misura 2° asse
    .label = 1° PUNTO 2° ASSE
    .prompt = 1° punto di misura 2° asse?
    .help = Coordinata nominale del punto di tastatura nell’asse secondario del piano di lavoro.
parameter-surface-point-tool = 1° punto di misura 3° asse
    .label = 1° PUNTO 3° ASSE
    .prompt = 1° punto di misura 3° asse?
    .help = Coordinata nominale del punto di tastatura nell’asse del tastatore.
parameter-surface-normal-main = Normale alla superficie asse principale
    .label = NORMALE ASSE PRINCIPALE
    .prompt = Normale alla superficie asse principale?
    .help = Componente della normale alla superficie nell’asse principale. La normale di un punto viene di solito fornita da un sistema CAD/CAM.
parameter-surface-normal-minor = Normale alla superficie asse secondario
    .label = NORMALE ASSE SECONDARIO
    .prompt = Normale alla superficie asse secondario?
    .help = Componente della normale alla superficie nell’asse secondario. La normale di un punto viene di solito fornita da un sistema CAD/CAM.
parameter-surface-normal-tool = Normale alla superficie asse utensile
    .label = NORMALE ASSE UTENSILE
    .prompt = Normale alla superficie asse utensile?
    .help = Componente della normale alla superficie nell’asse utensile. La normale di un punto viene di solito fornita da un sistema CAD/CAM.
parameter-tolerance-specification = Indicazione tolleranza
    .label = TOLLERANZA
    .prompt = Indicazione tolleranza?
    .help = Campo di tolleranza controllato dal ciclo: scostamento ammesso delle coordinate reali da quelle nominali lungo la normale alla superficie ({ $q-surface-normal-main }, { $q-surface-normal-minor }, { $q-surface-normal-tool }). Viene ripartito tra gli assi in base al vettore normale.
parameter-tolerance-error-reaction = Reazione a errore di tolleranza
    .label = REAZIONE A ERRORE
    .prompt = Reazione a errore di tolleranza?
    .help = Definire se in caso di scostamento del punto il controllo interrompe l’esecuzione del programma e visualizza un messaggio.
choice-reaction-none = se la tolleranza viene superata, l’esecuzione del programma non viene interrotta e non viene visualizzato alcun messaggio
choice-reaction-stop = se la tolleranza viene superata, l’esecuzione del programma viene interrotta
choice-reaction-stop-below-nominal = se la posizione reale lungo la normale alla superficie si trova al di sotto della coordinata nominale, il controllo visualizza un messaggio e interrompe il programma; se si trova al di sopra, non segue alcuna reazione
