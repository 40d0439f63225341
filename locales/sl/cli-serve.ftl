# Ukaz »serve«.
cli-serve = Prikaže priročnike in stanje prevodov v brskalniku na tem računalniku
cli-serve-port = Vrata, na katerih posluša (privzeto: 8477); 0 vzame poljubna prosta
cli-serve-address = Priročniki so na naslovu { $address }; Ctrl+C konča.
cli-serve-anew = Podatki so se spremenili: { $files ->
        [0] strani ni mogoče izdelati.
       *[other] znova izdelane datoteke: { $files }.
    }
cli-examples-serve =
    ciklo serve
    ciklo --data . serve --control tnc640 --lang fi
diag-serve-address = { $path } ni mogoče uporabiti kot naslov: { $reason ->
        [in-use] vrata uporablja drug program; z --port izberite druga
        [permission] dovoljenja ni; z --port izberite vrata nad 1023
       *[other] { $detail }
    }.
explain-serve-address = »ciklo serve« posluša na vratih tega računalnika, do katerih pride samo ta računalnik. Vrata lahko hkrati uporablja le en program, vrata do 1023 pa so pogosto pridržana za sistem. Primer: ciklo serve, medtem ko v drugem oknu že teče drug. Končajte drugi program ali z --port izberite druga vrata; z --port 0 sistem dodeli prosta.
