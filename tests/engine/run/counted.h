; control: tnc640
; M144: the linear axes stay when rotary axes turn, and positions count from where these have brought the tool.
; The head turns about B, its pivot 100 mm above the tip (20 to the spindle nose and a tool of 80). What follows each block in brackets is calculated by hand.
BEGIN PGM COUNTED MM
TOOL CALL 1 Z S1000 F300
L X+0 Y+0 Z+50 B+0 R0 FMAX
L B+90 FMAX M144 ; [the tip swings from below the pivot to -X of it: program coordinates X -100, Z 150; the axes stay]
L X-50 F500 ; [the axes go from X 0 to 50]
L B+0 FMAX ; [the tip is below the pivot again: X 50, Z 50]
L Z+40 F500 M145 ; [the same place by the axes]
L B+90 FMAX ; [not counted: X 50, Z 40 remain]
END PGM COUNTED MM
