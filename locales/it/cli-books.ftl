# Books that `ciklo build` writes.
cli-build-format = Che cosa scrivere: html, un sito (predefinito), o epub, un libro per ogni controllo e lingua
cli-book-written = { $path }: { $pages } pagine
diag-book-not-packed = Il libro { $path } non può essere impacchettato: { $reason }
explain-book-not-packed = Una parte del libro non ha potuto essere aggiunta al suo contenitore. Accade solo quando un testo o una figura supera quanto il formato consente (4 GiB). Esempio: una copia di lavoro il cui argomento è cresciuto senza fine. Rimedio: ridurre la pagina cresciuta e creare di nuovo il libro.
