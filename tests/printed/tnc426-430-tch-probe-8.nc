; control: tnc426-430 lang: pt source: 003:3413 corrected: order of the words of 8.1 (line-block)
60 TCH PROBE 8.0 LINHA
61 TCH PROBE 8.1 DIRECÇÃO: X ALTURA: +25
62 TCH PROBE 8.2 PERCURS: 0.5 L.DIST: 0.2 DIST. P: 0.5
