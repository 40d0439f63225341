explain-locale-same-as-source =
    Englanninkielisen tekstin kopio näyttää käännökseltä, mutta ei ole sellainen. Käännä teksti. Jos sanat ovat molemmissa kielissä samat tai eivät ole minkään kielen sanoja, lisää ne tai tekstin avain kielen luetteloon same-as-source.txt.
explain-texts-nothing-chosen =
    Kun käännös hyväksytään, sen ilmoitetaan vastaavan nykyistä englanninkielistä tekstiä, joten tarkistamattomia tekstejä ei koskaan hyväksytä. Luettele tekstit tai hyväksy valitsimella --changed ne, joiden käännöstä olet muuttanut.
explain-texts-unknown-key =
    Vain kielessä olevia tekstejä voidaan hyväksyä. ”ciklo texts status” luettelee keskeneräisten tekstien avaimet.
explain-texts-no-file =
    ”ciklo texts import” lukee kääntäjän käsittelemän tiedoston: XLIFF- tai PO-tiedoston, jollaisen ”ciklo texts export” kirjoittaa. Anna tiedoston nimi komennon perään, esimerkiksi ”ciklo texts import fi.xlf”.
explain-texts-no-language =
    Tekstit käännetään englannista kielelle, jolla on tunnus, esimerkiksi fi tai de-AT. Englanti ei voi olla kohdekieli, eikä nimi, jossa on muita merkkejä kuin kirjaimia, numeroita ja yhdysmerkkejä, kelpaa locales-kansion alikansioksi. Ilmoita kieli valitsimella --to. Palautetussa tiedostossa kieli on yleensä valmiina.
explain-texts-file-unreadable =
    Tiedosto hylätään kokonaan, eikä mitään muuteta. Luettavat muodot ovat XLIFF 1.2, XLIFF 2.0 ja PO sekä termeille TBX ja CSV, merkistönä UTF-8. Jos yhtä useista tiedostoista ei voi lukea, mitään niistä ei oteta käyttöön. Dokumenttityypit ja tiedoston omat entiteetit hylätään, koska niillä voi hakea muita tiedostoja tai kasvattaa tekstin rajattomaksi; samasta syystä hylätään liian syvät sisäkkäiset elementit. Katso ilmoitettua kohtaa tai vie tekstit uudelleen ja anna käännösohjelman tallentaa ne samassa muodossa.
explain-texts-unit-unknown =
    Yksikön tunnus on tekstin avain, eikä millään kielen tekstillä ole tätä avainta. Avain on nimetty uudelleen tai poistettu viennin jälkeen, tai tunnusta on muutettu tiedostossa. Vie tekstit uudelleen; käännösmuisti löytää valmiin käännöksen sanojen perusteella. Sanaston uusi termi kirjoitetaan ensin tiedostoon locales/en/glossary.ftl; sen jälkeen sen käännökset voidaan tuoda.
explain-texts-unit-twice =
    Kaksi yksikköä, joilla on sama tunnus, voivat sanoa eri asiat, eikä mikään kerro, kumpi on oikein. Kumpaakaan ei oteta. Poista kaikki paitsi yksi.
explain-texts-unit-source-changed =
    Englanninkielistä tekstiä on muutettu tiedoston viennin jälkeen, joten tiedoston käännös voi sanoa jotakin, mikä ei enää pidä paikkaansa. Yksikkö jätetään pois; muut otetaan. Vie teksti uudelleen: ensimmäiset huomautukset näyttävät, mitkä sanat ovat muuttuneet.
explain-texts-unit-not-read =
    Valmis yksikkö tarvitsee käännöksen, joka koostuu sanoista ja viedyistä koodeista. Tässä ei ole tekstiä, tai siinä on elementtejä, joita viedyssä tiedostossa ei ollut. Poista ne, tai aseta yksikölle keskeneräisen tila, kunnes se on käännetty.
explain-texts-unit-codes =
    Koodien tilalle ohjelma panee arvoja, termejä ja valintoja. Käännös voi muuttaa niiden järjestystä ja valita termin sijamuodon, esimerkiksi { "{ -probe(case: \"genitive\") }" }, mutta siinä on oltava lähdetekstin koodit eikä muita: puuttuvan koodin mukana katoaisi tieto, esimerkiksi syvyys tai parametri. Lisää puuttuvat koodit ja poista ne, joita ei sallita.
explain-texts-unit-exchanged =
    Käännöksen sanat ovat ennallaan ja vain koodit ovat muissa paikoissa, joten kukin arvo tarkoittaisi muuta asiaa. Palauta koodit paikoilleen. Jos uusi järjestys on oikea, muuta myös sanoja tai muokkaa Fluent-tiedostoa.
explain-texts-unit-incomplete =
    Uusi teksti, jossa on muunnelmia esimerkiksi yhdelle ja usealle reiälle, on valmis vasta, kun kaikki muunnelmat ovat mukana: puuttuvasta jäisi aukko lauseeseen. Käännä kaikki yksiköt, joiden tunnus alkaa samalla avaimella, ja merkitse ne valmiiksi.
explain-texts-unit-refused =
    Jokainen yksikkö tarkistetaan samoin kuin ”ciklo lint” tarkistaa kielen tekstit: syntaksi, termit ja niiden sijamuodot, samat luvut, yksiköt ja argumentit kuin muissa kielissä sekä selitetekstien isot kirjaimet, merkit ja pituus. Tästä yksiköstä tulisi lainattu huomautus. ”ciklo explain” ja sulkeissa oleva koodi kertovat siitä lisää. Korjaa yksikkö ja tuo tiedosto uudelleen; jo otetut yksiköt pysyvät silloin ennallaan.
explain-texts-unit-markup =
    Proosasivu säilyttää lähteensä muodon: yhtä monta otsikkoa, kappaletta, luettelokohtaa ja solua, linkit ja korostukset kääntäjän valitsemien sanojen ympärillä. Avaava merkintä on suljettava, eivätkä esimerkiksi sanojen sisällä olevat merkit * ja | saa aloittaa mitään uutta. Ciklo on jo yrittänyt kirjoittaa tällaiset merkit kenoviivan kanssa. Palauta koodit pareittain ja tuo yksikkö uudelleen.
explain-texts-unit-numbers =
    Luvut ja numeroita sisältävät sanat, esimerkiksi 0.5, Q200 ja M99, ovat tosiasioita: sivun käännöksessä ne ovat samat kuin lähteessä. Desimaalierotin saa olla kielen oma. Jos lähteessä luku on kirjoitettu sanana, se kirjoitetaan sanana myös käännöksessä. Vertaa tekstejä ja korjaa virheellinen.
explain-texts-unknown-topic =
    Proosasivut ovat tiedostoja kansiossa locales/en/topics; tiedoston nimi ilman päätettä ”.md” on aihe, esimerkiksi sl-cycles. Ilman valitsinta --topic viedään kaikki tekstit, myös sivut.
explain-draft-language =
    Luonnos täyttää tekeillä olevan kielen aukot englannilla, jotta sivuja voi lukea, ennen kuin kaikki on käännetty. Se tehdään yhdestä kielestä, jottei valmista kieltä vahingossa näytetä luonnoksena. Kielellä ei tarvitse vielä olla kansiota. Ilman valitsinta --draft sivu, josta puuttuu teksti, hylätään.
explain-texts-unit-swapped =
    Kahdesta valinnasta tai tuloksesta kummallakin on tiedostossa ne sanat, jotka toisella on nyt, joten lukija antaisi väärän arvon. Kumpaakaan ei oteta. Palauta sanat. Jos vaihtuneet ovat nykyiset sanat, muuta niitä Fluent-tiedostossa.
explain-texts-unit-negation =
    Englanninkielinen teksti kieltää jotakin, ja tiedoston käännös on nykyinen ilman kieltävää sanaa, esimerkiksi ”ei” tai ”eikä”. Se sallisi kielletyn tai ilmoittaisi tapahtuneeksi sellaista, mitä ei tapahtunut. Palauta sana. Jos virke kieltää muulla tavalla, kirjoita se niin; jos sana oli väärin, poista se Fluent-tiedostosta.
