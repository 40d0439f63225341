# Coordinate transformations.

# --- common ---
form-coordinates = Coordinates of the datum
form-table = Row of a datum table
note-transform-acts-until-reset = A coordinate transformation acts from its definition; it is not called. It stays in effect until it is reset or defined again.
note-transform-reset-ways = A coordinate transformation is reset by defining the cycle again with the values of the basic state (such as scaling factor 1.0), by the miscellaneous functions M2 and M30 or the END PGM block (depending on the machine parameter { $mp-clear-mode }), and by selecting another program.

# --- 7 ---
cycle-datum-shift = Datum shift
    .nc = DATUM SHIFT
    .purpose = Shifts the datum, so that machining operations can be repeated at any position on the workpiece. After the definition all coordinates refer to the new datum. The shift is given in the program or taken from a datum table, for example for operations that recur at several positions, or for a shift that is needed often.
step-shift-datum = The control shifts the datum:
say-shift-by-table-row = with a row number: by the values of that row of the active datum table
say-shift-by-coordinates = with coordinates: in each programmed axis to the given coordinate; absolute values refer to the workpiece datum, incremental values to the datum that was valid last
note-reset-datum-shift = To reset the datum shift, program a shift to the coordinates X=0, Y=0 etc. with a new cycle definition, or call a shift to the coordinates X=0, Y=0 etc. from the datum table.
note-rotary-axes-may-be-shifted = Rotary axes may be entered, too.
note-datum-shift-in-status-display = The additional status display shows the datum shift in each axis.
note-datum-table-refers-to-preset = Danger of collision! Datums of a datum table always and exclusively refer to the current preset.
note-select-datum-table-in-program = If datums are taken from a datum table, activate the required table in the program with the function SEL TABLE, in a block before this cycle. It stays active until another datum table is selected with SEL TABLE or with PGM MGT. To program SEL TABLE, press the key PGM CALL and the soft key for datum tables, enter the full path of the table or select the file with a soft key, and confirm with the key END.
note-select-datum-table-before-run = Without SEL TABLE the required datum table must be activated with the file manager before the test run or the program run (this also applies to the programming graphics): in the mode Test Run it then has the status S, in a program run mode the status M.
note-datum-table-is-absolute = Coordinate values of datum tables act only as absolute values.
note-datum-table-rows-at-end = New rows can only be added at the end of the datum table.
note-datum-table-name-begins-with-letter = The file name of a new datum table must begin with a letter.
note-save-datum-table-changes = After changing a value in a datum table, save the change with the key ENT. Otherwise it has no effect when the program is run.
note-edit-datum-table = A datum table is edited in the mode Programming and Editing: call the file manager with the key PGM MGT, show the files of the type .D with the soft keys, and select a table or enter a new file name. Soft keys go to the beginning, the end, the next or previous page, or the beginning or end of a row, insert a row or several rows at the end, delete a row, find, and copy and insert a value. To leave the table, show another file type in the file manager and select the wanted file.
note-datum-table-columns = If no datum is to be defined for an active axis, clear its entry with the key DEL. The properties of the columns can be edited after the code number 555343 is entered in the MOD menu; the soft key EDIT FORMAT then shows the columns with their properties. Changes apply only to the table that is open.
note-datum-row-in-status-display = The additional status display shows name and path of the active datum table, the number of the active datum, and its comment from the column DOC.

# --- 10 ---
cycle-rotation = Rotation
    .nc = ROTATION
    .purpose = Rotates the coordinate system in the working plane about the active datum, within a program.
step-rotate-coordinate-system = The control rotates the coordinate system about the active datum by the programmed angle. An incremental angle is added to the active one.
step-cancel-radius-compensation = The control cancels an active radius compensation.
step-move-both-axes = Move both axes of the working plane to activate the rotation.
note-reset-rotation = To reset the rotation, program the cycle again with the angle 0°.
note-reference-axis-of-rotation = Reference axis of the angle: X axis in the X/Y plane, Y axis in the Y/Z plane, Z axis in the Z/X plane.
note-acts-in-manual-data-input = The cycle also acts in the mode Positioning with Manual Data Input.
note-rotation-in-status-display = The additional status display shows the active angle of rotation.
note-program-radius-compensation-again = The definition of the cycle cancels an active radius compensation. Program it again if necessary.

# --- 247 ---
cycle-activate-preset = Datum setting
    .nc = DATUM SETTING
    .purpose = Activates a preset of the preset table as the new datum.
step-activate-preset = The control activates the preset { $q-preset-number } of the preset table as datum.
step-cancel-transforms-of-preset = It resets datum shift, mirroring, rotation, scaling factor and axis-specific scaling factor.
note-coordinates-refer-to-new-preset = After the definition all coordinates and datum shifts (absolute and incremental) refer to the new preset.
note-preset-cancels-transforms = When a datum of the preset table is activated, the control resets datum shift, mirroring, rotation, scaling factor and axis-specific scaling factor.
note-preset-zero = Preset number 0 (row 0) activates the datum that was last set manually in the mode Manual Operation.
note-preset-not-in-test-run = The cycle does not act in the mode Test Run.
note-preset-in-status-display = The status display shows the number of the active preset after the datum symbol; the additional status display (position display) shows it after the datum.
