# Parameters of the misalignment and datum cycles: name, label in the NC block, help.

# --- datum cycles: what differs from the hole ---
parameter-probing-centre-main__datum-inside-rectangle =
    .help = Središče žepa na glavni osi obdelovalne ravnine.
parameter-probing-centre-minor__datum-inside-rectangle =
    .help = Središče žepa na pomožni osi obdelovalne ravnine.
parameter-probing-centre-main__datum-outside-rectangle =
    .help = Središče čepa na glavni osi obdelovalne ravnine.
parameter-probing-centre-minor__datum-outside-rectangle =
    .help = Središče čepa na pomožni osi obdelovalne ravnine.
parameter-probing-centre-main__datum-outside-circle =
    .help = Središče čepa na glavni osi obdelovalne ravnine.
parameter-probing-centre-minor__datum-outside-circle =
    .help = Središče čepa na pomožni osi obdelovalne ravnine.
parameter-probing-nominal-diameter__datum-outside-circle =
    .help = Približni premer čepa. Vnesite raje preveliko kot premajhno vrednost.
parameter-number-of-touch-points__datum-outside-circle =
    .help = Določa, ali se čep izmeri s štirimi ali s tremi tipanji.
parameter-first-side-length__datum-outside-rectangle =
    .help = Dolžina čepa vzporedno z glavno osjo obdelovalne ravnine.
parameter-second-side-length__datum-outside-rectangle =
    .help = Dolžina čepa vzporedno s pomožno osjo obdelovalne ravnine.
parameter-datum-row-number__datum-outside-rectangle =
    .help = Številka v preglednici ničelnih točk ali preglednici prednastavitev, pod katero se shranijo koordinate središča čepa. Pri vrednosti 0 krmiljenje prikaz nastavi tako, da je nova referenčna točka v središču čepa.
parameter-datum-row-number__datum-outside-rectangle__tnc426-430 =
    .help = Številka v preglednici ničelnih točk, pod katero se shranijo koordinate središča čepa. Pri vrednosti 0 krmiljenje prikaz nastavi tako, da je nova referenčna točka v središču čepa.
parameter-datum-row-number__datum-outside-circle =
    .help = Številka v preglednici ničelnih točk ali preglednici prednastavitev, pod katero se shranijo koordinate središča čepa. Pri vrednosti 0 krmiljenje prikaz nastavi tako, da je nova referenčna točka v središču čepa.
parameter-datum-row-number__datum-outside-circle__tnc426-430 =
    .help = Številka v preglednici ničelnih točk, pod katero se shranijo koordinate središča čepa. Pri vrednosti 0 krmiljenje prikaz nastavi tako, da je nova referenčna točka v središču čepa.
parameter-new-datum-main__datum-outside-rectangle =
    .help = Koordinata na glavni osi, na katero se postavi izmerjeno središče čepa. Osnovna nastavitev: 0.
parameter-new-datum-minor__datum-outside-rectangle =
    .help = Koordinata na pomožni osi, na katero se postavi izmerjeno središče čepa. Osnovna nastavitev: 0.
parameter-new-datum-main__datum-outside-circle =
    .help = Koordinata na glavni osi, na katero se postavi izmerjeno središče čepa. Osnovna nastavitev: 0.
parameter-new-datum-minor__datum-outside-circle =
    .help = Koordinata na pomožni osi, na katero se postavi izmerjeno središče čepa. Osnovna nastavitev: 0.
choice-travel-paraxially-at-measuring-height = premikanje med merilnimi točkami vzporedno z osmi na merilni višini
choice-travel-linearly-at-clearance-height = premočrtno premikanje med merilnimi točkami na varni višini

# --- 408 and 409 ---
parameter-probing-centre-main__datum-slot-centre =
    .help = Središče utora na glavni osi obdelovalne ravnine.
parameter-probing-centre-minor__datum-slot-centre =
    .help = Središče utora na pomožni osi obdelovalne ravnine.
parameter-probing-centre-main__datum-ridge-centre =
    .help = Središče stojine na glavni osi obdelovalne ravnine.
parameter-probing-centre-minor__datum-ridge-centre =
    .help = Središče stojine na pomožni osi obdelovalne ravnine.
parameter-slot-width = Širina utora
    .label = ŠIRINA UTORA
    .help = Širina utora, ne glede na njegov položaj v obdelovalni ravnini.
parameter-ridge-width = Širina stojine
    .label = ŠIRINA STOJINE
    .help = Širina stojine, ne glede na njen položaj v obdelovalni ravnini.
parameter-datum-row-number__datum-slot-centre = Številka v preglednici
    .help = Številka v preglednici ničelnih točk ali preglednici prednastavitev, pod katero se shranijo koordinate središča utora. Pri vrednosti 0 krmiljenje prikaz nastavi tako, da je nova referenčna točka v središču utora.
parameter-datum-row-number__datum-ridge-centre = Številka v preglednici
    .help = Številka v preglednici ničelnih točk ali preglednici prednastavitev, pod katero se shranijo koordinate središča stojine. Pri vrednosti 0 krmiljenje prikaz nastavi tako, da je nova referenčna točka v središču stojine.
parameter-new-datum-measuring-axis = Nova referenčna točka
    .label = REFERENČNA TOČKA
    .help = Koordinata na merilni osi, na katero se postavi izmerjeno središče. Osnovna nastavitev: 0.

# --- 414 and 415 ---
parameter-third-point-main = 3. merilna točka 1. osi
    .label = 3. TOČKA 1. OSI
    .help = Koordinata tretje tipalne točke na glavni osi obdelovalne ravnine.
parameter-third-point-minor = 3. merilna točka 2. osi
    .label = 3. TOČKA 2. OSI
    .help = Koordinata tretje tipalne točke na pomožni osi obdelovalne ravnine.
parameter-point-distance-main = Razdalja na 1. osi
    .label = RAZDALJA NA 1. OSI
    .help = Razdalja med prvo in drugo merilno točko na glavni osi obdelovalne ravnine.
parameter-point-distance-minor = Razdalja na 2. osi
    .label = RAZDALJA NA 2. OSI
    .help = Razdalja med tretjo in četrto merilno točko na pomožni osi obdelovalne ravnine.
parameter-corner-number = Rob
    .label = ROB
    .help = Številka vogala, v katerem se določi referenčna točka.
parameter-corner-basic-rotation = Izvedba osnovne rotacije
    .prompt = Izvedba osnovnega vrtenja?
    .label = OSNOVNA ROTACIJA
    .help = Določa, ali krmiljenje poševni položaj obdelovanca izravna z osnovno rotacijo.
choice-no-basic-rotation = brez osnovne rotacije
choice-carry-out-basic-rotation = izvedba osnovne rotacije
parameter-datum-row-number__datum-outside-corner =
    .help = Številka v preglednici ničelnih točk ali preglednici prednastavitev, pod katero se shranijo koordinate vogala. Pri vrednosti 0 krmiljenje prikaz nastavi tako, da je nova referenčna točka v vogalu.
parameter-datum-row-number__datum-outside-corner__tnc426-430 =
    .help = Številka v preglednici ničelnih točk, pod katero se shranijo koordinate vogala. Pri vrednosti 0 krmiljenje prikaz nastavi tako, da je nova referenčna točka v vogalu.
parameter-datum-row-number__datum-inside-corner =
    .help = Številka v preglednici ničelnih točk ali preglednici prednastavitev, pod katero se shranijo koordinate vogala. Pri vrednosti 0 krmiljenje prikaz nastavi tako, da je nova referenčna točka v vogalu.
parameter-datum-row-number__datum-inside-corner__tnc426-430 =
    .help = Številka v preglednici ničelnih točk, pod katero se shranijo koordinate vogala. Pri vrednosti 0 krmiljenje prikaz nastavi tako, da je nova referenčna točka v vogalu.
parameter-new-datum-main__datum-outside-corner =
    .help = Koordinata na glavni osi, na katero se postavi izmerjeni vogal. Osnovna nastavitev: 0.
parameter-new-datum-minor__datum-outside-corner =
    .help = Koordinata na pomožni osi, na katero se postavi izmerjeni vogal. Osnovna nastavitev: 0.
parameter-new-datum-main__datum-inside-corner =
    .help = Koordinata na glavni osi, na katero se postavi izmerjeni vogal. Osnovna nastavitev: 0.
parameter-new-datum-minor__datum-inside-corner =
    .help = Koordinata na pomožni osi, na katero se postavi izmerjeni vogal. Osnovna nastavitev: 0.

# --- two points on a line ---
parameter-first-point-main = 1. merilna točka 1. osi
    .label = 1. TOČKA 1. OSI
    .help = Koordinata prve tipalne točke na glavni osi obdelovalne ravnine.
parameter-first-point-minor = 1. merilna točka 2. osi
    .label = 1. TOČKA 2. OSI
    .help = Koordinata prve tipalne točke na pomožni osi obdelovalne ravnine.
parameter-second-point-main = 2. merilna točka 1. osi
    .label = 2. TOČKA 1. OSI
    .help = Koordinata druge tipalne točke na glavni osi obdelovalne ravnine.
parameter-second-point-minor = 2. merilna točka 2. osi
    .label = 2. TOČKA 2. OSI
    .help = Koordinata druge tipalne točke na pomožni osi obdelovalne ravnine.
parameter-measuring-axis = Merilna os
    .label = MERILNA OS
    .help = Os obdelovalne ravnine, na kateri se izvede meritev.
parameter-measuring-axis__rotation-by-rotary-axis = Merilna os (1...3: 1=glavna os)
    .help = Os, na kateri se izvede meritev.
choice-measuring-axis-main = glavna os je merilna os
choice-measuring-axis-minor = pomožna os je merilna os
choice-measuring-axis-probe = os tipalnega sistema je merilna os
parameter-traverse-direction = Smer premika
    .label = SMER PREMIKANJA
    .prompt = Smer premika 1?
    .label-aliases = SMER PREMICA | SMER PREMIKA
    .help = Smer, v kateri se tipalni sistem primakne k obdelovancu.
parameter-traverse-direction__basic-rotation =
    .label = SMER PREMICA
    .label-aliases = SMER PREMIKANJA | SMER PREMIKA
choice-traverse-direction-negative = negativna smer premika
choice-traverse-direction-positive = pozitivna smer premika
choice-travel-directly-at-measuring-height = premikanje med merilnimi točkami na merilni višini
choice-travel-directly-at-clearance-height = premikanje med merilnimi točkami na varni višini

# --- two holes or studs ---
parameter-first-centre-main = 1. vrtina: središče 1. osi
    .label = 1. SREDIŠČE 1. OSI
    .help = Središče prve vrtine na glavni osi obdelovalne ravnine.
parameter-first-centre-minor = 1. vrtina: središče 2. osi
    .label = 1. SREDIŠČE 2. OSI
    .help = Središče prve vrtine na pomožni osi obdelovalne ravnine.
parameter-second-centre-main = 2. vrtina: središče 1. osi
    .label = 2. SREDIŠČE 1. OSI
    .help = Središče druge vrtine na glavni osi obdelovalne ravnine.
parameter-second-centre-minor = 2. vrtina: središče 2. osi
    .label = 2. SREDIŠČE 2. OSI
    .help = Središče druge vrtine na pomožni osi obdelovalne ravnine.
parameter-first-centre-main__rotation-two-studs = 1. čep: središče 1. osi
    .prompt = 1. čep: Sredina 1. osi?
    .help = Središče prvega čepa na glavni osi obdelovalne ravnine.
parameter-first-centre-minor__rotation-two-studs = 1. čep: središče 2. osi
    .help = Središče prvega čepa na pomožni osi obdelovalne ravnine.
parameter-second-centre-main__rotation-two-studs = 2. čep: središče 1. osi
    .help = Središče drugega čepa na glavni osi obdelovalne ravnine.
parameter-second-centre-minor__rotation-two-studs = 2. čep: središče 2. osi
    .help = Središče drugega čepa na pomožni osi obdelovalne ravnine.
parameter-first-stud-diameter = Premer 1. čepa
    .label = PREMER ČEPA 1
    .help = Približni premer prvega čepa. Vnesite raje preveliko kot premajhno vrednost.
parameter-second-stud-diameter = Premer 2. čepa
    .label = PREMER ČEPA 2
    .help = Približni premer drugega čepa. Vnesite raje preveliko kot premajhno vrednost.
parameter-measuring-height__rotation-two-studs = Merilna višina 1. čepa na osi tipalnega sistema
    .label = MERILNA VIŠINA 1
    .help = Višina, na kateri se izmeri 1. čep: koordinata središča tipalne krogle (točke dotika) na osi tipalnega sistema.
parameter-second-measuring-height = Merilna višina 2. čepa na osi tipalnega sistema
    .label = MERILNA VIŠINA 2
    .help = Višina, na kateri se izmeri 2. čep: koordinata središča tipalne krogle (točke dotika) na osi tipalnega sistema.

# --- what is done with the angle ---
parameter-reference-line-angle = Vnaprejšnja nastavitev rotacijskega kota
    .label = PREDNAST. ROT. KOTA
    .help = Kot referenčne premice, če se poševni položaj ne meri glede na glavno os, temveč glede na poljubno premico. Osnovna rotacija je tedaj razlika med izmerjeno vrednostjo in tem kotom.
parameter-basic-rotation-angle = Prednastavitev rotacijskega kota
    .label = PREDNAST. ROT. KOTA
    .help = Kot, na katerega se nastavi osnovna rotacija.
parameter-basic-rotation-row = Številka prednastavitve v preglednici
    .label = ŠT. V PREGLEDNICI
    .help = Številka v preglednici prednastavitev, pod katero se shrani ugotovljena osnovna rotacija. Pri vrednosti 0 jo krmiljenje shrani v meni ROT ročnega načina.
parameter-basic-rotation-row__rotation-two-holes =
    .help = Številka v preglednici prednastavitev, pod katero se shrani ugotovljena osnovna rotacija. Pri vrednosti 0 jo krmiljenje shrani v meni ROT ročnega načina. Če se poševni položaj izravna z vrtenjem okrogle mize ({ $q-misalignment-compensation } = 1), številka nima učinka in poševni položaj se kot vrednost kota ne shrani.
parameter-basic-rotation-row__rotation-two-studs =
    .help = Številka v preglednici prednastavitev, pod katero se shrani ugotovljena osnovna rotacija. Pri vrednosti 0 jo krmiljenje shrani v meni ROT ročnega načina. Če se poševni položaj izravna z vrtenjem okrogle mize ({ $q-misalignment-compensation } = 1), številka nima učinka in poševni položaj se kot vrednost kota ne shrani.
parameter-misalignment-compensation = Kompenzacija
    .label = KOMPENZACIJA
    .help = Določa, ali krmiljenje poševni položaj izravna z osnovno rotacijo ali z vrtenjem okrogle mize.
choice-compensate-by-basic-rotation = določitev osnovne rotacije
choice-compensate-by-rotary-table = vrtenje okrogle mize; krmiljenje poševnega položaja tedaj ne shrani, tudi če je v { $q-basic-rotation-row } navedena vrstica preglednice
parameter-zero-after-alignment = Ponastavitev po izravnavi
    .label = PONASTAVITEV
    .help = Določa, ali krmiljenje prikaz izravnane rotacijske osi nastavi na 0.
choice-keep-rotary-display = prikaz rotacijske osi se po izravnavi ne nastavi na 0
choice-zero-rotary-display = prikaz rotacijske osi se po izravnavi nastavi na 0
parameter-zero-or-row-after-alignment = Ponastavitev po izravnavi
    .label = PONASTAVITEV
    .help = Določa, ali krmiljenje prikaz osi C nastavi na 0 ali kotni zamik zapiše v stolpec C preglednice ničelnih točk.
choice-zero-c-axis-display = prikaz osi C se nastavi na 0
choice-offset-into-datum-row = izmerjeni kotni zamik se s predznakom zapiše v preglednico ničelnih točk; vrednost je številka vrstice. Če je tam zamik osi C že vnesen, krmiljenje izmerjeni zamik glede na predznak prišteje ali odšteje
parameter-compensation-axis = Os za izravnalni premik
    .label = IZRAVNALNA OS
    .help = Rotacijska os, s katero krmiljenje izravna izmerjeni poševni položaj.
choice-compensate-with-a-axis = izravnava poševnega položaja z rotacijsko osjo A
choice-compensate-with-b-axis = izravnava poševnega položaja z rotacijsko osjo B
choice-compensate-with-c-axis = izravnava poševnega položaja z rotacijsko osjo C
parameter-rotary-axis-row = Številka v preglednici
    .label = ŠT. V PREGLEDNICI
    .help = Številka v preglednici prednastavitev ali preglednici ničelnih točk, v kateri krmiljenje rotacijsko os nastavi na nič.
parameter-measured-value-transfer__rotation-by-rotary-axis =
    .help = Določa, ali se ugotovljena osnovna rotacija shrani v preglednico ničelnih točk ali v preglednico prednastavitev.
choice-rotation-into-datum-table = ugotovljena osnovna rotacija se kot zamik ničelne točke zapiše v aktivno preglednico ničelnih točk; referenčni sistem je aktivni koordinatni sistem obdelovanca
choice-rotation-into-preset-table = ugotovljena osnovna rotacija se zapiše v preglednico prednastavitev; referenčni sistem je strojni koordinatni sistem (REF-sistem)
parameter-alignment-angle = Referenčni kot (0 = glavna os)
    .prompt = Referenčni kot? (0=glavna os)
    .label = REFERENČNI KOT
    .help = Kot, na katerega krmiljenje poravna otipano premico.
condition-basic-rotation-chosen = se poševni položaj izravna z osnovno rotacijo ({ $q-misalignment-compensation } = 0)
condition-rotary-table-chosen = se poševni položaj izravna z vrtenjem okrogle mize ({ $q-misalignment-compensation } = 1)
condition-rotary-display-zeroed = je { $q-zero-after-alignment } = 1
condition-c-axis-compensates = je izbrana rotacijska os C ({ $q-compensation-axis } = 6)
parameter-probing-centre-minor__rotation-by-c-axis =
    .help = Središče vrtine na pomožni osi obdelovalne ravnine. Pri vrednosti 0 krmiljenje središče vrtine poravna s pozitivno osjo Y, pri vsaki drugi vrednosti z želenim položajem (kotom, ki izhaja iz središča vrtine).
parameter-probing-nominal-diameter__rotation-by-c-axis =
    .help = Približni premer krožnega žepa (vrtine). Vnesite raje premajhno kot preveliko vrednost.

parameter-new-datum-probe-axis__datum-inside-rectangle = Nova referenčna točka
parameter-traverse-to-clearance-height__datum-outside-corner =
    .label-aliases = PREMİK NA VARNO VIŠINO | PREMIK NA VARNOSTNO VIŠINO
parameter-traverse-to-clearance-height__datum-inside-corner =
    .label = PREMIK NA VARNOSTNO VIŠINO
    .label-aliases = PREMIK NA VARNO VIŠINO
parameter-traverse-to-clearance-height__datum-inside-corner__tnc320 =
    .label = PREMIK NA VARNO VIŠINO
    .label-aliases = PREMIK NA VARNOSTNO VIŠINO
