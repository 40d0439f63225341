# Cycles that measure angles, studs, rectangles, widths, coordinates, bolt-hole circles and planes.

# --- what several of them share ---
say-part-is-scrap = izvržek (Q182 = 1), če je katera od izmerjenih vrednosti zunaj tolerance in je ni mogoče popraviti
say-part-needs-rework = potrebna je dodatna obdelava (Q181 = 1), če je katera od izmerjenih vrednosti zunaj tolerance in jo je mogoče popraviti

# --- 422 ---
cycle-measure-stud = Meritev zunaj kroga
    .nc = MERITEV ZUNAJ KROGA
    .purpose = Izmeri središče in premer krožnega čepa. Če so v ciklu definirane tolerance, krmiljenje primerja želene vrednosti z dejanskimi in v parametre shrani odstopanja.
say-part-is-scrap__measure-stud = izvržek (Q182 = 1), če je čep manjši od { $q-stud-least-diameter } ali če njegovo središče odstopa za več kot { $q-centre-tolerance-main } ali { $q-centre-tolerance-minor }
say-part-needs-rework__measure-stud = potrebna je dodatna obdelava (Q181 = 1), če je čep večji od { $q-stud-greatest-diameter }
note-smallest-stepping-angle__measure-stud = Čim manjši je kotni korak { $q-probing-stepping-angle }, tem manj natančno krmiljenje izračuna dimenzije čepa. Najmanjši vnos: 5°.

# --- 423, 424 ---
cycle-measure-rectangular-pocket = Meritev znotraj pravokotnika
    .nc = MERITEV ZNOTR. PRAVOKOT.
    .nc-aliases = MERITEV ZNOT. PRAVOKOT. | MERITEV ZNOTRAJ PRAVOKOTNIKA
    .purpose = Izmeri središče, dolžino in širino pravokotnega žepa. Če so v ciklu definirane tolerance, krmiljenje primerja želene vrednosti z dejanskimi in v parametre shrani odstopanja.
cycle-measure-rectangular-stud = Meritev zunaj pravokotnika
    .nc = MERITEV ZUN. PRAVOKOT.
    .nc-aliases = MERITEV ZUNAJ PRAVOKOTNIKA
    .purpose = Izmeri središče, dolžino in širino pravokotnega čepa. Če so v ciklu definirane tolerance, krmiljenje primerja želene vrednosti z dejanskimi in v parametre shrani odstopanja.
say-part-is-scrap__measure-rectangular-pocket = izvržek (Q182 = 1), če je katera od stranic daljša od { $q-first-side-greatest-length } oziroma { $q-second-side-greatest-length } ali če središče odstopa za več kot { $q-centre-tolerance-main } ali { $q-centre-tolerance-minor }
say-part-needs-rework__measure-rectangular-pocket = potrebna je dodatna obdelava (Q181 = 1), če je katera od stranic krajša od { $q-first-side-least-length } oziroma { $q-second-side-least-length }
say-part-is-scrap__measure-rectangular-stud = izvržek (Q182 = 1), če je katera od stranic krajša od { $q-first-side-least-length } oziroma { $q-second-side-least-length } ali če središče odstopa za več kot { $q-centre-tolerance-main } ali { $q-centre-tolerance-minor }
say-part-needs-rework__measure-rectangular-stud = potrebna je dodatna obdelava (Q181 = 1), če je katera od stranic daljša od { $q-first-side-greatest-length } oziroma { $q-second-side-greatest-length }
result-side-main-deviation = Odstopanje stranske dolžine na glavni osi
result-side-minor-deviation = Odstopanje stranske dolžine na pomožni osi
title-measure-and-rework-rectangular-stud = Merjenje pravokotnega čepa in njegova dokončna obdelava z izmerjenimi vrednostmi
title-measure-rectangular-pocket-with-log = Merjenje pravokotnega žepa in zapis rezultatov v protokol

# --- 425, 426 ---
cycle-measure-slot-width = Meritev notranje širine
    .nc = MERITEV NOTRANJE ŠIRINE
    .purpose = Izmeri položaj in širino utora (žepa). Če so v ciklu definirane tolerance, krmiljenje primerja želene vrednosti z dejanskimi in v parameter shrani odstopanje.
cycle-measure-ridge-width = Meritev zunaj stojine
    .nc = MERJENJE MOST ZUNAJ
    .nc-aliases = MERITEV ZUNAJ STOJINE
    .purpose = Izmeri položaj in širino stojine. Če so v ciklu definirane tolerance, krmiljenje primerja želene vrednosti z dejanskimi in v parameter shrani odstopanje.
step-probe-first-in-positive-direction = Tipalni sistem izvede prvo tipanje s pomikom pri tipanju (stolpec { $mp-probing-feed }), vedno v pozitivni smeri programirane osi.
step-probe-first-in-positive-direction__tnc426-430 = Tipalni sistem izvede prvo tipanje s pomikom pri tipanju ({ $mp-probing-feed } ali { $mp-analog-probing-feed }), vedno v pozitivni smeri programirane osi.
step-probe-first-in-negative-direction = Tipalni sistem izvede prvo tipanje s pomikom pri tipanju (stolpec { $mp-probing-feed }), vedno v negativni smeri programirane osi.
step-probe-first-in-negative-direction__tnc426-430 = Tipalni sistem izvede prvo tipanje s pomikom pri tipanju ({ $mp-probing-feed } ali { $mp-analog-probing-feed }), vedno v negativni smeri programirane osi.
step-probe-second-side-of-slot = Tipalni sistem izvede drugo tipanje, kot določa { $q-second-measurement-offset }:
step-probe-second-side-of-slot__tnc640 = Pri veliki želeni dolžini krmiljenje tipalni sistem na drugo tipalno točko premakne v hitrem teku. Tipalni sistem izvede drugo tipanje, kot določa { $q-second-measurement-offset }:
say-offset-second-measurement = če { $q-second-measurement-offset } ni 0, krmiljenje tipalni sistem vzporedno z osjo premakne za ta zamik na naslednjo tipalno točko in tam izvede tipanje
say-offset-second-measurement__tnc640 = če { $q-second-measurement-offset } ni 0, krmiljenje tipalni sistem premakne za ta zamik na naslednjo tipalno točko, pri { $q-traverse-to-clearance-height } = 1 na varni višini { $q-clearance-height }, in tam izvede tipanje
say-measure-in-opposite-direction = pri { $q-second-measurement-offset } = 0 širino izmeri neposredno v nasprotni smeri
step-probe-second-side-of-ridge = Tipalni sistem se na varni višini { $q-clearance-height } premakne na naslednjo tipalno točko in tam izvede drugo tipanje.
say-part-is-scrap__measure-slot-width = izvržek (Q182 = 1), če je utor širši od { $q-greatest-dimension }
say-part-needs-rework__measure-slot-width = potrebna je dodatna obdelava (Q181 = 1), če je utor ožji od { $q-least-dimension }
say-part-is-scrap__measure-ridge-width = izvržek (Q182 = 1), če je stojina ožja od { $q-least-dimension }
say-part-needs-rework__measure-ridge-width = potrebna je dodatna obdelava (Q181 = 1), če je stojina širša od { $q-greatest-dimension }
note-clearance-acts-in-probe-axis-only = Varnostna razdalja { $q-probing-clearance } deluje samo pri tipanju referenčne točke na osi tipalnega sistema.
result-measured-length-actual = Dejanska izmerjena dolžina
result-measured-length-deviation = Odstopanje izmerjene dolžine

# --- 427 ---
cycle-measure-coordinate = Merjenje koordinate
    .nc = MERJENJE KOORDINATE
    .nc-aliases = MERITEV KOORDINATE
    .purpose = Izmeri koordinato na izbrani osi in vrednost shrani v parameter. Če so v ciklu definirane tolerance, krmiljenje primerja želene vrednosti z dejanskimi in v parametre shrani odstopanja.
step-position-against-traverse-direction = Krmiljenje pozicionira tipalni sistem v hitrem teku (vrednost iz stolpca { $mp-positioning-feed }) in s pozicionirno logiko na programirano tipalno točko. Pri tem ga zamakne za varnostno razdaljo v smeri, nasprotni smeri premika { $q-traverse-direction }.
step-position-against-traverse-direction__tnc426-430 = Krmiljenje pozicionira tipalni sistem v hitrem teku (vrednost iz { $mp-positioning-feed } ali { $mp-analog-positioning-feed }) in s pozicionirno logiko na programirano tipalno točko. Pri tem ga zamakne za varnostno razdaljo v smeri, nasprotni smeri premika { $q-traverse-direction }.
step-probe-coordinate = Krmiljenje v obdelovalni ravnini pozicionira tipalni sistem na programirano tipalno točko in tam izmeri dejansko vrednost na izbrani osi.
step-retract-and-store-measured-coordinate = Krmiljenje vrne tipalni sistem na varno višino { $q-clearance-height } in izmerjeno koordinato shrani v parameter rezultata.
say-part-is-scrap__measure-coordinate = izvržek (Q182 = 1), če je izmerjena koordinata manjša od { $q-least-dimension }
say-part-needs-rework__measure-coordinate = potrebna je dodatna obdelava (Q181 = 1), če je izmerjena koordinata večja od { $q-greatest-dimension }
say-correct-tool-length = če { $q-monitored-tool } ni 0, pri { $q-measuring-axis } = 3 popravi dolžino orodja v stolpcu DL preglednice orodij; če je odstopanje večje od tolerance loma RBREAK, prikaže sporočilo o napaki, zaustavi programski tek in blokira orodje (stolpec TL = L)
say-correct-tool-radius__measure-coordinate = če { $q-monitored-tool } ni 0, pri { $q-measuring-axis } = 1 ali 2 popravi vrednost delta polmera v stolpcu DR preglednice orodij, in sicer v smeri, ki izhaja iz { $q-traverse-direction }; če je odstopanje večje od tolerance loma RBREAK, prikaže sporočilo o napaki, zaustavi programski tek in blokira orodje (stolpec TL = L)
note-coordinate-is-outside-dimension = Krmiljenje predvideva, da se meri zunanja mera (čep). V drugih primerih je pravilno stanje meritve mogoče doseči z ustrezno izbiro največje in najmanjše mere skupaj s smerjo tipanja.
note-coordinate-corrects-radius-or-length = Če je merilna os katera od osi obdelovalne ravnine ({ $q-measuring-axis } = 1 ali 2), krmiljenje popravi polmer orodja; smer popravka izhaja iz smeri premika { $q-traverse-direction }. Če je merilna os enaka osi tipalnega sistema ({ $q-measuring-axis } = 3), popravi dolžino orodja.

# --- 430 ---
cycle-measure-bolt-hole-circle = Merjenje krožne luknje
    .nc = MERJENJE KROŽNE LUKNJE
    .nc-aliases = MERITEV KROŽNE LUKNJE
    .purpose = Z merjenjem treh vrtin izmeri središče in premer delnega kroga (krožne luknje). Če so v ciklu definirane tolerance, krmiljenje primerja želene vrednosti z dejanskimi in v parametre shrani odstopanja.
step-measure-centre-of-hole = Tipalni sistem se premakne na merilno višino { $q-measuring-height } in s štirimi tipanji določi središče vrtine.
step-travel-to-next-hole = Tipalni sistem se vrne na varno višino { $q-clearance-height } in se pozicionira na vneseno središče naslednje vrtine.
until-three-holes-measured = niso določena središča vseh treh vrtin
say-part-is-scrap__measure-bolt-hole-circle = izvržek (Q182 = 1), če je premer večji od { $q-greatest-dimension } ali manjši od { $q-least-dimension } ali če središče odstopa za več kot { $q-centre-tolerance-main } ali { $q-centre-tolerance-minor }
say-monitor-tool-breakage = če { $q-monitored-tool } ni 0, odstopanje primerja s toleranco loma RBREAK; če je odstopanje večje, prikaže sporočilo o napaki, zaustavi programski tek in blokira orodje (stolpec TL = L). Orodja ne popravi
note-only-breakage-monitoring = Ta cikel nadzoruje samo lom orodja; orodja ne popravi.
result-bolt-circle-diameter-actual = Dejanski premer delnega kroga
result-bolt-circle-diameter-deviation = Odstopanje premera delnega kroga

# --- 420 ---
cycle-measure-angle = Merjenje kota
    .nc = MERITEV KOTA
    .nc-aliases = MERJENJE KOTA
    .purpose = Izmeri kot med premico in glavno osjo obdelovalne ravnine.
say-travel-to-point-at-clearance-height = pri { $q-traverse-to-clearance-height } = 1 na varni višini { $q-clearance-height }
say-travel-to-point-at-measuring-height = pri { $q-traverse-to-clearance-height } = 0 na merilni višini { $q-measuring-height }
step-retract-and-store-angle = Krmiljenje vrne tipalni sistem na varno višino { $q-clearance-height } in izmerjeni kot shrani v parameter rezultata.
note-angle-about-a-or-b = Če je merilna os enaka osi tipalnega sistema ({ $q-measuring-axis } = 3), v { $q-first-point-main } in { $q-second-point-main } vnesite za merjenje kota okoli osi A isto vrednost, za merjenje kota okoli osi B pa različni vrednosti.
note-results-shown-in-help-graphic = Med definiranjem cikla pomožna slika kaže tudi parametre rezultatov; osvetljeni parameter rezultata pripada izbranemu parametru za vnos.
note-results-shown-in-help-graphic__tnc426-430 = Med definiranjem cikla pomožna slika kaže tudi parametre rezultatov.
result-measured-angle = Izmerjeni kot glede na glavno os obdelovalne ravnine

# --- 431 ---
cycle-measure-plane = Merjenje ravnine
    .nc = MERJENJE RAVNINE
    .nc-aliases = MERITEV RAVNINE
    .purpose = Z merjenjem treh točk določi kote ravnine in jih shrani v parametre.
step-measure-first-point-of-plane = Krmiljenje pozicionira tipalni sistem v hitrem teku (vrednost iz stolpca { $mp-positioning-feed }) in s pozicionirno logiko na programirano prvo tipalno točko in tam izmeri prvo točko ravnine. Pri tem ga zamakne za varnostno razdaljo v smeri, nasprotni smeri tipanja.
step-measure-first-point-of-plane__tnc426-430 = Krmiljenje pozicionira tipalni sistem v hitrem teku (vrednost iz { $mp-positioning-feed } ali { $mp-analog-positioning-feed }) in s pozicionirno logiko na programirano prvo tipalno točko in tam izmeri prvo točko ravnine. Pri tem ga zamakne za varnostno razdaljo v smeri, nasprotni smeri tipanja.
step-measure-second-point-of-plane = Tipalni sistem se vrne na varno višino { $q-clearance-height } in se v obdelovalni ravnini premakne na drugo tipalno točko, kjer krmiljenje izmeri dejansko vrednost druge točke ravnine.
step-measure-third-point-of-plane = Tipalni sistem se vrne na varno višino { $q-clearance-height } in se v obdelovalni ravnini premakne na tretjo tipalno točko, kjer krmiljenje izmeri dejansko vrednost tretje točke ravnine.
step-retract-and-store-plane-angles = Krmiljenje vrne tipalni sistem na varno višino { $q-clearance-height } in kote shrani v parametre rezultatov.
guard-points-on-one-line = Vse tri merilne točke ležijo na isti premici. Krmiljenje kotov ravnine ne more izračunati.
note-positioning-logic__measure-plane = Pozicionirna logika: če je najnižja točka tipalne glave pod varno višino { $q-clearance-height }, krmiljenje tipalni sistem najprej po osi tipalnega sistema umakne na varno višino in ga nato v obdelovalni ravnini pozicionira na prvo tipalno točko. Če je nad varno višino, krmiljenje tipalni sistem najprej v obdelovalni ravnini pozicionira na prvo tipalno točko in ga nato po osi tipalnega sistema premakne neposredno na merilno višino.
note-three-points-not-on-a-line = Merilne točke ne smejo vse tri ležati na isti premici: samo tako lahko krmiljenje izračuna kote.
note-spatial-angles-for-tilting = Parametri od Q170 do Q172 vsebujejo prostorske kote, ki jih potrebuje funkcija za vrtenje obdelovalne ravnine. Prvi dve merilni točki določata smer glavne osi pri vrtenju obdelovalne ravnine.
note-third-point-sets-tool-axis = Tretja merilna točka določa smer orodne osi. Definirajte jo v smeri pozitivne osi Y, da ima orodna os v desnosučnem koordinatnem sistemu pravo lego.
note-spatial-angle-in-tilted-plane = Če se cikel izvede pri aktivni zavrteni obdelovalni ravnini, se izmerjeni prostorski koti nanašajo na zavrteni koordinatni sistem. V funkciji za vrtenje obdelovalne ravnine jih uporabite kot inkrementalne vrednosti.
result-projection-angle-a = Projekcijski kot osi A
result-projection-angle-a__tnc426-430 = Kot osi A
result-projection-angle-b = Projekcijski kot osi B
result-projection-angle-b__tnc426-430 = Kot osi B
result-spatial-angle-a = Prostorski kot A
result-spatial-angle-b = Prostorski kot B
result-spatial-angle-c = Prostorski kot C
result-first-value-in-probe-axis = Izmerjena vrednost na osi tipalnega sistema (prva meritev)
result-first-value-in-probe-axis__tnc320 = Izmerjena vrednost na osi tipalnega sistema
result-second-value-in-probe-axis = Izmerjena vrednost na osi tipalnega sistema (druga meritev)
result-third-value-in-probe-axis = Izmerjena vrednost na osi tipalnega sistema (tretja meritev)

# --- 1 ---
cycle-polar-reference-plane = Referenčna ravnina – polarna
    .nc = REF. POLARNA RAVNINA
    .nc-aliases = REFERENČNA POLARNA RAVNINA
    .purpose = Izmeri poljuben položaj obdelovanca v poljubni smeri tipanja, ki jo določa kot.
step-probe-at-polar-angle = Tipalni sistem izvede tipanje s pomikom pri tipanju (stolpec { $mp-probing-feed }). Pri tem krmiljenje glede na kot tipanja hkrati premika dve osi. Smer tipanja je v ciklu definirana s polarnim kotom.
step-probe-at-polar-angle__tnc426-430 = Tipalni sistem izvede tipanje s pomikom pri tipanju ({ $mp-probing-feed } ali { $mp-analog-probing-feed }). Pri tem krmiljenje glede na kot tipanja hkrati premika dve osi. Smer tipanja je v ciklu definirana s polarnim kotom.
step-return-and-store-trigger-position = Ko je položaj izmerjen, se tipalni sistem vrne na začetno točko tipanja. Krmiljenje koordinate položaja, na katerem je bil tipalni sistem ob stikalnem signalu, shrani v parametre od Q115 do Q119.
step-return-and-store-trigger-position__tnc426-430 = Ko je položaj izmerjen, se tipalni sistem vrne na začetno točko tipanja. Krmiljenje koordinate središča tipalne krogle ob dotiku z obdelovancem shrani v parametre od Q115 do Q119.
note-probing-plane-by-axis = Tipalna os, definirana v ciklu, določa tipalno ravnino: X določa ravnino X/Y, Y ravnino Y/Z, Z ravnino Z/X.
note-trigger-position-of-ball-centre = Parametri od Q115 do Q119 vsebujejo koordinate središča tipalne krogle ob dotiku z obdelovancem.

# --- 3 ---
cycle-measuring = Meritev
    .nc = MERJENJE
    .nc-aliases = MERITEV
    .purpose = Izmeri poljuben položaj obdelovanca v izbrani smeri tipanja. Drugače kot pri ostalih merilnih ciklih se pot meritve in merilni pomik vneseta neposredno v tem ciklu, prav tako odmik po meritvi. Namenjen je izdelavi ciklov proizvajalca stroja.
cycle-measuring__tnc426-430 =
    .purpose = Izmeri poljuben položaj obdelovanca v izbrani smeri tipanja. Drugače kot pri ostalih merilnih ciklih se merilni pomik vnese neposredno v tem ciklu. Je merilni cikel za posebno uporabo.
step-move-in-polar-direction = Tipalni sistem se s trenutnega položaja z vnesenim pomikom premakne v programirani smeri tipanja. Smer tipanja je v ciklu definirana s polarnim kotom.
step-stop-and-store-ball-centre = Ko krmiljenje izmeri položaj, se tipalni sistem ustavi. Krmiljenje koordinate X, Y in Z središča tipalne krogle brez popravka dolžine in polmera shrani v tri zaporedne Q-parametre. Številka prvega parametra rezultata je definirana v ciklu.
step-stop-and-store-ball-centre__tnc426-430 = Ko krmiljenje izmeri položaj, se tipalni sistem ustavi. Krmiljenje koordinate središča tipalne krogle shrani v tri zaporedne Q-parametre. Številka prvega parametra je definirana v ciklu.
result-ball-centre-and-status = Središče tipalne krogle v X; naslednja parametra vsebujeta Y in Z, četrti pa −1, če ni bilo veljavne tipalne točke
result-ball-centre-and-status__tnc426-430 = Prva koordinata središča tipalne krogle; naslednja parametra vsebujeta ostali
note-probe-data-without-effect = Podatka tipalnega sistema { $mp-probing-distance } (največja pot do tipalne točke) in { $mp-probing-feed } (pomik pri tipanju), ki delujeta v ostalih merilnih ciklih, v tem ciklu nimata učinka.
note-four-parameters-overwritten = Krmiljenje vedno zapiše štiri zaporedne Q-parametre.
note-no-touch-point-no-error = Če krmiljenje ne najde veljavne tipalne točke, se program nadaljuje brez sporočila o napaki. Četrtemu parametru rezultata krmiljenje tedaj priredi −1, tako da se lahko program na napako odzove.
note-retraction-not-beyond-start = Krmiljenje tipalni sistem umakne največ za pot odmika MB, vendar ne čez začetno točko meritve. Zato pri odmiku ne more priti do kolizije.
note-probe-input-by-function = Funkcija FN17: SYSWRITE ID 990 NR 6 določa, ali cikel deluje na vhod tipalnega sistema X12 ali X13.
note-available-from-software-474 = Ta cikel je na voljo od NC-programske opreme 280 474-xx.
note-behaviour-defined-by-builder = Kako ta cikel podrobno deluje, določi proizvajalec stroja ali dobavitelj programske opreme; uporablja se znotraj posebnih ciklov tipalnega sistema.
