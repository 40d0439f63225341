; control: tnc640 lang: sl source: 001:6913-6914 form: angle
14 CYCL DEF 10.0 ROTACIJA
15 CYCL DEF 10.1 ROT+0
