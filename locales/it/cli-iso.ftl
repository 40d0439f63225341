# DIN/ISO: conversione dei programmi e ciò che non ha equivalente.

cli-convert-to-iso = Da Klartext a DIN/ISO
cli-convert-to-klartext = Da DIN/ISO a Klartext
cli-convert-control = Controllo di cui si scrivono i nomi e le etichette (predefinito: quello a cui appartengono i cicli del programma)
cli-convert-lang = Lingua dei nomi e delle etichette (predefinita: quella dei testi del programma stesso)

diag-iso-no-equivalent = DIN/ISO non ha un equivalente di «{ $found }»; il blocco diventa un commento.
diag-iso-no-code = Nessun manuale riporta un codice DIN/ISO di { $found }; il blocco diventa un commento.
diag-klartext-no-equivalent = Klartext non ha un equivalente di «{ $found }»; il blocco diventa un commento.
diag-iso-unknown-code = Nessun manuale riporta un ciclo o una funzione con il codice { $found }.
diag-iso-word-not-allowed = { $found } non è ammesso in questo blocco.
diag-iso-no-direction = { $found }: G05 prosegue nel senso dell’arco precedente, ma non ce n’è alcuno.
diag-iso-mode-left-on = { $found } del blocco precedente qui non è attivo: un sottoprogramma o una ripetizione lo ha cambiato.
