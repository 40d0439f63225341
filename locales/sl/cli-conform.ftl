# Ukazna vrstica: ukaz conform.
cli-conform-cycle = Samo ta cikel, na primer 200 ali "TCH PROBE 412"; lahko se ponovi
cli-conform-case = Samo primeri s tem imenom; lahko se ponovi
cli-conform-list = Samo naštej primere in kaj dokazujejo
cli-conform-proves = dokazuje: { $text }
cli-conform-why = utemeljitev: { $text }
cli-conform-place = primer: { $text }
cli-conform-manual = priročnik (datoteka:vrstice): { $text }
cli-conform-lists = { $what }: pričakovano { $expected } (levo), dobljeno { $found } (desno)
diag-conform-no-case = Noben primer ne ustreza izbiri: »ciklo conform --list« našteje vse primere.
cli-lint-only = Samo tisto, kar zadeva ta cikel, brez strani in primerjave jezikov; lahko se ponovi
cli-lint-summary = Preštej ugotovitve v vsaki datoteki in prikaži naslednjih dvajset
cli-lint-narrow = Strani in primerjava jezikov so izpuščene (--only).
cli-lint-file = { $path }: napake { $errors }, drugo { $others }
