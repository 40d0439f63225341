; control: tnc640 lang: sl source: 001:12704-12708 corrected: order of axis and word, comma of the line (polar-angle-word-640)
67 TCH PROBE 1.0 REF. POLARNA RAVNINA
68 TCH PROBE 1.1 X KOT: +30
69 TCH PROBE 1.2 X+5 Y+0 Z-5
