# Työkierrot, jotka määrittävät ja kompensoivat työkappaleen vinon asennon.

# --- yhteinen kulku ---
step-position-offset-at-first-touch-point = Ohjaus paikoittaa kosketusjärjestelmän ensimmäiseen kosketuspisteeseen pikaliikkeellä (arvo sarakkeesta { $mp-positioning-feed }) ja paikoituslogiikalla. Se siirtää kosketusjärjestelmää varmuusetäisyyden verran liikesuuntaa vastaan.
step-position-offset-at-first-touch-point__tnc426-430 = Ohjaus paikoittaa kosketusjärjestelmän ensimmäiseen kosketuspisteeseen pikaliikkeellä (arvo koneparametrista { $mp-positioning-feed } tai { $mp-analog-positioning-feed }) ja paikoituslogiikalla. Se siirtää kosketusjärjestelmää varmuusetäisyyden verran liikesuuntaa vastaan.
step-travel-to-and-probe-second-point = Kosketusjärjestelmä siirtyy toiseen kosketuspisteeseen ja tekee siellä toisen kosketuksen.
step-retract-and-carry-out-basic-rotation = Ohjaus palauttaa kosketusjärjestelmän varmuuskorkeudelle { $q-clearance-height } ja suorittaa määrittämänsä peruskäännön.
note-basic-rotation-reset-at-start = Ohjaus peruuttaa voimassa olevan peruskäännön työkierron alussa.
note-known-reference-direction = Parametrilla { $q-reference-line-angle } ohjaus korjaa mittausarvoa tunnetulla kulmalla. Näin peruskääntö voidaan mitata miltä tahansa työkappaleen suoralta, ja se tulee silti todellisen 0°-suunnan mukaiseksi.

# --- 400 ---
cycle-basic-rotation = Peruskääntö
    .nc = PERUSKÄÄNTÖ
    .purpose = Työkierto mittaa kaksi pistettä, joiden on oltava samalla suoralla, ja määrittää niistä työkappaleen vinon asennon. Ohjaus kompensoi sen peruskäännöllä.
step-store-basic-rotation = Ohjaus tallentaa peruskäännön:
say-rotation-into-preset-row = jos { $q-basic-rotation-row } ei ole 0, esiasetustaulukon riville { $q-basic-rotation-row }
say-rotation-into-rot-menu = jos { $q-basic-rotation-row } = 0, käsikäyttötavan ROT-valikkoon

# --- 401 ja 402 ---
cycle-rotation-two-holes = Peruskääntö kahden reiän avulla
    .nc = ROT 2 REIKÄÄ
    .nc-aliases = ROT 2 BOHRUNGEN
    .purpose = Työkierto mittaa kahden reiän keskipisteet ja laskee koneistustason pääakselin ja keskipisteiden yhdyssuoran välisen kulman. Ohjaus kompensoi kulman peruskäännöllä tai pyöröpöytää kääntämällä.
cycle-rotation-two-holes__tnc426-430 =
    .purpose = Työkierto mittaa kahden reiän keskipisteet ja laskee koneistustason pääakselin ja keskipisteiden yhdyssuoran välisen kulman. Ohjaus kompensoi kulman peruskäännöllä.
cycle-rotation-two-studs = Peruskääntö kahden kaulan avulla
    .nc = ROT 2 KAULAA
    .purpose = Työkierto mittaa kahden kaulan keskipisteet ja laskee koneistustason pääakselin ja keskipisteiden yhdyssuoran välisen kulman. Ohjaus kompensoi kulman peruskäännöllä tai pyöröpöytää kääntämällä.
cycle-rotation-two-studs__tnc426-430 =
    .purpose = Työkierto mittaa kahden kaulan keskipisteet ja laskee koneistustason pääakselin ja keskipisteiden yhdyssuoran välisen kulman. Ohjaus kompensoi kulman peruskäännöllä.
step-position-at-first-hole = Ohjaus paikoittaa kosketusjärjestelmän ensimmäisen reiän ohjelmoituun keskipisteeseen pikaliikkeellä (arvo sarakkeesta { $mp-positioning-feed }) ja paikoituslogiikalla.
step-position-at-first-hole__tnc426-430 = Ohjaus paikoittaa kosketusjärjestelmän ensimmäisen reiän ohjelmoituun keskipisteeseen pikaliikkeellä (arvo koneparametrista { $mp-positioning-feed } tai { $mp-analog-positioning-feed }) ja paikoituslogiikalla.
step-measure-first-hole = Kosketusjärjestelmä siirtyy mittauskorkeudelle { $q-measuring-height } ja määrittää ensimmäisen reiän keskipisteen neljällä kosketuksella.
step-position-at-second-hole = Kosketusjärjestelmä palaa varmuuskorkeudelle { $q-clearance-height } ja paikoittuu toisen reiän ohjelmoituun keskipisteeseen.
step-measure-second-hole = Kosketusjärjestelmä siirtyy mittauskorkeudelle { $q-measuring-height } ja määrittää toisen reiän keskipisteen neljällä kosketuksella.
step-position-at-first-stud = Ohjaus paikoittaa kosketusjärjestelmän ensimmäisen kaulan ensimmäiseen kosketuspisteeseen pikaliikkeellä (arvo sarakkeesta { $mp-positioning-feed }) ja paikoituslogiikalla.
step-position-at-first-stud__tnc426-430 = Ohjaus paikoittaa kosketusjärjestelmän ensimmäisen kaulan ensimmäiseen kosketuspisteeseen pikaliikkeellä (arvo koneparametrista { $mp-positioning-feed } tai { $mp-analog-positioning-feed }) ja paikoituslogiikalla.
step-measure-first-stud = Kosketusjärjestelmä siirtyy mittauskorkeudelle { $q-measuring-height } ja määrittää ensimmäisen kaulan keskipisteen neljällä kosketuksella. Kosketuspisteiden välillä, jotka ovat 90°:n päässä toisistaan, se kulkee ympyränkaarta pitkin: jos { $q-traverse-to-clearance-height } = 0, mittauskorkeudella, jos { $q-traverse-to-clearance-height } = 1, varmuuskorkeudella.
step-measure-first-stud__tnc426-430 = Kosketusjärjestelmä siirtyy mittauskorkeudelle { $q-measuring-height } ja määrittää ensimmäisen kaulan keskipisteen neljällä kosketuksella. Kosketuspisteiden välillä se kulkee mittauskorkeudella, jos { $q-traverse-to-clearance-height } = 0, ja varmuuskorkeudella, jos { $q-traverse-to-clearance-height } = 1.
step-position-at-second-stud = Kosketusjärjestelmä palaa varmuuskorkeudelle { $q-clearance-height } ja paikoittuu toisen kaulan ensimmäiseen kosketuspisteeseen.
step-measure-second-stud = Kosketusjärjestelmä siirtyy mittauskorkeudelle { $q-second-measuring-height } ja määrittää toisen kaulan keskipisteen neljällä kosketuksella.
step-compensate-as-chosen = Ohjaus kompensoi vinon asennon parametrin { $q-misalignment-compensation } mukaan:
say-rotation-into-preset-row-if-chosen = jos { $q-misalignment-compensation } = 0 ja { $q-basic-rotation-row } ei ole 0, se tallentaa peruskäännön esiasetustaulukon riville { $q-basic-rotation-row }
say-rotation-into-rot-menu-if-chosen = jos { $q-misalignment-compensation } = 0 ja { $q-basic-rotation-row } = 0, se tallentaa peruskäännön käsikäyttötavan ROT-valikkoon
say-turn-rotary-table = jos { $q-misalignment-compensation } = 1, se kääntää pyöröpöytää eikä tallenna peruskääntöä; jos { $q-zero-after-alignment } = 1, se asettaa sen jälkeen kiertoakselin näytön lukemaan 0
note-rotary-axis-by-tool-axis = Kun vino asento kompensoidaan pyöröpöytää kääntämällä, ohjaus valitsee kiertoakselin työkaluakselin mukaan: akselilla Z se on C, akselilla Y se on B ja akselilla X se on A.
note-no-tilting-with-this-cycle = Tämä työkierto ei ole sallittu koneistustason ollessa käännettynä.
title-rotation-from-two-holes = Peruskäännön määritys kahden reiän avulla

# --- 403 ---
cycle-rotation-by-rotary-axis = Peruskäännön kompensointi kiertoakselin avulla
    .nc = ROT C-AKSELILLA
    .nc-aliases = ROT KIERTOAKSELIN AVULLA
    .purpose = Työkierto mittaa kaksi pistettä, joiden on oltava samalla suoralla, ja määrittää niistä työkappaleen vinon asennon. Ohjaus kompensoi sen kääntämällä A-, B- tai C-akselia. Työkappale voi olla kiinnitettynä mihin tahansa kohtaan pyöröpöytää.
step-retract-and-turn-rotary-axis = Ohjaus palauttaa kosketusjärjestelmän varmuuskorkeudelle { $q-clearance-height } ja kääntää kiertoakselia { $q-compensation-axis } lasketun arvon verran. Se tallentaa kulman myös tulosparametriin. Haluttaessa se asettaa näytön suuntauksen jälkeen lukemaan 0.
step-retract-and-turn-rotary-axis__tnc426-430 = Ohjaus palauttaa kosketusjärjestelmän varmuuskorkeudelle { $q-clearance-height } ja kääntää kiertoakselia { $q-compensation-axis } lasketun arvon verran.
note-compensation-may-be-turned-180 = Törmäysvaara! Ohjaus tarkastaa vain karkeasti, sopivatko kosketuspisteet ja kompensoiva akseli yhteen. Kompensointiliike voi siksi olla kääntynyt 180°.
note-compensation-axis-combinations = Mittausakselin { $q-measuring-axis } ja kompensoivan akselin { $q-compensation-axis } sallitut yhdistelmät. Kosketusakseli Z: 1 ja 6, 2 ja 6, 3 ja 5 tai 4. Kosketusakseli Y: 1 ja 5, 2 ja 5, 3 ja 6 tai 4. Kosketusakseli X: 1 ja 4, 2 ja 4, 3 ja 5 tai 6.
note-only-without-tilting = Käytä tätä työkiertoa vain, kun koneistustason kääntö ei ole voimassa.

# --- 404 ---
cycle-set-basic-rotation = Peruskäännön asetus
    .nc = PERUSKÄÄNTÖ
    .nc-aliases = PERUSKÄÄNNÖN ASETUS
    .purpose = Työkierto asettaa minkä tahansa peruskäännön automaattisesti ohjelmanajon aikana. Se on tarkoitettu ennen kaikkea aiemmin tehdyn peruskäännön peruuttamiseen.
step-set-basic-rotation = Ohjaus asettaa peruskäännön kulmaan { $q-basic-rotation-angle }.
note-available-from-nc-software = Työkierto on käytettävissä NC-ohjelmistosta 280 474-xx lähtien.

# --- 405 ---
cycle-rotation-by-c-axis = Vinon asennon kompensointi C-akselin avulla
    .nc = ROT C-AKSELILLA
    .nc-aliases = ROT C-AKSELIN AVULLA
    .purpose = Työkierto määrittää kulmasiirtymän, joka on reiän keskilinjan ja aktiivisen koordinaatiston positiivisen Y-akselin välillä tai reiän keskipisteen asetusaseman ja oloaseman välillä. Ohjaus kompensoi sen kääntämällä C-akselia. Työkappale voi olla kiinnitettynä mihin tahansa kohtaan pyöröpöytää.
say-travel-on-circle-at-clearance-height__rotation-by-c-axis = jos { $q-traverse-to-clearance-height } = 1, ympyränkaarta pitkin varmuuskorkeudella { $q-clearance-height }
step-move-to-measured-centre = Ohjaus paikoittaa kosketusjärjestelmän reiän mitattuun keskipisteeseen.
step-retract-and-turn-to-y-axis = Ohjaus palauttaa kosketusjärjestelmän varmuuskorkeudelle { $q-clearance-height } ja suuntaa työkappaleen pyöröpöytää kääntämällä: kompensoinnin jälkeen reiän keskipiste on sekä pysty- että vaakasuoralla kosketusakselilla positiivisen Y-akselin suunnassa ({ $q-probing-centre-minor } = 0) tai asetusasemassaan. Mitattu kulmasiirtymä tallentuu myös tulosparametriin.
step-store-angular-offset = Ohjaus käsittelee kulmasiirtymän parametrin { $q-zero-or-row-after-alignment } mukaan:
say-zero-display-of-c-axis = jos { $q-zero-or-row-after-alignment } = 0, se asettaa C-akselin näytön lukemaan 0
say-offset-into-column-c = jos { $q-zero-or-row-after-alignment } on suurempi kuin 0, se kirjoittaa kulmasiirtymän etumerkkeineen nollapistetaulukon rivin { $q-zero-or-row-after-alignment } sarakkeeseen C; se lisätään rivillä jo olevaan C-siirtymään
note-smallest-stepping-angle__rotation-by-c-axis = Mitä pienempi kulma-askel { $q-probing-stepping-angle } on, sitä epätarkemmin ohjaus laskee ympyrän keskipisteen. Pienin sisäänsyöttöarvo: 5°.
note-hole-with-positive-y = Reiän Y-koordinaatin on oltava positiivinen.
note-repeat-with-horizontal-probe = Jos reiän kulmasiirtymä mitataan kosketusakselilla Y (vaakasuora reikä), työkierto on ehkä suoritettava useita kertoja: mittaustapa aiheuttaa epätarkkuuden, joka on noin 1{"\u00A0"}% vinoudesta.

# --- tulokset ---
result-alignment-angle-determined = Määritetty kulma
result-angular-offset-measured = Mitattu kulmasiirtymä
