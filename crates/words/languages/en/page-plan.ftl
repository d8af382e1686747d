# The page of a plan.
plan-title = Machining plan: { $part }
plan-material = Material
plan-material-of-strength = { $material } (HB { $hardness }, σB { $strength } MPa)
plan-material-of-hardness = { $material } (HB { $hardness })
plan-blank = Blank
plan-plate = plate { $length } × { $width } × { $thickness } mm
plan-disc = disc Ø{ $diameter } × { $thickness } mm
plan-ring = ring Ø{ $diameter } / Ø{ $bore } × { $thickness } mm
plan-machine = Equipment
# Its sections.
plan-route = 1. Route
plan-tools = 2. Cutters and holders
plan-conditions = 3. Cutting conditions
plan-clamping = 4. Set-up and clamping
plan-no-clamping = The plan sets neither clamps nor a vice: a fixture of your own must hold the part.
plan-corrections = 5. Tool-length offsets
plan-time = 6. Time
plan-findings = 7. Findings
# The route.
plan-operation = { $number } { $name }
plan-operation-number = 005
plan-operation-name = NC machining
plan-step-head = Transition
plan-scheme = Scheme
plan-cutter = Cutter
plan-reached = Grade and Ra (tables)
plan-set-up = Set up and clamp the blank
plan-turn-over = Turn the part over: set-up { $setup }
plan-take-off = Take off the part
plan-step = { $verb } { $count } { $count ->
    [one] hole
   *[other] holes
} { $size } ({ $hole })
plan-step-to = { $verb } { $count } { $count ->
    [one] hole
   *[other] holes
} { $size } ({ $hole }) to Ø{ $diameter }
plan-step-spot = { $verb } { $count } { $count ->
    [one] hole
   *[other] holes
} { $size } ({ $hole }), spot Ø{ $diameter }
plan-step-floor = { $verb } the floor of { $count } { $count ->
    [one] hole
   *[other] holes
} { $size } ({ $hole }), Ø{ $diameter }
plan-step-face = { $verb } face Ø{ $diameter } at { $count } { $count ->
    [one] hole
   *[other] holes
} { $size } ({ $hole })
plan-step-slot = { $verb } slot { $size } ({ $hole }) to a width of { $width }
plan-step-pocket = { $verb } pocket { $size } ({ $hole }) to a width of { $width }
plan-pocket-size = { $width } × { $length } R{ $corner }
plan-slot-size = { $width } × { $length }
plan-size-for-thread = for thread { $thread }
plan-open-slot-size = { $width } × { $length }, open
plan-step-within = permitted Ø{ $smallest } to Ø{ $largest }
plan-step-also = together with Ø{ $diameter }
plan-step-passes = { $count } { $count ->
    [one] pass
   *[other] passes
}
plan-step-round = round the edge
plan-step-stock = stock { $stock } mm, down to the machined face
plan-step-depth = depth { $depth } mm
plan-step-back = from the back
plan-step-elsewhere = on another machine
plan-by-table = { $table } { $scheme }
plan-by-complex = { $table } complex { $scheme }
plan-by-search = search
plan-by-search-as = search ({ $table } { $scheme })
plan-order = Order of the places
plan-point = [{ $x }; { $y }]
plan-choices = Required, the route taken, and the runner-up
plan-choice = { $required }. Route: { $route }, { $time } min; { $against }
plan-required = IT{ $it }, { $roughness }, tolerance of centre distances { $centre } mm
plan-required-step = step { $diameter }, { $roughness }
plan-route-made = { $route } ({ $operations })
plan-required-thread = { $thread }, tolerance of centre distances { $centre } mm
plan-no-runner-up = no other route is possible
plan-runner-up = next: { $route } ({ $operations }): { $why }
# The tools.
plan-designation = Designation
plan-table = Table
plan-does = Transition
plan-holder = Holder
plan-holder-length = l
plan-overhang = Overhang
plan-assembly = Assembly length
plan-length = Assembly length
plan-correction = Correction (G43)
plan-book-correction = In the book, Lmax − L
# The cutting conditions.
plan-hole = Hole
plan-hole-or-slot = Hole, slot
plan-transition = Transition
plan-feed = S
plan-feed-per-min = F
plan-thrust = P
plan-torque = M
plan-machine-time = Tm
plan-mark = { $mark } rests on a row of a table that nothing confirms: see the findings.
plan-for-one-hole = L is the travel at feed, t the depth of cut, S the feed, V the cutting speed, n the spindle speed, F the feed rate, P the thrust, M the torque, N, kW the power, and Tm the machine time of one hole or slot.
plan-coolant = With coolant: { $operations }.
plan-limited = { $hole }, { $operation } Ø{ $diameter }: limited by { $by }
plan-card = { $hole }, { $operation }: by the card S = { $feed } mm/rev, V = { $speed } m/min, P = { $force } N, N = { $power } kW
# Clamping and time.
plan-largest-force = The largest clamping force is needed for { $surface } { $hole }: M = { $torque } N·m, { $distance } mm from its clamp, W = k·M/(f·d) = { $force } N.
plan-largest-side-force = The largest clamping force is needed for { $surface } { $hole }: with M = { $torque } N·m the cutter pushes the part aside with P = 2·M/D = { $side } N; so that it does not slide under clamps and on supports, W = k·P/(f + f2) = { $force } N.
plan-clamps = Clamps { $points }: { $force } N each, screw { $screw }; start point at least { $distance } mm from a clamp.
plan-clamps-proposed = Clamps { $points } (proposed): { $force } N each, screw { $screw }; start point at least { $distance } mm from a clamp.
plan-weak-screw = The screw is too weak: it bears { $bears } N, and { $force } N are needed.
plan-lies = The left side is then at X{ $x } and the front side at Y{ $y } from the middle of the table, the front side along the slots.
plan-lies-axis = Its axis is then about X{ $x } Y{ $y } from the middle of the table.
plan-vice = Set-up { $setup }: vice { $vice }, jaws along { $axis }, opened to { $opened } mm; the part { $on }, { $height } mm over the table.
plan-on-parallels = on parallels { $height } mm high and { $thickness } mm thick at most
plan-on-ways = on the ways
plan-vice-grips = The jaws grip { $grip } mm and end { $below } mm below the face; for { $surface } { $hole } they press with { $force } N, and the vice gives { $gives } N.
plan-vice-stop = Its { $jaw } side lies against the fixed jaw, its { $side } side against an end stop.
plan-chuck = Set-up { $setup }: chuck { $chuck } on the table by its back, clamped there; jaws turned for discs, the first at { $first }° from X, the others at { $second }° and { $third }°; the part on step { $step } of the jaws, { $height } mm over the table, pressed down before the jaws are tightened.
plan-chuck-grips = The jaws grip { $grip } mm and end { $below } mm below the face; below the part { $room } mm are free to the body beside the jaws; for { $surface } { $hole } they press with { $force } N together, and the chuck gives { $gives } N.
plan-once-chuck = They are found once: the jaws bring the axis of every further part there.
plan-stops = Push it against stops: two at its { $long } side, one at its { $short } side.
plan-stops-one = Push it against two stops at its { $long } side.
plan-once = They are found once: every further part lies against the same stops.
plan-once-pins = They are found once: every further part sits on the same pins.
plan-once-axis = On each part anew: nothing but its rim says where its axis is.
plan-disc-angle = Turn it about its axis until a hole that is made already, off the axis, lies where the drawing turned over has it.
plan-zero-by-pin = { $frame }: bring the spindle over the round pin with an indicator and read xM, yM: X = xM{ $right }, Y = yM{ $back }; about X{ $x } Y{ $y }.
plan-zero-by-axis = { $frame }: turn an indicator in the spindle round the rim of the disc, or in its bore, until it stands still, and read xM, yM there: X = xM{ $right }, Y = yM{ $back }; about X{ $x } Y{ $y }.
plan-turned = Turn the part over for set-up { $setup } about its line along Y: left and right change places, the front side stays in front, and the face of set-up 1 lies down. Made already: { $made }; now from the other face: { $now }.
plan-turned-first = Lay the part for set-up { $setup } with the first face of the drawing down, turned about its line along Y: left and right change places, the front side stays in front. Made now: { $now }.
plan-bar-before = T{ $tool }: set its bar to Ø{ $diameter } ({ $holes }) before the program begins.
plan-bar-at-stop = T{ $tool }: where the program stops before { $holes }, set its bar to Ø{ $diameter }.
plan-loading = While the part is loaded and clamped, the spindle stands at the far left from you, X{ $x } Y{ $y } of the drawing, at least { $distance } mm from every clamp (1.11): drive there by hand.
plan-loading-beyond = At the far left from you, { $distance } mm from every clamp (1.11), is X{ $x } Y{ $y } of the drawing, { $beyond } mm beyond the travel along X: fixed stops must limit the turn of the wrench.
plan-loading-at-start = The far left from you (1.11), X{ $x } Y{ $y } of the drawing, is { $beyond } mm beyond the travel along X: while the part is loaded and clamped, the spindle stands where the tool changes, which is { $distance } mm from every clamp and more.
plan-pin-round = Round pin { $standard } at { $at }: Ø{ $diameter }{ $field } ({ $upper }; { $lower }) in the hole { $hole }, clearance { $least } to { $most } mm.
plan-pin-cut = Cut pin { $standard } at { $at }: Ø{ $diameter }{ $field } ({ $upper }; { $lower }) in the hole { $hole }, clearance { $least } to { $most } mm; its lands, { $land } mm wide, hold across the line to the round pin.
plan-pin-cut-alone = Cut pin { $standard } at { $at }: Ø{ $diameter }{ $field } ({ $upper }; { $lower }) in the hole { $hole }, clearance { $least } to { $most } mm; its lands, { $land } mm wide, hold along { $axis }.
plan-pin-pair = The pins are { $apart } mm apart. Every part goes on them while the tolerances of this distance, of the pins and of the holes together, are no wider than { $together } mm; the hole farthest from the round pin is turned aside by { $turned } mm at most.
plan-locating-error-pins = It costs { $least } to { $most } mm from part to part, the clearance of the round pin.
plan-knee = Knee: { $nose } mm from the table to the spindle nose with the ram up.
plan-zero-by-sides = { $frame }: touch the { $side } and the { $end } side with an arbor Ø d and read xM, yM: X = xM{ $right }, Y = yM{ $back }; about X{ $x } Y{ $y }.
plan-side-left = left
plan-side-right = right
plan-side-front = front
plan-side-back = back
plan-same-face = Along X this is the same face of the part as in set-up 1, now on the other side: the error of the length of the blank does not part the holes.
plan-lengths-measured = These lengths are sums from catalogs: measure each assembly and key in the length found.
plan-straps = Straps { $width } mm wide and { $length } mm long, outward over the nearest side; with their nuts no higher than { $height } mm over the face, tools go over them.
plan-studs = Their studs stand outside the part: where no slot of the table lies there, on a base plate, whose thickness belongs to fixture.height.
plan-straps-lower = Straps with their nuts must be lower than { $most } mm over the face, the height at which tools go by the file.
plan-zero-by-face = { $frame }: touch the face with the reference tool{ $tool } and read zM: Z = zM{ $face }; about Z{ $z } for the lengths of assemblies of this plan.
plan-start = Start and tool change at X{ $x } Y{ $y } of the drawing, the ram up; between the places of work { $level } mm over the face.
plan-start-to-clamp = The nearest clamp is { $away } mm from there.
plan-fixture-universal-straps = Universal fixture: straps on the table (1.6).
plan-fixture-universal-vice = Universal fixture: a vice (1.6).
plan-fixture-special-nothing = A special fixture is to be made (1.6): neither straps, nor a vice, nor a chuck hold the part.
plan-fixture-special-not-in-chuck = A fixture is to be made (1.6), or `holding: chuck` left out: the chuck that the file asks for does not hold the part.
plan-fixture-special-straps = A special fixture is to be made (1.6): under straps alone the part springs.
plan-fixture-special-pins = A special fixture is to be made (1.6): a steel plate with the pins of the part, straps on it.
plan-fixture-special-vice = A special fixture is to be made (1.6): in a vice the part springs.
plan-fixture-universal-chuck = Universal fixture: a three-jaw chuck on the table (1.6).
plan-fixture-special-chuck = A special fixture is to be made (1.6): in a chuck the part springs.
plan-fixture-specialised-chuck = A resettable chuck, for the whole group of parts (1.6).
plan-fixture-specialised-straps = A resettable fixture with straps, for the whole group of parts (1.6).
plan-fixture-specialised-vice = A resettable vice, for the whole group of parts (1.6).
plan-fixture-specialised-nothing = A resettable fixture, for the whole group of parts (1.6).
plan-keying-two-keys = On the table: two keys in its central slot, trued along it, the least accurate way (1.7 a).
plan-keying-coordinate-plate = On the table: pins in the holes of a coordinate plate (1.7 b).
plan-keying-cross-elements = On the table: by its cross slot or central hole (1.7 c).
plan-locating-three-planes = The part: by three planes, the one it lies on and two sides (1.9).
plan-locating-two-planes-and-hole = The part: by two planes and a hole (1.9).
plan-locating-plane-and-two-holes = The part: by a plane and two fine holes, the most accurate way (1.9).
plan-locating-plane-and-axis = The part: by its face and its axis; a disc has no sides to lie against.
plan-clamps-turned = X is counted as the part lies now: the other way than in the drawing.
plan-keying-play = It costs up to { $play } mm of play*.
plan-locating-error = It costs { $least } to { $most } mm from part to part*.
plan-fixture-special-own = A fixture of your own (1.6).
plan-own-fixture = { $name } holds the part. It must hold { $safety } times M = { $torque } N·m of { $surface } { $hole }.
plan-own-fixture-pushed = { $name } holds the part. It must hold { $safety } times M = { $torque } N·m of { $surface } { $hole }, and { $safety } times a side force of { $side } N.
plan-other-zero = { $frame }, of { $holes }, on each part anew: touch the { $side } and the { $end } side with an arbor Ø d and read xM, yM: X = xM{ $right }, Y = yM{ $back }; on a blank of nominal size the X and Y of { $first }. Z is that of { $first }.
plan-chain-hole = Holes
plan-chain-from = From
plan-chain-axis = Along
plan-chain-sum = Errors
plan-chain-worst = At worst
plan-chain-likely = Statistically
plan-chain-tolerance = Tolerance
plan-chain-closes = Chain
plan-chain-term = { $what } { $field }
plan-chains-how = Fields of error, mm; statistically: the root of the sum of their squares.
plan-supports-given = Set-up { $setup }: the part on supports of { $height } mm, as the file says.
plan-in-own = Set-up { $setup }: the part lies in its fixture { $height } mm over the table, as the file says.
plan-on-plate = Set-up { $setup }: the part on supports of the plate that its pins stand in, { $height } mm over the table, as the file says; the supports stand clear of the through holes.
plan-supports-assumed = Set-up { $setup }: the part on supports of { $height } mm, so that tools have room below it and the quill’s travel is enough; the file gives no height (fixture.height).
plan-supports-where = Supports stand under the clamps and beyond the outermost holes, so that no thrust tips the part, and clear of the through holes.
plan-supports-none = Set-up { $setup }: no supports are needed, no tool comes out below the part; the file gives no height (fixture.height).
plan-times = { $parts } = { $total } min
plan-time-machine = Machine time { $time }
plan-time-feed-out = other motions at feed { $time }
plan-time-dwell = dwells { $time }
plan-time-rapid = rapids { $time }
plan-time-change = tool changes { $time }
plan-time-hand = by hand at stops of the program { $time }
# Findings: how grave they are.
plan-impossible = impossible
plan-wrong = wrong
plan-doubtful = doubtful
plan-note = note
plan-of-pocket = pocket { $pocket }: { $finding }
plan-of-slot = slot { $slot }: { $finding }
# For the hole.
plan-hole-of = hole
plan-slot-of = slot
plan-of-hole = hole { $hole }: { $finding }
# Why a hole is made as it is.
explain-title = Hole { $hole } { $size }
explain-scheme = Scheme { $scheme } ({ $table })
explain-others = Other routes, and why they were not taken
explain-other-route = { $route }: { $why }
explain-other-route-timed = { $route }, { $time } min: { $why }
explain-made = { $operation } Ø{ $diameter }
explain-transition-only-elsewhere = { $number }. { $verb } Ø{ $diameter } on another machine
explain-transition-elsewhere = { $number }. { $verb } Ø{ $diameter } on another machine – { $designation }, { $holder }
explain-transition = { $number }. { $verb } Ø{ $diameter } – T{ $tool } { $designation }, { $holder }
explain-conditions = S = { $feed } mm/rev, V = { $speed } m/min, n = { $rpm } rpm
explain-decision = { $decision } [{ $rests }: { $place }]
explain-row = row { $row }
explain-seed = printed in the source
explain-standard = by a standard
explain-reconstructed = reconstructed
explain-reason = because: { $why }
explain-to-be-ground = * { $why }
explain-unconfirmed = * unconfirmed: { $why }
explain-not-taken = not taken: { $why }
explain-sources = Sources named by letters
explain-source = { $id }: { $source }
plan-bought = { $designation }, for H{ $it }
plan-bottoming-tap = { $designation }, bottoming, lead { $lead } P (form E of DIN 2197)
plan-pilot = { $designation }, pilot Ø{ $pilot }
plan-ground = { $designation }, ground from Ø{ $from } to Ø{ $to }
plan-ground-exactly = { $designation }, a new one ground down to Ø{ $to } itself
