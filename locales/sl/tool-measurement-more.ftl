# Cycles that measure the tool: radius, complete tool, calibration of the tool touch probe.

# --- parameters ---
help-tool-check-radius = Določa, ali se orodje izmeri prvič ali pa se preveri že izmerjeno orodje. Prvo merjenje prepiše polmer orodja { $mp-tool-radius } v preglednici orodij TOOL.T in nastavi vrednost delta { $mp-delta-radius } na 0. Preverjanje izmerjeni polmer primerja s polmerom orodja { $mp-tool-radius }; odstopanje se s predznakom vnese kot vrednost delta { $mp-delta-radius } in je na voljo tudi v Q116. Če je vrednost delta večja od dovoljene tolerance obrabe ali loma za polmer orodja, krmiljenje orodje blokira (stanje L v TOOL.T).
help-tool-check-complete = Določa, ali se orodje izmeri prvič ali pa se preveri že izmerjeno orodje. Prvo merjenje prepiše polmer orodja { $mp-tool-radius } in dolžino orodja { $mp-tool-length } v preglednici orodij TOOL.T ter nastavi vrednosti delta { $mp-delta-radius } in { $mp-delta-length } na 0. Preverjanje izmerjene podatke primerja s podatki v preglednici; odstopanja se s predznakom vnesejo kot vrednosti delta { $mp-delta-radius } in { $mp-delta-length } in so na voljo tudi v Q115 in Q116. Če je katera od vrednosti delta večja od dovoljene tolerance obrabe ali loma, krmiljenje orodje blokira (stanje L v TOOL.T).
help-additional-tooth-measurement = Določa, ali se dodatno merijo tudi posamezna rezila. Izmeriti je mogoče največ 20 rezil.
help-additional-tooth-measurement__itnc530 = Določa, ali se dodatno merijo tudi posamezna rezila. Izmeriti je mogoče največ 99 rezil.
help-additional-tooth-measurement__tnc426-430 = Določa, ali se dodatno merijo tudi posamezna rezila.
help-calibration-tool-height = Položaj na osi vretena, na katerem umeritveno orodje ne more trčiti v obdelovance ali vpenjala. Nanaša se na aktivno referenčno točko obdelovanca. Če je vrednost tako majhna, da bi bila konica umeritvenega orodja pod zgornjim robom tipalne glave, ga krmiljenje samodejno pozicionira nad tipalno glavo (varnostno območje iz { $mp-setter-safety-distance }).
parameter-tool-check__tool-radius =
    .help = { help-tool-check-radius }
parameter-tool-check__tool-radius-old =
    .help = { help-tool-check-radius }
parameter-tool-check__tool-complete =
    .help = { help-tool-check-complete }
parameter-tool-check__tool-complete-old =
    .help = { help-tool-check-complete }
parameter-tooth-measurement__tool-radius =
    .help = { help-additional-tooth-measurement }
parameter-tooth-measurement__tool-radius-old =
    .help = { help-additional-tooth-measurement }
parameter-tooth-measurement__tool-complete =
    .help = { help-additional-tooth-measurement }
parameter-tooth-measurement__tool-complete-old =
    .help = { help-additional-tooth-measurement }
parameter-tool-status-parameter__tool-radius-old =
    .help = Številka parametra, v katerega krmiljenje shrani stanje meritve: 0,0: orodje je v mejah tolerance; 1,0: orodje je obrabljeno (vrednost { $mp-wear-tolerance-radius } je presežena); 2,0: orodje je zlomljeno (vrednost { $mp-break-tolerance-radius } je presežena). Če rezultata v programu ne potrebujete, na vprašanje odgovorite s tipko NO ENT.
parameter-tool-status-parameter__tool-complete-old =
    .help = Številka parametra, v katerega krmiljenje shrani stanje meritve: 0,0: orodje je v mejah tolerance; 1,0: orodje je obrabljeno (presežena je vrednost { $mp-wear-tolerance-length }, { $mp-wear-tolerance-radius } ali obe); 2,0: orodje je zlomljeno (presežena je vrednost { $mp-break-tolerance-length }, { $mp-break-tolerance-radius } ali obe). Če rezultata v programu ne potrebujete, na vprašanje odgovorite s tipko NO ENT.
parameter-tool-clearance-height__calibrate-tool-probe =
    .help = { help-calibration-tool-height }
parameter-tool-clearance-height__calibrate-tool-probe-old =
    .help = { help-calibration-tool-height }

# --- 32 and 482 ---
cycle-tool-radius = Merjenje polmera orodja
    .nc = POLMER ORODJA
    .purpose = Z namiznim tipalnim sistemom izmeri ali preveri polmer orodja: z vrtečim se orodjem in po želji nato še rezilo za rezilom. Krmiljenje rezultat shrani v preglednico orodij TOOL.T in ga po koncu cikla samodejno upošteva.
cycle-tool-radius__tnc426-430 =
    .purpose = Z namiznim tipalnim sistemom izmeri ali preveri polmer orodja: z vrtečim se orodjem in po želji nato še rezilo za rezilom. Krmiljenje rezultat shrani v preglednico orodij TOOL.T in ga uporabi pri naslednjem priklicu orodja.
cycle-tool-radius-old = Merjenje polmera orodja
    .nc = POLMER ORODJA
    .purpose = Z namiznim tipalnim sistemom izmeri ali preveri polmer orodja: z vrtečim se orodjem in po želji nato še rezilo za rezilom. Krmiljenje rezultat shrani v preglednico orodij TOOL.T in ga po koncu cikla samodejno upošteva. Stara oblika cikla 482.
cycle-tool-radius-old__tnc426-430 =
    .purpose = Z namiznim tipalnim sistemom izmeri ali preveri polmer orodja: z vrtečim se orodjem in po želji nato še rezilo za rezilom. Krmiljenje rezultat shrani v preglednico orodij TOOL.T in ga uporabi pri naslednjem priklicu orodja. Stara oblika cikla 482.
step-position-tool-beside-setter = Krmiljenje pozicionira orodje ob tipalno glavo, tako da je njegova čelna ploskev za vrednost { $mp-setter-axis-offset } pod zgornjim robom glave; če je v { -tool-table(case: "locative") } vnesen dodatni zamik dolžine { $mp-setter-offset-length }, pa še za to vrednost nižje.
step-probe-rotating-tool-radially = Krmiljenje radialno otipa vrteče se orodje.
step-measure-teeth-radially = Krmiljenje ugotovi polmer:
say-measure-radii-of-teeth = pri { $q-tooth-measurement } = 1 nato s spreminjanjem usmeritve vretena izmeri polmere vseh rezil
say-radius-of-rotating-tool = pri { $q-tooth-measurement } = 0 velja polmer, izmerjen z vrtečim se orodjem
step-store-tool-radius = Krmiljenje shrani rezultat:
say-overwrite-tool-radius = pri { $q-tool-check } = 0 prepiše polmer orodja { $mp-tool-radius } v TOOL.T in nastavi vrednost delta { $mp-delta-radius } na 0
say-enter-delta-radius = pri { $q-tool-check } = 1 izmerjeni polmer primerja s polmerom orodja { $mp-tool-radius }, odstopanje s predznakom vnese kot vrednost delta { $mp-delta-radius } in v Q116 ter orodje blokira (stanje L), če je presežena toleranca obrabe ali toleranca loma
result-tool-radius-deviation = Odstopanje polmera orodja
note-diamond-coated-cylinders = Valjasta orodja z diamantno površino je mogoče izmeriti z mirujočim vretenom. V ta namen v preglednici orodij število rezil { $mp-teeth } definirajte kot 0 in prilagodite strojni parameter { $mp-tool-measurement-config }. Upoštevajte priročnik za stroj.
note-diamond-coated-cylinders__itnc530 = Valjasta orodja z diamantno površino je mogoče izmeriti z mirujočim vretenom. V ta namen v preglednici orodij število rezil { $mp-teeth } definirajte kot 0 in prilagodite strojni parameter { $mp-calibration-behaviour }. Upoštevajte priročnik za stroj.
note-two-ways-to-measure-tool = Orodje je mogoče izmeriti na dva načina: samo med vrtenjem ali najprej med vrtenjem in nato še rezilo za rezilom.

# --- 33 and 483 ---
cycle-tool-complete = Popolno merjenje orodja
    .nc = MERJENJE ORODJA
    .purpose = Z namiznim tipalnim sistemom izmeri ali preveri dolžino in polmer orodja: z vrtečim se orodjem in po želji nato še rezilo za rezilom. Krmiljenje rezultate shrani v preglednico orodij TOOL.T in jih po koncu cikla samodejno upošteva.
cycle-tool-complete__tnc426-430 =
    .purpose = Z namiznim tipalnim sistemom izmeri ali preveri dolžino in polmer orodja: z vrtečim se orodjem in po želji nato še rezilo za rezilom. Krmiljenje rezultate shrani v preglednico orodij TOOL.T in jih uporabi pri naslednjem priklicu orodja.
cycle-tool-complete-old = Popolno merjenje orodja
    .nc = MERJENJE ORODJA
    .purpose = Z namiznim tipalnim sistemom izmeri ali preveri dolžino in polmer orodja: z vrtečim se orodjem in po želji nato še rezilo za rezilom. Krmiljenje rezultate shrani v preglednico orodij TOOL.T in jih po koncu cikla samodejno upošteva. Stara oblika cikla 483.
cycle-tool-complete-old__tnc426-430 =
    .purpose = Z namiznim tipalnim sistemom izmeri ali preveri dolžino in polmer orodja: z vrtečim se orodjem in po želji nato še rezilo za rezilom. Krmiljenje rezultate shrani v preglednico orodij TOOL.T in jih uporabi pri naslednjem priklicu orodja. Stara oblika cikla 483.
step-measure-radius-first = Krmiljenje izmeri orodje v vedno enakem zaporedju. Najprej izmeri polmer, tako kot cikla 32 in 482: orodje pozicionira ob tipalno glavo, tako da je njegova čelna ploskev pod zgornjim robom glave, in sicer za vrednosti { $mp-setter-axis-offset } in { $mp-setter-offset-length }, ter radialno otipa vrteče se orodje:
step-then-measure-length = Nato izmeri dolžino, tako kot cikla 31 in 481:
step-store-radius-and-length = Krmiljenje shrani rezultate:
say-overwrite-radius-and-length = pri { $q-tool-check } = 0 prepiše polmer orodja { $mp-tool-radius } in dolžino orodja { $mp-tool-length } v TOOL.T ter nastavi vrednosti delta { $mp-delta-radius } in { $mp-delta-length } na 0
say-enter-both-delta-values = pri { $q-tool-check } = 1 izmerjene podatke primerja s podatki v TOOL.T, odstopanja s predznakom vnese kot vrednosti delta { $mp-delta-radius } in { $mp-delta-length } ter v Q116 (polmer) in Q115 (dolžina), orodje pa blokira (stanje L), če je presežena katera od toleranc obrabe ali loma
note-complete-measurement-saves-time = Cikel je primeren zlasti za prvo merjenje orodij: v primerjavi z ločenim merjenjem dolžine in polmera prihrani precej časa.
title-first-measurement-rotating = Prvo merjenje z vrtečim se orodjem
title-check-teeth = Preverjanje z merjenjem posameznih rezil

# --- 30 and 480 ---
cycle-calibrate-tool-probe = Umerjanje tipalnega sistema
    .nc = UMERJANJE TIP. SIST.
    .purpose = Z valjastim umeritvenim orodjem samodejno umeri namizni tipalni sistem. Krmiljenje ugotovi tudi sredinski zamik umeritvenega orodja. Umeritvene vrednosti shrani in jih upošteva pri poznejšem merjenju orodij.
cycle-calibrate-tool-probe-old = Umerjanje tipalnega sistema
    .nc = UMERJANJE TIP. SIST.
    .purpose = Z valjastim umeritvenim orodjem samodejno umeri namizni tipalni sistem. Krmiljenje ugotovi tudi sredinski zamik umeritvenega orodja. Umeritvene vrednosti shrani in jih upošteva pri poznejšem merjenju orodij. Stara oblika cikla 480.
guard-tool-call-missing__calibrate-tool-probe = Priklicano ni nobeno orodje. Umeritveno orodje prikličite s TOOL CALL.
guard-tool-call-missing__calibrate-tool-probe-old = Priklicano ni nobeno orodje. Umeritveno orodje prikličite s TOOL CALL.
step-position-calibration-tool-over-setter = Krmiljenje pozicionira umeritveno orodje na varno višino { $q-tool-clearance-height }, vendar ne pod varnostno območje { $mp-setter-safety-distance } nad tipalno glavo.
step-calibrate-tool-probe = Krmiljenje z umeritvenim orodjem samodejno umeri tipalni sistem.
step-turn-spindle-for-centre-misalignment = Na polovici umerjanja krmiljenje zavrti vreteno za 180°. Tako ugotovi tudi sredinski zamik umeritvenega orodja.
step-store-tool-probe-calibration = Krmiljenje shrani umeritvene vrednosti in jih upošteva pri naslednjih merjenjih orodij.
note-enter-calibration-tool-data = Pred umerjanjem v preglednico orodij TOOL.T vnesite natančni polmer in natančno dolžino umeritvenega orodja.
note-cylindrical-calibration-tool = Kot umeritveno orodje uporabite natančno valjast element, na primer valjast zatič.
note-calibration-tool-size = Premer umeritvenega orodja naj bo večji od 15{"\u00A0"}mm, orodje pa naj iz vpenjalne glave sega približno 50{"\u00A0"}mm. Tedaj se pri sili tipanja 1{"\u00A0"}N upogne za 0,1{"\u00A0"}µm.
note-tool-probe-position-known = Položaj tipalnega sistema v delovnem prostoru stroja mora biti definiran v strojnih parametrih od { $mp-setter-centre } > [0] do [2].
note-tool-probe-position-known__itnc530 = Položaj tipalnega sistema v delovnem prostoru stroja mora biti definiran v strojnih parametrih od { $mp-setter-centre }.0 do { $mp-setter-centre }.2.
note-tool-probe-position-known__tnc426-430 = Položaj tipalnega sistema v delovnem prostoru stroja mora biti definiran v strojnih parametrih od { $mp-setter-centre }.0 do { $mp-setter-centre }.2.
note-recalibrate-after-position-data-change = Po spremembi katerega od strojnih parametrov od { $mp-setter-centre } > [0] do [2] znova izvedite umerjanje.
note-recalibrate-after-position-data-change__itnc530 = Po spremembi katerega od strojnih parametrov od { $mp-setter-centre }.0 do { $mp-setter-centre }.2 znova izvedite umerjanje.
note-recalibrate-after-position-data-change__tnc426-430 = Po spremembi katerega od strojnih parametrov od { $mp-setter-centre }.0 do { $mp-setter-centre }.2 znova izvedite umerjanje.
note-keep-fixtures-off-tool-probe = Med umerjanjem pazite, da v bližini tipalnega sistema ni vpenjal. Priporočilo: pustite prostor v velikosti dvakratnega premera umeritvenega orodja.
note-calibration-cycle-behaviour = Delovanje cikla za umerjanje je odvisno od strojnega parametra { $mp-tool-measurement-config }. Upoštevajte priročnik za stroj.
note-calibration-cycle-behaviour__tnc320 = Delovanje cikla za umerjanje določi proizvajalec stroja. Upoštevajte priročnik za stroj.
note-calibration-cycle-behaviour__itnc530 = Delovanje cikla za umerjanje je odvisno od strojnega parametra { $mp-calibration-behaviour }. Upoštevajte priročnik za stroj.
note-calibration-cycle-behaviour__tnc426-430 = Delovanje cikla za umerjanje je odvisno od strojnega parametra { $mp-calibration-behaviour }. Upoštevajte priročnik za stroj.

# --- 484 ---
cycle-calibrate-wireless-tool-probe = Umerjanje brezžičnega namiznega tipalnega sistema TT 449
    .nc = UMERJANJE BREZŽIČNEGA TT 449
    .purpose = Umeri brezžični infrardeči namizni tipalni sistem TT 449. Umerjanje je polsamodejno, ker položaj tipalnega sistema na mizi stroja ni določen. Krmiljenje ugotovi tudi sredinski zamik umeritvenega orodja, shrani umeritvene vrednosti in jih upošteva pri poznejšem merjenju orodij.
step-insert-calibration-tool = Vstavite umeritveno orodje.
step-define-and-start-calibration = Definirajte in zaženite cikel za umerjanje.
step-position-calibration-tool-by-hand = Umeritveno orodje ročno pozicionirajte nad središče tipalnega sistema in upoštevajte navodila v pojavnem oknu. Pazite, da je umeritveno orodje nad merilno površino tipalne glave.
step-calibrate-wireless-tool-probe = Krmiljenje z umeritvenim orodjem polsamodejno umeri tipalni sistem.
message-calibration-tool-over-setter = Umeritveno orodje pozicionirajte nad središče tipalnega sistema in nadaljujte.
note-wireless-calibration-by-hand = Umerjanje ni povsem samodejno, ker položaj tipalnega sistema na mizi stroja ni določen.
note-recalibrate-after-move = Če se položaj tipalnega sistema na mizi spremeni, znova izvedite umerjanje.
note-calibration-tool-size__tnc640 = Premer umeritvenega orodja mora biti večji od 15{"\u00A0"}mm, orodje pa mora iz vpenjalne glave segati 50{"\u00A0"}mm. Tedaj se pri sili tipanja 1{"\u00A0"}N upogne za 0,1{"\u00A0"}µm.
guard-tool-call-missing__calibrate-wireless-tool-probe = Priklicano ni nobeno orodje. Umeritveno orodje prikličite s TOOL CALL.
