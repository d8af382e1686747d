# What is put before or after any sentence.
of-scheme = scheme { $scheme }
and-more-alike = {""} (and { $more } more like it)
no-such-language = there is no language `{ $language }`; there are { $known }
