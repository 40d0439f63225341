# Blocks that end a program or speak with the machine.
diag-error-of-program = Il programma termina da sé con l’errore { $number } (FN 14).
explain-error-of-program = FN 14: ERROR termina il programma con un errore proprio; il numero sceglie il messaggio visualizzato dal controllo. I programmi lo usano quando non possono proseguire, ad esempio perché il valore di un parametro non è utilizzabile. Esempio: “FN 14: ERROR = 1010”. Rimedio: controllare la condizione che precede il blocco e assegnare ai parametri valori con cui il programma può lavorare.
