; control: tnc426-430 lang: pt source: 003:2663-2667 corrected: number of the first block, O for 0 (block-of-cycle-2)
5 TCH PROBE 2.0 CALIBRAR TS
6 TCH PROBE 2.1 ALTURA: +50 R+25,003 MODO DE MEDIÇÃO: 0
