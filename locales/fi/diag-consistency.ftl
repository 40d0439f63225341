# Tekstit, jotka eivät täsmää keskenään; katso src/accord.
diag-consistency-negation = Kielen { $language } tekstissä { $key } ei ole kieltosanaa, vaikka kielissä { $others } on.
diag-consistency-number = Kielen { $language } tekstissä { $key } on muut luvut kuin kielissä { $others }: { $found }, odotettu { $expected }.
diag-consistency-unit = Kielen { $language } tekstissä { $key } on muut yksiköt kuin kielissä { $others }: { $found }, odotettu { $expected }.
diag-consistency-variant = Kielen { $language } teksti { $key } on käytössä myös tapauksessa { $variant }, jolle englannissa on oma muunnelma muine tietoineen: { $found }, odotettu { $expected }. Muunnelma puuttuu.
diag-consistency-code = Kielen { $language } teksti { $key } mainitsee muut parametrit, toiminnot tai sarakkeet kuin kielet { $others }: { $found }, odotettu { $expected }.
diag-consistency-argument = Kielen { $language } tekstissä { $key } on muut argumentit kuin kielissä { $others }: { $found }, odotettu { $expected }.
diag-consistency-label-twice = Kielessä { $language } saman työkierron parametreilla ”{ $parameter }” ja ”{ $other }” on sama teksti { $label }.
diag-consistency-label-of-another = Kielessä { $language } parametrin ”{ $parameter }” teksti { $label } kuuluu parametrille ”{ $other }”.
diag-consistency-swapped = Kielen { $language } tekstit { $key } ja { $other } näyttävät vaihtuneen keskenään; vertaa kieliin { $others }.
diag-consistency-quantity = { $parameter } mittaa suuretta { $found }, mutta sen nimi kielessä { $language } (”{ $name }”) viittaa suureeseen { $expected }.
diag-consistency-reference = { $parameter } on { $found }, mutta sen nimi kielessä { $language } (”{ $name }”) viittaa mittaan, joka on { $expected }.
related-said-here = teksti on tässä
diag-spec-odd-q = Työkierrossa { $cycle } parametrin { $q } nimi on ”{ $name }”, joka on muissa työkierroissa { $usual }; niissä { $q } on ”{ $other }”.
diag-spec-odd-choice = Vaihtoehdon ”{ $name }” arvo on tässä { $value } mutta muissa työkierroissa { $usual }.
diag-spec-odd-limit = Parametrin { $name } rajaa { $value } ei ole millään muulla tämän suureen parametrilla; useimmilla on { $usual }.
diag-spec-odd-condition = Ehdon ”{ $name }” mukaan { $q } on { $found }, mutta samannimisen vaihtoehdon arvo on { $value }.
diag-spec-odd-formula = Työkierto { $cycle } laskee arvon ”{ $name }” parametrista { $q }, mutta muut työkierrot laskevat sen parametrista { $usual }, joka tälläkin työkierrolla on.
diag-spec-example-guarded = Tarkastus ”{ $code }” hylkää painetun esimerkin.
diag-spec-unused-parameter = Mikään työkierron { $cycle } kulussa, tarkastuksissa tai lauseissa ei käytä parametria { $q }.
diag-spec-odd-result = { $reason ->
        [parameter] { $q } on työkierron { $cycle } tulos ja myös sen parametri
       *[not-a-result] Työkierron { $cycle } kulku asettaa parametrin { $q }, joka ei ole sen tulos eikä parametri
    }.
diag-consistency-reference-word = Kielen { $language } teksti { $key } ei mainitse absoluuttista tai inkrementaalista niin kuin kielet { $others }: { $found }, odotettu { $expected }.
diag-locale-unused = Mikään kuvaus tai teksti ei käytä tekstiä { $key }.
diag-spec-example-fails = Esimerkki ”{ $name }” ei anna ohjauksella { $control } odotettua tulosta: { $what } on { $found }, odotettu { $expected }.
diag-consistency-term = Kielen { $language } tekstistä { $key } puuttuu termi ”{ $term }” (lähteessä ”{ $source }”).
diag-consistency-forbidden = Kielen { $language } tekstissä { $key } on ”{ $word }”; termi on ”{ $term }”.
