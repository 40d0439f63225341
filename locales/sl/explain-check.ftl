# Pomen kod preverjanja programov za ukaz `ciklo explain`.

explain-arc-wrong = Konec loka ne leži na loku. S središčem (CC) morata biti začetek in konec enako oddaljena od njega; s polmerom (CR) smeta biti med seboj oddaljena največ za dvojni polmer. Javi se samo, kjer so vse koordinate zanesljive, s toleranco 0,05 mm. Primer: CR X+100 R+10 od X+0.
explain-axis-twice = Stavek sme vsako os navesti enkrat. Primer: L X+10 X+20.
explain-behind-end = Krmiljenje bere program do END PGM. Kar stoji za njim, se ne izvede; morda je drug program ali ostanek drugega programa.
explain-blank-wrong = Surovec je kvader z dvema ogliščema: BLK FORM 0.1 navaja najmanjše koordinate, BLK FORM 0.2 največje. Drugače ga krmiljenje ne more prikazati.
explain-block-numbers = Številke stavkov naraščajo. Krmiljenje na novo oštevilči, kar prebere, vendar so bili stavki tu morda premaknjeni, izgubljeni ali zapisani dvakrat. Javi se enkrat za vsak program; ciklo fmt številke zapiše na novo.
explain-call-of-def-active-cycle = Vzorci, preračunavanja koordinat in cikli tipalnega sistema delujejo ob definiciji. Priklic za njimi je napaka, če prej ni definiran noben obdelovalni cikel ali če stoji takoj za vzorcem, ki je obdelovalni cikel že priklical.
explain-called-but-not-defined = CYCL CALL, M99 in M89 izvedejo obdelovalni cikel, ki je bil definiran nazadnje. Brez definicije ni česa izvesti. Javi se samo, če cikel ni definiran na nobeni poti izvajanja, in ne za priklici drugih programov.
explain-choice-not-offered = Parameter ponuja izbiro vrednosti, od katerih ima vsaka svoj pomen, ta vrednost pa ni med njimi. Primer: Q215=3 v CYCL DEF 251.
explain-clearance-height-too-low = Na varni višini cikla tipalnega sistema tipalo in obdelovanec ne moreta trčiti. Kjer se krogla dotakne, je material. Če varna višina ni nad merilno višino ali nad točko, ki se tipa vzdolž osi tipalnega sistema, in varnostno razdaljo pred njo, ostane tipalo v obdelovancu. Kar doda preglednica tipalnega sistema, se ne upošteva. Primer: Q261=+15 in Q260=+10.
explain-compensation-at-cycle = Cikli sami upoštevajo polmer orodja: položaj pred njimi se programira z R0. Javi se enkrat za vsak program in samo, kjer je RL ali RR zanesljivo aktiven.
explain-compensation-left-on = RL ali RR je zanesljivo še aktiven, ko se prikliče orodje ali program konča. Kontura ni bila zapuščena z R0 ali DEP.
explain-contour-unnamed = Konturni cikli obdelajo konturo, ki jo prej navede CYCL DEF 14, SEL CONTOUR ali CONTOUR DEF. Javi se enkrat za vsak program.
explain-cutting-without-tool = Pred prvim TOOL CALL krmiljenje ne ve, katero orodje premika, in ne pozna njegove dolžine in polmera. Premiki v hitrem teku in v strojnih koordinatah se ne obravnavajo. Javi se enkrat za vsak program.
explain-cycle-line-alone = Definicija v stari obliki se začne z vrstico 0, ki navaja cikel: CYCL DEF 7.0, nato CYCL DEF 7.1. Vrstice drugega cikla med njimi ali napačno vnesena številka jo pretrgajo.
explain-cycle-not-covered = Priročniki tega krmiljenja, ki so tu znani, obravnavajo samo drugačne cikle, na primer cikle tipalnega sistema. Krmiljenje ta cikel lahko ima; njegovi parametri, oznake in učinek se preskočijo.
explain-cycle-not-described = Krmiljenje ima ta cikel, vendar zanj tu ni specifikacije. Njegovi parametri, oznake in učinek se preskočijo.
explain-cycle-not-on-control = Priročniki tega krmiljenja cikla ne poznajo, priročnik drugega pa ga pozna. Program je bil napisan za drugo krmiljenje ali pa je z --control izbrano napačno.
explain-defined-but-never-called = Cikel deluje, ko ga prikliče CYCL CALL, M99 ali M89 ali vzorec, nič od tega pa ne sledi pred naslednjim takim ciklom ali koncem programa. Definicija nima učinka ali pa je bil priklic pozabljen.
explain-duplicate-parameter = Definicija daje istemu parametru ali polju dve vrednosti; ni mogoče reči, katera je mišljena.
explain-feed-missing = Premik brez FMAX potrebuje pomik: v svojem stavku, v prejšnjem stavku ali v priklicu orodja. Javi se enkrat za vsak program in samo, če ni programiran na nobeni poti izvajanja.
explain-frame-mismatch = BEGIN PGM in END PGM programa imata isto ime in isto enoto. Drugače konec morda pripada drugemu programu.
explain-guard = Specifikacije navajajo, pod katerimi pogoji krmiljenje cikel zavrne, preskoči, opozori ali vpraša. Vsako tako preverjanje ima svojo kodo; opravi se samo s tem, kar je zanesljivo: z vrednostmi, zapisanimi v programu, parametri z zanesljivo vrednostjo in zanesljivo aktivnimi preračunavanji.
explain-label-duplicate = Program sme vsako oznako LBL postaviti enkrat; samo LBL 0, konec podprograma, se sme ponavljati. Pri dveh enakih oznakah ni mogoče reči, katera je priklicana.
explain-label-missing = Programa ni mogoče v celoti zapisati v tem jeziku: neko besedilo specifikacij še ni prevedeno. Stara oznaka ostane. Ukaz ciklo coverage našteje, kaj manjka.
explain-label-not-encodable = Program ni datoteka UTF-8, njeno kodiranje (Windows-1252) pa nima znaka iz nove oznake. Datoteko najprej pretvorite v UTF-8, če jo krmiljenje tako bere.
explain-label-of-another-language = Večina oznak programa je v enem jeziku, ta je v drugem. Ukaz ciklo translate jih zapiše vse v enem jeziku.
explain-label-of-another-parameter = Komentar za vrednostjo je oznaka drugega parametra istega cikla. Krmiljenje bere samo številko, vendar je vrednost morda mišljena za drugi parameter. Oznake, ki jih ni v nobenem jeziku, se ne obravnavajo.
explain-label-undefined = Priklic, ponovitev, skok ali seznam kontur navaja oznako, program pa zanjo nima stavka LBL. Številka ali ime je morda napačno vneseno ali pa je podprogram izpuščen.
explain-main-runs-into-subprogram = Podprogrami stojijo za M2 ali M30. Brez tega krmiljenje prvega na koncu izvede še enkrat, brez priklica. Javi se samo, če je podprogram priklican prej in mu sledijo samo podprogrami.
explain-measuring-height-below-floor = Cikel, ki rezka okoli središča, pusti dno na višini vsote koordinate površine in globine. Tipalni sistem, katerega krogla naj bi se dotaknila pod tem dnom, bi moral stati v obdelovancu. Primerjajo se samo cikli z istim središčem, in to le, če nič drugega v programu ni moglo rezati globlje ali premakniti koordinat. Primer: Q203=+10 in Q201=-10 pustita dno na 0; Q261=-5 je pod njim.
explain-metric-values-in-inch = BEGIN PGM se konča z INCH. Tam so pomiki v desetinkah palca na minuto, zato je F4000 več kot 10 m/min, surovec s 120 palci pa je dolg več kot 3 m. Hitri pomiki (9998 in več) se ne obravnavajo. Vsako se javi enkrat za vsak program.
explain-misordered-parameter = Krmiljenje prepozna parametre po številki in sprejme tudi drugačen vrstni red, vendar definicija najbrž ni nastala na krmiljenju. Javljen je prvi parameter, ki ni na svojem mestu.
explain-missing-parameter = Priročnik krmiljenja navaja za cikel parameter ali polje, ki ga v definiciji ni. Definicije z vrstico, ki je ni mogoče prebrati, se preskočijo. Primer: CYCL DEF 247 brez Q339.
explain-not-a-program = Nima ne BEGIN PGM ne END PGM, večine vrstic pa ni mogoče prebrati. Tudi zaglavne datoteke drugih jezikov se končajo s .h. Neberljive vrstice se ne naštejejo; v ciklo.toml se lahko javljanje za mapo izklopi.
explain-out-of-range = Priročnik krmiljenja navaja za parameter razpon, vrednost pa je zunaj njega. Razponi veljajo samo za to krmiljenje; kjer jih priročnik ne navaja, se ne preverja nič. V programih v palcih se meje dolžin in pomikov, ki jih priročnik navaja v milimetrih, pretvorijo. Primer: Q202=-5.
explain-parameter-unassigned = Na vsaki možni poti izvajanja se parameter bere, preden je zapisan. Obdrži, kar je v njem pustil prejšnji program ali uporabnik; številka je morda napačno vnesena. Preverijo se samo Q0 do Q99, QS0 do QS99 in QL, vsak enkrat, v programih s surovcem, ne pa za priklici drugih programov.
explain-pattern-missing = CYCL CALL PAT prikliče cikel na točkah vzorca, ki ga prej definira PATTERN DEF ali izbere SEL PATTERN.
explain-plane-not-reset = Obdelovalna ravnina je na koncu programa zanesljivo še zavrtena in taka ostane za naslednji program. Ponastavi jo PLANE RESET ali CYCL DEF 19 brez kotov. Javi se enkrat za vsak program.
explain-pole-missing = C se vrti okrog središča kroga, LP, CP in CTP štejejo od pola; oboje določi CC. Javi se enkrat za vsak program.
explain-program-begin-missing = Program ima END PGM, torej je cel, nima pa stavka BEGIN PGM z imenom in enoto. Začetek je morda izgubljen.
explain-program-calls-itself = CALL PGM navaja program, v katerem stoji, zato se priklic nikoli ne konča. Javi se samo, če priklic ne navaja mape.
explain-program-end-missing = Program se začne z BEGIN PGM in nima END PGM: datoteka je morda odrezana, tako da manjka več kot zadnji stavek.
explain-repeat-of-later-label = CALL LBL … REP ponovi del med oznako in samim seboj, zato stoji oznaka pred njim. Javi se, če stoji za njim.
explain-reserved-parameter = Krmiljenje hrani v Q100 do Q199 in QS100 do QS199 podatke o orodju, rezultate ciklov tipalnega sistema in stanja ter jih lahko kadar koli prepiše. Uporabite drug parameter. Javi se enkrat za vsakega.
explain-speed-missing = Število vrtljajev navede TOOL CALL s S. Javi se enkrat za vsak program, če je orodje priklicano in noben priklic ni navedel števila vrtljajev.
explain-spindle-off = Prikliče se obdelovalni cikel ali se kontura začne z RL ali RR, vretena pa ni nič vklopilo (M3, M4, M13, M14) ali pa je bilo vmes ustavljeno (M0, M5, M6). Za priklicem orodja in M-funkcijami proizvajalca stroja se nič ne javi. Javi se enkrat za vsak program.
explain-subprogram-recursive = Podprogram ne sme priklicati samega sebe, ne neposredno ne prek drugih: priklici se nikoli ne končajo. V programih s pogojnimi skoki ali preskočljivimi stavki je to opozorilo, saj jih lahko končajo.
explain-subprogram-runs-on = Podprogram se konča z LBL 0. Brez njega se naslednji izvede zraven. Javi se, če sta oba priklicana in nobeden ni cilj skoka.
explain-subprogram-without-end = CALL LBL izvede, kar sledi oznaki do LBL 0, in nadaljuje za priklicem. Brez LBL 0 se izvajanje nikoli ne vrne. Podprogrami, ki se končajo z M2 ali M30, se ne obravnavajo.
explain-tool-missing = Cikli potrebujejo orodno os, ki jo določi TOOL CALL: TOOL CALL 5 Z S2000. Javi se enkrat za vsak program.
explain-transfer-parameter-overwritten = Parametri cikla delujejo globalno. Kar se vanje zapiše med definicijo in priklicem, spremeni cikel. To je lahko namerno; če ni, uporabite drug parameter.
explain-unknown-cycle = Številka ne pomeni cikla v nobenem priročniku, na katerem temeljijo specifikacije, in tudi ne cikla proizvajalca stroja (od 300 do 399, od 500 do 599). Preverite ključno besedo in številko: CYCL DEF 32 in TCH PROBE 32 sta različna cikla. Primer: CYCL DEF 299.
explain-unknown-parameter = Parameter ali polje ni med tistimi, ki jih priročnik krmiljenja navaja za cikel. Pripada drugemu ciklu ali krmiljenju ali pa je številka napačno vnesena. Primer: Q999 v CYCL DEF 247.
explain-unreachable = Za M2, M30 ali koncem dela do teh stavkov ne vodi noben priklic, ponovitev ali skok, zato se nikoli ne izvedejo. Za podprogram, ki ga nič ne prikliče, je to pripomba.
explain-wrong-value-kind = Vrednost je vrste, ki je parameter ne sprejme: besedilo namesto števila, decimalno število namesto celega, beseda, ki je priročnik zanj ne navaja, ali nič. Q-parameter je dovoljena vrednost, razen če je njegovo število zanesljivo in ne ustreza. Primer: Q201=FAUTO.
