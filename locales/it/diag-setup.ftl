# Findings of the checker on tools, the spindle, presets and what the machine and the blank allow.
diag-approach-wrong =
    { $what ->
        [arc] L’arco di raggio { $value } non trova posto tra questo punto e il profilo.
       *[plunged] Il profilo inizia dove l’utensile è penetrato.
    }
diag-config-unknown-machine = L’impostazione della macchina «{ $key }» non esiste; esistono { $expected }.
diag-coordinate-out-of-range = La coordinata { $value } è fuori campo: { $limit } è il valore massimo ammesso dai manuali.
diag-labels-not-known =
    { $count ->
        [one] Un testo qui ha la forma di un’etichetta, ma nessuna lingua lo prevede per questo parametro: resta com’è. --relabel lo sostituisce.
       *[other] Da qui in poi { $count } testi hanno la forma di etichette, ma nessuna lingua li prevede per i loro parametri: restano come sono. --relabel li sostituisce.
    }
diag-machine-limit =
    { $what ->
        [speed] Il numero di giri { $value } supera { $limit }, il massimo della macchina.
        [feed] L’avanzamento { $value } supera { $limit }, il massimo della macchina.
        [helix] L’elica di { $value } gradi supera { $limit }, il massimo della macchina.
        [angle] { $word } { $value } è oltre { $limit }, il finecorsa dell’asse.
        [position] { $word } { $value } è oltre { $limit }, il finecorsa dell’asse.
       *[travel] Il programma usa { $value } mm dell’asse { $word }, lungo solo { $limit } mm.
    }
diag-machining-outside-blank =
    { $what ->
        [above] Il ciclo non scende sotto { $value }, cioè resta sopra il pezzo grezzo: non asporta nulla.
        [below] L’utensile taglia all’altezza { $value }, molto al di sotto del pezzo grezzo.
        [over] Ciò che viene lavorato in { $value }; { $other } oltrepassa il bordo del pezzo grezzo.
       *[outside] Ciò che viene lavorato in { $value }; { $other } è lontano dal pezzo grezzo.
    }
diag-milling-deeper-than-edges = Qui l’utensile fresa a una profondità di { $value }, maggiore della lunghezza dei suoi taglienti (LCUTS).
diag-plane-left-on = Il piano di lavoro è ancora ruotato quando viene chiamato questo utensile.
diag-preset-row-wrong =
    { $what ->
        [again] Il preset { $row } viene scritto di nuovo qui, in un altro punto, e nel frattempo nulla lo ha attivato.
        [other] Qui viene attivato il preset { $other }, ma quello rilevato è il preset { $row }, che non viene mai attivato.
       *[unused] Il preset { $row } viene scritto qui e mai attivato: la lavorazione prosegue con un altro preset.
    }
diag-repeat-without-effect = Una ripetizione di zero volte non ha alcun effetto.
diag-slot-too-narrow = L’utensile di diametro { $tool } qui non passa tra le pareti: questa retta è lunga solo { $value }.
diag-spindle-start-wrong =
    { $what ->
        [missing] Il mandrino non è stato avviato dopo la chiamata di questo utensile.
       *[direction] Il mandrino ruota in senso antiorario (M4) mentre questo utensile lavora.
    }
diag-tap-without-hole =
    { $what ->
        [missing] In { $value }; { $other } non è stato eseguito alcun foro per questo maschio.
       *[shallow] Il maschio scende fino a { $value }, ma il foro termina a { $other }.
    }
diag-tcpm-missing = Qui gli assi rotativi si muovono insieme agli assi lineari senza TCPM, benché il programma disattivi TCPM in seguito.
diag-tool-called-twice = L’utensile { $tool } viene chiamato di nuovo qui, senza nulla tra le due chiamate.
diag-tool-table-contradicts =
    { $what ->
        [speed] Il numero di giri { $value } supera { $other }, il numero di giri massimo dell’utensile { $tool } nella tabella utensili (NMAX).
        [locked] L’utensile { $tool } è bloccato nella tabella utensili (TL) e non è indicato alcun utensile gemello (RT).
        [point] { $value } centra qui sul diametro, ma per l’utensile { $tool } la tabella utensili non indica l’angolo del tagliente (T-ANGLE).
        [turning] { $value } non è adatto all’utensile { $tool }, che nella tabella degli utensili per tornire è di tipo { $other } (TYPE).
       *[type] { $value } non è adatto all’utensile { $tool }, che nella tabella utensili è di tipo { $other } (TYP).
    }
diag-translate-encoding = Il file viene scritto in { $encoding }: vi ha gli stessi byte e vi sono tutte le lettere delle nuove etichette.
diag-translate-encoding-unknown = Non esiste la codifica «{ $encoding }»; esistono { $known }.
diag-translate-encoding-wrong = { $path } non è in { $encoding }: alcuni byte non vi hanno significato.
diag-translate-unread = { $cycle } ha una riga che non può essere letta, perciò il nome e le etichette restano come sono.
related-preset-written-here = scritto qui
diag-character-unknown = Il testo contiene «{ $character }», che il carattere di incisione non possiede.
