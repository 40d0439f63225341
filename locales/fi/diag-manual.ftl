# What can go wrong while a manual is built; see the English file.

diag-manual-template = Mallia { $template } ei voi käyttää (rivi { $line }): { $reason }.
diag-manual-json = Tietoja ei voi kirjoittaa JSON-muotoon: { $reason }.
diag-manual-empty = Käsikirjaa varten ei ole ohjausta tai kieltä.
diag-manual-topic-missing = Aiheella { $topic } ei ole sivua kielellä { $language }.
diag-manual-topic-title = Aiheen { $topic } sivu kielellä { $language } ei ala otsikolla eli rivillä kuten "# Otsikko".
