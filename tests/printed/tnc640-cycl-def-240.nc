; control: tnc640 lang: sl source: 001:1765-1773 corrected: no blank behind the semicolon (drilling-label-blanks), none in a label (centring-label-selection)
11 CYCL DEF 240 CENTRIRANJE
Q200=2 ;VARNOSTNA RAZDALJA
Q343=1 ;IZBIRA GLOBINA/PREMER
Q201=+0 ;GLOBINA
Q344=-9 ;PREMER
Q206=250 ;POM. PRI GLOB. PRIM.
Q211=0.1 ;ČAS ZADRŽ. SPODAJ
Q203=+20 ;KOOR. POVRŠINE
Q204=100 ;2. VARNOSTNA RAZDALJA
