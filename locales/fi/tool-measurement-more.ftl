# Työkierrot, jotka mittaavat työkalun: säde, koko työkalu, pöytäkosketusjärjestelmän kalibrointi.

# --- parametrit ---
help-tool-check-radius = Määrää, mitataanko työkalu ensimmäistä kertaa vai tarkastetaanko jo aiemmin mitattu työkalu. Ensimmäinen mittaus korvaa työkalun säteen { $mp-tool-radius } työkalutaulukossa TOOL.T ja asettaa sarakkeen { $mp-delta-radius } arvoksi 0. Tarkastuksessa mitattua sädettä verrataan työkalun säteeseen { $mp-tool-radius }; poikkeama kirjataan etumerkkeineen delta-arvoon { $mp-delta-radius }, ja se on käytettävissä myös parametrissa Q116. Jos delta-arvo ylittää säteelle sallitun kulumis- tai rikkotoleranssin, ohjaus estää työkalun käytön (tila L työkalutaulukossa TOOL.T).
help-tool-check-complete = Määrää, mitataanko työkalu ensimmäistä kertaa vai tarkastetaanko jo aiemmin mitattu työkalu. Ensimmäinen mittaus korvaa työkalun säteen { $mp-tool-radius } ja pituuden { $mp-tool-length } työkalutaulukossa TOOL.T ja asettaa sarakkeiden { $mp-delta-radius } ja { $mp-delta-length } arvoksi 0. Tarkastuksessa mitattuja tietoja verrataan työkalutaulukon tietoihin; poikkeamat kirjataan etumerkkeineen delta-arvoihin { $mp-delta-radius } ja { $mp-delta-length }, ja ne ovat käytettävissä myös parametreissa Q115 ja Q116. Jos jokin delta-arvo ylittää sallitun kulumis- tai rikkotoleranssin, ohjaus estää työkalun käytön (tila L työkalutaulukossa TOOL.T).
help-additional-tooth-measurement = Määrää, mitataanko lisäksi terät yksitellen. Mitattavissa on enintään 20 terää.
help-additional-tooth-measurement__itnc530 = Määrää, mitataanko lisäksi terät yksitellen. Mitattavissa on enintään 99 terää.
help-additional-tooth-measurement__tnc426-430 = Määrää, mitataanko lisäksi terät yksitellen.
help-calibration-tool-height = Karan akselin asema, jossa kalibrointityökalu ei voi törmätä työkappaleisiin eikä kiinnittimiin. Se perustuu voimassa olevaan työkappaleen peruspisteeseen. Jos arvo on niin pieni, että kalibrointityökalun kärki jäisi kosketuspään yläreunan alapuolelle, ohjaus paikoittaa sen automaattisesti kosketuspään yläpuolelle (varmuusalue { $mp-setter-safety-distance }).
parameter-tool-check__tool-radius =
    .help = { help-tool-check-radius }
parameter-tool-check__tool-radius-old =
    .help = { help-tool-check-radius }
parameter-tool-check__tool-complete =
    .help = { help-tool-check-complete }
parameter-tool-check__tool-complete-old =
    .help = { help-tool-check-complete }
parameter-tooth-measurement__tool-radius =
    .help = { help-additional-tooth-measurement }
parameter-tooth-measurement__tool-radius-old =
    .help = { help-additional-tooth-measurement }
parameter-tooth-measurement__tool-complete =
    .help = { help-additional-tooth-measurement }
parameter-tooth-measurement__tool-complete-old =
    .help = { help-additional-tooth-measurement }
parameter-tool-status-parameter__tool-radius-old =
    .help = Sen parametrin numero, johon ohjaus tallentaa mittauksen tilan: 0,0: työkalu toleranssin sisäpuolella; 1,0: työkalu kulunut ({ $mp-wear-tolerance-radius } ylitetty); 2,0: työkalu rikkoutunut ({ $mp-break-tolerance-radius } ylitetty). Jos tulosta ei käytetä ohjelmassa, vastaa kysymykseen näppäimellä NO ENT.
parameter-tool-status-parameter__tool-complete-old =
    .help = Sen parametrin numero, johon ohjaus tallentaa mittauksen tilan: 0,0: työkalu toleranssin sisäpuolella; 1,0: työkalu kulunut ({ $mp-wear-tolerance-length } tai { $mp-wear-tolerance-radius } tai molemmat ylitetty); 2,0: työkalu rikkoutunut ({ $mp-break-tolerance-length } tai { $mp-break-tolerance-radius } tai molemmat ylitetty). Jos tulosta ei käytetä ohjelmassa, vastaa kysymykseen näppäimellä NO ENT.
parameter-tool-clearance-height__calibrate-tool-probe =
    .help = { help-calibration-tool-height }
parameter-tool-clearance-height__calibrate-tool-probe-old =
    .help = { help-calibration-tool-height }

# --- 32 ja 482 ---
cycle-tool-radius = Työkalun säteen mittaus
    .nc = TYÖKALUN SÄDE
    .purpose = Työkierto mittaa tai tarkastaa työkalun säteen pöytäkosketusjärjestelmällä: pyörivällä työkalulla ja haluttaessa sen jälkeen yksittäisterän mittauksella. Ohjaus tallentaa tuloksen työkalutaulukkoon TOOL.T ja ottaa sen automaattisesti huomioon työkierron lopussa.
cycle-tool-radius__tnc426-430 =
    .purpose = Työkierto mittaa tai tarkastaa työkalun säteen pöytäkosketusjärjestelmällä: pyörivällä työkalulla ja haluttaessa sen jälkeen yksittäisterän mittauksella. Ohjaus tallentaa tuloksen työkalutaulukkoon TOOL.T ja käyttää sitä seuraavasta työkalukutsusta lähtien.
cycle-tool-radius-old = Työkalun säteen mittaus
    .nc = TYÖKALUN SÄDE
    .purpose = Työkierto mittaa tai tarkastaa työkalun säteen pöytäkosketusjärjestelmällä: pyörivällä työkalulla ja haluttaessa sen jälkeen yksittäisterän mittauksella. Ohjaus tallentaa tuloksen työkalutaulukkoon TOOL.T ja ottaa sen automaattisesti huomioon työkierron lopussa. Tämä on työkierron 482 vanha lausemuoto.
cycle-tool-radius-old__tnc426-430 =
    .purpose = Työkierto mittaa tai tarkastaa työkalun säteen pöytäkosketusjärjestelmällä: pyörivällä työkalulla ja haluttaessa sen jälkeen yksittäisterän mittauksella. Ohjaus tallentaa tuloksen työkalutaulukkoon TOOL.T ja käyttää sitä seuraavasta työkalukutsusta lähtien. Tämä on työkierron 482 vanha lausemuoto.
step-position-tool-beside-setter = Ohjaus paikoittaa työkalun kosketuspään viereen niin, että sen otsapinta on kosketuspään yläreunan alapuolella arvon { $mp-setter-axis-offset } verran ja lisäksi pituuden lisäsiirtymän { $mp-setter-offset-length } verran, jos se on annettu työkalutaulukossa.
step-probe-rotating-tool-radially = Ohjaus koskettaa pyörivää työkalua säteen suunnassa.
step-measure-teeth-radially = Ohjaus määrittää säteen:
say-measure-radii-of-teeth = jos { $q-tooth-measurement } = 1, se mittaa sen jälkeen kaikkien terien säteet karaa suuntaamalla
say-radius-of-rotating-tool = jos { $q-tooth-measurement } = 0, säde saadaan mittauksesta pyörivällä työkalulla
step-store-tool-radius = Ohjaus tallentaa tuloksen:
say-overwrite-tool-radius = jos { $q-tool-check } = 0, se korvaa työkalun säteen { $mp-tool-radius } työkalutaulukossa TOOL.T ja asettaa sarakkeen { $mp-delta-radius } arvoksi 0
say-enter-delta-radius = jos { $q-tool-check } = 1, se vertaa mitattua sädettä työkalun säteeseen { $mp-tool-radius }, kirjaa poikkeaman etumerkkeineen delta-arvoon { $mp-delta-radius } ja parametriin Q116 ja asettaa työkalulle eston (tila L), jos kulumis- tai rikkotoleranssi on ylitetty
result-tool-radius-deviation = Työkalun säteen poikkeama
note-diamond-coated-cylinders = Lieriömäisiä työkaluja, joissa on timanttipinta, voidaan mitata karan ollessa pysähdyksissä. Aseta tätä varten työkalutaulukossa terien lukumääräksi ({ $mp-teeth }) 0 ja muuta koneparametria { $mp-tool-measurement-config }. Katso koneen käyttöohjekirjaa.
note-diamond-coated-cylinders__itnc530 = Lieriömäisiä työkaluja, joissa on timanttipinta, voidaan mitata karan ollessa pysähdyksissä. Aseta tätä varten työkalutaulukossa terien lukumääräksi ({ $mp-teeth }) 0 ja muuta koneparametria { $mp-calibration-behaviour }. Katso koneen käyttöohjekirjaa.
note-two-ways-to-measure-tool = Työkalu voidaan mitata kahdella tavalla: vain pyörivänä, tai ensin pyörivänä ja sen jälkeen yksittäisterän mittauksella.

# --- 33 ja 483 ---
cycle-tool-complete = Työkalun pituuden ja säteen mittaus
    .nc = TYÖKALUN MITTAUS
    .purpose = Työkierto mittaa tai tarkastaa työkalun pituuden ja säteen pöytäkosketusjärjestelmällä: pyörivällä työkalulla ja haluttaessa sen jälkeen yksittäisterän mittauksella. Ohjaus tallentaa tulokset työkalutaulukkoon TOOL.T ja ottaa ne automaattisesti huomioon työkierron lopussa.
cycle-tool-complete__tnc426-430 =
    .purpose = Työkierto mittaa tai tarkastaa työkalun pituuden ja säteen pöytäkosketusjärjestelmällä: pyörivällä työkalulla ja haluttaessa sen jälkeen yksittäisterän mittauksella. Ohjaus tallentaa tulokset työkalutaulukkoon TOOL.T ja käyttää niitä seuraavasta työkalukutsusta lähtien.
cycle-tool-complete-old = Työkalun pituuden ja säteen mittaus
    .nc = TYÖKALUN MITTAUS
    .purpose = Työkierto mittaa tai tarkastaa työkalun pituuden ja säteen pöytäkosketusjärjestelmällä: pyörivällä työkalulla ja haluttaessa sen jälkeen yksittäisterän mittauksella. Ohjaus tallentaa tulokset työkalutaulukkoon TOOL.T ja ottaa ne automaattisesti huomioon työkierron lopussa. Tämä on työkierron 483 vanha lausemuoto.
cycle-tool-complete-old__tnc426-430 =
    .purpose = Työkierto mittaa tai tarkastaa työkalun pituuden ja säteen pöytäkosketusjärjestelmällä: pyörivällä työkalulla ja haluttaessa sen jälkeen yksittäisterän mittauksella. Ohjaus tallentaa tulokset työkalutaulukkoon TOOL.T ja käyttää niitä seuraavasta työkalukutsusta lähtien. Tämä on työkierron 483 vanha lausemuoto.
step-measure-radius-first = Ohjaus mittaa työkalun kiinteässä järjestyksessä. Ensin se mittaa säteen samoin kuin työkierrot 32 ja 482: se paikoittaa työkalun kosketuspään viereen niin, että sen otsapinta on yläreunan alapuolella arvojen { $mp-setter-axis-offset } ja { $mp-setter-offset-length } mukaan, ja koskettaa pyörivää työkalua säteen suunnassa.
step-then-measure-length = Sen jälkeen se mittaa pituuden samoin kuin työkierrot 31 ja 481:
step-store-radius-and-length = Ohjaus tallentaa tulokset:
say-overwrite-radius-and-length = jos { $q-tool-check } = 0, se korvaa työkalun säteen { $mp-tool-radius } ja pituuden { $mp-tool-length } työkalutaulukossa TOOL.T ja asettaa sarakkeiden { $mp-delta-radius } ja { $mp-delta-length } arvoksi 0
say-enter-both-delta-values = jos { $q-tool-check } = 1, se vertaa mitattuja tietoja työkalutaulukon TOOL.T tietoihin, kirjaa poikkeamat etumerkkeineen delta-arvoihin { $mp-delta-radius } ja { $mp-delta-length } sekä parametreihin Q116 (säde) ja Q115 (pituus) ja asettaa työkalulle eston (tila L), jos jokin kulumis- tai rikkotoleranssi on ylitetty
note-complete-measurement-saves-time = Työkierto soveltuu erityisesti työkalujen ensimmäiseen mittaukseen: se säästää paljon aikaa pituuden ja säteen erilliseen mittaukseen verrattuna.
title-first-measurement-rotating = Ensimmäinen mittaus pyörivällä työkalulla
title-check-teeth = Tarkastus mittaamalla terät yksitellen

# --- 30 ja 480 ---
cycle-calibrate-tool-probe = TT-kalibrointi
    .nc = TT KALIBROINTI
    .purpose = Työkierto kalibroi pöytäkosketusjärjestelmän automaattisesti lieriömäisellä kalibrointityökalulla. Ohjaus määrittää myös kalibrointityökalun keskipistesiirtymän. Se tallentaa kalibrointiarvot ja ottaa ne huomioon myöhemmissä työkalun mittauksissa.
cycle-calibrate-tool-probe-old = TT-kalibrointi
    .nc = TT KALIBROINTI
    .purpose = Työkierto kalibroi pöytäkosketusjärjestelmän automaattisesti lieriömäisellä kalibrointityökalulla. Ohjaus määrittää myös kalibrointityökalun keskipistesiirtymän. Se tallentaa kalibrointiarvot ja ottaa ne huomioon myöhemmissä työkalun mittauksissa. Tämä on työkierron 480 vanha lausemuoto.
guard-tool-call-missing__calibrate-tool-probe = Työkalua ei ole kutsuttu. Kutsu kalibrointityökalu käskyllä TOOL CALL.
guard-tool-call-missing__calibrate-tool-probe-old = Työkalua ei ole kutsuttu. Kutsu kalibrointityökalu käskyllä TOOL CALL.
step-position-calibration-tool-over-setter = Ohjaus paikoittaa kalibrointityökalun varmuuskorkeudelle { $q-tool-clearance-height }, ei kuitenkaan kosketuspään yläpuolella olevaa varmuusaluetta { $mp-setter-safety-distance } alemmas.
step-calibrate-tool-probe = Ohjaus kalibroi kosketusjärjestelmän automaattisesti kalibrointityökalulla.
step-turn-spindle-for-centre-misalignment = Kalibroinnin puolivälissä ohjaus kääntää karaa 180°. Näin se määrittää myös kalibrointityökalun keskipistesiirtymän.
step-store-tool-probe-calibration = Ohjaus tallentaa kalibrointiarvot ja ottaa ne huomioon seuraavissa työkalun mittauksissa.
note-enter-calibration-tool-data = Syötä kalibrointityökalun tarkka säde ja tarkka pituus työkalutaulukkoon TOOL.T ennen kalibrointia.
note-cylindrical-calibration-tool = Käytä kalibrointityökaluna tarkasti lieriömäistä osaa, esimerkiksi lieriötappia.
note-calibration-tool-size = Kalibrointityökalun halkaisijan tulisi olla suurempi kuin 15{"\u00A0"}mm, ja sen tulisi ulottua noin 50{"\u00A0"}mm istukan ulkopuolelle. Silloin se taipuu 0,1{"\u00A0"}µm, kun kosketusvoima on 1{"\u00A0"}N.
note-tool-probe-position-known = Kosketusjärjestelmän sijainnin koneen työtilassa on oltava määritelty koneparametreissa { $mp-setter-centre } > [0]–[2].
note-tool-probe-position-known__itnc530 = Kosketusjärjestelmän sijainnin koneen työtilassa on oltava määritelty koneparametreissa { $mp-setter-centre }.0–{ $mp-setter-centre }.2.
note-tool-probe-position-known__tnc426-430 = Kosketusjärjestelmän sijainnin koneen työtilassa on oltava määritelty koneparametreissa { $mp-setter-centre }.0–{ $mp-setter-centre }.2.
note-recalibrate-after-position-data-change = Jos jotakin koneparametreista { $mp-setter-centre } > [0]–[2] muutetaan, kalibroi uudelleen.
note-recalibrate-after-position-data-change__itnc530 = Jos jotakin koneparametreista { $mp-setter-centre }.0–{ $mp-setter-centre }.2 muutetaan, kalibroi uudelleen.
note-recalibrate-after-position-data-change__tnc426-430 = Jos jotakin koneparametreista { $mp-setter-centre }.0–{ $mp-setter-centre }.2 muutetaan, kalibroi uudelleen.
note-keep-fixtures-off-tool-probe = Varmista kalibroinnissa, ettei kosketusjärjestelmän ympärille ole kiinnitetty kiinnittimiä. Suositus: jätä vapaata tilaa kaksi kertaa kalibrointityökalun halkaisijan verran.
note-calibration-cycle-behaviour = Kalibrointityökierron toiminta riippuu koneparametrista { $mp-tool-measurement-config }. Katso koneen käyttöohjekirjaa.
note-calibration-cycle-behaviour__tnc320 = Koneen valmistaja määrää kalibrointityökierron toiminnan. Katso koneen käyttöohjekirjaa.
note-calibration-cycle-behaviour__itnc530 = Kalibrointityökierron toiminta riippuu koneparametrista { $mp-calibration-behaviour }. Katso koneen käyttöohjekirjaa.
note-calibration-cycle-behaviour__tnc426-430 = Kalibrointityökierron toiminta riippuu koneparametrista { $mp-calibration-behaviour }. Katso koneen käyttöohjekirjaa.

# --- 484 ---
cycle-calibrate-wireless-tool-probe = Langattoman TT 449 -kosketusjärjestelmän kalibrointi
    .nc = IR TT KALIBROINTI
    .purpose = Työkierto kalibroi langattoman infrapunatoimisen pöytäkosketusjärjestelmän TT 449. Kalibrointi on puoliautomaattinen, koska kosketusjärjestelmän paikkaa koneen pöydällä ei ole määritelty. Ohjaus määrittää myös kalibrointityökalun keskipistesiirtymän, tallentaa kalibrointiarvot ja ottaa ne huomioon myöhemmissä työkalun mittauksissa.
step-insert-calibration-tool = Vaihda kalibrointityökalu karaan.
step-define-and-start-calibration = Määrittele ja käynnistä kalibrointityökierto.
step-position-calibration-tool-by-hand = Paikoita kalibrointityökalu käsin kosketusjärjestelmän keskipisteen yläpuolelle ja noudata ponnahdusikkunan ohjeita. Varmista, että kalibrointityökalu on kosketuspään mittauspinnan yläpuolella.
step-calibrate-wireless-tool-probe = Ohjaus kalibroi kosketusjärjestelmän puoliautomaattisesti kalibrointityökalulla.
message-calibration-tool-over-setter = Paikoita kalibrointityökalu kosketusjärjestelmän keskipisteen yläpuolelle ja jatka.
note-wireless-calibration-by-hand = Kalibrointi ei ole täysin automaattinen, koska kosketusjärjestelmän paikkaa koneen pöydällä ei ole määritelty.
note-recalibrate-after-move = Jos kosketusjärjestelmän paikka pöydällä muuttuu, kalibroi uudelleen.
note-calibration-tool-size__tnc640 = Kalibrointityökalun halkaisijan on oltava suurempi kuin 15{"\u00A0"}mm, ja sen on ulotuttava 50{"\u00A0"}mm istukan ulkopuolelle. Silloin se taipuu 0,1{"\u00A0"}µm, kun kosketusvoima on 1{"\u00A0"}N.
guard-tool-call-missing__calibrate-wireless-tool-probe = Työkalua ei ole kutsuttu. Kutsu kalibrointityökalu käskyllä TOOL CALL.
