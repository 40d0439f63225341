# Cycles that set a datum.

# --- 412 ---
cycle-datum-inside-circle = Referenčna točka znotraj kroga
    .nc = REF. TOČ. ZNOTR. KROGA
    .purpose = Izmeri središče krožnega žepa ali vrtine in ga določi kot referenčno točko. Na zahtevo ga krmiljenje zapiše še v { -preset-table(case: "accusative") } ali { -datum-table(case: "accusative") }.
cycle-datum-inside-circle__tnc426-430 =
    .purpose = Izmeri središče krožnega žepa ali vrtine in ga določi kot referenčno točko. Na zahtevo ga krmiljenje zapiše še v { -datum-table(case: "accusative") }.
step-retract-and-store-datum = Krmiljenje premakne { -probe(case: "accusative") } nazaj na { -clearance-height(case: "accusative") } { $q-clearance-height }, shrani dejanske vrednosti v parametre rezultatov in izmerjeno referenčno točko določi ali shrani glede na { $q-measured-value-transfer } in { $q-datum-row-number }:
step-retract-and-store-datum__tnc426-430 = Krmiljenje premakne { -probe(case: "accusative") } nazaj na { -clearance-height(case: "accusative") } { $q-clearance-height } in izmerjeno referenčno točko določi ali shrani glede na { $q-datum-row-number }:
say-datum-into-display-and-row-zero = pri { $q-datum-row-number } = 0 določi izmerjeno referenčno točko v prikazu; ta je takoj aktivna in se shrani tudi v vrstico 0 { -preset-table(case: "genitive") }
say-datum-into-display = pri { $q-datum-row-number } = 0 določi izmerjeno referenčno točko v prikazu; ta je takoj aktivna
say-datum-into-datum-table = če { $q-datum-row-number } ni 0 in je { $q-measured-value-transfer } = 0, zapiše izmerjeno referenčno točko v vrstico { $q-datum-row-number } aktivne { -datum-table(case: "genitive") }; referenčni sistem je aktivni koordinatni sistem obdelovanca
say-datum-into-datum-table__tnc426-430 = če { $q-datum-row-number } ni 0, zapiše izmerjeno referenčno točko v vrstico { $q-datum-row-number } aktivne { -datum-table(case: "genitive") }
say-datum-into-preset-table = če { $q-datum-row-number } ni 0 in je { $q-measured-value-transfer } = 1, zapiše izmerjeno referenčno točko v vrstico { $q-datum-row-number } { -preset-table(case: "genitive") }; referenčni sistem je strojni koordinatni sistem (REF-koordinate)
step-probe-in-probe-axis = Na zahtevo krmiljenje nato z ločenim tipanjem izmeri še referenčno točko na { -probe-axis(case: "locative") }:
say-datum-in-probe-axis = pri { $q-probing-in-probe-axis } = 1 otipa točko { $q-probe-axis-point-main }, { $q-probe-axis-point-minor }, { $q-probe-axis-point-tool } po { -probe-axis(case: "locative") }, se umakne in referenčno točko { $q-new-datum-probe-axis } določi ali shrani enako kot referenčno točko { -working-plane(case: "genitive") }
guard-datum-transfer-undefined = { $q-datum-row-number } ni 0, { $q-measured-value-transfer } pa je −1: določite, kam naj se shrani izmerjena referenčna točka.
guard-transformation-with-probe-axis-datum = Pri { $q-measured-value-transfer } = 0 in { $q-probing-in-probe-axis } = 1 preračunavanje koordinat ni dovoljeno; aktiven je zamik ničelne točke ali rotacija.
note-nominal-diameter-rather-small = Nevarnost kolizije! Da { -probe(case: "nominative") } ne trči v obdelovanec, za želeni premer žepa (vrtine) vnesite raje premajhno kot preveliko vrednost.
note-probing-from-centre-if-narrow = Če je žep ob upoštevanju varnostne razdalje premajhen za predpozicioniranje blizu tipalnih točk, krmiljenje tipanje vedno začne v središču žepa. Tipalni sistem se med merilnimi točkami tedaj ne premakne na { -clearance-height(case: "accusative") }.
note-no-transformation-with-probe-axis-datum = Če cikel določa referenčno točko z { $q-measured-value-transfer } = 0 in hkrati tipa po { -probe-axis(case: "locative") } ({ $q-probing-in-probe-axis } = 1), ne sme biti aktivno nobeno preračunavanje koordinat.
note-no-tilting-with-datum-cycles = Vrtenje { -working-plane(case: "genitive") } skupaj s cikli za določanje referenčne točke od 408 do 419 ni dovoljeno.
note-datum-cycles-with-basic-rotation = Cikle za določanje referenčne točke od 408 do 419 lahko izvajate tudi pri aktivni osnovni rotaciji.
note-datum-cycles-with-basic-rotation__tnc640 = Cikle za določanje referenčne točke od 408 do 419 lahko izvajate tudi pri aktivni rotaciji (cikel 10 ali osnovna rotacija).
note-basic-rotation-must-stay = Kota osnovne rotacije ne spreminjajte, če po merilnem ciklu uporabite zamik ničelne točke (cikel 7) iz { -datum-table(case: "genitive") }.
note-no-datum-cycles-with-basic-rotation = Ciklov za določanje referenčne točke od 410 do 418 pri aktivni osnovni rotaciji ni dovoljeno izvajati. Sicer krmiljenje prikaže sporočilo o napaki.
note-datum-axes-by-probe-axis = Os tipalnega sistema, definirana v merilnem programu, določa, na katerih oseh se določi referenčna točka: pri osi Z na X in Y, pri osi Y na Z in X, pri osi X na Y in Z.
note-datum-axes-by-probe-axis__tnc426-430 = Os tipalnega sistema, definirana v merilnem programu, določa, na katerih oseh se določi referenčna točka: pri osi Z ali W na X in Y, pri osi Y ali V na Z in X, pri osi X ali U na Y in Z.
note-transfer-minus-one = Kombinacija { $q-datum-row-number } ≠ 0 in { $q-measured-value-transfer } = −1 nastane samo, če programi s cikli od 410 do 418 izvirajo iz krmiljenja TNC 4xx ali iz starejše programske opreme iTNC 530 ali če prenos izmerjene vrednosti v definiciji cikla ni bil določen. Krmiljenje tedaj prikaže sporočilo o napaki, ker se je obravnava preglednic ničelnih točk, ki se nanašajo na strojno ničelno točko, spremenila; določite prenos.
note-activate-stored-datum = Referenčno točko, shranjeno v { -datum-table(case: "locative") }, v programu aktivirate s ciklom 7, tisto iz { -preset-table(case: "genitive") } pa s ciklom 247.
note-datum-table-must-be-active = Če želite izmerjeno referenčno točko zapisati v { -datum-table(case: "accusative") }, preglednico aktivirajte v načinu programskega teka (stanje M), preden se merilni program začne.
note-datum-table-reference = Pri zapisovanju v { -datum-table(case: "accusative") } krmiljenje upošteva { $mp-datum-table-reference }: pri vrednosti 0 se koordinate nanašajo na ničelno točko obdelovanca, pri vrednosti 1 na strojno ničelno točko. Če { $mp-datum-table-reference } pozneje spremenite, krmiljenje vrednosti, shranjene v preglednicah ničelnih točk, preračuna.
