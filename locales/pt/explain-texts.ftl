explain-locale-same-as-source =
    Uma cópia do texto inglês parece uma tradução, mas não é. Traduza o texto. Se as palavras forem iguais nos dois idiomas, ou não pertencerem a nenhum idioma, acrescente-as, ou a chave do texto, à lista same-as-source.txt do idioma.
explain-texts-nothing-chosen =
    Aceitar uma tradução significa declarar que corresponde ao texto inglês atual; por isso nunca se aceitam textos que ninguém reviu. Indique os textos ou aceite com --changed aqueles cuja tradução foi alterada.
explain-texts-unknown-key =
    Só podem ser aceites textos que existam no idioma. «ciklo texts status» indica as chaves dos que estão pendentes.
explain-texts-no-file =
    «ciklo texts import» lê um ficheiro em que um tradutor trabalhou: XLIFF ou PO, tal como «ciklo texts export» o escreve. Indique-o depois do comando, por exemplo «ciklo texts import fi.xlf».
explain-texts-no-language =
    Os textos são traduzidos do inglês para um idioma com um código como fi ou de-AT. O inglês não pode ser o idioma de chegada, e um nome com outros sinais além de letras, algarismos e hífenes não poderia ser uma pasta em locales. Indique o idioma com --to. Um ficheiro que regressa geralmente já o indica.
explain-texts-file-unreadable =
    O ficheiro é recusado na totalidade e nada é alterado. Leem-se XLIFF 1.2, XLIFF 2.0 e PO em UTF-8, e termos em TBX ou CSV. Se um de vários ficheiros não se puder ler, nenhum é aplicado. Declarações de tipo de documento e entidades próprias são recusadas porque podem ir buscar outros ficheiros ou crescer sem fim; pela mesma razão recusa-se um encaixe demasiado profundo de elementos. Verifique o local indicado, ou exporte os textos de novo e guarde-os na mesma forma com a ferramenta de tradução.
explain-texts-unit-unknown =
    O identificador de uma unidade é a chave de um texto, e nenhum texto do idioma tem esta chave. Foi mudada ou eliminada desde a exportação, ou o identificador foi alterado no ficheiro. Exporte de novo; uma memória de tradução encontra a tradução já feita pelas palavras. Um termo novo do glossário escreve-se primeiro em locales/en/glossary.ftl; depois podem importar-se as traduções.
explain-texts-unit-twice =
    Duas unidades com o mesmo identificador poderiam dizer coisas diferentes, e nada indica qual é a certa. Nenhuma delas é adotada. Elimine todas menos uma.
explain-texts-unit-source-changed =
    O texto inglês foi alterado depois da exportação do ficheiro, por isso a tradução no ficheiro pode dizer algo que já não é verdade. A unidade não é adotada; as outras são-no. Exporte o texto de novo: as primeiras notas mostram que palavras mudaram.
explain-texts-unit-not-read =
    Uma unidade definitiva precisa de uma tradução composta de palavras e dos códigos que foram exportados. Esta não tem texto, ou contém elementos que o ficheiro exportado não tinha. Elimine-os, ou dê à unidade um estado não definitivo até estar traduzida.
explain-texts-unit-codes =
    Os códigos estão no lugar de valores, termos e escolhas que o programa preenche. Uma tradução pode mudar a sua ordem e escolher a forma de um termo, como em { "{ -probe(case: \"genitive\") }" }, mas precisa dos códigos do texto de partida e de nenhum outro: um código em falta faria perder um dado, por exemplo uma profundidade ou um parâmetro. Reponha os que faltam e elimine os que não são permitidos.
explain-texts-unit-exchanged =
    As palavras da tradução são as de hoje e só os códigos estão noutros lugares, por isso cada valor seria dito de outra coisa. Reponha os códigos no lugar. Se a nova ordem estiver certa, altere também as palavras ou edite o ficheiro Fluent.
explain-texts-unit-incomplete =
    Um texto novo com variantes, por exemplo para um e para vários furos, só está completo quando existem todas as variantes: uma em falta deixaria uma lacuna nas frases. Traduza todas as unidades cujo identificador começa com a mesma chave e torne-as definitivas.
explain-texts-unit-refused =
    Cada unidade é verificada como «ciklo lint» verifica os textos do idioma: sintaxe, termos e as suas formas, os mesmos números, unidades e argumentos que nos outros idiomas, maiúsculas, caracteres e comprimento das designações. Esta unidade acrescentaria a ocorrência citada. «ciklo explain» com o código entre parênteses diz mais sobre ela. Corrija a unidade e importe o ficheiro de novo; as unidades já adotadas ficam então inalteradas.
explain-texts-unit-markup =
    Uma página de prosa mantém a forma do texto de partida: os mesmos títulos, parágrafos, itens e células, com ligações e realces em redor das palavras que o tradutor escolhe. Uma marca que abre tem de fechar, e sinais como * ou | dentro de palavras não podem iniciar nada de novo. O Ciklo já tentou escrever esses sinais com uma barra invertida. Reponha os códigos aos pares e importe a unidade de novo.
explain-texts-unit-numbers =
    Números e palavras com algarismos, como 0.5, Q200 ou M99, são factos: a tradução de uma página tem os mesmos que o texto de partida. O separador decimal pode ser o do idioma. Onde o texto de partida escreve um número por extenso, a tradução faz o mesmo. Compare os dois textos e corrija o que está errado.
explain-texts-unknown-topic =
    As páginas de prosa são ficheiros em locales/en/topics; o nome do ficheiro sem «.md» é o tema, por exemplo sl-cycles. Sem --topic exportam-se todos os textos, incluindo as páginas.
explain-draft-language =
    Um rascunho preenche com inglês as lacunas de um idioma em preparação, para que as páginas possam ser lidas antes de tudo estar traduzido. É de um só idioma, para que um idioma terminado nunca apareça por engano como rascunho. O idioma ainda não precisa de ter uma pasta. Sem --draft, uma página a que falta um texto é recusada.
explain-texts-unit-swapped =
    De duas opções ou de dois resultados, cada um tem no ficheiro as palavras que hoje são do outro, e quem lê introduziria o valor errado. Nenhum dos dois é adotado. Reponha as palavras. Se as que estão trocadas são as de hoje, corrija-as no ficheiro Fluent.
explain-texts-unit-negation =
    O texto inglês nega alguma coisa, e a tradução no ficheiro é a de hoje sem uma palavra como «não» ou «nem». Permitiria o que é proibido, ou diria que aconteceu o que não aconteceu. Reponha a palavra. Se a frase nega de outro modo, escreva-a assim; se a palavra estava errada, retire-a no ficheiro Fluent.
