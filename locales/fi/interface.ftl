# Words of the program itself.

severity-error = virhe
severity-warning = varoitus
severity-note = huomautus
diagnostic-without-text = Koodilla { $code } ei ole tekstiä.{ $values }
