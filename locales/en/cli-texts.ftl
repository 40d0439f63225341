# The command “texts”.
cli-texts = Show how far the translations are, accept them, and exchange them with translators
cli-texts-action = What is to be done: status shows what is open, accept records translations as matching their English texts, export writes a file for translators, import takes one back
cli-texts-input = import: the files of translators, XLIFF or PO, or terms as TBX or CSV; several are imported together
cli-texts-lang = Only this language; may be repeated
cli-texts-file = status: only this file of the language, such as drilling.ftl; may be repeated
cli-texts-text = accept: the text with this key, or all whose keys begin like KEY if it ends in *; may be repeated
cli-texts-changed = accept: translations that are new or were changed since they were accepted
cli-texts-all = accept: all translations, also those whose English has changed and that have not
cli-texts-to = export: the language to translate into; import: the language of the file (default: what the file says)
cli-texts-stale = export: only texts that are stale or not accepted; with --missing, both
cli-texts-missing = export: only texts that are missing; with --stale, both
cli-texts-cycle = export: only the texts of this cycle; may be repeated
cli-texts-copy-source = export: put the English where a translation is missing; for tools that translate in place
cli-texts-out = export: file to write (default: standard output)
cli-texts-any-state = import: take every unit with a translation for final; for tools that keep no states
cli-texts-dry-run = import: check the file and report, change nothing
cli-texts-format = Form of the output: text (default), json; of export: xliff (1.2, default), xliff2 (2.0), po, tmx (accepted texts of all languages), tbx and csv (glossary and parameters)
cli-texts-exported = { $count ->
        [one] { $count } unit exported.
       *[other] { $count } units exported.
    }
cli-texts-imported = { $language }: { $dry ->
        [yes] to take over { $taken }
       *[no] imported { $taken }
    }, unchanged { $unchanged }, not final { $open }, refused { $refused }.
cli-texts-count = { $name }: { $translated } of { $texts } translated, { $missing } missing, { $stale } stale, { $unaccepted } not accepted, { $same } same as English, { $long } too long, { $words } words to do
cli-texts-group = group { $name }
cli-texts-accepted = { $language }: { $count ->
        [one] { $count } text accepted.
       *[other] { $count } texts accepted.
    }
cli-texts-left = { $language }: not accepted because the English has changed and the translation has not: { $keys }. To accept one as it is, name it with “ciklo texts accept --text KEY”.
cli-texts-moved = { $language }: not accepted because they now have the words of other texts: { $keys }. To accept one as it is, name it with “ciklo texts accept --text KEY”.
cli-texts-new = { $language }: not accepted because they are new: { $keys }. “ciklo texts accept --changed” accepts them.
cli-texts-open =
    { $state ->
        [missing] missing: { $key } ({ $file })
        [stale] { $change ->
            [none] stale: { $key } ({ $file })
           *[other] stale: { $key } ({ $file }): { $change }
        }
        [unaccepted] not accepted: { $key } ({ $file })
       *[same] same as English: { $key } ({ $file })
    }
cli-texts-more = { $count ->
        [one] and { $count } more
       *[other] and { $count } more
    }
cli-examples-texts =
    ciklo texts status
    ciklo texts status --lang fi --file drilling.ftl --format json
    ciklo texts accept --changed
    ciklo texts accept --lang it --text step-approach
    ciklo texts export --to fi --stale --missing --out fi.xlf
    ciklo texts import fi.xlf --dry-run
    ciklo texts export --format tbx --out terms.tbx
cli-texts-topic = export: only the page of this topic; may be repeated
cli-texts-base-url = export: the address of the built site, for the links to pages in the notes
# What a translator is told about a text.
cli-texts-note-kind = This is { $kind ->
        [inserted] a word that other texts insert, with the cases that they ask for
        [topic] a segment of a page of prose
        [group] the name of a group of cycles
        [cycle] the name of a cycle
        [parameter] the name of a parameter
        [step] a sentence of the run of a cycle
        [until] a condition on which a repetition ends
        [condition] a condition, completing “only if”
        [choice] a choice of a parameter
        [result] a result of a cycle
        [note] a note on a cycle
        [guard] why a control refuses a cycle
        [message] a message of the control to the operator
        [figure] the title of a figure
        [form] the name of a form of the block of a cycle
        [table] the title of a table
        [title] the title of an example
        [comment] a comment in a worked program
        [term] a term of the glossary
        [log] a line of a log that a cycle writes
        [diagnostic] a finding of the program
        [explanation] what the program says about a finding when asked
        [gap] a word in place of an argument
        [command] help or a message of a command
        [unit] a unit
        [list] how a list is joined
        [page] a word of the pages of the manual
        [label] the comment after a parameter in NC programs
        [nc] the name of the cycle in NC programs
        [word] the printed word of a field in NC programs
        [help] what a parameter means
        [purpose] what a cycle is for
        [definition] the definition of a term
        [prompt] the question of the dialog
        [symbol] the symbol of a unit
       *[other] a text of the program
    }.
cli-texts-note-unit = Unit: { $unit }.
cli-texts-note-range = Permitted range: { $range } ({ $controls }).
cli-texts-note-label = At most { $most } characters: capitals, digits, spaces and { $signs }
cli-texts-note-capitals = Only capitals, digits, spaces and { $signs }
cli-texts-note-length = At most { $most } characters
cli-texts-note-cycles = { $more ->
        [none] { $control }: { $cycles }
       *[other] { $control }: { $cycles } and { $more } more
    }
cli-texts-note-lines = Source in the manuals of the { $control }, { $cycle }: { $lines }.
cli-texts-note-page = Page: { $page }
# Languages in the making, and the pseudo-language.
cli-build-draft = Build one language that is not complete: what is missing is in English, marked, and every page says so
cli-draft = { $language }: { $count } texts are missing; they are in English, in ⟦ ⟧.
cli-arg-pseudo = Show texts in a pseudo-language, to see what is cut or not translated: accents (longer words with accents) or bidi (also from right to left)
