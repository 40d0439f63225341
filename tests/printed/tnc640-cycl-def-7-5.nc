; control: tnc640 lang: sl source: 001:6904-6906 form: coordinates
5 CYCL DEF 7.0 NIČELNA TOČKA
6 CYCL DEF 7.1 X+65
7 CYCL DEF 7.2 Y+65
