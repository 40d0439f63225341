BEGIN TOOL .T MM
T    NAME             L         R         R2        DL     DR     TYP   LCUTS   ANGLE  T-ANGLE PITCH CUT
3    MILL_D8          +90       +4        +0        +0     +0     MILL  +25     +90    +0      +0    3
[END]
