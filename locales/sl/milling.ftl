# Pockets, slots, studs, line patterns and multipass milling.

# --- common to pockets, slots and studs ---
guard-tool-wider-than-slot = Orodje je preširoko za utor: brez stranskih nadmer je utor ožji od orodja.
guard-stud-blank-too-small = Surovec ni večji od končnega čepa.
note-finishing-only-rapid-to-first-depth = Nevarnost kolizije! Če cikel prikličete z obsegom obdelave 2 (samo fino rezkanje), krmiljenje orodje v hitrem teku spusti na prvo globino primika.

# --- 252 ---
cycle-circular-pocket = Krožni žep
    .nc = KROŽNI ŽEP
    .purpose = V celoti izdela krožni žep: grobo rezkanje, globinsko fino rezkanje in stransko fino rezkanje. Mogoče je tudi samo grobo rezkanje, samo globinsko in stransko fino rezkanje, samo globinsko fino rezkanje ali samo stransko fino rezkanje.
guard-plunging-angle-not-vertical = Za navpično spuščanje mora biti v preglednici orodij vnesen kot spuščanja { $mp-plunging-angle }, ki je 0 ali 90.
note-position-at-pocket-centre = Orodje pozicionirajte na začetno točko (središče kroga) v obdelovalni ravnini s popravkom polmera R0.

# --- 253 ---
cycle-slot = Rezkanje utorov
    .nc = REZKANJE UTOROV
    .purpose = V celoti izdela utor: grobo rezkanje, globinsko fino rezkanje in stransko fino rezkanje. Mogoče je tudi samo grobo rezkanje, samo globinsko in stransko fino rezkanje, samo globinsko fino rezkanje ali samo stransko fino rezkanje.
step-move-over-left-slot-arc = Krmiljenje premakne orodje v hitrem teku najprej po orodni osi na 2. varnostno razdaljo { $q-second-set-up-clearance } (na varnostno razdaljo, če ta ni vnesena), nato nad središče levega kroga utora in nazadnje na varnostno razdaljo { $q-set-up-clearance }.
step-plunge-at-left-slot-arc = Orodje se iz središča levega kroga utora spusti na naslednjo globino primika { $q-plunging-depth }. Način določa parameter { $q-plunging-strategy }:
say-plunge-to-and-fro-along-slot = { $q-plunging-strategy } = 1 ali 2: nihajoče vzdolž utora pod kotom spuščanja { $mp-plunging-angle } iz preglednice orodij, s pomikom { $q-plunging-feed }
step-clear-slot-level = Krmiljenje utor grobo rezka od znotraj navzven in pri tem upošteva nadmeri finega rezkanja { $q-side-allowance } in { $q-floor-allowance }.
step-rapid-to-first-plunging-depth-of-slot = Če je programirano samo fino rezkanje ({ $q-machining-operation } = 2), krmiljenje orodje v hitrem teku spusti na prvo globino primika.
step-finish-slot-side = Če je definirana stranska nadmera { $q-side-allowance }, krmiljenje najprej fino rezka stene utora; če je vnesen primik { $q-finishing-infeed }, v več primikih. Orodje se steni približa tangencialno v levem krogu utora.
step-finish-slot-side__circular-slot = Če je definirana stranska nadmera { $q-side-allowance }, krmiljenje najprej fino rezka stene utora; če je vnesen primik { $q-finishing-infeed }, v več primikih. Orodje se steni približa tangencialno.
until-slot-side-finished = stene niso fino rezkane do globine { $q-depth }
step-finish-slot-floor = Če je definirana globinska nadmera { $q-floor-allowance }, krmiljenje nato fino rezka dno utora od znotraj navzven.
step-leave-slot = Orodje se iz utora v hitrem teku umakne na 2. varnostno razdaljo { $q-second-set-up-clearance } (na varnostno razdaljo, če ta ni vnesena).
step-end-of-slot = Kje orodje stoji na koncu cikla, je odvisno od položaja utora { $q-slot-position }:
say-back-to-slot-centre = { $q-slot-position } = 0: krmiljenje orodje v obdelovalni ravnini vrne v središče utora
say-stays-in-working-plane = sicer: krmiljenje orodja v obdelovalni ravnini ne pozicionira
note-position-at-slot-start = Orodje pozicionirajte na začetno točko v obdelovalni ravnini s popravkom polmera R0. Upoštevajte položaj utora { $q-slot-position }.
note-position-at-slot-start__circular-slot = Orodje pozicionirajte na začetno točko v obdelovalni ravnini s popravkom polmera R0. Upoštevajte referenco za položaj utora { $q-slot-position-reference }.
note-slot-end-position = Na koncu cikla krmiljenje orodje v obdelovalni ravnini vrne v središče utora. Izjema: če je definiran položaj utora { $q-slot-position }, ki ni 0, ga samo po orodni osi pozicionira na 2. varnostno razdaljo. Pred ponovnim priklicem cikla orodje vrnite na začetni položaj ali pred priklicem programirajte absolutne premike.
note-wide-slot-is-cleared = Če je utor širši od dvakratnega premera orodja, ga krmiljenje ustrezno grobo rezka od znotraj navzven. Tako je mogoče tudi z majhnimi orodji rezkati poljubno široke utore.

# --- 254 ---
cycle-circular-slot = Okrogli utor
    .nc = OKROGLI UTOR
    .purpose = V celoti izdela okrogli utor ali več takih utorov na delnem krogu: grobo rezkanje, globinsko fino rezkanje in stransko fino rezkanje. Mogoče je tudi samo grobo rezkanje, samo globinsko in stransko fino rezkanje, samo globinsko fino rezkanje ali samo stransko fino rezkanje.
step-move-over-circular-slot = Krmiljenje premakne orodje v hitrem teku najprej po orodni osi na 2. varnostno razdaljo { $q-second-set-up-clearance } (na varnostno razdaljo, če ta ni vnesena), nato nad začetno točko utora in nazadnje na varnostno razdaljo { $q-set-up-clearance }.
step-plunge-in-circular-slot = Orodje se na sredini širine utora spusti na naslednjo globino primika { $q-plunging-depth }. Način določa parameter { $q-plunging-strategy }:
until-all-slots-milled = niso izdelani vsi utori (število: { $q-number-of-operations }); vsak naslednji je zavrten za { $q-pattern-stepping-angle } okoli središča delnega kroga
step-end-of-circular-slot = Kje orodje stoji na koncu cikla, je odvisno od reference za položaj utora { $q-slot-position-reference }:
say-back-to-pitch-circle-centre = { $q-slot-position-reference } = 0: krmiljenje orodje v obdelovalni ravnini vrne na začetno točko (središče delnega kroga)
condition-slot-at-entered-centre = položaj utora izhaja iz vnesenega središča delnega kroga ({ $q-slot-position-reference } = 0)
note-circular-slot-end-position = Na koncu cikla krmiljenje orodje v obdelovalni ravnini vrne na začetno točko (središče delnega kroga). Izjema: če je definiran položaj utora { $q-slot-position-reference }, ki ni 0, ga samo po orodni osi pozicionira na 2. varnostno razdaljo. V tem primeru po priklicu cikla vedno programirajte absolutne premike.
note-circular-slot-with-pattern = Če cikel 254 (okrogli utor) povežete s ciklom 221, za položaj utora ni dovoljena vrednost 0.

# --- 256 ---
cycle-rectangular-stud = Pravokotni čep
    .nc = PRAVOKOTNI ČEP
    .purpose = Izdela pravokotni čep. Če je surovec večji od največjega možnega stranskega primika, krmiljenje izvede več stranskih primikov, dokler ne doseže končnih mer.
step-move-to-stud-approach = Orodje se z začetnega položaja cikla (središče čepa) premakne na začetni položaj za obdelavo čepa. Določa ga parameter { $q-stud-approach-position }:
say-approach-beside-blank = { $q-stud-approach-position } = 0 (standardna nastavitev): 2{"\u00A0"}mm desno ob surovcu čepa
say-approach-at-stud-corner = sicer: ob izbranem vogalu
step-rapid-down-to-set-up-clearance = Če je orodje na 2. varnostni razdalji, ga krmiljenje v hitrem teku (FMAX) premakne na varnostno razdaljo { $q-set-up-clearance }.
step-feed-to-plunging-depth-of-stud = Orodje se s pomikom pri globinskem primiku { $q-plunging-feed } premakne na naslednjo globino primika { $q-plunging-depth }.
step-mill-around-stud = Orodje se nato konturi čepa približa tangencialno in rezka en obhod.
step-mill-around-stud-again = Če z enim obhodom končne mere niso dosežene, se orodje na trenutni globini primika stransko primakne in rezka nov obhod; krmiljenje pri tem upošteva mere surovca, končne mere in dovoljeni stranski primik. To se ponavlja, dokler končne mere niso dosežene. Če je začetna točka v vogalu ({ $q-stud-approach-position } ni 0), krmiljenje rezka spiralno od začetne točke navznoter, dokler končne mere niso dosežene.
step-leave-stud-to-start = Če so potrebni nadaljnji primiki, se orodje tangencialno odmakne od konture in vrne na začetno točko čepa.
until-stud-depth-reached = ni dosežena programirana globina { $q-depth } čepa
step-retract-from-stud = Na koncu cikla krmiljenje orodje pozicionira samo po orodni osi (končni položaj se zato ne ujema z začetnim):
note-position-at-stud-start = Orodje pozicionirajte na začetno točko v obdelovalni ravnini s popravkom polmera R0. Upoštevajte položaj čepa { $q-stud-position }.
note-room-beside-stud = Nevarnost kolizije! Desno ob čepu pustite dovolj prostora za primik orodja: najmanj premer orodja + 2{"\u00A0"}mm.
note-stud-end-position = Nevarnost kolizije! Na koncu krmiljenje vrne orodje na varnostno razdaljo ali, če je vnesena, na 2. varnostno razdaljo. Končni položaj orodja po ciklu se zato ne ujema z začetnim položajem.
note-choose-other-approach-position = Če primik s { $q-stud-approach-position } = 0 na površini čepa pusti sledi, izberite drug položaj primika.

# --- 257 ---
cycle-circular-stud = Krožni čep
    .nc = OKROGLI ČEP
    .purpose = Izdela krožni čep. Če je premer surovca večji od največjega možnega stranskega primika, krmiljenje izvede več stranskih primikov, dokler ne doseže končnega premera.
step-move-to-circular-stud-approach = Orodje se z začetnega položaja cikla (središče čepa) premakne na začetni položaj za obdelavo čepa. Določa ga parameter { $q-stud-starting-angle } kot polarni kot glede na središče čepa.
step-mill-spiral-around-stud = Orodje se nato konturi čepa tangencialno približa po spirali in rezka en obhod.
step-keep-spiral-to-finished-diameter = Če z enim obhodom končni premer ni dosežen, krmiljenje nadaljuje primik po spirali, dokler ga ne doseže; pri tem upošteva premer surovca, končni premer in dovoljeni stranski primik.
step-leave-stud-on-spiral = Krmiljenje orodje po spirali odmakne od konture.
step-next-infeed-near-departure = Če je potrebnih več primikov, se naslednji izvede v točki, ki je najbliže mestu odmika.
step-retract-and-return-to-stud-centre = Na koncu cikla, po spiralnem odmiku, krmiljenje orodje po orodni osi pozicionira na 2. varnostno razdaljo { $q-second-set-up-clearance } (na varnostno razdaljo, če ta ni vnesena) in nato v središče čepa.
note-position-at-stud-centre = Orodje pozicionirajte na začetno točko (središče čepa) v obdelovalni ravnini s popravkom polmera R0.
note-circular-stud-end-height = Nevarnost kolizije! Na koncu krmiljenje vrne orodje na varnostno razdaljo ali, če je vnesena, na 2. varnostno razdaljo. Po orodni osi se lahko zato končni položaj orodja po ciklu razlikuje od začetnega.

# --- 221 ---
cycle-line-pattern = Točkovni vzorec na premicah
    .nc = VZORČNE ČRTE
    .purpose = Izvede nazadnje definirani obdelovalni cikel v točkah, razporejenih v vrstice in stolpce.
until-line-done = niso opravljene vse obdelave vrstice (število: { $q-number-of-columns }); orodje nato stoji na zadnji točki vrstice
step-move-to-next-column = Krmiljenje nato premakne orodje na začetno točko naslednje obdelave, v prvi, tretji, peti … vrstici v pozitivni smeri glavne osi, v drugi, četrti, šesti … vrstici v negativni smeri, in tam na varnostno razdaljo { $q-set-up-clearance }.
step-height-between-lines = Na zadnji točki vrstice se orodje po osi vretena premakne na višino med obdelavami, kot določa { $q-pattern-clearance-mode }.
step-move-to-next-line = Krmiljenje nato premakne orodje v naslednjo vrstico, premočrtno na točko istega stolpca, in tam na varnostno razdaljo { $q-set-up-clearance }. Tako se izmenično v obe smeri obdelajo vse nadaljnje vrstice.
until-all-lines-done = niso opravljene vse vrstice (število: { $q-number-of-lines })
note-pattern-overrides-heights-and-rotation = Če s tem ciklom povežete enega od obdelovalnih ciklov od 200 do 209 ali od 251 do 267, veljajo varnostna razdalja { $q-set-up-clearance }, koordinata površine obdelovanca { $q-surface-coordinate }, 2. varnostna razdalja { $q-second-set-up-clearance } in rotacijski položaj { $q-angle-of-rotation } tega cikla.

# --- common to surfaces ---
until-surface-milled = vnesena ploskev ni v celoti rezkana
note-pre-position-for-surface = Nevarnost kolizije! Orodje predpozicionirajte tako, da ne more trčiti v obdelovanec ali vpenjalo.

# --- 230 ---
cycle-multipass-milling = Vrstno rezkanje
    .nc = VRSTNO REZKANJE
    .purpose = Rezka ravno pravokotno ploskev v vrsticah, izmenično v obe smeri.
step-rapid-to-start-of-lines = Krmiljenje s trenutnega položaja pozicionira orodje v hitrem teku (FMAX) v obdelovalni ravnini na začetno točko 1. Pri tem ga zamakne za polmer orodja v levo in navzgor.
step-down-to-start-of-lines = Orodje se nato po osi vretena v hitrem teku (FMAX) premakne na varnostno razdaljo { $q-set-up-clearance } in od tam s pomikom pri globinskem primiku { $q-plunging-feed } na programirani začetni položaj { $q-starting-point-tool } po osi vretena.
step-mill-line = Orodje nato s programiranim pomikom { $q-milling-feed } rezka do končne točke 2, ki jo krmiljenje izračuna iz začetne točke, programirane dolžine { $q-first-side-length } in polmera orodja.
step-step-over-to-next-line = Krmiljenje s pomikom { $q-stepover-feed } prečno premakne orodje na začetno točko naslednje vrstice. Zamik izračuna iz programirane širine { $q-second-side-length } in števila rezov { $q-number-of-cuts }.
step-mill-back-in-next-line = Orodje se nato vrne v negativni smeri 1. osi.
step-rapid-back-to-clearance-over-surface = Na koncu krmiljenje umakne orodje v hitrem teku (FMAX) na varnostno razdaljo { $q-set-up-clearance }.
note-plane-first-then-spindle-axis = Krmiljenje orodje s trenutnega položaja pozicionira na začetno točko najprej v obdelovalni ravnini in nato po osi vretena.

# --- 231 ---
cycle-ruled-surface = Premonosna ploskev
    .nc = PREMONOSNA PLOSKEV
    .purpose = Enosmerno po vrsticah rezka nagnjeno ali zvito ploskev, ki jo določajo štiri vogalne točke.
step-straight-to-starting-point = Krmiljenje premakne orodje s trenutnega položaja premočrtno v prostoru na začetno točko 1.
step-mill-line-to-its-end = Orodje nato s programiranim pomikom { $q-milling-feed } rezka do končne točke vrstice: v prvi vrstici do točke 2, in sicer s polovičnim pomikom; v vsaki nadaljnji do točke, ki jo krmiljenje izračuna iz točke 2 in zamika v smeri točke 3.
step-rapid-back-to-start-of-line = Od tam krmiljenje premakne orodje v hitrem teku (FMAX) v pozitivni smeri osi vretena za premer orodja nad višji konec vrstice in nato nazaj na začetno točko vrstice (v prvi vrstici na točko 1).
step-down-to-last-height = Na začetni točki krmiljenje premakne orodje po osi vretena v položaj, ki ga je tam imelo nazadnje.
step-move-to-start-of-next-line = Krmiljenje nato premakne orodje po vseh treh oseh s točke 1 v smeri točke 4 v naslednjo vrstico.
step-above-highest-point = Na koncu krmiljenje po osi vretena pozicionira orodje nad najvišjo vneseno točko, in sicer za premer orodja.
note-cutting-direction-of-surface = Začetno točko in s tem smer rezkanja je mogoče izbrati poljubno: krmiljenje posamezne reze izvede od točke 1 do točke 2, celoten potek pa gre od točk 1 in 2 do točk 3 in 4. Točka 1 je lahko v katerem koli vogalu ploskve.
note-surface-quality-with-end-mills = Pri uporabi stebelnih rezkarjev je mogoče kakovost površine izboljšati: pri rahlo nagnjenih ploskvah z vbodnim rezom (koordinata osi vretena točke 1 je večja od koordinate točke 2); pri strmih ploskvah z vlečnim rezom (koordinata osi vretena točke 1 je manjša od koordinate točke 2); pri zvitih ploskvah tako, da glavna smer rezanja (od točke 1 do točke 2) poteka v smeri večjega naklona.
note-surface-quality-with-ball-end-mills = Pri uporabi krogelnih rezkarjev je mogoče kakovost zvitih ploskev izboljšati tako, da glavna smer rezanja (od točke 1 do točke 2) poteka pravokotno na smer največjega naklona.
note-straight-to-start-without-collision = Nevarnost kolizije! Krmiljenje premakne orodje s trenutnega položaja premočrtno v prostoru na začetno točko 1. Orodje predpozicionirajte tako, da ne more trčiti v obdelovanec ali vpenjalo.
note-positions-with-r0 = Krmiljenje premika orodje med vnesenimi položaji s popravkom polmera R0.
note-centre-cut-or-pilot-drill = Po potrebi uporabite rezkar s čelnim zobom, ki reže po sredini (DIN 844), ali predhodno vrtajte s ciklom 21.

# --- 232 ---
cycle-face-milling = Plansko rezkanje
    .nc = PLANSKO REZKANJE
    .purpose = Rezka ravno ploskev v več primikih z upoštevanjem nadmere finega rezkanja in z eno od treh strategij.
step-position-beside-surface = Krmiljenje s trenutnega položaja pozicionira orodje v hitrem teku (FMAX) s pozicionirno logiko na začetno točko 1, ki leži ob obdelovancu, odmaknjena od njega za polmer orodja in stransko varnostno razdaljo { $q-side-clearance }:
say-plane-then-spindle-axis = če je orodje nad 2. varnostno razdaljo { $q-second-set-up-clearance }: najprej v obdelovalni ravnini, nato po osi vretena
say-second-clearance-then-plane = sicer: najprej na 2. varnostno razdaljo { $q-second-set-up-clearance }, nato v obdelovalni ravnini
step-feed-to-face-infeed = Orodje se nato po osi vretena s pomikom pri predpozicioniranju { $q-pre-positioning-feed } premakne na naslednjo globino primika, ki jo je izračunalo krmiljenje.
step-mill-face-line = Orodje s programiranim pomikom { $q-milling-feed } rezka do končne točke 2:
say-line-ends-outside-surface = { $q-face-milling-strategy } = 0: zunaj ploskve; krmiljenje jo izračuna iz programirane začetne točke, dolžine in stranske varnostne razdalje { $q-side-clearance } ter polmera orodja
say-line-ends-inside-surface = { $q-face-milling-strategy } = 1: znotraj ploskve; krmiljenje jo izračuna iz programirane začetne točke in dolžine ter polmera orodja
say-line-ends-outside-surface-by-lines = { $q-face-milling-strategy } = 2: zunaj ploskve; krmiljenje jo izračuna iz programirane začetne točke, dolžine in stranske varnostne razdalje { $q-side-clearance } ter polmera orodja
step-step-over-on-face = Krmiljenje zamik izračuna iz programirane širine { $q-second-side-length }, polmera orodja in največjega faktorja prekrivanja poti { $q-max-path-overlap } ter orodje prečno premakne na začetno točko naslednje vrstice:
say-step-over-outside = { $q-face-milling-strategy } = 0: s pomikom pri predpozicioniranju { $q-pre-positioning-feed }
say-step-over-inside = { $q-face-milling-strategy } = 1: znotraj obdelovanca, s pomikom pri rezkanju { $q-milling-feed }
say-retract-and-return-to-next-line = { $q-face-milling-strategy } = 2: orodje se po osi vretena premakne na varnostno razdaljo { $q-set-up-clearance } nad trenutno globino primika in s pomikom pri predpozicioniranju { $q-pre-positioning-feed } neposredno nazaj na začetno točko naslednje vrstice
step-mill-next-face-line = Orodje nato rezka naslednjo vrstico:
say-back-towards-start = { $q-face-milling-strategy } = 0: nazaj v smeri začetne točke 1
say-back-towards-start-inside = { $q-face-milling-strategy } = 1: nazaj v smeri začetne točke 1; tudi premik v naslednjo vrstico poteka znotraj obdelovanca
say-down-and-towards-end = { $q-face-milling-strategy } = 2: orodje se znova premakne na trenutno globino primika in nato v smeri končne točke 2
step-repeat-until-face-milled = To se ponavlja, dokler vnesena ploskev ni v celoti rezkana. Na koncu zadnje poti se orodje primakne na naslednjo globino obdelave. Da ni praznih hodov, se ploskev nato obdela v obratnem zaporedju.
until-face-infeeds-done = niso opravljeni vsi primiki razen zadnjega
step-finish-face = Pri zadnjem primiku se odrezka samo vnesena nadmera finega rezkanja { $q-floor-allowance }, in sicer s pomikom pri finem rezkanju { $q-finishing-feed }.
step-rapid-back-to-second-clearance = Na koncu krmiljenje umakne orodje v hitrem teku (FMAX) na 2. varnostno razdaljo { $q-second-set-up-clearance }.
note-three-face-milling-strategies = Na voljo so tri strategije. { $q-face-milling-strategy } = 0: meandraste poti, stranski primik zunaj ploskve, ki se obdeluje. { $q-face-milling-strategy } = 1: meandraste poti, stranski primik znotraj ploskve, ki se obdeluje. { $q-face-milling-strategy } = 2: vrstica za vrstico, z umikom in stranskim primikom s pomikom za pozicioniranje.
note-levels-in-reverse-order = Da ni praznih hodov, se vsaka nadaljnja ravnina obdela v obratnem zaporedju.
note-second-clearance-without-collision = 2. varnostno razdaljo { $q-second-set-up-clearance } vnesite tako, da orodje ne more trčiti v obdelovanec ali vpenjalo.
note-equal-end-and-start-do-nothing = Če sta začetna točka 3. osi { $q-starting-point-tool } in končna točka 3. osi { $q-end-point-tool } enaki, krmiljenje cikla ne izvede (programirana globina je 0).
