diag-texts-nothing-chosen = Navedite, kaj naj se potrdi: --text KEY, --changed ali --all.
diag-texts-unknown-key = Noben prevod nima besedila s ključem »{ $key }«.
diag-locale-same-as-source = Besedilo »{ $key }« v jeziku »{ $language }« je enako angleškemu.
