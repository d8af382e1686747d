# The page of an audit.
audit-title = Audit of the plan "{ $plan }"
audit-summary = { $error ->
        [one] 1 error
       *[other] { $error } errors
    }, { $wrong } wrong, { $doubtful } doubtful, { $note ->
        [one] 1 note
       *[other] { $note } notes
    }; of these { $follow } follow from others
audit-unconfirmed = { $count ->
        [one] { $count } finding rests
       *[other] { $count } findings rest
    } on rows that nothing confirms, of { $tables-count ->
        [1] table
       *[other] tables
    } { $tables }: each such row is marked “unconfirmed” below, and `technolog table NAME` says why
# Sections.
audit-section-route = Route
audit-section-tools = Cutters
audit-section-holders = Holders
audit-section-conditions = Cutting conditions
audit-section-clamping = Clamping
audit-section-lengths = Lengths and corrections
audit-section-program = NC program
audit-section-times = Times
audit-section-missing = Not stated
# How grave a finding is.
audit-severity-error = error
audit-severity-wrong = wrong
audit-severity-doubtful = doubtful
audit-severity-note = note
# Heads of tables.
audit-column-section = Section
audit-column-error = Errors
audit-column-wrong = Wrong
audit-column-doubtful = Doubtful
audit-column-note = Notes
audit-column-follow = Consequences
audit-column-file = File
audit-column-root = First root
audit-column-marks = Marks
audit-column-taken = Taken off
audit-column-severity = Severity
audit-column-place = Place
audit-column-ground = Ground
audit-column-about = About
audit-column-what = What
audit-column-difference = Difference
# What a finding says.
audit-about = { $about }: { $said }
audit-of-figure = { $what }: { $said }
audit-is-stated = stated { $stated }
audit-beside = stated { $stated }, should be { $right }
audit-beside-off = stated { $stated }, should be { $right } ({ $off } %)
audit-and-so = { $figures }; { $said }
audit-quantity = { $name } { $symbol }
audit-what-in-unit = { $what }, { $unit }
audit-factor = { $quantity } ({ $factor })
audit-tool = T{ $number }
# What it rests on.
audit-by-stated = by the stated figures: { $value }
audit-is-slip = later calculations use the right value: a slip of the pen
audit-supplied = not stated beside it, taken: { $taken }
audit-supplied-one = { $what } = { $value }
audit-rests-on = rests on: { $reasons }
audit-row = table { $table }, row { $row }
audit-row-unconfirmed = table { $table }, row { $row } (unconfirmed)
audit-table = table { $table }
audit-table-unconfirmed = table { $table } (unconfirmed)
audit-follows-from = follows from: { $fields }
audit-changes = wrong because of it: { $fields }
audit-change = { $stated } → { $right }
# What is not stated.
audit-whole-section = the whole section
audit-lacks = { $whose }: { $what }
audit-lacking-rows = { $count ->
        [1] row
       *[other] rows
    } { $rows }
audit-some-figure = a figure
# Marks.
audit-marks = Marks
audit-score = { $name }: { $points } of { $of }
audit-score-passed = { $name }: { $points } of { $of }, passed
audit-score-failed = { $name }: { $points } of { $of }, not passed
audit-by-consequence = as a consequence
audit-by-rule = by the rule { $rule }
audit-by-section = by the section "{ $section }"
audit-by-severity = by its severity
audit-by-capped = { $by }, up to the cap
audit-by-missing = it is not there
audit-part-missing = missing: { $part }, { $percent } %
audit-not-covered = By its own words the plan does not cover: { $parts }; nothing is taken off for that.
audit-part-holes = the route
audit-part-tools = tools
audit-part-conditions = cutting conditions
audit-part-clamping = the clamping
audit-part-program = the program
audit-part-times = times
audit-free = at no cost: { $counts }
audit-free-follow = consequences { $count }
audit-free-capped = beyond a cap { $count }
audit-free-other = others { $count }
audit-failed-mark = { $points } (fail)
# A folder of plans.
audit-folder = Audit of plans
audit-folder-summary = { $plans ->
        [one] 1 plan
       *[other] { $plans } plans
    }, { $unread } of them unreadable; { $error ->
        [one] 1 error
       *[other] { $error } errors
    }, { $wrong } wrong, { $doubtful } doubtful, { $note ->
        [one] 1 note
       *[other] { $note } notes
    }
audit-no-yaml = { $place } cannot be read: the file breaks the rules of YAML
audit-unreadable = { $place } cannot be read: { $message }
audit-root = { $whereabouts } { $change }
# Two plans.
audit-against = { $a } beside { $b }
audit-first-plan = Plan 1
audit-second-plan = Plan 2
audit-same = the plans say the same
audit-costs = What it costs
audit-cost-machine = machine time, min
audit-cost-rapid = rapids, min
audit-cost-tool_change = tool changes, min
audit-cost-total = total time, min
audit-cost-changes = number of tool changes
audit-cost-places = places in the magazine
# Keys of plan files that are no figures.
# Parts of a plan.
audit-key-route = route
audit-key-tools = tools
audit-key-conditions = cutting conditions
audit-key-clamping = clamping
audit-key-program = program
audit-key-times = times
audit-key-time = times
audit-key-holes = groups of holes
audit-key-transitions = transitions
audit-key-sequence = sequence
# Of rows.
audit-key-row = row of the route
audit-key-order = order of the rows
audit-key-operation = transition
audit-key-hole = group of holes
audit-key-tool = tool
audit-key-scheme = scheme
audit-key-table = table
audit-key-name = name
audit-key-way = how the scheme was found
audit-key-finish_elsewhere = whether it is finished elsewhere
audit-key-elsewhere = whether it is done elsewhere
audit-key-meets = whether it meets what is required
audit-key-centre_tolerance_mm = centre tolerance
audit-key-time_min = time of the route
audit-key-margin_min = gain over the next route
audit-key-cost = cost of the route
audit-key-feature = element of the hole
audit-key-face = face of the part
audit-key-step = step of the hole
audit-key-start_mm = start of the transition
audit-key-approach_mm = approach
audit-key-also_diameter_mm = second diameter
audit-key-achieved = what is reached
audit-key-it = grade
audit-key-roughness = roughness
audit-key-position_mm = accuracy of position
# Of tools.
audit-key-number = number of the tool
audit-key-designation = designation
audit-key-standard = standard
audit-key-shank = shank
audit-key-holder = holder
audit-key-holder_table = table of the holder
audit-key-with = word of the correction
audit-key-links = links of the assembly
audit-key-kind = kind
audit-key-mass_kg = mass
audit-key-load = load of the magazine
# Of conditions.
audit-key-limited_by = what limits the conditions
audit-key-coolant = coolant
audit-key-rounds = rounds of the mill
audit-key-mill_diameter_mm = diameter of the mill
audit-key-levels = levels
audit-key-card = conditions by the card
audit-key-axial_force_by_book_n = axial force by the book
audit-key-power_by_book_kw = power by the book
# Of the clamping.
audit-key-screw = screw
audit-key-proposed = whether the clamps are proposed
audit-key-safe_distance_mm = safe distance
# Of the sequence.
audit-key-setup = setup
audit-key-stops = stops
audit-key-transition = number of the transition
audit-key-at = point
audit-key-x = coordinate X
audit-key-y = coordinate Y
audit-key-nearest_rapid_min = rapids by the nearest point
audit-key-bound_min = lower bound of the rapids
audit-key-path_mm = length of the path
audit-key-clamp-place = place of a clamp
audit-key-holder-designation = designation of the holder
audit-key-holder-standard = standard of the holder
audit-key-link-length = length of the link
# Values of such keys.
audit-value-true = yes
audit-value-false = no
audit-value-null = none
audit-value-tables = by the tables
audit-value-complexes = by complexes
audit-value-search = by search
audit-value-bore = main cylinder
audit-value-step = step
audit-value-thread = thread
audit-value-cone = cone
audit-value-counterbore = counterbore
audit-value-countersink = countersink
audit-value-chamfer = chamfer
audit-value-face = face
audit-value-entry = entry
audit-value-back = back
audit-value-cutter = cutter
audit-value-holder = holder
# Bounds of a machine, and its own taper.
word-thrust-z-max = largest thrust
word-spindle-torque-max = largest torque
word-tool-overhang-max = largest overhang of a tool
word-taper = the spindle's taper
# Factors of the cards.
factor-material = material
factor-point-grinding = point grinding
factor-coolant = coolant
factor-tool-life = tool life
factor-coating = coating
factor-tool-material = tool material
factor-hole-depth = hole depth
factor-surface-state = state of the surface
# The command.
audit-program-in-folder = { $file }: a program, not counted as a work; if no plan of the folder names it, audit it by itself with its part: technolog audit { $file } --part PART.yaml
audit-skipped-file = { $file }: not a plan, skipped
audit-marks-legend = By what points are taken: by rule, where the scheme names the rule; by section, where it names the section of the plan; by severity (error, wrong, doubtful) everywhere else.
audit-no-plans = there is no plan in the folder `{ $folder }`
audit-what-is-a-plan = plans are files .yaml, .yml and .json as docs/audit.md describes them
audit-folder-against = only two plans can be compared, no folder
audit-name-a-plan = name a plan file
audit-class-grades = Grades
audit-class-mistakes = What the class gets wrong most
audit-class-mistakes-note = Mistakes of more than one work, each once for each work; what only follows from another is not counted.
audit-class-alike = Works alike, for the lecturer
audit-class-alike-note = The same wrong figures that hardly any other work states. It may be chance: ask, do not conclude.
audit-column-mistake = mistake
audit-column-works = works
audit-column-where = whose
audit-column-work = work
audit-column-other-work = other work
audit-column-same = the same in both
audit-column-of = of
audit-column-passed = passed
audit-column-taken-by = taken off: { $section }
audit-column-remark = remark
audit-same-figure = { $about }: { $stated }
audit-sheet-marks = Points taken off
audit-sheet-nothing = Nothing is wrong and nothing doubtful.
audit-sheet-notes = Notes for whoever wants to know more: { $count }; `technolog audit` shows them.
audit-sheet-follow = { $count ->
    [one] because of this one more figure or choice is wrong
   *[other] because of this { $count } more figures or choices are wrong
}
audit-sheets-format = the sheets of the students are pages: `--format html` or `--format markdown`
audit-sheets-format-help = add `--format html`; the grade book is another run with `--format csv` or `xlsx`
audit-sheet-lines = (l.
audit-folder-part = a folder has works of many parts; each names its own
audit-folder-part-help = name the part in each plan, above each list: `part`; or audit one file with `--part`
audit-sheets-of-one = sheets are for a folder of works
audit-sheets-of-one-help = name the folder; of one plan `-o FILE.html` is its page
