BEGIN TOOL .T MM
T     NAME              L          R          R2        DL      DR      TYP     LCUTS    ANGLE   T-ANGLE  PITCH    CUT
1     MILL_D10          +80.000    +5.000     +0.000    +0      +0      MILL    30       5       0        0        3
2     DRILL_D6.8        +120.000   +3.400     +0.000    +0      +0      DRILL   70       0       118      0        2
3     TAP_M8            +120.000   +4.000     +0.000    +0      +0      TAP     30       0       0        1.25     3
[END]
