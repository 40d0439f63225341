# Komento ”certify” ja sen ilmoitukset.
cli-certify = Kerro, miten jälkiprosessorin ohjelmat menestyvät: ohjelmittain, työkierroittain ja säännöittäin
cli-certify-path = NC-ohjelmat tai hakemistot, joissa on ohjelmia (.h, .i)
cli-certify-program =
    { $verdict ->
        [fail] { $file }: hylätty
       *[out-of-subset] { $file }: kuvauksen ulkopuolella
    } (virheitä { $errors }, varoituksia { $warnings })
cli-certify-cycle =
    { $verdict ->
        [pass] { $cycle }: hyväksytty
        [fail] { $cycle }: hylätty
       *[out-of-subset] { $cycle }: kuvauksen ulkopuolella
    } (määrittelyjä { $count }, virheellisiä { $wrong })
cli-certify-rule = { $severity } { $rule }: löydöksiä { $count }, ohjelmia { $programs }, ensimmäinen { $first }
cli-certified = { $control }: ohjelmia { $count }, hyväksytty { $pass }, hylätty { $fail }, kuvauksen ulkopuolella { $out }
cli-examples-certify =
    ciklo certify tulos --control itnc530
    ciklo certify tulos --control tnc640 --format json > raportti.json
