# Words of the program itself.

severity-error = errore
severity-warning = avviso
severity-note = nota
diagnostic-without-text = Il codice { $code } non ha un testo.{ $values }
