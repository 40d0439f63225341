# Drilling cycles.

# --- 200 ---
cycle-drilling = Vrtanje
    .nc = VRTANJE
    .purpose = Izdela vrtino v enem ali več primikih. Med primiki se orodje v hitrem teku umakne iz vrtine.
step-drill-to-plunging-depth = Orodje vrta s pomikom { $q-plunging-feed } do { -plunging-depth(case: "genitive") }, ki je pri vsakem primiku za { $q-plunging-depth } večja.
step-retract-and-return-to-set-up-clearance = Krmiljenje v hitrem teku (FMAX) dvigne orodje na { -set-up-clearance(case: "accusative") }, kjer orodje miruje za čas { $q-dwell-at-top }, če je ta vnesen, nato pa ga v hitrem teku (FMAX) vrne na { -set-up-clearance(case: "accusative") } nad doseženo globino.
step-dwell-at-hole-bottom = Orodje se na dnu vrtine zadrži za čas { $q-dwell-at-bottom }, če je vnesen.
step-rapid-out-of-hole = Orodje se z dna vrtine umakne v hitrem teku (FMAX):
say-rapid-to-second-set-up-clearance = na { -second-set-up-clearance(case: "accusative") } { $q-second-set-up-clearance }, če je vnesena
say-rapid-back-to-set-up-clearance = sicer na { -set-up-clearance(case: "accusative") } { $q-set-up-clearance }
note-position-over-hole-centre = Programirajte pozicionirni stavek na začetno točko (središče vrtine) v { -working-plane(case: "locative") } s popravkom polmera R0.
note-point-table-hole-centres = Če cikel prikličete s preglednico točk, so točke { -working-plane(case: "genitive") } središča vrtin. Če želite, da koordinata osi vretena iz preglednice velja kot koordinata začetne točke, za koordinato { -surface(case: "genitive") } { $q-surface-coordinate } vnesite 0.

# --- 205 ---
cycle-universal-pecking = Univerzalno globinsko vrtanje
    .nc = UNIVERZALNO GLOBINSKO VRTANJE
    .purpose = Izdela globoke vrtine s primiki, ki se lahko zmanjšujejo, z lomom ostružkov, z razdaljo zadrževanja pri vračanju v vrtino in z začetno točko pod { -surface(case: "instrumental") } za predhodno navrtane vrtine.
step-feed-to-deepened-starting-point = Če je vnesena globlja začetna točka { $q-deepened-starting-point }, se orodje s predpozicionirnim pomikom { $q-pre-positioning-feed } premakne na { -set-up-clearance(case: "accusative") } nad globljo začetno točko.
step-drill-on-to-plunging-depth = Orodje vrta s pomikom { $q-plunging-feed } proti { -plunging-depth(case: "dative") } { $q-plunging-depth }; pri lomu ostružkov se ustavi vsakič, ko je za { $q-depth-for-chip-breaking } globlje. Če je vnesena vrednost pojemanja { $q-decrement }, se { -plunging-depth(case: "nominative") } z vsakim primikom zmanjša zanjo.
step-break-chip = Za lom ostružkov se orodje umakne za { $q-chip-breaking-retraction } s hitrostjo 3000{"\u00A0"}mm/min.
until-plunging-depth-reached = ni dosežena { -plunging-depth(case: "nominative") }
step-retract-and-return-to-advanced-stop = Krmiljenje umakne orodje v hitrem teku (FMAX) na { -set-up-clearance(case: "accusative") } in ga v hitrem teku (FMAX) vrne na razdaljo zadrževanja nad doseženo globino: pri prvem primiku { $q-upper-advanced-stop-distance }, pri zadnjem { $q-lower-advanced-stop-distance }.
step-dwell-to-cut-free = Za prosto rezanje se orodje na dnu vrtine zadrži za čas { $q-dwell-at-bottom }, če je vnesen.
step-feed-back-to-set-up-clearance = Orodje se s pomikom { $q-plunging-feed } umakne na { -set-up-clearance(case: "accusative") } { $q-set-up-clearance }.
step-rapid-on-to-second-set-up-clearance = Če je vnesena { -second-set-up-clearance(case: "nominative") } { $q-second-set-up-clearance }, se orodje v hitrem teku (FMAX) premakne nanjo.
condition-infeeds-decrease = je vnesena vrednost pojemanja { $q-decrement }
condition-starting-point-deepened = globlja začetna točka { $q-deepened-starting-point } ni 0
guard-starting-point-below-depth = Globlja začetna točka leži na globini vrtine ali pod njo: za vrtanje ne ostane nič.
note-advanced-stop-changes-evenly = Če sta { $q-upper-advanced-stop-distance } in { $q-lower-advanced-stop-distance } različna, krmiljenje razdaljo zadrževanja med prvim in zadnjim primikom enakomerno spreminja.
note-deepened-start-changes-infeed-only = Globlja začetna točka { $q-deepened-starting-point } spremeni samo začetno točko primika. Umiki se še naprej nanašajo na koordinato { -surface(case: "genitive") }.
