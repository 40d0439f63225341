# Books that `ciklo build` writes.
cli-build-format = What is written: html, a site (default), epub or pdf, one book for each control and language
cli-book-written = { $path }: { $pages } pages
diag-book-not-packed = The book { $path } cannot be packed: { $reason }
explain-book-not-packed = A part of the book could not be added to its container. It happens only when a text or a figure is larger than the format allows (4 GiB). Example: a working copy whose topic has grown without end. Remedy: make the page that grew smaller and build the book again.
diag-book-not-set = The book { $path } cannot be typeset: { $file }, line { $line }: { $reason }
explain-book-not-set = The typesetter refuses the markup of a page, or the result would not be an accessible PDF (PDF/UA-1): a drawing without a description, a character that the fonts lack. The file named is that of the page, or book.typ, which sets the look. Example: a changed templates/print/book.typ that calls a function which does not exist. Remedy: correct the template or the text, then build the book again.
diag-pdf-not-built-in = This ciklo was built without PDF; one that has it is installed from its sources with: cargo install --path . --features pdf
explain-pdf-not-built-in = Typesetting a PDF needs parts that take minutes to compile; they are left out unless the feature pdf is asked for. Example: ciklo build --format pdf with a ciklo that was installed by cargo install --path . alone. Remedy: install it again with --features pdf, or take --format epub, which every ciklo can write.
