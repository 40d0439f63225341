# Parameters of the misalignment and datum cycles: name, label in the NC block, help.

# --- datum cycles: what differs from the hole ---
parameter-probing-centre-main__datum-inside-rectangle =
    .help = Centre of the pocket in the main axis of the working plane.
parameter-probing-centre-minor__datum-inside-rectangle =
    .help = Centre of the pocket in the secondary axis of the working plane.
parameter-probing-centre-main__datum-outside-rectangle =
    .help = Centre of the stud in the main axis of the working plane.
parameter-probing-centre-minor__datum-outside-rectangle =
    .help = Centre of the stud in the secondary axis of the working plane.
parameter-probing-centre-main__datum-outside-circle =
    .help = Centre of the stud in the main axis of the working plane.
parameter-probing-centre-minor__datum-outside-circle =
    .help = Centre of the stud in the secondary axis of the working plane.
parameter-probing-nominal-diameter__datum-outside-circle =
    .help = Approximate diameter of the stud. Enter a value that is too large rather than too small.
parameter-number-of-touch-points__datum-outside-circle =
    .help = Defines whether the stud is measured by probing four or three points.
parameter-first-side-length__datum-outside-rectangle =
    .help = Length of the stud parallel to the main axis of the working plane.
parameter-second-side-length__datum-outside-rectangle =
    .help = Length of the stud parallel to the secondary axis of the working plane.
parameter-datum-row-number__datum-outside-rectangle =
    .help = Number in the datum table or preset table under which the coordinates of the stud centre are stored. With 0 the control sets the display so that the new datum is at the stud centre.
parameter-datum-row-number__datum-outside-rectangle__tnc426-430 =
    .help = Number in the datum table under which the coordinates of the stud centre are stored. With 0 the control sets the display so that the new datum is at the stud centre.
parameter-datum-row-number__datum-outside-circle =
    .help = Number in the datum table or preset table under which the coordinates of the stud centre are stored. With 0 the control sets the display so that the new datum is at the stud centre.
parameter-datum-row-number__datum-outside-circle__tnc426-430 =
    .help = Number in the datum table under which the coordinates of the stud centre are stored. With 0 the control sets the display so that the new datum is at the stud centre.
parameter-new-datum-main__datum-outside-rectangle =
    .help = Coordinate in the main axis to which the measured stud centre is set. Basic setting: 0.
parameter-new-datum-minor__datum-outside-rectangle =
    .help = Coordinate in the secondary axis to which the measured stud centre is set. Basic setting: 0.
parameter-new-datum-main__datum-outside-circle =
    .help = Coordinate in the main axis to which the measured stud centre is set. Basic setting: 0.
parameter-new-datum-minor__datum-outside-circle =
    .help = Coordinate in the secondary axis to which the measured stud centre is set. Basic setting: 0.
choice-travel-paraxially-at-measuring-height = move parallel to the axes at measuring height between the measuring points
choice-travel-linearly-at-clearance-height = move on a straight line at clearance height between the measuring points

# --- 408 and 409 ---
parameter-probing-centre-main__datum-slot-centre =
    .help = Centre of the slot in the main axis of the working plane.
parameter-probing-centre-minor__datum-slot-centre =
    .help = Centre of the slot in the secondary axis of the working plane.
parameter-probing-centre-main__datum-ridge-centre =
    .help = Centre of the ridge in the main axis of the working plane.
parameter-probing-centre-minor__datum-ridge-centre =
    .help = Centre of the ridge in the secondary axis of the working plane.
parameter-slot-width = Slot width
    .label = SLOT WIDTH
    .help = Width of the slot, whatever its position in the working plane.
parameter-ridge-width = Ridge width
    .label = RIDGE WIDTH
    .help = Width of the ridge, whatever its position in the working plane.
parameter-datum-row-number__datum-slot-centre = Number in table
    .help = Number in the datum table or preset table under which the coordinates of the slot centre are stored. With 0 the control sets the display so that the new datum is at the slot centre.
parameter-datum-row-number__datum-ridge-centre = Number in table
    .help = Number in the datum table or preset table under which the coordinates of the ridge centre are stored. With 0 the control sets the display so that the new datum is at the ridge centre.
parameter-new-datum-measuring-axis = New datum
    .label = DATUM
    .help = Coordinate in the measuring axis to which the measured centre is set. Basic setting: 0.

# --- 414 and 415 ---
parameter-third-point-main = 3rd measuring point 1st axis
    .label = 3RD POINT 1ST AXIS
    .help = Coordinate of the third touch point in the main axis of the working plane.
parameter-third-point-minor = 3rd measuring point 2nd axis
    .label = 3RD POINT 2ND AXIS
    .help = Coordinate of the third touch point in the secondary axis of the working plane.
parameter-point-distance-main = Spacing in 1st axis
    .label = SPACING IN 1ST AXIS
    .help = Distance between the first and the second measuring point in the main axis of the working plane.
parameter-point-distance-minor = Spacing in 2nd axis
    .label = SPACING IN 2ND AXIS
    .help = Distance between the third and the fourth measuring point in the secondary axis of the working plane.
parameter-corner-number = Corner
    .label = CORNER
    .help = Number of the corner at which the datum is set.
parameter-corner-basic-rotation = Carry out basic rotation
    .label = BASIC ROTATION
    .help = Defines whether the control compensates the misalignment of the workpiece by a basic rotation.
choice-no-basic-rotation = carry out no basic rotation
choice-carry-out-basic-rotation = carry out a basic rotation
parameter-datum-row-number__datum-outside-corner =
    .help = Number in the datum table or preset table under which the coordinates of the corner are stored. With 0 the control sets the display so that the new datum is at the corner.
parameter-datum-row-number__datum-outside-corner__tnc426-430 =
    .help = Number in the datum table under which the coordinates of the corner are stored. With 0 the control sets the display so that the new datum is at the corner.
parameter-datum-row-number__datum-inside-corner =
    .help = Number in the datum table or preset table under which the coordinates of the corner are stored. With 0 the control sets the display so that the new datum is at the corner.
parameter-datum-row-number__datum-inside-corner__tnc426-430 =
    .help = Number in the datum table under which the coordinates of the corner are stored. With 0 the control sets the display so that the new datum is at the corner.
parameter-new-datum-main__datum-outside-corner =
    .help = Coordinate in the main axis to which the measured corner is set. Basic setting: 0.
parameter-new-datum-minor__datum-outside-corner =
    .help = Coordinate in the secondary axis to which the measured corner is set. Basic setting: 0.
parameter-new-datum-main__datum-inside-corner =
    .help = Coordinate in the main axis to which the measured corner is set. Basic setting: 0.
parameter-new-datum-minor__datum-inside-corner =
    .help = Coordinate in the secondary axis to which the measured corner is set. Basic setting: 0.

# --- two points on a line ---
parameter-first-point-main = 1st measuring point 1st axis
    .label = 1ST POINT 1ST AXIS
    .help = Coordinate of the first touch point in the main axis of the working plane.
parameter-first-point-minor = 1st measuring point 2nd axis
    .label = 1ST POINT 2ND AXIS
    .help = Coordinate of the first touch point in the secondary axis of the working plane.
parameter-second-point-main = 2nd measuring point 1st axis
    .label = 2ND POINT 1ST AXIS
    .help = Coordinate of the second touch point in the main axis of the working plane.
parameter-second-point-minor = 2nd measuring point 2nd axis
    .label = 2ND POINT 2ND AXIS
    .help = Coordinate of the second touch point in the secondary axis of the working plane.
parameter-measuring-axis = Measuring axis
    .label = MEASURING AXIS
    .help = Axis of the working plane in which the measurement is made.
parameter-measuring-axis__rotation-by-rotary-axis = Measuring axis (1...3: 1=main axis)
    .help = Axis in which the measurement is made.
choice-measuring-axis-main = the main axis is the measuring axis
choice-measuring-axis-minor = the secondary axis is the measuring axis
choice-measuring-axis-probe = the touch probe axis is the measuring axis
parameter-traverse-direction = Traverse direction 1
    .label = TRAVERSE DIRECTION
    .help = Direction in which the touch probe approaches the workpiece.
choice-traverse-direction-negative = negative direction of traverse
choice-traverse-direction-positive = positive direction of traverse
choice-travel-directly-at-measuring-height = move at measuring height between the measuring points
choice-travel-directly-at-clearance-height = move at clearance height between the measuring points

# --- two holes or studs ---
parameter-first-centre-main = 1st hole: centre in 1st axis
    .label = 1ST CENTER 1ST AXIS
    .help = Centre of the first hole in the main axis of the working plane.
parameter-first-centre-minor = 1st hole: centre in 2nd axis
    .label = 1ST CENTER 2ND AXIS
    .help = Centre of the first hole in the secondary axis of the working plane.
parameter-second-centre-main = 2nd hole: centre in 1st axis
    .label = 2ND CENTER 1ST AXIS
    .help = Centre of the second hole in the main axis of the working plane.
parameter-second-centre-minor = 2nd hole: centre in 2nd axis
    .label = 2ND CENTER 2ND AXIS
    .help = Centre of the second hole in the secondary axis of the working plane.
parameter-first-centre-main__rotation-two-studs = 1st stud: centre in 1st axis
    .help = Centre of the first stud in the main axis of the working plane.
parameter-first-centre-minor__rotation-two-studs = 1st stud: centre in 2nd axis
    .help = Centre of the first stud in the secondary axis of the working plane.
parameter-second-centre-main__rotation-two-studs = 2nd stud: centre in 1st axis
    .help = Centre of the second stud in the main axis of the working plane.
parameter-second-centre-minor__rotation-two-studs = 2nd stud: centre in 2nd axis
    .help = Centre of the second stud in the secondary axis of the working plane.
parameter-first-stud-diameter = Diameter of stud 1
    .label = DIAMETER OF STUD 1
    .help = Approximate diameter of the first stud. Enter a value that is too large rather than too small.
parameter-second-stud-diameter = Diameter of stud 2
    .label = DIAMETER OF STUD 2
    .help = Approximate diameter of the second stud. Enter a value that is too large rather than too small.
parameter-measuring-height__rotation-two-studs = Measuring height of stud 1 in the touch probe axis
    .label = MEASURING HEIGHT 1
    .help = Coordinate of the ball centre (touch point) in the touch probe axis at which stud 1 is measured.
parameter-second-measuring-height = Measuring height of stud 2 in the touch probe axis
    .label = MEASURING HEIGHT 2
    .help = Coordinate of the ball centre (touch point) in the touch probe axis at which stud 2 is measured.

# --- what is done with the angle ---
parameter-reference-line-angle = Preset rotation angle
    .label = PRESET ROTATION ANG.
    .help = Angle of a reference line, if the misalignment is to be measured with respect to any straight line instead of the main axis. The basic rotation is then the difference between the measured value and this angle.
parameter-basic-rotation-angle = Preset rotation angle
    .label = PRESET ROTATION ANG.
    .help = Angle to which the basic rotation is set.
parameter-basic-rotation-row = Preset number in table
    .label = NO. IN TABLE
    .help = Number in the preset table under which the determined basic rotation is stored. With 0 the control stores it in the ROT menu of the Manual operation mode.
parameter-basic-rotation-row__rotation-two-holes =
    .help = Number in the preset table under which the determined basic rotation is stored. With 0 the control stores it in the ROT menu of the Manual operation mode. If the misalignment is compensated by turning the rotary table ({ $q-misalignment-compensation }=1), the number has no effect and the misalignment is not stored as an angle.
parameter-basic-rotation-row__rotation-two-studs =
    .help = Number in the preset table under which the determined basic rotation is stored. With 0 the control stores it in the ROT menu of the Manual operation mode. If the misalignment is compensated by turning the rotary table ({ $q-misalignment-compensation }=1), the number has no effect and the misalignment is not stored as an angle.
parameter-misalignment-compensation = Compensation
    .label = COMPENSATION
    .help = Defines whether the control compensates the misalignment by a basic rotation or by turning the rotary table.
choice-compensate-by-basic-rotation = set a basic rotation
choice-compensate-by-rotary-table = turn the rotary table; the control then does not store the misalignment, even if a table row is given in { $q-basic-rotation-row }
parameter-zero-after-alignment = Set to zero after alignment
    .label = SET TO ZERO
    .help = Defines whether the control sets the display of the aligned rotary axis to 0.
choice-keep-rotary-display = do not set the display of the rotary axis to 0 after the alignment
choice-zero-rotary-display = set the display of the rotary axis to 0 after the alignment
parameter-zero-or-row-after-alignment = Set to zero after alignment
    .label = SET TO ZERO
    .help = Defines whether the control sets the display of the C-axis to 0 or writes the angular offset to column C of the datum table.
choice-zero-c-axis-display = set the display of the C-axis to 0
choice-offset-into-datum-row = write the measured angular offset with its sign to the datum table; the value is the number of the row. If the table already has an offset of C there, the control adds or subtracts the measured offset according to its sign
parameter-compensation-axis = Axis for compensating movement
    .label = COMPENSATION AXIS
    .help = Rotary axis with which the control compensates the measured misalignment.
choice-compensate-with-a-axis = compensate the misalignment with rotary axis A
choice-compensate-with-b-axis = compensate the misalignment with rotary axis B
choice-compensate-with-c-axis = compensate the misalignment with rotary axis C
parameter-rotary-axis-row = Number in table
    .label = NO. IN TABLE
    .help = Number in the preset table or datum table in which the control sets the rotary axis to zero.
parameter-measured-value-transfer__rotation-by-rotary-axis =
    .help = Defines whether the determined basic rotation is stored in the datum table or in the preset table.
choice-rotation-into-datum-table = write the determined basic rotation as a datum shift to the active datum table; the reference system is the active workpiece coordinate system
choice-rotation-into-preset-table = write the determined basic rotation to the preset table; the reference system is the machine coordinate system (REF system)
parameter-alignment-angle = Reference angle? (0=main axis)
    .prompt = Reference angle? (0=main axis)
    .label = REFERENCE ANGLE
    .help = Angle to which the control aligns the probed straight line.
condition-basic-rotation-chosen = the misalignment is compensated by a basic rotation ({ $q-misalignment-compensation }=0)
condition-rotary-table-chosen = the misalignment is compensated by turning the rotary table ({ $q-misalignment-compensation }=1)
condition-rotary-display-zeroed = { $q-zero-after-alignment }=1
condition-c-axis-compensates = the rotary axis C is chosen ({ $q-compensation-axis }=6)
parameter-probing-centre-minor__rotation-by-c-axis =
    .help = Centre of the hole in the secondary axis of the working plane. With 0 the control aligns the hole centre with the positive Y axis, with any other value with the nominal position (the angle that results from the hole centre).
parameter-probing-nominal-diameter__rotation-by-c-axis =
    .help = Approximate diameter of the circular pocket (hole). Enter a value that is too small rather than too large.
