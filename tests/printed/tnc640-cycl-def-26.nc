; control: tnc640 lang: sl source: 001:6682-6688 form: factors
26 CYCL DEF 26.0 FAKTOR MERILA, SPECIF. ZA OS
27 CYCL DEF 26.1 X 1.4 Y 0.6 CCX+15 CCY+20
