; control: tnc426-430 lang: pt source: 003:3112-3116 corrected: space in the height (digitizing-block-text)
50 TCH PROBE 5.0 CAMPO
51 TCH PROBE 5.1 NOME PGM: DADOS
52 TCH PROBE 5.2 Z X+0 Y+0 Z+0
53 TCH PROBE 5.3 X+10 Y+10 Z+20
54 TCH PROBE 5.4 ALTURA: +100
