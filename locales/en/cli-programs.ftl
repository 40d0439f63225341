# The command line: comparing, checking, mending and laying out programs.

cli-check-fail-on = The least severe finding that makes the command end with 1: error (default), warning, note
cli-compare = Prove that two programs are the same to a control, or show where they differ
cli-compare-a = NC program
cli-compare-b = NC program to compare it with
cli-compare-control = Control of both programs (default: the one whose cycles the first has)
cli-compare-execute = Execute both in the scene and compare what happens
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
            [one] The same happens: { $count } event.
           *[other] The same happens: { $count } events.
        }
        [different] Something else happens.
       *[unproved] The same happens as far as the engine can execute the programs; more is not proved.
    }

cli-check-path = NC programs, or folders whose programs (.h, .i) are checked; “-” reads standard input
cli-check-control = Control of the programs, with its software version if it is known, such as tnc640@340590-05 (default: that of ciklo.toml)
cli-check-config = File with settings (default: ciklo.toml in the folder of each program or above it)
cli-check-table = Tool, preset or datum table whose rows the programs use
cli-check-fix = Mend what can be mended without changing what a program does: labels
cli-check-no-cache = Check every program again, even those that have not changed since the last time
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
        [0] Nothing was mended.
        [one] { $count } label was mended.
       *[other] { $count } labels were mended.
    }
diag-check-no-control = The control of { $path } is not known: --control, or control in ciklo.toml.
diag-check-no-programs = There are no programs in { $path }: nothing was checked.
diag-check-no-table = “{ $path }” is no table: its extension is none of .T, .TP, .PR, .D and .PNT.
diag-passed-over = { $more ->
        [0] { $path } was passed over:
        [one] { $path } and one other entry were passed over:
       *[other] { $path } and { $more } other entries were passed over:
    } neither a file nor a folder, or a link that is not followed.
diag-fix-no-file = Standard input cannot be mended: name a file.
diag-fix-file-changed = { $path } was changed meanwhile by someone else; it is left as it is.
diag-fix-changes-program = { $path } would not be the same program any more; it is left as it is.
diag-config-syntax = This is not TOML.
diag-config-unknown-key = There is no setting “{ $key }”; there are control, lang, tables, fail-on, rules, machine and folder.
diag-config-unknown-rule = There is no rule “{ $key }”; “ciklo explain” lists them all.
diag-config-unknown-word = { $expected } is nothing that { $key } can be.
diag-config-value = { $key } needs something else here: { $expected }.
diag-allow-without-reason = This comment takes back { $rule } without a reason, so it does not.
diag-allow-unknown-rule = There is no rule “{ $rule }” to take back.
diag-allow-unused = { $rule } is not found here; the comment can go.
explain-allow-without-reason = A comment “; ciklo: allow RULE reason” takes back what a rule finds in the block that it follows, or, on a line of its own, in the block that follows. Without a reason it has no effect.
explain-allow-unknown-rule = The word after “allow” is no rule of the checker and no guard. ciklo explain lists all codes.
explain-allow-unused = The comment takes nothing back: the rule finds nothing in the block that the comment speaks for, or not on this control.

cli-translate-relabel = Take whatever has the form of a label for one, even in a language that is not known here
cli-translate-encoding = Encoding of the file, as a name such as windows-1250 (default: found out from its bytes)
cli-translate-from = Language of the program's labels; only these are replaced (default: each definition in its own)
cli-translate-sources = { $count ->
        [one] Language of the labels, with the number of definitions: { $languages }.
       *[other] Languages of the labels, with the number of definitions: { $languages }.
    }
cli-fmt = Format programs in place: numbers, columns, signs
cli-fmt-path = NC programs, or folders whose programs (.h, .i) are laid out; “-” reads standard input and writes standard output
cli-fmt-check = Write nothing; name the programs that would change
cli-examples-fmt =
    ciklo fmt part.h
    ciklo fmt programs --check
cli-completions = Print what a shell needs to complete words of the command line
cli-completions-shell = Shell: bash, elvish, fish, powershell, zsh
cli-examples-completions =
    ciklo completions bash > ~/.local/share/bash-completion/completions/ciklo
cli-man = Print the page for man, in English
cli-man-out = Directory for the page and one for each command
cli-examples-man =
    ciklo man > ciklo.1
    ciklo man --out man1
cli-fmt-diff = With --check: show what would change
