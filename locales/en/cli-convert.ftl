# The command “convert” and its messages.
cli-convert = Rewrite programs for another control, or in DIN/ISO or Klartext
cli-convert-file = NC programs; several only with --in-place
cli-convert-from = Control that the programs were written for
cli-convert-to = Control that they are to run on
cli-convert-form = Form of cycles that have two: new (Q parameters) or old (a block a line); default: as in the program
cli-convert-out = File to write (default: standard output)
cli-convert-in-place = Replace the old programs by the new ones
cli-converted = { $count ->
        [one] { $count } definition rewritten: { $path }
       *[other] { $count } definitions rewritten: { $path }
    }
cli-examples-convert =
    ciklo convert part.h --from tnc426-430 --to tnc640 > new.h
    ciklo convert part.h --from tnc640 --to tnc320 --format json
    ciklo convert measuring.h --from itnc530 --to itnc530 --form new --in-place
    ciklo convert part.h --to-iso > part.i
    ciklo convert part.i --to-klartext --lang it --out pezzo.h
diag-convert-one-file = Several programs can be rewritten only with --in-place.
diag-convert-iso-stays = “{ $found }” would change, but its new form cannot be written in DIN/ISO; the block was not changed.
diag-convert-iso-unread = Klartext has no equivalent of “{ $found }”; the block was neither checked nor changed.
diag-convert-cycle-not-on-control = { $control } does not have { $cycle }; the definition was not changed.
diag-convert-cycle-not-described = The manual of { $control } mentions { $cycle } but does not describe it; its parameters were not changed.
diag-convert-cycle-not-covered = The manuals of { $control } known to Ciklo do not cover cycles such as { $cycle }; the definition was not changed.
diag-convert-parameter-added =
    { $import ->
        [yes] { $parameter } = { $value } was added to { $cycle }, as { $control } does with older programs: set it to the value that you want.
       *[no] { $parameter } = { $value } was added to { $cycle }; with it the cycle does the same as before.
    }
diag-convert-parameter-dropped =
    { $neutral ->
        [yes] { $parameter } = { $value } of { $cycle } was removed: { $control } does the same without it.
       *[no] { $parameter } = { $value } of { $cycle } was removed: { $control } does not have it.
    }
diag-convert-parameter-renamed = { $parameter } of { $cycle } becomes { $new } on { $control }.
diag-convert-no-value = { $cycle } needs { $parameter } on { $control }, but it is not known which value leaves the machining unchanged.
diag-convert-value-refused = { $parameter } = { $value } of { $cycle } is not accepted on { $control }; the value was not changed.
diag-convert-value-differs-in-meaning = { $parameter } = { $value } of { $cycle } means something else on { $control }.
diag-convert-field-not-on-control = The field { $parameter } of { $cycle } does not exist on { $control }; the definition was not changed.
diag-convert-form = { $cycle } becomes { $new }.
diag-convert-form-stays = { $cycle } keeps its form: there are comments or other blocks between its lines.
diag-convert-not-line-by-line = { $cycle } was not changed: its parameters are not on lines of their own.
diag-convert-function-not-shown =
    { $function } (used { $count ->
        [one] once
       *[other] { $count } times
    }) was not changed: the manual of { $control } does not show it.
diag-convert-function-option = { $function } needs software option { $option } on { $control }.
