; control: tnc426-430 lang: pt source: 003:943-944 corrected: number of the cycle, number and label of Q307 (scanned-block-404)
5 TCH PROBE 404 ROTAÇÃO BÁSICA
Q307=+0 ;AJUSTE PRÉVIO ROTAÇ.BÁSICA
