BEGIN TOOL .T MM
T    NAME             L         R         R2        DL     DR     TYP   LCUTS   ANGLE  T-ANGLE PITCH CUT
3    MILL_D12         +90       +6        +0        +0     +0     MILL  +25     +90    +0      +0    4
9    CAL_PIN_D16      +80       +8        +0        +0     +0           +0      +0     +0      +0    0
[END]
