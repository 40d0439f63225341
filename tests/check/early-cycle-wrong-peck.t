BEGIN TOOL .T MM
T       NAME             L          R          R2      DL      DR      DR2     TL  CUT   LCUTS   T-ANGLE   TYP     PITCH   ANGLE
1       EM_D8            100        4          0       0       0       0           2     30      0         MILL    0       0
3       DRILL_D6.8       100        3.4        0       0       0       0           2     60      118         DRILL   0       0
4       TAP_M8           100        4          0       0       0       0           2     60      0         TAP     1.25       0
[END]
