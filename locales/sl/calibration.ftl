# Cycles that calibrate touch probes.

# --- 460 ---
cycle-calibrate-on-sphere = Umerjanje tipalnega sistema
    .nc = UMERJANJE TIPAL. SIST.
    .purpose = Samodejno umeri stikalni 3D-tipalni sistem z natančno umeritveno kroglo: samo polmer ali polmer in dolžino.
condition-length-calibration-wanted = je { $q-length-calibration } = 1
step-position-probe-over-sphere = Tipalni sistem pozicionirajte po osi tipalnega sistema nad umeritveno kroglo in v obdelovalni ravnini v središče krogle.
step-approach-sphere-downwards = Prvi premik v ciklu poteka v negativni smeri osi tipalnega sistema.
step-find-sphere-centre = Krmiljenje določi natančno središče krogle na osi tipalnega sistema.
step-calibrate-radius-on-sphere = Krmiljenje umeri polmer s tipanji v ravnini; njihovo število določa { $q-calibration-sphere-probings }. Med merilnimi točkami se tipalni sistem premika:
say-travel-at-clearance-height-between-points = pri { $q-traverse-to-clearance-height } = 1 na varni višini
say-travel-at-measuring-height-between-points = pri { $q-traverse-to-clearance-height } = 0 na merilni višini
step-calibrate-length-on-sphere = Po umerjanju polmera krmiljenje obravnava dolžino, kot določa { $q-length-calibration }:
say-length-from-sphere-centre = pri { $q-length-calibration } = 1 umeri dolžino; { $q-length-reference } je koordinata središča krogle
say-length-unchanged = pri { $q-length-calibration } = 0 dolžine ne umeri
step-store-calibration-values = Krmiljenje shrani umeritvene vrednosti. Veljajo takoj.
note-position-above-sphere-in-program = V programu tipalni sistem pozicionirajte tako, da je približno nad središčem krogle.
note-effective-length-reference = Dejanska dolžina tipalnega sistema se vedno nanaša na referenčno točko orodja. Proizvajalec stroja referenčno točko orodja praviloma določi na nosu vretena.
note-when-to-calibrate = Tipalni sistem vedno umerite ob prvem zagonu, po zlomu ali zamenjavi tipalne glave, po spremembi pomika pri tipanju, v posebnih okoliščinah, na primer če se stroj segreje, in po spremembi aktivne orodne osi.
note-when-to-calibrate__tnc426-430 = Tipalni sistem vedno umerite ob prvem zagonu, po zlomu ali zamenjavi tipalne glave, po spremembi pomika pri tipanju in v posebnih okoliščinah, na primer če se stroj segreje.
note-known-ring-or-stud = Z umerjanjem se določita dejanska dolžina tipalne glave in dejanski polmer tipalne krogle. Za umerjanje na mizo stroja vpnite nastavitveni obroč ali čep z znano višino in znanim polmerom.
note-known-ring-or-stud__tnc426-430 = Z umerjanjem se določita dejanska dolžina tipalne glave in dejanski polmer tipalne krogle. Za umerjanje na mizo stroja postavite nastavitveni obroč z znano višino in znanim notranjim polmerom.
note-calibration-values-at-once = Umeritvene vrednosti po umerjanju takoj veljajo za aktivni tipalni sistem. Orodja ni treba znova priklicati.
note-calibration-values-in-tables = Krmiljenje dejansko dolžino in dejanski polmer tipalnega sistema shrani v preglednico orodij, njegov sredinski zamik pa v stolpca { $mp-probe-offset-main } (glavna os) in { $mp-probe-offset-minor } (pomožna os) preglednice tipalnega sistema. Gumb za preglednico tipalnega sistema prikaže shranjene vrednosti.
note-right-tool-number-for-probe = Pri uporabi tipalnega sistema mora biti aktivna prava številka orodja, ne glede na to, ali se cikel tipalnega sistema izvaja samodejno ali ročno.

# --- 461 ---
cycle-calibrate-probe-length = Umerjanje dolžine tipalnega sistema
    .nc = UMERJANJE DOLŽINE TIPALNEGA SISTEMA
    .purpose = Umeri dejansko dolžino stikalnega 3D-tipalnega sistema na ploskvi znane višine, na primer na nastavitvenem obroču.
step-prepare-length-calibration = Pred začetkom cikla določite referenčno točko na osi vretena tako, da je na mizi stroja Z = 0, in pozicionirajte tipalni sistem nad umeritveni obroč.
step-orient-to-calibration-angle = Če je tipalni sistem mogoče usmeriti, ga krmiljenje usmeri na kot { $mp-probe-calibration-angle } iz preglednice tipalnega sistema.
step-probe-down-from-here = Krmiljenje s trenutnega položaja izvede tipanje v negativni smeri osi vretena s pomikom pri tipanju (stolpec { $mp-probing-feed }).
step-return-to-start-of-calibration = Krmiljenje v hitrem teku (stolpec { $mp-positioning-feed }) pozicionira tipalni sistem nazaj na začetni položaj.
step-store-probe-length = Krmiljenje dejansko dolžino shrani v preglednico orodij.

# --- 462 and 463 ---
cycle-calibrate-in-ring = Umerjanje notranjega polmera tipalnega sistema
    .nc = UMERJANJE TIPAL. SIST. V OBROČU
    .purpose = V umeritvenem obroču umeri dejanski polmer krogle stikalnega 3D-tipalnega sistema in njegov sredinski zamik, če tipalni sistem to omogoča.
cycle-calibrate-on-stud = Umerjanje zunanjega polmera tipalnega sistema
    .nc = UMERJANJE TIPAL. SIST. NA ČEPIH
    .purpose = Na čepu ali umeritvenem trnu umeri dejanski polmer krogle stikalnega 3D-tipalnega sistema in njegov sredinski zamik, če tipalni sistem to omogoča.
step-pre-position-in-ring = Pred začetkom cikla tipalni sistem predpozicionirajte v središče umeritvenega obroča in na želeno merilno višino.
step-pre-position-over-stud = Pred začetkom cikla tipalni sistem predpozicionirajte na sredino nad umeritveni trn, na osi tipalnega sistema približno za varnostno razdaljo nad njim (vrednost iz stolpca { $mp-set-up } + { $q-probing-clearance }).
step-rough-measurement-of-part = V prvem prehodu krmiljenje določi središče umeritvenega obroča (groba meritev) in pozicionira tipalni sistem v središče.
step-rough-measurement-of-part__calibrate-on-stud = V prvem prehodu krmiljenje določi središče čepa ali umeritvenega trna (groba meritev) in pozicionira tipalni sistem v središče.
step-fine-measurement-of-part = Nato dejansko umerjanje (fina meritev) določi polmer tipalne krogle.
step-travel-between-calibration-points = Med merilnimi točkami se tipalni sistem premika:
step-reverse-measurement = Če je tipalni sistem mogoče usmeriti v dve smeri ali v poljubno smer, ga krmiljenje zasuka za 180° in izvede še štiri tipanja. S to meritvijo se določi tudi sredinski zamik.
step-store-radius-and-offset = Krmiljenje dejanski polmer tipalne krogle shrani v stolpec { $mp-tool-radius } preglednice orodij, sredinski zamik pa v stolpca { $mp-probe-offset-main } in { $mp-probe-offset-minor } preglednice tipalnega sistema.
guard-too-few-calibration-points = Potrebna so vsaj tri tipanja: { $q-calibration-ring-probings } je premajhen.
guard-too-few-calibration-points__calibrate-on-sphere = Potrebna so vsaj tri tipanja: { $q-calibration-sphere-probings } je premajhen.
note-orientation-decides-calibration = Potek umerjanja je odvisen od tega, kako je mogoče usmeriti tipalni sistem. Če ga ni mogoče usmeriti ali ga je mogoče usmeriti samo v eno smer, krmiljenje izvede grobo in fino meritev ter določi dejanski polmer tipalne krogle. Če ga je mogoče usmeriti v dve smeri (na primer kabelski tipalni sistemi HEIDENHAIN), krmiljenje izvede grobo in fino meritev, tipalni sistem zasuka za 180° in izvede še štiri tipanja, ki poleg polmera določijo sredinski zamik. Če ga je mogoče usmeriti v poljubno smer (na primer infrardeči tipalni sistemi HEIDENHAIN), poteka umerjanje enako kot pri dveh smereh.
note-centre-offset-needs-suitable-probe = Sredinski zamik je mogoče določiti samo s primernim tipalnim sistemom.
note-centre-offset-prepared = Proizvajalec stroja mora krmiljenje pripraviti za določanje sredinskega zamika tipalne glave. Upoštevajte priročnik za stroj.
note-orientation-predefined = Pri tipalnih sistemih HEIDENHAIN je vnaprej določeno, ali in kako jih je mogoče usmeriti. Druge tipalne sisteme konfigurira proizvajalec stroja.

# --- 2 ---
cycle-calibrate-touch-probe = Umerjanje stikalnega tipalnega sistema
    .nc = UMERJANJE TS
    .purpose = Samodejno umeri stikalni tipalni sistem v umeritvenem obroču ali na umeritvenem čepu.
step-rise-to-clearance-height = Če je trenutni položaj pod varno višino, se tipalni sistem v hitrem teku (vrednost iz { $mp-positioning-feed } ali { $mp-analog-positioning-feed }) premakne nanjo.
step-position-over-calibration-part = Krmiljenje pozicionira tipalni sistem v obdelovalni ravnini:
say-near-first-touch-point = v bližino prve tipalne točke (zunanje umerjanje)
say-at-centre-of-ring = v središče umeritvenega obroča (notranje umerjanje)
step-probe-calibration-part = Tipalni sistem se premakne na merilno globino, ki izhaja iz strojnih parametrov { $mp-calibration-part-centre }.2 (v drugih območjih premikanja { $mp-calibration-part-centre-2 }.2, { $mp-calibration-part-centre-3 }.2) in { $mp-calibration-part-depth }.x, in umeritveni element zaporedoma otipa v smereh X+, Y+, X− in Y−.
step-retract-and-store-ball-radius = Krmiljenje umakne tipalni sistem na varno višino in dejanski polmer tipalne krogle zapiše med umeritvene podatke.
note-calibration-part-centre-known = Pred umerjanjem v strojnih parametrih od { $mp-calibration-part-centre }.0 do { $mp-calibration-part-centre }.2 definirajte središče umeritvenega elementa v delovnem prostoru stroja (koordinate REF).
note-calibration-part-per-traverse-range = Če uporabljate več območij premikanja, je mogoče za vsako shraniti lasten niz podatkov za središče umeritvenega elementa: od { $mp-calibration-part-centre-2 }.0 do { $mp-calibration-part-centre-2 }.2 in od { $mp-calibration-part-centre-3 }.0 do { $mp-calibration-part-centre-3 }.2.
note-probe-type-selected = Če izmenično uporabljate stikalne in analogne tipalne sisteme, pazite, da { $mp-probe-selection } izbere pravi tipalni sistem. Nikoli ne smeta biti na krmiljenje priključena oba hkrati. Krmiljenje ne more ugotoviti, kateri tipalni sistem je v resnici v stroju.
