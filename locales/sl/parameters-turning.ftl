# Parameters of the turning cycles: name, label in the NC block, help.

# --- extent, clearance, feeds ---
parameter-turning-operation = Obseg obdelave
    .label = OBSEG OBDELAVE
parameter-turning-clearance = Varnostna razdalja
    .label = VARNOSTNA RAZDALJA
parameter-max-cutting-depth = Največja rez. globina
    .label = NAJVEČJA GLOBINA REZA
    .label-aliases = NAJV. GLOBINA REZA | NAJVEČJA REZ. GLOBINA
parameter-max-axial-cutting-depth = Največja rez. globina
    .label = NAJVEČJA GLOBINA REZA
    .label-aliases = NAJV. GLOBINA REZA | NAJVEČJA REZ. GLOBINA
parameter-turning-roughing-feed = Pomik pri grobem obdelovanju
    .label = POMIK PRI GROBEM OBDELOVANJU
parameter-turning-finishing-feed = Pomik pri finem obdelovanju
    .label = POMIK PRI FINEM OBDELOVANJU
parameter-diameter-oversize = Nadmera premera
    .label = NADMERA PREMERA
parameter-z-oversize = Nadmera Z
    .label = NADMERA Z
parameter-contour-smoothing = Glajenje konture
    .label = GLAJENJE KONTURE

# --- contour defined by its corners ---
parameter-contour-start-diameter = Premer začetka konture
    .label = PREMER OB ZAČETKU KONTURE
    .label-aliases = PREMER OB ZACETKU KONTURE
parameter-contour-start-z = Začetek konture Z
    .label = ZAČETEK KONTURE Z
    .label-aliases = ZACETEK KONTURE Z
parameter-plunging-start-z = Začetek konture Z
    .label = ZAČETEK KONTURE Z
parameter-contour-end-diameter = Premer konca konture
    .label = PREMER KONCA KONTURE
parameter-contour-end-z = Konec konture Z
    .label = KONEC KONTURE Z
parameter-circumferential-surface-angle = Kot obodne površine
    .label = KOT POVRŠINE OBSEGA
parameter-face-angle = Kot čelne površine
    .label = KOT ČELNE POVRŠINE
parameter-flank-angle = Kot boka
    .label = KOT BOKA
parameter-start-element-type = Vrsta začetnega elementa
    .label = VRSTA ZAČETNEGA ELEMENTA
parameter-start-element-size = Velikost začetnega elementa
    .label = VELIKOST ZAČETNEGA ELEM.
parameter-contour-corner-radius = Polmer vogala konture
    .label = POLMER ROBA KONTURE
parameter-end-element-type = Vrsta končnega elementa
    .label = VRSTA KONČNEGA ELEMENTA
parameter-end-element-size = Velikost končnega elementa
    .label = VELIKOST KONČNEGA ELEMENTA

# --- contour described in a subprogram ---
parameter-contour-reversal = Obračanje konture
    .label = OBRAČANJE KONTURE
parameter-undercut-machining = Spuščanje
    .label = SPUŠČANJE
parameter-undercut-feed = Spuščanje pomika
    .label = POMIK PRI SPUŠČANJU
parameter-cutting-limit = Omejitev reza
    .label = OMEJITEV REZA
parameter-cutting-limit-diameter = Premer mejne vrednosti
    .label = PREMER MEJNE VREDN.
parameter-cutting-limit-z = Mejna vrednost Z
    .label = MEJNA VREDNOST Z
parameter-blank-oversize = Nadmera surovca
    .label = NADMERA SUROVCA
parameter-cutting-lines = Rezne črte
    .label = REZNE ČRTE

# --- orientation of the tool ---
parameter-precession-angle = Precesijski kot
    .label = PRECESIJSKI KOT
parameter-tool-reversal = Obračanje orodja
    .label = OBRAČANJE ORODJA
