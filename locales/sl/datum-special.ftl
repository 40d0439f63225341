# Datum cycles for bolt-hole circles, for the touch probe axis, for four holes and for one axis.

# --- 416 ---
cycle-datum-bolt-hole-circle = Referenčna točka središča krožne luknje
    .nc = REF. TOČ. SRED. KROŽ. LUKNJE
    .purpose = Z merjenjem treh vrtin izračuna središče delnega kroga (krožne luknje) in ga določi kot referenčno točko. Na zahtevo ga krmiljenje zapiše še v preglednico ničelnih točk ali preglednico prednastavitev.
cycle-datum-bolt-hole-circle__tnc426-430 =
    .purpose = Z merjenjem treh vrtin izračuna središče delnega kroga (krožne luknje) in ga določi kot referenčno točko. Na zahtevo ga krmiljenje zapiše še v preglednico ničelnih točk.
title-datum-at-top-and-bolt-hole-circle = Določitev referenčne točke na površini obdelovanca in v središču delnega kroga
title-top-and-bolt-hole-circle-into-datum-table = Zapis površine obdelovanca in središča delnega kroga v preglednico ničelnih točk

# --- 417 ---
cycle-datum-probe-axis = Referenčna točka osi tipalnega sistema
    .nc = REF. TOČ. OSI TIPAL. SIST.
    .nc-aliases = REF. TOČ. OSI TIPAL. SIS.
    .purpose = Izmeri poljubno koordinato na osi tipalnega sistema in jo določi kot referenčno točko. Na zahtevo jo krmiljenje zapiše še v preglednico ničelnih točk ali preglednico prednastavitev.
cycle-datum-probe-axis__tnc426-430 =
    .purpose = Izmeri poljubno koordinato na osi tipalnega sistema in jo določi kot referenčno točko. Na zahtevo jo krmiljenje zapiše še v preglednico ničelnih točk.
step-position-above-touch-point = Krmiljenje pozicionira tipalni sistem v hitrem teku (vrednost iz stolpca { $mp-positioning-feed }) in s pozicionirno logiko na programirano tipalno točko. Pri tem ga zamakne za varnostno razdaljo v pozitivni smeri osi tipalnega sistema.
step-position-above-touch-point__tnc426-430 = Krmiljenje pozicionira tipalni sistem v hitrem teku (vrednost iz { $mp-positioning-feed } ali { $mp-analog-positioning-feed }) in s pozicionirno logiko na programirano tipalno točko. Pri tem ga zamakne za varnostno razdaljo v pozitivni smeri osi tipalnega sistema.
step-probe-touch-point-in-probe-axis = Tipalni sistem se po osi tipalnega sistema premakne na vneseno koordinato { $q-first-point-tool } tipalne točke in z enim tipanjem izmeri dejanski položaj.
note-datum-set-in-probe-axis = Krmiljenje referenčno točko določi na osi tipalnega sistema, ki jo definira priklic orodja pred ciklom.
note-positioning-logic__datum-probe-axis = Pozicionirna logika: če je najnižja točka tipalne glave pod varno višino { $q-clearance-height }, krmiljenje tipalni sistem najprej po osi tipalnega sistema umakne na varno višino in ga nato v obdelovalni ravnini pozicionira na prvo tipalno točko. Če je nad varno višino, krmiljenje tipalni sistem najprej v obdelovalni ravnini pozicionira na prvo tipalno točko in ga nato po osi tipalnega sistema premakne neposredno na merilno višino.
note-no-transformation-with-probe-axis-datum__datum-probe-axis = Če cikel določa referenčno točko z { $q-measured-value-transfer } = 0 in hkrati tipa po osi tipalnega sistema (Q381 = 1), ne sme biti aktivno nobeno preračunavanje koordinat.
result-measured-point-actual = Dejanska vrednost izmerjene točke
title-datum-at-top-and-arc-centre = Določitev referenčne točke na površini obdelovanca in v središču krožnega odseka

# --- 418 ---
cycle-datum-four-holes = Referenčna točka središča 4 vrtin
    .nc = REF. TOČ. 4 VRTIN
    .purpose = Izračuna presečišče premic, ki povezujeta po dve središči vrtin, in ga določi kot referenčno točko. Na zahtevo ga krmiljenje zapiše še v preglednico ničelnih točk ali preglednico prednastavitev.
cycle-datum-four-holes__tnc426-430 =
    .purpose = Izračuna presečišče premic, ki povezujeta po dve središči vrtin, in ga določi kot referenčno točko. Na zahtevo ga krmiljenje zapiše še v preglednico ničelnih točk.
step-repeat-for-third-and-fourth-hole = Krmiljenje prejšnja dva koraka ponovi za tretjo in četrto vrtino.
step-retract-and-store-intersection = Krmiljenje vrne tipalni sistem na varno višino { $q-clearance-height }, izračuna referenčno točko kot presečišče premic med središčema vrtin 1 in 3 ter vrtin 2 in 4, shrani dejanske vrednosti v parametre rezultatov in referenčno točko določi ali shrani glede na { $q-measured-value-transfer } in { $q-datum-row-number }:
step-retract-and-store-intersection__tnc426-430 = Krmiljenje vrne tipalni sistem na varno višino { $q-clearance-height }, izračuna referenčno točko kot presečišče premic med središčema vrtin 1 in 3 ter vrtin 2 in 4 in jo obravnava glede na { $q-datum-row-number }:
result-intersection-main-actual = Dejanska vrednost presečišča na glavni osi
result-intersection-minor-actual = Dejanska vrednost presečišča na pomožni osi

# --- 419 ---
cycle-datum-one-axis = Referenčna točka posamezne osi
    .nc = REF. TOČ. POSAMEZNE OSI
    .nc-aliases = REF. TOČ. POSAM. OSI
    .purpose = Izmeri poljubno koordinato na izbrani osi in jo določi kot referenčno točko. Na zahtevo jo krmiljenje zapiše še v preglednico ničelnih točk ali preglednico prednastavitev.
step-position-against-probing-direction = Krmiljenje pozicionira tipalni sistem v hitrem teku (vrednost iz stolpca { $mp-positioning-feed }) in s pozicionirno logiko na programirano tipalno točko. Pri tem ga zamakne za varnostno razdaljo v smeri, nasprotni programirani smeri tipanja { $q-traverse-direction }.
step-move-to-measuring-height-and-probe = Tipalni sistem se premakne na merilno višino { $q-measuring-height } in z enim tipanjem izmeri dejanski položaj.
step-retract-and-store-datum__datum-one-axis = Krmiljenje vrne tipalni sistem na varno višino { $q-clearance-height } in izmerjeno referenčno točko določi ali shrani glede na { $q-measured-value-transfer } in { $q-datum-row-number }:
note-measuring-axes-by-probe-axis = Osi, ki jih je mogoče izbrati s parametrom { $q-measuring-axis }, so odvisne od aktivne osi tipalnega sistema ({ $q-measuring-axis } = 3): pri Z je glavna os ({ $q-measuring-axis } = 1) X in pomožna os ({ $q-measuring-axis } = 2) Y; pri Y sta to Z in X; pri X sta to Y in Z.
note-activate-preset-after-each-axis = Če želite referenčno točko z več zaporednimi izvedbami tega cikla shraniti na več oseh preglednice prednastavitev, po vsaki izvedbi aktivirajte številko prednastavitve, v katero je cikel zapisal vrednost. To ni potrebno, če se prepisuje aktivna prednastavitev.
