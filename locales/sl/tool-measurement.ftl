# Cycles that measure the tool on a tool touch probe.

# --- parameters ---
parameter-tool-check = Merjenje orodja = 0/preverjanje = 1
    .label = PREVERJANJE
    .word = PREVERJANJE:
    .prompt = Merjenje orodja = 0/preverjanje = 1
    .help = Določa, ali se orodje izmeri prvič ali pa se preveri že izmerjeno orodje. Prvo merjenje prepiše dolžino orodja { $mp-tool-length } v preglednici orodij TOOL.T in nastavi vrednost delta { $mp-delta-length } na 0. Preverjanje izmerjeno dolžino primerja z dolžino orodja { $mp-tool-length }; odstopanje se s predznakom vnese kot vrednost delta { $mp-delta-length } in je na voljo tudi v Q115. Če je vrednost delta večja od dovoljene tolerance obrabe ali tolerance loma za dolžino orodja, krmiljenje orodje blokira (stanje L v TOOL.T).
choice-tool-first-measurement = prvo merjenje orodja
choice-tool-check = preverjanje že izmerjenega orodja
parameter-tool-status-parameter = Št. parametra za rezultat
    .prompt = Št. parametra za rezultat?
    .help = Številka parametra, v katerega krmiljenje shrani stanje meritve: 0,0: orodje je v mejah tolerance; 1,0: orodje je obrabljeno (vrednost { $mp-wear-tolerance-length } je presežena); 2,0: orodje je zlomljeno (vrednost { $mp-break-tolerance-length } je presežena). Če rezultata v programu ne potrebujete, na vprašanje odgovorite s tipko NO ENT.
parameter-tool-clearance-height = Varna višina
    .label = VARNA VIŠINA
    .word = VIŠINA:
    .prompt = Varna višina
    .help = Položaj na osi vretena, na katerem orodje ne more trčiti v obdelovance ali vpenjala. Nanaša se na aktivno referenčno točko obdelovanca. Če je vrednost tako majhna, da bi bila konica orodja pod zgornjim robom tipalne glave, krmiljenje orodje samodejno pozicionira nad tipalno glavo (varnostno območje iz { $mp-setter-safety-distance }).
parameter-tooth-measurement = Merjenje rezil 0 = ne/1 = da
    .label = MERJENJE REZIL
    .word = MERJENJE REZIL:
    .prompt = Merjenje rezil 0 = ne/1 = da
    .help = Določa, ali se rezila merijo posamezno. Izmeriti je mogoče največ 20 rezil.
parameter-tooth-measurement__itnc530 =
    .help = Določa, ali se rezila merijo posamezno. Izmeriti je mogoče največ 99 rezil.
parameter-tooth-measurement__tnc426-430 =
    .help = Določa, ali se rezila merijo posamezno.
choice-no-tooth-measurement = brez merjenja posameznih rezil
choice-tooth-measurement = merjenje posameznih rezil

# --- 31 and 481 ---
cycle-tool-length = Merjenje dolžine orodja
    .nc = DOLŽINA ORODJA
    .purpose = Z namiznim tipalnim sistemom izmeri ali preveri dolžino orodja. Krmiljenje rezultat shrani v preglednico orodij TOOL.T in ga po koncu cikla samodejno upošteva.
cycle-tool-length__tnc426-430 =
    .purpose = Z namiznim tipalnim sistemom izmeri ali preveri dolžino orodja. Krmiljenje rezultat shrani v preglednico orodij TOOL.T in ga uporabi pri naslednjem priklicu orodja.
cycle-tool-length-old = Merjenje dolžine orodja
    .nc = DOLŽINA ORODJA
    .purpose = Z namiznim tipalnim sistemom izmeri ali preveri dolžino orodja. Krmiljenje rezultat shrani v preglednico orodij TOOL.T in ga po koncu cikla samodejno upošteva. Stara oblika cikla 481.
cycle-tool-length-old__tnc426-430 =
    .purpose = Z namiznim tipalnim sistemom izmeri ali preveri dolžino orodja. Krmiljenje rezultat shrani v preglednico orodij TOOL.T in ga uporabi pri naslednjem priklicu orodja. Stara oblika cikla 481.
step-position-tool-over-setter = Krmiljenje pozicionira orodje na { -clearance-height(case: "accusative") } { $q-tool-clearance-height }, vendar ne pod varnostno območje nad tipalno glavo.
step-touch-tool-setter = Krmiljenje izmeri dolžino:
say-measure-tooth-by-tooth = rezilo za rezilom, in sicer pri { $q-tooth-measurement } = 1: orodje se pozicionira ob tipalno glavo, tako da je njegova čelna ploskev za vrednost { $mp-setter-axis-offset } pod zgornjim robom glave; če je v { -tool-table(case: "locative") } vnesen dodatni zamik dolžine { $mp-setter-offset-length }, pa še za to vrednost nižje. Krmiljenje z radialnim tipanjem vrtečega se orodja določi začetni kot, nato pa s spreminjanjem usmeritve vretena izmeri dolžino vseh rezil
say-measure-rotating-or-stationary = z vrtečim se orodjem, če je njegov premer večji od merilne površine: orodje je od središča { -probe(case: "genitive") } zamaknjeno za { $mp-setter-offset-radius } iz { -tool-table(case: "genitive") } in se med vrtenjem premakne na merilno površino, tako da se najde najdaljše rezilo. Sicer, pa tudi pri svedrih in krogelnih rezkarjih, z mirujočim orodjem: premakne se nad sredino merilne površine in nato z mirujočim vretenom nanjo; v ta namen je { $mp-setter-offset-radius } v { -tool-table(case: "locative") } enak 0
step-store-tool-length = Krmiljenje shrani rezultat:
say-overwrite-tool-length = pri { $q-tool-check } = 0 prepiše dolžino orodja { $mp-tool-length } v TOOL.T in nastavi vrednost delta { $mp-delta-length } na 0
say-enter-delta-length = pri { $q-tool-check } = 1 izmerjeno dolžino primerja z dolžino orodja { $mp-tool-length }, odstopanje s predznakom vnese kot vrednost delta { $mp-delta-length } in v Q115 ter orodje blokira (stanje L), če je presežena toleranca obrabe ali toleranca loma
result-tool-length-deviation = Odstopanje dolžine orodja
result-tool-status = Stanje meritve: 0,0 = v mejah tolerance, 1,0 = obrabljeno, 2,0 = zlomljeno
guard-tool-call-missing = Priklicano ni nobeno orodje. Orodje, ki ga želite izmeriti, prikličite s TOOL CALL.
note-enter-tool-data-first = Preden orodje prvič izmerite, vnesite njegov približni polmer in približno dolžino, število rezil in smer rezanja v { -tool-table(case: "accusative") } TOOL.T.
note-most-teeth-measurable = Posamezna rezila je mogoče meriti pri orodjih z največ 20 rezili.
note-most-teeth-measurable__itnc530 = Posamezna rezila je mogoče meriti pri orodjih z največ 99 rezili. Prikaz stanja kaže vrednosti za največ 24 rezil.
note-tool-table-must-be-active = Merilni cikli delujejo samo, če je preglednica orodij TOOL.T aktivna.
note-tool-call-before-tool-measurement = Pred uporabo merilnih ciklov v preglednico orodij TOOL.T vnesite vse podatke, potrebne za merjenje, in orodje, ki ga želite izmeriti, prikličite s TOOL CALL.
note-three-ways-to-measure-length = Dolžino je mogoče izmeriti na tri načine: z vrtečim se orodjem, če je njegov premer večji od merilne površine { -probe(case: "genitive") }; z mirujočim orodjem, če je premer manjši ali če gre za svedre in krogelne rezkarje; rezilo za rezilom z mirujočim orodjem, če je premer večji od merilne površine.
note-tool-measurement-feed-and-speed = Pri mirujočem orodju krmiljenje uporabi pomik pri tipanju iz { $mp-stationary-probing-feed }. Pri vrtečem se orodju iz največje dovoljene obhodne hitrosti v m/min in aktivnega polmera orodja r v mm izračuna število vrtljajev n = { $mp-max-peripheral-speed } / (r · 0,0063) v vrt/min in pomik pri tipanju v = toleranca pri merjenju · n v mm/min.
note-tool-measurement-tolerance = { $mp-probing-feed-calculation } določa toleranco pri merjenju. ConstantTolerance: ostane konstantna, zato se pomik pri zelo velikih orodjih zmanjša na nič, in sicer tem prej, čim manjša sta { $mp-max-peripheral-speed } in { $mp-measuring-tolerance }. VariableTolerance: pri polmerih orodja do 30{"\u00A0"}mm znaša { $mp-measuring-tolerance }, do 60{"\u00A0"}mm dvakrat toliko, do 90{"\u00A0"}mm trikrat toliko, do 120{"\u00A0"}mm štirikrat toliko. ConstantFeed: pomik ostane konstanten, napaka pri merjenju pa narašča s polmerom: (r · { $mp-measuring-tolerance }) / 5{"\u00A0"}mm.
note-tool-measurement-tolerance__itnc530 = { $mp-probing-feed-calculation } določa toleranco pri merjenju. 0: ostane konstantna, zato se pomik pri zelo velikih orodjih zmanjša na nič, in sicer tem prej, čim manjša sta { $mp-max-peripheral-speed } in { $mp-measuring-tolerance }. 1: pri polmerih orodja do 30{"\u00A0"}mm znaša { $mp-measuring-tolerance }, do 60{"\u00A0"}mm dvakrat toliko, do 90{"\u00A0"}mm trikrat toliko, do 120{"\u00A0"}mm štirikrat toliko. 2: pomik ostane konstanten, napaka pri merjenju pa narašča s polmerom: (r · { $mp-measuring-tolerance }) / 5{"\u00A0"}mm.
note-tool-measurement-tolerance__tnc426-430 = { $mp-probing-feed-calculation } določa toleranco pri merjenju. 0: ostane konstantna, zato se pomik pri zelo velikih orodjih zmanjša na nič, in sicer tem prej, čim manjša sta { $mp-max-peripheral-speed } in { $mp-measuring-tolerance }. 1: pri polmerih orodja do 30{"\u00A0"}mm znaša { $mp-measuring-tolerance }, do 60{"\u00A0"}mm dvakrat toliko, do 90{"\u00A0"}mm trikrat toliko, do 120{"\u00A0"}mm štirikrat toliko. 2: pomik ostane konstanten, napaka pri merjenju pa narašča s polmerom: (r · { $mp-measuring-tolerance }) / 5{"\u00A0"}mm.
note-check-tool-measurement-parameters = Preden uporabite cikle tipalnega sistema, preverite vse strojne parametre pod { $mp-probe-settings } > { $mp-tool-measurement-config } in { $mp-round-stylus-config }.
note-tool-table-entries = V { -tool-table(case: "locative") } { $mp-teeth } pomeni število rezil, največ 20. { $mp-wear-tolerance-length } in { $mp-wear-tolerance-radius } sta dovoljeni odstopanji dolžine in polmera za zaznavanje obrabe, { $mp-break-tolerance-length } in { $mp-break-tolerance-radius } pa za zaznavanje loma, vsakič od 0 do 0,9999{"\u00A0"}mm; če je vrednost presežena, krmiljenje orodje blokira (stanje L). { $mp-cutting-direction } je smer rezanja pri merjenju z vrtečim se orodjem. { $mp-setter-offset-radius } je zamik med središčem tipalne glave in središčem orodja pri merjenju dolžine; prednastavitev: brez vrednosti (zamik = polmer orodja). { $mp-setter-offset-length } je zamik med zgornjim robom tipalne glave in spodnjim robom orodja pri merjenju polmera, dodatno k { $mp-setter-axis-offset }; prednastavitev: 0.
note-tool-table-entries__itnc530 = V { -tool-table(case: "locative") } { $mp-teeth } pomeni število rezil. { $mp-wear-tolerance-length } in { $mp-wear-tolerance-radius } sta dovoljeni odstopanji dolžine in polmera za zaznavanje obrabe, { $mp-break-tolerance-length } in { $mp-break-tolerance-radius } pa za zaznavanje loma, vsakič od 0 do 0,9999{"\u00A0"}mm; če je vrednost presežena, krmiljenje orodje blokira (stanje L). { $mp-cutting-direction } je smer rezanja pri merjenju z vrtečim se orodjem. { $mp-setter-offset-radius } je zamik med središčem tipalne glave in središčem orodja pri merjenju dolžine; prednastavitev: polmer orodja R (vnese ga tipka NO ENT). { $mp-setter-offset-length } je zamik med zgornjim robom tipalne glave in spodnjim robom orodja pri merjenju polmera, dodatno k { $mp-setter-axis-offset }; prednastavitev: 0.
note-usual-tool-table-entries = Običajni vnosi v { -tool-table(case: "locative") }. Sveder: { $mp-teeth } se ne uporablja, { $mp-setter-offset-radius } = 0 (izmeri se konica svedra), { $mp-setter-offset-length } brez vnosa. Valjasti rezkar s premerom pod 19{"\u00A0"}mm: { $mp-teeth } = 4 (rezila), { $mp-setter-offset-radius } = 0 (orodje je ožje od tipalne glave), { $mp-setter-offset-length } = 0. Valjasti rezkar s premerom nad 19{"\u00A0"}mm: { $mp-teeth } = 4, { $mp-setter-offset-radius } = R (zamik je potreben, ker je orodje širše od tipalne glave), { $mp-setter-offset-length } = 0. Pri merjenju polmera nobeden od valjastih rezkarjev ne potrebuje dodatnega zamika, ker se uporabi zamik iz { $mp-setter-axis-offset }. Krogelni rezkar: { $mp-teeth } = 4, { $mp-setter-offset-radius } = 0 (izmeri se najnižja točka krogelne konice), { $mp-setter-offset-length } = 5 (vedno polmer orodja, da se premer ne izmeri v zaokrožitvi).
note-old-and-new-form = Cikli od 31 do 33 in od 481 do 483 delujejo enako. Razliki sta samo dve: cikle od 481 do 483 pozna tudi DIN/ISO (od G481 do G483), stanje meritve pa zapišejo vedno v parameter Q199 namesto v poljubno izbranega.
note-status-parameter-optional = Brez parametra za rezultat se stanje meritve ne shrani.
note-tool-measurement-in-tilted-plane = Orodja je mogoče meriti tudi pri zavrteni { -working-plane(case: "locative") }.
note-tool-status-display = Dodatni prikaz stanja lahko kaže rezultate (v načinih delovanja stroja): program na levi, rezultate na desni. Vrednosti, ki presegajo toleranco obrabe, so označene z *, vrednosti, ki presegajo toleranco loma, pa z B.
note-tool-status-display__tnc426-430 = Gumb za stanje merjenja orodja prikaže rezultate v dodatnem prikazu stanja (v načinih delovanja stroja): program na levi, rezultate na desni. Vrednosti, ki presegajo toleranco obrabe, so označene z *, vrednosti, ki presegajo toleranco loma, pa z B.
note-from-software-280476 = Na voljo od NC-programske opreme 280 476-xx.
note-not-in-iso = Stara oblika v DIN/ISO ni na voljo.
note-prepare-for-tool-probe = Proizvajalec stroja mora stroj in krmiljenje pripraviti za namizni tipalni sistem. Morda niso na voljo vsi cikli in funkcije. Upoštevajte priročnik za stroj.
title-first-measurement-rotating-old = Prvo merjenje z vrtečim se orodjem; stara oblika
title-first-measurement-rotating-status = Prvo merjenje z vrtečim se orodjem, stanje shranjeno v Q1
title-check-teeth-status-old = Preverjanje z merjenjem posameznih rezil, stanje shranjeno v Q5; stara oblika
title-check-teeth-without-status = Preverjanje z merjenjem posameznih rezil, stanje ni shranjeno
