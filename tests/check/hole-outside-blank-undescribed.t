BEGIN TOOL .T MM
T       NAME             L          R          R2      DL      DR      DR2     TL  CUT   LCUTS   T-ANGLE   TYP     PITCH   ANGLE
1       MILL_D10         80         5          0       0       0       0           3     25      0         MILL    0       5
2       DRILL_D8         110        4          0       0       0       0           2     60      118       DRILL   0       0
11      TURN_OUT_80      135        0.8        0       0       0       0           1     12      0         TURN    0       0
[END]
