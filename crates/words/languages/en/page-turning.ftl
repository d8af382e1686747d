# What all pages of turning say.
turn-by-row = { $said } (`{ $table }`, row { $row }; { $place })
turn-by-table = { $said } (`{ $table }`; { $place })
turn-findings = Findings
turn-figure = The half section; the free end is on the right.
turn-map-figure = The same as a plot; L/D on a logarithmic scale.
turn-figure-seen = The drawing of this page; -o FILE.html shows it
turn-material = Material
turn-blank-label = Blank
turn-blank = { $kind } Ø{ $diameter } × { $length } mm, { $holding }
turn-blank-with-bore = { $kind } Ø{ $diameter }/{ $bore } × { $length } mm, { $holding }
turn-scheme = Scheme
turn-passes = Passes
turn-cutting = Cutting path
turn-time = Time
turn-zone = Zone
turn-depth = Depth
turn-length = Length
# Names that surfaces have by their place on the contour.
surface-outer = outer
surface-inner = inner
# The page of a stepped shaft.
turn-steps = Steps from the free end
turn-levels = Levels, up to { $depth } mm deep
turn-slices = Slices, up to { $depth } mm deep
turn-objective = Objective
turn-least-path = the shortest cutting path
turn-least-path-and-passes = the shortest cutting path; each pass counts as { $per_pass } mm
turn-least-time = the shortest time
turn-fewest-passes = the fewest passes
turn-equal-division = The stock between shoulders is divided equally.
turn-rich-moves = Rich moves: a pass may stop anywhere on the grid and take less than the full depth.
turn-ways = Ways of roughing
turn-ways-name = Way
turn-ways-refused = × { $way }: { $why }
turn-ways-leaves = { $way } leaves metal for a finishing pass: { $what }
turn-ways-program = Its program: `--show program --variant { $name }`; every way of the table is written so, if it is safe.
turn-path = Cutting path
turn-passes-across = Transverse passes
turn-proven = Proven: on the grid of { $radii } { $radii ->
        [one] radius
       *[other] radii
    } and { $zs } Z no sequence is better.
turn-bounded = On the grid of { $radii } { $radii ->
        [one] radius
       *[other] radii
    } and { $zs } Z no sequence can be below { $bound }; the one shown is the best found.
turn-optimum = The optimum, pass by pass
turn-direction = Direction
turn-why = Why
turn-recommended = Recommendation
turn-levels-and-zones = Levels and zones (lecture 12.4)
turn-limiting-depth = Limiting depth of cut { $limit } mm; passes of the cycles are { $depth } mm deep, the last one what is left.
turn-from-diameter = from Ø
turn-scheme-of-passes = Scheme of passes
turn-levels-key = t: stock on one side, i: number of passes.
turn-horizontals = Horizontals from Z { $z }: Ø{ $diameters }.
turn-whole-zone = The whole zone: { $zone }; { $schemes }.
turn-idle = Idle path
turn-scheme-is = { $scheme }: { $what } ({ $place })
turn-points = Support points: { $points }.
# The map over length to diameter.
turn-map = { $shaft }: how far the variants are above the optimum as the shaft is stretched
turn-map-above = { $variant }, above the optimum
turn-map-best = Best of the three
turn-map-along = From L/D = { $ratio } on longitudinal passes alone are no worse than transverse ones alone.
turn-map-across = From L/D = { $ratio } on transverse passes alone are better than longitudinal ones alone.
# The page of an operation.
turn-machine = Machine
turn-no-lathe = no lathe is named
turn-set-ups = Set-ups and surfaces (lecture 12.1)
turn-set-up = Set-up { $number }
turn-contour-outer = Outer contour
turn-contour-inner = Inner contour
turn-surface = Surface
turn-surface-kind = Kind of surface
turn-all-main = All surfaces are main elements.
turn-rest-main = All are main elements except those below.
turn-finish-allowance = Finishing allowance
turn-sized = { $surface }: { $drawn } is { $least } to { $most } mm, the program makes { $made }
turn-later = { $surface }: { $operation } follows, { $allowance } mm are left for it
turn-allowances = Allowances (lecture 12.2)
turn-set-up-column = Set-up
turn-side = Side
turn-side-outer = outer
turn-side-inner = inner
turn-allowance-rough = 1: rough
turn-allowance-additional = 2: additional elements
turn-allowance-finish = 3: finish
turn-rough-volume = Rough volume
turn-unit-mm2 = mm²
turn-unit-cm3 = cm³
turn-zones = Zones and tools (lecture 12.3)
turn-zone-kind = Kind of zone
turn-zone-face = face
turn-zone-inner = { $zone } inner
turn-tool = Tool
turn-no-tool = none
turn-limit = t_lim
turn-depth-of-pass = t_p
turn-zones-key = t_lim: limiting depth of cut, t_p: depth of a pass; φ, φ1: the angle needed ≤ that of the tool.
turn-of-zone = zone { $zone }: { $said }
turn-limits = zone { $zone }: at a feed of { $feed } mm/rev the depth is limited by { $bound }; all limits, mm: { $bounds }
turn-bound = { $bound } { $depth }
turn-tool-refused = zone { $zone }: { $tool } does not fit: { $why }
turn-closed-zones = Additional elements: closed zones
turn-closed-zone = Z { $from } → { $to } of set-up { $number }
turn-transitions = Schemes of rough transitions (lecture 12.4)
turn-work = Zone { $zone }, Z { $from } → { $to }
turn-depth-of-work = Depth of a pass t_p = { $depth } mm.
turn-conditions = f = { $feed } mm/rev, V = { $speed } m/min, n = { $rpm } rpm, { $rate } mm/min.
turn-conditions-with-force = f = { $feed } mm/rev, V = { $speed } m/min, n = { $rpm } rpm, { $rate } mm/min; Pz = { $force } N, N = { $power } kW.
turn-even = with an even allowance: { $best }
turn-scheme-refused = scheme “{ $scheme }” refused: { $why }
turn-support-point = { $name }: Ø{ $diameter }, Z { $z }
turn-support-points = support points: { $points }
turn-taken-by-rule = taken: “{ $scheme }”, which the file or the rule of the zone names; “{ $quicker }” is quicker
turn-taken = Taken
turn-beside = Feed in air
turn-rapid = Rapid
turn-ridges = Ridges
# The jobs of a set-up, tool after tool.
turn-jobs = Jobs, tool by tool
turn-job = Work
turn-job-nose = r
turn-job-of = set-up { $number }
turn-job-feed = f
turn-job-time = Set-up { $number }: cutting { $cutting } min, rapids { $rapids } min, { $count ->
        [one] tool change
       *[other] tool changes
    } ({ $count }) { $changes } min, spindle starts { $starts } min, loading and unloading { $load } min; { $total } min in all.
turn-job-time-without = Cutting and rapids are those of the program; times of changes, starts and loading are rows of `chuck-and-tailstock`, unless the record of the lathe has its own; starts and loading are not confirmed. The ways to the change position of the turret and back are not in them: the setter chooses where it is.
turn-does-face = face
turn-does-centre = centre
turn-does-drill = drill
turn-does-flatten = flatten the bottom
turn-does-countersink = countersink
turn-does-core-drill = core-drill
turn-does-ream = ream
turn-does-rough = rough
turn-does-finish = finish
turn-does-groove = groove
turn-does-thread = thread
turn-does-tap = tap
turn-does-part-off = part off
turn-total = In all
turn-total-of = { $count } rough { $count ->
        [one] transition
       *[other] transitions
    }: cutting path { $cutting } mm, time { $time } min.
# The programs of an operation.
turn-program = { $number }: set-up { $set_up }, { $count ->
        [one] tool
       *[other] tools
    } { $tools }
turn-program-not-written = { $program }: { $why }
turn-one-of-programs = this is program { $number } of { $of }, for set-up { $set_up } only; for the others: { $others }
turn-written-despite = What was asked for is written all the same: it does not make the whole part, and must not be run before the errors are mended.
turn-no-such-program = there is no program of this number
turn-programs-are = give one of these with --number: { $known }
turn-norm-outside = Outside diameters and outer threads: no table at hand has a time to gauge them, so it is not in the norm.
turn-no-programs = there is no program, because no zone of the part could be planned
turn-see-operation = `technolog turn FILE --show operation` says why
turn-tool-not-written = { $tool }: { $why }
# The setting sheet of a lathe.
turn-setting-zero = Control: { $control }. Z 0 is the finished face of the free end, X 0 the axis. The programs lead the theoretical point of each tool, already offset for its nose: nothing is compensated on the control.
turn-setting-stand = Set-up { $number }: { $held }; the stock reaches { $stock } mm before Z 0
turn-setting-tools = Tools
turn-setting-insert = Insert
turn-setting-shank = Shank, { $unit }
turn-setting-tip = Tip
turn-setting-sizes = Sizes with limits
turn-setting-drawn = Drawing
turn-setting-limits = Limits
turn-setting-programmed = Program
turn-setting-size-corrected = The program has the middle of the limits: measure the first part and correct the wear offset by the difference from it.
turn-setting-ground = Sizes for later machining
turn-setting-later = Later operation
turn-setting-turned = Ø as turned
turn-setting-left = Allowance on a side
turn-setting-ground-allowance = The later operation holds the size of the drawing; on this lathe the size with the allowance is measured.
turn-setting-threads = Threads
turn-setting-surface = Surface
turn-setting-thread = Thread
turn-setting-crests = Ø of crests
turn-setting-wire = Wire
turn-setting-over-wires = Over three wires
turn-setting-thread-cut = { $thread }: { $how }
turn-single-passes = A thread of this program is cut by single passes: { $why }.
turn-setting-thread-measured = d2 is the pitch diameter: the last pass ends in the middle of its limits. It is measured with a thread micrometer, outside with three wires too, in a bore with a thread plug gauge.
turn-setting-wires = The wire of the table is the best one, P/√3, which touches the flanks at d2. With another wire dw the size over the wires is M = d2 + 3·dw − 0.866·P.
turn-setting-measured = How the offsets are measured
turn-setting-offsets = { $tool }: X: { $x }; Z: { $z }
turn-setting-seat = T{ $place }, offset { $offset }
turn-tool-table-head = { $part }: X and Z are 0 until they are measured: touch the part off and enter them in the tool table
set-x-diameter = touch a turned diameter and enter what it measures
set-x-bore = touch a bore and enter what it measures
set-x-axis = the tool stands on the axis of the spindle: X 0
set-z-face = touch a finished face and enter its Z
set-z-blade = touch a finished face with the side of the blade towards the chuck and enter its Z
set-z-shoulder = touch a shoulder that looks towards the chuck and enter its Z
set-z-point = touch a finished face with the point and enter its Z
set-z-front = touch a finished face with its front and enter its Z
set-z-thread = bring the point over a finished face by eye and enter its Z
set-z-nose = the centre of the nose; no face touches it, so measure it with a presetter
set-z-presetter = the theoretical point; the edge leans over a face, so measure it with a presetter
set-zero-again = after turning over, set Z 0 again: the finished part is { $length } mm long, so Z 0 lies that far from the finished face at the chuck
set-driver = the driver is not chosen: a dog, or a face driver smaller than what is turned at that end; a live centre in the tailstock
turret-holds = T{ $place }: { $tool }, offset { $offset }
turret-exchanged = T{ $place }: { $tool } in place of { $out }, offset { $offset }
turret-begins = the program begins with { $tools }
turret-stop = before { $before } the program stops (M0): { $tools }; put the tools in, set their offsets, start again
jaws-stop = before { $before } the program stops (M0): { $what }, start again
jaws-stop-loosen = loosen the jaws to { $force } kN
jaws-stop-tighten = tighten the jaws to { $force } kN
# Drawings.
turn-panel = { $variant }: cutting path { $path } mm, { $count } { $count ->
        [one] pass
       *[other] passes
    }
turn-frames = { $variant }: { $path } mm, { $count } { $count ->
        [one] pass
       *[other] passes
    }; pale: in-process stock
turn-frame = { $number }. { $kind }, { $length } mm, { $sum } in all
turn-scheme-panel = { $scheme }: cutting { $cutting } mm, idle { $idle } mm, { $time } min
turn-working-feed = working feed
turn-drawn-diameter = Ø{ $nominal } { $fit }: { $least } to { $most }
turn-drawn-plain = Ø{ $diameter }
turn-drawn-length = { $nominal } { $fit }: { $least } to { $most }
turn-drawn-ground = Ø{ $turned } for { $operation }, { $left } left on a side
turn-layers = Set-up { $set_up }, { $side }: allowances and zones
turn-way = Set-up { $set_up }, { $side }, zone { $zone }: { $scheme }, t_p = { $depth } mm; cutting { $cutting } mm, { $time } min
turn-way-rapid = rapid
turn-way-cut = working pass
turn-way-infeed = infeed
turn-way-pick-up = pick-up
turn-way-semi-finish = semi-finishing pass
turn-way-finish = finishing pass
turn-way-return = feed in air
turn-way-plunge = plunge
turn-way-thread = thread
turn-report-title = Report of the turning operation: { $part }
turn-report-drawings = Sketches of the operation and toolpaths
turn-report-setting = Setting sheet
turn-report-programs = Programs
turn-report-way = Set-up { $set_up }, { $side }: the toolpath over zone { $zone }
