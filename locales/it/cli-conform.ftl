# La riga di comando: il comando conform.
cli-conform-cycle = Solo questo ciclo, ad esempio 200 o "TCH PROBE 412"; ripetibile
cli-conform-case = Solo i casi con questo nome; ripetibile
cli-conform-list = Elenca soltanto i casi e ciò che dimostrano
cli-conform-proves = dimostra: { $text }
cli-conform-why = motivo: { $text }
cli-conform-place = caso: { $text }
cli-conform-manual = manuale (file:righe): { $text }
cli-conform-lists = { $what }: attesi { $expected } (a sinistra), trovati { $found } (a destra)
diag-conform-no-case = Nessun caso corrisponde alla scelta: «ciklo conform --list» elenca tutti i casi.
cli-lint-only = Solo ciò che riguarda questo ciclo, senza le pagine e il confronto tra le lingue; ripetibile
cli-lint-summary = Conta le segnalazioni di ogni file e mostra le prossime venti
cli-lint-narrow = Le pagine e il confronto tra le lingue sono stati tralasciati (--only).
cli-lint-file = { $path }: errori { $errors }, altri { $others }
