# Segnalazioni su scene, macchine, tabelle e solidi.

diag-scene-expected =
    { $expected ->
        [mapping] Qui sono previste chiavi con valori, non «{ $found }».
        [list] Qui è previsto un elenco, non «{ $found }».
        [number] Qui è previsto un numero, non «{ $found }».
        [text] Qui è previsto un testo, non «{ $found }».
        [axis] Qui è prevista la lettera di un asse (X, Y o Z), non «{ $found }».
        [two-numbers] Qui sono previsti due numeri, non «{ $found }».
        [three-numbers] Qui sono previsti tre numeri, non «{ $found }».
        [row-number] Qui è previsto il numero di una riga della tabella, non «{ $found }».
        [unit] L’unità di misura deve essere mm o inch, non «{ $found }».
        [clock] Qui sono previste data e ora, ad esempio 2015-07-03T14:05:00, non «{ $found }».
        [datum-file] Il nome di una tabella origini deve terminare con .D.
        [table-file] Il nome di una tabella liberamente definibile deve terminare con .TAB.
        [rotary-axis] Qui è prevista la lettera di un asse rotativo (A, B o C), non «{ $found }».
        [parallel-axis] Qui è prevista la lettera di un asse parallelo (U, V o W), non «{ $found }».
        [carried] Un asse rotativo porta il pezzo (workpiece) o l’utensile (tool), non «{ $found }».
        [encoder] L’encoder di un asse è sul motore (motor) o sull’asse (axis), non «{ $found }».
        [orientation] L’orientamento deve essere fixed, two o any, non «{ $found }».
        [shaft] Il gambo dello stilo deve essere più sottile della sfera; il suo diametro è { $found }.
        [measurements] Sono possibili 1, 2 o 3 misurazioni, non «{ $found }».
       *[solids] Qui è previsto almeno un solido.
    }
diag-scene-unknown-key = La chiave { $key } non è possibile in questo punto; chiavi possibili: { $known }.
diag-scene-missing-key = Manca la chiave { $key }.
diag-scene-not-positive = Il valore deve essere maggiore di zero, non { $found }.
diag-scene-version = Questa versione del formato del file non è supportata; versione supportata: { $known }.
diag-scene-repeated = { $found } è definito due volte.
diag-scene-min-max = Ogni valore minimo deve essere inferiore al rispettivo massimo.
diag-scene-no-length = La lunghezza è nulla.
diag-scene-one-solid = Qui è previsto esattamente un solido: { $known }.
diag-scene-unknown-machine = Non esiste alcuna macchina di nome { $name }; le macchine sono { $known }.
diag-scene-no-axis = La macchina non ha un asse { $axis }.
diag-scene-start-outside = La posizione di partenza è fuori dal campo di traslazione dell’asse { $axis }: { $found } { $unit } non è compreso tra { $min } e { $max } { $unit }.
diag-scene-stl = { $file }: { $kind ->
        [nowhere] Una scena contenuta in un altro file non può indicare file STL.
        [large] I file STL di una scena possono occupare in tutto { $most } MB.
        [number] Nel triangolo { $triangle } una coordinata non è un numero o è maggiore di 1000000.
        [length] Il file non ha la lunghezza richiesta dal numero di triangoli indicato ({ $triangle }).
       *[empty] Nessun triangolo ha un’area.
    }
diag-scene-stl-word = Qui è previsto { $wanted ->
        [number] un numero fino a 1000000
       *[word] { $wanted }
    }, invece di «{ $found }».

diag-solid-not-finite = Una quota non è un numero finito e positivo.
diag-solid-too-many = La forma ha troppe superfici: la ricerca degli spigoli richiederebbe troppo tempo. Omettere ciò a cui non si avvicina nessun utensile né tastatore.
diag-solid-edge-unsupported = La sfera del tastatore può toccare uno spigolo che non è né una retta né un cerchio; questo contatto non può essere calcolato con esattezza.
diag-solid-cusp = La sfera del tastatore può toccare un punto in cui le superfici sono tangenti e non lasciano spessore; questo contatto non può essere calcolato con esattezza.
diag-solid-mesh-cut = Una superficie a triangoli non può far parte di una differenza.
diag-solid-helix-unsupported = La sfera del tastatore può toccare il pezzo durante un movimento elicoidale o mentre si muovono più assi; questo contatto non può essere calcolato con esattezza.

diag-table-no-header = La tabella deve iniziare con una riga contenente "BEGIN", il nome di un file { $extension } e l’unità di misura.
diag-table-no-heading = La seconda riga deve contenere i nomi delle colonne, tra cui { $column }.
diag-table-no-end = Manca la riga [END].
diag-table-not-described = I manuali non descrivono tabelle di questo tipo: si verificano solo l’inizio e la fine.
diag-table-no-row-number = La riga non ha numero: «{ $found }».
diag-table-duplicate-row = La riga { $row } è presente due volte.
diag-table-bad-number = { $file }, riga { $row }, colonna { $column }: «{ $found }» non è un numero.
diag-table-missing = La tabella { $file } non esiste.
diag-table-no-row = La tabella { $file } non contiene la riga { $row }.
diag-table-no-column = La tabella { $file } non contiene la colonna { $column }.
diag-table-too-wide = { $file }, riga { $row }: il valore è troppo lungo per la colonna { $column }.
diag-table-text-in-numbers = { $file }, riga { $row }: la colonna { $column } accetta solo numeri.
diag-table-key-column = { $file }, riga { $row }: il numero di riga nella colonna { $column } non può essere modificato.
diag-table-duplicate-column = La colonna { $column } compare due volte.
diag-table-unknown-column =
    { $count ->
        [one] I manuali non descrivono la colonna { $column }: le sue celle non vengono verificate.
       *[other] I manuali non descrivono le colonne { $column }: le loro celle non vengono verificate.
    }
diag-table-doubtful =
    { $what ->
        [unit] La prima riga non contiene né MM né INCH.
        [kind] La prima riga nomina un file { $found }, mentre questo è un file { $column }.
        [column] Manca la colonna { $column }.
        [order] La riga { $row } segue la riga { $found }.
        [after-end] Le righe dopo [END] non vengono lette.
        [astride] Riga { $row }: il numero della colonna { $column } prosegue nella colonna { $found }.
        [empty] Riga { $row }: la colonna { $column } è vuota.
        [corner] Riga { $row }: R2 è maggiore di R.
        [same] La riga { $row } contiene lo stesso punto della riga { $found }.
        [zero] L’utensile 0 significa che non è chiamato alcun utensile; il suo { $column } dovrebbe essere 0.
        [less] Nella riga { $row }, { $column } è inferiore a { $found }.
       *[value] Riga { $row }: «{ $found }» nella colonna { $column } è probabilmente un errore.
    }
diag-table-value-not-allowed = Riga { $row }: la colonna { $column } non accetta «{ $found }».
diag-stock-blank = BLK FORM richiede numeri che diano un’estensione al pezzo grezzo: ogni minimo deve essere inferiore al suo massimo, un cilindro maggiore del suo foro.
diag-stock-extent = Il pezzo grezzo è troppo grande: si estende oltre { $limit } mm dalla sua origine.
diag-stock-form = Da BLK FORM { $word } qui non risulta quale sia il pezzo grezzo: definirlo nella scena, come parallelepipedo con BLK FORM 0.1 e 0.2 oppure con BLK FORM CYLINDER.
diag-stock-missing = Manca il pezzo grezzo: la scena non ha stock e il programma non ha BLK FORM.
diag-stock-resolution = { $found } non può essere la distanza tra le colonne del pezzo grezzo: deve essere maggiore di zero e le colonne possono essere al massimo 10 milioni.
diag-stock-resolution-mesh = Il pezzo ha più triangoli di quanti ne può contenere un file STL; scegliere una distanza maggiore tra le colonne.
