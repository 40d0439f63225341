### Besedila ugotovitev razčlenjevalnika. $found je to, kar stoji na tem mestu, $expected ključ za to, kar bi lahko stalo, ali beseda programa.

syntax-expected =
    { $expected ->
        [block] začetek stavka
        [end] konec stavka
        [sign] predznak
        [word] koordinata, R0, RL, RR, pomik ali M-funkcija
        [number] število
        [m-function] M-funkcija
        [blk-form-part] 0.1, 0.2, CYLINDER, ROTATION ali FILE
        [tool-word] S, F, DL, DR ali DR2, vsak po enkrat
        [tool] številka orodja ali ime orodja v narekovajih
        [value] število ali Q-parameter
        [quotation-mark] zaključni narekovaj
        [unit] MM ali INCH
        [label] številka oznake ali ime oznake v narekovajih
        [call] LBL ali PGM
        [name] ime
        [selection] TABLE, PATTERN, CONTOUR, PGM ali CYCLE
        [cycle-word] CYCL DEF, CYCL CALL ali TCH PROBE
        [cycle-number] številka cikla
        [text-parameter] QS-parameter
        [parameter] Q-parameter
        [relation] EQU, NE, GT ali LT
        [relation-of-number] primerjava, ki pripada tej številki FN
        [less-nesting] krajša ali manj ugnezdena formula
        [field] polje cikla
        [operand] število, Q-parameter ali funkcija
        [operator] računski operator
        [closing-bracket] zaklepaj
        [known-function] funkcija jezika formul
        [character] znak jezika formul
        [arguments] drugačno število argumentov
        [in-spec-only] samo računske operacije; program tu ne more primerjati
        [block-word] beseda tega stavka
        [approach] LT, LN, CT, LCT, PLT, PLN, PCT ali PLCT
        [plane-form] SPATIAL, PROJECTED, EULER, VECTOR, POINTS, RELATIV, AXIAL ali RESET
        [function] ime funkcije
        [transformation] DATUM, MIRROR, ROTATION ali SCALE
        [pattern-item] POS, ROW, PAT, FRAME, CIRC ali PITCHCIRC
        [contour-name] kontura, na primer QC1
        [contour-operator] &, |, ^ ali \
       *[other] { $expected }
    }

diag-syntax-unknown-block = Noben stavek se ne začne z »{ $found }«.
diag-syntax-unexpected = »{ $found }« tu ne more stati; pričakovano: { syntax-expected }.
diag-syntax-incomplete = Stavek ni popoln; pričakovano: { syntax-expected }.
diag-syntax-unclosed-text = Besedilo nima zaključnega narekovaja: { $found }
diag-syntax-formula = »{ $found }« na tem mestu formule ne more stati; pričakovano: { syntax-expected }.
diag-syntax-text-after-tab = »{ $found }« stoji za tabulatorjem in ne pripada nobenemu stavku; krmiljenje bi ga zavrnilo. Komentar se začne s podpičjem.
diag-syntax-dangling-continuation = Znak ~ pove, da se stavek nadaljuje, vendar ne sledi vrstica, ki bi mu pripadala.
diag-syntax-foreign-line = »{ $found }« ni stavek tega jezika; krmiljenje bi ga zavrnilo. Komentar se začne s podpičjem.
diag-syntax-spelling = Krmiljenja ne pišejo »{ $found }«, temveč: { syntax-expected }.
diag-syntax-undescribed = »{ $found }« ni opisano v nobenem priročniku te družine krmiljenj; ni znano, ali ga krmiljenje sprejme.
diag-syntax-refused-block = Krmiljenje tega stavka ni moglo prebrati: { $found }
diag-syntax-excluding-codes = »{ $found }« in druga koda tega stavka se izključujeta.
diag-syntax-bracket-comment = Besedilo v oklepajih na teh krmiljenjih ni komentar: komentar se začne s podpičjem.
diag-syntax-doubled-continuation = Tu je še en znak ~; da se stavek nadaljuje v naslednji vrstici, zadošča eden.
