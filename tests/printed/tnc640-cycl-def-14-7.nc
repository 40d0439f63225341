; control: tnc640 lang: sl source: 001:7988-7989 form: labels corrected: OZN. KONTURE (contour-label-words)
9 CYCL DEF 14.0 KONTURA
10 CYCL DEF 14.1 OZN. KONTURE 2
