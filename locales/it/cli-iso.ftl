# DIN/ISO: conversione dei programmi e ciò che non ha equivalente.

cli-convert-to-iso = Da Klartext a DIN/ISO
cli-convert-to-klartext = Da DIN/ISO a Klartext
cli-convert-control = Controllo di cui si scrivono i nomi e le etichette (predefinito: quello di cui il programma contiene i cicli)
cli-convert-lang = Lingua dei nomi e delle etichette (predefinita: quella dei testi del programma stesso)

diag-iso-no-equivalent = In DIN/ISO non c’è equivalente di «{ $found }»; il blocco resta come commento.
diag-iso-no-code = Nessun manuale riporta un codice DIN/ISO di { $found }; il blocco resta come commento.
diag-klartext-no-equivalent = In Klartext non c’è equivalente di «{ $found }»; il blocco resta come commento.
diag-iso-unknown-code = Nessun manuale riporta un ciclo o una funzione con il codice { $found }.
diag-iso-word-not-allowed = Nulla in questo blocco ammette { $found }.
diag-iso-no-direction = { $found }: G05 continua nel senso del cerchio precedente, ma non ce n’è alcuno.
