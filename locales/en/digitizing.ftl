# Cycles that digitize a part with a touch probe.

# --- 5 and 15 ---
cycle-digitize-range = Range for digitizing
    .nc = RANGE
    .purpose = Defines the block-shaped range in which the digitizing cycles scan a part, the file for the digitized data and the clearance height.
cycle-digitize-range-from-points = Range for digitizing from a point table
    .nc = RANGE
    .purpose = Defines a range of any shape for digitizing with an analog touch probe: a point table gives its boundary in the working plane. The cycle also defines the file for the digitized data and the clearance height.
step-remember-digitizing-range = The control stores the range between the MIN point and the MAX point, the clearance height and the name of the file for the digitizing cycles that follow.
step-remember-digitizing-range-from-points = The control stores the range, the clearance height and the name of the file for the digitizing cycles that follow. The points of the table bound the range in the working plane, the MIN and MAX points bound it in the touch probe axis.
table-digitizing-points = Point table for digitizing
title-range-with-rotary-axis-a = Range with rotary axis A, for cycle 18
title-range-for-meander-with-rotary-axis = Range with rotary axis A, for cycle 6
title-range-with-rotary-axis-c = Range with rotary axis C, for cycle 7

# --- 6 and 16 ---
cycle-digitize-meander = Meander
    .nc = MEANDER
    .purpose = Digitizes a 3-D part in meanders with a touch-trigger probe.
cycle-digitize-meander-analog = Meander (analog touch probe)
    .nc = MEANDER
    .purpose = Digitizes a 3-D part in meanders with an analog touch probe.
step-approach-digitizing-start = The control moves automatically to the starting point, first in the tool axis to the clearance height, then in the working plane to the MIN point of the range of cycle 5 or cycle 15.
step-approach-workpiece-downwards = The touch probe moves towards the part in the negative direction of the tool axis. The control stores the coordinates of the position at which the touch probe contacts the part.
step-scan-meander = From the MIN point the touch probe moves along the part in the positive direction of the line axis to the boundary of the range, moves by the line spacing and returns along the next line; at the other end it moves by the line spacing again. This is repeated until the whole range has been digitized.
step-return-to-clearance-after-digitizing = At the end the touch probe returns to the clearance height.
title-meander-with-rotary-axis = Meander with a rotary axis as the line direction

# --- 7 and 17 ---
cycle-digitize-contour-lines = Contour lines
    .nc = CONTOUR LINES
    .purpose = Digitizes a 3-D part level by level, in contour lines, with a touch-trigger probe.
cycle-digitize-contour-lines-analog = Contour lines (analog touch probe)
    .nc = CONTOUR LINES
    .purpose = Digitizes a 3-D part level by level, in contour lines, with an analog touch probe.
step-approach-contour-line-start = The control moves automatically to the starting point, first in the tool axis to the clearance height, then in the working plane to the coordinates that the cycle defines. The coordinate of the starting point in the tool axis is that of the MIN point of cycle 5 if the line spacing is positive, that of the MAX point if it is negative.
step-approach-workpiece-in-direction = The touch probe moves towards the part in the programmed direction of approach. The control stores the coordinates of the position at which the touch probe contacts the part.
step-scan-contour-line = After the first point has been stored, the touch probe travels at constant height around the part until it reaches the first point again.
step-go-on-by-line-spacing = Then it moves by the line spacing in the positive or negative direction of the tool axis and again travels at constant height around the part, up to the first point stored at this height. This is repeated until the whole range has been digitized.
step-return-to-contour-line-start = At the end the touch probe moves to the clearance height and returns to the programmed starting point.

# --- 8 and 18 ---
cycle-digitize-lines = Line
    .nc = LINE
    .purpose = Digitizes a 3-D part line by line with a touch-trigger probe.
cycle-digitize-lines-analog = Line (analog touch probe)
    .nc = LINE
    .purpose = Digitizes a 3-D part line by line with an analog touch probe.
step-approach-line-start = The control moves automatically to the starting point, first in the tool axis to the clearance height, then in the working plane. The starting point is at the positive or negative boundary of the range in the programmed direction of the lines (this depends on the digitizing direction) and otherwise has the coordinates of the MIN point of the range of cycle 5 or cycle 15.
step-scan-line = The touch probe moves along the part in the positive direction of the selected axis of the working plane to the boundary of the range.
step-return-for-next-line = Then it moves to the clearance height and returns at rapid traverse to the beginning of the next line. There it moves at rapid traverse in the negative direction of the tool axis to the height for feed rate reduction, and from there at the probing feed rate until it contacts the part. This is repeated until the whole range has been digitized.
title-lines-with-rotary-axis = Line with rotary axis, without feed rate for the first line

# --- guards ---
guard-digitizing-with-transformation = A coordinate transformation is active. None may be active while digitizing.

# --- notes: programming ---
note-range-before-digitizing = In the part program, define a digitizing cycle RANGE (5 or 15) before the cycle that digitizes.
note-range-before-contour-lines = In the part program, define the digitizing cycle 5 RANGE before the digitizing cycle CONTOUR LINES.
note-not-with-contour-lines = Cycle { $cycle } cannot be combined with the digitizing cycle 17 CONTOUR LINES.
note-not-with-range-from-points = Cycle { $cycle } cannot be combined with the digitizing cycle 15 RANGE.
note-no-transformation-while-digitizing = No coordinate transformation and no basic rotation may be active while digitizing.
note-analog-probe-only = For analog touch probes only.
note-complete-path-of-data = Enter in the menu for the data interface the complete path under which the control stores the digitized data.
note-digitizing-not-in-iso = Digitizing cycles are not available in DIN/ISO.

# --- notes: what is needed ---
note-digitizing-needs-option = Digitizing needs a touch probe, the software module Digitizing Option and, if necessary, the evaluation software SUSA of HEIDENHAIN for processing digitized data of the cycle MEANDER.
note-calibrate-before-digitizing = Calibrate the touch probe before digitizing.
note-digitizing-axes = Digitizing cycles are programmed with the main axes X, Y and Z and with the rotary axes A, B and C.
note-digitizing-speed-touch-trigger = With a touch-trigger probe the digitizing speed is between 200 and 800 mm/min, with a point spacing of 1 mm.
note-digitizing-speed-analog = With an analog touch probe the cycle defines the digitizing speed, up to 3000 mm/min.

# --- notes: how it is digitized ---
note-meander-for-flat-parts = Digitizing in meanders is suited above all for relatively flat parts.
note-meander-for-evaluation-software = Digitize in meanders if the digitized data are to be processed with the evaluation software SUSA of HEIDENHAIN.
note-contour-lines-for-steep-parts = Digitizing in contour lines is suited particularly for irregular parts (such as injection moulds), or if a single contour line is to be recorded (such as the outline of a cam plate).
note-range-for-contour-lines = In the touch probe axis the range must be lower than the highest point of the part by at least the radius of the touch probe. In the working plane the range must be larger than the part by at least the radius of the touch probe.
note-single-contour-line = To digitize a single contour line, enter 0 for the line spacing and, if the cycle asks for it, for the minimum line spacing.
note-lines-for-one-milling-direction = This cycle is used above all for relatively flat parts whose digitized data are to be milled in climb or up-cut milling throughout, without evaluation software.
note-lines-for-rotary-axes = With an analog touch probe this cycle is used above all for digitizing with a rotary axis.
note-normal-retraction-recommended = Recommended travel in the direction of the line normals: between half the point spacing and the point spacing. The smaller the ball tip of the touch probe, the greater the travel should be.
note-climb-or-up-cut-by-direction = The digitizing direction also determines whether later milling is climb or up-cut milling.
note-sudden-changes-of-direction = The control stores the positions at which the direction changes suddenly, up to 1000 of them in a line. In the next line it automatically reduces the probing feed rate when the touch probe comes close to such a position. This improves the results.
note-feed-reduction-only-up-to-1000 = The reduction of the feed rate only works if a line has no more than 1000 points at which the feed rate must be reduced.
note-corner-reduction-entered-by-control = Answer the question for the feed rate reduction at corners with NO ENT. The control enters a value automatically.

# --- notes: rotary axes ---
note-rotary-axes-touch-trigger = With a touch-trigger probe, rotary axes can be digitized in meanders (cycle 6), in lines (cycle 8) or in contour lines (cycle 7). In each case enter the rotary axis in the cycle RANGE. The control interprets the values of rotary axes as degrees.
note-rotary-axes-analog = With an analog touch probe, rotary axes can only be digitized with cycle 18 LINE. The rotary axis is defined as the column axis.
note-digitizing-range-with-rotary-axis = For digitizing with a rotary axis, enter the rotary axis in the range. The control interprets its values as degrees. The file of digitized data contains the axes that the range defines; no BLK FORM is output, because rotary axes cannot be displayed graphically.
note-digitizing-display-of-rotary-axis = While digitizing and while milling, the display mode of the rotary axis must be the same (reduced to a value below 360°, or not reduced).
note-meander-with-rotary-axis = If a linear axis (such as X) is the direction of lines, at the end of a line the control moves the rotary axis (such as A) of the cycle RANGE by the line spacing; the touch probe then oscillates in the Z/X plane, for example. If a rotary axis (such as A) is the direction of lines, at the end of a line the control moves the linear axis (such as X) by the line spacing; the touch probe then oscillates in the Z/A plane, for example.
note-contour-lines-with-rotary-axis = The starting point is defined in a linear axis (such as X) and a rotary axis (such as C), and so is the order of approach. The touch probe then oscillates in the X/C plane, for example. This also suits machines with only two linear axes (such as Z and X) and one rotary axis (such as C). The sense of rotation defined in the order of approach applies to all contour lines.
note-lines-with-rotary-axis = If a linear axis (such as X) is the direction of lines, at the end of a line the control moves the rotary axis (such as A) of the cycle RANGE by the line spacing.

# --- notes: the data ---
note-digitized-data-on-disk = The control stores the positions recorded directly on the hard disk. The interface function PRINT determines the directory.
note-digitized-data-with-same-radius = If the digitized data are milled with a tool whose radius is that of the stylus, they can be executed directly with cycle 30.
note-block-form-in-data = The control inserts a BLK FORM into the file of digitized data. For this it enlarges the block defined by the cycle RANGE by twice the value of { $mp-stylus-deflection-depth } (for analog touch probes).
note-digitized-data-in-programs = Digitized data can be executed with the machining cycle 30 if several passes are needed (only data of the cycles MEANDER and LINE), or with an auxiliary program for finishing only: define a tool with the radius of the stylus, call it, set feed rate, M functions and radius compensation R0, and call the file with CALL PGM.
note-digitized-data-size = The file of digitized data may be at most 1500 MByte in size, which is the space on the hard disk of the control if no program is stored.

# --- notes: point tables ---
note-point-table-recording = The points are recorded in the mode Positioning with Manual Data Input with the analog touch probe, which needs the software option for digitizing with an analog touch probe. The soft key PNT selects a point table. Points are recorded manually (TEACH-IN: deflect the stylus by hand and capture the actual position) or automatically (at a point spacing entered, while the stylus is moved around the part by hand). A feed rate can be entered with which the touch probe reacts to a deflection, and the coordinates to be stored can be chosen for each axis. Only the coordinates of the working plane define the range.
note-point-table-size = A point table that serves as a range may contain at most 893 points. To have this monitored, set the soft key RANGE/CONTOUR DATA to RANGE.
note-point-table-closed = The points are joined by straight lines, which bound the range. The control automatically joins the last point of the table to the first one.
