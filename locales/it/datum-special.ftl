# Datum cycles for bolt-hole circles, for the touch probe axis, for four holes and for one axis; see the English file.

# --- 416 ---
cycle-datum-bolt-hole-circle = Impostazione origine centro cerchio di fori
    .nc = ORIGINE CENTRO CERCHIO
    .purpose = Calcola il centro di un cerchio di fori misurando tre dei suoi fori e lo imposta come origine. A scelta, il controllo scrive il centro anche in una tabella origini o nella tabella Preset.
cycle-datum-bolt-hole-circle__tnc426-430 =
    .purpose = Calcola il centro di un cerchio di fori misurando tre dei suoi fori e lo imposta come origine. A scelta, il controllo scrive il centro anche in una tabella origini.
title-datum-at-top-and-bolt-hole-circle = Impostazione dell’origine sul bordo superiore del pezzo e al centro di un cerchio di fori
title-top-and-bolt-hole-circle-into-datum-table = Scrittura del bordo superiore del pezzo e del centro di un cerchio di fori in una tabella origini

# --- 417 ---
cycle-datum-probe-axis = Impostazione origine asse tastatore
    .nc = ORIGINE ASSE TASTATORE
    .purpose = Misura una coordinata qualsiasi nell’asse del tastatore e la imposta come origine. A scelta, il controllo scrive la coordinata misurata anche in una tabella origini o nella tabella Preset.
cycle-datum-probe-axis__tnc426-430 =
    .purpose = Misura una coordinata qualsiasi nell’asse del tastatore e la imposta come origine. A scelta, il controllo scrive la coordinata misurata anche in una tabella origini.
step-position-above-touch-point = Il controllo posiziona il sistema di tastatura sul punto di tastatura programmato, in rapido (valore della colonna { $mp-positioning-feed }) e con logica di posizionamento, arretrandolo della distanza di sicurezza in direzione positiva dell’asse del tastatore.
step-position-above-touch-point__tnc426-430 = Il controllo posiziona il sistema di tastatura sul punto di tastatura programmato, in rapido (valore di { $mp-positioning-feed } o { $mp-analog-positioning-feed }) e con logica di posizionamento, arretrandolo della distanza di sicurezza in direzione positiva dell’asse del tastatore.
step-probe-touch-point-in-probe-axis = Il sistema di tastatura si porta nell’asse del tastatore alla coordinata inserita { $q-first-point-tool } del punto di tastatura e rileva la posizione reale con una tastatura.
note-datum-set-in-probe-axis = Il controllo imposta l’origine nell’asse del tastatore definito dalla chiamata utensile che precede il ciclo.
note-positioning-logic__datum-probe-axis = Logica di posizionamento: se il polo sud dello stilo si trova al di sotto dell’altezza di sicurezza { $q-clearance-height }, il controllo ritrae dapprima il sistema di tastatura nell’asse del tastatore all’altezza di sicurezza e lo posiziona poi nel piano di lavoro sul primo punto di tastatura. Se si trova al di sopra dell’altezza di sicurezza, il controllo posiziona dapprima il sistema di tastatura nel piano di lavoro sul primo punto di tastatura e lo porta poi nell’asse del tastatore direttamente all’altezza di misura.
note-no-transformation-with-probe-axis-datum__datum-probe-axis = Se un ciclo imposta un’origine con { $q-measured-value-transfer }=0 ed esegue anche la tastatura nell’asse del tastatore (Q381=1), non deve essere attiva alcuna conversione di coordinate.
result-measured-point-actual = Valore reale punto misurato
title-datum-at-top-and-arc-centre = Impostazione dell’origine sul bordo superiore del pezzo e al centro di un segmento circolare

# --- 418 ---
cycle-datum-four-holes = Impostazione origine centro di quattro fori
    .nc = ORIGINE DA 4 FORI
    .purpose = Calcola il punto di intersezione delle rette che congiungono i centri di quattro fori e lo imposta come origine. A scelta, il controllo scrive il punto di intersezione anche in una tabella origini o nella tabella Preset.
cycle-datum-four-holes__tnc426-430 =
    .purpose = Calcola il punto di intersezione delle rette che congiungono i centri di quattro fori e lo imposta come origine. A scelta, il controllo scrive il punto di intersezione anche in una tabella origini.
step-repeat-for-third-and-fourth-hole = Il controllo ripete i due passi precedenti per il terzo e il quarto foro.
step-retract-and-store-intersection = Il controllo riporta il sistema di tastatura all’altezza di sicurezza { $q-clearance-height }, calcola l’origine come punto di intersezione delle rette tra i centri dei fori 1 e 3 e dei fori 2 e 4, memorizza i valori reali nei parametri di risultato e imposta o memorizza l’origine in base a { $q-measured-value-transfer } e { $q-datum-row-number }:
step-retract-and-store-intersection__tnc426-430 = Il controllo riporta il sistema di tastatura all’altezza di sicurezza { $q-clearance-height }, calcola l’origine come punto di intersezione delle rette tra i centri dei fori 1 e 3 e dei fori 2 e 4 e la elabora in base a { $q-datum-row-number }:
result-intersection-main-actual = Valore reale punto di intersezione asse principale
result-intersection-minor-actual = Valore reale punto di intersezione asse secondario

# --- 419 ---
cycle-datum-one-axis = Impostazione origine in un asse selezionabile
    .nc = ORIGINE ASSE SINGOLO
    .purpose = Misura una coordinata qualsiasi in un asse selezionabile e la imposta come origine. A scelta, il controllo scrive la coordinata misurata anche in una tabella origini o nella tabella Preset.
step-position-against-probing-direction = Il controllo posiziona il sistema di tastatura sul punto di tastatura programmato, in rapido (valore della colonna { $mp-positioning-feed }) e con logica di posizionamento, arretrandolo della distanza di sicurezza in senso opposto alla direzione di tastatura programmata { $q-traverse-direction }.
step-move-to-measuring-height-and-probe = Il sistema di tastatura si porta all’altezza di misura { $q-measuring-height } e rileva la posizione reale con una tastatura.
step-retract-and-store-datum__datum-one-axis = Il controllo riporta il sistema di tastatura all’altezza di sicurezza { $q-clearance-height } e imposta o memorizza l’origine rilevata in base a { $q-measured-value-transfer } e { $q-datum-row-number }:
note-measuring-axes-by-probe-axis = Gli assi selezionati con { $q-measuring-axis } dipendono dall’asse del tastatore attivo ({ $q-measuring-axis }=3): con Z l’asse principale ({ $q-measuring-axis }=1) è X e l’asse secondario ({ $q-measuring-axis }=2) è Y; con Y sono Z e X; con X sono Y e Z.
note-activate-preset-after-each-axis = Per memorizzare l’origine in più assi della tabella Preset con più esecuzioni successive di questo ciclo, dopo ogni esecuzione attivare il numero Preset nel quale il ciclo ha scritto. Non è necessario se viene sovrascritto il Preset attivo.
