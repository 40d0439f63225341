# Cycles that measure the workpiece.

# --- 421 ---
cycle-measure-hole = Merjenje vrtine
    .nc = MERITEV VRTINE
    .nc-aliases = MERJENJE VRTINE
    .purpose = Izmeri središče in premer vrtine (krožnega žepa). Če so v ciklu definirane tolerance, krmiljenje primerja želene vrednosti z dejanskimi in v parametre shrani odstopanja.
step-retract-and-store-results = Krmiljenje premakne { -probe(case: "accusative") } nazaj na { -clearance-height(case: "accusative") } { $q-clearance-height } ter dejanske vrednosti in odstopanja od želenih vrednosti shrani v parametre rezultatov.
step-set-measuring-status = Krmiljenje določi stanje meritve:
say-hole-is-scrap = izvržek (Q182 = 1), če je vrtina večja od { $q-hole-greatest-diameter } ali če njeno središče odstopa za več kot { $q-centre-tolerance-main } ali { $q-centre-tolerance-minor }
say-hole-needs-rework = potrebna je dodatna obdelava (Q181 = 1), če je vrtina manjša od { $q-hole-least-diameter }
say-hole-is-good = sicer v mejah tolerance (Q180 = 1), tudi če tolerance ali mejne vrednosti niso vnesene
step-write-measuring-log = Krmiljenje ustvari merilni protokol, kot določa { $q-measuring-log }:
say-log-to-file = pri { $q-measuring-log } = 1 protokol shrani v datoteko TCHPR{ $cycle }.TXT
say-log-on-screen = pri { $q-measuring-log } = 2 prekine programski tek in prikaže protokol na zaslonu; program se nadaljuje z NC-zagonom
say-no-log = sicer protokola ne ustvari
message-measuring-log-on-screen = Merilni protokol je na zaslonu. Nadaljujte z NC-zagonom.
step-monitor-tool = Krmiljenje nadzoruje orodje, kot določa { $q-monitored-tool }:
say-correct-tool-radius = če { $q-monitored-tool } ni 0, odstopanje polmera prišteje vrednosti delta polmera v stolpcu DR { -tool-table(case: "genitive") }; če je odstopanje večje od tolerance loma RBREAK, prikaže sporočilo o napaki, zaustavi programski tek in blokira orodje (stolpec TL = L)
say-no-tool-monitoring = pri { $q-monitored-tool } = 0 orodja ne nadzoruje
step-stop-on-tolerance-error = Krmiljenje se na prekoračeno toleranco odzove, kot določa { $q-stop-on-tolerance-error }:
say-stop-with-tolerance-error = pri { $q-stop-on-tolerance-error } = 1 prekine programski tek in prikaže sporočilo o napaki
say-stop-with-tolerance-error__probing-3d = pri { $q-tolerance-error-reaction } = 1 prekine programski tek in prikaže sporočilo o napaki
say-continue-program = sicer se program nadaljuje
result-centre-main-deviation = Odstopanje središča na glavni osi
result-centre-minor-deviation = Odstopanje središča na pomožni osi
result-diameter-deviation = Odstopanje premera
result-status-good = 1: meritve so v mejah tolerance
result-status-rework = 1: potrebna je dodatna obdelava
result-status-scrap = 1: izvržek
note-measuring-log-contents = Merilni protokol vsebuje datum, čas in merilni program, želene vrednosti, mejne vrednosti, dejanske vrednosti, odstopanja in ostale merilne rezultate (merilno višino).
note-measuring-log-contents__tnc426-430 = Merilni protokol vsebuje datum, čas in merilni program, želene vrednosti, mejne vrednosti, dejanske vrednosti in odstopanja.
note-measuring-log-in-tnc-directory = Krmiljenje shrani merilni protokol kot datoteko ASCII, privzeto v imenik TNC:\.
note-measuring-log-in-program-directory = Krmiljenje shrani merilni protokol kot datoteko ASCII, privzeto v imenik, iz katerega se izvaja merilni program. Protokol lahko po podatkovnem vmesniku pošljete tudi na tiskalnik ali v računalnik: funkcijo Print v meniju vmesnika nastavite na RS232:\.
note-measuring-log-transfer = Za prenos merilnega protokola po podatkovnem vmesniku uporabite programsko opremo za prenos podatkov TNCremo podjetja HEIDENHAIN.
note-measuring-log-datum = Vse izmerjene vrednosti v datoteki s protokolom se nanašajo na referenčno točko, ki je bila aktivna ob izvajanju cikla.
note-measuring-log-manual-datum = Če ni aktiven zamik ničelne točke, se vse izmerjene vrednosti v datoteki s protokolom nanašajo na referenčno točko, določeno v ročnem načinu.
note-status-also-without-limits = Krmiljenje določi stanje meritve tudi, če tolerance ali mejne vrednosti niso vnesene.
note-which-value-is-out = Krmiljenje označi dodatno obdelavo ali izvržek, kakor hitro ena od izmerjenih vrednosti ni v mejah tolerance. Katera je ta vrednost, ugotovite iz merilnega protokola ali tako, da rezultate primerjate z njihovimi mejnimi vrednostmi.
note-limit-zero-not-monitored = Mejne vrednosti ali tolerance, za katero je vneseno 0 (prednastavljena vrednost), krmiljenje ne nadzoruje.
note-tool-monitoring-needs = Nadzor in popravek orodja delujeta samo, če je { -tool-table(case: "nominative") } aktivna in { $q-monitored-tool } ni 0. Pri več meritvah za popravek krmiljenje vsako odstopanje prišteje vrednosti, shranjeni v { -tool-table(case: "locative") }.
note-tool-monitoring-needs__tnc426-430 = Nadzor in popravek orodja delujeta samo, če je { -tool-table(case: "nominative") } aktivna in { $q-monitored-tool } ni 0.
note-tool-radius-always-corrected = Polmer orodja v stolpcu DR { -tool-table(case: "genitive") } krmiljenje popravi vedno, torej tudi pri odstopanju v mejah tolerance. Ali je potrebna dodatna obdelava, lahko v programu preverite s Q181 (Q181 = 1: potrebna je dodatna obdelava).
note-tool-breakage-needs = Nadzor loma orodja deluje samo, če je { -tool-table(case: "nominative") } aktivna, { $q-monitored-tool } ni 0 in je toleranca loma RBREAK orodja v { -tool-table(case: "locative") } večja od 0.
note-tool-by-name = Orodje lahko vnesete tudi z imenom, ki ga izberete z gumbom. Krmiljenje končnega narekovaja ne prikaže.

# --- 0 ---
cycle-reference-plane = Referenčna ravnina
    .nc = REFERENČNA RAVNINA
    .purpose = Izmeri koordinato na izbrani osi in jo priredi Q-parametru.
step-position-in-space = Tipalni sistem se v hitrem teku (vrednost iz stolpca { $mp-positioning-feed }) s 3D-premikom premakne na predpoložaj, programiran v ciklu.
step-position-in-space__tnc426-430 = Tipalni sistem se v hitrem teku (vrednost iz { $mp-positioning-feed } ali { $mp-analog-positioning-feed }) premakne na predpoložaj, programiran v ciklu.
step-probe-in-chosen-direction = Tipalni sistem izvede tipanje s pomikom pri tipanju (stolpec { $mp-probing-feed }) v smeri, programirani v ciklu.
step-probe-in-chosen-direction__tnc426-430 = Tipalni sistem izvede tipanje s pomikom pri tipanju ({ $mp-probing-feed } ali { $mp-analog-probing-feed }) v smeri, programirani v ciklu.
step-return-and-store-coordinate = Ko je položaj izmerjen, se { -probe(case: "nominative") } vrne na začetno točko tipanja. Krmiljenje shrani izmerjeno koordinato v programirani Q-parameter, koordinate položaja, na katerem je bil { -probe(case: "nominative") } ob stikalnem signalu, pa v parametre od Q115 do Q119.
result-measured-coordinate = Izmerjena koordinata
result-trigger-position-axis-1 = Položaj ob stikalnem signalu, 1. os
result-trigger-position-axis-2 = Položaj ob stikalnem signalu, 2. os
result-trigger-position-axis-3 = Položaj ob stikalnem signalu, 3. os
result-trigger-position-axis-4 = Položaj ob stikalnem signalu, 4. os
result-trigger-position-axis-5 = Položaj ob stikalnem signalu, 5. os
note-pre-position-without-collision = Nevarnost kolizije! Tipalni sistem pozicionirajte tako, da pri premiku na programirani predpoložaj ne more trčiti.
note-pre-position-without-collision__tnc426-430 = Nevarnost kolizije! Tipalni sistem ročno predpozicionirajte tako, da pri premiku na programirani predpoložaj ne more trčiti.
note-trigger-position-uncompensated = Vrednosti v parametrih od Q115 do Q119 ne upoštevajo dolžine in polmera tipalne glave.
note-no-log-for-reference-plane = Za ta cikel krmiljenje ne ustvari merilnega protokola.

# --- 444 ---
cycle-probing-3d = Tipanje 3D
    .nc = TIPANJE 3D
    .purpose = Preveri eno točko na površini obdelovanca, na primer na ploskvi proste oblike. Cikel ugotovi, ali je točka vzdolž normalnega vektorja nad želenim položajem ali pod njim, tako da lahko sledi na primer dodatna obdelava. Nadzoruje lahko toleranco, zapiše protokol, rezultate pa shrani v parametre.
step-position-on-normal = Tipalni sistem se s trenutnega položaja premakne na točko na normalnem vektorju. Njena razdalja od želenih koordinat je polmer tipalne krogle plus { $mp-set-up } plus { $q-probing-clearance }. Predpozicioniranje upošteva { -clearance-height(case: "accusative") } { $q-clearance-height }.
step-probe-nominal-point = Tipalni sistem se premakne proti želenim koordinatam. Pot tipanja določa { $mp-probing-distance }, ne pa normalni vektor; ta je namenjen samo pravilnemu izračunu koordinat.
step-return-and-store-position = Ko krmiljenje izmeri položaj, se { -probe(case: "nominative") } umakne in ustavi. Krmiljenje shrani izmerjene koordinate in odstopanja v parametre rezultatov.
step-retract-against-probing-direction = Krmiljenje premakne { -probe(case: "accusative") } nazaj, v smeri, nasprotni tipanju, za vrednost, določeno v parametru MB.
step-set-workpiece-status = Krmiljenje določi stanje obdelovanca Q183:
say-surface-status-undefined = −1 (nedoločeno), če { $q-tolerance-specification } ne določa tolerance
say-surface-needs-rework = 1 (dodatna obdelava), če je točka nad tolerančnim območjem
say-surface-is-scrap = 2 (izvržek), če je točka pod tolerančnim območjem
say-surface-is-good = 0 (dobro) v drugih primerih
step-write-surface-log = Krmiljenje ustvari protokol in ga shrani v obliki HTML.
step-react-to-tolerance-error = Krmiljenje se na točko zunaj tolerance odzove, kot določa { $q-tolerance-error-reaction }:
say-stop-below-nominal = pri { $q-tolerance-error-reaction } = 2 prikaže sporočilo in prekine program, če je točka pod želeno koordinato
result-position-main-actual = Izmerjeni položaj na glavni osi
result-position-minor-actual = Izmerjeni položaj na pomožni osi
result-position-tool-actual = Izmerjeni položaj na orodni osi
result-position-main-deviation = Izmerjeno odstopanje na glavni osi
result-position-minor-deviation = Izmerjeno odstopanje na pomožni osi
result-position-tool-deviation = Izmerjeno odstopanje na orodni osi
result-deviation-3d = Izmerjeno 3D-odstopanje; manj kot 0: premajhna mera, več kot 0: prevelika mera
result-workpiece-status = Stanje obdelovanca: −1 = nedoločeno, 0 = dobro, 1 = dodatna obdelava, 2 = izvržek
guard-zero-normal-vector = Vse komponente normalnega vektorja so 0.
guard-rotary-axes-askew = Položaji rotacijskih osi se ne ujemajo s koti vrtenja obdelovalne ravnine.
guard-mill-mode-only = Cikel je mogoče izvesti samo v načinu FUNCTION MODE MILL.
guard-surface-below-nominal = Točka je pod želeno koordinato in zunaj tolerance.
note-function-must-be-enabled = To funkcijo mora omogočiti in prilagoditi proizvajalec stroja. Upoštevajte priročnik za stroj.
note-mill-mode-only = Cikel je mogoče izvesti samo v načinu FUNCTION MODE MILL.
note-calibrate-in-3d = Za natančne rezultate { -probe(case: "accusative") } pred tem ciklom umerite s 3D-umerjanjem. To zahteva možnost 92, 3D-ToolComp.
note-surface-log-contents = Protokol vsebuje za glavno, pomožno in orodno os dejansko smer tipanja (vektor v vnosnem koordinatnem sistemu, dolg toliko kot konfigurirana pot tipanja), želeno in dejansko koordinato ter, če { $q-tolerance-specification } določa toleranco, zgornje in spodnje odstopanje in odstopanje vzdolž normalnega vektorja. Barva vrednosti kaže rezultat: zelena dobro, oranžna dodatno obdelavo, rdeča izvržek. Protokol vsebuje tudi 3D-odstopanje.
note-surface-log-directory = Krmiljenje shrani protokol kot datoteko HTML v imenik NC-programa, če je za FN 16 konfigurirana pot.
note-mirror-or-scaling-is-an-error = Krmiljenje prikaže sporočilo o napaki, če so ob aktiviranju cikla v veljavi zrcaljenje (cikel 8), faktor merila (cikel 11) ali faktor merila, specifičen za os (cikel 26).
note-tcpm-considered = Pri tipanju se upošteva aktivna funkcija TCPM. S TCPM je mogoče položaje otipati tudi, če se vrtenje { -working-plane(case: "genitive") } in rotacijske osi ne ujemajo.
note-track-with-controlled-spindle = Če ima stroj krmiljeno vreteno, v preglednici tipalnega sistema (stolpec { $mp-track }) aktivirajte usmeritev pod kotom. To na splošno izboljša natančnost merjenja s 3D-tipalnim sistemom.
note-coordinates-in-input-system = Vse koordinate cikla se nanašajo na vnosni koordinatni sistem.
note-results-in-parameters = Krmiljenje zapiše izmerjene vrednosti v parametre rezultatov.
note-status-independent-of-reaction = Stanje obdelovanca v Q183 (dobro, dodatna obdelava ali izvržek) se določi neodvisno od { $q-tolerance-error-reaction }.
note-normal-from-cad = Normalni vektor ({ $q-surface-normal-main }, { $q-surface-normal-minor }, { $q-surface-normal-tool }) je pravokoten na zamišljeno ravnino, v kateri ležijo želene koordinate, in je usmerjen stran od površine. Najbolje ga je prevzeti iz sistema CAD ali CAM.
note-normal-does-not-set-path = Normalni vektor ne določa poti tipanja.
note-tolerance-grammar = Primeri tolerance: pri vnosu "0.4-0.1" sega območje od 0,1 pod želeno koordinato do 0,4 nad njo, pri vnosu "0.4" od želene koordinate do 0,4 nad njo, pri vnosu "-0.1" od 0,1 pod želeno koordinato do te koordinate. Pri vnosih " ", "0" in "0.1+0.1" se toleranca ne nadzoruje.
note-tilting-angles-compared = Glede na strojni parameter chkTiltingAxes (št. 204600) krmiljenje med tipanjem preveri, ali se položaji rotacijskih osi ujemajo s koti vrtenja (3D ROT). Če se ne ujemajo, prikaže sporočilo o napaki.
note-adapt-nc-programs = NC-programi v primerih so predlogi. Pred uporabo stroju prilagodite orodja, rezalne vrednosti, pomike, varno višino ali varne položaje, položaje stroja (na primer z M91) in poti v priklicih programov. Programe, ki so odvisni od kinematike, prilagodite kinematiki stroja pred prvim preizkusom.
note-simulate-nc-programs = NC-program pred izvedbo preizkusite v simulaciji. Programski test pokaže, ali ga je mogoče uporabiti z razpoložljivimi programskimi možnostmi, aktivno kinematiko stroja in trenutno konfiguracijo stroja.
