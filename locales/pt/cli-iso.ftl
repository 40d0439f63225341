# DIN/ISO: conversão de programas e o que não tem equivalente.

cli-convert-to-iso = De Klartext para DIN/ISO
cli-convert-to-klartext = De DIN/ISO para Klartext
cli-convert-control = Comando cujos nomes e designações se escrevem (predefinição: aquele a que pertencem os ciclos do programa)
cli-convert-lang = Idioma dos nomes e das designações (predefinição: o dos textos do próprio programa)

diag-iso-no-equivalent = Em DIN/ISO não há equivalente de «{ $found }»; a frase passa a comentário.
diag-iso-no-code = Nenhum manual indica um código DIN/ISO de { $found }; a frase passa a comentário.
diag-klartext-no-equivalent = Em Klartext não há equivalente de «{ $found }»; a frase passa a comentário.
diag-iso-unknown-code = Nenhum manual indica um ciclo ou uma função com o código { $found }.
diag-iso-word-not-allowed = { $found } não é permitido nesta frase.
diag-iso-no-direction = { $found }: G05 continua no sentido do arco anterior, mas não há nenhum.
diag-iso-mode-left-on = O { $found } da frase anterior não está ativo aqui: um subprograma ou uma repetição mudou-o.
