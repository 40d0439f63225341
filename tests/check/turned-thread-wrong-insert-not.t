BEGIN TOOL .T MM
T    NAME             L         R         R2        DL     DR     TYP   LCUTS   PITCH CUT
40   TURN_R04         +90       +0        +0        +0     +0     TURN  +0      +0    1
43   THREAD_60        +90       +0        +0        +0     +0     TURN  +0      +2    1
[END]
