; control: itnc530
; Polynomials of the third degree: t runs from 1 to 0. What follows each block in brackets is calculated by hand.
BEGIN PGM SPLINE MM
TOOL CALL 1 Z S1000 F300
L X+0 Y+0 Z+10 A+0 C+0 R0 FMAX
; 30 - 3t - 27t², so 0 at the start; straight along X, the way is 30
SPL X+30 K3X+0 K2X-2.7 E+1 K1X-3 F600 ; [54 of bend: √(54 / 0.0008) = 259.8, 260 chords; the first to 30 - 3 (259/260) - 27 (259/260)² = 0.2189]
SPL X+60 Y+0.05 K3X+0.000E+000 K2X0 K1X-3.0E1 K3Y0 K2Y-5.000E-002 K1Y0 ; [y = 0.05 - 0.05 t²; a bend of 0.1: 12 chords; at t = 1/2 X 45, Y 0.0375]
CT X+90 Y+20.05 ; [tangential to X: the tangent at the end is 30 along X, 0 along Y]
SPL X+90 Y+20.05 C+5 K3X+0 K2X+0 K1X+0 K3Y+0 K2Y+0 K1Y+0 K3C-0.0016 K2C+0 K1C-4.9984 ; [C alone: a bend of 0.0096 at t = 1, 4 chords; at t = 1/2 C 5 - 0.0002 - 2.4992 = 2.5006]
SPL X+100 C+15 K3X+0 K2X+0 K1X-10 K3C+0 K2C+0 K1C-10 ; [one chord]
END PGM SPLINE MM
