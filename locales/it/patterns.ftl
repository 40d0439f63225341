# Point patterns; see the English file.
cycle-circular-pattern = Sagome di punti su cerchio
    .nc = CERCHIO FIGURE
    .purpose = Esegue l’ultimo ciclo di lavorazione definito in punti disposti su un cerchio o su un arco di cerchio.
step-move-to-first-operation = Il controllo porta l’utensile in rapido dalla posizione attuale al punto di partenza della prima lavorazione: alla 2ª distanza di sicurezza { $q-second-set-up-clearance } (asse del mandrino), sul punto di partenza nel piano di lavoro e alla distanza di sicurezza { $q-set-up-clearance } sopra la superficie del pezzo (asse del mandrino).
step-call-last-machining-cycle = Da questa posizione il controllo esegue l’ultimo ciclo di lavorazione definito.
step-height-between-operations = Tra una lavorazione e l’altra l’utensile si sposta nell’asse del mandrino:
say-to-second-set-up-clearance = { $q-pattern-clearance-mode } = 1: alla 2ª distanza di sicurezza { $q-second-set-up-clearance }
say-to-set-up-clearance = { $q-pattern-clearance-mode } = 0: alla distanza di sicurezza { $q-set-up-clearance }
step-move-to-next-operation = Il controllo porta poi l’utensile sul punto di partenza della lavorazione successiva e in quel punto alla distanza di sicurezza { $q-set-up-clearance }:
say-on-the-pitch-circle = { $q-pattern-traverse-type } = 1: sul cerchio parziale
say-in-a-straight-line = { $q-pattern-traverse-type } = 0: su una retta
until-all-operations-done = non sono state eseguite tutte le { $q-number-of-operations } lavorazioni
condition-stepping-angle-computed = non è inserito alcun angolo incrementale { $q-pattern-stepping-angle }
guard-pattern-angles-equal = L’angolo di partenza e l’angolo finale sono uguali. Inserire angoli diversi oppure un angolo incrementale.
note-pattern-is-def-active = Il ciclo è attivo dalla sua definizione: chiama automaticamente l’ultimo ciclo di lavorazione definito.
note-pattern-overrides-heights = Se uno dei cicli di lavorazione da 200 a 209 e da 251 a 267 viene combinato con questo ciclo, valgono la distanza di sicurezza { $q-set-up-clearance }, la coordinata della superficie del pezzo { $q-surface-coordinate } e la 2ª distanza di sicurezza { $q-second-set-up-clearance } di questo ciclo.
note-pattern-combinations = Il ciclo può essere combinato con i cicli di lavorazione da 200 a 209, 240, da 251 a 253, 256, 257, da 262 a 265 e 267. Il ciclo 254 (scanalatura circolare) può essere combinato solo con il ciclo 221.
note-pattern-alternatives = Per sagome di punti irregolari utilizzare tabelle punti con CYCL CALL PAT. Altre sagome di punti regolari sono disponibili con la funzione PATTERN DEF.
note-def-active-before-call-active = I cicli attivi dalla definizione dovrebbero essere programmati prima dei cicli da chiamare. Tra la definizione e la chiamata di un ciclo, un ciclo di questo tipo è ammesso solo se i due non hanno in comune parametri che devono mantenere valori diversi.
