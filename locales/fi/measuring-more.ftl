# Työkierrot, jotka mittaavat kulmia, kauloja, suorakulmioita, leveyksiä, koordinaatteja, reikäympyröitä ja tasoja.

# --- yhteiset ---
say-part-is-scrap = hylky (Q182 = 1), jos mittausarvo on toleranssin ulkopuolella eikä ole korjattavissa
say-part-needs-rework = jälkityö (Q181 = 1), jos mittausarvo on toleranssin ulkopuolella ja korjattavissa

# --- 422 ---
cycle-measure-stud = Työkappaleen mittaus ympyrän ulkopuolella (tappi)
    .nc = MITTAUS YMP. ULKOP.
    .nc-aliases = YMPYRÄN MITTAUS ULKOP
    .purpose = Mittaa ympyräkaulan keskipisteen ja halkaisijan. Jos työkierrossa on määritelty toleranssit, ohjaus vertaa asetusarvoja ja todellisarvoja ja tallentaa poikkeamat parametreihin.
say-part-is-scrap__measure-stud = hylky (Q182 = 1), jos kaula on pienempi kuin { $q-stud-least-diameter } tai sen keskipiste poikkeaa enemmän kuin { $q-centre-tolerance-main } tai { $q-centre-tolerance-minor } sallii
say-part-needs-rework__measure-stud = jälkityö (Q181 = 1), jos kaula on suurempi kuin { $q-stud-greatest-diameter }
note-smallest-stepping-angle__measure-stud = Mitä pienempi kulma-askel { $q-probing-stepping-angle } on, sitä epätarkemmin ohjaus laskee kaulan mitat. Pienin sisäänsyöttöarvo: 5°.

# --- 423, 424 ---
cycle-measure-rectangular-pocket = Työkappaleen mittaus suorakulmion sisäpuolella
    .nc = MITTAUS SUORAK. SISÄP.
    .nc-aliases = SUORAK MITTAUS SISÄP. | SUORAK MITTAUS SISÄP
    .purpose = Mittaa suorakulmataskun keskipisteen, pituuden ja leveyden. Jos työkierrossa on määritelty toleranssit, ohjaus vertaa asetusarvoja ja todellisarvoja ja tallentaa poikkeamat parametreihin.
cycle-measure-rectangular-stud = Työkappaleen mittaus suorakulmion ulkopuolella
    .nc = MITTAUS SUORAK. ULKOP.
    .nc-aliases = SUORAK MITTAUS ULKOP
    .purpose = Mittaa suorakulmakaulan keskipisteen, pituuden ja leveyden. Jos työkierrossa on määritelty toleranssit, ohjaus vertaa asetusarvoja ja todellisarvoja ja tallentaa poikkeamat parametreihin.
say-part-is-scrap__measure-rectangular-pocket = hylky (Q182 = 1), jos jokin sivu on pidempi kuin { $q-first-side-greatest-length } tai { $q-second-side-greatest-length } tai keskipiste poikkeaa enemmän kuin { $q-centre-tolerance-main } tai { $q-centre-tolerance-minor } sallii
say-part-needs-rework__measure-rectangular-pocket = jälkityö (Q181 = 1), jos jokin sivu on lyhyempi kuin { $q-first-side-least-length } tai { $q-second-side-least-length }
say-part-is-scrap__measure-rectangular-stud = hylky (Q182 = 1), jos jokin sivu on lyhyempi kuin { $q-first-side-least-length } tai { $q-second-side-least-length } tai keskipiste poikkeaa enemmän kuin { $q-centre-tolerance-main } tai { $q-centre-tolerance-minor } sallii
say-part-needs-rework__measure-rectangular-stud = jälkityö (Q181 = 1), jos jokin sivu on pidempi kuin { $q-first-side-greatest-length } tai { $q-second-side-greatest-length }
result-side-main-deviation = Poikkeama pääakselin sivun pituudesta
result-side-minor-deviation = Poikkeama sivuakselin sivun pituudesta
title-measure-and-rework-rectangular-stud = Suorakulmakaulan mittaus ja silitys mitattujen arvojen mukaan
title-measure-rectangular-pocket-with-log = Suorakulmataskun mittaus ja tulosten kirjaus pöytäkirjaan

# --- 425, 426 ---
cycle-measure-slot-width = Työkappaleen mittaus leveysmitan sisäpuolella (ura)
    .nc = MITTAUS SISÄLEVEYS
    .nc-aliases = URAN LEV MITTAUS SISÄP
cycle-measure-ridge-width = Työkappaleen mittaus leveysmitan ulkopuolella (askel)
    .nc = UUMAN MITTAUS ULKOP
result-measured-length-actual = Mitattavan pituuden todellisarvo
result-measured-length-deviation = Mitattavan pituuden poikkeama

# --- 427 ---
cycle-measure-coordinate = Koordinaatin mittaus
    .nc = KOORDINAATIN MITTAUS
result-measured-coordinate__measure-coordinate = Mitattava koordinaatti

# --- 430 ---
cycle-measure-bolt-hole-circle = Reikäympyrän mittaus
    .nc = REIKÄYMPYRÄN MITTAUS
result-bolt-circle-diameter-actual = Reikäympyrän halkaisijan todellisarvo
result-bolt-circle-diameter-deviation = Reikäympyrän halkaisijan poikkeama

# --- 420 ---
cycle-measure-angle = Kulman mittaus
    .nc = KULMAN MITTAUS
result-measured-angle = Mitattava kulma koneistustason pääakselin suhteen

# --- 431 ---
cycle-measure-plane = Tason mittaus
    .nc = TASON MITTAUS
result-projection-angle-a = A-akselin projektiokulma
result-projection-angle-b = B-akselin projektiokulma
result-spatial-angle-a = Tilakulma A
result-spatial-angle-b = Tilakulma B
result-spatial-angle-c = Tilakulma C
result-first-value-in-probe-axis__tnc320 = Mittausarvo kosketusjärjestelmän akselilla

# --- 1 ---
cycle-polar-reference-plane = Perustaso polaarinen
    .nc = PERUSTASO POLAARINEN

# --- 3 ---
cycle-measuring = Mittaus
    .nc = MITTAUS
