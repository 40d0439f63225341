# Porauksen työkierrot: kalvinta, väljennys, yleisporaus, takaupotus, porausjyrsintä, keskiöporaus, yksihuuliporaus.

# --- yhteiset lauseet ---
step-retract-at-retraction-feed = Työkalu vetäytyy syöttöarvolla { $q-retraction-feed } varmuusetäisyydelle { $q-set-up-clearance }.

# --- 201 ---
cycle-reaming = Kalvinta
    .nc = KALVINTA
    .purpose = Työkierto kalvii reiän yhdellä asetusliikkeellä. Työkalu poistuu reiästä omalla syöttöarvollaan.
step-ream-to-depth = Työkalu kalvii syöttöarvolla { $q-plunging-feed } ohjelmoituun syvyyteen { $q-depth }.

# --- 203 ---
cycle-universal-drilling = Yleisporaus
    .nc = YLEISPORAUS
    .purpose = Työkierto poraa reiän asetusliikkeillä, jotka voivat pienentyä. Lastu voidaan katkaista useita kertoja, ennen kuin työkalu vedetään irti reiästä.
step-drill-to-decreasing-plunging-depth = Työkalu poraa syöttöarvolla { $q-plunging-feed } seuraavaan asetussyvyyteen. Asetussyvyys { $q-plunging-depth } pienenee jokaisella asetusliikkeellä vähennysarvon { $q-decrement } verran, jos se on annettu.
step-break-chip-or-retract = Kahden asetusliikkeen välillä työkalu liikkuu takaisin:
say-break-chip-by-retraction = lastunkatkossa matkan { $q-chip-breaking-retraction }, niin monta kertaa kuin { $q-chip-breaks-before-retraction } määrää, ennen kuin se vedetään irti reiästä
say-retract-and-return-at-rapid = ilman lastunkatkoa syöttöarvolla { $q-retraction-feed } varmuusetäisyydelle, jossa se odottaa ajan { $q-dwell-at-top }, jos se on annettu; sieltä se siirtyy pikaliikkeellä (FMAX) varmuusetäisyydelle saavutetun syvyyden yläpuolelle

# --- 240 ---
cycle-centring = Keskiöporaus
    .nc = KESKIÖPORAUS
    .purpose = Työkierto keskiöi reiän haluttuun syvyyteen tai halkaisijaan.
step-centre-to-depth-or-diameter = Työkalu keskiöi syöttöarvolla { $q-plunging-feed }:
say-centre-to-diameter = { $q-depth-or-diameter } = 1: keskiöhalkaisijaan { $q-centring-diameter }
say-centre-to-depth = { $q-depth-or-diameter } = 0: keskiösyvyyteen { $q-depth }
step-dwell-at-centring-bottom = Työkalu odottaa keskiön pohjalla ajan { $q-dwell-at-bottom }, jos se on annettu.
condition-centring-to-depth = { $q-depth-or-diameter } = 0
condition-centring-to-diameter = { $q-depth-or-diameter } = 1
guard-point-angle-missing = Keskiöinti halkaisijaan edellyttää, että työkalun kärkikulma { $mp-drill-point-angle } on määritelty työkalutaulukossa.
guard-depth-zero__centring = Valittu syvyys tai halkaisija on 0: ohjaus ei suorita työkiertoa.
guard-depth-positive__centring = Valittu syvyys tai halkaisija on positiivinen. Anna negatiivinen arvo tai salli positiivinen arvo koneparametrilla { $mp-display-depth-err }.
note-sign-of-depth-or-diameter = Halkaisijan { $q-centring-diameter } tai syvyyden { $q-depth } etumerkki määrää työskentelysuunnan sen mukaan, kumpi niistä on valittu. Jos halkaisija tai syvyys on 0, ohjaus ei suorita työkiertoa.
note-positive-diameter-or-depth-reverses = Törmäysvaara! Jos halkaisija tai syvyys on positiivinen, ohjaus laskee esipaikoituksen käänteisesti: työkalu siirtyy työkaluakselin suunnassa pikaliikkeellä varmuusetäisyydelle työkappaleen yläpinnan alapuolelle.

# --- 202 ---
cycle-boring = Väljennys
    .nc = VÄLJENNYS
    .purpose = Työkierto väljentää reiän. Pohjalla kara suunnataan, ja työkalu voi irtautua seinämästä ennen vetäytymistä.
step-bore-to-depth = Työkalu väljentää syöttöarvolla { $q-plunging-feed } syvyyteen { $q-depth }.
step-dwell-with-spindle-turning = Vapaalastuamista varten työkalu odottaa reiän pohjalla karan pyöriessä ajan { $q-dwell-at-bottom }, jos aika on annettu.
step-orient-spindle-to-angle = Ohjaus suuntaa karan parametrissa { $q-spindle-orientation-angle } määriteltyyn asemaan.
step-disengage-from-wall = Jos irtiajo on valittu, työkalu siirtyy 0,2{"\u00A0"}mm (kiinteä arvo) suuntaan { $q-disengaging-direction }.
step-retract-bored-tool = Työkalu vetäytyy syöttöarvolla { $q-retraction-feed } varmuusetäisyydelle { $q-set-up-clearance }. Jos { $q-disengaging-direction } = 0, se palaa reiän seinämää pitkin.
step-restore-spindle-and-coolant = Ohjaus palauttaa karan ja jäähdytyksen tilat, jotka olivat voimassa ennen työkierron kutsua.
note-machine-and-control-prepared = Koneen valmistajan on valmisteltava kone ja ohjaus tätä työkiertoa varten.
note-servo-controlled-spindle-only = Työkiertoa voidaan käyttää vain koneissa, joissa on ohjattu kara.
note-spindle-and-coolant-restored = Työkierron lopussa ovat jälleen voimassa jäähdytyksen ja karan tilat, jotka vallitsivat ennen työkierron kutsua.
note-disengage-away-from-edge = Törmäysvaara! Valitse irtiajosuunta { $q-disengaging-direction } niin, että työkalu siirtyy poispäin reiän reunasta.
note-check-position-of-tool-tip = Törmäysvaara! Suuntaa kara parametrissa { $q-spindle-orientation-angle } ohjelmoituun kulmaan (esimerkiksi käyttötavalla ”Paikoitus käsin sisäänsyöttäen”) ja tarkasta, missä työkalun kärki on. Valitse kulma niin, että työkalun kärki on koordinaattiakselin suuntainen.
note-disengaging-considers-rotation = Irtiajossa ohjaus ottaa itse huomioon koordinaatiston voimassa olevan kierron.

# --- 204 ---
cycle-back-boring = Takaupotus
    .nc = TAKAUPOTUS
    .purpose = Työkierto koneistaa upotuksia työkappaleen alapintaan.
step-orient-and-offset-tool = Ohjaus suuntaa karan kulmaan { $q-spindle-orientation-angle } ja siirtää työkalua epäkeskomitan { $q-off-centre-distance } verran suuntaan { $q-disengaging-direction }.
step-feed-through-bore = Työkalu ajaa esipaikoituksen syöttöarvolla { $q-in-and-out-feed } valmiiseen reikään, kunnes terä on varmuusetäisyydellä { $q-set-up-clearance } työkappaleen alareunan alapuolella.
step-centre-tool-and-counterbore = Ohjaus siirtää työkalun takaisin reiän keskelle, kytkee päälle karan ja tarvittaessa jäähdytyksen ja ajaa sitten syöttöarvolla { $q-countersinking-feed } syvyyteen { $q-counterbore-depth }.
step-dwell-and-leave-counterbore = Jos { $q-counterbore-dwell } on annettu, työkalu odottaa upotuksen pohjalla. Sitten se poistuu upotuksesta; ohjaus suuntaa karan ja siirtää työkalua uudelleen epäkeskomitan verran.
step-feed-out-of-bore = Työkalu ajaa esipaikoituksen syöttöarvolla { $q-in-and-out-feed } varmuusetäisyydelle { $q-set-up-clearance } työkappaleen yläpinnan yläpuolelle.
note-back-boring-bars-only = Työkierto toimii vain takaupotukseen tarkoitetuilla poratangoilla.
note-sign-of-counterbore-depth = Syvyyden { $q-counterbore-depth } etumerkki määrää työskentelysuunnan. Huomio: positiivisella etumerkillä upotetaan karan akselin positiiviseen suuntaan.
note-length-to-lower-edge-of-bar = Anna työkalun pituus poratangon alareunaan eikä terään mitattuna.
note-edge-height-and-thickness-considered = Upotuksen alkupistettä laskiessaan ohjaus ottaa huomioon poratangon terän korkeuden { $q-cutting-edge-height } ja materiaalin paksuuden { $q-material-thickness }.

# --- 208 ---
cycle-bore-milling = Porausjyrsintä
    .nc = PORAUSJYRSINTÄ
    .purpose = Työkierto jyrsii reiän kierukkarataa pitkin. Jos reikä on yhtä leveä kuin työkalu, se porataan suoraan.
step-rapid-and-approach-hole-circumference = Ohjaus siirtää työkalun karan akselin suunnassa pikaliikkeellä (FMAX) varmuusetäisyydelle { $q-set-up-clearance } työkappaleen yläpinnan yläpuolelle ja sen jälkeen ympyränkaarta pitkin reiän kehälle { $q-nominal-diameter }, jos tilaa on riittävästi.
step-drill-directly-if-diameters-equal = Jos halkaisija { $q-nominal-diameter } on yhtä suuri kuin työkalun halkaisija, työkalu poraa ilman kierukkaa suoraan syvyyteen { $q-depth }.
step-mill-on-helix = Työkalu jyrsii syöttöarvolla { $q-plunging-feed } kierukkarataa, joka laskeutuu jokaisella kierroksella arvon { $q-infeed-per-helix } verran.
step-mill-full-circle-at-depth = Syvyydessä työkalu ajaa vielä kerran täysympyrän sisäänpistossa jääneen materiaalin poistamiseksi.
step-return-to-centre-of-hole = Ohjaus siirtää työkalun takaisin reiän keskelle.
step-rapid-back-to-clearance = Työkalu palaa pikaliikkeellä (FMAX) varmuusetäisyydelle { $q-set-up-clearance }.
guard-tool-wider-than-hole = Reiän halkaisija on pienempi kuin työkalun halkaisija.
guard-hole-too-wide-for-tool = Reikä on yli kaksi kertaa niin leveä kuin työkalu. Anna esiporatun reiän halkaisija tai käytä suurempaa työkalua.
note-equal-diameters-are-drilled = Jos annettu reiän halkaisija on sama kuin työkalun halkaisija, ohjaus poraa ilman kierukkainterpolaatiota suoraan annettuun syvyyteen.
note-mirroring-keeps-milling-type = Voimassa oleva peilaus ei muuta työkierrossa määriteltyä jyrsintämenetelmää.
note-infeed-too-large-does-damage = Liian suuri asetusliike vahingoittaa sekä työkalua että työkappaletta.
note-plunging-angle-limits-infeed = Vältä liian suuret asetusliikkeet antamalla työkalun suurin mahdollinen sisäänpistokulma työkalutaulukon sarakkeessa { $mp-plunging-angle }. Silloin ohjaus laskee itse suurimman sallitun asetusliikkeen ja muuttaa tarvittaessa annettua arvoa.

# --- 241 ---
cycle-single-lip-drilling = Yksihuulisyväporaus
    .nc = YKSIHUULISYVÄPORAUS
    .purpose = Työkierto poraa reiän yksihuulisella syväporalla, myös työkappaleen yläpinnan alapuolella olevasta alkupisteestä. Sisään- ja ulosajolla on oma kierrosluku ja pyörintäsuunta, ja jäähdytys kytketään M-toiminnoilla.
step-feed-in-and-switch-on = Ohjaus siirtää työkalun esipaikoituksen syöttöarvolla { $q-pre-positioning-feed } varmuusetäisyydelle syvennetyn alkupisteen { $q-deepened-starting-point } yläpuolelle ja kytkee siellä päälle karan porauksen kierrosluvulla { $q-drilling-speed } (M3) ja jäähdytyksen toiminnolla { $q-coolant-on-function }. Sisäänajossa kara pyörii parametrin { $q-rotation-in-and-out } mukaan myötäpäivään tai vastapäivään kierrosluvulla { $q-speed-in-and-out } tai seisoo paikallaan.
step-drill-in-one-infeed = Työkalu poraa syöttöarvolla { $q-plunging-feed } syvyyteen { $q-depth }.
step-switch-off-coolant-and-reset-speed = Ohjaus kytkee jäähdytyksen pois päältä toiminnolla { $q-coolant-off-function } ja palauttaa kierrosluvun ulosajon arvoon { $q-speed-in-and-out }.
