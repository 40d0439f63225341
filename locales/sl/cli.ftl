# Ukazna vrstica: pomoč, sporočila ter ugotovitve o datotekah in besedah.

cli-about = Specifikacije CNC-ciklov kot pogovorna okna, NC-stavki, priročniki, preverjanje in izvajanje programov
cli-explain-more = »ciklo explain { $code }« pojasni ugotovitev in kaj storiti.
cli-heading-usage = Uporaba:
cli-heading-commands = Ukazi
cli-heading-arguments = Argumenti
cli-heading-options = Možnosti
cli-heading-examples = Primeri:

cli-build = Zapiše priročnike, pogovorna okna in preglednice oznak
cli-build-out = Ciljna mapa; zamenja se šele, ko je vse popolno (privzeto: out)
cli-build-control = Samo to krmiljenje; lahko se ponovi
cli-build-lang = Samo ta jezik; lahko se ponovi
cli-build-base-url = Naslov, ki ga bo imelo spletišče: doda kanonične naslove, zemljevid spletišča in absolutne povezave v 404.html
cli-schema = Izpiše shemo JSON za specifikacije
cli-lint = Javi vse napake v specifikacijah in jezikih
cli-lint-accept = Potrdi prevode, ki so novi ali so bili po potrditvi spremenjeni
cli-coverage = Prikaže, kaj je popolno, kaj manjka, kaj je zastarelo, še ni na voljo in ni preizkušeno
cli-dialog = Prikaže pogovorno okno cikla
cli-block = Zapiše NC-stavek cikla
cli-block-values = Številka cikla in vrednosti parametrov, na primer Q321=50; drugi imajo vrednosti iz primera v priročniku
cli-block-number = Številka prvega stavka (privzeto: iz primera v priročniku)
cli-block-form = Oblika cikla, pri ciklih stare oblike, ki jih imajo več
cli-block-without = Neobvezno polje, ki se izpusti; lahko se ponovi
cli-parse = Razdeli program na stavke in jih izpiše kot JSON
cli-parse-print = Izpiše program nespremenjen, bajt za bajtom
cli-check = Preveri programe za eno krmiljenje
cli-check-lang = Jezik oznak v programih (privzeto: se ugotovi)
cli-explain = Pojasni kodo ugotovitve
cli-explain-code = Koda; brez nje se izpišejo vse kode
cli-explain-renamed = Koda »{ $old }« se zdaj imenuje »{ $code }«.
cli-translate = Zapiše program z imeni in oznakami drugega jezika; nič drugega se ne spremeni
cli-translate-to = Jezik imen in oznak
cli-translate-control = Krmiljenje programa (privzeto: se ugotovi iz njegovih ciklov)
cli-translate-out = Datoteka za zapis (privzeto: standardni izhod)
cli-run = Izvede program v prizorišču
cli-run-tool-table = Preglednica orodij ali stružnih orodij (.trn), ki se uporabi namesto tiste iz prizorišča; podati je mogoče obe
cli-run-out = Mapa za preglednice in protokole, ki jih zapiše program
cli-run-events = Vsak dogodek izpiše kot vrstico JSON
cli-run-skip-blocks = Preskoči stavke, ki se začnejo z /
cli-run-lang = Jezik protokolov (privzeto: jezik oznak v NC-programu, sicer jezik besedil samega programa)
cli-run-envelope = Namesto rezultatov pokaže, kaj bi vsak cikel tipanja naredil v najslabšem primeru
cli-conform = Izvede primere iz specifikacij
cli-conform-engine = Primere izvede z drugim izvajalnikom, ukazom, ki uporablja protokol iz docs/conform-protocol.md
cli-conform-time-limit = Najdaljši čas za primer, v sekundah (privzeto: 10)
cli-conform-serve = Odgovarja na zahteve tega protokola s standardnega vhoda
cli-export = Izpiše vse cikle krmiljenja v enem jeziku kot JSON

cli-arg-cycle = Številka cikla, na primer 412 ali TCH PROBE 412
cli-arg-file = NC-program; »-« pomeni standardni vhod
cli-arg-control = Krmiljenje, na primer tnc640
cli-arg-lang = Jezik, na primer fi (privzeto: jezik besedil samega programa)
cli-arg-scene = Datoteka prizorišča: stroj, orodja, obdelovanec
cli-arg-format = Oblika izpisa: text (privzeto), json
cli-arg-report = Oblika izpisa: text (privzeto), json, junit
cli-arg-data = Mapa s podmapami cycle-specs, locales in templates namesto vgrajenih podatkov
cli-arg-ui-lang = Jezik besedil samega programa (privzeto: jezik okolja)
cli-arg-help = Prikaže to pomoč
cli-arg-version = Prikaže različico

cli-examples-build =
    ciklo build
    ciklo build --out manuals --control tnc640 --lang fi --lang sl
cli-examples-dialog =
    ciklo dialog 412 --control tnc640 --lang fi
    ciklo dialog TCH PROBE 0 --control tnc320 --lang it --format json
cli-examples-block =
    ciklo block 200 Q201=-30 Q202=5 --control tnc640 --lang sl
    ciklo block CYCL DEF 7 --control tnc640 --lang fi --number 13
cli-examples-parse =
    ciklo parse part.h
    ciklo parse part.h --print > copy.h
cli-examples-check =
    ciklo check part.h --control tnc640
    ciklo check programs --control itnc530 --format sarif > findings.sarif
    ciklo check programs --fix
cli-examples-translate =
    ciklo translate part.h --to it > pezzo.h
    ciklo translate part.h --to pt --control tnc426-430 --out peca.h
    ciklo translate teil.h --to en --relabel
cli-examples-run =
    ciklo run part.h --control tnc640
    ciklo run part.h --control tnc640 --scene part.scene.yaml --out results
    ciklo run part.h --control tnc640 --scene part.scene.yaml --events
    ciklo run part.h --control tnc640 --scene part.scene.yaml --stock part.stl --resolution 0.2
    ciklo run part.h --control tnc640 --scene part.scene.yaml --envelope
cli-examples-conform =
    ciklo conform
    ciklo conform --control tnc640 --cycle 200 --case three-infeeds
    ciklo conform --cycle "TCH PROBE 412" --list
    ciklo conform --control tnc320 --format junit > conform.xml
    ciklo conform --engine "my-engine --jsonl" --time-limit 5
cli-examples-coverage =
    ciklo coverage
    ciklo coverage --format json
cli-examples-lint =
    ciklo lint
    ciklo lint --data . --format json
    ciklo lint --only 200
    ciklo lint --summary
    ciklo lint --accept-translations
cli-examples-schema =
    ciklo schema > cycle.schema.json
cli-examples-explain =
    ciklo explain locale-missing-text
    ciklo explain
cli-examples-export =
    ciklo export --control tnc640 --lang sl > tnc640.json

cli-summary = { $errors ->
        [0] { $warnings ->
            [0] { $notes ->
                [0] Brez ugotovitev.
               *[other] Brez napak in opozoril.
            }
            [one] Brez napak, { $warnings } opozorilo.
            [two] Brez napak, { $warnings } opozorili.
            [few] Brez napak, { $warnings } opozorila.
           *[other] Brez napak, { $warnings } opozoril.
        }
        [one] { $errors } napaka, { $warnings ->
            [one] { $warnings } opozorilo.
            [two] { $warnings } opozorili.
            [few] { $warnings } opozorila.
           *[other] { $warnings } opozoril.
        }
        [two] { $errors } napaki, { $warnings ->
            [one] { $warnings } opozorilo.
            [two] { $warnings } opozorili.
            [few] { $warnings } opozorila.
           *[other] { $warnings } opozoril.
        }
        [few] { $errors } napake, { $warnings ->
            [one] { $warnings } opozorilo.
            [two] { $warnings } opozorili.
            [few] { $warnings } opozorila.
           *[other] { $warnings } opozoril.
        }
       *[other] { $errors } napak, { $warnings ->
            [one] { $warnings } opozorilo.
            [two] { $warnings } opozorili.
            [few] { $warnings } opozorila.
           *[other] { $warnings } opozoril.
        }
    }
cli-written = Zapisano: { $path }
cli-building = Strani
cli-built = Strani: { $pages }, datotek: { $files }: { $path }
cli-coverage-control = { $control } ({ $title }): opisani cikli: { $described }, samo omenjeni: { $named }
cli-coverage-complete = popolno
cli-coverage-missing = { $language }: manjkajoča besedila: { $count } od { $of }: { $ids }
cli-coverage-stale = { $language }: zastarela besedila: { $count } od { $of }: { $ids }
cli-coverage-unexecuted = Povedi, ki jih ne izvede noben primer: { $count } od { $of }: { $ids }
cli-coverage-unprovoked = Preverjanja, ki jih ne sproži noben primer: { $ids }

cli-translated = { $count ->
        [one] { $count } sprememba: { $path }
        [two] { $count } spremembi: { $path }
        [few] { $count } spremembe: { $path }
       *[other] { $count } sprememb: { $path }
    }
cli-run-status = Program { $status ->
        [done] se je izvedel do konca
        [stopped] se je ustavil in se ni nadaljeval
        [limit] je dosegel mejo simulacije
        [unsupported] potrebuje funkcijo, ki je ni mogoče simulirati
       *[error] se je končal z napako
    }.
cli-envelope-cycle = Vrstica { $line }: { $cycle } { $name }
cli-envelope-still = Ni premika.
cli-envelope-lowest = Najnižja točka konice: { $axis } = { $height } mm
cli-envelope-highest = Najvišja točka konice: { $axis } = { $height } mm
cli-envelope-travelled = Višine premikov v obdelovalni ravnini: { $axis } = { $heights } mm
cli-envelope-probing = { $count ->
        [one] { $count } tipanje
        [two] { $count } tipanji
        [few] { $count } tipanja
       *[other] { $count } tipanj
    }, najdaljša pot { $length } mm
cli-envelope-near = { $what ->
        [stock] Surovec
       *[part] Telo { $number }
    }: najmanjša razdalja { $distance } mm, ko je konica pri X = { $x }, Y = { $y }, Z = { $z }; s tipanjem { $probed ->
        [yes] ga je mogoče doseči
       *[no] ga ni mogoče doseči
    }
cli-envelope-touches = { $what ->
        [stock] Surovec pred obdelavo: konica je v njem,
       *[part] Telo { $number }: TRK,
    } ko je konica pri X = { $x }, Y = { $y }, Z = { $z }
cli-envelope-near-unknown = { $what ->
        [stock] Surovec
       *[part] Telo { $number }
    }: najmanjše razdalje ni mogoče izračunati; s tipanjem { $probed ->
        [yes] ga je mogoče doseči
       *[no] ga ni mogoče doseči
    }
cli-envelope-fails = V tem prizorišču se cikel konča z napako { $code }: { $message }
cli-envelope-none = Program ne izvede nobenega cikla za tipanje.
cli-conform-pass = uspešno
cli-conform-fail = NAPAKA
cli-conform-out = ni podprto
cli-conform-skipped = izpuščeno
cli-conform-mismatch = { $what }: pričakovano { $expected }, dobljeno { $found }
cli-conform-summary = Uspešno: { $pass }, napake: { $fail }, ni podprto: { $out }, izpuščeno: { $skipped }.

cli-usage-hint = Morda { $suggestion }?
cli-usage-help = Glejte --help.

diag-unknown-software = »{ $found }« ni različica programske opreme: vnesite številko, ki jo prikaže krmiljenje, na primer 340590-05.
diag-usage = { $reason ->
        [no-value] { $subject } potrebuje vrednost.
        [invalid-value] »{ $value }« ni veljavna vrednost za { $subject }.
        [unknown-argument] Argument { $subject } ne obstaja.
        [unknown-command] Ukaz { $subject } ne obstaja.
        [no-command] Manjka ukaz.
        [missing-argument] Manjka: { $subject }.
        [conflict] Argument { $subject } je naveden dvakrat ali pa ga ni mogoče povezati z drugimi argumenti.
        [too-many-values] { $subject } ima preveč vrednosti.
        [not-text] Argument ni veljavno besedilo.
       *[other] Ukazna vrstica je napačna.
    } { $hint }
diag-io-read = { $path } ni mogoče prebrati: { $reason ->
        [not-found] ne obstaja
        [permission] ni dovoljenja
        [is-directory] to je mapa
        [not-directory] to ni mapa
        [link] je povezava do mape, ki se ji ne sledi
       *[other] { $detail }
    }.
diag-io-write = { $path } ni mogoče zapisati: { $reason ->
        [not-found] mapa ne obstaja
        [permission] ni dovoljenja
        [is-directory] to je mapa
        [not-directory] del poti ni mapa
        [full] prostora je zmanjkalo
        [read-only] datotečni sistem je samo za branje
        [too-large] datoteka ne sme biti tako velika
       *[other] { $detail }
    }.
diag-engine-start = Izvajalnika »{ $path }« ni mogoče zagnati: { $reason ->
        [not-found] program ne obstaja
        [permission] ni dovoljenja
       *[other] { $detail }
    }.
diag-engine-not-responding = Izvajalnik večkrat zapored ni odgovoril (število primerov: { $silent }), zato preostali niso bili poslani: { $left ->
        [one] { $left } primer.
        [two] { $left } primera.
        [few] { $left } primeri.
       *[other] { $left } primerov.
    }
diag-io-foreign-directory = V mapi { $path } so datoteke, ki jih Ciklo ni zapisal, zato ni bila zamenjana. Izberite prazno ali novo mapo.
diag-not-an-address = »{ $url }« ni naslov, ki se začne s https:// ali http://.
diag-data-directory-missing = V mapi { $path } manjka mapa { $name }.
diag-no-data = V mapi { $path } ni nobene od map cycle-specs, locales in templates.
diag-data-encoding = { $path } ni v kodiranju UTF-8.
diag-unknown-code = Koda »{ $code }« ne obstaja; »ciklo explain« izpiše vse.
diag-needs-data = { $option } potrebuje delovno kopijo: --data DIR.
diag-unknown-control = Krmiljenja »{ $control }« ni; krmiljenja so { $known }.
diag-unknown-language = Jezika »{ $language }« ni; jeziki so { $known }.
diag-cycle-name = »{ $cycle }« ni številka cikla; veljavna sta na primer 412 in "TCH PROBE 412".
diag-cycle-not-here = Krmiljenje { $control } nima cikla { $cycle }.
diag-cycle-ambiguous = Krmiljenje { $control } ima dva cikla s številko { $cycle }: { $keys }.
diag-cycle-only-named = Priročnik za { $control } cikel { $cycle } ({ $name }) omenja samo po imenu in ga ne opisuje.
diag-internal = Notranja napaka programa Ciklo: { $detail }.
diag-locale-unknown-suffix = »{ $name }« ni ne ime cikla ne krmiljenje.
diag-not-encodable = Znaka »{ $sign }« ni mogoče zapisati v kodiranju te datoteke (Windows-1252).
cli-examples-plot =
    ciklo plot part.h --control tnc640 --out part.svg
    ciklo plot part.h --control tnc640 --scene part.scene.yaml --view top --out path.svg
cli-arg-resolution = Največja razdalja med stolpci surovca, mm (privzeto: dvestotina njegove največje razsežnosti)
cli-plot = Nariše pot orodja in obdelovanec programa kot SVG
cli-plot-out = Datoteka za risbo
cli-plot-view = Smer pogleda: top, side, isometric (privzeto)
cli-run-stock = Datoteka za končani obdelovanec (STL), s poročilom o obdelavi
cli-stock-depth = Največja globina reza: { $value } mm (vrstica { $line })
cli-stock-finding = { $program }:{ $line }{ $count ->
        [one] :
        [two] {" "}({ $count } premika):
        [few] {" "}({ $count } premiki):
       *[other] {" "}({ $count } premikov):
    } { $kind ->
        [rapid-in-material] Hitri tek skozi { $amount } mm materiala.
        [spindle-stopped] Vreteno miruje, medtem ko se orodje giblje skozi { $amount } mm materiala.
        [edges-too-short] Material se reže do { $amount } mm nad konico orodja, kar je več, kot so dolga rezila.
        [turns-together] Rotacijske osi se med premikanjem orodja vrtijo: odvzeti material ni znan.
        [turned] Obdelovanec se struži, vendar ni rotacijsko telo okoli osi struženja ali pa je bil prej rezkan: kaj z njega odreže orodje { $amount }, se ne spremlja.
        [insert-unknown] Noben cikel ne pove, kako se ploščica orodja { $amount } dotika obdelovanca: odvzeti material ni znan.
        [thread-turned] Orodje { $amount } struži navoj, ki ni del spremljanega telesa.
       *[no-radius] Orodje { $amount } nima polmera: odvzeti material ni znan.
    }
cli-stock-length = Pot: { $feed } mm s pomikom, od tega { $cut } mm v premikih, ki odvzemajo material; { $rapid } mm v hitrem teku
cli-stock-more = { $count ->
        [one] Še { $count } ugotovitev.
        [two] Še { $count } ugotovitvi.
        [few] Še { $count } ugotovitve.
       *[other] Še { $count } ugotovitev.
    }
cli-stock-rate = Največja količina odrezanega materiala: { $value } mm³/min (vrstica { $line })
cli-stock-time = Čas: { $all } s; { $feed } s s pomikom, { $rapid } s v hitrem teku, { $dwell } s časa zadrževanja
cli-stock-volume = Prostornina: odvzetih { $removed } mm³ od { $blank } mm³
cli-stock-width = Največja širina reza: { $value } mm (vrstica { $line })
