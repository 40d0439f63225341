# Il comando «convert» e i suoi messaggi.
cli-convert = Riscrive programmi per un altro controllo, oppure in DIN/ISO o in Klartext
cli-convert-file = Programmi NC; più d’uno solo con --in-place
cli-convert-from = Controllo per cui sono scritti i programmi
cli-convert-to = Controllo su cui devono funzionare
cli-convert-form = Forma dei cicli che ne hanno due: new (parametri Q) oppure old (un blocco per riga); predefinita: come nel programma
cli-convert-out = File da scrivere (predefinito: uscita standard)
cli-convert-in-place = Scrive i nuovi programmi al posto di quelli vecchi
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
diag-convert-one-file = Più programmi vengono riscritti solo con --in-place.
diag-convert-iso-stays = «{ $found }» cambierebbe, ma la nuova forma non si può scrivere in DIN/ISO; il blocco resta com’era.
diag-convert-iso-unread = In Klartext non c’è equivalente di «{ $found }»; il blocco resta com’era e non viene esaminato.
diag-convert-cycle-not-on-control = { $control } non ha { $cycle }; la definizione resta com’è.
diag-convert-cycle-not-described = Il manuale di { $control } cita { $cycle } ma non lo descrive: i parametri restano come sono.
diag-convert-cycle-not-covered = I manuali del controllo { $control } qui noti non trattano cicli come { $cycle }: la definizione resta com’è.
diag-convert-parameter-added =
    { $import ->
        [yes] In { $cycle } viene aggiunto { $parameter } = { $value }, come fa { $control } con i programmi meno recenti: impostare il valore desiderato.
       *[no] In { $cycle } viene aggiunto { $parameter } = { $value }, che non cambia il comportamento.
    }
diag-convert-parameter-dropped =
    { $neutral ->
        [yes] { $parameter } = { $value } di { $cycle } viene tolto: { $control } si comporta allo stesso modo senza.
       *[no] { $parameter } = { $value } di { $cycle } viene tolto: { $control } non lo prevede.
    }
diag-convert-parameter-renamed = { $parameter } di { $cycle } diventa { $new } su { $control }.
diag-convert-no-value = { $cycle } su { $control } richiede { $parameter }, e nulla dice quale valore mantenga il comportamento.
diag-convert-value-refused = { $control } non accetta { $parameter } = { $value } di { $cycle }; il valore resta.
diag-convert-value-differs-in-meaning = { $parameter } = { $value } di { $cycle } ha un altro significato su { $control }.
diag-convert-field-not-on-control = Il campo { $parameter } di { $cycle } non esiste su { $control }; la definizione resta com’è.
diag-convert-form = { $cycle } diventa { $new }.
diag-convert-form-stays = { $cycle } resta nella sua forma: tra le sue righe ci sono commenti o altri blocchi.
diag-convert-not-line-by-line = { $cycle } resta com’è: i suoi parametri non stanno ciascuno su una riga propria.
diag-convert-function-not-shown =
    { $function } ({ $count ->
        [one] una volta
       *[other] { $count } volte
    }) resta com’è: il manuale di { $control } non ne parla.
diag-convert-function-option = { $function } su { $control } richiede l’opzione software { $option }.
