# Figures.
audit-figure = does not come out of the formula
audit-decimal-point = the decimal point is in the wrong place
audit-sign = the sign is the opposite one
audit-follows = follows from { $fields }
audit-ground = the catalog of this designation has { $own } mm: it must be ground down to { $size } mm
audit-bought = the catalog of this designation has { $own } mm: bought for the right field H it leaves { $size } mm
audit-no-such-reference = no assembly has that length: the reference tool is one of the plan's assemblies
audit-sign-by-g44 = the sign for G44; neither plan nor program says G43 or G44; for G43 it is the opposite one
audit-other-corrector = { $tool } uses offset register { $corrector }, but every other tool uses the register of its own number
audit-tools-exchanged = { $tool } and { $other } are exchanged: each suits what the other is to make (rows { $rows })
audit-two-sizes = { $tool } is to leave Ø{ $size } here and Ø{ $other } in row { $row }: one tool of this kind leaves one size
audit-correctors-exchanged = { $tool } and { $other } have each the offset register of the other's number
audit-exchanged = it is exchanged with that of row { $other }
audit-exchanged-figures = it is exchanged with this figure: { $other }
audit-card-row = it stands in the row of { $operation } Ø{ $diameter } of the card
audit-untried = of { $total } mixtures of stated and right figures only { $tried } were tried: it may follow from others after all
audit-order-opening = { $operation } needs the hole for its pilot, and { $instead } comes only in row { $row }
audit-scheme-transitions = scheme { $stated } is { $printed }, and the rows are { $transitions }
audit-program-left-out = T{ $tool } works at other points of { $hole } and leaves out { $points }
audit-exchanged-tool = it is exchanged with that of T{ $other }
audit-program-short = { $hole }: no cut goes down to { $depth } mm at { $points }; the deepest there is { $reached } mm deep
audit-program-inches = the points of the program are those of the drawing in inches: G21 is missing, or G20 too many
audit-by-table = { $share } % of the { $value } that the tables give
audit-clamp-not-largest = it was computed for M = { $torque }, but the largest force is needed by row { $row }: M = { $other }
audit-mistake = this is what comes out if { $mistake }
audit-mistake-row = this is what comes out if { $mistake } (row { $row })
audit-overhang = by the note of section 5.2 item 5 the overhang is { $least } to { $most } mm
audit-no-step = no step of the machine (its neighbours are { $below } and { $above }); for the computed { $computed } it is { $step }, and the stated value is { $excess } % off
audit-step-fast = { $excess } % above the computed { $computed }: tool life falls; the rule gives { $step }
audit-step-lost = { $excess } % from the computed { $computed }, as if a nought were lost; the rule gives { $step }
audit-step-slow = { $excess } % from the computed { $computed }: safe but slower; the rule gives { $step }
audit-not-in-series = no step of the machine: its neighbours are { $below } and { $above }
audit-outside-series = the spindle of the machine turns at { $least } to { $most } rpm
audit-series = the machine's series of speeds
audit-step-rule = how a step of the series is chosen
audit-limit = a limit of the machine
audit-tool-change = the time of one change
audit-rank = rank { $rank }
audit-beyond-machine = beyond the machine's limit of { $limit } ({ $quantity })
audit-clamps = the clamping is not symmetric: section 5.2 item 7 recommends { $needed } clamps
audit-load-low = { $share } % of the { $load } that the handbook's formulas give at a feed of { $feed } mm/rev: whatever is calculated from it may be too weak
audit-load-high = { $share } % of the { $load } that the handbook's formulas give at a feed of { $feed } mm/rev
# Designations.
named = the row of the catalog
audit-designation-misprinted = no catalog has { $tool }; probably { $known } without its beginning
audit-designation-unknown = no catalog has { $tool }; the nearest is { $known }
audit-designation-alien = { $tool } cannot be checked: no catalog has it
audit-designation-unchecked = { $tool } cannot be checked: no catalog has it; the nearest is { $known }
audit-designation-printed = the textbook prints { $tool } so; in its own table it is { $known }
audit-standard-printed = the textbook prints { $standard } so; the standard is { $known }
audit-clamping-other = the textbook has { $value }; handbooks of fixtures have other figures, so what is computed from this one stands
audit-dimensions-of = the dimensions stated are not those of { $tool } but of { $known }: the designation is the slip
audit-tool-table = { $tool } stands in { $known }, not in { $table }
audit-standard-misprinted = the standard { $standard } is misprinted: the catalog of this designation is of { $known }
audit-standard-other = { $standard } is not the standard of this designation: its catalog is of { $known }
audit-standard-unchecked = the standard { $standard } cannot be checked: the catalog names none
audit-shank = the shank is not { $shank }: in the catalog of this designation it is { $name }
audit-no-catalog = { $designation }: there is no catalog of it, so it was not checked
tool-of-other-operation = { $tool } is not for { $operation } but for { $transitions }
tool-of-other-size = { $tool } is Ø{ $own }, but the transition needs Ø{ $needed }
holder-of-other-shank = { $holder } does not hold { $tool }: its shank is { $shank }
# The route.
audit-hole-not-made = no transition makes the group ({ $count } holes)
audit-slot-not-checked = it is a slot: its mill, its width and its loads are checked, its passes and speeds are not
audit-hole-not-made-either = no transition makes the group ({ $count } holes); the program finds no route for it either
audit-order = { $operation } stands after row { $row } ({ $instead }), but by section 1.1.2 it comes before
audit-not-opened = the transition leaves Ø{ $diameter }, but the hole is Ø{ $before } already
audit-last-diameter = the last transition leaves Ø{ $diameter }, but the drawing requires { $hole }
audit-scheme-unknown = the tables give no scheme { $stated }; the best is { $way ->
        [search] of the search: { $scheme }
        [complex] complex { $scheme } ({ $table })
       *[table] scheme { $scheme } ({ $table })
    }
audit-scheme-table = the scheme is not of table { $stated }; it stands in { $table } ({ $scheme })
audit-route-dominated = the route is possible but ranks { $rank }, longer by { $slower } min; better is { $way ->
        [search] of the search: { $scheme }
        [complex] complex { $scheme } ({ $table })
       *[table] scheme { $scheme } ({ $table })
    }: { $better }
audit-route-as-good = the route ranks { $rank }, longer by no more than { $slower } min: as good as { $way ->
        [search] that of the search: { $scheme }
        [complex] complex { $scheme } ({ $table })
       *[table] scheme { $scheme } ({ $table })
    }: { $better }
audit-route-refused = the route "{ $transitions }" is not possible; the best is { $way ->
        [search] of the search: { $scheme }
        [complex] complex { $scheme } ({ $table })
       *[table] scheme { $scheme } ({ $table })
    }
audit-route-unknown = the tables give no route "{ $transitions }"; the best is { $way ->
        [search] of the search: { $scheme }
        [complex] complex { $scheme } ({ $table })
       *[table] scheme { $scheme } ({ $table })
    }
audit-tool-changes = { $changes } tool changes ({ $order }) where { $needed } are enough: { $time } min too much
# Clamping, lengths, magazine.
audit-no-screw = the table has no screw { $screw }: { $known }
audit-screw-weak = the screw { $screw } bears { $bears } N, but { $force } N are needed
audit-screw-large = the screw { $screw } is larger than { $force } N needs
audit-same-corrector = offset register { $corrector } is already used by { $other }
audit-magazine = { $tools } tools, but the magazine has { $places } places
# A plan of ours, changed.
audit-not-ours = { $field }: stated { $stated }, but `technolog plan` gives { $right }
audit-tool-of-transition = the transition names { $tool }, but the tool T{ $number } is { $other }
# What is missing.
audit-missing = { $section }: { $what }
# Beside the handbook's formulas.
audit-by-formula = { $share } % of the { $value } that the handbook's formula makes of what is stated
audit-tool-life = { $share } % of the { $value } min for which the handbook gives speeds at this diameter
# The working zone.
audit-zone-turned = turned by 90°, the holes would span { $span } ≤ { $travel } mm along { $axis }
audit-blank-off-table = the blank along { $axis } is { $size } mm, the table { $table } mm: { $over } mm overhang; turn it, or use a fixture
audit-zone-over = the assembly does not pass over the part: { $length } + approach { $approach } + part { $thickness } + fixture { $fixture } = { $needed } > { $most } mm from table to spindle nose; an assembly of up to { $fits } mm would pass
audit-zone-under = the quill does not bring the tool to the bottom: assembly of T{ $other } { $longest } − { $length } + approach { $approach } + depth of the tip { $depth } = { $way } > { $travel } mm of travel; an assembly of { $fits } mm or more would do
audit-zone-low = the quill does not bring the tool to the bottom: spindle nose at least { $least } over the table − { $length } − bottom { $lowest } = { $way } > { $travel } mm of travel; an assembly of { $fits } mm or more would do
audit-zone-unknown = the height was not checked: the record of the machine has no distance from table to spindle nose
# The reach.
audit-holder-hits = the tip goes { $needed } mm below the face and the tool stands { $reach } out of its holder: the holder would hit the part
audit-flute-short = the flutes are { $reach } mm long; depth, point and overrun need { $needed } mm
# Clamps.
audit-clamp-standard = { $standard } is not the standard of the clamp { $designation }: it is of { $known }
audit-clamp-screw = { $screw } is not the screw of the clamp { $designation }: it has { $known }
audit-impossible = { $text } cannot be the { $name }: { $must }
audit-column-unread = “{ $column }” was not read: no column or line of a plan is called so
audit-column-read-as = column “{ $column }” was read as { $meant }, as in a program
audit-list-without-part = the list names no part, material or machine: designations, tools, holders and arithmetic were judged; feeds, speeds and the steps of the spindle were not
    .help = name the part, `--part PART.yaml`, or write the material and the machine above the table
audit-list-without-material = the list names no part and no material: feeds, speeds and loads were not compared with the tables
    .help = name the part, `--part PART.yaml`, or write the material above the table
audit-list-without-machine = the list names no part and no machine: the steps and the limits of the machine were not asked
    .help = name the part, `--part PART.yaml`, or write the machine above the table
audit-list-with-both = the list names no part: routes, lengths and whatever depends on the drawing were not judged
    .help = name the part: `--part PART.yaml`
