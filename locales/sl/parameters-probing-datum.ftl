# Parametri ciklov za poševni položaj in referenčne točke: ime, oznaka v NC-stavku, pomoč.

# --- referenčne točke: kar se razlikuje od izvrtine ---
parameter-new-datum-probe-axis__datum-inside-rectangle = Nova referenčna točka

# --- 408 in 409 ---
parameter-slot-width = Širina utora
    .label = ŠIRINA UTORA
parameter-ridge-width = Širina stojine
    .label = ŠIRINA STOJINE
parameter-datum-row-number__datum-slot-centre = Številka v preglednici
parameter-datum-row-number__datum-ridge-centre = Številka v preglednici
parameter-new-datum-measuring-axis = Nova referenčna točka
    .label = REFERENČNA TOČKA

# --- 414 in 415 ---
parameter-third-point-main = 3. merilna točka 1. osi
    .label = 3. TOČKA 1. OSI
parameter-third-point-minor = 3. merilna točka 2. osi
    .label = 3. TOČKA 2. OSI
parameter-point-distance-main = Razdalja na 1. osi
    .label = RAZDALJA NA 1. OSI
parameter-point-distance-minor = Razdalja na 2. osi
    .label = RAZDALJA NA 2. OSI
parameter-corner-number = Rob
    .label = ROB
parameter-corner-basic-rotation = Izvedba osnovnega vrtenja
    .label = OSNOVNA ROTACIJA
parameter-traverse-to-clearance-height__datum-outside-corner =
    .label-aliases = PREMİK NA VARNO VIŠINO | PREMIK NA VARNOSTNO VIŠINO
parameter-traverse-to-clearance-height__datum-inside-corner =
    .label = PREMIK NA VARNOSTNO VIŠINO
    .label-aliases = PREMIK NA VARNO VIŠINO
parameter-traverse-to-clearance-height__datum-inside-corner__tnc320 =
    .label = PREMIK NA VARNO VIŠINO
    .label-aliases = PREMIK NA VARNOSTNO VIŠINO

# --- dve točki na premici ---
parameter-first-point-main = 1. merilna točka 1. osi
    .label = 1. TOČKA 1. OSI
parameter-first-point-minor = 1. merilna točka 2. osi
    .label = 1. TOČKA 2. OSI
parameter-second-point-main = 2. merilna točka 1. osi
    .label = 2. TOČKA 1. OSI
parameter-second-point-minor = 2. merilna točka 2. osi
    .label = 2. TOČKA 2. OSI
parameter-measuring-axis = Merilna os
    .label = MERILNA OS
parameter-measuring-axis__rotation-by-rotary-axis = Merilna os (1...3: 1=glavna os)
parameter-traverse-direction = Smer premika 1
    .label = SMER PREMIKANJA
    .label-aliases = SMER PREMICA | SMER PREMIKA
parameter-traverse-direction__basic-rotation =
    .label = SMER PREMICA
    .label-aliases = SMER PREMIKANJA | SMER PREMIKA

# --- dve vrtini ali dva čepa ---
parameter-first-centre-main = 1. vrtina: središče 1. osi
    .label = 1. SREDIŠČE 1. OSI
parameter-first-centre-minor = 1. vrtina: središče 2. osi
    .label = 1. SREDIŠČE 2. OSI
parameter-second-centre-main = 2. vrtina: središče 1. osi
    .label = 2. SREDIŠČE 1. OSI
parameter-second-centre-minor = 2. vrtina: središče 2. osi
    .label = 2. SREDIŠČE 2. OSI
parameter-first-centre-main__rotation-two-studs = 1. čep: Sredina 1. osi
parameter-first-centre-minor__rotation-two-studs = 1. čep: središče 2. osi
parameter-second-centre-main__rotation-two-studs = 2. čep: središče 1. osi
parameter-second-centre-minor__rotation-two-studs = 2. čep: središče 2. osi
parameter-first-stud-diameter = Premer 1. čepa
    .label = PREMER ČEPA 1
parameter-second-stud-diameter = Premer 2. čepa
    .label = PREMER ČEPA 2
parameter-measuring-height__rotation-two-studs = Merilna višina 1. čepa na osi tipalnega sistema
    .label = MERILNA VIŠINA 1
parameter-second-measuring-height = Merilna višina 2. čepa na osi tipalnega sistema
    .label = MERILNA VIŠINA 2

# --- kaj se zgodi s kotom ---
parameter-reference-line-angle = Vnaprejšnja nastavitev rotacijskega kota
    .label = PREDNAST. ROT. KOTA
parameter-basic-rotation-angle = Prednastavitev rotacijskega kota
    .label = PREDNAST. ROT. KOTA
parameter-basic-rotation-row = Številka prednastavitve v preglednici
    .label = ŠT. V PREGLEDNICI
parameter-misalignment-compensation = Kompenzacija
    .label = KOMPENZACIJA
parameter-zero-after-alignment = Ponastavitev po izravnavi
    .label = PONASTAVITEV
parameter-zero-or-row-after-alignment = Ponastavitev po izravnavi
    .label = PONASTAVITEV
parameter-compensation-axis = Os za izravnalni premik
    .label = IZRAVNALNA OS
parameter-rotary-axis-row = Številka v preglednici
    .label = ŠT. V PREGLEDNICI
parameter-alignment-angle = Referenčni kot? (0=glavna os)
    .label = REFERENČNI KOT
