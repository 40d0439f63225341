# Tekstit, jotka eivät täsmää keskenään; katso src/accord.
diag-accord-number = Kielen { $language } tekstissä { $key } on muut luvut kuin kielissä { $others }: { $found }, odotettu { $expected }.
diag-accord-unit = Kielen { $language } tekstissä { $key } on muut yksiköt kuin kielissä { $others }: { $found }, odotettu { $expected }.
diag-accord-code = Kielen { $language } teksti { $key } mainitsee muut parametrit, toiminnot tai sarakkeet kuin kielet { $others }: { $found }, odotettu { $expected }.
diag-accord-argument = Kielen { $language } teksti { $key } pyytää muut argumentit kuin kielet { $others }: { $found }, odotettu { $expected }.
diag-accord-label-twice = Kielessä { $language } saman työkierron parametreilla ”{ $parameter }” ja ”{ $other }” on sama teksti { $label }.
diag-accord-label-of-another = Kielessä { $language } parametrin ”{ $parameter }” teksti { $label } kuuluu parametrille ”{ $other }”.
diag-accord-swapped = Kielessä { $language } tekstit { $key } ja { $other } näyttävät vaihtaneen paikkaa; vertaa kieliin { $others }.
diag-accord-quantity = { $parameter } mittaa suuretta { $found }, mutta sen nimi kielessä { $language } (”{ $name }”) viittaa suureeseen { $expected }.
diag-accord-reference = { $parameter } on { $found }, mutta sen nimi kielessä { $language } (”{ $name }”) viittaa mittaan, joka on { $expected }.
related-said-here = teksti on tässä
diag-spec-odd-q = { $cycle } antaa parametrille { $q } nimen ”{ $name }”, joka muualla on { $usual }; muualla { $q } on ”{ $other }”.
diag-spec-odd-choice = Vaihtoehdon ”{ $name }” arvo on tässä { $value } ja muualla { $usual }.
diag-spec-odd-limit = Raja { $value } parametrissa { $name } ei esiinny tällä suureella missään muualla; { $usual } esiintyy.
diag-spec-odd-condition = Ehdon ”{ $name }” mukaan { $q } on { $found }, mutta samannimisen vaihtoehdon arvo on { $value }.
diag-spec-example-guarded = Tarkastus ”{ $code }” hylkää painetun esimerkin.
diag-spec-unused-parameter = Mikään työkierron { $cycle } kulussa, tarkastuksissa tai lauseissa ei käytä parametria { $q }.
