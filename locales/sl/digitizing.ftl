# Cycles that digitize a part with a touch probe.

# --- 5 and 15 ---
cycle-digitize-range = Območje za digitaliziranje
    .nc = OBMOČJE
    .purpose = Določi datoteko za podatke digitaliziranja, varno višino in kvadrasto območje, v katerem cikli digitaliziranja otipajo obdelovanec.
cycle-digitize-range-from-points = Območje za digitaliziranje iz preglednice točk
    .nc = OBMOČJE
    .purpose = Določi območje poljubne oblike za digitaliziranje z analognim tipalnim sistemom: preglednica točk navaja njegovo mejo v obdelovalni ravnini. Cikel določi tudi datoteko za podatke digitaliziranja in varno višino.
step-remember-digitizing-range = Krmiljenje za naslednje cikle digitaliziranja shrani območje med točkama MIN in MAX, varno višino in ime datoteke.
step-remember-digitizing-range-from-points = Krmiljenje za naslednje cikle digitaliziranja shrani območje, katerega mejo v obdelovalni ravnini določajo točke preglednice, na osi tipalnega sistema pa točki MIN in MAX, ter varno višino in ime datoteke.
table-digitizing-points = Preglednica točk za digitaliziranje
title-range-with-rotary-axis-a = Območje z rotacijsko osjo A za cikel 18
title-range-for-meander-with-rotary-axis = Območje z rotacijsko osjo A za cikel 6
title-range-with-rotary-axis-c = Območje z rotacijsko osjo C za cikel 7

# --- 6 and 16 ---
cycle-digitize-meander = Meander
    .nc = MEANDER
    .purpose = S stikalnim tipalnim sistemom v meandrih digitalizira 3D-obdelovanec.
cycle-digitize-meander-analog = Meander (analogni tipalni sistem)
    .nc = MEANDER
    .purpose = Z analognim tipalnim sistemom v meandrih digitalizira 3D-obdelovanec.
step-approach-digitizing-start = Krmiljenje tipalni sistem samodejno premakne na začetno točko, najprej po orodni osi na varno višino, nato v obdelovalni ravnini na točko MIN območja iz cikla 5 ali cikla 15.
step-approach-workpiece-downwards = Tipalni sistem se v negativni smeri orodne osi premakne k obdelovancu. Krmiljenje shrani koordinate položaja, na katerem se tipalni sistem dotakne obdelovanca.
step-scan-meander = Tipalni sistem se od točke MIN v pozitivni smeri osi vrstic premika vzdolž obdelovanca do meje območja, se premakne za razmik vrstic in se vrne po naslednji vrstici; na drugem koncu se znova premakne za razmik vrstic. To se ponavlja, dokler ni digitalizirano celotno območje.
step-return-to-clearance-after-digitizing = Na koncu se tipalni sistem vrne na varno višino.
title-meander-with-rotary-axis = Meander z rotacijsko osjo kot smerjo vrstic

# --- 7 and 17 ---
cycle-digitize-contour-lines = Plastnice
    .nc = PLASTNICE
    .purpose = S stikalnim tipalnim sistemom raven za ravnjo, v plastnicah, digitalizira 3D-obdelovanec.
cycle-digitize-contour-lines-analog = Plastnice (analogni tipalni sistem)
    .nc = PLASTNICE
    .purpose = Z analognim tipalnim sistemom raven za ravnjo, v plastnicah, digitalizira 3D-obdelovanec.
step-approach-contour-line-start = Krmiljenje tipalni sistem samodejno premakne na začetno točko, najprej po orodni osi na varno višino, nato v obdelovalni ravnini na koordinate, ki jih določa cikel. Koordinata začetne točke na orodni osi je koordinata točke MIN iz cikla 5, če je razmik vrstic pozitiven, in koordinata točke MAX, če je negativen.
step-approach-workpiece-in-direction = Tipalni sistem se v programirani smeri primika premakne k obdelovancu. Krmiljenje shrani koordinate položaja, na katerem se tipalni sistem dotakne obdelovanca.
step-scan-contour-line = Ko je prva točka shranjena, se tipalni sistem na stalni višini premika okoli obdelovanca, dokler znova ne doseže prve točke.
step-go-on-by-line-spacing = Nato se v pozitivni ali negativni smeri orodne osi premakne za razmik vrstic in se znova na stalni višini premika okoli obdelovanca do prve točke, shranjene na tej višini. To se ponavlja, dokler ni digitalizirano celotno območje.
step-return-to-contour-line-start = Na koncu se tipalni sistem premakne na varno višino in vrne na programirano začetno točko.

# --- 8 and 18 ---
cycle-digitize-lines = Vrstice
    .nc = VRSTICE
    .purpose = S stikalnim tipalnim sistemom vrstico za vrstico digitalizira 3D-obdelovanec.
cycle-digitize-lines-analog = Vrstice (analogni tipalni sistem)
    .nc = VRSTICE
    .purpose = Z analognim tipalnim sistemom vrstico za vrstico digitalizira 3D-obdelovanec.
step-approach-line-start = Krmiljenje tipalni sistem samodejno premakne na začetno točko, najprej po orodni osi na varno višino, nato v obdelovalni ravnini. Začetna točka je v programirani smeri vrstic na pozitivni ali negativni meji območja (odvisno od smeri digitaliziranja), sicer pa ima koordinate točke MIN območja iz cikla 5 ali cikla 15.
step-scan-line = Tipalni sistem se v pozitivni smeri izbrane osi obdelovalne ravnine premika vzdolž obdelovanca do meje območja.
step-return-for-next-line = Nato se premakne na varno višino in se v hitrem teku vrne na začetek naslednje vrstice. Tam se v hitrem teku v negativni smeri orodne osi premakne na višino za zmanjšanje pomika, od tam pa s pomikom pri tipanju do dotika obdelovanca. To se ponavlja, dokler ni digitalizirano celotno območje.
title-lines-with-rotary-axis = Vrstice z rotacijsko osjo, brez pomika za prvo vrstico

# --- guards ---
guard-digitizing-with-transformation = Aktivno je preračunavanje koordinat. Med digitaliziranjem ne sme biti aktivno.

# --- notes: programming ---
note-range-before-digitizing = V obdelovalnem programu pred ciklom, ki izvaja digitaliziranje, definirajte cikel digitaliziranja OBMOČJE (5 ali 15).
note-range-before-contour-lines = V obdelovalnem programu pred ciklom digitaliziranja PLASTNICE definirajte cikel digitaliziranja 5 OBMOČJE.
note-not-with-contour-lines = Cikla { $cycle } ni mogoče povezati s ciklom digitaliziranja 17 PLASTNICE.
note-not-with-range-from-points = Cikla { $cycle } ni mogoče povezati s ciklom digitaliziranja 15 OBMOČJE.
note-no-transformation-while-digitizing = Med digitaliziranjem ne sme biti aktivno niti preračunavanje koordinat niti osnovna rotacija.
note-analog-probe-only = Samo za analogne tipalne sisteme.
note-complete-path-of-data = V meni za podatkovni vmesnik vnesite celotno pot, na katero krmiljenje shrani podatke digitaliziranja.
note-digitizing-not-in-iso = Cikli digitaliziranja v DIN/ISO niso na voljo.

# --- notes: what is needed ---
note-digitizing-needs-option = Za digitaliziranje so potrebni tipalni sistem, programska možnost digitaliziranja in po potrebi programska oprema za vrednotenje SUSA podjetja HEIDENHAIN, ki obdela podatke digitaliziranja cikla MEANDER.
note-calibrate-before-digitizing = Pred digitaliziranjem umerite tipalni sistem.
note-digitizing-axes = Cikli digitaliziranja se programirajo z glavnimi osmi X, Y in Z ter z rotacijskimi osmi A, B in C.
note-digitizing-speed-touch-trigger = Pri stikalnem tipalnem sistemu je hitrost digitaliziranja med 200 in 800{"\u00A0"}mm/min pri razmiku točk 1{"\u00A0"}mm.
note-digitizing-speed-analog = Pri analognem tipalnem sistemu hitrost digitaliziranja določa cikel, največ 3000{"\u00A0"}mm/min.

# --- notes: how it is digitized ---
note-meander-for-flat-parts = Digitaliziranje v meandrih je primerno predvsem za razmeroma ravne obdelovance.
note-meander-for-evaluation-software = Če bo podatke digitaliziranja obdelala programska oprema za vrednotenje SUSA podjetja HEIDENHAIN, digitalizirajte v meandrih.
note-contour-lines-for-steep-parts = Digitaliziranje v plastnicah je primerno zlasti za razgibane obdelovance (na primer orodja za brizganje) in za zajem posamezne plastnice (na primer obrisa odmične plošče).
note-range-for-contour-lines = Območje mora biti na osi tipalnega sistema vsaj za polmer tipalnega sistema nižje od najvišje točke obdelovanca. V obdelovalni ravnini mora biti območje vsaj za polmer tipalnega sistema večje od obdelovanca.
note-single-contour-line = Če želite digitalizirati posamezno plastnico, za razmik vrstic in, če ga cikel zahteva, za najmanjši razmik vrstic vnesite 0.
note-lines-for-one-milling-direction = Ta cikel se uporablja predvsem za razmeroma ravne obdelovance, ki se bodo po podatkih digitaliziranja, brez programske opreme za vrednotenje, ves čas rezkali v soteku ali ves čas v protiteku.
note-lines-for-rotary-axes = Pri analognem tipalnem sistemu se ta cikel uporablja predvsem za digitaliziranje z rotacijsko osjo.
note-normal-retraction-recommended = Priporočeni odmik v smeri normale na vrstico: med polovico razmika točk in razmikom točk. Čim manjša je tipalna krogla, tem večji naj bo odmik.
note-climb-or-up-cut-by-direction = Smer digitaliziranja določa tudi, ali bo poznejše rezkanje v soteku ali v protiteku.
note-sudden-changes-of-direction = Krmiljenje shrani položaje, na katerih se smer nenadoma spremeni, največ 1000 v eni vrstici. V naslednji vrstici pomik pri tipanju samodejno zmanjša, ko se tipalni sistem približa takemu položaju. To izboljša rezultate.
note-feed-reduction-only-up-to-1000 = Zmanjševanje pomika deluje samo, če v vrstici ni več kot 1000 točk, na katerih je treba pomik zmanjšati.
note-corner-reduction-entered-by-control = Na vprašanje o zmanjšanju pomika v vogalih odgovorite z NO ENT. Krmiljenje vrednost vnese samodejno.

# --- notes: rotary axes ---
note-rotary-axes-touch-trigger = S stikalnim tipalnim sistemom je z rotacijskimi osmi mogoče digitalizirati v meandrih (cikel 6), v vrsticah (cikel 8) ali v plastnicah (cikel 7). V vseh primerih rotacijsko os vnesite v ciklu OBMOČJE. Krmiljenje vrednosti rotacijskih osi razume kot stopinje.
note-rotary-axes-analog = Z analognim tipalnim sistemom je z rotacijskimi osmi mogoče digitalizirati samo s ciklom 18 VRSTICE. Rotacijska os se definira kot os stolpcev.
note-digitizing-range-with-rotary-axis = Za digitaliziranje z rotacijsko osjo to os vnesite v območje. Krmiljenje njene vrednosti razume kot stopinje. Datoteka s podatki digitaliziranja vsebuje osi, ki jih določa območje; BLK FORM se vanjo ne zapiše, ker rotacijskih osi ni mogoče grafično prikazati.
note-digitizing-display-of-rotary-axis = Pri digitaliziranju in pri rezkanju mora biti prikaz rotacijske osi enak (z zmanjšanjem na vrednost pod 360° ali brez njega).
note-meander-with-rotary-axis = Če je smer vrstic linearna os (na primer X), se tipalni sistem na koncu vrstice za razmik vrstic premakne po rotacijski osi (na primer A) iz cikla OBMOČJE; tipalni sistem se tedaj giblje sem in tja, na primer v ravnini Z/X. Če je smer vrstic rotacijska os (na primer A), se tipalni sistem na koncu vrstice za razmik vrstic premakne po linearni osi (na primer X); tipalni sistem se tedaj giblje sem in tja, na primer v ravnini Z/A.
note-contour-lines-with-rotary-axis = Začetna točka se definira na linearni osi (na primer X) in na rotacijski osi (na primer C), prav tako zaporedje primika. Tipalni sistem se tedaj giblje sem in tja, na primer v ravnini X/C. To ustreza tudi strojem s samo dvema linearnima osema (na primer Z in X) in eno rotacijsko osjo (na primer C). Smer vrtenja, določena v zaporedju primika, velja za vse plastnice.
note-lines-with-rotary-axis = Če je smer vrstic linearna os (na primer X), se tipalni sistem na koncu vrstice za razmik vrstic premakne po rotacijski osi (na primer A) iz cikla OBMOČJE.

# --- notes: the data ---
note-digitized-data-on-disk = Krmiljenje zajete položaje shrani neposredno na trdi disk. Imenik določa funkcija vmesnika PRINT.
note-digitized-data-with-same-radius = Če se rezka z orodjem, katerega polmer je enak polmeru tipalne krogle, je mogoče podatke digitaliziranja neposredno izvesti s ciklom 30.
note-block-form-in-data = Krmiljenje v datoteko s podatki digitaliziranja zapiše BLK FORM. Pri tem kvader, določen s ciklom OBMOČJE, poveča za dvakratno vrednost { $mp-stylus-deflection-depth } (pri analognih tipalnih sistemih).
note-digitized-data-in-programs = Podatke digitaliziranja je mogoče izvesti z obdelovalnim ciklom 30, če je potrebnih več prehodov (samo podatki ciklov MEANDER in VRSTICE), ali s pomožnim programom, če je potrebno samo fino rezkanje: definirajte orodje s polmerom tipalne krogle, ga prikličite, določite pomik, M-funkcije in popravek polmera R0 ter datoteko prikličite s CALL PGM.
note-digitized-data-size = Datoteka s podatki digitaliziranja sme imeti največ 1500{"\u00A0"}MB; toliko prostora je na trdem disku krmiljenja, če ni shranjen noben program.

# --- notes: point tables ---
note-point-table-recording = Točke se zajamejo z analognim tipalnim sistemom v načinu Pozicioniranje z ročnim vnosom; za to je potrebna programska možnost za digitaliziranje s takim sistemom. Gumb PNT izbere preglednico točk. Točke se zajamejo ročno (TEACH-IN: tipalno glavo odklonite z roko in prevzamete dejanski položaj) ali samodejno (v vnesenem razmiku točk, medtem ko tipalno glavo z roko vodite okoli obdelovanca). Vnesti je mogoče pomik, s katerim se tipalni sistem odzove na odklon, in za vsako os izbrati koordinate, ki naj se shranijo. Območje določajo samo koordinate obdelovalne ravnine.
note-point-table-size = Preglednica točk za območje sme vsebovati največ 893 točk. Če želite, da krmiljenje to nadzoruje, nastavite gumb OBMOČJE/PODATKI KONTURE na OBMOČJE.
note-point-table-closed = Točke so povezane z daljicami, ki omejujejo območje. Krmiljenje zadnjo točko preglednice samodejno poveže s prvo.
