# Books that `ciklo build` writes.
cli-build-format = Kaj se zapiše: html je spletno mesto (privzeto), epub je knjiga za vsako krmiljenje in jezik
cli-book-written = { $path }: { $pages } strani
diag-book-not-packed = Knjige { $path } ni mogoče spakirati: { $reason }
explain-book-not-packed = Dela knjige ni bilo mogoče dodati v njen vsebnik. To se zgodi le, če je besedilo ali slika večja, kot dopušča oblika (4 GiB). Primer: delovna kopija, katere tema je zrasla brez konca. Rešitev: zmanjšajte stran, ki je zrasla, in znova izdelajte knjigo.
