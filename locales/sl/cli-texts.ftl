# Ukaz »texts«.
cli-texts = Pokaže stanje prevodov, jih potrdi ter izmenja s prevajalci
cli-texts-action = Kaj naj se naredi: status pokaže, kaj je še odprto, accept zabeleži, da prevodi ustrezajo angleškim besedilom, export zapiše datoteko za prevajalce, import jo prebere nazaj
cli-texts-input = import: datoteke prevajalcev, XLIFF ali PO, ali izrazi v obliki TBX ali CSV; več datotek se prevzame skupaj
cli-texts-lang = Samo ta jezik; lahko se ponovi
cli-texts-file = status: samo ta datoteka jezika, na primer drilling.ftl; lahko se ponovi
cli-texts-text = accept: besedilo s tem ključem ali, če se KEY konča z *, vsa besedila, katerih ključ se tako začne; lahko se ponovi
cli-texts-changed = accept: prevodi, ki so novi ali so bili po potrditvi spremenjeni
cli-texts-all = accept: vsi prevodi, tudi nespremenjeni, katerih angleško besedilo se je spremenilo
cli-texts-to = export: jezik, v katerega se prevaja; import: jezik datoteke (privzeto: kot je navedeno v datoteki)
cli-texts-stale = export: samo zastarela ali nepotrjena besedila; skupaj z --missing oboje
cli-texts-missing = export: samo manjkajoča besedila; skupaj z --stale oboje
cli-texts-cycle = export: samo besedila tega cikla; lahko se ponovi
cli-texts-copy-source = export: na mesto manjkajočega prevoda zapiše angleško besedilo; za programe, ki prevajajo na mestu samem
cli-texts-out = export: datoteka, ki se zapiše (privzeto: standardni izhod)
cli-texts-any-state = import: vsako prevedeno enoto obravnava kot končno; za programe, ki stanj ne ohranijo
cli-texts-dry-run = import: preveri datoteko in poroča, ne da bi kaj spremenil
cli-texts-format = Oblika izpisa: text (privzeto), json; pri export: xliff (1.2, privzeto), xliff2 (2.0), po, tmx (potrjena besedila vseh jezikov), tbx in csv (slovar in parametri)
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
cli-texts-group = skupina { $name }
cli-texts-accepted = { $language }: { $count ->
        [one] potrjeno { $count } besedilo.
        [two] potrjeni { $count } besedili.
        [few] potrjena { $count } besedila.
       *[other] potrjenih { $count } besedil.
    }
cli-texts-left = { $language }: nepotrjena so ostala besedila, pri katerih se je angleško besedilo spremenilo, prevod pa ne: { $keys }. Če prevod ustreza tak, kot je, ga potrdite z ukazom »ciklo texts accept --text KEY«.
cli-texts-moved = { $language }: nepotrjena so ostala besedila, ki imajo zdaj besede drugih besedil: { $keys }. Če prevod ustreza tak, kot je, ga potrdite z ukazom »ciklo texts accept --text KEY«.
cli-texts-new = { $language }: nepotrjena so ostala nova besedila: { $keys }. Potrdi jih »ciklo texts accept --changed«.
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
cli-texts-more = in še { $count }
cli-examples-texts =
    ciklo texts status
    ciklo texts status --lang fi --file drilling.ftl --format json
    ciklo texts accept --changed
    ciklo texts accept --lang it --text step-approach
    ciklo texts export --to fi --stale --missing --out fi.xlf
    ciklo texts import fi.xlf --dry-run
    ciklo texts export --format tbx --out terms.tbx
cli-texts-topic = export: samo stran te teme; lahko se ponovi
cli-texts-base-url = export: naslov zgrajenega spletnega mesta za povezave na strani v opombah
# What a translator is told about a text.
cli-texts-note-kind = To je { $kind ->
        [inserted] beseda, ki jo druga besedila vstavijo v zahtevanem sklonu
        [topic] odsek proznega besedila
        [group] ime skupine ciklov
        [cycle] ime cikla
        [parameter] ime parametra
        [step] stavek o poteku cikla
        [until] pogoj, ob katerem se ponavljanje konča
        [condition] pogoj, ki dopolni »samo če«
        [choice] izbira parametra
        [result] rezultat cikla
        [note] opomba k ciklu
        [guard] razlog, zakaj krmiljenje zavrne cikel
        [message] sporočilo krmiljenja upravljavcu
        [figure] naslov slike
        [form] ime oblike stavka cikla
        [table] naslov tabele
        [title] naslov primera
        [comment] opomba v primeru programa
        [term] izraz iz slovarja
        [log] vrstica protokola, ki ga zapiše cikel
        [diagnostic] ugotovitev programa
        [explanation] razlaga ugotovitve
        [gap] beseda na mestu argumenta
        [command] pomoč ali sporočilo ukaza
        [unit] enota
        [list] način združevanja seznama
        [page] beseda na straneh priročnika
        [label] komentar za parametrom v NC-programih
        [nc] ime cikla v NC-programih
        [word] natisnjena beseda polja v NC-programih
        [help] pomen parametra
        [purpose] namen cikla
        [definition] opredelitev izraza
        [prompt] vprašanje pogovornega okna
        [symbol] simbol enote
       *[other] besedilo programa
    }.
cli-texts-note-unit = Enota: { $unit }.
cli-texts-note-range = Dovoljeno območje: { $range } ({ $controls }).
cli-texts-note-label = Največ { $most } znakov: velike črke, števke, presledki in { $signs }
cli-texts-note-capitals = Samo velike črke, števke, presledki in { $signs }
cli-texts-note-length = Največ { $most } znakov
cli-texts-note-cycles = { $more ->
        [none] { $control }: { $cycles }
       *[other] { $control }: { $cycles } in še { $more }
    }
cli-texts-note-lines = Vir v priročnikih za { $control }, { $cycle }: { $lines }.
cli-texts-note-page = Stran: { $page }
# Languages in the making, and the pseudo-language.
cli-build-draft = Zgradi en jezik, ki še ni popoln: manjkajoče je označeno v angleščini in vsaka stran to pove
cli-draft = { $language }: manjkajočih besedil: { $count }; so v angleščini v oklepajih ⟦ ⟧.
cli-arg-pseudo = Prikaže besedila v psevdojeziku, da se vidi, kaj je odrezano ali neprevedeno: accents (daljše besede z naglasi) ali bidi (tudi od desne proti levi)
