# Mittauspöytäkirjojen sanat.

# --- työkierron 421 pöytäkirja ---
log-hole-title = Mittauspöytäkirja Kosketustyökierto { $cycle } Reiän mittaus
log-date = Päiväys:
log-time = Kellonaika:
log-program = Mittausohjelma:
log-nominal-values = Asetusarvot:
log-limits = Esimääritelty raja-arvo:
log-actual-values = Tosiarvo:
log-deviations = Poikkeamat:
log-centre-main = Pääakselin keskipiste:
log-centre-minor = Sivuakselin keskipiste:
log-diameter = Halkaisija:
log-centre-main-greatest = Pääakselin keskipisteen suurin mitta:
log-centre-main-least = Pääakselin keskipisteen pienin mitta:
log-centre-minor-greatest = Sivuakselin keskipisteen suurin mitta:
log-centre-minor-least = Sivuakselin keskipisteen pienin mitta:
log-hole-greatest = Reiän suurin mitta:
log-hole-least = Reiän pienin mitta:
log-further-results = Lisää mittaustuloksia:
log-measuring-height = Mittauskorkeus:
log-end = Mittauspöytäkirjan loppu

# --- muiden mittaustyökiertojen pöytäkirjat ---
log-angle-title = Mittauspöytäkirja Kosketustyökierto { $cycle } Kulman mittaus
log-stud-title = Mittauspöytäkirja Kosketustyökierto { $cycle } Ympyrän mittaus ulkopuolella
log-pocket-title = Mittauspöytäkirja Kosketustyökierto { $cycle } Suorakulmion mittaus sisäpuolella
log-rectangular-stud-title = Mittauspöytäkirja Kosketustyökierto { $cycle } Suorakulmion mittaus ulkopuolella
log-slot-title = Mittauspöytäkirja Kosketustyökierto { $cycle } Leveyden mittaus sisäpuolella
log-ridge-title = Mittauspöytäkirja Kosketustyökierto { $cycle } Uuman mittaus ulkopuolella
log-coordinate-title = Mittauspöytäkirja Kosketustyökierto { $cycle } Koordinaatin mittaus
log-bolt-circle-title = Mittauspöytäkirja Kosketustyökierto { $cycle } Reikäympyrän mittaus
log-plane-title = Mittauspöytäkirja Kosketustyökierto { $cycle } Tason mittaus
log-stud-greatest = Kaulan suurin mitta:
log-stud-least = Kaulan pienin mitta:
log-side-main = Sivun pituus pääakselilla:
log-side-minor = Sivun pituus sivuakselilla:
log-side-main-greatest = Pääakselin sivun pituuden suurin mitta:
log-side-main-least = Pääakselin sivun pituuden pienin mitta:
log-side-minor-greatest = Sivuakselin sivun pituuden suurin mitta:
log-side-minor-least = Sivuakselin sivun pituuden pienin mitta:
log-greatest = Suurin mitta:
log-least = Pienin mitta:
log-length = Pituus:
log-centre-line = Keskiakselin sijainti:
log-angle = Kulma:
log-coordinate = Koordinaatti:
log-bolt-circle-diameter = Reikäympyrän halkaisija:
log-plane-angle-a = A-akselin projektiokulma:
log-plane-angle-a__tnc426-430 = A-akselin kulma:
log-plane-angle-b = B-akselin projektiokulma:
log-plane-angle-b__tnc426-430 = B-akselin kulma:
log-spatial-angle-a = Tilakulma A:
log-spatial-angle-b = Tilakulma B:
log-spatial-angle-c = Tilakulma C:
log-first-in-probe-axis = Mittausarvo kosketusakselilla (ensimmäinen mittaus):
log-first-in-probe-axis__tnc320 = Mittausarvo kosketusjärjestelmän akselilla:
log-second-in-probe-axis = Mittausarvo kosketusakselilla (toinen mittaus):
log-third-in-probe-axis = Mittausarvo kosketusakselilla (kolmas mittaus):

# --- työkierron 444 pöytäkirja ---
log-surface-title = Mittausprotokolla Kosketustyökierto { $cycle } Kosketus 3D
log-main-axis = Pääakseli
log-minor-axis = Sivuakseli
log-tool-axis = Työkaluakseli
log-probing-direction = Todellinen kosketussuunta
log-nominal-coordinate = Asetuskoordinaatti
log-actual-coordinate = Olokoordinaatti
log-upper-deviation = Ylämittapoikkeama
log-lower-deviation = Alamittapoikkeama
log-deviation-along-normal = Poikkeama normaalivektorin suunnassa
log-deviation-3d = 3D-poikkeama
log-workpiece-status = Työkappaleen tila
log-status-undefined = ei määritelty
log-status-good = hyväksytty
log-status-rework = jälkityöstö
log-status-scrap = hylätty

# --- kinematics ---
log-kinematics-memory-title = Pöytäkirja Kosketustyökierto { $cycle } Kinematiikan tallennus
log-measure-kinematics-title = Mittauspöytäkirja Kosketustyökierto { $cycle } Kinematiikan mittaus
log-preset-compensation-title = Mittauspöytäkirja Kosketustyökierto { $cycle } Esiasetuksen kompensointi
log-mode = Tila:
log-kinematics = Aktiivinen kinematiikka:
log-memory = Muistipaikka:
log-memories = Tallennetut kinematiikat:
log-kinematics-saved = Tallennetut akselit ja muunnokset:
log-kinematics-before = Muunnokset ennen palautusta:
log-kinematics-after = Muunnokset palautuksen jälkeen:
log-rotary-axis = Kiertoakseli
log-centre-of-axis = keskipiste
log-direction-of-axis = kallistus
log-preset-shift = Esiasetuksen siirtymä:
log-sphere-radius = Annettu kuulan säde:
log-start-angle = Aloituskulma:
log-end-angle = Lopetuskulma:
log-incidence-angle = Asetuskulma:
log-measuring-points = Mittauspisteiden lukumäärä:
log-scatter-measured = Mitattu hajonta:
log-scatter-optimized = Optimoitu hajonta:
log-greatest-error = Suurin virhe:
log-angular-error = Kulmavirhe:
log-mean-backlash = Keskimääräinen välys:
log-mean-positioning-error = Keskimääräinen paikoitusvirhe:
log-measuring-circle = Mittausympyrän säde:
log-compensation = Korjausarvot:
log-rating = Mittauspisteiden arviointi:
log-uncertainty = Mittausepävarmuus (astetta/µm):

# --- masks of formatted output (FN 16): how the keywords of a control name this language ---
log-mask-language = Finnish
