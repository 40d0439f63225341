; control: tnc640 lang: sl source: 001:4469-4472 form: labels corrected: one line (contour-label-block-torn)
12 CYCL DEF 14.0 KONTURA
13 CYCL DEF 14.1 OZN. KONTURE 1/2/3/4
