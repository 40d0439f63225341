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
