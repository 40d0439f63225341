# Findings of the program checker and of the translation of programs.

diag-approach-twice = Primik na konturo je tu pri aktivnem popravku polmera: prejšnja kontura ni bila zapuščena.
diag-approach-without-compensation =
    { $what ->
        [approach] Primik na konturo je tu brez RL ali RR.
       *[departure] Tu je odmik s konture, popravek polmera pa ni aktiven.
    }
diag-arc-in-unequal-scaling = { $cycle } spreminja merilo osi tega loka z različnimi faktorji.
diag-arc-too-narrow = Polmer { $radius } na notranji strani konture je manjši od polmera orodja { $tool }.
diag-arc-without-tangent = Pred tem tangencialnim lokom ni elementa konture.
diag-arc-wrong =
    Lok se tu ne more končati: { $what ->
        [radius] polmer je { $first }, razdalja med začetkom in koncem pa { $second }
        [full] konča se na začetku; središče polnega kroga iz polmera ne izhaja
        [sense] kot je { $first }, DR pa obrača v drugo smer
       *[centre] začetek je od središča oddaljen { $first }, konec pa { $second }
    }.
diag-axis-twice = Os { $axis } je v tem stavku navedena dvakrat.
diag-blocks-after-end = Za stavkom END PGM so še drugi stavki.
diag-blank-wrong =
    { $what ->
        [again] Surovec že ima BLK FORM 0.1 pred tem.
        [axis] Tu manjka { $axis }: vogal surovca ima tri koordinate.
        [first] Pred BLK FORM 0.2 ni BLK FORM 0.1.
        [cylinder] Valju manjka polmer ali premer oziroma dolžina.
        [second] Za BLK FORM 0.1 ni BLK FORM 0.2.
        [tool] Pri surovcu ni navedena orodna os.
       *[order] Na osi { $axis } koordinata drugega oglišča surovca ni večja od koordinate prvega.
    }
diag-block-numbers = Številka stavka { $number } sledi številki { $before }.
diag-call-of-def-active-cycle = Cikel { $cycle } deluje takoj, ko je definiran; ni ga dovoljeno priklicati.
diag-called-but-not-defined = Tu se prikliče cikel, pred tem pa ni definiran noben.
diag-called-program-in-other-unit = Ta program je v { $own }, klicani program { $name } v { $other }.
diag-called-program-missing = Programa { $name } ni ob tem programu, kjer ga krmiljenje išče.
diag-centre-in-other-plane = Krožni lok poteka v drugi ravnini kot njegovo središče.
diag-choice-not-offered = { $parameter }={ $value } ni med možnostmi: { $offered }.
diag-clearance-height-too-low = { $cycle } se dotakne pri { $touched }: varna višina { $parameter }={ $value } mora biti nad { $least }.
diag-compensation-at-cycle =
    { $cycle } se tu izvede pri aktivnem popravku polmera.
diag-compensation-left-on = Popravek polmera je tu še aktiven.
diag-compensation-on-arc = Popravek polmera se tu začne na loku.
diag-compensation-switched = Popravek polmera tu zamenja stran brez vmesnega R0.
diag-contour-data-missing = { $cycle } se prikliče, { $data } pa pred tem ni definiran.
diag-contour-def-wrong =
    { $what ->
        [number] { $found }: to številko že ima druga kontura.
        [many] { $found }: CONTOUR DEF ima največ devet kontur.
       *[island] { $found }: prva kontura v CONTOUR DEF je žep, in sicer najgloblji.
    }
diag-contour-depth-missing = { $contour } nima DEPTH, druge konture ga imajo.
diag-contour-undeclared =
    { $what ->
        [twice] { $contour } je že določena prej.
       *[nothing] Formula bere { $contour }, ki je prej nič ne navede.
    }
diag-contour-not-selected =
    { $cycle } se tu prikliče, pred tem pa ni navedena nobena kontura.
diag-contour-wrong =
    { $cycle } te konture ne more obdelati: { $what ->
        [axis] v njej je premik orodne osi { $word }
        [approach] v njej je { $word }
        [tool] v njej je { $word }
        [call] v njej je { $word }
        [path] cikel ne bere elementa { $word }
        [first] prva točka ne navede obeh koordinat ravnine
        [uncompensated] v njej ni niti RL niti RR
        [many] cikel obdela samo prvo konturo, ne { $word }
        [corner] za { $word } ni elementa konture
        [local] v njej se bere { $word }, ki v njej ne dobi vrednosti
       *[open] ne konča se tam, kjer se začne
    }.
diag-coordinate-out-of-place = Koordinate ne ustrezajo stavku { $path }.
diag-corner-wrong =
    Tega vogala ni mogoče obdelati: { $what ->
        [twice] pred njim je že zaokrožitev ali posneti rob
        [arc] posneti rob leži med premicama, tu pa je lok
        [first] pred njim ni elementa konture
        [alone] za njim ni konturnega elementa
        [back] premica za njim vodi nazaj po premici pred njim
        [size] njegov polmer ali dolžina ni pozitivna
       *[long] potrebuje več, kot ima krajša premica, { $least }
    }.
diag-cutting-without-tool = Orodje se tu premika s pomikom, pred tem pa ni priklica orodja.
diag-cycle-line-zero-missing = Pred vrstico { $line } ni vrstice { $head }.
diag-cycle-line-empty = V vrstici { $line } cikla { $cycle } ni ničesar.
diag-cycle-line-missing = Pred vrstico { $line } manjka vrstica { $missing }.
diag-cycle-line-twice = Vrstica { $line } je v tej definiciji dvakrat.
diag-cycle-not-covered =
    { $other ->
        [none] Cikel { $cycle } se ne preveri: priročniki krmiljenja { $control }, ki so tu znani, takšnih ciklov ne obravnavajo.
       *[other] Priročniki krmiljenja { $control }, ki so tu znani, ciklov, kakršen je { $cycle }, ne obravnavajo: primerja se s priročnikom krmiljenja { $other }.
    }
diag-cycle-not-described =
    { $other ->
        [none] Cikel { $cycle } ({ $name }) je v priročnikih omenjen, a ne opisan: njegovi parametri se ne preverijo.
       *[other] Cikel { $cycle } ({ $name }) je v priročnikih omenjen, a ne opisan: primerja se s priročnikom krmiljenja { $other }.
    }
diag-cycle-not-on-control = Cikla { $cycle } na krmiljenju { $control } ni; obstaja na: { $controls }.
diag-cycle-of-previous-tool = { $cycle } je bil definiran za prejšnje orodje, ki je z njim že obdelovalo.
diag-datum-table-late = Prejšnji zamik ničelne točke je svojo vrstico vzel iz druge preglednice: SEL TABLE mora stati pred njim.
diag-defined-but-never-called = Cikel { $cycle } je tu definiran, nikoli pa priklican.
diag-digitizing-wrong =
    { $what ->
        [swapped] { $word } je manj od točke MIN območja, { $other }.
        [low] Varna višina { $word } je pod točko MAX območja, { $other }.
        [missing] { $cycle } digitalizira, vendar pred tem ni definirano nobeno območje.
       *[combined] { $cycle } ni mogoče povezati z { $range }, ki tu določa območje.
    }
diag-arc-direction-missing = Lok ne pove, v katero smer poteka: manjka DR+ ali DR−.
diag-doubtful-value =
    { $parameter }={ $value } v { $cycle } najbrž ni mišljeno: { $is ->
        [zero] vrednost je 0
        [negative] vrednost je negativna
       *[positive] vrednost je pozitivna in vodi proč od obdelovanca
    }.
diag-duplicate-parameter = Parameter { $parameter } je v ciklu { $cycle } naveden dvakrat.
diag-empty-word = Beseda { $word } tu nima vrednosti in ne naredi ničesar.
diag-feed-negative = Pomik je tu negativen.
diag-feed-zero = Pomik je tu nič.
diag-field-word-missing = Vrednost je tu brez besede; krmiljenje jo prikaže z njo: { $shown }.
diag-begin-end-mismatch = V END PGM je { $end }, v BEGIN PGM pa { $begin }.
diag-free-contour-wrong =
    { $what ->
        [label] Prosta kontura se ne more začeti takoj za oznako LBL.
        [again] Tu znova stoji CLSD+, čeprav CLSD- konture še ni sklenil.
        [unbegun] CLSD- tu sklene konturo, ki je ni začel noben CLSD+.
        [unclosed] Kontura, ki se je začela s CLSD+, se tu konča brez CLSD-.
        [length] Dolžina LEN ni pozitivna.
        [auxiliary] Razdalji D manjka pomožna točka (PDX, PDY).
        [distance] Pomožni točki manjka razdalja D.
        [selected] FSELECT ne stoji za nobenim elementom proste konture.
        [solution] FSELECT sprejme številko rešitve, ki se šteje od 1.
        [fpol] Pol proste konture ima dve koordinati.
        [pole] Tu so polarni podatki brez pola (FPOL).
       *[open] Prosta kontura ni določena: o njenih elementih je znanega premalo.
    }
diag-function-misspelled = Nobeno krmiljenje tu ne pozna besede { $word }; morda je mišljeno { $meant }.
diag-function-not-on-control = Na krmiljenju { $control } ni na voljo: { $function }.
diag-functions-contradict = { $first } in { $second } sta v istem stavku; mišljena je lahko samo ena od njiju.
diag-global-def-wrong =
    { $what ->
        [unknown] GLOBAL DEF { $number } ne obstaja.
        [missing] V GLOBAL DEF { $number } manjka { $parameter }.
        [foreign] GLOBAL DEF { $number } ne daje { $parameter }.
        [twice] { $parameter } je v GLOBAL DEF { $number } dvakrat.
        [again] GLOBAL DEF { $number } je že naveden in noben cikel še ni uporabil njegovih vrednosti.
        [nothing] V { $value } je za { $parameter } PREDEF, pa ga noben GLOBAL DEF ne daje.
        [later] V { $value } je za { $parameter } PREDEF, GLOBAL DEF, ki ga daje, pa stoji šele za njim.
       *[value] Noben cikel ne sprejme { $parameter }={ $value }.
    }
diag-guard = Krmiljenje teh vrednosti ne sprejme.
diag-hole-outside-blank =
    { $what ->
        [beside] Izvrtina pri { $value }; { $other } je zraven surovca.
        [surface] Površina pri { $value } ni na surovcu.
       *[through] Izvrtina sega do { $value }, daleč skozi surovec.
    }
diag-iso-incomplete =
    Ta stavek je nepopoln: { $what ->
        [value] črka nima vrednosti
        [label] manjka oznaka (L)
        [radius] manjka polmer ali dolžina (R)
        [cycle] manjkajo besede cikla (P01, P02, …)
       *[operand] manjka operand ali oznaka skoka (P01, P02, P03)
    }.
diag-label-duplicate = Oznaka LBL { $label } je tu postavljena drugič.
diag-label-missing = Jezik »{ $language }« nima oznake za { $parameter } cikla { $cycle }.
diag-label-not-encodable = V oznaki »{ $label }« je znak »{ $character }«, ki ga kodiranje datoteke ne pozna.
diag-label-of-another-language = »{ $label }« je oznaka v drugem jeziku ({ $language }); v jeziku programa je oznaka parametra { $parameter } »{ $right }«.
diag-label-of-another-parameter = »{ $label }« je oznaka parametra { $other }, ne parametra { $parameter }.
diag-label-twice = »{ $label }« stoji pri { $parameter } in pri { $other }: eden od njiju ima drugo oznako.
diag-label-undefined = Noben stavek ne postavi oznake LBL { $label }.
diag-labels-of-unknown-language =
    { $count ->
        [one] { $count } definicija, prva je ta, ima oznake v jeziku, ki tu ni znan; prebrana je bila po številkah.
        [two] { $count } definiciji, prva je ta, imata oznake v jeziku, ki tu ni znan; prebrani sta bili po številkah.
        [few] { $count } definicije, prva je ta, imajo oznake v jeziku, ki tu ni znan; prebrane so bile po številkah.
       *[other] { $count } definicij, prva je ta, ima oznake v jeziku, ki tu ni znan; prebrane so bile po številkah.
    }
diag-languages-mixed = Večina oznak je v enem jeziku ({ $language }); definicije v teh vrsticah so v drugem ({ $others }): { $lines }.
diag-loop-endless = Nič v zanki, ki jo sklene ta skok, je ne more končati.
diag-machine-coordinates-compensated = Strojne koordinate (M91, M92) so tu programirane s popravkom polmera.
diag-main-runs-into-subprogram = Glavni program se tu nadaljuje v podprogram { $label }: pred njim ni ne M2 ne M30.
diag-measuring-height-below-floor = { $cycle } meri na višini { $parameter }={ $value }, nižje od dna, ki ga tam pusti { $milling } ({ $floor }).
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
       *[again] zato orodje zadnji položaj obdela še enkrat
    }.
diag-mode-wrong =
    { $what ->
        [milling] { $cycle } rezka ali vrta, tu pa je aktiven FUNCTION MODE TURN.
        [turning] { $cycle } struži, FUNCTION MODE TURN pa tu ni aktiven.
       *[data] { $cycle } je tu zunaj načina struženja.
    }
diag-name-of-another-cycle = »{ $name }« je ime cikla { $other }, tu pa je { $cycle }.
diag-no-result =
    Ta formula nima rezultata: { $why ->
        [division] v njej se deli z ničlo
        [large] število je preveliko
       *[domain] funkcija za dano vrednost ni definirana
    }.
diag-no-table-open = FN 27 in FN 28 delata s preglednico, ki jo je odprl FN 26.
diag-not-a-program = Ta datoteka ni NC-program.
diag-number-does-not-exist = { $name } ne obstaja: številke segajo do { $greatest }.
diag-older-parameter-set = { $cycle } ima parametre starejše različice programske opreme; krmiljenje doda { $parameter }.
diag-out-of-range =
    { $side ->
        [below] { $parameter }={ $value } je premajhno: najmanjša vrednost je { $limit }.
        [long] Besedilo parametra { $parameter } je predolgo: največje število znakov je { $limit }.
        [many] { $parameter } navaja preveč oznak: največje število oznak je { $limit }.
        [axes] { $parameter } navaja preveč osi: navede jih lahko { $limit }.
       *[above] { $parameter }={ $value } je preveliko: največja vrednost je { $limit }.
    }
diag-out-of-usual-range =
    { $parameter }={ $value } najbrž ni mišljeno: { $where ->
        [control] { $control } tam ne sprejme vrednosti { $side ->
                [below] pod
               *[above] nad
            } { $limit }.
       *[any] noben priročnik za take parametre ne navaja vrednosti { $side ->
                [below] pod
               *[above] nad
            } { $limit }.
    }
diag-parameter-of-later-software = { $parameter } v ciklu { $cycle } zahteva novejšo različico programske opreme od { $software }, ki jo opisuje priročnik.
diag-parameter-unassigned =
    { $parameter } se tu bere, pred tem pa mu nič ne določi vrednosti.
diag-pattern-combination =
    { $what ->
        [value] { $cycle } ne more priklicati { $called } z { $value }.
       *[cycle] { $cycle } ne more priklicati { $called }.
    }
diag-pattern-wrong =
    { $what ->
        [count] { $word } je celo število položajev, najmanj 1.
        [many] { $word }: PATTERN DEF ima največ devet posameznih položajev.
        [rapid] { $word } tu ni veljaven: med točkami preglednice se orodje premika s pomikom.
        [distance] { $word } je 0: vsi položaji so isti.
        [angle] { $word } je več kot poln obrat.
        [same] { $word } je isti položaj kot eden pred njim.
       *[diameter] Premer { $word } kroga položajev je večji od 0.
    }
diag-plane-incomplete = V tem stavku PLANE manjka { $word }.
diag-plane-not-positioned = STAY pusti rotacijske osi, kjer so, in noben stavek programa jih ne premakne na kote te ravnine.
diag-plane-not-reset = Program se tu konča z zavrteno obdelovalno ravnino.
diag-position-after-contour = To je prvi položaj za ciklom { $cycle } in ne navede obeh koordinat ravnine absolutno.
diag-probe-while-turning = { $cycle } tu tipa, medtem ko se vreteno vrti.
diag-probed-axis-missing = Tipa se v smeri { $direction }, vendar položaj ne navaja osi { $axis }.
diag-program-begin-missing = Program se ne začne z BEGIN PGM.
diag-program-begin-twice = BEGIN PGM je tu drugič.
diag-program-calls-itself = Program prikliče samega sebe: { $name }.
diag-program-empty = Datoteka ne vsebuje nobenega stavka.
diag-program-end-missing =
    Program se tu konča brez { $end ->
        [iso] stavka, ki se začne s % in ga zaključi
       *[pgm] END PGM
    }.
diag-programs-call-in-circle = Program { $name } kliče nazaj tega, neposredno ali prek drugih.
diag-rapid-into-blank = Orodje se tu v hitrem teku premakne v surovec: Z gre na { $value }, surovec pa sega do { $top }.
diag-repeat-count-wrong = Del programa se ponovi celo število krat, od 0 do 65534.
diag-repeat-of-later-label = Oznaka LBL { $label } stoji za to ponovitvijo.
diag-reserved-parameter = Tu se zapiše { $parameter }, v parametre od Q100 do Q199 pa zapisuje krmiljenje samo.
diag-reset-order-wrong =
    { $what ->
        [tilt] Tu se ponastavi zavrtena ravnina, čeprav je rotacija, vklopljena za njo, še aktivna.
       *[shift] Tu se ponastavi zamik ničelne točke, čeprav je ravnina, zavrtena za njim, še zavrtena.
    }
diag-retract-missing =
    Orodje je pri { $value }, v surovcu ali tik nad njim, ko { $what ->
        [change] se zamenja
       *[turn] se rotacijska os zavrti v hitrem teku
    }: ni bilo odmaknjeno.
diag-row-not-in-table =
    { $table ->
        [preset] V preglednici prednastavitev ni vrstice { $row }.
       *[datum] V preglednici ničelnih točk ni vrstice { $row }.
    }
diag-program-not-selected = Tu se prikliče izbrani program, izbran pa ni bil noben.
diag-speed-missing = Vreteno se tu vklopi, število vrtljajev pa ni programirano.
diag-speed-out-of-range =
    { $what ->
        [feed] Pomik { $value }
       *[speed] Število vrtljajev vretena { $value }
    } najbrž ni mišljeno: { $side ->
        [below] vrednost je negativna
       *[above] največja vrednost, ki jo priročniki dovolijo vnesti, je { $limit }
    }.
diag-spindle-direction = { $cycle } potrebuje vreteno, ki se vrti v desno, tu pa se vrti v levo.
diag-spindle-off = Tu se material odvzema, medtem ko vreteno miruje.
diag-sql-handle-missing =
    { $what ->
        [ended] COMMIT ali ROLLBACK je transakcijo s HANDLE { $handle } že končal.
       *[missing] Nobena poizvedba prej ni dala vrednosti HANDLE { $handle }.
    }
diag-subprogram-end-without-label = Ta LBL 0 ne konča nobenega podprograma.
diag-subprogram-recursive = Podprogram { $label } tu prikliče samega sebe.
diag-subprogram-runs-on = Podprogram { $label } se nadaljuje v podprogram { $next }: med njima ni LBL 0.
diag-subprogram-without-end = Podprogram { $label } pride do konca programa brez LBL 0.
diag-tcpm-left-on =
    { $what ->
        [tool] Tu se prikliče orodje, medtem ko je aktiven M128 ali FUNCTION TCPM.
       *[end] Program se tu konča, medtem ko je aktiven M128 ali FUNCTION TCPM.
    }
diag-text-for-number =
    { $what ->
        [text] { $parameter } sprejme število, to pa je besedilo.
        [number] { $parameter } sprejme besedilo, to pa je število.
       *[calculation] To je besedilo; z njim ni mogoče računati.
    }
diag-text-wrong =
    { $what ->
        [empty] Besedilo parametra { $parameter } je prazno.
        [alone] »{ $found }« v besedilu parametra { $parameter } ni podvojen in ne stoji pred črko.
       *[character] { $parameter } ne sprejme znaka »{ $found }«.
    }
diag-tool-axis-missing = Ta priklic orodja ne navaja orodne osi, pa tudi prej ni bila navedena.
diag-tool-axis-other =
    { $what ->
        [pattern] PATTERN DEF deluje samo z orodno osjo { $axis }, tu pa je aktivna druga.
       *[blank] Surovec navede orodno os { $axis }, ki je nima nobeno orodje programa.
    }
diag-tool-definition-wrong =
    { $what ->
        [zero] Orodje 0 pomeni, da orodja ni, in ga ni mogoče določiti.
        [twice] Orodje { $tool } je bilo prej že določeno z drugimi merami.
       *[after-call] Orodje { $tool } je določeno tu, čeprav je bilo že priklicano.
    }
diag-tool-feed-missing = Tu se uporabi pomik iz priklica orodja, ki pa ga nima.
diag-tool-missing = Tu cikel premika osi, noben prejšnji priklic orodja pa ni določil orodne osi.
diag-tool-not-listed = V preglednici orodij ni orodja { $tool }.
diag-wrong-tool-type =
    { $what ->
        [probe] { $cycle } tu tipa z orodjem, ki je pravkar obdelovalo.
       *[mill] { $cycle } tu obdeluje z orodjem, ki je pravkar tipalo.
    }
diag-tool-unused = Orodje { $tool } se tu prikliče in takoj zamenja z drugim.
diag-transfer-parameter-overwritten =
    { $what ->
        [passed] { $cycle } je parameter { $parameter } prebral ob definiciji: kar je zapisano tu, njegovega priklica ne spremeni.
        [filled] { $cycle } od tu navedenega naprej zapolni štiri parametre, tudi { $parameter }, v katerega je program že pisal in ga pozneje bere.
        [lost] { $cycle } prepiše parameter { $parameter }, preden program prebere, kar se tu zapiše.
       *[call] { $parameter } pripada ciklu { $cycle }, ki se prikliče pozneje: priklic uporabi tu zapisano vrednost.
    }
diag-transformation-forbidden =
    { $cycle } je tu, čeprav je { $what ->
        [datum-shift] aktiven zamik ničelne točke
        [rotation] aktivna rotacija
        [tcpm] aktivna funkcija M128 ali FUNCTION TCPM
        [other-axis] orodna os druga kot Z
        [turning] aktiven način za struženje (FUNCTION MODE TURN)
       *[tilting] obdelovalna ravnina zavrtena
    }, kar priročnik prepoveduje.
diag-transformation-left-on =
    Program se tu konča, ko je še { $what ->
        [datum-shift] aktiven zamik ničelne točke
        [rotation] aktivna rotacija
        [mirroring] aktivno zrcaljenje
       *[scaling] aktiven faktor merila
    }.
diag-turning-feed-unit =
    { $what ->
        [revolution] { $parameter }={ $value } je tu pomik na vrtljaj, ker je M136 aktiven.
       *[minute] { $parameter }={ $value } je tu pomik na minuto, ker M136 ni aktiven.
    }
diag-turning-system-missing = { $cycle } se tu prikliče, od priklica orodja naprej pa { $aligning } ni bil definiran.
diag-two-signs = Pred številom sta dva predznaka; bereta se kot { $right }.
diag-unknown-cycle =
    { $name ->
        [none] { $cycle } je cikel, ki ga ne omenja noben tu upoštevan priročnik.
       *[other] { $cycle } ({ $name }) je cikel prvih krmiljenj: še vedno se izvede, njegove vrednosti pa se ne preverijo.
    }
diag-unknown-parameter = Cikel { $cycle } na tem krmiljenju nima parametra { $parameter }.
diag-differs-from-other-control =
    { $what ->
        [missing] { $cycle } ima na krmiljenju { $control } parameter { $parameter }, ki tu manjka.
        [value] Vrednost { $parameter }={ $value } v { $cycle } krmiljenje { $control } zavrne.
        [twice] { $parameter } je v { $cycle } dvakrat.
        [foreign] { $cycle } na krmiljenju { $control } nima parametra { $parameter }.
        [order] { $parameter } stoji za { $before }; v { $cycle } na krmiljenju { $control } stoji pred njim.
        [label] »{ $label }« v { $cycle } na krmiljenju { $control } pripada { $other }, ne { $parameter }.
        [doubt] { $cycle } je dvomljiv: { $message }
        [alone] Vrednosti { $parameter }={ $value } v { $cycle } ne sprejme noben cikel s tem parametrom.
       *[guard] Krmiljenje { $control } { $cycle } zavrne: { $message }
    }
diag-unreachable =
    { $part ->
        [label] Nič ne vodi do te oznake LBL.
       *[block] Izvajanje nikoli ne pride do tega stavka.
    }
diag-meaningless-value = Vrednost je tu { $value }, kar ni smiselno.
diag-word-missing = V tem stavku manjka { $word }.
diag-word-twice = { $word } je v tem stavku navedeno dvakrat.
diag-word-wrong =
    { $what ->
        [below] Vrednost { $value } besede { $word } je premajhna.
        [above] Vrednost { $value } besede { $word } je prevelika.
        [whole] { $word } je { $value }, sprejme pa samo cela števila.
        [offers] Za { $word } stoji eno od: { $value }.
        [contradict] { $word } in { $value } se izključujeta.
        [zero] { $word } ne smejo biti vsi 0.
        [not-below] { $word } mora biti manjši od { $value }.
        [operator] Tu stoji »{ $word }« namesto { $value }.
        [empty] Ime je prazno.
        [value] Za { $word } manjka vrednost.
        [place] { $word } ne sodi v ta stavek.
        [line] Tri točke ležijo na isti premici in ne določajo ravnine.
        [parallel] Vektorja sta vzporedna in ne določata ravnine.
        [number] Besedilo v { $word } ni število: »{ $value }«.
        [beyond] { $word } je { $value }, kar leži za koncem besedila.
        [file] { $value } ni datoteka { $word }.
       *[tool] { $value } ni številka orodja: za piko stoji ena števka.
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
