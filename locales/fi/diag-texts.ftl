diag-texts-nothing-chosen = Ilmoita, mitä hyväksytään: --text KEY, --changed tai --all.
diag-texts-unknown-key = Missään käännöksessä ei ole tekstiä, jonka avain on ”{ $key }”.
diag-locale-same-as-source = Teksti ”{ $key }” on kielellä ”{ $language }” sama kuin englanniksi.
