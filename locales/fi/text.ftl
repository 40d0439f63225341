# Texts that follow from the specifications by a pattern; see the English file.

prompt-from-name = { $name }?

# $until: a clause behind “kunnes”, such as “syvyys on saavutettu”.
repeat-steps = Vaiheet { $from }–{ $to } toistetaan, kunnes { $until }.
repeat-two-steps = Vaiheet { $from } ja { $to } toistetaan, kunnes { $until }.
repeat-step = Vaihe { $from } toistetaan, kunnes { $until }.

range-both = { $min } … { $max }
range-from = vähintään { $min }
range-to = enintään { $max }
range-length = enintään { $length } merkkiä

caption-reference = Mitoitustapa
reference-absolute = absoluuttinen
reference-incremental = inkrementaalinen
caption-range = Sisäänsyöttöalue
caption-unit = Yksikkö
caption-words = Tai
caption-effective = Vain jos
caption-example = Esimerkki
optional-field = Voidaan jättää pois.
