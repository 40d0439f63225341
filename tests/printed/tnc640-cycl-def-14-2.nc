; control: tnc640 lang: sl source: 001:4917-4918 form: labels
5 CYCL DEF 14.0 KONTURA
6 CYCL DEF 14.1 OZN. KONTURE 1
