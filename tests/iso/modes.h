0 BEGIN PGM MODES MM
1 BLK FORM 0.1 Z X+0 Y+0 Z-20
2 BLK FORM 0.2 X+100 Y+100 Z+0
3 TOOL CALL 1 Z S3000 F500
4 ; the subprogram leaves G91: the next block moves by 60
5 L Z+50 R0 FMAX M03
6 CALL LBL 1
7 L IX+60 IY+10 FMAX
8 L X+10 Y+10 FMAX
9 ; what comes back to G90 changes nothing
10 CALL LBL 2
11 L X+20 Y+20 FMAX
12 ; the second pass begins with G91
13 LBL 3
14 L X+30
15 L IZ-1
16 CALL LBL 3 REP 2
17 L Z+50 FMAX M30
18 LBL 1
19 L IZ-4 F200
20 LBL 0
21 ; after the subprogram before it in the text this one is still called with G90
22 LBL 2
23 L X+40 FMAX
24 L IX+5 FMAX
25 LBL 0
26 END PGM MODES MM
; 8:9 iso-mode-left-on [("found", Text("G90"))]
; 15:10 iso-mode-left-on [("found", Text("G90"))]
