BEGIN TOOL .T MM
T    NAME             L          R          R2       DL      DR      CUT  LCUTS   TYP
4    PARTING_2MM      +130       +0         +0.1     +0      +0      1    0       TURN
5    THREAD_OUT_60    +130       +0         +0.1     +0      +0      1    0       TURN
[END]
