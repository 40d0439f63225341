# Titles of the groups of cycles; see the English file.
cycle-group-drilling = Foratura
cycle-group-threads = Maschiatura e fresatura di filetti
cycle-group-pockets = Tasche, isole e scanalature
cycle-group-patterns = Sagome di punti
cycle-group-contours = Profili e superfici cilindriche
cycle-group-surfaces = Spianatura di superfici
cycle-group-transforms = Conversioni di coordinate
cycle-group-special = Funzioni speciali
cycle-group-turning = Tornitura
cycle-group-rotation = Posizione obliqua del pezzo
cycle-group-datum = Impostazione dell’origine
cycle-group-measuring = Misurazione di pezzi
cycle-group-calibration = Calibrazione del sistema di tastatura
cycle-group-kinematics = Misurazione cinematica
cycle-group-tool-measurement = Misurazione utensili
cycle-group-digitizing = Digitalizzazione

# Cycles that a manual only names, and that no specification describes.
named-cycl-def-30 = Lavorazione dati 3D
named-cycl-def-39 = Profilo esterno su superficie cilindrica
named-cycl-def-212 = Ciclo 212
named-cycl-def-213 = Finitura isola
named-cycl-def-270 = Dati contornatura profilo
named-cycl-def-275 = Scanalatura profilo trocoidale
named-cycl-def-290 = Tornitura in interpolazione
named-tch-probe-4 = Misurazione 3D
named-tch-probe-9 = Calibrazione lunghezza TS
named-tch-probe-440 = Misurazione offset assi
named-tch-probe-441 = Tastatura rapida
