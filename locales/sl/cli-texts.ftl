# Ukaz »texts«.
cli-texts = Pokaže stanje prevodov in jih potrdi
cli-texts-action = Kaj naj se naredi: status pokaže, kaj je še odprto, accept zabeleži, da prevodi ustrezajo angleškim besedilom
cli-texts-lang = Samo ta jezik; lahko se ponovi
cli-texts-file = status: samo ta datoteka jezika, na primer drilling.ftl; lahko se ponovi
cli-texts-text = accept: besedilo s tem ključem ali, če se KEY konča z *, vsa besedila, katerih ključ se tako začne; lahko se ponovi
cli-texts-changed = accept: prevodi, ki so novi ali so bili po potrditvi spremenjeni
cli-texts-all = accept: vsi prevodi, tudi nespremenjeni, katerih angleško besedilo se je spremenilo
cli-texts-count = { $name }: prevedeno { $translated } od { $texts }, manjka { $missing }, zastarelo { $stale }, nepotrjeno { $unaccepted }, enako angleškemu { $same }, predolgo { $long }, besed za prevod { $words }
cli-texts-accepted = { $language }: { $count ->
        [one] potrjeno { $count } besedilo.
        [two] potrjeni { $count } besedili.
        [few] potrjena { $count } besedila.
       *[other] potrjenih { $count } besedil.
    }
cli-texts-left = { $language }: nepotrjena so ostala besedila, pri katerih se je angleško besedilo spremenilo, prevod pa ne: { $keys }. Če prevod ustreza tak, kot je, ga potrdite z ukazom »ciklo texts accept --text KEY«.
cli-texts-open =
    { $state ->
        [missing] manjka: { $key } ({ $file })
        [stale] { $change ->
            [none] zastarelo: { $key } ({ $file })
           *[other] zastarelo: { $key } ({ $file }): { $change }
        }
        [unaccepted] nepotrjeno: { $key } ({ $file })
       *[same] enako angleškemu: { $key } ({ $file })
    }
cli-texts-more = { $count ->
        [one] in še { $count }
       *[other] in še { $count }
    }
cli-examples-texts =
    ciklo texts status
    ciklo texts status --lang fi --file drilling.ftl --format json
    ciklo texts accept --changed
    ciklo texts accept --lang it --text step-approach
