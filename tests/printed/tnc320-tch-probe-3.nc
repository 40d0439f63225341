; control: tnc320 lang: fi source: 000:6751-6760 corrected: blank behind the colon (measuring-words-640)
4 TCH PROBE 3.0 MITTAUS
5 TCH PROBE 3.1 Q1
6 TCH PROBE 3.2 X KULMA: +15
7 TCH PROBE 3.3 ABST +10 F100 MB50 PERUSJÄRJESTELMÄ: 0
8 TCH PROBE 3.4 ERRORMODE1
