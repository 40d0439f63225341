# Coordinate transformations; see the English file.

# --- common ---
form-coordinates = Coordinate dell’origine
form-table = Riga di una tabella origini
note-transform-acts-until-reset = Una conversione di coordinate è attiva dalla sua definizione e non deve essere chiamata. Rimane attiva finché non viene annullata o ridefinita.
note-transform-reset-ways = Una conversione di coordinate si annulla ridefinendo il ciclo con i valori dello stato base (ad esempio fattore di scala 1,0), con le funzioni ausiliarie M2 e M30 o con il blocco END PGM (a seconda del parametro macchina { $mp-clear-mode }), oppure selezionando un altro programma.

# --- 7 ---
cycle-datum-shift = Spostamento origine
    .nc = ORIGINE
    .purpose = Consente di ripetere lavorazioni in un punto qualsiasi del pezzo. Dopo la definizione tutte le coordinate si riferiscono alla nuova origine. Lo spostamento viene indicato nel programma o prelevato da una tabella origini, ad esempio per lavorazioni ricorrenti in più posizioni o per uno spostamento richiesto di frequente.
step-shift-datum = Il controllo sposta l’origine:
say-shift-by-table-row = con un numero di riga: dei valori di questa riga della tabella origini attiva
say-shift-by-coordinates = con coordinate: in ogni asse programmato sulla coordinata indicata; i valori assoluti si riferiscono all’origine del pezzo, quelli incrementali all’ultima origine valida
note-reset-datum-shift = Per annullare lo spostamento origine, programmare con una nuova definizione del ciclo uno spostamento sulle coordinate X=0, Y=0 ecc. oppure richiamare dalla tabella origini uno spostamento sulle coordinate X=0, Y=0 ecc.
note-rotary-axes-may-be-shifted = È possibile inserire anche assi rotativi.
note-datum-shift-in-status-display = L’indicazione di stato supplementare visualizza lo spostamento origine in ogni asse.
note-datum-table-refers-to-preset = Pericolo di collisione! Le origini di una tabella origini si riferiscono sempre ed esclusivamente al Preset attuale.
note-select-datum-table-in-program = Se le origini vengono prelevate da una tabella origini, attivare nel programma la tabella desiderata con la funzione SEL TABLE, in un blocco che precede questo ciclo. La tabella rimane attiva finché non ne viene selezionata un’altra tabella origini con SEL TABLE o con PGM MGT. Per programmare SEL TABLE premere il tasto PGM CALL e il softkey della tabella origini, inserire il percorso completo della tabella o selezionare il file con un softkey e confermare con il tasto END.
note-select-datum-table-before-run = Senza SEL TABLE la tabella origini desiderata deve essere attivata con la Gestione file prima della prova o dell’esecuzione del programma (lo stesso vale per la grafica di programmazione): nel modo operativo Prova programma riceve lo stato S, in un modo operativo di esecuzione del programma lo stato M.
note-datum-table-is-absolute = I valori di coordinate delle tabelle origini hanno effetto solo come valori assoluti.
note-datum-table-rows-at-end = È possibile aggiungere nuove righe solo alla fine della tabella origini.
note-datum-table-name-begins-with-letter = Il nome del file di una nuova tabella origini deve iniziare con una lettera.
note-save-datum-table-changes = Dopo aver modificato un valore in una tabella origini, salvare la modifica con il tasto ENT. In caso contrario la modifica non viene considerata durante l’esecuzione del programma.
note-edit-datum-table = Una tabella origini si modifica nel modo operativo Editing programma: richiamare la Gestione file con il tasto PGM MGT, visualizzare i file di tipo .D con i softkey e selezionare una tabella o inserire un nuovo nome di file. I softkey consentono di passare all’inizio, alla fine, alla pagina precedente o successiva, all’inizio o alla fine di una riga, di inserire una riga o più righe alla fine, di cancellare una riga, di cercare, nonché di copiare e inserire un valore. Per uscire dalla tabella, visualizzare nella Gestione file un altro tipo di file e selezionare il file desiderato.
note-datum-table-columns = Se per un asse attivo non si desidera alcuna origine, cancellare la relativa voce con il tasto DEL. Le proprietà delle colonne possono essere modificate dopo aver inserito il numero codice 555343 nel menu MOD; il softkey EDITING FORMATO visualizza quindi le colonne con le relative proprietà. Le modifiche valgono solo per la tabella aperta.
note-datum-row-in-status-display = L’indicazione di stato supplementare visualizza nome e percorso della tabella origini attiva, il numero dell’origine attiva e il relativo commento della colonna DOC.

# --- 10 ---
cycle-rotation = Rotazione
    .nc = ROTAZIONE
    .purpose = Ruota, all’interno di un programma, il sistema di coordinate nel piano di lavoro intorno all’origine attiva.
step-rotate-coordinate-system = Il controllo ruota il sistema di coordinate dell’angolo programmato intorno all’origine attiva. Un valore incrementale viene sommato all’angolo attivo.
step-cancel-radius-compensation = Il controllo annulla una correzione del raggio attiva.
step-move-both-axes = Spostare entrambi gli assi del piano di lavoro per attivare la rotazione.
note-reset-rotation = Per annullare la rotazione, programmare di nuovo il ciclo con l’angolo 0°.
note-reference-axis-of-rotation = Asse di riferimento dell’angolo: asse X nel piano X/Y, asse Y nel piano Y/Z, asse Z nel piano Z/X.
note-acts-in-manual-data-input = Il ciclo ha effetto anche nel modo operativo Introduzione manuale dati.
note-rotation-in-status-display = L’indicazione di stato supplementare visualizza l’angolo di rotazione attivo.
note-program-radius-compensation-again = La definizione del ciclo annulla una correzione del raggio attiva. Se necessario, programmarla di nuovo.

# --- 247 ---
cycle-activate-preset = Impostazione zero pezzo
    .nc = DEF. ZERO PEZZO
    .purpose = Attiva come nuova origine un Preset della tabella Preset.
step-activate-preset = Il controllo attiva come origine il Preset { $q-preset-number } della tabella Preset.
step-cancel-transforms-of-preset = Annulla spostamento origine, lavorazione speculare, rotazione, fattore di scala e fattore di scala specifico per asse.
note-coordinates-refer-to-new-preset = Dopo la definizione tutte le coordinate e gli spostamenti origine (assoluti e incrementali) si riferiscono al nuovo Preset.
note-preset-cancels-transforms = Quando viene attivata un’origine della tabella Preset, il controllo annulla spostamento origine, lavorazione speculare, rotazione, fattore di scala e fattore di scala specifico per asse.
note-preset-zero = Il numero di Preset 0 (riga 0) attiva l’ultima origine impostata manualmente nel modo operativo Funzionamento manuale.
note-preset-not-in-test-run = Il ciclo non ha effetto nel modo operativo Prova programma.
note-preset-in-status-display = L’indicazione di stato visualizza il numero del Preset attivo accanto al simbolo dell’origine; l’indicazione di stato supplementare (visualizzazione di posizione) lo visualizza accanto all’origine.
