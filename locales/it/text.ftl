# Texts that follow from the specifications by a pattern; see the English file.

prompt-from-name = { $name }?

# $until: a clause behind “finché”, with “non”, such as “la profondità non è raggiunta”.
repeat-steps = I passi da { $from } a { $to } vengono ripetuti finché { $until }.
repeat-two-steps = I passi { $from } e { $to } vengono ripetuti finché { $until }.
repeat-step = Il passo { $from } viene ripetuto finché { $until }.

range-both = da { $min } a { $max }
range-from = da { $min }
range-to = fino a { $max }
range-length =
    { $length ->
        [one] al massimo { $length } carattere
       *[other] al massimo { $length } caratteri
    }

caption-reference = Riferimento
reference-absolute = valore assoluto
reference-incremental = valore incrementale
caption-range = Campo di immissione
caption-unit = Unità
caption-words = Oppure
caption-effective = Solo se
caption-example = Esempio
optional-field = Facoltativo.
