; control: tnc640 lang: sl source: 001:6350-6352 form: table
77 CYCL DEF 7.0 NIČELNA TOČKA
78 CYCL DEF 7.1 #5
