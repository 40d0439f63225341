# Cycles that save the kinematics and compensate the preset.

# --- 450 ---
cycle-save-kinematics = Save kinematics
    .nc = SAVE KINEMATICS
    .purpose = Saves the active kinematics of the machine or restores kinematics saved before. The saved data can be shown and deleted.
cycle-save-kinematics__itnc530 =
    .purpose = Saves the active kinematics of the machine, restores kinematics saved before, or shows the present state of the memory on the screen and in a log.
condition-memory-location-used = { $q-kinematics-memory-mode } is not 2
step-treat-saved-kinematics = The control handles the kinematics according to the mode { $q-kinematics-memory-mode }:
say-save-active-kinematics = 0: it saves the active kinematics under { $q-kinematics-memory-location }
say-restore-saved-kinematics = 1: it restores the kinematics saved under { $q-kinematics-memory-location }
say-show-saved-kinematics = 2: it shows the present state of the memory
say-delete-saved-kinematics = 3: it deletes the data records that { $q-kinematics-memory-location } names
note-save-before-optimization = Before a kinematics optimization always save the active kinematics.
note-kinematics-memory-size = 16 memory locations are available.
note-kinematics-memory-size__itnc530 = 10 memory locations are available, with the numbers 0 to 9.
note-restore-only-into-identical-kinematics = In the mode “restore” the control can write saved data back only to an identical kinematics description.
note-preset-changes-with-kinematics__save-kinematics = A change of the kinematics, including a restoration, always changes the preset as well. If necessary, set the preset again.
note-kinematics-memory-wildcards = If several data records match the wildcards of { $q-kinematics-memory-location }, the control restores the mean values of their data (mode 1) or, after confirmation, deletes all of them (mode 3).
note-kinematics-memory-file = The control stores the saved data in the file TNC:\table\DATA450.KD. This file can be backed up on an external computer, with TNCremo for example, so that it can be restored after a disk failure. If the file is deleted, the saved data are lost. If it does not exist, the control creates it when cycle 450 is executed.
note-kinematics-memory-file-by-hand = Do not change the saved data in the file TNC:\table\DATA450.KD by hand: the data records may become corrupt and unusable.
note-kinematics-memory-code-number = In the mode “save” the control always stores the code number that was last entered under MOD as well; any code number may be defined. After that the memory location can be overwritten only if this code number is entered.
note-overwritten-without-question = If kinematics data were saved without a code number, the control overwrites its memory location the next time it saves, without asking.
note-kinematics-memory-log-contents = After cycle 450 the control creates a log (TCHPR450.TXT). It contains date and time, the path of the NC program, the mode (0=save/1=restore/2=state of memory/3=delete), the identifier of the active kinematics and the identifier of the data record entered. Mode 0 adds all axis and transformation entries of the kinematics chain saved, mode 1 all transformation entries before and after restoring, mode 2 a list of the saved data records, mode 3 a list of the records deleted.
note-kinematics-memory-log-contents__itnc530 = After cycle 450 the control creates a log (TCHPR450.TXT). It contains date and time, the path of the NC program, the mode (0=save/1=restore/2=state of memory), the number of the memory location (0 to 9), the line number of the kinematics in the kinematics table, and the code number if one was entered directly before cycle 450. Mode 0 adds all axis and transformation entries of the kinematics chain saved, mode 1 all transformation entries before and after restoring, mode 2 a list of the present state of the memory, on the screen and in the log, with memory location, code numbers, number of the kinematics and date of saving.
title-save-active-kinematics = Save the active kinematics
title-restore-saved-kinematics = Restore data records
title-show-saved-kinematics = Show all saved data records
title-delete-saved-kinematics = Delete data records
title-save-before-calibration = Save the kinematics before a calibration program
table-kinematics-memory = Saved kinematics

# --- 452 ---
cycle-preset-compensation = Preset compensation
    .nc = PRESET COMPENSATION
    .purpose = Optimizes the kinematic transformation chain of the machine. The control then also corrects the workpiece coordinate system in the kinematic model, so that the preset is at the centre of the calibration sphere after the optimization. In this way interchangeable heads can be matched to each other, or drift of the machine can be compensated.
group-match-interchangeable-heads = Matching interchangeable heads
group-compensate-drift = Compensating drift, if the calibration sphere can stay on the machine table during machining
group-measure-and-compensate = Measurement and compensation
step-clamp-calibration-sphere = Clamp the calibration sphere.
step-measure-reference-head = Measure the reference head completely with cycle 451, and let cycle 451 set the preset at the centre of the sphere.
step-insert-second-head = Insert the second head.
step-measure-second-head = Measure the interchangeable head with cycle { $cycle } up to the interface of the head change.
step-match-further-heads = Match further interchangeable heads to the reference head with cycle { $cycle }.
step-set-preset-in-sphere = Set the preset at the centre of the calibration sphere.
step-set-preset-on-workpiece = Set the preset on the workpiece and start machining.
step-compensate-at-intervals = Compensate the preset at regular intervals with cycle { $cycle }: the control determines the drift of the axes concerned and corrects it in the kinematics.
step-optimize-transformation-chain = The control optimizes the kinematic transformation chain of the machine.
step-correct-workpiece-system = The control corrects the workpiece coordinate system in the kinematic model so that the preset is at the centre of the calibration sphere.
note-datum-in-sphere-first__preset-compensation = Before the cycle definition, set and activate the datum at the centre of the calibration sphere.
note-one-degree-before-limit-switch = For axes without a separate position encoder, choose the measuring points so that 1° of travel to the limit switch remains. The control needs this path for its internal backlash compensation.
note-kinematics-limit-exceeded__preset-compensation = If the kinematics data exceed the permitted limit ({ $mp-max-modification }), the control shows a warning. Confirm with NC start that the values are to be accepted.
note-match-heads-purpose = Matching interchangeable heads leaves the workpiece preset unchanged when rotary axes (heads) are exchanged. Insert one of the heads as the reference head, clamp the calibration sphere, insert the touch probe, measure the complete kinematics with cycle 451 and let the cycle set the preset after the measurement (Q431=2 or 3). Then insert the next head and the touch probe and measure it with cycle { $cycle }. All other heads can be matched in the same way.
note-match-heads-only-changed-axes = Measure only the axes that were actually exchanged. Example: a fork head with the axes A and C, of which only the A-axis is exchanged; the C-axis is excluded with { $q-rotary-measuring-points-c }=0.
note-preset-and-sphere-stay = The preset and the position of the calibration sphere must not change during the whole procedure.
note-drift-purpose = During machining, machine components drift because of changing ambient conditions. If the drift is sufficiently constant over the traverse range and the calibration sphere can stay on the machine table, cycle { $cycle } determines and compensates it. Clamp the calibration sphere, insert the touch probe, measure the complete kinematics with cycle 451 before machining starts and let the cycle set the preset after the measurement (Q431=2 or 3), then set the presets of the workpieces and start machining. At regular intervals, insert the touch probe, activate the preset at the centre of the calibration sphere and measure the kinematics with cycle { $cycle }.
note-drift-without-rotary-axes = Drift can also be compensated on machines without rotary axes.
note-kinematics-prepared-for-preset = The kinematics must be prepared for preset compensation. Refer to the machine manual.
note-head-change-is-machine-function = Changing heads is a function of the machine. Refer to the machine manual.
note-kinematics-log-contents__preset-compensation = The log contains date and time, the path of the NC program, the number of the active kinematics and the sphere radius entered; for each rotary axis measured: start angle, end angle, angle of incidence, number of measuring points, scatter (standard deviation), greatest error, angular error, mean backlash, mean positioning error, radius of the measuring circle, compensation values in all axes (preset shift) and the measuring uncertainty of rotary axes.
note-kinematics-log-contents__preset-compensation__itnc530 = The log contains date and time, the path of the NC program, the number of the active kinematics and the sphere radius entered; for each rotary axis measured: start angle, end angle, angle of incidence, number of measuring points, scatter (standard deviation), greatest error, angular error, mean backlash, mean positioning error, radius of the measuring circle, compensation values in all axes (preset shift), rating of the measuring points and the measuring uncertainty of rotary axes.
note-kinematics-log-explained__preset-compensation = Scatter measured: 68.3% of the spatial errors measured lie within ± this value; optimized: 68.3% of the errors expected after the correction. The rating of the measuring points is a measure of the quality of the measuring positions with respect to the changeable transformations of the model: the higher it is, the better the optimization. It should not be below 2 for any rotary axis, better 4 or more; if it is small, enlarge the measuring range of the axis or the number of points. If that does not help, the kinematics description may be wrong; if necessary, contact customer service.
title-compensate-preset = Calibration program
title-match-interchangeable-head = Match an interchangeable head
title-compensate-drift = Compensate drift

# --- kinematics ---
message-backlash-angle-too-small = The backlash found is not much smaller than the angle entered in { $q-backlash-angle }: it may be greater than measured. Enter a larger angle and measure again.
message-kinematics-limit-exceeded = The kinematics data change by more than the permitted limit. Confirm with NC start that they are to be accepted.
message-delete-saved-kinematics = Several saved kinematics match the name. Confirm that all of them are to be deleted.
