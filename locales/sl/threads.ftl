# Tapping and thread milling.

# --- tapping ---
cycle-tapping = Vrtanje navojev (NOVO) z izravnalno vpenjalno glavo
    .nc = NOVO VRTANJE NAVOJEV
    .nc-aliases = VRTANJE NAVOJEV – NOVO
    .purpose = Z enim premikom izdela navoj z izravnalno vpenjalno glavo.
cycle-rigid-tapping = Vrtanje navojev GS brez izravnalne vpenjalne glave (NOVO)
    .nc = VRTANJE NAVOJEV GS NOVO
    .nc-aliases = VRTANJE NAVOJEV Z VIŠINO NAVOJA – NOVO | VRTANJE NAVOJEV BREZ IZRAVNALNE VPENJALNE GLAVE
    .purpose = Z enim premikom izdela navoj brez izravnalne vpenjalne glave.
cycle-tapping-with-chip-breaking = Vrtanje navojev z drobljenjem ostružkov
    .nc = VRTANJE NAVOJEV LOM OSTRUŽ.
    .nc-aliases = VRTANJE NAVOJEV Z DROBLJENJEM OSTRUŽKOV | VRTANJE NAVOJEV Z LOMOM OSTRUŽKOV
    .purpose = Z več primiki izdela navoj brez izravnalne vpenjalne glave. Parameter določa, ali orodje pri lomu ostružkov v celoti zapusti vrtino.
step-tap-in-one-movement = Orodje se z enim premikom premakne na globino navoja { $q-thread-depth }.
step-reverse-dwell-and-retract = Smer vrtenja vretena se obrne, po času zadrževanja { $q-dwell-at-bottom } pa se orodje umakne na varnostno razdaljo { $q-set-up-clearance }.
step-reverse-and-retract = Smer vrtenja vretena se obrne in orodje se umakne na varnostno razdaljo { $q-set-up-clearance }.
step-reverse-spindle-again = Na varnostni razdalji se smer vrtenja vretena znova obrne.
step-stop-spindle-at-set-up-clearance = Krmiljenje na varnostni razdalji zaustavi vreteno.
step-rapid-to-set-up-clearance-and-orient = Krmiljenje premakne orodje po osi vretena v hitrem teku (FMAX) na varnostno razdaljo { $q-set-up-clearance } nad površino obdelovanca in tam orientira vreteno na { $q-spindle-orientation-angle }.
step-tap-to-next-depth = Orodje se spusti globlje za primik { $q-depth-for-chip-breaking }.
step-reverse-and-break-chip = Smer vrtenja vretena se obrne, nato pa se za naslednji primik obrne znova. Vmes se orodje premakne nazaj (če je vnesen faktor { $q-retraction-speed-factor }, s številom vrtljajev, povečanim s tem faktorjem):
say-tap-leaves-hole = { $q-chip-breaking-turns } = 0: v celoti iz vrtine, zaradi hlajenja
say-tap-goes-back-some-turns = sicer za { $q-chip-breaking-turns }, pomnoženo s korakom navoja { $q-thread-pitch }
step-tap-back-to-set-up-clearance = Orodje se premakne nazaj na varnostno razdaljo { $q-set-up-clearance }.
note-sign-of-thread-depth = Predznak globine navoja { $q-thread-depth } določa smer obdelave. Pri globini navoja 0 krmiljenje cikla ne izvede.
note-thread-depth-gives-direction = Predznak globine navoja { $q-thread-depth } določa smer obdelave.
note-positive-thread-depth-reverses = Nevarnost kolizije! Pri pozitivni globini krmiljenje predpoložaj izračuna v nasprotni smeri: orodje se po orodni osi v hitrem teku premakne na varnostno razdaljo pod površino obdelovanca.
note-floating-tap-holder = Orodje mora biti vpeto v izravnalno vpenjalno glavo, ki med obdelavo izravnava tolerance pomika in števila vrtljajev.
note-overrides-while-tapping = Med izvajanjem cikla vrtljivi gumb za število vrtljajev ne deluje. Vrtljivi gumb za pomik deluje omejeno; kako, določi proizvajalec stroja (upoštevajte priročnik za stroj).
note-right-hand-with-m3 = Vreteno za desne navoje vklopite z M3, za leve navoje z M4.
note-feed-from-speed-and-pitch = Pomik določite z enačbo F = S × p. F: pomik (mm/min), S: število vrtljajev vretena (vrt/min), p: korak navoja (mm).
note-retract-after-interruption = Če med vrtanjem navoja pritisnete zunanjo tipko za zaustavitev, krmiljenje prikaže gumb, s katerim je mogoče orodje umakniti.
note-feed-follows-spindle-speed = Krmiljenje pomik izračuna iz števila vrtljajev vretena. Če med vrtanjem navoja zavrtite vrtljivi gumb za pomik, krmiljenje pomik prilagodi samodejno. Vrtljivi gumb za število vrtljajev ni aktiven.
note-spindle-stopped-after-tapping = Na koncu cikla vreteno miruje. Pred naslednjo obdelavo ga znova vklopite z M3 (ali M4).
note-retract-by-soft-key = Če med vrtanjem navoja pritisnete zunanjo tipko za zaustavitev, krmiljenje prikaže gumb ROČNI ODMIK. Ko ga pritisnete, lahko orodje nadzorovano umaknete s tipko za pozitivno smer aktivne osi vretena.
note-retraction-speed-is-limited = Če je v parametru { $q-retraction-speed-factor } definiran faktor števila vrtljajev za hitrejši umik, krmiljenje število vrtljajev omeji na najvišje, dovoljeno v aktivni stopnji gonila.

# --- thread milling: cycles ---
cycle-thread-milling = Rezkanje navojev
    .nc = REZKANJE NAVOJEV
    .purpose = Rezka navoj v predhodno izvrtan material.
cycle-thread-milling-countersinking = Rezkanje ugreznih navojev
    .nc = REZKANJE UGREZ. NAVOJA
    .nc-aliases = REZKANJE UGREZNIH NAVOJEV
    .purpose = Rezka navoj v predhodno izvrtan material in z grezenjem izdela posneti rob.
cycle-thread-drilling-milling = Rezkanje vrtalnih navojev
    .nc = VRTALNO REZKANJE NAVOJEV
    .nc-aliases = REZKANJE VRTALNIH NAVOJEV
    .purpose = Vrta v polni material in nato z istim orodjem rezka navoj.
cycle-helical-thread-drilling-milling = Vijačno rezkanje vrtalnih navojev
    .nc = VIJAČ. REZK. VRTAL. NAVOJEV
    .nc-aliases = VIJAČNO REZKANJE VRTALNIH NAVOJEV
    .purpose = Po vijačnici rezka navoj v polni material.
cycle-outside-thread-milling = Rezkanje zunanjih navojev
    .nc = REZK. ZUNAN. NAVOJEV
    .nc-aliases = REZKANJE ZUNANJIH NAVOJEV | REZKANJE ZUNANJEGA NAVOJA
    .purpose = Rezka zunanji navoj in z grezenjem izdela posneti rob.

# --- thread milling: steps ---
group-countersinking = Grezenje
group-countersinking-at-front = Čelno grezenje
group-drilling-the-hole = Vrtanje
group-milling-the-thread = Rezkanje navojev
step-feed-to-start-plane-of-threads = Orodje se s pomikom za predpozicioniranje { $q-in-and-out-feed } premakne na začetno ravnino, ki izhaja iz predznaka koraka navoja { $q-thread-pitch }, vrste rezkanja { $q-milling-type } in števila zavojev za povratek { $q-threads-per-step }.
step-feed-to-start-plane-of-thread = Orodje se s pomikom za predpozicioniranje { $q-in-and-out-feed } premakne na začetno ravnino navoja, ki izhaja iz predznaka koraka navoja { $q-thread-pitch } in vrste rezkanja { $q-milling-type }.
step-feed-to-start-plane-of-helix = Orodje se s pomikom za predpozicioniranje { $q-in-and-out-feed } premakne na začetno ravnino navoja.
step-approach-thread-and-compensate = Orodje se po vijačnici tangencialno premakne na premer navoja { $q-nominal-diameter }. Pri tem opravi tudi izravnalni premik po orodni osi, tako da se pot navoja začne v programirani začetni ravnini.
step-approach-thread = Orodje se po vijačnici tangencialno premakne na premer navoja { $q-nominal-diameter }.
step-approach-and-mill-one-turn = Orodje se po vijačnici tangencialno premakne na premer navoja { $q-nominal-diameter } in navoj rezka z vijačnim premikom za 360°.
step-mill-thread-in-turns = Orodje rezka navoj s pomikom { $q-milling-feed }, kot določa povratek { $q-threads-per-step }:
say-thread-in-one-turn = { $q-threads-per-step } = 0: z enim vijačnim premikom
say-thread-on-continuous-helix = { $q-threads-per-step } = 1: z neprekinjenim vijačnim premikom
say-thread-on-several-helices = { $q-threads-per-step } > 1: z več zamaknjenimi vijačnimi premiki
step-mill-thread-downwards = Krmiljenje premika orodje po neprekinjeni vijačnici navzdol do globine navoja { $q-thread-depth }.
step-depart-from-thread = Orodje se tangencialno odmakne od konture in se vrne na začetno točko v obdelovalni ravnini.
step-end-of-thread-milling = Na koncu cikla krmiljenje premakne orodje v hitrem teku:
step-feed-to-countersinking-depth = Če stranska varnostna razdalja { $q-clearance-to-wall } ni vnesena, se orodje s pomikom za predpozicioniranje { $q-in-and-out-feed } premakne na ugrezno globino { $q-countersinking-depth }, zmanjšano za varnostno razdaljo, in nato s pomikom pri grezenju { $q-countersinking-feed } na ugrezno globino.
step-feed-directly-to-countersinking-depth = Če je stranska varnostna razdalja { $q-clearance-to-wall } vnesena, krmiljenje orodje s pomikom za predpozicioniranje { $q-in-and-out-feed } takoj premakne na ugrezno globino { $q-countersinking-depth }.
step-countersink-on-circle = Glede na razpoložljivi prostor krmiljenje orodje mehko primakne iz središča ali s stranskim predpozicioniranjem in izvede krožni premik.
step-feed-to-depth-at-front = Orodje se s pomikom za predpozicioniranje { $q-in-and-out-feed } premakne na globino čelnega grezenja { $q-depth-at-front }.
step-feed-to-depth-at-front-before-or-after = Če je grezenje pred obdelavo navoja ({ $q-countersinking-moment } = 0), se orodje s pomikom pri grezenju { $q-countersinking-feed } premakne na globino čelnega grezenja { $q-depth-at-front }; če je po obdelavi navoja, s pomikom za predpozicioniranje { $q-in-and-out-feed }.
step-countersink-at-front = Krmiljenje brez popravka polmera premakne orodje v polkrogu iz središča na čelni zamik { $q-offset-at-front } in izvede krožni premik s pomikom pri grezenju { $q-countersinking-feed }.
step-countersink-at-front__thread-drilling-milling = Krmiljenje brez popravka polmera premakne orodje v polkrogu iz središča na čelni zamik { $q-offset-at-front } in izvede krožni premik s pomikom { $q-plunging-feed }.
step-leave-countersink-at-front = Krmiljenje v polkrogu vrne orodje v središče vrtine.
step-leave-countersink-at-front__outside-thread-milling = Krmiljenje v polkrogu vrne orodje na začetno točko.
step-countersink-after-thread = Če je grezenje po obdelavi navoja ({ $q-countersinking-moment } = 1), se izvede zdaj, kot je opisano zgoraj.
step-drill-towards-plunging-depth = Orodje vrta s pomikom { $q-plunging-feed } proti globini primika { $q-plunging-depth }; pri lomu ostružkov se ustavi vsakič, ko je za { $q-depth-for-chip-breaking } globlje.
step-retract-to-break-chip = Za lom ostružkov se orodje umakne za { $q-chip-breaking-retraction }.
step-retract-and-return-to-one-stop-distance = Krmiljenje umakne orodje v hitrem teku na varnostno razdaljo in ga v hitrem teku (FMAX) vrne na razdaljo zadrževanja { $q-upper-advanced-stop-distance } nad doseženo globino.
until-hole-depth-reached = ni dosežena globina vrtanja { $q-total-hole-depth }
step-move-beside-stud = Krmiljenje premakne orodje iz središča čepa po glavni osi obdelovalne ravnine na začetno točko čelnega grezenja. Njen položaj izhaja iz polmera navoja, polmera orodja in koraka.
step-move-beside-stud-without-countersinking = Če čelnega grezenja ni, krmiljenje premakne orodje na začetno točko rezkanja navoja, ki je ista kot pri čelnem grezenju.

# --- thread milling: conditions and guards ---
guard-no-depth-entered = Vse globine so 0, zato se nič ne obdela.
guard-depth-signs-differ = Globine imajo različne predznake. Za vse vnesite enak predznak.
guard-thread-near-countersinking-depth = Globina navoja mora biti najmanj za tretjino koraka manjša od ugrezne globine.
guard-thread-near-hole-depth = Globina navoja mora biti najmanj za tretjino koraka manjša od globine vrtanja.

# --- thread milling: notes ---
note-thread-approach-on-half-circle = Primik na premer navoja poteka v polkrogu iz središča navzven. Če premer orodja znaša le četrtino premera navoja, se orodje stransko predpozicionira.
note-compensation-before-approach = Pred primikom krmiljenje po orodni osi opravi izravnalni premik, ki je dolg največ pol koraka navoja. Poskrbite za dovolj prostora v vrtini.
note-thread-depth-moves-start = Če se globina navoja spremeni, krmiljenje začetno točko vijačnega premika spremeni samodejno.
note-depths-give-direction = Smer obdelave določajo predznaki parametrov globine, in sicer v tem zaporedju: 1. globina navoja { $q-thread-depth }, 2. ugrezna globina { $q-countersinking-depth }, 3. čelna globina { $q-depth-at-front }.
note-depths-give-direction__thread-drilling-milling = Smer obdelave določajo predznaki parametrov globine, in sicer v tem zaporedju: 1. globina navoja { $q-thread-depth }, 2. globina vrtanja { $q-total-hole-depth }, 3. čelna globina { $q-depth-at-front }.
note-two-depths-give-direction = Smer obdelave določajo predznaki parametrov globine, in sicer v tem zaporedju: 1. globina navoja { $q-thread-depth }, 2. čelna globina { $q-depth-at-front }.
note-depth-zero-leaves-out-step = Če je za katero od globin vnesena vrednost 0, krmiljenje tega koraka ne izvede.
note-no-countersinking-depth-for-front = Za čelno grezenje ugrezno globino { $q-countersinking-depth } definirajte kot 0.
note-thread-depth-above-countersinking-depth = Vnesite globino navoja { $q-thread-depth }, ki je najmanj za tretjino koraka navoja manjša od ugrezne globine { $q-countersinking-depth }.
note-thread-depth-above-hole-depth = Vnesite globino navoja { $q-thread-depth }, ki je najmanj za tretjino koraka navoja manjša od globine vrtanja { $q-total-hole-depth }.
note-helix-goes-into-workpiece = Vrsta rezkanja (sotek ali protitek) izhaja iz navoja (desni ali levi) in smeri vrtenja orodja, saj je mogoča samo smer obdelave s površine obdelovanca v obdelovanec.
note-position-over-stud-centre = Programirajte pozicionirni stavek na začetno točko (središče čepa) v obdelovalni ravnini s popravkom polmera R0.
note-offset-at-front-determined-before = Zamik za čelno grezenje določite pred uporabo cikla. Vnesite ga kot razdaljo od središča čepa do središča orodja (vrednost brez popravka).
note-internal-coolant-for-thread-milling = Stroj naj ima notranje hlajenje skozi vreteno: hladilo najmanj 30 barov, stisnjeni zrak najmanj 6 barov.
note-profile-correction-by-delta-radius = Pri rezkanju navojev se profil navoja pogosto popači, zato so potrebni popravki za posamezno orodje. Navedeni so v katalogu orodij ali pa jih navede proizvajalec orodja. Popravek se vnese v stavek TOOL CALL z vrednostjo delta { $mp-delta-radius }.
note-clockwise-tools-only = Cikel je mogoče uporabljati samo z orodji, ki se vrtijo v smeri urnega kazalca.
note-tools-of-both-rotations = Cikel je mogoče uporabljati z orodji, ki se vrtijo v smeri urnega kazalca, in z orodji, ki se vrtijo v nasprotni smeri.
note-direction-of-inside-thread = Smer obdelave je odvisna od predznaka koraka navoja { $q-thread-pitch } in od vrste rezkanja { $q-milling-type }. Z orodjem, ki se vrti v smeri urnega kazalca, se notranji navoj rezka v smeri Z+, če je desni (+) in rezkan v soteku (+1, RL) ali levi (−) in rezkan v protiteku (−1, RR), v smeri Z− pa, če je desni (+) in rezkan v protiteku (−1, RR) ali levi (−) in rezkan v soteku (+1, RL).
note-direction-of-outside-thread = Smer obdelave je odvisna od predznaka koraka navoja { $q-thread-pitch } in od vrste rezkanja { $q-milling-type }. Z orodjem, ki se vrti v smeri urnega kazalca, se zunanji navoj rezka v smeri Z−, če je desni (+) in rezkan v soteku (+1, RL) ali levi (−) in rezkan v protiteku (−1, RR), v smeri Z+ pa, če je desni (+) in rezkan v protiteku (−1, RR) ali levi (−) in rezkan v soteku (+1, RL).
note-feed-of-cutting-edge = Pri rezkanju navojev programirani pomik velja za rezilo orodja. Krmiljenje prikazuje pomik središča orodja, zato se prikazana vrednost razlikuje od programirane.
note-mirroring-turns-thread = Smer navoja se spremeni, če se cikel izvede pri zrcaljenju (cikel 8) samo ene osi.
note-same-signs-of-depths = Nevarnost kolizije! Za vse globine vedno vnesite enak predznak, ker cikli vsebujejo več potekov, ki niso odvisni drug od drugega. Če želite na primer ponoviti samo grezenje, za globino navoja vnesite 0; smer obdelave tedaj določa ugrezna globina.
note-same-signs-of-depths__outside-thread-milling = Nevarnost kolizije! Za vse globine vedno vnesite enak predznak, ker cikli vsebujejo več potekov, ki niso odvisni drug od drugega. Če želite na primer ponoviti samo čelno grezenje, za globino navoja vnesite 0; smer obdelave tedaj določa čelna globina.
note-tool-breakage-in-thread = Če se orodje med rezanjem navoja zlomi: zaustavite programski tek, preklopite v način Pozicioniranje z ročnim vnosom in orodje premočrtno premaknite v središče vrtine. Nato ga po osi primika umaknite in zamenjajte.
note-tool-breakage-in-thread__outside-thread-milling = Če se orodje med rezanjem navoja zlomi: zaustavite programski tek, preklopite v način Pozicioniranje z ročnim vnosom in orodje premočrtno odmaknite od navoja. Nato ga po osi primika umaknite in zamenjajte.
