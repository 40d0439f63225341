# Besede slik.

figure-section = Prerez
figure-plan = Pogled od zgoraj
figure-chip-breaking = Lom ostružkov
figure-decreasing-infeeds = Pojemajoči primiki
figure-deepened-start = Globlja začetna točka
figure-centring-diameter = Centriranje do premera
figure-rotation = Rotacijski kot
figure-pocket-position = Položaj ob priklicu
figure-milling-type = Rezkanje v soteku in protiteku
figure-allowances = Nadmere finega rezkanja
figure-slot-position = Položaj ob priklicu
figure-stud-position = Položaj ob priklicu
figure-approach = Položaj primika
figure-stepping-angle = Kotni korak
figure-traverse = Pot med obdelavami
figure-plunging = Spuščanje
figure-side = Pogled od strani
way-rapid = hitri tek
way-feed = pomik
way-probing = tipanje

cli-figure = Zapiše slike cikla kot datoteke SVG
cli-figure-out = Mapa za slike; če ne obstaja, se ustvari
cli-examples-figure =
    ciklo figure 205 --control tnc640 --lang sl --out figures
cli-coverage-figures = { $count } od { $of } dolžin, kotov in položajev ni na nobeni sliki: { $ids }

diag-figure-example-missing = Slika { $name } cikla { $cycle } naj bi bila narisana iz primera { $example }, ki ga cikel nima.
diag-figure-moment-never = Izvajanje slike { $name } cikla { $cycle } nikoli ne doseže prikazanega trenutka ({ $reason }).
diag-figure-name-taken = Dve sliki cikla { $cycle } imata isto ime { $name }.
diag-figure-no-value = Slika { $figure } cikla { $cycle } prikazuje { $name } med mestoma, ki v tem trenutku nimata vrednosti.
diag-figure-no-centre = Slika { $figure } cikla { $cycle } prikazuje { $name } kot kot, vendar središče manjka ali ni točka.
diag-figure-axis-not-visible = Slika { $figure } cikla { $cycle } prikazuje { $name } vzdolž osi, ki je pogled nima.
diag-figure-mixed-places = Slika { $figure } cikla { $cycle } prikazuje { $name } med koordinato in točko: obe mesti morata biti iste vrste.
diag-figure-measured-otherwise = Slika { $figure } cikla { $cycle } prikazuje { $name } med mestoma, ki sta pri izvajanju oddaljeni { $measured }; vrednost je { $value }.
diag-figure-nothing-to-see = Slika { $figure } cikla { $cycle } prikazuje { $name } z vrednostjo 0: nič ni vidno.
diag-figure-place-not-reached = Slika { $figure } cikla { $cycle } prikazuje { $name } do mesta ({ $place }), ki ga ne dosežeta ne orodje ne obdelovanec.
diag-figure-none = Cikel { $cycle } na tem krmiljenju nima slike.
diag-figure-parameter-not-shown = Nobena slika cikla { $cycle } ne prikazuje { $name }, specifikacija pa ne navaja razloga.

figure-new-datum = Nova referenčna točka

figure-probe-axis = Referenčna točka na osi tipalnega sistema

figure-heights = Varne višine

figure-corner-a = Vogal A

figure-corner-b = Vogal B

figure-corner-c = Vogal C

figure-corner-d = Vogal D

figure-corner-1 = Vogal 1

figure-corner-2 = Vogal 2

figure-corner-3 = Vogal 3

figure-corner-4 = Vogal 4

figure-front = Čelno grezenje

figure-wall = Stranska varnostna razdalja

figure-drilling = Vrtanje

figure-strategy = Obdelovalna strategija

figure-pattern = Več utorov

figure-side-allowance = Stranska nadmera

figure-rounding = Notranji zaokroževalni polmer

figure-between-points = Pot med tipalnimi točkami
figure-between-holes = Pot med položaji
figure-depth-or-diameter = Globina ali premer
figure-threads-per-step = Zavoji ali vijačnice
figure-countersinking-moment = Kdaj se grezi
figure-finishing-counter-clockwise = Fina obdelava v nasprotni smeri urnega kazalca, Q9 = +1
figure-finishing-clockwise = Fina obdelava v smeri urnega kazalca, Q9 = −1
figure-train-climb = Rezkanje v soteku, Q15 = +1
figure-train-up-cut = Rezkanje v protiteku, Q15 = −1
figure-train-to-and-fro = Tja in nazaj, Q15 = 0
figure-operation = Obseg obdelave

figure-no-contact = Pot brez dotika

figure-teeth = Merjenje rezil

figure-turning-tool = Vrteče se orodje

figure-single-teeth = Posamezna rezila

figure-line-angle = Kot vrstic

figure-rotary-a = Vzdolž rotacijske osi A

figure-rotary-b = Vzdolž rotacijske osi B

figure-rotary-c = Vzdolž rotacijske osi C

figure-backlash = Zračnost

figure-sphere = Tipanje umeritvene krogle

figure-basic-rotation = Osnovna rotacija

figure-greatest-dimension = Največja mera

figure-least-dimension = Najmanjša mera

figure-centre-tolerance = Toleranca središča

figure-spatial-angle-a = Prostorski kot A

figure-spatial-angle-b = Prostorski kot B

figure-spatial-angle-c = Prostorski kot C

figure-counterbore = Grezenje

figure-disengaging = Smer prostega premika

figure-pre-drilled = Predhodno izvrtana vrtina

figure-touch-points = Tipalne točke

figure-measuring-axis = Merilna os

figure-traverse-direction = Smer premika

figure-straight-or-circle = Premočrtno ali po krožnici
figure-program = Program od zgoraj
figure-program-turned = Program: polovica dela v prerezu
figure-program-recess = Program: utor
figure-program-side = Program s strani
figure-program-across = Program v smeri rotacijske osi
figure-program-tilted = Zavrtena ravnina programa

figure-wide-slot = Širok utor
