BEGIN TOOL .T MM
T    NAME             L          R          R2       DL      DR      CUT  LCUTS   ANGLE   TYP
1    MILL_D16         +100       +8         +0       +0      +0      4    40      5       MILL
[END]
