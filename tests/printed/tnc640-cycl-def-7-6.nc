; control: tnc640 lang: sl source: 001:6915-6917 form: coordinates
16 CYCL DEF 7.0 NIČELNA TOČKA
17 CYCL DEF 7.1 X+0
18 CYCL DEF 7.2 Y+0
