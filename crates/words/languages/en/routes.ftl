# The three ways.
auxiliary-scheme = scheme { $scheme } for the hole `{ $kind }`
no-auxiliary-scheme = A.10 gives no scheme: { $kind } Ø{ $diameter }, centre tolerance { $centre } mm
complex = complex { $complex } for the hole `{ $kind }`
complex-transitions = the transitions of complex { $complex }
no-complex = A.4 gives no complex: grade { $it }, Ø{ $diameter }, centre tolerance { $centre } mm
no-complex-group = A.4 has no group for a hole of grade { $it }, Ø{ $diameter }, tolerance { $centre } mm: it is for solid metal, grades 7–9 and 12 and coarser
searched = found by the search over the states: { $transitions }
searched-step = a transition that may follow: { $operation }
no-path = no chain of transitions reaches grade { $it } and { $roughness }
state-unreachable = nothing leads to the state { $state } at Ø{ $diameter }
bored-by-another = { $operation } is another transition's work here
no-centre-in-a-hole = no centring: there is a hole already (grade { $it }, Ø{ $diameter }, { $ratio } D)
# What a route holds.
reaches = reaches grade { $it }, { $roughness }
rough-face = drilling into an unmachined face costs { $percent } % of the accuracy of centre distances; the tables are queried with a tighter tolerance
misses-grade = by the tables it reaches grade { $it }, but { $asked } is required
misses-roughness = by the tables it reaches { $roughness }, but { $asked } is required
chamfer-inside-thread = the chamfer Ø{ $diameter } is narrower than the thread { $thread }: it does not guide the tap
reaches-again = the same again by a wider tool: grade { $it }, { $roughness }
reaches-by-itself = prepares the next transition: by itself grade { $it }, { $roughness }
reaches-no-worse = prepares the next transition and makes nothing worse: grade { $it }, { $roughness }
reaches-before-next = leaves IT{ $it }, { $roughness } of the range of its row: another transition follows, which leaves no finer
reaches-thread = thread: { $roughness }
drills-too-short = the largest drill that fits, Ø{ $diameter }, reaches { $reach } mm, and { $needed } mm are needed with its point and room for chips
bought-for = { $operation } to Ø{ $size }: the cutter of Ø{ $nominal } must be one bought for H{ $it }, not worn: one for a finer field leaves the hole too small
promised-finer = { $table } promises grade { $it }, and by A.1 these transitions give { $own }
misses-position = the position of the axis is within { $position } mm, and { $asked } mm are permitted
misses-axis = the tool follows the axis of the cast hole, whose core may be shifted by { $shift } mm, and { $asked } mm is permitted
misses-floor = too much of it stays unfinished above the flat floor
misses-unknown = the tables do not say what it reaches
not-bored = the position of the axis requires boring (1.2), but no boring bar can be used here; the route does not bore, and a reamer keeps the axis of the drill. A jig-boring machine, a drill bushing or a solid carbide drill holds it closer (hole-position-reach)
position-asks-boring = does not bore, though the permitted position is { $position } < 0.1 mm (1.2)
boring-not-asked = bores, though the permitted position { $position } ≥ 0.1 mm does not require it (1.2)
finished-here = leaves the finish to another machine, and another route finishes the hole here
not-surely-finished-here = the tables leave the finish of this hole to another machine, and this route holds the drawing at best or not at all
milled-not-round = milled to Ø{ $diameter }: the machine's roundness is { $roundness } mm, its share of the tolerance { $most } mm
# Why a route lost.
lost-by-time = longer by { $slower } min
lost-by-little = longer by { $slower } min, less than { $percent } % of the time: as good
lost-by-floor = leaves { $left } mm unfinished over the flat floor, not { $instead } mm
lost-by-borrowing = shorter by { $quicker } min, but then the route of another hole has no drill to borrow
lost-by-two-passes = shorter by { $quicker } min, but its drill would be there for another hole, too, which the rule then drills in two passes
lost-by-order = equal time; later in the order of methods
ranked-later = the tables rank it after { $first }, which is possible
same-as = the same route as { $table } { $same }
# Diameters.
core-drill-stock = a core drill is left { $stock } mm on diameter of Ø{ $nominal }
handbook-step = the handbook's step Ø{ $advised }; taken Ø{ $taken } (1.2.1: { $low }–{ $high })
handbook-step-outside = the handbook's step Ø{ $advised } is outside 1.2.1 ({ $low }–{ $high }) or the drills' series; taken Ø{ $taken }
handbook-step-lower = the handbook's step Ø{ $advised } is for a field H; this one lies lower: taken Ø{ $taken } (1.2.1: { $low }–{ $high })
handbook-first-drill = the handbook drills Ø{ $first } first, then Ø{ $diameter }
milled-instead = Ø{ $diameter } is large: milled instead of the first boring (contouring control)
no-drill-before = { $operation } to Ø{ $diameter }: no drill leaves it stock (up to Ø{ $largest })
no-counterbore-in-allowance = { $operation } to Ø{ $diameter }: no cutter of Ø{ $low }–{ $high } for it leaves the allowance
step-finished-elsewhere = the tables finish the step { $diameter } on another machine; stock is left for it here
no-hole-to-open = { $operation }: there is no hole to open
stock-too-small = { $operation } from Ø{ $start } to Ø{ $diameter }: the stock is { $stock } mm, and the tool cuts from { $least } mm on
tapped-at-once = the blank's hole Ø{ $start } is that for the thread { $thread } already: it is only tapped
opened-already = { $operation } to Ø{ $diameter }: the hole is Ø{ $start } already
stock-outside-allowance = { $operation } to Ø{ $diameter }: stock { $stock } mm is outside { $low }–{ $high } mm
no-thread-to-tap = this hole has no thread
# The rest of a hole.
edge = edge: to Ø{ $diameter }, { $depth } mm deep
flat-floor = flat floor: the drill stops at { $stop } mm, a mill levels it at { $depth } mm
floor-not-flat = the floor cannot be made flat: the drill's cone stays
free-floor-flat = no route leaves the cone of a drill: the free floor is made flat
flat-under-thread = for a thread { $depth } mm deep the hole is drilled to { $drilled } mm, with a cone: no flat floor at { $depth } mm; write `bottom: free`
too-shallow-for-flat = the hole is { $depth } mm deep, shallower than the point of the drill Ø{ $diameter }
no-flat-opening = Ø{ $diameter }: no cutter leaves a flat shoulder{ $sides ->
        [below] ; the largest below it is { $below }
        [above] ; the smallest above it is { $above }
        [none] {""}
       *[both] ; the nearest counterbores are { $below } and { $above }
    }
no-opening = Ø{ $diameter }: nothing opens it from Ø{ $start }
step-too-deep = the step is { $depth } mm deep, and the blank is { $limit } mm thick
groove-not-axial = no axial tool makes the groove Ø{ $diameter }, { $width } mm wide, { $depth } mm deep: it needs a recessing tool on another machine
thread-chamfer = a chamfer of the pitch, { $pitch } mm, for the thread
thread-of-step = thread { $thread } on the step
tap-elsewhere = thread { $thread }: the machine { $machine } cannot tap; the last transition is on another machine, for one on { $other }; its conditions are a guide
no-machine-taps = thread { $thread }: the machine { $machine } cannot tap, and no machine of the tables can; the conditions of the last transition are a guide
tap-nowhere = thread { $thread }: the machine { $machine } cannot tap, and none of the tables taps it (on { $other }: { $why }); find a machine that does, or mill or turn the thread
second-setup = steps from the back face: a second set-up after turning the part over; coordinates are those of the first
# Tools.
step-drill = a step drill Ø{ $narrow }/Ø{ $wide } makes both diameters with one stroke
no-step-drill = there is no step drill Ø{ $narrow }/Ø{ $wide }
cutter-ground-down = the catalogs lack this size: Ø{ $own } ground down to Ø{ $size }
mill-too-large = { $tool } ({ $table }): Ø{ $diameter } is more than Ø{ $limit }, the machine's largest end mill
tool-too-wide = { $tool } ({ $table }): Ø{ $diameter } is more than Ø{ $limit }, the widest the magazine takes
assembly-too-heavy = assembly with { $holder }: mass { $mass } kg, and { $limit } kg are allowed
second-opinion = public speed tables have { $low } to { $high } m/min; the formula gives { $formula } m/min, { $percent } % of their usual speed
second-opinion-softer = public speed tables end below this hardness; at HB { $hardness }, the hardest that they have, they end at { $high } m/min; the formula gives { $formula } m/min, { $percent } % of the usual speed there
practice-speed = the speed of practice is taken: { $speed } m/min
no-teeth-in-middle = { $tool } ({ $table }): the end teeth of this mill do not reach its middle, so Ø{ $diameter } cannot go straight down into metal
no-teeth-over-hole = { $tool } ({ $table }): the end teeth of this mill do not reach its middle, and over this hole only mills up to Ø{ $widest } of that kind can go straight down
does-not-pass = { $tool } ({ $table }): Ø{ $diameter } ≥ Ø{ $within } of the step it would have to pass
pilot-wider-than-hole = { $tool } ({ $table }): its pilot bore Ø{ $pilot } > Ø{ $hole }: the middle would be left standing
chamfered-by-centring = centring makes the chamfer here: a step drill has nothing to add
chamfer-in-countersink = a chamfer of { $chamfer } mm and a countersink at the same edge: keep one of them
promised = the scheme table promises grade { $it }; by A.1 this chain gives { $own }
no-drill-so-large = a drill Ø{ $diameter } > Ø{ $limit }, the largest the machine takes
no-mill-enters = no end mill of the tables enters a width of { $hole } mm with { $clearance } mm of room
no-tap = no tap { $thread } in the { $tables-count ->
        [1] table
       *[other] tables
    } { $tables }
no-taper-reamer = the cone 1:{ $ratio } to Ø{ $diameter } takes a taper reamer after drilling in steps, and the catalogs have none, for no page at hand gives their lengths: the cone stays undone; plan the cylinder here and ream the cone by hand
no-cone-of-angle = no countersink of { $angle }° (to Ø{ $diameter }); the { $tables-count ->
        [1] table
       *[other] tables
    } { $tables } { $tables-count ->
        [1] gives
       *[other] give
    } { $angles }°
no-cone-so-pointed = no countersink of { $angle }° to Ø{ $diameter } for a hole Ø{ $hole }: of those that wide in the { $tables-count ->
        [1] table
       *[other] tables
    } { $tables } the front is Ø{ $tip } and more, and it must enter the hole
no-cone-so-wide = no countersink of { $angle }° to Ø{ $diameter } for a hole Ø{ $hole }: the widest of the { $tables-count ->
        [1] table
       *[other] tables
    } { $tables } is Ø{ $widest }
overhang-tap = a tap stands out { $free } mm
thread-outside-chuck = thread { $thread } is outside the chuck's { $low }–{ $high }
magazine-reloaded = { $tools } tools for { $places } places: { $count ->
        [1] T{ $last } is
       *[other] T{ $first } to T{ $last } are
    } loaded by hand after the earlier ones have finished ({ $loads } loads of the magazine)
