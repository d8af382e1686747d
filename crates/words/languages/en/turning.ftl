# Mistakes of a shaft file.
empty-name = the name is empty
    .help = name the shaft
unknown-lathe = no catalog has the lathe `{ $lathe }`; there are: { $known }
    .help = name one of them, or leave `machine` out
unknown-material = there is no material `{ $material }`
    .help = `technolog table materials` lists them
unknown-material-near = there is no material `{ $material }`; did you mean `{ $near }`?
    .help = `technolog table materials` lists them
no-such-choice = `{ $word }` is not known here; there are { $known }
    .help = take one of them
not-above-zero = `{ $key }` is { $length }, but must be above 0
    .help = give millimetres, without a sign
length-too-large = `{ $key }` is { $length }, more than { $most }
    .help = give millimetres
no-steps = the shaft has no step
    .help = list the steps from the free end towards the chuck
step-beyond-blank = step { $step }: Ø{ $diameter } is larger than the blank Ø{ $blank }
    .help = take a larger blank
step-rises-to-the-free-end = step { $step }: Ø{ $diameter } is smaller than Ø{ $before } of step { $other }, which is nearer to the free end
    .help = check the order: from the free end towards the chuck no diameter falls; a neck behind a wider step is turned in a second set-up or with a grooving tool
steps-beyond-blank = all steps are { $sum } mm, longer than the blank of { $blank } mm, which ends here
    .help = take a longer blank, or shorten the steps
grid-too-fine = too many levels and slices: { $states } states, at most { $most } are looked through
    .help = take larger depths
# What the command cannot do with what it was given.
no-rates = no feeds to calculate the time with: the file has no `rates`
    .help = add the feeds, in mm/min, such as `rates: {"{"}longitudinal_feed: 180, transverse_feed: 150, rapid: 6000{"}"}`
    .help = add rates: {"{"}longitudinal_feed: 180, transverse_feed: 150, rapid: 6000{"}"}, mm/min
way-without-tool = the operation has no tool that roughs this shaft, so no way of roughing can be written
    .help = see `--show operation` for what is missing
rich-has-no-time = time cannot be the objective with rich moves
    .help = take another objective: path, path-and-passes or passes
# Why a pass.
pass-shorter = { $left } mm to go, { $otherwise } mm with the other direction
pass-quicker = { $left } min to go, { $otherwise } min with the other direction
pass-fewer = { $left } passes to go, { $otherwise } with the other direction
pass-as-good = both directions are as good, { $unit ->
        [min] { $left } min
        [passes] { $left } passes
       *[mm] { $left } mm
    } to go
pass-of-variant = the variant says so
pass-of-step = the direction of step { $step }
pass-of-search = from the search over rich moves, { $unit ->
        [passes] { $left } passes
       *[mm] { $left } mm
    } to go
# Which variant, and what to know.
take-lengthwise = between centres the fewest passes run along the axis
take-searched = in a chuck passes along and across the axis may be combined
take-contour = a blank near the shape of the part is turned parallel to the contour
contour-passes-elsewhere = passes parallel to the contour, which suit a blank near the shape of the part, are shown by `--show operation`; the ways here run straight
way-across = it has passes across the axis
way-full-cylinder = its passes would take a full cylinder, which the blank is not
way-by-proof = by the proof of its program: { $why }
way-quickest = { $variant }: { $length } mm in { $time } min, the quickest of those that hold and leave no metal standing, { $margin } min ({ $percent } %) less than { $rival }
way-as-quick = { $variant }: { $length } mm in { $time } min, as quick as { $rival } and quicker than the others that leave no metal standing; the lecture prefers { $variant }
way-only = { $variant }: { $length } mm in { $time } min, the only one that holds
way-none = none of these ways: each is refused for the reason given there
variant-beyond-model = the variant { $variant } is shorter than the best of the model: its longitudinal passes stop within a level
nothing-to-turn = no step is smaller than the blank: nothing to turn
