; control: tnc640
; The preset lies at 10, 20, 0 of the machine, its second datum at 100, 50, -20.
BEGIN PGM SECOND MM
TOOL CALL 1 Z S1200 F300
L X+0 Y+0 Z+50 R0 FMAX
L Z+30 R0 FMAX M91 ; [30 in the machine]
L X+5 Y-5 FMAX M92 ; [105, 45, 30 in the machine: 95, 25, 30 from the preset]
L IX+5 Z+0 F1000 M92 ; [110, 45, -20 in the machine]
END PGM SECOND MM
