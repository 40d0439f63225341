# Cycles that determine and compensate a misaligned workpiece.

# --- run, shared ---
step-position-offset-at-first-touch-point = Krmiljenje pozicionira tipalni sistem v hitrem teku (vrednost iz stolpca { $mp-positioning-feed }) in s pozicionirno logiko na prvo tipalno točko. Pri tem tipalni sistem zamakne za varnostno razdaljo v smeri, nasprotni smeri premika.
step-position-offset-at-first-touch-point__tnc426-430 = Krmiljenje pozicionira tipalni sistem v hitrem teku (vrednost iz { $mp-positioning-feed } ali { $mp-analog-positioning-feed }) in s pozicionirno logiko na prvo tipalno točko. Pri tem tipalni sistem zamakne za varnostno razdaljo v smeri, nasprotni smeri premika.
step-travel-to-and-probe-second-point = Tipalni sistem se premakne na drugo tipalno točko in tam izvede drugo tipanje.
step-retract-and-carry-out-basic-rotation = Krmiljenje vrne tipalni sistem na varno višino { $q-clearance-height } in izvede ugotovljeno osnovno rotacijo.
note-basic-rotation-reset-at-start = Krmiljenje na začetku cikla ponastavi aktivno osnovno rotacijo.
note-known-reference-direction = S parametrom { $q-reference-line-angle } krmiljenje izmerjeno vrednost popravi za znani kot. Tako je mogoče osnovno rotacijo izmeriti na poljubni premici obdelovanca, nanaša pa se vseeno na dejansko smer 0°.

# --- 400 ---
cycle-basic-rotation = Osnovna rotacija
    .nc = OSNOVNO VRTENJE
    .nc-aliases = OSNOVNA ROTACIJA
    .purpose = Z merjenjem dveh točk, ki morata ležati na isti premici obdelovanca, določi poševni položaj obdelovanca. Krmiljenje ga izravna z osnovno rotacijo.
step-store-basic-rotation = Krmiljenje shrani osnovno rotacijo:
say-rotation-into-preset-row = če { $q-basic-rotation-row } ni 0, v vrstico { $q-basic-rotation-row } preglednice prednastavitev
say-rotation-into-rot-menu = pri { $q-basic-rotation-row } = 0 v meni ROT ročnega načina

# --- 401 and 402 ---
cycle-rotation-two-holes = Osnovna rotacija z dvema vrtinama
    .nc = ROT 2 VRTIN
    .purpose = Izmeri središči dveh vrtin in izračuna kot med glavno osjo obdelovalne ravnine in premico, ki središči povezuje. Ta kot krmiljenje izravna z osnovno rotacijo ali z vrtenjem okrogle mize.
cycle-rotation-two-holes__tnc426-430 =
    .purpose = Izmeri središči dveh vrtin in izračuna kot med glavno osjo obdelovalne ravnine in premico, ki središči povezuje. Ta kot krmiljenje izravna z osnovno rotacijo.
cycle-rotation-two-studs = Osnovna rotacija z dvema čepoma
    .nc = ROT 2 ČEPOV
    .purpose = Izmeri središči dveh čepov in izračuna kot med glavno osjo obdelovalne ravnine in premico, ki središči povezuje. Ta kot krmiljenje izravna z osnovno rotacijo ali z vrtenjem okrogle mize.
cycle-rotation-two-studs__tnc426-430 =
    .purpose = Izmeri središči dveh čepov in izračuna kot med glavno osjo obdelovalne ravnine in premico, ki središči povezuje. Ta kot krmiljenje izravna z osnovno rotacijo.
step-position-at-first-hole = Krmiljenje pozicionira tipalni sistem v hitrem teku (vrednost iz stolpca { $mp-positioning-feed }) in s pozicionirno logiko na programirano središče prve vrtine.
step-position-at-first-hole__tnc426-430 = Krmiljenje pozicionira tipalni sistem v hitrem teku (vrednost iz { $mp-positioning-feed } ali { $mp-analog-positioning-feed }) in s pozicionirno logiko na programirano središče prve vrtine.
step-measure-first-hole = Tipalni sistem se premakne na merilno višino { $q-measuring-height } in s štirimi tipanji določi središče prve vrtine.
step-position-at-second-hole = Tipalni sistem se vrne na varno višino { $q-clearance-height } in se pozicionira na programirano središče druge vrtine.
step-measure-second-hole = Tipalni sistem se premakne na merilno višino { $q-measuring-height } in s štirimi tipanji določi središče druge vrtine.
step-position-at-first-stud = Krmiljenje pozicionira tipalni sistem v hitrem teku (vrednost iz stolpca { $mp-positioning-feed }) in s pozicionirno logiko na prvo tipalno točko prvega čepa.
step-position-at-first-stud__tnc426-430 = Krmiljenje pozicionira tipalni sistem v hitrem teku (vrednost iz { $mp-positioning-feed } ali { $mp-analog-positioning-feed }) in s pozicionirno logiko na prvo tipalno točko prvega čepa.
step-measure-first-stud = Tipalni sistem se premakne na merilno višino { $q-measuring-height } in s štirimi tipanji določi središče prvega čepa. Med tipalnimi točkami, ki so med seboj zamaknjene za 90°, se premika po krožnem loku: pri { $q-traverse-to-clearance-height } = 0 na merilni višini, pri { $q-traverse-to-clearance-height } = 1 na varni višini.
step-measure-first-stud__tnc426-430 = Tipalni sistem se premakne na merilno višino { $q-measuring-height } in s štirimi tipanji določi središče prvega čepa. Med tipalnimi točkami se pri { $q-traverse-to-clearance-height } = 0 premika na merilni višini, pri { $q-traverse-to-clearance-height } = 1 pa na varni višini.
step-position-at-second-stud = Tipalni sistem se vrne na varno višino { $q-clearance-height } in se pozicionira na prvo tipalno točko drugega čepa.
step-measure-second-stud = Tipalni sistem se premakne na merilno višino { $q-second-measuring-height } in s štirimi tipanji določi središče drugega čepa.
step-compensate-as-chosen = Krmiljenje izravna poševni položaj, kot določa { $q-misalignment-compensation }:
say-rotation-into-preset-row-if-chosen = če je { $q-misalignment-compensation } = 0 in { $q-basic-rotation-row } ni 0, osnovno rotacijo shrani v vrstico { $q-basic-rotation-row } preglednice prednastavitev
say-rotation-into-rot-menu-if-chosen = pri { $q-misalignment-compensation } = 0 in { $q-basic-rotation-row } = 0 osnovno rotacijo shrani v meni ROT ročnega načina
say-turn-rotary-table = pri { $q-misalignment-compensation } = 1 namesto shranjevanja osnovne rotacije zavrti okroglo mizo; pri { $q-zero-after-alignment } = 1 nato prikaz rotacijske osi nastavi na 0
note-rotary-axis-by-tool-axis = Za izravnavo poševnega položaja z vrtenjem okrogle mize krmiljenje samodejno uporabi te rotacijske osi: C pri orodni osi Z, B pri orodni osi Y, A pri orodni osi X.
note-no-tilting-with-this-cycle = Ta cikel pri zavrteni obdelovalni ravnini ni dovoljen.
title-rotation-from-two-holes = Določitev osnovne rotacije z dvema vrtinama

# --- 403 ---
cycle-rotation-by-rotary-axis = Izravnava osnovne rotacije z rotacijsko osjo
    .nc = ROT Z ROTACIJSKO OSJO
    .purpose = Z merjenjem dveh točk, ki morata ležati na isti premici obdelovanca, določi poševni položaj obdelovanca. Krmiljenje ga izravna z vrtenjem osi A, B ali C. Obdelovanec je lahko na okrogli mizi vpet kjer koli.
step-retract-and-turn-rotary-axis = Krmiljenje vrne tipalni sistem na varno višino { $q-clearance-height } in zavrti rotacijsko os { $q-compensation-axis } za izračunano vrednost. Kot shrani tudi v parameter rezultata. Na zahtevo po izravnavi nastavi prikaz na 0.
step-retract-and-turn-rotary-axis__tnc426-430 = Krmiljenje vrne tipalni sistem na varno višino { $q-clearance-height } in zavrti rotacijsko os { $q-compensation-axis } za izračunano vrednost.
note-compensation-may-be-turned-180 = Nevarnost kolizije! Krmiljenje le okvirno preveri, ali so tipalne točke in izravnalna os skupaj smiselne. Izravnalni premiki so zato lahko zasukani za 180°.
note-compensation-axis-combinations = Dovoljene kombinacije merilne osi { $q-measuring-axis } in izravnalne osi { $q-compensation-axis }. Os tipalnega sistema Z: 1{"\u00A0"}s 6, 2{"\u00A0"}s 6, 3{"\u00A0"}s 5 ali 4. Os tipalnega sistema Y: 1{"\u00A0"}s 5, 2{"\u00A0"}s 5, 3{"\u00A0"}s 6 ali 4. Os tipalnega sistema X: 1{"\u00A0"}s 4, 2{"\u00A0"}s 4, 3{"\u00A0"}s 5 ali 6.
note-only-without-tilting = Ta cikel uporabljajte samo, kadar funkcija za vrtenje obdelovalne ravnine ni aktivna.

# --- 404 ---
cycle-set-basic-rotation = Določitev osnovne rotacije
    .nc = OSNOVNA ROTACIJA
    .nc-aliases = NASTAVITEV OSNOVNE ROTACIJE
    .purpose = Med programskim tekom samodejno določi poljubno osnovno rotacijo. Namenjen je predvsem ponastavitvi prej izvedene osnovne rotacije.
step-set-basic-rotation = Krmiljenje nastavi osnovno rotacijo na kot { $q-basic-rotation-angle }.
note-available-from-nc-software = Na voljo od NC-programske opreme 280 474-xx.

# --- 405 ---
cycle-rotation-by-c-axis = Kompenziranje poševnega položaja obdelovanca z osjo C
    .nc = ROT S C-OSJO
    .purpose = Določi kotni zamik med pozitivno osjo Y aktivnega koordinatnega sistema in srednjico vrtine ali med želenim in dejanskim položajem središča vrtine. Krmiljenje ga izravna z vrtenjem osi C. Obdelovanec je lahko na okrogli mizi vpet kjer koli.
say-travel-on-circle-at-clearance-height__rotation-by-c-axis = pri { $q-traverse-to-clearance-height } = 1 po krožnem loku na varni višini { $q-clearance-height }
step-move-to-measured-centre = Krmiljenje pozicionira tipalni sistem v izmerjeno središče vrtine.
step-retract-and-turn-to-y-axis = Krmiljenje vrne tipalni sistem na varno višino { $q-clearance-height } in z vrtenjem okrogle mize izravna obdelovanec: po izravnavi je pri navpični in pri vodoravni osi tipalnega sistema središče vrtine v smeri pozitivne osi Y ({ $q-probing-centre-minor } = 0) ali na želenem položaju. Izmerjeni kotni zamik se shrani tudi v parameter rezultata.
step-store-angular-offset = Krmiljenje kotni zamik obravnava glede na { $q-zero-or-row-after-alignment }:
say-zero-display-of-c-axis = pri { $q-zero-or-row-after-alignment } = 0 nastavi prikaz osi C na 0
say-offset-into-column-c = če je { $q-zero-or-row-after-alignment } večji od 0, kotni zamik s predznakom zapiše v stolpec C vrstice { $q-zero-or-row-after-alignment } preglednice ničelnih točk; prišteje se zamiku osi C, ki ga vrstica že vsebuje
note-smallest-stepping-angle__rotation-by-c-axis = Čim manjši je kotni korak { $q-probing-stepping-angle }, tem manj natančno krmiljenje izračuna središče kroga. Najmanjši vnos: 5°.
note-hole-with-positive-y = Koordinata Y vrtine mora biti pozitivna.
note-repeat-with-horizontal-probe = Če se kotni zamik vrtine meri z osjo tipalnega sistema Y (vodoravna vrtina), bo cikel morda treba izvesti večkrat: način merjenja povzroči nenatančnost približno 1{"\u00A0"}% poševnega položaja.

# --- results ---
result-alignment-angle-determined = Ugotovljeni kot
result-angular-offset-measured = Izmerjeni kotni zamik
