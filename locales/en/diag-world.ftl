# Findings about scenes, machines, tables and solids.
# $found and $known come from the file or from the program and are shown as they are.

diag-scene-expected =
    { $expected ->
        [mapping] Expected a mapping of keys and values, found "{ $found }".
        [list] Expected a list, found "{ $found }".
        [number] Expected a number, found "{ $found }".
        [text] Expected a text, found "{ $found }".
        [axis] Expected the letter of an axis (X, Y or Z), found "{ $found }".
        [two-numbers] Expected two numbers, found "{ $found }".
        [three-numbers] Expected three numbers, found "{ $found }".
        [row-number] Expected the number of a table row, found "{ $found }".
        [unit] The unit must be mm or inch, not "{ $found }".
        [clock] Expected a date and a time such as 2015-07-03T14:05:00, found "{ $found }".
        [datum-file] The name of a datum table must end in .D.
        [table-file] The name of a freely definable table must end in .TAB.
        [rotary-axis] Expected the letter of a rotary axis (A, B or C), found "{ $found }".
        [parallel-axis] Expected the letter of a parallel axis (U, V or W), found "{ $found }".
        [carried] A rotary axis carries the workpiece or the tool, not "{ $found }".
        [encoder] The encoder of an axis is motor or axis, not "{ $found }".
        [orientation] The orientation must be fixed, two or any, not "{ $found }".
        [shaft] The shaft must be thinner than the ball; its diameter is { $found }.
        [measurements] 1, 2 or 3 measurements are possible, not "{ $found }".
       *[solids] Expected at least one solid.
    }
diag-scene-unknown-key = The key { $key } is not possible here; possible keys are { $known }.
diag-scene-missing-key = The key { $key } is missing.
diag-scene-not-positive = This must be greater than zero, not { $found }.
diag-scene-version = This version of the file format is not supported; supported is { $known }.
diag-scene-repeated = { $found } is defined twice.
diag-scene-min-max = Every minimum must be smaller than its maximum.
diag-scene-no-length = The length is zero.
diag-scene-one-solid = Exactly one solid is expected here: { $known }.
diag-scene-unknown-machine = There is no machine named { $name }; the machines are { $known }.
diag-scene-no-axis = The machine has no axis { $axis }.
diag-scene-start-outside = The start position is outside the traverse range of axis { $axis }: { $found } { $unit } is not between { $min } and { $max } { $unit }.
diag-scene-stl = { $file }: { $kind ->
        [nowhere] A scene inside of another file cannot name STL files.
        [large] All STL files of a scene together may have { $most } MB.
        [number] In triangle { $triangle } a coordinate is not a number, or greater than 1000000.
        [length] The file does not have the length that its { $triangle } triangles need.
       *[empty] There is no triangle with an area.
    }
diag-scene-stl-word = Expected { $wanted ->
        [number] a number up to 1000000
       *[word] the word { $wanted }
    }, found "{ $found }".

diag-solid-not-finite = A dimension is not a finite positive number.
diag-solid-too-many = The shape has too many surfaces: it would take too long to find its edges. Leave out what no tool or probe comes near.
diag-solid-edge-unsupported = The ball may touch an edge that is neither a straight line nor a circle; this contact cannot be calculated exactly.
diag-solid-cusp = The ball may touch a place where surfaces meet tangentially and leave no thickness; this contact cannot be calculated exactly.
diag-solid-mesh-cut = A triangulated surface cannot be part of a difference.
diag-solid-helix-unsupported = The ball may touch the workpiece on a helix or while several axes move; this contact cannot be calculated exactly.

diag-table-no-header = The table must begin with a line "BEGIN", the name of a { $extension } file and the unit.
diag-table-no-heading = The second line must contain the names of the columns, including { $column }.
diag-table-no-end = The line [END] is missing.
diag-table-not-described = The manuals do not describe tables of this kind: only the beginning and the end are checked.
diag-table-no-row-number = The row has no number: "{ $found }".
diag-table-duplicate-row = Row { $row } occurs twice.
diag-table-bad-number = { $file }, row { $row }, column { $column }: "{ $found }" is not a number.
diag-table-missing = There is no table { $file }.
diag-table-no-row = The table { $file } has no row { $row }.
diag-table-no-column = The table { $file } has no column { $column }.
diag-table-too-wide = { $file }, row { $row }: the value does not fit into column { $column }.
diag-table-text-in-numbers = { $file }, row { $row }: column { $column } accepts numbers only.
diag-table-key-column = { $file }, row { $row }: the row number in column { $column } cannot be changed.
diag-table-duplicate-column = Column { $column } occurs twice.
diag-table-unknown-column =
    { $count ->
        [one] The manuals do not describe the column { $column }: its cells are not checked.
       *[other] The manuals do not describe the columns { $column }: their cells are not checked.
    }
diag-table-doubtful =
    { $what ->
        [unit] The first line contains neither MM nor INCH.
        [kind] The first line names a { $found } file, but this is a { $column } file.
        [column] The column { $column } is missing.
        [order] Row { $row } comes after row { $found }.
        [after-end] Lines after [END] are not read.
        [astride] Row { $row }: the number in column { $column } extends into column { $found }.
        [empty] Row { $row }: column { $column } is empty.
        [corner] Row { $row }: R2 is greater than R.
        [same] Row { $row } contains the same point as row { $found }.
        [zero] Tool 0 means that no tool is called; its { $column } should be 0.
        [less] In row { $row }, { $column } is less than { $found }.
       *[value] Row { $row }: “{ $found }” in column { $column } is probably a mistake.
    }
diag-table-value-not-allowed = Row { $row }: column { $column } does not accept “{ $found }”.

diag-stock-extent = The blank is too large: it extends further than { $limit } mm from its datum.
diag-stock-form = BLK FORM { $word } does not say here what the blank is: define it in the scene, as a cuboid with BLK FORM 0.1 and 0.2, or with BLK FORM CYLINDER.
diag-stock-missing = There is no blank: the scene has no stock and the program has no BLK FORM.
diag-stock-blank = BLK FORM needs numbers that give the blank an extent: each minimum must be smaller than its maximum, a cylinder larger than its bore.
diag-stock-resolution = { $found } cannot be the distance between the columns of the stock: it must be greater than zero, and there may be at most 10 million columns.
diag-stock-resolution-mesh = The part has more triangles than an STL file can hold; choose a greater distance between the columns.
