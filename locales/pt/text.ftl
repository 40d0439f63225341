# Texts that follow from the specifications by a pattern; see the English file.

prompt-from-name = { $name }?

# $until: a clause in the subjunctive behind “até que”, such as “a profundidade seja atingida”.
repeat-steps = Os passos { $from } a { $to } repetem-se até que { $until }.
repeat-two-steps = Os passos { $from } e { $to } repetem-se até que { $until }.
repeat-step = O passo { $from } repete-se até que { $until }.

range-both = de { $min } a { $max }
range-from = a partir de { $min }
range-to = até { $max }
range-length =
    { $length ->
        [one] no máximo { $length } carácter
       *[other] no máximo { $length } caracteres
    }

caption-reference = Referência
reference-absolute = absoluto
reference-incremental = incremental
caption-range = Campo de introdução
caption-unit = Unidade
caption-words = Ou
caption-effective = Só se
caption-example = Exemplo
optional-field = Opcional.
