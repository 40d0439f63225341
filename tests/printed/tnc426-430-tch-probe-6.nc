; control: tnc426-430 lang: pt source: 003:3261-3264 corrected: wrapped line (digitizing-block-text)
60 TCH PROBE 6.0 MEANDRO
61 TCH PROBE 6.1 DIRECÇ: X
62 TCH PROBE 6.2 PERCURSO: 0.5 L.DIST: 0.2 DIST. P: 0.5
