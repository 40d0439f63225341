; control: tnc640 lang: sl source: 001:13731-13735 corrected: order of axis and word (polar-angle-word-640), blank behind the colon (measuring-words-640)
4 TCH PROBE 3.0 MERJENJE
5 TCH PROBE 3.1 Q1
6 TCH PROBE 3.2 X KOT: +15
7 TCH PROBE 3.3 ABST +10 F100 MB1 REFERENČNI SISTEM: 0
8 TCH PROBE 3.4 ERRORMODE1
