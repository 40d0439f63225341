; control: tnc320 lang: fi source: 000:1985-2003 corrected: name (two-holes-example-name), labels of Q268 to Q271 (two-holes-example-labels), Q305 is missing (two-holes-example-row-320)
2 TCH PROBE 401 ROT 2 REIKÄÄ
Q268=+25 ;1. AKS. 1. KESKIPISTE
Q269=+15 ;1. AKS. 2. KESKIPISTE
Q270=+80 ;2. AKS. 1. KESKIPISTE
Q271=+35 ;2. AKS. 2. KESKIPISTE
Q261=-5 ;MITTAUSKORKEUS
Q260=+20 ;VARMUUSKORKEUS
Q307=+0 ;PERUSK. ESIASETUS
Q305=0 ;NO. TAULUKOSSA
Q402=1 ;SUUNTAUS
Q337=1 ;ASETA NOLLA
