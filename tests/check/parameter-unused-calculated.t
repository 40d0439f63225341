BEGIN TOOL .T MM
T       NAME             L          R          R2      DL      DR      DR2     TL  CUT   LCUTS   T-ANGLE   TYP     PITCH   ANGLE
3       DRILL_D8         100        4          0       0       0       0           2     60      118         DRILL   0       0
[END]
