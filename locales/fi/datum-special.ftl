# Työkierrot, jotka asettavat peruspisteen reikäympyrälle, kosketusakselille, neljän reiän keskelle ja yksittäiselle akselille.

# --- 416 ---
cycle-datum-bolt-hole-circle = Peruspisteen asetus reikäympyrän keskelle
    .nc = PERUSP. REIKÄYMP. KESKIP
    .nc-aliases = PERUSP REIKÄYMP KESKIP
    .purpose = Työkierto laskee reikäympyrän keskipisteen mittaamalla sen kolme reikää ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa keskipisteen myös nollapiste- tai esiasetustaulukkoon.
cycle-datum-bolt-hole-circle__tnc426-430 =
    .purpose = Työkierto laskee reikäympyrän keskipisteen mittaamalla sen kolme reikää ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa keskipisteen myös nollapistetaulukkoon.
title-datum-at-top-and-bolt-hole-circle = Peruspisteen asetus työkappaleen yläpintaan ja reikäympyrän keskelle
title-top-and-bolt-hole-circle-into-datum-table = Työkappaleen yläpinnan ja reikäympyrän keskipisteen kirjoitus nollapistetaulukkoon

# --- 417 ---
cycle-datum-probe-axis = Peruspisteen asetus kosketusakselille
    .nc = PERUSP. KOSK.AKSELI
    .nc-aliases = PERUSP KOSK.JÄRJ. AKSELI
    .purpose = Työkierto mittaa minkä tahansa koordinaatin kosketusakselilla ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa mitatun koordinaatin myös nollapiste- tai esiasetustaulukkoon.
cycle-datum-probe-axis__tnc426-430 =
    .purpose = Työkierto mittaa minkä tahansa koordinaatin kosketusakselilla ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa mitatun koordinaatin myös nollapistetaulukkoon.
step-position-above-touch-point = Ohjaus paikoittaa kosketusjärjestelmän ohjelmoituun kosketuspisteeseen pikaliikkeellä (arvo sarakkeesta { $mp-positioning-feed }) ja paikoituslogiikalla. Se siirtää kosketusjärjestelmää varmuusetäisyyden verran kosketusakselin positiiviseen suuntaan.
step-position-above-touch-point__tnc426-430 = Ohjaus paikoittaa kosketusjärjestelmän ohjelmoituun kosketuspisteeseen pikaliikkeellä (arvo koneparametrista { $mp-positioning-feed } tai { $mp-analog-positioning-feed }) ja paikoituslogiikalla. Se siirtää kosketusjärjestelmää varmuusetäisyyden verran kosketusakselin positiiviseen suuntaan.
step-probe-touch-point-in-probe-axis = Kosketusjärjestelmä siirtyy kosketusakselin suunnassa kosketuspisteen annettuun koordinaattiin { $q-first-point-tool } ja mittaa oloaseman yhdellä kosketuksella.
note-datum-set-in-probe-axis = Ohjaus asettaa peruspisteen kosketusakselilla, jonka työkiertoa edeltävä työkalukutsu määrittelee.
note-positioning-logic__datum-probe-axis = Paikoituslogiikka: jos kosketusvarren etelänapa on varmuuskorkeuden { $q-clearance-height } alapuolella, ohjaus vetää kosketusjärjestelmän ensin kosketusakselin suunnassa varmuuskorkeudelle ja paikoittaa sen sitten koneistustasossa ensimmäiseen kosketuspisteeseen. Jos se on varmuuskorkeuden yläpuolella, ohjaus paikoittaa kosketusjärjestelmän ensin koneistustasossa ensimmäiseen kosketuspisteeseen ja ajaa sen sitten kosketusakselin suunnassa suoraan mittauskorkeudelle.
note-no-transformation-with-probe-axis-datum__datum-probe-axis = Jos työkierto asettaa peruspisteen valinnalla { $q-measured-value-transfer } = 0 ja koskettaa lisäksi kosketusakselin suunnassa (Q381 = 1), mikään koordinaattimuunnos ei saa olla voimassa.
result-measured-point-actual = Mitatun pisteen todellisarvo
title-datum-at-top-and-arc-centre = Peruspisteen asetus työkappaleen yläpintaan ja ympyräsegmentin keskipisteeseen

# --- 418 ---
cycle-datum-four-holes = Peruspisteen asetus neljän reiän keskelle
    .nc = PERUSP. 4 REIKÄÄ
    .nc-aliases = PERUSP 4 REIKÄÄ
    .purpose = Työkierto laskee reikien keskipisteiden kahden yhdyssuoran leikkauspisteen ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa leikkauspisteen myös nollapiste- tai esiasetustaulukkoon.
cycle-datum-four-holes__tnc426-430 =
    .purpose = Työkierto laskee reikien keskipisteiden kahden yhdyssuoran leikkauspisteen ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa leikkauspisteen myös nollapistetaulukkoon.
step-repeat-for-third-and-fourth-hole = Ohjaus toistaa kaksi edellistä vaihetta kolmannelle ja neljännelle reiälle.
step-retract-and-store-intersection = Ohjaus palauttaa kosketusjärjestelmän varmuuskorkeudelle { $q-clearance-height }, laskee peruspisteen reikien 1 ja 3 sekä reikien 2 ja 4 keskipisteiden yhdyssuorien leikkauspisteenä, tallentaa todellisarvot tulosparametreihin ja asettaa tai tallentaa peruspisteen parametrien { $q-measured-value-transfer } ja { $q-datum-row-number } mukaan:
step-retract-and-store-intersection__tnc426-430 = Ohjaus palauttaa kosketusjärjestelmän varmuuskorkeudelle { $q-clearance-height }, laskee peruspisteen reikien 1 ja 3 sekä reikien 2 ja 4 keskipisteiden yhdyssuorien leikkauspisteenä ja käsittelee sen parametrin { $q-datum-row-number } mukaan:
result-intersection-main-actual = Leikkauspisteen todellisarvo pääakselilla
result-intersection-minor-actual = Leikkauspisteen todellisarvo sivuakselilla

# --- 419 ---
cycle-datum-one-axis = Peruspisteen asetus yksittäiselle valittavalle akselille
    .nc = PERUSP. YKSITT.AKSELI
    .nc-aliases = PERUSP YKSITT. AKSELI
    .purpose = Työkierto mittaa minkä tahansa koordinaatin valittavalla akselilla ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa mitatun koordinaatin myös nollapiste- tai esiasetustaulukkoon.
step-position-against-probing-direction = Ohjaus paikoittaa kosketusjärjestelmän ohjelmoituun kosketuspisteeseen pikaliikkeellä (arvo sarakkeesta { $mp-positioning-feed }) ja paikoituslogiikalla. Se siirtää kosketusjärjestelmää varmuusetäisyyden verran ohjelmoitua kosketussuuntaa { $q-traverse-direction } vastaan.
step-move-to-measuring-height-and-probe = Kosketusjärjestelmä siirtyy mittauskorkeudelle { $q-measuring-height } ja mittaa oloaseman yhdellä kosketuksella.
step-retract-and-store-datum__datum-one-axis = Ohjaus palauttaa kosketusjärjestelmän varmuuskorkeudelle { $q-clearance-height } ja asettaa tai tallentaa mitatun peruspisteen parametrien { $q-measured-value-transfer } ja { $q-datum-row-number } mukaan:
note-measuring-axes-by-probe-axis = Parametrilla { $q-measuring-axis } valittavat akselit riippuvat aktiivisesta kosketusakselista ({ $q-measuring-axis } = 3): akselilla Z pääakseli ({ $q-measuring-axis } = 1) on X ja sivuakseli ({ $q-measuring-axis } = 2) on Y; akselilla Y ne ovat Z ja X; akselilla X ne ovat Y ja Z.
note-activate-preset-after-each-axis = Jos haluat tallentaa peruspisteen esiasetustaulukkoon useilla akseleilla suorittamalla tämän työkierron useita kertoja peräkkäin, aktivoi jokaisen suorituksen jälkeen se esiasetusnumero, johon työkierto on kirjoittanut. Tämä ei ole tarpeen, jos voimassa oleva esiasetus korvataan.
