# Il comando «convert» e i suoi messaggi.
cli-convert = Riscrive programmi per un altro controllo, oppure in DIN/ISO o in Klartext
cli-convert-file = Programmi NC; più d’uno solo con --in-place
cli-convert-from = Controllo per cui sono scritti i programmi
cli-convert-to = Controllo sul quale devono essere eseguiti
cli-convert-form = Forma dei cicli che ne hanno due: new (parametri Q) oppure old (un blocco per riga); predefinita: come nel programma
cli-convert-out = File da scrivere (predefinito: uscita standard)
cli-convert-in-place = Sostituisce i vecchi programmi con quelli nuovi
cli-converted = { $count ->
        [one] { $count } definizione riscritta: { $path }
       *[other] { $count } definizioni riscritte: { $path }
    }
cli-examples-convert =
    ciklo convert part.h --from tnc426-430 --to tnc640 > new.h
    ciklo convert part.h --from tnc640 --to tnc320 --format json
    ciklo convert measuring.h --from itnc530 --to itnc530 --form new --in-place
    ciklo convert part.h --to-iso > part.i
    ciklo convert part.i --to-klartext --lang it --out pezzo.h
diag-convert-one-file = Più programmi si possono riscrivere solo con --in-place.
diag-convert-iso-stays = «{ $found }» cambierebbe, ma la nuova forma non si può scrivere in DIN/ISO; il blocco non è stato modificato.
diag-convert-iso-unread = Klartext non ha un equivalente di «{ $found }»; il blocco non è stato né verificato né modificato.
diag-convert-cycle-not-on-control = { $control } non ha { $cycle }; la definizione non è stata modificata.
diag-convert-cycle-not-described = Il manuale di { $control } menziona { $cycle } ma non lo descrive; i parametri non sono stati modificati.
diag-convert-cycle-not-covered = I manuali di { $control } noti a Ciklo non trattano cicli come { $cycle }; la definizione non è stata modificata.
diag-convert-parameter-added = { $import ->
        [yes] A { $cycle } è stato aggiunto { $parameter } = { $value }, come fa { $control } con i programmi meno recenti: impostare il valore desiderato.
       *[no] A { $cycle } è stato aggiunto { $parameter } = { $value }; con questo valore il ciclo fa lo stesso di prima.
    }
diag-convert-parameter-dropped = { $neutral ->
        [yes] { $parameter } = { $value } di { $cycle } è stato tolto: { $control } fa lo stesso senza.
       *[no] { $parameter } = { $value } di { $cycle } è stato tolto: { $control } non lo ha.
    }
diag-convert-parameter-renamed = { $parameter } di { $cycle } diventa { $new } su { $control }.
diag-convert-no-value = { $cycle } richiede { $parameter } su { $control }, ma non si sa quale valore lasci invariata la lavorazione.
diag-convert-value-refused = { $parameter } = { $value } di { $cycle } non è ammesso su { $control }; il valore non è stato modificato.
diag-convert-value-differs-in-meaning = { $parameter } = { $value } di { $cycle } ha un altro significato su { $control }.
diag-convert-field-not-on-control = Il campo { $parameter } di { $cycle } non esiste su { $control }; la definizione non è stata modificata.
diag-convert-form = { $cycle } diventa { $new }.
diag-convert-form-stays = { $cycle } mantiene la sua forma: tra le sue righe ci sono commenti o altri blocchi.
diag-convert-not-line-by-line = { $cycle } non è stato modificato: i suoi parametri non sono ciascuno su una riga propria.
diag-convert-function-not-shown = { $function } ({ $count ->
        [one] usata una volta
       *[other] usata { $count } volte
    }) non è stata modificata: il manuale di { $control } non la mostra.
diag-convert-function-option = { $function } su { $control } richiede l’opzione software { $option }.
