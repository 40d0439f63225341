; control: tnc640 lang: sl source: 001:7024-7029 form: program corrected: blank and line break in the path (program-call-path-blank)
55 CYCL DEF 12.0 PGM CALL
56 CYCL DEF 12.1 PGM TNC:\KLAR35\FK1\50.H
