explain-locale-same-as-source =
    A copy of the English text looks like a translation and is none. Translate it. If the words are the same in both languages, or are no words of a language, add them or the key of the text to the list same-as-source.txt of the language.
explain-texts-nothing-chosen =
    Accepting a translation says that it matches the English text of today, so it is never done for texts that nobody has looked at. Name the texts, or accept with --changed those whose translation you have edited.
explain-texts-unknown-key =
    Only texts that the language has can be accepted. “ciklo texts status” lists the keys of those that are open.
