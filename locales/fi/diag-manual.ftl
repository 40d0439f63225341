# What can go wrong while a manual is built; see the English file.

diag-manual-template = Mallia { $template } ei voi käyttää (rivi { $line }): { $reason }.
diag-manual-json = Tietoja ei voi kirjoittaa JSON-muotoon: { $reason }.
diag-manual-empty = Käsikirjaa varten ei ole ohjausta tai kieltä.
