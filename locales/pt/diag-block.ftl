# Values that a block cannot have, and labels that a control cannot print; see the English file.

diag-block-unknown-form = { $cycle } não tem a forma «{ $form }». Formas disponíveis: { $forms }.
diag-block-unknown-parameter = { $cycle } não tem o parâmetro «{ $name }». Parâmetros disponíveis: { $known }.
diag-block-duplicate-parameter = { $name } está indicado duas vezes.
diag-block-wrong-kind =
    { $name } ({ $parameter }) não pode ser «{ $value }»; valor esperado: { $kind ->
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
    }.
diag-block-below-minimum = { $name } ({ $parameter }) não pode ser { $value }: o valor mínimo é { $min }.
diag-block-above-maximum = { $name } ({ $parameter }) não pode ser { $value }: o valor máximo é { $max }.
diag-block-too-long =
    { $kind ->
        [label-list] { $name } ({ $parameter }) não pode ser { $value }: são permitidos no máximo { $most } labels.
        [axes] { $name } ({ $parameter }) não pode ser { $value }: são permitidos no máximo { $most } eixos.
       *[text] { $name } ({ $parameter }) não pode ser { $value }: são permitidos no máximo { $most } caracteres.
    }
diag-block-not-offered = { $name } ({ $parameter }) não pode ser { $value }: os valores possíveis são { $offered }.
diag-block-no-value = { $cycle } precisa de um valor para { $name }; o manual não apresenta nenhum exemplo.
diag-label-character = A designação «{ $label }» de { $cycle } ({ $control }, { $language }) contém o carácter «{ $character }», que o comando não consegue mostrar.
diag-label-lower-case = A designação «{ $label }» de { $cycle } ({ $control }, { $language }) contém letras minúsculas.
diag-label-too-long = A designação «{ $label }» de { $cycle } ({ $control }, { $language }) tem { $length } caracteres; o comando mostra { $most }.
diag-prompt-too-long = A pergunta «{ $label }» de { $cycle } ({ $control }, { $language }) tem { $length } caracteres; o comando mostra { $most }.
