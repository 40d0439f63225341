; control: tnc640 lang: sl source: 001:14571-14573 corrected: label of Q409 (memory-label-640)
5 TCH PROBE 450 SHRANJEVANJE KINEMATIKE
Q410=0 ;NAČIN
Q409=5 ;OZNAKA POMNILNIKA
