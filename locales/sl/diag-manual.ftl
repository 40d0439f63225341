# What can go wrong while a manual is built; see the English file.

diag-manual-template = Predloge { $template } ni mogoče uporabiti (vrstica { $line }): { $reason }.
diag-manual-json = Podatkov ni mogoče zapisati v obliki JSON: { $reason }.
diag-manual-empty = Za priročnik ni nobenega krmiljenja ali jezika.
diag-manual-topic-missing = Tema { $topic } nima strani v jeziku { $language }.
diag-manual-topic-title = Stran teme { $topic } v jeziku { $language } se ne začne z naslovom, torej z vrstico, kot je "# Naslov".
