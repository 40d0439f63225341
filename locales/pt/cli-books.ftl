# Books that `ciklo build` writes.
cli-build-format = O que é escrito: html, um sítio (predefinição), ou epub, um livro por comando e língua
cli-book-written = { $path }: { $pages } páginas
diag-book-not-packed = Não é possível empacotar o livro { $path }: { $reason }
explain-book-not-packed = Não foi possível acrescentar uma parte do livro ao seu contentor. Só acontece quando um texto ou uma figura é maior do que o formato permite (4 GiB). Exemplo: uma cópia de trabalho cujo tema cresceu sem fim. Solução: reduzir a página que cresceu e criar o livro de novo.
