## Työkiertokuvausten virheet. $expected ja $found tulevat tiedostosta tai nimeävät arvon lajin.

diag-spec-both-forms = Työkierrolla on sekä parametreja että vanhan muodon rivejä; se voidaan kirjoittaa vain yhdessä muodossa.
diag-spec-case-incomplete = Tapaus { $name } tarvitsee asetelman ja odotetun tuloksen tai syyn ohittamiseen.
diag-spec-case-never-reached = Tähän tapaukseen ei koskaan tulla: aiempi tapaus on voimassa aina, kun tämä on.
diag-spec-case-proves-nothing = Tapaus { $name } ei kerro, mitä se osoittaa.
diag-spec-duplicate-choice = Vaihtoehto { $value } esiintyy kahdesti.
diag-spec-duplicate-cycle = { $cycle } ({ $name }) on kuvattu kahdesti samalle ohjaukselle.
diag-spec-duplicate-key = Avain { $key } on tässä kahdesti.
diag-spec-duplicate-name = Nimi { $name } on tässä kahdesti.
diag-spec-duplicate-parameter = { $q } on työkierrossa kahdesti.
diag-spec-empty-range = Alue on tyhjä: { $min } ei ole pienempi kuin { $max }.
diag-spec-example-out-of-range = Parametri { $name } ei hyväksy omaa esimerkkiarvoaan { $value }.
diag-spec-expected = Odotettiin: { $expected ->
        [mapping] avaimia ja arvoja
        [list] luettelo
        [number] luku
        [whole-number] kokonaisluku
        [text] teksti
        [true-or-false] true tai false
        [q-parameter] Q-parametri
        [axis] akselin kirjain
        [action] toiminto
        [one-verb] täsmälleen yksi verbi
        [one-series] täsmälleen yksi sarja
        [cell] file, row, column ja value
        [column] at ja is
        [pair] kaksi lukua
        [end-word] done, stopped, error, limit tai unsupported
       *[other] { $expected }
    }, löytyi: { $found }.
diag-spec-expression = Tämä ei ole lauseke: odotettiin { $expected }, löytyi ”{ $found }”.
diag-spec-foreign-manual = Käsikirja { $manual } ei kuulu ohjaukselle { $control }.
diag-spec-guard-keys = Tarkastus tarvitsee avaimet code, when ja then, tai se nimeää osan avaimella use.
diag-spec-id-form = Tunnus { $name } ei ole muotoa, jossa pienet kirjaimet ja numerot erotetaan yhdysmerkillä (kebab case).
diag-spec-lines-form = Rivit ”{ $lines }” eivät ole numeroita tai alueita suuruusjärjestyksessä.
diag-spec-missing-key = Avain { $key } puuttuu.
diag-spec-no-example = Parametrilla { $name } ei ole esimerkkiarvoa.
diag-spec-no-parameters = Työkierrolla ei ole parametreja eikä vanhan muodon rivejä.
diag-spec-no-source = Tälle ohjaukselle ei ole annettu paikkaa käsikirjassa.
diag-spec-no-steps = Kulussa ei ole vaiheita.
diag-spec-note-without-section = Ohjeella { $note } ei ole osiota tiedostossa pages.yaml: lisää se sopivaan osioon.
diag-spec-only-and-except = Kohdassa voi olla joko only tai except, ei molempia.
diag-spec-otherwise-last = Tapauksen, jolla ei ole ehtoja, on oltava viimeinen.
diag-spec-range-of-text = { $name } ei ole luku, joten sillä ei voi olla aluetta.
diag-spec-result-target = Tulos { $name } tarvitsee joko Q-parametrin tai tämän työkierron kentän.
diag-spec-run-item = Kulun kohta on virheellinen: { $reason ->
    [one-head] siinä on oltava täsmälleen yksi avaimista step, group ja each.
    [series-keys] in, until, between ja collect kuuluvat avaimen each yhteyteen.
    [series-body] each tarvitsee sarjan avaimeen in ja kulun kohtia avaimeen do.
    [step-body] vaiheessa on toimintoja, ei kulun kohtia.
    [group-body] ryhmässä on kohtia eikä mitään muuta.
   *[step-keys] choose, then ja by kuuluvat vaiheeseen.
}
diag-spec-text-parameter = { $name }: QS-parametrin arvo on teksti, ja vain QS-parametrilla voi olla teksti.
diag-spec-unknown-condition = Ehtoa { $name } ei ole.
diag-spec-unknown-control = Ohjausta { $control } ei ole; ohjaukset ovat { $known }.
diag-spec-unknown-cycle = Ohjauksessa { $control } ei ole työkiertoa { $cycle }.
diag-spec-unknown-cycle-name = Tässä ohjauksessa ei ole työkiertoa nimeltä { $name }.
diag-spec-unknown-datum = Ohjauksessa { $control } ei ole konetietoa nimeltä { $name }.
diag-spec-unknown-form = Työkierrolla ei ole muotoa nimeltä { $name }.
diag-spec-unknown-fragment = Kuvauksen osaa { $name } ei ole määritelty.
diag-spec-unknown-key = Avain { $key } ei ole tässä mahdollinen; mahdolliset avaimet: { $known }.
diag-spec-unknown-meaning = Sanastossa ei ole parametria nimeltä { $name }.
diag-spec-unknown-option = Ohjauksessa { $control } ei ole ohjelmisto-optiota { $option }.
diag-spec-unknown-parameter = Työkierrolla { $cycle } ei ole parametria { $name }.
diag-spec-unknown-topic = Aihetta { $topic } ei ole.
diag-spec-unused = Nimeä { $name } ei käytetä.
diag-spec-word-shape = { $name }: muoto word tarvitsee avaimen word, eikä sitä saa olla millään muulla muodolla.
diag-spec-yaml-feature = { $feature ->
    [anchor] Ankkureita ja tunnisteita ei käytetä kuvauksissa.
    [alias] Viittauksia ankkureihin ei käytetä kuvauksissa.
    [depth] Tiedostossa on liian monta sisäkkäistä tasoa.
    [no-document] Tiedosto on tyhjä.
    [second-document] Tiedostossa on vain yksi dokumentti.
   *[structured-key] Avaimen on oltava tavallinen sana.
}
diag-spec-yaml-syntax = Tämä ei ole YAML-muotoa: { $reason }.
related-first-place = ensimmäinen on tässä
related-other-place = toinen on tässä
related-defined-here = se on määritelty tässä
related-written-over-here = päälle kirjoitetaan tässä
related-for-this-control = tarvitaan tälle ohjaukselle
diag-spec-measure = Työkierrossa { $cycle } { $reason ->
        [different-quantities] lasketaan yhteen tai verrataan kahta suuretta, jotka eivät ole samaa lajia
        [coordinates-added] lasketaan yhteen kaksi koordinaattia
        [distance-as-coordinate] etäisyys on koordinaatin paikalla
        [coordinate-as-distance] koordinaatti on etäisyyden paikalla
        [not-a-feed] syöttöarvon paikalla on jotakin muuta kuin syöttöarvo
        [not-a-length] aseman paikalla on jotakin muuta kuin pituus
        [not-a-time] ajan paikalla on jotakin muuta kuin aika
        [not-a-speed] karan kierrosluvun paikalla on jotakin muuta kuin kierrosluku
        [not-a-number] yksiköttömän luvun paikalla on suure, jolla on yksikkö
        [bare-number] pituutta tai syöttöarvoa verrataan lukuun, jolla ei ole yksikköä
        [same-operands] valitaan kahdesta samasta kaavasta tai verrataan niitä
        [never-negative] otetaan etumerkki tai itseisarvo parametrista, joka ei ole koskaan negatiivinen
       *[not-an-angle] kulman paikalla on jotakin muuta kuin kulma
    }.
