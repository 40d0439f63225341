# Parametri ciklov, ki merijo kote, čepe, pravokotnike, širine, koordinate, krožne luknje in ravnine.

# --- 422 ---
parameter-stud-greatest-diameter = Največji premer čepa
    .label = NAJVEČJA VREDNOST
parameter-stud-least-diameter = Najmanjši premer čepa
    .label = NAJMANJŠA VREDNOST

# --- 423, 424 ---
parameter-probing-first-side-length = 1. stranska dolžina
    .label = 1. STRANSKA DOLŽINA
parameter-probing-second-side-length = 2. stranska dolžina
    .label = 2. STRANSKA DOLŽINA
parameter-first-side-greatest-length = Največja vrednost 1. stranske dolžine
    .label = NAJVEČJA VREDNOST 1. STRANI
parameter-first-side-least-length = Najmanjša vrednost 1. stranske dolžine
    .label = NAJMANJŠA VREDNOST 1. STRANI
parameter-second-side-greatest-length = Največja vrednost 2. stranske dolžine
    .label = NAJVEČJA VREDNOST 2. STRANI
parameter-second-side-least-length = Najmanjša vrednost 2. stranske dolžine
    .label = NAJMANJŠA VREDNOST 2. STRANI
parameter-first-side-greatest-length__tnc320 =
    .label = NAJV. VREDNOST 1. STRANI
    .label-aliases = NAJVEČJA VREDNOST 1. STRANI
parameter-first-side-greatest-length__tnc426-430 =
    .label = NAJV. VREDNOST 1. STRANI
    .label-aliases = NAJVEČJA VREDNOST 1. STRANI
parameter-first-side-least-length__tnc320 =
    .label = NAJM. VREDNOST 1. STRANI
    .label-aliases = NAJMANJŠA VREDNOST 1. STRANI
parameter-first-side-least-length__tnc426-430 =
    .label = NAJM. VREDNOST 1. STRANI
    .label-aliases = NAJMANJŠA VREDNOST 1. STRANI
parameter-second-side-greatest-length__tnc320 =
    .label = NAJV. VREDNOST 2. STRANI
    .label-aliases = NAJVEČJA VREDNOST 2. STRANI
parameter-second-side-greatest-length__tnc426-430 =
    .label = NAJV. VREDNOST 2. STRANI
    .label-aliases = NAJVEČJA VREDNOST 2. STRANI
parameter-second-side-least-length__tnc320 =
    .label = NAJM. VREDNOST 2. STRANI
    .label-aliases = NAJMANJŠA VREDNOST 2. STRANI
parameter-second-side-least-length__tnc426-430 =
    .label = NAJM. VREDNOST 2. STRANI
    .label-aliases = NAJMANJŠA VREDNOST 2. STRANI

# --- 425, 426 ---
parameter-probing-start-main = Začetna točka 1. osi
    .label = ZAČETNA TOČKA 1. OSI
parameter-probing-start-minor = Začetna točka 2. osi
    .label = ZAČETNA TOČKA 2. OSI
parameter-second-measurement-offset = Zamik za 2. meritev
    .label = ZAMIK 2. MERITVE
parameter-nominal-length = Želena dolžina
    .label = ŽELENA DOLŽINA
parameter-greatest-dimension = Največja vrednost
    .label = NAJVEČJA VREDNOST
parameter-least-dimension = Najmanjša vrednost
    .label = NAJMANJŠA VREDNOST
parameter-traverse-to-clearance-height__measure-slot-width =
    .label = PREMIK NA VARNOSTNO VIŠINO
    .label-aliases = PREMIK NA VARNO VIŠINO

# --- 427 ---
parameter-measuring-axis__measure-coordinate = Merilna os (1...3: 1=glavna os)
parameter-traverse-direction__measure-coordinate =
    .label = SMER PREMIKA
    .label-aliases = SMER PREMIKANJA | SMER PREMICA

# --- 430 ---
parameter-first-hole-angle = Kot 1. vrtine
    .label = KOT 1. VRTINE
parameter-second-hole-angle = Kot 2. vrtine
    .label = KOT 2. VRTINE
parameter-third-hole-angle = Kot 3. vrtine
    .label = KOT 3. VRTINE

# --- 420, 431 ---
parameter-first-point-tool = 1. merilna točka 3. osi
    .label = 1. TOČKA 3. OSI
parameter-second-point-tool = 2. merilna točka 3. osi
    .label = 2. TOČKA 3. OSI
parameter-third-point-tool = 3. merilna točka 3. osi
    .label = 3. TOČKA 3. OSI

# --- 417 ---
parameter-new-datum-probe-axis__datum-probe-axis = Nova referenčna točka

# --- 418 ---
parameter-third-centre-main = 3. središče 1. osi
    .label = 3. SREDIŠČE 1. OSI
parameter-third-centre-minor = 3. središče 2. osi
    .label = 3. SREDIŠČE 2. OSI
parameter-fourth-centre-main = 4. središče 1. osi
    .label = 4. SREDIŠČE 1. OSI
parameter-fourth-centre-minor = 4. središče 2. osi
    .label = 4. SREDIŠČE 2. OSI

# --- 419 ---
parameter-measuring-axis__datum-one-axis = Merilna os (1...3: 1=glavna os)
parameter-traverse-direction__datum-one-axis =
    .label = SMER PREMIKA
    .label-aliases = SMER PREMIKANJA | SMER PREMICA
parameter-new-datum-one-axis = Nova referenčna točka
    .label = REFERENČNA TOČKA

# --- 1, 3 ---
parameter-polar-probing-axis = Tipalna os
parameter-polar-probing-angle = Kot tipanja
    .word = KOT:
parameter-polar-probing-angle__measuring = Tipalni kot
parameter-greatest-measuring-path = Najdaljša pot meritve
    .word = ABST
parameter-measuring-feed = Merilni pomik
parameter-greatest-retraction-path = Najdaljša pot odmika
parameter-probing-reference-system = Referenčni sistem? (0=IST/1=REF)
    .word = REFERENČNI SISTEM:
parameter-probing-error-mode = Stanje sporočila o napaki (0 = IZKLOP/1 = VKLOP)
