# A linha de comandos: o comando conform.
cli-conform-cycle = Só este ciclo, por exemplo 200 ou "TCH PROBE 412"; pode repetir-se
cli-conform-case = Só os casos com este nome; pode repetir-se
cli-conform-list = Apenas listar os casos e o que provam
cli-conform-proves = prova: { $text }
cli-conform-why = motivo: { $text }
cli-conform-place = caso: { $text }
cli-conform-manual = manual (ficheiro:linhas): { $text }
cli-conform-lists = { $what }: esperados { $expected } (à esquerda), obtidos { $found } (à direita)
diag-conform-no-case = Nenhum caso corresponde à escolha: «ciklo conform --list» mostra todos os casos.
cli-lint-only = Só o que diz respeito a este ciclo, sem as páginas e a comparação dos idiomas; pode repetir-se
cli-lint-summary = Conta as indicações de cada ficheiro e mostra as próximas vinte
cli-lint-narrow = As páginas e a comparação dos idiomas foram omitidas (--only).
cli-lint-file = { $path }: erros { $errors }, outros { $others }
