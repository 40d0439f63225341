; control: tnc640 lang: sl source: 001:6581-6585 form: coordinates
13 CYCL DEF 7.0 NIČELNA TOČKA
14 CYCL DEF 7.1 X+60
15 CYCL DEF 7.2 Y+40
