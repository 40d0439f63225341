# Kielitiedostoja koskevat havainnot.

diag-locale-encoding = Tiedosto ei ole UTF-8-muodossa.
diag-locale-tag = Hakemiston nimi ”{ $tag }” ei ole kielitunnus.
diag-locale-nesting = Aaltosulkeita on sisäkkäin yli { $most } tasoa; tiedostoa ei lueta.
diag-locale-long-number = Luvussa on peräkkäin yli { $most } numeroa; tiedostoa ei lueta.
diag-locale-syntax =
    Tämä ei ole Fluentia: { $kind ->
        [expected-token] tässä pitäisi olla ”{ $detail }”
        [expected-character] tässä pitäisi olla jokin merkeistä { $detail }
        [empty-message] viestillä ”{ $detail }” ei ole arvoa eikä attribuuttia
        [empty-term] termillä ”-{ $detail }” ei ole arvoa
        [bad-function-name] funktion nimessä saa olla vain isoja kirjaimia, numeroita sekä merkkejä ”-” ja ”_”
        [no-default] valinta tarvitsee oletuksen, jonka merkki on ”*”
        [two-defaults] valinnalla saa olla vain yksi oletus
        [no-value] tässä pitäisi olla arvo
        [bad-selector] valinta tehdään argumentin, funktion tai termin attribuutin mukaan
        [term-attribute] termin attribuuttia ei voi näyttää
        [open-string] merkkijonoa ei ole päätetty
        [argument-order] nimettömien argumenttien on oltava ensin
        [argument-twice] argumentti ”{ $detail }” on annettu kahdesti
        [bad-escape] ”{ $detail }” ei ole ohjausmerkintä
        [closing-brace] sulkeva aaltosulje ilman avaavaa
       *[no-expression] tässä pitäisi olla lauseke
    }.
diag-locale-isolation-mark = Tässä on kirjoitussuunnan eristysmerkki; se ei saa päätyä NC-ohjelmaan.
diag-locale-duplicate = ”{ $key }” on määritelty kahdesti; myös samanniminen viesti ja termi lasketaan.
related-first-definition = ensimmäinen määrittely
diag-locale-variant = ”{ $key }” ei ole nimi, jossa on enintään kaksi loppuosaa (työkierto ja ohjaus).
diag-locale-unit-form = ”{ $key }” ei ole malli: yksikössä on tekstiä ja yksi { "{ $value }" }, luettelossa { "{ $first }" } ja { "{ $last }" } sekä arvossa että attribuutissa ”more”.
diag-locale-unknown-reference = Kohdetta ”{ $name }” ei ole.
diag-locale-unknown-function = Funktiota ”{ $name }” ei ole.
diag-locale-function-option = ”{ $name }: { $value }” ei ole funktion { $function } valitsin.
diag-locale-function-arguments = Funktiolla { $function } on väärä määrä arvoja.
diag-locale-unknown-unit = Yksikköä ”{ $name }” ei ole: tiedostossa units.ftl ei ole sille viestiä.
diag-locale-term-argument = Termi ”-{ $term }” ei käytä argumenttia ”{ $name }”.
diag-locale-term-value = Termillä ”-{ $term }” ei ole muotoa ”{ $value }” argumentille ”{ $name }”.
diag-locale-term-needs = Termille ”-{ $term }” on annettava tässä ”{ $name }”.
diag-locale-cyclic = ”{ $key }” sisältää itsensä.
diag-locale-unknown-language = Kielelle ”{ $language }” ei ole tiedostoja.
diag-locale-missing-text = Kielessä ”{ $language }” ei ole tekstiä ”{ $key }”{ $file ->
        [none] {""}.
       *[other] ; se kuuluu tiedostoon { $file }.
    }
diag-locale-missing-argument = Teksti ”{ $key }” ({ $language }) käyttää argumenttia ”{ $name }”, jota tässä ei ole.
diag-locale-function-failed =
    Tekstissä ”{ $key }” ({ $language }) funktiota { $name } ei voi suorittaa: { $reason ->
        [not-a-number] arvo ei ole luku
        [not-finite] luku ei ole äärellinen
        [no-unit] yksikkö puuttuu
        [unknown-unit] yksikkö on tuntematon
        [not-a-list] arvo ei ole luettelo
       *[unknown-type] luettelon laji on tuntematon
    }.
diag-locale-too-long = Tekstissä ”{ $key }” ({ $language }) on liian monta täytettävää kohtaa.
diag-locale-lock-line = Tämän tiedoston jokaisella rivillä on oltava tunnus ja kahdeksan heksadesimaalinumeroa.
diag-locale-missing-translation = Tekstiä ”{ $key }” ei ole käännetty kielelle ”{ $language }”.
diag-locale-unfinished = Kielestä ”{ $language }” puuttuu { $count } tekstiä. ”ciklo texts status --lang { $language }” laskee ne tiedostoittain ja nimeää seuraavat.
diag-locale-orphan = ”{ $key }” ({ $language }) on jäänyt yli: englanninkielistä tekstiä ei enää ole.
diag-locale-stale =
    { $change ->
        [none] Englanninkielinen teksti ”{ $key }” on muuttunut sen jälkeen, kun se käännettiin kielelle ”{ $language }”.
       *[other] Englanninkielinen teksti ”{ $key }” on muuttunut sen jälkeen, kun se käännettiin kielelle ”{ $language }”: { $change }.
    }
diag-locale-unrecorded = Tekstin ”{ $key }” käännöstä kielelle ”{ $language }” ei ole vielä hyväksytty.
diag-locale-moved = Tekstillä ”{ $key }” ({ $language }) on nyt sanat, jotka on hyväksytty tekstille ”{ $name }”.
diag-locale-unknown-argument = ”{ $key }” ({ $language }) käyttää argumenttia ”{ $name }”, jota englanninkielisessä tekstissä ei ole.
