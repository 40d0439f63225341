# Books that `ciklo build` writes.
cli-build-format = Mitä kirjoitetaan: html on sivusto (oletus), epub on kirja jokaista ohjausta ja kieltä kohti
cli-book-written = { $path }: { $pages } sivua
diag-book-not-packed = Kirjaa { $path } ei voi pakata: { $reason }
explain-book-not-packed = Kirjan osaa ei voitu lisätä sen pakettiin. Näin käy vain, kun teksti tai kuva on suurempi kuin muoto sallii (4 GiB). Esimerkki: työkopio, jonka aihe on kasvanut rajatta. Korjaus: pienennä kasvanutta sivua ja tee kirja uudelleen.
