# Ohjelmien tarkastuksen ja kääntämisen löydökset; ks. englanninkielinen tiedosto.

diag-call-of-def-active-cycle = Työkierto { $cycle } vaikuttaa heti määrittelyn jälkeen; sitä ei saa kutsua.
    .explain = Pistekuviot, koordinaattimuunnokset ja kosketustyökierrot vaikuttavat, kun ne määritellään. Kutsu niiden perässä on virhe, jos sitä ennen ei ole määritelty koneistustyökiertoa, tai jos se on heti pistekuvion perässä, joka on jo kutsunut koneistustyökierron.
diag-called-but-not-defined = Tässä kutsutaan työkiertoa, mutta sitä ennen ei ole määritelty yhtään.
    .explain = CYCL CALL, M99 ja M89 suorittavat viimeksi määritellyn koneistustyökierron. Ilman määrittelyä ei ole mitään suoritettavaa. Ohjelmissa, joissa on hyppyjä, aliohjelmia tai ohitettavia lauseita, tämä ilmoitetaan vain, jos työkiertoa ei määritellä lainkaan, eikä koskaan, jos kutsutaan muita ohjelmia.
diag-choice-not-offered = { $parameter }={ $value } ei ole mikään vaihtoehdoista: { $offered }.
    .explain = Parametri tarjoaa arvoja, joilla kullakin on oma merkityksensä, eikä tämä ole mikään niistä. Esimerkki: Q215=3 työkierrossa CYCL DEF 251.
diag-cycle-not-described = Työkierto { $cycle } ({ $name }) mainitaan käsikirjoissa, mutta sitä ei ole kuvattu: sen parametreja ei tarkasteta.
    .explain = Ohjauksessa on työkierto, mutta sille ei ole tässä kuvausta. Sen parametrit, tekstit ja vaikutus ohitetaan.
diag-cycle-not-on-control = Ohjauksessa { $control } ei ole työkiertoa { $cycle }; se on ohjauksissa: { $controls }.
    .explain = Tämän ohjauksen käsikirjat eivät tunne työkiertoa, jonkin toisen ohjauksen käsikirja tuntee. Ohjelma on tehty toiselle ohjaukselle, tai valinta --control on väärä.
diag-defined-but-never-called = Työkierto { $cycle } määritellään tässä, mutta sitä ei kutsuta.
    .explain = Työkierto vaikuttaa, kun sitä kutsutaan toiminnolla CYCL CALL, M99 tai M89 tai pistekuviolla, eikä mitään näistä seuraa ennen seuraavaa tällaista työkiertoa tai ohjelman loppua. Määrittely ei tee mitään, tai kutsu on unohtunut.
diag-duplicate-parameter = { $parameter } on työkierrossa { $cycle } kahdesti.
    .explain = Määrittely antaa samalle parametrille tai kentälle kaksi arvoa; ei voi sanoa, kumpaa tarkoitetaan.
diag-guard = Ohjaus ei hyväksy näitä arvoja.
    .explain = Kuvauksissa sanotaan, milloin ohjaus hylkää työkierron, ohittaa sen, varoittaa tai kysyy. Jokaisella tällaisella ehdolla on oma koodinsa; se tarkastetaan vain arvoilla, jotka ohjelmassa on kirjoitettu lukuina tai teksteinä.
diag-label-missing = Kielellä ”{ $language }” ei ole tekstiä työkierron { $cycle } parametrille { $parameter }.
    .explain = Ohjelmaa ei voi kirjoittaa kokonaan tällä kielellä: jokin teksti on vielä kääntämättä. Vanha teksti jää paikalleen. Komento ciklo coverage luettelee, mitä puuttuu.
diag-label-not-encodable = Tekstissä ”{ $label }” on merkki ”{ $character }”, jota tiedoston merkistössä ei ole.
    .explain = Ohjelma ei ole UTF-8-tiedosto, ja sen merkistöstä (Windows-1252) puuttuu uuden tekstin merkki. Muunna tiedosto ensin UTF-8-muotoon, jos ohjaus lukee sitä.
diag-label-of-another-language = ”{ $label }” on toisen kielen teksti ({ $language }); ohjelman kielellä parametrin { $parameter } teksti on ”{ $right }”.
    .explain = Useimmat ohjelman tekstit ovat yhtä kieltä, tämä on toista. Komento ciklo translate kirjoittaa ne kaikki yhdellä kielellä.
diag-label-of-another-parameter = ”{ $label }” on parametrin { $other } teksti, ei parametrin { $parameter }.
    .explain = Arvon perässä oleva kommentti on saman työkierron toisen parametrin teksti. Ohjaus lukee vain numeron, mutta arvo saattaa olla tarkoitettu toiselle parametrille. Teksteihin, joita ei ole millään kielellä, ei puututa.
diag-misordered-parameter = Työkierrossa { $cycle } ohjaus näyttää parametrin { $parameter } ennen parametria { $before }.
    .explain = Ohjaus tunnistaa parametrit numerosta ja hyväksyy muunkin järjestyksen, mutta ohjauksessa määrittelyä tuskin on tehty. Ensimmäinen väärässä kohdassa oleva parametri ilmoitetaan.
diag-missing-parameter = Työkierrosta { $cycle } puuttuu { $parameter }.
    .explain = Ohjauksen käsikirja luettelee työkierrolle parametrin tai kentän, jota määrittelyssä ei ole. Määrittelyt, joissa on lukukelvoton rivi, ohitetaan. Esimerkki: CYCL DEF 247 ilman parametria Q339.
diag-out-of-range =
    { $side ->
        [below] { $parameter }={ $value } on liian pieni: pienin arvo on { $limit }.
        [long] Parametrin { $parameter } teksti on liian pitkä: siinä saa olla { $limit } merkkiä.
       *[above] { $parameter }={ $value } on liian suuri: suurin arvo on { $limit }.
    }
    .explain = Ohjauksen käsikirja antaa parametrille rajat, joiden ulkopuolella arvo on. Rajat koskevat vain tätä ohjausta; missä käsikirja ei niitä anna, mitään ei tarkasteta. Tuumaohjelmissa pituuksia ja syöttöarvoja ei tarkasteta. Esimerkki: Q202=-5.
diag-spindle-off = Tässä kutsutaan koneistustyökiertoa, kun kara on pysähdyksissä.
    .explain = Karaa ei ole käynnistetty (M3, M4, M13, M14), tai se on sen jälkeen pysäytetty (M0, M5, M6). Työkalukutsun ja koneen valmistajan M-toimintojen jälkeen ei ilmoiteta mitään. Ilmoitetaan kerran ohjelmassa.
diag-tool-missing = Työkierto liikkuu tässä, mutta sitä ennen ei mikään työkalukutsu ole antanut työkaluakselia.
    .explain = Työkierrot tarvitsevat työkaluakselin, jonka TOOL CALL antaa: TOOL CALL 5 Z S2000. Ilmoitetaan kerran ohjelmassa.
diag-unknown-cycle = { $cycle } ei ole minkään tässä tunnetun ohjauksen työkierto.
    .explain = Numero ei tarkoita työkiertoa missään käsikirjassa, johon kuvaukset perustuvat, eikä koneen valmistajan työkiertoa (300–399, 500–599). Tarkista avainsana ja numero: CYCL DEF 32 ja TCH PROBE 32 ovat eri työkiertoja. Esimerkki: CYCL DEF 299.
diag-unknown-parameter = Työkierrossa { $cycle } ei ole tässä ohjauksessa parametria { $parameter }.
    .explain = Parametri tai kenttä ei kuulu niihin, jotka ohjauksen käsikirja luettelee työkierrolle. Se kuuluu toiseen työkiertoon tai toiseen ohjaukseen, tai numero on kirjoitettu väärin. Esimerkki: Q999 työkierrossa CYCL DEF 247.
diag-wrong-value-kind =
    Työkierron { $cycle } parametri { $parameter } ottaa { $kind ->
        [integer] kokonaisluvun
        [number-or-name] luvun tai nimen lainausmerkeissä
        [text] tekstin lainausmerkeissä
        [q-number] Q-parametrin
        [axis-direction] akselin etumerkkeineen, esimerkiksi X-
        [position] koordinaatit akseleittain, esimerkiksi X+5 Y+0
        [row] taulukon rivin, esimerkiksi #5
        [axis] akselin
       *[number] luvun
    }{ $words-count ->
        [0] {""}
       *[other] {" "}tai { $words }
    }.
    .explain = Arvo on laatua, jota parametri ei ota: teksti luvun asemesta, murtoluku kokonaisluvun asemesta, sana, jota käsikirja ei sille luettele, tai ei mitään. Q-parametri on aina kelvollinen arvo. Esimerkki: Q201=FAUTO.
