diag-texts-nothing-chosen = Say what is to be accepted: --text KEY, --changed or --all.
diag-texts-unknown-key = No translation has a text with the key “{ $key }”.
diag-locale-same-as-source = The text “{ $key }” in the language “{ $language }” is the same as in English.
diag-texts-no-file = “texts import” needs the file that is to be read.
diag-texts-no-language = “{ $language }” is not a language to translate into; name it with --to, as in “--to fi”.
diag-texts-file-unreadable = The file cannot be read: { $reason ->
        [document-type] document types and entities of their own are not accepted
        [entity] there is an unknown entity
        [encoding] the encoding is not UTF-8
        [depth] the elements are nested too deeply
        [columns] the table lacks the columns concept and language
        [empty] the file is empty
        [quote] a cell in quotation marks begins here and does not end
        [size] it is larger than 64 MB
        [xliff] this is neither XLIFF 1.2 nor XLIFF 2.0
       *[form] the form is wrong from here on
    }.
diag-texts-unit-unknown = There is no text for the unit “{ $key }”.
diag-texts-unit-twice = The unit “{ $key }” is in the file several times.
diag-texts-unit-source-changed = The source of the unit “{ $key }” is not that of today: export the text again.
diag-texts-unit-not-read = The unit “{ $key }” has no translation, or one with elements that are not known here.
diag-texts-unit-codes = The codes of the unit “{ $key }” do not match: missing { $missing }, not allowed { $foreign }.
diag-texts-unit-exchanged = In the unit “{ $key }” codes have changed places among the same words.
diag-texts-unit-incomplete = The unit “{ $key }” is one of several variants of a new text; the others are missing or refused.
diag-texts-unit-refused = The unit “{ $key }” is refused ({ $code }): { $finding }
diag-texts-unit-markup = The translation of the unit “{ $key }” would change the form of the page: its marks or the blocks around it.
diag-texts-unit-numbers = The numbers of the unit “{ $key }” differ from those of the source: missing { $missing }, not in the source { $foreign }.
diag-texts-unknown-topic = There is no page of prose “{ $topic }”.
diag-draft-language = A draft is of one language: name it with --lang, as in “--draft --lang de”.
diag-texts-unit-swapped = The units “{ $key }” and “{ $other }” have got the words of each other.
diag-texts-unit-negation = In the unit “{ $key }” a word that denies was taken out, so the text says the opposite.
