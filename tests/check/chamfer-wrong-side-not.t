BEGIN TOOL .T MM
T     NAME              L          R          R2        DL      DR      TYP     LCUTS    ANGLE   T-ANGLE  PITCH    CUT
1     CHAMFER_MILL_90   +80.000    +6.000     +0.000    +0      +0      MILL    6        0       90       0        3
[END]
