0 ; a part
1 BEGIN PGM PART MM
2 BLK FORM 0.1 Z X+0 Y+0 Z-40
3 BLK FORM 0.2 X+100 Y+100 Z+0
4 TOOL DEF 1 L+0 R+5
5 TOOL CALL 1 Z S3500 F500 DL+0.2 DR-0.1 DR2+0.05
6 M3
7 L Z+250 R0 FMAX
8 L X-30 Y+50 FMAX
/9 L Z-5 F200 ; down
10 L X+5 Y+50 RL F300
11 ; G26 R2
12 CC X+15 Y+30
13 C X+6,645 Y+35.495 DR-
14 CT X+55.505 Y+69.488
15 CR X+58.995 Y+30.025 R+20 DR-
16 CC X-5 Y+Q2
17 C IX+5 Y+Q1 DR+
18 CHF 10
19 RND R5 F100
20 Z+Q1
21 X+40 R+ F100 M3
22 IY-10.5 R-
23 ; G07 G43 X+1 Y+2
24 ; G01 G43 X+1
25 CC X+50 Y+50
26 LP PR+45 PA+180
27 CP IPA+1080 IZ+5 DR+
28 CP IPA+30 DR+ ; (bent)
29 CTP IPR+30 IPA-Q5
30 LP IPR+10 IPAQ5 FMAX
31 CC
32 ; G27 R2 M30
33 LP R0 FMAX
34 TOOL CALL S2000
35 M5 M9
36 M140 MB MAX
37 STOP M8
38 TOOL DEF 12
39 TOOL CALL "MILL 10" Z S1000
40 LBL 1
41 CALL LBL 1
42 CALL LBL "SUB" REP 3
43 CALL LBL Q5
44 LBL "SUB"
45 LBL 0
46 FN 0: Q5 = +60
47 FN 2: Q1 = -Q2 - -5
48 FN 9: IF +Q1 EQU +Q3 GOTO LBL "END"
49 FN 14: ERROR = 1000
50 FN 18: SYSREAD Q25 = ID210 NR4 IDX3
51 FN 19: PLC = +10 / +Q3
52 FN 16: F-PRINT TNC:\MASK.A/TNC:\PROT.TXT
53 FN 26: TABOPEN TNC:\TAB1.TAB
54 Q1 = ( Q2 + 3 ) * 2
55 QS1 = "a;b" || QS2
56 SEL TABLE "ZERO.D"
57 SEL PGM "OTHER.I"
58 CALL SELECTED PGM
59 CALL PGM TNC:\SUB\HOLES.I
60 CALL PGM "HOLES.I"
61 CYCL DEF 200 ~
    Q200=2 ~
    Q201=-20 ~
    Q206=150 ~
    Q202=5 ~
    Q210=0 ~
    Q203=+0 ~
    Q204=50 ~
    Q211=0.25
62 CYCL DEF 203 UNIVERSAL DRILLING ~
    Q200=+2 ;SET-UP CLEARANCE ~
    Q201=-20 ;DEPTH ~
    Q206=FAUTO ;PLUNGING FEED
63 CYCL CALL M3
64 CYCL CALL POS X+10 Y+20 Z+5 F400
65 L X+30 Y+20 FMAX M8
66 CYCL CALL
67 CYCL CALL PAT F500 M3
68 CYCL DEF 7.0
69 CYCL DEF 7.1 X+25
70 CYCL DEF 7.2 Y-12.5
71 CYCL DEF 7.3 Z+100
72 CYCL DEF 7.0
73 CYCL DEF 7.1 #12
74 CYCL DEF 8.0
75 CYCL DEF 8.1 X Y
76 CYCL DEF 10.0
77 CYCL DEF 10.1 IROT+25
78 CYCL DEF 11.0
79 CYCL DEF 11.1 VALUE: 0.98
80 CYCL DEF 19.0
81 CYCL DEF 19.1 A+0 B+45 C+0
82 CYCL DEF 9.0
83 CYCL DEF 9.1 VALUE: 1.5
84 CYCL DEF 13.0
85 CYCL DEF 13.1 VALUE: 90
86 CYCL DEF 12.0
87 CYCL DEF 12.1 VALUE: "TNC:\KLAR35\FK1\50.H"
88 CYCL DEF 14.0
89 CYCL DEF 14.1 VALUE: 1/2
90 CYCL DEF 32.0
91 CYCL DEF 32.1 T0.05
92 CYCL DEF 32.2 HSC-MODE:0 TA5
93 TCH PROBE 0.0 Q10 X-
94 TCH PROBE 0.1 X+25 Y+10 Z-20
95 ; G83 P01 2 P02 -20 P03 -5 P04 0 P05 500
96 TCH PROBE 410 ~
    Q321=+50 ;CENTRE OF AXIS 1 ~
    Q322=+50 ;CENTRE OF AXIS 2 ~
    Q323=60
97 PLANE SPATIAL SPA+0 SPB+45 SPC+0 STAY
98 * - a heading
99 ; G01 X+10 +
100 ; X+
101 ; G1000
102 ; (nothing)
103 CYCL DEF 200 ~
    Q200=2 ~
    Q206=150 ~
    Q201== 
104 L X5 Y-3 FMAX M3
105 END PGM PART MM
; 8:14 syntax-incomplete [("found", Text("")), ("expected", Text("*"))]
; 9:25 syntax-incomplete [("found", Text("")), ("expected", Text("*"))]
; 11:5 klartext-no-equivalent [("found", Text("G26 R2"))]
; 22:18 syntax-unexpected [("found", Text("Y+2")), ("expected", Text("word"))]
; 23:6 klartext-no-equivalent [("found", Text("G01 G43 X+1"))]
; 31:6 klartext-no-equivalent [("found", Text("G27 R2"))]
; 65:26 syntax-incomplete [("found", Text("")), ("expected", Text("*"))]
; 82:6 klartext-no-equivalent [("found", Text("G83 P01 2 P02 -20 P03 -5 P04 0 P05 500"))]
; 91:15 syntax-unexpected [("found", Text("+")), ("expected", Text("word"))]
; 91:16 syntax-incomplete [("found", Text("")), ("expected", Text("*"))]
; 92:6 iso-word-not-allowed [("found", Text("X+"))]
; 93:11 syntax-incomplete [("found", Text("")), ("expected", Text("number"))]
; 94:6 syntax-bracket-comment [("found", Text("(nothing)")), ("expected", Text("block"))]
; 96:6 syntax-unexpected [("found", Text("=")), ("expected", Text("parameter"))]
; 97:9 syntax-incomplete [("found", Text("")), ("expected", Text("*"))]
; 98:14 syntax-incomplete [("found", Text("")), ("expected", Text("*"))]
