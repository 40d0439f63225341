# Parameters of the contour, cylinder surface and engraving cycles: name, label in the NC block, help.

# --- contour and its data ---
parameter-contour-labels = Številke oznak za konturo
    .word = OZN. KONTURE
    .help = Številke vseh podprogramov, katerih konture skupaj tvorijo celotno konturo. Vsako številko potrdite s tipko ENT in vnos končajte s tipko END. Vnesti je mogoče največ 12 številk podprogramov od 1 do 254.
    .label-aliases = OZNAKA KONTURE
parameter-milling-depth = Globina rezkanja
    .label = GLOB. REZKANJA
    .help = Razdalja med površino obdelovanca in dnom konture.
parameter-milling-depth__contour-data =
    .help = Razdalja med površino obdelovanca in dnom žepa.
parameter-path-overlap__contour-data =
    .help = Stranski primik k je zmnožek tega faktorja in polmera orodja.
    .label = PREKRIVANJE PROGE
parameter-set-up-clearance__contour-data =
    .help = Razdalja med čelno površino orodja in površino obdelovanca.
parameter-contour-clearance-height = Varna višina
    .label = VARNA VIŠINA
    .help = Absolutna višina, na kateri orodje ne more trčiti v obdelovanec; za vmesno pozicioniranje in za umik na koncu cikla.
parameter-inside-corner-rounding-radius = Notranji zaokroževalni polmer
    .label = ZAKROŽEVALNI POLMER
    .help = Polmer, s katerim se zaokrožijo notranji vogali. Vrednost se nanaša na pot središča orodja in omogoča bolj tekoče premike med konturnimi elementi. To ni polmer, ki bi ga krmiljenje med programirane elemente vstavilo kot samostojen konturni element.
parameter-contour-direction = Smer vrtenja
    .label = SMER VRTENJA
    .help = Smer obdelave žepov.
    .prompt = Smer vrtenja?

# --- machining ---
parameter-contour-plunging-depth = Globina primika
    .label = GLOBINA PRIMIKA
    .help = Globina, za katero se orodje vsakokrat primakne.
parameter-contour-plunging-depth__pilot-drilling =
    .help = Globina, za katero se orodje vsakokrat primakne (s predznakom »−«, če je smer obdelave negativna).
parameter-contour-plunging-depth__cylinder-surface-slot =
    .label-aliases = GLOBINA POMIKA
parameter-contour-plunging-feed = Pomik pri globinskem primiku
    .label = POM. PRI GLOB. PRIM.
    .help = Hitrost premikanja orodja pri spuščanju na globino po osi vretena.
parameter-roughing-feed = Pomik pri rezkanju
    .label = POMIK PRI POSNEMANJU
    .help = Hitrost premikanja orodja v obdelovalni ravnini.
parameter-contour-milling-feed = Pomik pri rezkanju
    .label = POMIK PRI REZKANJU
    .help = Hitrost premikanja orodja v obdelovalni ravnini.
parameter-reciprocation-feed = Nihajni pomik
    .label = NIHAJNI POMIK
    .help = Hitrost premikanja orodja pri nihajočem spuščanju.
parameter-contour-retraction-feed = Vzvratni pomik
    .label = VZVRATNI POMIK
    .help = Hitrost premikanja orodja pri umiku po obdelavi. Pri vrednosti 0 krmiljenje umakne orodje s pomikom { $q-roughing-feed }.
parameter-contour-retraction-feed__rough-out = Vzvratni pomik
    .prompt = Vzratni pomik?
parameter-rough-out-tool = Številka/ime izvrtalnega svedra
    .label = IZVRTALNI SVEDER
    .help = Številka ali ime orodja, ki bo konturo grobo rezkalo.
parameter-coarse-roughing-tool = Orodje za predvrtanje
    .label = ORODJE ZA PREDVRTANJE
    .help = Številka ali ime orodja, s katerim je krmiljenje konturo že grobo rezkalo. Če grobega rezkanja ni bilo, vnesite 0. Če je vnesena številka ali ime, krmiljenje obdela samo tisto, česar to orodje ni doseglo.
parameter-side-finishing-direction = Smer vrtenja
    .label = SMER VRTENJA
    .help = Smer obdelave.
parameter-remaining-side-allowance = Nadmera stranskega finega rezkanja
    .label = STRANSKA NADMERA
    .help = Nadmera za fino rezkanje v več delovnih korakih. Pri vrednosti 0 se odstrani še preostala nadmera finega rezkanja.
parameter-contour-milling-type = Vrsta rezkanja
    .label = VRSTA REZKANJA
    .help = Vrsta rezkanja vzdolž konture.

# --- cylinder surface ---
parameter-cylinder-milling-depth = Globina rezkanja
    .label = GLOB. REZKANJA
    .help = Razdalja med plaščem valja in dnom konture.
parameter-side-allowance__cylinder-surface =
    .help = Nadmera finega rezkanja v ravnini odvoja. Deluje v smeri popravka polmera.
parameter-side-allowance__cylinder-surface-slot =
    .help = Nadmera finega rezkanja na steni utora. Utor zoži za dvakratno vneseno vrednost.
parameter-side-allowance__cylinder-surface-ridge =
    .help = Nadmera finega rezkanja na steni stojine. Stojino razširi za dvakratno vneseno vrednost.
parameter-cylinder-set-up-clearance = Varnostna razdalja
    .label = VARNOSTNA RAZDALJA
    .help = Razdalja med čelno površino orodja in plaščem valja.
parameter-cylinder-radius = Polmer valja
    .label = POLMER
    .help = Polmer valja, na katerem se obdeluje kontura.
parameter-development-dimension-type = Vrsta dimenzioniranja (0 = stopinje, 1 = mm ali palci)
    .label = NAČ. DIMENZIONIRANJA
    .help = Določa, ali so koordinate rotacijske osi v podprogramu programirane v stopinjah ali v milimetrih (palcih).
    .prompt = Vrsta dimenzioniranja? Stopinja = 0 MM/PALEC = 1
parameter-cylinder-slot-width = Širina utora
    .label = ŠIRINA UTORA
    .help = Širina končnega utora.
parameter-cylinder-slot-tolerance = Toleranca
    .label = TOLERANCA
    .help = Dovoljeno odstopanje od idealnega utora, rezkanega z orodjem, ki je natanko tako široko kot utor. Če je orodje manjše od programirane širine utora { $q-cylinder-slot-width }, se stene utora pri krožnih lokih in poševnih premicah popačijo; če je toleranca vnesena, krmiljenje utor dodatno obdeluje, dokler se ne približa idealnemu. Število dodatnih obdelav je odvisno od polmera valja, orodja in globine utora. Čim manjša je toleranca, tem natančnejši je utor in tem dlje traja dodatna obdelava. Priporočena vrednost: 0,02{"\u00A0"}mm. Z vrednostjo 0 funkcijo izklopite (osnovna nastavitev).
parameter-cylinder-ridge-width = Širina stojine
    .label = ŠIRINA STOJINE
    .help = Širina končne stojine.

# --- engraving ---
parameter-engraving-text = Besedilo za graviranje
    .label = BESEDILO ZA GRAVIRANJE
    .help = Vnesite ga v narekovajih. Besedilni parameter (QS) priredite s tipko Q na številski tipkovnici; tipka Q na črkovni tipkovnici je za navadno besedilo.
parameter-character-height = Višina znakov
    .label = VIŠINA ZNAKA
    .help = Višina graviranih znakov v mm.
parameter-character-spacing-factor = Faktor razmaka
    .label = FAKTOR RAZMAKA
    .help = Razmik med znaki. Pisava je proporcionalna: vsak znak ima svojo širino, ki jo krmiljenje uporabi pri vrednosti 0. Pri drugi vrednosti krmiljenje spremeni razmik med znaki s tem faktorjem.
parameter-engraving-font = Vrsta črk
    .label = VRSTA ČRK
    .help = Trenutno brez funkcije.
parameter-text-arrangement = Besedilo ravno/na krogu (0/1)
    .label = RAZPOREDIT. BESEDILA
    .help = Določa, kako je besedilo razporejeno.
parameter-text-rotation = Rotacijski položaj
    .label = ROT. POLOŽAJ
    .help = Središčni kot, če je besedilo razporejeno na krožnem loku.
parameter-text-circle-radius = Polmer pri besedilu na krogu
    .label = POLMER KROGA
    .help = Polmer krožnega loka v mm, na katerega krmiljenje razporedi besedilo.
parameter-depth__engraving =
    .help = Razdalja med površino obdelovanca in dnom gravure.
parameter-plunging-feed__engraving =
    .help = Hitrost premikanja orodja pri spuščanju na globino.
parameter-set-up-clearance__engraving =
    .help = Razdalja konice orodja od površine obdelovanca. PREDEF prevzame vrednost iz stavka GLOBAL DEF.
parameter-second-set-up-clearance__engraving =
    .help = Višina na osi vretena, na kateri orodje ne more trčiti v obdelovanec ali vpenjalo. PREDEF prevzame vrednost iz stavka GLOBAL DEF.

parameter-surface-coordinate__contour-data = Koordinata površine obdelovanca
parameter-surface-coordinate__contour-train = Koordinata površine obdelovanca

# --- choices ---
choice-up-cut-pocket-and-island = rezkanje v protiteku za žep in otok
choice-climb-pocket-and-island = rezkanje v soteku za žep in otok
choice-finish-counter-clockwise = nasprotna smer urnega kazalca
choice-finish-clockwise = smer urnega kazalca
choice-climb-and-up-cut-alternately = izmenično rezkanje v soteku in protiteku v več primikih
choice-dimensions-in-degrees = stopinje
choice-dimensions-in-millimetres-or-inches = milimetri ali palci
choice-text-on-straight-line = graviranje besedila po premici
choice-text-on-arc = graviranje besedila po krožnem loku
