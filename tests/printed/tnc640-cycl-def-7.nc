; control: tnc640 lang: sl source: 001:6284-6287 form: coordinates corrected: order of blocks 15 and 16 (datum-shift-block-order)
13 CYCL DEF 7.0 NIČELNA TOČKA
14 CYCL DEF 7.1 X+60
15 CYCL DEF 7.2 Y+40
16 CYCL DEF 7.3 Z-5
