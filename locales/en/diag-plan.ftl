## Mistakes in the runs of cycles. $expected and $found name a kind of value.

diag-plan-argument = The argument is not well formed: { $expected ->
    [mapping] named arguments are expected.
    [one-transform] exactly one change of the coordinate system is expected.
    [point-or-axes] either a point or at least one of main, minor and tool is expected.
    [add-or-value] either add or value is expected, not both.
    [read-or-write] either add or value (to write) or as (to read) is expected.
    [list-of-points] a list of points is expected.
    [q-parameter] a Q parameter is expected.
    [q-number-field] a field that names a Q parameter is expected.
    [no-result] the strategy has no result that could be given a name.
    [type-word] number, truth, point or text is expected.
    [spindle-word] clockwise, counter-clockwise or stop is expected.
    [coolant-word] flood or stop is expected.
    [cancel-word] radius-compensation, datum-shift, mirroring, rotation, scaling or axis-scaling is expected.
   *[other] { $expected } is expected.
}
diag-plan-missing-argument = The argument { $name } is missing.
diag-plan-modifier = The verb { $verb } does not accept { $modifier }.
diag-plan-name-form = The name { $name } may consist of lower-case letters, digits and _ only.
diag-plan-name-taken = The name { $name } is already taken here.
diag-plan-recursive-fragment = The fragment { $name } uses itself.
diag-plan-too-many-fragments = The cycle uses more than { NUMBER($limit) } fragments, including those within other fragments.
diag-plan-type = Expected { $expected }, found { $found }.
diag-plan-unknown-argument = There is no argument { $name }; possible are { $known }.
diag-plan-unknown-field = The cycle has no field { $name }.
diag-plan-unknown-fragment = No fragment is named { $name }.
diag-plan-unknown-name = The name { $name } is not defined here.
diag-plan-unknown-series = There is no series { $name }; possible are { $known }.
diag-plan-unknown-strategy = There is no strategy { $name }; similar names are { $near }.
diag-plan-unknown-table = There is no table { $name }; possible are { $known }.
