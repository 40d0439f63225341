# The command line: help, messages, and findings about files and words.

cli-about = Specifications of CNC cycles as dialogs, NC blocks, manuals, program checks and an engine
cli-explain-more = “ciklo explain { $code }” explains a finding and what to do about it.
cli-heading-usage = Usage:
cli-heading-commands = Commands
cli-heading-arguments = Arguments
cli-heading-options = Options
cli-heading-examples = Examples:

cli-build = Write the manuals, dialogs and label tables
cli-build-out = Directory to write; it is replaced only when everything is complete (default: out)
cli-build-control = Only this control; may be repeated
cli-build-lang = Only this language; may be repeated
cli-build-base-url = Address that the site will have: adds canonical addresses, a sitemap and absolute links on 404.html
cli-schema = Print the JSON Schema of the specifications
cli-lint = Report everything that is wrong with specifications and languages
cli-lint-accept = Accept the translations that are new or were edited since they were accepted
cli-coverage = Show what is complete, missing, out of date, not implemented and not tested
cli-dialog = Show the dialog of a cycle
cli-block = Write the NC block of a cycle
cli-block-values = Number of the cycle, and values of parameters such as Q321=50; the others have the values of the manual's example
cli-block-number = Block number of the first block (default: that of the manual's example)
cli-block-form = Form of the cycle, for old-style cycles that have several
cli-block-without = Optional field to leave out; may be repeated
cli-parse = Split a program into blocks, as JSON
cli-parse-print = Print the program unchanged, byte for byte
cli-check = Check programs for one control
cli-check-lang = Language of the labels in the programs (default: detected)
cli-explain = Explain the code of a finding
cli-explain-code = The code; without one, all codes are listed
cli-explain-renamed = The code “{ $old }” is now called “{ $code }”.
cli-translate = Write a program with the names and labels of another language; nothing else changes
cli-translate-to = Language of the names and labels
cli-translate-control = Control of the program (default: detected from its cycles)
cli-translate-out = File to write (default: standard output)
cli-run = Execute a program in a scene
cli-run-tool-table = Table of tools or turning tools (.trn) to use instead of the one in the scene; may be given for each
cli-run-out = Directory for the tables and logs that the program writes
cli-run-events = Print each event as a line of JSON
cli-run-stock = File for the finished part (STL), with a report on the machining
cli-run-skip-blocks = Skip the blocks that begin with /
cli-run-lang = Language of the logs (default: that of the labels in the NC program, otherwise that of the program’s own texts)
cli-run-envelope = Show what each probing cycle would do in the worst case, instead of the results
cli-plot = Draw the tool path and the part of a program as SVG
cli-plot-view = Direction of view: top, side, isometric (default)
cli-plot-out = File for the drawing
cli-conform = Execute the examples of the specifications
cli-conform-engine = Run the examples on another engine, a command that uses the protocol of docs/conform-protocol.md
cli-conform-time-limit = Longest time for a case, in seconds (default: 10)
cli-conform-serve = Answer requests of this protocol from standard input
cli-export = Print all cycles of a control in one language, as JSON

cli-arg-cycle = Number of the cycle, such as 412 or TCH PROBE 412
cli-arg-file = NC program; “-” reads standard input
cli-arg-control = Control, such as tnc640
cli-arg-lang = Language, such as fi (default: that of the program’s own texts)
cli-arg-scene = Scene file: machine, tools, workpiece
cli-arg-resolution = Greatest distance between the columns of the stock, mm (default: a two-hundredth of its greatest extent)
cli-arg-format = Form of the output: text (default), json
cli-arg-report = Form of the output: text (default), json, junit
cli-arg-data = Directory with cycle-specs, locales and templates to use instead of the built-in ones
cli-arg-ui-lang = Language of the program's own texts (default: that of the environment)
cli-arg-help = Show this help
cli-arg-version = Show the version

cli-examples-build =
    ciklo build
    ciklo build --out manuals --control tnc640 --lang fi --lang sl
cli-examples-dialog =
    ciklo dialog 412 --control tnc640 --lang fi
    ciklo dialog TCH PROBE 0 --control tnc320 --lang it --format json
cli-examples-block =
    ciklo block 200 Q201=-30 Q202=5 --control tnc640 --lang sl
    ciklo block CYCL DEF 7 --control tnc640 --lang fi --number 13
cli-examples-parse =
    ciklo parse part.h
    ciklo parse part.h --print > copy.h
cli-examples-check =
    ciklo check part.h --control tnc640
    ciklo check programs --control itnc530 --format sarif > findings.sarif
    ciklo check programs --fix
cli-examples-translate =
    ciklo translate part.h --to it > pezzo.h
    ciklo translate part.h --to pt --control tnc426-430 --out peca.h
    ciklo translate teil.h --to en --relabel
cli-examples-run =
    ciklo run part.h --control tnc640
    ciklo run part.h --control tnc640 --scene part.scene.yaml --out results
    ciklo run part.h --control tnc640 --scene part.scene.yaml --events
    ciklo run part.h --control tnc640 --scene part.scene.yaml --stock part.stl --resolution 0.2
    ciklo run part.h --control tnc640 --scene part.scene.yaml --envelope
cli-examples-plot =
    ciklo plot part.h --control tnc640 --out part.svg
    ciklo plot part.h --control tnc640 --scene part.scene.yaml --view top --out path.svg
cli-examples-conform =
    ciklo conform
    ciklo conform --control tnc640 --cycle 200 --case three-infeeds
    ciklo conform --cycle "TCH PROBE 412" --list
    ciklo conform --control tnc320 --format junit > conform.xml
    ciklo conform --engine "my-engine --jsonl" --time-limit 5
cli-examples-coverage =
    ciklo coverage
    ciklo coverage --format json
cli-examples-lint =
    ciklo lint
    ciklo lint --data . --format json
    ciklo lint --only 200
    ciklo lint --summary
    ciklo lint --accept-translations
cli-examples-schema =
    ciklo schema > cycle.schema.json
cli-examples-explain =
    ciklo explain locale-missing-text
    ciklo explain
cli-examples-export =
    ciklo export --control tnc640 --lang sl > tnc640.json

cli-summary = { $errors ->
        [0] { $warnings ->
            [0] { $notes ->
                [0] Nothing found.
               *[other] No errors, no warnings.
            }
            [one] No errors, { $warnings } warning.
           *[other] No errors, { $warnings } warnings.
        }
        [one] { $errors } error, { $warnings ->
            [one] { $warnings } warning.
           *[other] { $warnings } warnings.
        }
       *[other] { $errors } errors, { $warnings ->
            [one] { $warnings } warning.
           *[other] { $warnings } warnings.
        }
    }
cli-written = Written: { $path }
cli-building = Pages
cli-built = { $pages } pages, { $files } files: { $path }
cli-coverage-control = { $control } ({ $title }): { $described } cycles described, { $named } named only
cli-coverage-complete = complete
cli-coverage-missing = { $language }: { $count } of { $of } texts missing: { $ids }
cli-coverage-stale = { $language }: { $count } of { $of } texts out of date: { $ids }
cli-coverage-unexecuted = Not executed by any example: { $count } of { $of } sentences: { $ids }
cli-coverage-unprovoked = Not triggered by any example: { $ids }

cli-translated = { $count ->
        [one] { $count } change: { $path }
       *[other] { $count } changes: { $path }
    }
cli-run-status = The program { $status ->
        [done] was executed to its end
        [stopped] stopped and was not continued
        [limit] reached a limit of the simulation
        [unsupported] needs a function that cannot be simulated
       *[error] ended with an error
    }.
cli-stock-time = Time: { $all } s; { $feed } s at feed rate, { $rapid } s at rapid traverse, { $dwell } s dwell time
cli-stock-length = Distance: { $feed } mm at feed rate, of which { $cut } mm in moves that remove material; { $rapid } mm at rapid traverse
cli-stock-volume = Volume: { $removed } mm³ removed of { $blank } mm³
cli-stock-depth = Greatest depth of a cut: { $value } mm (line { $line })
cli-stock-width = Greatest width of a cut: { $value } mm (line { $line })
cli-stock-rate = Greatest removal rate: { $value } mm³/min (line { $line })
cli-stock-finding = { $program }:{ $line }{ $count ->
        [one] :
       *[other] {" "}({ $count } moves):
    } { $kind ->
        [rapid-in-material] Rapid traverse through { $amount } mm of material.
        [spindle-stopped] The spindle is not turning while the tool moves through { $amount } mm of material.
        [edges-too-short] Material is cut up to { $amount } mm above the tool tip, beyond the length of the cutting edges.
        [turns-together] Rotary axes turn while the tool moves: the material removed is not known.
        [turned] The workpiece is turned, but it is not a body of revolution about the turning axis, or it was milled before: what tool { $amount } removes from it is not followed.
        [insert-unknown] No cycle says how the insert of tool { $amount } meets the workpiece: the material removed is not known.
        [thread-turned] Tool { $amount } turns a thread, which is not part of the body that is followed.
       *[no-radius] Tool { $amount } has no radius: the material removed is not known.
    }
cli-stock-more = { $count ->
        [one] { $count } more finding.
       *[other] { $count } more findings.
    }
cli-envelope-cycle = Line { $line }: { $cycle } { $name }
cli-envelope-still = No movement.
cli-envelope-lowest = Lowest point of the stylus tip: { $axis } = { $height } mm
cli-envelope-highest = Highest point of the stylus tip: { $axis } = { $height } mm
cli-envelope-travelled = Heights of movements in the working plane: { $axis } = { $heights } mm
cli-envelope-probing = { $count ->
        [one] { $count } probing
       *[other] { $count } probings
    }, the longest path { $length } mm
cli-envelope-near = { $what ->
        [stock] Raw material
       *[part] Part { $number }
    }: closest distance { $distance } mm, with the tip at X = { $x }, Y = { $y }, Z = { $z }; { $probed ->
        [yes] within
       *[no] out of
    } reach of the probing movements
cli-envelope-touches = { $what ->
        [stock] Raw material, as it is before machining: its inside is entered,
       *[part] Part { $number }: COLLISION,
    } with the tip at X = { $x }, Y = { $y }, Z = { $z }
cli-envelope-near-unknown = { $what ->
        [stock] Raw material
       *[part] Part { $number }
    }: the closest distance cannot be calculated; { $probed ->
        [yes] within
       *[no] out of
    } reach of the probing movements
cli-envelope-fails = In this scene the cycle ends with the error { $code }: { $message }
cli-envelope-none = The program executes no probing cycle.
cli-conform-pass = pass
cli-conform-fail = FAIL
cli-conform-out = out of subset
cli-conform-skipped = skipped
cli-conform-mismatch = { $what }: expected { $expected }, found { $found }
cli-conform-summary = { $pass } passed, { $fail } failed, { $out } out of subset, { $skipped } skipped.

cli-usage-hint = Perhaps { $suggestion }?
cli-usage-help = See --help.

diag-unknown-software = “{ $found }” is not a software version: enter the number that the control shows, such as 340590-05.
diag-usage = { $reason ->
        [no-value] { $subject } needs a value.
        [invalid-value] “{ $value }” is not a valid value for { $subject }.
        [unknown-argument] There is no argument { $subject }.
        [unknown-command] There is no command { $subject }.
        [no-command] A command is missing.
        [missing-argument] This is missing: { $subject }.
        [conflict] { $subject } occurs twice or cannot be combined with the other arguments.
        [too-many-values] { $subject } has too many values.
        [not-text] An argument is not valid text.
       *[other] The command line is wrong.
    } { $hint }
diag-io-read = { $path } cannot be read: { $reason ->
        [not-found] it does not exist
        [permission] permission is denied
        [is-directory] it is a directory
        [not-directory] it is not a directory
        [link] it is a link to a directory, which is not followed
       *[other] { $detail }
    }.
diag-io-write = { $path } cannot be written: { $reason ->
        [not-found] the directory does not exist
        [permission] permission is denied
        [is-directory] it is a directory
        [not-directory] a part of the path is not a directory
        [full] no space is left
        [read-only] the file system is read-only
        [too-large] a file may not be that large
       *[other] { $detail }
    }.
diag-engine-start = The engine “{ $path }” cannot be started: { $reason ->
        [not-found] there is no such program
        [permission] permission is denied
       *[other] { $detail }
    }.
diag-engine-not-responding = The engine did not answer { $silent } cases in a row, so the remaining ones are not sent: { $left ->
        [one] { $left } case.
       *[other] { $left } cases.
    }
diag-io-foreign-directory = { $path } contains files that Ciklo has not written, so it is not replaced. Choose an empty or a new directory.
diag-not-an-address = “{ $url }” is not an address that begins with https:// or http://.
diag-data-directory-missing = The directory { $name } is missing in { $path }.
diag-no-data = { $path } contains none of the directories cycle-specs, locales and templates.
diag-data-encoding = { $path } is not UTF-8.
diag-unknown-code = There is no code “{ $code }”; “ciklo explain” lists them all.
diag-needs-data = { $option } needs a working copy: --data DIR.
diag-unknown-control = There is no control “{ $control }”; the controls are { $known }.
diag-unknown-language = There is no language “{ $language }”; the languages are { $known }.
diag-cycle-name = “{ $cycle }” is not the number of a cycle; valid are, for example, 412 and "TCH PROBE 412".
diag-cycle-not-here = { $control } has no cycle { $cycle }.
diag-cycle-ambiguous = { $control } has two cycles with the number { $cycle }: { $keys }.
diag-cycle-only-named = The manual of { $control } only mentions { $cycle } ({ $name }) by name and does not describe it.
diag-internal = Internal error in Ciklo: { $detail }.
diag-locale-unknown-suffix = “{ $name }” is neither the name of a cycle nor a control.
diag-not-encodable = The character “{ $sign }” cannot be written in the encoding of this file (Windows-1252).
