; control: tnc640 lang: sl source: 001:14701-14702 corrected: name and blank (preset-name-variant)
2 CYCL DEF 247 DOLOČITEV REF. TOČKE
Q339=1 ;ŠTEVILKA REF. TOČKE
