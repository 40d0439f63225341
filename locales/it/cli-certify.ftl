# Il comando «certify» e i suoi messaggi.
cli-certify = Riporta l’esito della verifica dei programmi di un postprocessor, per programma, ciclo e regola
cli-certify-path = Programmi NC o cartelle con programmi (.h, .i)
cli-certify-program =
    { $verdict ->
        [fail] { $file }: non conforme
       *[out-of-subset] { $file }: fuori da quanto descritto
    } (errori: { $errors }, avvisi: { $warnings })
cli-certify-cycle =
    { $verdict ->
        [pass] { $cycle }: conforme
        [fail] { $cycle }: non conforme
       *[out-of-subset] { $cycle }: fuori da quanto descritto
    } (definizioni: { $count }, con errori: { $wrong })
cli-certify-rule = { $severity } { $rule }: { $count } volte, programmi: { $programs }, prima volta { $first }
cli-certified = { $control }: programmi: { $count }, conformi: { $pass }, non conformi: { $fail }, fuori da quanto descritto: { $out }
cli-examples-certify =
    ciklo certify output --control itnc530
    ciklo certify output --control tnc640 --format json > report.json
