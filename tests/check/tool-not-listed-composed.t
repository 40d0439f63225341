BEGIN TOOL .T MM
T    NAME             L         R         R2        DL     DR     TYP   LCUTS   ANGLE  T-ANGLE PITCH CUT
1    MILL_D10         +90       +5        +0        +0     +0     MILL  +25     +90    +0      +0    4
2    DRILL_D6.8       +110      +3.4      +0        +0     +0     DRILL +60     +0     +118    +0    2
3    TAP_M8           +100      +4        +0        +0     +0     TAP   +22     +0     +0      +1.25 1
4    SPOT_D10         +80       +5        +0        +0     +0     CENT  +10     +0     +90     +0    2
5    MILL_D20         +100      +10       +0        +0     +0     MILL  +40     +90    +0      +0    4
6    MILL_D8          +70       +4        +0        +0     +0     MILL  +20     +90    +0      +0    3
7    REAMER_D10       +120      +5        +0        +0     +0     REAM  +40     +0     +0      +0    6
8    DRILL_D9.8       +120      +4.9      +0        +0     +0     DRILL +80     +0     +118    +0    2
9    DRILL_D20        +140      +10       +0        +0     +0     DRILL +90     +0     +118    +0    2
10   BORE_D32         +150      +16       +0        +0     +0     BOR   +60     +0     +0      +0    1
11   BACKBORE_D28     +150      +14       +0        +0     +0     BCKBOR +45    +0     +0      +0    1
12   DRILL_D12        +140      +6        +0        +0     +0     DRILL +60     +0     +118    +0    2
20   PROBE            +120      +2        +0        +0     +0     TCHP  +0      +0     +0      +0    0
[END]
