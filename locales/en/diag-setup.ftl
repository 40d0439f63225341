# Findings of the checker on tools, the spindle, presets and what the machine and the blank allow.
diag-approach-wrong =
    { $what ->
        [arc] The arc with the radius { $value } does not fit between this point and the contour.
        [left] The tool leaves the contour along its axis, without DEP.
       *[plunged] The contour begins where the tool has plunged.
    }
diag-config-unknown-machine = There is no machine setting “{ $key }”; there are { $expected }.
diag-coordinate-out-of-range = The coordinate { $value } is out of range: { $limit } is the greatest value that the manuals allow.
diag-labels-not-known =
    { $count ->
        [one] One label here has the form of a label, but no language has it for this parameter: it stays. --relabel replaces it.
       *[other] { $count } labels from here on have the form of labels, but no language has them for their parameters: they stay. --relabel replaces them.
    }
diag-machine-limit =
    { $what ->
        [speed] The spindle speed { $value } is above { $limit }, the maximum of the machine.
        [feed] The feed rate { $value } is above { $limit }, the maximum of the machine.
        [helix] The helix of { $value } degrees is longer than { $limit }, the maximum of the machine.
        [angle] { $word } { $value } is beyond { $limit }, the end of the axis.
        [position] { $word } { $value } is beyond { $limit }, the end of the axis.
       *[travel] The program uses { $value } mm of axis { $word }, which is only { $limit } mm long.
    }
diag-machining-outside-blank =
    { $what ->
        [across] The side of { $value } lies across the face milled in this plane, which is only { $other } wide: turned by 90 degrees it would lie on it.
        [above] The cycle goes no lower than { $value }, which is above the blank: it removes nothing.
        [below] The tool cuts at a height of { $value }, far below the blank.
        [over] What is machined at { $value }, { $other } goes over the edge of the blank.
        [contour] The contour is called at { $value }, above the blank, and elsewhere inside of it: it removes nothing here.
        [curve] The curve begins and ends in the blank, but leaves it on the way, at { $value }, { $other }.
        [corner] The position of the pocket counts from a corner here, so from { $value }, { $other }, the middle of the blank, it goes over the edge.
       *[outside] What is machined at { $value }, { $other } is far from the blank.
    }
diag-milling-deeper-than-edges = The tool mills { $value } deep here, which is more than its cutting edges are long (LCUTS).
diag-plane-left-on =
    { $what ->
        [axes] The plane is reset, but the rotary axes have not been turned back: the tool cuts into the tilted part.
       *[tool] The working plane is still tilted when this tool is called.
    }
diag-preset-row-wrong =
    { $what ->
        [again] Preset { $row } is written again here, at another place, and nothing has activated it in between.
        [other] Preset { $other } is activated here, but the probed one is preset { $row }, which is never activated.
        [datum] Row { $row } of the datum table is written here and never activated: machining goes on with another datum.
        [same] Preset { $row } is active already; here it is activated again, after the program has stopped for the operator.
        [table] Row { $row } of the datum table is written here, but then preset { $row } is activated, which nothing has written.
       *[unused] Preset { $row } is written here and never activated: machining goes on with another preset.
    }
diag-repeat-without-effect =
    { $what ->
        [same] The contour is repeated at the same depth { $value }: incremental steps of it would go through the blank.
        [place] The repeated movement leads to a place with absolute coordinates, where the tool already is: the repeats do nothing.
        [jump] This jump leads to the block that follows it anyway: what it was to pass over is missing.
       *[zero] A repeat of zero times does nothing.
    }
diag-slot-too-narrow = The tool with the diameter { $tool } does not fit between the walls here: this line is only { $value } long.
diag-spindle-start-wrong =
    { $what ->
        [missing] Nothing has turned the spindle on since this tool was called.
       *[direction] The spindle turns counter-clockwise (M4) while this tool cuts.
    }
diag-tap-without-hole =
    { $what ->
        [missing] No hole was drilled at { $value }, { $other } for this tap.
        [floor] The thread goes down to { $value }, but the floor beside it is at { $other }: the thread mill goes into solid material.
       *[shallow] The tap goes down to { $value }, but the hole ends at { $other }.
    }
diag-tcpm-missing = Rotary axes move together with linear axes here without TCPM, although the program switches TCPM off later.
diag-tool-called-twice = Tool { $tool } is called again here, with nothing between the two calls.
diag-tool-table-contradicts =
    { $what ->
        [speed] The spindle speed { $value } exceeds { $other }, the maximum speed of tool { $tool } in the tool table (NMAX).
        [locked] Tool { $tool } is locked in the tool table (TL), and no replacement tool is named (RT).
        [point] { $value } centres to a diameter here, and tool { $tool } has no point angle in the tool table (T-ANGLE).
        [turning] { $value } is not meant for tool { $tool }, which is of type { $other } in the table of turning tools (TYPE).
        [size] Tool { $tool } has a diameter of { $other } in the tool table, and its name says { $value }.
        [oversize] The oversize { $value } (DR) leaves nothing of the radius { $other } of tool { $tool }.
        [left] The pitch { $value } is that of a left-hand thread, and nothing says that tool { $tool } is a left-hand tap.
        [length] Tool { $tool } has no length in the tool table (L), while the other tools have one.
        [teeth] { $value } measures each tooth, but tool { $tool } has no number of teeth in the tool table (CUT).
        [large] The oversize { $value } (DR) is greater than the radius { $other } of tool { $tool }.
        [called] { $value } is not meant for tool { $tool }, which is called { $other }.
       *[type] { $value } is not meant for tool { $tool }, which is of type { $other } in the tool table (TYP).
    }
diag-translate-encoding = The file is written in { $encoding }: it has the same bytes there, and all letters of the new labels.
diag-translate-encoding-unknown = There is no encoding “{ $encoding }”; there are { $known }.
diag-translate-encoding-wrong = { $path } is not in { $encoding }: some bytes have no meaning there.
diag-translate-unread = { $cycle } has a line that cannot be read, so its name and labels stay as they are.
related-preset-written-here = written here
diag-character-unknown = The text has “{ $character }”, which the font does not have.
diag-allowance-left =
    { $what ->
        [order] The contour is machined with the oversize { $value } (DR) here and afterwards with the greater one { $other } by the same tool: nothing is left for the second pass.
        [below] The contour of label { $label } is machined with the negative oversize { $value } first: nothing is left for the tool that machines it afterwards.
        [cycle] { $label } machines the contour with this tool, too, with the allowance { $value }: it stays on the part.
       *[left] The contour of label { $label } is machined with the oversize { $value } with this tool, too: the allowance stays on the part.
    }
diag-contour-crossed =
    { $what ->
        [back] This closed contour goes from a corner straight back to the one before it.
        [away] The tool leaves this closed contour for its other side: on the way it cuts through what it has just finished.
        [start] This closed contour is approached in an inside corner: the tool cuts into its last element there.
        [short] This contour ends on its first line, short of its beginning: the rest of the line is not machined.
        [itself] This contour comes back to one of its own lines before its end: the tool cuts through what it has just finished.
       *[side] With this radius compensation the tool crosses the closed contour: it comes from the other side of it.
    }
diag-contour-depths-differ =
    { $what ->
        [chamfer] The chamfer is cut at { $value }, below the floor of the contour at { $other }.
        [deep] The contour ends at { $value } here, and the tool before has cut one infeed deeper, down to { $other }.
       *[shallow] The contour is cut down to { $value } here in one pass, and the tool before has only come down to { $other }.
    }
diag-error-branch-entered =
    { $what ->
        [turned] The jump over the stop is taken where { $parameter } reports a fault.
        [implied] This jump and the one before it go to the same label and compare { $parameter } in the same direction: one of the two limits says nothing.
        [branch] The condition of this jump does not fit its branch: with this value { $parameter } means something else than the label or the comment there.
        [good] This jump to a branch for faults is also taken when all is well: { $parameter } reports no fault with this value.
        [unchecked] The cycle measures the tool anew here and compares it with nothing: { $parameter }, which is asked for afterwards, reports no fault.
        [greater] The jump to the error message is always taken here: { $value } is greater than { $other }.
        [less] The jump to the error message is always taken here: { $value } is less than { $other }.
       *[entered] The run comes to this branch without its jump, and stops: neither M2 nor M30 ends the program before it.
    }
diag-finishing-before-roughing =
    { $what ->
        [pilot] { $other } names the tool that drills here; it must name the one that roughs out afterwards.
       *[order] { $cycle } finishes the contour here, before { $other } roughs it out.
    }
diag-label-unused = Nothing calls, repeats or jumps to label { $label } in this subprogram.
diag-loop-runs-once =
    { $what ->
        [again] From the second time on this loop is executed only once: nothing sets its counter back.
        [other] The counter of this loop is calculated from another parameter in each pass: the number with which it begins has no effect.
        [inner] The loop inside of this one counts with { $parameter } as well, which ends this one early or never: this jump does not count its own passes.
       *[never] This jump back is never taken: its counter fulfils the condition on no pass.
    }
diag-parameter-unused =
    { $what ->
        [late] { $parameter } is given a value here that no call reads any more: each call has its own values, and the call for these comes before them.
       *[never] { $parameter } is given a value here, and nothing reads it.
    }
diag-probing-direction-wrong =
    { $what ->
        [up] { $cycle } probes with { $value }, upwards along the tool axis: the probe would come from inside of the part.
       *[edge] { $cycle } probes the edge in { $axis } with the direction { $value }: the part is on the side from which the probe comes.
    }
diag-same-datum-twice =
    { $what ->
        [loop] The loop counts, but activates row { $row } on every pass: the same is machined again each time.
        [turned] The table was not turned on for row { $row }: it stands at the angle of another side.
        [cycle] Row { $row } is activated again before the same cycle call at the same place: the same is machined twice.
       *[again] Row { $row } is activated again before the same subprogram: the same is machined twice.
    }
diag-selected-table-missing = The table { $name } is not in the folder of the program.
diag-turned-contour-wrong =
    { $what ->
        [above] The contour ends at Z { $value }, above the blank, which ends at { $limit }.
        [narrow] The recess is { $value } wide, the tool { $limit }.
        [side] The recess goes from the diameter { $limit } to { $value }; elsewhere the same tool recesses in the other direction.
        [dip] The contour falls to the diameter { $value }, below its first diameter { $limit }, and the cycle machines no undercuts.
        [deep] The recess is { $value } deep, and the tool cuts only { $limit }.
        [ridge] The face rises to the diameter { $value } and falls to { $limit } at once: an edge without any width stays.
        [corner] A corner of the contour lies at Z { $value }, beyond the end of the blank at { $limit }, and the contour comes back from there.
        [wall] The tool cuts through the wall of the part here: on its other side the diameter is { $limit }.
        [air] The cycle turns only in the air: it comes to the diameter { $value }, and the part has the diameter { $limit } there.
       *[rounding] The rounding { $value } needs more of a line than there is; at most { $limit } is possible.
    }
diag-called-program-wants =
    { $name } reads { $parameter }, and nothing has given it a value before this call.
diag-branch-runs-on =
    { $what ->
        [variant] The branch ends here without a jump, and the run goes on into the other one: nothing leads to label { $parameter } after it.
       *[values] The branch ends here without a jump: the next one gives { $parameter } other values before anything reads these.
    }
diag-finishing-tool-too-wide = The allowance and the radius of the tool add up to { $value } here; this must be less than in roughing, { $other }.
