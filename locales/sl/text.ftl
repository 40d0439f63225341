# Texts that follow from the specifications by a pattern; see the English file.

prompt-from-name = { $name }?

# $until: a clause behind “dokler”, such as “ni dosežena globina”.
repeat-steps = Koraki od { $from } do { $to } se ponavljajo, dokler { $until }.
repeat-two-steps = Koraka { $from } in { $to } se ponavljata, dokler { $until }.
repeat-step = Korak { $from } se ponavlja, dokler { $until }.

range-both = od { $min } do { $max }
range-from = od { $min }
range-to = do { $max }
range-length =
    { $length ->
        [one] največ { $length } znak
        [two] največ { $length } znaka
        [few] največ { $length } znaki
       *[other] največ { $length } znakov
    }

caption-reference = Vrsta vrednosti
reference-absolute = absolutno
reference-incremental = inkrementalno
caption-range = Razpon vnosa
caption-unit = Enota
caption-words = Ali
caption-effective = Samo če
caption-example = Primer
optional-field = Ni obvezno.
