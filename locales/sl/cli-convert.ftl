# Ukaz »convert« in njegova sporočila.
cli-convert = Prepiše programe za drugo krmiljenje oziroma v DIN/ISO ali Klartext
cli-convert-file = NC-programi; več le z --in-place
cli-convert-from = Krmiljenje, za katero so programi napisani
cli-convert-to = Krmiljenje, na katerem naj tečejo
cli-convert-form = Oblika ciklov, ki imajo dve: new (Q-parametri) ali old (vsaka vrstica je svoj stavek); privzeto: kakor v programu
cli-convert-out = Datoteka za zapis (privzeto: standardni izhod)
cli-convert-in-place = Stare programe nadomesti z novimi
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
diag-convert-iso-stays = »{ $found }« bi se spremenil, njegove nove oblike pa v DIN/ISO ni mogoče zapisati; stavek ni bil spremenjen.
diag-convert-iso-unread = Klartext nima ustreznice za »{ $found }«; stavek ni bil ne preverjen ne spremenjen.
diag-convert-cycle-not-on-control = Krmiljenje { $control } nima cikla { $cycle }; definicija ni bila spremenjena.
diag-convert-cycle-not-described = Priročnik za { $control } cikel { $cycle } omenja, a ga ne opisuje; njegovi parametri niso bili spremenjeni.
diag-convert-cycle-not-covered = Priročniki krmiljenja { $control }, ki jih Ciklo pozna, ciklov, kakršen je { $cycle }, ne obravnavajo; definicija ni bila spremenjena.
diag-convert-parameter-added =
    { $import ->
        [yes] V cikel { $cycle } je bil dodan { $parameter } = { $value }, kakor stori krmiljenje { $control } pri starejših programih: nastavite želeno vrednost.
       *[no] V cikel { $cycle } je bil dodan { $parameter } = { $value }; z njim deluje cikel enako kot prej.
    }
diag-convert-parameter-dropped =
    { $neutral ->
        [yes] { $parameter } = { $value } je bil iz cikla { $cycle } odstranjen: krmiljenje { $control } brez njega deluje enako.
       *[no] { $parameter } = { $value } je bil iz cikla { $cycle } odstranjen: krmiljenje { $control } ga nima.
    }
diag-convert-parameter-renamed = { $parameter } cikla { $cycle } na krmiljenju { $control } postane { $new }.
diag-convert-no-value = Cikel { $cycle } na krmiljenju { $control } potrebuje { $parameter }, ni pa znano, pri kateri vrednosti ostane obdelava nespremenjena.
diag-convert-value-refused = Krmiljenje { $control } v ciklu { $cycle } ne sprejme { $parameter } = { $value }; vrednost ni bila spremenjena.
diag-convert-value-differs-in-meaning = { $parameter } = { $value } v ciklu { $cycle } na krmiljenju { $control } pomeni nekaj drugega.
diag-convert-field-not-on-control = Polje { $parameter } cikla { $cycle } na krmiljenju { $control } ne obstaja; definicija ni bila spremenjena.
diag-convert-form = { $cycle } postane { $new }.
diag-convert-form-stays = Cikel { $cycle } obdrži svojo obliko: med njegovimi vrsticami so komentarji ali drugi stavki.
diag-convert-not-line-by-line = Cikel { $cycle } ni bil spremenjen: njegovi parametri niso vsak v svoji vrstici.
diag-convert-function-not-shown =
    { $function } ({ $count ->
        [one] { $count }-krat
        [two] { $count }-krat
        [few] { $count }-krat
       *[other] { $count }-krat
    }) ni spremenjeno: priročnik za { $control } tega ne prikazuje.
diag-convert-function-option = { $function } na krmiljenju { $control } zahteva programsko možnost { $option }.
