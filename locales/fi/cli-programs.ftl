# Komentorivi: ohjelmien vertailu, tarkastus, korjaus ja asettelu.

cli-check-fail-on = Lievin havainto, jolla komento päättyy arvoon 1: error (oletus), warning, note
cli-compare = Todista, että kaksi ohjelmaa ovat ohjaukselle samat, tai näytä erot
cli-compare-a = NC-ohjelma
cli-compare-b = NC-ohjelma, johon sitä verrataan
cli-compare-control = Ohjelmien ohjaus (oletus: se, jonka työkiertoja ensimmäisessä on)
cli-compare-execute = Suorita molemmat asetelmassa ja vertaa, mitä tapahtuu
cli-examples-compare =
    ciklo compare part.h pezzo.h
    ciklo compare part.h pezzo.h --control tnc640 --execute --scene part.scene.yaml
cli-compared = { $count ->
        [0] Ohjelmat ovat samat NC-tekstejä, kommentteja, numerointia, tyhjiä merkkejä ja lukujen kirjoitusasua lukuun ottamatta.
        [one] Ohjelmat eroavat { $count } kohdassa.
       *[other] Ohjelmat eroavat { $count } kohdassa.
    }
cli-compare-executed = { $verdict ->
        [same] { $count ->
            [one] Tapahtuu sama: { $count } tapahtuma.
           *[other] Tapahtuu sama: { $count } tapahtumaa.
        }
        [different] Tapahtuu jotakin muuta.
       *[unproved] Tapahtuu sama niiltä osin kuin ohjelmat voidaan suorittaa; enempää ei ole todistettu.
    }

cli-check-path = NC-ohjelmat tai hakemistot, joiden ohjelmat (.h, .i) tarkastetaan; ”-” tarkoittaa vakiosyötettä
cli-check-control = Ohjelmien ohjaus, tunnettaessa ohjelmistoversioineen, esimerkiksi tnc640@340590-05 (oletus: ciklo.toml-tiedoston mukainen)
cli-check-config = Asetustiedosto (oletus: ciklo.toml kunkin ohjelman hakemistossa tai sen yläpuolella)
cli-check-table = Työkalu-, peruspiste- tai nollapistetaulukko, jonka rivejä ohjelmat käyttävät
cli-check-fix = Korjaa, minkä voi korjata muuttamatta ohjelman toimintaa: NC-tekstit
cli-check-no-cache = Tarkasta jokainen ohjelma uudelleen, myös ne, jotka eivät ole muuttuneet viime kerran jälkeen
cli-check-format = Tulosteen muoto: text (oletus), json, sarif, github
cli-checking = Ohjelmia
cli-checked = Tarkastettuja ohjelmia: { $files }, { $wrong ->
        [0] joista missään ei ole virheitä.
       *[other] joista virheellisiä: { $wrong }.
    }
cli-fixed = { $count ->
        [0] Mitään ei korjattu.
        [one] Korjattiin { $count } NC-teksti.
       *[other] Korjattiin { $count } NC-tekstiä.
    }
diag-check-no-control = Ohjelman { $path } ohjaus ei ole tiedossa: --control tai control tiedostossa ciklo.toml.
diag-check-no-programs = Paikassa { $path } ei ole ohjelmia: mitään ei tarkastettu.
diag-check-no-table = ”{ $path }” ei ole taulukko: sen tarkenne ei ole .T, .TP, .PR, .D eikä .PNT.
diag-passed-over = { $more ->
        [0] Ohitettiin { $path }:
        [one] Ohitettiin { $path } ja yksi muu kohde:
       *[other] Ohitettiin { $path } ja { $more } muuta kohdetta:
    } ei tiedosto eikä kansio, tai linkki, jota ei seurata.
diag-fix-no-file = Vakiosyötettä ei voi korjata: nimeä tiedosto.
diag-fix-file-changed = Joku muu on muuttanut tiedostoa { $path } sillä välin; se jätetään ennalleen.
diag-fix-changes-program = { $path } ei olisi enää sama ohjelma; se jätetään ennalleen.
diag-config-syntax = Tämä ei ole TOML-muotoa.
diag-config-unknown-key = Asetusta ”{ $key }” ei ole; asetukset ovat control, lang, tables, fail-on, rules, machine ja folder.
diag-config-unknown-rule = Sääntöä ”{ $key }” ei ole; ”ciklo explain” luettelee kaikki.
diag-config-unknown-word = { $expected } ei kelpaa kohtaan { $key }.
diag-config-value = Tässä { $key } vaatii jotakin muuta: { $expected }.
diag-allow-without-reason = Tämä kommentti kumoaa säännön { $rule } ilman perustelua, joten se ei vaikuta.
diag-allow-unknown-rule = Sääntöä ”{ $rule }” ei ole, joten sitä ei voi kumota.
diag-allow-unused = Sääntö { $rule } ei löydä tästä mitään; kommentin voi poistaa.
explain-allow-without-reason = Kommentti ”; ciklo: allow SÄÄNTÖ perustelu” kumoaa säännön havainnot siinä lauseessa, jonka perässä se on, tai omalla rivillään seuraavassa lauseessa. Ilman perustelua se ei vaikuta.
explain-allow-unknown-rule = Sanan ”allow” jäljessä ei ole tarkastimen sääntöä eikä ehtoa. ciklo explain luettelee kaikki koodit.
explain-allow-unused = Kommentti ei kumoa mitään: sääntö ei löydä mitään lauseesta, jota kommentti koskee, tai ei tällä ohjauksella.

cli-translate-relabel = Pidä NC-tekstinä kaikkea, millä on sen muoto, myös muulla kuin tunnetulla kielellä
cli-translate-encoding = Tiedoston merkistö, esimerkiksi windows-1250 (oletus: päätellään tavuista)
cli-translate-from = Ohjelman NC-tekstien kieli; vain ne korvataan (oletus: kukin määrittely omalla kielellään)
cli-translate-sources = { $count ->
        [one] NC-tekstien kieli ja määrittelyjen määrä: { $languages }.
       *[other] NC-tekstien kielet ja määrittelyjen määrät: { $languages }.
    }
cli-fmt = Asettele ohjelmia paikallaan: numerot, sarakkeet, etumerkit
cli-fmt-path = NC-ohjelmat tai hakemistot, joiden ohjelmat (.h, .i) asetellaan; ”-” tarkoittaa vakiosyötettä ja vakiotulostetta
cli-fmt-check = Älä kirjoita mitään; nimeä ohjelmat, jotka muuttuisivat
cli-examples-fmt =
    ciklo fmt part.h
    ciklo fmt programs --check
cli-completions = Tulosta, mitä komentotulkki tarvitsee komentorivin täydentämiseen
cli-completions-shell = Komentotulkki: bash, elvish, fish, powershell, zsh
cli-examples-completions =
    ciklo completions bash > ~/.local/share/bash-completion/completions/ciklo
cli-man = Tulosta man-sivu englanniksi
cli-man-out = Hakemisto sivulle ja kunkin komennon omalle sivulle
cli-examples-man =
    ciklo man > ciklo.1
    ciklo man --out man1
cli-fmt-diff = Valitsimen --check kanssa: näytä, mikä muuttuisi
