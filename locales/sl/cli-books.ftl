# Books that `ciklo build` writes.
cli-build-format = Kaj se zapiše: html je spletno mesto (privzeto), epub in pdf sta knjigi, po ena za vsako krmiljenje in jezik
cli-book-written = { $path }: { $pages } strani
diag-book-not-packed = Knjige { $path } ni mogoče spakirati: { $reason }
explain-book-not-packed = Dela knjige ni bilo mogoče dodati v njen vsebnik. To se zgodi le, če je besedilo ali slika večja, kot dopušča oblika (4 GiB). Primer: delovna kopija, katere tema je zrasla brez konca. Rešitev: zmanjšajte stran, ki je zrasla, in znova izdelajte knjigo.
diag-book-not-set = Knjige { $path } ni mogoče postaviti: { $file }, vrstica { $line }: { $reason }
explain-book-not-set = Stavni program zavrne oznake strani ali pa rezultat ne bi bil dostopen PDF (PDF/UA-1): slika nima opisa ali v pisavah ni znaka. Navedena datoteka je datoteka strani ali book.typ, ki določa videz. Primer: spremenjena datoteka templates/print/book.typ kliče funkcijo, ki ne obstaja. Rešitev: popravite predlogo ali besedilo in znova izdelajte knjigo.
diag-pdf-not-built-in = Ta ciklo je preveden brez PDF; takega, ki zna PDF, namestite iz izvorne kode z ukazom: cargo install --path . --features pdf
explain-pdf-not-built-in = Za knjige PDF so potrebni deli programa, katerih prevajanje traja več minut; izpuščeni so, če možnosti pdf ne zahtevate. Primer: ciklo build --format pdf, ciklo pa je bil nameščen samo s cargo install --path . Rešitev: namestite ga znova z --features pdf ali uporabite --format epub, ki jo zna zapisati vsak ciklo.
