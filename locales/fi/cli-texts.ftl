# Komento ”texts”.
cli-texts = Näyttää, miten pitkällä käännökset ovat, hyväksyy niitä ja välittää ne kääntäjille ja takaisin
cli-texts-action = Mitä tehdään: status näyttää, mikä on kesken, accept merkitsee käännökset englanninkielisiä tekstejä vastaaviksi, export kirjoittaa tiedoston kääntäjille, import lukee sellaisen takaisin
cli-texts-input = import: kääntäjän tiedosto, XLIFF tai PO
cli-texts-lang = Vain tämä kieli; voidaan toistaa
cli-texts-file = status: vain tämä kielen tiedosto, esimerkiksi drilling.ftl; voidaan toistaa
cli-texts-text = accept: teksti, jolla on tämä avain, tai kaikki, joiden avaimen alku on sama, jos KEY päättyy merkkiin *; voidaan toistaa
cli-texts-changed = accept: käännökset, jotka ovat uusia tai joita on muutettu hyväksymisen jälkeen
cli-texts-all = accept: kaikki käännökset, myös muuttamattomat, joiden englanninkielinen teksti on muuttunut
cli-texts-to = export: kieli, jolle käännetään; import: tiedoston kieli (oletus: tiedostossa ilmoitettu)
cli-texts-stale = export: vain vanhentuneet tai hyväksymättömät tekstit; valitsimen --missing kanssa molemmat
cli-texts-missing = export: vain puuttuvat tekstit; valitsimen --stale kanssa molemmat
cli-texts-cycle = export: vain tämän työkierron tekstit; voidaan toistaa
cli-texts-out = export: kirjoitettava tiedosto (oletus: vakiotuloste)
cli-texts-dry-run = import: tarkistaa tiedoston ja raportoi muuttamatta mitään
cli-texts-format = Tulosteen muoto: text (oletus), json; export-toiminnossa xliff (1.2, oletus), xliff2 (2.0), po
cli-texts-exported = { $count ->
        [one] { $count } yksikkö viety.
       *[other] { $count } yksikköä viety.
    }
cli-texts-imported = { $language }: { $dry ->
        [yes] otettavissa { $taken }
       *[no] otettu { $taken }
    }, ennallaan { $unchanged }, kesken { $open }, hylätty { $refused }.
cli-texts-count = { $name }: käännetty { $translated }/{ $texts }, puuttuu { $missing }, vanhentunut { $stale }, hyväksymättä { $unaccepted }, sama kuin englanniksi { $same }, liian pitkä { $long }, sanoja kääntämättä { $words }
cli-texts-accepted = { $language }: { $count ->
        [one] { $count } teksti hyväksytty.
       *[other] { $count } tekstiä hyväksytty.
    }
cli-texts-left = { $language }: hyväksymättä jäivät tekstit, joiden englanninkielinen teksti on muuttunut mutta käännös ei: { $keys }. Jos käännös kelpaa sellaisenaan, hyväksy se komennolla ”ciklo texts accept --text KEY”.
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
