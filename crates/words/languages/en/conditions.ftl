# Conditions.
feed = feed: upper end { $upper } mm/rev × { $multiple }
feed-choice = where the feed comes from
feed-before-finishing = feed × { $factor }: a reamer or a tap follows
depth-feed-factor = feed × { $factor } for the depth
depth-speed-factor = speed × { $factor } for the depth
material-speed-factor = speed × { $factor } for the material
speed-alloy-factor = speed × { $factor } for the alloy
material-force-factor = forces × { $factor } for the material
force-alloy-factor = forces × { $factor } for the alloy
surface-factor = speed × { $factor } for the surface
tool-life = tool life { $minutes } min
speed-coefficients = speed coefficients, Cv = { $cv }
load-coefficients = torque and thrust coefficients
boring-feed = boring feed { $feed } mm/rev
boring-finish-feed = feed by roughness { $feed } mm/rev
too-fine-to-bore = { $roughness } is finer than boring can give
spindle-step = computed { $computed }; steps { $below } and { $above } ({ $excess } % above): { $step } rpm
spindle-step-in-practice = computed { $computed }; steps { $below } and { $above }; the upper one is faster than practice, { $fastest } rpm at most: { $step } rpm
spindle-fastest = computed { $computed } is above the top: { $step } rpm
spindle-slowest = computed { $computed } is below the lowest: { $step } rpm
feed-reduced = feed reduced from { $from } to { $to } mm/rev: { $by }, limit { $limit }
load-margin = a load may take { $percent } % of the machine's limit
speed-for-feed = the speed is that for a feed of { $feed } mm/rev: { $speed } m/min instead of { $before }
life-for-feed = for a feed of { $feed } mm/rev the formula gives { $speed } m/min: the tool life is calculated from it
tap-lead = the tap's lead, { $lead } mm, goes beyond the full thread
thread-runout = the hole under a blind thread is drilled { $runout } mm deeper
thread-runout-short = the hole under a blind thread is drilled { $runout } mm deeper, as long as the lead of the tap: there is no room for the usual { $usual } mm
mill-clearance = the mill is at least { $clearance } mm smaller than the hole it enters
countersink-goes-round = no countersink is wide enough to be sunk: a smaller one goes round the edge, its front { $clearance } mm from the wall below
mill-cuts-down = the end teeth of the mill reach its middle, so it goes straight down into metal; up to { $percent } % of what it mills its centre has feed left
mill-over-hole = the mill need not enter the hole Ø{ $hole }: only { $percent } % of its diameter, its middle, has no teeth
ground-within = ground down by { $limit } mm at most
feed-held = feed limited to { $limit } mm/min
stand-in = { $table } has no figure for { $material }; { $group } is used instead
no-figure = { $operation }: table { $table } has no figure for { $material }
stand-in-operation = { $operation }: no figures of its own; those of { $instead } are used
stand-in-tool-material = { $table } has no figure for tools of { $tool }; { $other } is used instead
no-cutter-shape = { $operation }: no mill is given
no-pitch = { $operation }: no pitch is given
mill-does-not-enter = { $operation }: the mill Ø{ $diameter } does not enter the hole Ø{ $hole }
milling-rounds = passes { $passes }, levels { $levels }: t = { $t } mm, B = { $b } mm; path of the mill's axis { $path } mm, its feed × { $factor }
slot-passes = passes { $passes }, levels { $levels }: t = { $t } mm, B = { $b } mm; path of the mill's axis in the slot { $path } mm
slot-arc-feed = ways round along the walls { $passes }; on the arcs the wall lies further out than the mill's axis, which is fed there at r/R of the feed along the walls, r being the radius of its way and R that of the wall: at { $percent } % on the tightest arc, and by no less than { $least } mm/tooth
slot-finished = the same mill leaves { $stock } mm on the walls and takes it by one more way round
slot-milled-at-once = the walls need no finishing way round
milling-finish-round = the last round takes { $stock } mm a side: it finishes the cylinder
plunge-feed = goes down at { $percent } % of the feed along the wall
feed-per-tooth = feed per tooth { $feed } mm
milling-finish-feed = feed per tooth × { $factor }: last pass, { $roughness }
milling-load-coefficients = coefficients of the mill's main force
tapping-coefficients = speed coefficients of the tap, Cv = { $cv }, T = { $minutes } min
tapping-load-coefficients = torque coefficients of the tap
feed-is-pitch = the feed is the pitch, { $pitch } mm
spindle-step-below = computed speed { $computed }; the step not above it: { $step } rpm
no-step-below = { $operation }: no spindle step up to { $computed } rpm has the power and the feed rate
torque-beyond-spindle = { $operation }: torque { $torque } N·m, and the spindle has { $limit } N·m
reaming-feed = reaming feed × { $factor }
feed-within-practice = the handbook has { $table } mm/rev, practice at most { $practice } in solid metal: { $multiple } times that is taken
reaming-feed-practice = the handbook has { $table } mm/rev, practice at most { $feed } mm/rev, which is taken
reaming-feed-blind = blind hole: feed within { $low }–{ $high } mm/rev
reaming-load-coefficients = force coefficients of a reamer's tooth
reamer-teeth = teeth of the reamer { $teeth }
too-deep = { $operation }: { $ratio } diameters deep is outside table { $table }
card-calibration = card: { $name } × { $factor } of the formula
card-point = the card prints V = { $speed } m/min, P = { $thrust } N, N = { $power } kW here
card-point-forces-differ = the card prints V = { $speed } m/min, P = { $thrust } N, N = { $power } kW here; the formula does not reproduce force and power; the loads are the formula's
card-corrections = the example's factors: speed × { $product }, material { $material }
card-without-depth = { $ratio } diameters deep: the factor { $factor } of { $table } is left out, the cards' own for depth are not known
card-other-grade = the factors of the cards are those of { $example }, the worked example's grade; for { $material } they are not known
card-other-material = the cards' factors for { $material } are not known
stock-of-practice = in practice a reamer finds { $low } to { $high } mm on diameter
force-opinion = a maker's formulas give { $thrust } N and { $torque } N·m; ours are { $thrust_percent } % and { $torque_percent } % of them
torque-opinion = by the specific cutting force { $torque } N·m at { $feed } mm/rev; the formula gives { $percent } % of it
torque-by-specific-force = the formula is less than two thirds of it: the larger torque is taken
reamed-for-surface = the last reamer is driven no faster than a rough one that takes { $stock } mm: { $speed } m/min
hardness-no-force = HB { $stated } as stated changes no force: the tables have the forces of { $material } for one state, HB { $own }; harder metal needs more
strength-no-force = { $stated } MPa as stated change no force: the tables have the forces of { $material } for one state, { $own } MPa; stronger metal needs more
