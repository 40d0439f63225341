; control: tnc640
BEGIN PGM CONTOUR MM
; What happens between two elements keeps its order; the roundings count with the contour, not with the path.
TOOL CALL 1 Z S3000 F400 DR+0.5
L X-20 Y-20 R0 FMAX M3
L Z-5 F100
APPR LCT X+0 Y+10 R4 RL F300 M8
FN 0: Q1 = +40
L Y+Q1
RND R6 F150
Q2 = Q1 + 10
L X+50 Y+Q2
M9
CHF 3
L X+65 Y+35
CT X+80 Y+10
CYCL DEF 9.0 DWELL TIME
CYCL DEF 9.1 DWELL 0.5
CC X+70 Y+10
CP IPA-90 IZ-1 DR-
L X+0 M5
DEP LT LEN20 Z+50 F2000
STOP
END PGM CONTOUR MM
