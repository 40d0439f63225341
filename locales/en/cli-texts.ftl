# The command “texts”.
cli-texts = Show how far the translations are, accept them, and exchange them with translators
cli-texts-action = What is to be done: status shows what is open, accept records translations as matching their English texts, export writes a file for translators, import takes one back
cli-texts-input = import: the file of the translator, XLIFF or PO
cli-texts-lang = Only this language; may be repeated
cli-texts-file = status: only this file of the language, such as drilling.ftl; may be repeated
cli-texts-text = accept: the text with this key, or all whose keys begin like KEY if it ends in *; may be repeated
cli-texts-changed = accept: translations that are new or were changed since they were accepted
cli-texts-all = accept: all translations, also those whose English has changed and that have not
cli-texts-to = export: the language to translate into; import: the language of the file (default: what the file says)
cli-texts-stale = export: only texts that are stale or not accepted; with --missing, both
cli-texts-missing = export: only texts that are missing; with --stale, both
cli-texts-cycle = export: only the texts of this cycle; may be repeated
cli-texts-out = export: file to write (default: standard output)
cli-texts-dry-run = import: check the file and report, change nothing
cli-texts-format = Form of the output: text (default), json; of export: xliff (1.2, default), xliff2 (2.0), po
cli-texts-exported = { $count ->
        [one] { $count } unit exported.
       *[other] { $count } units exported.
    }
cli-texts-imported = { $language }: { $dry ->
        [yes] to take over { $taken }
       *[no] taken over { $taken }
    }, unchanged { $unchanged }, not final { $open }, refused { $refused }.
cli-texts-count = { $name }: { $translated } of { $texts } translated, { $missing } missing, { $stale } stale, { $unaccepted } not accepted, { $same } same as English, { $long } too long, { $words } words to do
cli-texts-accepted = { $language }: { $count ->
        [one] { $count } text accepted.
       *[other] { $count } texts accepted.
    }
cli-texts-left = { $language }: not accepted because the English has changed and the translation has not: { $keys }. To accept one as it is, name it with “ciklo texts accept --text KEY”.
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
