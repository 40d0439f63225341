# O comando «convert» e as suas mensagens.
cli-convert = Reescreve programas para outro comando, ou em DIN/ISO ou em Klartext
cli-convert-file = Programas NC; vários só com --in-place
cli-convert-from = Comando para o qual os programas foram escritos
cli-convert-to = Comando para o qual são convertidos
cli-convert-form = Forma dos ciclos que têm duas: new (parâmetros Q) ou old (uma frase por linha); predefinição: como no programa
cli-convert-out = Ficheiro a escrever (predefinição: saída padrão)
cli-convert-in-place = Substituir os programas antigos pelos novos
cli-converted = { $count ->
        [0] Nenhuma definição reescrita: { $path }
        [one] { $count } definição reescrita: { $path }
       *[other] { $count } definições reescritas: { $path }
    }
cli-examples-convert =
    ciklo convert part.h --from tnc426-430 --to tnc640 > new.h
    ciklo convert part.h --from tnc640 --to tnc320 --format json
    ciklo convert measuring.h --from itnc530 --to itnc530 --form new --in-place
    ciklo convert part.h --to-iso > part.i
    ciklo convert part.i --to-klartext --lang it --out pezzo.h
diag-convert-one-file = Vários programas só são reescritos com --in-place.
diag-convert-iso-stays = «{ $found }» mudaria, mas a nova forma não se pode escrever em DIN/ISO; a frase não foi alterada.
diag-convert-iso-unread = Em Klartext não há equivalente de «{ $found }»; a frase não foi verificada nem alterada.
diag-convert-cycle-not-on-control = { $control } não tem { $cycle }; a definição não foi alterada.
diag-convert-cycle-not-described = O manual de { $control } menciona { $cycle }, mas não o descreve; os parâmetros não foram alterados.
diag-convert-cycle-not-covered = Os manuais de { $control } que o Ciklo conhece não tratam de ciclos como { $cycle }; a definição não foi alterada.
diag-convert-parameter-added = { $import ->
        [yes] Em { $cycle } foi acrescentado { $parameter } = { $value }, como { $control } faz com programas mais antigos: introduza o valor pretendido.
       *[no] Em { $cycle } foi acrescentado { $parameter } = { $value }; com ele, o ciclo faz o mesmo que antes.
    }
diag-convert-parameter-dropped = { $neutral ->
        [yes] Em { $cycle } foi retirado { $parameter } = { $value }: sem ele, { $control } faz o mesmo.
       *[no] Em { $cycle } foi retirado { $parameter } = { $value }: { $control } não o tem.
    }
diag-convert-parameter-renamed = { $parameter } de { $cycle } passa a { $new } em { $control }.
diag-convert-no-value = { $cycle } precisa de { $parameter } em { $control }, mas não se sabe que valor mantém a maquinação inalterada.
diag-convert-value-refused = { $control } não aceita { $parameter } = { $value } de { $cycle }; o valor não foi alterado.
diag-convert-value-differs-in-meaning = { $parameter } = { $value } de { $cycle } significa outra coisa em { $control }.
diag-convert-field-not-on-control = O campo { $parameter } de { $cycle } não existe em { $control }; a definição não foi alterada.
diag-convert-form = { $cycle } passa a { $new }.
diag-convert-form-stays = { $cycle } mantém a sua forma: entre as suas linhas há comentários ou outras frases.
diag-convert-not-line-by-line = { $cycle } não foi alterado: os seus parâmetros não ocupam cada um a sua linha.
diag-convert-function-not-shown = { $function } ({ $count ->
        [one] uma utilização
       *[other] { $count } utilizações
    }) não foi alterado: o manual de { $control } não o mostra.
diag-convert-function-option = { $function } precisa da opção de software { $option } em { $control }.
