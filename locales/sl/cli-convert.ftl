# Ukaz »convert« in njegova sporočila.
cli-convert = Prepiše programe za drugo krmiljenje oziroma v DIN/ISO ali Klartext
cli-convert-file = NC-programi; več le z --in-place
cli-convert-from = Krmiljenje, za katero so programi napisani
cli-convert-to = Krmiljenje, na katerem naj tečejo
cli-convert-form = Oblika ciklov, ki imajo dve: new (Q-parametri) ali old (vsaka vrstica je svoj stavek); privzeto: kakor v programu
cli-convert-out = Datoteka za zapis (privzeto: standardni izhod)
cli-convert-in-place = Stare programe zamenja z novimi
cli-converted = { $count ->
        [one] { $count } prepisana definicija: { $path }
        [two] { $count } prepisani definiciji: { $path }
        [few] { $count } prepisane definicije: { $path }
       *[other] { $count } prepisanih definicij: { $path }
    }
cli-examples-convert =
    ciklo convert part.h --from tnc426-430 --to tnc640 > new.h
    ciklo convert part.h --from tnc640 --to tnc320 --format json
    ciklo convert measuring.h --from itnc530 --to itnc530 --form new --in-place
    ciklo convert part.h --to-iso > part.i
    ciklo convert part.i --to-klartext --lang it --out pezzo.h
diag-convert-one-file = Več programov je mogoče prepisati le z --in-place.
diag-convert-iso-stays = »{ $found }« bi se spremenil, nove oblike pa v DIN/ISO ni mogoče zapisati; stavek ostane, kakor je bil.
diag-convert-iso-unread = Klartext nima ustreznice za »{ $found }«; stavek ostane, kakor je bil, in se ne pregleda.
diag-convert-cycle-not-on-control = Krmiljenje { $control } nima cikla { $cycle }; definicija ostane, kakor je.
diag-convert-cycle-not-described = Priročnik za { $control } cikel { $cycle } omenja, a ga ne opisuje: parametri ostanejo, kakor so.
diag-convert-cycle-not-covered = Priročniki krmiljenja { $control }, ki so tu znani, ciklov, kakršen je { $cycle }, ne obravnavajo: definicija ostane, kakor je.
diag-convert-parameter-added =
    { $import ->
        [yes] V cikel { $cycle } je dodan { $parameter } = { $value }, kakor stori krmiljenje { $control } pri starejših programih: nastavite želeno vrednost.
       *[no] V cikel { $cycle } je dodan { $parameter } = { $value }, ki delovanja ne spremeni.
    }
diag-convert-parameter-dropped =
    { $neutral ->
        [yes] { $parameter } = { $value } se iz cikla { $cycle } izpusti: krmiljenje { $control } brez njega deluje enako.
       *[no] { $parameter } = { $value } se iz cikla { $cycle } izpusti: krmiljenje { $control } ga nima.
    }
diag-convert-parameter-renamed = { $parameter } cikla { $cycle } na krmiljenju { $control } postane { $new }.
diag-convert-no-value = Cikel { $cycle } na krmiljenju { $control } potrebuje { $parameter }, ni pa znano, pri kateri vrednosti deluje enako.
diag-convert-value-refused = Krmiljenje { $control } v ciklu { $cycle } ne sprejme { $parameter } = { $value }; vrednost ostane, kakor je.
diag-convert-value-differs-in-meaning = { $parameter } = { $value } v ciklu { $cycle } na krmiljenju { $control } pomeni nekaj drugega.
diag-convert-field-not-on-control = Polje { $parameter } cikla { $cycle } na krmiljenju { $control } ne obstaja; definicija ostane, kakor je.
diag-convert-form = { $cycle } postane { $new }.
diag-convert-form-stays = Cikel { $cycle } ostane v svoji obliki: med njegovimi vrsticami so komentarji ali drugi stavki.
diag-convert-not-line-by-line = Cikel { $cycle } ostane, kakor je: njegovi parametri niso vsak v svoji vrstici.
diag-convert-function-not-shown =
    { $function } ({ $count ->
        [one] { $count }-krat
        [two] { $count }-krat
        [few] { $count }-krat
       *[other] { $count }-krat
    }) ostane, kakor je: priročnik za { $control } tega ne prikazuje.
diag-convert-function-option = { $function } na krmiljenju { $control } zahteva programsko možnost { $option }.
