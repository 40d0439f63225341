BEGIN TOOL .T MM
T       NAME             L          R          R2      DL      DR      DR2     TL  CUT   LCUTS   T-ANGLE   TYP     PITCH   ANGLE
2       CHAMFER_90       100        0.25       0       0       0       0           3     6       90        MILL    0       0
[END]
