BEGIN TOOL .T MM
T       NAME             L          R          R2      DL      DR      DR2     TL  CUT   LCUTS   T-ANGLE   TYP     PITCH   ANGLE
1       MILL_D8          80         4          0       0       0       0           3     25      0         MILL    0       5
2       DRILL_D8.5       110        4.25       0       0       0       0           2     60      118       DRILL   0       0
3       THREADMILL_M10   80         4.5        0       0       0       0           4     25      0         MILL    1.5     0
[END]
