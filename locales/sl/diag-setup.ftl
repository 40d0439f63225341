# Findings of the checker on tools, the spindle, presets and what the machine and the blank allow.
diag-approach-wrong =
    { $what ->
        [arc] Lok s polmerom { $value } nima prostora med to točko in konturo.
        [left] Orodje zapusti konturo vzdolž svoje osi, brez DEP.
       *[plunged] Kontura se začne tam, kjer se je orodje spustilo v material.
    }
diag-config-unknown-machine = Nastavitve stroja »{ $key }« ni; na voljo so { $expected }.
diag-coordinate-out-of-range = Koordinata { $value } je zunaj območja: { $limit } je največja vrednost, ki jo dovoljujejo priročniki.
diag-labels-not-known =
    { $count ->
        [one] Eno besedilo tukaj ima obliko oznake, vendar ga za ta parameter ne pozna noben jezik: ostane, kot je. --relabel ga zamenja.
        [two] Od tukaj naprej imata { $count } besedili obliko oznake, vendar ju za njuna parametra ne pozna noben jezik: ostaneta, kot sta. --relabel ju zamenja.
        [few] Od tukaj naprej imajo { $count } besedila obliko oznake, vendar jih za njihove parametre ne pozna noben jezik: ostanejo, kot so. --relabel jih zamenja.
       *[other] Od tukaj naprej ima { $count } besedil obliko oznake, vendar jih za njihove parametre ne pozna noben jezik: ostanejo, kot so. --relabel jih zamenja.
    }
diag-machine-limit =
    { $what ->
        [speed] Število vrtljajev { $value } presega { $limit }, največjo vrednost stroja.
        [feed] Pomik { $value } presega { $limit }, največjo vrednost stroja.
        [helix] Vijačnica { $value } stopinj presega { $limit }, največjo vrednost stroja.
        [angle] { $word } { $value } presega { $limit }, konec osi.
        [position] { $word } { $value } presega { $limit }, konec osi.
       *[travel] Program uporablja { $value } mm osi { $word }, ki je dolga le { $limit } mm.
    }
diag-machining-outside-blank =
    { $what ->
        [across] Stranica { $value } leži počez na ploskvi, ki je rezkana v tej ravnini in je široka le { $other }: zavrtena za 90 stopinj bi ležala na njej.
        [above] Cikel ne gre nižje od { $value }, kar je nad surovcem: ničesar ne odstrani.
        [below] Orodje reže na višini { $value }, daleč pod surovcem.
        [over] Kar se obdeluje na { $value }; { $other }, sega čez rob surovca.
        [contour] Kontura je priklicana pri { $value }, nad surovcem, drugje pa v njem: tu ničesar ne odstrani.
        [curve] Krivulja se začne in konča v surovcu, vmes pa ga zapusti pri { $value }; { $other }.
        [corner] Položaj žepa se tu šteje od vogala, zato od sredine surovca { $value }; { $other } sega čez rob.
       *[outside] Kar se obdeluje na { $value }; { $other }, je daleč od surovca.
    }
diag-milling-deeper-than-edges = Orodje tukaj rezka { $value } globoko, kar je več od dolžine njegovih rezil (LCUTS).
diag-plane-left-on =
    { $what ->
        [axes] Ravnina je ponastavljena, rotacijske osi pa niso zasukane nazaj: orodje reže v nagnjen obdelovanec.
       *[tool] Obdelovalna ravnina je ob priklicu tega orodja še vedno zavrtena.
    }
diag-preset-row-wrong =
    { $what ->
        [again] Prednastavitev { $row } se tukaj znova zapiše na drugem mestu, vmes pa je nič ni aktiviralo.
        [other] Tukaj se aktivira prednastavitev { $other }, izmerjena pa je prednastavitev { $row }, ki se nikoli ne aktivira.
        [datum] Vrstica { $row } preglednice ničelnih točk se tukaj zapiše in se nikoli ne aktivira: obdelava se nadaljuje z drugo ničelno točko.
        [same] Prednastavitev { $row } je že aktivna; tukaj se aktivira še enkrat, potem ko se je program ustavil za upravljavca.
        [table] Tu se zapiše vrstica { $row } preglednice ničelnih točk, nato pa se aktivira prednastavitev { $row }, ki je ni zapisalo nič.
       *[unused] Prednastavitev { $row } se tukaj zapiše in se nikoli ne aktivira: obdelava se nadaljuje z drugo prednastavitvijo.
    }
diag-repeat-without-effect =
    { $what ->
        [same] Kontura se ponovi na isti globini { $value }: z inkrementalnimi koraki te velikosti bi šla skozi surovec.
        [place] Ponovljeni premik vodi na mesto z absolutnimi koordinatami, kjer orodje že je: ponovitve ne naredijo ničesar.
        [jump] Ta skok vodi v stavek, ki mu tako ali tako sledi: manjka tisto, kar naj bi preskočil.
       *[zero] Nič ponovitev nima nobenega učinka.
    }
diag-slot-too-narrow = Orodje s premerom { $tool } tukaj ne gre med stene: ta premica je dolga samo { $value }.
diag-spindle-start-wrong =
    { $what ->
        [missing] Po priklicu tega orodja vreteno ni bilo vklopljeno.
       *[direction] Vreteno se vrti v nasprotni smeri urnega kazalca (M4), medtem ko to orodje reže.
    }
diag-tap-without-hole =
    { $what ->
        [missing] Na { $value }; { $other } ni bila izvrtana nobena vrtina za ta navojni sveder.
        [floor] Navoj seže do { $value }, dno ob njem pa je pri { $other }: rezkar za navoje gre v polni material.
       *[shallow] Navojni sveder seže do { $value }, vrtina pa se konča pri { $other }.
    }
diag-tcpm-missing = Rotacijske osi se tukaj premikajo skupaj z linearnimi brez TCPM, čeprav program TCPM pozneje izklopi.
diag-tool-called-twice = Orodje { $tool } je tukaj znova priklicano, med priklicema pa ni ničesar.
diag-tool-table-contradicts =
    { $what ->
        [speed] Število vrtljajev { $value } presega { $other }, največje število vrtljajev orodja { $tool } v preglednici orodij (NMAX).
        [locked] Orodje { $tool } je v preglednici orodij blokirano (TL), nadomestno orodje (RT) pa ni navedeno.
        [point] { $value } tu centrira na premer, orodje { $tool } pa v preglednici orodij nima kota konice (T-ANGLE).
        [turning] { $value } ni za orodje { $tool }, ki je v preglednici stružnih orodij tipa { $other } (TYPE).
        [size] Orodje { $tool } ima v preglednici orodij premer { $other }, njegovo ime pa navaja { $value }.
        [oversize] Negativna nadmera { $value } (DR) od polmera { $other } orodja { $tool } ne pusti ničesar.
        [left] Korak { $value } je korak levega navoja, nič pa ne pove, da je orodje { $tool } levi navojni sveder.
        [length] Orodje { $tool } v preglednici orodij nima dolžine (L), druga orodja pa jo imajo.
        [teeth] { $value } meri vsako rezilo, orodje { $tool } pa v preglednici orodij nima števila rezil (CUT).
        [large] Nadmera { $value } (DR) je večja od polmera { $other } orodja { $tool }.
        [called] { $value } ni za orodje { $tool }, ki se imenuje { $other }.
       *[type] { $value } ni za orodje { $tool }, ki je v preglednici orodij tipa { $other } (TYP).
    }
diag-translate-encoding = Datoteka je zapisana v { $encoding }: v njem ima enake bajte in vse črke novih oznak.
diag-translate-encoding-unknown = Kodiranje »{ $encoding }« ne obstaja; na voljo so { $known }.
diag-translate-encoding-wrong = { $path } ni v { $encoding }: nekateri bajti tam nimajo pomena.
diag-translate-unread = { $cycle } ima vrstico, ki je ni mogoče prebrati, zato ime in oznake ostanejo, kot so.
related-preset-written-here = zapisano tukaj
diag-character-unknown = Besedilo vsebuje »{ $character }«, znak, ki ga pisava nima.
diag-allowance-left =
    { $what ->
        [order] Kontura se tukaj obdela z nadmero { $value } (DR), pozneje pa z istim orodjem z večjo nadmero { $other }: za drugi prehod ne ostane nič.
        [below] Kontura oznake { $label } se najprej obdela z negativno nadmero { $value }: orodju, ki jo obdela za tem, ne ostane nič.
        [cycle] { $label } tudi s tem orodjem obdela konturo z nadmero { $value }: nadmera ostane na obdelovancu.
       *[left] Kontura oznake { $label } se tudi s tem orodjem obdela z nadmero { $value }: nadmera ostane na obdelovancu.
    }
diag-contour-crossed =
    { $what ->
        [back] Ta sklenjena kontura se od vogala vrne naravnost k prejšnjemu.
        [away] Orodje se s te sklenjene konture odmakne na njeno drugo stran: na poti reže to, kar je pravkar končalo.
        [start] Do te sklenjene konture orodje pride v notranjem vogalu: tam zareže v njen zadnji element.
        [short] Ta kontura se konča na svoji prvi premici pred začetkom: preostanek premice ostane neobdelan.
        [itself] Ta kontura se pred svojim koncem vrne na eno od lastnih premic: orodje reže to, kar je pravkar končalo.
       *[side] S tem popravkom polmera orodje prečka sklenjeno konturo: prihaja z njene druge strani.
    }
diag-contour-depths-differ =
    { $what ->
        [chamfer] Posnetje se reže pri { $value }, pod dnom konture pri { $other }.
        [deep] Kontura se tu konča pri { $value }, prejšnje orodje pa je rezalo za eno dostavo globlje, do { $other }.
       *[shallow] Kontura se tu v enem prehodu reže do { $value }, prejšnje orodje pa je prišlo le do { $other }.
    }
diag-error-branch-entered =
    { $what ->
        [turned] Skok čez zaustavitev se izvede, kadar { $parameter } javlja napako.
        [implied] Ta skok in skok pred njim vodita na isto oznako in primerjata { $parameter } v isto smer: ena od obeh mej ne učinkuje.
        [branch] Pogoj tega skoka ne ustreza njegovi veji: pri tej vrednosti { $parameter } pomeni nekaj drugega kot tamkajšnja oznaka ali komentar.
        [good] Ta skok v vejo za napake se izvede tudi, kadar je vse v redu: pri tej vrednosti { $parameter } ne javlja napake.
        [unchecked] Cikel tu orodje izmeri na novo in ga z ničimer ne primerja: { $parameter }, po katerem se pozneje vpraša, ne javlja napake.
        [greater] Skok na sporočilo o napaki se tu vedno izvede: { $value } je večje od { $other }.
        [less] Skok na sporočilo o napaki se tu vedno izvede: { $value } je manjše od { $other }.
       *[entered] Izvajanje pride v to vejo tudi brez skoka in se ustavi: pred njo programa ne konča ne M2 ne M30.
    }
diag-finishing-before-roughing =
    { $what ->
        [pilot] { $other } navaja orodje, ki tukaj vrta; navesti mora orodje, ki pozneje grobo rezka.
       *[order] { $cycle } tukaj fino obdela konturo, preden jo { $other } grobo obdela.
    }
diag-label-unused = Oznake { $label } v tem podprogramu nič ne prikliče in ne ponovi, nanjo tudi noben skok ne vodi.
diag-loop-runs-once =
    { $what ->
        [again] Od drugič naprej se ta zanka izvede samo enkrat: njenega števca nič ne ponastavi.
        [other] Števec te zanke se v vsakem prehodu izračuna iz drugega parametra: število, s katerim začne, nima učinka.
        [inner] Tudi notranja zanka šteje s parametrom { $parameter }, zato se ta konča prezgodaj ali nikoli: ta skok ne šteje svojih prehodov.
       *[never] Ta skok nazaj se nikoli ne izvede: števec v nobenem prehodu ne izpolni pogoja.
    }
diag-parameter-unused =
    { $what ->
        [late] { $parameter } tu dobi vrednost, ki je noben priklic ne bere več: vsak priklic ima svoje vrednosti, priklic za te pa stoji pred njimi.
       *[never] { $parameter } tukaj dobi vrednost, nič pa je ne prebere.
    }
diag-probing-direction-wrong =
    { $what ->
        [up] { $cycle } tipa s smerjo { $value }, navzgor vzdolž orodne osi: tipalni sistem bi prišel iz notranjosti obdelovanca.
       *[edge] { $cycle } tipa rob na osi { $axis } s smerjo { $value }: obdelovanec je na strani, s katere pride tipalni sistem.
    }
diag-same-datum-twice =
    { $what ->
        [loop] Zanka šteje, vendar v vsakem prehodu aktivira vrstico { $row }: vsakič se obdela isto.
        [turned] Miza se za vrstico { $row } ni obrnila naprej: stoji pod kotom druge strani.
        [cycle] Vrstica { $row } se znova aktivira pred enakim priklicem cikla na istem mestu: isto se obdela dvakrat.
       *[again] Vrstica { $row } se pred istim podprogramom znova aktivira: isto se obdela dvakrat.
    }
diag-selected-table-missing = Preglednice { $name } ni v mapi programa.
diag-turned-contour-wrong =
    { $what ->
        [above] Kontura se konča pri Z { $value }, nad surovcem, ki se konča pri { $limit }.
        [narrow] Vbod je širok { $value }, orodje { $limit }.
        [side] Vbod sega od premera { $limit } do { $value }; drugje isto orodje vbada v drugo smer.
        [dip] Kontura pade na premer { $value }, pod svoj prvi premer { $limit }, cikel pa spodrezov ne obdeluje.
        [deep] Vbod je globok { $value }, orodje pa reže samo { $limit }.
        [ridge] Čelna ploskev se dvigne na premer { $value } in takoj pade na { $limit }: ostane rob brez širine.
        [corner] Vogal konture je pri Z { $value }, zunaj konca surovca pri { $limit }, in kontura se od tam vrne.
        [wall] Orodje tukaj prereže steno obdelovanca: na drugi strani je premer { $limit }.
        [air] Cikel struži samo v zraku: pride do premera { $value }, obdelovanec pa ima tam premer { $limit }.
       *[rounding] Za zaokrožitev { $value } je premica prekratka; možno je največ { $limit }.
    }
diag-called-program-wants =
    { $name } bere { $parameter }, ki mu pred tem priklicem nič ni dalo vrednosti.
diag-branch-runs-on =
    { $what ->
        [variant] Veja se tu konča brez skoka in potek se nadaljuje v drugo: na oznako { $parameter } za njo ne vodi nič.
       *[values] Veja se tu konča brez skoka: naslednja določi druge vrednosti ({ $parameter }), preden kaj prebere te.
    }
diag-finishing-tool-too-wide = Nadmera in polmer orodja sta tu skupaj { $value }; to mora biti manj kot pri posnemanju, { $other }.
