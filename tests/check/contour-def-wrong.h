; control: tnc640
0 BEGIN PGM A MM
1 CONTOUR DEF I1 = "A.H" I2 = "B.H" DEPTH5
2 CONTOUR DEF P1 = "A.H" I2 = "B.H" I3 = "C.H" I4 = "D.H" I5 = "E.H" P6 = "F.H" I7 = "G.H" I8 = "H.H" I9 = "I.H" I10 = "J.H"
3 CONTOUR DEF P1 = "A.H" I1 = "B.H"
3 END PGM A MM
