# Parameters of the machining cycles: name, label in the NC block, help.

# --- heights and depths ---
parameter-set-up-clearance = Varnostna razdalja
    .label = VARNOSTNA RAZDALJA
    .help = Razdalja konice orodja od { -surface(case: "genitive") }.
parameter-set-up-clearance__drilling =
    .help = Razdalja konice orodja od { -surface(case: "genitive") }. Vnesite pozitivno vrednost.
parameter-set-up-clearance__centring =
    .help = Razdalja konice orodja od { -surface(case: "genitive") }. Vnesite pozitivno vrednost.
parameter-set-up-clearance__circular-pattern =
    .help = Razdalja konice orodja od { -surface(case: "genitive") }. Velja tudi za obdelovalni cikel, ki ga vzorec prikliče.
parameter-set-up-clearance__rectangular-pocket =
    .help = Razdalja konice orodja od { -surface(case: "genitive") }. PREDEF prevzame vrednost iz stavka GLOBAL DEF.
parameter-set-up-clearance__circular-pocket =
    .help = Razdalja konice orodja od { -surface(case: "genitive") }. PREDEF prevzame vrednost iz stavka GLOBAL DEF.
parameter-set-up-clearance__slot =
    .help = Razdalja konice orodja od { -surface(case: "genitive") }. PREDEF prevzame vrednost iz stavka GLOBAL DEF.
parameter-set-up-clearance__circular-slot =
    .help = Razdalja konice orodja od { -surface(case: "genitive") }. PREDEF prevzame vrednost iz stavka GLOBAL DEF.
parameter-set-up-clearance__rectangular-stud =
    .help = Razdalja konice orodja od { -surface(case: "genitive") }. PREDEF prevzame vrednost iz stavka GLOBAL DEF.
parameter-set-up-clearance__circular-stud =
    .help = Razdalja konice orodja od { -surface(case: "genitive") }. PREDEF prevzame vrednost iz stavka GLOBAL DEF.
parameter-second-set-up-clearance = 2. varnostna razdalja
    .label = 2. VARNOSTNA RAZDALJA
    .label-aliases = 2. VARNOST. RAZD. | 2. VARNOSTNI RAZMAK
    .help = Višina na osi vretena, na kateri orodje ne more trčiti v obdelovanec ali vpenjalo.
parameter-second-set-up-clearance__circular-pattern =
    .help = Višina na osi vretena, na kateri orodje ne more trčiti v obdelovanec ali vpenjalo. Velja tudi za obdelovalni cikel, ki ga vzorec prikliče.
parameter-second-set-up-clearance__rectangular-pocket =
    .help = Višina na osi vretena, na kateri orodje ne more trčiti v obdelovanec ali vpenjalo. PREDEF prevzame vrednost iz stavka GLOBAL DEF.
parameter-second-set-up-clearance__circular-pocket =
    .help = Višina na osi vretena, na kateri orodje ne more trčiti v obdelovanec ali vpenjalo. PREDEF prevzame vrednost iz stavka GLOBAL DEF.
parameter-second-set-up-clearance__slot =
    .help = Višina na osi vretena, na kateri orodje ne more trčiti v obdelovanec ali vpenjalo. PREDEF prevzame vrednost iz stavka GLOBAL DEF.
parameter-second-set-up-clearance__circular-slot =
    .help = Višina na osi vretena, na kateri orodje ne more trčiti v obdelovanec ali vpenjalo. PREDEF prevzame vrednost iz stavka GLOBAL DEF.
parameter-second-set-up-clearance__rectangular-stud =
    .help = Višina na osi vretena, na kateri orodje ne more trčiti v obdelovanec ali vpenjalo. PREDEF prevzame vrednost iz stavka GLOBAL DEF.
parameter-second-set-up-clearance__circular-stud =
    .help = Višina na osi vretena, na kateri orodje ne more trčiti v obdelovanec ali vpenjalo. PREDEF prevzame vrednost iz stavka GLOBAL DEF.
parameter-second-set-up-clearance__face-milling =
    .help = Višina na osi vretena, na kateri orodje ne more trčiti v obdelovanec ali vpenjalo. PREDEF prevzame vrednost iz stavka GLOBAL DEF.
parameter-surface-coordinate = Koord. površine obdelovanca
    .label = KOOR. POVRŠINE
    .help = Koordinata { -surface(case: "genitive") }.
parameter-surface-coordinate__circular-pattern =
    .help = Koordinata { -surface(case: "genitive") }. Velja tudi za obdelovalni cikel, ki ga vzorec prikliče.
parameter-depth = Globina
    .label = GLOBINA
    .help = Razdalja med { -surface(case: "instrumental") } in dnom vrtine, merjeno do konice vrtalnega stožca.
parameter-depth__rectangular-pocket =
    .help = Razdalja med { -surface(case: "instrumental") } in dnom žepa.
parameter-plunging-depth = Globina primika
    .label = GLOBINA PRIMIKA
    .help = Globina, za katero se orodje primakne z vsakim primikom. Celotna globina ni nujno njen večkratnik. Orodje doseže globino z enim premikom, če sta vrednosti enaki ali če je globina primika večja od globine.
parameter-plunging-depth__rectangular-pocket =
    .help = Globina, za katero se orodje primakne z vsakim primikom. Vnesite vrednost, večjo od 0.
parameter-decrement = Vrednost pojemanja
    .label = PRIBLIŽEK
    .label-aliases = ZMANJŠANJE
    .help = Vrednost, za katero se { -plunging-depth(case: "nominative") } { $q-plunging-depth } z vsakim primikom zmanjša.
parameter-least-plunging-depth = Min. globina primika
    .label = MIN. GLOBINA POMIKA
    .help = Če je vnesena vrednost pojemanja { $q-decrement }, noben primik ni manjši od te vrednosti.
parameter-upper-advanced-stop-distance = Razdalja zadrž. zgoraj
    .label = RAZDALJA ZADRŽ. ZGORAJ
    .help = Razdalja nad trenutno globino primika, do katere se orodje po umiku vrne v vrtino v hitrem teku: vrednost pri prvem primiku.
parameter-lower-advanced-stop-distance = Razdalja zadrž. spodaj
    .label = RAZDALJA ZADRŽ. SPODAJ
    .help = Razdalja nad trenutno globino primika, do katere se orodje po umiku vrne v vrtino v hitrem teku: vrednost pri zadnjem primiku.
parameter-depth-for-chip-breaking = Globina vrtanja do loma ostružkov
    .label = GLOBINA VRTANJA DO LOMA OSTRUŽKOV
    .help = Primik, po katerem se ostružek odlomi. Pri vrednosti 0 loma ostružkov ni.
parameter-chip-breaking-retraction = Odmik pri lomu ostružkov
    .label = ODMIK PRI LOMU OSTRUŽKOV
    .help = Razdalja, za katero se orodje umakne, da odlomi ostružek. Orodje se umakne s hitrostjo 3000{"\u00A0"}mm/min.
parameter-deepened-starting-point = Globlja začetna točka
    .label = ZAČETNA TOČKA
    .help = Začetna točka dejanskega vrtanja, merjena od { -surface(case: "genitive") }, kadar je vrtina s krajšim orodjem že izdelana do določene globine. Orodje se do nje premakne z varnostne razdalje s predpozicionirnim pomikom { $q-pre-positioning-feed }.

# --- feeds and times ---
parameter-plunging-feed = Pomik pri globinskem primiku
    .label = POM. PRI GLOB. PRIM.
    .label-aliases = F GLOB. PRIM. | POM. PRI GLOB. PRIMIKU
    .help = Hitrost premikanja orodja pri vrtanju.
parameter-plunging-feed__rectangular-pocket =
    .label = GLOBINSKI PRIMIK
    .label-aliases = POM. PRI GLOB. PRIM.
    .help = Hitrost premikanja orodja pri spuščanju na globino.
parameter-pre-positioning-feed = Predpozicionirni pomik
    .label = POMIK PRI PREDPOZ.
    .label-aliases = PREDPOZICIONIRNI POMIK
    .help = Hitrost premikanja orodja z varnostne razdalje na globljo začetno točko. Deluje samo, če { $q-deepened-starting-point } ni 0.
parameter-milling-feed = Pomik pri rezkanju
    .label = POMIK PRI REZKANJU
    .help = Hitrost premikanja orodja pri rezkanju.
parameter-finishing-feed = Pomik pri finem rezkanju
    .label = POMIK PRI FINEM REZKANJU
    .label-aliases = POMIK PRI FINEM REZK.
    .help = Hitrost premikanja orodja pri finem rezkanju stene in dna.
parameter-dwell-at-top = Čas zadrževanja zgoraj
    .label = ČAS ZADRŽ. ZGORAJ
    .label-aliases = ČAS ZADRŽ. ZG.
    .help = Čas, ko orodje stoji na varnostni razdalji, potem ko je bilo zaradi hlajenja umaknjeno iz vrtine.
parameter-dwell-at-bottom = Čas zadrževanja spodaj
    .label = ČAS ZADRŽ. SPODAJ
    .help = Čas, v katerem orodje miruje na dnu vrtine.

# --- milling of pockets ---
parameter-machining-operation = Obseg obdelave (0/1/2)
    .label = OBSEG OBDELAVE
    .help = Kaj se obdela. Stena in dno se fino rezkata samo, če je definirana ustrezna nadmera finega rezkanja ({ $q-side-allowance }, { $q-floor-allowance }).
parameter-first-side-length = 1. stranska dolžina
    .label = 1. STRANSKA DOLŽINA
    .help = Dolžina žepa vzporedno z glavno osjo { -working-plane(case: "genitive") }.
parameter-second-side-length = 2. stranska dolžina
    .label = 2. STRANSKA DOLŽINA
    .help = Dolžina žepa vzporedno s pomožno osjo { -working-plane(case: "genitive") }.
parameter-corner-radius = Polmer vogala
    .label = POLMER KOTA
    .label-aliases = POLMER ROBA
    .help = Polmer vogalov žepa. Pri vrednosti 0 krmiljenje za polmer vogala vzame polmer orodja.
parameter-side-allowance = Nadmera stranskega finega rezkanja
    .label = STRANSKA NADMERA
    .help = Nadmera finega rezkanja v { -working-plane(case: "locative") }.
parameter-floor-allowance = Nadmera globinskega finega rezkanja
    .label = GLOB. NADMERA
    .label-aliases = PREDIZMERA GLOBINA
    .help = Nadmera finega rezkanja na globini.
parameter-angle-of-rotation = Rotacijski položaj
    .label = ROT. POLOŽAJ
    .help = Kot, za katerega se zavrti celotna obdelava. Središče vrtenja je položaj orodja ob priklicu cikla.
parameter-pocket-position = Položaj žepa
    .label = POLOŽAJ ŽEPA
    .help = Položaj žepa glede na položaj orodja ob priklicu cikla.
parameter-milling-type = Vrsta rezkanja
    .label = VRSTA REZKANJA
    .help = Vrsta rezkanja pri vrtenju vretena v smeri urnega kazalca (M3). PREDEF prevzame vrednost iz stavka GLOBAL DEF.
parameter-finishing-infeed = Primik pri finem rezkanju
    .label = PRIM. FINO REZKANJE
    .help = Razdalja, za katero se orodje po osi vretena primakne za vsak prehod finega rezkanja. Pri vrednosti 0 poteka fino rezkanje z enim primikom.
parameter-path-overlap = Faktor prekrivanja poti
    .label = PREKRIVANJE POTI
    .help = Stranski primik k je zmnožek tega faktorja in polmera orodja. PREDEF prevzame vrednost iz stavka GLOBAL DEF.
parameter-plunging-strategy = Strategija spuščanja
    .label = SPUŠČANJE
    .help = Kako orodje vstopi v material. PREDEF prevzame vrednost iz stavka GLOBAL DEF.

# --- patterns ---
parameter-pitch-circle-centre-main = Središče 1. osi
    .label = SREDIŠČE 1. OSI
    .help = Središče delnega kroga na glavni osi { -working-plane(case: "genitive") }.
parameter-pitch-circle-centre-minor = Središče 2. osi
    .label = SREDIŠČE 2. OSI
    .help = Središče delnega kroga na pomožni osi { -working-plane(case: "genitive") }.
parameter-pitch-circle-diameter = Premer delnega kroga
    .label = PREMER DEL. KROGA
    .help = Premer delnega kroga, na katerem ležijo obdelave.
parameter-pattern-starting-angle = Začetni kot
    .label = ZAČETNI KOT
    .help = Kot, pod katerim glede na glavno os { -working-plane(case: "genitive") } na delnem krogu leži začetna točka prve obdelave.
parameter-pattern-stopping-angle = Končni kot
    .label = KONČNI KOT
    .help = Kot, pod katerim glede na glavno os { -working-plane(case: "genitive") } na delnem krogu leži začetna točka zadnje obdelave; za polne kroge ne velja. Razlikovati se mora od začetnega kota { $q-pattern-starting-angle }. Če je večji od začetnega kota, poteka obdelava v nasprotni smeri urnega kazalca, sicer v smeri urnega kazalca.
parameter-pattern-stepping-angle = Kotni korak
    .label = KOTNI KORAK
    .help = Kot med dvema obdelavama na delnem krogu. Pri vrednosti 0 ga krmiljenje izračuna iz začetnega kota, končnega kota in števila obdelav. Če je vnesen, se končni kot { $q-pattern-stopping-angle } ne upošteva. Predznak določa smer (− = v smeri urnega kazalca).
parameter-number-of-operations = Število obdelav
    .label = ŠTEVILO OBDELAV
    .help = Koliko obdelav leži na delnem krogu.
parameter-pattern-clearance-mode = Premik na varno višino
    .label = PREMIK NA VARNO VIŠINO
    .label-aliases = PREMIK NA VARNOSTNO VIŠINO
    .help = Na kateri višini se orodje premika med obdelavami.
parameter-pattern-traverse-type = Način premika? Premočrtno=0/krožno=1
    .label = NAČIN PREMIKA
    .help = Po kakšni poti se orodje premika med obdelavami.
    .prompt = Način premika? Premočrtno=0/krožno=1

# --- coordinate transforms ---
parameter-datum-shift = Zamik
    .help = Koordinate, na katerih je nova ničelna točka. Absolutne vrednosti se nanašajo na ničelno točko obdelovanca, določeno kot referenčna točka; inkrementalne vrednosti se vedno nanašajo na nazadnje veljavno ničelno točko, ki je lahko tudi sama zamaknjena. Mogočih je do 6 osi NC.
parameter-datum-row = Zamik
    .help = Številka ničelne točke v { -datum-table(case: "locative") } ali Q-parameter. Pri Q-parametru krmiljenje aktivira ničelno točko, katere številka je v parametru.
parameter-rotation-angle = Rotacija
    .help = Rotacijski kot v stopinjah, absolutno ali inkrementalno.
parameter-preset-number = Številka za referenčno točko
    .label = ŠTEVILKA REF. TOČKE
    .help = Številka referenčne točke v { -preset-table(case: "locative") }, ki naj se aktivira.
    .prompt = Številka za referenčno točko?

# --- choices ---
choice-roughing-and-finishing = grobo in fino obdelovanje
choice-roughing-only = samo grobo obdelovanje
choice-finishing-only = stransko in globinsko fino rezkanje
choice-tool-at-pocket-centre = položaj orodja = središče žepa
choice-tool-at-lower-left-corner = položaj orodja = levi spodnji vogal
choice-tool-at-lower-right-corner = položaj orodja = desni spodnji vogal
choice-tool-at-upper-right-corner = položaj orodja = desni zgornji vogal
choice-tool-at-upper-left-corner = položaj orodja = levi zgornji vogal
choice-climb-milling = rezkanje v soteku
choice-up-cut-milling = rezkanje v protiteku
choice-vertical-plunging = navpično spuščanje, ne glede na kot spuščanja { $mp-plunging-angle } v { -tool-table(case: "locative") }
choice-helical-plunging = vijačno spuščanje. Kot spuščanja { $mp-plunging-angle } aktivnega orodja v { -tool-table(case: "locative") } ne sme biti 0, sicer krmiljenje javi napako
choice-reciprocating-plunging = nihajoče spuščanje. Kot spuščanja { $mp-plunging-angle } aktivnega orodja v { -tool-table(case: "locative") } ne sme biti 0, sicer krmiljenje javi napako. Dolžina nihanja je odvisna od kota spuščanja in znaša najmanj dvakratni premer orodja
choice-at-set-up-clearance = premik med obdelavami na varnostni razdalji
choice-at-second-set-up-clearance = premik med obdelavami na 2. varnostni razdalji
choice-straight-between-operations = premočrtno premikanje med obdelavami
choice-on-the-pitch-circle = krožni premik po delnem krogu med obdelavami
