# Mensagens da verificação e da tradução de programas; ver o ficheiro inglês.

diag-call-of-def-active-cycle = { $cycle } actua logo que é definido; não deve ser chamado.
    .explain = Os padrões de pontos, as conversões de coordenadas e os ciclos de apalpação actuam ao serem definidos. Uma chamada depois deles é um erro se antes não estiver definido nenhum ciclo de maquinação, ou se vier directamente a seguir a um padrão, que já chamou o ciclo de maquinação.
diag-called-but-not-defined = Aqui é chamado um ciclo, mas antes não está definido nenhum.
    .explain = CYCL CALL, M99 e M89 executam o ciclo de maquinação definido em último lugar. Sem definição não há nada para executar. Nos programas com saltos, sub-programas ou blocos omitidos só se indica se não houver nenhum ciclo definido, e nunca se forem chamados outros programas.
diag-choice-not-offered = { $parameter }={ $value } não está entre as opções: { $offered }.
    .explain = O parâmetro oferece uma escolha de valores, cada um com o seu significado, e este não é nenhum deles. Exemplo: Q215=3 em CYCL DEF 251.
diag-cycle-not-described = { $cycle } ({ $name }) é mencionado nos manuais mas não descrito: os seus parâmetros não são verificados.
    .explain = O comando dispõe do ciclo, mas aqui não há especificação que o descreva. Os seus parâmetros, textos e efeito não são considerados.
diag-cycle-not-on-control = { $cycle } não existe no comando { $control }; existe em: { $controls }.
    .explain = Os manuais deste comando não conhecem o ciclo, os de outro conhecem. O programa foi escrito para esse outro comando, ou foi escolhido com --control o comando errado.
diag-defined-but-never-called = { $cycle } é definido aqui e nunca é chamado.
    .explain = O ciclo actua quando é chamado com CYCL CALL, M99 ou M89, ou por um padrão de pontos, e nada disso se segue antes do próximo ciclo desse tipo ou do fim. A definição não tem efeito, ou a chamada foi esquecida.
diag-duplicate-parameter = { $parameter } aparece duas vezes em { $cycle }.
    .explain = A definição dá dois valores ao mesmo parâmetro ou campo; não se pode dizer qual é o pretendido.
diag-guard = O comando não aceita estes valores.
    .explain = As especificações dizem em que condições um comando recusa um ciclo, o omite, avisa ou pergunta. Cada uma dessas condições tem um código próprio; só é verificada com valores que o programa escreve como números ou textos.
diag-label-missing = A língua «{ $language }» não tem texto para { $parameter } de { $cycle }.
    .explain = O programa não pode ser escrito inteiramente nesta língua: um texto das especificações ainda não está traduzido. O texto anterior mantém-se. O comando ciklo coverage lista o que falta.
diag-label-not-encodable = «{ $label }» tem o carácter «{ $character }», que a codificação do ficheiro não pode escrever.
    .explain = O programa não é um ficheiro UTF-8 e a sua codificação (Windows-1252) não tem um carácter do novo texto. Converta primeiro o ficheiro para UTF-8, se o comando o ler.
diag-label-of-another-language = «{ $label }» é um texto noutra língua ({ $language }); na língua do programa o texto de { $parameter } é «{ $right }».
    .explain = A maioria dos textos do programa está numa língua, este está noutra. O comando ciklo translate escreve-os todos numa só língua.
diag-label-of-another-parameter = «{ $label }» é o texto de { $other }, não de { $parameter }.
    .explain = O comentário atrás do valor é o texto de outro parâmetro do mesmo ciclo. O comando lê apenas o número, mas o valor pode estar destinado ao outro parâmetro. Os textos que não existem em nenhuma língua não são considerados.
diag-misordered-parameter = Em { $cycle }, o comando visualiza { $parameter } antes de { $before }.
    .explain = O comando reconhece os parâmetros pelo número e aceita outra ordem, mas dificilmente a definição foi criada num comando. É indicado o primeiro parâmetro fora de ordem.
diag-missing-parameter = Em { $cycle } falta { $parameter }.
    .explain = O manual do comando indica para o ciclo um parâmetro ou campo que a definição não tem. As definições com uma linha ilegível não são consideradas. Exemplo: CYCL DEF 247 sem Q339.
diag-out-of-range =
    { $side ->
        [below] { $parameter }={ $value } é demasiado pequeno: o valor mínimo é { $limit }.
        [long] O texto de { $parameter } é demasiado longo: são permitidos { $limit } caracteres.
       *[above] { $parameter }={ $value } é demasiado grande: o valor máximo é { $limit }.
    }
    .explain = O manual do comando indica para o parâmetro um campo de introdução, e o valor está fora dele. Os campos valem só para este comando; onde o manual não os indica, nada é verificado. Nos programas em polegadas não se verificam longitudes nem avanços. Exemplo: Q202=-5.
diag-spindle-off = Aqui é chamado um ciclo de maquinação com a ferramenta parada.
    .explain = Nada ligou a ferramenta (M3, M4, M13, M14), ou ela foi parada entretanto (M0, M5, M6). Depois de uma chamada da ferramenta e de funções M do fabricante nada se indica. Indicado uma vez por programa.
diag-tool-missing = Aqui um ciclo desloca-se, mas antes nenhuma chamada da ferramenta indicou o eixo da ferramenta.
    .explain = Os ciclos precisam do eixo da ferramenta, que TOOL CALL indica: TOOL CALL 5 Z S2000. Indicado uma vez por programa.
diag-unknown-cycle = { $cycle } não é um ciclo de nenhum comando aqui conhecido.
    .explain = O número não corresponde a nenhum ciclo nos manuais em que as especificações se baseiam, nem a um ciclo do fabricante da máquina (300 a 399, 500 a 599). Verifique a palavra-chave e o número: CYCL DEF 32 e TCH PROBE 32 são ciclos diferentes. Exemplo: CYCL DEF 299.
diag-unknown-parameter = Neste comando, { $cycle } não tem o parâmetro { $parameter }.
    .explain = O parâmetro ou campo não está entre os que o manual do comando indica para o ciclo. Pertence a outro ciclo ou a outro comando, ou o número está errado. Exemplo: Q999 em CYCL DEF 247.
diag-wrong-value-kind =
    O parâmetro { $parameter } de { $cycle } aceita { $kind ->
        [integer] um número inteiro
        [number-or-name] um número ou um nome entre aspas
        [text] um texto entre aspas
        [q-number] um parâmetro Q
        [axis-direction] um eixo com sinal, por exemplo X-
        [position] coordenadas por eixo, por exemplo X+5 Y+0
        [row] uma linha da tabela, por exemplo #5
        [axis] um eixo
       *[number] um número
    }{ $words-count ->
        [0] {""}
       *[other] {" "}ou { $words }
    }.
    .explain = O valor é de um tipo que o parâmetro não aceita: um texto em vez de um número, um número com decimais onde é preciso um inteiro, uma palavra que o manual não prevê, ou nada. Um parâmetro Q é sempre admitido. Exemplo: Q201=FAUTO.
