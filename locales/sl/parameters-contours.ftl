# Parameters of the contour, cylinder surface and engraving cycles: name, label in the NC block, help.

# --- contour and its data ---
parameter-contour-labels = Številke oznak za konturo
    .word = OZN. KONTURE
    .label-aliases = OZNAKA KONTURE
parameter-milling-depth = Globina rezkanja
    .label = GLOB. REZKANJA
parameter-path-overlap__contour-data =
    .label = PREKRIVANJE PROGE
parameter-surface-coordinate__contour-data = Koordinata površine obdelovanca
parameter-surface-coordinate__contour-train = Koordinata površine obdelovanca
parameter-contour-clearance-height = Varna višina
    .label = VARNA VIŠINA
parameter-inside-corner-rounding-radius = Notranji zaokroževalni polmer
    .label = ZAKROŽEVALNI POLMER
parameter-contour-direction = Smer vrtenja?
    .label = SMER VRTENJA
    .prompt = Smer vrtenja?

# --- machining ---
parameter-contour-plunging-depth = Globina primika
    .label = GLOBINA PRIMIKA
parameter-contour-plunging-depth__cylinder-surface-slot =
    .label-aliases = GLOBINA POMIKA
parameter-contour-plunging-feed = Pomik pri globinskem primiku
    .label = POM. PRI GLOB. PRIM.
parameter-roughing-feed = Pomik pri rezkanju
    .label = POMIK PRI POSNEMANJU
parameter-contour-milling-feed = Pomik pri rezkanju
    .label = POMIK PRI REZKANJU
parameter-reciprocation-feed = Nihajni pomik
    .label = NIHAJNI POMIK
parameter-contour-retraction-feed = Vzvratni pomik
    .label = VZVRATNI POMIK
parameter-contour-retraction-feed__rough-out = Vzratni pomik
parameter-rough-out-tool = Številka/ime izvrtalnega svedra
    .label = IZVRTALNI SVEDER
parameter-coarse-roughing-tool = Orodje za predvrtanje
    .label = ORODJE ZA PREDVRTANJE
parameter-side-finishing-direction = Smer vrtenja
    .label = SMER VRTENJA
parameter-remaining-side-allowance = Nadmera stranskega finega rezkanja
    .label = STRANSKA NADMERA
parameter-contour-milling-type = Vrsta rezkanja
    .label = VRSTA REZKANJA

# --- cylinder surface ---
parameter-cylinder-milling-depth = Globina rezkanja
    .label = GLOB. REZKANJA
parameter-cylinder-set-up-clearance = Varnostna razdalja
    .label = VARNOSTNA RAZDALJA
parameter-cylinder-radius = Polmer valja
    .label = POLMER
parameter-development-dimension-type = Vrsta dimenzioniranja? Stopinja = 0 MM/PALEC = 1
    .label = NAČ. DIMENZIONIRANJA
    .prompt = Vrsta dimenzioniranja? Stopinja = 0 MM/PALEC = 1
parameter-cylinder-slot-width = Širina utora
    .label = ŠIRINA UTORA
parameter-cylinder-slot-tolerance = Toleranca
    .label = TOLERANCA
parameter-cylinder-ridge-width = Širina stojine
    .label = ŠIRINA STOJINE

# --- engraving ---
parameter-engraving-text = Besedilo za graviranje
    .label = BESEDILO ZA GRAVIRANJE
parameter-character-height = Višina znakov
    .label = VIŠINA ZNAKA
parameter-character-spacing-factor = Faktor razmaka
    .label = FAKTOR RAZMAKA
parameter-engraving-font = Vrsta črk
    .label = VRSTA ČRK
parameter-text-arrangement = Besedilo ravno/na krogu (0/1)
    .label = RAZPOREDIT. BESEDILA
parameter-text-rotation = Rotacijski položaj
    .label = ROT. POLOŽAJ
parameter-text-circle-radius = Polmer pri besedilu na krogu
    .label = POLMER KROGA
