# Words of the program itself.

severity-error = error
severity-warning = warning
severity-note = note
diagnostic-without-text = No text for the code { $code }.{ $values }
