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

# --- logs of the other measuring cycles ---
log-angle-title = Merilni protokol za tipalni cikel { $cycle } – merjenje kota
log-stud-title = Merilni protokol za tipalni cikel { $cycle } – meritev zunaj kroga
log-pocket-title = Merilni protokol za tipalni cikel { $cycle } – meritev znotraj pravokotnika
log-rectangular-stud-title = Merilni protokol za tipalni cikel { $cycle } – meritev zunaj pravokotnika
log-slot-title = Merilni protokol za tipalni cikel { $cycle } – meritev notranje širine
log-ridge-title = Merilni protokol za tipalni cikel { $cycle } – meritev zunaj stojine
log-coordinate-title = Merilni protokol za tipalni cikel { $cycle } – merjenje koordinate
log-bolt-circle-title = Merilni protokol za tipalni cikel { $cycle } – merjenje krožne luknje
log-plane-title = Merilni protokol za tipalni cikel { $cycle } – merjenje ravnine
log-stud-greatest = Največji premer čepa:
log-stud-least = Najmanjši premer čepa:
log-side-main = Stranska dolžina na glavni osi:
log-side-minor = Stranska dolžina na pomožni osi:
log-side-main-greatest = Največja vrednost stranske dolžine na glavni osi:
log-side-main-least = Najmanjša vrednost stranske dolžine na glavni osi:
log-side-minor-greatest = Največja vrednost stranske dolžine na pomožni osi:
log-side-minor-least = Najmanjša vrednost stranske dolžine na pomožni osi:
log-greatest = Največja vrednost:
log-least = Najmanjša vrednost:
log-length = Dolžina:
log-centre-line = Položaj srednje osi:
log-angle = Kot:
log-coordinate = Koordinata:
log-bolt-circle-diameter = Premer krožne luknje:
log-plane-angle-a = Projekcijski kot osi A:
log-plane-angle-a__tnc426-430 = Kot osi A:
log-plane-angle-b = Projekcijski kot osi B:
log-plane-angle-b__tnc426-430 = Kot osi B:
log-spatial-angle-a = Prostorski kot A:
log-spatial-angle-b = Prostorski kot B:
log-spatial-angle-c = Prostorski kot C:
log-first-in-probe-axis = Merilna vrednost na osi tipalnega sistema (prva meritev):
log-first-in-probe-axis__tnc320 = Merilna vrednost na osi tipalnega sistema:
log-second-in-probe-axis = Merilna vrednost na osi tipalnega sistema (druga meritev):
log-third-in-probe-axis = Merilna vrednost na osi tipalnega sistema (tretja meritev):

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

# --- kinematics ---
log-kinematics-memory-title = Protokol za tipalni cikel { $cycle } – shranjevanje kinematike
log-measure-kinematics-title = Merilni protokol za tipalni cikel { $cycle } – merjenje kinematike
log-preset-compensation-title = Merilni protokol za tipalni cikel { $cycle } – kompenzacija prednastavitve
log-mode = Način:
log-kinematics = Aktivna kinematika:
log-memory = Oznaka pomnilnika:
log-memories = Shranjene kinematike:
log-kinematics-saved = Shranjene osi in pretvorbe:
log-kinematics-before = Pretvorbe pred obnovitvijo:
log-kinematics-after = Pretvorbe po obnovitvi:
log-rotary-axis = Rotacijska os
log-centre-of-axis = središče
log-direction-of-axis = nagib
log-preset-shift = Zamik prednastavitve:
log-sphere-radius = Vneseni polmer krogle:
log-start-angle = Začetni kot:
log-end-angle = Končni kot:
log-incidence-angle = Naklonski kot:
log-measuring-points = Število merilnih točk:
log-scatter-measured = Izmerjena razpršitev:
log-scatter-optimized = Optimirana razpršitev:
log-greatest-error = Največja napaka:
log-angular-error = Napaka kota:
log-mean-backlash = Povprečna zračnost:
log-mean-positioning-error = Povprečna pozicionirna napaka:
log-measuring-circle = Polmer merilnega kroga:
log-compensation = Popravki:
log-rating = Ocena merilnih točk:
log-uncertainty = Merilna nenatančnost (stopinj na µm):

# --- masks of formatted output (FN 16): how the keywords of a control name this language ---
log-mask-language = Slovenian
