; control: tnc426-430 lang: pt source: 003:3465-3469 corrected: word of 5.1 (digitizing-file-word), 0 for O (scanned-block-5)
30 TCH PROBE 5.0 CAMPO
31 TCH PROBE 5.1 NOME PGM: DATRND
32 TCH PROBE 5.2 Z X+0 A+0 Z+0
33 TCH PROBE 5.3 X+85 A+270 Z+65
34 TCH PROBE 5.4 ALTURA: 100
