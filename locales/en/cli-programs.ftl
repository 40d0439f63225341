# The command line: comparing, checking, correcting and formatting programs.

cli-check-fail-on = The least severe finding that makes the command end with 1: error (default), warning, note
cli-compare = Prove that two programs are the same to a control, or show where they differ
cli-compare-a = NC program
cli-compare-b = NC program to compare it with
cli-compare-control = Control of both programs (default: the one that the cycles of the first belong to)
cli-compare-execute = Execute both in the scene and compare the events
cli-examples-compare =
    ciklo compare part.h pezzo.h
    ciklo compare part.h pezzo.h --control tnc640 --execute --scene part.scene.yaml
cli-compared = { $count ->
        [0] The programs are the same apart from labels, comments, numbering, white space and the spelling of numbers.
        [one] The programs differ in { $count } place.
       *[other] The programs differ in { $count } places.
    }
cli-compare-executed = { $verdict ->
        [same] { $count ->
            [one] Executing them gives the same { $count } event.
           *[other] Executing them gives the same { $count } events.
        }
        [different] Executing them gives different events.
       *[unproved] Executing them gives the same events as far as the engine can execute the programs; the rest is not proved.
    }

cli-check-path = NC programs, or folders whose programs (.h, .i) are checked; “-” reads standard input
cli-check-control = Control of the programs, with its software version if it is known, such as tnc640@340590-05 (default: that of ciklo.toml)
cli-check-config = File with settings (default: ciklo.toml in the folder of each program or above it)
cli-check-table = Tool, preset or datum table whose rows the programs use
cli-check-fix = Correct what can be corrected without changing what a program does: labels and doubled signs
cli-check-no-cache = Check every program again, even those that have not changed since the last time
cli-check-no-execution = Do not execute programs whose tools are all known; only read them
cli-check-format = Form of the output: text (default), json, sarif, github
cli-checking = Programs
cli-checked =
    { $files ->
        [one] { $files } program checked, { $wrong ->
            [0] without errors.
           *[other] with errors.
        }
       *[other] { $files } programs checked, { $wrong ->
            [0] none of them with errors.
           *[other] { $wrong } of them with errors.
        }
    }
cli-fixed = { $count ->
        [0] Nothing was corrected.
        [one] { $count } place was corrected.
       *[other] { $count } places were corrected.
    }
diag-check-no-control = The control of { $path } is not known: name it with --control, or with control in ciklo.toml.
diag-check-no-programs = There are no programs in { $path }: nothing was checked.
diag-check-no-table = “{ $path }” is not a table: its extension is none of .T, .TP, .PR, .D and .PNT.
diag-passed-over = { $more ->
        [0] { $path } was skipped:
        [one] { $path } and one other entry were skipped:
       *[other] { $path } and { $more } other entries were skipped:
    } neither a file nor a folder, or a link that is not followed.
diag-fix-no-file = Standard input cannot be corrected in place: name a file.
diag-fix-file-changed = { $path } was changed by another program in the meantime; it was not written.
diag-fix-changes-program = { $path } would no longer be the same program; it was not written.
diag-config-syntax = This is not valid TOML.
diag-config-unknown-key = There is no setting “{ $key }”. The settings are control, lang, tables, fail-on, rules, machine and folder.
diag-config-unknown-rule = There is no rule “{ $key }”; “ciklo explain” lists them all.
diag-config-unknown-word = { $expected } is not a possible value of { $key }.
diag-config-value = { $key } needs another value here: { $expected }.
diag-allow-without-reason = This comment allows { $rule } without a reason, so it has no effect.
diag-allow-unknown-rule = There is no rule “{ $rule }” that could be allowed.
diag-allow-unused = { $rule } is not found here; the comment can be deleted.

cli-translate-relabel = Treat every comment that looks like a label as one, even in an unknown language
cli-translate-encoding = Encoding of the file, as a name such as windows-1250 (default: found out from its bytes)
cli-translate-from = Language of the program's labels; only these are replaced (default: each definition in its own)
cli-translate-sources = { $count ->
        [one] Language of the labels, with the number of definitions: { $languages }.
       *[other] Languages of the labels, with the number of definitions: { $languages }.
    }
cli-fmt = Format programs in place: numbers, columns, signs
cli-fmt-path = NC programs, or folders whose programs (.h, .i) are formatted; “-” reads standard input and writes standard output
cli-fmt-check = Write nothing; name the programs that would change
cli-examples-fmt =
    ciklo fmt part.h
    ciklo fmt programs --check
cli-completions = Print the script that completes the command line in a shell
cli-completions-shell = Shell: bash, elvish, fish, powershell, zsh
cli-examples-completions =
    ciklo completions bash > ~/.local/share/bash-completion/completions/ciklo
cli-man = Print the page for man, in English
cli-man-out = Directory for the page and one for each command
cli-examples-man =
    ciklo man > ciklo.1
    ciklo man --out man1
cli-fmt-diff = With --check: show what would change
