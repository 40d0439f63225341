# Ukazna vrstica: primerjava, preverjanje, popravljanje in oblikovanje programov.

cli-check-fail-on = Najblažja ugotovitev, pri kateri se ukaz konča z 1: error (privzeto), warning, note
cli-compare = Dokaže, da sta programa za krmiljenje enaka, ali pokaže, v čem se razlikujeta
cli-compare-a = NC-program
cli-compare-b = NC-program, s katerim se primerja
cli-compare-control = Krmiljenje obeh programov (privzeto: tisto, katerega cikle vsebuje prvi)
cli-compare-execute = Oba izvede v prizorišču in primerja, kaj se zgodi
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
            [one] Zgodi se isto: { $count } dogodek.
            [two] Zgodi se isto: { $count } dogodka.
            [few] Zgodi se isto: { $count } dogodki.
           *[other] Zgodi se isto: { $count } dogodkov.
        }
        [different] Zgodi se nekaj drugega.
       *[unproved] Zgodi se isto, kolikor je programa mogoče izvesti; več ni dokazano.
    }

cli-check-path = NC-programi ali mape, katerih programi (.h, .i) se preverijo; »-« pomeni standardni vhod
cli-check-control = Krmiljenje programov, z različico programske opreme, če je znana, na primer tnc640@340590-05 (privzeto: tisto iz ciklo.toml)
cli-check-config = Datoteka z nastavitvami (privzeto: ciklo.toml v mapi vsakega programa ali nad njo)
cli-check-table = Preglednica orodij, prednastavitev ali ničelnih točk, katere vrstice uporabljajo programi
cli-check-fix = Popravi, kar je mogoče popraviti, ne da bi se delovanje programa spremenilo: oznake
cli-check-no-cache = Znova preveri vsak program, tudi tiste, ki se od zadnjič niso spremenili
cli-check-format = Oblika izpisa: text (privzeto), json, sarif, github
cli-checking = Programi
cli-checked = Preverjeni programi: { $files }, { $wrong ->
        [0] noben z napakami.
       *[other] z napakami: { $wrong }.
    }
cli-fixed = { $count ->
        [0] Nič ni bilo popravljeno.
        [one] Popravljena je { $count } oznaka.
        [two] Popravljeni sta { $count } oznaki.
        [few] Popravljene so { $count } oznake.
       *[other] Popravljenih je { $count } oznak.
    }
diag-check-no-control = Krmiljenje za { $path } ni znano: --control ali control v ciklo.toml.
diag-check-no-programs = V { $path } ni programov: nič ni bilo preverjeno.
diag-check-no-table = »{ $path }« ni preglednica: njena končnica ni .T, .TP, .PR, .D ali .PNT.
diag-passed-over = { $more ->
        [0] Preskočeno je bilo { $path }:
        [one] Preskočeno je bilo { $path } in še { $more } vnos:
        [two] Preskočeno je bilo { $path } in še { $more } vnosa:
        [few] Preskočeno je bilo { $path } in še { $more } vnosi:
       *[other] Preskočeno je bilo { $path } in še { $more } vnosov:
    } to ni datoteka ne mapa ali pa je povezava, ki se ji ne sledi.
diag-fix-no-file = Standardnega vhoda ni mogoče popraviti: navedite datoteko.
diag-fix-file-changed = { $path } je medtem spremenil nekdo drug; ostane, kakor je.
diag-fix-changes-program = { $path } ne bi bil več isti program; ostane, kakor je.
diag-config-syntax = To ni TOML.
diag-config-unknown-key = Nastavitve »{ $key }« ni; na voljo so control, lang, tables, fail-on, rules, machine in folder.
diag-config-unknown-rule = Pravila »{ $key }« ni; »ciklo explain« izpiše vsa.
diag-config-unknown-word = { $expected } ni nič, kar bi { $key } lahko bil.
diag-config-value = { $key } tu zahteva nekaj drugega: { $expected }.
diag-allow-without-reason = Ta komentar prekliče { $rule } brez razloga, zato ne učinkuje.
diag-allow-unknown-rule = Pravila »{ $rule }«, ki bi ga preklical, ni.
diag-allow-unused = { $rule } tu ničesar ne najde; komentar lahko odstranite.
explain-allow-without-reason = Komentar »; ciklo: allow PRAVILO razlog« prekliče ugotovitve pravila v stavku, za katerim stoji, v svoji vrstici pa v naslednjem stavku. Brez razloga nima učinka.
explain-allow-unknown-rule = Beseda za »allow« ni pravilo preverjanja in ne pogoj. ciklo explain izpiše vse kode.
explain-allow-unused = Komentar ničesar ne prekliče: pravilo v stavku, za katerega velja, ničesar ne najde, ali pa ne na tem krmiljenju.

cli-translate-relabel = Vse, kar ima obliko oznake, velja za oznako, tudi v jeziku, ki tu ni znan
cli-translate-encoding = Kodiranje datoteke, na primer windows-1250 (privzeto: ugotovljeno iz bajtov)
cli-translate-from = Jezik oznak programa; zamenjajo se samo te (privzeto: vsaka definicija v svojem jeziku)
cli-translate-sources = { $count ->
        [one] Jezik oznak s številom definicij: { $languages }.
       *[other] Jeziki oznak s številom definicij: { $languages }.
    }
cli-fmt = Oblikuje programe na njihovem mestu: številke, stolpci, predznaki
cli-fmt-path = NC-programi ali mape, katerih programi (.h, .i) se oblikujejo; »-« bere standardni vhod in piše na standardni izhod
cli-fmt-check = Ne zapiše ničesar; izpiše programe, ki bi se spremenili
cli-examples-fmt =
    ciklo fmt part.h
    ciklo fmt programs --check
cli-completions = Izpiše, kar lupina potrebuje za dopolnjevanje besed ukazne vrstice
cli-completions-shell = Lupina: bash, elvish, fish, powershell, zsh
cli-examples-completions =
    ciklo completions bash > ~/.local/share/bash-completion/completions/ciklo
cli-man = Izpiše stran za man v angleščini
cli-man-out = Mapa za stran in za stran vsakega ukaza
cli-examples-man =
    ciklo man > ciklo.1
    ciklo man --out man1
cli-fmt-diff = Z --check: prikaži, kaj bi se spremenilo
