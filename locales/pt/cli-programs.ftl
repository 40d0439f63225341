# A linha de comandos: comparar, verificar, corrigir e dispor programas.

cli-check-fail-on = A mensagem menos grave com que o comando termina com 1: error (predefinição), warning, note
cli-compare = Prova que dois programas são iguais para um comando numérico ou mostra em que diferem
cli-compare-a = Programa NC
cli-compare-b = Programa NC com que se compara
cli-compare-control = Comando numérico dos dois programas (predefinição: aquele a que pertencem os ciclos do primeiro)
cli-compare-execute = Executa ambos na cena e compara os eventos
cli-examples-compare =
    ciklo compare part.h pezzo.h
    ciklo compare part.h pezzo.h --control tnc640 --execute --scene part.scene.yaml
cli-compared = { $count ->
        [0] Os programas são iguais, exceto nas designações, comentários, numeração, espaços e escrita dos números.
        [one] Os programas diferem em { $count } ponto.
       *[other] Os programas diferem em { $count } pontos.
    }
cli-compare-executed = { $verdict ->
        [same] { $count ->
            [one] A execução dá o mesmo { $count } evento.
           *[other] A execução dá os mesmos { $count } eventos.
        }
        [different] A execução dá eventos diferentes.
       *[unproved] A execução dá os mesmos eventos até onde os programas podem ser executados; o resto não está provado.
    }

cli-check-path = Programas NC, ou pastas cujos programas (.h, .i) são verificados; «-» lê a entrada padrão
cli-check-control = Comando numérico dos programas, com a versão de software se for conhecida, por exemplo tnc640@340590-05 (predefinição: o de ciklo.toml)
cli-check-config = Ficheiro com definições (predefinição: ciklo.toml na pasta de cada programa ou acima dela)
cli-check-table = Tabela de ferramentas, de pontos de referência ou de pontos zero cujas linhas os programas usam
cli-check-fix = Corrige o que se pode corrigir sem mudar o que o programa faz: designações e sinais duplicados
cli-check-no-cache = Verifica de novo todos os programas, também os que não mudaram desde a última vez
cli-check-no-execution = Não executar os programas de que se conhecem todas as ferramentas, apenas lê-los
cli-check-format = Forma da saída: text (predefinição), json, sarif, github
cli-checking = Programas
cli-checked = Programas verificados: { $files }, { $wrong ->
        [0] nenhum com erros.
       *[other] com erros: { $wrong }.
    }
cli-fixed = { $count ->
        [0] Nada foi corrigido.
        [one] Foi corrigido { $count } lugar.
       *[other] Foram corrigidos { $count } lugares.
    }
diag-check-no-control = O comando numérico de { $path } não é conhecido: indique-o com --control, ou com control em ciklo.toml.
diag-check-no-programs = Em { $path } não há programas: nada foi verificado.
diag-check-no-table = «{ $path }» não é uma tabela: a sua extensão não é nenhuma de .T, .TP, .PR, .D e .PNT.
diag-passed-over = { $more ->
        [0] { $path } não foi lido:
        [one] { $path } e mais uma entrada não foram lidos:
       *[other] { $path } e mais { $more } entradas não foram lidos:
    } não se trata de ficheiros nem de pastas, ou são ligações que não são seguidas.
diag-fix-no-file = A entrada padrão não pode ser corrigida no lugar: indique um ficheiro.
diag-fix-file-changed = { $path } foi entretanto alterado por outro programa; não foi escrito.
diag-fix-changes-program = { $path } deixaria de ser o mesmo programa; não foi escrito.
diag-config-syntax = Isto não é TOML válido.
diag-config-unknown-key = Não existe a definição «{ $key }». As definições são control, lang, tables, fail-on, rules, machine e folder.
diag-config-unknown-rule = Não há a regra «{ $key }»; «ciklo explain» indica todas.
diag-config-unknown-word = { $expected } não é um valor possível de { $key }.
diag-config-value = Aqui { $key } precisa de outro valor: { $expected }.
diag-allow-without-reason = Este comentário permite { $rule } sem um motivo e, por isso, não tem efeito.
diag-allow-unknown-rule = Não existe a regra «{ $rule }», que se pudesse permitir.
diag-allow-unused = { $rule } não é encontrado aqui; o comentário pode ser apagado.

cli-translate-relabel = Trata como designação todos os comentários que parecem uma, mesmo num idioma desconhecido
cli-translate-encoding = Codificação do ficheiro, por exemplo windows-1250 (predefinição: deduzida dos bytes)
cli-translate-from = Idioma das designações do programa; só estas são substituídas (predefinição: cada definição no seu)
cli-translate-sources = { $count ->
        [one] Idioma das designações, com o número de definições: { $languages }.
       *[other] Idiomas das designações, com o número de definições: { $languages }.
    }
cli-fmt = Dispõe os programas no seu lugar: números, colunas, sinais
cli-fmt-path = Programas NC, ou pastas cujos programas (.h, .i) são formatados; «-» lê a entrada padrão e escreve na saída padrão
cli-fmt-check = Não escreve nada; indica os programas que mudariam
cli-examples-fmt =
    ciklo fmt part.h
    ciklo fmt programs --check
cli-completions = Escreve o script que completa a linha de comandos numa shell
cli-completions-shell = Shell: bash, elvish, fish, powershell, zsh
cli-examples-completions =
    ciklo completions bash > ~/.local/share/bash-completion/completions/ciklo
cli-man = Mostra a página para man, em inglês
cli-man-out = Pasta para a página e para a de cada comando
cli-examples-man =
    ciklo man > ciklo.1
    ciklo man --out man1
cli-fmt-diff = Com --check: mostra o que mudaria
