# Ukaz »convert« in njegova sporočila.
cli-convert = Prepiše programe za drugo krmiljenje ali v DIN/ISO ali Klartext
cli-convert-file = NC-programi; več le z --in-place
cli-convert-from = Krmiljenje, za katero so programi napisani
cli-convert-to = Krmiljenje, na katerem naj tečejo
cli-convert-form = Oblika ciklov, ki imajo dve: new (parametri Q) ali old (stavek na vrstico); privzeto: kakor v programu
cli-convert-out = Datoteka za zapis (privzeto: standardni izhod)
cli-convert-in-place = Nove programe zapiše na mesto starih
cli-converted = { $count ->
        [one] { $count } prepisana definicija: { $path }
        [two] { $count } prepisani definiciji: { $path }
        [few] { $count } prepisane definicije: { $path }
       *[other] { $count } prepisanih definicij: { $path }
    }
cli-examples-convert =
    ciklo convert kos.h --from tnc426-430 --to tnc640 > nov.h
    ciklo convert kos.h --from tnc640 --to tnc320 --format json
    ciklo convert merjenje.h --from itnc530 --to itnc530 --form new --in-place
    ciklo convert part.h --to-iso > part.i
    ciklo convert part.i --to-klartext --lang it --out pezzo.h
diag-convert-one-file = Več programov se prepiše le z --in-place.
diag-convert-klartext-first = { $path } je v DIN/ISO: najprej ga zapišite v Klartextu (--to-klartext).
diag-convert-cycle-lacking = Krmiljenje { $control } nima cikla { $cycle }; definicija ostane, kakor je.
diag-convert-cycle-not-described = Priročnik za { $control } cikel { $cycle } omenja, a ga ne opisuje: parametri ostanejo, kakor so.
diag-convert-parameter-added =
    { $import ->
        [yes] V cikel { $cycle } je dodan { $parameter } = { $value }, kakor stori { $control } pri starejših programih: nastavite želeno vrednost.
       *[no] V cikel { $cycle } je dodan { $parameter } = { $value }, ki delovanja ne spremeni.
    }
diag-convert-parameter-dropped =
    { $neutral ->
        [yes] { $parameter } = { $value } v ciklu { $cycle } odpade: { $control } brez njega deluje enako.
       *[no] { $parameter } = { $value } v ciklu { $cycle } odpade: { $control } ga nima.
    }
diag-convert-parameter-renamed = { $parameter } cikla { $cycle } je na krmiljenju { $control } { $new }.
diag-convert-no-value = Cikel { $cycle } na krmiljenju { $control } potrebuje { $parameter }, ni pa znano, katera vrednost ohrani delovanje.
diag-convert-value-refused = Krmiljenje { $control } v ciklu { $cycle } ne sprejme { $parameter } = { $value }; vrednost ostane.
diag-convert-value-means-else = { $parameter } = { $value } v ciklu { $cycle } na krmiljenju { $control } pomeni nekaj drugega.
diag-convert-field-lacking = { $parameter } cikla { $cycle } na krmiljenju { $control } ne obstaja; definicija ostane, kakor je.
diag-convert-form = { $cycle } postane { $new }.
diag-convert-form-stays = Cikel { $cycle } ostane v svoji obliki: med njegovimi vrsticami so komentarji ali drugi stavki.
diag-convert-not-line-by-line = Cikel { $cycle } ostane, kakor je: njegovi parametri niso vsak v svoji vrstici.
