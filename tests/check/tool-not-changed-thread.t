BEGIN TOOL .T MM
T     NAME              L          R          R2        DL      DR      TYP     LCUTS    ANGLE   T-ANGLE  PITCH    CUT
1     MILL_D12          +80.000    +6.000     +0.000    +0      +0      MILL    30       30      0        0        3
2     THREADMILL_P1.5   +80.000    +6.000     +0.000    +0      +0      MILL    25       0       0        1.5      3
[END]
