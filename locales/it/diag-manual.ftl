# What can go wrong while a manual is built; see the English file.

diag-manual-template = Il modello { $template } non è utilizzabile (riga { $line }): { $reason }.
diag-manual-json = I dati non possono essere scritti in formato JSON: { $reason }.
diag-manual-empty = Non c’è alcun controllo o alcuna lingua per cui creare il manuale.
diag-manual-topic-missing = L’argomento { $topic } non ha una pagina nella lingua { $language }.
diag-manual-topic-title = La pagina dell’argomento { $topic } nella lingua { $language } non inizia con un titolo, cioè con una riga come "# Titolo".
