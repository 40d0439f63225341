# Words of the program itself.

severity-error = erro
severity-warning = aviso
severity-note = nota
diagnostic-without-text = O código { $code } não tem texto.{ $values }
