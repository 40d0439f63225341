# Komentorivi: ohjelmien vertailu, tarkastus, korjaus ja asettelu.

cli-check-fail-on = Lievin havainto, jolla komento päättyy arvoon 1: error (oletus), warning, note
cli-compare = Todista, että kaksi ohjelmaa ovat ohjaukselle samat, tai näytä erot
cli-compare-a = NC-ohjelma
cli-compare-b = NC-ohjelma, johon sitä verrataan
cli-compare-control = Ohjelmien ohjaus (oletus: se, jonka työkiertoja ensimmäisessä on)
cli-compare-execute = Suorita molemmat asetelmassa ja vertaa tapahtumia
cli-examples-compare =
    ciklo compare part.h pezzo.h
    ciklo compare part.h pezzo.h --control tnc640 --execute --scene part.scene.yaml
cli-compared = { $count ->
        [0] Ohjelmat ovat samat NC-tekstejä, kommentteja, numerointia, tyhjiä merkkejä ja lukujen kirjoitusasua lukuun ottamatta.
        [one] Ohjelmat eroavat { $count } kohdassa.
       *[other] Ohjelmat eroavat { $count } kohdassa.
    }
cli-compare-executed =
    { $verdict ->
        [same] { $count ->
            [one] Suoritus tuottaa molemmissa saman { $count } tapahtuman.
           *[other] Suoritus tuottaa molemmissa samat { $count } tapahtumaa.
        }
        [different] Suoritus tuottaa eri tapahtumat.
       *[unproved] Suoritus tuottaa samat tapahtumat siltä osin kuin suoritin osaa suorittaa ohjelmat; loppua ei ole osoitettu.
    }

cli-check-path = NC-ohjelmat tai hakemistot, joiden ohjelmat (.h, .i) tarkastetaan; ”-” tarkoittaa vakiosyötettä
cli-check-control = Ohjelmien ohjaus, tunnettaessa ohjelmistoversioineen, esimerkiksi tnc640@340590-05 (oletus: ciklo.toml-tiedoston mukainen)
cli-check-config = Asetustiedosto (oletus: ciklo.toml kunkin ohjelman hakemistossa tai sen yläpuolella)
cli-check-table = Työkalu-, peruspiste- tai nollapistetaulukko, jonka rivejä ohjelmat käyttävät
cli-check-fix = Korjaa, minkä voi korjata muuttamatta ohjelman toimintaa: NC-tekstit ja kaksinkertaiset merkit
cli-check-no-cache = Tarkasta jokainen ohjelma uudelleen, myös ne, jotka eivät ole muuttuneet viime kerran jälkeen
cli-check-no-execution = Älä suorita ohjelmia, joiden kaikki työkalut tunnetaan, vaan lue ne vain
cli-check-format = Tulosteen muoto: text (oletus), json, sarif, github
cli-checking = Ohjelmia
cli-checked = Tarkastettuja ohjelmia: { $files }, { $wrong ->
        [0] joista missään ei ole virheitä.
       *[other] joista virheellisiä: { $wrong }.
    }
cli-fixed =
    { $count ->
        [0] Mitään ei korjattu.
        [one] Korjattiin { $count } kohta.
       *[other] Korjattiin { $count } kohtaa.
    }
diag-check-no-control = Ohjelman { $path } ohjausta ei tiedetä: nimeä se valitsimella --control tai asetuksella control tiedostossa ciklo.toml.
diag-check-no-programs = Paikassa { $path } ei ole ohjelmia: mitään ei tarkastettu.
diag-check-no-table = ”{ $path }” ei ole taulukko: sen pääte ei ole .T, .TP, .PR, .D eikä .PNT.
diag-passed-over = { $more ->
        [0] Ohitettiin { $path }:
        [one] Ohitettiin { $path } ja yksi muu kohde:
       *[other] Ohitettiin { $path } ja { $more } muuta kohdetta:
    } ei tiedosto eikä kansio, tai linkki, jota ei seurata.
diag-fix-no-file = Vakiosyötettä ei voi korjata paikallaan: nimeä tiedosto.
diag-fix-file-changed = Toinen ohjelma on sillä välin muuttanut tiedostoa { $path }; tiedostoon ei kirjoitettu.
diag-fix-changes-program = { $path } ei olisi enää sama ohjelma; tiedostoon ei kirjoitettu.
diag-config-syntax = Tämä ei ole kelvollista TOML-kieltä.
diag-config-unknown-key = Asetusta ”{ $key }” ei ole. Asetukset ovat control, lang, tables, fail-on, rules, machine ja folder.
diag-config-unknown-rule = Sääntöä ”{ $key }” ei ole; ”ciklo explain” luettelee kaikki.
diag-config-unknown-word = { $expected } ei kelpaa asetuksen { $key } arvoksi.
diag-config-value = Asetus { $key } vaatii tässä toisen arvon: { $expected }.
diag-allow-without-reason = Tämä kommentti sallii säännön { $rule } havainnon ilman syytä, joten kommentti ei vaikuta.
diag-allow-unknown-rule = Sääntöä ”{ $rule }” ei ole, joten sen havaintoa ei voi sallia.
diag-allow-unused = Sääntö { $rule } ei löydä tästä mitään; kommentin voi poistaa.

cli-translate-relabel = Pidä NC-tekstinä jokaista kommenttia, joka näyttää NC-tekstiltä, myös tuntemattomalla kielellä
cli-translate-encoding = Tiedoston merkistö, esimerkiksi windows-1250 (oletus: päätellään tavuista)
cli-translate-from = Ohjelman NC-tekstien kieli; vain ne korvataan (oletus: kukin määrittely omalla kielellään)
cli-translate-sources = { $count ->
        [one] NC-tekstien kieli ja määrittelyjen määrä: { $languages }.
       *[other] NC-tekstien kielet ja määrittelyjen määrät: { $languages }.
    }
cli-fmt = Asettele ohjelmia paikallaan: numerot, sarakkeet, etumerkit
cli-fmt-path = NC-ohjelmat tai kansiot, joiden ohjelmat (.h, .i) muotoillaan; ”-” lukee vakiosyötettä ja kirjoittaa vakiotulosteeseen
cli-fmt-check = Älä kirjoita mitään; nimeä ohjelmat, jotka muuttuisivat
cli-examples-fmt =
    ciklo fmt part.h
    ciklo fmt programs --check
cli-completions = Tulosta komentosarja, jolla komentotulkki täydentää komentorivin
cli-completions-shell = Komentotulkki: bash, elvish, fish, powershell, zsh
cli-examples-completions =
    ciklo completions bash > ~/.local/share/bash-completion/completions/ciklo
cli-man = Tulosta man-sivu englanniksi
cli-man-out = Hakemisto sivulle ja kunkin komennon omalle sivulle
cli-examples-man =
    ciklo man > ciklo.1
    ciklo man --out man1
cli-fmt-diff = Valitsimen --check kanssa: näytä, mikä muuttuisi
