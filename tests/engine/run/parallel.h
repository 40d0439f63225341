; control: tnc640
; What follows each block in brackets is calculated by hand.
BEGIN PGM PARALLEL MM
TOOL CALL 1 Z S1000 F300
L X+0 Y+0 Z+50 R0 FMAX
FUNCTION PARAXCOMP DISPLAY W
L W-20 F500 ; [W alone: 500]
L X+30 Y+40 W-10 F1000 ; [tool 50 mm at 1000, W 10 mm in the same time: 200]
L IW+5 FMAX ; [to -5, rapid]
L W-5 F100 ; [nothing]
L Z+60 U+3 FMAX
FUNCTION PARAXCOMP OFF
FUNCTION PARAXMODE OFF
W+0 F100 ; [a block of the axis alone: 100]
FUNCTION PARAXCOMP MOVE W
L W-10 F200 ; [Z takes the way back, from 60 to 70: the tool stays]
FUNCTION PARAXCOMP OFF
L Z+50 M91 FMAX ; [the axis Z goes from 70 to 50, the tool with it from 60 to 40]
FUNCTION PARAXMODE X Y W
L X+0 Z+30 F1000 ; [W moves, by 10 from -10 to -20]
L Z+70 FMAX ; [W alone is the rapid rate]
FUNCTION PARAXMODE OFF
L W+21 F100 ; [by itself again, from 20]
L Z+60 F1000 ; [Z]
END PGM PARALLEL MM
