BEGIN TOOL .T MM
T       NAME             L          R          R2      DL      DR      DR2     TL  CUT   LCUTS   T-ANGLE   TYP     PITCH   ANGLE
1       TM_DRILL_M8      95         3.2        0       0       0       0           2     18      90        DRILL   1.5     0
2       TAP_M8           95         4          0       0       0       0           3     20      0         TAP     1.5     0
[END]
