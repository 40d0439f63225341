BEGIN TOOL .T MM
T       NAME             L          R          R2      DL      DR      DR2     TL  CUT   LCUTS   T-ANGLE   TYP     PITCH   ANGLE
1       FACE_D20         100        10         0       0       0       0           2     60      0         MILL    0       0
2       EM_D6_LINKS      100        3          0       0       0       0           2     60      0         MILL    0       0
[END]
