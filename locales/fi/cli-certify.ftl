# Komento ”certify” ja sen ilmoitukset.
cli-certify = Näytä, miten postprosessorin ohjelmat läpäisevät tarkastuksen: ohjelmittain, työkierroittain ja säännöittäin
cli-certify-path = NC-ohjelmat tai hakemistot, joissa on ohjelmia (.h, .i)
cli-certify-program =
    { $verdict ->
        [fail] { $file }: hylätty
       *[out-of-subset] { $file }: kuvausten ulkopuolella
    } (virheitä { $errors }, varoituksia { $warnings })
cli-certify-cycle =
    { $verdict ->
        [pass] { $cycle }: hyväksytty
        [fail] { $cycle }: hylätty
       *[out-of-subset] { $cycle }: kuvausten ulkopuolella
    } (määrittelyjä { $count }, virheellisiä { $wrong })
cli-certify-rule = { $severity } { $rule }: havaintoja { $count }, ohjelmia { $programs }, ensimmäinen: { $first }
cli-certified = { $control }: ohjelmia { $count }, hyväksytty { $pass }, hylätty { $fail }, kuvausten ulkopuolella { $out }
cli-examples-certify =
    ciklo certify output --control itnc530
    ciklo certify output --control tnc640 --format json > report.json
