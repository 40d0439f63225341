# Findings of the program checker and of the translation of programs.

diag-approach-twice =
    { $what ->
        [call] Podprogram začne konturo z RL ali RR, tu pa je priklican, ko je popravek prejšnjega priklica še aktiven.
       *[approach] Orodje se tu primakne na konturo, čeprav je popravek polmera še aktiven: prejšnja kontura ni bila zapuščena.
    }
diag-approach-without-compensation =
    { $what ->
        [approach] Primik na konturo je tu brez RL ali RR.
        [contour] Orodje obide to sklenjeno konturo brez RL ali RR, za njo pa R0 izklopi, kar ni bilo nikoli vklopljeno.
       *[departure] Tu je odmik s konture, popravek polmera pa ni aktiven.
    }
diag-arc-direction-wrong =
    { $what ->
        [sign] Ta lok se elementoma pred njim in za njim priključi samo z drugim predznakom polmera: tako, kot je zapisan, je večji del kroga.
        [full] Orodje tu sredi konture naredi poln krog: konec loka je njegov začetek.
        [beyond] Ta lok sega čez surovec; v drugi smeri vrtenja bi ostal znotraj.
       *[direction] Ta krožni lok se prejšnjemu in naslednjemu elementu prilega samo z drugo smerjo vrtenja.
    }
diag-arc-in-unequal-scaling = { $cycle } spreminja merilo osi tega loka z različnima faktorjema: iz loka ne nastane lok.
diag-arc-too-narrow = Polmer { $radius } na notranji strani konture je manjši od polmera orodja { $tool }.
diag-arc-without-tangent = Pred tem tangencialnim lokom ni elementa konture.
diag-arc-wrong =
    Lok se tu ne more končati: { $what ->
        [radius] polmer je { $first }, razdalja med začetkom in koncem pa { $second }
        [full] konča se na začetku; središče polnega kroga iz polmera ne izhaja
        [sense] kot je { $first }, DR pa ima nasprotno smer
       *[centre] začetek je od središča oddaljen { $first }, konec pa { $second }
    }.
diag-axis-twice = Os { $axis } je v tem stavku navedena dvakrat.
diag-back-boring-inside =
    { $what ->
        [hole] Rezalni rob sega { $value } od osi vrtine, njen polmer pa je le { $other }: orodje ne gre skoznjo.
       *[thickness] Po podatkih cikla je material debel { $value }, surovec pa sega { $other } pod površino.
    }
diag-blocks-after-end = Za stavkom END PGM so še drugi stavki.
diag-blank-wrong =
    { $what ->
        [again] Surovec že ima BLK FORM 0.1.
        [axis] Tu manjka { $axis }: oglišče surovca ima tri koordinate.
        [first] Pred BLK FORM 0.2 ni BLK FORM 0.1.
        [cylinder] Valju manjka polmer ali premer oziroma dolžina.
        [second] Stavku BLK FORM 0.1 ne sledi BLK FORM 0.2.
        [tool] Pri surovcu ni navedena orodna os.
       *[order] Na osi { $axis } mora biti koordinata drugega oglišča surovca večja od koordinate prvega.
    }
diag-block-numbers = Številka stavka { $number } sledi številki { $before }.
diag-call-of-def-active-cycle = { $cycle } deluje od definicije; ne sme se priklicati.
diag-called-but-not-defined = Tu se prikliče cikel, definiran pa ni bil noben.
diag-called-program-in-other-unit = Ta program je v { $own }, klicani program { $name } pa v { $other }.
diag-called-program-missing = Programa { $name } ni ob tem programu, kjer ga krmiljenje išče.
diag-centre-in-other-plane = Lok in njegovo središče nista v isti ravnini.
diag-chamfer-wrong-side = Konica orodja za posnemanje robov gre { $value } globoko skozi polni material, { $other } znotraj roba surovca: zunaj bi rob posnela.
diag-choice-not-offered = { $parameter }={ $value } ni med možnostmi: { $offered }.
diag-clearance-height-too-low =
    { $what ->
        [stud] { $cycle } se pomika od izvrtine do izvrtine pri { $parameter }={ $value }, čep med njima pa sega do { $least }.
       *[touched] { $cycle } tipa pri { $touched }: varna višina { $parameter }={ $value } mora biti nad { $least }.
    }
diag-compensation-at-cycle =
    { $cycle } se tu izvede pri aktivnem popravku polmera.
diag-compensation-left-on = Popravek polmera je tu še aktiven.
diag-compensation-missing = Ta kontura se drugje obdeluje z RL ali RR; tu gre po njej z R0 središče orodja.
diag-compensation-on-arc = Popravek polmera se ne sme začeti na loku.
diag-compensation-other-side = Ista kontura je bila prej obdelana z nasprotnim popravkom polmera: tu je orodje na njeni drugi strani.
diag-compensation-switched = Popravek polmera tu zamenja stran brez vmesnega R0.
diag-contour-at-rapid = Orodje se tu ob konturi s popravkom polmera premika v hitrem teku.
diag-contour-data-missing = { $cycle } se prikliče, { $data } pa pred tem ni definiran.
diag-contour-def-wrong =
    { $what ->
        [number] { $found }: to številko že ima druga kontura.
        [many] { $found }: CONTOUR DEF ima lahko največ devet kontur.
       *[island] { $found }: prva kontura v CONTOUR DEF mora biti žep, in sicer najgloblji.
    }
diag-contour-depth-missing = { $contour } nima DEPTH, druge konture pa ga imajo.
diag-contour-returns =
    { $what ->
        [back] Kontura se tu vrača po isti črti, po kateri je prišla do { $value }, { $other }.
       *[corner] Kontura se vrne v točko { $value }; { $other }, ki je že njeno oglišče.
    }
diag-contour-undeclared =
    { $what ->
        [twice] { $contour } je bila že določena.
       *[nothing] Formula uporablja { $contour }, ki prej ni bila določena.
    }
diag-contour-not-selected =
    { $cycle } se tu prikliče, izbrana pa ni bila nobena kontura.
diag-contour-wrong =
    { $cycle } te konture ne more obdelati: { $what ->
        [axis] v njej je premik po orodni osi { $word }
        [approach] v njej je { $word }
        [tool] v njej je { $word }
        [call] v njej je { $word }
        [path] cikel ne bere elementa { $word }
        [first] njena prva točka nima obeh koordinat ravnine
        [uncompensated] v njej ni niti RL niti RR
        [many] cikel obdela samo prvo konturo in ne upošteva { $word }
        [corner] besedi { $word } ne sledi element konture
        [local] v njej se bere { $word }, ki v njej ne dobi vrednosti
        [same] kontura { $word } je ista
        [islands] po RL in RR so vse otoki, žepa okrog njih pa ni
        [round] po obeh oseh je daljša od obsega valja
        [nested] po RL ali RR je žep in leži v celoti v drugem žepu, zato ne odstrani ničesar
        [beside] po RL ali RR je otok in leži ob vseh žepih, zato se tam ne obdela nič
       *[open] ne konča se tam, kjer se začne
    }.
diag-coordinate-out-of-place = { $path } teh koordinat ne sprejme.
diag-core-hole-too-large =
    { $what ->
        [removed] Sveder s premerom { $other } odstrani navoj { $value }, ki je bil tu vrezan prej.
       *[core] Premer vrtine je { $other }, premer navoja { $value }: za navoj ne ostane materiala.
    }
diag-core-hole-too-small =
    { $what ->
        [milled] Rezkar za navoje { $value } gre v vrtino { $other }: vrtina je preozka.
       *[tapped] Navoj { $value } se vrta v vrtino { $other }: vrtina je preozka.
    }
diag-corner-wrong =
    Tega vogala ni mogoče obdelati: { $what ->
        [twice] neposredno pred njim je druga zaokrožitev ali posneti rob
        [arc] posneti rob mora biti med premicama, eden od elementov pa je lok
        [first] pred njim ni elementa konture
        [alone] za njim ni elementa konture
        [back] premica za njim vodi nazaj po premici pred njim
        [size] njegov polmer ali dolžina ni pozitivna
       *[long] potrebuje več prostora, kot je dolga krajša premica: { $least }
    }.
diag-cutting-speed-unusual =
    { $side ->
        [above] Rezalna hitrost { $value } m/min je za to orodje s premerom { $other } veliko prevelika.
        [reamed] Povrtalo s premerom { $other } se pomakne le za { $value } na vrtljaj: vrtljaji so veliko previsoki ali pomik veliko premajhen.
       *[below] Rezalna hitrost { $value } m/min je za to orodje s premerom { $other } veliko premajhna.
    }
diag-cutting-without-tool = Orodje se tu premika s pomikom, pred tem pa ni priklica orodja.
diag-cycle-line-zero-missing = Pred vrstico { $line } manjka vrstica { $head }.
diag-cycle-line-empty = V vrstici { $line } cikla { $cycle } ni ničesar.
diag-cycle-line-missing =
    { $line ->
        [none] Manjka vrstica { $missing }: definicija ima samo ime.
       *[other] Pred vrstico { $line } manjka vrstica { $missing }.
    }
diag-cycle-line-twice = Vrstica { $line } je v tej definiciji dvakrat.
diag-cycle-not-covered =
    { $other ->
        [none] Cikel { $cycle } se ne preveri: priročniki krmiljenja { $control }, ki jih Ciklo pozna, takih ciklov ne obravnavajo.
       *[other] Priročniki krmiljenja { $control }, ki jih Ciklo pozna, ciklov, kakršen je { $cycle }, ne obravnavajo: preveri se po priročniku krmiljenja { $other }.
    }
diag-cycle-not-described =
    { $other ->
        [none] Cikel { $cycle } ({ $name }) je v priročnikih omenjen, a ne opisan: njegovi parametri se ne preverijo.
       *[other] Cikel { $cycle } ({ $name }) je v priročnikih omenjen, a ne opisan: preveri se po priročniku krmiljenja { $other }.
    }
diag-cycle-not-on-control = Cikla { $cycle } na krmiljenju { $control } ni; obstaja na: { $controls }.
diag-cycle-of-previous-tool = { $cycle } je bil definiran za prejšnje orodje, ki je z njim že obdelovalo.
diag-cycle-removes-nothing = { $cycle } tu ne odstrani ničesar: kjer gre njegovo orodje, ni materiala.
diag-datum-table-late = Prejšnji zamik ničelne točke vzame svojo vrstico iz druge preglednice: SEL TABLE programirajte pred njim.
diag-defined-but-never-called = { $cycle } je tu definiran, nikoli pa priklican.
diag-deviation-compared =
    { $what ->
        [deviation] { $parameter } je odstopanje od nazivne mere { $other }, primerja pa se s { $value }, kot da bi bil sama mera.
       *[size] { $parameter } je izmerjena mera (nazivna { $other }), primerja pa se s { $value }, kot da bi bil odstopanje.
    }
diag-digitizing-wrong =
    { $what ->
        [swapped] { $word } je pod točko MIN območja, { $other }.
        [low] Varna višina { $word } je pod točko MAX območja, { $other }.
        [missing] { $cycle } digitalizira, vendar pred tem ni definirano nobeno območje.
       *[combined] { $cycle } ni mogoče povezati z { $range }, ki tu določa območje.
    }
diag-arc-direction-missing = Manjka smer vrtenja tega loka, DR+ ali DR−.
diag-doubtful-value =
    { $parameter }={ $value } v { $cycle } je najbrž napaka: { $is ->
        [zero] vrednost je 0
        [negative] vrednost je negativna
        [small] vrednost je veliko manjša kot običajno
        [large] vrednost je veliko večja kot običajno
       *[positive] vrednost je pozitivna in vodi proč od obdelovanca
    }.
diag-duplicate-parameter = Parameter { $parameter } je v ciklu { $cycle } naveden dvakrat.
diag-early-cycle-wrong =
    { $what ->
        [corner] Polmer vogala žepa { $value } je manjši od polmera orodja { $other }.
        [clearance] Varnostna razdalja { $value } je negativna: cikel bi se začel pod svojo površino.
        [depth] Globina { $value } je pozitivna: cikel orodje odmika od obdelovanca.
        [infeed] Z globino primika 0 cikel ne more obdelovati.
        [feed] Pomik cikla je 0.
        [narrow] Orodje s premerom { $other } ne gre v utor ali žep mere { $value }.
        [pitch] Navoj ima korak { $value }, navojni sveder pa { $other }.
        [peck] Vrtina se vrta z enim primikom { $value }: več kot osemkratni premer svedra { $other }.
        [wide] Krožni žep je širok { $value }, surovec pa le { $other }: namesto polmera je morda vpisan premer.
        [sides] S stranicama { $value } in { $other } žep sega čez rob surovca; zamenjani bi bili v njem.
       *[tapped] Pomik { $value } ne ustreza navojnemu svedru: korak krat število vrtljajev je { $other }.
    }
diag-empty-word = Beseda { $word } tu nima vrednosti in ne naredi ničesar.
diag-feed-negative = Pomik je tu negativen.
diag-feed-zero = Pomik je tu enak nič.
diag-field-word-missing = Vrednost je tu brez besede; krmiljenje jo prikaže z njo: { $shown }.
diag-begin-end-mismatch = V END PGM je { $end }, v BEGIN PGM pa { $begin }.
diag-free-contour-wrong =
    { $what ->
        [label] Prosta kontura se ne more začeti takoj za oznako LBL.
        [again] Tu znova stoji CLSD+, čeprav CLSD- konture še ni sklenil.
        [unbegun] CLSD- sklene konturo, ki je ni začel noben CLSD+.
        [unclosed] Kontura, ki se je začela s CLSD+, se tu konča brez CLSD-.
        [length] Dolžina LEN ni pozitivna.
        [auxiliary] Razdalji D manjka pomožna točka (PDX, PDY).
        [distance] Pomožni točki manjka razdalja D.
        [selected] FSELECT ne stoji za nobenim elementom proste konture.
        [solution] FSELECT sprejme številko rešitve, ki se šteje od 1.
        [fpol] Pol proste konture potrebuje dve koordinati.
        [pole] Polarne koordinate potrebujejo pol (FPOL).
        [turn] Kontura se začne in konča na isti krožnici, vendar v različnih smereh.
       *[open] Za prosto konturo ni rešitve: vrednosti njenih elementov je premalo.
    }
diag-function-misspelled = Nobeno krmiljenje tu ne sprejme besede { $word }; morda je mišljeno { $meant }.
diag-function-not-on-control = Na krmiljenju { $control } ni na voljo: { $function }.
diag-functions-contradict = { $first } in { $second } se izključujeta, sta pa v istem stavku.
diag-global-def-wrong =
    { $what ->
        [unknown] GLOBAL DEF { $number } ne obstaja.
        [missing] V GLOBAL DEF { $number } manjka { $parameter }.
        [foreign] GLOBAL DEF { $number } nima { $parameter }.
        [twice] { $parameter } je v GLOBAL DEF { $number } dvakrat.
        [again] GLOBAL DEF { $number } je bil že programiran, njegovih vrednosti pa ni uporabil še noben cikel.
        [nothing] V { $value } ima { $parameter } vrednost PREDEF, ne nastavi pa ga noben GLOBAL DEF.
        [later] V { $value } ima { $parameter } vrednost PREDEF, GLOBAL DEF, ki ga nastavi, pa stoji šele za njim.
       *[value] Noben cikel ne sprejme { $parameter }={ $value }.
    }
diag-guard = Krmiljenje teh vrednosti ne sprejme.
diag-hole-outside-blank =
    { $what ->
        [beside] Vrtina pri { $value }; { $other } je ob surovcu.
        [edge] Rob surovca reže vrtino pri { $value }; { $other }.
        [surface] Površina pri { $value } je daleč od surovca.
        [tilted] Vrtine tega cikla ne zadenejo surovca: v zavrteni ravnini ležijo ob njem ali nad njim.
       *[through] Vrtina sega do { $value }, daleč skozi surovec.
    }
diag-incremental-left-on = Koordinate te konture so inkrementalne; samo kot absolutne vodijo nazaj na njen začetek.
diag-pattern-not-called = Cikel se tu prikliče na enem položaju, ne pa na položajih vzorca v vrstici { $line }.
diag-plunge-beside-hole = Stavek je prej zapeljal v vrtino, na { $value }, { $other } pa gre v poln material.
diag-polygon-incomplete =
    { $what ->
        [rectangle] Pravokotniku manjka oglišče pri { $value }, { $other }: ta črta ga odreže.
       *[polar] Pravilnemu mnogokotniku s { $count } oglišči manjka tisto pri { $value }°.
    }
diag-position-without-call = Orodje gre med dvema priklicema na { $value }, { $other } in tam ne naredi ničesar: morda manjka priklic (M99, CYCL CALL).
diag-result-of-other-axis =
    { $what ->
        [size] { $value } je želena vrednost za { $other }, tu pa se z njo primerja { $parameter }.
       *[axis] { $parameter } je rezultat za os { $axis }, tu pa se uporabi za { $other }.
    }
diag-holes-overlap =
    { $what ->
        [pockets] Žep ali utor okrog { $value }, { $other } sega v drugega z isto definicijo.
        [pocket] Vrtino na { $value }, { $other } reže žep ali utor, ki je bil rezkan prej.
        [hole] Izvrtino pri { $value }; { $other } po vsej dolžini reže širša, ki je bila narejena prej.
        [inside] Žep ali utor okoli { $value }; { $other } leži večinoma v drugem, prej izrezkanem in vsaj enako globokem, drugače kot drugi iz njegove definicije.
        [beside] Pri { $value }; { $other } se rezka širša izvrtina, izvrtine s predvrtanim premerom pa so drugje.
       *[holes] Dve vrtini s premerom { $other } sta tu narazen samo { $value }: prekrivata se.
    }
diag-insert-points-away = Rezalna ploščica ne more rezati v smeri, v katero gre { $cycle }: njena usmerjenost (TO) je { $orientation }, zato je konica obrnjena stran od obdelovanca ali od pomika.
diag-iso-incomplete =
    Ta stavek je nepopoln: { $what ->
        [value] črka nima vrednosti
        [label] manjka oznaka (L)
        [radius] manjka polmer ali dolžina (R)
        [cycle] manjkajo besede cikla (P01, P02, …)
       *[operand] manjka operand ali oznaka skoka (P01, P02, P03)
    }.
diag-label-duplicate = Oznaka LBL { $label } je postavljena dvakrat; tu je drugič.
diag-label-missing = Jezik »{ $language }« nima oznake za { $parameter } cikla { $cycle }.
diag-label-not-encodable = V oznaki »{ $label }« je znak »{ $character }«, ki ga v kodiranju datoteke ni.
diag-label-of-another-language = »{ $label }« je oznaka v drugem jeziku ({ $language }); v jeziku programa je oznaka parametra { $parameter } »{ $right }«.
diag-label-of-another-parameter = »{ $label }« je oznaka parametra { $other }, ne parametra { $parameter }.
diag-label-twice = »{ $label }« stoji pri { $parameter } in pri { $other }: prava je lahko samo pri enem od njiju.
diag-label-undefined = Noben stavek ne postavi oznake LBL { $label }.
diag-labels-of-unknown-language =
    { $count ->
        [one] Oznake v { $count } definiciji, ki je tukaj, so v jeziku, ki ga Ciklo ne pozna; prebrana je bila po številkah parametrov.
        [two] Oznake v { $count } definicijah od te naprej so v jeziku, ki ga Ciklo ne pozna; prebrani sta bili po številkah parametrov.
        [few] Oznake v { $count } definicijah od te naprej so v jeziku, ki ga Ciklo ne pozna; prebrane so bile po številkah parametrov.
       *[other] Oznake v { $count } definicijah od te naprej so v jeziku, ki ga Ciklo ne pozna; prebrane so bile po številkah parametrov.
    }
diag-languages-mixed = Večina oznak je v enem jeziku ({ $language }); definicije v teh vrsticah so v drugem ({ $others }): { $lines }.
diag-loop-endless =
    { $what ->
        [counter] Ta skok čaka na { $parameter }, vendar ga v zanki nič ne šteje.
       *[jump] Ta skok sklene zanko, ki se nikoli ne konča.
    }
diag-machine-coordinates-compensated = Strojne koordinate (M91, M92) so tu programirane s popravkom polmera.
diag-machine-coordinates-missing = Drugje se program odmakne na { $value } z M91; tu M91 manjka in višina velja od referenčne točke obdelovanca.
diag-main-runs-into-subprogram = Glavni program se tu nadaljuje v podprogram { $label }: pred njim ni ne M2 ne M30.
diag-measuring-height-above-surface = Merilna višina { $value } je nad obdelovancem, ki se konča pri { $other }.
diag-measuring-height-below-floor = { $cycle } meri na višini { $parameter }={ $value }, pod dnom pri { $floor }, ki ga tam pusti { $milling }.
diag-metric-values-in-inch = Program je v palcih, { $value } pa je videti kot vrednost v milimetrih.
diag-mirror-of-tool-axis = Orodne osi { $axis } ni mogoče zrcaliti.
diag-misordered-parameter = V ciklu { $cycle } krmiljenje prikaže { $parameter } pred { $before }.
diag-missing-parameter =
    { $count ->
        [one] V ciklu { $cycle } manjka { $parameter }.
        [two] V ciklu { $cycle } manjkata { $parameter }.
        [few] V ciklu { $cycle } manjkajo { $parameter }.
       *[other] V ciklu { $cycle } manjkajo { $parameter }.
    }
diag-modal-call-left-on =
    M89 v tem stavku še vedno prikliče cikel, { $what ->
        [beside] čeprav vodi na mesto ob surovcu
       *[again] zato se zadnji položaj obdela še enkrat
    }.
diag-mode-wrong =
    { $what ->
        [milling] { $cycle } rezka ali vrta, krmiljenje pa je tu v načinu struženja (FUNCTION MODE TURN).
        [turning] { $cycle } struži, krmiljenje pa tu ni v načinu struženja (FUNCTION MODE TURN).
       *[data] { $cycle } je tu zunaj načina struženja.
    }
diag-name-of-another-cycle = »{ $name }« je ime cikla { $other }, tu pa je { $cycle }.
diag-no-result =
    Ta formula nima rezultata: { $why ->
        [division] v njej se deli z nič
        [large] število je preveliko
       *[domain] funkcija za to vrednost ni definirana
    }.
diag-no-table-open = FN 27 in FN 28 potrebujeta preglednico, ki jo je odprl FN 26.
diag-nominal-differs = Želeni premer je tu { $value }, žep na tem mestu pa je širok { $other }.
diag-not-a-program = Ta datoteka ni NC-program.
diag-nothing-left = Vrtina je tu že široka { $other }: orodje s premerom { $value } ne odvzame ničesar.
diag-number-does-not-exist = { $name } ne obstaja: največja številka je { $greatest }.
diag-older-parameter-set = { $cycle } ima parametre starejše različice programske opreme; krmiljenje doda { $parameter }.
diag-out-of-range =
    { $side ->
        [below] { $parameter }={ $value } je premajhno: najmanjša vrednost je { $limit }.
        [long] Besedilo parametra { $parameter } je predolgo: dovoljenih znakov je največ { $limit }.
        [many] { $parameter } navaja preveč oznak: dovoljenih je največ { $limit }.
        [axes] { $parameter } navaja preveč osi: dovoljenih je največ { $limit }.
       *[above] { $parameter }={ $value } je preveliko: največja vrednost je { $limit }.
    }
diag-out-of-usual-range =
    { $parameter }={ $value } je najbrž napaka: { $where ->
        [control] { $control } tam ne sprejme vrednosti { $side ->
                [below] pod
               *[above] nad
            } { $limit }.
       *[any] noben priročnik za take parametre ne dovoljuje vrednosti { $side ->
                [below] pod
               *[above] nad
            } { $limit }.
    }
diag-parameter-of-later-software = { $parameter } v ciklu { $cycle } zahteva novejšo različico programske opreme od { $software }, ki jo opisuje priročnik.
diag-parameter-unassigned =
    { $parameter } se tu bere, vrednosti pa mu ni določilo nič.
diag-path-twice =
    { $what ->
        [repeated] Orodje gre po tej poti že tretjič: odstraniti ni ničesar več.
        [air] S tem preračunavanjem pot od tu naprej ne odvzame ničesar, čeprav so isti stavki z drugim rezali.
        [copied] Kontura od tu naprej je bila s tem orodjem že obdelana v drugih stavkih, čeprav je orodje pozicionirano drugam.
       *[transformed] Celotna pot od tu naprej je bila s tem orodjem že obdelana pri drugem preračunavanju koordinat.
    }
diag-path-not-closed = Ta podprogram se ne vrne na svoj začetek, čeprav je znova priklican na istem mestu: korak je { $value }, pot pa bi sklenil { $other }.
diag-pattern-combination =
    { $what ->
        [value] { $cycle } ne more priklicati { $called } z { $value }.
       *[cycle] { $cycle } ne more priklicati { $called }.
    }
diag-pattern-wrong =
    { $what ->
        [count] { $word } mora biti celo število položajev, najmanj 1.
        [many] { $word }: PATTERN DEF ima lahko največ devet posameznih položajev.
        [rapid] { $word } tu ni dovoljen: med točkami preglednice se orodje premika s pomikom.
        [distance] { $word } je 0: vsi položaji so isti.
        [angle] { $word } je več kot poln obrat.
        [same] { $word } ponovi prejšnji položaj.
       *[diameter] Premer { $word } delnega kroga mora biti večji od 0.
    }
diag-pilot-hole-too-shallow =
    { $what ->
        [bored] Orodje struži znotraj do { $value }, izvrtana vrtina pa se konča pri { $other }.
       *[start] Poglobljena začetna točka je pri { $value }, vrtina, ki je tam, pa se konča pri { $other }.
    }
diag-pilot-hole-elsewhere = Pri luknji na { $value }; { $other } se ne naredi nič drugega, žep pa se v polnem materialu začne tam, kjer sta koordinati zamenjani.
diag-plane-incomplete = V tem stavku PLANE manjka { $word }.
diag-plane-not-positioned =
    { $what ->
        [cycle] Po tem vrtenju ravnine noben stavek ne pozicionira rotacijskih osi; ali to stori cikel, je odvisno od stroja.
        [reset] PLANE RESET s STAY pusti rotacijske osi zasukane, obdelava pa se nadaljuje, preden jih kak stavek premakne nazaj.
       *[plane] STAY rotacijskih osi ne premakne in tudi noben stavek programa jih ne premakne na kote te ravnine.
    }
diag-plane-not-reset =
    { $what ->
        [zero] { $cycle } tu vse kote nastavi na 0, vrtenja obdelovalne ravnine pa nič ne izklopi.
       *[tilted] Program se tu konča z zavrteno obdelovalno ravnino.
    }
diag-plunge-too-fast =
    { $what ->
        [sideways] Orodje gre tu skozi poln material s pomikom, ki je { $value }-kratnik pomika iz priklica orodja.
        [tenfold] Orodje gre tu skozi poln material s pomikom, ki je { $value }-kratnik pomika njegovih drugih rezov.
        [turn] Orodje tu rezka po { $value } na vrtljaj, kar je veliko več, kot prenese orodje s takim premerom.
       *[plunge] Orodje tu prodira v material po { $value } na vrtljaj.
    }
diag-position-after-contour = To je prvi položaj za ciklom { $cycle }, nima pa absolutnih vrednosti za obe koordinati ravnine.
diag-position-missing = Orodje gre navzdol do { $value }, preden mu je program določil položaj v ravnini.
diag-position-twice =
    { $what ->
        [definition] Definicija je do besede enaka prej priklicani, orodje pa se od takrat ni premaknilo: obdelati ni ničesar več.
       *[place] Točka { $value }; { $other } je bila s to definicijo in tem orodjem že obdelana.
    }
diag-probe-while-turning = { $cycle } tu tipa, medtem ko se vreteno vrti.
diag-probed-axis-missing = Tipa se v smeri { $direction }, v položaju pa ni osi { $axis }.
diag-program-begin-missing = Program se ne začne z BEGIN PGM.
diag-program-begin-twice = BEGIN PGM je tu drugič.
diag-program-calls-itself = Program prikliče samega sebe: { $name }.
diag-program-empty = V datoteki ni stavkov.
diag-program-end-missing =
    Program se tu konča brez { $end ->
        [iso] sklepnega stavka, ki se začne s %
       *[pgm] END PGM
    }.
diag-programs-call-in-circle = Program { $name } neposredno ali prek drugih znova prikliče ta program.
diag-rapid-into-blank = Orodje se tu v hitrem teku premakne v surovec: gre na Z { $value }, zgornji rob surovca pa je pri { $top }.
diag-rapid-through-material = Orodje gre tu v hitrem teku skozi do { $value }{"\u00A0"}mm materiala.
diag-reaming-wrong =
    { $what ->
        [none] Tu ni vrtine, ki bi jo bilo mogoče povrtati.
        [deep] Povrtalo gre do { $value }, vrtina pa samo do { $other }.
        [bored] Drog za izstruževanje gre do { $value }, vrtina pa samo do { $other }.
        [stock] Vrtina je široka { $other }: drog za izstruževanje { $value } ne more odstraniti toliko.
       *[allowance] Vrtina je široka { $other }: za povrtalo { $value } ostane veliko preveč materiala.
    }
diag-repeat-count-wrong = Število ponovitev mora biti celo število od 0 do 65534.
diag-repeat-of-later-label = Oznaka LBL { $label } mora stati pred ponovitvijo, ne za njo.
diag-repeated-infeed =
    { $what ->
        [absolute] Preračunavanje v ponavljanem delu je absolutno: od drugega prehoda naprej naredi vsakič isto.
        [deep] Ponovitve vodijo do { $value }, daleč pod surovec.
       *[same] Vsaka ponovitev gre znova na { $value } in naredi isto kot prvi prehod.
    }
diag-reserved-parameter = Tu se piše v { $parameter }, parametri od Q100 do Q199 pa pripadajo krmiljenju, ki jih prepisuje.
diag-reset-order-wrong =
    { $what ->
        [tilt] Tu se ponastavi zavrtena ravnina, rotacija, vklopljena za njo, pa je še aktivna.
       *[shift] Tu se ponastavi zamik ničelne točke, ravnina, zavrtena za njim, pa je še zavrtena.
    }
diag-retract-missing =
    { $what ->
        [change] Orodje je še pri { $value }, v surovcu, ob njem ali tik nad njim, ko se zamenja: ni bilo odmaknjeno.
        [tilt] Orodje je še pri { $value }, v surovcu, ob njem ali tik nad njim, ko se ravnina zavrti z MOVE: ni bilo odmaknjeno.
        [end] Orodje je še pri { $value }, v surovcu, ob njem ali tik nad njim, ko se program konča: ni bilo odmaknjeno.
        [others] Osi se tu zasukajo po odmiku samo na { $value }; pred vsemi drugimi zasuki se orodje odmakne dlje.
        [unretracted] Osi se tu zasukajo, čeprav se orodje po obdelavi ni odmaknilo; pred vsemi drugimi zasuki se odmakne.
        [rapid] Orodje je še pri { $value }, v surovcu, ob njem ali tik nad njim, ko nadaljuje v hitrem teku, drugače kot po drugih vrsticah površine: ni bilo odmaknjeno.
       *[turn] Orodje je še pri { $value }, v surovcu, ob njem ali tik nad njim, ko se rotacijska os premakne v hitrem teku: ni bilo odmaknjeno.
    }
diag-rotary-axis-jumps = Rotacijska os tu zaniha od { $other } do { $value } in v naslednjem stavku nazaj.
diag-row-not-in-table =
    { $table ->
        [preset] V preglednici prednastavitev ni vrstice { $row }.
       *[datum] V preglednici ničelnih točk ni vrstice { $row }.
    }
diag-program-not-selected = Tu se prikliče izbrani program, izbran pa ni bil noben.
diag-shift-in-tilted-plane = Ničelna točka se v zavrteni ravnini premakne na { $parameter }, ki je bil izmerjen v nezavrteni.
diag-speed-missing = Vreteno se tu vklopi, število vrtljajev za to orodje pa ni programirano.
diag-speed-out-of-range =
    { $what ->
        [feed] Pomik { $value }
       *[speed] Število vrtljajev vretena { $value }
    } je najbrž napaka: { $side ->
        [below] vrednost je negativna
       *[above] priročniki dovoljujejo največ { $limit }
    }.
diag-stepover-too-wide = Vrstice so { $value } narazen, orodje pa je široko le { $other }: med njimi ostanejo rebra.
diag-spindle-direction = { $cycle } potrebuje vreteno, ki se vrti v desno, tu pa se vrti v levo.
diag-spindle-off = Orodje tu reže, medtem ko vreteno miruje.
diag-sql-handle-missing =
    { $what ->
        [ended] COMMIT ali ROLLBACK je transakcijo s HANDLE { $handle } že končal.
       *[missing] Nobena poizvedba ni vrnila vrednosti HANDLE { $handle }.
    }
diag-subprogram-end-without-label = Ta LBL 0 ne konča nobenega podprograma.
diag-subprogram-recursive = Podprogram { $label } tu prikliče samega sebe.
diag-subprogram-runs-on = Podprogram { $label } se nadaljuje v podprogram { $next }: med njima ni LBL 0.
diag-subprogram-without-end = Podprogram { $label } teče do konca programa brez LBL 0.
diag-tcpm-left-on =
    { $what ->
        [tool] Tu se prikliče orodje, medtem ko je aktiven M128 ali FUNCTION TCPM.
       *[end] Program se tu konča, medtem ko je aktiven M128 ali FUNCTION TCPM.
    }
diag-text-for-number =
    { $what ->
        [text] { $parameter } sprejme število, to pa je besedilo.
        [number] { $parameter } sprejme besedilo, to pa je število.
       *[calculation] Z besedili ni mogoče računati.
    }
diag-text-wrong =
    { $what ->
        [empty] Besedilo parametra { $parameter } je prazno.
        [alone] »{ $found }« v besedilu parametra { $parameter } ni podvojen in ne stoji pred črko.
       *[character] Znak »{ $found }« v { $parameter } ni dovoljen.
    }
diag-thread-pitch-unusual = Korak { $value } ni standarden za navoj s premerom { $other }.
diag-tool-axis-missing = Ta priklic orodja nima orodne osi, pa tudi prejšnji je ni navedel.
diag-tool-axis-other =
    { $what ->
        [pattern] PATTERN DEF deluje samo z orodno osjo { $axis }, tu pa je aktivna druga.
        [lifted] Ta priklic orodja navaja drugo orodno os kot surovec, orodje pa se odmika samo po osi { $axis }.
       *[blank] Surovec ima orodno os { $axis }, nima pa je nobeno orodje programa.
    }
diag-tool-cuts-sideways = Sveder, navojni sveder ali povrtalo se tu pomika bočno skozi material.
diag-tool-definition-wrong =
    { $what ->
        [zero] Orodje 0 pomeni, da orodja ni, in ga ni mogoče določiti.
        [twice] Orodje { $tool } je bilo že določeno z drugimi merami.
       *[after-call] Orodje { $tool } je določeno tu, priklicano pa je bilo že prej.
    }
diag-tool-feed-missing = Tu se uporabi pomik iz priklica orodja, ta pa pomika nima.
diag-tool-missing = Tu cikel premika osi, noben prejšnji priklic orodja pa ni določil orodne osi.
diag-tool-not-changed = { $cycle } se prikliče z orodjem, ki je že izvedlo { $before }: potrebuje drugo orodje.
diag-tool-not-listed = V preglednici orodij ni orodja { $tool }.
diag-tool-radius-outdated = To se izračuna s polmerom prejšnjega orodja (Q108), bere pa se šele po priklicu drugega orodja.
diag-turning-start-wrong =
    { $what ->
        [positive] Cikel za struženje se ne začne tam, kjer je orodje: kontura gre v pozitivno smer Z, stran od obdelovanca.
        [z] Cikel za struženje se ne začne tam, kjer je orodje: orodje je v smeri Z za koncem konture.
        [bar] Orodje za notranje struženje tukaj struži zunaj: cikel določi stran po položaju orodja.
        [outer] Orodje za zunanje struženje tukaj struži znotraj: cikel določi stran po položaju orodja.
        [inwards] To orodje je prej stružilo zunaj, tukaj pa struži znotraj: cikel določi stran po položaju orodja.
        [outwards] To orodje je prej stružilo znotraj, tukaj pa struži zunaj: cikel določi stran po položaju orodja.
        [start] Notranje struženje se začne pri premeru { $value }, vrtina pa je široka le { $other }: orodje gre v polni material.
        [thick] Drog je širok { $value }, vrtina pa le { $other }.
       *[diameter] Cikel za struženje se ne začne tam, kjer je orodje: orodje je za končnim premerom konture.
    }
diag-uncalculable-contour =
    Krmiljenje tukaj ne more izračunati konture: { $what ->
        [open] manjkajo podatki, ki določajo ta element
        [contradicts] podatki tega elementa si nasprotujejo
        [several] podatkom ustreza več elementov, izbran pa ni noben
        [rounding] zaokrožitev ali posneti rob ne gre med svoja elementa
        [crossing] kontura seka samo sebe
       *[approach] na konturo tako ni mogoče primakniti
    }.
diag-value-unlike-others =
    { $what ->
        [feed] Pomik je tu { $value }, v priklicu orodja pa { $other }.
        [sign] Višina je tu { $value }, med nižjimi na isti poti; ustrezala bi { $other }.
        [depth] Globina je tu { $value }; v drugih ciklih programa so globine negativne.
        [path] Koordinata je tu { $value }, daleč od sosednjih točk na isti poti; ustrezala bi { $other }.
        [angle] Kot je tu { $value }; korakom drugih kotov bi ustrezal { $other }.
       *[others] Vrednost je tu { $value }, na vseh drugih takih mestih pa { $other }.
    }
diag-wall-left = Odprta kontura pusti ob robu surovca { $value } mm široko steno: RL in RR sta morda zamenjana.
diag-wrong-tool-type =
    { $what ->
        [probe] { $cycle } tu tipa z orodjem, ki je pravkar obdelovalo.
        [measured] { $cycle } tu meri orodje, ki je pravkar tipalo.
        [contour] Orodje, ki je pravkar tipalo, se tu premika po konturi.
        [named] { $cycle } tu meri tipalni sistem, če ime orodja drži.
        [calibrates] { $cycle } tu umeri namizni tipalni sistem z rezalnim orodjem.
       *[mill] { $cycle } tu obdeluje z orodjem, ki je pravkar tipalo.
    }
diag-tool-unused = Tu se prikliče orodje { $tool }, naslednji stavek pa prikliče drugo.
diag-tool-zero = { $cycle } se izvede z orodjem 0: v vretenu ni orodja.
diag-transfer-parameter-overwritten =
    { $what ->
        [passed] { $cycle } je parameter { $parameter } prebral ob definiciji: tu zapisana vrednost na njegov priklic ne vpliva.
        [filled] { $cycle } zapolni štiri parametre od tu navedenega naprej in prepiše { $parameter }, v katerega je program že pisal in ga pozneje bere.
        [lost] { $cycle } prepiše parameter { $parameter }, preden program prebere tu zapisano vrednost.
        [result] { $parameter } se po eni meritvi kopira dvakrat: rezultat meritve pred njo je bil prepisan neprebran.
       *[call] { $parameter } pripada ciklu { $cycle }, ki se prikliče pozneje: priklic uporabi tu zapisano vrednost.
    }
diag-transformation-forbidden =
    { $cycle } se uporablja, čeprav je { $what ->
        [datum-shift] aktiven zamik ničelne točke
        [rotation] aktivna rotacija
        [tcpm] aktivna funkcija M128 ali FUNCTION TCPM
        [other-axis] orodna os druga kot Z
        [turning] aktiven način struženja (FUNCTION MODE TURN)
       *[tilting] obdelovalna ravnina zavrtena
    }, kar priročnik prepoveduje.
diag-transformation-without-effect =
    { $what ->
        [again] { $cycle } definira preračunavanje, ki je že aktivno, isti podprogram pa se prikliče še enkrat.
       *[ended] { $other } konča preračunavanje cikla { $cycle }, preden ga karkoli uporabi.
    }
diag-transformation-left-on =
    Program se tu konča, ko je še { $what ->
        [datum-shift] aktiven zamik ničelne točke
        [rotation] aktivna rotacija
        [mirroring] aktivno zrcaljenje
       *[scaling] aktiven faktor merila
    }.
diag-feed-unit =
    { $what ->
        [revolution] { $parameter }={ $value } je tu pomik na vrtljaj, ker je M136 aktiven.
        [revolving] { $parameter }{ $value } je tu pomik na vrtljaj, ker je M136 aktiven.
        [large] { $parameter }={ $value } je tu pomik na vrtljaj in za struženje veliko prevelik.
        [moving] { $parameter }{ $value } je tu pomik na minuto, ker M136 ni aktiven.
       *[minute] { $parameter }={ $value } je tu pomik na minuto, ker M136 ni aktiven.
    }
diag-turning-system-missing = { $cycle } se tu prikliče, od priklica orodja naprej pa { $aligning } ni bil definiran.
diag-cutting-speed-unlimited = Hitrost rezanja je konstantna, število vrtljajev pa ni omejeno; v vrstici { $line } pride orodje do rotacijske osi.
diag-two-signs = Pred številom sta dva predznaka; bereta se kot { $right }.
diag-unknown-cycle =
    { $name ->
        [none] { $cycle } ne omenja noben priročnik, ki ga Ciklo pozna.
       *[other] { $cycle } ({ $name }) je cikel prvih krmiljenj: še vedno se izvede, njegove vrednosti pa se ne preverijo.
    }
diag-unknown-parameter = Cikel { $cycle } na tem krmiljenju nima parametra { $parameter }.
diag-differs-from-other-control =
    { $what ->
        [missing] { $cycle } ima na krmiljenju { $control } parameter { $parameter }, ki tu manjka.
        [value] Krmiljenje { $control } v { $cycle } ne sprejme { $parameter }={ $value }.
        [twice] { $parameter } je v { $cycle } dvakrat.
        [foreign] { $cycle } na krmiljenju { $control } nima parametra { $parameter }.
        [order] { $parameter } stoji za { $before }, v { $cycle } na krmiljenju { $control } pa pred njim.
        [label] »{ $label }« v { $cycle } na krmiljenju { $control } pripada { $other }, ne { $parameter }.
        [doubt] { $cycle } je dvomljiv: { $message }
        [alone] { $parameter }={ $value }, kakor v { $cycle }, ne sprejme noben cikel s tem parametrom.
       *[guard] Krmiljenje { $control } bi { $cycle } zavrnilo: { $message }
    }
diag-unreachable =
    { $part ->
        [label] Nič ne vodi do te oznake LBL.
       *[block] Ta stavek se nikoli ne izvede.
    }
diag-meaningless-value = Vrednost { $value } tu ni mogoča.
diag-word-missing = V tem stavku manjka { $word }.
diag-word-twice = { $word } je v tem stavku navedeno dvakrat.
diag-word-wrong =
    { $what ->
        [below] Vrednost { $value } besede { $word } je premajhna.
        [above] Vrednost { $value } besede { $word } je prevelika.
        [whole] { $word } je { $value }, biti pa mora celo število.
        [offers] Za { $word } mora stati eno od: { $value }.
        [contradict] { $word } in { $value } se izključujeta.
        [zero] { $word } ne smejo biti vsi 0.
        [not-below] { $word } mora biti manjši od { $value }.
        [operator] Tu stoji »{ $word }« namesto { $value }.
        [empty] Ime je prazno.
        [value] Za { $word } manjka vrednost.
        [place] { $word } v tem stavku ni dovoljeno.
        [line] Tri točke ležijo na isti premici in ne določajo ravnine.
        [parallel] Vektorja sta vzporedna in ne določata ravnine.
        [number] Besedilo v { $word } ni število: »{ $value }«.
        [beyond] { $word } je { $value }, kar je za koncem besedila.
        [file] { $value } ni datoteka { $word }.
        [shorter] { $word } je { $value }: krmiljenje ima orodje za toliko krajše in vse postane za toliko globlje.
        [askew] Osnovni in normalni vektor morata biti pravokotna drug na drugega.
       *[tool] { $value } ni številka orodja: za piko sme stati samo ena števka.
    }
diag-wrong-value-kind =
    Parameter { $parameter } cikla { $cycle } sprejme { $kind ->
        [integer] celo število
        [number-or-name] število ali ime v narekovajih
        [text] besedilo v narekovajih
        [q-number] Q-parameter
        [axis-direction] os s predznakom, na primer X-
        [position] koordinate po oseh, na primer X+5 Y+0
        [row] vrstico preglednice, na primer #5
        [axis] os
        [label-list] številke oznak, ločene s poševnicami, na primer 1/2/3
       *[number] število
    }{ $words-count ->
        [0] {""}
       *[other] {" "}ali { $words }
    }.
diag-coolant-forgotten = To orodje reže brez hladilne tekočine; vsa druga orodja programa jo vklopijo.
diag-comment-contradicts =
    { $what ->
        [digits] Vrednost je tu { $value }, v komentarju pa { $other }: dve števki sta zamenjani.
        [result] Rezultat je { $value }, ne { $other }, kot pravi komentar.
        [scale] Faktor merila { $value } ne ustreza { $other } odstotkom iz komentarja.
        [parameter] Tu se bere { $value }, komentar zgoraj pa navaja { $other }.
       *[holes] Število lukenj po tem priklicu orodja je { $value }, v komentarju pa { $other }.
    }
diag-decimal-comma = Ta vrednost ima decimalno vejico, druge vrednosti programa pa decimalno piko.
diag-definitions-differ =
    { $what ->
        [deep] Globina primika { $value } vzame vso globino { $other } naenkrat, kar je več od premera orodja.
        [infeed] Globina primika je tu { $value }, v drugi definiciji istega žepa ali utora pa { $other }.
        [operation] Obe definiciji tega žepa ali utora samo grobo rezkata: nadmera { $other } ostane.
        [turned] Vrednost je tu { $value }, v definiciji, ki grobo struži isto konturo, pa { $other }.
       *[size] Vrednost je tu { $value }, v definiciji, ki grobo rezka isti žep ali utor, pa { $other }.
    }
diag-helix-too-steep =
    { $what ->
        [up] Vijačnica se dvigne za { $value }, čeprav ji sledi poln krog kot na dnu: njen predznak je napačen.
        [pitch] Vijačnica ima korak { $value }, rezkar za navoje pa { $other }.
        [left] Ta vijačnica reže levi navoj; niti orodje niti komentar ne pove, da je tak.
       *[steep] Vijačnica se v enem obratu spusti za { $value }; več kot { $other } tu ne reže nobeno orodje.
    }
diag-holes-differ =
    { $what ->
        [stray] Vrtina pri { $value }; { $other } ni bila centrirana, eno centrirano mesto pa je brez vrtine.
        [untapped] V izvrtino pri { $value }; { $other } se ne vreže navoj, v druge iste vrste pa se.
        [unreamed] Vrtina pri { $value }; { $other } se ne povrta, druge iste vrste pa se.
        [uncentred] Vrtina pri { $value }; { $other } ni bila centrirana, vse druge iste vrste pa so bile.
        [unused] Mesto { $value }; { $other } je bilo centrirano in ostane brez vrtine, drugače kot vsa druga iste vrste.
        [gap] V krogu vrtin manjka vrtina pri { $value }; { $other }.
        [corner] Ta vrtina ne leži v oglišču { $value }; { $other } pravokotnika, ki ga tvorijo druge tri.
        [passed] Orodje se ustavi pri { $value }; { $other } in tam ne naredi ničesar; stavka pred njim in za njim prikličeta cikel.
        [rotation] Orodje tu obdeluje pri { $value } od { $other } enakih kotov polnega kroga: eden manjka.
       *[arc] Središče zgreši vrtino pri { $value }; { $other }; drugi loki ležijo okrog vrtin.
    }
diag-probing-place-wrong =
    { $what ->
        [angle] Izvrtina se meri pri { $value } stopinjah, vzorec pa je tam ne naredi.
        [apart] Druga izvrtina je le { $value } od prve, katere premer je { $other }.
        [side] Tu se tipa stranica { $value }, surovec pa je tam širok { $other }: tipalo se spusti nanj.
        [centre] Pri tem središču ni bilo nič obdelano, pri { $value }; { $other } pa je bilo.
        [corner] Vogal se tipa na drugi strani surovca kot referenčna točka { $value }.
        [size] Tu se tipa mera { $value }, surovec pa je tam širok le { $other }.
        [axis] Meri se os, na kateri je mesto pri { $value }, največja mera pa je { $other }: meji sta od druge osi.
        [later] Tu se tipa premer { $value }, pozneje pa v istem središču { $other }: tipalo se spusti ob izvrtini.
        [removed] Površina pri { $value }, ki se tu tipa, je bila prej odvzeta do { $other }.
        [across] Na tej osi se tipa širina { $value }, tu izrezkano pa je v njeni smeri široko { $other }: leži v drugi smeri.
       *[outside] Mesto { $value }; { $other } je ob surovcu: tam ni česa otipati.
    }
diag-rough-out-tool-other =
    { $what ->
        [pilot] Tu je navedeno orodje { $value }, posnema pa orodje { $other }.
       *[coarse] Orodje { $value } prej ni posnemalo; posnemalo je orodje { $other }.
    }
diag-speed-and-feed-exchanged = Orodje se prikliče s številom vrtljajev { $value } in pomikom { $other }: videti je, da sta zamenjana.
diag-stud-in-solid = Surova mera { $value } je veliko manjša od surovca okrog čepa, ki je tu širok { $other }.
diag-surface-wrong =
    { $what ->
        [unlike] Površina je na { $value }, površina drugih ciklov na teh mestih na { $other }, tako globoko pa doslej ni bilo nič obdelano.
        [opposite] Površina pri { $value } je nad surovcem; druge obdelave se začnejo ali končajo pri { $other }.
        [pattern] Površina vzorca je pri { $value }, površina cikla, ki ga kliče, pa pri { $other }: velja tista iz vzorca.
        [air] Cikel tu dela v zraku: gre do { $value }, kjer je bilo vse že prej odstranjeno.
        [high] Cikel začne tam, kjer je priklican, pri { $value }: njegova površina je potem pri { $other }, nad surovcem.
        [low] Cikel je priklican v surovcu, pri { $value }, do njegove površine pri { $other } pa ni bilo obdelano nič.
        [below] Cikel se v hitrem teku spusti na { $value }, drugi pa so tu šli samo do { $other }: zapelje v material.
        [cylinder] Valj ima polmer { $value }, surovec okrog njegove osi pa { $other }.
       *[faced] Površina je pri { $value }, ploskev pa je bila rezkana do { $other }.
    }
diag-turned-thread-wrong =
    { $what ->
        [pitch] Korak { $value } je veliko prevelik za navoj s premerom { $other }.
        [tool] Navoj ima korak { $value }, orodje pa je narejeno za { $other }.
        [end] Navoj sega do { $value }, čez konec svojega valja pri { $other }.
        [groove] Navoj sega do { $value }, čez utor, ki se konča pri { $other }.
        [inside] Na premeru { $value }, ki je bil stružen zunaj, se reže notranji navoj.
        [speed] Navoj se struži s konstantno rezalno hitrostjo (VCONST:ON): število vrtljajev se od reza do reza spreminja.
       *[diameter] Navoj ima premer { $value }, tam pa je bilo struženo { $other }.
    }
diag-tilted-work =
    { $what ->
        [beside] V zavrteni ravnini ta cikel nikjer ne zadene surovca.
       *[stands] Cikel se začne pri { $value }, v zavrteni ravnini pa surovec tu sega do { $other }.
    }
diag-circle-point-wrong =
    { $what ->
        [angle] { $parameter } se računa s kotom { $value }, { $other } pa s kotom { $angle }: obe koordinati točke na krogu imata isti kot.
       *[function] { $parameter } in { $other } se oba izračunata z { $value } istega kota: točka na krogu ima v eni koordinati sinus, v drugi pa kosinus.
    }
diag-formula-wrong =
    { $what ->
        [square] { $parameter } je vsota ali razlika kvadratov in se uporablja kot dolžina: manjka kvadratni koren.
       *[radius] { $parameter } se izračuna z drugim predznakom polmera orodja Q108 kot pred prejšnjim priklicem: orodje je na drugi strani iste mere.
    }
diag-correction-wrong =
    { $what ->
        [side] { $parameter } se popravi za { $other }, kar je odstopanje druge stranice.
        [actual] { $other } je izmerjena mera sama in ne njeno odstopanje: od mere { $parameter } ne ostane skoraj nič.
        [radius] { $parameter } je odstopanje premera ali širine in popravi polmer orodja, ne da bi bilo razpolovljeno.
        [turned] Odstopanje { $parameter } popravi polmer orodja z napačnim predznakom: napaka se podvoji.
       *[added] Odstopanje { $other } se prišteje meri { $parameter }: treba ga je odšteti.
    }
diag-monitored-tool-idle =
    { $what ->
        [elsewhere] { $cycle } nadzoruje ali popravlja orodje { $tool }, ki merjenega ni rezkalo: to je naredilo orodje { $other }.
       *[idle] { $cycle } nadzoruje ali popravlja orodje { $tool }, ki prej ni bilo priklicano.
    }
