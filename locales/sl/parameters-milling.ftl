# Parameters of pockets, slots, studs, line patterns and multipass milling: name, label in the NC block, help.

# --- pockets, slots and studs ---
parameter-circle-diameter = Premer kroga
    .label = PREMER KROGA
    .help = Premer končnega žepa.
parameter-slot-length = Dolžina utora
    .label = DOLŽINA UTORA
    .help = Daljša stranica utora, vzporedna z glavno osjo obdelovalne ravnine.
parameter-milled-slot-width = Širina utora
    .label = ŠIRINA UTORA
    .help = Širina utora, vzporedna s pomožno osjo obdelovalne ravnine. Če je enaka premeru orodja, krmiljenje samo grobo rezka (izdela podolgovato luknjo). Največja širina utora za grobo rezkanje: dvakratni premer orodja.
parameter-angle-of-rotation__slot = Rot. položaj
    .help = Kot, za katerega se zavrti celoten utor. Središče vrtenja je položaj orodja ob priklicu cikla.
parameter-angle-of-rotation__line-pattern = Rot. položaj
    .help = Kot, za katerega se zavrti celoten vzorec. Središče vrtenja je začetna točka. Velja tudi za obdelovalni cikel, ki ga vzorec prikliče.
parameter-slot-position = Položaj utora (0/1/2/3/4)
    .label = POLOŽAJ UTORA
    .help = Položaj utora glede na položaj orodja ob priklicu cikla.
parameter-slot-position-reference = Referenca za položaj utora (0/1/2/3)
    .label = REFEREN. POL. UTORA
    .help = Položaj utora glede na položaj orodja ob priklicu cikla.
parameter-slot-starting-angle = Začetni kot
    .label = ZAČETNI KOT
    .help = Polarni kot začetne točke.
parameter-slot-opening-angle = Odpiralni kot utora
    .label = ODPRTI KOT
    .help = Kot, ki ga utor obsega.
parameter-pattern-stepping-angle__circular-slot =
    .help = Kot, za katerega se za vsako nadaljnjo obdelavo zavrti celoten utor. Središče vrtenja je središče delnega kroga.
parameter-stud-first-side-length = 1. stranska dolžina
    .label = 1. STRANSKA DOLŽINA
    .help = Dolžina čepa vzporedno z glavno osjo obdelovalne ravnine.
parameter-blank-first-side-length = Stranska dolžina surovca 1
    .label = MERE SUROVCA 1
    .help = Dolžina surovca čepa vzporedno z glavno osjo obdelovalne ravnine. Vnesite vrednost, večjo od 1. stranske dolžine { $q-stud-first-side-length }. Če se vrednosti razlikujeta za več kot dovoljeni stranski primik (polmer orodja, pomnožen s prekrivanjem poti { $q-path-overlap }), krmiljenje izvede več stranskih primikov. Vsi stranski primiki so enaki.
parameter-stud-second-side-length = 2. stranska dolžina
    .label = 2. STRANSKA DOLŽINA
    .help = Dolžina čepa vzporedno s pomožno osjo obdelovalne ravnine.
parameter-blank-second-side-length = Stranska dolžina surovca 2
    .label = MERE SUROVCA 2
    .help = Dolžina surovca čepa vzporedno s pomožno osjo obdelovalne ravnine. Vnesite vrednost, večjo od 2. stranske dolžine { $q-stud-second-side-length }. Če se vrednosti razlikujeta za več kot dovoljeni stranski primik (polmer orodja, pomnožen s prekrivanjem poti { $q-path-overlap }), krmiljenje izvede več stranskih primikov. Vsi stranski primiki so enaki.
parameter-corner-radius__rectangular-stud =
    .help = Polmer vogalov čepa.
parameter-side-allowance__rectangular-stud =
    .help = Nadmera finega rezkanja, ki jo krmiljenje pri obdelavi pusti v obdelovalni ravnini.
parameter-stud-position = Položaj čepa
    .label = POLOŽAJ ČEPA
    .help = Položaj čepa glede na položaj orodja ob priklicu cikla.
parameter-stud-approach-position = Položaj primika (0-4)
    .label = POLOŽAJ PRIMIKA
    .help = Določa, kje se orodje primakne k čepu.
parameter-finished-part-diameter = Končni premer
    .label = PREMER IZDELKA
    .help = Premer končnega čepa.
parameter-blank-diameter = Premer surovca
    .label = PREMER SUROVCA
    .help = Premer surovca mora biti večji od premera končnega izdelka { $q-finished-part-diameter }. Če se vrednosti razlikujeta za več kot dovoljeni stranski primik (polmer orodja, pomnožen s prekrivanjem poti { $q-path-overlap }), krmiljenje izvede več stranskih primikov. Vsi stranski primiki so enaki.
parameter-stud-starting-angle = Začetni kot
    .label = ZAČETNI KOT
    .help = Polarni kot glede na središče čepa, pod katerim se orodje primakne k čepu.
parameter-depth__slot =
    .help = Razdalja med površino obdelovanca in dnom utora.
parameter-depth__circular-slot =
    .help = Razdalja med površino obdelovanca in dnom utora.
parameter-depth__circular-pocket =
    .help = Razdalja med površino obdelovanca in dnom žepa.
parameter-depth__rectangular-stud =
    .help = Razdalja med površino obdelovanca in dnom čepa.
parameter-depth__circular-stud =
    .help = Razdalja med površino obdelovanca in dnom čepa.
parameter-plunging-depth__circular-pocket =
    .help = Globina, za katero se orodje vsakokrat primakne. Vnesite vrednost, večjo od 0.
parameter-plunging-depth__slot =
    .help = Globina, za katero se orodje vsakokrat primakne. Vnesite vrednost, večjo od 0.
parameter-plunging-depth__circular-slot =
    .help = Globina, za katero se orodje vsakokrat primakne. Vnesite vrednost, večjo od 0.
parameter-plunging-depth__rectangular-stud =
    .help = Globina, za katero se orodje vsakokrat primakne. Vnesite vrednost, večjo od 0.
parameter-plunging-depth__circular-stud =
    .help = Globina, za katero se orodje vsakokrat primakne. Vnesite vrednost, večjo od 0.
parameter-plunging-feed__circular-pocket =
    .help = Hitrost premikanja orodja pri spuščanju na globino.
    .label = GLOBINSKI PRIMIK
parameter-plunging-feed__slot =
    .help = Hitrost premikanja orodja pri spuščanju na globino.
    .label = GLOBINSKI PRIMIK
parameter-plunging-feed__circular-slot =
    .help = Hitrost premikanja orodja pri spuščanju na globino.
    .label = GLOBINSKI PRIMIK
parameter-plunging-feed__rectangular-stud =
    .help = Hitrost premikanja orodja pri spuščanju na globino.
    .label = GLOBINSKI PRIMIK
    .label-aliases = POM. PRI GLOB. PRIM.
parameter-plunging-feed__circular-stud =
    .help = Hitrost premikanja orodja pri spuščanju na globino.
    .label = GLOBINSKI PRIMIK
parameter-plunging-feed__multipass-milling =
    .help = Hitrost premikanja orodja pri spuščanju na globino.

# --- line patterns ---
parameter-pattern-spacing-main = Razdalja na 1. osi
    .label = RAZDALJA NA 1. OSI
    .help = Razdalja med točkami v vrstici.
parameter-pattern-spacing-minor = Razdalja na 2. osi
    .prompt = Razdalja 2. osi?
    .label = RAZDALJA NA 2. OSI
    .help = Razdalja med vrsticami.
parameter-number-of-columns = Število stolpcev
    .label = ŠTEVILO STOLPCEV
    .help = Število obdelav v vrstici.
parameter-number-of-lines = Število vrstic
    .label = ŠTEVILO VRSTIC
    .help = Število vrstic.
parameter-starting-point-main__line-pattern =
    .help = Koordinata začetne točke na glavni osi obdelovalne ravnine.
parameter-starting-point-minor__line-pattern =
    .help = Koordinata začetne točke na pomožni osi obdelovalne ravnine.
parameter-set-up-clearance__line-pattern =
    .help = Razdalja konice orodja od površine obdelovanca. Velja tudi za obdelovalni cikel, ki ga vzorec prikliče.
parameter-surface-coordinate__line-pattern =
    .help = Koordinata površine obdelovanca. Velja tudi za obdelovalni cikel, ki ga vzorec prikliče.
parameter-second-set-up-clearance__line-pattern =
    .help = Višina na osi vretena, na kateri orodje ne more trčiti v obdelovanec ali vpenjalo. Velja tudi za obdelovalni cikel, ki ga vzorec prikliče.

# --- multipass milling of surfaces ---
parameter-starting-point-main = Začetna točka 1. osi
    .label = ZAČETNA TOČKA 1. OSI
    .label-aliases = ZAČETNATOČKA 1. OSI
    .help = Koordinata začetne točke ploskve, ki se obdeluje, na glavni osi obdelovalne ravnine.
parameter-starting-point-minor = Začetna točka 2. osi
    .label = ZAČETNA TOČKA 2. OSI
    .label-aliases = ZAČETNATOČKA 2. OSI
    .help = Koordinata začetne točke ploskve, ki se obdeluje, na pomožni osi obdelovalne ravnine.
parameter-starting-point-tool = Začetna točka 3. osi
    .label = ZAČETNA TOČKA 3. OSI
    .label-aliases = ZAČETNATOČKA 3. OSI
    .help = Višina na osi vretena, na kateri se ploskev rezka.
parameter-starting-point-tool__ruled-surface =
    .help = Koordinata začetne točke ploskve, ki se obdeluje, na osi vretena.
parameter-starting-point-tool__face-milling =
    .help = Koordinata površine obdelovanca, od katere se računajo primiki.
parameter-first-side-length__multipass-milling =
    .help = Dolžina ploskve, ki se obdeluje, na glavni osi obdelovalne ravnine, od začetne točke 1. osi.
parameter-first-side-length__face-milling =
    .help = Dolžina ploskve, ki se obdeluje, na glavni osi obdelovalne ravnine. Predznak določa smer prve poti rezkanja glede na začetno točko 1. osi.
parameter-second-side-length__multipass-milling =
    .help = Dolžina ploskve, ki se obdeluje, na pomožni osi obdelovalne ravnine, od začetne točke 2. osi.
parameter-second-side-length__face-milling =
    .help = Dolžina ploskve, ki se obdeluje, na pomožni osi obdelovalne ravnine. Predznak določa smer prvega stranskega primika glede na začetno točko 2. osi.
parameter-number-of-cuts = Število rezov
    .label = ŠTEVILO REZOV
    .help = Število vrstic, v katerih krmiljenje premika orodje po širini.
parameter-number-of-cuts__ruled-surface =
    .help = Število vrstic, ki jih krmiljenje obdela med točkama 1 in 4 oziroma med točkama 2 in 3.
parameter-stepover-feed = Prečni pomik
    .label = PREČNI POMIK
    .help = Hitrost premikanja orodja pri premiku v naslednjo vrstico. Za prečni premik v materialu vnesite vrednost, manjšo od { $q-milling-feed }; pri prečnem premiku nad obdelovancem je { $q-stepover-feed } lahko večji od { $q-milling-feed }.
parameter-set-up-clearance__multipass-milling =
    .help = Razdalja med konico orodja in globino rezkanja za pozicioniranje na začetku in na koncu cikla.
parameter-set-up-clearance__face-milling =
    .help = Razdalja med konico orodja in začetnim položajem na orodni osi. Pri strategiji { $q-face-milling-strategy } = 2 se orodje na tej razdalji nad trenutno globino primika premakne na začetno točko naslednje vrstice.
parameter-surface-second-point-main = 2. točka 1. osi
    .label = 2. TOČKA 1. OSI
    .help = Koordinata končne točke ploskve, ki se obdeluje, na glavni osi obdelovalne ravnine.
parameter-surface-second-point-minor = 2. točka 2. osi
    .label = 2. TOČKA 2. OSI
    .help = Koordinata končne točke ploskve, ki se obdeluje, na pomožni osi obdelovalne ravnine.
parameter-surface-second-point-tool = 2. točka 3. osi
    .label = 2. TOČKA 3. OSI
    .help = Koordinata končne točke ploskve, ki se obdeluje, na osi vretena.
parameter-surface-third-point-main = 3. točka 1. osi
    .label = 3. TOČKA 1. OSI
    .help = Koordinata točke 3 na glavni osi obdelovalne ravnine.
parameter-surface-third-point-minor = 3. točka 2. osi
    .label = 3. TOČKA 2. OSI
    .help = Koordinata točke 3 na pomožni osi obdelovalne ravnine.
parameter-surface-third-point-tool = 3. točka 3. osi
    .label = 3. TOČKA 3. OSI
    .help = Koordinata točke 3 na osi vretena.
parameter-surface-fourth-point-main = 4. točka 1. osi
    .label = 4. TOČKA 1. OSI
    .help = Koordinata točke 4 na glavni osi obdelovalne ravnine.
parameter-surface-fourth-point-minor = 4. točka 2. osi
    .label = 4. TOČKA 2. OSI
    .help = Koordinata točke 4 na pomožni osi obdelovalne ravnine.
parameter-surface-fourth-point-tool = 4. točka 3. osi
    .label = 4. TOČKA 3. OSI
    .help = Koordinata točke 4 na osi vretena.
parameter-milling-feed__ruled-surface =
    .help = Hitrost premikanja orodja pri rezkanju. Prvi rez izvede krmiljenje s polovico programirane vrednosti.
parameter-face-milling-strategy = Obdelovalna strategija (0/1/2)
    .label = STRATEGIJA
    .help = Določa, kako krmiljenje obdela ploskev.
parameter-end-point-tool = Končna točka 3. osi
    .label = KONČNA TOČKA 3. OSI
    .help = Koordinata na osi vretena, do katere se ploskev plansko rezka.
parameter-max-plunging-depth = Maks. globina primika
    .label = MAKS. DOSTAVNA GLOBINA
    .help = Največja globina, za katero se orodje primakne z enim primikom. Dejansko globino primika krmiljenje izračuna iz razlike med končno in začetno točko na orodni osi, in sicer tako, da so vsi primiki enaki; pri tem upošteva nadmero finega rezkanja { $q-floor-allowance }.
parameter-floor-allowance__face-milling =
    .help = Globina zadnjega primika.
    .label = PREDIZMERA GLOBINA
parameter-max-path-overlap = Največji faktor prekrivanja poti
    .label = MAKS. PREKRIVANJE
    .help = Faktor, ki določa največji stranski primik k. Dejanski stranski primik krmiljenje izračuna iz 2. stranske dolžine { $q-second-side-length } in polmera orodja, in sicer tako, da so vsi stranski primiki enaki. Če je v preglednici orodij vnesen polmer { $mp-tool-radius-2 } (na primer polmer ploščice pri čelni rezkalni glavi), krmiljenje stranski primik ustrezno zmanjša.
parameter-finishing-feed__face-milling =
    .help = Hitrost premikanja orodja pri rezkanju po zadnjem primiku.
    .label = POMIK PRI FINEM REZK.
parameter-pre-positioning-feed__face-milling = Pomik pri predpozicioniranju
    .help = Hitrost premikanja orodja pri premiku na začetni položaj in v naslednjo vrstico. Če poteka stranski primik v materialu ({ $q-face-milling-strategy } = 1), ga krmiljenje izvede s pomikom pri rezkanju { $q-milling-feed }.
parameter-side-clearance = Stranska varnostna razdalja
    .label = STRANSKA VARNOSTNA RAZDALJA
    .help = Stranska razdalja orodja od obdelovanca pri premiku na prvo globino primika in razdalja, na kateri potekajo stranski primiki pri strategijah { $q-face-milling-strategy } = 0 in { $q-face-milling-strategy } = 2.

# --- choices ---
choice-vertical-plunging-with-angle-0-or-90 = navpično spuščanje. Kot spuščanja { $mp-plunging-angle } aktivnega orodja v preglednici orodij mora biti 0 ali 90, sicer krmiljenje javi napako
choice-reciprocating-plunging-by-angle = nihajoče spuščanje. Kot spuščanja { $mp-plunging-angle } aktivnega orodja v preglednici orodij ne sme biti 0, sicer krmiljenje javi napako
choice-tool-at-slot-centre = položaj orodja = središče utora
choice-tool-at-left-slot-end = položaj orodja = levi konec utora
choice-tool-at-left-slot-arc-centre = položaj orodja = središče levega kroga utora
choice-tool-at-right-slot-arc-centre = položaj orodja = središče desnega kroga utora
choice-tool-at-right-slot-end = položaj orodja = desni konec utora
choice-tool-position-not-considered = položaj orodja se ne upošteva. Položaj utora izhaja iz vnesenega središča delnega kroga in začetnega kota
choice-slot-begins-at-tool = položaj orodja = središče levega kroga utora. Začetni kot { $q-slot-starting-angle } se nanaša na ta položaj. Vneseno središče delnega kroga se ne upošteva
choice-slot-middle-at-tool = položaj orodja = središče srednje osi. Začetni kot { $q-slot-starting-angle } se nanaša na ta položaj. Vneseno središče delnega kroga se ne upošteva
choice-slot-ends-at-tool = položaj orodja = središče desnega kroga utora. Začetni kot { $q-slot-starting-angle } se nanaša na ta položaj. Vneseno središče delnega kroga se ne upošteva
choice-tool-at-stud-centre = položaj orodja = središče čepa
choice-approach-right-of-stud = desno ob čepu (privzeta nastavitev)
choice-approach-at-lower-left-corner = levi spodnji vogal
choice-approach-at-lower-right-corner = desni spodnji vogal
choice-approach-at-upper-right-corner = desni zgornji vogal
choice-approach-at-upper-left-corner = levi zgornji vogal
choice-meander-stepover-outside = meandraste poti, stranski primik zunaj ploskve, ki se obdeluje
choice-meander-stepover-inside = meandraste poti, stranski primik znotraj ploskve, ki se obdeluje
choice-line-by-line-with-retraction = vrstica za vrstico, z umikom in stranskim primikom s pomikom za pozicioniranje

# --- coordinate transforms ---
parameter-mirrored-axes = Zrcaljena os
    .help = Osi, ki naj se zrcalijo. Zrcaliti je mogoče vse osi, tudi rotacijske, razen osi vretena in pomožne osi, ki ji je vzporedna. Največ tri od NC-osi X, Y, Z, U, V, W, A, B, C.
    .prompt = Zrcaljena os?
parameter-scaling-factor = Faktor
    .help = Faktor merila SCL. Krmiljenje z njim pomnoži koordinate in polmere.
    .prompt = Faktor?
    .word = SCL
parameter-axis-scaling-factors = Os in faktor
    .help = Koordinatne osi in faktorji, s katerimi se vsaka od njih raztegne ali stisne.
parameter-axis-scaling-centre = Koordinate središča
    .help = Središče, od katerega se kontura raztegne ali proti kateremu se stisne.
parameter-tilting-angles = Rotacijska os in kot
    .help = Rotacijske osi z naklonskimi koti; rotacijske osi A, B in C se programirajo z gumbi.
    .prompt = Rotacijska os in kot?
parameter-tilting-feed = Pomik
    .help = Hitrost premikanja rotacijske osi, če jo krmiljenje pozicionira samodejno.
    .prompt = Pomik? F=
parameter-tilting-clearance = Varnostna razdalja
    .help = Krmiljenje vrtljivo glavo pozicionira tako, da se položaj konca orodja, podaljšanega za varnostno razdaljo, glede na obdelovanec ne spremeni. Vnese se, če krmiljenje rotacijske osi pozicionira samodejno.
    .prompt = Varnostna razdalja?

# --- special functions ---
parameter-programmed-dwell = Čas zadrževanja v sekundah
    .help = Čas, za katerega se programski tek zaustavi, do 1 ure v korakih po 0,001{"\u00A0"}s.
    .word = ČAS ZADRŽ.
parameter-program-to-call = Ime programa
    .help = Ime programa, ki naj se prikliče, po potrebi s potjo.
    .word = PGM
parameter-orientation-angle = Kot usmeritve
    .help = Kot glede na kotno referenčno os obdelovalne ravnine.
    .word = KOT
parameter-contour-tolerance = Tolerančna vrednost T
    .help = Dovoljeno odstopanje od programirane konture v milimetrih (v palčnih programih v palcih).
parameter-hsc-mode = Način HSC (0 = fino rezkanje, 1 = grobo rezkanje)
    .prompt = NAČIN HSC, fino rezkanje=0, grobo rezkanje=1?
    .help = Filter, ki ga krmiljenje aktivira.
parameter-rotary-axis-tolerance = Toleranca za rotacijske osi TA
    .help = Dovoljeno odstopanje rotacijskih osi v stopinjah pri aktivni funkciji M128 (FUNCTION TCPM). Krmiljenje pomik vedno zmanjša tako, da se pri premikih po več oseh najpočasnejša os premika s svojim največjim pomikom. Rotacijske osi so praviloma precej počasnejše od linearnih. Večja toleranca (na primer 10°) lahko precej skrajša čas obdelave večosnih programov, ker krmiljenju rotacijskih osi ni treba vedno premakniti na predpisani želeni položaj. Kontura se pri tem ne poškoduje; spremeni se samo položaj rotacijske osi glede na površino obdelovanca.

# --- choices of the special functions ---
choice-milling-with-higher-accuracy = rezkanje z večjo natančnostjo konture. Krmiljenje uporabi interno določene nastavitve filtra za fino rezkanje
choice-milling-at-higher-feed = rezkanje z večjim pomikom. Krmiljenje uporabi interno določene nastavitve filtra za grobo rezkanje
