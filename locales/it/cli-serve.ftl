# Il comando «serve».
cli-serve = Mostra i manuali e lo stato delle traduzioni in un browser di questo computer
cli-serve-port = Porta su cui restare in ascolto (predefinita: 8477); con 0 se ne usa una libera
cli-serve-address = I manuali sono all’indirizzo { $address }; Ctrl+C termina.
cli-serve-anew = I dati sono cambiati: { $files ->
        [0] impossibile creare le pagine.
       *[other] file creati di nuovo: { $files }.
    }
cli-examples-serve =
    ciklo serve
    ciklo --data . serve --control tnc640 --lang fi
diag-serve-address = { $path } non si può usare come indirizzo: { $reason ->
        [in-use] un altro programma usa la porta; sceglierne un’altra con --port
        [permission] permesso negato; scegliere con --port una porta superiore a 1023
       *[other] { $detail }
    }.
explain-serve-address = «ciklo serve» resta in ascolto su una porta di questo computer, raggiungibile solo da questo computer. Una porta può essere usata da un solo programma alla volta, e le porte fino a 1023 sono spesso riservate al sistema. Esempio: ciklo serve mentre un altro è in funzione in una seconda finestra. Terminare l’altro programma oppure scegliere un’altra porta con --port; con --port 0 il sistema ne assegna una libera.
