# Cycles that set a datum, beside that of the hole.

# --- 410 and 411 ---
cycle-datum-inside-rectangle = Referenčna točka znotraj pravokotnika
    .nc = REF. TOČ. ZNOT. PRAVOKOT.
    .nc-aliases = REF. TOČ. ZNOTR. PRAVOKOT.
    .purpose = Izmeri središče pravokotnega žepa in ga določi kot referenčno točko. Na zahtevo ga krmiljenje zapiše še v preglednico ničelnih točk ali preglednico prednastavitev.
cycle-datum-inside-rectangle__tnc426-430 =
    .purpose = Izmeri središče pravokotnega žepa in ga določi kot referenčno točko. Na zahtevo ga krmiljenje zapiše še v preglednico ničelnih točk.
cycle-datum-outside-rectangle = Referenčna točka zunaj pravokotnika
    .nc = REF. TOČ. ZUN. PRAVOKOT.
    .purpose = Izmeri središče pravokotnega čepa in ga določi kot referenčno točko. Na zahtevo ga krmiljenje zapiše še v preglednico ničelnih točk ali preglednico prednastavitev.
cycle-datum-outside-rectangle__tnc426-430 =
    .purpose = Izmeri središče pravokotnega čepa in ga določi kot referenčno točko. Na zahtevo ga krmiljenje zapiše še v preglednico ničelnih točk.
step-probe-first-point = Tipalni sistem izvede prvo tipanje s pomikom pri tipanju (stolpec { $mp-probing-feed }).
step-probe-first-point__tnc426-430 = Tipalni sistem izvede prvo tipanje s pomikom pri tipanju ({ $mp-probing-feed } ali { $mp-analog-probing-feed }).
step-travel-to-second-touch-point = Tipalni sistem se premakne na drugo tipalno točko:
say-travel-linearly-at-clearance-height = pri { $q-traverse-to-clearance-height } = 1 premočrtno na varni višini { $q-clearance-height }
say-travel-paraxially-at-measuring-height = pri { $q-traverse-to-clearance-height } = 0 vzporedno z osmi na merilni višini { $q-measuring-height }
step-probe-second-point = Tipalni sistem tam izvede drugo tipanje.
step-probe-third-and-fourth-point = Krmiljenje pozicionira tipalni sistem na tretjo in nato na četrto tipalno točko ter tam izvede tretje in četrto tipanje.
step-retract-and-treat-datum = Krmiljenje vrne tipalni sistem na varno višino { $q-clearance-height } in izmerjeno referenčno točko določi ali shrani glede na { $q-measured-value-transfer } in { $q-datum-row-number }:
step-retract-and-treat-datum__tnc426-430 = Krmiljenje vrne tipalni sistem na varno višino { $q-clearance-height } in izmerjeno referenčno točko določi ali shrani glede na { $q-datum-row-number }:
step-store-actual-values = Krmiljenje shrani dejanske vrednosti v parametre rezultatov.
note-pocket-sides-rather-small = Nevarnost kolizije! Da tipalni sistem ne trči v obdelovanec, za 1. in 2. stransko dolžino žepa vnesite raje premajhno kot preveliko vrednost.
note-stud-sides-rather-large = Nevarnost kolizije! Da tipalni sistem ne trči v obdelovanec, za 1. in 2. stransko dolžino čepa vnesite raje preveliko kot premajhno vrednost.
title-introduction-to-probing = Še en primer

# --- 413 ---
cycle-datum-outside-circle = Referenčna točka zunaj kroga
    .nc = REF. TOČ. ZUNAJ KROGA
    .nc-aliases = REF. TOČ. ZUN. KROGA
    .purpose = Izmeri središče krožnega čepa in ga določi kot referenčno točko. Na zahtevo ga krmiljenje zapiše še v preglednico ničelnih točk ali preglednico prednastavitev.
cycle-datum-outside-circle__tnc426-430 =
    .purpose = Izmeri središče krožnega čepa in ga določi kot referenčno točko. Na zahtevo ga krmiljenje zapiše še v preglednico ničelnih točk.
note-stud-diameter-rather-large = Nevarnost kolizije! Da tipalni sistem ne trči v obdelovanec, za želeni premer čepa vnesite raje preveliko kot premajhno vrednost.
note-small-stepping-angle-less-exact__datum-outside-circle = Čim manjši je kotni korak { $q-probing-stepping-angle }, tem manj natančno krmiljenje izračuna referenčno točko.
title-datum-at-arc-centre-and-top = Določitev referenčne točke v središču krožnega odseka in na površini obdelovanca
title-datum-at-arc-centre-and-top__tnc426-430 = Določitev referenčne točke v središču krožnega odseka

# --- results ---
result-side-main-actual = Dejanska vrednost stranske dolžine na glavni osi
result-side-minor-actual = Dejanska vrednost stranske dolžine na pomožni osi
result-slot-width-actual = Dejanska vrednost izmerjene širine utora
result-ridge-width-actual = Dejanska vrednost izmerjene širine stojine
result-centre-axis-actual = Dejanska vrednost položaja srednje osi
result-corner-main-actual = Dejanska vrednost vogala na glavni osi
result-corner-minor-actual = Dejanska vrednost vogala na pomožni osi

# --- 408 and 409 ---
cycle-datum-slot-centre = Referenčna točka središča utora
    .nc = REF. TOČ. SRED. UTORA
    .nc-aliases = REF.TOČ.SR.UTORA
    .purpose = Izmeri središče utora in ga določi kot referenčno točko. Na zahtevo ga krmiljenje zapiše še v preglednico ničelnih točk ali preglednico prednastavitev.
cycle-datum-ridge-centre = Referenčna točka središča stojine
    .nc = REF. TOČ. SRED. STOJINE
    .nc-aliases = REF.TOČ. SR. STOJINE
    .purpose = Izmeri središče stojine in ga določi kot referenčno točko. Na zahtevo ga krmiljenje zapiše še v preglednico ničelnih točk ali preglednico prednastavitev.
step-travel-at-clearance-height-to-second = Tipalni sistem se na varni višini { $q-clearance-height } premakne na drugo tipalno točko.
say-start-again-from-centre__datum-slot-centre = iz središča in brez premika na varno višino, če je utor ob upoštevanju varnostne razdalje preozek za predpozicioniranje blizu tipalnih točk
note-slot-width-rather-small = Nevarnost kolizije! Da tipalni sistem ne trči v obdelovanec, za širino utora vnesite raje premajhno kot preveliko vrednost.
note-ridge-width-rather-large = Nevarnost kolizije! Da tipalni sistem ne trči v obdelovanec, za širino stojine vnesite raje preveliko kot premajhno vrednost.
note-probing-from-centre-if-narrow__datum-slot-centre = Če je utor ob upoštevanju varnostne razdalje preozek za predpozicioniranje blizu tipalnih točk, krmiljenje tipanje vedno začne v središču utora. Tipalni sistem se med merilnima točkama tedaj ne premakne na varno višino.
note-feature-content-level-3 = Ta cikel je funkcija stopnje Feature Content Level 3 (FCL 3).

# --- 414 and 415 ---
cycle-datum-outside-corner = Referenčna točka zunaj roba
    .nc = REF. TOČ. ZNOTR. ROBA
    .nc-aliases = REF. TOČ. ZUN. KOTA
    .purpose = Z zunanje strani izmeri dve premici in njuno presečišče določi kot referenčno točko. Na zahtevo ga krmiljenje zapiše še v preglednico ničelnih točk ali preglednico prednastavitev.
cycle-datum-outside-corner__tnc426-430 =
    .purpose = Z zunanje strani izmeri dve premici in njuno presečišče določi kot referenčno točko. Na zahtevo ga krmiljenje zapiše še v preglednico ničelnih točk.
cycle-datum-inside-corner = Referenčna točka znotraj roba
    .nc = REF. TOČ. ZUNAJ ROBA
    .nc-aliases = REF. TOČ. ZNOTR. KOTA
    .purpose = Z notranje strani izmeri dve premici in njuno presečišče določi kot referenčno točko. Na zahtevo ga krmiljenje zapiše še v preglednico ničelnih točk ali preglednico prednastavitev.
cycle-datum-inside-corner__tnc426-430 =
    .purpose = Z notranje strani izmeri dve premici in njuno presečišče določi kot referenčno točko. Na zahtevo ga krmiljenje zapiše še v preglednico ničelnih točk.
step-probe-first-point-by-third-point = Tipalni sistem izvede prvo tipanje s pomikom pri tipanju (stolpec { $mp-probing-feed }). Smer tipanja krmiljenje določi iz programirane tretje merilne točke.
step-probe-first-point-by-third-point__tnc426-430 = Tipalni sistem izvede prvo tipanje s pomikom pri tipanju ({ $mp-probing-feed } ali { $mp-analog-probing-feed }). Smer tipanja krmiljenje določi iz programirane tretje merilne točke.
step-probe-first-point-by-corner-number = Tipalni sistem izvede prvo tipanje s pomikom pri tipanju (stolpec { $mp-probing-feed }). Smer tipanja krmiljenje določi iz številke vogala { $q-corner-number }.
step-probe-first-point-by-corner-number__tnc426-430 = Tipalni sistem izvede prvo tipanje s pomikom pri tipanju ({ $mp-probing-feed } ali { $mp-analog-probing-feed }). Smer tipanja krmiljenje določi iz številke vogala { $q-corner-number }.
step-retract-and-store-corner = Krmiljenje vrne tipalni sistem na varno višino { $q-clearance-height }, shrani koordinate izmerjenega vogala v parametre rezultatov in izmerjeno referenčno točko določi ali shrani glede na { $q-measured-value-transfer } in { $q-datum-row-number }:
step-retract-and-store-corner__tnc426-430 = Krmiljenje vrne tipalni sistem na varno višino { $q-clearance-height } in presečišče izmerjenih premic kot referenčno točko določi ali shrani glede na { $q-datum-row-number }:
step-carry-out-basic-rotation-on-request = Pri { $q-corner-basic-rotation } = 1 krmiljenje poševni položaj obdelovanca izravna z osnovno rotacijo.
note-corner-from-first-and-third-point = Položaja merilnih točk 1 in 3 določata vogal, v katerem krmiljenje določi referenčno točko. Vogal A: točka 1 ima večji X in manjši Y kot točka 3. Vogal B: manjši X, manjši Y. Vogal C: manjši X, večji Y. Vogal D: večji X, večji Y.
note-first-line-in-secondary-direction = Krmiljenje prvo premico vedno izmeri v smeri pomožne osi obdelovalne ravnine.
note-basic-rotation-with-immediate-datum = Osnovno rotacijo naj krmiljenje izvede samo, če se referenčna točka določi takoj, in ne, če se zapiše v preglednico ničelnih točk za poznejšo obdelavo.
