# Tekstit, jotka eivät täsmää keskenään; katso src/accord.
diag-accord-number = Kielen { $language } tekstissä { $key } on muut luvut kuin kielissä { $others }: { $found }, odotettu { $expected }.
diag-accord-unit = Kielen { $language } tekstissä { $key } on muut yksiköt kuin kielissä { $others }: { $found }, odotettu { $expected }.
diag-accord-code = Kielen { $language } teksti { $key } mainitsee muut parametrit, toiminnot tai sarakkeet kuin kielet { $others }: { $found }, odotettu { $expected }.
diag-accord-argument = Kielen { $language } teksti { $key } pyytää muut argumentit kuin kielet { $others }: { $found }, odotettu { $expected }.
diag-accord-label-twice = Kielessä { $language } saman työkierron parametreilla ”{ $parameter }” ja ”{ $other }” on sama teksti { $label }.
diag-accord-label-of-another = Kielessä { $language } parametrin ”{ $parameter }” teksti { $label } kuuluu parametrille ”{ $other }”.
diag-accord-swapped = Kielessä { $language } tekstit { $key } ja { $other } näyttävät vaihtaneen paikkaa; vertaa kieliin { $others }.
