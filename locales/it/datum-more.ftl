# Cycles that set a datum, beside that of the hole; see the English file.

# --- 410 and 411 ---
cycle-datum-inside-rectangle = Impostazione origine rettangolo interno
    .nc = ORIGINE RETTANGOLO INT.
    .purpose = Misura il centro di una tasca rettangolare e lo imposta come origine. A scelta, il controllo scrive il centro anche in una tabella origini o nella tabella Preset.
cycle-datum-inside-rectangle__tnc426-430 =
    .purpose = Misura il centro di una tasca rettangolare e lo imposta come origine. A scelta, il controllo scrive il centro anche in una tabella origini.
cycle-datum-outside-rectangle = Impostazione origine rettangolo esterno
    .nc = ORIGINE RETTANGOLO EST.
    .purpose = Misura il centro di un’isola rettangolare e lo imposta come origine. A scelta, il controllo scrive il centro anche in una tabella origini o nella tabella Preset.
cycle-datum-outside-rectangle__tnc426-430 =
    .purpose = Misura il centro di un’isola rettangolare e lo imposta come origine. A scelta, il controllo scrive il centro anche in una tabella origini.
step-probe-first-point = Il sistema di tastatura esegue la prima tastatura con l’avanzamento di tastatura (colonna { $mp-probing-feed }).
step-probe-first-point__tnc426-430 = Il sistema di tastatura esegue la prima tastatura con l’avanzamento di tastatura ({ $mp-probing-feed } o { $mp-analog-probing-feed }).
step-travel-to-second-touch-point = Il sistema di tastatura si porta al secondo punto di tastatura:
say-travel-linearly-at-clearance-height = con { $q-traverse-to-clearance-height }=1 su una retta all’altezza di sicurezza { $q-clearance-height }
say-travel-paraxially-at-measuring-height = con { $q-traverse-to-clearance-height }=0 parallelamente agli assi all’altezza di misura { $q-measuring-height }
step-probe-second-point = Qui il sistema di tastatura esegue la seconda tastatura.
step-probe-third-and-fourth-point = Il controllo posiziona il sistema di tastatura sul terzo e poi sul quarto punto di tastatura ed esegue in questi punti la terza e la quarta tastatura.
step-retract-and-treat-datum = Il controllo riporta il sistema di tastatura all’altezza di sicurezza { $q-clearance-height } e imposta o memorizza l’origine rilevata in base a { $q-measured-value-transfer } e { $q-datum-row-number }:
step-retract-and-treat-datum__tnc426-430 = Il controllo riporta il sistema di tastatura all’altezza di sicurezza { $q-clearance-height } e imposta o memorizza l’origine rilevata in base a { $q-datum-row-number }:
step-store-actual-values = Il controllo memorizza i valori reali nei parametri di risultato.
note-pocket-sides-rather-small = Pericolo di collisione! Per evitare una collisione tra il sistema di tastatura e il pezzo, inserire per il 1° e il 2° lato della tasca lunghezze approssimate per difetto.
note-stud-sides-rather-large = Pericolo di collisione! Per evitare una collisione tra il sistema di tastatura e il pezzo, inserire per il 1° e il 2° lato dell’isola lunghezze approssimate per eccesso.
title-introduction-to-probing = Altro esempio

# --- 413 ---
cycle-datum-outside-circle = Impostazione origine cerchio esterno (isola)
    .nc = ORIGINE CERCHIO EST.
    .purpose = Misura il centro di un’isola circolare e lo imposta come origine. A scelta, il controllo scrive il centro anche in una tabella origini o nella tabella Preset.
cycle-datum-outside-circle__tnc426-430 =
    .purpose = Misura il centro di un’isola circolare e lo imposta come origine. A scelta, il controllo scrive il centro anche in una tabella origini.
note-stud-diameter-rather-large = Pericolo di collisione! Per evitare una collisione tra il sistema di tastatura e il pezzo, inserire per l’isola un diametro nominale approssimato per eccesso.
note-small-stepping-angle-less-exact__datum-outside-circle = Quanto più piccolo è l’angolo incrementale { $q-probing-stepping-angle }, tanto meno precisa è l’origine calcolata dal controllo.
title-datum-at-arc-centre-and-top = Impostazione dell’origine al centro di un segmento circolare e sul bordo superiore del pezzo
title-datum-at-arc-centre-and-top__tnc426-430 = Impostazione dell’origine al centro di un segmento circolare

# --- results ---
result-side-main-actual = Valore reale lunghezza lato asse principale
result-side-minor-actual = Valore reale lunghezza lato asse secondario
result-slot-width-actual = Valore reale della larghezza scanalatura misurata
result-ridge-width-actual = Valore reale della larghezza isola misurata
result-centre-axis-actual = Valore reale posizione asse centrale
result-corner-main-actual = Valore reale spigolo asse principale
result-corner-minor-actual = Valore reale spigolo asse secondario

# --- 408 and 409 ---
cycle-datum-slot-centre = Impostazione origine centro scanalatura
    .nc = ORIGINE CENTRO SCANAL.
    .purpose = Misura il centro di una scanalatura e lo imposta come origine. A scelta, il controllo scrive il centro anche in una tabella origini o nella tabella Preset.
cycle-datum-ridge-centre = Impostazione origine centro isola
    .nc = ORIGINE CENTRO ISOLA
    .purpose = Misura il centro di un’isola e lo imposta come origine. A scelta, il controllo scrive il centro anche in una tabella origini o nella tabella Preset.
step-travel-at-clearance-height-to-second = Il sistema di tastatura si porta, all’altezza di sicurezza { $q-clearance-height }, al secondo punto di tastatura.
say-start-again-from-centre__datum-slot-centre = se la scanalatura e la distanza di sicurezza non lasciano spazio per un preposizionamento vicino ai punti di tastatura, rimane al centro e non si porta all’altezza di sicurezza
note-slot-width-rather-small = Pericolo di collisione! Per evitare una collisione tra il sistema di tastatura e il pezzo, inserire una larghezza della scanalatura approssimata per difetto.
note-ridge-width-rather-large = Pericolo di collisione! Per evitare una collisione tra il sistema di tastatura e il pezzo, inserire una larghezza dell’isola approssimata per eccesso.
note-probing-from-centre-if-narrow__datum-slot-centre = Se la larghezza della scanalatura e la distanza di sicurezza non consentono un preposizionamento vicino ai punti di tastatura, il controllo inizia sempre la tastatura dal centro della scanalatura. In tal caso, tra i due punti di misura il sistema di tastatura non si porta all’altezza di sicurezza.
note-feature-content-level-3 = Questo ciclo è una funzione del Feature Content Level 3 (FCL 3).

# --- 414 and 415 ---
cycle-datum-outside-corner = Impostazione origine spigolo esterno
    .nc = ORIGINE SPIGOLO EST.
    .purpose = Misura due rette dall’esterno e imposta il loro punto di intersezione come origine. A scelta, il controllo scrive il punto di intersezione anche in una tabella origini o nella tabella Preset.
cycle-datum-outside-corner__tnc426-430 =
    .purpose = Misura due rette dall’esterno e imposta il loro punto di intersezione come origine. A scelta, il controllo scrive il punto di intersezione anche in una tabella origini.
cycle-datum-inside-corner = Impostazione origine spigolo interno
    .nc = ORIGINE SPIGOLO INT.
    .purpose = Misura due rette dall’interno e imposta il loro punto di intersezione come origine. A scelta, il controllo scrive il punto di intersezione anche in una tabella origini o nella tabella Preset.
cycle-datum-inside-corner__tnc426-430 =
    .purpose = Misura due rette dall’interno e imposta il loro punto di intersezione come origine. A scelta, il controllo scrive il punto di intersezione anche in una tabella origini.
step-probe-first-point-by-third-point = Il sistema di tastatura esegue la prima tastatura con l’avanzamento di tastatura (colonna { $mp-probing-feed }). Il controllo determina la direzione di tastatura dal terzo punto di misura programmato.
step-probe-first-point-by-third-point__tnc426-430 = Il sistema di tastatura esegue la prima tastatura con l’avanzamento di tastatura ({ $mp-probing-feed } o { $mp-analog-probing-feed }). Il controllo determina la direzione di tastatura dal terzo punto di misura programmato.
step-probe-first-point-by-corner-number = Il sistema di tastatura esegue la prima tastatura con l’avanzamento di tastatura (colonna { $mp-probing-feed }). Il controllo determina la direzione di tastatura dal numero dello spigolo { $q-corner-number }.
step-probe-first-point-by-corner-number__tnc426-430 = Il sistema di tastatura esegue la prima tastatura con l’avanzamento di tastatura ({ $mp-probing-feed } o { $mp-analog-probing-feed }). Il controllo determina la direzione di tastatura dal numero dello spigolo { $q-corner-number }.
step-retract-and-store-corner = Il controllo riporta il sistema di tastatura all’altezza di sicurezza { $q-clearance-height }, memorizza le coordinate dello spigolo rilevato nei parametri di risultato e imposta o memorizza l’origine rilevata in base a { $q-measured-value-transfer } e { $q-datum-row-number }:
step-retract-and-store-corner__tnc426-430 = Il controllo riporta il sistema di tastatura all’altezza di sicurezza { $q-clearance-height } e imposta o memorizza come origine il punto di intersezione delle rette misurate, in base a { $q-datum-row-number }:
step-carry-out-basic-rotation-on-request = Con { $q-corner-basic-rotation }=1 il controllo compensa la posizione obliqua del pezzo mediante una rotazione base.
note-corner-from-first-and-third-point = Le posizioni dei punti di misura 1 e 3 determinano lo spigolo sul quale il controllo imposta l’origine. Spigolo A: la coordinata del punto 1 è maggiore di quella del punto 3 in X e minore in Y. Spigolo B: minore in X, minore in Y. Spigolo C: minore in X, maggiore in Y. Spigolo D: maggiore in X, maggiore in Y.
note-first-line-in-secondary-direction = Il controllo misura la prima retta sempre in direzione dell’asse secondario del piano di lavoro.
note-basic-rotation-with-immediate-datum = Far eseguire al controllo la rotazione base solo se l’origine viene impostata subito e non se viene scritta nella tabella origini per una lavorazione successiva.
