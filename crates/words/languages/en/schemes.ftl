blank-step-rises-to-the-free-end = step { $step } of the blank: Ø{ $diameter } is smaller than Ø{ $before } before it
    .help = check the order: from the free end towards the chuck no diameter of the blank falls
blank-step-beyond-blank = step { $step } of the blank: Ø{ $diameter } is larger than its largest Ø{ $blank }
    .help = the diameter of the blank is its largest; raise it
# What the schemes are.
scheme-verticals = the stock is taken over one cylinder after the other
scheme-levels = level after level over all cylinders
scheme-horizontals-a = straight passes leave at most one depth over each cylinder, which a pass along the contour takes
scheme-horizontals-b = straight passes leave less than the depth everywhere, a pass along the contour takes the rest
scheme-quickest = { $variant }: the quickest, { $margin } min ({ $percent } %) less than { $rival }
# What the schemes of rough transitions are.
transition-loop = straight passes, drawn back and returned through air
transition-loop-against-stop = straight passes against a stop: step after step, at the full depth to its shoulder
transition-zigzag = cuts there and back, and goes in along the contour at both ends
transition-descent = the stock is taken by radial motions, slice by slice
transition-pick-up = after each straight pass along the contour up to the level of the pass before
transition-semi-finishing = straight passes, then one along the contour that cuts all ridges
transition-equidistant = passes at equal distances from the rough contour
transition-contour = passes repeat the contour, shifted along a line
transition-as-quick = { $variant }: as quick as { $rival }
finishing-must-follow = the scheme gives a roughness down to { $finest }, but { $asked } is required: finishing must follow it
# Why a zone is not worked.
zone-contour-not-monotone = the contour of the zone ({ $contour }) is empty, broken or leads back towards the free end
    .help = give the contour from the free end towards the chuck, each element from the end of the one before
zone-contours-differ = the rough contour and the blank of the zone differ in their stretch of Z or in their side
    .help = cut both contours off at the bounds of the zone
zone-settings-not-positive = the depth of a pass, the approach and the retract must be greater than zero
    .help = give them in mm, greater than zero
rough-above-blank = at Z{ $z } the rough contour is above the blank
    .help = make the blank larger or the finishing allowance there smaller
flank-too-steep = from Z{ $z } the contour goes at { $angle }°, but the tool allows { $limit }°
    .help = take a tool with a larger angle, or leave that stretch to another transition
stop-needs-steps = only stepped rollers that do not fall towards the chuck are worked against a stop
    .help = take the loop without a stop
no-equidistant = there is no contour at a distance of { $distance } mm
    .help = take a smaller depth of a pass, or the contour scheme
too-many-passes = too many passes: { $passes }, at most { $most } are made
    .help = check the size of the blank and the limiting depth of a pass
# What a zone is.
zone-is = zone: { $kind }
zone-scheme = scheme for the zone: { $kind }
