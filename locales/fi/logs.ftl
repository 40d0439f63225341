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
