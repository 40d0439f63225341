# Sorvaus: pistosorvaus, pisto ja kierteet.

# --- 841, 842, 840, 851, 852, 850 ---
cycle-simple-radial-recess-turning = Yksinkertainen säteittäinen pistosorvaus
    .nc = PISTOSORVAUS YKSINK., SÄTEITT.
    .purpose = Työkierto koneistaa suorakulmaisia uria pitkittäissuunnassa pistosorvaamalla: rouhinta, silitys tai molemmat. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti.
cycle-extended-radial-recess-turning = Laajennettu säteittäinen pistosorvaus
    .nc = PISTOSORVAUS LAAJ., SÄTEITT.
    .purpose = Työkierto koneistaa uria pitkittäissuunnassa pistosorvaamalla: rouhinta, silitys tai molemmat. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti. Urassa voi olla vinot sivuseinämät, pyöristetyt nurkat sekä viiste tai pyöristys muodon alussa ja lopussa.
cycle-radial-contour-recess-turning = Säteittäinen muodon pistosorvaus
    .nc = MUODON PISTOSORVAUS, SÄTEITT.
    .purpose = Työkierto koneistaa vapaamuotoisia uria pitkittäissuunnassa pistosorvaamalla: rouhinta, silitys tai molemmat. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti.
cycle-simple-axial-recess-turning = Yksinkertainen aksiaalinen pistosorvaus
    .nc = PISTOSORVAUS YKSINK., AKSIAAL.
    .purpose = Työkierto koneistaa suorakulmaisia uria poikittaissuunnassa (otsapinnalle) pistosorvaamalla: rouhinta, silitys tai molemmat. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti.
cycle-extended-axial-recess-turning = Laajennettu aksiaalinen pistosorvaus
    .nc = PISTOSORVAUS LAAJ., AKSIAAL.
    .purpose = Työkierto koneistaa uria poikittaissuunnassa pistosorvaamalla: rouhinta, silitys tai molemmat. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti. Urassa voi olla vinot sivuseinämät, pyöristetyt nurkat sekä viiste tai pyöristys muodon alussa ja lopussa.
cycle-axial-contour-recess-turning = Aksiaalinen muodon pistosorvaus
    .nc = MUODON PISTOSORVAUS, AKSIAAL.
    .purpose = Työkierto koneistaa vapaamuotoisia uria poikittaissuunnassa pistosorvaamalla: rouhinta, silitys tai molemmat. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti.

# --- 861, 862, 860, 871, 872, 870 ---
cycle-radial-recessing = Säteittäinen pisto
    .nc = PISTO SÄTEITTÄIN
    .purpose = Työkierto tekee suorakulmaisia uria säteittäisellä pistolla: rouhinta, silitys tai molemmat. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti.
cycle-extended-radial-recessing = Laajennettu säteittäinen pisto
    .nc = LAAJ. PISTO SÄTEITTÄIN
    .purpose = Työkierto tekee uria säteittäisellä pistolla: rouhinta, silitys tai molemmat. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti. Urassa voi olla vinot sivuseinämät, pyöristetyt nurkat sekä viiste tai pyöristys muodon alussa ja lopussa.
cycle-radial-contour-recessing = Säteittäinen muodon pisto
    .nc = MUODON PISTO SÄTEITTÄIN
    .purpose = Työkierto tekee vapaamuotoisia uria säteittäisellä pistolla: rouhinta, silitys tai molemmat. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti.
cycle-axial-recessing = Aksiaalinen pisto
    .nc = PISTO AKSIAALISESTI
    .purpose = Työkierto tekee suorakulmaisia uria aksiaalisella pistolla (tasopisto): rouhinta, silitys tai molemmat. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti.
cycle-extended-axial-recessing = Laajennettu aksiaalinen pisto
    .nc = LAAJ. PISTO AKSIAALISESTI
    .purpose = Työkierto tekee uria aksiaalisella pistolla (tasopisto): rouhinta, silitys tai molemmat. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti. Urassa voi olla vinot sivuseinämät, pyöristetyt nurkat sekä viiste tai pyöristys muodon alussa ja lopussa.
cycle-axial-contour-recessing = Aksiaalinen muodon pisto
    .nc = MUODON PISTO AKSIAALISESTI
    .purpose = Työkierto tekee vapaamuotoisia uria aksiaalisella pistolla (tasopisto): rouhinta, silitys tai molemmat. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti.

# --- 831, 832, 830 ---
cycle-longitudinal-thread = Pitkittäiskierre
    .nc = PITKITTÄISKIERRE
    .purpose = Työkierto sorvaa yksi- tai monipäisiä pitkittäiskierteitä.
cycle-extended-thread = Laajennettu kierre
    .nc = LAAJENNETTU KIERRE
    .purpose = Työkierto sorvaa yksi- tai monipäisiä pitkittäis-, taso- tai kartiokierteitä.
cycle-contour-parallel-thread = Muodon suuntainen kierre
    .nc = MUODON SUUNTAINEN KIERRE
    .purpose = Työkierto sorvaa yksi- tai monipäisiä vapaamuotoisia pitkittäis- tai tasokierteitä.

# --- urien rouhinta ---
step-take-tool-position-as-start = Ohjaus ottaa työkierron alkupisteeksi työkalun aseman työkierron kutsuhetkellä.
step-start-recess-at-contour-start-diameter = Jos alkupisteen X-koordinaatti on pienempi kuin halkaisija muodon alussa { $q-contour-start-diameter }, ohjaus paikoittaa työkalun X-suunnassa halkaisijalle { $q-contour-start-diameter } ja aloittaa työkierron sieltä.
step-start-recess-at-contour-start-z = Jos alkupisteen Z-koordinaatti on pienempi kuin muodon alku Z-suunnassa { $q-contour-start-z }, ohjaus paikoittaa työkalun Z-suunnassa koordinaattiin { $q-contour-start-z } ja aloittaa työkierron sieltä.
step-start-recess-at-contour-point-x = Jos alkupisteen X-koordinaatti on pienempi kuin muodon alkupisteen, ohjaus paikoittaa työkalun X-suunnassa muodon alkupisteeseen ja aloittaa työkierron sieltä.
step-start-recess-at-contour-point-z = Jos alkupisteen Z-koordinaatti on pienempi kuin muodon alkupisteen, ohjaus paikoittaa työkalun Z-suunnassa muodon alkupisteeseen ja aloittaa työkierron sieltä.
step-rapid-to-first-recess-z = Ohjaus paikoittaa työkalun Z-suunnassa pikaliikkeellä (ensimmäinen pistoasema).
step-rapid-to-first-recess-x = Ohjaus paikoittaa työkalun X-suunnassa pikaliikkeellä (ensimmäinen pistoasema).
step-recess-from-start-to-first-depth = Ohjaus tekee piston työkierron alkupisteestä ensimmäiseen asetussyvyyteen.
step-recess-to-first-depth = Ohjaus tekee piston ensimmäiseen asetussyvyyteen.
step-rough-groove-lengthwise = Ohjaus rouhii aloitusaseman ja loppupisteen välisen alueen pitkittäissuunnassa syöttöarvolla { $q-turning-roughing-feed }.
step-rough-groove-crosswise = Ohjaus rouhii aloitusaseman ja loppupisteen välisen alueen poikittaissuunnassa syöttöarvolla { $q-turning-roughing-feed }.
step-choose-side-of-next-recess = Koneistussuunta { $q-recess-direction } määrää, missä seuraava asetusliike tehdään:
say-lift-off-and-return = { $q-recess-direction } = 1 (vain yksi suunta): ohjaus nostaa työkalun irti varmuusetäisyyden verran, palauttaa sen pikaliikkeellä ja lähestyy muotoa uudelleen määritellyllä syöttöarvolla
say-infeed-at-both-sides = { $q-recess-direction } = 0 (molemmat suunnat): asetusliike tehdään molemmilla puolilla
step-recess-to-next-depth = Ohjaus tekee piston seuraavaan asetussyvyyteen.
until-groove-depth-reached = uran syvyys on saavutettu
step-recess-at-both-walls = Ohjaus paikoittaa työkalun uudelleen varmuusetäisyydelle ja tekee yhden piston kummallakin sivuseinämällä.
step-infeed-parallel-to-axis = Ohjaus tekee pikaliikkeellä koordinaattiakselin suuntaisen asetusliikkeen. Sivuttaisasetus on 0,8 kertaa terän leveys.
step-recess-radially = Ohjaus koneistaa aloitusaseman ja loppupisteen välisen alueen säteittäissuunnassa syöttöarvolla { $q-turning-roughing-feed }.
step-recess-axially = Ohjaus koneistaa aloitusaseman ja loppupisteen välisen alueen aksiaalisuunnassa syöttöarvolla { $q-turning-roughing-feed }.
until-groove-width-reached = uran leveys on saavutettu
until-groove-shape-reached = uran muoto on saavutettu

# --- urien silitys ---
step-rapid-to-first-flank = Ohjaus paikoittaa työkalun pikaliikkeellä uran ensimmäiselle kyljelle.
step-rapid-again-to-first-flank = { step-rapid-to-first-flank }
step-rapid-to-second-flank = Ohjaus paikoittaa työkalun pikaliikkeellä uran toiselle kyljelle.
step-finish-groove-wall = Ohjaus silittää uran sivuseinämän syöttöarvolla { $q-turning-finishing-feed }.
step-finish-second-groove-wall = { step-finish-groove-wall }
step-finish-groove-walls = Ohjaus silittää uran sivuseinämät syöttöarvolla { $q-turning-finishing-feed }.
step-finish-groove-floor = Ohjaus silittää uran pohjan määritellyllä syöttöarvolla.
step-finish-groove-floor-or-all = Ohjaus silittää uran pohjan määritellyllä syöttöarvolla:
say-finish-whole-groove = jos muodon nurkan säde { $q-contour-corner-radius } on annettu, ohjaus silittää koko uran yhdellä kertaa
say-finish-floor-only = muussa tapauksessa vain pohjan
step-retract-from-groove = Ohjaus vetää työkalun pois urasta pikaliikkeellä.
step-finish-half-of-width = Ohjaus silittää puolet uran leveydestä määritellyllä syöttöarvolla.
step-finish-other-half-of-width = Ohjaus silittää toisen puolen uran leveydestä määritellyllä syöttöarvolla.
step-finish-half-of-groove = Ohjaus silittää puolet urasta määritellyllä syöttöarvolla.
step-finish-other-half-of-groove = Ohjaus silittää uran toisen puolen määritellyllä syöttöarvolla.

# --- kierteet ---
step-move-before-thread-and-infeed = Ohjaus paikoittaa työkalun pikaliikkeellä varmuusetäisyydelle kierteen eteen ja tekee asetusliikkeen.
step-cut-thread-parallel-to-axis = Ohjaus ajaa pitkittäislastun kiertoakselin suuntaisesti. Se tahdistaa syöttöarvon ja kierrosluvun niin, että syntyy määritelty nousu.
step-cut-thread-along-line = Ohjaus lastuaa kierteen alkupisteen ja loppupisteen välille. Se tahdistaa syöttöarvon ja kierrosluvun niin, että syntyy määritelty nousu.
step-cut-thread-along-contour = Ohjaus lastuaa kierteen määritellyn kierremuodon suuntaisesti. Se tahdistaa syöttöarvon ja kierrosluvun niin, että syntyy määritelty nousu.
step-lift-off-thread = Ohjaus nostaa työkalun pikaliikkeellä irti varmuusetäisyyden verran.
step-infeed-at-angle = Ohjaus tekee asetusliikkeen. Asetusliikkeet noudattavat asetuskulmaa { $q-thread-infeed-angle }.
until-thread-depth-reached = kierteen syvyys on saavutettu
step-make-air-cuts = Ohjaus ajaa niin monta tyhjälastua kuin { $q-number-of-air-cuts } määrää.
step-infeed-for-next-start = Seuraavaa kierteen päätä varten ohjaus vie työkalun takaisin ensimmäisen asetusliikkeen syvyyteen. Lastu alkaa karan kulmasta, joka on siirtynyt kierteen päiden jaon verran.
until-all-thread-starts-cut = kierteen kaikki päät ({ $q-number-of-thread-starts }) on lastuttu

# --- ehdot ---
condition-cutting-limit-wanted = { $q-cutting-limit } = 1
condition-taper-angle-given = kartio mitoitetaan kulmalla ({ $q-taper-dimensioning })
condition-start-diameter-given = kartio mitoitetaan muodon alun halkaisijalla ({ $q-taper-dimensioning })
condition-start-z-given = kartio mitoitetaan muodon alun Z-koordinaatilla ({ $q-taper-dimensioning })
condition-end-diameter-given = kartio mitoitetaan muodon lopun halkaisijalla ({ $q-taper-dimensioning })
condition-end-z-given = kartio mitoitetaan muodon lopun Z-koordinaatilla ({ $q-taper-dimensioning })

# --- virheet ---
guard-recess-offset-too-great = Sivusiirtymä on yli 80{"\u00A0"}% terän vaikuttavasta leveydestä, joka on terän leveys vähennettynä kaksinkertaisella terän säteellä.

# --- ohjeet: urat ---
note-recess-turning-alternates = Pistosorvauksessa pistot asetussyvyyteen ja rouhintalastut vuorottelevat. Näin koneistuksessa tarvitaan mahdollisimman vähän vetäytymisiä ja asetusliikkeitä.
note-groove-extended-scope = Laajennetut ominaisuudet: muodon alkuun ja loppuun voidaan lisätä viiste tai pyöristys; uran sivuseinämille voidaan määritellä kulmat; muodon nurkkiin voidaan lisätä säteet.
note-recess-cuts-get-shorter = Toisen asetusliikkeen jälkeen ohjaus lyhentää jokaista seuraavaa lastua 0,1{"\u00A0"}mm. Se vähentää työkalun sivuttaiskuormitusta. Jos työkierrossa on annettu siirtymäleveys { $q-recess-offset-width }, lastua lyhennetään sen sijaan tämän arvon verran. Jäljelle jäänyt materiaali poistetaan piston lopussa yhdellä pistolla. Jos sivusiirtymä on yli 80{"\u00A0"}% terän vaikuttavasta leveydestä (terän leveys − 2 × terän säde), ohjaus antaa virheilmoituksen.
title-groove-with-chamfers = Sorvatun olakkeen ura, jossa on viisteet (esimerkkiohjelma)

# --- ohjeet: kierteet ---
note-threads-with-several-starts = Työkierrolla voidaan tehdä yksi- tai monipäisiä kierteitä.
note-standard-thread-depth = Jos työkierrossa ei ole annettu kierteen syvyyttä, työkierto käyttää vakiokierresyvyyttä.
note-standard-thread-depth__longitudinal-thread = Jos työkierrossa ei ole annettu kierteen syvyyttä, työkierto käyttää standardin ISO 1502 mukaista kierresyvyyttä.
note-thread-outside-or-inside = Työkiertoa voidaan käyttää ulko- ja sisäpuoliseen koneistukseen.
note-extended-thread-scope = Laajennetut ominaisuudet: pitkittäis- tai tasokierre on valittavissa; kartion mitoitustavan, kartiokulman ja muodon X-alkupisteen parametreilla voidaan määritellä erilaisia kartiokierteitä; sisäänajomatka ja yliajomatka määräävät matkat, joilla syöttöakseli kiihdytetään ja jarrutetaan.
note-overrun-after-contour = Törmäysvaara! Työkierto { $cycle } ajaa ohjelmoidun muodon jälkeen vielä yliajomatkan { $q-overrun-path }. Ota käytettävissä oleva tila huomioon.
note-clearance-is-starting-path = Ohjaus käyttää varmuusetäisyyttä { $q-thread-clearance } sisäänajomatkana. Sen on oltava niin pitkä, että syöttöakselit ehditään kiihdyttää tarvittavaan nopeuteen.
note-pitch-is-overrun-path = Ohjaus käyttää kierteen nousua { $q-turned-thread-pitch } yliajomatkana. Sen on oltava niin pitkä, että syöttöakselit ehditään jarruttaa.
note-extended-thread-has-paths = Työkierrossa 832 on parametrit sisäänajomatkalle ja yliajomatkalle.
note-starting-path-long-enough = Sisäänajomatkan { $q-starting-path } on oltava niin pitkä, että syöttöakselit ehditään kiihdyttää tarvittavaan nopeuteen.
note-overrun-path-long-enough = Yliajomatkan { $q-overrun-path } on oltava niin pitkä, että syöttöakselit ehditään jarruttaa.
note-paths-outside-contour = Sekä sisäänajomatka että yliajomatka ovat määritellyn muodon ulkopuolella.
note-override-while-thread-cutting = Syötön muunnoskytkin ei vaikuta, kun ohjaus lastuaa kierrettä. Karan kierrosluvun muunnoskytkin vaikuttaa edelleen koneen valmistajan määräämissä rajoissa. Katso koneen käyttöohjekirjaa.
note-thread-with-separate-holder = Joissakin konetyypeissä sorvaustyökalua ei kiinnitetä jyrsinkaraan, vaan sen vieressä olevaan erilliseen pitimeen. Siellä sorvaustyökalua ei voi kääntää 180° esimerkiksi ulko- ja sisäkierteiden lastuamiseksi samalla työkalulla. Jos haluat käyttää tällaisessa koneessa ulkopuolista työkalua sisäpuoliseen koneistukseen, koneista negatiivisella halkaisija-alueella (−X) ja käännä työkappaleen pyörintäsuunta. Kun esipaikoitetaan negatiivisella halkaisija-alueella, ohjaus kääntää kierteen sijainnin { $q-thread-position } vaikutuksen: silloin 1 on ulkokierre ja 0 sisäkierre.
note-thread-retracts-directly = Törmäysvaara! Työkalu vetäytyy suoraan aloitusasemaan. Esipaikoita se aina niin, että ohjaus voi ajaa alkupisteeseen työkierron lopussa ilman törmäystä.

# --- ohjeet: muodot aliohjelmasta ---
note-contour-by-cycle-14 = Muoto kuvataan aliohjelmassa ratatoiminnoilla tai FK-toiminnoilla. Ohjelmoi ennen työkierron kutsua työkierto 14 (muoto), joka määrää aliohjelman numeron.
note-local-parameters-in-contour = Jos muotoaliohjelmassa käytetään paikallisia parametreja QL, niiden arvot on myös sijoitettava tai laskettava muotoaliohjelmassa.
note-cutting-limit-limits-area = Lastuamisraja rajaa koneistettavan muodon alueen. Lähestymis- ja poistumisradat saavat ylittää lastuamisrajan.
note-cutting-limit-by-tool-position = Työkalun asema ennen työkierron kutsua vaikuttaa lastuamisrajan toimintaan: ohjaus lastuaa materiaalin siltä puolelta lastuamisrajaa, jolla työkalu on ennen työkierron kutsua.
