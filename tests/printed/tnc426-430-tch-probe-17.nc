; control: tnc426-430 lang: pt source: 003:3342-3348 corrected: torn block (contour-line-block)
60 TCH PROBE 17.0 LINHAS DE NÍVEL
61 TCH PROBE 17.1 TEMPO: 0 X+0 Y+0
62 TCH PROBE 17.2 SEQUÊNCIA: Y- / X-
63 TCH PROBE 17.3 F1000 FMIN500 MIN.DIST. L. 0.2 DIST. L.: 0.5 DIST. P.: 0.5 TOL: 0.1 DIST: 2
