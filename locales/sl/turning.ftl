# Turning: longitudinal and face.

# --- common sentences of the turning cycles ---
group-turning-roughing = Grobo obdelovanje
group-turning-finishing = Fino obdelovanje
step-rapid-radial-infeed = Krmiljenje v hitrem teku izvede primik v radialni smeri, vzporedno s koordinatno osjo. Primik izračuna iz največje rezalne globine { $q-max-cutting-depth }.
step-cut-longitudinally = Krmiljenje območje med začetnim položajem in končno točko obdela v vzdolžni smeri s pomikom { $q-turning-roughing-feed }.
step-retract-by-infeed = Krmiljenje z definiranim pomikom umakne orodje za vrednost primika:
say-follow-contour-within-infeed = pri { $q-contour-smoothing } = 0 vzdolž konture, znotraj območja primika
say-lift-off-at-45-degrees = sicer pod kotom 45°
step-rapid-to-start-of-cut = Krmiljenje vrne orodje v hitrem teku na začetek reza.
until-turning-contour-finished = kontura ni končana
step-smooth-after-last-cut = Pri { $q-contour-smoothing } = 1 krmiljenje po zadnjem rezu zgladi celotno konturo.
step-rapid-to-starting-point-of-cycle = Krmiljenje vrne orodje v hitrem teku na začetno točko cikla.
step-rapid-back-after-finishing = { step-rapid-to-starting-point-of-cycle }
step-rapid-in-z-by-clearance = Krmiljenje premakne orodje v smeri Z v hitrem teku za varnostno razdaljo { $q-turning-clearance }.
step-rapid-paraxial-infeed = Krmiljenje v hitrem teku izvede primik, vzporeden s koordinatno osjo.
step-finish-turned-contour = Krmiljenje fino obdela konturo obdelovanca s pomikom { $q-turning-finishing-feed }.
step-retract-by-clearance = Krmiljenje z definiranim pomikom umakne orodje za varnostno razdaljo { $q-turning-clearance }.
guard-turning-mode-missing = Cikle za struženje je mogoče izvajati samo v načinu struženja FUNCTION MODE TURN.
note-turning-mode-only = Cikle za struženje je mogoče uporabljati samo v načinu struženja FUNCTION MODE TURN.
note-program-before-turning-cycle = Pred priklicem cikla vedno programirajte: način struženja FUNCTION MODE TURN, priklic orodja TOOL CALL, smer vrtenja stružnega vretena (na primer M303), število vrtljajev ali rezalno hitrost s FUNCTION TURNDATA SPIN, M136, če uporabljate pomike na vrtljaj (mm/vrt), pozicionirni stavek na primerno začetno točko (na primer L X+130 Y+0 R0 FMAX) in cikel 800, ki prilagodi koordinatni sistem in usmeri orodje.
note-call-turning-cycle = Cikel prikličite s CYCL CALL ali z M99.
note-outside-or-inside-by-tool-position = Če je orodje ob priklicu cikla zunaj konture, ki se obdeluje, cikel izvede zunanjo obdelavo; če je znotraj nje, notranjo.
note-outside-or-inside-by-diameters = Če je začetni premer { $q-contour-start-diameter } večji od končnega premera { $q-contour-end-diameter }, cikel izvede zunanjo obdelavo; če je manjši, notranjo.
note-outside-or-inside-by-contour = Če je koordinata začetne točke konture večja od koordinate njene končne točke, cikel izvede zunanjo obdelavo; če je manjša, notranjo.
note-check-after-change-of-side = Po menjavi med zunanjo in notranjo obdelavo preverite nastavitve orodja in smer vrtenja.
note-area-from-tool-position-to-end-point = Pri grobem obdelovanju cikel obdela območje od položaja orodja ob priklicu cikla (začetne točke cikla) do končne točke, definirane v ciklu.
note-position-at-starting-position = Pred priklicem cikla programirajte pozicionirni stavek na začetni položaj s popravkom polmera R0.
note-position-at-safe-position = Pred priklicem cikla programirajte pozicionirni stavek na varen položaj s popravkom polmera R0.
note-tool-position-determines-area = Položaj orodja ob priklicu cikla (začetna točka cikla) določa velikost območja, ki se obdela.
note-tool-position-influences-area = Položaj orodja ob priklicu cikla (začetna točka cikla) vpliva na območje, ki se obdela.
note-pre-positioning-influences-time = Predpozicioniranje orodja močno vpliva na delovno območje cikla in s tem na čas obdelave. Pri grobem obdelovanju je začetna točka cikla položaj orodja ob priklicu cikla. Krmiljenje območje obdelave izračuna iz začetne točke in iz končne točke ali konture, definirane v ciklu. Če je začetna točka v tem območju, nekateri cikli orodje najprej premaknejo na varnostno razdaljo.
note-finishing-approach-from-envelope = Nevarnost za orodje in obdelovanec! Pri finem obdelovanju cikel orodje samodejno premakne na začetno točko. Način primika je odvisen od tega, ali je orodje ob priklicu cikla znotraj ali zunaj ovojne konture; to je programirana kontura, povečana za varnostno razdaljo { $q-turning-clearance }. Če je orodje znotraj ovojne konture, se z definiranim pomikom po neposredni poti premakne na začetni položaj, kar lahko poškoduje konturo: orodje pozicionirajte tako, da lahko začetni položaj doseže, ne da bi poškodovalo konturo. Če je orodje zunaj ovojne konture, se do nje premakne v hitrem teku, znotraj nje pa s programiranim pomikom.
note-cutting-geometry-considered = Krmiljenje upošteva rezalno geometrijo orodja ({ $mp-tool-orientation }, { $mp-cutting-edge-radius }, { $mp-point-angle }, { $mp-tool-angle }), tako da definiranih konturnih elementov ni mogoče poškodovati. Če z aktivnim orodjem konture ni mogoče v celoti obdelati, krmiljenje prikaže opozorilo.
note-feed-rates-with-m136 = Če je pred ciklom programirana funkcija M136, krmiljenje pomike v ciklu upošteva v mm/vrt, brez M136 pa v mm/min.
note-inclined-turning = Če se cikel izvaja med obdelavo z nagnjenim orodjem (M144), se koti orodja glede na konturo spremenijo. Krmiljenje to spremembo samodejno upošteva in tako tudi pri nagnjenem orodju nadzira, da se kontura ne poškoduje.
note-blank-form-update = S sledenjem surovcu (FUNCTION TURNDATA BLANK) krmiljenje prepozna že obdelana območja in vse poti primika in odmika prilagodi posamezni obdelavi. Na voljo je samo v obdelovalnem ciklu v načinu struženja; surovec mora biti zaprta kontura (začetni položaj = končni položaj) in je presek rotacijsko simetričnega telesa.
note-finished-part-beyond-blank = Pri sledenju surovcu krmiljenje primik in odmik prilagodi trenutnemu surovcu. Če območja končnega izdelka segajo čez surovec, se lahko poškodujeta obdelovanec in orodje.
step-rapid-axial-infeed = Krmiljenje v hitrem teku izvede primik v aksialni smeri, vzporedno s koordinatno osjo. Primik izračuna iz največje rezalne globine { $q-max-axial-cutting-depth }.
step-cut-across-axis = Krmiljenje območje med začetnim položajem in končno točko obdela v prečni smeri s pomikom { $q-turning-roughing-feed }.
step-cut-contour-longitudinally = Krmiljenje območje med začetnim položajem in končno točko obdela v vzdolžni smeri. Vzdolžni rez poteka vzporedno s koordinatno osjo s pomikom { $q-turning-roughing-feed }.
step-cut-contour-across-axis = Krmiljenje območje med začetnim položajem in končno točko obdela v prečni smeri. Prečni rez poteka vzporedno s koordinatno osjo s pomikom { $q-turning-roughing-feed }.
step-cut-parallel-to-contour = Krmiljenje obdela območje med začetnim položajem in končno točko. Rez poteka vzporedno s konturo s pomikom { $q-turning-roughing-feed }.
step-retract-to-starting-position-in-x = Krmiljenje z definiranim pomikom umakne orodje na začetni položaj v smeri X.
step-clear-area-in-x-then-z = Če je začetna točka (položaj orodja ob priklicu cikla) v območju, ki se obdeluje, krmiljenje orodje najprej v smeri X in nato v smeri Z pozicionira na varnostno razdaljo { $q-turning-clearance } in cikel začne od tam.
step-clear-area-in-z-then-x = Če je začetna točka (položaj orodja ob priklicu cikla) v območju, ki se obdeluje, krmiljenje orodje najprej v smeri Z in nato v smeri X pozicionira na varnostno razdaljo { $q-turning-clearance } in cikel začne od tam.
step-clear-area-in-z = Če je začetna točka v območju, ki se obdeluje, krmiljenje orodje najprej v smeri Z pozicionira na varnostno razdaljo { $q-turning-clearance }.
step-clear-plunging-start-in-z = Če je koordinata Z začetne točke (položaja orodja ob priklicu cikla) manjša od začetka konture { $q-plunging-start-z }, krmiljenje orodje v smeri Z pozicionira na varnostno razdaljo { $q-turning-clearance } in cikel začne od tam.
step-clear-contour-start-in-z = Če je koordinata Z začetne točke (položaja orodja ob priklicu cikla) manjša od koordinate začetne točke konture, krmiljenje orodje v smeri Z pozicionira na varnostno razdaljo { $q-turning-clearance } in cikel začne od tam.
step-clear-contour-start-before-finishing = { step-clear-contour-start-in-z }
step-position-at-contour-start-in-z = Če je koordinata Z začetne točke (položaja orodja ob priklicu cikla) manjša od koordinate začetne točke konture, krmiljenje orodje v smeri Z pozicionira na začetno točko konture in cikel začne od tam.
step-rapid-infeed = Krmiljenje v hitrem teku izvede primik.
step-finish-turned-contour-to-end = Krmiljenje konturo obdelovanca od začetne do končne točke konture fino obdela s pomikom { $q-turning-finishing-feed }.
condition-start-element-added = { $q-start-element-type } na začetku konture doda element
condition-end-element-added = { $q-end-element-type } na koncu konture doda element
condition-undercuts-machined = { $q-undercut-machining } dovoljuje obdelavo potopnih elementov
note-area-from-starting-point-to-end-point = Pri grobem obdelovanju cikel obdela območje od začetne točke cikla do končne točke, definirane v ciklu.
note-infeed-within-undercut = Znotraj spodreza krmiljenje primik izvede s pomikom { $q-turning-roughing-feed }. Vsak odmik je tam dolg toliko, kot je varnostna razdalja { $q-turning-clearance }.
note-contour-direction-decides = Programirana smer konture določa smer obdelave.
title-shoulder-with-recess = Segment z vbodom

# --- 811 ---
cycle-turn-shoulder-longitudinal = Vzdolžno struženje segmenta
    .nc = VZDOLŽNO STRUŽENJE SEGMENTA
    .purpose = Vzdolžno struži pravokotne segmente, zunaj ali znotraj: grobo obdelovanje, fino obdelovanje ali oboje. Rezi grobega obdelovanja so vzporedni s koordinatno osjo.

# --- 812 ---
cycle-turn-shoulder-longitudinal-extended = Razširjeno vzdolžno struženje segmenta
    .nc = RAZŠIRJENO VZDOLŽNO STRUŽENJE SEGMENTA
    .nc-aliases = RAZŠIR. VZDOLŽ. SEG. | VZDOLŽNO STRUŽENJE SEGMENTA RAZŠIRJEN
    .purpose = Vzdolžno struži segmente, zunaj ali znotraj: grobo obdelovanje, fino obdelovanje ali oboje. Na začetku in na koncu konture je mogoče dodati posneti rob ali zaokrožitev, za čelno in obodno površino je mogoče definirati kot, vogal konture ima lahko polmer. Rezi grobega obdelovanja so vzporedni s koordinatno osjo.

# --- 813 ---
cycle-turn-plunge-longitudinal = Potopno vzdolžno struženje
    .nc = POTOPNO VZDOLŽNO STRUŽENJE
    .purpose = Vzdolžno struži segmente s potopnimi elementi (spodrezi), zunaj ali znotraj: grobo obdelovanje, fino obdelovanje ali oboje. Rezi grobega obdelovanja so vzporedni s koordinatno osjo.

# --- 814 ---
cycle-turn-plunge-longitudinal-extended = Razširjeno potopno vzdolžno struženje
    .nc = RAZŠIRJENO POTOPNO VZDOLŽNO STRUŽENJE
    .purpose = Vzdolžno struži segmente s potopnimi elementi (spodrezi), zunaj ali znotraj: grobo obdelovanje, fino obdelovanje ali oboje. Na začetku in na koncu konture je mogoče dodati posneti rob ali zaokrožitev, določiti je mogoče tudi polmer vogala konture in kot čelne površine. Rezi grobega obdelovanja so vzporedni s koordinatno osjo.

# --- 810 ---
cycle-turn-contour-longitudinal = Vzdolžno struženje konture
    .nc = VZDOLŽNO STRUŽENJE KONTURE
    .purpose = Vzdolžno struži obdelovance s poljubno stružno konturo, ki jo opisuje podprogram, zunaj ali znotraj: grobo obdelovanje, fino obdelovanje ali oboje. Rezi grobega obdelovanja so vzporedni s koordinatno osjo.

# --- 815 ---
cycle-turn-contour-parallel = Struženje vzporedno s konturo
    .nc = STRUŽENJE VZPOREDNO S KONTURO
    .purpose = Struži obdelovance s poljubno stružno konturo, ki jo opisuje podprogram, zunaj ali znotraj: grobo obdelovanje, fino obdelovanje ali oboje. Rezi grobega obdelovanja so vzporedni s konturo.

# --- 821 ---
cycle-turn-shoulder-face = Čelno struženje segmenta
    .nc = ČELNO STRUŽENJE SEGMENTA
    .purpose = Čelno struži pravokotne segmente, zunaj ali znotraj: grobo obdelovanje, fino obdelovanje ali oboje. Rezi grobega obdelovanja so vzporedni s koordinatno osjo.

# --- 822 ---
cycle-turn-shoulder-face-extended = Razširjeno čelno struženje segmenta
    .nc = RAZŠIRJENO ČELNO STRUŽENJE SEGMENTA
    .nc-aliases = ČELNO STRUŽENJE SEGMENTA RAZŠIRJEN
    .purpose = Čelno struži segmente, zunaj ali znotraj: grobo obdelovanje, fino obdelovanje ali oboje. Na začetku in na koncu konture je mogoče dodati posneti rob ali zaokrožitev, za čelno in obodno površino je mogoče definirati kot, vogal konture ima lahko polmer. Rezi grobega obdelovanja so vzporedni s koordinatno osjo.

# --- 823 ---
cycle-turn-plunge-face = Potopno čelno struženje
    .nc = POTOPNO ČELNO STRUŽENJE
    .purpose = Čelno struži potopne elemente (spodreze), zunaj ali znotraj: grobo obdelovanje, fino obdelovanje ali oboje. Rezi grobega obdelovanja so vzporedni s koordinatno osjo.

# --- 824 ---
cycle-turn-plunge-face-extended = Razširjeno potopno čelno struženje
    .nc = RAZŠIRJENO POTOPNO ČELNO STRUŽENJE
    .purpose = Čelno struži potopne elemente (spodreze), zunaj ali znotraj: grobo obdelovanje, fino obdelovanje ali oboje. Na začetku in na koncu konture je mogoče dodati posneti rob ali zaokrožitev, določiti je mogoče tudi polmer vogala konture in kot čelne površine. Rezi grobega obdelovanja so vzporedni s koordinatno osjo.

# --- 820 ---
cycle-turn-contour-face = Čelno struženje konture
    .nc = ČELNO STRUŽENJE KONTURE
    .purpose = Čelno struži obdelovance s poljubno stružno konturo, ki jo opisuje podprogram, zunaj ali znotraj: grobo obdelovanje, fino obdelovanje ali oboje. Rezi grobega obdelovanja so vzporedni s koordinatno osjo.

# --- 800 ---
cycle-adapt-turning-system = Prilagoditev sistema struženja
    .nc = PRILAGODITEV STRUŽNEGA SISTEMA
    .nc-aliases = DREHSYSTEM ANPASSEN | PRILAGODITEV SISTEMA STRUŽENJA
    .purpose = Poravna koordinatni sistem obdelovanca za struženje in usmeri rezilo orodja; orodje lahko tudi zrcali, tako da je uporabno za notranjo in za zunanjo obdelavo.
step-align-turning-system = Krmiljenje poravna koordinatni sistem obdelovanca glede na precesijski kot { $q-precession-angle } in ustrezno usmeri rezilo orodja: za zunanjo obdelavo v središče okrogle mize, za notranjo v nasprotno smer.
step-reverse-turning-tool = S parametrom { $q-tool-reversal } je mogoče koordinatni sistem orodja zrcaliti: krmiljenje tedaj zavrti vreteno za 180° in zrcali usmeritev orodja { $mp-tool-orientation }. Tako je mogoče orodje uporabiti za notranjo in za zunanjo obdelavo.
note-before-turning = Pred struženjem premaknite orodje na pravi položaj in usmerite njegovo rezilo.
note-position-over-turning-spindle = Za premik orodja na primeren položaj programirajte pozicionirni stavek v središče stružnega vretena, na primer L Y+0 R0 FMAX.
note-purpose-of-precession-angle = Precesijski kot { $q-precession-angle } določa, kje na obodu se obdelovanec obdeluje. To je lahko potrebno, če je treba orodje zaradi pomanjkanja prostora premakniti na določen obdelovalni položaj; obdelovalni položaj je mogoče tudi zavrteti, da je obdelavo laže opazovati.
note-precession-in-inclined-turning = Pri struženju z nagnjenim orodjem s precesijskim kotom { $q-precession-angle } premaknite rezilo in koordinatni sistem v primeren položaj.
note-turning-system-until-tool-call = Cikel deluje od definicije do naslednjega priklica orodja.
note-turning-tool-clamped-and-measured = Orodje mora biti vpeto v pravem položaju in izmerjeno.
note-turning-tool-selected = Cikel je mogoče uporabljati samo, če je izbrano stružno orodje.
note-check-tool-orientation = Pred obdelavo preverite usmeritev orodja.
note-own-functions-for-tool-alignment = Proizvajalec stroja lahko ponudi lastne funkcije za usmerjanje orodja. Upoštevajte priročnik za stroj.
note-cycle-depends-on-machine = Cikel { $cycle } je odvisen od stroja. Upoštevajte priročnik za stroj.

# --- 801 ---
cycle-reset-turning-system = Ponastavitev sistema struženja
    .nc = PONASTAVITEV SISTEMA STRUŽENJA
    .purpose = Ponastavi nastavitve, določene s ciklom 800.
step-reset-turning-system = Krmiljenje ponastavi vse nastavitve, programirane s ciklom 800: precesijski kot Q497 in obračanje orodja Q498.
note-tool-stays-oriented = Orodje se ne vrne v prvotno usmeritev. Če ga je usmeril cikel 800, po ponastavitvi ostane v tem položaju.
note-cycle-without-parameters = Cikel nima parametrov. Njegov vnos zaključite s tipko END.
message-turning-contour-left = Orodje konture ne more obdelati v celoti: rezalna ploščica ne doseže vseh njenih delov.
