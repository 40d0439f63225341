BEGIN TOOL .T MM
T       NAME             L          R          R2         TL  CUT   LTOL      DIRECT.   TIME1     DOC
1       DRILL_D10        102.5      x5         0          X   120   0.05      -
1       MILL_D20         88.25      10         0          L   4     1.5       3
