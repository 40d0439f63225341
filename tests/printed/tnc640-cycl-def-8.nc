; control: tnc640 lang: sl source: 001:6537-6539 form: axes
79 CYCL DEF 8.0 ZRCALJENJE
80 CYCL DEF 8.1 X Y Z
