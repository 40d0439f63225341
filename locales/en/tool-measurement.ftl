# Cycles that measure the tool on a tool touch probe.

# --- parameters ---
parameter-tool-check = Measure tool=0 / check tool=1
    .label = CHECK
    .word = CHECK:
    .prompt = Measure tool=0 / check tool=1
    .help = Defines whether the tool is measured for the first time, or a tool that has been measured before is checked. The first measurement overwrites the tool length { $mp-tool-length } in the central tool file TOOL.T and sets the delta value { $mp-delta-length } to 0. A check compares the measured length with the tool length { $mp-tool-length }; the deviation, with its sign, is entered as the delta value { $mp-delta-length } and is also available in Q115. If the delta value is greater than the wear or breakage tolerance permitted for the tool length, the control locks the tool (status L in TOOL.T).
choice-tool-first-measurement = measure the tool for the first time
choice-tool-check = check a tool that has been measured before
parameter-tool-status-parameter = Parameter number for result?
    .prompt = Parameter number for result?
    .help = Number of the parameter in which the control stores the measuring status: 0.0: tool within tolerance; 1.0: tool worn ({ $mp-wear-tolerance-length } exceeded); 2.0: tool broken ({ $mp-break-tolerance-length } exceeded). If the result is not used further in the program, answer the question with NO ENT.
parameter-tool-clearance-height = Clearance height
    .label = CLEARANCE HEIGHT
    .word = HEIGHT:
    .prompt = Clearance height
    .help = Position in the spindle axis at which the tool cannot collide with workpieces or their clamping. It refers to the active workpiece datum. If the value is so small that the tool tip would be below the upper edge of the plate, the control automatically positions the tool above the plate (safety zone of { $mp-setter-safety-distance }).
parameter-tooth-measurement = Probing the teeth 0=no / 1=yes
    .label = PROBING THE TEETH
    .word = PROBING THE TEETH:
    .prompt = Probing the teeth 0=no / 1=yes
    .help = Defines whether the teeth are measured one by one. At most 20 teeth can be measured.
parameter-tooth-measurement__itnc530 =
    .help = Defines whether the teeth are measured one by one. At most 99 teeth can be measured.
parameter-tooth-measurement__tnc426-430 =
    .help = Defines whether the teeth are measured one by one.
choice-no-tooth-measurement = do not measure the teeth one by one
choice-tooth-measurement = measure the teeth one by one

# --- 31 and 481 ---
cycle-tool-length = Measure tool length
    .nc = TOOL LENGTH
    .purpose = Measures the length of the tool with the tool touch probe, or checks it. The control stores the result in the central tool file TOOL.T and takes it into account automatically at the end of the cycle.
cycle-tool-length__tnc426-430 =
    .purpose = Measures the length of the tool with the tool touch probe, or checks it. The control stores the result in the central tool file TOOL.T and uses it in the next tool call.
cycle-tool-length-old = Measure tool length (old form)
    .nc = TOOL LENGTH
    .purpose = Measures the length of the tool with the tool touch probe, or checks it. The control stores the result in the central tool file TOOL.T and takes it into account automatically at the end of the cycle. Old block form of cycle 481.
cycle-tool-length-old__tnc426-430 =
    .purpose = Measures the length of the tool with the tool touch probe, or checks it. The control stores the result in the central tool file TOOL.T and uses it in the next tool call. Old block form of cycle 481.
step-position-tool-over-setter = The control positions the tool at the clearance height { $q-tool-clearance-height }, but not below the safety zone above the plate.
step-touch-tool-setter = The control measures the length:
say-measure-tooth-by-tooth = tooth by tooth with { $q-tooth-measurement }=1: the tool is positioned beside the probe contact, with its face below the upper edge of the contact as defined by { $mp-setter-axis-offset }, and, if entered in the tool table, by the additional length offset { $mp-setter-offset-length }. The control probes the rotating tool radially to find the starting angle, then measures the length of all teeth by changing the spindle orientation
say-measure-rotating-or-stationary = otherwise, if the diameter of the tool is larger than the measuring surface, with the tool rotating: the tool is offset from the centre of the touch probe by { $mp-setter-offset-radius } of the tool table and moves, rotating, onto the measuring surface, so that the longest tooth is found. If the diameter is smaller, and for drills and ball-nose cutters, with the tool stationary: it moves to the centre above the measuring surface and then, with the spindle stopped, onto the surface; for this { $mp-setter-offset-radius } in the tool table is 0
step-store-tool-length = The control stores the result:
say-overwrite-tool-length = with { $q-tool-check }=0 it overwrites the tool length { $mp-tool-length } in TOOL.T and sets the delta value { $mp-delta-length } to 0
say-enter-delta-length = with { $q-tool-check }=1 it compares the measured length with the tool length { $mp-tool-length }, enters the deviation with its sign as the delta value { $mp-delta-length } and in Q115, and locks the tool (status L) if the wear or breakage tolerance is exceeded
result-tool-length-deviation = Deviation of the tool length
result-tool-status = Measuring status: 0.0 = within tolerance, 1.0 = worn, 2.0 = broken
guard-tool-call-missing = No tool is called. Call the tool to be measured with TOOL CALL.
note-enter-tool-data-first = Before a tool is measured for the first time, enter its approximate radius and length, the number of teeth and the cutting direction in the tool table TOOL.T.
note-most-teeth-measurable = Teeth can be measured one by one on tools with up to 20 teeth.
note-most-teeth-measurable__itnc530 = Teeth can be measured one by one on tools with up to 99 teeth. The status display shows the values of up to 24 teeth.
note-tool-table-must-be-active = The measuring cycles only work if the central tool file TOOL.T is active.
note-tool-call-before-tool-measurement = Before the measuring cycles are used, enter all data required for the measurement in the central tool file and call the tool to be measured with TOOL CALL.
note-three-ways-to-measure-length = The length can be measured in three ways: with the tool rotating if its diameter is larger than the measuring surface of the touch probe; with the tool stationary if its diameter is smaller, or for drills and ball-nose cutters; tooth by tooth with the tool stationary if its diameter is larger than the measuring surface.
note-tool-measurement-feed-and-speed = With the tool stationary the control uses the probing feed rate of { $mp-stationary-probing-feed }. With the tool rotating it calculates the spindle speed n = { $mp-max-peripheral-speed } / (r · 0.0063) in rpm from the maximum permissible peripheral speed in m/min and the active tool radius r in mm, and the probing feed rate v = measuring tolerance · n in mm/min.
note-tool-measurement-tolerance = { $mp-probing-feed-calculation } determines the measuring tolerance. ConstantTolerance: it stays constant, so that the feed rate of very large tools drops to zero, the sooner the smaller { $mp-max-peripheral-speed } and { $mp-measuring-tolerance } are. VariableTolerance: it is { $mp-measuring-tolerance } for tool radii up to 30 mm, twice that up to 60 mm, three times up to 90 mm, four times up to 120 mm. ConstantFeed: the feed rate stays constant and the measuring error grows with the radius: (r · { $mp-measuring-tolerance }) / 5 mm.
note-tool-measurement-tolerance__itnc530 = { $mp-probing-feed-calculation } determines the measuring tolerance. 0: it stays constant, so that the feed rate of very large tools drops to zero, the sooner the smaller { $mp-max-peripheral-speed } and { $mp-measuring-tolerance } are. 1: it is { $mp-measuring-tolerance } for tool radii up to 30 mm, twice that up to 60 mm, three times up to 90 mm, four times up to 120 mm. 2: the feed rate stays constant and the measuring error grows with the radius: (r · { $mp-measuring-tolerance }) / 5 mm.
note-tool-measurement-tolerance__tnc426-430 = { $mp-probing-feed-calculation } determines the measuring tolerance. 0: it stays constant, so that the feed rate of very large tools drops to zero, the sooner the smaller { $mp-max-peripheral-speed } and { $mp-measuring-tolerance } are. 1: it is { $mp-measuring-tolerance } for tool radii up to 30 mm, twice that up to 60 mm, three times up to 90 mm, four times up to 120 mm. 2: the feed rate stays constant and the measuring error grows with the radius: (r · { $mp-measuring-tolerance }) / 5 mm.
note-check-tool-measurement-parameters = Before the touch-probe cycles are used, check all machine parameters under { $mp-probe-settings } > { $mp-tool-measurement-config } and { $mp-round-stylus-config }.
note-tool-table-entries = Entries of the tool table: { $mp-teeth } is the number of teeth, at most 20. { $mp-wear-tolerance-length } and { $mp-wear-tolerance-radius } are the permitted deviation of length and radius for the detection of wear, { $mp-break-tolerance-length } and { $mp-break-tolerance-radius } for the detection of breakage, each from 0 to 0.9999 mm; if one is exceeded, the control locks the tool (status L). { $mp-cutting-direction } is the cutting direction for measuring with the tool rotating. { $mp-setter-offset-radius } is the offset between the centre of the stylus and the centre of the tool when the length is measured; the default is no value (offset = tool radius). { $mp-setter-offset-length } is the offset between the upper edge of the stylus and the lower edge of the tool when the radius is measured, in addition to { $mp-setter-axis-offset }; the default is 0.
note-tool-table-entries__itnc530 = Entries of the tool table: { $mp-teeth } is the number of teeth. { $mp-wear-tolerance-length } and { $mp-wear-tolerance-radius } are the permitted deviation of length and radius for the detection of wear, { $mp-break-tolerance-length } and { $mp-break-tolerance-radius } for the detection of breakage, each from 0 to 0.9999 mm; if one is exceeded, the control locks the tool (status L). { $mp-cutting-direction } is the cutting direction for measuring with the tool rotating. { $mp-setter-offset-radius } is the offset between the centre of the stylus and the centre of the tool when the length is measured; the default is the tool radius R (entered with the key NO ENT). { $mp-setter-offset-length } is the offset between the upper edge of the stylus and the lower edge of the tool when the radius is measured, in addition to { $mp-setter-axis-offset }; the default is 0.
note-usual-tool-table-entries = Usual entries in the tool table. Drill: no { $mp-teeth }, { $mp-setter-offset-radius } = 0 (the tip is measured), no { $mp-setter-offset-length }. End mill with a diameter below 19 mm: { $mp-teeth } = 4, { $mp-setter-offset-radius } = 0 (the tool is narrower than the plate), { $mp-setter-offset-length } = 0. End mill with a diameter above 19 mm: { $mp-teeth } = 4, { $mp-setter-offset-radius } = R (an offset is needed, because the tool is wider than the plate), { $mp-setter-offset-length } = 0. Neither end mill needs an additional offset when the radius is measured, because the offset of { $mp-setter-axis-offset } is used. Ball-nose cutter: { $mp-teeth } = 4, { $mp-setter-offset-radius } = 0 (the south pole of the ball is measured), { $mp-setter-offset-length } = 5 (always the tool radius, so that the diameter is not measured in the radius of the ball).
note-old-and-new-form = The cycles 31 to 33 and 481 to 483 work identically. The only differences: 481 to 483 are also available in DIN/ISO as G481 to G483, and instead of a parameter of your choice they use the fixed parameter Q199 for the measuring status.
note-status-parameter-optional = Without a result parameter the measuring status is not stored.
note-tool-measurement-in-tilted-plane = Tools can also be measured with a tilted working plane.
note-tool-status-display = The additional status display can show the results (in the machine modes): the program on the left, the results on the right. Values beyond the wear tolerance are marked with *, values beyond the breakage tolerance with B.
note-tool-status-display__tnc426-430 = The soft key for the status of the tool measurement brings the results into the additional status display (in the machine modes): the program on the left, the results on the right. Values beyond the wear tolerance are marked with *, values beyond the breakage tolerance with B.
note-from-software-280476 = Available from NC software 280 476-xx.
note-not-in-iso = The old form is not available in DIN/ISO.
note-prepare-for-tool-probe = The machine builder must prepare the machine and the control for the tool touch probe. Some cycles and functions may not be available. Refer to the machine manual.
title-first-measurement-rotating-old = First measurement with the tool rotating; old form
title-first-measurement-rotating-status = First measurement with the tool rotating, status stored in Q1
title-check-teeth-status-old = Check with measurement of the individual teeth, status stored in Q5; old form
title-check-teeth-without-status = Check with measurement of the individual teeth, status not stored
