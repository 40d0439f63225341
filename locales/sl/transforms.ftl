# Coordinate transformations.

# --- common ---
form-coordinates = Koordinate ničelne točke
form-table = Vrstica preglednice ničelnih točk
note-transform-acts-until-reset = Preračunavanje koordinat deluje od definicije naprej in se ne prikliče. Veljavno ostane, dokler ga ne ponastavite ali znova definirate.
note-transform-reset-ways = Preračunavanje koordinat ponastavite z novo definicijo cikla z vrednostmi osnovnega stanja (na primer s faktorjem merila 1,0), z dodatnima funkcijama M2 in M30 ali s stavkom END PGM (odvisno od strojnega parametra { $mp-clear-mode }) in z izbiro drugega programa.

# --- 7 ---
cycle-datum-shift = Zamik ničelne točke
    .nc = NIČELNA TOČKA
    .purpose = Omogoča, da se obdelava ponovi na poljubnih mestih obdelovanca. Po definiciji se vse koordinate nanašajo na novo ničelno točko. Zamik je naveden v programu ali vzet iz { -datum-table(case: "genitive") }, na primer za obdelave, ki se ponavljajo na več mestih, ali za pogosto potreben zamik.
step-shift-datum = Krmiljenje zamakne ničelno točko:
say-shift-by-table-row = pri navedeni številki vrstice: za vrednosti te vrstice aktivne { -datum-table(case: "genitive") }
say-shift-by-coordinates = pri navedenih koordinatah: na vsaki programirani osi na navedeno koordinato; absolutne vrednosti se nanašajo na ničelno točko obdelovanca, inkrementalne pa na nazadnje veljavno ničelno točko
note-reset-datum-shift = Zamik ničelne točke ponastavite tako, da z novo definicijo cikla programirate zamik na koordinate X = 0, Y = 0 itd. ali da zamik na koordinate X = 0, Y = 0 itd. prikličete iz { -datum-table(case: "genitive") }.
note-rotary-axes-may-be-shifted = Vnesete lahko tudi rotacijske osi.
note-datum-shift-in-status-display = Dodatni prikaz stanja kaže zamik ničelne točke na posamezni osi.
note-datum-table-refers-to-preset = Nevarnost kolizije! Ničelne točke iz { -datum-table(case: "genitive") } se vedno in izključno nanašajo na trenutno prednastavitev.
note-select-datum-table-in-program = Če so ničelne točke vzete iz { -datum-table(case: "genitive") }, želeno preglednico aktivirajte v programu s funkcijo SEL TABLE v stavku pred tem ciklom. Aktivna ostane, dokler s SEL TABLE ali s PGM MGT ne izberete druge { -datum-table(case: "genitive") }. SEL TABLE programirate s tipko PGM CALL in gumbom PREGLEDNICA NIČELNIH TOČK: vnesite celotno pot preglednice ali z gumbom IZBIRA izberite datoteko in potrdite s tipko END.
note-select-datum-table-before-run = Brez SEL TABLE je treba želeno { -datum-table(case: "accusative") } aktivirati z upraviteljem datotek pred programskim testom ali programskim tekom (to velja tudi za programirno grafiko): v načinu Programski test ima nato stanje S, v načinu Programski tek pa stanje M.
note-datum-table-is-absolute = Koordinate iz preglednic ničelnih točk delujejo samo kot absolutne vrednosti.
note-datum-table-rows-at-end = Nove vrstice je mogoče dodati samo na konec { -datum-table(case: "genitive") }.
note-datum-table-name-begins-with-letter = Ime datoteke nove { -datum-table(case: "genitive") } se mora začeti s črko.
note-save-datum-table-changes = Ko spremenite vrednost v { -datum-table(case: "locative") }, spremembo shranite s tipko ENT. Sicer je pri izvajanju programa krmiljenje ne upošteva.
note-edit-datum-table = Preglednico ničelnih točk urejate v načinu Shranjevanje/urejanje programa: s tipko PGM MGT prikličite upravljanje datotek, z gumbi prikažite datoteke vrste .D in izberite preglednico ali vnesite novo ime datoteke. Gumbi omogočajo skok na začetek ali konec preglednice, na naslednjo ali prejšnjo stran in na začetek ali konec vrstice, dodajanje ene ali več vrstic na konec, brisanje vrstice, iskanje ter kopiranje in vstavljanje vrednosti. Preglednico zapustite tako, da v upravljanju datotek prikažete drugo vrsto datotek in izberete želeno datoteko.
note-datum-table-columns = Če za aktivno os ne želite ničelne točke, njen vnos izbrišite s tipko DEL. Lastnosti stolpcev lahko urejate, ko v meniju MOD vnesete številko ključa 555343; gumb UREJANJE OBLIKE nato prikaže stolpce z njihovimi lastnostmi. Spremembe veljajo samo za odprto preglednico.
note-datum-row-in-status-display = Dodatni prikaz stanja kaže ime in pot aktivne { -datum-table(case: "genitive") }, številko aktivne ničelne točke in njeno opombo iz stolpca DOC.

# --- 10 ---
cycle-rotation = Rotacija
    .nc = ROTACIJA
    .purpose = Znotraj programa zavrti koordinatni sistem v { -working-plane(case: "locative") } okoli aktivne ničelne točke.
step-rotate-coordinate-system = Krmiljenje zavrti koordinatni sistem okoli aktivne ničelne točke za programirani kot. Inkrementalni kot se prišteje k aktivnemu.
step-cancel-radius-compensation = Krmiljenje prekliče aktivni popravek polmera.
step-move-both-axes = Premaknite obe osi { -working-plane(case: "genitive") }, da aktivirate rotacijo.
note-reset-rotation = Rotacijo ponastavite tako, da cikel znova programirate s kotom 0°.
note-reference-axis-of-rotation = Referenčna os kota: os X v ravnini X/Y, os Y v ravnini Y/Z, os Z v ravnini Z/X.
note-acts-in-manual-data-input = Cikel deluje tudi v načinu Pozicioniranje z ročnim vnosom.
note-rotation-in-status-display = Dodatni prikaz stanja kaže aktivni rotacijski kot.
note-program-radius-compensation-again = Definicija cikla prekliče aktivni popravek polmera. Po potrebi ga programirajte znova.

# --- 247 ---
cycle-activate-preset = Določitev referenčne točke
    .nc = DOLOČITEV REF. TOČKE
    .nc-aliases = DOLOČANJE REFERENČNE TOČKE
    .purpose = Aktivira prednastavitev iz { -preset-table(case: "genitive") } kot novo referenčno točko.
step-activate-preset = Krmiljenje aktivira prednastavitev { $q-preset-number } iz { -preset-table(case: "genitive") } kot referenčno točko.
step-cancel-transforms-of-preset = Ponastavi zamik ničelne točke, zrcaljenje, rotacijo, faktor merila in faktor merila, specifičen za os.
note-coordinates-refer-to-new-preset = Po definiciji se vse koordinate in zamiki ničelne točke (absolutni in inkrementalni) nanašajo na novo prednastavitev.
note-preset-cancels-transforms = Ko se aktivira referenčna točka iz { -preset-table(case: "genitive") }, krmiljenje ponastavi zamik ničelne točke, zrcaljenje, rotacijo, faktor merila in faktor merila, specifičen za os.
note-preset-zero = Prednastavitev s številko 0 (vrstica 0) aktivira referenčno točko, ki je bila nazadnje ročno določena v ročnem načinu.
note-preset-not-in-test-run = V načinu Programski test cikel ne deluje.
note-preset-in-status-display = V prikazu stanja je številka aktivne prednastavitve navedena desno od simbola referenčne točke, v dodatnem prikazu stanja (prikaz položaja) pa desno od referenčne točke.
