# Parameters of the misalignment and datum cycles; see the English file.

# --- datum cycles: what differs from the hole ---
parameter-probing-centre-main__datum-inside-rectangle =
    .help = Centro della tasca nell’asse principale del piano di lavoro.
parameter-probing-centre-minor__datum-inside-rectangle =
    .help = Centro della tasca nell’asse secondario del piano di lavoro.
parameter-probing-centre-main__datum-outside-rectangle =
    .help = Centro dell’isola nell’asse principale del piano di lavoro.
parameter-probing-centre-minor__datum-outside-rectangle =
    .help = Centro dell’isola nell’asse secondario del piano di lavoro.
parameter-probing-centre-main__datum-outside-circle =
    .help = Centro dell’isola nell’asse principale del piano di lavoro.
parameter-probing-centre-minor__datum-outside-circle =
    .help = Centro dell’isola nell’asse secondario del piano di lavoro.
parameter-probing-nominal-diameter__datum-outside-circle =
    .help = Diametro dell’isola; inserire un valore approssimato per eccesso.
parameter-number-of-touch-points__datum-outside-circle =
    .help = Definire se l’isola viene misurata con quattro o con tre tastature.
parameter-first-side-length__datum-outside-rectangle =
    .help = Lunghezza dell’isola, parallela all’asse principale del piano di lavoro.
parameter-second-side-length__datum-outside-rectangle =
    .help = Lunghezza dell’isola, parallela all’asse secondario del piano di lavoro.
parameter-datum-row-number__datum-outside-rectangle =
    .help = Numero nella tabella origini o nella tabella Preset con il quale vengono memorizzate le coordinate del centro dell’isola. Con 0 il controllo imposta la visualizzazione in modo che la nuova origine si trovi al centro dell’isola.
parameter-datum-row-number__datum-outside-rectangle__tnc426-430 =
    .help = Numero nella tabella origini con il quale vengono memorizzate le coordinate del centro dell’isola. Con 0 il controllo imposta la visualizzazione in modo che la nuova origine si trovi al centro dell’isola.
parameter-datum-row-number__datum-outside-circle =
    .help = Numero nella tabella origini o nella tabella Preset con il quale vengono memorizzate le coordinate del centro dell’isola. Con 0 il controllo imposta la visualizzazione in modo che la nuova origine si trovi al centro dell’isola.
parameter-datum-row-number__datum-outside-circle__tnc426-430 =
    .help = Numero nella tabella origini con il quale vengono memorizzate le coordinate del centro dell’isola. Con 0 il controllo imposta la visualizzazione in modo che la nuova origine si trovi al centro dell’isola.
parameter-new-datum-main__datum-outside-rectangle =
    .help = Coordinata nell’asse principale sulla quale viene impostato il centro dell’isola rilevato. Impostazione base: 0.
parameter-new-datum-minor__datum-outside-rectangle =
    .help = Coordinata nell’asse secondario sulla quale viene impostato il centro dell’isola rilevato. Impostazione base: 0.
parameter-new-datum-main__datum-outside-circle =
    .help = Coordinata nell’asse principale sulla quale viene impostato il centro dell’isola rilevato. Impostazione base: 0.
parameter-new-datum-minor__datum-outside-circle =
    .help = Coordinata nell’asse secondario sulla quale viene impostato il centro dell’isola rilevato. Impostazione base: 0.
choice-travel-paraxially-at-measuring-height = spostamento parallelo agli assi all’altezza di misura tra i punti di misura
choice-travel-linearly-at-clearance-height = spostamento su una retta all’altezza di sicurezza tra i punti di misura

# --- 408 and 409 ---
parameter-probing-centre-main__datum-slot-centre =
    .help = Centro della scanalatura nell’asse principale del piano di lavoro.
parameter-probing-centre-minor__datum-slot-centre =
    .help = Centro della scanalatura nell’asse secondario del piano di lavoro.
parameter-probing-centre-main__datum-ridge-centre =
    .help = Centro dell’isola nell’asse principale del piano di lavoro.
parameter-probing-centre-minor__datum-ridge-centre =
    .help = Centro dell’isola nell’asse secondario del piano di lavoro.
parameter-slot-width = Larghezza scanalatura
    .label = LARGHEZZA SCANALATURA
    .help = Larghezza della scanalatura, indipendentemente dalla sua posizione nel piano di lavoro.
parameter-ridge-width = Larghezza isola
    .label = LARGHEZZA ISOLA
    .help = Larghezza dell’isola, indipendentemente dalla sua posizione nel piano di lavoro.
parameter-datum-row-number__datum-slot-centre = Numero nella tabella
    .help = Numero nella tabella origini o nella tabella Preset con il quale vengono memorizzate le coordinate del centro della scanalatura. Con 0 il controllo imposta la visualizzazione in modo che la nuova origine si trovi al centro della scanalatura.
parameter-datum-row-number__datum-ridge-centre = Numero nella tabella
    .help = Numero nella tabella origini o nella tabella Preset con il quale vengono memorizzate le coordinate del centro dell’isola. Con 0 il controllo imposta la visualizzazione in modo che la nuova origine si trovi al centro dell’isola.
parameter-new-datum-measuring-axis = Nuova origine
    .label = ORIGINE
    .help = Coordinata nell’asse di misura sulla quale viene impostato il centro rilevato. Impostazione base: 0.

# --- 414 and 415 ---
parameter-third-point-main = 3° punto di misura 1° asse
    .label = 3° PUNTO 1° ASSE
    .help = Coordinata del terzo punto di tastatura nell’asse principale del piano di lavoro.
parameter-third-point-minor = 3° punto di misura 2° asse
    .label = 3° PUNTO 2° ASSE
    .help = Coordinata del terzo punto di tastatura nell’asse secondario del piano di lavoro.
parameter-point-distance-main = Distanza 1° asse
    .label = DISTANZA 1° ASSE
    .help = Distanza tra il primo e il secondo punto di misura nell’asse principale del piano di lavoro.
parameter-point-distance-minor = Distanza 2° asse
    .label = DISTANZA 2° ASSE
    .help = Distanza tra il terzo e il quarto punto di misura nell’asse secondario del piano di lavoro.
parameter-corner-number = Spigolo
    .label = SPIGOLO
    .help = Numero dello spigolo sul quale viene impostata l’origine.
parameter-corner-basic-rotation = Esecuzione rotazione base
    .label = ROTAZIONE BASE
    .help = Definire se il controllo compensa la posizione obliqua del pezzo mediante una rotazione base.
choice-no-basic-rotation = senza esecuzione della rotazione base
choice-carry-out-basic-rotation = con esecuzione della rotazione base
parameter-datum-row-number__datum-outside-corner =
    .help = Numero nella tabella origini o nella tabella Preset con il quale vengono memorizzate le coordinate dello spigolo. Con 0 il controllo imposta la visualizzazione in modo che la nuova origine si trovi sullo spigolo.
parameter-datum-row-number__datum-outside-corner__tnc426-430 =
    .help = Numero nella tabella origini con il quale vengono memorizzate le coordinate dello spigolo. Con 0 il controllo imposta la visualizzazione in modo che la nuova origine si trovi sullo spigolo.
parameter-datum-row-number__datum-inside-corner =
    .help = Numero nella tabella origini o nella tabella Preset con il quale vengono memorizzate le coordinate dello spigolo. Con 0 il controllo imposta la visualizzazione in modo che la nuova origine si trovi sullo spigolo.
parameter-datum-row-number__datum-inside-corner__tnc426-430 =
    .help = Numero nella tabella origini con il quale vengono memorizzate le coordinate dello spigolo. Con 0 il controllo imposta la visualizzazione in modo che la nuova origine si trovi sullo spigolo.
parameter-new-datum-main__datum-outside-corner =
    .help = Coordinata nell’asse principale sulla quale viene impostato lo spigolo rilevato. Impostazione base: 0.
parameter-new-datum-minor__datum-outside-corner =
    .help = Coordinata nell’asse secondario sulla quale viene impostato lo spigolo rilevato. Impostazione base: 0.
parameter-new-datum-main__datum-inside-corner =
    .help = Coordinata nell’asse principale sulla quale viene impostato lo spigolo rilevato. Impostazione base: 0.
parameter-new-datum-minor__datum-inside-corner =
    .help = Coordinata nell’asse secondario sulla quale viene impostato lo spigolo rilevato. Impostazione base: 0.

# --- two points on a line ---
parameter-first-point-main = 1° punto di misura 1° asse
    .label = 1° PUNTO 1° ASSE
    .help = Coordinata del primo punto di tastatura nell’asse principale del piano di lavoro.
parameter-first-point-minor = 1° punto di misura 2° asse
    .label = 1° PUNTO 2° ASSE
    .help = Coordinata del primo punto di tastatura nell’asse secondario del piano di lavoro.
parameter-second-point-main = 2° punto di misura 1° asse
    .label = 2° PUNTO 1° ASSE
    .help = Coordinata del secondo punto di tastatura nell’asse principale del piano di lavoro.
parameter-second-point-minor = 2° punto di misura 2° asse
    .label = 2° PUNTO 2° ASSE
    .help = Coordinata del secondo punto di tastatura nell’asse secondario del piano di lavoro.
parameter-measuring-axis = Asse di misura
    .label = ASSE DI MISURA
    .help = Asse del piano di lavoro nel quale viene eseguita la misurazione.
parameter-measuring-axis__rotation-by-rotary-axis = Asse di misura (1...3: 1=asse principale)
    .help = Asse nel quale viene eseguita la misurazione.
choice-measuring-axis-main = l’asse principale è l’asse di misura
choice-measuring-axis-minor = l’asse secondario è l’asse di misura
choice-measuring-axis-probe = l’asse del tastatore è l’asse di misura
parameter-traverse-direction = Direzione di spostamento 1
    .label = DIREZIONE SPOSTAMENTO
    .help = Direzione in cui il sistema di tastatura si avvicina al pezzo.
choice-traverse-direction-negative = direzione di spostamento negativa
choice-traverse-direction-positive = direzione di spostamento positiva
choice-travel-directly-at-measuring-height = spostamento all’altezza di misura tra i punti di misura
choice-travel-directly-at-clearance-height = spostamento all’altezza di sicurezza tra i punti di misura

# --- two holes or studs ---
parameter-first-centre-main = 1° foro: centro 1° asse
    .label = 1° CENTRO 1° ASSE
    .help = Centro del primo foro nell’asse principale del piano di lavoro.
parameter-first-centre-minor = 1° foro: centro 2° asse
    .label = 1° CENTRO 2° ASSE
    .help = Centro del primo foro nell’asse secondario del piano di lavoro.
parameter-second-centre-main = 2° foro: centro 1° asse
    .label = 2° CENTRO 1° ASSE
    .help = Centro del secondo foro nell’asse principale del piano di lavoro.
parameter-second-centre-minor = 2° foro: centro 2° asse
    .label = 2° CENTRO 2° ASSE
    .help = Centro del secondo foro nell’asse secondario del piano di lavoro.
parameter-first-centre-main__rotation-two-studs = 1ª isola: centro 1° asse
    .help = Centro della prima isola nell’asse principale del piano di lavoro.
parameter-first-centre-minor__rotation-two-studs = 1ª isola: centro 2° asse
    .help = Centro della prima isola nell’asse secondario del piano di lavoro.
parameter-second-centre-main__rotation-two-studs = 2ª isola: centro 1° asse
    .help = Centro della seconda isola nell’asse principale del piano di lavoro.
parameter-second-centre-minor__rotation-two-studs = 2ª isola: centro 2° asse
    .help = Centro della seconda isola nell’asse secondario del piano di lavoro.
parameter-first-stud-diameter = Diametro isola 1
    .label = DIAMETRO ISOLA 1
    .help = Diametro della prima isola; inserire un valore approssimato per eccesso.
parameter-second-stud-diameter = Diametro isola 2
    .label = DIAMETRO ISOLA 2
    .help = Diametro della seconda isola; inserire un valore approssimato per eccesso.
parameter-measuring-height__rotation-two-studs = Altezza di misura isola 1 nell’asse del tastatore
    .label = ALTEZZA DI MISURA 1
    .help = Coordinata del centro della sfera (punto di tastatura) nell’asse del tastatore alla quale viene misurata l’isola 1.
parameter-second-measuring-height = Altezza di misura isola 2 nell’asse del tastatore
    .label = ALTEZZA DI MISURA 2
    .help = Coordinata del centro della sfera (punto di tastatura) nell’asse del tastatore alla quale viene misurata l’isola 2.

# --- what is done with the angle ---
parameter-reference-line-angle = Preimpostazione angolo di rotazione
    .label = PREIMP. ANGOLO ROTAZ.
    .help = Angolo di una retta di riferimento, se la posizione obliqua deve essere misurata rispetto a una retta qualsiasi anziché all’asse principale. La rotazione base è allora la differenza tra il valore misurato e questo angolo.
parameter-basic-rotation-angle = Preimpostazione angolo di rotazione
    .label = PREIMP. ANGOLO ROTAZ.
    .help = Angolo al quale viene impostata la rotazione base.
parameter-basic-rotation-row = Numero Preset nella tabella
    .label = NR. NELLA TABELLA
    .help = Numero nella tabella Preset con il quale viene memorizzata la rotazione base rilevata. Con 0 il controllo la memorizza nel menu ROT del modo operativo Funzionamento manuale.
parameter-basic-rotation-row__rotation-two-holes =
    .help = Numero nella tabella Preset con il quale viene memorizzata la rotazione base rilevata. Con 0 il controllo la memorizza nel menu ROT del modo operativo Funzionamento manuale. Se la posizione obliqua viene compensata ruotando la tavola rotante ({ $q-misalignment-compensation }=1), il numero non ha effetto e la posizione obliqua non viene memorizzata come angolo.
parameter-basic-rotation-row__rotation-two-studs =
    .help = Numero nella tabella Preset con il quale viene memorizzata la rotazione base rilevata. Con 0 il controllo la memorizza nel menu ROT del modo operativo Funzionamento manuale. Se la posizione obliqua viene compensata ruotando la tavola rotante ({ $q-misalignment-compensation }=1), il numero non ha effetto e la posizione obliqua non viene memorizzata come angolo.
parameter-misalignment-compensation = Compensazione
    .label = COMPENSAZIONE
    .help = Definire se il controllo compensa la posizione obliqua mediante una rotazione base o ruotando la tavola rotante.
choice-compensate-by-basic-rotation = impostare la rotazione base
choice-compensate-by-rotary-table = ruotare la tavola rotante; il controllo non memorizza allora la posizione obliqua, neppure se in { $q-basic-rotation-row } è indicata una riga della tabella
parameter-zero-after-alignment = Azzeramento dopo allineamento
    .label = AZZERAMENTO
    .help = Definire se il controllo imposta a 0 la visualizzazione dell’asse rotativo allineato.
choice-keep-rotary-display = non impostare a 0 la visualizzazione dell’asse rotativo dopo l’allineamento
choice-zero-rotary-display = impostare a 0 la visualizzazione dell’asse rotativo dopo l’allineamento
parameter-zero-or-row-after-alignment = Azzeramento dopo allineamento
    .label = AZZERAMENTO
    .help = Definire se il controllo imposta a 0 la visualizzazione dell’asse C oppure scrive l’offset angolare nella colonna C della tabella origini.
choice-zero-c-axis-display = impostare a 0 la visualizzazione dell’asse C
choice-offset-into-datum-row = scrivere l’offset angolare misurato con il suo segno nella tabella origini; il valore è il numero della riga. Se la tabella contiene già un offset di C, il controllo somma o sottrae l’offset misurato in base al segno
parameter-compensation-axis = Asse per movimento di compensazione
    .label = ASSE DI COMPENSAZIONE
    .help = Asse rotativo con cui il controllo compensa la posizione obliqua misurata.
choice-compensate-with-a-axis = compensare la posizione obliqua con l’asse rotativo A
choice-compensate-with-b-axis = compensare la posizione obliqua con l’asse rotativo B
choice-compensate-with-c-axis = compensare la posizione obliqua con l’asse rotativo C
parameter-rotary-axis-row = Numero nella tabella
    .label = NR. NELLA TABELLA
    .help = Numero nella tabella Preset o nella tabella origini in cui il controllo azzera l’asse rotativo.
parameter-measured-value-transfer__rotation-by-rotary-axis =
    .help = Definire se la rotazione base rilevata viene memorizzata nella tabella origini o nella tabella Preset.
choice-rotation-into-datum-table = scrivere la rotazione base rilevata come spostamento origine nella tabella origini attiva; il sistema di riferimento è il sistema di coordinate del pezzo attivo
choice-rotation-into-preset-table = scrivere la rotazione base rilevata nella tabella Preset; il sistema di riferimento è il sistema di coordinate della macchina (sistema REF)
parameter-alignment-angle = Angolo di riferimento? (0=asse principale)
    .prompt = Angolo di riferimento? (0=asse principale)
    .label = ANGOLO DI RIFERIM.
    .help = Angolo al quale il controllo allinea la retta tastata.
condition-basic-rotation-chosen = la posizione obliqua viene compensata mediante una rotazione base ({ $q-misalignment-compensation }=0)
condition-rotary-table-chosen = la posizione obliqua viene compensata ruotando la tavola rotante ({ $q-misalignment-compensation }=1)
condition-rotary-display-zeroed = { $q-zero-after-alignment }=1
condition-c-axis-compensates = è selezionato l’asse rotativo C ({ $q-compensation-axis }=6)
parameter-probing-centre-minor__rotation-by-c-axis =
    .help = Centro del foro nell’asse secondario del piano di lavoro. Con 0 il controllo allinea il centro del foro all’asse Y positivo, con qualsiasi altro valore alla posizione nominale (l’angolo che risulta dal centro del foro).
parameter-probing-nominal-diameter__rotation-by-c-axis =
    .help = Diametro della tasca circolare (foro); inserire un valore approssimato per difetto.
