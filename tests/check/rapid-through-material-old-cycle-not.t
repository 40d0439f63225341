BEGIN TOOL .T MM
T    NAME             L          R          R2       DL      DR      CUT  LCUTS   ANGLE   TYP
1    SLOT_DRILL_D16   +100       +8         +0       +0      +0      2    30      4       MILL
2    DRILL_D8         +110       +4         +0       +0      +0      2    60      0       DRILL
[END]
