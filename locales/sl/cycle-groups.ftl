# Titles of the groups of cycles.
cycle-group-drilling = Vrtanje
cycle-group-threads = Vrtanje navojev in rezkanje navojev
cycle-group-pockets = Žepi, čepi in utori
cycle-group-patterns = Točkovni vzorci
cycle-group-contours = Konture in plašč valja
cycle-group-surfaces = Vrstno rezkanje
cycle-group-transforms = Preračunavanje koordinat
cycle-group-special = Posebne funkcije
cycle-group-turning = Struženje
cycle-group-rotation = Poševni položaj obdelovanca
cycle-group-datum = Določanje referenčnih točk
cycle-group-measuring = Merjenje obdelovancev
cycle-group-calibration = Umerjanje tipalnega sistema
cycle-group-kinematics = Merjenje kinematike
cycle-group-tool-measurement = Merjenje orodij
cycle-group-digitizing = Digitaliziranje
