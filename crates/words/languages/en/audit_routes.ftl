# Schemes.
audit-scheme-mixed = the row names the scheme { $stated }, but the other rows of the group { $other }
audit-scheme-uncentred = { $printed } gives the scheme { $stated }, but by section 1.2.1 such a hole is centred first, so { $scheme } ({ $table })
audit-route-by-scheme = the transitions of { $printed } for the scheme { $stated } word for word; `technolog plan` makes { $scheme } ({ $table }): { $better }
audit-one-drill = Ø{ $diameter } with one drill: section 1.2.1 requires two, the first of 0.5–0.6 of the diameter
# Openings.
audit-opening-not-made = no transition makes the { $feature } Ø{ $diameter } of the drawing
audit-opening-not-centred = no transition makes the { $feature } Ø{ $diameter }, and the centring spot Ø{ $spot } is narrower
audit-opening-unasked = the transition “{ $operation }” is not needed: the drawing of this hole asks for nothing of the kind
audit-opening-diameter = by the drawing: { $feature }
audit-opening-depth = by the drawing: { $feature }
# Depths.
audit-depth-of-hole = the hole { $hole } of the drawing is not of that depth
audit-spot-depth = the depth of the spot is t = (D/2)/tan φ by the angle of the centring drill
audit-travel-short = the tool is fed less far than the transition is deep, { $depth } mm, and approach and overrun come on top
audit-breaks-through = the tip of the tool is at { $end } mm, but the part is { $thickness } mm thick: the blind hole goes through
# Threads.
audit-tap-drill = the hole under { $thread } is { $low } to { $high } mm
audit-thread-short = the thread { $thread } of the drawing is { $depth } mm deep
audit-thread-runout = under the thread { $thread } of { $depth } mm there is no room for the lead of the tap
audit-thread-deep = the thread { $thread } of the drawing is only { $depth } mm deep
audit-thread-elsewhere = the plan does not cut the thread { $thread }: this machine cannot, so it is cut on another (a row `operation: tap` with `elsewhere: true` says so)
audit-cannot-tap = the machine { $machine } cuts no threads: it is done on another (`elsewhere: true`)
# Allowances.
audit-allowance = row { $row } ({ $operation }) finds { $stock } mm on diameter, and section 1.2.1 permits { $low } to { $high }
audit-transition-missing = before row { $row } ({ $operation }) a transition is missing, { $missing }: the tool finds { $stock } mm on diameter, and section 1.2.1 permits at most { $high }
audit-passes = { $stock } mm on diameter are bored in { $needed } passes by section 1.2.1 (up to { $high } in each)
# Cutters, holders, places.
bar-of-other-stage-rough = { $tool } is a bar for rough boring
bar-of-other-stage-finish = { $tool } is a bar for finish boring
bar-of-other-range = { $tool } bores Ø{ $low }–{ $high }, but the transition needs Ø{ $needed }
tap-of-other-thread = { $tool } is a tap { $own }, but the thread is { $needed }
tool-of-other-angle = { $tool } has an angle of { $own }°, but the transition needs { $needed }°
tool-for-blind-holes = { $tool } is for blind holes, but the hole goes through: for it { $known }
tool-for-through-holes = { $tool } is for through holes, but the hole is blind: for it { $known }
holder-of-whole-tool = { $tool } has its own 7:24 taper and stands in the spindle itself: { $holder } does not hold it
holder-of-other-family = { $holder } is not for such a shank as that of { $tool }: for it { $known }
audit-no-place = there is no place T{ $number }: the magazine has { $places }
