# Naslovi slik stružnih ciklov.

figure-turning-roughing = Grobo obdelovanje
figure-turning-finishing = Fino obdelovanje
figure-turning-inside = Notranja stran
figure-turning-system = Koordinatni sistem
figure-turning-reversed-tool = Obrnjeno orodje
figure-turning-smoothing = Glajenje konture
figure-turning-start-element = Element na začetku
figure-turning-end-element = Element na koncu
figure-turning-elements = Posneti rob, zaokrožitev in polmer vogala
figure-turning-angles = Koti
figure-turning-limit = Omejitev reza
figure-turning-reversal = Smer konture
figure-turning-undercut = Potopni elementi
figure-turning-cutting-lines = Rezne črte
figure-turned-thread = Navoj
figure-thread-position = Zunanji ali notranji navoj
figure-thread-orientation = Vzdolžno ali prečno
figure-turning-infeed = Primik
figure-turning-infeed-type = Vrsta primika
figure-turning-depth = Globina in iztek
figure-recess-offset = Širina zamika
figure-recess-compensation = Popravek globine
figure-recess-direction = Smer obdelave
figure-text-on-arc = Besedilo na loku
figure-text-arrangement = Besedilo naravnost ali na loku
figure-around-cylinder = Okoli valja
