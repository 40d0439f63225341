BEGIN TOOL .T MM
T       NAME             L          R          R2      DL      DR      DR2     TL  CUT   LCUTS   T-ANGLE   TYP     PITCH   ANGLE
1       THREADMILL_P1.5  80         6          0       0       0       0           4     25      0         GF      1.5     0
[END]
