# Sorvaus: pitkittäissorvaus ja tasosorvaus.

# --- sorvauksen työkiertojen yhteiset lauseet ---
group-turning-roughing = Rouhinta
group-turning-finishing = Silitys
step-rapid-radial-infeed = Ohjaus tekee pikaliikkeellä koordinaattiakselin suuntaisen asetusliikkeen säteittäissuunnassa. Asetusliikkeen suuruuden se laskee suurimmasta lastuamissyvyydestä { $q-max-cutting-depth }.
step-cut-longitudinally = Ohjaus koneistaa aloitusaseman ja loppupisteen välisen alueen pitkittäissuunnassa syöttöarvolla { $q-turning-roughing-feed }.
step-retract-by-infeed = Ohjaus vetää työkalun takaisin määritellyllä syöttöarvolla asetusliikkeen verran:
say-follow-contour-within-infeed = jos { $q-contour-smoothing } = 0, muotoa pitkin asetusliikkeen alueella
say-lift-off-at-45-degrees = muussa tapauksessa 45°:n kulmassa
step-rapid-to-start-of-cut = Ohjaus palauttaa työkalun pikaliikkeellä lastun alkuun.
until-turning-contour-finished = muoto on valmis
step-smooth-after-last-cut = Jos { $q-contour-smoothing } = 1, ohjaus tasoittaa koko muodon viimeisen lastun jälkeen.
step-rapid-to-starting-point-of-cycle = Ohjaus palauttaa työkalun pikaliikkeellä työkierron alkupisteeseen.
step-rapid-back-after-finishing = { step-rapid-to-starting-point-of-cycle }
step-rapid-in-z-by-clearance = Ohjaus siirtää työkalua pikaliikkeellä Z-suunnassa varmuusetäisyyden { $q-turning-clearance } verran.
step-rapid-paraxial-infeed = Ohjaus tekee pikaliikkeellä koordinaattiakselin suuntaisen asetusliikkeen.
step-finish-turned-contour = Ohjaus silittää valmisosan muodon syöttöarvolla { $q-turning-finishing-feed }.
step-retract-by-clearance = Ohjaus vetää työkalun takaisin määritellyllä syöttöarvolla varmuusetäisyyden { $q-turning-clearance } verran.
guard-turning-mode-missing = Sorvauksen työkierrot voidaan suorittaa vain sorvauskäytössä FUNCTION MODE TURN.
note-turning-mode-only = Sorvauksen työkiertoja voidaan käyttää vain sorvauskäytössä FUNCTION MODE TURN.
note-program-before-turning-cycle = Ohjelmoi aina ennen työkierron kutsua: sorvauskäyttö FUNCTION MODE TURN, työkalukutsu TOOL CALL, sorvauskaran pyörintäsuunta (esimerkiksi M303), kierrosluku tai lastuamisnopeus toiminnolla FUNCTION TURNDATA SPIN, M136, jos käytetään kierroskohtaisia syöttöarvoja (mm/kierros), paikoituslause sopivaan alkupisteeseen (esimerkiksi L X+130 Y+0 R0 FMAX) sekä työkierto 800, joka sovittaa koordinaatiston ja suuntaa työkalun.
note-call-turning-cycle = Kutsu työkierto käskyllä CYCL CALL tai koodilla M99.
note-outside-or-inside-by-tool-position = Työkierto koneistaa ulkopuolen, jos työkalu on työkierron kutsuhetkellä koneistettavan muodon ulkopuolella, ja sisäpuolen, jos työkalu on sen sisäpuolella.
note-outside-or-inside-by-diameters = Jos alkuhalkaisija { $q-contour-start-diameter } on suurempi kuin loppuhalkaisija { $q-contour-end-diameter }, työkierto koneistaa ulkopuolen; jos se on pienempi, sisäpuolen.
note-outside-or-inside-by-contour = Jos muodon alkupisteen koordinaatti on suurempi kuin loppupisteen, työkierto koneistaa ulkopuolen; jos se on pienempi, sisäpuolen.
note-check-after-change-of-side = Tarkasta työkaluasetukset ja pyörintäsuunta aina, kun vaihdat ulko- ja sisäpuolisen koneistuksen välillä.
note-area-from-tool-position-to-end-point = Rouhinnassa työkierto koneistaa alueen työkalun asemasta työkierron kutsuhetkellä (työkierron alkupisteestä) työkierrossa määriteltyyn loppupisteeseen.
note-position-at-starting-position = Ohjelmoi ennen työkierron kutsua paikoituslause aloitusasemaan sädekorjauksella R0.
note-position-at-safe-position = Ohjelmoi ennen työkierron kutsua paikoituslause turvalliseen asemaan sädekorjauksella R0.
note-tool-position-determines-area = Työkalun asema työkierron kutsuhetkellä (työkierron alkupiste) määrää koneistettavan alueen koon.
note-tool-position-influences-area = Työkalun asema työkierron kutsuhetkellä (työkierron alkupiste) vaikuttaa koneistettavaan alueeseen.
note-pre-positioning-influences-time = Työkalun esipaikoitus vaikuttaa huomattavasti työkierron koneistusalueeseen ja siten koneistusaikaan. Rouhinnassa työkierron alkupiste on työkalun asema työkierron kutsuhetkellä. Ohjaus laskee koneistettavan alueen alkupisteestä ja työkierrossa määritellystä loppupisteestä tai muodosta. Jos alkupiste on tällä alueella, jotkin työkierrot siirtävät työkalun ensin varmuusetäisyydelle.
note-finishing-approach-from-envelope = Työkalun ja työkappaleen vaurioitumisvaara! Silityksessä työkierto siirtää työkalun alkupisteeseen automaattisesti. Lähestyminen riippuu työkalun asemasta työkierron kutsuhetkellä: verhokäyrän sisä- vai ulkopuolella. Verhokäyrä on ohjelmoitu muoto varmuusetäisyydellä { $q-turning-clearance } suurennettuna. Jos työkalu on verhokäyrän sisäpuolella, se ajaa määritellyllä syöttöarvolla suoraan aloitusasemaan, mikä voi vaurioittaa muotoa: paikoita työkalu niin, että se pääsee aloitusasemaan muotoa vaurioittamatta. Jos työkalu on verhokäyrän ulkopuolella, se ajaa pikaliikkeellä verhokäyrälle ja sen sisäpuolella ohjelmoidulla syöttöarvolla.
note-cutting-geometry-considered = Ohjaus ottaa huomioon työkalun terägeometrian ({ $mp-tool-orientation }, { $mp-cutting-edge-radius }, { $mp-point-angle }, { $mp-tool-angle }), jotta määritellyt muotoelementit eivät vaurioituisi. Jos muotoa ei voida koneistaa kokonaan aktiivisella työkalulla, ohjaus antaa varoituksen.
note-feed-rates-with-m136 = Jos M136 on ohjelmoitu ennen työkiertoa, ohjaus tulkitsee työkierron syöttöarvot yksikössä mm/kierros, ilman M136-koodia yksikössä mm/min.
note-inclined-turning = Jos työkierto suoritetaan kallistetussa koneistuksessa (M144), työkalun kulmat muotoon nähden muuttuvat. Ohjaus ottaa tämän muutoksen automaattisesti huomioon ja valvoo siten muotovaurioita myös kallistetussa koneistuksessa.
note-blank-form-update = Aihion seurannassa (FUNCTION TURNDATA BLANK) ohjaus tunnistaa jo koneistetut alueet ja sovittaa kaikki lähestymis- ja poistumisradat kuhunkin työvaiheeseen. Toiminto on käytettävissä vain sorvauskäytön koneistustyökierrossa; aihion on oltava suljettu muoto (alkuasema = loppuasema), ja se on pyörähdyssymmetrisen kappaleen poikkileikkaus.
note-finished-part-beyond-blank = Aihion seurannassa ohjaus sovittaa lähestymisen ja vetäytymisen päivitettyyn aihioon. Jos valmisosan alueita ulottuu aihion ulkopuolelle, työkappale ja työkalu voivat vaurioitua.
step-rapid-axial-infeed = Ohjaus tekee pikaliikkeellä koordinaattiakselin suuntaisen asetusliikkeen aksiaalisuunnassa. Asetusliikkeen suuruuden se laskee suurimmasta lastuamissyvyydestä { $q-max-axial-cutting-depth }.
step-cut-across-axis = Ohjaus koneistaa aloitusaseman ja loppupisteen välisen alueen tasosuunnassa syöttöarvolla { $q-turning-roughing-feed }.
step-cut-contour-longitudinally = Ohjaus koneistaa aloitusaseman ja loppupisteen välisen alueen pitkittäissuunnassa. Pitkittäislastu ajetaan koordinaattiakselin suuntaisesti syöttöarvolla { $q-turning-roughing-feed }.
step-cut-contour-across-axis = Ohjaus koneistaa aloitusaseman ja loppupisteen välisen alueen tasosuunnassa. Tasolastu ajetaan koordinaattiakselin suuntaisesti syöttöarvolla { $q-turning-roughing-feed }.
step-cut-parallel-to-contour = Ohjaus koneistaa aloitusaseman ja loppupisteen välisen alueen. Lastu ajetaan muodon suuntaisesti syöttöarvolla { $q-turning-roughing-feed }.
step-retract-to-starting-position-in-x = Ohjaus vetää työkalun määritellyllä syöttöarvolla X-aloitusasemaan.
step-clear-area-in-x-then-z = Jos alkupiste (työkalun asema työkierron kutsuhetkellä) on koneistettavalla alueella, ohjaus paikoittaa työkalun ensin X- ja sitten Z-suunnassa varmuusetäisyydelle { $q-turning-clearance } ja aloittaa työkierron sieltä.
step-clear-area-in-z-then-x = Jos alkupiste (työkalun asema työkierron kutsuhetkellä) on koneistettavalla alueella, ohjaus paikoittaa työkalun ensin Z- ja sitten X-suunnassa varmuusetäisyydelle { $q-turning-clearance } ja aloittaa työkierron sieltä.
step-clear-area-in-z = Jos alkupiste on koneistettavalla alueella, ohjaus paikoittaa työkalun ensin Z-suunnassa varmuusetäisyydelle { $q-turning-clearance }.
step-clear-plunging-start-in-z = Jos alkupisteen (työkalun aseman työkierron kutsuhetkellä) Z-koordinaatti on pienempi kuin muodon alku { $q-plunging-start-z }, ohjaus paikoittaa työkalun Z-suunnassa varmuusetäisyydelle { $q-turning-clearance } ja aloittaa työkierron sieltä.
step-clear-contour-start-in-z = Jos alkupisteen (työkalun aseman työkierron kutsuhetkellä) Z-koordinaatti on pienempi kuin muodon alkupisteen, ohjaus paikoittaa työkalun Z-suunnassa varmuusetäisyydelle { $q-turning-clearance } ja aloittaa työkierron sieltä.
step-clear-contour-start-before-finishing = { step-clear-contour-start-in-z }
step-position-at-contour-start-in-z = Jos alkupisteen (työkalun aseman työkierron kutsuhetkellä) Z-koordinaatti on pienempi kuin muodon alkupisteen, ohjaus paikoittaa työkalun Z-suunnassa muodon alkupisteeseen ja aloittaa työkierron sieltä.
step-rapid-infeed = Ohjaus tekee asetusliikkeen pikaliikkeellä.
step-finish-turned-contour-to-end = Ohjaus silittää valmisosan muodon alkupisteestä loppupisteeseen syöttöarvolla { $q-turning-finishing-feed }.
condition-start-element-added = muodon alkuun lisätään elementti ({ $q-start-element-type })
condition-end-element-added = muodon loppuun lisätään elementti ({ $q-end-element-type })
condition-undercuts-machined = sisäänpistoelementit saa koneistaa ({ $q-undercut-machining })
note-area-from-starting-point-to-end-point = Rouhinnassa työkierto koneistaa alueen työkierron alkupisteestä työkierrossa määriteltyyn loppupisteeseen.
note-infeed-within-undercut = Takaleikkauksen sisällä ohjaus tekee asetusliikkeet syöttöarvolla { $q-turning-roughing-feed }. Jokainen vetäytyminen siellä on varmuusetäisyyden { $q-turning-clearance } suuruinen.
note-contour-direction-decides = Muodon ohjelmoitu suunta määrää koneistussuunnan.
title-shoulder-with-recess = Olake, jossa on pistoura

# --- 811 ---
cycle-turn-shoulder-longitudinal = Olakkeen pitkittäissorvaus
    .nc = OLAKE, PITKITTÄIN
    .purpose = Työkierto sorvaa suorakulmaisia olakkeita pitkittäissuunnassa ulko- tai sisäpuolelta: rouhinta, silitys tai molemmat. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti.

# --- 812 ---
cycle-turn-shoulder-longitudinal-extended = Olakkeen laajennettu pitkittäissorvaus
    .nc = OLAKE, PITKITT. LAAJ.
    .purpose = Työkierto sorvaa olakkeita pitkittäissuunnassa ulko- tai sisäpuolelta: rouhinta, silitys tai molemmat. Muodon alkuun ja loppuun voidaan lisätä viiste tai pyöristys, taso- ja kehäpinnalle voidaan määritellä kulmat, ja muodon nurkassa voi olla säde. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti.

# --- 813 ---
cycle-turn-plunge-longitudinal = Pitkittäissorvaus sisäänpistolla
    .nc = PITKITTÄIN, SISÄÄNPISTO
    .purpose = Työkierto sorvaa olakkeita, joissa on sisäänpistoelementtejä (takaleikkauksia), pitkittäissuunnassa ulko- tai sisäpuolelta: rouhinta, silitys tai molemmat. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti.

# --- 814 ---
cycle-turn-plunge-longitudinal-extended = Laajennettu pitkittäissorvaus sisäänpistolla
    .nc = PITKITT., SISÄÄNPISTO LAAJ.
    .purpose = Työkierto sorvaa olakkeita, joissa on sisäänpistoelementtejä (takaleikkauksia), pitkittäissuunnassa ulko- tai sisäpuolelta: rouhinta, silitys tai molemmat. Muodon alkuun ja loppuun voidaan lisätä viiste tai pyöristys, ja tasopinnan kulma ja muodon nurkan säde voidaan määritellä. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti.

# --- 810 ---
cycle-turn-contour-longitudinal = Muodon pitkittäissorvaus
    .nc = MUOTO, PITKITTÄIN
    .purpose = Työkierto sorvaa työkappaleita, joiden sorvausmuoto on vapaa ja kuvattu aliohjelmassa, pitkittäissuunnassa ulko- tai sisäpuolelta: rouhinta, silitys tai molemmat. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti.

# --- 815 ---
cycle-turn-contour-parallel = Muodon suuntainen sorvaus
    .nc = MUODON SUUNTAINEN
    .purpose = Työkierto sorvaa työkappaleita, joiden sorvausmuoto on vapaa ja kuvattu aliohjelmassa, ulko- tai sisäpuolelta: rouhinta, silitys tai molemmat. Rouhintalastut ajetaan muodon suuntaisesti.

# --- 821 ---
cycle-turn-shoulder-face = Olakkeen tasosorvaus
    .nc = OLAKE, TASO
    .purpose = Työkierto tasosorvaa suorakulmaisia olakkeita ulko- tai sisäpuolelta: rouhinta, silitys tai molemmat. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti.

# --- 822 ---
cycle-turn-shoulder-face-extended = Olakkeen laajennettu tasosorvaus
    .nc = OLAKE, TASO LAAJ.
    .purpose = Työkierto tasosorvaa olakkeita ulko- tai sisäpuolelta: rouhinta, silitys tai molemmat. Muodon alkuun ja loppuun voidaan lisätä viiste tai pyöristys, taso- ja kehäpinnalle voidaan määritellä kulmat, ja muodon nurkassa voi olla säde. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti.

# --- 823 ---
cycle-turn-plunge-face = Tasosorvaus sisäänpistolla
    .nc = TASO, SISÄÄNPISTO
    .purpose = Työkierto tasosorvaa sisäänpistoelementtejä (takaleikkauksia) ulko- tai sisäpuolelta: rouhinta, silitys tai molemmat. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti.

# --- 824 ---
cycle-turn-plunge-face-extended = Laajennettu tasosorvaus sisäänpistolla
    .nc = TASO, SISÄÄNPISTO LAAJ.
    .purpose = Työkierto tasosorvaa sisäänpistoelementtejä (takaleikkauksia) ulko- tai sisäpuolelta: rouhinta, silitys tai molemmat. Muodon alkuun ja loppuun voidaan lisätä viiste tai pyöristys, ja tasopinnan kulma ja muodon nurkan säde voidaan määritellä. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti.

# --- 820 ---
cycle-turn-contour-face = Muodon tasosorvaus
    .nc = MUOTO, TASO
    .purpose = Työkierto tasosorvaa työkappaleita, joiden sorvausmuoto on vapaa ja kuvattu aliohjelmassa, ulko- tai sisäpuolelta: rouhinta, silitys tai molemmat. Rouhintalastut ajetaan koordinaattiakselin suuntaisesti.

# --- 800 ---
cycle-adapt-turning-system = Kiertokoordinaatiston sovitus
    .nc = KIERTOKOORDINAATISTON SOVITUS
    .purpose = Työkierto suuntaa työkappaleen koordinaatiston sorvausta varten ja asettaa työkalun terän oikeaan suuntaan. Se voi myös peilata työkalun, jolloin sitä voidaan käyttää sekä sisä- että ulkopuoliseen koneistukseen.
step-align-turning-system = Ohjaus suuntaa työkappaleen koordinaatiston prekessiokulmaan { $q-precession-angle } ja kääntää työkalun terän vastaavasti: ulkopuolisessa koneistuksessa pyöröpöydän keskipisteeseen, sisäpuolisessa koneistuksessa vastakkaiseen suuntaan.
step-reverse-turning-tool = Parametrilla { $q-tool-reversal } työkalun koordinaatisto voidaan peilata: silloin ohjaus kääntää karaa 180° ja peilaa työkalun suuntauksen { $mp-tool-orientation }. Näin samaa työkalua voidaan käyttää sekä sisä- että ulkopuoliseen koneistukseen.
note-before-turning = Aja työkalu ennen sorvausta oikeaan asemaan ja suuntaa sen terä.
note-position-over-turning-spindle = Ohjelmoi työkalun sopivaan asemaan ajamista varten paikoituslause sorvauskaran keskipisteeseen, esimerkiksi L Y+0 R0 FMAX.
note-purpose-of-precession-angle = Prekessiokulma { $q-precession-angle } määrää, missä kohdassa kehää työkappaletta koneistetaan. Se voi olla tarpeen, jos työkalu on tilan puutteen takia ajettava tiettyyn koneistusasemaan; koneistusasemaa voidaan kääntää myös niin, että koneistusta on helpompi seurata.
note-precession-in-inclined-turning = Käytä kallistetussa sorvauksessa prekessiokulmaa { $q-precession-angle } terän ja koordinaatiston asettamiseksi sopivaan asentoon.
note-turning-system-until-tool-call = Työkierto on voimassa määrittelystään seuraavaan työkalukutsuun asti.
note-turning-tool-clamped-and-measured = Työkalun on oltava kiinnitetty oikeaan asentoon ja mitattu.
note-turning-tool-selected = Työkiertoa voidaan käyttää vain, jos sorvaustyökalu on valittu.
note-check-tool-orientation = Tarkasta työkalun suuntaus ennen koneistusta.
note-own-functions-for-tool-alignment = Koneen valmistaja voi tarjota omia toimintoja työkalun suuntaamiseen. Katso koneen käyttöohjekirjaa.
note-cycle-depends-on-machine = Työkierto { $cycle } on konekohtainen. Katso koneen käyttöohjekirjaa.

# --- 801 ---
cycle-reset-turning-system = Kiertokoordinaatiston peruutus
    .nc = KIERTOKOORDINAATISTON PERUUTUS
    .purpose = Työkierto peruuttaa työkierrolla 800 tehdyt asetukset.
step-reset-turning-system = Ohjaus peruuttaa kaikki työkierrolla 800 ohjelmoidut asetukset: prekessiokulman Q497 ja työkalun käännön Q498.
note-tool-stays-oriented = Työkalua ei palauteta alkuperäiseen asentoonsa. Jos työkierto 800 on suunnannut sen, se jää tähän asentoon peruutuksen jälkeen.
note-cycle-without-parameters = Työkierrolla ei ole työkiertoparametreja. Päätä sen sisäänsyöttö näppäimellä END.
message-turning-contour-left = Työkalu ei voi koneistaa muotoa kokonaan: sen teräpala ei ulotu kaikkialle.
