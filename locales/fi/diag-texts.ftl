diag-texts-nothing-chosen = Ilmoita, mitä hyväksytään: --text KEY, --changed tai --all.
diag-texts-unknown-key = Missään käännöksessä ei ole tekstiä, jonka avain on ”{ $key }”.
diag-locale-same-as-source = Teksti ”{ $key }” on kielellä ”{ $language }” sama kuin englanniksi.
diag-texts-no-file = ”texts import” tarvitsee luettavan tiedoston.
diag-texts-no-language = ”{ $language }” ei ole kieli, jolle käännetään; ilmoita kieli valitsimella --to, esimerkiksi ”--to fi”.
diag-texts-file-unreadable = Tiedostoa ei voida lukea: { $reason ->
        [document-type] dokumenttityyppejä ja omia entiteettejä ei hyväksytä
        [entity] siinä on tuntematon entiteetti
        [encoding] merkistö ei ole UTF-8
        [depth] elementtejä on liian monta sisäkkäin
        [columns] taulukosta puuttuvat sarakkeet concept ja language
        [empty] tiedosto on tyhjä
        [quote] tästä alkaa lainausmerkeissä oleva solu, joka ei pääty
        [size] se on suurempi kuin 64 Mt
        [xliff] se ei ole XLIFF 1.2 eikä XLIFF 2.0
       *[form] muoto on tästä eteenpäin virheellinen
    }.
diag-texts-unit-unknown = Yksikköä ”{ $key }” vastaavaa tekstiä ei ole.
diag-texts-unit-twice = Yksikkö ”{ $key }” on tiedostossa useita kertoja.
diag-texts-unit-source-changed = Yksikön ”{ $key }” lähdeteksti ei ole nykyinen: vie teksti uudelleen.
diag-texts-unit-not-read = Yksikössä ”{ $key }” ei ole käännöstä, tai siinä on tuntemattomia elementtejä.
diag-texts-unit-codes = Yksikön ”{ $key }” koodit eivät täsmää: puuttuu { $missing }, ei sallittu { $foreign }.
diag-texts-unit-exchanged = Yksikössä ”{ $key }” koodit ovat vaihtaneet paikkaa samojen sanojen joukossa.
diag-texts-unit-incomplete = Yksikkö ”{ $key }” on yksi uuden tekstin muunnelmista; muut puuttuvat tai on hylätty.
diag-texts-unit-refused = Yksikkö ”{ $key }” hylätään ({ $code }): { $finding }
diag-texts-unit-markup = Yksikön ”{ $key }” käännös muuttaisi sivun muotoa: merkintöjä tai ympäröiviä lohkoja.
diag-texts-unit-numbers = Yksikön ”{ $key }” luvut eroavat lähteestä: puuttuu { $missing }, lähteessä ei ole { $foreign }.
diag-texts-unknown-topic = Proosasivua ”{ $topic }” ei ole.
diag-draft-language = Luonnos tehdään yhdestä kielestä: ilmoita se valitsimella --lang, esimerkiksi ”--draft --lang de”.
diag-texts-unit-swapped = Yksiköt ”{ $key }” ja ”{ $other }” ovat saaneet toistensa sanat.
diag-texts-unit-negation = Yksiköstä ”{ $key }” on poistettu kieltävä sana, joten teksti sanoo päinvastaista.
