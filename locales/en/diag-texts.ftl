diag-texts-nothing-chosen = Say what is to be accepted: --text KEY, --changed or --all.
diag-texts-unknown-key = No translation has a text with the key “{ $key }”.
diag-locale-same-as-source = The text “{ $key }” in the language “{ $language }” is the same as in English.
