# Values that a block cannot have, and labels that a control cannot print; see the English file.

diag-block-unknown-form = Työkierrolla { $cycle } ei ole muotoa ”{ $form }”. Muodot ovat: { $forms }.
diag-block-unknown-parameter = Työkierrolla { $cycle } ei ole parametria ”{ $name }”. Parametrit ovat: { $known }.
diag-block-duplicate-parameter = { $name } on annettu kahdesti.
diag-block-wrong-kind =
    { $name } ({ $parameter }) ei voi olla ”{ $value }”; sallittu arvo: { $kind ->
        [integer] kokonaisluku
        [number-or-name] luku tai nimi lainausmerkeissä
        [text] teksti lainausmerkeissä
        [q-number] Q-parametri
        [axis-direction] akseli ja etumerkki, esimerkiksi X-
        [position] koordinaatit akseleittain, esimerkiksi X+5 Y+0
        [row] taulukon rivi, esimerkiksi #5
        [axis] akseli
        [label-list] label-numerot vinoviivoin erotettuina, esimerkiksi 1/2/3
       *[number] luku
    }.
diag-block-below-minimum = { $name } ({ $parameter }) ei voi olla { $value }: pienin arvo on { $min }.
diag-block-above-maximum = { $name } ({ $parameter }) ei voi olla { $value }: suurin arvo on { $max }.
diag-block-too-long =
    { $kind ->
        [label-list] { $name } ({ $parameter }) ei voi olla { $value }: labeleita saa olla enintään { $most }.
        [axes] { $name } ({ $parameter }) ei voi olla { $value }: akseleita saa olla enintään { $most }.
       *[text] { $name } ({ $parameter }) ei voi olla { $value }: merkkejä saa olla enintään { $most }.
    }
diag-block-not-offered = { $name } ({ $parameter }) ei voi olla { $value }: vaihtoehdot ovat { $offered }.
diag-block-no-value = Työkierto { $cycle } tarvitsee arvon parametrille { $name }; käsikirjassa ei ole esimerkkiä.
diag-label-character = Työkierron { $cycle } NC-tekstissä ”{ $label }” ({ $control }, { $language }) on merkki ”{ $character }”, jota ohjaus ei voi näyttää.
diag-label-lower-case = Työkierron { $cycle } NC-tekstissä ”{ $label }” ({ $control }, { $language }) on pieniä kirjaimia.
diag-label-too-long = Työkierron { $cycle } NC-tekstissä ”{ $label }” ({ $control }, { $language }) on { $length } merkkiä; ohjaus näyttää { $most }.
diag-prompt-too-long = Työkierron { $cycle } kysymyksessä ”{ $label }” ({ $control }, { $language }) on { $length } merkkiä; ohjaus näyttää { $most }.
