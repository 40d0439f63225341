# Komento ”texts”.
cli-texts = Näytä, miten pitkällä käännökset ovat, hyväksy niitä ja välitä ne kääntäjille ja takaisin
cli-texts-action = Mitä tehdään: status näyttää, mikä on kesken, accept merkitsee käännökset englanninkielisiä tekstejä vastaaviksi, export kirjoittaa tiedoston kääntäjille, import lukee sellaisen takaisin
cli-texts-input = import: kääntäjien tiedostot, XLIFF tai PO, tai termit muodossa TBX tai CSV; useat otetaan käyttöön yhdessä
cli-texts-lang = Vain tämä kieli; voidaan toistaa
cli-texts-file = status: vain tämä kielen tiedosto, esimerkiksi drilling.ftl; voidaan toistaa
cli-texts-text = accept: teksti, jolla on tämä avain, tai kaikki, joiden avaimen alku on sama, jos KEY päättyy merkkiin *; voidaan toistaa
cli-texts-changed = accept: käännökset, jotka ovat uusia tai joita on muutettu hyväksymisen jälkeen
cli-texts-all = accept: kaikki käännökset, myös muuttamattomat, joiden englanninkielinen teksti on muuttunut
cli-texts-to = export: kieli, jolle käännetään; import: tiedoston kieli (oletus: tiedostossa ilmoitettu)
cli-texts-stale = export: vain vanhentuneet tai hyväksymättömät tekstit; valitsimen --missing kanssa molemmat
cli-texts-missing = export: vain puuttuvat tekstit; valitsimen --stale kanssa molemmat
cli-texts-cycle = export: vain tämän työkierron tekstit; voidaan toistaa
cli-texts-copy-source = export: kirjoittaa puuttuvan käännöksen paikalle englanninkielisen tekstin; ohjelmille, jotka kääntävät tekstin paikallaan
cli-texts-out = export: kirjoitettava tiedosto (oletus: vakiotuloste)
cli-texts-any-state = import: pitää jokaista käännettyä yksikköä valmiina; ohjelmille, jotka eivät säilytä tiloja
cli-texts-dry-run = import: tarkistaa tiedoston ja raportoi muuttamatta mitään
cli-texts-format = Tulosteen muoto: text (oletus), json; export-toiminnossa xliff (1.2, oletus), xliff2 (2.0), po, tmx (kaikkien kielten hyväksytyt tekstit), tbx ja csv (sanasto ja parametrit)
cli-texts-exported = { $count ->
        [one] { $count } yksikkö viety.
       *[other] { $count } yksikköä viety.
    }
cli-texts-imported = { $language }: { $dry ->
        [yes] otettavissa { $taken }
       *[no] otettu { $taken }
    }, ennallaan { $unchanged }, kesken { $open }, hylätty { $refused }.
cli-texts-count = { $name }: käännetty { $translated }/{ $texts }, puuttuu { $missing }, vanhentunut { $stale }, hyväksymättä { $unaccepted }, sama kuin englanniksi { $same }, liian pitkä { $long }, sanoja kääntämättä { $words }
cli-texts-group = ryhmä { $name }
cli-texts-accepted = { $language }: { $count ->
        [one] { $count } teksti hyväksytty.
       *[other] { $count } tekstiä hyväksytty.
    }
cli-texts-left = { $language }: hyväksymättä jäivät tekstit, joiden englanninkielinen teksti on muuttunut mutta käännös ei: { $keys }. Jos käännös kelpaa sellaisenaan, hyväksy se komennolla ”ciklo texts accept --text KEY”.
cli-texts-moved = { $language }: hyväksymättä jäivät tekstit, joilla on nyt toisten tekstien sanat: { $keys }. Jos käännös kelpaa sellaisenaan, hyväksy se komennolla ”ciklo texts accept --text KEY”.
cli-texts-new = { $language }: hyväksymättä jäivät uudet tekstit: { $keys }. Komento ”ciklo texts accept --changed” hyväksyy ne.
cli-texts-open =
    { $state ->
        [missing] puuttuu: { $key } ({ $file })
        [stale] { $change ->
            [none] vanhentunut: { $key } ({ $file })
           *[other] vanhentunut: { $key } ({ $file }): { $change }
        }
        [unaccepted] hyväksymättä: { $key } ({ $file })
       *[same] sama kuin englanniksi: { $key } ({ $file })
    }
cli-texts-more = { $count ->
        [one] ja vielä { $count }
       *[other] ja vielä { $count }
    }
cli-examples-texts =
    ciklo texts status
    ciklo texts status --lang fi --file drilling.ftl --format json
    ciklo texts accept --changed
    ciklo texts accept --lang it --text step-approach
    ciklo texts export --to fi --stale --missing --out fi.xlf
    ciklo texts import fi.xlf --dry-run
    ciklo texts export --format tbx --out terms.tbx
cli-texts-topic = export: vain tämän aiheen sivu; voidaan toistaa
cli-texts-base-url = export: rakennetun sivuston osoite huomautusten sivulinkkejä varten
# What a translator is told about a text.
cli-texts-note-kind = Tämä on { $kind ->
        [inserted] sana, jonka muut tekstit lisäävät pyytämässään sijamuodossa
        [topic] proosasivun osa
        [group] työkiertoryhmän nimi
        [cycle] työkierron nimi
        [parameter] parametrin nimi
        [step] virke työkierron kulusta
        [until] ehto, johon toisto päättyy
        [condition] ehto, joka täydentää ilmauksen ”vain jos”
        [choice] parametrin valintavaihtoehto
        [result] työkierron tulos
        [note] työkiertoa koskeva huomautus
        [guard] syy, jonka takia ohjaus hylkää työkierron
        [message] ohjauksen viesti koneen käyttäjälle
        [figure] kuvan otsikko
        [form] työkierron lauseen muodon nimi
        [table] taulukon otsikko
        [title] esimerkin otsikko
        [comment] esimerkkiohjelman kommentti
        [term] sanaston termi
        [log] rivi työkierron kirjoittamassa pöytäkirjassa
        [diagnostic] ohjelman huomautus
        [explanation] ohjelman selitys huomautukseen
        [gap] sana argumentin tilalla
        [command] komennon ohje tai viesti
        [unit] yksikkö
        [list] luettelon liitostapa
        [page] ohjekirjan sivujen sana
        [label] parametrin perässä oleva selite NC-ohjelmassa
        [nc] työkierron nimi NC-ohjelmassa
        [word] kentän painettu sana NC-ohjelmassa
        [help] parametrin merkitys
        [purpose] työkierron tarkoitus
        [definition] termin määritelmä
        [prompt] dialogin kysymys
        [symbol] yksikön tunnus
       *[other] ohjelman teksti
    }.
cli-texts-note-unit = Yksikkö: { $unit }.
cli-texts-note-range = Sallittu alue: { $range } ({ $controls }).
cli-texts-note-label = Enintään { $most } merkkiä: isoja kirjaimia, numeroita, välilyöntejä ja { $signs }
cli-texts-note-capitals = Vain isoja kirjaimia, numeroita, välilyöntejä ja { $signs }
cli-texts-note-length = Enintään { $most } merkkiä
cli-texts-note-cycles = { $more ->
        [none] { $control }: { $cycles }
       *[other] { $control }: { $cycles } ja { $more } muuta
    }
cli-texts-note-lines = Lähde ohjauksen { $control } käsikirjoissa, { $cycle }: { $lines }.
cli-texts-note-page = Sivu: { $page }
# Languages in the making, and the pseudo-language.
cli-build-draft = Kirjoita yksi keskeneräinen kieli: puuttuva teksti on merkittynä englanniksi, ja jokainen sivu ilmoittaa siitä
cli-draft = { $language }: { $count } tekstiä puuttuu; ne ovat englanniksi merkkien ⟦ ⟧ sisällä.
cli-arg-pseudo = Näytä tekstit pseudokielellä, jotta huomataan, mikä katkeaa tai on kääntämättä: accents (pidennetyt sanat, joissa on tarkkeita) tai bidi (lisäksi oikealta vasemmalle)
