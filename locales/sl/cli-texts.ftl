# Ukaz »texts«.
cli-texts = Pokaže stanje prevodov, jih potrdi ter izmenja s prevajalci
cli-texts-action = Kaj naj se naredi: status pokaže, kaj je še odprto, accept zabeleži, da prevodi ustrezajo angleškim besedilom, export zapiše datoteko za prevajalce, import jo prebere nazaj
cli-texts-input = import: datoteka prevajalca, XLIFF ali PO
cli-texts-lang = Samo ta jezik; lahko se ponovi
cli-texts-file = status: samo ta datoteka jezika, na primer drilling.ftl; lahko se ponovi
cli-texts-text = accept: besedilo s tem ključem ali, če se KEY konča z *, vsa besedila, katerih ključ se tako začne; lahko se ponovi
cli-texts-changed = accept: prevodi, ki so novi ali so bili po potrditvi spremenjeni
cli-texts-all = accept: vsi prevodi, tudi nespremenjeni, katerih angleško besedilo se je spremenilo
cli-texts-to = export: jezik, v katerega se prevaja; import: jezik datoteke (privzeto: kot je navedeno v datoteki)
cli-texts-stale = export: samo zastarela ali nepotrjena besedila; skupaj z --missing oboje
cli-texts-missing = export: samo manjkajoča besedila; skupaj z --stale oboje
cli-texts-cycle = export: samo besedila tega cikla; lahko se ponovi
cli-texts-out = export: datoteka, ki se zapiše (privzeto: standardni izhod)
cli-texts-dry-run = import: preveri datoteko in poroča, ne da bi kaj spremenil
cli-texts-format = Oblika izpisa: text (privzeto), json; pri export: xliff (1.2, privzeto), xliff2 (2.0), po
cli-texts-exported = { $count ->
        [one] Izvožena { $count } enota.
        [two] Izvoženi { $count } enoti.
        [few] Izvožene { $count } enote.
       *[other] Izvoženih { $count } enot.
    }
cli-texts-imported = { $language }: { $dry ->
        [yes] za prevzem { $taken }
       *[no] prevzeto { $taken }
    }, nespremenjeno { $unchanged }, nedokončano { $open }, zavrnjeno { $refused }.
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
    ciklo texts export --to fi --stale --missing --out fi.xlf
    ciklo texts import fi.xlf --dry-run
