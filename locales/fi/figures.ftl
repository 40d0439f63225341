# Kuvien sanat.

figure-section = Leikkaus
figure-plan = Ylhäältä
figure-chip-breaking = Lastunkatko
figure-deepened-start = Syvennetty aloituspiste
figure-centring-diameter = Keskiöinti halkaisijaan
figure-rotation = Kiertokulma
figure-pocket-position = Sijainti kutsuttaessa
figure-milling-type = Myötä- ja vastajyrsintä
figure-allowances = Viimeistelyvarat
figure-slot-position = Sijainti kutsuttaessa
figure-stud-position = Sijainti kutsuttaessa
figure-approach = Lähestymisasema
figure-stepping-angle = Kulma-askel
figure-traverse = Liike koneistuksesta toiseen
figure-plunging = Sisäänpisto
figure-side = Sivulta
figure-new-datum = Uusi peruspiste
figure-probe-axis = Peruspiste kosketusakselilla
figure-heights = Varmuuskorkeudet
figure-corner-a = Nurkka A
figure-corner-b = Nurkka B
figure-corner-c = Nurkka C
figure-corner-d = Nurkka D
figure-corner-1 = Nurkka 1
figure-corner-2 = Nurkka 2
figure-corner-3 = Nurkka 3
figure-corner-4 = Nurkka 4
figure-front = Otsapuolen upotus
figure-wall = Sivuetäisyys
figure-drilling = Poraus
figure-strategy = Koneistusstrategia
figure-pattern = Useita uria
figure-side-allowance = Sivun silitystyövara
figure-rounding = Sisänurkan pyöristyssäde
figure-between-points = Liike kosketuspisteiden välillä
way-rapid = pikaliike
way-feed = syöttöliike
way-probing = kosketusliike

cli-figure = Kirjoita työkierron kuvat SVG-tiedostoina
cli-figure-out = Kuvien hakemisto; se luodaan, jos sitä ei ole
cli-examples-figure =
    ciklo figure 205 --control tnc640 --lang sl --out figures
cli-coverage-figures = { $count } pituutta, kulmaa tai sijaintia ({ $of }:stä) puuttuu kuvista: { $ids }

diag-figure-example-missing = Työkierron { $cycle } kuva { $name } piirretään esimerkistä { $example }, jota työkierrolla ei ole.
diag-figure-moment-never = Työkierron { $cycle } kuvan { $name } suoritus ei koskaan saavuta kuvattua hetkeä ({ $reason }).
diag-figure-no-value = Työkierron { $cycle } kuvassa { $figure } parametrin { $name } mittapaikoilla ei ole kuvatulla hetkellä arvoa.
diag-figure-no-centre = Työkierron { $cycle } kuvassa { $figure } parametri { $name } on kulma, mutta sen keskipiste puuttuu tai ei ole piste.
diag-figure-axis-not-visible = Työkierron { $cycle } kuvassa { $figure } parametri { $name } mitataan akselilla, joka ei näy kuvasuunnassa.
diag-figure-mixed-places = Työkierron { $cycle } kuvassa { $figure } parametri { $name } mitataan koordinaatin ja pisteen välillä: molempien paikkojen on oltava samaa lajia.
diag-figure-measured-otherwise = Työkierron { $cycle } kuvassa { $figure } parametrin { $name } mittapaikkojen väli on suorituksessa { $measured }, mutta parametrin arvo on { $value }.
diag-figure-nothing-to-see = Työkierron { $cycle } kuvassa { $figure } parametrin { $name } arvo on 0, joten mitään ei näy.
diag-figure-place-not-reached = Työkierron { $cycle } kuvassa { $figure } parametri { $name } päättyy paikkaan ({ $place }), johon työkalu ei liiku ja jossa työkappaletta ei ole.
diag-figure-none = Työkierrolla { $cycle } ei ole kuvaa tässä ohjauksessa.
diag-figure-parameter-not-shown = Mikään työkierron { $cycle } kuva ei näytä parametria { $name }, eikä määrittelyssä ole perustelua.
