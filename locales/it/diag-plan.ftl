## Errori nelle esecuzioni dei cicli.

diag-plan-argument = L’argomento non ha la forma giusta: { $expected ->
    [mapping] sono attesi argomenti con nome.
    [one-transform] è atteso esattamente un cambiamento del sistema di coordinate.
    [point-or-axes] è atteso un punto oppure almeno uno tra main, minor e tool.
    [add-or-value] è atteso add oppure value, non entrambi.
    [read-or-write] è atteso add o value (per scrivere) oppure as (per leggere).
    [list-of-points] è atteso un elenco di punti.
    [q-parameter] è atteso un parametro Q.
    [q-number-field] è atteso un campo che indica un parametro Q.
    [no-result] la strategia non ha un risultato al quale si possa dare un nome.
    [type-word] è atteso number, truth, point o text.
    [spindle-word] è atteso clockwise, counter-clockwise o stop.
    [coolant-word] è atteso flood o stop.
    [cancel-word] è atteso radius-compensation, datum-shift, mirroring, rotation, scaling o axis-scaling.
   *[other] è atteso: { $expected }.
}
diag-plan-missing-argument = Manca l’argomento { $name }.
diag-plan-modifier = Il verbo { $verb } non ammette { $modifier }.
diag-plan-name-form = Il nome { $name } può contenere solo lettere minuscole, cifre e _.
diag-plan-name-taken = Il nome { $name } è già occupato qui.
diag-plan-recursive-fragment = Il frammento { $name } utilizza sé stesso.
diag-plan-too-many-fragments = Il ciclo usa più di { NUMBER($limit) } frammenti, compresi quelli all’interno di altri frammenti.
diag-plan-type = Atteso: { $expected }, trovato: { $found }.
diag-plan-unknown-argument = Non esiste l’argomento { $name }; sono possibili { $known }.
diag-plan-unknown-field = Il ciclo non ha il campo { $name }.
diag-plan-unknown-fragment = Non esiste il frammento { $name }.
diag-plan-unknown-name = Il nome { $name } qui non è definito.
diag-plan-unknown-series = Non esiste la serie { $name }; sono possibili { $known }.
diag-plan-unknown-strategy = Non esiste la strategia { $name }; nomi simili sono { $near }.
diag-plan-unknown-table = Non esiste la tabella { $name }; sono possibili { $known }.
