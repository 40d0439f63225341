BEGIN TOOL .T MM
T       NAME             L          R          R2      DL      DR      DR2     TL  CUT   LCUTS   T-ANGLE   TYP     PITCH   ANGLE
1       EM_D12           100        6          0       0       0       0           2     30      0         MILL    0       0
2       EM_D10           100        5          0       0       0       0           2     30      0         MILL    0       0
6       GUN_DRILL_D8     100        4          0       0       0       0           2     90      118         DRILL   0       0
[END]
