# Muut työkierrot, jotka asettavat peruspisteen.

# --- 410 ja 411 ---
cycle-datum-inside-rectangle = Peruspisteen asetus suorakulmion sisään
    .nc = PERUSP. SUORAK. SISÄP.
    .nc-aliases = PERUSP SUORAK SISÄP
    .purpose = Työkierto mittaa suorakulmataskun keskipisteen ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa keskipisteen myös nollapiste- tai esiasetustaulukkoon.
cycle-datum-inside-rectangle__tnc426-430 =
    .purpose = Työkierto mittaa suorakulmataskun keskipisteen ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa keskipisteen myös nollapistetaulukkoon.
cycle-datum-outside-rectangle = Peruspisteen asetus suorakulmion ulkopuolelle
    .nc = PERUSP. SUORAK. ULKOP.
    .nc-aliases = PERUSP SUORAK ULKOP
    .purpose = Työkierto mittaa suorakulmakaulan keskipisteen ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa keskipisteen myös nollapiste- tai esiasetustaulukkoon.
cycle-datum-outside-rectangle__tnc426-430 =
    .purpose = Työkierto mittaa suorakulmakaulan keskipisteen ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa keskipisteen myös nollapistetaulukkoon.
step-probe-first-point = Kosketusjärjestelmä tekee ensimmäisen kosketuksen kosketussyöttöarvolla (sarake { $mp-probing-feed }).
step-probe-first-point__tnc426-430 = Kosketusjärjestelmä tekee ensimmäisen kosketuksen kosketussyöttöarvolla ({ $mp-probing-feed } tai { $mp-analog-probing-feed }).
step-travel-to-second-touch-point = Kosketusjärjestelmä siirtyy toiseen kosketuspisteeseen:
say-travel-linearly-at-clearance-height = jos { $q-traverse-to-clearance-height } = 1, suoraa pitkin varmuuskorkeudella { $q-clearance-height }
say-travel-paraxially-at-measuring-height = jos { $q-traverse-to-clearance-height } = 0, akselin suuntaisesti mittauskorkeudella { $q-measuring-height }
step-probe-second-point = Kosketusjärjestelmä tekee siellä toisen kosketuksen.
step-probe-third-and-fourth-point = Ohjaus paikoittaa kosketusjärjestelmän kolmanteen ja sen jälkeen neljänteen kosketuspisteeseen ja tekee niissä kolmannen ja neljännen kosketuksen.
step-retract-and-treat-datum = Ohjaus palauttaa kosketusjärjestelmän varmuuskorkeudelle { $q-clearance-height } ja asettaa tai tallentaa mitatun peruspisteen parametrien { $q-measured-value-transfer } ja { $q-datum-row-number } mukaan:
step-retract-and-treat-datum__tnc426-430 = Ohjaus palauttaa kosketusjärjestelmän varmuuskorkeudelle { $q-clearance-height } ja asettaa tai tallentaa mitatun peruspisteen parametrin { $q-datum-row-number } mukaan:
step-store-actual-values = Ohjaus tallentaa todellisarvot tulosparametreihin.
note-pocket-sides-rather-small = Törmäysvaara! Jotta kosketusjärjestelmä ja työkappale eivät törmää, anna taskun 1. ja 2. sivun pituudeksi mieluummin liian pieni kuin liian suuri arvo.
note-stud-sides-rather-large = Törmäysvaara! Jotta kosketusjärjestelmä ja työkappale eivät törmää, anna kaulan 1. ja 2. sivun pituudeksi mieluummin liian suuri kuin liian pieni arvo.
title-introduction-to-probing = Toinen esimerkki

# --- 413 ---
cycle-datum-outside-circle = Peruspisteen asetus ympyrän ulkopuolelle (kaula)
    .nc = PERUSP. YMP. ULKOP.
    .nc-aliases = PERUSP YMPYRÄ ULKOP
    .purpose = Työkierto mittaa ympyräkaulan keskipisteen ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa keskipisteen myös nollapiste- tai esiasetustaulukkoon.
cycle-datum-outside-circle__tnc426-430 =
    .purpose = Työkierto mittaa ympyräkaulan keskipisteen ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa keskipisteen myös nollapistetaulukkoon.
note-stud-diameter-rather-large = Törmäysvaara! Jotta kosketusjärjestelmä ja työkappale eivät törmää, anna kaulan asetushalkaisijaksi mieluummin liian suuri kuin liian pieni arvo.
note-small-stepping-angle-less-exact__datum-outside-circle = Mitä pienempi kulma-askel { $q-probing-stepping-angle } on, sitä epätarkemmin ohjaus laskee peruspisteen.
title-datum-at-arc-centre-and-top = Peruspisteen asetus ympyräsegmentin keskipisteeseen ja työkappaleen yläpintaan
title-datum-at-arc-centre-and-top__tnc426-430 = Peruspisteen asetus ympyräsegmentin keskipisteeseen

# --- tulokset ---
result-side-main-actual = Sivun pituuden todellisarvo pääakselilla
result-side-minor-actual = Sivun pituuden todellisarvo sivuakselilla
result-slot-width-actual = Mitatun uran leveyden todellisarvo
result-ridge-width-actual = Mitatun uuman leveyden todellisarvo
result-centre-axis-actual = Keskiakselin sijainnin todellisarvo
result-corner-main-actual = Nurkan todellisarvo pääakselilla
result-corner-minor-actual = Nurkan todellisarvo sivuakselilla

# --- 408 ja 409 ---
cycle-datum-slot-centre = Peruspisteen asetus uran keskelle
    .nc = PERUSP. URAN KESKIP
    .nc-aliases = PERUSP URAN KESK
    .purpose = Työkierto mittaa uran keskipisteen ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa keskipisteen myös nollapiste- tai esiasetustaulukkoon.
cycle-datum-ridge-centre = Peruspisteen asetus uuman keskelle
    .nc = PERUSP. UUMAN KESKIP
    .nc-aliases = PERUSP UUMAN KESK
    .purpose = Työkierto mittaa uuman keskipisteen ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa keskipisteen myös nollapiste- tai esiasetustaulukkoon.
step-travel-at-clearance-height-to-second = Kosketusjärjestelmä siirtyy varmuuskorkeudella { $q-clearance-height } toiseen kosketuspisteeseen.
say-start-again-from-centre__datum-slot-centre = jos ura ja varmuusetäisyys eivät jätä tilaa esipaikoitukselle kosketuspisteiden lähellä, se pysyy keskipisteessä eikä aja varmuuskorkeudelle
note-slot-width-rather-small = Törmäysvaara! Jotta kosketusjärjestelmä ja työkappale eivät törmää, anna uran leveydeksi mieluummin liian pieni kuin liian suuri arvo.
note-ridge-width-rather-large = Törmäysvaara! Jotta kosketusjärjestelmä ja työkappale eivät törmää, anna uuman leveydeksi mieluummin liian suuri kuin liian pieni arvo.
note-probing-from-centre-if-narrow__datum-slot-centre = Jos uran leveys ja varmuusetäisyys eivät salli esipaikoitusta kosketuspisteiden lähelle, ohjaus aloittaa kosketuksen aina uran keskeltä. Silloin kosketusjärjestelmä ei aja varmuuskorkeudelle mittauspisteiden välillä.
note-feature-content-level-3 = Tämä työkierto on kehitystilan Feature Content Level 3 (FCL 3) toiminto.

# --- 414 ja 415 ---
cycle-datum-outside-corner = Peruspisteen asetus nurkan ulkopuolelle
    .nc = PERUSP. NURKAN SISÄP.
    .nc-aliases = PERUSP NURKKA ULKOP
    .purpose = Työkierto mittaa kaksi suoraa ulkopuolelta ja asettaa niiden leikkauspisteen peruspisteeksi. Haluttaessa ohjaus kirjoittaa leikkauspisteen myös nollapiste- tai esiasetustaulukkoon.
cycle-datum-outside-corner__tnc426-430 =
    .purpose = Työkierto mittaa kaksi suoraa ulkopuolelta ja asettaa niiden leikkauspisteen peruspisteeksi. Haluttaessa ohjaus kirjoittaa leikkauspisteen myös nollapistetaulukkoon.
cycle-datum-inside-corner = Peruspisteen asetus nurkan sisään
    .nc = PERUSP. NURKAN ULKOP.
    .nc-aliases = PERUSP NURKKA SISÄP
    .purpose = Työkierto mittaa kaksi suoraa sisäpuolelta ja asettaa niiden leikkauspisteen peruspisteeksi. Haluttaessa ohjaus kirjoittaa leikkauspisteen myös nollapiste- tai esiasetustaulukkoon.
cycle-datum-inside-corner__tnc426-430 =
    .purpose = Työkierto mittaa kaksi suoraa sisäpuolelta ja asettaa niiden leikkauspisteen peruspisteeksi. Haluttaessa ohjaus kirjoittaa leikkauspisteen myös nollapistetaulukkoon.
step-probe-first-point-by-third-point = Kosketusjärjestelmä tekee ensimmäisen kosketuksen kosketussyöttöarvolla (sarake { $mp-probing-feed }). Ohjaus päättelee kosketussuunnan ohjelmoidusta kolmannesta mittauspisteestä.
step-probe-first-point-by-third-point__tnc426-430 = Kosketusjärjestelmä tekee ensimmäisen kosketuksen kosketussyöttöarvolla ({ $mp-probing-feed } tai { $mp-analog-probing-feed }). Ohjaus päättelee kosketussuunnan ohjelmoidusta kolmannesta mittauspisteestä.
step-probe-first-point-by-corner-number = Kosketusjärjestelmä tekee ensimmäisen kosketuksen kosketussyöttöarvolla (sarake { $mp-probing-feed }). Ohjaus päättelee kosketussuunnan nurkan numerosta { $q-corner-number }.
step-probe-first-point-by-corner-number__tnc426-430 = Kosketusjärjestelmä tekee ensimmäisen kosketuksen kosketussyöttöarvolla ({ $mp-probing-feed } tai { $mp-analog-probing-feed }). Ohjaus päättelee kosketussuunnan nurkan numerosta { $q-corner-number }.
step-retract-and-store-corner = Ohjaus palauttaa kosketusjärjestelmän varmuuskorkeudelle { $q-clearance-height }, tallentaa mitatun nurkan koordinaatit tulosparametreihin ja asettaa tai tallentaa mitatun peruspisteen parametrien { $q-measured-value-transfer } ja { $q-datum-row-number } mukaan:
step-retract-and-store-corner__tnc426-430 = Ohjaus palauttaa kosketusjärjestelmän varmuuskorkeudelle { $q-clearance-height } ja asettaa tai tallentaa mitattujen suorien leikkauspisteen peruspisteeksi parametrin { $q-datum-row-number } mukaan:
step-carry-out-basic-rotation-on-request = Jos { $q-corner-basic-rotation } = 1, ohjaus kompensoi työkappaleen vinon asennon peruskäännöllä.
note-corner-from-first-and-third-point = Mittauspisteiden 1 ja 3 sijainti määrää nurkan, johon ohjaus asettaa peruspisteen. Nurkka A: pisteen 1 X on suurempi ja Y pienempi kuin pisteen 3. Nurkka B: X pienempi, Y pienempi. Nurkka C: X pienempi, Y suurempi. Nurkka D: X suurempi, Y suurempi.
note-first-line-in-secondary-direction = Ohjaus mittaa ensimmäisen suoran aina koneistustason sivuakselin suunnassa.
note-basic-rotation-with-immediate-datum = Anna ohjauksen suorittaa peruskääntö vain, jos peruspiste asetetaan heti, ei silloin, kun se kirjoitetaan nollapistetaulukkoon myöhempää koneistusta varten.
