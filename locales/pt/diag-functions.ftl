# Blocks that end a program or speak with the machine.
diag-error-of-program = O programa termina por si próprio com o erro { $number } (FN 14).
explain-error-of-program = FN 14: ERROR termina o programa com um erro próprio; o número escolhe a mensagem que o comando mostra. Os programas usam-no quando não podem continuar, por exemplo porque o valor de um parâmetro não serve. Exemplo: “FN 14: ERROR = 1010”. Solução: verificar a condição antes do bloco e dar aos parâmetros valores com que o programa possa trabalhar.
diag-tool-setter-missing = O cenário não tem apalpador de ferramentas.
explain-tool-setter-missing = Um ciclo de medição da ferramenta precisa de um apalpador de mesa no cenário: onde está a sua superfície e que largura tem. Exemplo: “tool_setter:” com “at: [300, 200, -50]” e “diameter: 40”. Solução: acrescentá-lo ao cenário; docs/scene.md descreve as chaves.
