%MODES G71 *
N10 G30 G17 X+0 Y+0 Z-20 *
N20 G31 G90 X+100 Y+100 Z+0 *
N30 T1 G17 S3000 F500 *
; the subprogram leaves G91: the next block moves by 60
N40 G00 G40 G90 Z+50 M03 *
N50 L1,0 *
N60 G00 X+60 Y+10 *
N70 G90 X+10 Y+10 *
; what comes back to G90 changes nothing
N80 L2,0 *
N90 X+20 Y+20 *
; the second pass begins with G91
N100 G98 L3 *
N110 G01 X+30 *
N120 G91 Z-1 *
N130 L3,2 *
N140 G90 G00 Z+50 M30 *
N150 G98 L1 *
N160 G01 G91 Z-4 F200 *
N170 G98 L0 *
; after the subprogram before it in the text this one is still called with G90
N180 G98 L2 *
N190 G00 X+40 *
N200 G91 X+5 *
N210 G90 *
N220 G98 L0 *
N99999999 %MODES G71 *
