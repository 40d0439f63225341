# Pockets.
cycle-rectangular-pocket = Pravokotni žep
    .nc = PRAVOKOTNI ŽEP
    .purpose = V celoti izdela pravokotni žep: grobo rezkanje, globinsko fino rezkanje in stransko fino rezkanje. Mogoče je tudi samo grobo rezkanje, samo globinsko in stransko fino rezkanje, samo globinsko fino rezkanje ali samo stransko fino rezkanje.
step-move-over-pocket-centre = Krmiljenje premakne orodje v hitrem teku najprej po orodni osi na { -second-set-up-clearance(case: "accusative") } { $q-second-set-up-clearance } (na { -set-up-clearance(case: "accusative") }, če ta ni vnesena), nato nad središče žepa in nazadnje na { -set-up-clearance(case: "accusative") } { $q-set-up-clearance }.
group-roughing = Grobo rezkanje
step-plunge-at-centre = Orodje se v središču žepa spusti v obdelovanec na naslednjo { -plunging-depth(case: "accusative") } { $q-plunging-depth }. Način določa parameter { $q-plunging-strategy }:
say-plunge-vertically = { $q-plunging-strategy } = 0: navpično s pomikom { $q-plunging-feed }
say-plunge-helically = { $q-plunging-strategy } = 1: vijačno s pomikom { $q-plunging-feed }
say-plunge-reciprocating = { $q-plunging-strategy } = 2: nihajoče s pomikom { $q-plunging-feed }
step-clear-level = Krmiljenje žep grobo rezka od sredine navzven in pri tem upošteva prekrivanje poti { $q-path-overlap } ter nadmeri finega rezkanja { $q-side-allowance } in { $q-floor-allowance }. Na koncu se orodje od stene žepa odmakne tangencialno.
step-leave-wall-and-return = Orodje se dvigne na { -set-up-clearance(case: "accusative") } nad trenutno { -plunging-depth(case: "instrumental") } in se od tam v hitrem teku vrne v središče žepa.
until-roughing-depth-reached = ni dosežena globina { $q-depth }, zmanjšana za globinsko nadmero { $q-floor-allowance }
group-finishing = Fino rezkanje
step-rapid-to-first-plunging-depth = Če je programirano samo fino rezkanje ({ $q-machining-operation } = 2), krmiljenje orodje v središču žepa v hitrem teku spusti na prvo { -plunging-depth(case: "accusative") }.
step-finish-side = Če je definirana stranska nadmera { $q-side-allowance }, krmiljenje najprej fino rezka steno žepa; če je vnesen primik { $q-finishing-infeed }, v več primikih. Orodje se steni približa tangencialno.
until-side-finished = stena ni fino rezkana do globine { $q-depth }
step-finish-floor = Če je definirana globinska nadmera { $q-floor-allowance }, krmiljenje nato fino rezka dno žepa od sredine navzven; orodje se dnu približa tangencialno.
step-leave-pocket = Orodje se iz žepa umakne v hitrem teku:
step-return-to-starting-point = Krmiljenje vrne orodje na začetno točko v { -working-plane(case: "locative") }.
guard-plunging-depth-zero = Globina primika mora biti večja od 0.
guard-tool-wider-than-pocket = Orodje je preširoko za žep: brez stranskih nadmer je žep ožji od orodja.
guard-plunging-angle-missing__slot = Za nihajoče spuščanje mora biti v { -tool-table(case: "locative") } vnesen kot spuščanja { $mp-plunging-angle }, ki ni 0.
guard-plunging-angle-missing__circular-slot = Za nihajoče spuščanje mora biti v { -tool-table(case: "locative") } vnesen kot spuščanja { $mp-plunging-angle }, ki ni 0.
guard-plunging-angle-missing = Za vijačno in nihajoče spuščanje mora biti v { -tool-table(case: "locative") } vnesen kot spuščanja { $mp-plunging-angle }, ki ni 0.
guard-helix-too-small = Premer vijačnice za spuščanje je manjši od dvakratnega premera orodja. Za orodja, ki režejo po sredini, to preverjanje izklopi strojni parameter { $mp-suppress-plunge-err }.
note-without-tool-table-plunge-vertically = Če nobena { -tool-table(case: "nominative") } ni aktivna, mora biti spuščanje vedno navpično ({ $q-plunging-strategy } = 0), ker kota spuščanja ni mogoče definirati.
note-position-at-pocket-start = Orodje pozicionirajte na začetno točko v { -working-plane(case: "locative") } s popravkom polmera R0. Upoštevajte položaj žepa { $q-pocket-position }.
note-positions-in-tool-axis-itself = Krmiljenje orodje po orodni osi pozicionira samodejno. Upoštevajte { -second-set-up-clearance(case: "accusative") } { $q-second-set-up-clearance }.
note-returns-to-starting-point = Na koncu cikla krmiljenje orodje v obdelovalni ravnini vrne na začetno točko.
note-clearance-above-chips = Po vsaki obdelani ravni se orodje v hitrem teku vrne v središče žepa, in sicer na { -set-up-clearance(case: "locative") } nad trenutno { -plunging-depth(case: "instrumental") }. Izberite tako { -set-up-clearance(case: "accusative") }, da se orodje med premikom ne more zagozditi zaradi ostružkov.
note-helix-diameter-monitored = Pri vijačnem spuščanju krmiljenje javi napako, če je izračunani premer vijačnice manjši od dvakratnega premera orodja. Za orodja, ki režejo po sredini, lahko to preverjanje izklopite s strojnim parametrom { $mp-suppress-plunge-err }.
note-cutting-edge-limits-infeed = Če je rezalni rob krajši od { -plunging-depth(case: "genitive") } { $q-plunging-depth }, krmiljenje zmanjša { -plunging-depth(case: "accusative") } na dolžino { $mp-cutting-edge-length } iz { -tool-table(case: "genitive") }.
note-finishing-only-starts-at-first-depth = Nevarnost kolizije! Če cikel prikličete z obsegom obdelave 2 (samo fino rezkanje), krmiljenje orodje v središču žepa v hitrem teku spusti na prvo { -plunging-depth(case: "accusative") }.
note-point-table-starting-points = Če cikel prikličete s preglednico točk, so točke { -working-plane(case: "genitive") } začetne točke cikla. Če želite, da koordinata osi vretena iz preglednice velja kot koordinata začetne točke, za koordinato { -surface(case: "genitive") } { $q-surface-coordinate } vnesite 0.
note-point-table-shifts-datum = Če cikel prikličete s preglednico točk, krmiljenje vsako točko upošteva kot dodaten zamik ničelne točke.
