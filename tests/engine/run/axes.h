; control: tnc640
; What follows each block in brackets is calculated by hand.
BEGIN PGM AXES MM
TOOL CALL 1 Z S1000 F300
L X+50 Y+0 Z+10 R0 FMAX
L C+90 F1000 M116 ; [distance 50 from the axis: 1000 / 50 * 180 / pi = 1145.9156 degrees/min]
L X+30 Y+40 F1000 ; [a straight way: 1000 mm/min]
L C+0 F1000 ; [the distance is 50 again: 1145.9156]
L X+0 Y+0 F1000
L C+10 F1000 ; [on the axis: as fast as it turns, 7200]
L C+0 F1000 M117 ; [1000 degrees/min]
L X+0 Y-30 Z+40 F1000
L A+10 F500 M116 ; [50 from the X axis: 500 / 50 * 180 / pi = 572.9578]
L A+0 F500 M117 ; [500 degrees/min]
L Z+200 FMAX
PLANE SPATIAL SPA+30 SPB+0 SPC+20 TURN FMAX TABLE ROT ; [A 30, C 20]
PLANE RESET TURN FMAX
M138 A
PLANE SPATIAL SPA+30 SPB+0 SPC+0 TURN FMAX TABLE ROT ; [A 30]
PLANE RESET TURN FMAX
M138
PLANE PROJECTED PROPR+0 PROMIN+30 ROT+0 TURN FMAX ; [as SPA+30: A 30]
PLANE RESET TURN FMAX
END PGM AXES MM
