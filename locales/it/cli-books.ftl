# Books that `ciklo build` writes.
cli-build-format = Che cosa scrivere: html, un sito (predefinito), epub o pdf, un libro per ogni controllo e lingua
cli-book-written = { $path }: { $pages } pagine
diag-book-not-packed = Il libro { $path } non può essere impacchettato: { $reason }
explain-book-not-packed = Una parte del libro non ha potuto essere aggiunta al suo contenitore. Accade solo quando un testo o una figura supera quanto il formato consente (4 GiB). Esempio: una copia di lavoro il cui argomento è cresciuto senza fine. Rimedio: ridurre la pagina cresciuta e creare di nuovo il libro.
diag-book-not-set = Il libro { $path } non può essere composto: { $file }, riga { $line }: { $reason }
explain-book-not-set = Il compositore rifiuta la marcatura di una pagina, oppure il risultato non sarebbe un PDF accessibile (PDF/UA-1): una figura senza descrizione, un carattere che manca nei font. Il file indicato è quello della pagina, oppure book.typ, che ne definisce l’aspetto. Esempio: un templates/print/book.typ modificato che chiama una funzione inesistente. Rimedio: correggere il modello o il testo e creare di nuovo il libro.
diag-pdf-not-built-in = Questo ciklo è stato compilato senza PDF; uno che lo scrive si installa dai sorgenti con: cargo install --path . --features pdf
explain-pdf-not-built-in = La composizione di un PDF richiede parti la cui compilazione dura alcuni minuti; mancano, a meno che non si chieda la funzione pdf. Esempio: ciklo build --format pdf con un ciklo installato soltanto con cargo install --path . Rimedio: installarlo di nuovo con --features pdf oppure usare --format epub, che ogni ciklo sa scrivere.
