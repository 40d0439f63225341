# DIN/ISO: conversão de programas e o que não tem equivalente.

cli-convert-to-iso = De Klartext para DIN/ISO
cli-convert-to-klartext = De DIN/ISO para Klartext
cli-convert-control = Comando cujos nomes e designações se escrevem (predefinição: aquele cujos ciclos o programa contém)
cli-convert-lang = Idioma dos nomes e das designações (predefinição: o dos textos do próprio programa)

diag-iso-no-equivalent = Em DIN/ISO não há equivalente de «{ $found }»; a frase fica como comentário.
diag-iso-no-code = Nenhum manual indica um código DIN/ISO de { $found }; a frase fica como comentário.
diag-klartext-no-equivalent = Em Klartext não há equivalente de «{ $found }»; a frase fica como comentário.
diag-iso-unknown-code = Nenhum manual indica um ciclo ou uma função com o código { $found }.
diag-iso-word-not-allowed = Nada nesta frase aceita { $found }.
diag-iso-no-direction = { $found }: G05 continua no sentido do círculo anterior, mas não há nenhum.
