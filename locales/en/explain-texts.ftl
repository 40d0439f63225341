explain-locale-same-as-source =
    A copy of the English text looks like a translation and is none. Translate it. If the words are the same in both languages, or are no words of a language, add them or the key of the text to the list same-as-source.txt of the language.
explain-texts-nothing-chosen =
    Accepting a translation says that it matches the English text of today, so it is never done for texts that nobody has looked at. Name the texts, or accept with --changed those whose translation you have edited.
explain-texts-unknown-key =
    Only texts that the language has can be accepted. “ciklo texts status” lists the keys of those that are open.
explain-texts-no-file =
    “ciklo texts import” takes a file that a translator has worked on: XLIFF or PO, as “ciklo texts export” writes it. Name it after the command, for example “ciklo texts import fi.xlf”.
explain-texts-no-language =
    Texts are translated from English into a language with a tag such as fi or de-AT. English itself is no target, and a name with other signs than letters, digits and hyphens could not be a folder below locales. Name the language with --to. A file that comes back usually names it itself.
explain-texts-file-unreadable =
    The file is refused as a whole, and nothing is changed. XLIFF 1.2, XLIFF 2.0 and PO in UTF-8 are read, and terms as TBX or CSV. Of several files, none is imported if one cannot be read. Document types and entities of their own are refused because they can fetch other files or grow without end; a deep nesting of elements is refused for the same reason. Look at the place that is named, or export the texts again and let the translation tool save them in the same form.
explain-texts-unit-unknown =
    The identifier of a unit is the key of a text, and no text of the language has this key. It was renamed or removed since the file was exported, or the identifier was changed in the file. Export again; a translation memory finds the finished translation by its words. A new term of the glossary is written in locales/en/glossary.ftl first; then its translations can be imported.
explain-texts-unit-twice =
    Two units with the same identifier could say different things, and nothing says which of them is right. None of them is imported. Remove all but one.
explain-texts-unit-source-changed =
    The English text was edited after the file was exported, so the translation in the file may say something that is no longer true. The unit is left out; the others are imported. Export the text again: the first notes show which words have changed.
explain-texts-unit-not-read =
    A final unit needs a translation that consists of words and of the codes that were exported. This one has no text, or it contains inline elements that the exported file did not have. Remove them, or set the unit to a state that is not final until it is translated.
explain-texts-unit-codes =
    Codes stand for values, terms and selections that the program fills in. A translation may put them in another order and choose the case of a term, as in { "{ -probe(case: \"genitive\") }" }, but it needs the codes of its source and has no others: a missing code would lose a fact such as a depth or a parameter. Put the missing ones back and remove those that are not allowed.
explain-texts-unit-exchanged =
    The words of the translation are those of today, and only the codes are in different places, so each value would belong to something else. Put the codes back. If the new order is right, change the words as well, or edit the Fluent file.
explain-texts-unit-incomplete =
    A new text with variants, for example for one and for several holes, is only complete when all variants are there: a missing one would leave a gap in sentences. Translate all units whose identifiers begin with the same key and set them to a final state.
explain-texts-unit-refused =
    Each unit is checked as “ciklo lint” checks the texts of the language: syntax, terms and their cases, numbers, units and arguments as in the other languages, capitals, characters and length of labels. This unit would add the finding that is quoted. “ciklo explain” with the code in parentheses says more about it. Correct the unit and import the file again; units that were taken over already are then unchanged.
explain-texts-unit-markup =
    A page of prose keeps the form of its source: as many headings, paragraphs, items and cells, with links and emphasis around the words that the translator chooses. A mark that opens must close, and signs such as * or | inside of words must not begin something new. Ciklo has already tried to write such signs with a backslash. Put the codes back in pairs and import the unit again.
explain-texts-unit-numbers =
    Numbers and words with digits, such as 0.5, Q200 or M99, are facts: a translation of a page has the same as its source. The decimal sign may be that of the language. Where the source writes a number as a word, the translation does the same. Compare both and correct the one that is wrong.
explain-texts-unknown-topic =
    Pages of prose are files below locales/en/topics; the name of the file without “.md” is the topic, for example sl-cycles. Without --topic all texts are exported, pages included.
explain-draft-language =
    A draft fills the gaps of a language in the making with English, so that its pages can be read before everything is translated. It is of one language, so that a finished one is never shown as a draft by mistake. The language need not have a folder yet. Without --draft, a page that lacks a text is refused.
explain-texts-unit-swapped =
    Of two choices or results, each has the words in the file that the other one has today, so readers would enter the wrong value. Neither is taken over. Put the words back. If it is today’s words that are exchanged, change them in the Fluent file.
explain-texts-unit-negation =
    The English text denies something, and the translation in the file is that of today without a word such as “not” or “nor”. It would allow what is forbidden, or report what did not happen. Put the word back. If the sentence denies in another way, write it so; if the word was wrong, remove it in the Fluent file.
