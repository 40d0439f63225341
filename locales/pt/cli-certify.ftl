# O comando «certify» e as suas mensagens.
cli-certify = Indica o resultado da verificação dos programas de um pós-processador, por programa, ciclo e regra
cli-certify-path = Programas NC ou pastas com programas (.h, .i)
cli-certify-program =
    { $verdict ->
        [fail] { $file }: não conforme
       *[out-of-subset] { $file }: fora do que está descrito
    } (erros: { $errors }, avisos: { $warnings })
cli-certify-cycle =
    { $verdict ->
        [pass] { $cycle }: conforme
        [fail] { $cycle }: não conforme
       *[out-of-subset] { $cycle }: fora do que está descrito
    } (definições: { $count }, com erros: { $wrong })
cli-certify-rule = { $severity } { $rule }: { $count } vezes, programas: { $programs }, primeira vez { $first }
cli-certified = { $control }: programas: { $count }, conformes: { $pass }, não conformes: { $fail }, fora do que está descrito: { $out }
cli-examples-certify =
    ciklo certify output --control itnc530
    ciklo certify output --control tnc640 --format json > report.json
