# Books that `ciklo build` writes.
cli-build-format = O que é escrito: html, um sítio (predefinição), epub ou pdf, um livro por comando e língua
cli-book-written = { $path }: { $pages } páginas
diag-book-not-packed = Não é possível empacotar o livro { $path }: { $reason }
explain-book-not-packed = Não foi possível acrescentar uma parte do livro ao seu contentor. Só acontece quando um texto ou uma figura é maior do que o formato permite (4 GiB). Exemplo: uma cópia de trabalho cujo tema cresceu sem fim. Solução: reduzir a página que cresceu e criar o livro de novo.
diag-book-not-set = Não é possível compor o livro { $path }: { $file }, linha { $line }: { $reason }
explain-book-not-set = O compositor recusa a marcação de uma página, ou o resultado não seria um PDF acessível (PDF/UA-1): uma figura sem descrição, um carácter que falta nos tipos de letra. O ficheiro indicado é o da página, ou book.typ, que define o aspeto. Exemplo: um templates/print/book.typ alterado que chama uma função que não existe. Solução: corrigir o modelo ou o texto e criar o livro de novo.
diag-pdf-not-built-in = Este ciklo foi compilado sem PDF; um que o escreve instala-se a partir do código-fonte com: cargo install --path . --features pdf
explain-pdf-not-built-in = A composição de um PDF precisa de partes que demoram minutos a compilar; ficam de fora, a não ser que se peça a funcionalidade pdf. Exemplo: ciklo build --format pdf com um ciklo instalado apenas com cargo install --path . Solução: instalá-lo de novo com --features pdf, ou usar --format epub, que qualquer ciklo sabe escrever.
