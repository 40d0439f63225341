### Jäsentimen havaintojen tekstit. $found on se, mitä kohdassa lukee, $expected avain sille, mitä siinä voisi lukea, tai ohjelman sana.

syntax-expected =
    { $expected ->
        [block] lauseen alku
        [end] lauseen loppu
        [sign] etumerkki
        [word] koordinaatti, R0, RL, RR, syöttöarvo tai M-toiminto
        [number] luku
        [m-function] M-toiminto
        [blk-form-part] 0.1, 0.2, CYLINDER, ROTATION tai FILE
        [tool-word] S, F, DL, DR tai DR2, kukin kerran
        [tool] työkalun numero tai työkalun nimi lainausmerkeissä
        [value] luku tai Q-parametri
        [quotation-mark] sulkeva lainausmerkki
        [unit] MM tai INCH
        [label] label-numero tai labelin nimi lainausmerkeissä
        [call] LBL tai PGM
        [name] nimi
        [selection] TABLE, PATTERN, CONTOUR, PGM tai CYCLE
        [cycle-word] CYCL DEF, CYCL CALL tai TCH PROBE
        [cycle-number] työkierron numero
        [text-parameter] QS-parametri
        [parameter] Q-parametri
        [relation] EQU, NE, GT tai LT
        [relation-of-number] tämän FN-numeron vertailu
        [less-nesting] lyhyempi tai vähemmän sisäkkäinen kaava
        [field] työkierron kenttä
        [operand] luku, Q-parametri tai funktio
        [operator] laskutoimituksen merkki
        [closing-bracket] sulkeva kaarisulku
        [known-function] kaavakielen funktio
        [character] kaavakielen merkki
        [arguments] eri määrä argumentteja
        [in-spec-only] vain laskutoimituksia, koska ohjelmissa ei tässä voi vertailla
        [block-word] tämän lauseen sana
        [approach] LT, LN, CT, LCT, PLT, PLN, PCT tai PLCT
        [plane-form] SPATIAL, PROJECTED, EULER, VECTOR, POINTS, RELATIV, AXIAL tai RESET
        [function] toiminnon nimi
        [transformation] DATUM, MIRROR, ROTATION tai SCALE
        [pattern-item] POS, ROW, PAT, FRAME, CIRC tai PITCHCIRC
        [contour-name] muoto, esimerkiksi QC1
        [contour-operator] &, |, ^ tai \
       *[other] { $expected }
    }

diag-syntax-unknown-block = Mikään lause ei ala näin: ”{ $found }”.
diag-syntax-unexpected = ”{ $found }” ei voi olla tässä; odotettiin: { syntax-expected }.
diag-syntax-incomplete = Lause on vajaa; odotettiin: { syntax-expected }.
diag-syntax-unclosed-text = Tekstistä puuttuu sulkeva lainausmerkki: { $found }
diag-syntax-formula = ”{ $found }” ei voi olla tässä kaavassa; odotettiin: { syntax-expected }.
diag-syntax-text-after-tab = ”{ $found }” on sarkainmerkin jäljessä eikä kuulu lauseeseen; ohjaus hylkäisi sen. Kommentti alkaa puolipisteellä.
diag-syntax-dangling-continuation = Merkki ~ kertoo, että lause jatkuu, mutta siihen kuuluvaa riviä ei seuraa.
diag-syntax-foreign-line = ”{ $found }” ei ole tämän kielen lause; ohjaus hylkäisi sen. Kommentti alkaa puolipisteellä.
diag-syntax-spelling = Ohjaukset eivät kirjoita ”{ $found }” vaan: { syntax-expected }.
diag-syntax-undescribed = Mikään tämän ohjausperheen käsikirja ei kuvaa muotoa ”{ $found }”; ei tiedetä, hyväksyykö ohjaus sen.
diag-syntax-refused-block = Ohjaus ei osannut lukea tätä lausetta: { $found }
diag-syntax-excluding-codes = ”{ $found }” ja saman lauseen toinen koodi sulkevat toisensa pois.
diag-syntax-bracket-comment = Suluissa oleva teksti ei ole näissä ohjauksissa kommentti: kommentti alkaa puolipisteellä.
diag-syntax-doubled-continuation = Tässä on toinen merkki ~; yksi riittää jatkamaan lauseen seuraavalle riville.
