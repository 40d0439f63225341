# Cycles that set a datum.

# --- 412 ---
cycle-datum-inside-circle = Datum at centre of hole (inside of circle)
    .nc = DATUM INSIDE CIRCLE
    .purpose = Measures the centre of a circular pocket or a hole and sets it as the datum. If desired, the control also writes the centre to a datum table or preset table.
cycle-datum-inside-circle__tnc426-430 =
    .purpose = Measures the centre of a circular pocket or a hole and sets it as the datum. If desired, the control also writes the centre to a datum table.
step-retract-and-store-datum = The control returns the touch probe to the clearance height { $q-clearance-height }, stores the actual values in the result parameters and sets or stores the measured datum as defined in { $q-measured-value-transfer } and { $q-datum-row-number }:
step-retract-and-store-datum__tnc426-430 = The control returns the touch probe to the clearance height { $q-clearance-height } and sets or stores the measured datum as defined in { $q-datum-row-number }:
say-datum-into-display-and-row-zero = with { $q-datum-row-number }=0 it sets the measured datum in the display; the datum is active at once and is also stored in row 0 of the preset table
say-datum-into-display = with { $q-datum-row-number }=0 it sets the measured datum in the display; the datum is active at once
say-datum-into-datum-table = with { $q-datum-row-number } not 0 and { $q-measured-value-transfer }=0 it writes the measured datum to row { $q-datum-row-number } of the active datum table; the reference system is the active workpiece coordinate system
say-datum-into-datum-table__tnc426-430 = with { $q-datum-row-number } not 0 it writes the measured datum to row { $q-datum-row-number } of the active datum table
say-datum-into-preset-table = with { $q-datum-row-number } not 0 and { $q-measured-value-transfer }=1 it writes the measured datum to row { $q-datum-row-number } of the preset table; the reference system is the machine coordinate system (REF coordinates)
step-probe-in-probe-axis = If selected, the control then measures the datum in the touch probe axis in a separate probing:
say-datum-in-probe-axis = with { $q-probing-in-probe-axis }=1 it probes the point { $q-probe-axis-point-main }, { $q-probe-axis-point-minor }, { $q-probe-axis-point-tool } in the touch probe axis, retracts, and sets or stores the datum { $q-new-datum-probe-axis } in the same way as that of the working plane
guard-datum-transfer-undefined = { $q-datum-row-number } is not 0 and { $q-measured-value-transfer } is −1: define where the measured datum is to be stored.
guard-transformation-with-probe-axis-datum = A datum shift or rotation is active, but { $q-measured-value-transfer }=0 and { $q-probing-in-probe-axis }=1 do not permit a coordinate transformation.
note-nominal-diameter-rather-small = Danger of collision! To avoid a collision between the touch probe and the workpiece, enter a nominal diameter of the pocket (hole) that is too small rather than too large.
note-probing-from-centre-if-narrow = If the dimensions of the pocket and the set-up clearance do not permit pre-positioning near the touch points, the control always starts probing from the centre of the pocket. The touch probe then does not move to clearance height between the measuring points.
note-no-transformation-with-probe-axis-datum = If the cycle sets a datum with { $q-measured-value-transfer }=0 and also probes in the touch probe axis ({ $q-probing-in-probe-axis }=1), no coordinate transformation may be active.
note-no-tilting-with-datum-cycles = Tilting the working plane is not permitted together with the datum setting cycles 408 to 419.
note-datum-cycles-with-basic-rotation = The datum setting cycles 408 to 419 may also be executed with an active basic rotation.
note-datum-cycles-with-basic-rotation__tnc640 = The datum setting cycles 408 to 419 may also be executed with an active rotation (basic rotation or cycle 10).
note-basic-rotation-must-stay = Do not change the angle of the basic rotation if a datum shift (cycle 7) from the datum table is used after the measuring cycle.
note-no-datum-cycles-with-basic-rotation = The datum setting cycles 410 to 418 must not be executed with an active basic rotation. Otherwise the control shows an error message.
note-datum-axes-by-probe-axis = The touch probe axis defined in the measuring program determines the axes in which the datum is set: Z: X and Y; Y: Z and X; X: Y and Z.
note-datum-axes-by-probe-axis__tnc426-430 = The touch probe axis defined in the measuring program determines the axes in which the datum is set: Z or W: X and Y; Y or V: Z and X; X or U: Y and Z.
note-transfer-minus-one = { $q-datum-row-number } not 0 together with { $q-measured-value-transfer }=−1 arises only if programs with the cycles 410 to 418 come from a TNC 4xx or from older software of the iTNC 530, or if the transfer was left undefined in the cycle definition. The control then shows an error message, because the handling of datum tables referenced to the machine datum has changed; define the transfer.
note-activate-stored-datum = A datum stored in the datum table is activated in the program with cycle 7, one stored in the preset table with cycle 247.
note-datum-table-must-be-active = To write the measured datum to a datum table, activate a datum table in a program run mode (status M) before the measuring program starts.
note-datum-table-reference = When it writes to the datum table, the control takes { $mp-datum-table-reference } into account: 0: values referred to the workpiece datum; 1: values referred to the machine datum. If { $mp-datum-table-reference } is changed afterwards, the control converts the values stored in the datum tables.
