BEGIN TOOL .T MM
T       NAME             L          R          R2      DL      DR      DR2     TL  CUT   LCUTS   T-ANGLE   TYP     PITCH   ANGLE
1       MILL_D20         100        10         0       0       0       0           4     35      0         MILL    0       5
2       MILL_D8          80         4          0       0       0       0           3     20      0         MILL    0       5
3       THREADMILL_P2    110        6          0       0       0       0           4     12      0         GF      2       0
4       DRILL_D12        110        6          0       0       0       0           2     60      118       DRILL   0       0
5       BORE_BAR_D20     140        10         0       0       0       0           1     10      0         BORING  0       0
6       REAMER_D10       130        5          0       0       0       0           6     40      0         REAM    0       0
[END]
