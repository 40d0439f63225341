# Blocks that end a program or speak with the machine.
diag-error-of-program = Program se sam konča z napako { $number } (FN 14).
explain-error-of-program = FN 14: ERROR konča program z lastno napako; številka izbere sporočilo, ki ga pokaže krmiljenje. Programi ga uporabljajo, kadar ne morejo nadaljevati, na primer ko vrednost parametra ni uporabna. Primer: »FN 14: ERROR = 1010«. Rešitev: preverite pogoj pred stavkom in parametrom priredite vrednosti, s katerimi lahko program dela.
diag-tool-setter-askew = Orodje ni pravokotno na ploskev namiznega tipalnega sistema.
explain-tool-setter-askew = Glava ali obdelovalna ravnina je zavrtena drugače, kot je nameščen namizni tipalni sistem: orodje bi se ga dotaknilo poševno in izmerjeno ne bi bilo ne dolžina ne polmer. Primer: orodje leži vodoravno nad tipalnim sistemom, katerega ploskev gleda navzgor. Rešitev: pred ciklom zavrtite rotacijske osi tako, da je orodje poravnano s tipalnim sistemom, ali pa ustrezno namestite tipalni sistem prizorišča (»rotate«).
diag-tool-setter-collision = Trk: orodje zadene namizni tipalni sistem pri premiku iz X { NUMBER($x) } Y { NUMBER($y) } Z { NUMBER($z) }.
explain-tool-setter-collision = Orodje zadene namizni tipalni sistem prizorišča pri premiku, ki ni meritev: orodje, kakršno v resnici je, z najdaljšim in najširšim rezilom. Na stroju bi se lahko oboje poškodovalo. Pogosto je varna višina premajhna ali pa se dolžina in polmer v preglednici orodij od resnice razlikujeta bolj, kot dopušča varnostna razdalja tipalnega sistema. Pred prvo meritvijo vnesite približne vrednosti ali pa tipalni sistem obvozite.
diag-tool-setter-missing = Prizorišče nima namiznega tipalnega sistema.
explain-tool-setter-missing = Cikel za merjenje orodja potrebuje v prizorišču namizni tipalni sistem: kje je njegova merilna površina in kako široka je. Primer: »tool_setter:« z »at: [300, 200, -50]« in »diameter: 40«. Rešitev: dodajte ga v prizorišče; docs/scene.md opisuje ključe.

# --- kinematics ---
diag-kinematics-not-saved = Pod imenom »{ $name }« ni shranjena nobena kinematika.
explain-kinematics-not-saved = Obnoviti ali izbrisati je mogoče samo shranjeno kinematiko. Primer: način 1 z imenom AB, preden je bilo to ime shranjeno v načinu 0. Rešitev: najprej shranite, popravite ime ali v prizorišču pod »kinematics: saved:« dodajte pomnilniško mesto.
diag-kinematics-differs = Kinematika, shranjena kot »{ $name }«, opisuje drug stroj.
explain-kinematics-differs = Shranjene podatke je mogoče obnoviti samo v enak opis kinematike: z istim imenom in istimi rotacijskimi osmi v istem zaporedju. Primer: podatki stroja z osema A in C na stroju z osema B in C. Rešitev: izberite podatke tega stroja.
diag-kinematics-memory-full = Vsa pomnilniška mesta za kinematiko ({ $count }) so zasedena.
explain-kinematics-memory-full = Krmiljenje hrani omejeno število shranjenih kinematik. Primer: sedemnajsto ime na krmiljenju s 16 mesti. Rešitev: izbrišite nepotrebno ali shranite pod imenom, ki je že v rabi.
diag-tool-edges-too-many = Rezila je mogoče meriti posamezno pri orodjih z največ { $most } rezili; v preglednici orodij jih je { $count }.
explain-tool-edges-too-many = Priročnik omejuje merjenje posameznih rezil. Primer: CUT = 24 v preglednici orodij in Q341=1, izmeriti pa je mogoče največ 20 rezil. Rešitev: orodje izmerite med vrtenjem (Q341=0) ali popravite CUT. Preglednica orodij ostane nespremenjena.
diag-kinematics-tool-axis = Ta cikel se lahko uporablja samo z orodno osjo Z; aktivna orodna os je { $axis }.
explain-kinematics-tool-axis = Kinematika se meri s tipalnim sistemom vzdolž osi Z: priročniki druge orodne osi ne dovoljujejo. Primer: TOOL CALL 1 Y pred ciklom 451. Rešitev: tipalni sistem prikličite z orodno osjo Z. Kinematika ostane nespremenjena.
diag-kinematics-undetermined = Iz merilnih položajev ni mogoče določiti lege osi { $axis }.
explain-kinematics-undetermined = Za popravek lege rotacijske osi se morajo merilni položaji jasno razlikovati od referenčnega položaja pri 0°. Primer: ena točka pri 0,05° ali le točka pri 0°, ki je prezrta. Rešitev: večje območje med začetnim in končnim kotom ali več merilnih točk. Kinematika ostane nespremenjena.
diag-sphere-radius-differs = Izmerjeni polmer umeritvene krogle { $found } mm preveč odstopa od vnesenega polmera { $entered } mm.
explain-sphere-radius-differs = Krmiljenje v vsakem položaju najprej izmeri polmer krogle; strojni parameter omejuje odstopanje od vnesenega. Primer: vneseno 12,5, krogla 12,6 in meja 0,05. Rešitev: vnesite točen polmer ali umerite tipalni sistem.
diag-measuring-position-at-zero = Merilni položaj osi { $axis } je pri 0° ali 360°.
explain-measuring-position-at-zero = Referenčna meritev se izvede pri 0°, zato merilni položaj tam ne pove ničesar in ga iTNC 530 zavrne. Primer: od −90 do +90 s 3 točkami. Rešitev: drugo število točk ali drugi koti.
diag-measuring-position-near-limit = Merilni položaj osi { $axis } pri { $angle }° je manj kot { $way }° od meje osi.
explain-measuring-position-near-limit = Kot osi se meri z dajalnikom motorja, krmiljenje pa za notranjo izravnavo zračnosti za vsakim merilnim položajem potrebuje { $way }° poti. Primer: točka pri 119,5° in v stroju »max: 120« ter »encoder: motor«. Rešitev: začetni in končni kot izberite dlje od meja.
diag-hirth-without-retraction = Os { $axis } ima Hirthovo ozobje in potrebuje višino odmika.
explain-hirth-without-retraction = Os s Hirthovim ozobjem se za pozicioniranje premakne iz zobja, zato je ni mogoče izmeriti brez odmika. Primer: višina odmika 0 in »hirth: 3« v stroju. Rešitev: vnesite višino nad kroglo.
diag-mask-missing = Maske { $name } ni.
explain-mask-missing = FN 16 izpisuje po maski, besedilni datoteki ob programu ali v prizorišču pod »masks«, te pa ni na nobenem od obeh mest. Pogon in mape v imenu niso pomembni. Primer: »FN 16: F-PRINT TNC:\MASK.A / TNC:\LOG.TXT« brez datoteke MASK.A. Dodajte masko ali popravite njeno ime.
diag-mask-unreadable = { $file }, vrstica { $line }: maske ni mogoče prebrati: { $found }
explain-mask-unreadable = Maska je sestavljena iz besedil v narekovajih, ki imajo mesto za vsako vrednost za njimi, in iz ključnih besed; vsak del se konča s podpičjem. Primer: »"X = %9.3LF", Q31;«. Pogosti vzroki so manjkajoče podpičje, več mest kot vrednosti ali ključna beseda, ki je ni mogoče simulirati. Popravite vrstico.
diag-output-path = Pot { $path } vodi iz mape z rezultati.
explain-output-path = Kar zapiše FN 16, gre v mapo, navedeno z --out, pod imenom svoje datoteke, ne glede na mapo v krmiljenju. Pot, ki vodi navzgor ali na pogon oziroma v korensko mapo drugega sistema, bi lahko prepisala druge datoteke, zato je zavrnjena. Primer: »TNC:\LOG\..\PART.TXT«. Uporabite pot na TNC: brez »..«.
diag-open-table-missing = Odprta ni nobena preglednica.
explain-open-table-missing = FN 27 in FN 28 pišeta v preglednico in jo bereta, ko jo odpre FN 26: TABOPEN; pred tem stavkom ni bila odprta nobena. Primer: »FN 28: TABREAD Q10 = 6/"X,Y"« na začetku programa. Preglednico najprej odprite: »FN 26: TABOPEN TNC:\TAB1.TAB«.
