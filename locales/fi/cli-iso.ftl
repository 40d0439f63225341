# DIN/ISO: ohjelmien muuntaminen ja se, mille ei ole vastinetta.

cli-convert-to-iso = Klartext-kielestä DIN/ISO-kielelle
cli-convert-to-klartext = DIN/ISO-kielestä Klartext-kielelle
cli-convert-control = Ohjaus, jonka nimet ja NC-tekstit kirjoitetaan (oletus: se, jonka työkiertoja ohjelmassa on)
cli-convert-lang = Nimien ja NC-tekstien kieli (oletus: ohjelman omien tekstien kieli)

diag-iso-no-equivalent = DIN/ISO-kielessä ei ole vastinetta tälle: ”{ $found }”; lauseesta tulee kommentti.
diag-iso-no-code = Mikään käsikirja ei mainitse DIN/ISO-koodia työkierrolle { $found }; lauseesta tulee kommentti.
diag-klartext-no-equivalent = Klartext-kielessä ei ole vastinetta tälle: ”{ $found }”; lauseesta tulee kommentti.
diag-iso-unknown-code = Mikään käsikirja ei mainitse työkiertoa tai toimintoa, jonka koodi on { $found }.
diag-iso-word-not-allowed = Sana { $found } ei ole sallittu tässä lauseessa.
diag-iso-no-direction = { $found }: G05 jatkaa edellisen kaaren suuntaan, mutta edellä ei ole kaarta.
diag-iso-mode-left-on = Edellä oleva { $found } ei ole tässä voimassa: aliohjelma tai toisto on muuttanut sen.
