# Porauksen, kierreporauksen ja kierteen jyrsinnän parametrit: nimi, teksti NC-lauseessa, ohje.

# --- muidenkin työkiertojen parametrit ---
parameter-depth__reaming =
    .help = Työkappaleen yläpinnan ja reiän pohjan välinen etäisyys.
parameter-depth__boring =
    .help = Työkappaleen yläpinnan ja reiän pohjan välinen etäisyys.
parameter-depth__bore-milling =
    .help = Työkappaleen yläpinnan ja reiän pohjan välinen etäisyys.
parameter-depth__single-lip-drilling =
    .help = Työkappaleen yläpinnan ja reiän pohjan välinen etäisyys.
parameter-depth__centring =
    .help = Työkappaleen yläpinnan ja keskiön pohjan välinen etäisyys keskiökartion kärkeen mitattuna. Vaikuttaa vain, jos { $q-depth-or-diameter } = 0.
parameter-plunging-depth__universal-drilling =
    .help = Matka, jonka työkalu etenee yhdellä asetusliikkeellä. Syvyyden ei tarvitse olla sen monikerta. Työkalu ajaa syvyyteen yhdellä liikkeellä, jos asetussyvyys on yhtä suuri kuin syvyys tai jos se on suurempi eikä lastunkatkoa ole määritelty.
parameter-chip-breaking-retraction__universal-drilling =
    .help = Matka, jonka työkalu vetäytyy lastun katkaisemiseksi.
parameter-plunging-feed__reaming =
    .help = Työkalun liikenopeus kalvinnassa.
parameter-plunging-feed__boring =
    .help = Työkalun liikenopeus väljennyksessä.
parameter-plunging-feed__bore-milling =
    .help = Työkalun liikenopeus jyrsittäessä kierukkarataa.
parameter-plunging-feed__centring =
    .help = Työkalun liikenopeus keskiöinnissä.
parameter-set-up-clearance__bore-milling =
    .help = Työkalun alareunan ja työkappaleen yläpinnan välinen etäisyys.
parameter-milling-type__bore-milling =
    .help = Jyrsinnän laji karan pyöriessä myötäpäivään (M3).
parameter-deepened-starting-point__single-lip-drilling =
    .help = Varsinaisen porauksen alkupiste työkappaleen yläpinnasta mitattuna. Työkalu siirtyy sinne varmuusetäisyydeltä esipaikoituksen syöttöarvolla { $q-pre-positioning-feed }.

# --- poraus ---
parameter-retraction-feed = Vetäytymisen syöttöarvo
    .label = VETÄYTYMISEN SYÖTTÖARVO
    .help = Työkalun liikenopeus, kun se poistuu reiästä. Arvolla 0 se poistuu syöttöarvolla { $q-plunging-feed }.
parameter-chip-breaks-before-retraction = Lastunkatkojen lukumäärä ennen vetäytymistä
    .label = LASTUNKATKOJEN LKM
    .help = Kuinka monta kertaa lastu katkaistaan, ennen kuin työkalu vedetään reiästä jäähtymään. Lastun katkaisemiseksi työkalu vetäytyy matkan { $q-chip-breaking-retraction }.
parameter-depth-or-diameter = Syvyyden tai halkaisijan valinta
    .label = SYVYYS/HALKAISIJA
    .help = Keskiöidäänkö annettuun syvyyteen vai annettuun halkaisijaan. Halkaisijaa varten työkalun kärkikulma on määriteltävä työkalutaulukon sarakkeessa { $mp-drill-point-angle }.
parameter-centring-diameter = Halkaisija (etumerkki)
    .label = HALKAISIJA
    .help = Keskiöhalkaisija; etumerkki määrää työskentelysuunnan. Vaikuttaa vain, jos { $q-depth-or-diameter } = 1.
parameter-disengaging-direction = Irtiajosuunta
    .label = IRTIAJOSUUNTA
    .help = Suunta, johon ohjaus ajaa työkalun irti reiän pohjalla karan suuntauksen jälkeen.
parameter-disengaging-direction__back-boring =
    .help = Suunta, johon ohjaus siirtää työkalua epäkeskomitan verran karan suuntauksen jälkeen. Arvo 0 ei ole sallittu.
parameter-spindle-orientation-angle = Karan suuntauskulma
    .label = KARAN KULMA
    .help = Kulma, johon ohjaus suuntaa työkalun ennen irtiajoa.
parameter-spindle-orientation-angle__back-boring =
    .help = Kulma, johon ohjaus suuntaa työkalun ennen reikään menoa ja ennen reiästä poistumista.
parameter-counterbore-depth = Upotussyvyys
    .label = UPOTUSSYVYYS
    .help = Työkappaleen alareunan ja upotuksen lopun välinen etäisyys. Positiivisella etumerkillä upotetaan karan akselin positiiviseen suuntaan.
parameter-material-thickness = Materiaalin paksuus
    .label = MATERIAALIN PAKSUUS
    .help = Työkappaleen paksuus.
parameter-off-centre-distance = Epäkeskomitta
    .label = EPÄKESKOMITTA
    .help = Poratangon epäkeskomitta työkalun tietolehdestä.
parameter-cutting-edge-height = Terän korkeus
    .label = TERÄN KORKEUS
    .help = Poratangon alareunan ja pääterän välinen etäisyys työkalun tietolehdestä.
parameter-counterbore-dwell = Odotusaika
    .label = ODOTUSAIKA
    .help = Aika, jonka työkalu viipyy upotuksen lopussa.
parameter-infeed-per-helix = Asetus kierukkaa kohti
    .label = ASETUSSYVYYS
    .help = Matka, jonka työkalu etenee yhdellä kierukan kierroksella (360°).
parameter-nominal-diameter = Nimellishalkaisija
    .label = NIMELLISHALKAISIJA
    .help = Kierteen halkaisija.
parameter-nominal-diameter__bore-milling =
    .help = Reiän halkaisija. Jos se on sama kuin työkalun halkaisija, ohjaus poraa ilman kierukkainterpolaatiota suoraan annettuun syvyyteen.
parameter-pre-drilled-diameter = Esiporatun reiän halkaisija
    .label = ESIPORATTU HALKAISIJA
    .help = Jos annettu arvo on suurempi kuin 0, ohjaus ei tarkasta reiän halkaisijan ja työkalun halkaisijan suhdetta. Näin voidaan jyrsiä reikiä, jotka ovat yli kaksi kertaa työkalun levyisiä.
parameter-rotation-in-and-out = Pyörintäsuunta sisään- ja ulosajossa
    .label = KARAN PYÖRINTÄSUUNTA
    .help = Suunta, johon työkalu pyörii ajaessaan reikään ja poistuessaan siitä.
parameter-speed-in-and-out = Karan kierrosluku sisään- ja ulosajossa
    .label = KIERROSLUKU SISÄÄN/ULOS
    .help = Kierrosluku, jolla työkalu pyörii ajaessaan reikään ja poistuessaan siitä.
parameter-drilling-speed = Porauksen kierrosluku
    .label = PORAUKSEN KIERROSLUKU
    .help = Kierrosluku, jolla työkalu poraa.
parameter-coolant-on-function = M-toiminto: jäähdytys päälle
    .label = JÄÄHDYTYS PÄÄLLE
    .help = Lisätoiminto M, joka kytkee jäähdytyksen päälle. Ohjaus kytkee sen päälle, kun työkalu on reiässä syvennetyssä alkupisteessä.
parameter-coolant-off-function = M-toiminto: jäähdytys pois
    .label = JÄÄHDYTYS POIS
    .help = Lisätoiminto M, joka kytkee jäähdytyksen pois päältä. Ohjaus kytkee sen pois, kun työkalu on reiän syvyydessä.

# --- upotus, kierreporaus ja kierteen jyrsintä ---
parameter-in-and-out-feed = Esipaikoituksen syöttöarvo
    .label = ESIPAIK. SYÖTTÖARVO
    .help = Työkalun liikenopeus, kun se ajaa työkappaleeseen tai poistuu siitä.
parameter-countersinking-feed = Upotuksen syöttöarvo
    .label = UPOTUKSEN SYÖTTÖARVO
    .help = Työkalun liikenopeus upotuksessa.

# --- vaihtoehdot ---
choice-centre-to-entered-depth = Keskiöinti annettuun syvyyteen
choice-centre-to-entered-diameter = Keskiöinti annettuun halkaisijaan
choice-no-disengagement = Ei työkalun irtiajoa
choice-disengage-minus-main = Työkalun irtiajo pääakselin negatiiviseen suuntaan
choice-disengage-minus-minor = Työkalun irtiajo sivuakselin negatiiviseen suuntaan
choice-disengage-plus-main = Työkalun irtiajo pääakselin positiiviseen suuntaan
choice-disengage-plus-minor = Työkalun irtiajo sivuakselin positiiviseen suuntaan
choice-in-and-out-clockwise = Kara pyörii koodilla M3
choice-in-and-out-counter-clockwise = Kara pyörii koodilla M4
choice-in-and-out-standing = Ajo karan seistessä
