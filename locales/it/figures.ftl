# Parole delle figure.

figure-section = Sezione
figure-plan = Vista dall’alto
figure-chip-breaking = Rottura truciolo
figure-decreasing-infeeds = Incrementi decrescenti
figure-deepened-start = Punto di partenza abbassato
figure-centring-diameter = Centrinatura fino al diametro
figure-rotation = Angolo di rotazione
figure-pocket-position = Posizione alla chiamata
figure-milling-type = Fresatura concorde e discorde
figure-allowances = Sovrametalli di finitura
figure-slot-position = Posizione alla chiamata
figure-stud-position = Posizione alla chiamata
figure-approach = Posizione di avvicinamento
figure-stepping-angle = Angolo incrementale
figure-traverse = Percorso tra le lavorazioni
figure-plunging = Penetrazione
figure-side = Vista laterale
figure-new-datum = La nuova origine
figure-probe-axis = Origine nell’asse del tastatore
figure-heights = Altezze di sicurezza
figure-corner-a = Spigolo A
figure-corner-b = Spigolo B
figure-corner-c = Spigolo C
figure-corner-d = Spigolo D
figure-corner-1 = Spigolo 1
figure-corner-2 = Spigolo 2
figure-corner-3 = Spigolo 3
figure-corner-4 = Spigolo 4
figure-front = Svasatura frontale
figure-wall = Distanza laterale
figure-drilling = Foratura
figure-strategy = Strategia di lavorazione
figure-pattern = Più scanalature
figure-side-allowance = Sovrametallo laterale
figure-rounding = Raggio spigolo interno
figure-between-points = Percorso tra i punti da tastare
figure-between-holes = Percorso tra le posizioni
figure-depth-or-diameter = Profondità o diametro
figure-threads-per-step = Giri o eliche
figure-countersinking-moment = Momento della svasatura
figure-finishing-counter-clockwise = Finitura in senso antiorario, Q9 = +1
figure-finishing-clockwise = Finitura in senso orario, Q9 = −1
figure-train-climb = Fresatura concorde, Q15 = +1
figure-train-up-cut = Fresatura discorde, Q15 = −1
figure-train-to-and-fro = In andata e ritorno, Q15 = 0
figure-operation = Lavorazione
figure-no-contact = Percorso senza contatto
way-rapid = rapido
way-feed = avanzamento
way-probing = tastatura

cli-figure = Scrive le figure di un ciclo come file SVG
cli-figure-out = La cartella per le figure; se non esiste, viene creata
cli-examples-figure =
    ciklo figure 205 --control tnc640 --lang sl --out figures
cli-coverage-figures = { $count } di { $of } lunghezze, angoli e posizioni senza figura: { $ids }

diag-figure-example-missing = La figura { $name } di { $cycle } deve essere disegnata dall’esempio { $example }, che il ciclo non possiede.
diag-figure-moment-never = L’esecuzione della figura { $name } di { $cycle } non arriva mai al momento da mostrare ({ $reason }).
diag-figure-name-taken = Due figure di { $cycle } si chiamano entrambe { $name }.
diag-figure-no-value = La figura { $figure } di { $cycle } mostra { $name } tra punti che in quel momento non hanno valore.
diag-figure-no-centre = La figura { $figure } di { $cycle } mostra { $name } come angolo, ma il centro manca o non è un punto.
diag-figure-axis-not-visible = La figura { $figure } di { $cycle } mostra { $name } lungo un asse che la vista non contiene.
diag-figure-mixed-places = La figura { $figure } di { $cycle } mostra { $name } tra una coordinata e un punto: i due estremi devono essere dello stesso tipo.
diag-figure-measured-otherwise = La figura { $figure } di { $cycle } mostra { $name } tra punti che nell’esecuzione distano { $measured }; il valore è { $value }.
diag-figure-nothing-to-see = La figura { $figure } di { $cycle } mostra { $name } con il valore 0: non c’è nulla da vedere.
diag-figure-place-not-reached = La figura { $figure } di { $cycle } mostra { $name } fino a un punto ({ $place }) che né l’utensile né il pezzo raggiungono.
diag-figure-none = Il ciclo { $cycle } non ha figure su questo controllo numerico.
diag-figure-parameter-not-shown = Nessuna figura di { $cycle } mostra { $name } e la specifica non ne indica il motivo.
figure-teeth = Taglienti sul sistema di tastatura utensile
figure-turning-tool = Utensile rotante
figure-single-teeth = Taglienti singoli
figure-line-angle = Angolo delle righe
figure-rotary-a = Lungo l’asse rotativo A
figure-rotary-b = Lungo l’asse rotativo B
figure-rotary-c = Lungo l’asse rotativo C
figure-backlash = Gioco di inversione
figure-sphere = Tastatura della sfera calibrata
figure-basic-rotation = Rotazione base
figure-greatest-dimension = Quota massima
figure-least-dimension = Quota minima
figure-centre-tolerance = Tolleranza del centro
figure-spatial-angle-a = Angolo solido A
figure-spatial-angle-b = Angolo solido B
figure-spatial-angle-c = Angolo solido C
figure-counterbore = Lamatura
figure-disengaging = Direzione di disimpegno
figure-pre-drilled = Preforo
figure-touch-points = Punti da tastare
figure-measuring-axis = Asse di misura
figure-traverse-direction = Direzione di spostamento
figure-straight-or-circle = In linea retta o su cerchio
figure-program = Il programma dall’alto
figure-program-turned = Il programma: metà del pezzo in sezione
figure-program-recess = Il programma: la gola
figure-program-side = Il programma di lato
figure-program-across = Il programma lungo l’asse rotativo
figure-program-tilted = Il piano ruotato del programma
figure-wide-slot = Scanalatura larga
