## Napake v potekih ciklov.

diag-plan-argument = Argument ni pravilno oblikovan: { $expected ->
    [mapping] pričakovani so poimenovani argumenti.
    [one-transform] pričakovana je natanko ena sprememba koordinatnega sistema.
    [point-or-axes] pričakovana je točka ali vsaj ena od vrednosti main, minor in tool.
    [add-or-value] pričakovana je vrednost add ali value, ne obe.
    [read-or-write] pričakovana je vrednost add ali value (pisanje) ali as (branje).
    [list-of-points] pričakovan je seznam točk.
    [q-parameter] pričakovan je Q-parameter.
    [q-number-field] pričakovano je polje, ki imenuje Q-parameter.
    [no-result] strategija nima rezultata, ki bi mu bilo mogoče dati ime.
    [type-word] pričakovana je beseda number, truth, point ali text.
    [spindle-word] pričakovana je beseda clockwise, counter-clockwise ali stop.
    [coolant-word] pričakovana je beseda flood ali stop.
    [cancel-word] pričakovana je beseda radius-compensation, datum-shift, mirroring, rotation, scaling ali axis-scaling.
   *[other] pričakovano: { $expected }.
}
diag-plan-missing-argument = Manjka argument { $name }.
diag-plan-modifier = Glagol { $verb } ne sprejme dodatka { $modifier }.
diag-plan-name-form = Ime { $name } lahko vsebuje le male črke, števke in znak _.
diag-plan-name-taken = Ime { $name } je tukaj že zasedeno.
diag-plan-recursive-fragment = Fragment { $name } uporablja samega sebe.
diag-plan-too-many-fragments = Cikel uporablja več kot { NUMBER($limit) } fragmentov, vključno z ugnezdenimi.
diag-plan-type = Pričakovano: { $expected }, najdeno: { $found }.
diag-plan-unknown-argument = Argumenta { $name } ni; mogoči so: { $known }.
diag-plan-unknown-field = Cikel nima polja { $name }.
diag-plan-unknown-fragment = Fragment { $name } ne obstaja.
diag-plan-unknown-name = Ime { $name } tu ni določeno.
diag-plan-unknown-series = Zaporedja { $name } ni; mogoča so: { $known }.
diag-plan-unknown-strategy = Strategije { $name } ni; podobna imena so: { $near }.
diag-plan-unknown-table = Preglednice { $name } ni; mogoče so: { $known }.
