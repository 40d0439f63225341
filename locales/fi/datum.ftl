# Työkierrot, jotka asettavat peruspisteen.

# --- 412 ---
cycle-datum-inside-circle = Peruspisteen asetus ympyrän sisään (reikä)
    .nc = PERUSP. YMP. SISÄP.
    .nc-aliases = PERUSP YMPYRÄ SISÄP
    .purpose = Työkierto mittaa ympyrätaskun tai reiän keskipisteen ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa keskipisteen myös nollapiste- tai esiasetustaulukkoon.
cycle-datum-inside-circle__tnc426-430 =
    .purpose = Työkierto mittaa ympyrätaskun tai reiän keskipisteen ja asettaa sen peruspisteeksi. Haluttaessa ohjaus kirjoittaa keskipisteen myös nollapistetaulukkoon.
step-retract-and-store-datum = Ohjaus palauttaa kosketusjärjestelmän varmuuskorkeudelle { $q-clearance-height }, tallentaa todellisarvot tulosparametreihin ja asettaa tai tallentaa mitatun peruspisteen parametrien { $q-measured-value-transfer } ja { $q-datum-row-number } mukaan:
step-retract-and-store-datum__tnc426-430 = Ohjaus palauttaa kosketusjärjestelmän varmuuskorkeudelle { $q-clearance-height } ja asettaa tai tallentaa mitatun peruspisteen parametrin { $q-datum-row-number } mukaan:
say-datum-into-display-and-row-zero = jos { $q-datum-row-number } = 0, se asettaa mitatun peruspisteen näyttöön; peruspiste on heti aktiivinen ja tallentuu myös esiasetustaulukon riville 0
say-datum-into-display = jos { $q-datum-row-number } = 0, se asettaa mitatun peruspisteen näyttöön; peruspiste on heti aktiivinen
say-datum-into-datum-table = jos { $q-datum-row-number } ei ole 0 ja { $q-measured-value-transfer } = 0, se kirjoittaa mitatun peruspisteen aktiivisen nollapistetaulukon riville { $q-datum-row-number }; perusjärjestelmänä on aktiivinen työkappaleen koordinaatisto
say-datum-into-datum-table__tnc426-430 = jos { $q-datum-row-number } ei ole 0, se kirjoittaa mitatun peruspisteen aktiivisen nollapistetaulukon riville { $q-datum-row-number }
say-datum-into-preset-table = jos { $q-datum-row-number } ei ole 0 ja { $q-measured-value-transfer } = 1, se kirjoittaa mitatun peruspisteen esiasetustaulukon riville { $q-datum-row-number }; perusjärjestelmänä on koneen koordinaatisto (REF-koordinaatit)
step-probe-in-probe-axis = Haluttaessa ohjaus mittaa sen jälkeen kosketusakselin peruspisteen erillisellä kosketuksella:
say-datum-in-probe-axis = jos { $q-probing-in-probe-axis } = 1, se koskettaa pistettä { $q-probe-axis-point-main }, { $q-probe-axis-point-minor }, { $q-probe-axis-point-tool } kosketusakselin suunnassa, vetäytyy ja asettaa tai tallentaa peruspisteen { $q-new-datum-probe-axis } samoin kuin koneistustason peruspisteen
guard-datum-transfer-undefined = { $q-datum-row-number } ei ole 0 ja { $q-measured-value-transfer } on −1: määrittele, mihin mitattu peruspiste tallennetaan.
guard-transformation-with-probe-axis-datum = Nollapisteen siirto tai kierto on voimassa, mutta asetuksilla { $q-measured-value-transfer } = 0 ja { $q-probing-in-probe-axis } = 1 koordinaattimuunnos ei ole sallittu.
note-nominal-diameter-rather-small = Törmäysvaara! Jotta kosketusjärjestelmä ja työkappale eivät törmää, anna taskun (reiän) asetushalkaisijaksi mieluummin liian pieni kuin liian suuri arvo.
note-probing-from-centre-if-narrow = Jos taskun mitat ja varmuusetäisyys eivät salli esipaikoitusta kosketuspisteiden lähelle, ohjaus aloittaa kosketuksen aina taskun keskeltä. Silloin kosketusjärjestelmä ei aja varmuuskorkeudelle mittauspisteiden välillä.
note-no-transformation-with-probe-axis-datum = Jos työkierto asettaa peruspisteen valinnalla { $q-measured-value-transfer } = 0 ja koskettaa lisäksi kosketusakselin suunnassa ({ $q-probing-in-probe-axis } = 1), mikään koordinaattimuunnos ei saa olla voimassa.
note-no-tilting-with-datum-cycles = Koneistustason kääntö ei ole sallittu peruspisteen asetuksen työkiertojen 408–419 yhteydessä.
note-datum-cycles-with-basic-rotation = Peruspisteen asetuksen työkierrot 408–419 voidaan suorittaa myös peruskäännön ollessa voimassa.
note-datum-cycles-with-basic-rotation__tnc640 = Peruspisteen asetuksen työkierrot 408–419 voidaan suorittaa myös kierron (peruskäännön tai työkierron 10) ollessa voimassa.
note-basic-rotation-must-stay = Älä muuta peruskäännön kulmaa, jos mittaustyökierron jälkeen käytetään nollapisteen siirtoa (työkierto 7) nollapistetaulukosta.
note-no-datum-cycles-with-basic-rotation = Peruspisteen asetuksen työkiertoja 410–418 ei saa suorittaa peruskäännön ollessa voimassa. Muuten ohjaus antaa virheilmoituksen.
note-datum-axes-by-probe-axis = Mittausohjelmassa määritelty kosketusakseli määrää, millä akseleilla peruspiste asetetaan: Z: X ja Y; Y: Z ja X; X: Y ja Z.
note-datum-axes-by-probe-axis__tnc426-430 = Mittausohjelmassa määritelty kosketusakseli määrää, millä akseleilla peruspiste asetetaan: Z tai W: X ja Y; Y tai V: Z ja X; X tai U: Y ja Z.
note-transfer-minus-one = Tilanne, jossa { $q-datum-row-number } ei ole 0 ja { $q-measured-value-transfer } = −1, syntyy vain, jos työkiertoja 410–418 sisältävät ohjelmat ovat peräisin TNC 4xx -ohjauksesta tai iTNC 530:n vanhemmasta ohjelmistosta tai jos mittausarvojen lähetystä ei ole annettu työkierron määrittelyssä. Silloin ohjaus antaa virheilmoituksen, koska koneen nollapisteeseen perustuvien nollapistetaulukoiden käsittely on muuttunut; määrittele mittausarvojen lähetys.
note-activate-stored-datum = Nollapistetaulukkoon tallennettu nollapiste aktivoidaan ohjelmassa työkierrolla 7, esiasetustaulukkoon tallennettu peruspiste työkierrolla 247.
note-datum-table-must-be-active = Jotta mitattu peruspiste voidaan kirjoittaa nollapistetaulukkoon, aktivoi nollapistetaulukko ohjelmanajon käyttötavalla (tila M) ennen mittausohjelman käynnistystä.
note-datum-table-reference = Kirjoittaessaan nollapistetaulukkoon ohjaus ottaa huomioon koneparametrin { $mp-datum-table-reference }: 0: arvot perustuvat työkappaleen nollapisteeseen; 1: arvot perustuvat koneen nollapisteeseen. Jos koneparametria { $mp-datum-table-reference } muutetaan jälkikäteen, ohjaus muuntaa nollapistetaulukoihin tallennetut arvot.
