; control: tnc640 lang: sl source: 001:6781-6782 form: angles
12 CYCL DEF 19.0 OBDELOVALNA RAVNINA
13 CYCL DEF 19.1 A+0 B+45 C+0
