# Ukaz »certify« in njegova sporočila.
cli-certify = Poroča o izidu preverjanja programov postprocesorja: po programih, ciklih in pravilih
cli-certify-path = NC-programi ali mape s programi (.h, .i)
cli-certify-program =
    { $verdict ->
        [fail] { $file }: ni ustrezno
       *[out-of-subset] { $file }: zunaj specifikacij
    } (napake: { $errors }, opozorila: { $warnings })
cli-certify-cycle =
    { $verdict ->
        [pass] { $cycle }: ustrezno
        [fail] { $cycle }: ni ustrezno
       *[out-of-subset] { $cycle }: zunaj specifikacij
    } (definicije: { $count }, z napakami: { $wrong })
cli-certify-rule = { $severity } { $rule }: ugotovitve: { $count }, programi: { $programs }, prvič: { $first }
cli-certified = { $control }: programi: { $count }, ustrezno: { $pass }, ni ustrezno: { $fail }, zunaj specifikacij: { $out }
cli-examples-certify =
    ciklo certify output --control itnc530
    ciklo certify output --control tnc640 --format json > report.json
