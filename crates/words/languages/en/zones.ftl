# What an element is.
element-main = { $surface }: a main element: it rises { $rise }°, not steeper than φ = { $main }°, and falls { $fall }°, not steeper than φ1 = { $secondary }°
element-by-kind = { $surface }: an additional element by its kind; tool: { $take }
element-rises = { $surface }: it rises { $rise }°, steeper than φ = { $main }°; tool: { $take }
element-falls = { $surface }: it falls { $fall }°, steeper than φ1 = { $secondary }°; tool: { $take }
element-leads-back = { $surface }: it leads back towards the free end, or lies under what does; tool: { $take }
element-in-shadow = { $surface }: it lies behind a steep fall, where a tool with φ1 = { $secondary }° does not reach; tool: { $take }
element-in-corner = { $surface }: it lies before a steep rise, where a tool with φ = { $main }° does not reach; tool: { $take }
element-in-valley = { $surface }: a wall of a valley whose floor the tool does not reach; tool: { $take }
element-beyond = { $surface }: it lies behind a fall after which the contour never rises again, so it is turned from the other end
element-partly = { $surface }: a part of it the tool would make, but the whole element is additional
# Set-ups.
setup-first = from the free end
setup-only = one set-up makes all of it
setup-falls-away = from Z { $z }, Ø{ $diameter } the contour falls towards the chuck more steeply than φ1 = { $secondary }° and never rises again
setup-lends = Ø{ $diameter } from Z { $z } is turned in this set-up and not in the first one, which would leave the jaws too little
setup-thread-from-far = the thread Ø{ $diameter } from Z { $z } is cut from this end: in the first set-up it would have no room to begin or to end
setup-behind-rest = the tool of the first set-up does not come past the steady rest: from Z { $z }, Ø{ $diameter } the part is turned from this end
setup-parts-off = in the end the part is parted off behind Z { $z }
setup-bore-widens = the bore widens towards the far face
setup-far-face = there is stock on the far face
hold-centres = the part is held between centres
hold-blank = { $length } mm of the blank's Ø{ $diameter } are left to hold it by ({ $least } mm are wanted, at the very least { $shortest } mm)
hold-blank-short = only { $length } mm of the blank's Ø{ $diameter } are left; { $least } mm are wanted, at the very least { $shortest } mm and { $clearance } mm more up to the tool: take a longer blank or centres
hold-surface = the part is held by { $surface }, Ø{ $diameter }, { $length } mm long ({ $least } mm are wanted, at the very least { $shortest } mm): the thickest of the cylinders that are long enough
hold-thread = nothing else is long enough: the part is held by the thread { $surface }, Ø{ $diameter }, { $length } mm long ({ $least } mm are wanted, at the very least { $shortest } mm)
hold-surface-short = { $surface }: { $length } mm are less than { $least } mm
hold-nowhere = no turned cylinder is long enough: centres, a mandrel or bored jaws are needed
# Tools against zones.
tool-main-angle = φ = { $has }° is less than { $needs }°
tool-secondary-angle = φ1 = { $has }° is less than { $needs }°
tool-bore-too-small = the bore of Ø{ $bore } is smaller than the least for the tool, Ø{ $least }
tool-bar-too-short = the bore is { $depth } mm deep, and the bar reaches { $reach } mm
tool-wider-than-groove = the tool is { $width } mm wide, the floor { $floor } mm
tool-only-for-grooves = a grooving tool is for closed zones, and this one is { $kind }
jaws-close = the jaws close on Ø{ $grips } from Z { $z }, over { $length } mm; turning they sweep at most Ø{ $sweep }
jaws-close-alone = the jaws close on Ø{ $grips } from Z { $z }, over { $length } mm
jaws-grip-too-little = set-up { $number }: to stay off the tool the jaws grip only { $length } mm, less than the { $least } mm below which nothing is held: leave a longer surface for them, or hold the part in another way
jaws-grip-little = set-up { $number }: to stay off the tool the jaws grip { $length } mm, and { $least } mm are wanted: bore the jaws deeper, or take a smaller depth of cut
jaws-bored = the surface is finished: soft jaws, bored to Ø{ $grips } over { $length } mm
jaws-on-bushing = a split bushing with this thread, { $length } mm long, goes between the jaws and Ø{ $grips }: make it before
centre-turned-down = set-up { $number }: a usual centre is in the way of the tools: take one that is turned down to Ø{ $body } or less behind its cone, or a half centre
grip-required = on Ø{ $grips } the jaws must press with { $force } kN together: the heaviest cut pulls with { $pull } kN there, friction { $friction }, safety { $safety }
chuck-turns-at-most = the chuck of { $chuck } mm turns at { $most } 1/min at most here: faster, its jaws lose too much of their force
grip-too-weak = set-up { $number }: the heaviest cut requires { $force } kN of the jaws on Ø{ $grips }, and a hand chuck of this size gives about { $given } kN: take a power chuck, a smaller depth or feed, a thicker cylinder to grip, or a tailstock
jaws-full-bored = full-grip jaws, which close nearly all around: bored to Ø{ $grips } over { $length } mm
grip-required-upright = on Ø{ $grips } the jaws must press with { $force } kN together: a cut tips the part with { $moment } N·m, and { $length } mm are gripped, safety { $safety }
grip-tips = set-up { $number }: a cut tips the part out of the jaws: { $moment } N·m · { $safety } > { $holds } N·m, which { $length } mm on Ø{ $grips } hold with the { $left } kN that the speed leaves of about { $given } kN: grip a longer surface, seat a flange against the jaws, take a tailstock, or a smaller depth (`limiting_depth`), feed or speed
jaws-crush = set-up { $number }: the wall of { $wall } mm under the jaws gives way on Ø{ $grips }: { $force } kN > { $bears } kN, which it bears: take full-grip jaws (`jaws: full-grip`), an expanding mandrel, a smaller depth or feed, or turn the part from a bar
jaws-crush-full = set-up { $number }: the wall of { $wall } mm gives way on Ø{ $grips } even in full-grip jaws: { $force } kN > { $bears } kN, which it bears: take an expanding mandrel, a smaller depth or feed, or turn the part from a bar
jaws-make-lobes = set-up { $number }: under the jaws “{ $surface }” springs out of round by { $lobes } mm a side when they open, with { $force } kN on a wall of { $wall } mm on Ø{ $grips }; of its tolerance of { $tolerance } mm { $allowed } may be: take full-grip jaws (`jaws: full-grip`), an expanding mandrel, or bore the part in one set-up from a bar
jaws-loosen = set-up { $number }: pressed with { $force } kN as roughing asks, “{ $surface }” would spring out of round by { $lobes } mm a side, of its tolerance of { $tolerance } mm { $allowed } may be, with a wall of { $wall } mm on Ø{ $grips }: loosen the jaws to { $loosened } kN before finishing, where the program stops (M0)
