# Levels of diagnostics.
cli-error = error
cli-warning = warning
cli-note = note
cli-help = help
# Heads of tables.
cli-table = Table
cli-row-count = Rows
cli-kind = Kind
cli-title = Title
cli-row = Row
cli-row-number = No.
cli-row-source = Origin
cli-catalog = catalog
cli-decision = decision
# Parts of a printed table.
cli-source = Source
cli-columns = Columns
cli-input = input
cli-output = output
cli-optional = not in every row
cli-list = list
cli-corrections = Corrected (*): the source prints otherwise
cli-unconfirmed = Unconfirmed (?)
cli-choices = Choices of ours (?)
cli-reasons = Reconstructed from
cli-places = Place in the source, where another
cli-row-notes = Notes on rows
cli-notes = Notes
cli-gaps = What the table does not hold
# A lookup.
cli-result = Result
cli-no-row = no row applies
cli-passed-over = Match too, but not taken
cli-rejected = Rejected, by the first column that failed
cli-nearest = Nearest rows and what failed in them
cli-nearest-values = Nearest values
cli-gap = Gap of the source
cli-question = Query
cli-each-alone = Each key on its own finds
cli-empty-cell = (empty)
cli-command-line = command line
cli-all-rejected = every row on its own: --all
cli-also-says = The row also says
# The proof.
cli-hole = Hole
cli-transition = Transition
cli-made = Made
cli-tool = T
# Phrases of commands.
cli-unknown-table = there is no table `{ $id }`
cli-did-you-mean = did you mean `{ $name }`?
cli-list-tables = `technolog table` lists them
cli-no-format = the command { $command } has no format { $format }
cli-formats = its formats are { $known }
cli-cannot-write = { $path }: cannot be written: { $error }
cli-write-not-permitted = { $path }: writing it is not permitted
cli-check-folder = name a file in a folder that exists and can be written
cli-replace-link = name the file itself, or remove the link
cli-would-replace-input = { $file } is an input of this command; it is not overwritten
cli-another-file = name another file with -o
cli-cannot-print = the answer cannot be printed: { $error }
cli-print-to-file = name a file for the answer: -o FILE
cli-broken-build = the embedded knowledge cannot be read: { $error }
cli-rebuild = build the program again, or name a folder with --knowledge DIR
cli-cannot-read = { $path }: cannot be read: { $error }
cli-not-found = { $path }: there is no such file
cli-not-permitted = { $path }: reading it is not permitted
cli-is-a-folder = { $path }: this is a folder, not a file
cli-check-path = check the path of the file
cli-no-hole = { $path }: there is no group of holes `{ $name }`
cli-hole-missing = which group of holes is meant? name it: --hole NAME
cli-known = there are: { $names }
cli-option-of-lists = { $option } is for lists of points, not for a part file
cli-leave-out = leave out { $option }
cli-not-a-pair = `{ $text }` is not of the form key=value
cli-write-pair = write, for example, { $example }
cli-no-such-key = table { $table } has no key `{ $key }`
cli-is-output = `{ $key }` is an output of table { $table }, not an input
cli-no-such-key-but = did you mean `{ $near }`? the keys of the table are { $known }
cli-the-keys-are = the keys of the table are { $known }
cli-keep-one = keep one of them
cli-bad-value = key `{ $key }`: `{ $value }` is not valid
cli-bad-value-because = key `{ $key }`: { $why }
cli-expected-is = expected: { $expected }
cli-out-of-domain = key `{ $key }`: { $value } is outside the table's domain: { $domain }
cli-within-domain = give a value within it
cli-missing-keys = table { $table } also needs { $keys }
cli-give-keys = add, for example, { $example }
cli-other-machine = the machine is { $asked }, but the part is for { $own }
cli-leave-machine = leave out --machine, or change the part's machine
cli-no-control = the record of the machine `{ $machine }` does not say which control it has
cli-unknown-control = there is no control `{ $control }`
cli-alien-control = the machine `{ $machine }` has the control `{ $control }`, whose language is not known here
cli-name-control = name one with --control: there are { $known }
check-of-lathe = this is a program of a lathe, and { $control } is the control of a mill
check-name-lathe = name the control of the lathe: { $controls }
check-more-of-a-kind = and { $count } more, lines { $lines }
check-read-as = the program was read as one of { $control }, because no control is named
check-read-as-other = name another with --control: { $controls }
cli-no-machine = the catalog has no machine `{ $id }`
cli-by-rule = { $what } (rule: { $section ->
        [text] how a program is written
        [words] words
        [blocks] blocks
        [motions] motions
        [cycles] cycles
        [calls] subprograms
        [spindle] spindle
        [machine] machine
        [start] state at the start
        [part] comparison with the part
       *[other] textbook { $section }
    })
cli-run-lint = the table is at fault; `technolog lint` shows where
cli-printed-otherwise = { $column }: printed as "{ $printed }": { $reason }
cli-all-rows-of-one-source = Origin of every row: { $source }
cli-default-is = { $value } unless given
cli-refers-to = see { $table }, { $column }
cli-one-of = one of { $values }
cli-word-of = a word of table { $table }
cli-and-more = and { $count } more
# Counts.
cli-rows-counted = { $count } { $count ->
        [one] row
       *[other] rows
    }
cli-tables-counted = { $count } { $count ->
        [one] table
       *[other] tables
    }
cli-problems-hidden = and { $count } more: `--all-problems` shows all
cli-findings-counted = { $count } { $count ->
        [one] finding
       *[other] findings
    }
# What a column expects.
cli-expected-unit = a unit, such as `mm/min`
cli-expected-number = a number
cli-expected-length = a length
cli-expected-angle = an angle
cli-expected-it = a tolerance grade, 1 to 18
cli-expected-roughness = a roughness such as "Ra 2.5"
cli-expected-in-unit = { $what } in { $unit }
cli-alien-ending = `{ $command }` writes no { $ending } files
cli-known-endings = it writes { $known }
cli-unknown-ending = the ending of { $file } does not say what to print
cli-file-twice = { $file } is named twice with -o
cli-one-file = only `report` writes several files at once
cli-not-built = this program was built without its { $format } printer
cli-build-it = build one that has it: { $command }
cli-other-kind = this is { $is }, but { $wanted } is needed here
cli-kind-command = its command is `{ $command }`
cli-kind-turned = its command is `technolog turn { $file }`; a program for it is checked by `technolog check PROGRAM --control linuxcnc-lathe --part { $file }`
cli-kind-setting-of = it is for `technolog check … --setting { $file }`
cli-kind-marks-of = it is for `technolog audit … --marks { $file }`
cli-kind-table-of = it is for `technolog lint --knowledge …`
cli-kind-help = `technolog --help` lists the commands and the files that they take
kind-part = a file of a part with holes
kind-turned = a file of a turned part
kind-plan = a plan
kind-cases = a file of cases
kind-setting = a setting file
kind-marks = a marking scheme
kind-table = a table of the knowledge base
kind-program = an NC program
kind-list = a list of points
kind-yaml = a YAML or JSON file
cli-other-alphabet = some letters look alike in the Latin and the Ukrainian alphabet: the part file has `{ $name }`, copy it from there
cli-format-contradiction = { $file }: its ending means { $meant }, and --format asks for { $asked }
cli-format-contradiction-help = leave out --format, or give the file another ending
cli-report-no-parts = `parts` chooses parts of the report of a part with holes, which this is not
cli-report-leave-parts = leave `parts` out of the title block
cli-report-lathe-control = there is no control `{ $control }` for turned parts
cli-report-lathe-controls = known are { $known }
cli-report-audit-control = `--control` means nothing for the report of an audit
cli-report-no-forms = only the report of a part with holes has forms (`--only`) that stand by themselves
cli-report-leave-only = leave `--only` out
cli-not-on-screen = { $format } is no text, which a screen cannot show
cli-name-a-file = name a file: `-o report{ $ending }`
