; control: tnc640 lang: sl source: 001:4777-4783 corrected: one block (floor-finishing-torn-example)
60 CYCL DEF 23 GLOB. FINO REZK.
Q11=100 ;POM. PRI GLOB. PRIM.
Q12=350 ;POMIK PRI POSNEMANJU
Q208=9999 ;VZVRATNI POMIK
