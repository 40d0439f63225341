# Tables that cycles read or write; see the English file.
table-tool = Tabella utensili
table-preset = Tabella Preset
table-datum = Tabella origini
table-probe = Tabella del sistema di tastatura
table-kinematics = Tabella cinematica
