; control: tnc426-430 lang: pt source: 003:1784-1784 corrected: two blocks on one line (scanned-text)
67 TCH PROBE 0.0 SUPERF. REF. Q5 X-
68 TCH PROBE 0.1 X+5 Y+0 Z-5
