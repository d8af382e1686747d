# Cases that were run.
test-title = Cases
test-case = "{ $name }"
test-short = { $path }: expected { $expected }; came { $came }
test-table = { $table }: { $said }
test-what-is-a-case = in a folder cases are the files that end in .test.yaml; a single file may be named itself
test-one-copy = a copy with -o can be of one file only
test-file-changed = { $file }: the file was changed while its cases ran; nothing is written
test-run-again = run it again
test-one-by-one = name one file, or leave out -o
test-passed = ok
test-failed = FAILED
test-unusable = unusable
test-expected = expected: { $value }
test-came = got: { $value }
test-why = why: { $reason }
test-source = source: { $text }
test-because = because: { $text }
test-nothing = nothing
test-nothing-yet = nothing yet: `technolog test --write` fills in what comes
test-not-there = that it is not there: { $written }
test-review = { $cases }: written; review them before you rely on them
test-no-cases = there are no cases in the folder `{ $folder }`
test-without = not among { $list }
test-no-such-key-near = there is no `{ $key }` here; did you mean `{ $near }`?
test-no-such-key = there is no `{ $key }` here; there are: { $known }
test-no-such-word = nothing here is called `{ $word }`
test-no-such-word-near = nothing here is called `{ $word }`; did you mean `{ $near }`?
test-not-taken = scheme { $scheme } was not taken: { $why }
test-other-row = row { $row } would give what is expected, but its column { $column } says { $cell }
test-row = { $table }, row { $row }: { $said }
test-cases-counted = { $count } { $count ->
        [one] case
       *[other] cases
    }
test-files-counted = { $count } { $count ->
        [one] file
       *[other] files
    }
test-all-as-expected = { $files }, { $cases }: all as expected
test-none-failed = { $files }, { $cases }
test-some-failed = { $files }, { $cases }: { $failed } failed
test-unusable-files = {""}, unusable files: { $count }
