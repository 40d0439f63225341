# Komento ”serve”.
cli-serve = Näytä käsikirjat ja käännösten tilan tämän koneen selaimessa
cli-serve-port = Kuunneltava portti (oletus: 8477); 0 valitsee minkä tahansa vapaan portin
cli-serve-address = Käsikirjat ovat osoitteessa { $address }; Ctrl+C lopettaa.
cli-serve-anew = Tiedot ovat muuttuneet: { $files ->
        [0] sivuja ei voida tehdä.
       *[other] tiedostoja tehty uudelleen { $files }.
    }
cli-examples-serve =
    ciklo serve
    ciklo --data . serve --control tnc640 --lang fi
diag-serve-address = { $path } ei käy osoitteeksi: { $reason ->
        [in-use] toinen ohjelma käyttää porttia; valitse toinen portti valitsimella --port
        [permission] lupa puuttuu; valitse suurempi portti kuin 1023 valitsimella --port
       *[other] { $detail }
    }.
explain-serve-address = ”ciklo serve” kuuntelee tämän koneen porttia, johon pääsee vain tältä koneelta. Porttia voi käyttää yksi ohjelma kerrallaan, ja portit 1023:een saakka on usein varattu järjestelmälle. Esimerkki: ciklo serve, kun toinen on käynnissä toisessa ikkunassa. Lopeta toinen ohjelma tai valitse toinen portti valitsimella --port; valitsimella --port 0 järjestelmä antaa vapaan portin.
