# Cycles that measure angles, studs, rectangles, widths, coordinates, bolt-hole circles and planes; see the English file.

# --- what several of them share ---
say-part-is-scrap = scarto (Q182=1), se un valore misurato è fuori tolleranza e non può essere corretto
say-part-needs-rework = ripresa (Q181=1), se un valore misurato è fuori tolleranza e può essere corretto

# --- 422 ---
cycle-measure-stud = Misurazione pezzo cerchio esterno (isola)
    .nc = MISURARE CERCHIO EST.
    .purpose = Misura il centro e il diametro di un'isola circolare. Se nel ciclo sono definite tolleranze, il controllo confronta i valori nominali con quelli reali e memorizza gli scostamenti in parametri.
say-part-is-scrap__measure-stud = scarto (Q182=1), se l'isola è più piccola di { $q-stud-least-diameter } o il suo centro si scosta di più di { $q-centre-tolerance-main } o { $q-centre-tolerance-minor }
say-part-needs-rework__measure-stud = ripresa (Q181=1), se l'isola è più grande di { $q-stud-greatest-diameter }
note-smallest-stepping-angle__measure-stud = Quanto più piccolo è l'angolo incrementale { $q-probing-stepping-angle }, tanto meno precise sono le dimensioni dell'isola calcolate dal controllo. Valore minimo di immissione: 5°.

# --- 423, 424 ---
cycle-measure-rectangular-pocket = Misurazione pezzo rettangolo interno
    .nc = MISURARE RETTANGOLO INT.
    .purpose = Misura il centro, la lunghezza e la larghezza di una tasca rettangolare. Se nel ciclo sono definite tolleranze, il controllo confronta i valori nominali con quelli reali e memorizza gli scostamenti in parametri.
cycle-measure-rectangular-stud = Misurazione pezzo rettangolo esterno
    .nc = MISURARE RETTANGOLO EST.
    .purpose = Misura il centro, la lunghezza e la larghezza di un'isola rettangolare. Se nel ciclo sono definite tolleranze, il controllo confronta i valori nominali con quelli reali e memorizza gli scostamenti in parametri.
say-part-is-scrap__measure-rectangular-pocket = scarto (Q182=1), se un lato è più lungo di { $q-first-side-greatest-length } o { $q-second-side-greatest-length } o il centro si scosta di più di { $q-centre-tolerance-main } o { $q-centre-tolerance-minor }
say-part-needs-rework__measure-rectangular-pocket = ripresa (Q181=1), se un lato è più corto di { $q-first-side-least-length } o { $q-second-side-least-length }
say-part-is-scrap__measure-rectangular-stud = scarto (Q182=1), se un lato è più corto di { $q-first-side-least-length } o { $q-second-side-least-length } o il centro si scosta di più di { $q-centre-tolerance-main } o { $q-centre-tolerance-minor }
say-part-needs-rework__measure-rectangular-stud = ripresa (Q181=1), se un lato è più lungo di { $q-first-side-greatest-length } o { $q-second-side-greatest-length }
result-side-main-deviation = Scostamento lunghezza lato asse principale
result-side-minor-deviation = Scostamento lunghezza lato asse secondario
title-measure-and-rework-rectangular-stud = Misurazione di un'isola rettangolare e finitura con i valori misurati
title-measure-rectangular-pocket-with-log = Misurazione di una tasca rettangolare con registrazione dei risultati
