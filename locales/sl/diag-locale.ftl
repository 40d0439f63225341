# Ugotovitve o jezikovnih datotekah.

diag-locale-encoding = Datoteka ni v kodiranju UTF-8.
diag-locale-tag = Ime mape »{ $tag }« ni oznaka jezika.
diag-locale-nesting = Zaviti oklepaji so ugnezdeni globlje od { $most } ravni; datoteka se ne prebere.
diag-locale-long-number = Število ima več kot { $most } števk zapored; datoteka se ne prebere.
diag-locale-syntax =
    To ni Fluent: { $kind ->
        [expected-token] tukaj je pričakovan »{ $detail }«
        [expected-character] tukaj je pričakovan eden od znakov { $detail }
        [empty-message] sporočilo »{ $detail }« nima ne vrednosti ne atributa
        [empty-term] izraz »-{ $detail }« nima vrednosti
        [bad-function-name] ime funkcije lahko sestavljajo samo velike črke, števke, »-« in »_«
        [no-default] izbira potrebuje privzeto možnost z oznako »*«
        [two-defaults] izbira ima lahko samo eno privzeto možnost
        [no-value] tukaj je pričakovana vrednost
        [bad-selector] izbira poteka po argumentu, funkciji ali atributu izraza
        [term-attribute] atributa izraza ni mogoče prikazati
        [open-string] niz ni zaključen
        [argument-order] argumenti brez imena morajo biti na začetku
        [argument-twice] argument »{ $detail }« je naveden dvakrat
        [bad-escape] »{ $detail }« ni ubežno zaporedje
        [closing-brace] zaklepaj brez oklepaja
       *[no-expression] tukaj je pričakovan izraz
    }.
diag-locale-isolation-mark = Tukaj je znak za ločitev smeri pisanja; v NC-program ne sme priti.
diag-locale-duplicate = »{ $key }« je določeno dvakrat; to velja tudi, če imata sporočilo in izraz enako ime.
related-first-definition = prva določitev
diag-locale-variant = »{ $key }« ni ime z največ dvema priponama, za cikel in krmiljenje.
diag-locale-unit-form = »{ $key }« ni predloga: enota ima besedilo in en { "{ $value }" }, seznam ima { "{ $first }" } in { "{ $last }" } v vrednosti in v atributu »more«.
diag-locale-unknown-reference = »{ $name }« ne obstaja.
diag-locale-unknown-function = Funkcija »{ $name }« ne obstaja.
diag-locale-function-option = »{ $name }: { $value }« ni možnost funkcije { $function }.
diag-locale-function-arguments = Funkcija { $function } ima napačno število vrednosti.
diag-locale-unknown-unit = Enota »{ $name }« ne obstaja: datoteka units.ftl nima sporočila zanjo.
diag-locale-term-argument = Izraz »-{ $term }« ne uporablja argumenta »{ $name }«.
diag-locale-term-value = Izraz »-{ $term }« nima oblike »{ $value }« za argument »{ $name }«.
diag-locale-term-needs = Izraz »-{ $term }« tukaj potrebuje argument »{ $name }«.
diag-locale-cyclic = »{ $key }« vsebuje samo sebe.
diag-locale-unknown-language = Za jezik »{ $language }« ni datotek.
diag-locale-missing-text = Jezik »{ $language }« nima besedila »{ $key }«{ $file ->
        [none] {""}.
       *[other] ; spada v { $file }.
    }
diag-locale-missing-argument = Besedilo »{ $key }« ({ $language }) uporablja argument »{ $name }«, ki tu ni na voljo.
diag-locale-function-failed =
    V besedilu »{ $key }« ({ $language }) funkcije { $name } ni mogoče uporabiti: { $reason ->
        [not-a-number] vrednost ni število
        [not-finite] število ni končno
        [no-unit] manjka enota
        [unknown-unit] enota ni znana
        [not-a-list] vrednost ni seznam
       *[unknown-type] vrsta seznama ni znana
    }.
diag-locale-too-long = Besedilo »{ $key }« ({ $language }) ima preveč mest za vstavljanje.
diag-locale-lock-line = Vsako vrstico te datoteke sestavljata oznaka in osem šestnajstiških števk.
diag-locale-missing-translation = »{ $key }« ni prevedeno v jezik »{ $language }«.
diag-locale-unfinished = V jeziku »{ $language }« manjka toliko besedil: { $count }. »ciklo texts status --lang { $language }« jih prešteje po datotekah in navede naslednja.
diag-locale-orphan = »{ $key }« ({ $language }) je odveč: angleškega besedila ni več.
diag-locale-stale =
    { $change ->
        [none] Angleško besedilo »{ $key }« se je po prevodu v jezik »{ $language }« spremenilo.
       *[other] Angleško besedilo »{ $key }« se je po prevodu v jezik »{ $language }« spremenilo: { $change }.
    }
diag-locale-unrecorded = Prevod »{ $key }« v jezik »{ $language }« še ni potrjen.
diag-locale-moved = Prevod »{ $key }« v jezik »{ $language }« ima zdaj besede, ki so bile potrjene za »{ $name }«.
diag-locale-unknown-argument = »{ $key }« ({ $language }) uporablja argument »{ $name }«, ki ga v angleškem besedilu ni.
