# Why a job is not made.
job-needs-lathe = no lathe is named (`machine:`), so speed and feed are not known
job-no-tool = { $surface }: the catalog has no tool for it
job-bore-too-small = { $surface }: the bore of Ø{ $bore } is narrower than Ø{ $least }, the smallest that the bar enters
job-bar-too-short = { $surface }: it ends { $depth } mm deep, and the bar reaches { $reach } mm
job-overloaded = { $tool }: more than it bears: { $bound }
groove-no-valley = { $surface }: it is not a groove of two walls and a floor
groove-too-narrow = { $surface }: { $room } mm of room at the floor, and the narrowest blade is { $width } mm wide
groove-beyond-blade = { $surface }: the tool must reach { $depth } mm deep, and it reaches { $reach } mm
groove-face-too-small = { $surface }: its outer diameter { $diameter } mm is less than { $least } mm, for which the blade is curved
groove-faces-chuck = { $surface }: it is in a face towards the chuck, where no tool of this set-up comes
groove-undercut = { $surface }: it undercuts both of its neighbours: a lead angle φ of at least { $main }° and a trailing angle φ1 of at least { $secondary }° are needed, and with the angle of an insert that is more than 180°
    .help = a form tool that is fed in at 45° cuts it; write its pass by hand
thread-no-insert = the catalog has threading inserts for pitches of { $least } to { $most } mm whose nose is known, none for { $pitch } mm
thread-no-passes = the table of passes ends before the pitch of { $pitch } mm
thread-too-quick = a pitch of { $pitch } mm at { $spindle } 1/min, the slowest of the spindle, is { $rate } mm/min, and the feed goes to { $most } mm/min
thread-no-entry = { $surface }: the tool needs { $needs } mm before the thread, and there are { $room } mm
thread-no-run-out = { $surface }: the tool needs { $needs } mm behind the thread, and there are { $room } mm
    .help = give the thread a wider relief, or end it earlier
thread-relief-shallow = { $surface }: the relief behind it has Ø{ $relief }, and the roots are at Ø{ $root }
thread-on-no-cylinder = { $surface }: only threads on a cylinder are cut
job-no-drill = no drill of the catalogs is at most Ø{ $diameter } and reaches { $depth } mm deep
job-drill-too-strong = a drill of Ø{ $diameter } presses with { $force } N even at the least feed, and the drive of Z gives { $most } N
job-no-centre-hole = for Ø{ $diameter } there is no centre drill: the smallest is for Ø{ $least }
part-off-near-jaws = the blade would cut { $gap } mm before the jaws, and must stay { $least } mm away
part-off-too-deep = the wall is { $depth } mm thick, and no blade reaches further than { $reach } mm
# What is done.
groove-plunges-face = { $surface }: plunges of the blade: { $count }, its leading corner at Ø { $places }; then both sides and the floor ({ $tool })
groove-plunges = { $surface }: plunges of the blade: { $count }, its leading corner at Z { $places }; then both sides and the floor ({ $tool })
groove-one-plunge = { $surface }: one plunge, because the blade is as wide as the floor; the tool does not wait at the floor, because the toolpath has no dwell ({ $tool })
groove-by-nose = { $surface }: no blade is narrow enough, so { $tool } goes along its contour
groove-pecked = { $surface }: a deep groove, so the blade goes in step by step ({ $steps }) and draws back after each
groove-corner-kept = { $surface }: corners of the floor keep the radius of the edge, { $radius } mm, in place of { $wanted } mm
groove-width-of-blade = { $surface }: its width is that of the blade: measure the insert
job-tool-taken = { $tool } is taken
job-limit = { $name } = { $value }
grooving-practice = the maker of the blade: { $feed-min } to { $feed-max } mm/rev, at least { $speed } m/min at a width of { $width } mm
thread-passes = { $surface }: { $thread } by { $tool }, { $depth } mm deep; { $passes } { $passes ->
        [one] pass
       *[other] passes
    }, then { $springs } more at full depth; fed in at { $angle }°
thread-ways = { $surface }: the tool begins { $entry } mm before the thread and ends { $run-out } mm behind it
thread-pulled-out = { $surface }: nothing is cut away behind the thread, so over { $length } mm the tool is drawn out of the metal; full depth ends before
thread-crests = { $surface }: turned to Ø{ $turned } before the thread, the middle of Ø{ $least } to Ø{ $most } that ISO 965-1 leaves for crests of { $class }
thread-crests-nominal = { $surface }: the limits of the crests of { $thread } are not known here, so it is turned to the nominal diameter before the thread
thread-infeed = infeed { $angle }° from the perpendicular to the axis
thread-speed = { $wanted } m/min wanted, { $speed } m/min at { $spindle } 1/min
thread-feed-follows = the feed goes to { $most } mm/min, so a pitch of { $pitch } mm is cut at { $spindle } 1/min at most
threading-passes = passes for a pitch of { $pitch } mm: { $passes }
threading-first-pass = the first pass at most { $depth } mm deep, passes more: { $more }
job-flattened = the bottom is made flat: a drill of Ø{ $diameter } reground to 2φ = 180° takes away the cone down to { $tip } mm; that drills are reground is our choice: the catalogs have none with a flat end
job-ground = ground down from Ø{ $nominal } to Ø{ $size }
job-no-cutter = no cutter of the catalogs ({ $operation }) is of Ø{ $diameter } and reaches { $depth } mm deep
job-no-stock = { $operation } to Ø{ $diameter } has nothing to cut: the hole there is Ø{ $from } already
axial-hole = { $surface }, Ø{ $diameter }: made to size on the axis ({ $way }), because no boring bar enters it
axial-steps = the diameters before the last reamer of Ø{ $diameter }
job-drilled = drilled to Ø{ $diameter }, the point to { $tip } mm, in steps: { $steps }
job-drill-point = full diameter to { $full } mm, then the cone of the point, { $point } mm
job-drill-steps = { $ratio } diameters deep, steps: { $steps }
job-drill-loads = feed { $feed } mm/rev: thrust { $thrust } N, torque { $torque } N·m
job-drill-speed = { $wanted } m/min wanted, { $speed } m/min at { $spindle } 1/min
job-centre-hole = centre hole in a face of Ø{ $diameter }: { $tool }, Ø{ $mouth } at the face, { $depth } mm deep
job-spot = spot for a drill of Ø{ $drill }: { $tool }, Ø{ $mouth } at the face, { $depth } mm deep
parting-blade = a bar of Ø{ $bar } asks for a blade of at least { $width } mm
part-off = parted off behind { $face } mm by { $tool }, { $width } mm of bar are cut away
part-off-slow = from the radius of { $radius } mm inwards the feed is { $feed } mm/rev
part-off-pip = the blade goes { $beyond } mm beyond the axis, so that no pip stays; a blade that leans by 4 to 6 degrees leaves it on the bar
job-first-drill = Ø{ $diameter } is drilled in two passes, the first at most Ø{ $most }
thread-flanks = { $surface }: { $thread } is programmed to the pitch diameter Ø{ $made }, the middle of Ø{ $least } to Ø{ $most } that ISO 965-1 allows for { $class }; measure it and correct what differs by the tool's offset
thread-flanks-basic = { $surface }: the limits of the pitch diameter of { $thread } are not known here, so it is programmed to that of the basic profile, Ø{ $made }, where the GO gauge may not go yet: measure it and correct it by the tool's offset
thread-deviation = deviation of { $class } from the basic profile: { $value } mm
thread-tolerance = tolerance of the pitch diameter for { $class }: { $value } mm
thread-run-out-too-long = { $surface }: without a relief the thread runs out over { $needs } mm of metal, and the standard allows { $most } mm: draw a relief behind it
thread-run-out-on-seat = { $surface }: without a relief the thread runs out on { $seat }, a surface of IT{ $grade }, and scores it: draw a relief behind the thread, or end it earlier
thread-longest-run-out = the run-out of a pitch of { $pitch } mm is at most { $length } mm
