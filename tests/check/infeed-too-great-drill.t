BEGIN TOOL .T MM
T       NAME             L          R          R2      DL      DR      DR2     TL  CUT   LCUTS   T-ANGLE   TYP     PITCH   ANGLE
1       DRILL_D6         100        3          0       0       0       0           3     70      140       DRILL   0       90
[END]
