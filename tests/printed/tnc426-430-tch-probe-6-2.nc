; control: tnc426-430 lang: pt source: 003:3470-3472 corrected: words of direction and line spacing (meander-words), 0 for O (scanned-block-5)
60 TCH PROBE 6.0 MEANDRO
61 TCH PROBE 6.1 DIRECÇ: A
62 TCH PROBE 6.2 PERCURSO: 0,3 L.DIST: 0,5 DIST. P: 0,5
