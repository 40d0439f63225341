# Komento ”texts”.
cli-texts = Näyttää, miten pitkällä käännökset ovat, ja hyväksyy niitä
cli-texts-action = Mitä tehdään: status näyttää, mikä on kesken, accept merkitsee käännökset englanninkielisiä tekstejä vastaaviksi
cli-texts-lang = Vain tämä kieli; voidaan toistaa
cli-texts-file = status: vain tämä kielen tiedosto, esimerkiksi drilling.ftl; voidaan toistaa
cli-texts-text = accept: teksti, jolla on tämä avain, tai kaikki, joiden avaimen alku on sama, jos KEY päättyy merkkiin *; voidaan toistaa
cli-texts-changed = accept: käännökset, jotka ovat uusia tai joita on muutettu hyväksymisen jälkeen
cli-texts-all = accept: kaikki käännökset, myös muuttamattomat, joiden englanninkielinen teksti on muuttunut
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
