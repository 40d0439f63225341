# Words of the measuring logs.

# --- log of cycle 421 ---
log-hole-title = Merilni protokol za tipalni cikel { $cycle } – merjenje vrtine
log-date = Datum:
log-time = Čas:
log-program = Merilni program:
log-nominal-values = Želene vrednosti:
log-limits = Vnaprej določene mejne vrednosti:
log-actual-values = Dejanske vrednosti:
log-deviations = Odstopanja:
log-centre-main = Sredina glavne osi:
log-centre-minor = Sredina pomožne osi:
log-diameter = Premer:
log-centre-main-greatest = Največja vrednost središča glavne osi:
log-centre-main-least = Najmanjša vrednost središča glavne osi:
log-centre-minor-greatest = Največja vrednost središča pomožne osi:
log-centre-minor-least = Najmanjša vrednost središča pomožne osi:
log-hole-greatest = Največji premer vrtine:
log-hole-least = Najmanjši premer vrtine:
log-further-results = Ostali merilni rezultati:
log-measuring-height = Izmerjena višina:
log-end = Konec merilnega protokola

# --- log of cycle 444 ---
log-surface-title = Merilni protokol za tipalni cikel { $cycle } – tipanje 3D
log-main-axis = Glavna os
log-minor-axis = Pomožna os
log-tool-axis = Orodna os
log-probing-direction = Dejanska smer tipanja
log-nominal-coordinate = Želena koordinata
log-actual-coordinate = Dejanska koordinata
log-upper-deviation = Zgornje odstopanje
log-lower-deviation = Spodnje odstopanje
log-deviation-along-normal = Odstopanje vzdolž normalnega vektorja
log-deviation-3d = 3D-odstopanje
log-workpiece-status = Stanje obdelovanca
log-status-undefined = nedoločeno
log-status-good = dobro
log-status-rework = dodatna obdelava
log-status-scrap = izvržek
