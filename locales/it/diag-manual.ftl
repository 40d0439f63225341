# What can go wrong while a manual is built; see the English file.

diag-manual-template = Il modello { $template } non è utilizzabile (riga { $line }): { $reason }.
diag-manual-json = I dati non possono essere scritti in formato JSON: { $reason }.
diag-manual-empty = Non c'è alcun controllo o alcuna lingua per cui creare il manuale.
