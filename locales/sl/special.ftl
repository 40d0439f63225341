# Special functions.

# --- 9 ---
cycle-dwell = Čas zadrževanja
    .nc = ČAS ZADRŽ.
    .purpose = Za čas zadrževanja zaustavi programski tek, na primer za lom ostružkov.
step-dwell-for-programmed-time = Krmiljenje za programirani čas zadrževanja zaustavi programski tek.
note-dwell-acts-from-definition = Cikel deluje od svoje definicije v programu naprej.
note-dwell-keeps-modal-states = Modalno delujoča stanja, na primer vrtenje vretena, ostanejo nespremenjena.

# --- 12 ---
cycle-program-call = Priklic programa
    .nc = PGM CALL
    .purpose = Poljuben program, na primer poseben vrtalni cikel ali geometrijski modul, izenači z obdelovalnim ciklom. Program se nato prikliče kot cikel.
step-call-program-as-cycle = Ob priklicu cikla krmiljenje izvede program.
note-program-becomes-cycle = Vnesite ime programa, ki naj se prikliče, po potrebi s potjo; ali pa z gumbom IZBIRA aktivirajte izbiro datoteke in izberite program.
note-called-program-on-hard-disk = Priklicani program mora biti shranjen na trdem disku krmiljenja.
note-called-program-in-same-directory = Če vnesete samo ime programa, mora biti program v istem imeniku kot program, ki ga kliče.
note-called-program-with-path = Če program ni v istem imeniku kot program, ki ga kliče, vnesite celotno pot.
note-called-iso-program = Če želite program DIN/ISO deklarirati kot cikel, za imenom programa vnesite vrsto datoteke .I.
note-q-parameters-act-globally = Q-parametri pri priklicu programa s tem ciklom vedno delujejo globalno. Spremembe Q-parametrov v priklicanem programu zato lahko vplivajo na program, ki ga kliče.
note-ways-to-call-the-program = Program prikličite s CYCL CALL (poseben stavek), z M99 (po stavkih) ali z M89 (izvede se po vsakem pozicionirnem stavku).
title-program-50-as-cycle = Program 50 kot cikel, priklican z M99

# --- 13 ---
cycle-spindle-orientation = Orientacija vretena
    .nc = ORIENTACIJA
    .purpose = Določi kot, na katerega krmiljenje zavrti glavno vreteno orodnega stroja.
step-keep-orientation-angle = Krmiljenje si zapomni kot za naslednjo orientacijo vretena.
step-program-m19-or-m20 = Programirajte M19 ali M20 (odvisno od stroja): krmiljenje nato vreteno pozicionira na kot, definiran v ciklu.
note-prepare-for-spindle-orientation = Proizvajalec stroja mora pripraviti stroj in krmiljenje.
note-orientation-is-needed-for = Orientacija vretena je potrebna na primer pri menjalnikih orodij z določenim položajem za menjavo orodja in za usmeritev oddajnega in sprejemnega okna 3D-tipalnih sistemov z infrardečim prenosom.
note-orientation-by-m19-or-m20 = Krmiljenje vreteno pozicionira na kot, definiran v ciklu, ko je programirana funkcija M19 ali M20 (odvisno od stroja).
note-orientation-without-cycle = Če M19 ali M20 programirate brez predhodne definicije tega cikla, krmiljenje glavno vreteno pozicionira na kot, ki ga je določil proizvajalec stroja (glejte priročnik za stroj).
note-orientation-used-by-cycles = Obdelovalni cikli 202, 204 in 209 ta cikel interno uporabljajo. Po enem od njih ga po potrebi programirajte znova.

# --- 32 ---
cycle-tolerance = Toleranca
    .nc = TOLERANCA
    .purpose = Vpliva na rezultat obdelave z veliko hitrostjo glede natančnosti, kakovosti površine in hitrosti, kolikor je krmiljenje prilagojeno stroju.
step-smooth-contour = Krmiljenje samodejno gladi konturo med poljubnimi konturnimi elementi, s popravkom ali brez njega. Orodje se zato po površini obdelovanca premika brez prekinitev, kar varuje mehaniko stroja.
step-reduce-feed-to-run-smoothly = Po potrebi krmiljenje programirani pomik zmanjša, tako da program vedno izvaja brez sunkov z največjo možno hitrostjo.
note-prepare-for-tolerance = Proizvajalec stroja mora pripraviti stroj in krmiljenje.
note-preset-tolerance-by-builder = Zaradi glajenja kontura odstopa. Odstopanje (tolerančno vrednost) je proizvajalec stroja določil v strojnem parametru. Cikel spremeni prednastavljeno tolerančno vrednost in izbere druge nastavitve filtra, če proizvajalec stroja te možnosti uporablja.
note-tolerance-is-always-used = Tudi kadar krmiljenje hitrosti ne zmanjša, vedno upošteva definirano toleranco. Čim večja je toleranca, tem hitreje se lahko krmiljenje premika.
note-tolerance-on-arcs = Toleranca, definirana v ciklu, deluje tudi pri premikih po krožnih lokih.
note-chord-error-of-cam = Pri izdelavi NC-programov s CAM-sistemom je najpomembnejši dejavnik napaka tetive S, ki jo je tam mogoče definirati. Določa največjo razdaljo med točkami NC-programa, ki ga izdela postprocesor. Če je napaka tetive enaka ali manjša od tolerančne vrednosti T tega cikla, lahko krmiljenje konturne točke gladi, razen če programirani pomik omejijo posebne nastavitve stroja.
note-best-smoothing = Glajenje je najboljše, če je tolerančna vrednost v ciklu med 1,1-kratno in 2-kratno napako tetive CAM-sistema.
note-very-small-tolerance = Pri zelo majhnih tolerančnih vrednostih stroj konture ne more več obdelati brez sunkov. Vzrok ni premajhna računska moč krmiljenja, temveč to, da krmiljenje prehode konture izvede skoraj natančno in mora zato hitrost premikanja morda močno zmanjšati.
note-tolerance-is-def-active = Cikel deluje od definicije naprej: veljaven je, takoj ko je v programu definiran.
note-reset-tolerance = Krmiljenje cikel ponastavi, če ga znova definirate in na vprašanje o tolerančni vrednosti odgovorite z NO ENT ali če s tipko PGM MGT izberete nov program. Po ponastavitvi je znova aktivna toleranca, prednastavljena s strojnim parametrom.
note-unit-of-tolerance = Krmiljenje vneseno tolerančno vrednost T v milimetrskem programu razume v milimetrih, v palčnem programu pa v palcih.
note-tolerance-alone-adds-zeros = Če naložite program, ki kot parameter cikla vsebuje samo tolerančno vrednost T, krmiljenje po potrebi doda preostala parametra z vrednostjo 0.
note-tolerance-changes-circle-diameter = Z večanjem tolerance se premer krožnih premikov praviloma zmanjšuje. Če je na stroju aktiven filter HSC (po potrebi vprašajte proizvajalca stroja), se lahko krog tudi poveča.
note-tolerance-in-status-display = Če je cikel aktiven, dodatni prikaz stanja na zavihku CYC kaže njegove parametre.
