; control: tnc426-430 lang: pt source: 003:3482-3486 corrected: word of 5.1 (digitizing-file-word), number of the cycle twice (scanned-block-5)
30 TCH PROBE 5.0 CAMPO
31 TCH PROBE 5.1 NOME PGM: DATH
32 TCH PROBE 5.2 Z X-50 C+0 Z+0
33 TCH PROBE 5.3 X+50 C+360 Z+85
34 TCH PROBE 5.4 ALTURA: 100
