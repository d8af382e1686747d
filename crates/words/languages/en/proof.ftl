# What is made and what is not.
not-made = { $hole }: { $operation } (T{ $tool }) is not made at { $count ->
        [one] one point
       *[other] { $count } points
    }: { $points }
    .help = { $count ->
        [1] add this point
       *[other] add these points
    }
cut-again = extra cut: at { $at } T{ $tool } goes to Z{ $z } again, and that is made already
    .help = remove the repetition
cut-not-planned = extra cut: at { $at } T{ $tool } goes to Z{ $z }, and that hole has no such transition
    .help = check the coordinates and the subprogram
cut-elsewhere = extra cut: at { $at } T{ $tool } goes to Z{ $z }, but there is no hole
    .help = check the coordinates and the subprogram
wrong-order = { $hole }: { $operation } at { $at } is made after a transition that follows it ({ $instead })
    .help = put the transitions of the hole in the plan's order
# Tools.
wrong-tool = { $hole }: { $operation } at { $at } is made by T{ $tool }, but T{ $needed } is needed
    .help = check T and H of this tool
program-tool-called = T{ $tool } is called, but { $hole }: { $operation } at { $at } needs T{ $needed }
program-tools-exchanged = T{ $tool } and T{ $needed } are exchanged: each is called for the work of the other
program-correctors-exchanged = offset registers H{ $corrector } and H{ $own } are exchanged: each tool cuts with that of the other
tool-unknown = the plan has no tool T{ $tool }
    .help = check T and H of this tool
tool-by-work = T{ $tool } of the program does the work of the plan's T{ $plan }
    .help = check what stands in the magazine
not-loaded = the plan's tool { $tool } is not put into place { $place }: there is no stop before it is called
    .help = put M00 before this tool
no-correction = T{ $tool } cuts without length offset; its H{ $own } is { $needed } (H{ $corrector } = { $value } acts)
    .help = turn it on: G43 H
wrong-correction = T{ $tool } cuts with H{ $corrector } = { $value }{ $whose ->
        [none] {""}
       *[tool] {""}, the offset of T{ $other }
    }, and its correction is H{ $own } = { $needed }
    .help = { $whose ->
        [none] check T and H of this tool
       *[tool] write H{ $own } where T{ $tool } takes its length, or T{ $other } where the tool is changed
    }
other-corrector = T{ $tool } cuts with H{ $corrector }, but its offset register is H{ $own }; the value is the same, { $value } of { $needed }
    .help = check T and H of this tool
wrong-sign = T{ $tool }: H{ $corrector } = { $value }, and { $needed } by the plan: the sign is the opposite
    .help = an offset register holds the tool's length minus that of the longest
feed-per-turn = { $hole }: { $operation } at { $at }: { $made } mm/rev instead of { $needed }
    .help = make F and S agree
changes-elsewhere = the tool is changed at { $at }, not at the place of the tool change
    .help = bring table and quill there before the change
no-corrector = T{ $tool } cuts without its offset register H{ $own }, which holds 0 only by convention
    .help = give its length offset: G43 H{ $own }
shared-corrector = T{ $tool } cuts with H{ $corrector } = { $value }, which is that of T{ $other }; the plan has H{ $own } = { $needed }
    .help = check T and H of this tool
correction-otherwise = H{ $corrector } = { $value } for T{ $tool }, but the plan has H{ $own } = { $needed }: heights are taken by the value given
    .help = check the length of the tool
# Dangerous motions.
rapid-across = a rapid across inside the part: to { $at } at Z{ $z }
    .help = leave the part first
through-obstacle = the way to { $to } is at Z{ $made }, and a clamp or an obstacle at { $at } stands up to Z{ $needed }
    .help = raise the tool over it first, or go round it
holder-through-obstacle = T{ $tool }: { $whose ->
        [holder] the holder { $own }
        [collar] the collar of the holder { $own }
       *[nose] the spindle nose
    }, Ø{ $diameter }, comes down to Z{ $made } beside a clamp or an obstacle at { $at } that stands up to Z{ $needed }
    .help = take a longer tool, or stand it farther away or lower
holder-unknown = { $tools }: how thick the holder { $own } is nobody says; if as thick as its collar, Ø{ $diameter }, it meets what stands at { $points }; worst at { $at }: T{ $tool } brings it down to Z{ $made } beside what stands up to Z{ $needed }
    .help = measure it: up to Ø{ $free } it passes everywhere (then say so in tables of your own, --with: max_diameter of its row); else stand what it meets { $aside } mm farther from its ways, or { $lower } mm lower
holder-into-part = T{ $tool }: the holder { $own }, Ø{ $diameter }, comes down to Z{ $made } at { $at }, and the face of the part is at Z{ $needed }
    .help = take a longer tool
rapid-into-part = a rapid into the metal at { $at } to Z{ $z }
    .help = go into the metal at feed
rapid-into-metal = { $hole }: { $operation } at { $at }: the feed begins at Z{ $made }, but the metal at Z{ $needed }
    .help = check the levels of the cycle, the zero and the offset register
tap-not-followed = at { $at } the thread is tapped without { $word } before: the spindle does not follow the feed
    .help = give { $word } with S before the tapping cycle
spindle-stands = at { $at } T{ $tool } cuts while the spindle is stopped
    .help = start the spindle: S and M03
wrong-turn = at { $at } T{ $tool } cuts while the spindle turns counterclockwise
    .help = a right-hand tool needs M03
slot-gouged = { $hole }: { $operation } at { $at }: the mill cuts { $made } mm beyond the slot on its way to { $to } at Z{ $z }
slot-uncut = { $hole }: { $operation } at { $at }: metal is left in the slot at { $to } at Z{ $z }
slot-plunge-aside = { $hole }: { $operation } at { $at }: the mill goes down beside the middle of the slot, at { $to } to Z{ $z }
slot = { $hole }: { $operation } at { $at }: a feed across in the metal to { $to } at Z{ $z }
    .help = check the coordinates and the subprogram
travel-low = the move to { $at } is at Z{ $made }, lower than Z{ $needed }
    .help = raise the tool before it goes on
# Levels.
too-shallow = { $hole }: { $operation } at { $at }: to Z{ $made }, but Z{ $needed } is needed
    .help = check the levels of the cycle, the zero and the offset register
less-overrun = { $hole }: { $operation } at { $at }: to Z{ $made } instead of Z{ $needed }, with less overrun
    .help = check the levels of the cycle, the zero and the offset register
into-table = { $hole }: { $operation } at { $at }: to Z{ $made }, but the table is at Z{ $needed }: the tool goes into the table
deeper = { $hole }: { $operation } at { $at }: to Z{ $made }, deeper than Z{ $needed }
    .help = check the levels of the cycle, the zero and the offset register
begins-lower = { $hole }: { $operation } at { $at }: the feed begins at Z{ $made }, with less approach than from Z{ $needed }
    .help = check the levels of the cycle, the zero and the offset register
begins-higher = { $hole }: { $operation } at { $at }: the feed begins at Z{ $made } instead of Z{ $needed }
    .help = check the levels of the cycle, the zero and the offset register
# Conditions.
other-speed = { $hole }: { $operation } at { $at }: { $made } rpm instead of { $needed }
    .help = use the value in the plan where the control lets you, or make sure that this one is right
other-feed = { $hole }: { $operation } at { $at }: feed { $made } mm/min instead of { $needed }
    .help = use the value in the plan where the control lets you, or make sure that this one is right
other-dwell = { $hole }: { $operation } at { $at }: a dwell of { $made } s instead of { $needed }
    .help = use the value in the plan where the control lets you, or make sure that this one is right
dwell-elsewhere = { $hole }: { $operation } at { $at }: a dwell of { $made } s not at the bottom
    .help = remove it, or make sure that it is intended
coolant-missing = { $hole }: { $operation } at { $at }: without coolant
    .help = switch the coolant on
coolant-superfluous = { $hole }: { $operation } at { $at }: with coolant, which is not in the plan
    .help = remove it, or make sure that it is intended
# Steps.
steps-not-planned = { $hole }: { $operation } at { $at }: in { $made } steps instead of one
    .help = take the cycle that the transition requires
step-too-large = { $hole }: { $operation } at { $at }: a step of { $made } mm, more than { $needed }
    .help = use the value in the plan where the control lets you, or make sure that this one is right
step-smaller = { $hole }: { $operation } at { $at }: a step of { $made } mm instead of { $needed }
    .help = use the value in the plan where the control lets you, or make sure that this one is right
step-clearance = { $hole }: { $operation } at { $at }: a step begins { $made } mm before the metal instead of { $needed }
    .help = use the value in the plan where the control lets you, or make sure that this one is right
step-return = { $hole }: { $operation } at { $at }: between steps to Z{ $made } instead of Z{ $needed }
    .help = take the cycle that the transition requires
# The way out.
out-at-rapid = { $hole }: { $operation } at { $at }: out at rapid, and it must be at feed
    .help = take the cycle that the transition requires
out-at-feed = { $hole }: { $operation } at { $at }: out at feed { $made } mm/min; rapid is enough
    .help = take the cycle that the transition requires
out-other-feed = { $hole }: { $operation } at { $at }: out at feed { $made } mm/min instead of { $needed }
    .help = use the value in the plan where the control lets you, or make sure that this one is right
out-too-high = { $hole }: { $operation } at { $at }: at feed up to Z{ $made }, from Z{ $needed } on rapid is enough
    .help = take the cycle that the transition requires
out-too-low = { $hole }: { $operation } at { $at }: at feed only up to Z{ $made }, but Z{ $needed } is needed
    .help = take the cycle that the transition requires
out-elsewhere = { $hole }: { $operation } at { $at }: the exit ends at Z{ $made } and not at Z{ $needed }
    .help = take the cycle that the transition requires
out-turning = { $hole }: { $operation } at { $at }: out while the spindle turns, and it must be stopped
    .help = take the cycle that the transition requires
out-standing = { $hole }: { $operation } at { $at }: out while the spindle is stopped
    .help = take the cycle that the transition requires
# Circles.
circle-missing = { $hole }: { $operation } at { $at }: { $count } circles are missing, the first at Z{ $z }
    .help = check the circle: level, radius, centre, sense
circle-superfluous = { $hole }: { $operation } at { $at }: an extra circle at Z{ $z }
    .help = check the circle: level, radius, centre, sense
circle-level = { $hole }: { $operation } at { $at }: a circle at Z{ $z }, but Z{ $needed } is needed
    .help = check the circle: level, radius, centre, sense
circle-radius = { $hole }: { $operation } at { $at }: a circle of radius { $made } mm at Z{ $z }, but { $needed } is needed
    .help = check the circle: level, radius, centre, sense
circle-centre = { $hole }: { $operation } at { $at }: the centre of the circle is { $made } at Z{ $z }
    .help = check the circle: level, radius, centre, sense
circle-sense = { $hole }: { $operation } at { $at }: the circle at Z{ $z } goes the other way round
    .help = check the circle: level, radius, centre, sense
circle-open = { $hole }: { $operation } at { $at }: only { $made } of a circle at Z{ $z }
    .help = check the circle: level, radius, centre, sense
circle-again = { $hole }: { $operation } at { $at }: { $made } circles at Z{ $z } instead of one
    .help = check the circle: level, radius, centre, sense
ways-between-circles = { $hole }: { $operation } at { $at }: { $made } straight moves across instead of { $needed }
    .help = remove it, or make sure that it is intended
ways-down = { $hole }: { $operation } at { $at }: { $made } moves down instead of { $needed }
    .help = remove it, or make sure that it is intended
oblique = { $hole }: { $operation } at { $at }: across and down at once to Z{ $z }
    .help = check the coordinates and the subprogram
not-in-the-middle = { $hole }: { $operation } at { $at }: a motion along Z at { $to } to Z{ $z }, not in the middle of the hole
    .help = check the coordinates and the subprogram
# Pauses.
no-stop-to-load = there is no stop to put tool { $tool } into place { $place }
    .help = put M00 before this tool
no-stop-to-turn-over = there is no stop to turn the part over
    .help = put M00 before this tool
no-stop-to-set-bar = there is no stop to set the bar to Ø{ $diameter }
    .help = put M00 before this tool
not-turned-over = the second set-up begins without a stop to turn the part over
    .help = put M00 before this tool
stop-for-nothing = a stop that the plan has not
    .help = remove it, or make sure that it is intended
# Around the cuts.
other-order = the points are not in the plan's order from { $at } on (there { $needed }): { $count } other places, path { $way } mm
    .help = compare with `technolog order`
idle-point = a motion to { $at }, where nothing is done
    .help = remove it, or make sure that it is intended
idle-height = a motion to Z{ $z }, which is not in the cycle
    .help = remove it, or make sure that it is intended
air-at-feed = over the part to Z{ $z } at feed { $made } mm/min; rapid is enough
    .help = remove it, or make sure that it is intended
travel-at-feed = the move to { $at } at feed { $made } mm/min; rapid is enough
    .help = remove it, or make sure that it is intended
travel-high = the move to { $at } is at Z{ $made }, higher than Z{ $needed }
    .help = remove it, or make sure that it is intended
travel-not-up = the move from or to the tool change ({ $at }) is at Z{ $z }, not with the quill up
    .help = raise the quill first
radius-correction = a radius compensation acts, which is not in the plan
    .help = cancel it: G40
approach-standing = the move down to Z{ $z } while the spindle is stopped
    .help = start the spindle before it: S and M03
dwell-in-air = a dwell of { $made } s over the part
    .help = remove it, or make sure that it is intended
turns-to-change = the spindle turns on the way to the tool change
    .help = stop the spindle: M05
correction-at-change = the length offset still acts at the tool change
    .help = cancel it: G49
turns-at-change = the spindle turns until the tool change
    .help = stop the spindle: M05
coolant-at-change = the coolant is on during a tool change
    .help = switch it off: M09
turns-at-end = the program ends and the spindle turns
    .help = stop the spindle: M05
coolant-at-end = the program ends and the coolant is on
    .help = switch it off: M09
ends-elsewhere = the program ends at { $at }, not at the place of the tool change
    .help = bring table and quill to the place of the change
no-end = the program does not come to its end
    .help = end the program with M02 or M30
