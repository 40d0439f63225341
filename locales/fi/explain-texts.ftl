explain-locale-same-as-source =
    Englanninkielisen tekstin kopio näyttää käännökseltä, mutta ei ole sellainen. Käännä teksti. Jos sanat ovat molemmissa kielissä samat tai eivät ole minkään kielen sanoja, lisää ne tai tekstin avain kielen luetteloon same-as-source.txt.
explain-texts-nothing-chosen =
    Kun käännös hyväksytään, sen ilmoitetaan vastaavan nykyistä englanninkielistä tekstiä, joten tarkistamattomia tekstejä ei koskaan hyväksytä. Luettele tekstit tai hyväksy valitsimella --changed ne, joiden käännöstä olet muuttanut.
explain-texts-unknown-key =
    Vain kielessä olevia tekstejä voidaan hyväksyä. ”ciklo texts status” luettelee keskeneräisten tekstien avaimet.
