diag-texts-nothing-chosen = Navedite, kaj naj se potrdi: --text KEY, --changed ali --all.
diag-texts-unknown-key = Noben prevod nima besedila s ključem »{ $key }«.
diag-locale-same-as-source = Besedilo »{ $key }« v jeziku »{ $language }« je enako angleškemu.
diag-texts-no-file = »texts import« potrebuje datoteko, ki naj se prebere.
diag-texts-no-language = »{ $language }« ni jezik, v katerega se prevaja; navedite ga z --to, na primer »--to fi«.
diag-texts-file-unreadable = Datoteke ni mogoče prebrati: { $reason ->
        [document-type] tipi dokumentov in lastne entitete niso dovoljeni
        [entity] vsebuje neznano entiteto
        [encoding] kodiranje ni UTF-8
        [depth] elementi so pregloboko gnezdeni
        [columns] v preglednici manjkata stolpca concept in language
        [empty] datoteka je prazna
        [quote] tu se začne celica v narekovajih, ki se ne konča
        [size] je večja od 64 MB
        [xliff] to ni ne XLIFF 1.2 ne XLIFF 2.0
       *[form] od tu naprej je oblika napačna
    }.
diag-texts-unit-unknown = Za enoto »{ $key }« ni besedila.
diag-texts-unit-twice = Enota »{ $key }« je v datoteki večkrat.
diag-texts-unit-source-changed = Izvirno besedilo enote »{ $key }« ni današnje: besedilo znova izvozite.
diag-texts-unit-not-read = Enota »{ $key }« nima prevoda ali pa so v njem neznani elementi.
diag-texts-unit-codes = Kode enote »{ $key }« se ne ujemajo: manjka { $missing }, ni dovoljeno { $foreign }.
diag-texts-unit-exchanged = V enoti »{ $key }« so kode med istimi besedami zamenjale mesta.
diag-texts-unit-incomplete = Enota »{ $key }« je ena od različic novega besedila; druge manjkajo ali so zavrnjene.
diag-texts-unit-refused = Enota »{ $key }« je zavrnjena ({ $code }): { $finding }
diag-texts-unit-markup = Prevod enote »{ $key }« bi spremenil obliko strani: njene oznake ali bloke okoli nje.
diag-texts-unit-numbers = Števila enote »{ $key }« se razlikujejo od izvirnika: manjka { $missing }, v izvirniku ni { $foreign }.
diag-texts-unknown-topic = Strani besedila »{ $topic }« ni.
diag-draft-language = Osnutek je v enem jeziku: navedite ga z --lang, na primer »--draft --lang de«.
diag-texts-unit-swapped = Enoti »{ $key }« in »{ $other }« sta dobili besede druga druge.
diag-texts-unit-negation = V enoti »{ $key }« je bila odstranjena nikalnica, zato besedilo pove nasprotno.
