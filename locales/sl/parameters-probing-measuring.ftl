# Parameters of the cycles that measure angles, studs, rectangles, widths, coordinates, bolt-hole circles and planes.

# --- 422 ---
parameter-probing-centre-main__measure-stud =
    .help = Središče čepa na glavni osi obdelovalne ravnine.
parameter-probing-centre-minor__measure-stud =
    .help = Središče čepa na pomožni osi obdelovalne ravnine.
parameter-probing-nominal-diameter__measure-stud =
    .help = Premer čepa.
parameter-number-of-touch-points__measure-stud =
    .help = Določa, ali se čep izmeri s štirimi ali s tremi tipanji.
parameter-stud-greatest-diameter = Največji premer čepa
    .label = NAJVEČJA VREDNOST
    .help = Največji dovoljeni premer čepa.
parameter-stud-least-diameter = Najmanjši premer čepa
    .label = NAJMANJŠA VREDNOST
    .help = Najmanjši dovoljeni premer čepa.

# --- 423, 424 ---
parameter-probing-centre-main__measure-rectangular-pocket =
    .help = Središče žepa na glavni osi obdelovalne ravnine.
parameter-probing-centre-minor__measure-rectangular-pocket =
    .help = Središče žepa na pomožni osi obdelovalne ravnine.
parameter-probing-centre-main__measure-rectangular-stud =
    .help = Središče čepa na glavni osi obdelovalne ravnine.
parameter-probing-centre-minor__measure-rectangular-stud =
    .help = Središče čepa na pomožni osi obdelovalne ravnine.
parameter-probing-first-side-length = 1. stranska dolžina
    .label = 1. STRANSKA DOLŽINA
    .help = Dolžina žepa vzporedno z glavno osjo obdelovalne ravnine.
parameter-probing-first-side-length__measure-rectangular-stud =
    .help = Dolžina čepa vzporedno z glavno osjo obdelovalne ravnine.
parameter-probing-second-side-length = 2. stranska dolžina
    .label = 2. STRANSKA DOLŽINA
    .help = Dolžina žepa vzporedno s pomožno osjo obdelovalne ravnine.
parameter-probing-second-side-length__measure-rectangular-stud =
    .help = Dolžina čepa vzporedno s pomožno osjo obdelovalne ravnine.
parameter-first-side-greatest-length = Največja vrednost 1. stranske dolžine
    .label = NAJVEČJA VREDNOST 1. STRANI
    .help = Največja dovoljena dolžina žepa.
parameter-first-side-greatest-length__measure-rectangular-stud =
    .help = Največja dovoljena dolžina čepa.
parameter-first-side-greatest-length__tnc320 =
    .label = NAJV. VREDNOST 1. STRANI
    .label-aliases = NAJVEČJA VREDNOST 1. STRANI
parameter-first-side-greatest-length__tnc426-430 =
    .label = NAJV. VREDNOST 1. STRANI
    .label-aliases = NAJVEČJA VREDNOST 1. STRANI
parameter-first-side-least-length = Najmanjša vrednost 1. stranske dolžine
    .label = NAJMANJŠA VREDNOST 1. STRANI
    .help = Najmanjša dovoljena dolžina žepa.
parameter-first-side-least-length__measure-rectangular-stud =
    .help = Najmanjša dovoljena dolžina čepa.
parameter-first-side-least-length__tnc320 =
    .label = NAJM. VREDNOST 1. STRANI
    .label-aliases = NAJMANJŠA VREDNOST 1. STRANI
parameter-first-side-least-length__tnc426-430 =
    .label = NAJM. VREDNOST 1. STRANI
    .label-aliases = NAJMANJŠA VREDNOST 1. STRANI
parameter-second-side-greatest-length = Največja vrednost 2. stranske dolžine
    .label = NAJVEČJA VREDNOST 2. STRANI
    .help = Največja dovoljena širina žepa.
parameter-second-side-greatest-length__measure-rectangular-stud =
    .help = Največja dovoljena širina čepa.
parameter-second-side-greatest-length__tnc320 =
    .label = NAJV. VREDNOST 2. STRANI
    .label-aliases = NAJVEČJA VREDNOST 2. STRANI
parameter-second-side-greatest-length__tnc426-430 =
    .label = NAJV. VREDNOST 2. STRANI
    .label-aliases = NAJVEČJA VREDNOST 2. STRANI
parameter-second-side-least-length = Najmanjša vrednost 2. stranske dolžine
    .label = NAJMANJŠA VREDNOST 2. STRANI
    .help = Najmanjša dovoljena širina žepa.
parameter-second-side-least-length__measure-rectangular-stud =
    .help = Najmanjša dovoljena širina čepa.
parameter-second-side-least-length__tnc320 =
    .label = NAJM. VREDNOST 2. STRANI
    .label-aliases = NAJMANJŠA VREDNOST 2. STRANI
parameter-second-side-least-length__tnc426-430 =
    .label = NAJM. VREDNOST 2. STRANI
    .label-aliases = NAJMANJŠA VREDNOST 2. STRANI

# --- 425, 426 ---
parameter-probing-start-main = Začetna točka 1. osi
    .label = ZAČETNA TOČKA 1. OSI
    .help = Začetna točka tipanja na glavni osi obdelovalne ravnine.
parameter-probing-start-minor = Začetna točka 2. osi
    .label = ZAČETNA TOČKA 2. OSI
    .help = Začetna točka tipanja na pomožni osi obdelovalne ravnine.
parameter-second-measurement-offset = Zamik za 2. meritev
    .label = ZAMIK 2. MERITVE
    .help = Razdalja, za katero se tipalni sistem pred drugo meritvijo zamakne. Pri vrednosti 0 ga krmiljenje ne zamakne.
parameter-nominal-length = Želena dolžina
    .label = ŽELENA DOLŽINA
    .help = Želena vrednost dolžine, ki se meri.
parameter-greatest-dimension = Največja vrednost
    .label = NAJVEČJA VREDNOST
    .help = Največja dovoljena dolžina.
parameter-least-dimension = Najmanjša vrednost
    .label = NAJMANJŠA VREDNOST
    .help = Najmanjša dovoljena dolžina.
parameter-probing-clearance__measure-slot-width =
    .help = Dodatna razdalja med merilno točko in tipalno kroglo. Prišteje se vrednosti { $mp-set-up } in deluje samo pri tipanju referenčne točke na osi tipalnega sistema.

# --- 427 ---
parameter-measuring-axis__measure-coordinate = Merilna os (1...3: 1=glavna os)
    .help = Os, na kateri se izvede meritev.
parameter-greatest-dimension__measure-coordinate =
    .help = Največja dovoljena izmerjena vrednost.
parameter-least-dimension__measure-coordinate =
    .help = Najmanjša dovoljena izmerjena vrednost.

# --- 430 ---
parameter-probing-centre-main__measure-bolt-hole-circle =
    .help = Središče delnega kroga (želena vrednost) na glavni osi obdelovalne ravnine.
parameter-probing-centre-minor__measure-bolt-hole-circle =
    .help = Središče delnega kroga (želena vrednost) na pomožni osi obdelovalne ravnine.
parameter-probing-nominal-diameter__measure-bolt-hole-circle =
    .help = Premer delnega kroga.
parameter-first-hole-angle = Kot 1. vrtine
    .label = KOT 1. VRTINE
    .help = Kot središča prve vrtine v obdelovalni ravnini, v polarnih koordinatah.
parameter-second-hole-angle = Kot 2. vrtine
    .label = KOT 2. VRTINE
    .help = Kot središča druge vrtine v obdelovalni ravnini, v polarnih koordinatah.
parameter-third-hole-angle = Kot 3. vrtine
    .label = KOT 3. VRTINE
    .help = Kot središča tretje vrtine v obdelovalni ravnini, v polarnih koordinatah.
parameter-greatest-dimension__measure-bolt-hole-circle =
    .help = Največji dovoljeni premer delnega kroga.
parameter-least-dimension__measure-bolt-hole-circle =
    .help = Najmanjši dovoljeni premer delnega kroga.
parameter-monitored-tool__measure-bolt-hole-circle =
    .help = Številka ali ime orodja, če naj krmiljenje nadzoruje njegov lom.
parameter-monitored-tool__measure-bolt-hole-circle__tnc320 =
    .help = Številka orodja, če naj krmiljenje nadzoruje njegov lom.
parameter-monitored-tool__measure-bolt-hole-circle__tnc426-430 =
    .help = Številka orodja, če naj krmiljenje nadzoruje njegov lom.

# --- 420, 431 ---
parameter-first-point-tool = 1. merilna točka 3. osi
    .label = 1. TOČKA 3. OSI
    .help = Koordinata prve tipalne točke na osi tipalnega sistema.
parameter-second-point-tool = 2. merilna točka 3. osi
    .label = 2. TOČKA 3. OSI
    .help = Koordinata druge tipalne točke na osi tipalnega sistema.
parameter-third-point-tool = 3. merilna točka 3. osi
    .label = 3. TOČKA 3. OSI
    .help = Koordinata tretje tipalne točke na osi tipalnega sistema.
parameter-measuring-axis__measure-angle =
    .help = Os, na kateri se izvede meritev.

# --- 416 ---
parameter-probing-centre-main__datum-bolt-hole-circle =
    .help = Središče delnega kroga (želena vrednost) na glavni osi obdelovalne ravnine.
parameter-probing-centre-minor__datum-bolt-hole-circle =
    .help = Središče delnega kroga (želena vrednost) na pomožni osi obdelovalne ravnine.
parameter-probing-nominal-diameter__datum-bolt-hole-circle =
    .help = Približni premer delnega kroga. Čim manjše so vrtine, tem natančneje ga je treba vnesti.
parameter-datum-row-number__datum-bolt-hole-circle =
    .help = Številka v preglednici ničelnih točk ali preglednici prednastavitev, pod katero se shranijo koordinate središča delnega kroga. Pri vrednosti 0 krmiljenje prikaz nastavi tako, da je nova referenčna točka v središču delnega kroga.
parameter-datum-row-number__datum-bolt-hole-circle__tnc426-430 =
    .help = Številka v preglednici ničelnih točk, pod katero se shranijo koordinate središča delnega kroga. Pri vrednosti 0 krmiljenje prikaz nastavi tako, da je nova referenčna točka v središču delnega kroga.
parameter-new-datum-main__datum-bolt-hole-circle =
    .help = Koordinata na glavni osi, na katero se postavi izmerjeno središče delnega kroga. Osnovna nastavitev: 0.
parameter-new-datum-minor__datum-bolt-hole-circle =
    .help = Koordinata na pomožni osi, na katero se postavi izmerjeno središče delnega kroga. Osnovna nastavitev: 0.
parameter-probing-clearance__datum-bolt-hole-circle =
    .help = Dodatna razdalja med merilno točko in tipalno kroglo. Prišteje se vrednosti { $mp-set-up } in deluje samo pri tipanju referenčne točke na osi tipalnega sistema.

# --- 417 ---
parameter-datum-row-number__datum-probe-axis =
    .help = Številka v preglednici ničelnih točk ali preglednici prednastavitev, pod katero se shrani koordinata. Pri vrednosti 0 krmiljenje prikaz nastavi tako, da je nova referenčna točka na otipani ploskvi.
parameter-datum-row-number__datum-probe-axis__tnc426-430 =
    .help = Številka v preglednici ničelnih točk, pod katero se shrani koordinata. Pri vrednosti 0 krmiljenje prikaz nastavi tako, da je nova referenčna točka na otipani ploskvi.

# --- 418 ---
parameter-third-centre-main = 3. središče 1. osi
    .label = 3. SREDIŠČE 1. OSI
    .help = Središče tretje vrtine na glavni osi obdelovalne ravnine.
parameter-third-centre-minor = 3. središče 2. osi
    .label = 3. SREDIŠČE 2. OSI
    .help = Središče tretje vrtine na pomožni osi obdelovalne ravnine.
parameter-fourth-centre-main = 4. središče 1. osi
    .label = 4. SREDIŠČE 1. OSI
    .help = Središče četrte vrtine na glavni osi obdelovalne ravnine.
parameter-fourth-centre-minor = 4. središče 2. osi
    .label = 4. SREDIŠČE 2. OSI
    .help = Središče četrte vrtine na pomožni osi obdelovalne ravnine.
parameter-datum-row-number__datum-four-holes =
    .help = Številka v preglednici ničelnih točk ali preglednici prednastavitev, pod katero se shranijo koordinate presečišča povezovalnih premic. Pri vrednosti 0 krmiljenje prikaz nastavi tako, da je nova referenčna točka v presečišču povezovalnih premic.
parameter-datum-row-number__datum-four-holes__tnc426-430 =
    .help = Številka v preglednici ničelnih točk, pod katero se shranijo koordinate presečišča povezovalnih premic. Pri vrednosti 0 krmiljenje prikaz nastavi tako, da je nova referenčna točka v presečišču povezovalnih premic.
parameter-new-datum-main__datum-four-holes =
    .help = Koordinata na glavni osi, na katero se postavi izmerjeno presečišče povezovalnih premic. Osnovna nastavitev: 0.
parameter-new-datum-minor__datum-four-holes =
    .help = Koordinata na pomožni osi, na katero se postavi izmerjeno presečišče povezovalnih premic. Osnovna nastavitev: 0.

# --- 419 ---
parameter-measuring-axis__datum-one-axis = Merilna os (1...3: 1=glavna os)
    .help = Os, na kateri se izvede meritev.
parameter-datum-row-number__datum-one-axis =
    .help = Številka v preglednici ničelnih točk ali preglednici prednastavitev, pod katero se shrani koordinata. Pri vrednosti 0 krmiljenje prikaz nastavi tako, da je nova referenčna točka na otipani ploskvi.
parameter-new-datum-one-axis = Nova referenčna točka
    .label = REFERENČNA TOČKA
    .help = Koordinata, na katero se postavi referenčna točka. Osnovna nastavitev: 0.

# --- 1, 3 ---
parameter-polar-probing-axis = Tipalna os
    .help = Tipalna os, vnesena s tipko za izbiro osi ali s črkovno tipkovnico. Potrdite s tipko ENT.
parameter-polar-probing-axis__measuring =
    .help = Os, v smeri katere se izvede tipanje. Potrdite s tipko ENT.
parameter-polar-probing-axis__measuring__tnc426-430 =
    .help = Glavna os obdelovalne ravnine: X pri orodni osi Z, Z pri orodni osi Y, Y pri orodni osi X. Potrdite s tipko ENT.
parameter-polar-probing-angle = Kot tipanja
    .word = KOT:
    .help = Kot glede na tipalno os, pod katerim se premika tipalni sistem.
parameter-polar-probing-angle__measuring = Tipalni kot
parameter-result-parameter__measuring =
    .help = Številka Q-parametra, ki mu krmiljenje priredi prvo izmerjeno koordinato (X). Y in Z sta v naslednjih Q-parametrih.
parameter-greatest-measuring-path = Najdaljša pot meritve
    .word = ABST
    .help = Pot, za katero se tipalni sistem premakne od začetne točke. Potrdite s tipko ENT.
parameter-measuring-feed = Merilni pomik
    .help = Pomik, s katerim se tipalni sistem premika med meritvijo (mm/min).
parameter-greatest-retraction-path = Najdaljša pot odmika
    .help = Pot v nasprotni smeri tipanja po odklonu tipalne glave. Krmiljenje umakne tipalni sistem največ do začetne točke, zato do kolizije ne more priti.
parameter-probing-reference-system = Referenčni sistem (0 = IST, 1 = REF)
    .prompt = Referenčni sistem? (0=IST/1=REF)
    .word = REFERENČNI SISTEM:
    .help = Določa, ali se smer tipanja in rezultat nanašata na dejanski koordinatni sistem (IST, lahko je zamaknjen ali zasukan) ali na strojni koordinatni sistem (REF).
parameter-probing-reference-system__tnc320 =
    .help = Določa, ali se rezultat nanaša na dejanski koordinatni sistem (IST, lahko je zamaknjen ali zasukan) ali na strojni koordinatni sistem (REF).
choice-probe-in-actual-system = tipanje v dejanskem sistemu in shranjevanje rezultata v sistemu IST
choice-probe-in-machine-system = tipanje v strojnem sistemu REF in shranjevanje rezultata v sistemu REF
parameter-probing-error-mode = Stanje sporočila o napaki (0 = IZKLOP/1 = VKLOP)
    .help = Določa, ali krmiljenje prikaže sporočilo o napaki, če je tipalna glava ob začetku cikla odklonjena. Pri vrednosti 1 krmiljenje v četrti parameter rezultata shrani −1 in nadaljuje cikel.
parameter-probing-error-mode__tnc320 =
    .help = Določa, ali krmiljenje prikaže sporočilo o napaki, če je tipalna glava ob začetku cikla odklonjena. Pri vrednosti 1 krmiljenje v četrti parameter rezultata shrani 2,0 in nadaljuje cikel.
choice-show-probing-error = prikaz sporočila o napaki
choice-probing-error-off = brez sporočila o napaki

parameter-traverse-to-clearance-height__measure-slot-width =
    .label = PREMIK NA VARNOSTNO VIŠINO
    .label-aliases = PREMIK NA VARNO VIŠINO
parameter-traverse-direction__measure-coordinate =
    .label = SMER PREMIKA
    .label-aliases = SMER PREMIKANJA | SMER PREMICA
parameter-new-datum-probe-axis__datum-probe-axis = Nova referenčna točka
parameter-traverse-direction__datum-one-axis =
    .label = SMER PREMIKA
    .label-aliases = SMER PREMIKANJA | SMER PREMICA
