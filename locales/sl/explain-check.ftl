# Pomen kod preverjanja programov za ukaz `ciklo explain`.

explain-call-of-def-active-cycle = Vzorci, preračunavanja koordinat in cikli tipalnega sistema delujejo ob definiciji. Priklic za njimi je napaka, če prej ni definiran noben obdelovalni cikel ali če stoji takoj za vzorcem, ki je obdelovalni cikel že priklical.
explain-called-but-not-defined = CYCL CALL, M99 in M89 izvedejo obdelovalni cikel, ki je bil definiran nazadnje. Brez definicije ni česa izvesti. V programih s skoki, podprogrami ali preskočenimi stavki se to javi samo, če ni definiran noben cikel, nikoli pa, če se priklicujejo drugi programi.
explain-choice-not-offered = Parameter ponuja izbiro vrednosti, od katerih ima vsaka svoj pomen, ta vrednost pa ni med njimi. Primer: Q215=3 v CYCL DEF 251.
explain-clearance-height-too-low = Na varni višini cikla tipalnega sistema tipalo in obdelovanec ne moreta trčiti. Kjer se krogla dotakne, je material. Če varna višina ni nad merilno višino ali nad točko, ki se tipa vzdolž osi tipalnega sistema, in varnostno razdaljo pred njo, ostane tipalo v obdelovancu. Kar doda preglednica tipalnega sistema, se ne upošteva. Primer: Q261=+15 in Q260=+10.
explain-cycle-not-described = Krmiljenje ima ta cikel, vendar zanj tu ni specifikacije. Njegovi parametri, oznake in učinek se preskočijo.
explain-cycle-not-on-control = Priročniki tega krmiljenja cikla ne poznajo, priročnik drugega pa ga pozna. Program je bil napisan za drugo krmiljenje ali pa je z --control izbrano napačno.
explain-defined-but-never-called = Cikel deluje, ko ga prikliče CYCL CALL, M99 ali M89 ali vzorec, nič od tega pa ne sledi pred naslednjim takim ciklom ali koncem programa. Definicija nima učinka ali pa je bil priklic pozabljen.
explain-duplicate-parameter = Definicija daje istemu parametru ali polju dve vrednosti; ni mogoče reči, katera je mišljena.
explain-guard = Specifikacije navajajo, pod katerimi pogoji krmiljenje cikel zavrne, preskoči, opozori ali vpraša. Vsako tako preverjanje ima svojo kodo; opravi se samo z vrednostmi, ki so v programu zapisane kot števila ali besedila.
explain-label-missing = Programa ni mogoče v celoti zapisati v tem jeziku: neko besedilo specifikacij še ni prevedeno. Stara oznaka ostane. Ukaz ciklo coverage našteje, kaj manjka.
explain-label-not-encodable = Program ni datoteka UTF-8, njeno kodiranje (Windows-1252) pa nima znaka iz nove oznake. Datoteko najprej pretvorite v UTF-8, če jo krmiljenje tako bere.
explain-label-of-another-language = Večina oznak programa je v enem jeziku, ta je v drugem. Ukaz ciklo translate jih zapiše vse v enem jeziku.
explain-label-of-another-parameter = Komentar za vrednostjo je oznaka drugega parametra istega cikla. Krmiljenje bere samo številko, vendar je vrednost morda mišljena za drugi parameter. Oznake, ki jih ni v nobenem jeziku, se ne obravnavajo.
explain-misordered-parameter = Krmiljenje prepozna parametre po številki in sprejme tudi drugačen vrstni red, vendar definicija najbrž ni nastala na krmiljenju. Javljen je prvi parameter, ki ni na svojem mestu.
explain-missing-parameter = Priročnik krmiljenja navaja za cikel parameter ali polje, ki ga v definiciji ni. Definicije z vrstico, ki je ni mogoče prebrati, se preskočijo. Primer: CYCL DEF 247 brez Q339.
explain-out-of-range = Priročnik krmiljenja navaja za parameter razpon, vrednost pa je zunaj njega. Razponi veljajo samo za to krmiljenje; kjer jih priročnik ne navaja, se ne preverja nič. V programih v palcih se dolžine in pomiki ne preverjajo. Primer: Q202=-5.
explain-spindle-off = Vretena ni nič vklopilo (M3, M4, M13, M14) ali pa je bilo vmes ustavljeno (M0, M5, M6). Za priklicem orodja in M-funkcijami proizvajalca stroja se nič ne javi. Javi se enkrat za vsak program.
explain-tool-missing = Cikli potrebujejo orodno os, ki jo določi TOOL CALL: TOOL CALL 5 Z S2000. Javi se enkrat za vsak program.
explain-unknown-cycle = Številka ne pomeni cikla v nobenem priročniku, na katerem temeljijo specifikacije, in tudi ne cikla proizvajalca stroja (od 300 do 399, od 500 do 599). Preverite ključno besedo in številko: CYCL DEF 32 in TCH PROBE 32 sta različna cikla. Primer: CYCL DEF 299.
explain-unknown-parameter = Parameter ali polje ni med tistimi, ki jih priročnik krmiljenja navaja za cikel. Pripada drugemu ciklu ali krmiljenju ali pa je številka napačno vnesena. Primer: Q999 v CYCL DEF 247.
explain-wrong-value-kind = Vrednost je vrste, ki je parameter ne sprejme: besedilo namesto števila, decimalno število namesto celega, beseda, ki je priročnik zanj ne navaja, ali nič. Q-parameter je vedno dovoljena vrednost. Primer: Q201=FAUTO.
