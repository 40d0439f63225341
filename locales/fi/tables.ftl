# Taulukot, joita työkierrot lukevat tai kirjoittavat.
table-tool = Työkalutaulukko
table-preset = Esiasetustaulukko
table-datum = Nollapistetaulukko
table-probe = Kosketusjärjestelmän taulukko
table-kinematics = Kinematiikkataulukko
