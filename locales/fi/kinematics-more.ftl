# Työkierrot, jotka tallentavat kinematiikan ja kompensoivat esiasetuksen.

# --- 450 ---
cycle-save-kinematics = Kinematiikan tallennus
    .nc = KINEMATIIKAN TALLENNUS
    .purpose = Työkierto tallentaa koneen aktiivisen kinematiikan tai palauttaa aiemmin tallennetun kinematiikan. Tallennetut tiedot voidaan näyttää ja poistaa.
cycle-save-kinematics__itnc530 =
    .purpose = Työkierto tallentaa koneen aktiivisen kinematiikan, palauttaa aiemmin tallennetun kinematiikan tai esittää muistin nykyisen tilan näytöllä ja pöytäkirjassa.
condition-memory-location-used = { $q-kinematics-memory-mode } ei ole 2
step-treat-saved-kinematics = Ohjaus käsittelee kinematiikan tilan { $q-kinematics-memory-mode } mukaan:
say-save-active-kinematics = 0: se tallentaa aktiivisen kinematiikan parametrin { $q-kinematics-memory-location } osoittamaan paikkaan
say-restore-saved-kinematics = 1: se palauttaa parametrin { $q-kinematics-memory-location } osoittamaan paikkaan tallennetun kinematiikan
say-show-saved-kinematics = 2: se näyttää muistin nykyisen tilan
say-delete-saved-kinematics = 3: se poistaa tietueet, jotka { $q-kinematics-memory-location } nimeää
note-save-before-optimization = Tallenna aktiivinen kinematiikka aina ennen kinematiikan optimointia.
note-kinematics-memory-size = Käytettävissä on 16 muistipaikkaa.
note-kinematics-memory-size__itnc530 = Käytettävissä on 10 muistipaikkaa, joiden numerot ovat 0–9.
note-restore-only-into-identical-kinematics = Palautustilassa ohjaus voi kirjoittaa tallennetut tiedot takaisin vain identtiseen kinematiikkakuvaukseen.
note-preset-changes-with-kinematics__save-kinematics = Kinematiikan muutos, siis myös sen palautus, muuttaa aina myös esiasetusta. Aseta esiasetus tarvittaessa uudelleen.
note-kinematics-memory-wildcards = Jos useat tietueet vastaavat parametrin { $q-kinematics-memory-location } korvausmerkkejä, ohjaus palauttaa niiden tietojen keskiarvot (tila 1) tai poistaa vahvistuksen jälkeen ne kaikki (tila 3).
note-kinematics-memory-file = Ohjaus tallentaa tiedot tiedostoon TNC:\table\DATA450.KD. Tiedosto voidaan varmuuskopioida ulkoiseen tietokoneeseen, esimerkiksi ohjelmalla TNCremo, jotta se voidaan palauttaa kiintolevyn vikaannuttua. Jos tiedosto poistetaan, tallennetut tiedot menetetään. Jos sitä ei ole, ohjaus luo sen, kun työkierto 450 suoritetaan.
note-kinematics-memory-file-by-hand = Älä muuta tiedostoon TNC:\table\DATA450.KD tallennettuja tietoja käsin: tietueet voivat vioittua ja muuttua käyttökelvottomiksi.
note-kinematics-memory-code-number = Tallennustilassa ohjaus tallentaa aina myös MOD-toiminnossa viimeksi annetun avainluvun; avainluku on vapaasti määriteltävissä. Sen jälkeen muistipaikka voidaan korvata vain antamalla tämä avainluku.
note-overwritten-without-question = Jos kinematiikka on tallennettu ilman avainlukua, ohjaus korvaa sen muistipaikan seuraavassa tallennuksessa kysymättä.
note-kinematics-memory-log-contents = Työkierron 450 jälkeen ohjaus laatii pöytäkirjan (TCHPR450.TXT). Se sisältää päiväyksen ja kellonajan, NC-ohjelman polun, tilan (0=tallennus/1=palautus/2=muistin tila/3=poisto), aktiivisen kinematiikan tunnuksen ja annetun tietueen tunnuksen. Tila 0 lisää siihen tallennetun kinematiikkaketjun kaikki akseli- ja muunnostiedot, tila 1 kaikki muunnostiedot ennen palautusta ja sen jälkeen, tila 2 luettelon tallennetuista tietueista, tila 3 luettelon poistetuista tietueista.
note-kinematics-memory-log-contents__itnc530 = Työkierron 450 jälkeen ohjaus laatii pöytäkirjan (TCHPR450.TXT). Se sisältää päiväyksen ja kellonajan, NC-ohjelman polun, tilan (0=tallennus/1=palautus/2=muistin tila), muistipaikan numeron (0–9), kinematiikan rivinumeron kinematiikkataulukossa sekä avainluvun, jos se on annettu juuri ennen työkiertoa 450. Tila 0 lisää siihen tallennetun kinematiikkaketjun kaikki akseli- ja muunnostiedot, tila 1 kaikki muunnostiedot ennen palautusta ja sen jälkeen, tila 2 luettelon muistin nykyisestä tilasta näytöllä ja pöytäkirjassa: muistipaikka, avainluvut, kinematiikan numero ja tallennuspäivä.
title-save-active-kinematics = Aktiivisen kinematiikan tallennus
title-restore-saved-kinematics = Tietueiden palautus
title-show-saved-kinematics = Kaikkien tallennettujen tietueiden näyttö
title-delete-saved-kinematics = Tietueiden poisto
title-save-before-calibration = Kinematiikan tallennus ennen kalibrointiohjelmaa
table-kinematics-memory = Tallennetut kinematiikat

# --- 452 ---
cycle-preset-compensation = Esiasetuksen kompensointi
    .nc = ESIASETUKSEN KOMPENSOINTI
    .purpose = Työkierto optimoi koneen kinemaattisen muunnosketjun. Sen jälkeen ohjaus korjaa kinematiikkamallissa myös työkappaleen koordinaatiston, niin että esiasetus on optimoinnin jälkeen kalibrointikuulan keskipisteessä. Näin voidaan sovittaa vaihtopäät toisiinsa tai kompensoida koneen ryömintä.
group-match-interchangeable-heads = Vaihtopäiden sovitus
group-compensate-drift = Ryöminnän kompensointi, jos kalibrointikuula voi olla koneen pöydällä koneistuksen aikana
group-measure-and-compensate = Mittaus ja kompensointi
step-clamp-calibration-sphere = Kiinnitä kalibrointikuula.
step-measure-reference-head = Mittaa referenssipää kokonaan työkierrolla 451 ja anna työkierron 451 asettaa esiasetus kuulan keskipisteeseen.
step-insert-second-head = Aseta toinen pää koneeseen.
step-measure-second-head = Mittaa vaihtopää työkierrolla { $cycle } päänvaihdon liitäntään asti.
step-match-further-heads = Sovita muut vaihtopäät referenssipäähän työkierrolla { $cycle }.
step-set-preset-in-sphere = Aseta esiasetus kalibrointikuulaan.
step-set-preset-on-workpiece = Aseta esiasetus työkappaleeseen ja aloita koneistus.
step-compensate-at-intervals = Kompensoi esiasetus säännöllisin väliajoin työkierrolla { $cycle }: ohjaus määrittää kyseisten akselien ryöminnän ja korjaa sen kinematiikassa.
step-optimize-transformation-chain = Ohjaus optimoi koneen kinemaattisen muunnosketjun.
step-correct-workpiece-system = Ohjaus korjaa kinematiikkamallissa työkappaleen koordinaatiston niin, että esiasetus on kalibrointikuulan keskipisteessä.
note-datum-in-sphere-first__preset-compensation = Aseta ja aktivoi peruspiste kalibrointikuulan keskipisteeseen ennen työkierron määrittelyä.
note-one-degree-before-limit-switch = Valitse mittauspisteet akseleilla, joilla ei ole erillistä paikoitusmittalaitetta, niin, että rajakytkimelle jää 1°:n liikematka. Ohjaus tarvitsee tämän matkan välyksen sisäiseen kompensointiin.
note-kinematics-limit-exceeded__preset-compensation = Jos kinematiikkatiedot ylittävät sallitun raja-arvon ({ $mp-max-modification }), ohjaus antaa varoituksen. Vahvista arvot NC-käynnistyksellä.
note-match-heads-purpose = Vaihtopäiden sovituksen ansiosta työkappaleen esiasetus ei muutu, kun kiertoakseleita (päitä) vaihdetaan. Aseta yksi päistä koneeseen referenssipääksi, kiinnitä kalibrointikuula, vaihda kosketusjärjestelmä karaan, mittaa koko kinematiikka työkierrolla 451 ja anna sen asettaa esiasetus mittauksen jälkeen (Q431 = 2 tai 3). Aseta sitten seuraava pää ja kosketusjärjestelmä paikoilleen ja mittaa se työkierrolla { $cycle }. Kaikki muut päät voidaan sovittaa samalla tavalla.
note-match-heads-only-changed-axes = Mittaa vain ne akselit, jotka on todella vaihdettu. Esimerkki: haarukkapää, jossa on akselit A ja C ja josta vaihdetaan vain A-akseli; C-akseli jätetään pois asetuksella { $q-rotary-measuring-points-c } = 0.
note-preset-and-sphere-stay = Esiasetusta ja kalibrointikuulan paikkaa ei saa muuttaa koko toimenpiteen aikana.
note-drift-purpose = Koneistuksen aikana koneen osat ryömivät ympäristön vaihtelevien vaikutusten takia. Jos ryömintä on liikealueella riittävän tasaista ja kalibrointikuula voi olla koneen pöydällä koneistuksen aikana, työkierto { $cycle } määrittää ja kompensoi sen. Kiinnitä kalibrointikuula, vaihda kosketusjärjestelmä karaan, mittaa koko kinematiikka työkierrolla 451 ennen koneistuksen alkua ja anna sen asettaa esiasetus mittauksen jälkeen (Q431 = 2 tai 3); aseta sitten työkappaleiden esiasetukset ja aloita koneistus. Vaihda kosketusjärjestelmä karaan säännöllisin väliajoin, aktivoi kalibrointikuulan esiasetus ja mittaa kinematiikka työkierrolla { $cycle }.
note-drift-without-rotary-axes = Ryömintä voidaan kompensoida myös koneissa, joissa ei ole kiertoakseleita.
note-kinematics-prepared-for-preset = Kinematiikan on oltava valmisteltu esiasetuksen kompensointia varten. Katso koneen käyttöohjekirjaa.
note-head-change-is-machine-function = Pään vaihto on koneen toiminto. Katso koneen käyttöohjekirjaa.
note-kinematics-log-contents__preset-compensation = Pöytäkirja sisältää päiväyksen ja kellonajan, NC-ohjelman polun, aktiivisen kinematiikan numeron ja annetun kuulan säteen; jokaisesta mitatusta kiertoakselista: aloituskulman, lopetuskulman, asetuskulman, mittauspisteiden lukumäärän, hajonnan (keskihajonnan), suurimman virheen, kulmavirheen, keskimääräisen välyksen, keskimääräisen paikoitusvirheen, mittausympyrän säteen, kaikkien akselien korjausarvot (esiasetuksen siirtymän) ja kiertoakselien mittausepävarmuuden.
note-kinematics-log-contents__preset-compensation__itnc530 = Pöytäkirja sisältää päiväyksen ja kellonajan, NC-ohjelman polun, aktiivisen kinematiikan numeron ja annetun kuulan säteen; jokaisesta mitatusta kiertoakselista: aloituskulman, lopetuskulman, asetuskulman, mittauspisteiden lukumäärän, hajonnan (keskihajonnan), suurimman virheen, kulmavirheen, keskimääräisen välyksen, keskimääräisen paikoitusvirheen, mittausympyrän säteen, kaikkien akselien korjausarvot (esiasetuksen siirtymän), mittauspisteiden arvioinnin ja kiertoakselien mittausepävarmuuden.
note-kinematics-log-explained__preset-compensation = Mitattu hajonta: 68,3{"\u00A0"}% mitatuista tilavirheistä on tämän arvon sisällä (±); optimoitu: 68,3{"\u00A0"}% korjauksen jälkeen odotettavista virheistä. Mittauspisteiden arviointi osoittaa, kuinka hyvät mittausasemat ovat mallin muutettavissa olevien muunnosten kannalta: mitä suurempi se on, sitä parempi on optimointi. Sen ei pitäisi olla millään kiertoakselilla alle 2, mieluummin 4 tai enemmän; jos se on pieni, suurenna akselin mittausaluetta tai pisteiden lukumäärää. Jos se ei auta, kinematiikkakuvaus voi olla väärä; ota tarvittaessa yhteys asiakaspalveluun.
title-compensate-preset = Kalibrointiohjelma
title-match-interchangeable-head = Vaihtopään sovitus
title-compensate-drift = Ryöminnän kompensointi

# --- kinematics ---
message-backlash-angle-too-small = Mitattu välys ei ole paljon pienempi kuin parametrin { $q-backlash-angle } kulma: välys voi olla mitattua suurempi. Anna suurempi kulma ja mittaa uudelleen.
message-kinematics-limit-exceeded = Kinematiikkatiedot muuttuvat enemmän kuin raja-arvo sallii. Vahvista ne NC-käynnistyksellä.
message-delete-saved-kinematics = Useampi tallennettu kinematiikka vastaa nimeä. Vahvista, että ne kaikki poistetaan.
