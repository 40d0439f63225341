# Blocks that end a program or speak with the machine.
diag-error-of-program = The program ends itself with the error { $number } (FN 14).
explain-error-of-program = FN 14: ERROR ends the program with an error of its own; the number chooses the message that the control shows. Programs use it where they cannot go on, for example after a jump over values that they can work with. Example: “FN 14: ERROR = 1010”. Remedy: look at the condition before the block and give the parameters values that the program can work with.
diag-tool-setter-askew = The tool is not at right angles to the face of the tool setter.
explain-tool-setter-askew = The head, or the working plane, is tilted in another way than the tool setter is mounted: the tool would touch it askew, and what is found would be neither length nor radius. Example: a tool that lies horizontally over a setter whose face points upwards. Remedy: turn the rotary axes so that the tool is along the setter before the cycle, or mount the setter of the scene accordingly (“rotate”).
diag-tool-setter-collision = Collision: the tool meets the tool setter on a movement from X { NUMBER($x) } Y { NUMBER($y) } Z { NUMBER($z) }.
explain-tool-setter-collision = The tool meets the tool setter of the scene on a movement that does not measure: the tool as it really is, with its longest and widest edge. On the machine both could break. Often the clearance height is too low, or length and radius in the tool table are too far from the truth for the safety distance of the tool setter. Enter approximate values before a first measurement, or go round the tool setter.
diag-tool-setter-missing = The scene has no tool setter.
explain-tool-setter-missing = A cycle of the tool setter needs one in the scene: where its face is and how wide. Example: “tool_setter:” with “at: [300, 200, -50]” and “diameter: 40”. Remedy: add it to the scene; docs/scene.md describes its keys.

# --- kinematics ---
diag-kinematics-not-saved = No kinematics are saved under the name “{ $name }”.
explain-kinematics-not-saved = Only kinematics that were saved can be restored or deleted. Example: mode 1 with the name AB before any mode 0 with it. Remedy: save first, correct the name, or add the memory to “kinematics: saved:” in the scene.
diag-kinematics-differs = The kinematics saved as “{ $name }” describe another machine.
explain-kinematics-differs = Saved data can only be restored into an identical kinematics description: the same name and the same rotary axes in the same order. Example: data of a machine with A and C restored on one with B and C. Remedy: choose data of this machine.
diag-kinematics-memory-full = All { $count } memories for kinematics are in use.
explain-kinematics-memory-full = The control keeps a limited number of saved kinematics. Example: a seventeenth name on a control with 16 memories. Remedy: delete one that is no longer needed, or save under a name that is in use.
diag-tool-edges-too-many = Teeth can be measured one by one on tools with up to { $most } teeth; the tool table says { $count }.
explain-tool-edges-too-many = The manual limits the measurement of single teeth. Example: CUT = 24 in the tool table and Q341=1, where at most 20 teeth can be measured. Remedy: measure the tool rotating (Q341=0), or correct CUT. The tool table stays as it was.
diag-kinematics-tool-axis = This cycle can be used with the tool axis Z only; the active tool axis is { $axis }.
explain-kinematics-tool-axis = Kinematics are measured with the touch probe along Z: the manuals allow no other tool axis. Example: TOOL CALL 1 Y before cycle 451. Remedy: call the touch probe with the tool axis Z. The kinematics stay as they were.
diag-kinematics-undetermined = The measuring positions do not tell where the { $axis } axis is.
explain-kinematics-undetermined = To correct the place of a rotary axis, its measuring positions must differ clearly from the reference position at 0°. Example: one point at 0.05°, or only a point at 0° that is ignored. Remedy: a larger range between start and end angle, or more measuring points. The kinematics stay as they were.
diag-sphere-radius-differs = The measured radius of the calibration sphere, { $found } mm, deviates too far from the radius entered, { $entered } mm.
explain-sphere-radius-differs = At each position the control first measures the radius of the sphere; a machine parameter limits its deviation from the one entered. Example: 12.5 entered, a sphere of 12.6 and a limit of 0.05. Remedy: enter the exact radius, or calibrate the probe.
diag-measuring-position-at-zero = A measuring position of the { $axis } axis is at 0° or 360°.
explain-measuring-position-at-zero = The reference measurement is made at 0°, so a measuring position there tells nothing, and the iTNC 530 refuses it. Example: −90 to +90 with 3 points. Remedy: another number of points, or other angles.
diag-measuring-position-near-limit = The measuring position of the { $axis } axis at { $angle }° is less than { $way }° from the limit of the axis.
explain-measuring-position-near-limit = The angle of the axis is measured with the encoder of its motor, and the control needs { $way }° of travel beyond each measuring position for its internal backlash compensation. Example: a point at 119.5° with “max: 120” and “encoder: motor” in the machine. Remedy: choose start and end angle further from the limits.
diag-hirth-without-retraction = The { $axis } axis has Hirth teeth and needs a retraction height.
explain-hirth-without-retraction = An axis with Hirth teeth leaves its grid to be positioned, so it cannot be measured without retraction. Example: a retraction height of 0 with “hirth: 3” in the machine. Remedy: enter a height above the sphere.
diag-mask-missing = There is no mask { $name }.
explain-mask-missing = FN 16 writes by a mask, a text file that stands beside the program or under "masks" in the scene, and this one is in neither place. Drives and folders in the name do not matter. Example: “FN 16: F-PRINT TNC:\MASK.A / TNC:\LOG.TXT” without a file MASK.A. Add the mask or correct its name.
diag-mask-unreadable = { $file }, line { $line }: the mask cannot be read: { $found }
explain-mask-unreadable = A mask consists of texts in quotation marks with a place for each value that follows them, and of keywords; each ends with a semicolon. Example: “"X = %9.3LF", Q31;”. Frequent causes are a missing semicolon, more places than values, or a keyword that cannot be simulated. Correct the line.
diag-output-path = The path { $path } leads out of the folder of the results.
explain-output-path = What FN 16 writes goes into the folder that is given with --out, under the name of its file, whatever the folder on the control. A path that leads upwards, or to the drive or root folder of another system, could overwrite other files and is refused. Example: “TNC:\LOG\..\PART.TXT”. Use a path on TNC: without “..”.
diag-open-table-missing = No table is open.
explain-open-table-missing = FN 27 and FN 28 write and read the table that FN 26: TABOPEN has opened, and none has been opened before this block. Example: “FN 28: TABREAD Q10 = 6/"X,Y"” at the beginning of a program. Open the table first: “FN 26: TABOPEN TNC:\TAB1.TAB”.
