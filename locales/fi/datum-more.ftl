# Muut työkierrot, jotka asettavat peruspisteen.

# --- 410 ja 411 ---
cycle-datum-inside-rectangle = Peruspisteen asetus suorakulmion sisään
    .nc = PERUSP. SUORAK. SISÄP.
    .nc-aliases = PERUSP SUORAK SISÄP
    .purpose = Mittaa suorakulmataskun keskipisteen ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa keskipisteen myös nollapiste- tai esiasetustaulukkoon.
cycle-datum-inside-rectangle__tnc426-430 =
    .purpose = Mittaa suorakulmataskun keskipisteen ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa keskipisteen myös nollapistetaulukkoon.
cycle-datum-outside-rectangle = Peruspisteen asetus suorakulmion ulkopuolelle
    .nc = PERUSP. SUORAK. ULKOP.
    .nc-aliases = PERUSP SUORAK ULKOP
    .purpose = Mittaa suorakulmakaulan keskipisteen ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa keskipisteen myös nollapiste- tai esiasetustaulukkoon.
cycle-datum-outside-rectangle__tnc426-430 =
    .purpose = Mittaa suorakulmakaulan keskipisteen ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa keskipisteen myös nollapistetaulukkoon.
step-probe-first-point = Kosketusjärjestelmä tekee ensimmäisen kosketuksen kosketussyöttöarvolla (sarake { $mp-probing-feed }).
step-probe-first-point__tnc426-430 = Kosketusjärjestelmä tekee ensimmäisen kosketuksen kosketussyöttöarvolla ({ $mp-probing-feed } tai { $mp-analog-probing-feed }).
step-travel-to-second-touch-point = Kosketusjärjestelmä siirtyy toiseen kosketuspisteeseen:
say-travel-linearly-at-clearance-height = jos { $q-traverse-to-clearance-height } = 1, suoraa pitkin varmuuskorkeudella { $q-clearance-height }
say-travel-paraxially-at-measuring-height = jos { $q-traverse-to-clearance-height } = 0, akselin suuntaisesti mittauskorkeudella { $q-measuring-height }
step-probe-second-point = Kosketusjärjestelmä tekee siellä toisen kosketuksen.
step-probe-third-and-fourth-point = Ohjaus paikoittaa kosketusjärjestelmän kolmanteen ja sen jälkeen neljänteen kosketuspisteeseen ja tekee niissä kolmannen ja neljännen kosketuksen.
step-retract-and-treat-datum = Ohjaus palauttaa kosketusjärjestelmän varmuuskorkeudelle { $q-clearance-height } ja käsittelee mitatun peruspisteen parametrien { $q-measured-value-transfer } ja { $q-datum-row-number } mukaan:
step-retract-and-treat-datum__tnc426-430 = Ohjaus palauttaa kosketusjärjestelmän varmuuskorkeudelle { $q-clearance-height } ja käsittelee mitatun peruspisteen parametrin { $q-datum-row-number } mukaan:
step-store-actual-values = Ohjaus tallentaa todellisarvot tulosparametreihin.
note-pocket-sides-rather-small = Törmäysvaara! Jotta kosketusjärjestelmä ja työkappale eivät törmää, anna taskun 1. ja 2. sivun pituudeksi mieluummin liian pieni kuin liian suuri arvo.
note-stud-sides-rather-large = Törmäysvaara! Jotta kosketusjärjestelmä ja työkappale eivät törmää, anna kaulan 1. ja 2. sivun pituudeksi mieluummin liian suuri kuin liian pieni arvo.
title-introduction-to-probing = Kosketustyökiertojen johdannon NC-lause

# --- 413 ---
cycle-datum-outside-circle = Peruspisteen asetus ympyrän ulkopuolelle (tappi)
    .nc = PERUSP. YMP. ULKOP.
    .nc-aliases = PERUSP YMPYRÄ ULKOP
    .purpose = Mittaa ympyräkaulan keskipisteen ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa keskipisteen myös nollapiste- tai esiasetustaulukkoon.
cycle-datum-outside-circle__tnc426-430 =
    .purpose = Mittaa ympyräkaulan keskipisteen ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa keskipisteen myös nollapistetaulukkoon.
note-stud-diameter-rather-large = Törmäysvaara! Jotta kosketusjärjestelmä ja työkappale eivät törmää, anna kaulan asetushalkaisijaksi mieluummin liian suuri kuin liian pieni arvo.
note-small-stepping-angle-less-exact__datum-outside-circle = Mitä pienempi kulma-askel { $q-probing-stepping-angle } on, sitä epätarkemmin ohjaus laskee peruspisteen.
title-datum-at-arc-centre-and-top = Peruspisteen asetus ympyräsegmentin keskipisteeseen ja työkappaleen yläpintaan

# --- tulokset ---
result-side-main-actual = Sivun pituuden todellisarvo pääakselilla
result-side-minor-actual = Sivun pituuden todellisarvo sivuakselilla
result-slot-width-actual = Mitatun uran leveyden todellisarvo
result-ridge-width-actual = Mitatun uuman leveyden todellisarvo
result-centre-axis-actual = Keskiakselin sijainnin todellisarvo
result-corner-main-actual = Nurkan todellisarvo pääakselilla
result-corner-minor-actual = Nurkan todellisarvo sivuakselilla

# --- 408 ja 409 ---
cycle-datum-slot-centre = Peruspiste uran keskipiste
    .nc = PERUSP. URAN KESKIP
    .nc-aliases = PERUSP URAN KESK
cycle-datum-ridge-centre = Peruspisteen asetus uuman keskelle
    .nc = PERUSP. UUMAN KESKIP
    .nc-aliases = PERUSP UUMAN KESK

# --- 414 ja 415 ---
cycle-datum-outside-corner = Peruspisteen asetus nurkan ulkopuolelle
    .nc = PERUSP. NURKAN SISÄP.
    .nc-aliases = PERUSP NURKKA ULKOP
cycle-datum-inside-corner = Peruspisteen asetus nurkan sisään
    .nc = PERUSP. NURKAN ULKOP.
    .nc-aliases = PERUSP NURKKA SISÄP
