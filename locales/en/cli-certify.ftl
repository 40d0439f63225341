# The command “certify” and its messages.
cli-certify = Report the result of checking the programs of a post-processor, by program, cycle and rule
cli-certify-path = NC programs, or folders with programs (.h, .i)
cli-certify-program =
    { $verdict ->
        [fail] { $file }: fail
       *[out-of-subset] { $file }: out of subset
    } ({ $errors } errors, { $warnings } warnings)
cli-certify-cycle =
    { $verdict ->
        [pass] { $cycle }: pass
        [fail] { $cycle }: fail
       *[out-of-subset] { $cycle }: out of subset
    } ({ $count } definitions, { $wrong } with errors)
cli-certify-rule = { $severity } { $rule }: { $count } times in { $programs } programs, first { $first }
cli-certified = { $control }: { $count } programs, { $pass } pass, { $fail } fail, { $out } out of subset
cli-examples-certify =
    ciklo certify output --control itnc530
    ciklo certify output --control tnc640 --format json > report.json
