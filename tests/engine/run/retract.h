BEGIN PGM RETRACT MM
; The tool stands at Z 10, then 50 mm higher at Z 60, then where the Z axis of the machine ends, at 1000 in machine coordinates; once there it stays.
TOOL CALL 1 Z S1000 F300
L X+20 Y+30 Z+10 FMAX
M140 MB50
L M140 MB MAX
M140 MB MAX
END PGM RETRACT MM
