; control: tnc640 lang: sl source: 001:6909-6910 form: angle
10 CYCL DEF 10.0 ROTACIJA
11 CYCL DEF 10.1 IROT+45
