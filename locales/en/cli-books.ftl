# Books that `ciklo build` writes.
cli-build-format = What is written: html, a site (default), or epub, one book for each control and language
cli-book-written = { $path }: { $pages } pages
diag-book-not-packed = The book { $path } cannot be packed: { $reason }
explain-book-not-packed = A part of the book could not be added to its container. It happens only when a text or a figure is larger than the format allows (4 GiB). Example: a working copy whose topic has grown without end. Remedy: make the page that grew smaller and build the book again.
