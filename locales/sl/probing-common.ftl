# What several touch-probe cycles share.

# --- run ---
step-position-at-first-touch-point = Krmiljenje pozicionira { -probe(case: "accusative") } v hitrem teku (vrednost iz stolpca { $mp-positioning-feed }) in s pozicionirno logiko na prvo { -touch-point(case: "accusative") }. Tipalne točke izračuna iz vnosov v ciklu in iz varnostne razdalje v stolpcu { $mp-set-up }.
step-position-at-first-touch-point__tnc426-430 = Krmiljenje pozicionira { -probe(case: "accusative") } v hitrem teku (vrednost iz { $mp-positioning-feed } ali { $mp-analog-positioning-feed }) in s pozicionirno logiko na prvo { -touch-point(case: "accusative") }. Tipalne točke izračuna iz vnosov v ciklu in iz varnostne razdalje { $mp-set-up }.
step-move-to-measuring-height = Tipalni sistem se premakne na { -measuring-height(case: "accusative") } { $q-measuring-height }.
step-probe-outward = Tipalni sistem izvede tipanje s pomikom pri tipanju (stolpec { $mp-probing-feed }). Smer tipanja krmiljenje določi iz začetnega kota { $q-probing-starting-angle } in kotnega koraka { $q-probing-stepping-angle }.
step-probe-outward__tnc426-430 = Tipalni sistem izvede tipanje s pomikom pri tipanju ({ $mp-probing-feed } ali { $mp-analog-probing-feed }). Smer tipanja krmiljenje določi iz začetnega kota { $q-probing-starting-angle } in kotnega koraka { $q-probing-stepping-angle }.
step-travel-to-next-touch-point = Tipalni sistem se premakne na naslednjo { -touch-point(case: "accusative") }:
say-start-again-from-centre = iz središča in brez premika na { -clearance-height(case: "accusative") }, če je žep ob upoštevanju varnostne razdalje premajhen za predpozicioniranje blizu tipalnih točk
say-travel-straight-at-clearance-height = pri { $q-traverse-to-clearance-height } = 1 in { $q-probing-traverse-type } = 0 premočrtno na { -clearance-height(case: "locative") } { $q-clearance-height }
say-travel-on-circle-at-clearance-height = pri { $q-traverse-to-clearance-height } = 1 po krožnem loku na { -clearance-height(case: "locative") } { $q-clearance-height }
say-travel-on-circle-at-clearance-height__tnc640 = pri { $q-traverse-to-clearance-height } = 1 in { $q-probing-traverse-type } = 1 po krožnem loku na { -clearance-height(case: "locative") } { $q-clearance-height }
say-travel-on-circle-at-measuring-height = pri { $q-traverse-to-clearance-height } = 0 po krožnem loku na { -measuring-height(case: "locative") } { $q-measuring-height }
until-all-touch-points-probed = niso otipane vse tipalne točke

# --- conditions ---
condition-travel-at-clearance-height = se { -probe(case: "nominative") } premika na { -clearance-height(case: "locative") } ({ $q-traverse-to-clearance-height } = 1)
condition-probe-axis-wanted = je { $q-probing-in-probe-axis } = 1

# --- guards ---
guard-probe-axis-undefined = Pred definicijo cikla ni priklica orodja, zato { -probe-axis(case: "nominative") } ni določena.
guard-transformation-active = Aktivno je zrcaljenje, faktor merila ali faktor merila, specifičen za os. Med ciklom tipalnega sistema ne sme biti aktivno nič od tega.
guard-basic-rotation-active = Aktivna je osnovna rotacija. Tega cikla pri osnovni rotaciji ni dovoljeno izvajati.
guard-stepping-angle-too-small = Kotni korak { $q-probing-stepping-angle } je manjši od 5°.
guard-tolerance-exceeded = Toleranca je prekoračena.
guard-tool-broken = Odstopanje je večje od tolerance loma orodja. Orodje je blokirano.

# --- notes: probing in general ---
note-positioning-logic = Pozicionirna logika: če je najnižja točka tipalne glave pod { -clearance-height(case: "instrumental") } { $q-clearance-height }, krmiljenje { -probe(case: "accusative") } najprej po { -probe-axis(case: "locative") } umakne na { -clearance-height(case: "accusative") } in ga nato v { -working-plane(case: "locative") } pozicionira na prvo { -touch-point(case: "accusative") }. Če je nad { -clearance-height(case: "instrumental") }, krmiljenje { -probe(case: "accusative") } najprej v { -working-plane(case: "locative") } pozicionira na prvo { -touch-point(case: "accusative") } in ga nato po { -probe-axis(case: "locative") } premakne neposredno na { -measuring-height(case: "accusative") } { $q-measuring-height }.
note-tool-call-before-definition = Pred definicijo cikla programirajte priklic orodja, ki določa { -probe-axis(case: "accusative") }.
note-no-mirror-or-scaling-while-probing = Med izvajanjem ciklov tipalnega sistema ne smejo biti aktivni zrcaljenje (cikel 8), faktor merila (cikel 11) in faktor merila, specifičen za os (cikel 26).
note-transformations-while-probing = Med izvajanjem ciklov tipalnega sistema ne sme biti aktiven noben cikel za preračunavanje koordinat: ničelna točka (7), zrcaljenje (8), rotacija (10), faktor merila (11 in 26), obdelovalna ravnina (19).
note-heidenhain-probes-only = Delovanje ciklov tipalnega sistema je zagotovljeno samo s tipalnimi sistemi HEIDENHAIN.
note-prepare-for-3d-probes = Proizvajalec stroja mora krmiljenje pripraviti za 3D-tipalne sisteme. Upoštevajte priročnik za stroj.
note-compensation-data-for-probing = Pazite, da so podatki za popravek (dolžina, polmer) ob začetku cikla pravi: podatki umerjanja ali podatki zadnjega stavka TOOL CALL. Izbere jih { $mp-calibration-data-source }.
note-no-contact-within-distance = Če se tipalna glava na razdalji { $mp-probing-distance } ne odkloni, krmiljenje prikaže sporočilo o napaki.
note-set-up-is-pre-position = { $mp-set-up } je razdalja do tipalne točke, na kateri krmiljenje predpozicionira { -probe(case: "accusative") }. Čim manjša je, tem natančneje je treba definirati tipalne točke.
note-track-orients-probe = Pri nastavitvi { $mp-track } = ON krmiljenje pred vsakim tipanjem zasuka infrardeči { -probe(case: "accusative") } v programirano smer, tako da se tipalna glava vedno odkloni v isto smer; to poveča natančnost merjenja. Po spremembi nastavitve { $mp-track } { -probe(case: "accusative") } znova umerite.
note-pre-positioning-speed = { $mp-pre-positioning } določa hitrost predpozicioniranja: FMAX_PROBE je pomik iz stolpca { $mp-positioning-feed }, FMAX_MACHINE pa hitri tek stroja.
note-multiple-measurement = Za večjo zanesljivost meritev lahko krmiljenje vsako tipanje izvede do trikrat zaporedoma; število meritev in tolerančno območje določajo strojni parametri pod { $mp-probe-settings } (delovanje tipalnega sistema, samodejno delovanje). Če se izmerjene vrednosti med seboj razlikujejo za več kot tolerančno območje, krmiljenje prikaže sporočilo o napaki, sicer shrani njihovo srednjo vrednost. Tako je mogoče odkriti na primer merilne napake zaradi umazanije.
note-multiple-measurement__tnc426-430 = Za večjo zanesljivost meritev lahko krmiljenje vsako tipanje izvede do trikrat zaporedoma; število meritev določa { $mp-multiple-measurement }, tolerančno območje pa { $mp-confidence-range }. Če se izmerjene vrednosti med seboj razlikujejo za več kot tolerančno območje, krmiljenje prikaže sporočilo o napaki, sicer shrani njihovo srednjo vrednost. Tako je mogoče odkriti na primer merilne napake zaradi umazanije.
note-step-below-90-for-arcs = Če želite namesto polnega kroga izmeriti krožni lok, programirajte kotni korak { $q-probing-stepping-angle }, manjši od 90°.
note-smallest-stepping-angle = Čim manjši je kotni korak { $q-probing-stepping-angle }, tem manj natančno krmiljenje izračuna referenčno točko. Najmanjši vnos: 5°.
note-smallest-stepping-angle__measure-hole = Čim manjši je kotni korak { $q-probing-stepping-angle }, tem manj natančno krmiljenje izračuna dimenzije vrtine. Najmanjši vnos: 5°.
note-small-stepping-angle-less-exact = Čim manjši je kotni korak { $q-probing-stepping-angle }, tem manj natančno krmiljenje izračuna središče.
note-small-stepping-angle-less-exact__datum-inside-circle = Čim manjši je kotni korak { $q-probing-stepping-angle }, tem manj natančno krmiljenje izračuna referenčno točko.
note-results-in-active-system = Vse rezultate v parametrih rezultatov in v datoteki s protokolom krmiljenje navaja v aktivnem koordinatnem sistemu, ki je lahko zamaknjen, zasukan ali nagnjen.
note-results-in-active-system__tnc320 = Vse rezultate v parametrih rezultatov in v datoteki s protokolom krmiljenje navaja v aktivnem koordinatnem sistemu, ki je lahko zamaknjen in/ali zasukan.
note-results-in-active-system__tnc426-430 = Vse rezultate v parametrih rezultatov in v datoteki s protokolom krmiljenje navaja v aktivnem koordinatnem sistemu, ki je lahko zamaknjen.
note-results-in-q-parameters = Krmiljenje rezultate meritev shrani v globalno aktivne Q-parametre od Q150 do Q160, ki jih je mogoče uporabiti v nadaljevanju programa.
note-deviations-in-q-parameters = Krmiljenje rezultate meritev shrani v globalno aktivne Q-parametre od Q150 do Q160, odstopanja od želenih vrednosti pa v parametre od Q161 do Q166. Med definiranjem cikla pomožna slika kaže tudi parametre rezultatov; osvetljeni parameter rezultata pripada izbranemu parametru za vnos.
note-deviations-in-q-parameters__tnc426-430 = Krmiljenje rezultate meritev shrani v globalno aktivne Q-parametre od Q150 do Q160, odstopanja od želenih vrednosti pa v parametre od Q161 do Q166. Med definiranjem cikla pomožna slika kaže tudi parametre rezultatov.

# --- results ---
result-centre-main-actual = Dejanska vrednost središča na glavni osi
result-centre-minor-actual = Dejanska vrednost središča na pomožni osi
result-diameter-actual = Dejanski premer
