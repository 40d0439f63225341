; control: tnc426-430 lang: pt source: 003:3417 corrected: order of the words of 18.1, O for 0 (line-block)
60 TCH PROBE 18.0 LINHA
61 TCH PROBE 18.1 DIRECÇÃO: X ÂNGULO: 0 ALTURA: +25
62 TCH PROBE 18.2 F1000 FMIN500 MIN.DIST. L. 0.2 DIST. L.: 0.5 DIST. P.: 0.5 TOL: 0.1 DIST: 2
