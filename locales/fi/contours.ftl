# Muodon, lieriövaipan ja kaiverruksen työkierrot.

# --- yhteiset ---
step-retract-to-contour-clearance-height = Työkalu vetäytyy varmuuskorkeudelle syöttöarvolla { $q-contour-retraction-feed } tai, jos se on 0, syöttöarvolla { $q-roughing-feed }.
step-leave-to-contour-clearance-height = Työkalu siirtyy varmuuskorkeudelle.
until-contour-depth-reached = ohjelmoitu syvyys on saavutettu
until-parts-of-contour-cleared = muodon kaikki erilliset alueet on koneistettu
note-contour-element-limit = SL-työkierron muisti on rajallinen. Yhdessä SL-työkierrossa voidaan ohjelmoida enintään 16384 muotoelementtiä.
note-sign-of-milling-depth = Jyrsintäsyvyyden etumerkki määrää työskentelysuunnan. Jos syvyys on 0, ohjaus ei suorita työkiertoa.
note-both-axes-after-contour-cycle = Törmäysvaara! Ohjelmoi SL-työkierron jälkeen koneistustason ensimmäinen liike molemmilla koordinaateilla, esimerkiksi L X+80 Y+0 R0 FMAX.
note-contour-cycle-properties = Ohjaus paikoittaa työkalun itse varmuusetäisyydelle ennen jokaista työkiertoa. Jokainen taso jyrsitään työkalua nostamatta; saarekkeet kierretään sivulta. Sisänurkkien säde on ohjelmoitavissa: työkalu ei pysähdy niihin eikä jätä jälkiä (koskee rouhinnan uloimpaa rataa ja sivun silitystä). Sivun silityksessä ohjaus lähestyy muotoa tangentiaalista ympyränkaarta pitkin, pohjan silityksessä samoin työkappaletta (karan akselilla Z tasossa Z/X). Muoto koneistetaan kauttaaltaan myötälastulla tai vastalastulla.
note-contour-tool-by-name = Työkalu voidaan antaa numerolla tai nimellä. Anna nimi painamalla ohjelmanäppäintä TOOL NAME; ohjaus lisää lainausmerkit itse, kun poistut kentästä.
note-global-def-for-contours = Muodon jyrsinnän toiminto GLOBAL DEF määrittelee ennalta työkiertojen 20, 22, 23, 24 ja 25 varmuusetäisyyden, varmuuskorkeuden, limityskertoimen ja jyrsintämenetelmän.

# --- 14 ---
cycle-contour = Muoto
    .nc = MUOTO
    .purpose = Työkierto luettelee kaikki aliohjelmat, joiden muodot yhdistetään yhdeksi muodoksi. Ohjaus laskee kokonaismuodon näistä osamuodoista, jotka ovat taskuja tai saarekkeita.
step-remember-contour-labels = Ohjaus säilyttää label-numerot. Seuraavat työkierrot koneistavat aliohjelmien kuvaaman muodon.
note-contour-acts-from-definition = Työkierto vaikuttaa määrittelystään lähtien.
note-most-contour-labels = Enintään 12 aliohjelmaa (osamuotoa) voidaan luetella.
note-transformations-in-contour = Koordinaattimuunnokset ovat sallittuja. Jos ne ohjelmoidaan osamuodon sisällä, ne vaikuttavat myös seuraavissa aliohjelmissa; niitä ei tarvitse peruuttaa työkierron kutsun jälkeen.
note-pocket-and-island-recognized = Ohjaus tunnistaa taskun, jos työkalu kulkee muodon sisäpuolella, esimerkiksi myötäpäivään sädekorjauksella RR. Se tunnistaa saarekkeen, jos työkalu kulkee muodon ulkopuolella, esimerkiksi myötäpäivään sädekorjauksella RL.
note-contour-without-spindle-axis = Aliohjelmissa ei saa olla karan akselin koordinaatteja.
note-contour-begins-with-both-axes = Ohjelmoi aliohjelman ensimmäisessä lauseessa aina molemmat akselit.
note-parameters-within-contour = Jos käytetään Q-parametreja, laske ja sijoita niiden arvot vain kyseisen muotoaliohjelman sisällä.
note-contours-may-overlap = Taskuja ja saarekkeita voidaan yhdistää uudeksi muodoksi. Päällekkäinen tasku suurentaa taskun pintaa tai pienentää saareketta.
note-contour-intersections-computed = Ohjaus laskee osamuotojen leikkauspisteet; niitä ei tarvitse ohjelmoida.
note-contour-sum = Summapinta (molemmat pinnat A ja B yhteisine alueineen): A:n ja B:n on oltava taskuja. Luettelon ensimmäisen taskun on alettava toisen ulkopuolelta.
note-contour-difference = Erotuspinta (A ilman B:n peittämää aluetta): A:n on oltava tasku, B:n saareke. A:n on alettava B:n ulkopuolelta, B:n on alettava A:n sisäpuolelta.
note-contour-intersection = Leikkauspinta (vain alue, jonka sekä A että B peittävät): A:n ja B:n on oltava taskuja. A:n on alettava B:n sisäpuolelta.
note-machining-data-in-contour-data = Koneistustiedot kuten jyrsintäsyvyys, työvarat ja varmuusetäisyys annetaan keskitetysti työkierrossa 20.
note-contour-cycle-or-sel-contour = Työkiertoa ei tarvita, jos muoto valitaan toiminnolla SEL CONTOUR.
note-contour-for-turning = Myös muotoa koneistavat sorvauksen työkierrot edellyttävät tätä työkiertoa: se on ohjelmoitava ennen niiden kutsua, ja se ilmoittaa aliohjelman numeron.

# --- 20 ---
cycle-contour-data = Muototiedot
    .nc = MUOTOTIEDOT
    .purpose = Työkierto sisältää osamuotojen aliohjelmia koskevat koneistustiedot.
step-remember-contour-data = Ohjaus säilyttää koneistustiedot työkiertoja 21–24 varten.
note-contour-data-act-from-definition = Työkierto vaikuttaa määrittelystään lähtien. Koneistustiedot koskevat vain työkiertoja 21–24.
note-parameters-reserved-for-contours = Jos SL-työkiertoja käytetään Q-parametriohjelmissa, parametreja Q1–Q20 ei saa käyttää ohjelman parametreina.
note-contour-data-at-interruption = Kun ohjelma keskeytetään, koneistusparametrit voidaan tarkastaa ja tarvittaessa korvata.

# --- 21 ---
cycle-pilot-drilling = Esiporaus
    .nc = ESIPORAUS
    .purpose = Työkierto poraa muodon asetuspisteisiin, jotka ovat samalla rouhinnan alkupisteitä.
step-position-at-pilot-holes = Ohjaus määrittää muodon asetuspisteet.
step-move-over-pilot-hole = Ohjaus paikoittaa työkalun asetuspisteen yläpuolelle varmuusetäisyydelle.
step-drill-pilot-hole-to-plunging-depth = Työkalu poraa syöttöarvolla { $q-contour-plunging-feed } asetussyvyyteen, joka kasvaa jokaisella asetusliikkeellä arvon { $q-contour-plunging-depth } verran.
step-retract-and-return-to-stop-distance = Ohjaus vetää työkalun reiästä pikaliikkeellä (FMAX) ja palauttaa sen esipysäytysetäisyydelle t saavutetun syvyyden yläpuolelle.
until-drilling-depth-reached = poraussyvyys on saavutettu
step-dwell-and-retract-to-start = Työkalu odottaa reiän pohjalla vapaalastuamista varten ja vetäytyy sitten pikaliikkeellä (FMAX) aloitusasemaan.
until-pilot-holes-drilled = kaikki asetuspisteet on porattu
note-stop-distance-determined = Ohjaus määrittää esipysäytysetäisyyden t itse: 0,6{"\u00A0"}mm, kun poraussyvyys on enintään 30{"\u00A0"}mm, ja yli 30{"\u00A0"}mm:n syvyydellä viideskymmenesosa poraussyvyydestä, mutta enintään 7{"\u00A0"}mm.
note-infeed-points-consider = Asetuspisteissä ohjaus ottaa huomioon sivun ja pohjan silitystyövaran sekä rouhintatyökalun säteen.
note-delta-radius-not-considered-for-infeed-points = Asetuspisteitä laskiessaan ohjaus ei ota huomioon TOOL CALL -lauseessa ohjelmoitua delta-arvoa DR.
note-narrow-places-not-pre-drilled = Ahtaissa paikoissa ohjaus ei ehkä voi esiporata työkalulla, joka on rouhintatyökalua suurempi.

# --- 22 ---
cycle-rough-out = Rouhinta
    .nc = ROUHINTA
    .purpose = Työkierto rouhii muodon taso kerrallaan pohjan työvaraan asti tai koneistaa vain sen, mitä suurempi työkalu on jättänyt jäljelle.
step-position-over-infeed-point = Ohjaus paikoittaa työkalun asetuspisteen yläpuolelle ja ottaa huomioon sivun silitystyövaran.
step-take-depths-of-partial-contours = Ohjaus koneistaa osamuodon, jolla on oma syvyys, siihen syvyyteen ja kaikki muut muototietojen jyrsintäsyvyyteen.
step-go-to-infeed-point = Työkalu siirtyy pikaliikkeellä asetuspisteen yläpuolelle ja alas varmuusetäisyydelle jo koneistetusta pinnasta.
step-plunge-to-contour-level = Työkalu siirtyy seuraavaan asetussyvyyteen eli arvon { $q-contour-plunging-depth } verran syvemmälle:
say-plunge-vertically-without-reciprocation = { $q-reciprocation-feed } = 0: kohtisuoraan syöttöarvolla { $q-contour-plunging-feed }, vaikka aktiiviselle työkalulle olisi määritelty sisäänpistokulma { $mp-plunging-angle }
say-plunge-vertically-at-reciprocation-feed = { $mp-plunging-angle } = 90°: kohtisuoraan heiluriliikkeen syöttöarvolla { $q-reciprocation-feed }
say-plunge-on-helix-or-in-strokes = muussa tapauksessa kierukkarataa pitkin sisäänpistokulmalla { $mp-plunging-angle } tai, jos kierukka ei ole mahdollinen, edestakaisin heiluriliikkeellä
step-rough-contour-level = Tässä syvyydessä työkalu jyrsii muodon sisältä ulospäin syöttöarvolla { $q-roughing-feed }; saarekkeiden ympärillä radat lähestyvät taskun muotoa. Näin se koneistaa:
say-rough-what-coarser-tool-left = jos esirouhintatyökalu { $q-coarse-roughing-tool } on annettu, vain sen, mitä tämä työkalu ei ole voinut koneistaa
say-rough-whole-region = muussa tapauksessa koko alueen
message-contour-material-left = Työkalu ei yllä koko muotoon: se jättää materiaalia nurkkiin tai kapeisiin kohtiin.
note-centre-cutting-or-pilot-drilling = Käytä tarvittaessa keskeltä lastuavaa varsijyrsintä (DIN 844) tai esiporaa työkierrolla 21.
note-rough-out-plunging = Työkalun sisäänpisto määräytyy parametrista { $q-reciprocation-feed } ja työkalutaulukon sarakkeista { $mp-plunging-angle } ja { $mp-cutting-edge-length }. Kun { $q-reciprocation-feed } = 0, se tunkeutuu aina kohtisuoraan. Kun { $mp-plunging-angle } = 90°, se tunkeutuu kohtisuoraan syöttöarvolla { $q-reciprocation-feed }. Jos heiluriliikkeen syöttöarvo on annettu ja { $mp-plunging-angle } on välillä 0,1–89,999, se tunkeutuu kierukkarataa pitkin tällä kulmalla. Jos heiluriliikkeen syöttöarvo on annettu mutta työkalutaulukosta puuttuu { $mp-plunging-angle }, ohjaus antaa virheilmoituksen. Jos kierukalle ei ole tilaa (esimerkiksi urassa), ohjaus yrittää tunkeutua heiluriliikkeellä; sen pituus on { $mp-cutting-edge-length } / tan { $mp-plunging-angle }.
note-overlap-greater-than-one = Jos limityskerroin on suurempi kuin 1, teräväkulmaisiin taskumuotoihin voi jäädä materiaalia. Tarkasta sisin rata testausgrafiikalla ja muuta limityskerrointa tarvittaessa hieman. Lastut jakautuvat silloin toisin, mikä johtaa usein haluttuun tulokseen.
note-wear-of-coarse-tool-not-considered = Jälkirouhinnassa ohjaus ei ota huomioon esirouhintatyökalulle määriteltyä kulumisarvoa DR.
note-fine-roughing-needs-tool-data = Jos jälkirouhinnan aluetta ei voida lähestyä sivulta, työkalu tunkeutuu heiluriliikkeellä. Määrittele tätä varten työkalutaulukossa työkalun terän pituus { $mp-cutting-edge-length } ja suurin sisäänpistokulma { $mp-plunging-angle }; muuten ohjaus voi antaa virheilmoituksen.

# --- 23 ---
cycle-floor-finishing = Pohjan silitys
    .nc = POHJAN SILITYS
    .purpose = Työkierto poistaa rouhinnan pohjaan jättämän silitystyövaran.
step-approach-contour-floor = Työkalu lähestyy pohjaa pehmeästi pystysuoraa tangentiaalista ympyränkaarta pitkin, jos tilaa on riittävästi. Muussa tapauksessa se ajaa kohtisuoraan syvyyteen syöttöarvolla { $q-contour-plunging-feed }.
step-find-start-of-floor-finishing = Ohjaus määrittää pohjan silityksen alkupisteen.
step-finish-contour-floor = Työkalu jyrsii rouhinnassa jääneen silitystyövaran syöttöarvolla { $q-roughing-feed }.
note-starting-point-by-itself = Ohjaus määrittää silityksen alkupisteen itse. Se riippuu taskussa olevasta tilasta.
note-approach-radius-is-fixed = Säde, jolla loppusyvyyttä lähestytään, on sisäisesti kiinteä eikä riipu työkalun sisäänpistokulmasta.

# --- 24 ---
cycle-side-finishing = Sivun silitys
    .nc = SIVUN SILITYS
    .purpose = Työkierto silittää muodon sivut. Jokainen osamuoto silitetään erikseen.
step-find-start-of-side-finishing = Ohjaus määrittää silityksen alkupisteen.
step-finish-partial-contour = Ohjaus siirtää työkalun syöttöarvolla { $q-contour-plunging-feed } seuraavaan asetussyvyyteen eli arvon { $q-contour-plunging-depth } verran syvemmälle, ajaa sen tangentiaalisesti ympyränkaarta pitkin osamuotoon ja silittää osamuodon syöttöarvolla { $q-roughing-feed }.
until-partial-contours-finished = jokainen osamuoto on silitetty
note-side-finishing-allowances = Sivun silitystyövaran { $q-remaining-side-allowance } ja silitystyökalun säteen summan on oltava pienempi kuin työkierron 20 sivun silitystyövaran ja rouhintatyökalun säteen summa.
note-side-finishing-without-roughing = Sama pätee, jos työkierto suoritetaan ilman edeltävää rouhintaa työkierrolla 22; rouhintatyökalun säteenä on silloin 0.
note-side-finishing-mills-contours = Työkiertoa voidaan käyttää myös muotojen jyrsintään. Määrittele silloin muoto yksittäiseksi saarekkeeksi (ilman taskun rajausta) ja anna työkierrossa 20 sivun silitystyövara, joka on suurempi kuin silitystyövaran { $q-remaining-side-allowance } ja työkalun säteen summa.
note-start-depends-on-room-and-allowance = Ohjaus määrittää silityksen alkupisteen itse. Se riippuu taskussa olevasta tilasta ja työkierrossa 20 ohjelmoidusta työvarasta.
note-start-depends-on-sequence = Alkupiste riippuu myös koneistusjärjestyksestä. Jos silityksen työkierto valitaan näppäimellä GOTO ja ohjelma sitten käynnistetään, alkupiste voi olla muualla kuin silloin, kun ohjelma suoritetaan järjestyksessä.

# --- 25 ---
cycle-contour-train = Muotorailo
    .nc = MUOTORAILO
    .purpose = Työkierto koneistaa avoimia ja suljettuja muotoja yhdessä työkierron 14 kanssa. Toisin kuin paikoituslauseilla ohjelmoidussa muodossa ohjaus valvoo koneistusta, jyrsii kauttaaltaan myötälastulla tai vastalastulla ja voi jyrsiä edestakaisin ja työvaroja käyttäen.
step-position-over-contour-start = Ohjaus siirtää työkalun varmuuskorkeudelle { $q-contour-clearance-height } ja muodon alkupisteen yläpuolelle.
step-plunge-beside-contour = Työkalu siirtyy syöttöarvolla { $q-contour-plunging-feed } seuraavaan asetussyvyyteen eli arvon { $q-contour-plunging-depth } verran syvemmälle.
step-mill-along-contour = Työkalu jyrsii muotoa pitkin syöttöarvolla { $q-contour-milling-feed } ottaen huomioon silitystyövaran { $q-side-allowance }:
say-mill-to-and-fro = { $q-contour-milling-type } = 0: edestakaisin, asetusliikkeittäin vuorotellen myötä- ja vastalastulla
say-mill-in-one-direction = { $q-contour-milling-type } = +1 tai −1: jokaisella asetusliikkeellä myötälastulla tai vastalastulla
until-milling-depth-reached = jyrsintäsyvyys { $q-milling-depth } on saavutettu
note-contour-damage-monitored = Ohjaus valvoo koneistusta niin, ettei synny takaleikkauksia eikä muotovaurioita. Tarkasta muoto graafisella testauksella.
note-inside-corners-may-need-reworking = Jos työkalun säde on liian suuri, muodon sisänurkat on ehkä jälkikoneistettava.
note-milling-type-kept-when-mirrored = Muoto voidaan koneistaa kauttaaltaan myötälastulla tai vastalastulla. Jyrsintämenetelmä säilyy myös muotoja peilattaessa.
note-several-infeeds-to-and-fro = Useilla asetusliikkeillä ohjaus voi ajaa työkalua edestakaisin, mikä lyhentää koneistusaikaa.
note-contour-in-several-operations = Työvaroja voidaan antaa, joten rouhinta ja silitys voidaan tehdä useassa työvaiheessa.
note-only-first-contour-label = Ohjaus ottaa huomioon vain työkierron 14 ensimmäisen labelin.
note-contour-data-not-needed = Työkiertoa 20 ei tarvita.
note-corner-feed-functions-without-effect = Lisätoiminnot M109 ja M110 eivät vaikuta, kun muoto koneistetaan tällä työkierrolla.
note-no-incremental-after-contour-train = Törmäysvaara! Älä ohjelmoi työkierron jälkeen inkrementaalisia mittoja: ne perustuvat työkalun asemaan työkierron lopussa.
note-absolute-position-after-contour-train = Törmäysvaara! Aja työkalu työkierron jälkeen kaikilla pääakseleilla määriteltyyn (absoluuttiseen) asemaan, koska sen asema työkierron lopussa ei ole sama kuin alussa.

# --- 27–29 ---
step-plunge-into-cylinder = Työkalu siirtyy syöttöarvolla { $q-contour-plunging-feed } seuraavaan asetussyvyyteen eli arvon { $q-contour-plunging-depth } verran syvemmälle.
until-cylinder-milling-depth-reached = ohjelmoitu jyrsintäsyvyys { $q-cylinder-milling-depth } on saavutettu
step-return-in-tool-axis = Työkalu palaa työkaluakselin suunnassa varmuuskorkeudelle tai asemaan, joka on viimeksi ohjelmoitu ennen työkiertoa.
guard-clearance-within-tool-radius = Varmuusetäisyys ei ole suurempi kuin työkalun säde.
guard-spindle-not-across-rotary-axis = Karan akseli ei ole kohtisuorassa pyöröpöydän akselia vastaan.
guard-datum-off-rotary-axis = Peruspiste ei ole pyöröpöydän akselilla: lieriö heittäisi.
guard-depth-out-of-cylinder = Jyrsintäsyvyys on positiivinen: työkalu liikkuisi poispäin lieriön akselista.
guard-slot-core-left = Ura on yli kaksi kertaa niin leveä kuin työkalu: seinämien väliin jää materiaalia.
note-contour-in-development = Kuvaa muoto työkierrolla 14 valittavassa aliohjelmassa, aina koordinaateilla X ja Y koneen kiertoakseleista riippumatta. Silloin muodon kuvaus ei riipu koneen konfiguraatiosta.
note-prepare-for-cylinder-interpolation = Koneen valmistajan on valmisteltava kone ja ohjaus lieriövaippainterpolaatiota varten. Katso koneen käyttöohjekirjaa.
note-contour-begins-with-both-coordinates-of-cylinder = Ohjelmoi muotoaliohjelman ensimmäisessä NC-lauseessa aina lieriövaipan molemmat koordinaatit.
note-centre-cutting-end-mill = Käytä keskeltä lastuavaa varsijyrsintä (DIN 844).
note-cylinder-centred-on-rotary-table = Lieriön on oltava kiinnitetty pyöröpöydän keskelle.
note-datum-in-centre-of-rotary-table = Aseta peruspiste pyöröpöydän keskipisteeseen.
note-spindle-across-rotary-axis = Karan akselin on työkiertoa kutsuttaessa oltava kohtisuorassa pyöröpöydän akselia vastaan. Muuten ohjaus antaa virheilmoituksen. Kinematiikan vaihto voi olla tarpeen.
note-cylinder-in-tilted-plane = Työkiertoa voidaan käyttää myös koneistustason ollessa käännettynä.
note-clearance-greater-than-tool-radius = Varmuusetäisyyden { $q-cylinder-set-up-clearance } on oltava suurempi kuin työkalun säde.
note-many-contour-elements-take-time = Koneistus voi kestää kauemmin, jos muodossa on paljon muotoelementtejä, jotka eivät liity toisiinsa tangentiaalisesti.

# --- 27 ---
cycle-cylinder-surface = Lieriövaippa
    .nc = LIERIÖVAIPPA
    .purpose = Työkierto siirtää levityskuvaan määritellyn muodon lieriön vaipalle.
step-mill-along-developed-contour = Työkalu jyrsii ohjelmoitua muotoa pitkin syöttöarvolla { $q-contour-milling-feed }.
step-back-over-infeed-point = Muodon lopussa ohjaus siirtää työkalun varmuusetäisyydelle { $q-cylinder-set-up-clearance } ja takaisin asetuspisteen yläpuolelle.
step-end-at-cylinder-clearance = Työkalu siirtyy varmuusetäisyydelle { $q-cylinder-set-up-clearance }.
note-functions-for-developed-contour = Työkalun rataa varten käytettävissä ovat toiminnot L, CHF, CR, RND ja CT.
note-angular-axis-unit = Kulma-akselin arvot (X-koordinaatit) voidaan antaa asteina tai millimetreinä (tuumina); sen määrää parametri { $q-development-dimension-type }.
note-guide-slots-with-other-cycle = Käytä johdeurien jyrsintään lieriölle työkiertoa 28.

# --- 28 ---
cycle-cylinder-surface-slot = Lieriövaippa – uran jyrsintä
    .nc = LIERIÖVAIPPA
    .purpose = Työkierto siirtää levityskuvaan määritellyn johdeuran lieriön vaipalle niin, että seinämät ovat lähes yhdensuuntaiset.
step-position-over-slot-infeed-point = Ohjaus paikoittaa työkalun asetuspisteen yläpuolelle.
step-mill-along-slot-wall = Työkalu jyrsii uran seinämää pitkin syöttöarvolla { $q-contour-milling-feed } ottaen huomioon sivun silitystyövaran { $q-side-allowance }.
step-mill-back-along-opposite-wall = Muodon lopussa ohjaus siirtää työkalun uran vastakkaiselle seinämälle ja takaisin asetuspisteeseen.
step-rework-slot-walls = Jos toleranssi { $q-cylinder-slot-tolerance } on määritelty, ohjaus jälkikoneistaa uran niin, että sen seinämät ovat mahdollisimman yhdensuuntaiset.
note-walls-nearly-parallel = Toisin kuin työkierto 27, tämä työkierto asettaa työkalun niin, että seinämät ovat sädekorjauksen ollessa voimassa lähes yhdensuuntaiset. Ne ovat täysin yhdensuuntaiset, jos työkalu on täsmälleen uran levyinen.
note-small-tool-distorts-slot = Mitä pienempi työkalu on uran leveyteen verrattuna, sitä suurempia ovat vääristymät kaarissa ja vinoissa suorissa. Niitä voidaan pienentää määrittelemällä toleranssi { $q-cylinder-slot-tolerance }: silloin ohjaus tekee urasta lähes samanlaisen kuin uran levyisellä työkalulla.
note-program-centre-path-of-slot = Ohjelmoi muodon keskipisterata sädekorjauksella. Sädekorjaus määrää, tekeekö ohjaus uran myötälastulla vai vastalastulla.

# --- 29 ---
cycle-cylinder-surface-ridge = Lieriövaippa – uuman jyrsintä
    .nc = LIERIÖVAIPPA UUMA
    .purpose = Työkierto siirtää levityskuvaan määritellyn uuman lieriön vaipalle niin, että seinämät ovat yhdensuuntaiset.
step-position-over-ridge-start = Ohjaus paikoittaa työkalun koneistuksen alkupisteen yläpuolelle, jonka se laskee uuman leveydestä ja työkalun halkaisijasta: muotoaliohjelman ensimmäisen pisteen viereen, siirrettynä uuman leveyden puolikkaan ja koko työkalun halkaisijan summan verran. Sädekorjaus määrää puolen: uuman vasemmalla puolella (myötälastu) tai oikealla puolella (vastalastu).
step-approach-ridge-wall = Tässä syvyydessä työkalu ajaa muotoon tangentiaalista ympyränkaarta pitkin syöttöarvolla { $q-contour-milling-feed } ja ottaa huomioon sivun silitystyövaran { $q-side-allowance }, jos se on annettu.
step-mill-along-ridge-wall = Työkalu jyrsii uuman seinämää pitkin syöttöarvolla { $q-contour-milling-feed }, kunnes uuma on valmis.
step-leave-ridge-wall = Työkalu irtautuu uuman seinämästä tangentiaalisesti ja palaa koneistuksen alkupisteeseen.
note-ridge-walls-parallel = Työkierto asettaa työkalun niin, että seinämät ovat sädekorjauksen ollessa voimassa aina yhdensuuntaiset.
note-program-centre-path-of-ridge = Ohjelmoi uuman keskipisterata sädekorjauksella. Sädekorjaus määrää, tekeekö ohjaus uuman myötälastulla vai vastalastulla.
note-ridge-ends-in-semicircles = Ohjaus lisää uuman päihin aina puoliympyrän; sen säde on puolet uuman leveydestä.

# --- 225 ---
cycle-engraving = Kaiverrus
    .nc = KAIVERRUS
    .purpose = Työkierto kaivertaa tekstiä työkappaleen tasaiselle pinnalle suoraa tai ympyränkaarta pitkin.
step-move-to-first-character = Ohjaus paikoittaa työkalun koneistustasossa ensimmäisen merkin alkupisteeseen.
step-engrave-character = Työkalu tunkeutuu kohtisuoraan syöttöarvolla { $q-plunging-feed } kaiverruksen pohjaan ja jyrsii merkin syöttöarvolla { $q-milling-feed }. Jos työkalua on nostettava merkin sisällä, se nousee varmuusetäisyydelle { $q-set-up-clearance }. Merkin lopussa työkalu on varmuusetäisyydellä työkappaleen yläpinnan yläpuolella.
step-move-over-next-character = Ohjaus siirtää työkalun varmuusetäisyydellä seuraavan merkin alkupisteeseen.
until-characters-engraved = kaikki merkit on kaiverrettu
step-end-engraving-at-second-clearance = Ohjaus siirtää työkalun 2. varmuusetäisyydelle { $q-second-set-up-clearance }.
condition-text-runs-on-arc = teksti sijoitetaan ympyränkaarelle ({ $q-text-arrangement })
note-straight-text-starts-at-tool = Suoralle asetetussa tekstissä ({ $q-text-arrangement } = 0) työkalun asema työkierron kutsuhetkellä on ensimmäisen merkin alkupiste.
note-circle-text-centre-at-tool = Kaarelle asetetussa tekstissä ({ $q-text-arrangement } = 1) työkalun asema työkierron kutsuhetkellä on ympyrän keskipiste.
note-text-from-string-parameter = Teksti voidaan antaa myös merkkijonoparametrilla (QS).
note-engraving-characters = Kaiverrettavissa olevat merkit: pienet kirjaimet, suuret kirjaimet, numerot ja erikoismerkit ! # $ % & ' ( ) * + , - . / : ; < = > ? @ [ \ ] _
note-engraving-doubled-characters = Ohjaus käyttää erikoismerkkejä % ja \ erikoistoimintoihin. Jos haluat kaivertaa jommankumman niistä, kirjoita se tekstiin kahdesti, esimerkiksi %%.
note-engraving-control-characters = Erikoismerkki \ aloittaa myös merkit, joita ei kaiverreta vaan jotka asettelevat tekstiä: \n on rivinvaihto, \t vaakasarkain (sarkaimen leveys on 8 merkkiä), \v pystysarkain (sarkaimen leveys on yksi rivi).
note-proportional-font = Kirjasimen merkit ovat erilevyisiä: jokaisella merkillä on oma leveytensä. Välikerroin { $q-character-spacing-factor } skaalaa merkkien välistä etäisyyttä.
note-engraving-since-software = Työkierto on käytettävissä ohjelmistosta 34059x-02 lähtien.
