## Zakaj se izvajanje konča predčasno.

diag-angle-missing = Krožnici manjka kot PA.
diag-axis-limit = Os { $axis } bi se premaknila na { NUMBER($found) }{"\u00A0"}{ $unit }, zunaj območja stroja od { NUMBER($min) } do { NUMBER($max) }{"\u00A0"}{ $unit }.
diag-block-limit = Izvajanje je bilo prekinjeno: izvedenih je bilo več kot { NUMBER($limit) } stavkov.
diag-block-unreadable = Stavka ni mogoče prebrati: { $found }
diag-call-depth-limit = Priklici so ugnezdeni globlje kot { NUMBER($limit) } ravni.
related-called-here = priklicano tukaj
diag-collision = Trk: tipalna glava se zunaj tipanja dotakne obdelovanca pri X { NUMBER($x) } Y { NUMBER($y) } Z { NUMBER($z) }.
diag-conform-no-value = Primer ne podaja vrednosti za { $name }, specifikacija pa nima vrednosti za primer.
diag-conform-unknown-clause = Primer naj bi dokazal { $name }, česar cikel { $cycle } nima.
diag-cycle-depth-limit = Cikli so ugnezdeni globlje kot { NUMBER($limit) } ravni.
diag-cycle-error = Cikel se ustavi z napako { $code }.
diag-cycle-unknown = Priročniki za { $control } cikla { $cycle } ne opisujejo: ni ga mogoče simulirati.
diag-direction-contradicts = Predznak inkrementalnega kota nasprotuje smeri vrtenja DR.
diag-direction-missing = Krožnici manjka smer vrtenja DR.
diag-direction-undefined = Točki sta narazen le { NUMBER($distance) }{"\u00A0"}mm: smeri ne določata.
diag-division-by-zero = Deljenje z nič.
diag-elements-overlap = Elementa na dveh vogalih konture se prekrivata: skupaj zavzameta { NUMBER($least) }{"\u00A0"}mm stranice med njima, ki je dolga { NUMBER($found) }{"\u00A0"}mm.
diag-end-off-circle = Končna točka ne leži na krožnici: polmer na začetku { NUMBER($start_radius, maximumFractionDigits: 4) }{"\u00A0"}mm, na koncu { NUMBER($end_radius, maximumFractionDigits: 4) }{"\u00A0"}mm.
diag-feed-missing = Aktiven ni noben pomik, večji od 0.
diag-field-missing = V ciklu { $cycle } manjka polje { $field }.
diag-field-unknown = Cikel { $cycle } nima takega polja: { $found }
diag-fit-collinear = Tipalne točke ({ NUMBER($points) }) ležijo na isti premici: krožnice jim ni mogoče prilagoditi.
diag-fit-failed = Tipalnim točkam ({ NUMBER($points) }) ni mogoče prilagoditi krožnice.
diag-fit-too-few = Tipalnih točk je premalo za krožnico: { NUMBER($points) }.
diag-infeeds-never-reach-depth = Primiki nikoli ne dosežejo globine { NUMBER($depth) }{"\u00A0"}mm: prvi meri { NUMBER($first) }{"\u00A0"}mm, vsak naslednji je za { NUMBER($less) }{"\u00A0"}mm manjši, najmanjši meri { NUMBER($least) }{"\u00A0"}mm; končajo se pri { NUMBER($reached) }{"\u00A0"}mm.
diag-insert-askew = Struženja s cikli ni mogoče simulirati, ko je orodje nagnjeno in je aktivna funkcija M144, M128 ali FUNCTION TCPM.
diag-insert-direction = Rezalna ploščica orodja { $tool } ni obrnjena proti obdelovancu ali v smer rezov: njena usmeritev (TO) je { $orientation }.
diag-jump-limit = Izvajanje je bilo prekinjeno: izvedenih je bilo več kot { NUMBER($limit) } skokov, ponovitev in priklicev.
diag-jump-target-missing = Oznake LBL { $label } ni.
diag-jump-target-twice = Oznaka LBL { $label } je v programu dvakrat.
diag-kinematics-unknown = Kinematika »{ $name }« za FUNCTION MODE ni kinematika simuliranega stroja »{ $machine }«.
diag-lines-parallel = Premici sta vzporedni: nimata presečišča.
diag-log-failed = Protokola { $name } ni mogoče zapisati: { $reason }
diag-log-template = Protokol { $name } nima predloge.
diag-log-text = Manjka besedilo protokola { $name } ({ $reason }).
diag-machine-parameter-missing = Strojni parameter { $name } s tremi koordinatami ni določen.
diag-milling-mode-missing = { $cycle } se izvaja samo v načinu rezkanja, aktiven pa je način struženja (FUNCTION MODE TURN).
diag-move-limit = Izvajanje je bilo prekinjeno: izvedenih je bilo več kot { NUMBER($limit) } premikov orodja.
diag-no-cycle-to-call = Cikel je priklican, definiran pa ni bil noben obdelovalni cikel.
diag-no-such-parameter = Parametra { $q } ni.
diag-number-too-large = Rezultat je prevelik za obliko števil.
diag-orientation-missing = Popravek polmera pri struženju potrebuje usmeritev (TO) orodja { $tool }: ta pove, kje je konica glede na središče zaobljenja.
diag-outside-domain = Funkcija { $function } za { NUMBER($value) } ni definirana.
diag-parameter-missing = V ciklu { $cycle } manjka { $q }.
diag-parameter-out-of-range = Parameter { $q } ne sprejme vrednosti { NUMBER($value) }.
diag-parameter-undefined = Parameter { $q } nima vrednosti.
diag-parameter-in-addition = { $q } v { $cycle } pripada poznejši različici programske opreme od tu opisane; njegov učinek ni znan.
diag-parameter-unknown = Cikel { $cycle } nima parametra { $q }.
diag-plan-mistake = Specifikacija cikla { $cycle } vsebuje napako: { $reason }
diag-plane-through-line = Vse tri točke ležijo na isti premici, zato ne določajo ravnine.
diag-pole-missing = Središče kroga ali pol (CC) ni definiran.
diag-probe-deflected = Tipalna glava je odklonjena že pred tipanjem.
diag-probe-measurements-differ = Meritve iste točke se razlikujejo za { NUMBER($found) }{"\u00A0"}mm; tolerančno območje je { NUMBER($range) }{"\u00A0"}mm.
diag-probe-missing = V vretenu ni tipalnega sistema.
diag-probe-no-contact = Tipalni sistem se na razdalji { NUMBER($distance) }{"\u00A0"}mm ničesar ne dotakne.
diag-probe-no-direction = Tipalna glava je že v točki, ki naj jo otipa, zato smeri tipanja ni.
diag-program-missing = Programa { $name } ni.
diag-radius-missing = V tem stavku manjka polmer R.
diag-radius-too-small = Polmer { NUMBER($radius) }{"\u00A0"}mm ne zadošča za tetivo { NUMBER($chord, maximumFractionDigits: 4) }{"\u00A0"}mm.
diag-recess-impossible = Za utor ni prostora, manjka njegova sredina, globina ali širina, ali pa ni na ravnem elementu.
diag-recursive-call = Del programa priklicuje samega sebe.
diag-repeat-count = REP zahteva celo število od 0 do 65534, ne { NUMBER($found) }.
diag-rotary-axis-missing = Stroj nima rotacijske osi { $axis }.
diag-rotary-axis-unsuitable = Rotacijska os { $axis } se ne vrti v ravnini poševnega položaja in ga ne more izravnati.
diag-series-count = Število ponovitev mora biti celo in ne negativno, ne { NUMBER($found) }.
diag-series-limit = Cikel bi svoje korake ponovil več kot { NUMBER($limit) }-krat.
diag-strategy-argument = Manjka argument strategije.
diag-text-or-number = Besedilo je tam, kjer je potrebno število, ali obratno.
diag-text-too-long = Besedilni parameter bi presegel { NUMBER($limit) } znakov.
diag-tool-locked = Orodje { $tool } je blokirano.
diag-tool-not-in-table = Orodja { $tool } ni v preglednici orodij.
diag-turn-limit = Izvajanje je bilo prekinjeno: en premik ima več kot { NUMBER($limit) } obratov.
diag-undercut-form = UDC { $form } ni mogoče simulirati: noben priročnik ne opisuje njegove oblike.
diag-undercut-impossible = Za spodrez ni prostora, manjka mera ali pa ni med površino vzdolž rotacijske osi in nanjo pravokotno čelno površino.
diag-unsupported-axis = Simulirani stroj nima osi { $axis }.
diag-unsupported-block = { $word } ni mogoče simulirati.
diag-unsupported-cycle = Priročnik za { $control } cikel { $cycle } omenja samo po imenu: ni ga mogoče simulirati.
diag-unsupported-feed = Tega pomika v priklicu orodja ni mogoče simulirati: { $word }
diag-unsupported-m = M-funkcije { $word } ni mogoče simulirati.
diag-unsupported-path = { $word } v tem stavku ni mogoče simulirati.
diag-unsupported-tcpm = Pri aktivnem TCPM tipalni sistem ni pravokoten na obdelovalno ravnino; cikla { $cycle } takrat ni mogoče simulirati.
diag-unsupported-transformation = Premikov ni mogoče simulirati, ko je aktivno to preračunavanje koordinat: { $name }
diag-value-missing = Vrednost manjka ali ni število.
diag-value-not-bound = Formula specifikacije bere vrednost, ki še ne obstaja: { $place }
diag-word-not-offered = Beseda { $word } tu ni dovoljena.
diag-arc-scaled-unequally = Osi ravnine imata različna faktorja merila: lok bi postal elipsa.
diag-scaling-factor-zero = Faktor merila mora biti večji od nič, ne { NUMBER($found) }.
diag-shaft-collision = Steblo tipalne glave se dotakne obdelovanca pri X { NUMBER($x) } Y { NUMBER($y) } Z { NUMBER($z) }.
diag-shape-impossible = S tem orodjem oblike ni mogoče obdelati: potrebnih je vsaj { NUMBER($least) }{"\u00A0"}mm, na voljo je { NUMBER($found) }{"\u00A0"}mm.
diag-cutting-width-missing = Orodje { $tool } ni orodje za struženje utorov: rezalna širina (CUTWIDTH) mora biti večja od 0 in vsaj dvakratnik rezalnega polmera (RS).
diag-m144-together = M144 ne more biti aktivna skupaj s funkcijo { $word }.
diag-spline-start = Zlepek se začne { NUMBER($distance, maximumFractionDigits: 4) }{"\u00A0"}mm ali stopinj od trenutnega položaja; dovoljeno je 0,001.
diag-tool-direction-unreachable = Rotacijske osi stroja orodja ne morejo postaviti v smer, ki jo navaja ta stavek.
diag-tilting-unreachable = Rotacijske osi stroja orodja ne morejo postaviti pravokotno na to ravnino.
diag-pattern-missing = { $name ->
        [none] Za priklic cikla ni definiran ne vzorec ne preglednica točk.
       *[other] Preglednice točk »{ $name }« ni.
    }
diag-pattern-too-long = PATTERN DEF sprejme največ { $limit } posameznih položajev; tu jih je { $count }.
diag-pattern-tool-axis = Vzorci se lahko uporabljajo samo z orodno osjo Z; aktivna orodna os je { $axis }.
diag-pattern-unreadable = »{ $found }« v PATTERN DEF ni mogoče uporabiti.
diag-position-incomplete = CYCL CALL POS potrebuje koordinate vseh treh osi.
diag-value-not-predefined = Programiran je PREDEF, vrednosti pa ni določil noben GLOBAL DEF.
diag-contour-crossing = Kontura oznake { $label } se križa ali dotika sama sebe v točki: glavna os { NUMBER($x) } mm, pomožna os { NUMBER($y) } mm.
diag-contour-begin-incomplete = Kontura { $label } se ne začne z obema koordinatama obdelovalne ravnine.
diag-contour-data-undefined = Noben cikel še ni določil konturnih podatkov.
diag-contour-count = Kontura je sestavljena iz več kot { NUMBER($limit) } delnih kontur.
diag-contour-depth =
    { $what ->
        [first] Delna kontura je globlja od prve v stavku CONTOUR DEF, ki mora biti najgloblji žep.
       *[cycle] Delna kontura ima globino { NUMBER($depth) } mm in je globlja od globine rezkanja iz konturnih podatkov.
    }
diag-contour-elements = Konture imajo skupaj več kot { NUMBER($limit) } konturnih elementov.
diag-contour-empty = Podprogram oznake { $label } ne opisuje konture, ki bi omejevala površino.
diag-contour-lead = Kontura, ki jo obdela cikel, ne sme vsebovati { $word }: cikel se ji sam približa in jo zapusti.
diag-contour-not-defined = Noben cikel še ni navedel podprogramov konture.
diag-contour-open = Kontura oznake { $label } je odprta: konča se { NUMBER($distance) } mm od začetne točke.
diag-contour-side-missing = Kontura oznake { $label } nima popravka polmera RL ali RR, ki pove, ali gre za žep ali otok.
diag-contour-tool-axis = Kontura oznake { $label } vsebuje koordinato na orodni osi.
diag-free-contour-contradicts = Nobena kontura ne ustreza vsem vrednostim tega elementa in elementov pred njim.
diag-free-contour-open =
    { $what ->
        [line] Lega ali smer te premice ni določena. Število manjkajočih vrednosti: { $values }.
        [arc] Središče ali polmer tega loka ni določen. Število manjkajočih vrednosti: { $values }.
       *[end] Konec tega elementa ni določen. Število manjkajočih vrednosti: { $values }.
    }
diag-free-contour-reference = Stavek { $block } ni niti element te proste konture niti pozicionirni stavek pred njo.
diag-free-contour-selection = FSELECT { $wanted } ni mogoče izbrati: število rešitev tukaj je { $solutions }.
diag-free-contour-several = Od tega elementa naprej ima prosta kontura več rešitev ({ $solutions }), z besedo FSELECT pa ni izbrana nobena.
diag-free-contour-word = Besede { $word } v prosti konturi ni mogoče uporabiti tako.
