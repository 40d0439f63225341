0  BEGIN PGM habits mm
;; two marks begin a comment
* - structure
1 ; a long comment that goes ~
  on in the next line ~
  and ends here
2 l x10 y20.5 z.5 r0 fmax m3
3	L	X+10	Y5.	RL	F MAX
7 L R0 FMAX M91
7 L
5 L X+10,5 Y-,5 F Max M99
L X+Q1 Y-Q2 Z Q3 R0 F AUTO
4 CYCL DEF9.0 DWELL
4 CYCL DEF9.1 DWELL3.5
6 cycl def 200 drilling~
    q200=+2 ;clearance ~
    Q201= - 3 ;DEPTH~
    Q206= AUTO ;FEED~
    Q202=5. ~ ;PLUNGING
    QS330="DRILL" ;TOOL
8 Q1 = - 3
9 Q2 = .5 * ( 5. + 2,5 )
10 q3 = sin q1 + +Q2
11 QR4 = -Q1 + - Q2
12 fn 0:q5=+5
13 IF +Q5 EQU -,5 GOTO LBL 2
14 L X+1 ; a comment behind a block that ~
   goes on as text
15 CC X 0 Y 0
16 c x0 y-10 dr -
17 CR X+5 Y+5 R 5 DR+ FQ5
18 TOOL CALL 5 z s2000 dr-0.1
19 tool call "mill" Z S( VC = 120 )
20 TOOL DEF 3.1
21 TOOL DEF "NEXT"
22 CALL LBL 1 REP 3/3
23 /L X+5
/24 L X+6
N25 L XQL1 IYQR2 FQL20 M140 MBQ5
26 TOOL CALL QS1 Z SQL5 DRQR2 FQ1
27 FN 18: SYSREAD QL1 = ID230 NR2 IDX1
N28 STOP M36
27 CYCL DEF 247 DATUM SETTING ; the vice ~
   on the left ~
   Q339=+1 ;ROW 1, as the~
   plan says
27 CYCL DEF 247 DATUM SETTING ~
   Q339=+1 ;ROW ~
   Q340 +1 ;TORN ~
28 LX+10IY-5R0FMAXM3
29 CYCL DEF9 .0 DWELL
30 CYCL DEF 253 SLOT~
   Q207= F MAX ;FEED
26 END PGM habits MM
