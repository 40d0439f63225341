# Blocks that end a program or speak with the machine.
diag-error-of-program = Il programma termina da sé con l’errore { $number } (FN 14).
explain-error-of-program = FN 14: ERROR termina il programma con un errore proprio; il numero sceglie il messaggio visualizzato dal controllo. I programmi lo usano quando non possono proseguire, ad esempio perché il valore di un parametro non è utilizzabile. Esempio: “FN 14: ERROR = 1010”. Rimedio: controllare la condizione che precede il blocco e assegnare ai parametri valori con cui il programma può lavorare.
diag-tool-setter-missing = Lo scenario non ha un sistema di tastatura per utensili.
explain-tool-setter-missing = Un ciclo di misura dell’utensile richiede nello scenario un sistema di tastatura da tavolo: dove si trova la sua superficie e quanto è larga. Esempio: “tool_setter:” con “at: [300, 200, -50]” e “diameter: 40”. Rimedio: aggiungerlo allo scenario; docs/scene.md ne descrive le chiavi.
