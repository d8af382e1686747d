# What is put before or after any sentence.
of-scheme = scheme { $scheme }
and-more-alike = {""} (and { $more } more like it)
no-such-language = there is no language `{ $language }`; there are { $known }
# What the writers of pages say themselves.
document-left-out = columns left out
document-see-all = a wider window, `COLUMNS=<width>` or `-o FILE.html` shows the whole table
document-figure = drawing
verbatim = { $text }
called = “{ $name }”
