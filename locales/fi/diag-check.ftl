# Ohjelmien tarkastuksen ja kääntämisen löydökset; ks. englanninkielinen tiedosto.

diag-call-of-def-active-cycle = Työkierto { $cycle } vaikuttaa heti määrittelyn jälkeen; sitä ei saa kutsua.
diag-called-but-not-defined = Tässä kutsutaan työkiertoa, mutta sitä ennen ei ole määritelty yhtään.
diag-choice-not-offered = { $parameter }={ $value } ei ole mikään vaihtoehdoista: { $offered }.
diag-clearance-height-too-low = { $cycle } koskettaa korkeudella { $touched }: varmuuskorkeuden { $parameter }={ $value } on oltava suurempi kuin { $least }.
diag-cycle-not-described = Työkierto { $cycle } ({ $name }) mainitaan käsikirjoissa, mutta sitä ei ole kuvattu: sen parametreja ei tarkasteta.
diag-cycle-not-on-control = Ohjauksessa { $control } ei ole työkiertoa { $cycle }; se on ohjauksissa: { $controls }.
diag-defined-but-never-called = Työkierto { $cycle } määritellään tässä, mutta sitä ei kutsuta.
diag-duplicate-parameter = { $parameter } on työkierrossa { $cycle } kahdesti.
diag-guard = Ohjaus ei hyväksy näitä arvoja.
diag-label-missing = Kielellä ”{ $language }” ei ole NC-tekstiä työkierron { $cycle } parametrille { $parameter }.
diag-label-not-encodable = NC-tekstissä ”{ $label }” on merkki ”{ $character }”, jota tiedoston merkistössä ei ole.
diag-label-of-another-language = ”{ $label }” on toisen kielen NC-teksti ({ $language }); ohjelman kielellä parametrin { $parameter } teksti on ”{ $right }”.
diag-label-of-another-parameter = ”{ $label }” on parametrin { $other } NC-teksti, ei parametrin { $parameter }.
diag-misordered-parameter = Työkierrossa { $cycle } ohjaus näyttää parametrin { $parameter } ennen parametria { $before }.
diag-missing-parameter = Työkierrosta { $cycle } puuttuu { $parameter }.
diag-out-of-range =
    { $side ->
        [below] { $parameter }={ $value } on liian pieni: pienin arvo on { $limit }.
        [many] Parametri { $parameter } luettelee liian monta labelia: niitä saa olla { $limit }.
        [long] Parametrin { $parameter } teksti on liian pitkä: siinä saa olla enintään { $limit } merkkiä.
       *[above] { $parameter }={ $value } on liian suuri: suurin arvo on { $limit }.
    }
diag-spindle-off = Tässä kutsutaan koneistustyökiertoa, kun kara on pysähdyksissä.
diag-tool-missing = Työkierto liikuttaa tässä akseleita, mutta mikään aiempi työkalukutsu ei ole määritellyt työkaluakselia.
diag-unknown-cycle = { $cycle } ei ole minkään tässä tunnetun ohjauksen työkierto.
diag-unknown-parameter = Työkierrossa { $cycle } ei ole tässä ohjauksessa parametria { $parameter }.
diag-wrong-value-kind =
    Työkierron { $cycle } parametrin { $parameter } arvoksi kelpaa { $kind ->
        [integer] kokonaisluku
        [number-or-name] luku tai nimi lainausmerkeissä
        [text] teksti lainausmerkeissä
        [q-number] Q-parametri
        [axis-direction] akseli etumerkkeineen, esimerkiksi X-
        [position] yksi tai useampi koordinaatti, esimerkiksi X+5 Y+0
        [row] taulukon rivi, esimerkiksi #5
        [axis] akseli
        [label-list] label-numerot vinoviivoin erotettuina, esimerkiksi 1/2/3
       *[number] luku
    }{ $words-count ->
        [0] {""}
       *[other] {" "}tai { $words }
    }.
