# Findings of the checker on tools, the spindle, presets and what the machine and the blank allow.
diag-approach-wrong =
    { $what ->
        [arc] L’arco di raggio { $value } non trova posto tra questo punto e il profilo.
        [left] L’utensile lascia il profilo lungo il suo asse, senza DEP.
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
        [across] Il lato di { $value } sta di traverso sulla superficie fresata in questo piano, larga solo { $other }: ruotato di 90 gradi vi starebbe.
        [above] Il ciclo non scende sotto { $value }, cioè resta sopra il pezzo grezzo: non asporta nulla.
        [below] L’utensile taglia all’altezza { $value }, molto al di sotto del pezzo grezzo.
        [over] Ciò che viene lavorato in { $value }; { $other } oltrepassa il bordo del pezzo grezzo.
        [contour] Il profilo viene chiamato a { $value }, sopra il pezzo grezzo, e altrove dentro di esso: qui non asporta nulla.
        [curve] La curva inizia e termina nel pezzo grezzo, ma lungo il percorso ne esce in { $value }; { $other }.
        [corner] Qui la posizione della tasca conta da uno spigolo, quindi da { $value }; { $other }, il centro del pezzo grezzo, oltrepassa il bordo.
       *[outside] Ciò che viene lavorato in { $value }; { $other } è lontano dal pezzo grezzo.
    }
diag-milling-deeper-than-edges = Qui l’utensile fresa a una profondità di { $value }, maggiore della lunghezza dei suoi taglienti (LCUTS).
diag-plane-left-on =
    { $what ->
        [axes] Il piano è annullato, ma gli assi rotativi non sono tornati a zero: l’utensile taglia il pezzo ruotato.
       *[tool] Il piano di lavoro è ancora ruotato quando viene chiamato questo utensile.
    }
diag-preset-row-wrong =
    { $what ->
        [again] Il Preset { $row } viene scritto di nuovo qui, in un altro punto, e nel frattempo nulla lo ha attivato.
        [other] Qui viene attivato il Preset { $other }, ma quello rilevato è il Preset { $row }, che non viene mai attivato.
        [datum] La riga { $row } della tabella origini viene scritta qui e mai attivata: la lavorazione prosegue con un’altra origine.
        [same] Il Preset { $row } è già attivo; qui viene attivato di nuovo, dopo che il programma si è fermato per l’operatore.
        [table] Qui viene scritta la riga { $row } della tabella origini, ma poi viene attivato il Preset { $row }, che nulla ha scritto.
       *[unused] Il Preset { $row } viene scritto qui e mai attivato: la lavorazione prosegue con un altro Preset.
    }
diag-repeat-without-effect =
    { $what ->
        [same] Il profilo viene ripetuto alla stessa profondità { $value }: con passi incrementali di tale misura attraverserebbe il grezzo.
        [place] Il movimento ripetuto porta a un punto in coordinate assolute in cui l’utensile si trova già: le ripetizioni non fanno nulla.
        [jump] Questo salto porta al blocco che lo segue comunque: manca ciò che doveva saltare.
       *[zero] Una ripetizione di zero volte non ha alcun effetto.
    }
diag-slot-too-narrow = L’utensile di diametro { $tool } qui non passa tra le pareti: questa retta è lunga solo { $value }.
diag-spindle-start-wrong =
    { $what ->
        [missing] Il mandrino non è stato avviato dopo la chiamata di questo utensile.
       *[direction] Il mandrino ruota in senso antiorario (M4) mentre questo utensile lavora.
    }
diag-tap-without-hole =
    { $what ->
        [missing] In { $value }; { $other } non è stato eseguito alcun foro per questo maschio.
        [floor] La filettatura scende fino a { $value }, ma il fondo accanto è a { $other }: la fresa per filettare entra nel materiale pieno.
       *[shallow] Il maschio scende fino a { $value }, ma il foro termina a { $other }.
    }
diag-tcpm-missing = Qui gli assi rotativi si muovono insieme agli assi lineari senza TCPM, benché il programma disattivi TCPM in seguito.
diag-tool-called-twice = L’utensile { $tool } viene chiamato di nuovo qui, senza nulla tra le due chiamate.
diag-tool-table-contradicts =
    { $what ->
        [speed] Il numero di giri { $value } supera { $other }, il numero di giri massimo dell’utensile { $tool } nella tabella utensili (NMAX).
        [locked] L’utensile { $tool } è bloccato nella tabella utensili (TL) e non è indicato alcun utensile gemello (RT).
        [point] { $value } centrina qui fino a un diametro, ma per l’utensile { $tool } la tabella utensili non indica l’angolo del tagliente (T-ANGLE).
        [turning] { $value } non è adatto all’utensile { $tool }, che nella tabella degli utensili per tornire è di tipo { $other } (TYPE).
        [size] L’utensile { $tool } ha nella tabella utensili il diametro { $other }, ma il nome dice { $value }.
        [oversize] Il sovrametallo { $value } (DR) non lascia nulla del raggio { $other } dell’utensile { $tool }.
        [left] Il passo { $value } è quello di una filettatura sinistrorsa, e nulla dice che l’utensile { $tool } sia un maschio sinistrorso.
        [length] Per l’utensile { $tool } la tabella utensili non indica la lunghezza (L), per gli altri sì.
        [teeth] { $value } misura ogni tagliente, ma per l’utensile { $tool } la tabella utensili non indica il numero dei taglienti (CUT).
        [large] Il sovrametallo { $value } (DR) è maggiore del raggio { $other } dell’utensile { $tool }.
        [called] { $value } non è adatto all’utensile { $tool }, che si chiama { $other }.
       *[type] { $value } non è adatto all’utensile { $tool }, che nella tabella utensili è di tipo { $other } (TYP).
    }
diag-translate-encoding = Il file viene scritto in { $encoding }: questa codifica conserva gli stessi byte e contiene tutte le lettere delle nuove etichette.
diag-translate-encoding-unknown = Non esiste la codifica «{ $encoding }»; esistono { $known }.
diag-translate-encoding-wrong = { $path } non è in { $encoding }: alcuni byte non vi hanno significato.
diag-translate-unread = { $cycle } ha una riga che non può essere letta, perciò il nome e le etichette restano come sono.
related-preset-written-here = scritto qui
diag-character-unknown = Il testo contiene «{ $character }», che il carattere di incisione non possiede.
diag-allowance-left =
    { $what ->
        [order] Qui il profilo viene lavorato con il sovrametallo { $value } (DR) e in seguito, con lo stesso utensile, con quello maggiore { $other }: per la seconda passata non rimane nulla.
        [below] Il profilo del label { $label } viene lavorato prima con il sovrametallo negativo { $value }: all’utensile che lo lavora in seguito non resta nulla.
        [cycle] Anche con questo utensile { $label } lavora il profilo con il sovrametallo { $value }, che rimane sul pezzo.
       *[left] Il profilo del label { $label } viene lavorato anche con questo utensile con il sovrametallo { $value }: il sovrametallo rimane sul pezzo.
    }
diag-contour-crossed =
    { $what ->
        [back] Questo profilo chiuso torna da uno spigolo direttamente a quello precedente.
        [away] L’utensile lascia questo profilo chiuso verso l’altro lato: lungo il percorso taglia ciò che ha appena finito.
        [start] Questo profilo chiuso viene raggiunto in uno spigolo interno: lì l’utensile intacca l’ultimo elemento.
        [short] Questo profilo termina sulla sua prima retta prima dell’inizio: il resto della retta non viene lavorato.
        [itself] Questo profilo torna prima della fine su una delle proprie rette: l’utensile taglia ciò che ha appena finito.
       *[side] Con questa correzione del raggio l’utensile attraversa il profilo chiuso: arriva dall’altro lato.
    }
diag-contour-depths-differ =
    { $what ->
        [chamfer] Lo smusso viene tagliato a { $value }, sotto il fondo del profilo a { $other }.
        [deep] Qui il profilo termina a { $value }, ma l’utensile precedente ha tagliato un incremento più in basso, fino a { $other }.
       *[shallow] Qui il profilo viene tagliato in una passata fino a { $value }, mentre l’utensile precedente è sceso solo a { $other }.
    }
diag-error-branch-entered =
    { $what ->
        [turned] Il salto oltre l’arresto viene eseguito quando { $parameter } segnala un difetto.
        [implied] Questo salto e quello precedente portano allo stesso label e confrontano { $parameter } nello stesso verso: uno dei due limiti non ha effetto.
        [branch] La condizione di questo salto non è adatta al suo ramo: con questo valore { $parameter } significa altro rispetto al label o al commento di quel ramo.
        [good] Questo salto a un ramo per difetti viene eseguito anche quando tutto è a posto: con questo valore { $parameter } non segnala alcun difetto.
        [unchecked] Qui il ciclo misura l’utensile da capo e non lo confronta con nulla: { $parameter }, che viene interrogato dopo, non segnala difetti.
        [greater] Il salto al messaggio di errore viene eseguito sempre: { $value } è maggiore di { $other }.
        [less] Il salto al messaggio di errore viene eseguito sempre: { $value } è minore di { $other }.
       *[entered] L’esecuzione arriva a questo ramo anche senza il salto e si arresta: né M2 né M30 terminano prima il programma.
    }
diag-finishing-before-roughing =
    { $what ->
        [pilot] { $other } indica l’utensile che fora qui; deve indicare quello che poi svuota.
       *[order] { $cycle } esegue qui la finitura del profilo, prima che { $other } lo svuoti.
    }
diag-label-unused = Nulla chiama o ripete il label { $label } di questo sottoprogramma, e nessun salto vi conduce.
diag-loop-runs-once =
    { $what ->
        [again] Dalla seconda volta in poi questa ripetizione viene eseguita una volta sola: nulla riporta indietro il suo contatore.
        [other] Il contatore di questo ciclo viene calcolato a ogni passaggio da un altro parametro: il numero con cui inizia non ha effetto.
        [inner] Anche la ripetizione interna conta con { $parameter }, per cui questa termina troppo presto o mai: questo salto non conta i propri passaggi.
       *[never] Questo salto all’indietro non viene mai eseguito: il contatore non soddisfa la condizione in nessun passaggio.
    }
diag-parameter-unused =
    { $what ->
        [late] { $parameter } riceve qui un valore che nessuna chiamata legge più: ogni chiamata ha i propri valori, e quella per questi si trova prima di essi.
       *[never] { $parameter } riceve qui un valore, e nulla lo legge.
    }
diag-probing-direction-wrong =
    { $what ->
        [up] { $cycle } tasta con { $value }, verso l’alto lungo l’asse utensile: il sistema di tastatura arriverebbe dall’interno del pezzo.
       *[edge] { $cycle } tasta il bordo in { $axis } con la direzione { $value }: il pezzo è sul lato da cui arriva il sistema di tastatura.
    }
diag-same-datum-twice =
    { $what ->
        [loop] La ripetizione conta, ma attiva la riga { $row } in ogni passaggio: ogni volta viene lavorato lo stesso punto.
        [turned] La tavola non è stata ruotata oltre per la riga { $row }: si trova all’angolo di un altro lato.
        [cycle] La riga { $row } viene attivata di nuovo prima della stessa chiamata ciclo nello stesso punto: la stessa lavorazione viene eseguita due volte.
       *[again] La riga { $row } viene attivata di nuovo prima dello stesso sottoprogramma: lo stesso pezzo viene lavorato due volte.
    }
diag-selected-table-missing = La tabella { $name } non si trova nella directory del programma.
diag-turned-contour-wrong =
    { $what ->
        [above] Il profilo termina a Z { $value }, sopra il pezzo grezzo, che termina a { $limit }.
        [narrow] La gola è larga { $value }, l’utensile { $limit }.
        [side] La gola va dal diametro { $limit } a { $value }; altrove lo stesso utensile esegue gole nell’altra direzione.
        [dip] Il profilo scende al diametro { $value }, sotto il suo primo diametro { $limit }, e il ciclo non lavora sottosquadri.
        [deep] La gola è profonda { $value }, e l’utensile taglia solo { $limit }.
        [ridge] La faccia sale al diametro { $value } e scende subito a { $limit }: resta uno spigolo senza larghezza.
        [corner] Un angolo del profilo è a Z { $value }, oltre la fine del pezzo grezzo a { $limit }, e il profilo torna indietro da lì.
        [wall] Qui l’utensile taglia la parete del pezzo da parte a parte: sull’altro lato il diametro è { $limit }.
        [air] Il ciclo tornisce solo a vuoto: arriva al diametro { $value }, e lì il pezzo ha il diametro { $limit }.
       *[rounding] Per l’arrotondamento { $value } la retta è troppo corta; è possibile al massimo { $limit }.
    }
diag-called-program-wants =
    { $name } legge { $parameter }, e nulla gli ha assegnato un valore prima di questa chiamata.
diag-branch-runs-on =
    { $what ->
        [variant] Il ramo termina qui senza un salto e l’esecuzione prosegue nell’altro: nulla porta al label { $parameter } dopo di esso.
       *[values] Il ramo termina qui senza salto: quello successivo assegna altri valori a { $parameter } prima che questi vengano letti.
    }
diag-finishing-tool-too-wide = Sovrametallo e raggio dell’utensile danno qui { $value }; la somma deve essere minore che nello svuotamento, { $other }.
