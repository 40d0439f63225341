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

# Cycles that a manual only names, and that no specification describes.
named-cycl-def-30 = Obdelava podatkov 3D
named-cycl-def-39 = Zunanja kontura na plašču valja
named-cycl-def-212 = Cikel 212
named-cycl-def-213 = Fino rezkanje čepa
named-cycl-def-270 = Podatki konturnega segmenta
named-cycl-def-275 = Trohoidni konturni utor
named-cycl-def-290 = Interpolacijsko struženje
named-tch-probe-4 = 3D-merjenje
named-tch-probe-9 = Umerjanje dolžine tipalnega sistema
named-tch-probe-440 = Merjenje zamika osi
named-tch-probe-441 = Hitro tipanje
