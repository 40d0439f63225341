; control: tnc640 lang: sl source: 001:7072-7074 form: angle
93 CYCL DEF 13.0 ORIENTACIJA
94 CYCL DEF 13.1 KOT 180
