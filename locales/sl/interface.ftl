# Words of the program itself.

severity-error = napaka
severity-warning = opozorilo
severity-note = opomba
diagnostic-without-text = Koda { $code } nima besedila.{ $values }
