BEGIN TOOL .T MM
T       NAME             L          R          R2      DL      DR      DR2     TL  CUT   LCUTS   T-ANGLE   TYP     PITCH   ANGLE
5       DRILL_D25        180        12.5       0       0       0       0           2     100     140       DRILL   0       0
8       TURN_ROUGH       120        0          0       0       0       0           0     0       80        TURN    0       0
9       TURN_BORE_D20    190        0          0       0       0       0           0     0       0         TURN    0       0
12      RECESS_3         130        0          0       0       0       0           0     0       0         TURN    0       0
[END]
