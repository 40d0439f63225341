# Turning: recess turning, recessing and threads.

# --- 841, 842, 840, 851, 852, 850 ---
cycle-simple-radial-recess-turning = Preprosto radialno vbodno rezkanje
    .nc = VB. REZK. PREPROSTO R.
    .purpose = Z vbodnim struženjem v vzdolžni smeri obdela pravokotne utore: grobo obdelovanje, fino obdelovanje ali oboje. Rezi grobega obdelovanja so vzporedni s koordinatno osjo.
cycle-extended-radial-recess-turning = Razširjeno radialno vbodno rezkanje
    .nc = RAZŠIRJENO RADIALNO STRUŽENJE
    .purpose = Z vbodnim struženjem v vzdolžni smeri obdela utore: grobo obdelovanje, fino obdelovanje ali oboje. Rezi grobega obdelovanja so vzporedni s koordinatno osjo. Utor ima lahko nagnjene stranske stene, zaobljene vogale ter posneti rob ali zaokrožitev na začetku in na koncu konture.
cycle-radial-contour-recess-turning = Radialno vbodno rezkanje konture
    .nc = VB. REZK. KONT, RAD.
    .purpose = Z vbodnim struženjem v vzdolžni smeri obdela utore poljubne oblike: grobo obdelovanje, fino obdelovanje ali oboje. Rezi grobega obdelovanja so vzporedni s koordinatno osjo.
cycle-simple-axial-recess-turning = Preprosto aksialno vbodno rezkanje
    .nc = VB. REZK. PREPR., AKS.
    .purpose = Z vbodnim struženjem v prečni smeri (na čelni površini) obdela pravokotne utore: grobo obdelovanje, fino obdelovanje ali oboje. Rezi grobega obdelovanja so vzporedni s koordinatno osjo.
cycle-extended-axial-recess-turning = Razširjeno aksialno vbodno rezkanje
    .nc = VB. REZK. RAZŠIRJENO AKSIALNO
    .purpose = Z vbodnim struženjem v prečni smeri obdela utore: grobo obdelovanje, fino obdelovanje ali oboje. Rezi grobega obdelovanja so vzporedni s koordinatno osjo. Utor ima lahko nagnjene stranske stene, zaobljene vogale ter posneti rob ali zaokrožitev na začetku in na koncu konture.
cycle-axial-contour-recess-turning = Aksialno vbodno rezkanje kontur
    .nc = VB. REZK. KONT, AKS.
    .purpose = Z vbodnim struženjem v prečni smeri obdela utore poljubne oblike: grobo obdelovanje, fino obdelovanje ali oboje. Rezi grobega obdelovanja so vzporedni s koordinatno osjo.

# --- 861, 862, 860, 871, 872, 870 ---
cycle-radial-recessing = Radialno struženje
    .nc = RADIALNO STRUŽENJE
    .purpose = Radialno struži pravokotne utore: grobo obdelovanje, fino obdelovanje ali oboje. Rezi grobega obdelovanja so vzporedni s koordinatno osjo.
cycle-extended-radial-recessing = Razširjeno radialno struženje
    .nc = RAZŠIRJENO RADIALNO STRUŽENJE
    .purpose = Radialno struži utore: grobo obdelovanje, fino obdelovanje ali oboje. Rezi grobega obdelovanja so vzporedni s koordinatno osjo. Utor ima lahko nagnjene stranske stene, zaobljene vogale ter posneti rob ali zaokrožitev na začetku in na koncu konture.
cycle-radial-contour-recessing = Radialno struženje konture
    .nc = RADIALNO STRUŽENJE KONTURE
    .purpose = Radialno struži utore poljubne oblike: grobo obdelovanje, fino obdelovanje ali oboje. Rezi grobega obdelovanja so vzporedni s koordinatno osjo.
cycle-axial-recessing = Aksialno struženje
    .nc = AKSIALNO STRUŽENJE
    .purpose = Aksialno (na čelni površini) struži pravokotne utore: grobo obdelovanje, fino obdelovanje ali oboje. Rezi grobega obdelovanja so vzporedni s koordinatno osjo.
cycle-extended-axial-recessing = Razširjeno aksialno struženje
    .nc = RAZŠIRJENO AKSIALNO STRUŽENJE
    .purpose = Aksialno (na čelni površini) struži utore: grobo obdelovanje, fino obdelovanje ali oboje. Rezi grobega obdelovanja so vzporedni s koordinatno osjo. Utor ima lahko nagnjene stranske stene, zaobljene vogale ter posneti rob ali zaokrožitev na začetku in na koncu konture.
cycle-axial-contour-recessing = Aksialno struženje konture
    .nc = AKSIALNO STRUŽENJE KONTURE
    .purpose = Aksialno (na čelni površini) struži utore poljubne oblike: grobo obdelovanje, fino obdelovanje ali oboje. Rezi grobega obdelovanja so vzporedni s koordinatno osjo.

# --- 831, 832, 830 ---
cycle-longitudinal-thread = Vzdolžni navoj
    .nc = NAVOJ VZDOLŽNO
    .purpose = Struži vzdolžne navoje z eno ali več stopnjami (začetki).
cycle-extended-thread = Razširjen navoj
    .nc = RAZŠIRJENI NAVOJ
    .nc-aliases = RAZŠIRJEN NAVOJ
    .purpose = Struži vzdolžne, čelne ali konične navoje z eno ali več stopnjami (začetki).
cycle-contour-parallel-thread = Navoj, vzporeden s konturo
    .nc = NAVOJ VZPOREDEN S KONTURO
    .purpose = Struži vzdolžne ali čelne navoje poljubne oblike z eno ali več stopnjami (začetki).

# --- roughing of grooves ---
step-take-tool-position-as-start = Krmiljenje položaj orodja ob priklicu cikla prevzame kot začetno točko cikla.
step-start-recess-at-contour-start-diameter = Če je koordinata X začetne točke manjša od premera na začetku konture { $q-contour-start-diameter }, krmiljenje orodje v smeri X pozicionira na { $q-contour-start-diameter } in cikel začne tam.
step-start-recess-at-contour-start-z = Če je koordinata Z začetne točke manjša od začetka konture Z { $q-contour-start-z }, krmiljenje orodje v smeri Z pozicionira na { $q-contour-start-z } in cikel začne tam.
step-start-recess-at-contour-point-x = Če je koordinata X začetne točke manjša od koordinate začetne točke konture, krmiljenje orodje v smeri X pozicionira na začetno točko konture in cikel začne tam.
step-start-recess-at-contour-point-z = Če je koordinata Z začetne točke manjša od koordinate začetne točke konture, krmiljenje orodje v smeri Z pozicionira na začetno točko konture in cikel začne tam.
step-rapid-to-first-recess-z = Krmiljenje v hitrem teku pozicionira orodje v smeri Z (prvi položaj vboda).
step-rapid-to-first-recess-x = Krmiljenje v hitrem teku pozicionira orodje v smeri X (prvi položaj vboda).
step-recess-from-start-to-first-depth = Krmiljenje od začetne točke cikla izvede vbod do prve globine primika.
step-recess-to-first-depth = Krmiljenje izvede vbod do prve globine primika.
step-rough-groove-lengthwise = Krmiljenje območje med začetnim položajem in končno točko grobo obdela v vzdolžni smeri s pomikom { $q-turning-roughing-feed }.
step-rough-groove-crosswise = Krmiljenje območje med začetnim položajem in končno točko grobo obdela v prečni smeri s pomikom { $q-turning-roughing-feed }.
step-choose-side-of-next-recess = Kje se izvede naslednji primik, določa smer obdelave { $q-recess-direction }:
say-lift-off-and-return = { $q-recess-direction } = 1 (samo ena smer): krmiljenje orodje dvigne za varnostno razdaljo, ga v hitrem teku vrne in z definiranim pomikom znova primakne h konturi
say-infeed-at-both-sides = { $q-recess-direction } = 0 (obe smeri): primik se izvede na obeh straneh
step-recess-to-next-depth = Orodje izvede vbod do naslednje globine primika.
until-groove-depth-reached = ni dosežena globina utora
step-recess-at-both-walls = Krmiljenje orodje znova pozicionira na varnostno razdaljo in na vsaki stranski steni izvede en vbod.
step-infeed-parallel-to-axis = Krmiljenje v hitrem teku izvede primik, vzporeden s koordinatno osjo. Stranski primik je 0,8-kratna širina rezila.
step-recess-radially = Krmiljenje območje med začetnim položajem in končno točko obdela v radialni smeri s pomikom { $q-turning-roughing-feed }.
step-recess-axially = Krmiljenje območje med začetnim položajem in končno točko obdela v aksialni smeri s pomikom { $q-turning-roughing-feed }.
until-groove-width-reached = ni dosežena širina utora
until-groove-shape-reached = ni dosežena oblika utora

# --- finishing of grooves ---
step-rapid-to-first-flank = Krmiljenje pozicionira orodje v hitrem teku na prvi bok utora.
step-rapid-again-to-first-flank = { step-rapid-to-first-flank }
step-rapid-to-second-flank = Krmiljenje pozicionira orodje v hitrem teku na drugi bok utora.
step-finish-groove-wall = Krmiljenje fino obdela stransko steno utora s pomikom { $q-turning-finishing-feed }.
step-finish-second-groove-wall = { step-finish-groove-wall }
step-finish-groove-walls = Krmiljenje fino obdela stranski steni utora s pomikom { $q-turning-finishing-feed }.
step-finish-groove-floor = Krmiljenje fino obdela dno utora z definiranim pomikom.
step-finish-groove-floor-or-all = Krmiljenje fino obdela dno utora z definiranim pomikom:
say-finish-whole-groove = če je za vogal konture vnesen polmer { $q-contour-corner-radius }, krmiljenje z enim prehodom fino obdela celoten utor
say-finish-floor-only = sicer samo dno
step-retract-from-groove = Krmiljenje umakne orodje v hitrem teku.
step-finish-half-of-width = Krmiljenje z definiranim pomikom fino obdela polovico širine utora.
step-finish-other-half-of-width = Krmiljenje z definiranim pomikom fino obdela drugo polovico širine utora.
step-finish-half-of-groove = Krmiljenje z definiranim pomikom fino obdela polovico utora.
step-finish-other-half-of-groove = Krmiljenje z definiranim pomikom fino obdela drugo polovico utora.

# --- threads ---
step-move-before-thread-and-infeed = Krmiljenje pozicionira orodje v hitrem teku na varnostno razdaljo pred navojem in izvede primik.
step-cut-thread-parallel-to-axis = Krmiljenje izvede vzdolžni rez, vzporeden z osjo. Pri tem pomik in število vrtljajev vretena uskladi tako, da nastane definirani korak.
step-cut-thread-along-line = Krmiljenje reže navoj med začetno in končno točko. Pri tem pomik in število vrtljajev vretena uskladi tako, da nastane definirani korak.
step-cut-thread-along-contour = Krmiljenje reže navoj vzporedno z definirano konturo navoja. Pri tem pomik in število vrtljajev vretena uskladi tako, da nastane definirani korak.
step-lift-off-thread = Krmiljenje v hitrem teku dvigne orodje za varnostno razdaljo.
step-infeed-at-angle = Krmiljenje izvede primik. Primiki potekajo pod kotom primika { $q-thread-infeed-angle }.
until-thread-depth-reached = ni dosežena globina navoja
step-make-air-cuts = Krmiljenje izvede toliko praznih rezov, kot jih določa { $q-number-of-air-cuts }.
step-infeed-for-next-start = Za naslednjo stopnjo navoja krmiljenje vrne orodje na mesto prvega primika. Rez se začne pri kotu vretena, ki je zamaknjen za razmik stopenj.
until-all-thread-starts-cut = ni narezanih toliko stopenj navoja, kot jih določa { $q-number-of-thread-starts }

# --- conditions ---
condition-cutting-limit-wanted = je { $q-cutting-limit } = 1
condition-taper-angle-given = { $q-taper-dimensioning } določa stožec s kotom
condition-start-diameter-given = { $q-taper-dimensioning } določa stožec s premerom na začetku konture
condition-start-z-given = { $q-taper-dimensioning } določa stožec s koordinato Z začetka konture
condition-end-diameter-given = { $q-taper-dimensioning } določa stožec s premerom na koncu konture
condition-end-z-given = { $q-taper-dimensioning } določa stožec s koordinato Z konca konture

# --- errors ---
guard-recess-offset-too-great = Stranski zamik je večji od 80{"\u00A0"}% učinkovite širine rezila, to je širine rezila, zmanjšane za dvakratni polmer rezila.

# --- notes: grooves ---
note-recess-turning-alternates = Pri vbodnem struženju se izmenjujejo vbodi na globino primika in grobi rezi. Obdelava zato zahteva čim manj dvigov in primikov.
note-groove-extended-scope = Razširjen obseg funkcij: na začetku in na koncu konture je mogoče dodati posneti rob ali zaokrožitev; za stranski steni utora je mogoče definirati kota; v vogalih konture je mogoče dodati polmere.
note-recess-cuts-get-shorter = Po drugem primiku krmiljenje vsak nadaljnji rez skrajša za 0,1{"\u00A0"}mm. To zmanjša stransko obremenitev orodja. Če je v ciklu vnesena širina zamika { $q-recess-offset-width }, se rez namesto tega skrajša za to vrednost. Preostali material se na koncu vbadanja odstrani z enim vbodnim gibom. Če stranski zamik presega 80{"\u00A0"}% učinkovite širine rezila (širina rezila − 2 × polmer rezila), krmiljenje prikaže sporočilo o napaki.
title-groove-with-chamfers = Utor s posnetima robovoma v struženem segmentu (celoten program)

# --- notes: threads ---
note-threads-with-several-starts = S ciklom je mogoče izdelati navoje z eno ali več stopnjami (začetki).
note-standard-thread-depth = Če v ciklu globina navoja ni vnesena, cikel uporabi standardno globino navoja.
note-standard-thread-depth__longitudinal-thread = Če v ciklu globina navoja ni vnesena, cikel uporabi globino navoja po standardu ISO 1502.
note-thread-outside-or-inside = Cikel je mogoče uporabiti za zunanjo in za notranjo obdelavo.
note-extended-thread-scope = Razširjen obseg funkcij: izbrati je mogoče vzdolžni ali čelni navoj; različne konične navoje določajo vrsta dimenzioniranja in kot stožca ter začetna točka konture X; pot zagona in pot prekoračitve določata razdalji, na katerih os pomika pospešuje in zavira.
note-overrun-after-contour = Nevarnost kolizije! Cikel { $cycle } se po programirani konturi nadaljuje še za pot prekoračitve { $q-overrun-path }. Upoštevajte razpoložljivi prostor.
note-clearance-is-starting-path = Krmiljenje kot pot zagona uporabi varnostno razdaljo { $q-thread-clearance }. Biti mora dovolj dolga, da osi pomika pospešijo na potrebno hitrost.
note-pitch-is-overrun-path = Krmiljenje kot pot prekoračitve uporabi korak navoja { $q-turned-thread-pitch }. Biti mora dovolj dolg, da se lahko osi pomika zavrejo.
note-extended-thread-has-paths = Cikel 832 ima parametra za pot zagona in pot prekoračitve.
note-starting-path-long-enough = Pot zagona { $q-starting-path } mora biti dovolj dolga, da osi pomika pospešijo na potrebno hitrost.
note-overrun-path-long-enough = Pot prekoračitve { $q-overrun-path } mora biti dovolj dolga, da se lahko osi pomika zavrejo.
note-paths-outside-contour = Tako pot zagona kot pot prekoračitve ležita zunaj definirane konture.
note-override-while-thread-cutting = Med rezanjem navoja vrtljivi gumb za pomik ne deluje. Vrtljivi gumb za število vrtljajev deluje v mejah, ki jih določi proizvajalec stroja. Upoštevajte priročnik za stroj.
note-thread-with-separate-holder = Na nekaterih vrstah strojev stružno orodje ni vpeto v rezkalno vreteno, temveč v ločeno držalo ob njem. Tam stružnega orodja ni mogoče zavrteti za 180°, na primer za rezanje zunanjih in notranjih navojev z istim orodjem. Če želite na takem stroju zunanje orodje uporabiti za notranjo obdelavo, obdelujte v negativnem območju premera (−X) in obrnite smer vrtenja obdelovanca. Pri predpozicioniranju v negativnem območju premera krmiljenje obrne učinek položaja navoja { $q-thread-position }: tedaj 1 pomeni zunanji, 0 pa notranji navoj.
note-thread-retracts-directly = Nevarnost kolizije! Orodje se po neposredni poti umakne na začetni položaj. Vedno ga predpozicionirajte tako, da lahko krmiljenje na koncu cikla začetno točko doseže brez kolizije.

# --- notes: contours from a subprogram ---
note-contour-by-cycle-14 = Kontura je opisana v podprogramu, s funkcijami poti ali funkcijami FK. Pred priklicem cikla programirajte cikel 14 (kontura), ki določi številko podprograma.
note-local-parameters-in-contour = Če so v konturnem podprogramu uporabljeni lokalni parametri QL, jih je treba prirediti ali izračunati prav tako v konturnem podprogramu.
note-cutting-limit-limits-area = Omejitev reza omeji območje konture, ki se obdela. Poti primika in odmika lahko segajo čez omejitev reza.
note-cutting-limit-by-tool-position = Na delovanje omejitve reza vpliva položaj orodja pred priklicem cikla: krmiljenje odstrani material na tisti strani omejitve reza, na kateri orodje stoji pred priklicem cikla.
