# DIN/ISO: ohjelmien muuntaminen ja se, mille ei ole vastinetta.

cli-convert-to-iso = Klartext-kielestä DIN/ISO-kielelle
cli-convert-to-klartext = DIN/ISO-kielestä Klartext-kielelle
cli-convert-control = Ohjaus, jonka nimet ja NC-tekstit kirjoitetaan (oletus: se, jonka työkiertoja ohjelmassa on)
cli-convert-lang = Nimien ja NC-tekstien kieli (oletus: ohjelman omien tekstien kieli)

diag-iso-no-equivalent = DIN/ISO-kielessä ei ole vastinetta tälle: ”{ $found }”; lause jää kommentiksi.
diag-iso-no-code = Mikään käsikirja ei mainitse DIN/ISO-koodia työkierrolle { $found }; lause jää kommentiksi.
diag-klartext-no-equivalent = Klartext-kielessä ei ole vastinetta tälle: ”{ $found }”; lause jää kommentiksi.
diag-iso-unknown-code = Mikään käsikirja ei mainitse työkiertoa tai toimintoa, jonka koodi on { $found }.
diag-iso-word-not-allowed = Mikään tässä lauseessa ei ota sanaa { $found }.
diag-iso-no-direction = { $found }: G05 jatkaa edellisen ympyrän suuntaan, mutta ennen sitä ei ole ympyrää.
