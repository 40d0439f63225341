# Drilling cycles: reaming, boring, universal drilling, back boring, bore milling, centring, single-lip drilling.

# --- shared sentences ---
step-retract-at-retraction-feed = Orodje se z vzvratnim pomikom { $q-retraction-feed } umakne na varnostno razdaljo { $q-set-up-clearance }.

# --- 201 ---
cycle-reaming = Povrtavanje
    .nc = POVRTAVANJE
    .purpose = Povrta vrtino z enim primikom. Vrtino zapusti s posebej določenim pomikom.
step-ream-to-depth = Orodje s pomikom { $q-plunging-feed } povrtava do programirane globine { $q-depth }.

# --- 203 ---
cycle-universal-drilling = Univerzalno vrtanje
    .nc = UNIVERZALNO VRTANJE
    .purpose = Izdela vrtino s primiki, ki se lahko zmanjšujejo. Ostružek je mogoče večkrat odlomiti, preden se orodje umakne iz vrtine.
step-drill-to-decreasing-plunging-depth = Orodje s pomikom { $q-plunging-feed } vrta do naslednje globine primika. Če je vnesena vrednost pojemanja { $q-decrement }, se globina primika { $q-plunging-depth } z vsakim primikom zmanjša zanjo.
step-break-chip-or-retract = Med dvema primikoma se orodje premakne nazaj:
say-break-chip-by-retraction = pri lomu ostružkov za odmik { $q-chip-breaking-retraction }, in sicer pred umikom iz vrtine tolikokrat, kot določa { $q-chip-breaks-before-retraction }
say-retract-and-return-at-rapid = brez loma ostružkov s pomikom { $q-retraction-feed } na varnostno razdaljo, kjer miruje za čas { $q-dwell-at-top }, če je ta vnesen; od tam v hitrem teku (FMAX) na varnostno razdaljo nad doseženo globino

# --- 240 ---
cycle-centring = Centriranje
    .nc = CENTRIRANJE
    .purpose = Centrira vrtino do globine ali do premera.
step-centre-to-depth-or-diameter = Orodje centrira s pomikom { $q-plunging-feed }:
say-centre-to-diameter = { $q-depth-or-diameter } = 1: do premera centriranja { $q-centring-diameter }
say-centre-to-depth = { $q-depth-or-diameter } = 0: do globine centriranja { $q-depth }
step-dwell-at-centring-bottom = Orodje se na dnu centrirne vrtine zadrži za čas { $q-dwell-at-bottom }, če je vnesen.
condition-centring-to-depth = je { $q-depth-or-diameter } = 0
condition-centring-to-diameter = je { $q-depth-or-diameter } = 1
guard-point-angle-missing = Za centriranje do premera v preglednici orodij definirajte kot konice { $mp-drill-point-angle } orodja.
guard-depth-zero__centring = Izbrana globina ali izbrani premer je 0, zato krmiljenje cikla ne izvede.
guard-depth-positive__centring = Izbrana globina ali izbrani premer ima pozitivno vrednost. Vnesite negativno vrednost ali dovolite pozitivno s strojnim parametrom { $mp-display-depth-err }.
note-sign-of-depth-or-diameter = Smer obdelave določa predznak premera { $q-centring-diameter } ali globine { $q-depth }, odvisno od tega, kaj je izbrano. Pri premeru ali globini 0 krmiljenje cikla ne izvede.
note-positive-diameter-or-depth-reverses = Nevarnost kolizije! Pri pozitivnem premeru ali pozitivni globini krmiljenje predpoložaj izračuna v nasprotni smeri: orodje se po orodni osi v hitrem teku premakne na varnostno razdaljo pod površino obdelovanca.

# --- 202 ---
cycle-boring = Izstruževanje
    .nc = IZSTRUŽEVANJE
    .purpose = Izstruži vrtino. Na dnu krmiljenje orientira vreteno; orodje se lahko pred umikom odmakne od stene.
step-bore-to-depth = Orodje s pomikom { $q-plunging-feed } izstružuje do globine { $q-depth }.
step-dwell-with-spindle-turning = Za prosto rezanje se orodje na dnu vrtine pri vrtečem se vretenu zadrži za čas { $q-dwell-at-bottom }, če je vnesen.
step-orient-spindle-to-angle = Krmiljenje orientira vreteno na položaj, definiran v parametru { $q-spindle-orientation-angle }.
step-disengage-from-wall = Če je izbran prosti premik, se orodje premakne za 0,2{"\u00A0"}mm (stalna vrednost) v smeri { $q-disengaging-direction }.
step-retract-bored-tool = Orodje se s pomikom { $q-retraction-feed } umakne na varnostno razdaljo { $q-set-up-clearance }. Če je { $q-disengaging-direction } = 0, se umakne ob steni vrtine.
step-restore-spindle-and-coolant = Krmiljenje obnovi stanje vretena in hladila, ki je bilo aktivno pred priklicem cikla.
note-machine-and-control-prepared = Proizvajalec stroja mora stroj in krmiljenje pripraviti za ta cikel.
note-servo-controlled-spindle-only = Cikel je mogoče uporabljati samo na strojih s krmiljenim vretenom.
note-spindle-and-coolant-restored = Na koncu cikla znova velja stanje hladila in vretena izpred priklica cikla.
note-disengage-away-from-edge = Nevarnost kolizije! Smer prostega premika { $q-disengaging-direction } izberite tako, da se orodje odmakne od roba vrtine.
note-check-position-of-tool-tip = Nevarnost kolizije! Vreteno orientirajte na kot, programiran v parametru { $q-spindle-orientation-angle } (na primer v načinu Pozicioniranje z ročnim vnosom), in preverite, kje je konica orodja. Kot izberite tako, da je konica orodja vzporedna s koordinatno osjo.
note-disengaging-considers-rotation = Pri prostem premiku krmiljenje aktivno rotacijo koordinatnega sistema upošteva samodejno.

# --- 204 ---
cycle-back-boring = Vzvratno grezenje
    .nc = VZVRATNO GREZENJE
    .nc-aliases = VZRATNO GREZENJE
    .purpose = Izdela ugreznine na spodnji strani obdelovanca.
step-orient-and-offset-tool = Krmiljenje orientira vreteno na { $q-spindle-orientation-angle } in zamakne orodje za dimenzijo izsrednika { $q-off-centre-distance } v smeri { $q-disengaging-direction }.
step-feed-through-bore = Orodje se s predpozicionirnim pomikom { $q-in-and-out-feed } spusti v obstoječo vrtino, dokler ni rezilo na varnostni razdalji { $q-set-up-clearance } pod spodnjim robom obdelovanca.
step-centre-tool-and-counterbore = Krmiljenje vrne orodje na sredino vrtine, vklopi vreteno in po potrebi hladilo ter orodje nato s pomikom { $q-countersinking-feed } premakne na globino { $q-counterbore-depth }.
step-dwell-and-leave-counterbore = Če je vnesen čas { $q-counterbore-dwell }, se orodje toliko časa zadrži na dnu ugreznine. Nato ugreznino zapusti; krmiljenje orientira vreteno in znova zamakne orodje za dimenzijo izsrednika.
step-feed-out-of-bore = Orodje se s predpozicionirnim pomikom { $q-in-and-out-feed } premakne na varnostno razdaljo { $q-set-up-clearance } nad površino obdelovanca.
note-back-boring-bars-only = Cikel deluje samo z vrtalnimi drogovi za vzvratno grezenje.
note-sign-of-counterbore-depth = Predznak globine { $q-counterbore-depth } določa smer obdelave. Pozor: pri pozitivnem predznaku poteka grezenje v pozitivni smeri osi vretena.
note-length-to-lower-edge-of-bar = Dolžino orodja vnesite tako, da je izmerjen spodnji rob vrtalnega droga in ne rezilo.
note-edge-height-and-thickness-considered = Pri izračunu začetne točke grezenja krmiljenje upošteva rezalno višino { $q-cutting-edge-height } vrtalnega droga in debelino materiala { $q-material-thickness }.

# --- 208 ---
cycle-bore-milling = Vrtalno rezkanje
    .nc = VRTALNO REZKANJE
    .purpose = Rezka vrtino po vijačnici. Če je vrtina enako široka kot orodje, jo neposredno izvrta.
step-rapid-and-approach-hole-circumference = Krmiljenje premakne orodje po osi vretena v hitrem teku (FMAX) na varnostno razdaljo { $q-set-up-clearance } nad površino obdelovanca in nato, če je dovolj prostora, po loku na obod vrtine { $q-nominal-diameter }.
step-drill-directly-if-diameters-equal = Če je premer { $q-nominal-diameter } enak premeru orodja, orodje brez vijačnice vrta neposredno do globine { $q-depth }.
step-mill-on-helix = Orodje rezka s pomikom { $q-plunging-feed } po vijačnici, ki se z vsakim obratom spusti za { $q-infeed-per-helix }.
step-mill-full-circle-at-depth = Na globini se orodje še enkrat premakne po polnem krogu, da odstrani material, ki je ostal pri spuščanju.
step-return-to-centre-of-hole = Krmiljenje vrne orodje na sredino vrtine.
step-rapid-back-to-clearance = Orodje se v hitrem teku (FMAX) vrne na varnostno razdaljo { $q-set-up-clearance }.
guard-tool-wider-than-hole = Premer vrtine je manjši od premera orodja.
guard-hole-too-wide-for-tool = Premer vrtine je več kot dvakrat večji od premera orodja. Vnesite premer predhodno izvrtane vrtine ali uporabite večje orodje.
note-equal-diameters-are-drilled = Če je vneseni premer vrtine enak premeru orodja, krmiljenje brez vijačne interpolacije vrta neposredno do vnesene globine.
note-mirroring-keeps-milling-type = Aktivno zrcaljenje ne spremeni vrste rezkanja, definirane v ciklu.
note-infeed-too-large-does-damage = Prevelik primik poškoduje tako orodje kot obdelovanec.
note-plunging-angle-limits-infeed = Da preprečite prevelike primike, v stolpec { $mp-plunging-angle } preglednice orodij vnesite največji možni kot spuščanja orodja. Krmiljenje tedaj največji dovoljeni primik izračuna samodejno in po potrebi spremeni vneseno vrednost.

# --- 241 ---
cycle-single-lip-drilling = Enoutorno vrtanje
    .nc = ENOUTORNO VRTANJE
    .purpose = Vrta z enoutornim globinskim svedrom, tudi z začetno točko pod površino obdelovanca; za uvlek in izvlek se posebej določita število vrtljajev in smer vrtenja, hladilo pa vklopita in izklopita M-funkciji.
step-feed-in-and-switch-on = Krmiljenje premakne orodje s predpozicionirnim pomikom { $q-pre-positioning-feed } na varnostno razdaljo nad globljo začetno točko { $q-deepened-starting-point } in tam z M3 vklopi vrtenje s številom vrtljajev za vrtanje { $q-drilling-speed }, s funkcijo { $q-coolant-on-function } pa hladilo. Pri uvleku se vreteno vrti v smeri urnega kazalca ali v nasprotni smeri s številom vrtljajev { $q-speed-in-and-out } ali pa miruje, kot določa { $q-rotation-in-and-out }.
step-drill-in-one-infeed = Orodje s pomikom { $q-plunging-feed } vrta do globine { $q-depth }.
step-switch-off-coolant-and-reset-speed = Krmiljenje s funkcijo { $q-coolant-off-function } izklopi hladilo in število vrtljajev ponastavi na vrednost { $q-speed-in-and-out } za izvlek.
