BEGIN TOOL .T MM
T       NAME             L          R          R2      DL      DR      DR2     TL  CUT   LCUTS   T-ANGLE   TYP     PITCH   ANGLE
1       EM_D12           100        6          0       0       0       0           3     30      0         MILL    0       5
[END]
