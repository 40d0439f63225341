; control: tnc640 lang: sl source: 001:6974-6976 form: time
89 CYCL DEF 9.0 ČAS ZADRŽ.
90 CYCL DEF 9.1 ČAS ZADRŽ. 1.5
