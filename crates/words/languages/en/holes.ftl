# Visiting the holes.
visiting-method = { $method } (grade { $it }, centre tolerance { $centre } mm, K_T = { $ratio })
position-lost-at-tool-change = section 1.3.1 finishes each hole without moving the part; this machine changes tools at X { $x } Y { $y }, which moves the table, so the rule cannot be kept: with { $tools } tools { $parallel } min in parallel, { $sequential } min in sequence
visited-in-parallel = by 1.3.1 the sequential method would be quicker, but changing tools at X { $x } Y { $y } moves the table: with { $tools } tools { $parallel } min in parallel, { $sequential } min in sequence
# Schemes.
stages = stages: { $stages } (Δ0 = { $delta } mm, σc = { $sigma } mm)
no-stages = the table gives no stages for grade { $it }
table-for-hole = grade { $it } is looked up in { $table } by the rows of grade { $asked-it }, centre tolerance { $centre } mm
cell = taken: { $take }
scheme = scheme { $scheme } (grade { $it }, { $roughness })
which-of-two = the cell offers { $schemes }; taken: { $take }
centre = centre-drill first: solid metal, { $ratio } diameters deep
no-centre = no centring is needed: grade { $it }, Ø{ $diameter }, { $ratio } D deep
twin = scheme { $scheme } with centring is scheme { $centred }
no-twin = scheme { $scheme } has no centred twin; centring is added
transitions = the transitions of scheme { $scheme }
no-scheme = the tables give no scheme: grade { $it }, { $roughness }, centre tolerance { $centre } mm; roughness columns { $columns }
no-route = { $diameter }: no scheme is possible ({ $tried } refused)
nearest-depth = the nearest depth at which this hole can be made here is { $depth } mm, not { $asked } mm
nearest-thickness = through a blank of { $depth } mm this hole can be made here, not through { $asked } mm
nearest-machine = on the machine { $machine } this hole can be made as drawn
finish-elsewhere = the tables finish this hole on a machine of another type: scheme { $scheme } leaves { $stock } mm on the diameter for it, and grade, roughness and position are that machine's to reach
grade-without-distance = centre_tolerance: IT{ $it } needs two holes in the group; give the width in mm
grade-outside-table = IT{ $it } at a centre distance of { $distance } mm is outside the table: { $why }
point-breaks-through = the point of the drill Ø{ $diameter } reaches { $depth } mm, and the blank is { $limit } mm thick: the blind hole breaks through
spot-too-deep = the spot Ø{ $diameter } is { $depth } mm deep, and the hole { $limit } mm
countersink-too-deep = the front of the countersink for Ø{ $diameter } comes { $depth } mm deep, and the hole is { $limit } mm deep: it would meet the floor
too-heavy = mass { $mass } kg, and the machine takes { $limit } kg at most
plate-too-heavy = a solid blank of this size weighs { $mass } kg, and the machine takes { $limit } kg at most: give `mass` if the blank is lighter
not-planned = { $operation }: not planned here
rows-rejected = rows by the column “{ $column }”: { $rows }
# Diameters.
allowance = { $operation }: allowance { $taken } mm on diameter, range { $low }–{ $high } mm
ground-to-size = the catalog's Ø{ $nominal } cutter, made to Ø{ $size }
rough-boring = rough boring: { $stock } mm on diameter in passes: { $passes }, { $low }–{ $high } mm each at most
nearest-grade = the same hole is possible at grade { $it } with { $roughness }
finer-than-this-machine = no route on this machine holds grade { $it } and { $roughness }: the hole is left at Ø{ $from }, and { $operation } on another machine takes the { $stock } mm that are left on the diameter; grade and roughness are that machine's to reach
finer-elsewhere = { $operation } on another machine reaches grade { $it } and { $roughness }
stock-left = { $operation } finds { $least } to { $most } mm on the diameter
stock-for-elsewhere = { $stock } mm on diameter left for the other machine
one-pass = drill Ø{ $diameter } in one pass
two-passes = drill in two passes: Ø{ $first } first, then Ø{ $diameter } (first drill { $low }–{ $high } mm)
first-drill = first drill Ø{ $first }: { $share-min }–{ $share-max } of Ø{ $diameter }
two-passes-cost = against one drill: { $time } min per hole, thrust { $thrust } N instead of { $one-thrust } N
bored-by-stand-in = Ø{ $diameter } is too small for a boring bar (from Ø{ $smallest }); { $instead } is done instead of boring
too-small-to-bore = { $operation }: Ø{ $diameter } < Ø{ $smallest }, the smallest hole a bar enters
no-drill = no drill Ø{ $diameter } that reaches{ $sides ->
        [below] ; the largest below it is { $below }
        [above] ; the smallest above it is { $above }
        [none] {""}
       *[both] ; the nearest are { $below } and { $above }
    }
no-drill-in-allowance = { $operation } to Ø{ $diameter }: no drill from Ø{ $low } to Ø{ $high }
no-drill-before-boring = boring to Ø{ $diameter }: no drill from Ø{ $smallest } to Ø{ $largest }
no-bar-enters = boring to Ø{ $diameter }: no bar that reaches so deep enters the hole Ø{ $hole } and is set to Ø{ $hole } + { $most } mm of its first pass or less
bar-set-by-hand = boring in several passes: the bar is reset by hand between them; large holes are better milled (1.2.1)
spot-by-drill = spot Ø{ $spot }: { $share } of the drill Ø{ $drill }
spot-by-depth = spot Ø{ $spot }, not { $share } of the drill Ø{ $drill }: no deeper than half of the hole
spot-by-chamfer = spot Ø{ $spot } makes the chamfer too
travel = approach { $approach } mm, overrun { $overrun } mm
# Of any row.
unconfirmed-counted = figures rest on { $count ->
    [one] one row
   *[other] { $count } rows
} that nothing confirms, of { $tables-count ->
    [1] table
   *[other] tables
} { $tables }: `--all-problems` lists { $count ->
    [one] it
   *[other] them
}
to-be-ground = { $table }, row { $row }: { $why }
unconfirmed = unconfirmed: { $table }, row { $row }: { $why }
names-look-alike = { $count } groups are named { $name }: their letters look the same, but some are Latin and some Cyrillic; write all names in one alphabet
