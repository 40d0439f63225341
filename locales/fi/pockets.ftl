# Taskut.
cycle-rectangular-pocket = Suorakulmatasku
    .nc = SUORAKULMATASKU
    .purpose = Työkierto koneistaa suorakulmataskun kokonaan: rouhinta, pohjan silitys ja sivun silitys. Mahdollista on myös pelkkä rouhinta, pelkkä pohjan ja sivun silitys, pelkkä pohjan silitys tai pelkkä sivun silitys.
step-move-over-pocket-centre = Ohjaus paikoittaa työkalun pikaliikkeellä ensin työkaluakselin suunnassa 2. varmuusetäisyydelle { $q-second-set-up-clearance } (ellei sitä ole annettu, varmuusetäisyydelle), sitten taskun keskipisteen yläpuolelle ja sen jälkeen varmuusetäisyydelle { $q-set-up-clearance }.
group-roughing = Rouhinta
step-plunge-at-centre = Työkalu tunkeutuu taskun keskipisteessä työkappaleeseen seuraavaan asetussyvyyteen { $q-plunging-depth }. Parametri { $q-plunging-strategy } määrää sisäänpistotavan:
say-plunge-vertically = { $q-plunging-strategy } = 0: kohtisuoraan syöttöarvolla { $q-plunging-feed }
say-plunge-helically = { $q-plunging-strategy } = 1: kierukkarataa pitkin syöttöarvolla { $q-plunging-feed }
say-plunge-reciprocating = { $q-plunging-strategy } = 2: edestakaisin heiluriliikkeellä syöttöarvolla { $q-plunging-feed }
step-clear-level = Ohjaus rouhii taskun sisältä ulospäin ja ottaa huomioon ratalimityksen { $q-path-overlap } sekä silitystyövarat { $q-side-allowance } ja { $q-floor-allowance }. Lopuksi työkalu irtautuu taskun seinämästä tangentiaalisesti.
step-leave-wall-and-return = Työkalu siirtyy varmuusetäisyydelle hetkellisen asetussyvyyden yläpuolelle ja palaa sieltä pikaliikkeellä taskun keskipisteeseen.
until-roughing-depth-reached = syvyys { $q-depth } vähennettynä pohjan silitystyövaralla { $q-floor-allowance } on saavutettu
group-finishing = Silitys
step-rapid-to-first-plunging-depth = Jos vain silitys on ohjelmoitu ({ $q-machining-operation } = 2), ohjaus siirtää työkalun taskun keskipisteessä pikaliikkeellä ensimmäiseen asetussyvyyteen.
step-finish-side = Jos sivun silitystyövara { $q-side-allowance } on määritelty, ohjaus silittää ensin taskun sivun ja lähestyy sitä tangentiaalisesti; jos { $q-finishing-infeed } on annettu, useilla asetusliikkeillä.
until-side-finished = sivu on silitetty syvyyteen { $q-depth }
step-finish-floor = Jos pohjan silitystyövara { $q-floor-allowance } on määritelty, ohjaus silittää sen jälkeen taskun pohjan sisältä ulospäin ja lähestyy sitä tangentiaalisesti.
step-leave-pocket = Työkalu poistuu taskusta pikaliikkeellä:
step-return-to-starting-point = Ohjaus palauttaa työkalun koneistustason alkupisteeseen.
guard-plunging-depth-zero = Asetussyvyyden on oltava suurempi kuin 0.
guard-tool-wider-than-pocket = Työkalu ei mahdu taskuun: kun sivun työvarat vähennetään, tasku on kapeampi kuin työkalu.
guard-plunging-angle-missing = Kierukkamainen ja heilurimainen sisäänpisto edellyttävät, että työkalutaulukon sisäänpistokulma { $mp-plunging-angle } ei ole 0.
guard-helix-too-small = Sisäänpiston kierukan halkaisija on pienempi kuin kaksi kertaa työkalun halkaisija. Koneparametri { $mp-suppress-plunge-err } kytkee tämän tarkastuksen pois keskeltä lastuavilla työkaluilla.
note-without-tool-table-plunge-vertically = Jos työkalutaulukko ei ole aktiivinen, sisäänpiston on aina oltava kohtisuora ({ $q-plunging-strategy } = 0), koska sisäänpistokulmaa ei voi määritellä.
note-position-at-pocket-start = Paikoita työkalu koneistustason alkupisteeseen sädekorjauksella R0. Ota huomioon taskun sijainti { $q-pocket-position }.
note-positions-in-tool-axis-itself = Ohjaus paikoittaa työkalun työkaluakselin suunnassa itse. Ota huomioon 2. varmuusetäisyys { $q-second-set-up-clearance }.
note-returns-to-starting-point = Työkierron lopussa ohjaus palauttaa työkalun koneistustasossa alkupisteeseen.
note-clearance-above-chips = Aina kun taso on rouhittu, työkalu palaa pikaliikkeellä taskun keskipisteeseen varmuusetäisyydelle hetkellisen asetussyvyyden yläpuolelle. Valitse varmuusetäisyys niin, ettei työkalu voi liikkuessaan juuttua lastuihin.
note-helix-diameter-monitored = Kierukkamaisessa sisäänpistossa ohjaus antaa virheilmoituksen, jos sen laskema kierukan halkaisija on pienempi kuin kaksi kertaa työkalun halkaisija. Keskeltä lastuavilla työkaluilla tarkastuksen voi kytkeä pois koneparametrilla { $mp-suppress-plunge-err }.
note-cutting-edge-limits-infeed = Jos terä on lyhyempi kuin asetussyvyys { $q-plunging-depth }, ohjaus pienentää sen työkalutaulukossa määritellyn terän pituuden { $mp-cutting-edge-length } suuruiseksi.
note-finishing-only-starts-at-first-depth = Törmäysvaara! Jos työkierto kutsutaan koneistuksen laajuudella 2 (vain silitys), ohjaus siirtää työkalun taskun keskipisteessä pikaliikkeellä ensimmäiseen asetussyvyyteen.
note-point-table-starting-points = Jos työkierto kutsutaan pistetaulukon avulla, koneistustason pisteet ovat työkierron alkupisteitä. Jos haluat käyttää taulukon karan akselin koordinaattia alkupisteen koordinaattina, anna työkappaleen yläpinnan koordinaatiksi { $q-surface-coordinate } arvo 0.
note-point-table-shifts-datum = Jos työkierto kutsutaan pistetaulukon avulla, ohjaus tulkitsee jokaisen pisteen ylimääräiseksi nollapisteen siirroksi.
