; control: tnc640 lang: sl source: 001:2690-2713 corrected: torn lines joined (chip-breaking-tapping-torn-example), no blank behind the semicolon (drilling-label-blanks), capitals (spindle-angle-label)
26 CYCL DEF 209 VRTANJE NAVOJEV LOM OSTRUŽ.
Q200=2 ;VARNOSTNA RAZDALJA
Q201=-20 ;GLOBINA
Q239=+1 ;VIŠINA NAVOJA
Q203=+25 ;KOOR. POVRŠINE
Q204=50 ;2. VARNOSTNA RAZDALJA
Q257=5 ;GLOBINA VRTANJA DO LOMA OSTRUŽKOV
Q256=+25 ;ODMIK PRI LOMU OSTRUŽKOV
Q336=50 ;KOT VRETENA
Q403=1.5 ;FAKTOR ŠTEV. VRTLJAJEV
