# Työkierrot, jotka kalibroivat kosketusjärjestelmiä.

# --- 460 ---
cycle-calibrate-on-sphere = Kosketusjärjestelmän kalibrointi
    .nc = TS KALIBROINTI KUULASSA
    .purpose = Työkierto kalibroi kytkevän 3D-kosketusjärjestelmän automaattisesti tarkalla kalibrointikuulalla: vain säteen tai säteen ja pituuden.
condition-length-calibration-wanted = { $q-length-calibration } = 1
step-position-probe-over-sphere = Paikoita kosketusjärjestelmä kosketusakselin suunnassa kalibrointikuulan yläpuolelle ja koneistustasossa kuulan keskelle.
step-approach-sphere-downwards = Työkierron ensimmäinen liike tapahtuu kosketusakselin negatiiviseen suuntaan.
step-find-sphere-centre = Ohjaus määrittää kuulan tarkan keskipisteen kosketusakselilla.
step-calibrate-radius-on-sphere = Ohjaus kalibroi säteen tasossa kosketuksilla, joiden lukumäärä on { $q-calibration-sphere-probings }. Mittauspisteiden välillä kosketusjärjestelmä siirtyy:
say-travel-at-clearance-height-between-points = jos { $q-traverse-to-clearance-height } = 1, varmuuskorkeudella
say-travel-at-measuring-height-between-points = jos { $q-traverse-to-clearance-height } = 0, mittauskorkeudella
step-calibrate-length-on-sphere = Säteen jälkeen ohjaus käsittelee pituuden parametrin { $q-length-calibration } mukaan:
say-length-from-sphere-centre = jos { $q-length-calibration } = 1, se kalibroi pituuden; { $q-length-reference } on kuulan keskipisteen koordinaatti
say-length-unchanged = jos { $q-length-calibration } = 0, se ei kalibroi pituutta
step-store-calibration-values = Ohjaus tallentaa kalibrointiarvot. Ne tulevat heti voimaan.
note-position-above-sphere-in-program = Paikoita kosketusjärjestelmä ohjelmassa suunnilleen kuulan keskipisteen yläpuolelle.
note-effective-length-reference = Kosketusjärjestelmän vaikuttava pituus perustuu aina työkalun peruspisteeseen. Yleensä koneen valmistaja asettaa työkalun peruspisteen karan nokkaan.
note-when-to-calibrate = Kalibroi kosketusjärjestelmä aina käyttöönotossa, kosketusvarren rikkoutumisen tai vaihdon jälkeen, kosketussyöttöarvon muuttamisen jälkeen, erityisten olosuhteiden jälkeen (esimerkiksi kun kone on lämmennyt) ja aktiivisen työkaluakselin vaihdon jälkeen.
note-when-to-calibrate__tnc426-430 = Kalibroi kosketusjärjestelmä aina käyttöönotossa, kosketusvarren rikkoutumisen tai vaihdon jälkeen, kosketussyöttöarvon muuttamisen jälkeen ja erityisten olosuhteiden jälkeen (esimerkiksi kun kone on lämmennyt).
note-known-ring-or-stud = Kalibrointi määrittää kosketusvarren vaikuttavan pituuden ja kosketuskuulan vaikuttavan säteen. Kiinnitä kalibrointia varten koneen pöydälle asetusrengas tai kaula, jonka korkeus ja säde tunnetaan.
note-known-ring-or-stud__tnc426-430 = Kalibrointi määrittää kosketusvarren vaikuttavan pituuden ja kosketuskuulan vaikuttavan säteen. Aseta kalibrointia varten koneen pöydälle asetusrengas, jonka korkeus ja sisäsäde tunnetaan.
note-calibration-values-at-once = Aktiivisen kosketusjärjestelmän kalibrointiarvot tulevat voimaan heti kalibroinnin jälkeen. Työkalua ei tarvitse kutsua uudelleen.
note-calibration-values-in-tables = Ohjaus tallentaa kosketusjärjestelmän vaikuttavan pituuden ja vaikuttavan säteen työkalutaulukkoon ja keskipistesiirtymän kosketusjärjestelmän taulukon sarakkeisiin { $mp-probe-offset-main } (pääakseli) ja { $mp-probe-offset-minor } (sivuakseli). Kosketusjärjestelmän taulukon ohjelmanäppäin näyttää tallennetut arvot.
note-right-tool-number-for-probe = Kun kosketusjärjestelmää käytetään, oikean työkalun numeron on oltava voimassa, suoritetaanpa kosketustyökierto automaattikäyttötavalla tai käsin.

# --- 461 ---
cycle-calibrate-probe-length = Kosketusjärjestelmän pituuden kalibrointi
    .nc = TS PITUUDEN KALIBROINTI
    .purpose = Työkierto kalibroi kytkevän 3D-kosketusjärjestelmän vaikuttavan pituuden pinnalla, jonka korkeus tunnetaan, esimerkiksi asetusrenkaalla.
step-prepare-length-calibration = Aseta ennen työkierron käynnistystä karan akselin peruspiste niin, että koneen pöydällä Z = 0, ja paikoita kosketusjärjestelmä kalibrointirenkaan yläpuolelle.
step-orient-to-calibration-angle = Jos kosketusjärjestelmä voidaan suunnata, ohjaus suuntaa sen kulmaan { $mp-probe-calibration-angle }, joka on annettu kosketusjärjestelmän taulukossa.
step-probe-down-from-here = Ohjaus koskettaa hetkellisasemasta karan akselin negatiiviseen suuntaan kosketussyöttöarvolla (sarake { $mp-probing-feed }).
step-return-to-start-of-calibration = Ohjaus paikoittaa kosketusjärjestelmän pikaliikkeellä (sarake { $mp-positioning-feed }) takaisin aloitusasemaan.
step-store-probe-length = Ohjaus tallentaa vaikuttavan pituuden työkalutaulukkoon.

# --- 462 ja 463 ---
cycle-calibrate-in-ring = Kosketusjärjestelmän säteen kalibrointi sisäpuolella
    .nc = TS KALIBROINTI RENKAASSA
    .purpose = Työkierto kalibroi kytkevän 3D-kosketusjärjestelmän kosketuskuulan vaikuttavan säteen kalibrointirenkaassa sekä keskipistesiirtymän, jos kosketusjärjestelmä sen sallii.
cycle-calibrate-on-stud = Kosketusjärjestelmän säteen kalibrointi ulkopuolella
    .nc = TS KALIBROINTI KAULASSA
    .purpose = Työkierto kalibroi kytkevän 3D-kosketusjärjestelmän kosketuskuulan vaikuttavan säteen kaulassa tai kalibrointitapissa sekä keskipistesiirtymän, jos kosketusjärjestelmä sen sallii.
step-pre-position-in-ring = Esipaikoita kosketusjärjestelmä ennen työkierron käynnistystä kalibrointirenkaan keskelle ja haluttuun mittauskorkeuteen.
step-pre-position-over-stud = Esipaikoita kosketusjärjestelmä ennen työkierron käynnistystä keskelle kalibrointitapin yläpuolelle, kosketusakselin suunnassa suunnilleen varmuusetäisyydelle siitä (sarakkeen { $mp-set-up } arvo + { $q-probing-clearance }).
step-rough-measurement-of-part = Ensimmäisellä kierroksella ohjaus määrittää kalibrointirenkaan keskipisteen (karkea mittaus) ja paikoittaa kosketusjärjestelmän keskelle.
step-rough-measurement-of-part__calibrate-on-stud = Ensimmäisellä kierroksella ohjaus määrittää kaulan tai kalibrointitapin keskipisteen (karkea mittaus) ja paikoittaa kosketusjärjestelmän keskelle.
step-fine-measurement-of-part = Sen jälkeen varsinainen kalibrointi (tarkka mittaus) määrittää kosketuskuulan säteen.
step-travel-between-calibration-points = Mittauspisteiden välillä kosketusjärjestelmä siirtyy:
step-reverse-measurement = Jos kosketusjärjestelmä voidaan suunnata kahteen tai mihin tahansa suuntaan, ohjaus kääntää sitä 180° ja tekee neljä lisäkosketusta. Tämä mittaus määrittää myös keskipistesiirtymän.
step-store-radius-and-offset = Ohjaus tallentaa kosketuskuulan vaikuttavan säteen työkalutaulukon sarakkeeseen { $mp-tool-radius } ja keskipistesiirtymän kosketusjärjestelmän taulukon sarakkeisiin { $mp-probe-offset-main } ja { $mp-probe-offset-minor }.
guard-too-few-calibration-points = Kosketuksia tarvitaan vähintään kolme: { $q-calibration-ring-probings } on liian pieni.
guard-too-few-calibration-points__calibrate-on-sphere = Kosketuksia tarvitaan vähintään kolme: { $q-calibration-sphere-probings } on liian pieni.
note-orientation-decides-calibration = Kalibrointi riippuu siitä, miten kosketusjärjestelmä voidaan suunnata. Jos sitä ei voida suunnata tai se voidaan suunnata vain yhteen suuntaan, ohjaus tekee karkean ja tarkan mittauksen ja määrittää kosketuskuulan vaikuttavan säteen. Jos se voidaan suunnata kahteen suuntaan (kuten HEIDENHAINin kaapelilliset kosketusjärjestelmät), ohjaus tekee karkean ja tarkan mittauksen, kääntää kosketusjärjestelmää 180° ja tekee neljä lisäkosketusta, jotka määrittävät säteen lisäksi keskipistesiirtymän. Jos se voidaan suunnata mihin tahansa suuntaan (kuten HEIDENHAINin infrapunakosketusjärjestelmät), kalibrointi on sama kuin kahden suunnan tapauksessa.
note-centre-offset-needs-suitable-probe = Keskipistesiirtymä voidaan määrittää vain siihen soveltuvalla kosketusjärjestelmällä.
note-centre-offset-prepared = Koneen valmistajan on valmisteltava ohjaus kosketusvarren keskipistesiirtymän määritystä varten. Katso koneen käyttöohjekirjaa.
note-orientation-predefined = HEIDENHAIN-kosketusjärjestelmille on valmiiksi määritelty, voidaanko ne suunnata ja miten. Muut kosketusjärjestelmät konfiguroi koneen valmistaja.

# --- 2 ---
cycle-calibrate-touch-probe = Kytkevän kosketusjärjestelmän kalibrointi
    .nc = TS KALIBROINTI
    .purpose = Työkierto kalibroi kytkevän kosketusjärjestelmän automaattisesti kalibrointirenkaassa tai kalibrointikaulassa.
step-rise-to-clearance-height = Kosketusjärjestelmä siirtyy pikaliikkeellä (arvo koneparametrista { $mp-positioning-feed } tai { $mp-analog-positioning-feed }) varmuuskorkeudelle, jos sen hetkellisasema on alempana.
step-position-over-calibration-part = Ohjaus paikoittaa kosketusjärjestelmän koneistustasossa:
say-near-first-touch-point = ensimmäisen kosketuspisteen lähelle (kalibrointi ulkopuolella)
say-at-centre-of-ring = kalibrointirenkaan keskelle (kalibrointi sisäpuolella)
step-probe-calibration-part = Kosketusjärjestelmä siirtyy mittaussyvyyteen, joka määräytyy koneparametreista { $mp-calibration-part-centre }.2 (muilla liikealueilla { $mp-calibration-part-centre-2 }.2, { $mp-calibration-part-centre-3 }.2) ja { $mp-calibration-part-depth }.x, ja koskettaa kalibrointikappaletta peräkkäin suunnissa X+, Y+, X− ja Y−.
step-retract-and-store-ball-radius = Ohjaus vetää kosketusjärjestelmän varmuuskorkeudelle ja kirjoittaa kosketuskuulan vaikuttavan säteen kalibrointitietoihin.
note-calibration-part-centre-known = Määrittele ennen kalibrointia kalibrointikappaleen keskipiste koneen työtilassa koneparametreissa { $mp-calibration-part-centre }.0–{ $mp-calibration-part-centre }.2 (REF-koordinaatit).
note-calibration-part-per-traverse-range = Jos käytetään useita liikealueita, kullekin niistä voidaan tallentaa oma tietojoukko kalibrointikappaleen keskipisteelle: { $mp-calibration-part-centre-2 }.0–{ $mp-calibration-part-centre-2 }.2 ja { $mp-calibration-part-centre-3 }.0–{ $mp-calibration-part-centre-3 }.2.
note-probe-type-selected = Jos käytetään vuorotellen kytkevää ja mittaavaa kosketusjärjestelmää, varmista, että { $mp-probe-selection } valitsee oikean kosketusjärjestelmän. Ne eivät saa koskaan olla samanaikaisesti liitettyinä ohjaukseen. Ohjaus ei pysty tunnistamaan, kumpi kosketusjärjestelmä koneessa todella on.
