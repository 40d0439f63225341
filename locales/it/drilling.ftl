# Drilling cycles; see the English file.

# --- 200 ---
cycle-drilling = Foratura
    .nc = FORATURA
    .purpose = Esegue un foro in uno o più incrementi. Tra un incremento e l’altro l’utensile viene ritratto in rapido dal foro.
step-drill-to-plunging-depth = L’utensile fora con l’avanzamento { $q-plunging-feed } fino alla profondità incremento, che a ogni incremento aumenta di { $q-plunging-depth }.
step-retract-and-return-to-set-up-clearance = Il controllo ritrae l’utensile in rapido (FMAX) alla distanza di sicurezza, lo fa sostare in questa posizione per { $q-dwell-at-top }, se inserito, e lo riporta in rapido (FMAX) fino alla distanza di sicurezza sopra la profondità raggiunta.
step-dwell-at-hole-bottom = L’utensile sosta sul fondo del foro per { $q-dwell-at-bottom }, se inserito.
step-rapid-out-of-hole = L’utensile lascia il fondo del foro in rapido (FMAX):
say-rapid-to-second-set-up-clearance = fino alla 2ª distanza di sicurezza { $q-second-set-up-clearance }, se inserita
say-rapid-back-to-set-up-clearance = altrimenti fino alla distanza di sicurezza { $q-set-up-clearance }
note-position-over-hole-centre = Programmare un blocco di posizionamento sul punto di partenza (centro del foro) nel piano di lavoro con correzione del raggio R0.
note-point-table-hole-centres = Se il ciclo viene chiamato con una tabella punti, i punti del piano di lavoro sono i centri dei fori. Per utilizzare la coordinata dell’asse del mandrino della tabella come coordinata del punto di partenza, inserire 0 come coordinata della superficie del pezzo { $q-surface-coordinate }.

# --- 205 ---
cycle-universal-pecking = Foratura profonda universale
    .nc = FORATURA PROFONDA UNIVERSALE
    .purpose = Esegue fori profondi in più incrementi, che possono essere decrescenti, con rottura truciolo, distanza di prearresto per il ritorno nel foro e punto di partenza sotto la superficie del pezzo per fori preforati.
step-feed-to-deepened-starting-point = Se è inserito un punto di partenza abbassato { $q-deepened-starting-point }, l’utensile si porta con l’avanzamento di avvicinamento { $q-pre-positioning-feed } alla distanza di sicurezza sopra il punto di partenza abbassato.
step-drill-on-to-plunging-depth = L’utensile fora con l’avanzamento { $q-plunging-feed } verso la profondità incremento { $q-plunging-depth }; con la rottura truciolo si ferma ogni volta che è sceso di { $q-depth-for-chip-breaking }. A ogni incremento la profondità incremento si riduce del decremento { $q-decrement }, se inserito.
step-break-chip = Per la rottura truciolo l’utensile si ritrae di { $q-chip-breaking-retraction } a 3000 mm/min.
until-plunging-depth-reached = non è raggiunta la profondità incremento
step-retract-and-return-to-advanced-stop = Il controllo ritrae l’utensile in rapido (FMAX) alla distanza di sicurezza e lo riporta in rapido (FMAX) fino alla distanza di prearresto sopra la profondità raggiunta: all’inizio { $q-upper-advanced-stop-distance }, alla fine { $q-lower-advanced-stop-distance }.
step-dwell-to-cut-free = Per eseguire la spoglia l’utensile sosta sul fondo del foro per { $q-dwell-at-bottom }, se inserito.
step-feed-back-to-set-up-clearance = L’utensile si ritrae con l’avanzamento { $q-plunging-feed } alla distanza di sicurezza { $q-set-up-clearance }.
step-rapid-on-to-second-set-up-clearance = Se è inserita una 2ª distanza di sicurezza { $q-second-set-up-clearance }, l’utensile la raggiunge in rapido (FMAX).
condition-infeeds-decrease = è inserito un decremento { $q-decrement }
condition-starting-point-deepened = il punto di partenza abbassato { $q-deepened-starting-point } è diverso da 0
guard-starting-point-below-depth = Il punto di partenza abbassato si trova alla quota della profondità o più in basso: non rimane nulla da forare.
note-advanced-stop-changes-evenly = Se { $q-upper-advanced-stop-distance } e { $q-lower-advanced-stop-distance } sono diversi, il controllo varia la distanza di prearresto in modo uniforme tra il primo e l’ultimo incremento.
note-deepened-start-changes-infeed-only = Un punto di partenza abbassato { $q-deepened-starting-point } modifica soltanto il punto di partenza dell’incremento. Le ritrazioni continuano a riferirsi alla coordinata della superficie del pezzo.
