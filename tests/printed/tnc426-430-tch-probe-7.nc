; control: tnc426-430 lang: pt source: 003:3335-3338 corrected: torn block, 7.2 for 7.3 (contour-line-block)
60 TCH PROBE 7.0 LINHAS DE NÍVEL
61 TCH PROBE 7.1 TEMPO: 0 X+0 Y+0
62 TCH PROBE 7.2 SEQUÊNCIA: Y- / X-
63 TCH PROBE 7.3 PERCURS: 0.5 L.DIST: +0.2 DIST. P: 0.5
