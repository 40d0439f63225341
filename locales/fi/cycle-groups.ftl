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
