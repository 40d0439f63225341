# Työkiertoryhmien otsikot.
cycle-group-drilling = Poraus
cycle-group-threads = Kierreporaus ja kierteen jyrsintä
cycle-group-pockets = Taskut, kaulat ja urat
cycle-group-patterns = Pistekuviot
cycle-group-contours = Muodot ja lieriövaipat
cycle-group-surfaces = Pintojen rivijyrsintä
cycle-group-transforms = Koordinaattimuunnokset
cycle-group-special = Erikoistoiminnot
cycle-group-turning = Sorvaus
cycle-group-rotation = Työkappaleen vino asento
cycle-group-datum = Peruspisteen asetus
cycle-group-measuring = Työkappaleen mittaus
cycle-group-calibration = Kosketusjärjestelmän kalibrointi
cycle-group-kinematics = Kinematiikan mittaus
cycle-group-tool-measurement = Työkalun mittaus
cycle-group-digitizing = Digitointi

# Cycles that a manual only names, and that no specification describes.
named-cycl-def-30 = 3D-tietojen suoritus
named-cycl-def-39 = Ulkopuolinen muoto lieriön vaipalla
named-cycl-def-212 = Työkierto 212
named-cycl-def-213 = Kaulan silitys
named-cycl-def-270 = Muotorailon tiedot
named-cycl-def-275 = Trokoidinen muotoura
named-cycl-def-290 = Interpolaatiosorvaus
named-tch-probe-4 = 3D-mittaus
named-tch-probe-9 = Kosketusjärjestelmän pituuden kalibrointi
named-tch-probe-440 = Akselisiirtymän mittaus
named-tch-probe-441 = Nopea kosketus
