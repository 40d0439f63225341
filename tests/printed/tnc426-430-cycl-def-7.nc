; control: tnc426-430 lang: pt source: 003:1634-1635 form: table
4 CYCL DEF 7.0 PONTO ZERO
5 CYCL DEF 7.1 #1
