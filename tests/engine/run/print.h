; control: tnc640
; What follows each block in brackets is calculated by hand.
BEGIN PGM PRINT MM
Q31 = 149.3604
Q32 = -0.0004
Q33 = -25
QS1 = "P-17"
FN 16: F-PRINT TNC:\MASK\REPORT.A / TNC:\LOG\FIRST.TXT
FN 16: F-PRINT TNC:\MASK\MORE.A / FIRST.TXT ; [the file was closed, M_APPEND goes on with it]
FN 16: F-PRINT SHORT.A / FIRST.TXT ; [appended]
FN 16: F-PRINT TNC:\MASK\REPORT.A / SECOND.TXT
FN 16: F-PRINT SHORT.A / SECOND.TXT ; [the file was closed: it begins anew]
QS3 = "SHORT.A"
FN 16: F-PRINT :'QS3' / SCREEN:
FN 16: F-PRINT SHORT.A / SCLR: ; [nothing is written]
FN 16: F-PRINT MONTH.A / MONTH.TXT
FN 16: F-PRINT MONTH.A / MONTH.TXT ; [it has less than 1 KB]
FN 16: F-PRINT FULL.A / MONTH.TXT ; [there is no room for more: nothing is written]
FN 15: PRINT Q31
FN 17: SYSWRITE ID990 NR6 = 1
END PGM PRINT MM
