# O comando «serve».
cli-serve = Mostra os manuais e o estado das traduções num navegador deste computador
cli-serve-port = Porta em que fica à escuta (predefinição: 8477); 0 escolhe uma que esteja livre
cli-serve-address = Os manuais estão em { $address }; Ctrl+C termina.
cli-serve-anew = Os dados mudaram: { $files ->
        [0] não é possível criar as páginas.
       *[other] ficheiros criados de novo: { $files }.
    }
cli-examples-serve =
    ciklo serve
    ciklo --data . serve --control tnc640 --lang fi
diag-serve-address = { $path } não pode ser utilizado como endereço: { $reason ->
        [in-use] outro programa utiliza a porta; escolha outra com --port
        [permission] sem permissão; escolha com --port uma porta acima de 1023
       *[other] { $detail }
    }.
explain-serve-address = «ciklo serve» fica à escuta numa porta deste computador, a que só este computador chega. Uma porta só pode ser utilizada por um programa de cada vez, e as portas até 1023 estão muitas vezes reservadas ao sistema. Exemplo: ciklo serve, com outro em execução numa segunda janela. Termine o outro programa ou escolha outra porta com --port; com --port 0, o sistema atribui uma que esteja livre.
