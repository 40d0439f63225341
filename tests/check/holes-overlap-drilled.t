BEGIN TOOL .T MM
T    NAME             L          R          R2       DL      DR      CUT  LCUTS   ANGLE   TYP
1    DRILL_D28        +150       +14        +0       +0      +0      2    90      0       DRILL
2    DRILL_D7         +110       +3.5       +0       +0      +0      2    60      0       DRILL
3    MILL_D8          +90        +4         +0       +0      +0      4    24      5       MILL
[END]
