# Books that `ciklo build` writes.
cli-build-format = Mitä kirjoitetaan: html on sivusto (oletus), epub ja pdf ovat kirjoja, yksi jokaista ohjausta ja kieltä kohti
cli-book-written = { $path }: { $pages } sivua
diag-book-not-packed = Kirjaa { $path } ei voi pakata: { $reason }
explain-book-not-packed = Kirjan osaa ei voitu lisätä sen pakettiin. Näin käy vain, kun teksti tai kuva on suurempi kuin muoto sallii (4 GiB). Esimerkki: työkopio, jonka aihe on kasvanut rajatta. Korjaus: pienennä kasvanutta sivua ja tee kirja uudelleen.
diag-book-not-set = Kirjaa { $path } ei voi latoa: { $file }, rivi { $line }: { $reason }
explain-book-not-set = Ladontaohjelma ei hyväksy sivun merkintöjä, tai tulos ei olisi esteetön PDF (PDF/UA-1): kuvalta puuttuu kuvaus tai kirjasimista puuttuu merkki. Mainittu tiedosto on sivun tiedosto tai book.typ, joka määrää ulkoasun. Esimerkki: muutettu templates/print/book.typ kutsuu funktiota, jota ei ole. Korjaus: korjaa malli tai teksti ja tee kirja uudelleen.
diag-pdf-not-built-in = Tämä ciklo on käännetty ilman PDF:ää; PDF:n tekevä ciklo asennetaan lähdekoodista komennolla: cargo install --path . --features pdf
explain-pdf-not-built-in = PDF:n ladonta tarvitsee osia, joiden kääntäminen kestää minuutteja; ne jäävät pois, ellei ominaisuutta pdf pyydetä. Esimerkki: ciklo build --format pdf, kun ciklo on asennettu pelkällä komennolla cargo install --path . Korjaus: asenna ciklo uudelleen valitsimella --features pdf tai käytä muotoa --format epub, jonka jokainen ciklo osaa kirjoittaa.
