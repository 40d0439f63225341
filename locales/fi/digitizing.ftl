# Työkierrot, jotka digitoivat kappaleen kosketusjärjestelmällä.

# --- 5 ja 15 ---
cycle-digitize-range = Digitointialue
    .nc = ALUE
    .purpose = Työkierto määrittelee suorakulmaisen särmiön muotoisen alueen, jolta digitointityökierrot mittaavat kappaleen, digitointitietojen tiedoston ja varmuuskorkeuden.
cycle-digitize-range-from-points = Digitointialue pistetaulukosta
    .nc = ALUE
    .purpose = Työkierto määrittelee digitointiin mittaavalla kosketusjärjestelmällä alueen, jonka muoto on vapaa: pistetaulukko ilmoittaa alueen rajan koneistustasossa. Työkierto määrittelee myös digitointitietojen tiedoston ja varmuuskorkeuden.
step-remember-digitizing-range = Ohjaus tallentaa MIN-pisteen ja MAX-pisteen välisen alueen, varmuuskorkeuden ja tiedoston nimen seuraavia digitointityökiertoja varten.
step-remember-digitizing-range-from-points = Ohjaus tallentaa seuraavia digitointityökiertoja varten alueen, jonka rajan koneistustasossa ilmoittavat taulukon pisteet ja kosketusakselilla MIN- ja MAX-piste, sekä varmuuskorkeuden ja tiedoston nimen.
table-digitizing-points = Digitoinnin pistetaulukko
title-range-with-rotary-axis-a = Alue kiertoakselilla A työkiertoa 18 varten
title-range-for-meander-with-rotary-axis = Alue kiertoakselilla A työkiertoa 6 varten
title-range-with-rotary-axis-c = Alue kiertoakselilla C työkiertoa 7 varten

# --- 6 ja 16 ---
cycle-digitize-meander = Meanderi
    .nc = MEANDERI
    .purpose = Työkierto digitoi 3D-muodon meanderimaisesti kytkevällä kosketusjärjestelmällä.
cycle-digitize-meander-analog = Meanderi (mittaava kosketusjärjestelmä)
    .nc = MEANDERI
    .purpose = Työkierto digitoi 3D-muodon meanderimaisesti mittaavalla kosketusjärjestelmällä.
step-approach-digitizing-start = Ohjaus ajaa automaattisesti alkupisteeseen, ensin työkaluakselin suunnassa varmuuskorkeudelle, sitten koneistustasossa työkierron 5 tai työkierron 15 alueen MIN-pisteeseen.
step-approach-workpiece-downwards = Kosketusjärjestelmä siirtyy kappaletta kohti työkaluakselin negatiiviseen suuntaan. Ohjaus tallentaa sen aseman koordinaatit, jossa kosketusjärjestelmä koskettaa kappaletta.
step-scan-meander = MIN-pisteestä alkaen kosketusjärjestelmä kulkee kappaletta pitkin riviakselin positiiviseen suuntaan alueen rajalle, siirtyy rivivälin verran ja palaa seuraavaa riviä pitkin; toisessa päässä se siirtyy taas rivivälin verran. Tämä toistetaan, kunnes koko alue on digitoitu.
step-return-to-clearance-after-digitizing = Lopuksi kosketusjärjestelmä palaa varmuuskorkeudelle.
title-meander-with-rotary-axis = Meanderi, kiertoakseli rivien suuntana

# --- 7 ja 17 ---
cycle-digitize-contour-lines = Korkeuskäyrät
    .nc = KORKEUSKÄYRÄT
    .purpose = Työkierto digitoi 3D-muodon taso kerrallaan korkeuskäyrinä kytkevällä kosketusjärjestelmällä.
cycle-digitize-contour-lines-analog = Korkeuskäyrät (mittaava kosketusjärjestelmä)
    .nc = KORKEUSKÄYRÄT
    .purpose = Työkierto digitoi 3D-muodon taso kerrallaan korkeuskäyrinä mittaavalla kosketusjärjestelmällä.
step-approach-contour-line-start = Ohjaus ajaa automaattisesti alkupisteeseen, ensin työkaluakselin suunnassa varmuuskorkeudelle, sitten koneistustasossa työkierrossa määriteltyihin koordinaatteihin. Alkupisteen koordinaatti työkaluakselilla on positiivisella rivivälillä työkierron 5 MIN-pisteen, negatiivisella MAX-pisteen koordinaatti.
step-approach-workpiece-in-direction = Kosketusjärjestelmä siirtyy kappaletta kohti ohjelmoidussa lähestymissuunnassa. Ohjaus tallentaa sen aseman koordinaatit, jossa kosketusjärjestelmä koskettaa kappaletta.
step-scan-contour-line = Kun ensimmäinen piste on tallennettu, kosketusjärjestelmä kulkee vakiokorkeudella kappaleen ympäri, kunnes se saavuttaa taas ensimmäisen pisteen.
step-go-on-by-line-spacing = Sitten se siirtyy rivivälin verran työkaluakselin positiiviseen tai negatiiviseen suuntaan ja kulkee taas vakiokorkeudella kappaleen ympäri tällä korkeudella tallennettuun ensimmäiseen pisteeseen asti. Tämä toistetaan, kunnes koko alue on digitoitu.
step-return-to-contour-line-start = Lopuksi kosketusjärjestelmä siirtyy varmuuskorkeudelle ja palaa ohjelmoituun alkupisteeseen.

# --- 8 ja 18 ---
cycle-digitize-lines = Rivi
    .nc = RIVI
    .purpose = Työkierto digitoi 3D-muodon rivi kerrallaan kytkevällä kosketusjärjestelmällä.
cycle-digitize-lines-analog = Rivi (mittaava kosketusjärjestelmä)
    .nc = RIVI
    .purpose = Työkierto digitoi 3D-muodon rivi kerrallaan mittaavalla kosketusjärjestelmällä.
step-approach-line-start = Ohjaus ajaa automaattisesti alkupisteeseen, ensin työkaluakselin suunnassa varmuuskorkeudelle, sitten koneistustasossa. Alkupiste on alueen positiivisella tai negatiivisella rajalla rivien ohjelmoidussa suunnassa (riippuu digitointisuunnasta), ja muuten sillä on työkierron 5 tai työkierron 15 alueen MIN-pisteen koordinaatit.
step-scan-line = Kosketusjärjestelmä kulkee kappaletta pitkin koneistustason valitun akselin positiiviseen suuntaan alueen rajalle.
step-return-for-next-line = Sitten se siirtyy varmuuskorkeudelle ja palaa pikaliikkeellä seuraavan rivin alkuun. Siellä se ajaa pikaliikkeellä työkaluakselin negatiiviseen suuntaan syöttöarvon pienennyksen korkeudelle ja siitä kosketussyöttöarvolla, kunnes se koskettaa kappaletta. Tämä toistetaan, kunnes koko alue on digitoitu.
title-lines-with-rotary-axis = Rivi kiertoakselilla, ilman ensimmäisen rivin syöttöarvoa

# --- tarkastukset ---
guard-digitizing-with-transformation = Koordinaattimuunnos on voimassa. Mikään muunnos ei saa olla voimassa digitoinnin aikana.

# --- ohjeet: ohjelmointi ---
note-range-before-digitizing = Määrittele koneistusohjelmassa digitointityökierto ALUE (5 tai 15) ennen digitoivaa työkiertoa.
note-range-before-contour-lines = Määrittele koneistusohjelmassa digitointityökierto 5 ALUE ennen digitointityökiertoa KORKEUSKÄYRÄT.
note-not-with-contour-lines = Työkiertoa { $cycle } ei voi yhdistää digitointityökiertoon 17 KORKEUSKÄYRÄT.
note-not-with-range-from-points = Työkiertoa { $cycle } ei voi yhdistää digitointityökiertoon 15 ALUE.
note-no-transformation-while-digitizing = Mikään koordinaattimuunnos tai peruskääntö ei saa olla voimassa digitoinnin aikana.
note-analog-probe-only = Työkiertoa voidaan käyttää vain mittaavalla kosketusjärjestelmällä.
note-complete-path-of-data = Anna tiedonsiirtoliitännän valikossa koko polku, johon ohjaus tallentaa digitointitiedot.
note-digitizing-not-in-iso = Digitointityökierrot eivät ole käytettävissä DIN/ISO-muodossa.

# --- ohjeet: mitä tarvitaan ---
note-digitizing-needs-option = Digitointi vaatii kosketusjärjestelmän, ohjelmistomoduulin Digitointioptio ja tarvittaessa HEIDENHAINin analysointiohjelmiston SUSA työkierron MEANDERI digitointitietojen jatkokäsittelyyn.
note-calibrate-before-digitizing = Kalibroi kosketusjärjestelmä ennen digitointia.
note-digitizing-axes = Digitointityökierrot ohjelmoidaan pääakseleilla X, Y ja Z sekä kiertoakseleilla A, B ja C.
note-digitizing-speed-touch-trigger = Kytkevällä kosketusjärjestelmällä digitointinopeus on 200–800{"\u00A0"}mm/min, kun pisteväli on 1{"\u00A0"}mm.
note-digitizing-speed-analog = Mittaavalla kosketusjärjestelmällä digitointinopeus määritellään työkierrossa, enintään 3000{"\u00A0"}mm/min.

# --- ohjeet: miten digitoidaan ---
note-meander-for-flat-parts = Meanderimainen digitointi soveltuu ennen kaikkea verrattain tasaisille kappaleille.
note-meander-for-evaluation-software = Digitoi meanderimaisesti, jos digitointitiedot käsitellään HEIDENHAINin analysointiohjelmistolla SUSA.
note-contour-lines-for-steep-parts = Digitointi korkeuskäyrinä soveltuu erityisesti epäsäännöllisille kappaleille (esimerkiksi ruiskuvalumuoteille) tai yksittäisen korkeuskäyrän tallennukseen (esimerkiksi nokkalevyn ääriviivan).
note-range-for-contour-lines = Kosketusakselilla alueen on oltava vähintään kosketusjärjestelmän säteen verran kappaleen korkeinta kohtaa alempana. Koneistustasossa alueen on oltava vähintään kosketusjärjestelmän säteen verran kappaletta suurempi.
note-single-contour-line = Kun digitoidaan yksittäinen korkeuskäyrä, anna riviväliksi ja, jos työkierto kysyy sitä, pienimmäksi riviväliksi 0.
note-lines-for-one-milling-direction = Tätä työkiertoa käytetään ennen kaikkea verrattain tasaisiin kappaleisiin, joiden digitointitiedot jyrsitään kauttaaltaan myötä- tai vastalastulla ilman analysointiohjelmistoa.
note-lines-for-rotary-axes = Mittaavalla kosketusjärjestelmällä tätä työkiertoa käytetään ennen kaikkea digitointiin kiertoakselin avulla.
note-normal-retraction-recommended = Suositeltava liike rivien normaalin suunnassa on vähintään puolet pistevälistä ja enintään pistevälin suuruinen. Mitä pienempi kosketuskuula on, sitä suurempi liikkeen tulisi olla.
note-climb-or-up-cut-by-direction = Digitointisuunta määrää myös, jyrsitäänkö myöhemmin myötälastulla vai vastalastulla.
note-sudden-changes-of-direction = Ohjaus tallentaa asemat, joissa suunta muuttuu äkillisesti, enintään 1000 asemaa riviä kohti. Seuraavalla rivillä se pienentää kosketussyöttöarvoa automaattisesti, kun kosketusjärjestelmä lähestyy tällaista asemaa. Tämä parantaa tuloksia.
note-feed-reduction-only-up-to-1000 = Syöttöarvon pienennys toimii vain, jos rivillä on enintään 1000 pistettä, joissa syöttöarvoa on pienennettävä.
note-corner-reduction-entered-by-control = Vastaa nurkissa tapahtuvaa syöttöarvon pienennystä koskevaan kysymykseen näppäimellä NO ENT. Ohjaus syöttää arvon automaattisesti.

# --- ohjeet: kiertoakselit ---
note-rotary-axes-touch-trigger = Kytkevällä kosketusjärjestelmällä voidaan digitoida kiertoakselien avulla meanderimaisesti (työkierto 6), riveittäin (työkierto 8) tai korkeuskäyrinä (työkierto 7). Anna kiertoakseli kaikissa tapauksissa työkierrossa ALUE. Ohjaus tulkitsee kiertoakselien arvot asteiksi.
note-rotary-axes-analog = Mittaavalla kosketusjärjestelmällä voidaan digitoida kiertoakselin avulla vain työkierrolla 18 RIVI. Kiertoakseli määritellään sarakeakseliksi.
note-digitizing-range-with-rotary-axis = Kun digitoidaan kiertoakselin avulla, anna kiertoakseli alueessa. Ohjaus tulkitsee sen arvot asteiksi. Digitointitietojen tiedosto sisältää alueessa määritellyt akselit; aihion määrittelyä BLK FORM ei tulosteta, koska kiertoakseleita ei voi esittää graafisesti.
note-digitizing-display-of-rotary-axis = Kiertoakselin näyttötavan on oltava digitoitaessa ja jyrsittäessä sama (supistettu alle 360°:n arvoon tai supistamaton).
note-meander-with-rotary-axis = Jos rivien suuntana on lineaariakseli (esimerkiksi X), ohjaus siirtyy rivin lopussa rivivälin verran työkierron ALUE kiertoakselilla (esimerkiksi A); kosketusjärjestelmä liikkuu silloin edestakaisin esimerkiksi Z/X-tasossa. Jos rivien suuntana on kiertoakseli (esimerkiksi A), ohjaus siirtyy rivin lopussa rivivälin verran lineaariakselilla (esimerkiksi X); kosketusjärjestelmä liikkuu silloin edestakaisin esimerkiksi Z/A-tasossa.
note-contour-lines-with-rotary-axis = Alkupiste määritellään lineaariakselilla (esimerkiksi X) ja kiertoakselilla (esimerkiksi C), samoin lähestymisjärjestys. Kosketusjärjestelmä liikkuu silloin edestakaisin esimerkiksi X/C-tasossa. Tämä soveltuu myös koneille, joissa on vain kaksi lineaariakselia (esimerkiksi Z ja X) ja yksi kiertoakseli (esimerkiksi C). Lähestymisjärjestyksessä määritelty kiertosuunta koskee kaikkia korkeuskäyriä.
note-lines-with-rotary-axis = Jos rivien suuntana on lineaariakseli (esimerkiksi X), ohjaus siirtyy rivin lopussa rivivälin verran työkierron ALUE kiertoakselilla (esimerkiksi A).

# --- ohjeet: tiedot ---
note-digitized-data-on-disk = Ohjaus tallentaa mitatut asemat suoraan kiintolevylle. Liitäntävalikon asetus PRINT määrää hakemiston.
note-digitized-data-with-same-radius = Jos digitointitiedot jyrsitään työkalulla, jonka säde on sama kuin kosketusvarren, ne voidaan suorittaa suoraan työkierrolla 30.
note-block-form-in-data = Ohjaus lisää digitointitietojen tiedostoon aihion määrittelyn BLK FORM. Sitä varten se suurentaa työkierrossa ALUE määriteltyä särmiötä kaksinkertaisen { $mp-stylus-deflection-depth }-arvon verran (mittaavilla kosketusjärjestelmillä).
note-digitized-data-in-programs = Digitointitiedot voidaan suorittaa koneistustyökierrolla 30, jos tarvitaan useita lastuja (vain työkiertojen MEANDERI ja RIVI tiedot), tai apuohjelmalla, jos vain silitetään: määrittele työkalu kosketusvarren säteellä, kutsu se, aseta syöttöarvo, M-toiminnot ja sädekorjaus R0 ja kutsu tiedosto käskyllä CALL PGM.
note-digitized-data-size = Digitointitietojen tiedosto saa olla enintään 1500{"\u00A0"}Mt, mikä on ohjauksen kiintolevyn vapaa tila, kun ohjelmia ei ole tallennettu.

# --- ohjeet: pistetaulukot ---
note-point-table-recording = Pisteet tallennetaan mittaavalla kosketusjärjestelmällä käyttötavalla ”Paikoitus käsin sisäänsyöttäen”. Se vaatii ohjelmisto-option digitointiin mittaavalla kosketusjärjestelmällä. Ohjelmanäppäin PNT valitsee pistetaulukon. Pisteet voidaan tallentaa käsin (TEACH-IN: taivuta kosketusvartta käsin ja ota oloasema talteen) tai automaattisesti (annetulla pistevälillä, kun kosketusvartta liikutetaan käsin kappaleen ympäri). Lisäksi annetaan syöttöarvo, jolla kosketusjärjestelmä reagoi kosketusvarren taipumiseen, ja valitaan kullekin akselille tallennettavat koordinaatit. Vain koneistustason koordinaatit määrittelevät alueen.
note-point-table-size = Alueena käytettävässä pistetaulukossa saa olla enintään 893 pistettä. Jos haluat valvoa tätä, aseta ohjelmanäppäin RANGE/CONTOUR DATA asentoon RANGE.
note-point-table-closed = Pisteet yhdistetään suorilla, jotka rajaavat alueen. Ohjaus yhdistää taulukon viimeisen pisteen automaattisesti ensimmäiseen.
