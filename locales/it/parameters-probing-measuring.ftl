# Parameters of the cycles that measure angles, studs, rectangles, widths, coordinates, bolt-hole circles and planes; see the English file.

# --- 422 ---
parameter-probing-centre-main__measure-stud =
    .help = Centro dell’isola nell’asse principale del piano di lavoro.
parameter-probing-centre-minor__measure-stud =
    .help = Centro dell’isola nell’asse secondario del piano di lavoro.
parameter-probing-nominal-diameter__measure-stud =
    .help = Diametro dell’isola.
parameter-number-of-touch-points__measure-stud =
    .help = Definire se l’isola viene misurata con quattro o con tre tastature.
parameter-stud-greatest-diameter = Quota massima isola
    .label = QUOTA MASSIMA
    .help = Diametro massimo ammesso dell’isola.
parameter-stud-least-diameter = Quota minima isola
    .label = QUOTA MINIMA
    .help = Diametro minimo ammesso dell’isola.

# --- 423, 424 ---
parameter-probing-centre-main__measure-rectangular-pocket =
    .help = Centro della tasca nell’asse principale del piano di lavoro.
parameter-probing-centre-minor__measure-rectangular-pocket =
    .help = Centro della tasca nell’asse secondario del piano di lavoro.
parameter-probing-centre-main__measure-rectangular-stud =
    .help = Centro dell’isola nell’asse principale del piano di lavoro.
parameter-probing-centre-minor__measure-rectangular-stud =
    .help = Centro dell’isola nell’asse secondario del piano di lavoro.
parameter-probing-first-side-length = Lunghezza 1° lato
    .label = LUNGHEZZA 1° LATO
    .help = Lunghezza della tasca, parallela all’asse principale del piano di lavoro.
parameter-probing-first-side-length__measure-rectangular-stud =
    .help = Lunghezza dell’isola, parallela all’asse principale del piano di lavoro.
parameter-probing-second-side-length = Lunghezza 2° lato
    .label = LUNGHEZZA 2° LATO
    .help = Lunghezza della tasca, parallela all’asse secondario del piano di lavoro.
parameter-probing-second-side-length__measure-rectangular-stud =
    .help = Lunghezza dell’isola, parallela all’asse secondario del piano di lavoro.
parameter-first-side-greatest-length = Quota massima lunghezza 1° lato
    .label = QUOTA MASSIMA 1° LATO
    .help = Lunghezza massima ammessa della tasca.
parameter-first-side-greatest-length__measure-rectangular-stud =
    .help = Lunghezza massima ammessa dell’isola.
parameter-first-side-least-length = Quota minima lunghezza 1° lato
    .label = QUOTA MINIMA 1° LATO
    .help = Lunghezza minima ammessa della tasca.
parameter-first-side-least-length__measure-rectangular-stud =
    .help = Lunghezza minima ammessa dell’isola.
parameter-second-side-greatest-length = Quota massima lunghezza 2° lato
    .label = QUOTA MASSIMA 2° LATO
    .help = Larghezza massima ammessa della tasca.
parameter-second-side-greatest-length__measure-rectangular-stud =
    .help = Larghezza massima ammessa dell’isola.
parameter-second-side-least-length = Quota minima lunghezza 2° lato
    .label = QUOTA MINIMA 2° LATO
    .help = Larghezza minima ammessa della tasca.
parameter-second-side-least-length__measure-rectangular-stud =
    .help = Larghezza minima ammessa dell’isola.

# --- 425, 426 ---
parameter-probing-start-main = Punto di partenza 1° asse
    .label = PUNTO PARTENZA 1° ASSE
    .help = Punto di partenza della tastatura nell’asse principale del piano di lavoro.
parameter-probing-start-minor = Punto di partenza 2° asse
    .label = PUNTO PARTENZA 2° ASSE
    .help = Punto di partenza della tastatura nell’asse secondario del piano di lavoro.
parameter-second-measurement-offset = Offset per 2ª misurazione
    .label = OFFSET 2ª MISURAZIONE
    .help = Valore di cui viene spostato il sistema di tastatura prima della seconda misurazione. Con 0 il controllo non sposta il sistema di tastatura.
parameter-nominal-length = Lunghezza nominale
    .label = LUNGHEZZA NOMINALE
    .help = Valore nominale della lunghezza da misurare.
parameter-greatest-dimension = Quota massima
    .label = QUOTA MASSIMA
    .help = Lunghezza massima ammessa.
parameter-least-dimension = Quota minima
    .label = QUOTA MINIMA
    .help = Lunghezza minima ammessa.
parameter-probing-clearance__measure-slot-width =
    .help = Distanza supplementare tra punto di misura e sfera del tastatore. Si somma a { $mp-set-up } e ha effetto solo nella tastatura dell’origine nell’asse del tastatore.

# --- 427 ---
parameter-measuring-axis__measure-coordinate = Asse di misura (1...3: 1=asse principale)
    .help = Asse nel quale viene eseguita la misurazione.
parameter-greatest-dimension__measure-coordinate =
    .help = Valore misurato massimo ammesso.
parameter-least-dimension__measure-coordinate =
    .help = Valore misurato minimo ammesso.

# --- 430 ---
parameter-probing-centre-main__measure-bolt-hole-circle =
    .help = Centro del cerchio di fori (valore nominale) nell’asse principale del piano di lavoro.
parameter-probing-centre-minor__measure-bolt-hole-circle =
    .help = Centro del cerchio di fori (valore nominale) nell’asse secondario del piano di lavoro.
parameter-probing-nominal-diameter__measure-bolt-hole-circle =
    .help = Diametro del cerchio di fori.
parameter-first-hole-angle = Angolo 1° foro
    .label = ANGOLO 1° FORO
    .help = Angolo, in coordinate polari, del centro del primo foro nel piano di lavoro.
parameter-second-hole-angle = Angolo 2° foro
    .label = ANGOLO 2° FORO
    .help = Angolo, in coordinate polari, del centro del secondo foro nel piano di lavoro.
parameter-third-hole-angle = Angolo 3° foro
    .label = ANGOLO 3° FORO
    .help = Angolo, in coordinate polari, del centro del terzo foro nel piano di lavoro.
parameter-greatest-dimension__measure-bolt-hole-circle =
    .help = Diametro massimo ammesso del cerchio di fori.
parameter-least-dimension__measure-bolt-hole-circle =
    .help = Diametro minimo ammesso del cerchio di fori.
parameter-monitored-tool__measure-bolt-hole-circle =
    .help = Numero o nome dell’utensile di cui il controllo deve sorvegliare la rottura, se previsto.
parameter-monitored-tool__measure-bolt-hole-circle__tnc320 =
    .help = Numero dell’utensile di cui il controllo deve sorvegliare la rottura, se previsto.
parameter-monitored-tool__measure-bolt-hole-circle__tnc426-430 =
    .help = Numero dell’utensile di cui il controllo deve sorvegliare la rottura, se previsto.

# --- 420, 431 ---
parameter-first-point-tool = 1° punto di misura 3° asse
    .label = 1° PUNTO 3° ASSE
    .help = Coordinata del primo punto di tastatura nell’asse del tastatore.
parameter-second-point-tool = 2° punto di misura 3° asse
    .label = 2° PUNTO 3° ASSE
    .help = Coordinata del secondo punto di tastatura nell’asse del tastatore.
parameter-third-point-tool = 3° punto di misura 3° asse
    .label = 3° PUNTO 3° ASSE
    .help = Coordinata del terzo punto di tastatura nell’asse del tastatore.
parameter-measuring-axis__measure-angle =
    .help = Asse nel quale viene eseguita la misurazione.

# --- 416 ---
parameter-probing-centre-main__datum-bolt-hole-circle =
    .help = Centro del cerchio di fori (valore nominale) nell’asse principale del piano di lavoro.
parameter-probing-centre-minor__datum-bolt-hole-circle =
    .help = Centro del cerchio di fori (valore nominale) nell’asse secondario del piano di lavoro.
parameter-probing-nominal-diameter__datum-bolt-hole-circle =
    .help = Diametro approssimativo del cerchio di fori. Quanto più piccolo è il diametro dei fori, tanto maggiore deve essere la precisione del valore inserito.
parameter-datum-row-number__datum-bolt-hole-circle =
    .help = Numero nella tabella origini o nella tabella Preset con il quale vengono memorizzate le coordinate del centro del cerchio di fori. Con 0 il controllo imposta la visualizzazione in modo che la nuova origine si trovi al centro del cerchio di fori.
parameter-datum-row-number__datum-bolt-hole-circle__tnc426-430 =
    .help = Numero nella tabella origini con il quale vengono memorizzate le coordinate del centro del cerchio di fori. Con 0 il controllo imposta la visualizzazione in modo che la nuova origine si trovi al centro del cerchio di fori.
parameter-new-datum-main__datum-bolt-hole-circle =
    .help = Coordinata nell’asse principale sulla quale viene impostato il centro rilevato del cerchio di fori. Impostazione base: 0.
parameter-new-datum-minor__datum-bolt-hole-circle =
    .help = Coordinata nell’asse secondario sulla quale viene impostato il centro rilevato del cerchio di fori. Impostazione base: 0.
parameter-probing-clearance__datum-bolt-hole-circle =
    .help = Distanza supplementare tra punto di misura e sfera del tastatore. Si somma a { $mp-set-up } e ha effetto solo nella tastatura dell’origine nell’asse del tastatore.

# --- 417 ---
parameter-datum-row-number__datum-probe-axis =
    .help = Numero nella tabella origini o nella tabella Preset con il quale viene memorizzata la coordinata. Con 0 il controllo imposta la visualizzazione in modo che la nuova origine si trovi sulla superficie tastata.
parameter-datum-row-number__datum-probe-axis__tnc426-430 =
    .help = Numero nella tabella origini con il quale viene memorizzata la coordinata. Con 0 il controllo imposta la visualizzazione in modo che la nuova origine si trovi sulla superficie tastata.

# --- 418 ---
parameter-third-centre-main = 3° centro 1° asse
    .label = 3° CENTRO 1° ASSE
    .help = Centro del terzo foro nell’asse principale del piano di lavoro.
parameter-third-centre-minor = 3° centro 2° asse
    .label = 3° CENTRO 2° ASSE
    .help = Centro del terzo foro nell’asse secondario del piano di lavoro.
parameter-fourth-centre-main = 4° centro 1° asse
    .label = 4° CENTRO 1° ASSE
    .help = Centro del quarto foro nell’asse principale del piano di lavoro.
parameter-fourth-centre-minor = 4° centro 2° asse
    .label = 4° CENTRO 2° ASSE
    .help = Centro del quarto foro nell’asse secondario del piano di lavoro.
parameter-datum-row-number__datum-four-holes =
    .help = Numero nella tabella origini o nella tabella Preset con il quale vengono memorizzate le coordinate del punto di intersezione delle rette di congiunzione. Con 0 il controllo imposta la visualizzazione in modo che la nuova origine si trovi nel punto di intersezione delle rette di congiunzione.
parameter-datum-row-number__datum-four-holes__tnc426-430 =
    .help = Numero nella tabella origini con il quale vengono memorizzate le coordinate del punto di intersezione delle rette di congiunzione. Con 0 il controllo imposta la visualizzazione in modo che la nuova origine si trovi nel punto di intersezione delle rette di congiunzione.
parameter-new-datum-main__datum-four-holes =
    .help = Coordinata nell’asse principale sulla quale viene impostato il punto di intersezione rilevato delle rette di congiunzione. Impostazione base: 0.
parameter-new-datum-minor__datum-four-holes =
    .help = Coordinata nell’asse secondario sulla quale viene impostato il punto di intersezione rilevato delle rette di congiunzione. Impostazione base: 0.

# --- 419 ---
parameter-measuring-axis__datum-one-axis = Asse di misura (1...3: 1=asse principale)
    .help = Asse nel quale viene eseguita la misurazione.
parameter-datum-row-number__datum-one-axis =
    .help = Numero nella tabella origini o nella tabella Preset con il quale viene memorizzata la coordinata. Con 0 il controllo imposta la visualizzazione in modo che la nuova origine si trovi sulla superficie tastata.
parameter-new-datum-one-axis = Nuova origine
    .label = ORIGINE
    .help = Coordinata sulla quale viene impostata l’origine. Impostazione base: 0.

# --- 1, 3 ---
parameter-polar-probing-axis = Asse di tastatura
    .help = Asse di tastatura, inserito con il tasto asse o con la tastiera alfabetica. Confermare con ENT.
parameter-polar-probing-axis__measuring =
    .help = Asse nella cui direzione viene eseguita la tastatura. Confermare con ENT.
parameter-polar-probing-axis__measuring__tnc426-430 =
    .help = Asse principale del piano di lavoro: X con asse utensile Z, Z con asse utensile Y, Y con asse utensile X. Confermare con ENT.
parameter-polar-probing-angle = Angolo di tastatura
    .word = ANGOLO:
    .help = Angolo, riferito all’asse di tastatura, che indica la direzione in cui si sposta il sistema di tastatura.
parameter-result-parameter__measuring =
    .help = Numero del parametro Q al quale il controllo assegna la prima coordinata misurata (X). Y e Z si trovano nei parametri Q successivi.
parameter-greatest-measuring-path = Percorso di misura massimo
    .word = DIST.
    .help = Percorso del sistema di tastatura dal punto di partenza. Confermare con ENT.
parameter-measuring-feed = Avanzamento di misura
    .help = Avanzamento di misura in mm/min.
parameter-greatest-retraction-path = Percorso di ritrazione massimo
    .help = Percorso in senso opposto alla direzione di tastatura dopo la deflessione dello stilo. Il controllo ritrae il sistema di tastatura al massimo fino al punto di partenza, in modo da escludere collisioni.
parameter-probing-reference-system = Sistema di riferimento (0=REALE/1=REF)
    .word = SISTEMA DI RIFERIMENTO:
    .help = Definire se la direzione di tastatura e il risultato si riferiscono al sistema di coordinate attuale (REALE, che può essere spostato o ruotato) o al sistema di coordinate della macchina (REF).
parameter-probing-reference-system__tnc320 =
    .help = Definire se il risultato si riferisce al sistema di coordinate attuale (REALE, che può essere spostato o ruotato) o al sistema di coordinate della macchina (REF).
choice-probe-in-actual-system = tastare nel sistema attuale e memorizzare il risultato nel sistema REALE
choice-probe-in-machine-system = tastare nel sistema della macchina REF e memorizzare il risultato nel sistema REF
parameter-probing-error-mode = Modo errore (0=OFF/1=ON)
    .help = Definire se il controllo visualizza un messaggio d’errore quando lo stilo è deflesso all’inizio del ciclo. Con 1 il controllo memorizza −1 nel quarto parametro di risultato e prosegue il ciclo.
parameter-probing-error-mode__tnc320 =
    .help = Definire se il controllo visualizza un messaggio d’errore quando lo stilo è deflesso all’inizio del ciclo. Con 1 il controllo memorizza 2,0 nel quarto parametro di risultato e prosegue il ciclo.
choice-show-probing-error = visualizzare il messaggio d’errore
choice-probing-error-off = non visualizzare alcun messaggio d’errore
