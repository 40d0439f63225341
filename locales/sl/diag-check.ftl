# Ugotovitve preverjanja in prevajanja programov; glejte angleško datoteko.

diag-call-of-def-active-cycle = Cikel { $cycle } deluje takoj, ko je definiran; ni ga dovoljeno priklicati.
    .explain = Vzorci, preračunavanja koordinat in cikli tipalnega sistema delujejo ob definiciji. Priklic za njimi je napaka, če prej ni definiran noben obdelovalni cikel ali če stoji takoj za vzorcem, ki je obdelovalni cikel že priklical.
diag-called-but-not-defined = Tu se prikliče cikel, pred tem pa ni definiran nobeden.
    .explain = CYCL CALL, M99 in M89 izvedejo obdelovalni cikel, ki je bil definiran nazadnje. Brez definicije ni česa izvesti. V programih s skoki, podprogrami ali preskočenimi stavki se to javi samo, če ni definiran noben cikel, nikoli pa, če se kličejo drugi programi.
diag-choice-not-offered = Vrednosti { $parameter }={ $value } ni med možnostmi: { $offered }.
    .explain = Parameter ponuja izbiro vrednosti, od katerih ima vsaka svoj pomen, ta vrednost pa ni med njimi. Primer: Q215=3 v CYCL DEF 251.
diag-cycle-not-described = Cikel { $cycle } ({ $name }) je v priročnikih omenjen, a ne opisan: njegovi parametri se ne preverijo.
    .explain = Krmiljenje ima ta cikel, vendar tu zanj ni opisa. Njegovi parametri, oznake in učinek se preskočijo.
diag-cycle-not-on-control = Cikla { $cycle } na krmiljenju { $control } ni; obstaja na: { $controls }.
    .explain = Priročniki tega krmiljenja cikla ne poznajo, priročnik drugega pa ga pozna. Program je bil napisan za drugo krmiljenje ali pa je z --control izbrano napačno.
diag-defined-but-never-called = Cikel { $cycle } je tu definiran, nikoli pa priklican.
    .explain = Cikel deluje, ko ga prikliče CYCL CALL, M99 ali M89 ali vzorec, nič od tega pa ne sledi pred naslednjim takim ciklom ali koncem programa. Definicija nima učinka ali pa je bil priklic pozabljen.
diag-duplicate-parameter = { $parameter } je v ciklu { $cycle } navedeno dvakrat.
    .explain = Definicija daje istemu parametru ali polju dve vrednosti; ni mogoče reči, katera je mišljena.
diag-guard = Krmiljenje teh vrednosti ne sprejme.
    .explain = Opisi navajajo, pod katerimi pogoji krmiljenje cikel zavrne, preskoči, opozori ali vpraša. Vsak tak pogoj ima svojo kodo; preverja se samo z vrednostmi, ki so v programu zapisane kot števila ali besedila.
diag-label-missing = Jezik »{ $language }« nima oznake za { $parameter } cikla { $cycle }.
    .explain = Programa ni mogoče v celoti zapisati v tem jeziku: neko besedilo še ni prevedeno. Stara oznaka ostane. Ukaz ciklo coverage našteje, kaj manjka.
diag-label-not-encodable = V oznaki »{ $label }« je znak »{ $character }«, ki ga kodiranje datoteke ne pozna.
    .explain = Program ni datoteka UTF-8, njeno kodiranje (Windows-1252) pa nima znaka iz nove oznake. Datoteko najprej pretvorite v UTF-8, če jo krmiljenje tako bere.
diag-label-of-another-language = »{ $label }« je oznaka v drugem jeziku ({ $language }); v jeziku programa je oznaka parametra { $parameter } »{ $right }«.
    .explain = Večina oznak programa je v enem jeziku, ta je v drugem. Ukaz ciklo translate jih zapiše vse v enem jeziku.
diag-label-of-another-parameter = »{ $label }« je oznaka parametra { $other }, ne parametra { $parameter }.
    .explain = Komentar za vrednostjo je oznaka drugega parametra istega cikla. Krmiljenje bere samo številko, vendar je vrednost morda mišljena za drugi parameter. Oznake, ki jih ni v nobenem jeziku, se ne obravnavajo.
diag-misordered-parameter = V ciklu { $cycle } krmiljenje prikaže { $parameter } pred { $before }.
    .explain = Krmiljenje prepozna parametre po številki in sprejme tudi drugačen vrstni red, vendar definicija najbrž ni nastala na krmiljenju. Javljen je prvi parameter, ki ni na svojem mestu.
diag-missing-parameter = V ciklu { $cycle } manjka { $parameter }.
    .explain = Priročnik krmiljenja navaja za cikel parameter ali polje, ki ga v definiciji ni. Definicije z vrstico, ki je ni mogoče prebrati, se preskočijo. Primer: CYCL DEF 247 brez Q339.
diag-out-of-range =
    { $side ->
        [below] { $parameter }={ $value } je premajhno: najmanjša vrednost je { $limit }.
        [long] Besedilo parametra { $parameter } je predolgo: največje število znakov je { $limit }.
       *[above] { $parameter }={ $value } je preveliko: največja vrednost je { $limit }.
    }
    .explain = Priročnik krmiljenja navaja za parameter razpon, vrednost pa je zunaj njega. Razponi veljajo samo za to krmiljenje; kjer jih priročnik ne navaja, se ne preverja nič. V programih v palcih se dolžine in pomiki ne preverjajo. Primer: Q202=-5.
diag-spindle-off = Tu se prikliče obdelovalni cikel, ko vreteno miruje.
    .explain = Vretena ni nič vklopilo (M3, M4, M13, M14) ali pa je bilo vmes ustavljeno (M0, M5, M6). Za priklicem orodja in M-funkcijami proizvajalca stroja se nič ne javi. Javi se enkrat na program.
diag-tool-missing = Tu se cikel premika, pred tem pa noben priklic orodja ni določil orodne osi.
    .explain = Cikli potrebujejo orodno os, ki jo določi TOOL CALL: TOOL CALL 5 Z S2000. Javi se enkrat na program.
diag-unknown-cycle = { $cycle } ni cikel nobenega tu znanega krmiljenja.
    .explain = Številka ne pomeni cikla v nobenem priročniku, na katerem temeljijo opisi, in tudi ne cikla proizvajalca stroja (300 do 399, 500 do 599). Preverite ključno besedo in številko: CYCL DEF 32 in TCH PROBE 32 sta različna cikla. Primer: CYCL DEF 299.
diag-unknown-parameter = Cikel { $cycle } na tem krmiljenju nima parametra { $parameter }.
    .explain = Parameter ali polje ni med tistimi, ki jih priročnik krmiljenja navaja za cikel. Pripada drugemu ciklu ali krmiljenju ali pa je številka napačno vnesena. Primer: Q999 v CYCL DEF 247.
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
       *[number] število
    }{ $words-count ->
        [0] {""}
       *[other] {" "}ali { $words }
    }.
    .explain = Vrednost je vrste, ki je parameter ne sprejme: besedilo namesto števila, ulomek namesto celega števila, beseda, ki je priročnik zanj ne navaja, ali nič. Q-parameter je vedno dovoljena vrednost. Primer: Q201=FAUTO.
