# Point patterns.
cycle-circular-pattern = Točkovni vzorec na krogu
    .nc = VZORČNI KROG
    .purpose = Izvede nazadnje definirani obdelovalni cikel v točkah na krogu ali na krožnem loku.
step-move-to-first-operation = Krmiljenje premakne orodje v hitrem teku s trenutnega položaja na začetno točko prve obdelave: na { -second-set-up-clearance(case: "accusative") } { $q-second-set-up-clearance } (os vretena), na začetno točko v { -working-plane(case: "locative") } in na { -set-up-clearance(case: "accusative") } { $q-set-up-clearance } nad { -surface(case: "instrumental") } (os vretena).
step-call-last-machining-cycle = S tega položaja krmiljenje izvede nazadnje definirani obdelovalni cikel.
step-height-between-operations = Med obdelavami se orodje po osi vretena premakne:
say-to-second-set-up-clearance = { $q-pattern-clearance-mode } = 1: na { -second-set-up-clearance(case: "accusative") } { $q-second-set-up-clearance }
say-to-set-up-clearance = { $q-pattern-clearance-mode } = 0: na { -set-up-clearance(case: "accusative") } { $q-set-up-clearance }
step-move-to-next-operation = Krmiljenje nato premakne orodje na začetno točko naslednje obdelave in tam na { -set-up-clearance(case: "accusative") } { $q-set-up-clearance }:
say-on-the-pitch-circle = { $q-pattern-traverse-type } = 1: po delnem krogu
say-in-a-straight-line = { $q-pattern-traverse-type } = 0: premočrtno
until-all-operations-done = niso opravljene vse obdelave (število: { $q-number-of-operations })
condition-stepping-angle-computed = kotni korak { $q-pattern-stepping-angle } ni vnesen
guard-pattern-angles-equal = Začetni in končni kot sta enaka. Vnesite različna kota ali kotni korak.
note-pattern-is-def-active = Cikel deluje že od definicije naprej: nazadnje definirani obdelovalni cikel prikliče sam.
note-pattern-overrides-heights = Če s tem ciklom povežete enega od obdelovalnih ciklov od 200 do 209 ali od 251 do 267, veljajo { -set-up-clearance(case: "nominative") } { $q-set-up-clearance }, koordinata { -surface(case: "genitive") } { $q-surface-coordinate } in { -second-set-up-clearance(case: "nominative") } { $q-second-set-up-clearance } tega cikla.
note-pattern-combinations = Cikel lahko povežete z obdelovalnimi cikli od 200 do 209, 240, od 251 do 253, 256, 257, od 262 do 265 in 267. Cikel 254 (okrogli utor) je mogoče povezati samo s ciklom 221.
note-pattern-alternatives = Kadar točke niso razporejene enakomerno, uporabite preglednico točk in CYCL CALL PAT. Še več enakomernih točkovnih vzorcev ponuja funkcija PATTERN DEF.
note-def-active-before-call-active = Cikle, ki delujejo od definicije, programirajte pred cikli, ki se prikličejo. Med definicijo in priklicem takega cikla programirajte cikel, ki deluje od definicije, samo, če nimata skupnih parametrov, ki morajo ohraniti različne vrednosti.
