BEGIN TOOL .T MM
T    NAME             L         R         R2        DL     DR     TYP   LCUTS   ANGLE  T-ANGLE PITCH CUT
1    MILL_D10         +90       +5        +0        +0     +0     MILL  +25     +90    +0      +0    4
2    DRILL_D6.8       +110      +3.4      +0        +0     +0     DRILL +60     +0     +118    +0    2
3    TAP_M8           +100      +4        +0        +0     +0     TAP   +22     +0     +0      +1.25 1
4    THREADMILL_P2    +80       +6        +0        +0     +0     MILL  +25     +0     +0      +2    4
5    ENDMILL_D20      +100      +10       +0        +0     +0     MILL  +40     +90    +0      +0    4
[END]
