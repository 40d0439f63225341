# Parameters of the cycles that save the kinematics, calibrate touch probes and digitize: name, label in the NC block, help.

# --- saved kinematics ---
parameter-kinematics-memory-mode = Način (0/1/2/3)
    .label = NAČIN
    .help = Določa, ali se kinematika shrani ali obnovi.
parameter-kinematics-memory-mode__itnc530 = Način (0/1/2)
choice-save-kinematics = shranjevanje kinematike
choice-save-kinematics__itnc530 = shranjevanje aktivne kinematike
choice-restore-kinematics = obnovitev shranjene kinematike
choice-show-saved-kinematics = prikaz trenutnega stanja pomnilnika
choice-delete-saved-kinematics = izbris niza podatkov
parameter-kinematics-memory-location = Oznaka pomnilnika
    .label = OZNAKA POMNILNIKA
    .label-aliases = MESTO POMNILNIKA
    .help = Številka ali ime niza podatkov, največ 16 znakov. Na voljo je 16 pomnilniških mest. V načinu 2 nima vpliva. V načinih 1 in 3 (obnovitev in izbris) lahko vsebuje nadomestne znake. Če nadomestnim znakom ustreza več nizov podatkov, se obnovijo srednje vrednosti njihovih podatkov (način 1) oziroma se po potrditvi vsi izbrišejo (način 3). Nadomestni znaki: ? je posamezen nedoločen znak, $ posamezna črka, # posamezna nedoločena števka, * poljubno dolg niz znakov.
parameter-kinematics-memory-location__itnc530 = Mesto pomnilnika (0…9)
    .label = MESTO POMNILNIKA
    .help = Številka pomnilniškega mesta, na katero se shrani celotna kinematika ali s katerega se shranjena kinematika obnovi. V načinu 2 nima vpliva.

# --- preset compensation ---
parameter-sphere-touch-points__preset-compensation = Število merilnih točk
    .help = Število tipanj, s katerimi krmiljenje izmeri umeritveno kroglo v ravnini.

# --- calibration of touch probes ---
parameter-calibration-sphere-probings = Število tipanj ravnine (4/3)
    .label = ŠTEVILO TIPANJ
    .help = Število merilnih točk na premeru.
parameter-calibration-ring-probings = ŠTEVILO TIPANJ
    .label = ŠTEVILO TIPANJ
    .help = Število merilnih točk na premeru.
parameter-kinematics-reference-angle__calibrate-in-ring = REFERENČNI KOT
    .help = Kot med glavno osjo obdelovalne ravnine in prvo tipalno točko.
parameter-kinematics-reference-angle__calibrate-on-stud = REFERENČNI KOT
    .help = Kot med glavno osjo obdelovalne ravnine in prvo tipalno točko.
parameter-length-calibration = Umeritev dolžine (0/1)
    .label = UMERJANJE DOLŽINE
    .help = Določa, ali krmiljenje po umerjanju polmera umeri tudi dolžino tipalnega sistema.
choice-no-length-calibration = brez umerjanja dolžine tipalnega sistema
choice-length-calibration = umerjanje dolžine tipalnega sistema
parameter-length-reference = Referenčna točka za dolžino
    .label = REFERENČNA TOČKA
    .help = Koordinata središča umeritvene krogle. Potrebna je samo, če se umerja dolžina.
parameter-length-reference__calibrate-probe-length = Referenčna točka
    .help = Referenca za dolžino, na primer višina nastavitvenega obroča.
parameter-calibration-ring-radius = POLMER KROGA
    .label = POLMER KROGA
    .help = Polmer nastavitvenega obroča.
parameter-calibration-stud-radius = POLMER ČEPOV
    .label = POLMER ČEPOV
    .help = Polmer čepa.
parameter-calibration-clearance-height = Varna višina
    .word = VIŠINA:
    .help = Koordinata na osi tipalnega sistema, na kateri tipalni sistem ne more trčiti v umeritveni element ali vpenjalo.
parameter-calibration-part-radius = Polmer umeritvenega obroča
    .help = Polmer umeritvenega elementa.
parameter-calibration-inside-or-outside = Notranje umerjanje=0/zunanje umerjanje=1
    .word = NAČIN MERJENJA:
    .help = Določa, ali krmiljenje umerja znotraj v obroču ali zunaj na čepu.
choice-calibrate-inside = notranje umerjanje
choice-calibrate-outside = zunanje umerjanje

# --- digitizing: the range ---
parameter-digitized-data-file = Ime PGM za podatke digitaliziranja
    .word = IME PGM:
    .help = Ime datoteke, v katero se shranijo podatki digitaliziranja.
parameter-digitized-data-file__digitize-range-from-points =
    .word = PGM DIGIT.:
parameter-digitizing-probe-axis = Os tipalnega sistema
    .help = Os tipalnega sistema.
parameter-digitizing-range-min = Točka MIN območja
    .figure = MIN
    .help = Najmanjša točka območja, ki se digitalizira, na treh oseh.
parameter-digitizing-range-max = Točka MAX območja
    .figure = MAX
    .help = Največja točka območja, ki se digitalizira, na treh oseh.
parameter-digitizing-clearance-height = Varna višina
    .word = VIŠINA:
    .help = Položaj na osi tipalnega sistema, na katerem tipalna glava in obdelovanec ne moreta trčiti.
parameter-digitizing-range-table = Ime PGM za podatke območja
    .word = PGM OBMOČJE:
    .help = Ime preglednice točk, ki določa območje.
parameter-probe-axis-min = Točka MIN osi tipalnega sistema
    .word = MIN:
    .help = Najmanjša točka območja, ki se digitalizira, na osi tipalnega sistema.
parameter-probe-axis-max = Točka MAX osi tipalnega sistema
    .word = MAX:
    .help = Največja točka območja, ki se digitalizira, na osi tipalnega sistema.

# --- digitizing: the lines ---
parameter-line-direction = Smer vrstic
    .word = SMER:
    .help = Koordinatna os obdelovalne ravnine, v katere pozitivni smeri se tipalni sistem premika od prve shranjene konturne točke.
parameter-line-direction__digitize-lines =
    .help = Koordinatna os obdelovalne ravnine, vzporedno s katero se premika tipalni sistem. Smer digitaliziranja določa tudi, ali bo poznejše rezkanje v soteku ali v protiteku.
parameter-line-direction__digitize-lines-analog =
    .help = Koordinatna os obdelovalne ravnine, vzporedno s katero se premika tipalni sistem. Smer digitaliziranja določa tudi, ali bo poznejše rezkanje v soteku ali v protiteku.
parameter-probing-angle = Tipalni kot
    .word = KOT:
    .help = Smer premikanja tipalnega sistema glede na smer vrstic.
parameter-probing-angle__digitize-lines-analog =
    .help = Smer premikanja tipalnega sistema glede na smer vrstic. Smer vrstic in tipalni kot skupaj omogočata poljubno smer digitaliziranja.
parameter-feed-reduction-height = Višina za zmanjšanje pomika
    .word = VIŠINA:
    .help = Koordinata na orodni osi, na kateri krmiljenje na začetku vsake vrstice preklopi s hitrega teka na pomik pri tipanju.
parameter-digitizing-time-limit = Časovna omejitev
    .word = ČAS:
    .help = Čas, v katerem mora tipalni sistem po enem obhodu znova doseči prvo tipalno točko plastnice. { $mp-contour-line-accuracy } določa, kako natančno mora biti prva tipalna točka dosežena. Če je čas prekoračen, krmiljenje prekine cikel digitaliziranja. Pri vrednosti 0 časovne omejitve ni.
parameter-contour-line-start = Začetna točka
    .help = Koordinate začetne točke v obdelovalni ravnini.
parameter-contour-line-approach = Os in smer primika
    .word = ZAPOREDJE:
    .help = Koordinatna os in smer, v kateri se tipalni sistem primakne k obdelovancu.
parameter-contour-line-direction = Začetna tipalna os in smer
    .word = /
    .help = Koordinatna os in smer, v kateri se tipalni sistem med digitaliziranjem premika vzdolž obdelovanca. Smer digitaliziranja določa tudi, ali bo poznejše rezkanje v soteku ali v protiteku.

# --- digitizing: feed rates, distances, tolerance ---
parameter-digitizing-feed = Pomik F
    .help = Hitrost digitaliziranja. Čim večja je, tem manj natančni so podatki digitaliziranja.
parameter-digitizing-first-line-feed = Pomik MIN.
    .help = Pomik za digitaliziranje prve vrstice.
parameter-digitizing-first-line-feed__digitize-contour-lines-analog =
    .help = Pomik za digitaliziranje prve plastnice.
parameter-least-line-spacing = MIN. razmik vrstic
    .word = MIN.RAZM.VRST:
    .help = Če je vnesena vrednost manjša od razmika vrstic, krmiljenje na strmih delih konture zmanjša razmik vrstic do te najmanjše vrednosti. Tako so točke enako goste tudi na zelo neenakomernih površinah.
parameter-least-line-spacing__digitize-contour-lines-analog =
    .help = Če je vnesena vrednost manjša od razmika vrstic, krmiljenje na ravnih delih konture zmanjša razmik vrstic do te najmanjše vrednosti. Tako so točke enako goste tudi na zelo neenakomernih površinah.
parameter-line-spacing = Razmik vrstic
    .word = RAZM.VRST:
    .help = Zamik tipalnega sistema na koncu vrstice, torej razdalja med dvema vrsticama.
parameter-signed-line-spacing = Razmik vrstic in smer
    .word = RAZM.VRST:
    .help = Zamik tipalnega sistema, ko doseže začetno točko plastnice. Predznak določa smer zamika.
parameter-point-spacing = MAX. razmik točk
    .word = RAZM.TOČK:
    .help = Največja razdalja med točkami, ki jih krmiljenje shrani. Poleg tega upošteva točke, ki so za obliko obdelovanca pomembne in kritične, na primer v notranjih vogalih.
parameter-point-spacing__digitize-lines =
    .help = Največja razdalja med točkami, ki jih krmiljenje shrani.
parameter-point-spacing__digitize-lines-analog =
    .help = Največja razdalja med točkami, ki jih krmiljenje shrani.
parameter-normal-retraction = Odmik v smeri normale na vrstico
    .word = POT:
    .help = Razdalja, za katero se tipalni sistem umakne, ko otipa točko obdelovanca. Priporočeno: med 0,5 · razmik točk in razmikom točk. Čim manjša je tipalna krogla, tem večja naj bo vrednost.
parameter-digitizing-tolerance = Tolerančna vrednost
    .word = TOL:
    .help = Krmiljenje ne shrani digitaliziranih točk, dokler razdalja med zadnjima tipalnima točkama ne preseže tolerančne vrednosti. Tako nastane na ukrivljenih konturah veliko točk, na ravnih pa malo. Pri vrednosti 0 krmiljenje izda točke v programiranem razmiku točk.
parameter-corner-feed-reduction = Zmanjšanje pomika v kotih
    .word = RAZD:
    .help = Na vprašanje odgovorite z NO ENT. Krmiljenje vrednost vnese samodejno.
parameter-corner-feed-reduction__digitize-lines-analog =
    .help = Razdalja od strmih sten, pri kateri krmiljenje začne zmanjševati pomik digitaliziranja.

parameter-probing-clearance__calibrate-in-ring = VARNOSTNA RAZDALJA
parameter-probing-clearance__calibrate-on-stud = VARNOSTNA RAZDALJA
parameter-traverse-to-clearance-height__calibrate-on-stud = PREMIK NA VARNO VIŠINO
