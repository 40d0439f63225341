BEGIN TOOL .T MM
T     NAME              L          R          R2        DL      DR      TYP     LCUTS    ANGLE   T-ANGLE  PITCH    CUT
1     MILL_D10          +80.000    +5.000     +0.000    +0      +0      MILL    30       5       0        0        3
[END]
