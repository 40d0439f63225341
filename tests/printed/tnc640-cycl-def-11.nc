; control: tnc640 lang: sl source: 001:6634-6635 form: factor
15 CYCL DEF 11.0 FAKTOR MERILA
16 CYCL DEF 11.1 SCL 0.75
