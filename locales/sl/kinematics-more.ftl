# Cycles that save the kinematics and compensate the preset.

# --- 450 ---
cycle-save-kinematics = Shranjevanje kinematike
    .nc = SHRANJEVANJE KINEMATIKE
    .purpose = Shrani aktivno kinematiko stroja ali obnovi prej shranjeno kinematiko. Shranjene podatke je mogoče prikazati in izbrisati.
cycle-save-kinematics__itnc530 =
    .purpose = Shrani aktivno kinematiko stroja, obnovi prej shranjeno kinematiko ali pa na zaslonu in v protokolu prikaže trenutno stanje pomnilnika.
condition-memory-location-used = { $q-kinematics-memory-mode } ni 2
step-treat-saved-kinematics = Krmiljenje kinematiko obravnava, kot določa način { $q-kinematics-memory-mode }:
say-save-active-kinematics = 0: aktivno kinematiko shrani pod { $q-kinematics-memory-location }
say-restore-saved-kinematics = 1: obnovi kinematiko, shranjeno pod { $q-kinematics-memory-location }
say-show-saved-kinematics = 2: prikaže trenutno stanje pomnilnika
say-delete-saved-kinematics = 3: izbriše nize podatkov, ki jih navaja { $q-kinematics-memory-location }
note-save-before-optimization = Pred optimiranjem kinematike vedno shranite aktivno kinematiko.
note-kinematics-memory-size = Na voljo je 16 pomnilniških mest.
note-kinematics-memory-size__itnc530 = Na voljo je 10 pomnilniških mest s številkami od 0 do 9.
note-restore-only-into-identical-kinematics = V načinu obnovitve lahko krmiljenje shranjene podatke zapiše samo v enak opis kinematike.
note-preset-changes-with-kinematics__save-kinematics = Sprememba kinematike in s tem tudi njena obnovitev vedno spremeni tudi prednastavitev. Po potrebi prednastavitev določite znova.
note-kinematics-memory-wildcards = Če nadomestnim znakom v parametru { $q-kinematics-memory-location } ustreza več nizov podatkov, krmiljenje obnovi srednje vrednosti njihovih podatkov (način 1) oziroma jih po potrditvi vse izbriše (način 3).
note-kinematics-memory-file = Krmiljenje shranjene podatke hrani v datoteki TNC:\table\DATA450.KD. To datoteko je mogoče, na primer s programom TNCremo, varnostno kopirati v zunanji računalnik, da jo je po okvari diska mogoče obnoviti. Če se datoteka izbriše, so shranjeni podatki izgubljeni. Če je ni, jo krmiljenje ustvari ob izvedbi cikla 450.
note-kinematics-memory-file-by-hand = Shranjenih podatkov v datoteki TNC:\table\DATA450.KD ne spreminjajte ročno: nizi podatkov se lahko poškodujejo in postanejo neuporabni.
note-kinematics-memory-code-number = V načinu shranjevanja krmiljenje vedno shrani tudi številko ključa, ki je bila nazadnje vnesena pod MOD; določite lahko poljubno številko ključa. Pomnilniško mesto je nato mogoče prepisati samo z vnosom te številke.
note-overwritten-without-question = Če je bila kinematika shranjena brez številke ključa, krmiljenje njeno pomnilniško mesto pri naslednjem shranjevanju prepiše brez vprašanja.
note-kinematics-memory-log-contents = Po ciklu 450 krmiljenje ustvari protokol (TCHPR450.TXT). Vsebuje datum in čas, pot NC-programa, način (0=shranjevanje/1=obnovitev/2=stanje pomnilnika/3=izbris), oznako aktivne kinematike in vneseno oznako niza podatkov. Način 0 doda vse vnose osi in transformacij shranjene kinematične verige, način 1 vse vnose transformacij pred obnovitvijo in po njej, način 2 seznam shranjenih nizov podatkov, način 3 seznam izbrisanih nizov.
note-kinematics-memory-log-contents__itnc530 = Po ciklu 450 krmiljenje ustvari protokol (TCHPR450.TXT). Vsebuje datum in čas, pot NC-programa, način (0=shranjevanje/1=obnovitev/2=stanje pomnilnika), številko pomnilniškega mesta (od 0 do 9), številko vrstice kinematike v preglednici kinematike in številko ključa, če je bila vnesena neposredno pred ciklom 450. Način 0 doda vse vnose osi in transformacij shranjene kinematične verige, način 1 vse vnose transformacij pred obnovitvijo in po njej, način 2 na zaslonu in v protokolu seznam trenutnega stanja pomnilnika s pomnilniškim mestom, številkami ključa, številko kinematike in datumom shranjevanja.
title-save-active-kinematics = Shranjevanje aktivne kinematike
title-restore-saved-kinematics = Obnovitev nizov podatkov
title-show-saved-kinematics = Prikaz vseh shranjenih nizov podatkov
title-delete-saved-kinematics = Izbris nizov podatkov
title-save-before-calibration = Shranjevanje kinematike pred programom za umerjanje
table-kinematics-memory = Shranjene kinematike

# --- 452 ---
cycle-preset-compensation = Kompenzacija prednastavitve
    .nc = IZRAVNAVA PREDNASTAVITVE
    .nc-aliases = KOMPENZACIJA PREDNASTAVITVE
    .purpose = Optimira kinematično transformacijsko verigo stroja. Krmiljenje nato v kinematičnem modelu popravi tudi koordinatni sistem obdelovanca, tako da je prednastavitev po optimiranju v središču umeritvene krogle. Tako je mogoče medsebojno uskladiti menjalne glave ali izravnati zdrs stroja.
group-match-interchangeable-heads = Uskladitev menjalnih glav
group-compensate-drift = Izravnava zdrsa, če lahko umeritvena krogla med obdelavo ostane na mizi stroja
group-measure-and-compensate = Meritev in izravnava
step-clamp-calibration-sphere = Vpnite umeritveno kroglo.
step-measure-reference-head = Referenčno glavo v celoti izmerite s ciklom 451; cikel 451 naj prednastavitev določi v središču krogle.
step-insert-second-head = Vstavite drugo glavo.
step-measure-second-head = S ciklom { $cycle } izmerite menjalno glavo do vmesnika za menjavo glave.
step-match-further-heads = Nadaljnje menjalne glave uskladite z referenčno glavo s ciklom { $cycle }.
step-set-preset-in-sphere = Določite prednastavitev v umeritveni krogli.
step-set-preset-on-workpiece = Določite prednastavitev na obdelovancu in začnite obdelavo.
step-compensate-at-intervals = S ciklom { $cycle } v enakomernih časovnih presledkih izravnavajte prednastavitev: krmiljenje ugotovi zdrs udeleženih osi in ga popravi v kinematiki.
step-optimize-transformation-chain = Krmiljenje optimira kinematično transformacijsko verigo stroja.
step-correct-workpiece-system = Krmiljenje v kinematičnem modelu popravi koordinatni sistem obdelovanca, tako da je prednastavitev v središču umeritvene krogle.
note-datum-in-sphere-first__preset-compensation = Pred definicijo cikla določite in aktivirajte referenčno točko v središču umeritvene krogle.
note-one-degree-before-limit-switch = Pri oseh brez ločenega merilnika položaja merilne točke izberite tako, da do končnega stikala ostane 1° poti. Krmiljenje to pot potrebuje za notranjo izravnavo zračnosti.
note-kinematics-limit-exceeded__preset-compensation = Če kinematični podatki presežejo dovoljeno mejo ({ $mp-max-modification }), krmiljenje prikaže opozorilo. Prevzem vrednosti potrdite z NC-zagonom.
note-match-heads-purpose = Z uskladitvijo menjalnih glav ostane prednastavitev obdelovanca po menjavi rotacijskih osi (glav) nespremenjena. Eno od glav vstavite kot referenčno, vpnite umeritveno kroglo, vstavite tipalni sistem, s ciklom 451 izmerite celotno kinematiko in po meritvi določite prednastavitev (Q431 = 2 ali 3). Nato vstavite naslednjo glavo in tipalni sistem ter jo izmerite s ciklom { $cycle }. Enako lahko uskladite vse druge glave.
note-match-heads-only-changed-axes = Izmerite samo osi, ki se v resnici zamenjajo. Primer: viličasta glava z osema A in C, od katerih se zamenja samo os A; os C se izpusti s { $q-rotary-measuring-points-c } = 0.
note-preset-and-sphere-stay = Prednastavitev in položaj umeritvene krogle se med celotnim postopkom ne smeta spremeniti.
note-drift-purpose = Med obdelavo se sestavni deli stroja zaradi spreminjajočih se razmer v okolici premikajo. Če je zdrs v območju premikanja dovolj enakomeren in lahko umeritvena krogla ostane na mizi stroja, ga cikel { $cycle } ugotovi in izravna. Vpnite umeritveno kroglo, vstavite tipalni sistem, pred začetkom obdelave s ciklom 451 izmerite celotno kinematiko in po meritvi določite prednastavitev (Q431 = 2 ali 3), nato določite prednastavitve obdelovancev in začnite obdelavo. V enakomernih časovnih presledkih vstavite tipalni sistem, aktivirajte prednastavitev v umeritveni krogli in s ciklom { $cycle } izmerite kinematiko.
note-drift-without-rotary-axes = Zdrs je mogoče izravnati tudi na strojih brez rotacijskih osi.
note-kinematics-prepared-for-preset = Kinematika mora biti pripravljena za izravnavo prednastavitve. Upoštevajte priročnik za stroj.
note-head-change-is-machine-function = Menjava glave je funkcija stroja. Upoštevajte priročnik za stroj.
note-kinematics-log-contents__preset-compensation = Protokol vsebuje datum in čas, pot NC-programa, številko aktivne kinematike in vneseni polmer krogle; za vsako izmerjeno rotacijsko os pa: začetni kot, končni kot, naklonski kot, število merilnih točk, razpršitev (standardno odstopanje), največjo napako, napako kota, povprečno zračnost, povprečno pozicionirno napako, polmer merilnega kroga, popravke po vseh oseh (zamik prednastavitve) in merilno nenatančnost za rotacijske osi.
note-kinematics-log-contents__preset-compensation__itnc530 = Protokol vsebuje datum in čas, pot NC-programa, številko aktivne kinematike in vneseni polmer krogle; za vsako izmerjeno rotacijsko os pa: začetni kot, končni kot, naklonski kot, število merilnih točk, razpršitev (standardno odstopanje), največjo napako, napako kota, povprečno zračnost, povprečno pozicionirno napako, polmer merilnega kroga, popravke po vseh oseh (zamik prednastavitve), oceno merilnih točk in merilno nenatančnost za rotacijske osi.
note-kinematics-log-explained__preset-compensation = Izmerjena razpršitev: 68,3{"\u00A0"}% izmerjenih prostorskih napak leži znotraj ± te vrednosti; optimirana: 68,3{"\u00A0"}% napak, pričakovanih po popravku. Ocena merilnih točk je merilo kakovosti merilnih položajev glede na spremenljive transformacije modela: čim višja je, tem boljše je optimiranje. Za nobeno rotacijsko os naj ne bo manjša od 2, bolje je 4 ali več; če je majhna, povečajte merilno območje osi ali število točk. Če to ne pomaga, je morda napačen opis kinematike; po potrebi se obrnite na servisno službo.
title-compensate-preset = Program za umerjanje
title-match-interchangeable-head = Uskladitev menjalne glave
title-compensate-drift = Izravnava zdrsa

# --- kinematics ---
message-backlash-angle-too-small = Izmerjena zračnost ni veliko manjša od kota v { $q-backlash-angle }, zato je lahko večja od izmerjene. Vnesite večji kot in merite znova.
message-kinematics-limit-exceeded = Podatki o kinematiki se spremenijo za več, kot dovoljuje mejna vrednost. Prevzem potrdite z NC-zagonom.
message-delete-saved-kinematics = Imenu ustreza več shranjenih kinematik. Potrdite, da se izbrišejo vse.
