# Mensagens da verificação e da tradução de programas; ver o ficheiro inglês.

diag-call-of-def-active-cycle = { $cycle } atua logo que é definido; não deve ser chamado.
diag-called-but-not-defined = Aqui é chamado um ciclo, mas antes não está definido nenhum.
diag-choice-not-offered = { $parameter }={ $value } não está entre as opções: { $offered }.
diag-clearance-height-too-low = { $cycle } apalpa em { $touched }: a altura segura { $parameter }={ $value } tem de ficar acima de { $least }.
diag-cycle-not-described = { $cycle } ({ $name }) é mencionado nos manuais mas não descrito: os seus parâmetros não são verificados.
diag-cycle-not-on-control = { $cycle } não existe no comando { $control }; existe em: { $controls }.
diag-defined-but-never-called = { $cycle } é definido aqui e nunca é chamado.
diag-duplicate-parameter = { $parameter } aparece duas vezes em { $cycle }.
diag-guard = O comando não aceita estes valores.
diag-label-missing = O idioma «{ $language }» não tem designação para { $parameter } de { $cycle }.
diag-label-not-encodable = «{ $label }» tem o carácter «{ $character }», que a codificação do ficheiro não pode escrever.
diag-label-of-another-language = «{ $label }» é uma designação noutro idioma ({ $language }); a maior parte do programa designa { $parameter } por «{ $right }».
diag-label-of-another-parameter = «{ $label }» é a designação de { $other }, não de { $parameter }.
diag-misordered-parameter = Em { $cycle }, o comando visualiza { $parameter } antes de { $before }.
diag-missing-parameter = Em { $cycle } falta { $parameter }.
diag-out-of-range =
    { $side ->
        [below] { $parameter }={ $value } é demasiado pequeno: o valor mínimo é { $limit }.
        [long] O texto de { $parameter } é demasiado longo: são permitidos { $limit } caracteres.
        [many] { $parameter } indica labels a mais: são permitidos { $limit }.
       *[above] { $parameter }={ $value } é demasiado grande: o valor máximo é { $limit }.
    }
diag-spindle-off = Aqui é chamado um ciclo de maquinação com o cabeçote parado.
diag-tool-missing = Aqui um ciclo executa movimentos, mas antes nenhuma chamada da ferramenta indicou o eixo da ferramenta.
diag-unknown-cycle = { $cycle } não é um ciclo de nenhum comando aqui conhecido.
diag-unknown-parameter = Neste comando, { $cycle } não tem o parâmetro { $parameter }.
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
        [label-list] números de labels separados por barras, por exemplo 1/2/3
       *[number] um número
    }{ $words-count ->
        [0] {""}
       *[other] {" "}ou { $words }
    }.
