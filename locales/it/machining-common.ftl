# Sentences that several machining cycles share; see the English file.

# --- steps ---
step-rapid-to-set-up-clearance = Il controllo porta l’utensile nell’asse del mandrino in rapido (FMAX) alla distanza di sicurezza { $q-set-up-clearance } sopra la superficie del pezzo.
until-depth-reached = non è raggiunta la profondità programmata { $q-depth }

# --- conditions ---

# --- guards ---
guard-depth-zero = La profondità è 0: il controllo non esegue il ciclo.
guard-depth-positive = La profondità è positiva. Inserire una profondità negativa oppure ammettere profondità positive con il parametro macchina { $mp-display-depth-err }.

# --- notes ---
note-program-before-call = Prima della chiamata del ciclo programmare la chiamata utensile, il senso di rotazione del mandrino (M3 o M4) e la definizione del ciclo; per il test grafico occorre anche la definizione del pezzo grezzo (BLK FORM).
note-graphic-test-first = Pericolo di collisione! I cicli possono eseguire lavorazioni estese. Per sicurezza, prima della lavorazione eseguire un test grafico del programma.
note-sign-of-depth = Il segno della profondità { $q-depth } determina la direzione di lavoro. Con profondità 0 il controllo non esegue il ciclo.
note-positive-depth-error = Pericolo di collisione con una profondità positiva! Il parametro macchina { $mp-display-depth-err } determina se all’inserimento di una tale profondità il controllo deve emettere un messaggio d’errore (on) oppure no (off).
note-positive-depth-reverses = Pericolo di collisione! Con una profondità { $q-depth } positiva il controllo inverte il calcolo della posizione preliminare: l’utensile si porta in rapido nell’asse utensile alla distanza di sicurezza sotto la superficie del pezzo.
note-retraction-between-pattern-points = Con CYCL CALL PAT l’utensile si ritrae tra un punto e l’altro a un’altezza sicura: la coordinata dell’asse del mandrino alla chiamata del ciclo oppure la 2ª distanza di sicurezza { $q-second-set-up-clearance }, se questa è più alta.
note-assigned-parameters-are-fixed = Se a un parametro del ciclo viene assegnato un altro parametro, una modifica di quest’ultimo dopo la definizione del ciclo non ha effetto.
note-fauto-is-fixed = FAUTO acquisisce l’avanzamento del blocco TOOL CALL all’esecuzione della definizione del ciclo; una modifica successiva dell’avanzamento non ha effetto.
