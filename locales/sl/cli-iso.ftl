# DIN/ISO: pretvarjanje programov in to, kar nima ustreznice.

cli-convert-to-iso = Iz jezika Klartext v DIN/ISO
cli-convert-to-klartext = Iz jezika DIN/ISO v Klartext
cli-convert-control = Krmiljenje, katerega imena in oznake se zapišejo (privzeto: tisto, katerega cikle vsebuje program)
cli-convert-lang = Jezik imen in oznak (privzeto: jezik besedil samega programa)

diag-iso-no-equivalent = DIN/ISO nima ustreznice za »{ $found }«; stavek ostane kot komentar.
diag-iso-no-code = Noben priročnik ne navaja kode DIN/ISO za { $found }; stavek ostane kot komentar.
diag-klartext-no-equivalent = Klartext nima ustreznice za »{ $found }«; stavek ostane kot komentar.
diag-iso-unknown-code = Noben priročnik ne navaja cikla ali funkcije s kodo { $found }.
diag-iso-word-not-allowed = Nič v tem stavku ne sprejme { $found }.
diag-iso-no-direction = { $found }: G05 nadaljuje v smeri prejšnjega kroga, vendar pred njim ni nobenega.
