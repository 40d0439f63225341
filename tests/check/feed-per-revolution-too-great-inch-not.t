BEGIN TOOL .T MM
T     NAME              L          R          R2        DL      DR      TYP     LCUTS    ANGLE   T-ANGLE  PITCH    CUT
3     REAMER_3/8        +120.000   +4.763     +0.000    +0      +0      REAM    40       0       0        0        6
[END]
