BEGIN TOOL .T MM
T    NAME             L          R          R2       DL      DR      CUT  LCUTS   ANGLE   TYP
1    SPOT_DRILL       +100       +5         +0       +0      +0      2    10      0       CENT
2    DRILL_D6         +110       +3         +0       +0      +0      2    60      0       DRILL
[END]
