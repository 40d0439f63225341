; control: tnc640 lang: sl source: 001:6587-6589 form: angle
16 CYCL DEF 10.0 ROTACIJA
17 CYCL DEF 10.1 ROT+35
