; control: tnc640
; LN with a direction of the tool. The head turns C and then A, the pivot is 100 mm above the tip. What follows each block
; in brackets is calculated by hand.
BEGIN PGM DIRECTION MM
TOOL CALL 1 Z S1000 F300
L X+0 Y+0 Z+50 A+0 C+0 R0 FMAX
LN X+5 TX+0 TY+0.6 TZ+0.8 ; [without M128 the direction is ignored]
LN X+10 TX+0 TY-0.6 TZ+0.8 F500 M128 ; [A 36.8699: the head leans to -Y; pivot at Y -60, Z 130, so the axes go to X 10, Y -60, Z 30]
LN X+20 NX+0.6 NY+0 NZ+0.8 ; [no direction of the tool: along the normal; C 90 and A 36.8699, or C -90 and A -36.8699: both turn by 90 at most, the first is nearer]
LN X+30 TX+0 TY+0 TZ+1 ; [A 0; C does not matter and stays]
TOOL CALL 2 Z S1200 F300
LN X+40 Y+0 NX+0.6 NY+0 NZ+0.8 TX+0 TY+0 TZ+1 ; [upright, 0.5 larger ball: 0.5 (0.6, 0, -0.2): 40.3, 0, 49.9]
LN X+50 NX+0 NY-0.6 NZ+0.8 TX+0 TY-0.6 TZ+0.8 ; [along the normal: the tip touches, nothing is moved: 50, 0, 50]
LN X+60 NX+0 NY+0 NZ+1 TX+0 TY-0.6 TZ+0.8 ; [n - t = (0, 0.6, 0.2), half of it: 60, 0.3, 50.1]
END PGM DIRECTION MM
