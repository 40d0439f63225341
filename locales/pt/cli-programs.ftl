# A linha de comandos: comparar, verificar, corrigir e dispor programas.

cli-check-fail-on = A mensagem menos grave com que o comando termina com 1: error (predefinição), warning, note
cli-compare = Prova que dois programas são iguais para um comando numérico ou mostra em que diferem
cli-compare-a = Programa NC
cli-compare-b = Programa NC com que se compara
cli-compare-control = Comando numérico dos dois programas (predefinição: aquele cujos ciclos o primeiro contém)
cli-compare-execute = Executa ambos no cenário e compara o que acontece
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
            [one] Acontece o mesmo: { $count } evento.
           *[other] Acontece o mesmo: { $count } eventos.
        }
        [different] Acontece algo diferente.
       *[unproved] Acontece o mesmo até onde os programas podem ser executados; mais não está provado.
    }

cli-check-path = Programas NC, ou pastas cujos programas (.h, .i) são verificados; «-» lê a entrada padrão
cli-check-control = Comando numérico dos programas, com a versão de software se for conhecida, por exemplo tnc640@340590-05 (predefinição: o de ciklo.toml)
cli-check-config = Ficheiro com definições (predefinição: ciklo.toml na pasta de cada programa ou acima dela)
cli-check-table = Tabela de ferramentas, de pontos de referência ou de pontos zero cujas linhas os programas usam
cli-check-fix = Corrige o que se pode corrigir sem mudar o que o programa faz: as designações
cli-check-no-cache = Verifica de novo todos os programas, também os que não mudaram desde a última vez
cli-check-format = Forma da saída: text (predefinição), json, sarif, github
cli-checking = Programas
cli-checked = Programas verificados: { $files }, { $wrong ->
        [0] nenhum com erros.
       *[other] com erros: { $wrong }.
    }
cli-fixed = { $count ->
        [0] Nada foi corrigido.
        [one] Corrigida { $count } designação.
       *[other] Corrigidas { $count } designações.
    }
diag-check-no-control = O comando numérico de { $path } não é conhecido: --control, ou control em ciklo.toml.
diag-check-no-programs = Em { $path } não há programas: nada foi verificado.
diag-check-no-table = «{ $path }» não é uma tabela: a sua extensão não é .T, .TP, .PR, .D nem .PNT.
diag-passed-over = { $more ->
        [0] Foi ignorado { $path }:
        [one] Foram ignorados { $path } e mais um elemento:
       *[other] Foram ignorados { $path } e mais { $more } elementos:
    } não se trata de ficheiros nem de pastas, ou são ligações que não são seguidas.
diag-fix-no-file = A entrada padrão não pode ser corrigida: indique um ficheiro.
diag-fix-file-changed = { $path } foi alterado entretanto por outrem; fica como está.
diag-fix-changes-program = { $path } deixaria de ser o mesmo programa; fica como está.
diag-config-syntax = Isto não é TOML.
diag-config-unknown-key = Não há a definição «{ $key }»; há control, lang, tables, fail-on, rules, machine e folder.
diag-config-unknown-rule = Não há a regra «{ $key }»; «ciklo explain» indica todas.
diag-config-unknown-word = { $expected } não pode estar em { $key }.
diag-config-value = Aqui { $key } precisa de outra coisa: { $expected }.
diag-allow-without-reason = Este comentário anula { $rule } sem um motivo, por isso não tem efeito.
diag-allow-unknown-rule = Não há a regra «{ $rule }» para anular.
diag-allow-unused = { $rule } nada assinala aqui; o comentário pode sair.
explain-allow-without-reason = Um comentário «; ciklo: allow REGRA motivo» anula as observações de uma regra na frase atrás da qual se encontra ou, numa linha própria, na frase seguinte. Sem motivo não tem efeito.
explain-allow-unknown-rule = A palavra a seguir a «allow» não é uma regra da verificação nem uma condição. ciklo explain indica todos os códigos.
explain-allow-unused = O comentário nada anula: a regra nada assinala na frase a que o comentário se refere, ou não neste comando numérico.

cli-translate-relabel = Toma por designação tudo o que tem a forma dela, mesmo num idioma aqui desconhecido
cli-translate-encoding = Codificação do ficheiro, por exemplo windows-1250 (predefinição: deduzida dos bytes)
cli-translate-from = Idioma das designações do programa; só estas são substituídas (predefinição: cada definição no seu)
cli-translate-sources = { $count ->
        [one] Idioma das designações, com o número de definições: { $languages }.
       *[other] Idiomas das designações, com o número de definições: { $languages }.
    }
cli-fmt = Dispõe os programas no seu lugar: números, colunas, sinais
cli-fmt-path = Programas NC, ou pastas cujos programas (.h, .i) são dispostos; «-» lê a entrada padrão e escreve na saída padrão
cli-fmt-check = Não escreve nada; indica os programas que mudariam
cli-examples-fmt =
    ciklo fmt part.h
    ciklo fmt programs --check
cli-completions = Mostra o que uma shell precisa para completar palavras da linha de comandos
cli-completions-shell = Shell: bash, elvish, fish, powershell, zsh
cli-examples-completions =
    ciklo completions bash > ~/.local/share/bash-completion/completions/ciklo
cli-man = Mostra a página para man, em inglês
cli-man-out = Pasta para a página e para a de cada comando
cli-examples-man =
    ciklo man > ciklo.1
    ciklo man --out man1
cli-fmt-diff = Com --check: mostra o que mudaria
