BEGIN TOOL .T MM
T     NAME              L          R          R2        DL      DR      TYP     LCUTS    ANGLE   T-ANGLE  PITCH    CUT
1     MILL_D10          +80.000    +5.000     +0.000    +0      +0      MILL    30       5       0        0        3
2     DRILL_D9.8        +120.000   +4.900     +0.000    +0      +0      DRILL   70       0       118      0        2
3     REAMER_D10H7      +120.000   +5.000     +0.000    +0      +0      REAM    40       0       0        0        6
[END]
