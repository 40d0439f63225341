; control: tnc640  what comments take back, and what is wrong with such comments
0 BEGIN PGM ALLOW MM
1 TOOL CALL 5 Z S2000 F500
2 L X+0 Y+0 FMAX M3
5 FOO ; Ciklo: Allow syntax-unknown-block an older control reads it
6 FOO ; ciklo: allow syntax-unknown-block
7 FOO ; ciklo: allow out-of-range the wrong one
8 FOO ; ciklo: allow no-such-rule because
9 FOO ; ciklo: deny nothing
3 ; ciklo: allow defined-but-never-called called by the machine builder's macro
4 CYCL DEF 200 DRILLING
  Q200=2 ;SET-UP CLEARANCE
  Q201=-15 ;DEPTH
  Q206=250 ;FEED RATE FOR PLNGNG
  Q202=5 ;PLUNGING DEPTH
  Q210=0 ;DWELL TIME AT TOP
  Q203=+20 ;SURFACE COORDINATE
  Q204=100 ;2ND SET-UP CLEARANCE
  Q211=0 ;DWELL TIME AT DEPTH
10 END PGM ALLOW MM
