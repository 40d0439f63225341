; control: tnc640 lang: sl source: 001:6631-6633 form: coordinates
12 CYCL DEF 7.0 NIČELNA TOČKA
13 CYCL DEF 7.1 X+60
14 CYCL DEF 7.2 Y+40
