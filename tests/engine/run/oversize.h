; control: tnc640
; A tool with oversizes touches a surface where the one without them does. What follows each block in brackets is
; calculated by hand.
BEGIN PGM OVERSIZE MM
TOOL CALL 1 Z S1200 F300
L X+0 Y+0 Z+10 R0 FMAX M3
LN X+10 Y+0 Z+0 NX+0 NY+0 NZ+1 F500 ; [upright: nothing is moved]
M107
TOOL CALL 2 Z S1200 F300
LN X+20 Y+0 Z+0 NX+0 NY+0 NZ+1 ; [the tip touches: nothing is moved]
LN X+30 NX+1 NY+0 NZ+0 ; [0.5 ahead, and 0.5 down: the middle of the greater ball is as high as that of the other; 30.5, 0, -0.5]
LN X+40 NX+0.6 NY+0 NZ+0.8 ; [0.5 * (0.6, 0, -0.2): 40.3, 0, -0.1]
LN IY+10 NX+3 NY+0 NZ+4 ; [from the programmed position: 40.3, 10, -0.1]
L X+50 ; [50, 10, 0]
TOOL CALL 1 Z S1200 F300 DR-0.2
LN X+60 NX+0 NY-0.6 NZ+0.8 ; [an end mill: -0.2 across; 60, 10.2, 0]
L X+Q108 Y+0 Z+10 FMAX ; [the active radius, 5 - 0.2 = 4.8, in Q108: 4.8, 0, 10]
END PGM OVERSIZE MM
