# Cycles that measure the tool: radius, complete tool, calibration of the tool touch probe.

# --- parameters ---
help-tool-check-radius = Defines whether the tool is measured for the first time, or a tool that has been measured before is checked. The first measurement overwrites the tool radius { $mp-tool-radius } in the central tool file TOOL.T and sets the delta value { $mp-delta-radius } to 0. A check compares the measured radius with the tool radius { $mp-tool-radius }; the deviation, with its sign, is entered as the delta value { $mp-delta-radius } and is also available in Q116. If the delta value is greater than the wear or breakage tolerance permitted for the tool radius, the control locks the tool (status L in TOOL.T).
help-tool-check-complete = Defines whether the tool is measured for the first time, or a tool that has been measured before is checked. The first measurement overwrites the tool radius { $mp-tool-radius } and the tool length { $mp-tool-length } in the central tool file TOOL.T and sets the delta values { $mp-delta-radius } and { $mp-delta-length } to 0. A check compares the measured data with those of the tool file; the deviations, with their signs, are entered as the delta values { $mp-delta-radius } and { $mp-delta-length } and are also available in Q115 and Q116. If one of the delta values is greater than the permitted wear or breakage tolerance, the control locks the tool (status L in TOOL.T).
help-additional-tooth-measurement = Defines whether the teeth are measured one by one in addition. At most 20 teeth can be measured.
help-additional-tooth-measurement__itnc530 = Defines whether the teeth are measured one by one in addition. At most 99 teeth can be measured.
help-additional-tooth-measurement__tnc426-430 = Defines whether the teeth are measured one by one in addition.
help-calibration-tool-height = Position in the spindle axis at which the calibration tool cannot collide with workpieces or their clamping. It refers to the active workpiece datum. If the value is so small that the tip of the calibration tool would be below the upper edge of the plate, the control automatically positions it above the plate (safety zone of { $mp-setter-safety-distance }).
parameter-tool-check__tool-radius =
    .help = { help-tool-check-radius }
parameter-tool-check__tool-radius-old =
    .help = { help-tool-check-radius }
parameter-tool-check__tool-complete =
    .help = { help-tool-check-complete }
parameter-tool-check__tool-complete-old =
    .help = { help-tool-check-complete }
parameter-tooth-measurement__tool-radius =
    .help = { help-additional-tooth-measurement }
parameter-tooth-measurement__tool-radius-old =
    .help = { help-additional-tooth-measurement }
parameter-tooth-measurement__tool-complete =
    .help = { help-additional-tooth-measurement }
parameter-tooth-measurement__tool-complete-old =
    .help = { help-additional-tooth-measurement }
parameter-tool-status-parameter__tool-radius-old =
    .help = Number of the parameter in which the control stores the measuring status: 0.0: tool within tolerance; 1.0: tool worn ({ $mp-wear-tolerance-radius } exceeded); 2.0: tool broken ({ $mp-break-tolerance-radius } exceeded). If the result is not used further in the program, answer the question with NO ENT.
parameter-tool-status-parameter__tool-complete-old =
    .help = Number of the parameter in which the control stores the measuring status: 0.0: tool within tolerance; 1.0: tool worn ({ $mp-wear-tolerance-length } or { $mp-wear-tolerance-radius } exceeded, or both); 2.0: tool broken ({ $mp-break-tolerance-length } or { $mp-break-tolerance-radius } exceeded, or both). If the result is not used further in the program, answer the question with NO ENT.
parameter-tool-clearance-height__calibrate-tool-probe =
    .help = { help-calibration-tool-height }
parameter-tool-clearance-height__calibrate-tool-probe-old =
    .help = { help-calibration-tool-height }

# --- 32 and 482 ---
cycle-tool-radius = Measure tool radius
    .nc = TOOL RADIUS
    .purpose = Measures the radius of the tool with the tool touch probe, or checks it: with the tool rotating, or with the tool rotating and then tooth by tooth. The control stores the result in the central tool file TOOL.T and takes it into account automatically at the end of the cycle.
cycle-tool-radius__tnc426-430 =
    .purpose = Measures the radius of the tool with the tool touch probe, or checks it: with the tool rotating, or with the tool rotating and then tooth by tooth. The control stores the result in the central tool file TOOL.T and uses it in the next tool call.
cycle-tool-radius-old = Measure tool radius (old form)
    .nc = TOOL RADIUS
    .purpose = Measures the radius of the tool with the tool touch probe, or checks it: with the tool rotating, or with the tool rotating and then tooth by tooth. The control stores the result in the central tool file TOOL.T and takes it into account automatically at the end of the cycle. Old block form of cycle 482.
cycle-tool-radius-old__tnc426-430 =
    .purpose = Measures the radius of the tool with the tool touch probe, or checks it: with the tool rotating, or with the tool rotating and then tooth by tooth. The control stores the result in the central tool file TOOL.T and uses it in the next tool call. Old block form of cycle 482.
step-position-tool-beside-setter = The control positions the tool beside the probe contact, with its face below the upper edge of the contact as defined by { $mp-setter-axis-offset } and, if entered in the tool table, by the additional length offset { $mp-setter-offset-length }.
step-probe-rotating-tool-radially = The control probes the rotating tool radially.
step-measure-teeth-radially = The control determines the radius:
say-measure-radii-of-teeth = with { $q-tooth-measurement }=1 it then measures the radii of all teeth by orienting the spindle
say-radius-of-rotating-tool = with { $q-tooth-measurement }=0 the measurement with the tool rotating gives the radius
step-store-tool-radius = The control stores the result:
say-overwrite-tool-radius = with { $q-tool-check }=0 it overwrites the tool radius { $mp-tool-radius } in TOOL.T and sets the delta value { $mp-delta-radius } to 0
say-enter-delta-radius = with { $q-tool-check }=1 it compares the measured radius with the tool radius { $mp-tool-radius }, enters the deviation with its sign as the delta value { $mp-delta-radius } and in Q116, and locks the tool (status L) if the wear or breakage tolerance is exceeded
result-tool-radius-deviation = Deviation of the tool radius
note-diamond-coated-cylinders = Cylindrical tools with a diamond surface can be measured with the spindle stationary. For this, define the number of teeth { $mp-teeth } as 0 in the tool table and adapt the machine parameter { $mp-tool-measurement-config }. Refer to the machine manual.
note-diamond-coated-cylinders__itnc530 = Cylindrical tools with a diamond surface can be measured with the spindle stationary. For this, define the number of teeth { $mp-teeth } as 0 in the tool table and adapt the machine parameter { $mp-calibration-behaviour }. Refer to the machine manual.
note-two-ways-to-measure-tool = The tool can be measured in two ways: with the tool rotating, or with the tool rotating and then tooth by tooth.

# --- 33 and 483 ---
cycle-tool-complete = Measure complete tool
    .nc = MEASURE TOOL
    .purpose = Measures the length and the radius of the tool with the tool touch probe, or checks them: with the tool rotating, or with the tool rotating and then tooth by tooth. The control stores the results in the central tool file TOOL.T and takes them into account automatically at the end of the cycle.
cycle-tool-complete__tnc426-430 =
    .purpose = Measures the length and the radius of the tool with the tool touch probe, or checks them: with the tool rotating, or with the tool rotating and then tooth by tooth. The control stores the results in the central tool file TOOL.T and uses them in the next tool call.
cycle-tool-complete-old = Measure complete tool (old form)
    .nc = MEASURE TOOL
    .purpose = Measures the length and the radius of the tool with the tool touch probe, or checks them: with the tool rotating, or with the tool rotating and then tooth by tooth. The control stores the results in the central tool file TOOL.T and takes them into account automatically at the end of the cycle. Old block form of cycle 483.
cycle-tool-complete-old__tnc426-430 =
    .purpose = Measures the length and the radius of the tool with the tool touch probe, or checks them: with the tool rotating, or with the tool rotating and then tooth by tooth. The control stores the results in the central tool file TOOL.T and uses them in the next tool call. Old block form of cycle 483.
step-measure-radius-first = The control measures the tool in a fixed sequence. It first measures the radius, as the cycles 32 and 482 do: it positions the tool beside the probe contact, with its face below the upper edge as defined by { $mp-setter-axis-offset } and { $mp-setter-offset-length }, and probes the rotating tool radially.
step-then-measure-length = Then it measures the length, as the cycles 31 and 481 do:
step-store-radius-and-length = The control stores the results:
say-overwrite-radius-and-length = with { $q-tool-check }=0 it overwrites the tool radius { $mp-tool-radius } and the tool length { $mp-tool-length } in TOOL.T and sets the delta values { $mp-delta-radius } and { $mp-delta-length } to 0
say-enter-both-delta-values = with { $q-tool-check }=1 it compares the measured data with those of TOOL.T, enters the deviations with their signs as the delta values { $mp-delta-radius } and { $mp-delta-length } and in Q116 (radius) and Q115 (length), and locks the tool (status L) if a wear or breakage tolerance is exceeded
note-complete-measurement-saves-time = The cycle is particularly suited for the first measurement of tools: compared with measuring length and radius separately it saves much time.
title-first-measurement-rotating = First measurement with the tool rotating
title-check-teeth = Check with measurement of the individual teeth

# --- 30 and 480 ---
cycle-calibrate-tool-probe = Calibrate tool touch probe
    .nc = CALIBRATE TT
    .purpose = Calibrates the tool touch probe automatically with a cylindrical calibration tool. The control also determines the centre misalignment of the calibration tool. It stores the calibration values and takes them into account in later tool measurements.
cycle-calibrate-tool-probe-old = Calibrate tool touch probe (old form)
    .nc = CALIBRATE TT
    .purpose = Calibrates the tool touch probe automatically with a cylindrical calibration tool. The control also determines the centre misalignment of the calibration tool. It stores the calibration values and takes them into account in later tool measurements. Old block form of cycle 480.
guard-tool-call-missing__calibrate-tool-probe = No tool is called. Call the calibration tool with TOOL CALL.
guard-tool-call-missing__calibrate-tool-probe-old = No tool is called. Call the calibration tool with TOOL CALL.
step-position-calibration-tool-over-setter = The control positions the calibration tool at the clearance height { $q-tool-clearance-height }, but not below the safety zone { $mp-setter-safety-distance } above the plate.
step-calibrate-tool-probe = The control calibrates the touch probe automatically with the calibration tool.
step-turn-spindle-for-centre-misalignment = Half-way through the calibration the control turns the spindle by 180°. In this way it also determines the centre misalignment of the calibration tool.
step-store-tool-probe-calibration = The control stores the calibration values and takes them into account in the tool measurements that follow.
note-enter-calibration-tool-data = Before calibrating, enter the exact radius and the exact length of the calibration tool in the tool table TOOL.T.
note-cylindrical-calibration-tool = Use an exactly cylindrical part as the calibration tool, such as a cylindrical pin.
note-calibration-tool-size = The diameter of the calibration tool should be larger than 15 mm, and it should protrude about 50 mm from the chuck. It then bends by 0.1 µm at a probing force of 1 N.
note-tool-probe-position-known = The position of the touch probe in the working space of the machine must be defined in the machine parameters { $mp-setter-centre } > [0] to [2].
note-tool-probe-position-known__itnc530 = The position of the touch probe in the working space of the machine must be defined in the machine parameters { $mp-setter-centre }.0 to { $mp-setter-centre }.2.
note-tool-probe-position-known__tnc426-430 = The position of the touch probe in the working space of the machine must be defined in the machine parameters { $mp-setter-centre }.0 to { $mp-setter-centre }.2.
note-recalibrate-after-position-data-change = After a change of one of the machine parameters { $mp-setter-centre } > [0] to [2], calibrate again.
note-recalibrate-after-position-data-change__itnc530 = After a change of one of the machine parameters { $mp-setter-centre }.0 to { $mp-setter-centre }.2, calibrate again.
note-recalibrate-after-position-data-change__tnc426-430 = After a change of one of the machine parameters { $mp-setter-centre }.0 to { $mp-setter-centre }.2, calibrate again.
note-keep-fixtures-off-tool-probe = While calibrating, make sure that no fixtures are clamped around the touch probe. Recommendation: leave room for twice the diameter of the calibration tool.
note-calibration-cycle-behaviour = How the calibration cycle works depends on the machine parameter { $mp-tool-measurement-config }. Refer to the machine manual.
note-calibration-cycle-behaviour__tnc320 = The machine builder defines how the calibration cycle works. Refer to the machine manual.
note-calibration-cycle-behaviour__itnc530 = How the calibration cycle works depends on the machine parameter { $mp-calibration-behaviour }. Refer to the machine manual.
note-calibration-cycle-behaviour__tnc426-430 = How the calibration cycle works depends on the machine parameter { $mp-calibration-behaviour }. Refer to the machine manual.

# --- 484 ---
cycle-calibrate-wireless-tool-probe = Calibrate wireless tool touch probe TT 449
    .nc = CALIBRATE IR TT
    .purpose = Calibrates the wireless infrared tool touch probe TT 449. The calibration is semi-automatic, because the position of the touch probe on the machine table is not defined. The control also determines the centre misalignment of the calibration tool, stores the calibration values and takes them into account in later tool measurements.
step-insert-calibration-tool = Insert the calibration tool.
step-define-and-start-calibration = Define the calibration cycle and start it.
step-position-calibration-tool-by-hand = Position the calibration tool manually above the centre of the touch probe and follow the instructions of the pop-up window. Make sure that the calibration tool is above the measuring surface of the probe contact.
step-calibrate-wireless-tool-probe = The control calibrates the touch probe semi-automatically with the calibration tool.
message-calibration-tool-over-setter = Position the calibration tool above the centre of the touch probe and continue.
note-wireless-calibration-by-hand = The calibration is not fully automatic, because the position of the touch probe on the machine table is not defined.
note-recalibrate-after-move = If the position of the touch probe on the table changes, calibrate again.
note-calibration-tool-size__tnc640 = The diameter of the calibration tool must be larger than 15 mm, and it must protrude 50 mm from the chuck. It then bends by 0.1 µm at a probing force of 1 N.
guard-tool-call-missing__calibrate-wireless-tool-probe = No tool is called. Call the calibration tool with TOOL CALL.
