BEGIN PGM RETRACT MM
; The plane is tilted by 30 degrees about X, and the head swivels with it: the tool leans towards -Y. 50 mm along it are 25 mm in -Y and 43.301 mm in Z.
; Then up to where the first axis of the machine ends: Z at 1000.
; With the head at 0 again the tool is along the tool axis of the machine, also while the tip is held.
TOOL CALL 1 Z S1000 F300
L X+20 Y+30 Z+10 FMAX
PLANE SPATIAL SPA+30 SPB+0 SPC+0 TURN MB50 FMAX
L X+0 Y+0 Z+10 FMAX
M140 MB50 F500
M140 MB MAX
PLANE RESET TURN FMAX
FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS
L X+0 Y+0 Z+50 FMAX
M140 MB50
FUNCTION RESET TCPM
END PGM RETRACT MM
