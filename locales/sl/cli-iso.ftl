# DIN/ISO: pretvarjanje programov in to, kar nima ustreznice.

cli-convert-to-iso = Iz jezika Klartext v DIN/ISO
cli-convert-to-klartext = Iz jezika DIN/ISO v Klartext
cli-convert-control = Krmiljenje, katerega imena in oznake se zapišejo (privzeto: tisto, h kateremu sodijo cikli programa)
cli-convert-lang = Jezik imen in oznak (privzeto: jezik besedil samega programa)

diag-iso-no-equivalent = DIN/ISO nima ustreznice za »{ $found }«; stavek postane komentar.
diag-iso-no-code = Noben priročnik ne navaja kode DIN/ISO za { $found }; stavek postane komentar.
diag-klartext-no-equivalent = Klartext nima ustreznice za »{ $found }«; stavek postane komentar.
diag-iso-unknown-code = Noben priročnik ne navaja cikla ali funkcije s kodo { $found }.
diag-iso-word-not-allowed = { $found } v tem stavku ni dovoljeno.
diag-iso-no-direction = { $found }: G05 se nadaljuje v smeri prejšnjega loka, tega pa ni.
diag-iso-mode-left-on = { $found } iz prejšnjega stavka tu ne velja: podprogram ali ponovitev ga je spremenila.
