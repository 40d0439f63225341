# Komentorivi: ohje, ilmoitukset sekä tiedostoja ja sanoja koskevat havainnot.

cli-about = CNC-työkiertojen kuvaukset dialogeina, NC-lauseina, käsikirjoina, ohjelmien tarkastuksena ja suorituksena
cli-explain-more = ”ciklo explain { $code }” selittää havainnon ja kertoo, mitä sille voi tehdä.
cli-heading-usage = Käyttö:
cli-heading-commands = Komennot
cli-heading-arguments = Argumentit
cli-heading-options = Valitsimet
cli-heading-examples = Esimerkkejä:

cli-build = Kirjoita käsikirjat, dialogit ja NC-tekstien taulukot
cli-build-out = Hakemisto, johon kirjoitetaan; se korvataan vasta, kun kaikki on valmista (oletus: out)
cli-build-control = Vain tämä ohjaus; voidaan toistaa
cli-build-lang = Vain tämä kieli; voidaan toistaa
cli-build-base-url = Sivuston tuleva osoite: lisää kanoniset osoitteet, sivukartan ja absoluuttiset linkit tiedostoon 404.html
cli-schema = Tulosta kuvausten JSON-skeema
cli-lint = Ilmoita kaikki kuvausten ja kielten virheet
cli-lint-accept = Hyväksy käännökset, jotka ovat uusia tai joita on muutettu hyväksymisen jälkeen
cli-coverage = Näytä, mikä on valmista, puuttuu, on vanhentunut, toteuttamatta tai koettelematta
cli-dialog = Näytä työkierron dialogi
cli-block = Kirjoita työkierron NC-lause
cli-block-values = Työkierron numero sekä parametrien arvoja, esimerkiksi Q321=50; muilla on käsikirjan esimerkin arvot
cli-block-number = Ensimmäisen lauseen numero (oletus: käsikirjan esimerkin numero)
cli-block-form = Vanhanmuotoisen työkierron muoto, jos niitä on useita
cli-block-without = Pois jätettävä valinnainen kenttä; voidaan toistaa
cli-parse = Jaa ohjelma lauseiksi JSON-muotoon
cli-parse-print = Tulosta ohjelma muuttumattomana, tavu tavulta
cli-check = Tarkasta ohjelmia yhdelle ohjaukselle
cli-check-lang = Ohjelmien NC-tekstien kieli (oletus: päätellään)
cli-explain = Selitä havainnon koodi
cli-explain-code = Koodi; ilman sitä luetellaan kaikki koodit
cli-explain-renamed = Koodin ”{ $old }” nimi on nyt ”{ $code }”.
cli-translate = Kirjoita ohjelma toisen kielen nimillä ja NC-teksteillä; muu ei muutu
cli-translate-to = Nimien ja NC-tekstien kieli
cli-translate-control = Ohjelman ohjaus (oletus: päätellään työkierroista)
cli-translate-out = Kirjoitettava tiedosto (oletus: vakiotuloste)
cli-run = Suorita ohjelma asetelmassa
cli-run-tool-table = Työkalujen tai sorvaustyökalujen (.trn) taulukko asetelman oman sijasta; voidaan antaa kummallekin
cli-run-out = Hakemisto taulukoille ja pöytäkirjoille, jotka ohjelma kirjoittaa
cli-run-events = Tulosta jokainen tapahtuma JSON-rivinä
cli-run-skip-blocks = Ohita lauseet, jotka alkavat merkillä /
cli-run-lang = Pöytäkirjojen kieli (oletus: NC-ohjelman NC-tekstien kieli, muuten ohjelman omien tekstien kieli)
cli-run-envelope = Näytä tulosten asemesta, mitä kukin kosketustyökierto tekisi pahimmassa tapauksessa
cli-conform = Suorita kuvausten esimerkit
cli-conform-engine = Suorita esimerkit toisella suorittimella, komennolla, joka käyttää asiakirjan docs/conform-protocol.md protokollaa
cli-conform-time-limit = Pisin aika tapausta kohti sekunteina (oletus: 10)
cli-conform-serve = Vastaa tämän protokollan pyyntöihin vakiosyötteestä
cli-export = Tulosta ohjauksen kaikki työkierrot yhdellä kielellä JSON-muodossa

cli-arg-cycle = Työkierron numero, esimerkiksi 412 tai TCH PROBE 412
cli-arg-file = NC-ohjelma; ”-” tarkoittaa vakiosyötettä
cli-arg-control = Ohjaus, esimerkiksi tnc640
cli-arg-lang = Kieli, esimerkiksi fi (oletus: ohjelman omien tekstien kieli)
cli-arg-scene = Asetelmatiedosto: kone, työkalut, työkappale
cli-arg-format = Tulosteen muoto: text (oletus), json
cli-arg-report = Tulosteen muoto: text (oletus), json, junit
cli-arg-data = Hakemisto, jonka cycle-specs-, locales- ja templates-tietoja käytetään ohjelmaan sisältyvien sijasta
cli-arg-ui-lang = Ohjelman omien tekstien kieli (oletus: ympäristön kieli)
cli-arg-help = Näytä tämä ohje
cli-arg-version = Näytä versio

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
                [0] Ei havaintoja.
               *[other] Ei virheitä eikä varoituksia.
            }
            [one] Ei virheitä, { $warnings } varoitus.
           *[other] Ei virheitä, { $warnings } varoitusta.
        }
        [one] { $errors } virhe, { $warnings ->
            [one] { $warnings } varoitus.
           *[other] { $warnings } varoitusta.
        }
       *[other] { $errors } virhettä, { $warnings ->
            [one] { $warnings } varoitus.
           *[other] { $warnings } varoitusta.
        }
    }
cli-written = Kirjoitettu: { $path }
cli-building = Sivuja
cli-built = Sivuja { $pages }, tiedostoja { $files }: { $path }
cli-coverage-control = { $control } ({ $title }): työkiertoja kuvattu { $described }, vain mainittu { $named }
cli-coverage-complete = valmis
cli-coverage-missing = { $language }: tekstejä puuttuu { $count }/{ $of }: { $ids }
cli-coverage-stale = { $language }: vanhentuneita tekstejä { $count }/{ $of }: { $ids }
cli-coverage-unexecuted = Mikään esimerkki ei suorita: { $count }/{ $of } virkettä: { $ids }
cli-coverage-unprovoked = Mikään esimerkki ei laukaise: { $ids }

cli-translated = { $count ->
        [one] { $count } muutos: { $path }
       *[other] { $count } muutosta: { $path }
    }
cli-run-status =
    Ohjelma { $status ->
        [done] suoritettiin loppuun
        [stopped] pysähtyi, eikä sitä jatkettu
        [limit] saavutti simuloinnin rajan
        [unsupported] tarvitsee toiminnon, jota ei voi simuloida
       *[error] päättyi virheeseen
    }.
cli-envelope-cycle = Rivi { $line }: { $cycle } { $name }
cli-envelope-still = Ei liikettä.
cli-envelope-lowest = Kosketuspään alin kohta: { $axis } = { $height } mm
cli-envelope-highest = Kosketuspään ylin kohta: { $axis } = { $height } mm
cli-envelope-travelled = Koneistustason liikkeiden korkeudet: { $axis } = { $heights }{"\u00A0"}mm
cli-envelope-probing = { $count ->
        [one] { $count } kosketus
       *[other] { $count } kosketusta
    }, pisin liikepituus { $length } mm
cli-envelope-near = { $what ->
        [stock] Aihio
       *[part] Kappale { $number }
    }: lähimmillään { $distance } mm:n päässä, kun kosketuspää on kohdassa X = { $x }, Y = { $y }, Z = { $z }; kosketusliike { $probed ->
        [yes] voi ulottua
       *[no] ei ulotu
    } siihen
cli-envelope-touches = { $what ->
        [stock] Aihio ennen koneistusta: kosketuspää on sen sisällä,
       *[part] Kappale { $number }: TÖRMÄYS,
    } kun kosketuspää on kohdassa X = { $x }, Y = { $y }, Z = { $z }
cli-envelope-near-unknown = { $what ->
        [stock] Aihio
       *[part] Kappale { $number }
    }: etäisyyttä ei voida laskea; kosketusliike { $probed ->
        [yes] voi ulottua
       *[no] ei ulotu
    } siihen
cli-envelope-fails = Tässä asetelmassa työkierto päättyy virheeseen { $code }: { $message }
cli-envelope-none = Ohjelma ei suorita yhtään kosketustyökiertoa.
cli-conform-pass = läpi
cli-conform-fail = VIRHE
cli-conform-out = ei tuettu
cli-conform-skipped = ohitettu
cli-conform-mismatch = { $what }: odotettiin { $expected }, saatiin { $found }
cli-conform-summary = Läpi { $pass }, virheellisiä { $fail }, ei tuettuja { $out }, ohitettuja { $skipped }.

cli-usage-hint = Tarkoititko: { $suggestion }?
cli-usage-help = Katso --help.

diag-unknown-software = ”{ $found }” ei ole ohjelmistoversio: anna ohjauksen näyttämä numero, esimerkiksi 340590-05.
diag-usage =
    { $reason ->
        [no-value] { $subject } tarvitsee arvon.
        [invalid-value] ”{ $value }” ei ole kelvollinen arvo: { $subject }.
        [unknown-argument] Argumenttia { $subject } ei ole.
        [unknown-command] Komentoa { $subject } ei ole.
        [no-command] Komento puuttuu.
        [missing-argument] Puuttuu: { $subject }.
        [conflict] { $subject } on annettu kahdesti, tai sitä ei voi yhdistää muihin argumentteihin.
        [too-many-values] Liian monta arvoa: { $subject }.
        [not-text] Argumentti ei ole kelvollista tekstiä.
       *[other] Komentorivi on virheellinen.
    } { $hint }
diag-io-read = Lukeminen ei onnistu: { $path }: { $reason ->
        [not-found] kohdetta ei ole
        [permission] ei käyttöoikeutta
        [is-directory] kohde on hakemisto
        [not-directory] kohde ei ole hakemisto
        [link] se on linkki hakemistoon eikä sitä seurata
       *[other] { $detail }
    }.
diag-io-write = Kirjoittaminen ei onnistu: { $path }: { $reason ->
        [not-found] hakemistoa ei ole
        [permission] ei käyttöoikeutta
        [is-directory] kohde on hakemisto
        [not-directory] polun osa ei ole hakemisto
        [full] tila on loppunut
        [read-only] tiedostojärjestelmä on vain luettavissa
        [too-large] tiedosto ei saa olla niin suuri
       *[other] { $detail }
    }.
diag-engine-start = Suorittimen käynnistäminen ei onnistu: { $path }: { $reason ->
        [not-found] ohjelmaa ei ole
        [permission] ei käyttöoikeutta
       *[other] { $detail }
    }.
diag-engine-not-responding = Suoritin ei vastannut { $silent } peräkkäiseen tapaukseen, joten loppuja ei lähetetä: { $left ->
        [one] { $left } tapaus.
       *[other] { $left } tapausta.
    }
diag-io-foreign-directory = Hakemistossa { $path } on tiedostoja, joita Ciklo ei ole kirjoittanut, joten sitä ei korvata. Valitse tyhjä tai uusi hakemisto.
diag-not-an-address = ”{ $url }” ei ole osoite, jonka alussa on https:// tai http://.
diag-data-directory-missing = Hakemistosta { $path } puuttuu hakemisto { $name }.
diag-no-data = Hakemistossa { $path } ei ole hakemistoja cycle-specs, locales eikä templates.
diag-data-encoding = { $path } ei ole UTF-8-muodossa.
diag-unknown-code = Koodia ”{ $code }” ei ole; ”ciklo explain” luettelee kaikki.
diag-needs-data = { $option } tarvitsee työkopion: --data DIR.
diag-unknown-control = Ohjausta ”{ $control }” ei ole; ohjaukset ovat { $known }.
diag-unknown-language = Kieltä ”{ $language }” ei ole; kielet ovat { $known }.
diag-cycle-name = ”{ $cycle }” ei ole työkierron numero; kelvollisia ovat esimerkiksi 412 ja "TCH PROBE 412".
diag-cycle-not-here = Ohjauksessa { $control } ei ole työkiertoa { $cycle }.
diag-cycle-ambiguous = Ohjauksessa { $control } on kaksi työkiertoa, joiden numero on { $cycle }: { $keys }.
diag-cycle-only-named = Ohjauksen { $control } käsikirja vain mainitsee työkierron { $cycle } ({ $name }) nimeltä eikä kuvaa sitä.
diag-internal = Ciklon sisäinen virhe: { $detail }.
diag-locale-unknown-suffix = ”{ $name }” ei ole työkierron nimi eikä ohjaus.
diag-not-encodable = Merkkiä ”{ $sign }” ei voi kirjoittaa tämän tiedoston merkistöllä (Windows-1252).
cli-examples-plot =
    ciklo plot part.h --control tnc640 --out part.svg
    ciklo plot part.h --control tnc640 --scene part.scene.yaml --view top --out path.svg
cli-arg-resolution = Aihion sarakkeiden suurin väli, mm (oletus: kahdessadasosa suurimmasta ulottuvuudesta)
cli-plot = Piirrä ohjelman työkalun rata ja kappale SVG-kuvana
cli-plot-out = Piirroksen tiedosto
cli-plot-view = Katselusuunta: top, side, isometric (oletus)
cli-run-stock = Valmiin kappaleen tiedosto (STL); lisäksi raportti koneistuksesta
cli-stock-depth = Suurin lastuamissyvyys: { $value } mm (rivi { $line })
cli-stock-finding = { $program }:{ $line }{ $count ->
        [one] :
       *[other] {" "}({ $count } liikettä):
    } { $kind ->
        [rapid-in-material] Pikaliike { $amount } mm:n matkan materiaalin läpi.
        [spindle-stopped] Kara on pysähdyksissä, kun työkalu kulkee { $amount } mm:n matkan materiaalin läpi.
        [edges-too-short] Materiaalia lastutaan { $amount } mm kärjen yläpuolelle asti, enemmän kuin terien pituus on.
        [turns-together] Akselit kääntyvät työkalun liikkuessa: poistettua materiaalia ei tunneta.
        [turned] Työkappaletta sorvataan, mutta se ei ole sorvausakselin suhteen pyörähdyskappale tai sitä on jyrsitty aiemmin: työkalun { $amount } poistamaa materiaalia ei seurata.
        [insert-unknown] Mikään työkierto ei kerro, miten työkalun { $amount } terä osuu työkappaleeseen: poistettua materiaalia ei tunneta.
        [thread-turned] Työkalu { $amount } sorvaa kierteen, jota seurattava kappale ei sisällä.
       *[no-radius] Työkalulla { $amount } ei ole sädettä: ei tiedetä, mitä se poistaa.
    }
cli-stock-length = Matka: { $feed }{"\u00A0"}mm syöttöarvolla, siitä { $cut }{"\u00A0"}mm materiaalia poistavissa liikkeissä; { $rapid }{"\u00A0"}mm pikaliikkeellä
cli-stock-more = { $count ->
        [one] vielä { $count } havainto.
       *[other] vielä { $count } havaintoa.
    }
cli-stock-rate = Suurin lastunpoistonopeus: { $value } mm³/min (rivi { $line })
cli-stock-time = Aika: { $all }{"\u00A0"}s; { $feed }{"\u00A0"}s syöttöarvolla, { $rapid }{"\u00A0"}s pikaliikkeellä, { $dwell }{"\u00A0"}s odotusaikaa
cli-stock-volume = Tilavuus: poistettu { $removed }{"\u00A0"}mm³, aihio { $blank }{"\u00A0"}mm³
cli-stock-width = Suurin lastuamisleveys: { $value } mm (rivi { $line })
