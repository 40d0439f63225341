# What can go wrong while a manual is built; see the English file.

diag-manual-template = O modelo { $template } não pode ser utilizado (linha { $line }): { $reason }.
diag-manual-json = Não é possível escrever os dados em formato JSON: { $reason }.
diag-manual-empty = Não há nenhum comando ou idioma para o qual criar o manual.
diag-manual-topic-missing = O tema { $topic } não tem página no idioma { $language }.
diag-manual-topic-title = A página do tema { $topic } no idioma { $language } não começa com um título, ou seja, uma linha como "# Título".
