# Ukazna vrstica: primerjava, preverjanje, popravljanje in oblikovanje programov.

cli-check-fail-on = Najblažja ugotovitev, pri kateri se ukaz konča z izhodno kodo 1: error (privzeto), warning, note
cli-compare = Dokaže, da sta programa za krmiljenje enaka, ali pokaže, v čem se razlikujeta
cli-compare-a = NC-program
cli-compare-b = NC-program, s katerim se primerja
cli-compare-control = Krmiljenje obeh programov (privzeto: tisto, h kateremu sodijo cikli prvega)
cli-compare-execute = Oba izvede v prizorišču in primerja dogodke
cli-examples-compare =
    ciklo compare part.h pezzo.h
    ciklo compare part.h pezzo.h --control tnc640 --execute --scene part.scene.yaml
cli-compared = { $count ->
        [0] Programa sta enaka, razen v oznakah, komentarjih, številčenju, praznem prostoru in zapisu števil.
        [one] Programa se razlikujeta na { $count } mestu.
        [two] Programa se razlikujeta na { $count } mestih.
        [few] Programa se razlikujeta na { $count } mestih.
       *[other] Programa se razlikujeta na { $count } mestih.
    }
cli-compare-executed = { $verdict ->
        [same] { $count ->
            [one] Izvajanje da v obeh isti { $count } dogodek.
            [two] Izvajanje da v obeh ista { $count } dogodka.
            [few] Izvajanje da v obeh iste { $count } dogodke.
           *[other] Izvajanje da v obeh istih { $count } dogodkov.
        }
        [different] Izvajanje da različne dogodke.
       *[unproved] Izvajanje da iste dogodke, kolikor je programa mogoče izvesti; preostalo ni dokazano.
    }

cli-check-path = NC-programi ali mape, katerih programi (.h, .i) se preverijo; »-« pomeni standardni vhod
cli-check-control = Krmiljenje programov, z različico programske opreme, če je znana, na primer tnc640@340590-05 (privzeto: tisto iz ciklo.toml)
cli-check-config = Datoteka z nastavitvami (privzeto: ciklo.toml v mapi vsakega programa ali nad njo)
cli-check-table = Preglednica orodij, prednastavitev ali ničelnih točk, katere vrstice uporabljajo programi
cli-check-fix = Popravi, kar je mogoče popraviti, ne da bi se spremenilo delovanje programa: oznake in podvojene predznake
cli-check-no-cache = Znova preveri vsak program, tudi tiste, ki se od zadnjič niso spremenili
cli-check-no-execution = Programov, katerih orodja so vsa znana, ne izvede, temveč jih samo prebere
cli-check-format = Oblika izpisa: text (privzeto), json, sarif, github
cli-checking = Programi
cli-checked = Preverjeni programi: { $files }, { $wrong ->
        [0] noben z napakami.
       *[other] z napakami: { $wrong }.
    }
cli-fixed = { $count ->
        [0] Nič ni bilo popravljeno.
        [one] Popravljeno je { $count } mesto.
        [two] Popravljeni sta { $count } mesti.
        [few] Popravljena so { $count } mesta.
       *[other] Popravljenih je { $count } mest.
    }
diag-check-no-control = Krmiljenje za { $path } ni znano: navedite ga z --control ali s control v ciklo.toml.
diag-check-no-programs = V { $path } ni programov: nič ni bilo preverjeno.
diag-check-no-table = »{ $path }« ni preglednica: njena končnica ni .T, .TP, .PR, .D ali .PNT.
diag-passed-over = { $more ->
        [0] Preskočeno je bilo { $path }:
        [one] Preskočeno je bilo { $path } in še { $more } vnos:
        [two] Preskočeno je bilo { $path } in še { $more } vnosa:
        [few] Preskočeno je bilo { $path } in še { $more } vnosi:
       *[other] Preskočeno je bilo { $path } in še { $more } vnosov:
    } to ni datoteka ne mapa ali pa je povezava, ki se ji ne sledi.
diag-fix-no-file = Standardnega vhoda ni mogoče popraviti na mestu: navedite datoteko.
diag-fix-file-changed = Datoteko { $path } je medtem spremenil drug program; ni bila zapisana.
diag-fix-changes-program = { $path } ne bi bil več isti program; datoteka ni bila zapisana.
diag-config-syntax = To ni veljaven TOML.
diag-config-unknown-key = Nastavitve »{ $key }« ni. Nastavitve so control, lang, tables, fail-on, rules, machine in folder.
diag-config-unknown-rule = Pravila »{ $key }« ni; »ciklo explain« izpiše vsa.
diag-config-unknown-word = { $expected } ni mogoča vrednost nastavitve { $key }.
diag-config-value = { $key } tu zahteva drugo vrednost: { $expected }.
diag-allow-without-reason = Ta komentar dovoljuje { $rule } brez razloga, zato nima učinka.
diag-allow-unknown-rule = Pravila »{ $rule }«, ki bi ga bilo mogoče dovoliti, ni.
diag-allow-unused = { $rule } tu ničesar ne najde; komentar lahko izbrišete.

cli-translate-relabel = Vsak komentar, ki je videti kot oznaka, velja za oznako, tudi v neznanem jeziku
cli-translate-encoding = Kodiranje datoteke, na primer windows-1250 (privzeto: ugotovljeno iz bajtov)
cli-translate-from = Jezik oznak programa; zamenjajo se samo te (privzeto: vsaka definicija v svojem jeziku)
cli-translate-sources = { $count ->
        [one] Jezik oznak s številom definicij: { $languages }.
        [two] Jezika oznak s številom definicij: { $languages }.
        [few] Jeziki oznak s številom definicij: { $languages }.
       *[other] Jeziki oznak s številom definicij: { $languages }.
    }
cli-fmt = Oblikuje programe na njihovem mestu: številke, stolpci, predznaki
cli-fmt-path = NC-programi ali mape, katerih programi (.h, .i) se oblikujejo; »-« bere standardni vhod in piše na standardni izhod
cli-fmt-check = Ne zapiše ničesar; izpiše programe, ki bi se spremenili
cli-examples-fmt =
    ciklo fmt part.h
    ciklo fmt programs --check
cli-completions = Izpiše skript, ki v lupini dopolnjuje ukazno vrstico
cli-completions-shell = Lupina: bash, elvish, fish, powershell, zsh
cli-examples-completions =
    ciklo completions bash > ~/.local/share/bash-completion/completions/ciklo
cli-man = Izpiše stran za man v angleščini
cli-man-out = Mapa za stran in za stran vsakega ukaza
cli-examples-man =
    ciklo man > ciklo.1
    ciklo man --out man1
cli-fmt-diff = Z --check: prikaže, kaj bi se spremenilo
