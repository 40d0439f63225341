; control: tnc640 lang: sl source: 001:10365-10367 corrected: name in the language of the manual (turning-system-german-name)
7 CYCL DEF 800 PRILAGODITEV STRUŽNEGA SISTEMA
Q497=+0 ;PRECESIJSKI KOT
Q498=+0 ;OBRAČANJE ORODJA
