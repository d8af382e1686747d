# The encoding sheet of a program.
encoding-title = Encoding sheet (GOST 3.1404-86, form 5a)
encoding-part = Part
encoding-equipment = Equipment, control
encoding-equipment-is = { $machine }, { $control }
encoding-instructions = Special instructions†
encoding-zero = set-up { $setup }: zero of the part from the machine zero X{ $x } Y{ $y } Z{ $z }
encoding-correctors = offset registers, mm: { $held }
encoding-ours = † ours: the textbook's sheet does not have it
encoding-transition = Transition
encoding-tool = T, H†
encoding-block = Code (block)
encoding-meaning = The block in words†
# What the words of a block say.
encoding-is = { $meaning } = { $value } { $unit }
encoding-moves-to = { $meaning } to { $value } { $unit }
encoding-moves-by = { $meaning } by { $value } { $unit }
encoding-both = { $first } and { $second }
encoding-unknown = the control's tables do not know this word
encoding-comment = comment: { $text }
encoding-skip = /: what follows is left out on request
encoding-tape = %: start or end of the program
encoding-statement = { $text }: statement of the control
encoding-sub = { $text }: the subprogram begins
encoding-endsub = { $text }: the subprogram ends
encoding-call = { $text }: call of the subprogram
# What the operator sets before a program runs.
setting-title = Setting of the machine: { $part }
setting-stand = set-up { $setup }: the part on supports of { $supports } mm; { $nose } mm from the table to the spindle nose with the ram up
setting-stand-own = set-up { $setup }: the part lies in its fixture { $supports } mm over the table; { $nose } mm from the table to the spindle nose with the ram up
setting-stand-vice = set-up { $setup }: { $nose } mm from the table to the spindle nose with the ram up
setting-mark = * rests on a row of a table that nothing confirms; `technolog plan … --all-problems` says why
setting-lengths = lengths H are sums from catalogs: measure each assembly and key in the length found
setting-clamps-of-second = set-up { $setup }: the places of the clamps are to be chosen anew, the plan has those of the first set-up only
setting-of-set-up = set-up { $setup }: { $clamps }
setting-tool = T{ $place } H{ $corrector }: { $designation }, Ø{ $diameter }, length { $length } mm
setting-length = Assembly length
setting-place = Place
setting-places = The program calls the number of the place T.
setting-load = T{ $tool } is put into place { $place } by hand while the program stops at M00 before it; the program calls it T{ $place }
setting-unfinished = Unfinished: { $hole }: { $left }
setting-not-as-drawn = not made as drawn
setting-not-made = not made at all
program-not-written = the program is not written: it must not be run
    .help = `--force` writes it all the same, and its first line says why it must not be run
program-number-beyond = the control 2C42-65 has programs 01 to 99, not { $number }
program-numbers-run-out = behind the program number { $number } there is no room for { $count } subprograms: numbers end at 9999; give a smaller one, or --no-subprograms
setting-zeros = Zeros of the part, from the zero of the machine
setting-frame = Frame
setting-file = `--show setting --format yaml` writes the file of this setting for `technolog check … --setting`.
setting-keys = Keying in, in this order
keys-input = { $keys }: input from the panel
keys-correctors = { $keys }: the table of correctors
keys-reference = The reference tool{ $tool } down onto a gauge block on the table; { $keys }: Z is shown as 0
keys-corrector = T{ $tool } down onto the same block; { $keys }: its length goes into H{ $corrector }, about { $value }
keys-restore = { $keys }: Z is shown as before
keys-leave = { $keys }: out of the table
keys-zeros = Set-up { $setup }: { $keys }: the table of zeros
keys-page = { $keys }, until page { $page }: { $frame } stands there
keys-value = { $frame }, lines X and Y, { $keys } each: X = xM{ $x }, about { $about_x }; Y = yM{ $y }, about { $about_y }
keys-each-part = On each part anew
keys-read-z = The reference tool{ $tool } from Z 0 of the machine down onto the face; { $keys } on line Z of { $frame }: about { $about }
keys-value-z = The reference tool{ $tool } from Z 0 of the machine down onto the face, read zM; { $frame }, line Z, { $keys }: Z = zM{ $less }, about { $about }
