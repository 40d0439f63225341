# Parameters of pockets, slots, studs, line patterns and multipass milling: name, label in the NC block, help.

# --- pockets, slots and studs ---
parameter-circle-diameter = Premer kroga
    .label = PREMER KROGA
parameter-slot-length = Dolžina utora
    .label = DOLŽINA UTORA
parameter-milled-slot-width = Širina utora
    .label = ŠIRINA UTORA
parameter-angle-of-rotation__slot = Rot. položaj
parameter-angle-of-rotation__line-pattern = Rot. položaj
parameter-slot-position = Položaj utora (0/1/2/3/4)
    .label = POLOŽAJ UTORA
parameter-slot-position-reference = Referenca za položaj utora (0/1/2/3)
    .label = REFEREN. POL. UTORA
parameter-slot-starting-angle = Začetni kot
    .label = ZAČETNI KOT
parameter-slot-opening-angle = Odpiralni kot utora
    .label = ODPRTI KOT
parameter-stud-first-side-length = 1. stranska dolžina
    .label = 1. STRANSKA DOLŽINA
parameter-blank-first-side-length = Stranska dolžina surovca 1
    .label = MERE SUROVCA 1
parameter-stud-second-side-length = 2. stranska dolžina
    .label = 2. STRANSKA DOLŽINA
parameter-blank-second-side-length = Stranska dolžina surovca 2
    .label = MERE SUROVCA 2
parameter-stud-position = Položaj čepa
    .label = POLOŽAJ ČEPA
parameter-stud-approach-position = Položaj primika (0-4)
    .label = POLOŽAJ PRIMIKA
parameter-finished-part-diameter = Končni premer
    .label = PREMER IZDELKA
parameter-blank-diameter = Premer surovca
    .label = PREMER SUROVCA
parameter-stud-starting-angle = Začetni kot
    .label = ZAČETNI KOT
parameter-plunging-feed__circular-pocket =
    .label = GLOBINSKI PRIMIK
parameter-plunging-feed__slot =
    .label = GLOBINSKI PRIMIK
parameter-plunging-feed__circular-slot =
    .label = GLOBINSKI PRIMIK
parameter-plunging-feed__rectangular-stud =
    .label = GLOBINSKI PRIMIK
    .label-aliases = POM. PRI GLOB. PRIM.
parameter-plunging-feed__circular-stud =
    .label = GLOBINSKI PRIMIK

# --- line patterns ---
parameter-pattern-spacing-main = Razdalja na 1. osi
    .label = RAZDALJA NA 1. OSI
parameter-pattern-spacing-minor = Razdalja 2. osi
    .label = RAZDALJA NA 2. OSI
parameter-number-of-columns = Število stolpcev
    .label = ŠTEVILO STOLPCEV
parameter-number-of-lines = Število vrstic
    .label = ŠTEVILO VRSTIC

# --- multipass milling of surfaces ---
parameter-starting-point-main = Začetna točka 1. osi
    .label = ZAČETNA TOČKA 1. OSI
    .label-aliases = ZAČETNATOČKA 1. OSI
parameter-starting-point-minor = Začetna točka 2. osi
    .label = ZAČETNA TOČKA 2. OSI
    .label-aliases = ZAČETNATOČKA 2. OSI
parameter-starting-point-tool = Začetna točka 3. osi
    .label = ZAČETNA TOČKA 3. OSI
    .label-aliases = ZAČETNATOČKA 3. OSI
parameter-number-of-cuts = Število rezov
    .label = ŠTEVILO REZOV
parameter-stepover-feed = Prečni pomik
    .label = PREČNI POMIK
parameter-surface-second-point-main = 2. točka 1. osi
    .label = 2. TOČKA 1. OSI
parameter-surface-second-point-minor = 2. točka 2. osi
    .label = 2. TOČKA 2. OSI
parameter-surface-second-point-tool = 2. točka 3. osi
    .label = 2. TOČKA 3. OSI
parameter-surface-third-point-main = 3. točka 1. osi
    .label = 3. TOČKA 1. OSI
parameter-surface-third-point-minor = 3. točka 2. osi
    .label = 3. TOČKA 2. OSI
parameter-surface-third-point-tool = 3. točka 3. osi
    .label = 3. TOČKA 3. OSI
parameter-surface-fourth-point-main = 4. točka 1. osi
    .label = 4. TOČKA 1. OSI
parameter-surface-fourth-point-minor = 4. točka 2. osi
    .label = 4. TOČKA 2. OSI
parameter-surface-fourth-point-tool = 4. točka 3. osi
    .label = 4. TOČKA 3. OSI
parameter-face-milling-strategy = Obdelovalna strategija (0/1/2)
    .label = STRATEGIJA
parameter-end-point-tool = Končna točka 3. osi
    .label = KONČNA TOČKA 3. OSI
parameter-max-plunging-depth = Maks. globina primika
    .label = MAKS. DOSTAVNA GLOBINA
parameter-floor-allowance__face-milling =
    .label = PREDIZMERA GLOBINA
parameter-max-path-overlap = Največji faktor prekrivanja poti
    .label = MAKS. PREKRIVANJE
parameter-finishing-feed__face-milling =
    .label = POMIK PRI FINEM REZK.
parameter-pre-positioning-feed__face-milling = Pomik pri predpozicioniranju
parameter-side-clearance = Stranska varnostna razdalja
    .label = STRANSKA VARNOSTNA RAZDALJA

# --- coordinate transforms ---
parameter-mirrored-axes = Zrcaljena os
    .prompt = Zrcaljena os?
parameter-scaling-factor = Faktor
    .prompt = Faktor?
parameter-axis-scaling-factors = Os in faktor
parameter-axis-scaling-centre = Koordinate središča
parameter-tilting-angles = Rotacijska os in kot
    .prompt = Rotacijska os in kot?
parameter-tilting-feed = Pomik
    .prompt = Pomik? F=
parameter-tilting-clearance = Varnostna razdalja
    .prompt = Varnostna razdalja?

# --- special functions ---
parameter-programmed-dwell = Čas zadrževanja v sekundah
    .word = ČAS ZADRŽ.
parameter-program-to-call = Ime programa
parameter-orientation-angle = Kot usmeritve
    .word = KOT
parameter-contour-tolerance = Tolerančna vrednost T
parameter-hsc-mode = NAČIN HSC, fino rezkanje=0, grobo rezkanje=1
parameter-rotary-axis-tolerance = Toleranca za rotacijske osi TA
