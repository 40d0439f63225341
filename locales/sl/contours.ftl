# Contour, cylinder surface and engraving cycles.

# --- common ---
step-retract-to-contour-clearance-height = Orodje se s pomikom { $q-contour-retraction-feed } umakne na varno višino; če je ta pomik 0, s pomikom { $q-roughing-feed }.
step-leave-to-contour-clearance-height = Orodje se premakne na varno višino.
until-contour-depth-reached = ni dosežena programirana globina
until-parts-of-contour-cleared = niso obdelane vse ločene površine konture
note-contour-element-limit = Pomnilnik za SL-cikel je omejen. V enem SL-ciklu je mogoče programirati največ 16384 konturnih elementov.
note-sign-of-milling-depth = Predznak globine rezkanja določa smer obdelave. Pri globini 0 krmiljenje cikla ne izvede.
note-both-axes-after-contour-cycle = Nevarnost kolizije! Po SL-ciklu prvi premik v obdelovalni ravnini programirajte z obema koordinatama, na primer L X+80 Y+0 R0 FMAX.
note-contour-cycle-properties = Krmiljenje orodje pred vsakim ciklom samodejno pozicionira na varnostno razdaljo. Vsaka ravnina se rezka brez dviganja orodja; otoke orodje obide ob strani. Polmer notranjih vogalov je mogoče programirati: orodje se tam ne ustavi in ne pusti sledi (to velja za skrajno zunanjo pot grobega rezkanja in za stransko fino rezkanje). Pri stranskem finem rezkanju se orodje konturi približa po tangencialnem krožnem loku, prav tako se pri globinskem finem rezkanju po tangencialnem krožnem loku približa obdelovancu (pri osi vretena Z v ravnini Z/X). Kontura se ves čas obdeluje v soteku ali ves čas v protiteku.
note-contour-tool-by-name = Orodje lahko vnesete s številko ali z imenom. Za vnos imena pritisnite gumb IME ORODJA; krmiljenje ob izhodu iz polja za vnos samodejno doda narekovaje.
note-global-def-for-contours = Funkcija GLOBAL DEF za konturno rezkanje vnaprej določi varnostno razdaljo, varno višino, faktor prekrivanja in vrsto rezkanja za cikle 20, 22, 23, 24 in 25.

# --- 14 ---
cycle-contour = Kontura
    .nc = KONTURA
    .purpose = Navede vse podprograme z delnimi konturami, ki skupaj tvorijo celotno konturo. Krmiljenje jo izračuna iz delnih kontur; te so žepi ali otoki.
step-remember-contour-labels = Krmiljenje si zapomni številke oznak. Naslednji cikli obdelajo konturo, ki jo opisujejo podprogrami.
note-contour-acts-from-definition = Cikel deluje od svoje definicije v programu naprej.
note-most-contour-labels = Navesti je mogoče največ 12 podprogramov (delnih kontur).
note-transformations-in-contour = Preračunavanja koordinat so dovoljena. Če so programirana znotraj delne konture, delujejo tudi v naslednjih podprogramih; po priklicu cikla jih ni treba ponastaviti.
note-pocket-and-island-recognized = Krmiljenje prepozna žep, če se orodje premika po notranji strani konture, na primer v smeri urnega kazalca s popravkom polmera RR. Otok prepozna, če se orodje premika po zunanji strani konture, na primer v smeri urnega kazalca s popravkom polmera RL.
note-contour-without-spindle-axis = Podprogrami ne smejo vsebovati koordinat na osi vretena.
note-contour-begins-with-both-axes = V prvem stavku podprograma vedno programirajte obe osi.
note-parameters-within-contour = Če uporabljate Q-parametre, jih izračunajte in priredite samo znotraj posameznega konturnega podprograma.
note-contours-may-overlap = Žepi in otoki se lahko prekrivajo in tako tvorijo novo konturo. Prekrivajoči se žep poveča površino žepa ali zmanjša otok.
note-contour-intersections-computed = Presečišča delnih kontur izračuna krmiljenje; ni jih treba programirati.
note-contour-sum = Površina vsote (obe površini A in B, vključno s prekrivajočim se delom): A in B morata biti žepa. Prvi žep na seznamu se mora začeti zunaj drugega.
note-contour-difference = Površina razlike (A brez dela, ki ga prekriva B): A mora biti žep, B otok. A se mora začeti zunaj B, B se mora začeti znotraj A.
note-contour-intersection = Površina preseka (samo del, ki ga prekrivata tako A kot B): A in B morata biti žepa. A se mora začeti znotraj B.
note-machining-data-in-contour-data = Podatki o obdelavi, kot so globina rezkanja, nadmere in varnostna razdalja, se vnesejo skupaj v ciklu 20.
note-contour-cycle-or-sel-contour = Cikel ni potreben, če je kontura izbrana s SEL CONTOUR.
note-contour-for-turning = Tudi cikli za struženje, ki obdelujejo konturo, potrebujejo ta cikel: programiran mora biti pred njihovim priklicem in navede številko podprograma.

# --- 20 ---
cycle-contour-data = Konturni podatki
    .nc = KONTURNI PODATKI
    .purpose = Vsebuje podatke o obdelavi za podprograme z delnimi konturami.
step-remember-contour-data = Krmiljenje si zapomni podatke o obdelavi za cikle od 21 do 24.
note-contour-data-act-from-definition = Cikel deluje od svoje definicije v programu naprej. Podatki o obdelavi veljajo samo za cikle od 21 do 24.
note-parameters-reserved-for-contours = Če se SL-cikli uporabljajo v programih s Q-parametri, parametrov od Q1 do Q20 ni dovoljeno uporabljati kot programskih parametrov.
note-contour-data-at-interruption = Ko se program prekine, je mogoče parametre obdelave preveriti in po potrebi prepisati.

# --- 21 ---
cycle-pilot-drilling = Predvrtanje
    .nc = PREDVRTANJE
    .purpose = Vrta na vbodnih točkah konture, ki so hkrati začetne točke za posnemanje.
step-position-at-pilot-holes = Krmiljenje določi vbodne točke konture.
step-move-over-pilot-hole = Krmiljenje premakne orodje nad vbodno točko na varnostno razdaljo.
step-drill-pilot-hole-to-plunging-depth = Orodje vrta s pomikom { $q-contour-plunging-feed } do globine primika, ki je pri vsakem primiku za { $q-contour-plunging-depth } globlja.
step-retract-and-return-to-stop-distance = Krmiljenje umakne orodje v hitrem teku (FMAX) in ga vrne na razdaljo zadrževanja t nad doseženo globino.
until-drilling-depth-reached = ni dosežena globina vrtanja
step-dwell-and-retract-to-start = Orodje se na dnu vrtine zadrži za prosto rezanje in se nato v hitrem teku (FMAX) umakne na začetni položaj.
until-pilot-holes-drilled = niso izvrtane vse vbodne točke
note-stop-distance-determined = Razdaljo zadrževanja t krmiljenje določi samodejno: pri globini vrtanja do 30{"\u00A0"}mm je 0,6{"\u00A0"}mm, nad 30{"\u00A0"}mm petdesetina globine vrtanja, vendar nikoli več kot 7{"\u00A0"}mm.
note-infeed-points-consider = Pri vbodnih točkah krmiljenje upošteva nadmeri stranskega in globinskega finega rezkanja ter polmer orodja za grobo rezkanje.
note-delta-radius-not-considered-for-infeed-points = Pri izračunu vbodnih točk krmiljenje ne upošteva vrednosti delta DR, programirane v stavku TOOL CALL.
note-narrow-places-not-pre-drilled = Na ozkih mestih krmiljenje morda ne more predvrtati z orodjem, ki je večje od orodja za grobo rezkanje.

# --- 22 ---
cycle-rough-out = Posnemanje
    .nc = VRTANJE
    .purpose = Konturo ravnino za ravnino grobo obdela do globinske nadmere ali obdela samo tisto, kar je pustilo večje orodje.
step-position-over-infeed-point = Krmiljenje z upoštevanjem nadmere stranskega finega rezkanja premakne orodje nad vbodno točko.
step-take-depths-of-partial-contours = Krmiljenje obdela delno konturo z lastno globino do te globine, vse druge pa do globine rezkanja iz konturnih podatkov.
step-go-to-infeed-point = Orodje se v hitrem teku premakne nad vbodno točko in navzdol na varnostno razdaljo nad že obdelano površino.
step-plunge-to-contour-level = Orodje se spusti na naslednjo globino primika, za { $q-contour-plunging-depth } globlje:
say-plunge-vertically-without-reciprocation = { $q-reciprocation-feed } = 0: navpično s pomikom { $q-contour-plunging-feed }, tudi če je za aktivno orodje definiran kot spuščanja { $mp-plunging-angle }
say-plunge-vertically-at-reciprocation-feed = { $mp-plunging-angle } = 90°: navpično z nihajnim pomikom { $q-reciprocation-feed }
say-plunge-on-helix-or-in-strokes = sicer po vijačnici pod kotom spuščanja { $mp-plunging-angle } ali, če vijačnica ni mogoča, nihajoče
step-rough-contour-level = Na tej globini orodje konturo rezka od znotraj navzven s pomikom { $q-roughing-feed }, okoli otokov pa po poteh, ki se približujejo konturi žepa. Pri tem obdela:
say-rough-what-coarser-tool-left = če je vneseno orodje za predhodno grobo rezkanje { $q-coarse-roughing-tool }, samo tisto, česar to orodje ni moglo obdelati
say-rough-whole-region = sicer celotno površino
message-contour-material-left = Orodje ne doseže celotne konture: v vogalih ali na ozkih mestih pusti material.
note-centre-cutting-or-pilot-drilling = Po potrebi uporabite rezkar s čelnim zobom, ki reže po sredini (DIN 844), ali predvrtajte s ciklom 21.
note-rough-out-plunging = Način spuščanja določajo parameter { $q-reciprocation-feed } in stolpca { $mp-plunging-angle } in { $mp-cutting-edge-length } v preglednici orodij. Pri { $q-reciprocation-feed } = 0 je spuščanje vedno navpično. Pri { $mp-plunging-angle } = 90° je spuščanje navpično s pomikom { $q-reciprocation-feed }. Pri nihajnem pomiku in { $mp-plunging-angle } od 0,1 do 89,999 poteka spuščanje po vijačnici pod tem kotom. Pri nihajnem pomiku brez vrednosti { $mp-plunging-angle } v preglednici orodij krmiljenje javi napako. Če za vijačnico ni prostora (na primer v utoru), poskusi krmiljenje z nihajočim spuščanjem; dolžina nihanja je { $mp-cutting-edge-length } / tan { $mp-plunging-angle }.
note-overlap-greater-than-one = Pri faktorju prekrivanja, večjem od 1, lahko pri konturah žepov z ostrimi notranjimi vogali ostane material. V testni grafiki preverite skrajno notranjo pot in po potrebi nekoliko spremenite faktor prekrivanja. Tako se rezi drugače razporedijo, kar pogosto da želeni rezultat.
note-wear-of-coarse-tool-not-considered = Pri finem posnemanju krmiljenje ne upošteva vrednosti obrabe DR, definirane za orodje za predhodno grobo rezkanje.
note-fine-roughing-needs-tool-data = Če do območja finega posnemanja ni mogoče priti s strani, se orodje spusti nihajoče. V ta namen v preglednici orodij definirajte dolžino rezila { $mp-cutting-edge-length } in največji kot spuščanja { $mp-plunging-angle } orodja; sicer lahko krmiljenje javi napako.

# --- 23 ---
cycle-floor-finishing = Globinsko fino rezkanje
    .nc = GLOB. FINO REZK.
    .purpose = Odstrani nadmero finega rezkanja, ki je po posnemanju ostala na dnu.
step-approach-contour-floor = Če je dovolj prostora, se orodje dnu mehko približa po navpičnem tangencialnem krožnem loku. Sicer se s pomikom { $q-contour-plunging-feed } navpično spusti na globino.
step-find-start-of-floor-finishing = Krmiljenje določi začetno točko za fino rezkanje dna.
step-finish-contour-floor = Orodje s pomikom { $q-roughing-feed } odrezka nadmero finega rezkanja, ki je ostala po posnemanju.
note-starting-point-by-itself = Začetno točko finega rezkanja krmiljenje določi samodejno. Odvisna je od prostora v žepu.
note-approach-radius-is-fixed = Polmer za primik na končno globino je interno določen in ni odvisen od kota spuščanja orodja.

# --- 24 ---
cycle-side-finishing = Stransko fino rezkanje
    .nc = STRAN. FINO REZK.
    .purpose = Fino rezka stene konture. Vsaka delna kontura se fino rezka posebej.
step-find-start-of-side-finishing = Krmiljenje določi začetno točko finega rezkanja.
step-finish-partial-contour = Krmiljenje spusti orodje s pomikom { $q-contour-plunging-feed } na naslednjo globino primika, za { $q-contour-plunging-depth } globlje, ga po krožnem loku tangencialno pripelje k delni konturi in jo fino rezka s pomikom { $q-roughing-feed }.
until-partial-contours-finished = niso fino rezkane vse delne konture
note-side-finishing-allowances = Vsota nadmere stranskega finega rezkanja { $q-remaining-side-allowance } in polmera orodja za fino rezkanje mora biti manjša od vsote nadmere stranskega finega rezkanja iz cikla 20 in polmera orodja za grobo rezkanje.
note-side-finishing-without-roughing = Enako velja, če se cikel izvede brez predhodnega posnemanja s ciklom 22; kot polmer orodja za grobo rezkanje tedaj velja 0.
note-side-finishing-mills-contours = Cikel je mogoče uporabiti tudi za konturno rezkanje. Za to konturo definirajte kot posamezen otok (brez omejitve žepa) in v ciklu 20 vnesite nadmero stranskega finega rezkanja, ki je večja od vsote nadmere finega rezkanja { $q-remaining-side-allowance } in polmera orodja.
note-start-depends-on-room-and-allowance = Začetno točko finega rezkanja krmiljenje določi samodejno. Odvisna je od prostora v žepu in od nadmere, programirane v ciklu 20.
note-start-depends-on-sequence = Začetna točka je odvisna tudi od zaporedja obdelave. Če cikel za fino rezkanje izberete s tipko GOTO in nato zaženete program, je lahko začetna točka drugje, kot če se program izvaja po vrsti.

# --- 25 ---
cycle-contour-train = Konturni segment
    .nc = KONTURNI SEGMENT
    .purpose = Skupaj s ciklom 14 obdela odprte in zaprte konture. V nasprotju s pozicionirnimi stavki vzdolž konture krmiljenje obdelavo nadzoruje, ves čas rezka v soteku ali v protiteku, lahko pa rezka tudi izmenično v obe smeri in z nadmerami.
step-position-over-contour-start = Krmiljenje premakne orodje na varno višino { $q-contour-clearance-height } in nad začetno točko konture.
step-plunge-beside-contour = Orodje se s pomikom { $q-contour-plunging-feed } spusti na naslednjo globino primika, za { $q-contour-plunging-depth } globlje.
step-mill-along-contour = Orodje s pomikom { $q-contour-milling-feed } rezka vzdolž konture; pri tem se upošteva nadmera finega rezkanja { $q-side-allowance }:
say-mill-to-and-fro = { $q-contour-milling-type } = 0: v obe smeri, z vsakim primikom izmenično v soteku in protiteku
say-mill-in-one-direction = { $q-contour-milling-type } = +1 ali −1: pri vsakem primiku v soteku oziroma v protiteku
until-milling-depth-reached = ni dosežena globina rezkanja { $q-milling-depth }
note-contour-damage-monitored = Krmiljenje obdelavo nadzoruje, tako da ne pride ne do spodrezov ne do poškodb konture. Konturo preverite z grafičnim testom.
note-inside-corners-may-need-reworking = Če je polmer orodja prevelik, bo notranje vogale konture morda treba dodatno obdelati.
note-milling-type-kept-when-mirrored = Konturo je mogoče ves čas obdelovati v soteku ali ves čas v protiteku. Vrsta rezkanja se ohrani tudi pri zrcaljenju kontur.
note-several-infeeds-to-and-fro = Pri več primikih lahko krmiljenje orodje premika izmenično v obe smeri, kar skrajša čas obdelave.
note-contour-in-several-operations = Vnesti je mogoče nadmere, tako da grobo in fino rezkanje potekata v več delovnih korakih.
note-only-first-contour-label = Krmiljenje upošteva samo prvo oznako iz cikla 14.
note-contour-data-not-needed = Cikel 20 ni potreben.
note-corner-feed-functions-without-effect = Dodatni funkciji M109 in M110 pri obdelavi konture s tem ciklom ne delujeta.
note-no-incremental-after-contour-train = Nevarnost kolizije! Po ciklu ne programirajte inkrementalnih mer: nanašajo se na položaj orodja na koncu cikla.
note-absolute-position-after-contour-train = Nevarnost kolizije! Po ciklu orodje po vseh glavnih oseh premaknite na definiran (absoluten) položaj, ker njegov položaj na koncu cikla ni enak položaju na začetku.

# --- 27 to 29 ---
step-plunge-into-cylinder = Orodje se s pomikom { $q-contour-plunging-feed } spusti na naslednjo globino primika, za { $q-contour-plunging-depth } globlje.
until-cylinder-milling-depth-reached = ni dosežena programirana globina rezkanja { $q-cylinder-milling-depth }
step-return-in-tool-axis = Orodje se po orodni osi vrne na varno višino ali na položaj, ki je bil nazadnje programiran pred ciklom.
guard-clearance-within-tool-radius = Varnostna razdalja ni večja od polmera orodja.
guard-spindle-not-across-rotary-axis = Os vretena ni pravokotna na os okrogle mize.
guard-datum-off-rotary-axis = Referenčna točka ni na osi okrogle mize: valj bi opletal.
guard-depth-out-of-cylinder = Globina rezkanja je pozitivna: orodje bi se oddaljilo od osi valja.
guard-slot-core-left = Utor je več kot dvakrat širši od orodja: med stenama ostane material.
note-contour-in-development = Konturo opišite v podprogramu, ki ga izberete s ciklom 14, in sicer vedno s koordinatama X in Y, ne glede na to, katere rotacijske osi ima stroj. Opis konture tako ni odvisen od konfiguracije stroja.
note-prepare-for-cylinder-interpolation = Proizvajalec stroja mora stroj in krmiljenje pripraviti za interpolacijo plašča valja. Upoštevajte priročnik za stroj.
note-contour-begins-with-both-coordinates-of-cylinder = V prvem NC-stavku konturnega podprograma vedno programirajte obe koordinati plašča valja.
note-centre-cutting-end-mill = Uporabite rezkar s čelnim zobom, ki reže po sredini (DIN 844).
note-cylinder-centred-on-rotary-table = Valj mora biti vpet na sredini okrogle mize.
note-datum-in-centre-of-rotary-table = Referenčno točko določite v središču okrogle mize.
note-spindle-across-rotary-axis = Ob priklicu cikla mora biti os vretena pravokotna na os okrogle mize. Sicer krmiljenje javi napako. Morda je treba preklopiti kinematiko.
note-cylinder-in-tilted-plane = Cikel je mogoče uporabiti tudi pri zavrteni obdelovalni ravnini.
note-clearance-greater-than-tool-radius = Varnostna razdalja { $q-cylinder-set-up-clearance } mora biti večja od polmera orodja.
note-many-contour-elements-take-time = Obdelava lahko traja dlje, če je kontura sestavljena iz veliko netangencialnih konturnih elementov.

# --- 27 ---
cycle-cylinder-surface = Plašč valja
    .nc = PLAŠČ VALJA
    .purpose = Konturo, definirano na odvoju, prenese na plašč valja.
step-mill-along-developed-contour = Orodje s pomikom { $q-contour-milling-feed } rezka vzdolž programirane konture.
step-back-over-infeed-point = Na koncu konture krmiljenje premakne orodje na varnostno razdaljo { $q-cylinder-set-up-clearance } in nazaj nad vbodno točko.
step-end-at-cylinder-clearance = Orodje se premakne na varnostno razdaljo { $q-cylinder-set-up-clearance }.
note-functions-for-developed-contour = Za pot orodja so na voljo funkcije L, CHF, CR, RND in CT.
note-angular-axis-unit = Vrednosti za kotno os (koordinate X) je mogoče vnesti v stopinjah ali v milimetrih (palcih); enoto določa { $q-development-dimension-type }.
note-guide-slots-with-other-cycle = Za rezkanje vodilnih utorov na valju uporabite cikel 28.

# --- 28 ---
cycle-cylinder-surface-slot = Plašč valja – rezkanje utorov
    .nc = PLAŠČ VALJA
    .purpose = Vodilni utor, definiran na odvoju, prenese na plašč valja; stene utora so skoraj vzporedne.
step-position-over-slot-infeed-point = Krmiljenje premakne orodje nad vbodno točko.
step-mill-along-slot-wall = Orodje s pomikom { $q-contour-milling-feed } rezka vzdolž stene utora; pri tem se upošteva nadmera stranskega finega rezkanja { $q-side-allowance }.
step-mill-back-along-opposite-wall = Na koncu konture krmiljenje premakne orodje k nasprotni steni utora in nazaj do vbodne točke.
step-rework-slot-walls = Če je definirana toleranca { $q-cylinder-slot-tolerance }, krmiljenje utor dodatno obdela, tako da so njegove stene čim bolj vzporedne.
note-walls-nearly-parallel = V nasprotju s ciklom 27 ta cikel orodje nastavi tako, da so stene pri aktivnem popravku polmera skoraj vzporedne. Povsem vzporedne so pri orodju, ki je natanko tako široko kot utor.
note-small-tool-distorts-slot = Čim manjše je orodje v primerjavi s širino utora, tem večja so popačenja pri krožnih lokih in poševnih premicah. Da jih zmanjšate, definirajte toleranco { $q-cylinder-slot-tolerance }: krmiljenje tedaj utor približa utoru, izdelanemu z orodjem, ki je tako široko kot utor.
note-program-centre-path-of-slot = Programirajte pot središča konture s popravkom polmera. Popravek polmera določa, ali krmiljenje utor izdela v soteku ali v protiteku.

# --- 29 ---
cycle-cylinder-surface-ridge = Plašč valja – rezkanje stojin
    .nc = STOJINA NA PLAŠČU VALJA
    .purpose = Stojino, definirano na odvoju, prenese na plašč valja; njene stene so vzporedne.
step-position-over-ridge-start = Krmiljenje premakne orodje nad začetno točko obdelave, ki jo izračuna iz širine stojine in premera orodja: ob prvi točki konturnega podprograma, zamaknjeno za polovico širine stojine in še za premer orodja. Stran določa popravek polmera: levo od stojine (sotek) ali desno od nje (protitek).
step-approach-ridge-wall = Na tej globini se orodje s pomikom { $q-contour-milling-feed } po tangencialnem krožnem loku premakne h konturi; morebitna nadmera stranskega finega rezkanja { $q-side-allowance } se upošteva.
step-mill-along-ridge-wall = Orodje s pomikom { $q-contour-milling-feed } rezka vzdolž stene stojine, dokler ta ni v celoti izdelana.
step-leave-ridge-wall = Orodje se od stene stojine odmakne tangencialno in se vrne na začetno točko obdelave.
note-ridge-walls-parallel = Cikel orodje nastavi tako, da so stene pri aktivnem popravku polmera vedno vzporedne.
note-program-centre-path-of-ridge = Programirajte pot središča stojine s popravkom polmera. Popravek polmera določa, ali krmiljenje stojino izdela v soteku ali v protiteku.
note-ridge-ends-in-semicircles = Na koncih stojine krmiljenje vedno doda polkrog; njegov polmer je polovica širine stojine.

# --- 225 ---
cycle-engraving = Graviranje
    .nc = GRAVIRANJE
    .purpose = Na ravno ploskev obdelovanca gravira besedilo, po premici ali po krožnem loku.
step-move-to-first-character = Krmiljenje premakne orodje v obdelovalni ravnini na začetno točko prvega znaka.
step-engrave-character = Orodje se s pomikom { $q-plunging-feed } navpično spusti na dno gravure in s pomikom { $q-milling-feed } rezka znak. Kjer se mora znotraj znaka dvigniti, se dvigne na varnostno razdaljo { $q-set-up-clearance }. Na koncu znaka je orodje na varnostni razdalji nad površino obdelovanca.
step-move-over-next-character = Krmiljenje premakne orodje na varnostni razdalji na začetno točko naslednjega znaka.
until-characters-engraved = niso gravirani vsi znaki
step-end-engraving-at-second-clearance = Krmiljenje premakne orodje na 2. varnostno razdaljo { $q-second-set-up-clearance }.
condition-text-runs-on-arc = { $q-text-arrangement } zahteva besedilo na krožnem loku
note-straight-text-starts-at-tool = Pri besedilu na premici ({ $q-text-arrangement } = 0) je položaj orodja ob priklicu cikla začetna točka prvega znaka.
note-circle-text-centre-at-tool = Pri besedilu na krožnem loku ({ $q-text-arrangement } = 1) je položaj orodja ob priklicu cikla središče kroga.
note-text-from-string-parameter = Besedilo je mogoče podati tudi z besedilnim parametrom (QS).
note-engraving-characters = Znaki, ki jih je mogoče gravirati: male črke, velike črke, številke in posebni znaki ! # $ % & ' ( ) * + , - . / : ; < = > ? @ [ \ ] _
note-engraving-doubled-characters = Posebna znaka % in \ krmiljenje uporablja za posebne funkcije. Če želite enega od njiju gravirati, ga v besedilu vnesite dvakrat, na primer %%.
note-engraving-control-characters = Posebni znak \ uvaja tudi znake, ki se ne natisnejo in razporejajo besedilo: \n je prelom vrstice, \t vodoravni tabulator (širina tabulatorja je 8 znakov), \v navpični tabulator (širina tabulatorja je ena vrstica).
note-proportional-font = Pisava je proporcionalna: vsak znak ima svojo širino. Faktor razmaka { $q-character-spacing-factor } spreminja razmik med znaki.
note-engraving-since-software = Cikel obstaja od programske opreme 34059x-02 naprej.
