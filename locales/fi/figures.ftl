# Kuvien sanat.

figure-section = Leikkaus
figure-plan = Ylhäältä
figure-chip-breaking = Lastunkatko
figure-decreasing-infeeds = Pienenevät asetussyvyydet
figure-deepened-start = Syvennetty alkupiste
figure-centring-diameter = Keskiöinti halkaisijaan
figure-rotation = Kiertokulma
figure-pocket-position = Sijainti kutsuttaessa
figure-milling-type = Jyrsintämenetelmä
figure-allowances = Silitystyövarat
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
figure-between-holes = Liike paikkojen välillä
figure-depth-or-diameter = Syvyyden tai halkaisijan valinta
figure-threads-per-step = Kierteitä askelta kohti
figure-countersinking-moment = Upotuksen ajankohta
figure-finishing-counter-clockwise = Silitys vastapäivään, Q9 = +1
figure-finishing-clockwise = Silitys myötäpäivään, Q9 = −1
figure-train-climb = Myötälastu, Q15 = +1
figure-train-up-cut = Vastalastu, Q15 = −1
figure-train-to-and-fro = Edestakaisin, Q15 = 0
figure-operation = Koneistuksen laajuus
figure-no-contact = Liike ilman kosketusta
way-rapid = pikaliike
way-feed = syöttöliike
way-probing = kosketusliike

cli-figure = Kirjoita työkierron kuvat SVG-tiedostoina
cli-figure-out = Kuvien hakemisto; se luodaan, jos sitä ei ole
cli-examples-figure =
    ciklo figure 205 --control tnc640 --lang sl --out figures
cli-coverage-figures = kuvista puuttuu { $count }/{ $of } pituutta, kulmaa tai sijaintia: { $ids }

diag-figure-example-missing = Työkierron { $cycle } kuva { $name } piirretään esimerkistä { $example }, jota työkierrolla ei ole.
diag-figure-moment-never = Työkierron { $cycle } kuvan { $name } suoritus ei koskaan saavuta kuvattua hetkeä ({ $reason }).
diag-figure-name-taken = Työkierron { $cycle } kahden kuvan nimi on { $name }.
diag-figure-no-value = Työkierron { $cycle } kuvassa { $figure } parametrin { $name } mittapaikoilla ei ole kuvatulla hetkellä arvoa.
diag-figure-no-centre = Työkierron { $cycle } kuvassa { $figure } parametri { $name } on kulma, mutta sen keskipiste puuttuu tai ei ole piste.
diag-figure-axis-not-visible = Työkierron { $cycle } kuvassa { $figure } parametri { $name } mitataan akselilla, joka ei näy kuvasuunnassa.
diag-figure-mixed-places = Työkierron { $cycle } kuvassa { $figure } parametri { $name } mitataan koordinaatin ja pisteen välillä: molempien paikkojen on oltava samaa lajia.
diag-figure-measured-otherwise = Työkierron { $cycle } kuvassa { $figure } parametrin { $name } mittapaikkojen väli on suorituksessa { $measured }, mutta parametrin arvo on { $value }.
diag-figure-nothing-to-see = Työkierron { $cycle } kuvassa { $figure } parametrin { $name } arvo on 0, joten mitään ei näy.
diag-figure-place-not-reached = Työkierron { $cycle } kuvassa { $figure } parametri { $name } päättyy paikkaan ({ $place }), johon työkalu ei liiku ja jossa työkappaletta ei ole.
diag-figure-none = Työkierrolla { $cycle } ei ole kuvaa tässä ohjauksessa.
diag-figure-parameter-not-shown = Mikään työkierron { $cycle } kuva ei näytä parametria { $name }, eikä työkierron kuvauksessa ole perustelua.
figure-teeth = Terien mittaus
figure-turning-tool = Pyörivä työkalu
figure-single-teeth = Yksittäiset terät
figure-line-angle = Rivien kulma
figure-rotary-a = Kiertoakselin A suunnassa
figure-rotary-b = Kiertoakselin B suunnassa
figure-rotary-c = Kiertoakselin C suunnassa
figure-backlash = Välys
figure-sphere = Kalibrointikuulan kosketus
figure-basic-rotation = Peruskääntö
figure-greatest-dimension = Suurin mitta
figure-least-dimension = Pienin mitta
figure-centre-tolerance = Keskipisteen toleranssi
figure-spatial-angle-a = Tilakulma A
figure-spatial-angle-b = Tilakulma B
figure-spatial-angle-c = Tilakulma C
figure-counterbore = Upotus
figure-disengaging = Irtiajosuunta
figure-pre-drilled = Esiporattu reikä
figure-touch-points = Kosketuspisteet
figure-measuring-axis = Mittausakseli
figure-traverse-direction = Liikesuunta
figure-straight-or-circle = Liiketapa
figure-program = Ohjelma ylhäältä
figure-program-turned = Ohjelma: puolet kappaleesta leikattuna
figure-program-recess = Ohjelma: ura
figure-program-side = Ohjelma sivulta
figure-program-across = Ohjelma kiertoakselin suunnassa
figure-program-tilted = Ohjelman käännetty taso
figure-wide-slot = Leveä ura
