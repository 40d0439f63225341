## Miksi ajo päättyy ennen loppuaan.

diag-angle-missing = Ympyrältä puuttuu kulma PA.
diag-axis-limit = Akseli { $axis } siirtyisi asemaan { NUMBER($found) }{"\u00A0"}{ $unit }, koneen rajojen { NUMBER($min) } … { NUMBER($max) }{"\u00A0"}{ $unit } ulkopuolelle.
diag-block-limit = Suoritus päättyy: yli { NUMBER($limit) } lausetta on suoritettu.
diag-block-unreadable = Lausetta ei voi lukea: { $found }
diag-call-depth-limit = Kutsuja on sisäkkäin yli { NUMBER($limit) } tasoa.
related-called-here = kutsuttu tässä
diag-collision = Törmäys: kosketusvarsi koskettaa työkappaletta muussa kuin kosketusliikkeessä, kohdassa X { NUMBER($x) } Y { NUMBER($y) } Z { NUMBER($z) }.
diag-conform-no-value = Tapaus ei anna arvoa parametrille { $name }, eikä kuvauksessa ole esimerkkiarvoa.
diag-conform-unknown-clause = Tapauksen pitäisi todistaa kohta { $name }, jota työkierrossa { $cycle } ei ole.
diag-cycle-depth-limit = Työkiertoja on sisäkkäin yli { NUMBER($limit) } tasoa.
diag-cycle-error = Työkierto keskeytyy virheeseen { $code }.
diag-cycle-unknown = Ohjauksen { $control } käsikirjat eivät kuvaa työkiertoa { $cycle }: sitä ei voi simuloida.
diag-direction-contradicts = Inkrementaalisen kulman etumerkki on ristiriidassa kiertosuunnan DR kanssa.
diag-direction-missing = Ympyrältä puuttuu kiertosuunta DR.
diag-direction-undefined = Kahden pisteen väli on vain { NUMBER($distance) }{"\u00A0"}mm: ne eivät määrää suuntaa.
diag-division-by-zero = Jako nollalla.
diag-elements-overlap = Muodon kahden nurkan elementit menevät päällekkäin: ne tarvitsevat väliinsä jäävästä sivusta yhteensä { NUMBER($least) }{"\u00A0"}mm, ja sen pituus on { NUMBER($found) }{"\u00A0"}mm.
diag-end-off-circle = Loppupiste ei ole ympyrällä: säde alussa { NUMBER($start_radius, maximumFractionDigits: 4) }{"\u00A0"}mm, lopussa { NUMBER($end_radius, maximumFractionDigits: 4) }{"\u00A0"}mm.
diag-feed-missing = Arvoa 0 suurempaa syöttöarvoa ei ole voimassa.
diag-field-missing = Työkierrosta { $cycle } puuttuu kenttä { $field }.
diag-field-unknown = Työkierrossa { $cycle } ei ole tällaista kenttää: { $found }
diag-fit-collinear = Kosketuspisteet ({ NUMBER($points) }) ovat samalla suoralla: mikään ympyrä ei sovi niihin.
diag-fit-failed = Kosketuspisteisiin ({ NUMBER($points) }) ei voi sovittaa ympyrää.
diag-fit-too-few = Kosketuspisteitä on liian vähän ympyrää varten: { NUMBER($points) }.
diag-infeeds-never-reach-depth = Asetusliikkeet eivät koskaan saavuta syvyyttä { NUMBER($depth) }{"\u00A0"}mm: ensimmäinen on { NUMBER($first) }{"\u00A0"}mm, kukin seuraava on { NUMBER($less) }{"\u00A0"}mm pienempi, pienin on { NUMBER($least) }{"\u00A0"}mm; ne päättyvät syvyyteen { NUMBER($reached) }{"\u00A0"}mm.
diag-insert-askew = Sorvaustyökiertoja ei voi simuloida, kun työkalu on kallistettu ja M144, M128 tai FUNCTION TCPM on voimassa.
diag-insert-direction = Työkalun { $tool } teräpala ei osoita kappaletta eikä lastujen suuntaan: sen suunta (TO) on { $orientation }.
diag-jump-limit = Suoritus päättyy: hyppyjä, toistoja ja kutsuja on suoritettu yli { NUMBER($limit) }.
diag-jump-target-missing = Labelia { $label } ei ole.
diag-jump-target-twice = Label { $label } on ohjelmassa kahdesti.
diag-kinematics-unknown = Lauseen FUNCTION MODE jälkeen nimetty kinematiikka ”{ $name }” ei ole simuloidun koneen ”{ $machine }” kinematiikka.
diag-lines-parallel = Suorat ovat yhdensuuntaiset: niillä ei ole leikkauspistettä.
diag-log-failed = Pöytäkirjaa { $name } ei voi kirjoittaa: { $reason }
diag-log-template = Pöytäkirjalla { $name } ei ole mallia.
diag-log-text = Pöytäkirjan teksti { $name } puuttuu ({ $reason }).
diag-machine-parameter-missing = Koneparametria { $name } ja sen kolmea koordinaattia ei ole määritelty.
diag-milling-mode-missing = { $cycle } suoritetaan vain jyrsintäkäytössä, mutta voimassa on sorvauskäyttö (FUNCTION MODE TURN).
diag-move-limit = Suoritus päättyy: työkalun liikkeitä on suoritettu yli { NUMBER($limit) }.
diag-no-cycle-to-call = Työkierto kutsutaan, mutta koneistustyökiertoa ei ole määritelty.
diag-no-such-parameter = Parametria { $q } ei ole.
diag-number-too-large = Tulos on liian suuri lukumuotoon.
diag-orientation-missing = Sädekorjaus sorvauksessa tarvitsee työkalun { $tool } suunnan (TO): se kertoo, missä kärki on nirkon keskipisteestä.
diag-outside-domain = Funktiota { $function } ei ole määritelty arvolle { NUMBER($value) }.
diag-parameter-missing = Työkierrosta { $cycle } puuttuu { $q }.
diag-parameter-out-of-range = Parametri { $q } ei hyväksy arvoa { NUMBER($value) }.
diag-parameter-undefined = Parametrilla { $q } ei ole arvoa.
diag-parameter-in-addition = { $q } työkierrossa { $cycle } kuuluu uudempaan ohjelmistoversioon kuin tässä kuvattu; sen vaikutusta ei tunneta.
diag-parameter-unknown = Työkierrossa { $cycle } ei ole parametria { $q }.
diag-plan-mistake = Työkierron { $cycle } kuvauksessa on virhe: { $reason }
diag-plane-through-line = Kolme pistettä on samalla suoralla: ne eivät määritä tasoa.
diag-pole-missing = Ympyrän keskipistettä tai napaa (CC) ei ole määritelty.
diag-probe-deflected = Kosketusvarsi on taipunut jo ennen kosketuksen alkua.
diag-probe-measurements-differ = Saman pisteen mittaukset eroavat { NUMBER($found) }{"\u00A0"}mm; suoja-alue on { NUMBER($range) }{"\u00A0"}mm.
diag-probe-missing = Karassa ei ole kosketusjärjestelmää.
diag-probe-no-contact = Kosketusjärjestelmä ei kosketa mitään { NUMBER($distance) }{"\u00A0"}mm:n matkalla.
diag-probe-no-direction = Kosketusvarsi on jo kosketettavassa pisteessä, joten kosketussuuntaa ei ole.
diag-program-missing = Ohjelmaa { $name } ei ole.
diag-radius-missing = Tästä lauseesta puuttuu säde R.
diag-radius-too-small = Säde { NUMBER($radius) }{"\u00A0"}mm ei riitä jänteelle { NUMBER($chord, maximumFractionDigits: 4) }{"\u00A0"}mm.
diag-recess-impossible = Uralle ei ole tilaa, sen keskikohta, syvyys tai leveys puuttuu, tai se ei ole suorassa elementissä.
diag-recursive-call = Ohjelmanosa kutsuu itseään.
diag-repeat-count = REP vaatii kokonaisluvun väliltä 0–65534; annettu luku on { NUMBER($found) }.
diag-rotary-axis-missing = Koneessa ei ole kiertoakselia { $axis }.
diag-rotary-axis-unsuitable = Kiertoakseli { $axis } ei käänny vinon asennon tasossa eikä voi kompensoida vinoa asentoa.
diag-series-count = Toistojen määrän on oltava kokonaisluku eikä negatiivinen, ei { NUMBER($found) }.
diag-series-limit = Työkierto toistaisi vaiheensa yli { NUMBER($limit) } kertaa.
diag-strategy-argument = Strategian argumentti puuttuu.
diag-text-or-number = Teksti on luvun paikalla tai päinvastoin.
diag-text-too-long = Merkkijonoparametrissa olisi yli { NUMBER($limit) } merkkiä.
diag-tool-locked = Työkalulle { $tool } on asetettu esto.
diag-tool-not-in-table = Työkalua { $tool } ei ole työkalutaulukossa.
diag-turn-limit = Suoritus päättyy: yhdessä liikkeessä on yli { NUMBER($limit) } kierrosta.
diag-undercut-form = Lausetta UDC { $form } ei voi simuloida: mikään käsikirja ei kuvaa sen muotoa.
diag-undercut-impossible = Takaleikkaukselle ei ole tilaa, siltä puuttuu mitta, tai se ei ole kiertoakselin suuntaisen pinnan ja sitä vastaan kohtisuoran otsapinnan välissä.
diag-unsupported-axis = Simuloidussa koneessa ei ole akselia { $axis }.
diag-unsupported-block = Lausetta { $word } ei voi simuloida.
diag-unsupported-cycle = Ohjauksen { $control } käsikirja vain mainitsee työkierron { $cycle } nimeltä: sitä ei voi simuloida.
diag-unsupported-feed = Tätä työkalukutsun syöttöarvoa ei voi simuloida: { $word }
diag-unsupported-m = M-toimintoa { $word } ei voi simuloida.
diag-unsupported-path = Toimintoa { $word } ei voi simuloida tässä lauseessa.
diag-unsupported-tcpm = Kun TCPM on voimassa, kosketusjärjestelmä ei ole kohtisuorassa koneistustasoa vastaan; työkiertoa { $cycle } ei voi silloin simuloida.
diag-unsupported-transformation = Liikkeitä ei voi simuloida, kun tämä muunnos on voimassa: { $name }
diag-value-missing = Arvo puuttuu tai ei ole luku.
diag-value-not-bound = Kuvauksen kaava lukee arvon, jota ei vielä ole: { $place }
diag-word-not-offered = Sana { $word } ei ole sallittu tässä.
diag-arc-scaled-unequally = Tason akseleilla on eri mittakertoimet: kaaresta tulisi ellipsi.
diag-scaling-factor-zero = Mittakertoimen on oltava suurempi kuin nolla, ei { NUMBER($found) }.
diag-shaft-collision = Kosketusvarren varsiosa osuu työkappaleeseen kohdassa X { NUMBER($x) } Y { NUMBER($y) } Z { NUMBER($z) }.
diag-shape-impossible = Tämä työkalu ei voi koneistaa muotoa: tarvitaan vähintään { NUMBER($least) }{"\u00A0"}mm, käytettävissä on { NUMBER($found) }{"\u00A0"}mm.
diag-cutting-width-missing = Työkalu { $tool } ei ole pistotyökalu: terän leveyden (CUTWIDTH) on oltava suurempi kuin 0 ja vähintään kaksi kertaa teräsäde (RS).
diag-m144-together = M144 ei voi olla voimassa yhdessä toiminnon { $word } kanssa.
diag-spline-start = Spline alkaa { NUMBER($distance, maximumFractionDigits: 4) }{"\u00A0"}mm tai astetta hetkellisasemasta; sallittu ero on 0,001.
diag-tool-direction-unreachable = Koneen kiertoakselit eivät voi kääntää työkalua tässä lauseessa annettuun suuntaan.
diag-tilting-unreachable = Koneen kiertoakselit eivät voi asettaa työkalua kohtisuoraan tätä tasoa vastaan.
diag-pattern-missing =
    { $name ->
        [none] Työkierron kutsua varten ei ole määritelty pistekuviota eikä pistetaulukkoa.
       *[other] Pistetaulukkoa ”{ $name }” ei ole.
    }
diag-pattern-too-long = PATTERN DEF hyväksyy enintään { $limit } yksittäistä paikkaa; tässä niitä on { $count }.
diag-pattern-tool-axis = Pistekuviot toimivat vain työkaluakselilla Z; voimassa oleva työkaluakseli on { $axis }.
diag-pattern-unreadable = ”{ $found }” ei kelpaa PATTERN DEF -lauseeseen.
diag-position-incomplete = CYCL CALL POS vaatii kaikkien kolmen akselin koordinaatit.
diag-value-not-predefined = Arvoksi on ohjelmoitu PREDEF, mutta mikään GLOBAL DEF ei ole määritellyt arvoa.
diag-contour-crossing = Aliohjelman { $label } muoto leikkaa tai sivuaa itseään kohdassa: pääakseli { NUMBER($x) } mm, sivuakseli { NUMBER($y) } mm.
diag-contour-begin-incomplete = Muodon { $label } alussa ei ole koneistustason kumpaakin koordinaattia.
diag-contour-data-undefined = Mikään työkierto ei ole vielä määritellyt muototietoja.
diag-contour-count = Muoto koostuu yli { NUMBER($limit) } osamuodosta.
diag-contour-depth =
    { $what ->
        [first] Osamuoto on syvempi kuin lauseen CONTOUR DEF ensimmäinen osamuoto, jonka on oltava syvin tasku.
       *[cycle] Osamuodon syvyys on { NUMBER($depth) } mm: se on syvempi kuin muototietojen jyrsintäsyvyys.
    }
diag-contour-elements = Muodoissa on yhteensä yli { NUMBER($limit) } muotoelementtiä.
diag-contour-empty = Labelin { $label } aliohjelma ei kuvaa muotoa, joka rajaa alueen.
diag-contour-lead = Työkierron koneistamassa muodossa ei voi olla lausetta { $word }: työkierto ajaa itse muotoon ja pois siitä.
diag-contour-not-defined = Mikään työkierto ei ole vielä nimennyt muodon aliohjelmia.
diag-contour-open = Labelin { $label } muoto on avoin: se päättyy { NUMBER($distance) } mm:n päähän alkupisteestään.
diag-contour-side-missing = Labelin { $label } muodosta puuttuu sädekorjaus RL tai RR, joka kertoo, onko se tasku vai saareke.
diag-contour-tool-axis = Labelin { $label } muodossa on työkaluakselin koordinaatti.
diag-free-contour-contradicts = Mikään muoto ei täytä kaikkia arvoja, jotka tästä elementistä ja sitä edeltävistä on annettu.
diag-free-contour-open =
    { $what ->
        [line] Tämän suoran paikka tai suunta ei määräydy. Arvoja puuttuu vielä: { $values }.
        [arc] Tämän kaaren keskipiste tai säde ei määräydy. Arvoja puuttuu vielä: { $values }.
       *[end] Tämän elementin loppupiste ei määräydy. Arvoja puuttuu vielä: { $values }.
    }
diag-free-contour-reference = Lause { $block } ei ole tämän vapaan muodon elementti eikä sitä edeltävä paikoituslause.
diag-free-contour-selection = Valinta FSELECT { $wanted } ei ole mahdollinen: ratkaisujen määrä tässä on { $solutions }.
diag-free-contour-several = Vapaalla muodolla on tästä elementistä alkaen useita ratkaisuja ({ $solutions }), eikä niistä ole valittu yhtäkään sanalla FSELECT.
diag-free-contour-word = Sanaa { $word } ei voi käyttää vapaassa muodossa näin.
