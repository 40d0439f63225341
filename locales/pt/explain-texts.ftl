explain-locale-same-as-source =
    Uma cópia do texto inglês parece uma tradução, mas não é. Traduza o texto. Se as palavras forem iguais nos dois idiomas, ou não pertencerem a nenhum idioma, acrescente-as, ou a chave do texto, à lista same-as-source.txt do idioma.
explain-texts-nothing-chosen =
    Aceitar uma tradução significa declarar que corresponde ao texto inglês atual; por isso nunca se aceitam textos que ninguém reviu. Indique os textos ou aceite com --changed aqueles cuja tradução foi alterada.
explain-texts-unknown-key =
    Só podem ser aceites textos que existam no idioma. «ciklo texts status» indica as chaves dos que estão pendentes.
