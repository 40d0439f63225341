# Tables that cycles read or write.
table-tool = Tabela de ferramentas
table-preset = Tabela de presets
table-datum = Tabela de pontos zero
table-probe = Tabela de apalpadores
table-kinematics = Tabela de cinemáticas
