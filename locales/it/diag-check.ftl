# Segnalazioni della verifica e della traduzione di programmi; vedere il file inglese.

diag-approach-twice =
    { $what ->
        [call] Il sottoprogramma inizia un profilo con RL o RR, ma qui viene chiamato con la correzione della chiamata precedente ancora attiva.
       *[approach] Qui ci si avvicina al profilo con la correzione del raggio ancora attiva: il profilo precedente non è stato lasciato.
    }
diag-approach-without-compensation =
    { $what ->
        [approach] Qui ci si avvicina al profilo senza RL o RR.
        [contour] L’utensile percorre questo profilo chiuso senza RL o RR, e poi R0 disattiva ciò che non era mai stato attivo.
       *[departure] Qui ci si allontana dal profilo, ma nessuna correzione del raggio è attiva.
    }
diag-arc-direction-wrong =
    { $what ->
        [sign] Questo arco si raccorda agli elementi prima e dopo solo con l’altro segno del raggio: così com’è scritto è la parte maggiore del cerchio.
        [full] Qui l’utensile percorre un cerchio completo all’interno del profilo: la fine dell’arco è il suo inizio.
        [beyond] Questo arco esce dal pezzo grezzo; con l’altro senso di rotazione resterebbe all’interno.
       *[direction] Questo arco si raccorda agli elementi precedente e successivo solo con l’altro senso di rotazione.
    }
diag-arc-in-unequal-scaling = { $cycle } scala gli assi di questo arco con fattori diversi: il risultato non è un arco.
diag-arc-too-narrow = Il raggio { $radius } all’interno del profilo è inferiore a quello dell’utensile, { $tool }.
diag-arc-without-tangent = Prima di questo arco tangente non c’è alcun elemento di profilo.
diag-arc-wrong =
    L’arco non può terminare qui: { $what ->
        [radius] il raggio è { $first }, ma la distanza tra inizio e fine è { $second }
        [full] finisce dove comincia; il centro di un cerchio completo non risulta dal raggio
        [sense] l’angolo è { $first }, ma DR ha il senso opposto
       *[centre] l’inizio dista { $first } dal centro, la fine { $second }
    }.
diag-axis-twice = L’asse { $axis } compare due volte in questo blocco.
diag-back-boring-inside =
    { $what ->
        [hole] Il tagliente arriva a { $value } dall’asse del foro, che ha un raggio di soli { $other }: l’utensile non passa.
       *[thickness] Secondo il ciclo il materiale è spesso { $value }, ma il pezzo grezzo arriva { $other } sotto la superficie.
    }
diag-blocks-after-end = Qui ci sono blocchi dopo END PGM.
diag-blank-wrong =
    { $what ->
        [again] Il pezzo grezzo ha già un BLK FORM 0.1.
        [axis] Qui manca { $axis }: un vertice del pezzo grezzo ha tre coordinate.
        [first] Prima di BLK FORM 0.2 non c’è BLK FORM 0.1.
        [cylinder] Al cilindro manca il raggio o il diametro, oppure la lunghezza.
        [second] Dopo BLK FORM 0.1 non c’è BLK FORM 0.2.
        [tool] Il pezzo grezzo non indica l’asse utensile.
       *[order] Nell’asse { $axis } il secondo vertice del pezzo grezzo deve avere una coordinata maggiore del primo.
    }
diag-block-numbers = Il numero di blocco { $number } segue { $before }.
diag-call-of-def-active-cycle = { $cycle } è attivo dalla sua definizione; non deve essere chiamato.
diag-called-but-not-defined = Qui viene chiamato un ciclo, ma non ne è stato definito alcuno.
diag-called-program-in-other-unit = Questo programma è in { $own }, ma il programma chiamato { $name } è in { $other }.
diag-called-program-missing = Il programma { $name } non si trova accanto a questo, dove il controllo lo cerca.
diag-centre-in-other-plane = L’arco e il suo centro non si trovano nello stesso piano.
diag-chamfer-wrong-side = La punta dell’utensile per smussi passa a una profondità di { $value } nel pieno, { $other } all’interno del bordo del grezzo: all’esterno lo smusserebbe.
diag-choice-not-offered = { $parameter }={ $value } non è una delle scelte: { $offered }.
diag-clearance-height-too-low =
    { $what ->
        [stud] { $cycle } si sposta da foro a foro a { $parameter }={ $value }, e un’isola tra essi arriva fino a { $least }.
       *[touched] { $cycle } tasta a { $touched }: l’altezza di sicurezza { $parameter }={ $value } deve trovarsi sopra { $least }.
    }
diag-compensation-at-cycle =
    { $cycle } viene eseguito qui con la correzione del raggio attiva.
diag-compensation-left-on = Qui la correzione del raggio è ancora attiva.
diag-compensation-missing = Altrove questo profilo viene lavorato con RL o RR; qui lo percorre il centro dell’utensile con R0.
diag-compensation-on-arc = La correzione del raggio non deve iniziare su un arco.
diag-compensation-other-side = Lo stesso profilo è stato lavorato prima con la correzione del raggio opposta: qui l’utensile è sull’altro lato.
diag-compensation-switched = La correzione del raggio cambia lato qui senza R0 intermedio.
diag-contour-at-rapid = Qui l’utensile percorre in rapido un profilo con correzione del raggio.
diag-contour-data-missing = { $cycle } viene chiamato, ma { $data } non è stato definito prima.
diag-contour-def-wrong =
    { $what ->
        [number] { $found }: un altro profilo ha già questo numero.
        [many] { $found }: CONTOUR DEF può avere al massimo nove profili.
       *[island] { $found }: il primo profilo di CONTOUR DEF deve essere una tasca, la più profonda.
    }
diag-contour-depth-missing = { $contour } non ha DEPTH, ma altri profili sì.
diag-contour-returns =
    { $what ->
        [back] Qui il profilo torna indietro lungo la linea sulla quale è arrivato a { $value }, { $other }.
       *[corner] Il profilo torna in { $value }; { $other }, uno spigolo che ha già.
    }
diag-contour-undeclared =
    { $what ->
        [twice] { $contour } è già stato dichiarato.
       *[nothing] La formula usa { $contour }, che prima non è stato dichiarato.
    }
diag-contour-not-selected =
    { $cycle } viene chiamato qui, ma non è stato selezionato alcun profilo.
diag-contour-wrong =
    { $cycle } non può lavorare il profilo così: { $what ->
        [axis] contiene un movimento nell’asse utensile { $word }
        [approach] contiene { $word }
        [tool] contiene { $word }
        [call] contiene { $word }
        [path] il ciclo non legge { $word }
        [first] il primo punto non ha entrambe le coordinate del piano
        [uncompensated] non ha né RL né RR
        [many] il ciclo lavora solo il primo profilo e ignora { $word }
        [corner] nessun elemento segue { $word }
        [local] vi si legge { $word }, ma non vi viene assegnato
        [same] il profilo { $word } è lo stesso
        [islands] secondo RL e RR sono tutti isole, e non c’è nessuna tasca attorno ad essi
        [round] in entrambi gli assi è più lungo della circonferenza del cilindro
        [nested] secondo RL o RR è una tasca e si trova interamente in un’altra tasca, perciò non asporta nulla
        [beside] secondo RL o RR è un’isola e si trova accanto a tutte le tasche, perciò lì non si lavora nulla
       *[open] non finisce dove comincia
    }.
diag-coordinate-out-of-place = { $path } non ammette queste coordinate.
diag-core-hole-too-large =
    { $what ->
        [removed] La punta con diametro { $other } asporta la filettatura { $value } maschiata qui in precedenza.
       *[core] Il foro ha diametro { $other }, la filettatura { $value }: non resta materiale per la filettatura.
    }
diag-core-hole-too-small =
    { $what ->
        [milled] La fresa per filettare da { $value } entra in un foro da { $other }: il foro è troppo stretto.
       *[tapped] Una filettatura di { $value } viene maschiata in un foro di { $other }: il foro è troppo stretto.
    }
diag-corner-wrong =
    Questo spigolo non si può lavorare: { $what ->
        [twice] segue direttamente un altro arrotondamento o smusso
        [arc] uno smusso deve trovarsi tra due rette, ma uno degli elementi è un arco
        [first] non lo precede alcun elemento di profilo
        [alone] non è seguito da un elemento del profilo
        [back] la retta che lo segue torna indietro lungo quella che lo precede
        [size] il suo raggio o la sua lunghezza non è positiva
       *[long] richiede più della lunghezza della retta più corta, { $least }
    }.
diag-cutting-speed-unusual =
    { $side ->
        [above] Una velocità di taglio di { $value } m/min è decisamente troppo alta per questo utensile del diametro di { $other }.
        [reamed] L’alesatore con diametro { $other } avanza solo di { $value } al giro: la velocità del mandrino è decisamente troppo alta o l’avanzamento troppo basso.
       *[below] Una velocità di taglio di { $value } m/min è decisamente troppo bassa per questo utensile del diametro di { $other }.
    }
diag-cutting-without-tool = Qui l’utensile si sposta in avanzamento, ma prima non c’è alcuna chiamata utensile.
diag-cycle-line-zero-missing = La riga { $line } non è preceduta dalla riga { $head }.
diag-cycle-line-empty = Nella riga { $line } di { $cycle } non c’è nulla.
diag-cycle-line-missing =
    { $line ->
        [none] Manca la riga { $missing }: la definizione ha soltanto il nome.
       *[other] Prima di { $line } manca la riga { $missing }.
    }
diag-cycle-line-twice = La riga { $line } compare due volte in questa definizione.
diag-cycle-not-covered =
    { $other ->
        [none] { $cycle } non viene verificato: i manuali del controllo { $control } noti a Ciklo non trattano cicli di questo tipo.
       *[other] I manuali del controllo { $control } noti a Ciklo non trattano cicli come { $cycle }: viene verificato in base al manuale di { $other }.
    }
diag-cycle-not-described =
    { $other ->
        [none] I manuali citano { $cycle } ({ $name }) ma non lo descrivono: i suoi parametri non vengono verificati.
       *[other] I manuali citano { $cycle } ({ $name }) ma non lo descrivono: viene verificato in base al manuale di { $other }.
    }
diag-cycle-not-on-control = { $cycle } non esiste sul controllo { $control }; esiste su: { $controls }.
diag-cycle-of-previous-tool = { $cycle } è stato definito per l’utensile precedente, che ha già lavorato con esso.
diag-cycle-removes-nothing = { $cycle } qui non asporta nulla: dove passa il suo utensile non c’è materiale.
diag-datum-table-late = Lo spostamento origine precedente prende la sua riga da un’altra tabella: programmare prima SEL TABLE.
diag-defined-but-never-called = { $cycle } è definito qui, ma non viene mai chiamato.
diag-deviation-compared =
    { $what ->
        [deviation] { $parameter } è lo scostamento dalla quota nominale { $other }, ma viene confrontato con { $value } come se fosse la quota stessa.
       *[size] { $parameter } è la quota misurata (nominale { $other }), ma viene confrontato con { $value } come se fosse lo scostamento.
    }
diag-digitizing-wrong =
    { $what ->
        [swapped] { $word } è minore del punto MIN del campo, { $other }.
        [low] L’altezza di sicurezza { $word } è al di sotto del punto MAX del campo, { $other }.
        [missing] { $cycle } digitalizza, ma prima non è stato definito alcun campo.
       *[combined] { $cycle } non può essere combinato con { $range }, che qui definisce il campo.
    }
diag-arc-direction-missing = Manca il senso di rotazione di questo arco, DR+ o DR−.
diag-doubtful-value =
    { $parameter }={ $value } in { $cycle } difficilmente è voluto: { $is ->
        [zero] il valore è 0
        [negative] il valore è negativo
        [small] il valore è molto più piccolo del solito
        [large] il valore è molto più grande del solito
       *[positive] il valore è positivo e allontana l’utensile dal pezzo
    }.
diag-duplicate-parameter = { $parameter } compare due volte in { $cycle }.
diag-early-cycle-wrong =
    { $what ->
        [corner] Il raggio dell’angolo { $value } della tasca è minore del raggio { $other } dell’utensile.
        [clearance] La distanza di sicurezza { $value } è negativa: il ciclo inizierebbe sotto la sua superficie.
        [depth] La profondità { $value } è positiva: il ciclo allontana l’utensile dal pezzo.
        [infeed] Con una profondità incremento di 0 il ciclo non può lavorare.
        [feed] L’avanzamento del ciclo è 0.
        [narrow] L’utensile con il diametro di { $other } non entra in una scanalatura o tasca di { $value }.
        [pitch] La filettatura ha un passo di { $value }, ma il maschio ha { $other }.
        [peck] Il foro viene eseguito in un solo incremento di { $value }: più di otto volte il diametro { $other } della punta.
        [wide] La tasca circolare è larga { $value } e il pezzo grezzo solo { $other }: al posto del raggio potrebbe essere stato inserito il diametro.
        [sides] Con i lati { $value } e { $other } la tasca oltrepassa il bordo del pezzo grezzo; scambiati, starebbe all’interno.
       *[tapped] Un avanzamento di { $value } non è adatto al maschio: passo per numero di giri dà { $other }.
    }
diag-empty-word = Questa { $word } è senza valore e non fa nulla.
diag-feed-negative = Qui l’avanzamento è negativo.
diag-feed-zero = Qui l’avanzamento è zero.
diag-field-word-missing = Qui c’è un valore senza parola; il controllo lo mostra con una parola: { $shown }.
diag-begin-end-mismatch = END PGM indica { $end }, BEGIN PGM indica { $begin }.
diag-free-contour-wrong =
    { $what ->
        [label] Un profilo libero non può cominciare subito dopo un label.
        [again] CLSD+ compare di nuovo prima che CLSD- abbia chiuso il profilo.
        [unbegun] CLSD- chiude un profilo che nessun CLSD+ ha aperto.
        [unclosed] Il profilo aperto con CLSD+ termina qui senza CLSD-.
        [length] La lunghezza LEN non è positiva.
        [auxiliary] Alla distanza D manca il punto ausiliario (PDX, PDY).
        [distance] Al punto ausiliario manca la distanza D.
        [selected] FSELECT non segue alcun elemento di un profilo libero.
        [solution] FSELECT richiede il numero di una soluzione, contato da 1.
        [fpol] Il polo di un profilo libero richiede due coordinate.
        [pole] Le coordinate polari richiedono un polo (FPOL).
        [turn] Il profilo comincia e finisce sullo stesso cerchio, ma in direzioni diverse.
       *[open] Il profilo libero non ha soluzione: dei suoi elementi sono indicati troppo pochi valori.
    }
diag-function-misspelled = Nessun controllo accetta qui { $word }; forse si intende { $meant }.
diag-function-not-on-control = Il { $control } non ha { $function }.
diag-functions-contradict = { $first } e { $second } si escludono a vicenda, ma sono nello stesso blocco.
diag-global-def-wrong =
    { $what ->
        [unknown] GLOBAL DEF { $number } non esiste.
        [missing] In GLOBAL DEF { $number } manca { $parameter }.
        [foreign] GLOBAL DEF { $number } non ha { $parameter }.
        [twice] { $parameter } compare due volte in GLOBAL DEF { $number }.
        [again] GLOBAL DEF { $number } è già stato programmato, ma nessun ciclo ne ha usato i valori.
        [nothing] In { $value } per { $parameter } si trova PREDEF, ma nessun GLOBAL DEF lo imposta.
        [later] In { $value } per { $parameter } si trova PREDEF, ma il GLOBAL DEF che lo imposta viene dopo.
       *[value] Nessun ciclo ammette { $parameter }={ $value }.
    }
diag-guard = Il controllo non accetta questi valori.
diag-hole-outside-blank =
    { $what ->
        [beside] Il foro in { $value }; { $other } è fuori dal pezzo grezzo.
        [edge] Il bordo del pezzo grezzo taglia il foro in { $value }; { $other }.
        [surface] La superficie a { $value } è lontana dal pezzo grezzo.
        [tilted] I fori di questo ciclo non incontrano il pezzo grezzo: nel piano inclinato si trovano a lato o al di sopra di esso.
       *[through] Il foro arriva a { $value }, ben oltre il pezzo grezzo.
    }
diag-incremental-left-on = Le coordinate di questo profilo sono incrementali; solo come assolute riportano al suo inizio.
diag-pattern-not-called = Qui il ciclo è richiamato in una sola posizione non nelle posizioni della sagoma della riga { $line }.
diag-plunge-beside-hole = Prima il blocco è sceso in un foro, ma a { $value }, { $other } penetra nel materiale pieno.
diag-polygon-incomplete =
    { $what ->
        [rectangle] A un rettangolo manca il vertice a { $value }, { $other }: questa linea lo taglia via.
       *[polar] A un poligono regolare con { $count } vertici manca quello a { $value }°.
    }
diag-position-without-call = Tra due chiamate l’utensile va a { $value }, { $other } e lì non fa nulla: potrebbe mancare una chiamata (M99, CYCL CALL).
diag-result-of-other-axis =
    { $what ->
        [size] { $value } è il valore nominale di { $other }, ma qui viene confrontato con { $parameter }.
       *[axis] { $parameter } è il risultato per l’asse { $axis }, ma qui viene usato per { $other }.
    }
diag-holes-overlap =
    { $what ->
        [pockets] La tasca o scanalatura attorno a { $value }, { $other } entra in un’altra della stessa definizione.
        [pocket] Il foro a { $value }, { $other } è tagliato da una tasca o scanalatura fresata prima.
        [hole] Il foro in { $value }; { $other } è tagliato per tutta la lunghezza da uno più largo eseguito prima.
        [inside] La tasca o scanalatura intorno a { $value }; { $other } sta per la maggior parte in un’altra fresata prima e altrettanto profonda, a differenza delle altre della sua definizione.
        [beside] In { $value }; { $other } viene allargato un foro, ma i fori del diametro preforato sono altrove.
       *[holes] Qui due fori del diametro di { $other } distano solo { $value }: si sovrappongono.
    }
diag-insert-points-away = L’inserto non può tagliare dove va { $cycle }: il suo orientamento (TO) è { $orientation }, perciò la punta è rivolta dalla parte opposta al pezzo o all’avanzamento.
diag-iso-incomplete =
    Questo blocco è incompleto: { $what ->
        [value] una lettera è senza valore
        [label] manca il label (L)
        [radius] manca il raggio o la lunghezza (R)
        [cycle] mancano le parole del ciclo (P01, P02, …)
       *[operand] manca un operando o il label di un salto (P01, P02, P03)
    }.
diag-label-duplicate = Il label { $label } è impostato due volte; questa è la seconda.
diag-label-missing = La lingua «{ $language }» non ha un’etichetta per { $parameter } di { $cycle }.
diag-label-not-encodable = «{ $label }» contiene il carattere «{ $character }», che non esiste nella codifica del file.
diag-label-of-another-language = «{ $label }» è un’etichetta in un’altra lingua ({ $language }); nella lingua del programma { $parameter } è «{ $right }».
diag-label-of-another-parameter = «{ $label }» è l’etichetta di { $other }, non di { $parameter }.
diag-label-twice = { $parameter } e { $other } hanno entrambi l’etichetta «{ $label }», che può essere giusta solo per uno dei due.
diag-label-undefined = Nessun blocco imposta il label { $label }.
diag-labels-of-unknown-language =
    { $count ->
        [one] Le etichette di questa definizione sono in una lingua che Ciklo non conosce; è stata letta in base ai numeri dei parametri.
       *[other] Le etichette di { $count } definizioni, di cui questa è la prima, sono in una lingua che Ciklo non conosce; sono state lette in base ai numeri dei parametri.
    }
diag-languages-mixed = La maggior parte delle etichette è in una lingua ({ $language }); le definizioni in queste righe sono in un’altra ({ $others }): { $lines }.
diag-loop-endless =
    { $what ->
        [counter] Questo salto aspetta { $parameter }, ma nella ripetizione nulla lo conta.
       *[jump] Questo salto chiude una ripetizione che non termina mai.
    }
diag-machine-coordinates-compensated = Qui si programmano coordinate macchina (M91, M92) con correzione del raggio.
diag-machine-coordinates-missing = Altrove il programma si disimpegna a { $value } con M91; qui M91 manca, e la quota vale dall’origine del pezzo.
diag-main-runs-into-subprogram = Il programma principale prosegue qui nel sottoprogramma { $label }: non lo termina né M2 né M30.
diag-measuring-height-above-surface = L’altezza di misura { $value } è al di sopra del pezzo, che termina a { $other }.
diag-measuring-height-below-floor = { $cycle } misura a { $parameter }={ $value }, sotto il fondo a { $floor } lasciato in quel punto da { $milling }.
diag-metric-values-in-inch = Il programma è in pollici, ma { $value } sembra espresso in millimetri.
diag-mirror-of-tool-axis = L’asse utensile { $axis } non si può rendere speculare.
diag-misordered-parameter = In { $cycle } il controllo visualizza { $parameter } prima di { $before }.
diag-missing-parameter =
    { $count ->
        [one] In { $cycle } manca { $parameter }.
       *[other] In { $cycle } mancano { $parameter }.
    }
diag-modal-call-left-on =
    { $what ->
        [beside] M89 chiama ancora il ciclo in questo blocco, che porta in una posizione fuori dal pezzo grezzo.
       *[again] M89 chiama ancora il ciclo in questo blocco: l’ultima posizione viene lavorata di nuovo.
    }
diag-mode-wrong =
    { $what ->
        [milling] { $cycle } fresa o fora, ma qui il controllo è nel modo tornitura (FUNCTION MODE TURN).
        [turning] { $cycle } tornisce, ma qui il controllo non è nel modo tornitura (FUNCTION MODE TURN).
       *[data] { $cycle } viene usato fuori dal modo tornitura.
    }
diag-name-of-another-cycle = «{ $name }» è il nome di { $other }, ma qui c’è { $cycle }.
diag-no-result =
    Questa formula non ha risultato: { $why ->
        [division] divide per zero
        [large] il numero è troppo grande
       *[domain] una funzione non è definita per il suo valore
    }.
diag-no-table-open = FN 27 e FN 28 richiedono una tabella aperta da FN 26.
diag-nominal-differs = Qui il diametro nominale è { $value }, mentre la tasca in questo punto è larga { $other }.
diag-not-a-program = Questo file non è un programma NC.
diag-nothing-left = Qui il foro è già largo { $other }: un utensile di { $value } non asporta nulla.
diag-number-does-not-exist = { $name } non esiste: il numero massimo è { $greatest }.
diag-older-parameter-set = { $cycle } ha i parametri di una versione software precedente; il controllo aggiunge { $parameter }.
diag-out-of-range =
    { $side ->
        [below] { $parameter }={ $value } è troppo piccolo: il valore minimo è { $limit }.
        [long] Il testo di { $parameter } è troppo lungo: sono ammessi al massimo { $limit } caratteri.
        [many] { $parameter } elenca troppi label: ne sono ammessi al massimo { $limit }.
        [axes] { $parameter } indica troppi assi: ne sono ammessi al massimo { $limit }.
       *[above] { $parameter }={ $value } è troppo grande: il valore massimo è { $limit }.
    }
diag-out-of-usual-range =
    { $parameter }={ $value } difficilmente è voluto: { $where ->
        [control] il { $control } non accetta qui valori { $side ->
                [below] inferiori a
               *[above] superiori a
            } { $limit }.
       *[any] nessun manuale ammette per un parametro simile valori { $side ->
                [below] inferiori a
               *[above] superiori a
            } { $limit }.
    }
diag-parameter-of-later-software = { $parameter } in { $cycle } richiede una versione software successiva alla { $software }, quella descritta nel manuale.
diag-parameter-unassigned =
    { $parameter } viene letto qui, ma nulla gli ha assegnato un valore.
diag-path-twice =
    { $what ->
        [repeated] L’utensile percorre questa traiettoria per la terza volta: non resta nulla da asportare.
        [air] Con questa conversione il percorso da qui in poi non asporta nulla, mentre gli stessi blocchi con un’altra hanno lavorato.
        [copied] Il profilo da qui in poi è già stato lavorato con questo utensile da altri blocchi, anche se l’utensile è stato posizionato altrove.
       *[transformed] L’intera traiettoria da qui in poi è già stata lavorata con questo utensile con un’altra conversione.
    }
diag-path-not-closed = Questo sottoprogramma non torna al suo inizio, anche se viene richiamato nello stesso punto: il passo è { $value }, { $other } chiuderebbe il percorso.
diag-pattern-combination =
    { $what ->
        [value] { $cycle } non può chiamare { $called } con { $value }.
       *[cycle] { $cycle } non può chiamare { $called }.
    }
diag-pattern-wrong =
    { $what ->
        [count] { $word } deve essere un numero intero di posizioni, almeno 1.
        [many] { $word }: PATTERN DEF può avere al massimo nove posizioni singole.
        [rapid] { $word } qui non è ammesso: tra i punti di una tabella l’utensile si sposta in avanzamento.
        [distance] { $word } vale 0: tutte le posizioni coincidono.
        [angle] { $word } supera un giro completo.
        [same] { $word } ripete una posizione precedente.
       *[diameter] Il diametro { $word } di un cerchio parziale deve essere maggiore di 0.
    }
diag-pilot-hole-too-shallow =
    { $what ->
        [bored] L’utensile tornisce all’interno fino a { $value }, e il foro eseguito termina a { $other }.
       *[start] Il punto di partenza abbassato è a { $value }, e il foro esistente termina a { $other }.
    }
diag-pilot-hole-elsewhere = Sul foro in { $value }; { $other } non viene eseguito altro, e una tasca inizia nel pieno nel punto con le due coordinate scambiate.
diag-plane-incomplete = In questo PLANE manca { $word }.
diag-plane-not-positioned =
    { $what ->
        [cycle] Nessun blocco posiziona gli assi rotativi dopo questa rotazione del piano; se lo fa il ciclo dipende dalla macchina.
        [reset] PLANE RESET con STAY lascia ruotati gli assi rotativi, e la lavorazione prosegue prima che un blocco li riporti indietro.
       *[plane] STAY non muove gli assi rotativi, e nessun blocco del programma li porta agli angoli di questo piano.
    }
diag-plane-not-reset =
    { $what ->
        [zero] { $cycle } imposta qui tutti gli angoli a 0, ma nulla disattiva la rotazione del piano di lavoro.
       *[tilted] Il programma termina qui con il piano di lavoro ruotato.
    }
diag-plunge-too-fast =
    { $what ->
        [sideways] Qui l’utensile attraversa materiale pieno con { $value } volte l’avanzamento della sua chiamata.
        [tenfold] Qui l’utensile attraversa materiale pieno con { $value } volte l’avanzamento delle sue altre passate.
        [turn] Qui l’utensile fresa { $value } al giro, molto più di quanto regga un utensile del suo diametro.
       *[plunge] Qui l’utensile penetra nel materiale di { $value } al giro.
    }
diag-position-after-contour = Questa è la prima posizione dopo { $cycle }, ma non ha valori assoluti per entrambe le coordinate del piano.
diag-position-missing = L’utensile scende a { $value } prima che il programma lo abbia posizionato nel piano.
diag-position-twice =
    { $what ->
        [definition] La definizione è, parola per parola, quella chiamata prima, e da allora l’utensile non si è mosso: non resta nulla da lavorare.
       *[place] Il punto { $value }; { $other } è già stato lavorato con questa definizione e questo utensile.
    }
diag-probe-while-turning = { $cycle } tasta qui mentre il mandrino gira.
diag-probed-axis-missing = Si tasta in direzione { $direction }, ma la posizione non contiene { $axis }.
diag-program-begin-missing = Il programma non inizia con BEGIN PGM.
diag-program-begin-twice = BEGIN PGM compare qui una seconda volta.
diag-program-calls-itself = Il programma chiama sé stesso: { $name }.
diag-program-empty = Il file non contiene blocchi.
diag-program-end-missing =
    Il programma finisce qui senza { $end ->
        [iso] un blocco finale che inizi con %
       *[pgm] END PGM
    }.
diag-programs-call-in-circle = Il programma { $name } richiama a sua volta questo, direttamente o tramite altri.
diag-rapid-into-blank = Qui l’utensile entra nel pezzo grezzo in rapido: va a Z { $value }, e il bordo superiore del grezzo è a { $top }.
diag-rapid-through-material = Qui l’utensile attraversa in rapido fino a { $value }{"\u00A0"}mm di materiale.
diag-reaming-wrong =
    { $what ->
        [none] Qui non c’è alcun foro da alesare.
        [deep] L’alesatore arriva a { $value }, il foro solo a { $other }.
        [bored] Il bareno arriva a { $value }, il foro solo a { $other }.
        [stock] Il foro è largo { $other }: un bareno di { $value } non può asportare così tanto.
       *[allowance] Il foro è largo { $other }: per un alesatore di { $value } resta fin troppo materiale.
    }
diag-repeat-count-wrong = Il numero di ripetizioni deve essere un numero intero da 0 a 65534.
diag-repeat-of-later-label = Il label { $label } deve trovarsi prima della ripetizione, non dopo.
diag-repeated-infeed =
    { $what ->
        [absolute] La conversione nella parte ripetuta è assoluta: dalla seconda passata in poi fa ogni volta lo stesso.
        [deep] Le ripetizioni arrivano a { $value }, molto al di sotto del pezzo grezzo.
       *[same] Ogni ripetizione va di nuovo a { $value } e fa lo stesso della prima passata.
    }
diag-reserved-parameter = Qui viene scritto { $parameter }, ma i parametri da Q100 a Q199 appartengono al controllo, che li sovrascrive.
diag-reset-order-wrong =
    { $what ->
        [tilt] Qui la rotazione del piano di lavoro viene annullata, ma una rotazione attivata dopo di essa è ancora attiva.
       *[shift] Qui lo spostamento origine viene annullato, ma il piano di lavoro ruotato dopo di esso è ancora ruotato.
    }
diag-retract-missing =
    { $what ->
        [change] L’utensile si trova ancora a { $value }, nel pezzo grezzo, accanto o appena sopra, quando viene cambiato: non è stato disimpegnato.
        [tilt] L’utensile si trova ancora a { $value }, nel pezzo grezzo, accanto o appena sopra, quando il piano viene ruotato con MOVE: non è stato disimpegnato.
        [end] L’utensile si trova ancora a { $value }, nel pezzo grezzo, accanto o appena sopra, quando il programma termina: non è stato disimpegnato.
        [others] Qui gli assi ruotano dopo uno svincolo solo a { $value }; prima di tutte le altre rotazioni l’utensile si allontana di più.
        [unretracted] Qui gli assi ruotano benché l’utensile non si sia allontanato dopo la lavorazione; prima di tutte le altre rotazioni lo fa.
        [rapid] L’utensile si trova ancora a { $value }, nel pezzo grezzo, accanto o appena sopra, quando prosegue in rapido, a differenza di quanto fa dopo le altre passate della superficie: non è stato disimpegnato.
       *[turn] L’utensile si trova ancora a { $value }, nel pezzo grezzo, accanto o appena sopra, quando un asse rotativo si muove in rapido: non è stato disimpegnato.
    }
diag-rotary-axis-jumps = Qui l’asse rotativo oscilla da { $other } a { $value } e nel blocco successivo torna indietro.
diag-row-not-in-table =
    { $table ->
        [preset] La tabella Preset non contiene la riga { $row }.
       *[datum] La tabella origini non contiene la riga { $row }.
    }
diag-program-not-selected = Qui si chiama un programma selezionato, ma nessuno è stato selezionato.
diag-shift-in-tilted-plane = L’origine viene spostata nel piano ruotato su { $parameter }, che è stato misurato nel piano non ruotato.
diag-speed-missing = Il mandrino viene avviato qui, ma per questo utensile non è programmato alcun numero di giri.
diag-speed-out-of-range =
    { $what ->
        [feed] L’avanzamento { $value }
       *[speed] Il numero di giri del mandrino { $value }
    } difficilmente è voluto: { $side ->
        [below] è negativo
       *[above] i manuali ammettono al massimo { $limit }
    }.
diag-stepover-too-wide = Le passate distano { $value } e l’utensile è largo solo { $other }: tra di esse restano nervature.
diag-spindle-direction = { $cycle } richiede un mandrino che giri in senso orario, ma qui gira in senso antiorario.
diag-spindle-off = Qui l’utensile taglia a mandrino fermo.
diag-sql-handle-missing =
    { $what ->
        [ended] COMMIT o ROLLBACK ha già concluso la transazione con HANDLE { $handle }.
       *[missing] Nessuna interrogazione ha fornito HANDLE { $handle }.
    }
diag-subprogram-end-without-label = Questo LBL 0 non termina alcun sottoprogramma.
diag-subprogram-recursive = Il sottoprogramma { $label } chiama qui sé stesso.
diag-subprogram-runs-on = Il sottoprogramma { $label } prosegue nel sottoprogramma { $next }: tra i due non c’è LBL 0.
diag-subprogram-without-end = Il sottoprogramma { $label } prosegue fino alla fine del programma senza LBL 0.
diag-tcpm-left-on =
    { $what ->
        [tool] Qui si chiama un utensile con M128 o FUNCTION TCPM attivo.
       *[end] Il programma termina qui con M128 o FUNCTION TCPM attivo.
    }
diag-text-for-number =
    { $what ->
        [text] { $parameter } accetta un numero, ma questo è un testo.
        [number] { $parameter } accetta un testo, ma questo è un numero.
       *[calculation] Nei calcoli non si possono usare testi.
    }
diag-text-wrong =
    { $what ->
        [empty] Il testo di { $parameter } è vuoto.
        [alone] «{ $found }» nel testo di { $parameter } non è doppio né precede una lettera.
       *[character] Il carattere «{ $found }» non è ammesso in { $parameter }.
    }
diag-thread-pitch-unusual = Un passo di { $value } non è normalizzato per una filettatura del diametro di { $other }.
diag-tool-axis-missing = Questa chiamata utensile non ha l’asse utensile, e nessuna chiamata precedente lo ha indicato.
diag-tool-axis-other =
    { $what ->
        [pattern] PATTERN DEF lavora solo con l’asse utensile { $axis }, ma qui ne è attivo un altro.
        [lifted] Questa chiamata utensile indica un asse utensile diverso da quello del grezzo, ma l’utensile viene disimpegnato solo lungo { $axis }.
       *[blank] Il grezzo ha l’asse utensile { $axis }, ma nessun utensile del programma lo ha.
    }
diag-tool-cuts-sideways = Qui una punta, un maschio o un alesatore si muove lateralmente nel materiale.
diag-tool-definition-wrong =
    { $what ->
        [zero] L’utensile 0 significa nessun utensile e non si può definire.
        [twice] L’utensile { $tool } è già stato definito con altre dimensioni.
       *[after-call] L’utensile { $tool } viene definito qui, ma è già stato chiamato.
    }
diag-tool-feed-missing = Qui si usa l’avanzamento della chiamata utensile, ma la chiamata non ne ha.
diag-tool-missing = Qui un ciclo esegue movimenti, ma nessuna chiamata utensile ha indicato l’asse utensile.
diag-tool-not-changed = { $cycle } viene chiamato con l’utensile già usato per { $before }: richiede un altro utensile.
diag-tool-not-listed = La tabella utensili non contiene l’utensile { $tool }.
diag-tool-radius-outdated = Questo viene calcolato con il raggio dell’utensile precedente (Q108) e letto solo dopo la chiamata di un altro utensile.
diag-turning-start-wrong =
    { $what ->
        [positive] Il ciclo di tornitura non inizia dove si trova l’utensile: il profilo va verso Z positivo, lontano dal pezzo.
        [z] Il ciclo di tornitura non inizia dove si trova l’utensile: in Z l’utensile è oltre la fine del profilo.
        [bar] Qui un utensile per interni tornisce all’esterno: il ciclo ricava il lato dalla posizione dell’utensile.
        [outer] Qui un utensile per esterni tornisce all’interno: il ciclo ricava il lato dalla posizione dell’utensile.
        [inwards] Questo utensile prima ha tornito all’esterno e qui tornisce all’interno: il ciclo ricava il lato dalla posizione dell’utensile.
        [outwards] Questo utensile prima ha tornito all’interno e qui tornisce all’esterno: il ciclo ricava il lato dalla posizione dell’utensile.
        [start] La tornitura interna inizia al diametro { $value }, e il foro è largo solo { $other }: l’utensile entra nel pieno.
        [thick] Il bareno è largo { $value }, e il foro solo { $other }.
       *[diameter] Il ciclo di tornitura non inizia dove si trova l’utensile: l’utensile è oltre il diametro finale del profilo.
    }
diag-uncalculable-contour =
    Qui il controllo non può calcolare il profilo: { $what ->
        [open] mancano dati che determinano questo elemento
        [contradicts] i dati di questo elemento si contraddicono
        [several] più elementi corrispondono ai dati e nessuno è selezionato
        [rounding] il raccordo o lo smusso non trova posto tra i suoi elementi
        [crossing] il profilo interseca sé stesso
       *[approach] non è possibile avvicinarsi così al profilo
    }.
diag-value-unlike-others =
    { $what ->
        [feed] Qui l’avanzamento è { $value }, nella chiamata utensile { $other }.
        [sign] La quota è qui { $value }, tra altre più basse sullo stesso percorso; { $other } sarebbe coerente.
        [depth] La profondità è qui { $value }; negli altri cicli del programma le profondità sono negative.
        [path] La coordinata è qui { $value }, lontana dai punti vicini sullo stesso percorso; { $other } sarebbe coerente.
        [angle] Qui l’angolo è { $value }; { $other } sarebbe coerente con i passi degli altri angoli.
       *[others] Qui il valore è { $value }, in tutti gli altri punti simili { $other }.
    }
diag-wall-left = Il profilo aperto lascia una parete larga { $value } mm sul bordo del pezzo grezzo: RL e RR potrebbero essere scambiati.
diag-wrong-tool-type =
    { $what ->
        [probe] { $cycle } tasta qui con l’utensile che ha appena lavorato.
        [measured] { $cycle } misura qui l’utensile che ha appena tastato.
        [contour] L’utensile che ha appena tastato si muove qui lungo un profilo.
        [named] { $cycle } misura qui un tastatore, se il nome dell’utensile è giusto.
        [calibrates] { $cycle } calibra qui il tastatore per utensili con un utensile che taglia.
       *[mill] { $cycle } lavora qui con l’utensile che ha appena tastato.
    }
diag-tool-unused = L’utensile { $tool } viene chiamato qui, e il blocco successivo ne chiama un altro.
diag-tool-zero = { $cycle } viene eseguito con l’utensile 0: nel mandrino non c’è alcun utensile.
diag-transfer-parameter-overwritten =
    { $what ->
        [passed] { $cycle } ha letto { $parameter } alla definizione: il valore scritto qui non influisce sulla sua chiamata.
        [filled] { $cycle } riempie quattro parametri a partire da quello indicato qui, e sovrascrive { $parameter }, che il programma ha scritto prima e legge più avanti.
        [lost] { $cycle } sovrascrive { $parameter } prima che il programma legga il valore scritto qui.
        [result] { $parameter } viene copiato due volte dopo una sola misurazione: il risultato della misurazione precedente è stato sovrascritto senza essere letto.
       *[call] { $parameter } appartiene a { $cycle }, che viene chiamato più avanti: la chiamata usa il valore scritto qui.
    }
diag-transformation-forbidden =
    { $cycle } viene usato qui benché { $what ->
        [datum-shift] sia attivo uno spostamento origine
        [rotation] sia attiva una rotazione
        [tcpm] sia attiva M128 o FUNCTION TCPM
        [other-axis] l’asse utensile non sia Z
        [turning] il controllo sia nel modo tornitura (FUNCTION MODE TURN)
       *[tilting] il piano di lavoro sia ruotato
    }: il manuale lo vieta.
diag-transformation-without-effect =
    { $what ->
        [again] { $cycle } definisce la conversione che è già attiva, e lo stesso sottoprogramma viene chiamato di nuovo.
       *[ended] { $other } annulla la conversione di { $cycle } prima che qualcosa la utilizzi.
    }
diag-transformation-left-on =
    Il programma termina qui con { $what ->
        [datum-shift] uno spostamento origine attivo
        [rotation] una rotazione attiva
        [mirroring] una lavorazione speculare attiva
       *[scaling] un fattore di scala attivo
    }.
diag-feed-unit =
    { $what ->
        [revolution] { $parameter }={ $value } è qui un avanzamento al giro, perché M136 è attivo.
        [revolving] { $parameter }{ $value } è qui un avanzamento al giro, perché M136 è attivo.
        [large] { $parameter }={ $value } è qui un avanzamento al giro, troppo grande per la tornitura.
        [moving] { $parameter }{ $value } è qui un avanzamento al minuto, perché M136 non è attivo.
       *[minute] { $parameter }={ $value } è qui un avanzamento al minuto, perché M136 non è attivo.
    }
diag-turning-system-missing = Qui viene chiamato { $cycle }, ma { $aligning } non è stato definito dopo la chiamata utensile.
diag-cutting-speed-unlimited = La velocità di taglio è costante e il numero di giri non è limitato, ma alla riga { $line } l’utensile arriva all’asse di rotazione.
diag-two-signs = Davanti al numero ci sono due segni; vengono letti come { $right }.
diag-unknown-cycle =
    { $name ->
        [none] Nessun manuale noto a Ciklo cita { $cycle }.
       *[other] { $cycle } ({ $name }) è un ciclo dei primi controlli: viene ancora eseguito, ma i suoi valori non vengono verificati.
    }
diag-unknown-parameter = Su questo controllo { $cycle } non ha il parametro { $parameter }.
diag-differs-from-other-control =
    { $what ->
        [missing] { $cycle } ha sul { $control } il parametro { $parameter }, ma qui manca.
        [value] Il { $control } non accetta { $parameter }={ $value } in { $cycle }.
        [twice] { $parameter } compare due volte in { $cycle }.
        [foreign] { $cycle } sul { $control } non ha il parametro { $parameter }.
        [order] { $parameter } segue { $before }, ma in { $cycle } sul { $control } lo precede.
        [label] «{ $label }» in { $cycle } sul { $control } appartiene a { $other }, non a { $parameter }.
        [doubt] { $cycle } è dubbio: { $message }
        [alone] Nessun ciclo con questo parametro accetta { $parameter }={ $value }, come in { $cycle }.
       *[guard] Il { $control } rifiuterebbe { $cycle }: { $message }
    }
diag-unreachable =
    { $part ->
        [label] Nulla conduce a questo label.
       *[block] Questo blocco non viene mai eseguito.
    }
diag-meaningless-value = Il valore { $value } qui non è possibile.
diag-word-missing = In questo blocco manca { $word }.
diag-word-twice = { $word } compare due volte in questo blocco.
diag-word-wrong =
    { $what ->
        [below] { $word } vale { $value }: è troppo piccolo.
        [above] { $word } vale { $value }: è troppo grande.
        [whole] { $word } vale { $value }, ma deve essere un numero intero.
        [offers] Dopo { $word } deve trovarsi una di queste parole: { $value }.
        [contradict] { $word } e { $value } si escludono a vicenda.
        [zero] { $word } non possono essere tutti 0.
        [not-below] { $word } deve essere inferiore a { $value }.
        [operator] Qui si trova «{ $word }» al posto di { $value }.
        [empty] Il nome è vuoto.
        [value] Dopo { $word } manca il valore.
        [place] { $word } non è ammesso in questo blocco.
        [line] I tre punti si trovano su una retta e non determinano un piano.
        [parallel] I due vettori sono paralleli e non determinano un piano.
        [number] Il testo di { $word } non è un numero: «{ $value }».
        [beyond] { $word } vale { $value }, oltre la fine del testo.
        [file] { $value } non è un file { $word }.
        [shorter] { $word } vale { $value }: il controllo considera l’utensile più corto di tanto, e tutto diventa più profondo della stessa misura.
        [askew] Il vettore base e il vettore normale devono essere perpendicolari tra loro.
       *[tool] { $value } non è un numero di utensile: dopo il punto è ammessa una sola cifra.
    }
diag-wrong-value-kind =
    Il parametro { $parameter } di { $cycle } accetta { $kind ->
        [integer] un numero intero
        [number-or-name] un numero o un nome tra virgolette
        [text] un testo tra virgolette
        [q-number] un parametro Q
        [axis-direction] un asse con segno, ad esempio X-
        [position] coordinate per asse, ad esempio X+5 Y+0
        [row] una riga della tabella, ad esempio #5
        [axis] un asse
        [label-list] numeri di label separati da barre, ad esempio 1/2/3
       *[number] un numero
    }{ $words-count ->
        [0] {""}
       *[other] {" "}oppure { $words }
    }.
diag-coolant-forgotten = Questo utensile lavora senza refrigerante; tutti gli altri utensili del programma lo inseriscono.
diag-comment-contradicts =
    { $what ->
        [digits] Qui il valore è { $value }, nel commento { $other }: due cifre sono scambiate.
        [result] Il risultato è { $value }, non { $other } come dice il commento.
        [scale] Il fattore di scala { $value } non corrisponde al { $other } percento del commento.
        [parameter] Qui viene letto { $value }, mentre il commento sopra indica { $other }.
       *[holes] Dopo questa chiamata utensile i fori sono { $value }, nel commento { $other }.
    }
diag-decimal-comma = Questo valore ha la virgola decimale, altri valori del programma il punto decimale.
diag-definitions-differ =
    { $what ->
        [deep] L’accostamento { $value } asporta in una volta tutta la profondità { $other }, maggiore del diametro dell’utensile.
        [infeed] L’accostamento è qui { $value }, nell’altra definizione della stessa tasca o scanalatura { $other }.
        [operation] Entrambe le definizioni di questa tasca o scanalatura sgrossano soltanto: rimane il sovrametallo di { $other }.
        [turned] Il valore è qui { $value }, nella definizione che sgrossa lo stesso profilo di tornitura { $other }.
       *[size] Il valore è qui { $value }, nella definizione che sgrossa la stessa tasca o scanalatura { $other }.
    }
diag-helix-too-steep =
    { $what ->
        [up] L’elica sale di { $value }, benché segua un cerchio completo come sul fondo: il suo segno è sbagliato.
        [pitch] L’elica ha un passo di { $value }, mentre la fresa per filettare ha { $other }.
        [left] Questa elica taglia una filettatura sinistra; né l’utensile né un commento lo indicano.
       *[steep] L’elica scende di { $value } in un giro; più di { $other } qui nessun utensile taglia.
    }
diag-holes-differ =
    { $what ->
        [stray] Il foro in { $value }; { $other } non è stato centrato, e un punto centrato è senza foro.
        [untapped] Il preforo in { $value }; { $other } non viene filettato, altri della stessa serie sì.
        [unreamed] Il foro in { $value }; { $other } non viene alesato, altri della stessa serie sì.
        [uncentred] Il foro in { $value }; { $other } non è stato centrato, tutti gli altri della stessa serie sì.
        [unused] Il punto { $value }; { $other } è stato centrato e resta senza foro, a differenza di tutti gli altri della stessa serie.
        [gap] Nel cerchio di fori manca quello in { $value }; { $other }.
        [corner] Questo foro non è nel vertice { $value }; { $other } del rettangolo formato dagli altri tre.
        [passed] L’utensile si ferma in { $value }; { $other } e non vi fa nulla; i blocchi prima e dopo chiamano il ciclo.
        [rotation] Qui l’utensile lavora in { $value } di { $other } angoli uguali di un giro completo: ne manca uno.
       *[arc] Il centro manca il foro in { $value }; { $other }; gli altri archi sono intorno a fori.
    }
diag-probing-place-wrong =
    { $what ->
        [angle] Un foro viene misurato a { $value } gradi, ma la sagoma lì non ne esegue nessuno.
        [apart] Il secondo foro dista solo { $value } dal primo, il cui diametro è { $other }.
        [side] Qui viene tastato un lato di { $value }, mentre il grezzo lì è largo { $other }: il tastatore scende su di esso.
        [centre] In questo centro non è stato lavorato nulla, in { $value }; { $other } invece sì.
        [corner] Lo spigolo viene tastato sul lato del pezzo grezzo opposto all’origine { $value }.
        [size] Qui si tasta una misura di { $value }, ma il pezzo grezzo è largo solo { $other }.
        [axis] Si misura l’asse in cui il punto è a { $value }, ma la quota massima è { $other }: i limiti sono quelli di un altro asse.
        [later] Qui si tasta un diametro di { $value }, e più avanti nello stesso centro uno di { $other }: il tastatore scende accanto al foro.
        [removed] La superficie a { $value } che qui si tasta è già stata asportata fino a { $other }.
        [across] In questo asse si tasta una larghezza di { $value }, ma ciò che qui è stato fresato è largo { $other } lungo l’asse: è disposto nell’altro verso.
       *[outside] Il punto { $value }; { $other } è fuori dal pezzo grezzo: lì non c’è nulla da tastare.
    }
diag-rough-out-tool-other =
    { $what ->
        [pilot] Qui è indicato l’utensile { $value }, ma svuota l’utensile { $other }.
       *[coarse] L’utensile { $value } non ha svuotato prima; lo ha fatto l’utensile { $other }.
    }
diag-speed-and-feed-exchanged = L’utensile è chiamato con { $value } giri e un avanzamento di { $other }: i due valori sembrano scambiati.
diag-stud-in-solid = La misura grezza { $value } è molto minore del pezzo grezzo intorno all’isola, largo qui { $other }.
diag-surface-wrong =
    { $what ->
        [unlike] La superficie è a { $value }, quella degli altri cicli in queste posizioni a { $other }, e prima niente è stato lavorato a tale profondità.
        [opposite] La superficie a { $value } è sopra il pezzo grezzo; altre lavorazioni iniziano o finiscono a { $other }.
        [pattern] La superficie della sagoma è a { $value }, quella del ciclo che essa chiama a { $other }: vale quella della sagoma.
        [air] Qui il ciclo lavora a vuoto: scende a { $value }, dove tutto è già stato asportato.
        [high] Il ciclo parte da dove viene chiamato, a { $value }: la sua superficie è quindi a { $other }, sopra il pezzo grezzo.
        [low] Il ciclo viene chiamato dentro il pezzo grezzo, a { $value }, e nulla è stato lavorato fino alla sua superficie a { $other }.
        [below] Il ciclo scende in rapido a { $value }, ma qui gli altri sono arrivati solo a { $other }: entra nel materiale.
        [cylinder] Il cilindro ha il raggio { $value }, ma il pezzo grezzo attorno al suo asse ha { $other }.
       *[faced] La superficie è a { $value }, ma la faccia è stata fresata fino a { $other }.
    }
diag-turned-thread-wrong =
    { $what ->
        [pitch] Il passo { $value } è troppo grande per una filettatura del diametro { $other }.
        [tool] La filettatura ha il passo { $value }, ma l’utensile è fatto per { $other }.
        [end] La filettatura arriva a { $value }, oltre la fine del suo cilindro a { $other }.
        [groove] La filettatura arriva a { $value }, oltre la gola che termina a { $other }.
        [inside] Al diametro { $value }, tornito all’esterno, viene eseguita una filettatura interna.
        [speed] La filettatura viene tornita a velocità di taglio costante (VCONST:ON): il numero di giri cambia da una passata all’altra.
       *[diameter] La filettatura ha il diametro { $value }, ma lì è stato tornito { $other }.
    }
diag-tilted-work =
    { $what ->
        [beside] Nel piano ruotato questo ciclo non incontra in nessun punto il pezzo grezzo.
       *[stands] Il ciclo inizia a { $value }, ma nel piano ruotato qui il pezzo grezzo arriva a { $other }.
    }
diag-circle-point-wrong =
    { $what ->
        [angle] { $parameter } viene calcolato con l’angolo { $value } e { $other } con { $angle }: le due coordinate di un punto su un cerchio hanno lo stesso angolo.
       *[function] { $parameter } e { $other } sono calcolati entrambi con { $value } dello stesso angolo: un punto su un cerchio ha in una coordinata il seno e nell’altra il coseno.
    }
diag-formula-wrong =
    { $what ->
        [square] { $parameter } è una somma o differenza di quadrati e viene usato come lunghezza: manca la radice quadrata.
       *[radius] { $parameter } viene calcolato con l’altro segno del raggio utensile Q108 rispetto alla chiamata precedente: l’utensile è dall’altra parte della stessa quota.
    }
diag-correction-wrong =
    { $what ->
        [side] { $parameter } viene corretto di { $other }, che è lo scostamento dell’altro lato.
        [actual] { $other } è la misura rilevata, non il suo scostamento: della misura { $parameter } non resta quasi nulla.
        [radius] { $parameter } è lo scostamento di un diametro o di una larghezza e corregge il raggio dell’utensile senza essere dimezzato.
        [turned] Lo scostamento { $parameter } corregge il raggio dell’utensile con il segno sbagliato: l’errore raddoppia.
       *[added] Lo scostamento { $other } viene aggiunto alla misura { $parameter }: va sottratto.
    }
diag-monitored-tool-idle =
    { $what ->
        [elsewhere] { $cycle } controlla o corregge l’utensile { $tool }, che non ha fresato ciò che viene misurato: è stato l’utensile { $other }.
       *[idle] { $cycle } controlla o corregge l’utensile { $tool }, che prima non è stato chiamato.
    }
