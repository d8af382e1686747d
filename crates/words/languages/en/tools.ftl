# Tools.
tool-tables = { $operation }: the cutter is looked for in the { $tables-count ->
        [1] table
       *[other] tables
    } { $order }
cutter = the first cutter that fits
centre-drill-for-all = the smallest centring drill for all groups of holes: Ø{ $needed }
centre-drill-for-all-over = the smallest centring drill for all groups of holes: over Ø{ $needed }
centre-drill-for-all-least = the smallest centring drill for all groups of holes: at least Ø{ $needed }
holder = the first holder that takes the shank ({ $shank })
overhang-cylindrical = overhang: { $free } mm outside the seat + { $extra } mm
overhang-morse = overhang: { $projection } mm outside the taper
overhang-shell = shell cutter: it stands out by its own length
overhang-taper = a tool with the machine's own taper
does-not-reach = { $tool } ({ $table }): reach { $reach } mm, and { $needed } mm are needed
flutes-close = { $tool } ({ $table }): flutes of { $flutes } mm < { $needed } mm in the hole + { $room } mm open for chips
drill-too-large = { $tool } ({ $table }): Ø{ $diameter } is more than Ø{ $limit }, the machine's largest drill
bar-does-not-enter = { $tool } ({ $table }): the bar Ø{ $bar } does not enter the hole Ø{ $hole }
no-cutter-of-size = { $operation }: in the { $tables-count ->
        [1] table
       *[other] tables
    } { $tables } there is no Ø{ $diameter }{ $sides ->
        [below] ; the largest below it is { $below }
        [above] ; the smallest above it is { $above }
        [none] {""}
       *[both] ; the nearest are { $below } and { $above }
    }
no-cutter = { $operation }: no cutter
shank-outside-clamp = { $holder }: shank Ø{ $shank } is outside { $low }–{ $high } mm
other-morse = { $holder }: Morse { $taken }, the cutter has { $own }
other-taper = { $holder }: 7:24 No. { $own }, the spindle has No. { $spindle }
stands-out-too-little = { $holder }: it stands out { $reach } mm < { $needed } mm in the hole + { $over_face } mm of the holder over the face
arbor-does-not-enter = { $holder }: the arbor Ø{ $arbor } does not enter the hole Ø{ $hole }
start-near-clamp = the tool-change point is { $distance } mm from a clamp, less than the safe { $needed } mm: clamp with the spindle where the set-up says, or put fixed stops that limit the turn of the wrench (textbook 1.11)
clamp-near-hole = a clamp is { $distance } mm from the hole's axis, less than { $needed } mm
other-bore = { $holder }: seat { $taken } mm, the cutter has { $own } mm
assembly-too-long = { $tool } in { $holder }: length { $length } mm, and the machine's largest overhang is { $limit } mm
# Clamping, travel.
safety = safety factor k = { $value }
face-milled = no cutter plunges the whole face, so a mill goes round it: { $why }
support-friction = friction on the support f2 = { $value }
clamping-turns = { $operation } with M = { $torque } N·m turns the part: W = k·M/(f·d) = { $by_book } N
clamping-pushes = { $operation } with M = { $torque } N·m pushes the part with { $side } N: against sliding W = k·P/(f + f2) = { $force } N, more than k·M/(f·d) = { $by_book } N
friction = friction f = { $value }
least-screw = no thinner screw than M{ $value } is set under a strap
screw = { $needed } is needed, { $taken } taken: bears { $bears } N
no-screw = no screw bears { $force } N per clamp ({ $clamps }), { $screw } bears { $bears } N: take { $enough } clamps no nearer to the holes ({ $share } N each), or cut with { $most } N·m at most instead of { $torque } N·m
no-screw-for-slot = T-slots of { $slot } mm take screw { $screw } at most: { $bears } N < { $force } N on each clamp ({ $clamps }); take { $enough } clamps no nearer to the holes ({ $share } N each), cut with { $most } N·m at most instead of { $torque } N·m, or take a fixture of your own
straps-overlap = the straps at { $one } and { $other } would overlap
strap-near-hole = the strap of screw { $screw }, { $width } mm wide, leaves the tools of hole { $hole } less than { $least } mm beside it
strap = strap of screw { $screw }: { $width } mm wide, { $height } mm over the face with its nut
screw-too-weak = screw { $screw } bears { $bears } N, and each clamp takes { $force } N; { $needed } is needed, or { $enough } clamps of { $screw } no nearer to the holes ({ $share } N each), or a cut with { $most } N·m at most instead of { $torque } N·m
clamp-outlines-overlap = the clamps at { $one } and { $other } overlap by their outlines; put them apart, or correct `outline`
clamps-overlap = two clamps { $distance } mm apart: their feet overlap, each takes { $least } mm; give their `outline` if they are narrower
one-clamp-turns = one clamp: hole { $hole } turns the part about it with { $moment } N·m (with the safety factor), and nothing holds that; a second clamp at least { $least } mm away, or a stop there, does
clamps-turn = the clamps stand too near to each other: hole { $hole } turns the part about one of them with { $moment } N·m > { $holds } N·m, what friction at the others holds; for two clamps { $least } mm are enough
clamps-tip = the side force of { $side } N tips the part over an edge with { $moment } N·m > { $holds } N·m, what the clamps hold there; put them farther from the edges
clamps-one-side = all clamps stand by one side: the part goes on { $beyond } of { $width } mm beyond them and lifts as a drill breaks through; clamp it on two opposite sides
beyond-travel = the holes span { $span } mm, and the travel along { $axis } is { $travel } mm
vice-grip = at least { $value } mm of the part are gripped
vice-grip-share = at least { $value } of the height of the part is gripped
vice-below-face = the jaws end { $value } mm or more below the face
vice-room-below = below a tool that comes out there are { $value } mm or more
vice-holds = { $along } mm along jaws of { $jaws } mm, { $between } mm between them, opening { $opening } mm
vice-parallels = parallels of { $height } mm: a tool comes out { $below } mm below the part
chuck-holds = Ø{ $diameter } on step { $step }, which holds from Ø{ $least } to Ø{ $most }
fixture-kind = the kind of fixture (textbook 1.6)
fixture-keying = how the fixture is keyed to the table (textbook 1.7)
part-locating = how the part is located (textbook 1.9)
keying-play = keys or pins of { $size } mm: up to { $play } mm of play
locating-error = part after part up to { $most } mm off its place
chain-both-axes = both axes err: neither section 1.2.1 nor the accuracy of the machine says whether it is of an axis or of the distance of two; by the other reading the first field alone would count
pin-clearance = clearance of the pin in its hole { $least } to { $most } mm
no-locating-pin = no pin of the table `locating-pins` is as thick as the hole { $hole } at { $at }: it takes 3 to 50 mm
pin-does-not-enter = the pin does not enter the hole { $hole } at { $at }: its smallest diameter is { $smallest } mm, the largest of a pin { $field } is { $largest } mm
chain-term = a field of { $field } mm in the chain
chain-closing = whether the chain closes
chain-zeros = how many zeros the part gets (textbook 5.2 item 11.2)
