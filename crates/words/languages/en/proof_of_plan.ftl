# What of a plan is not proven: each inequality that does not hold.
proof-no-stock = { $operation }: no stock at worst: the hole of Ø{ $before } may be Ø{ $may_be }, the axes may lie { $shift } mm apart; { $least } mm is left, and it must be more than 0
proof-too-much = { $operation }: takes { $stock } mm on the diameter, and at most { $most } mm is right for such a tool
proof-grade = { $operation } does not reach grade { $asked }: IT{ $ordinary } in practice, IT{ $best } at best
proof-grade-at-best = { $operation } reaches grade { $asked } only at best: ordinarily IT{ $ordinary }, at best IT{ $best }
proof-surface = { $operation } does not reach { $asked }: { $ordinary } in practice, { $best } at best
proof-surface-at-best = { $operation } reaches { $asked } only at best: ordinarily { $ordinary }, at best { $best }
proof-position = { $operation }: position of the axis { $best } to { $ordinary } mm > { $asked } mm permitted
proof-position-at-best = { $operation }: position of the axis ordinarily { $ordinary } mm > { $asked } mm permitted; at best { $best } mm
proof-too-wide = { $operation } Ø{ $diameter }: the hole may be Ø{ $may_be } > Ø{ $limit }, its upper limit
proof-not-finished = the last transition leaves Ø{ $left }, and the drawing requires Ø{ $smallest } to { $largest }
proof-enters = { $operation }: the tool of Ø{ $tool } is wider than the finished hole, Ø{ $limit }
proof-gouges = { $operation }: on the shoulder at { $shoulder } mm the point of the drill is still Ø{ $crater } wide, and the hole below is Ø{ $below }: it leaves a crater in the shoulder; drill less wide or less deep, and mill or counterbore the rest
proof-middle-in-metal = { $operation }: the mill Ø{ $tool } goes straight down into metal, and its end teeth need not reach its middle, up to Ø{ $middle }: take one with a tooth to the middle
proof-middle-over-hole = { $operation }: the mill Ø{ $tool } goes straight down where only Ø{ $open } is open, and its end teeth need not reach its middle, up to Ø{ $middle }: take one with a tooth to the middle
proof-spot-stays = the centring spot of Ø{ $spot } is wider than the hole and its chamfer, Ø{ $limit }: it stays on the part
proof-too-shallow = { $operation }: full diameter down to { $depth } mm, and { $asked } mm are needed
proof-breaks-through = { $operation }: the tip at a depth of { $tip } mm comes out of the floor; the blank is { $thickness } mm thick
proof-thin-floor = { $operation }: under the tip at a depth of { $tip } mm { $floor } mm of floor are left, less than { $least } mm: it may burst; make the hole shallower or the part thicker
proof-meets-floor = { $operation }: the tool goes down to { $tip } mm, just the flat floor, where it has nothing to cut; let it stop a little above
proof-floor = { $operation }: the tool goes down to { $tip } mm, and the hole is open at full diameter down to { $opened } mm
proof-tap-hole = the drill of Ø{ $diameter } under the thread is outside the minor diameter of 6H: { $smallest } to { $largest } mm
proof-thrust = { $operation }: thrust { $value } N > { $percent } % of the permissible { $limit } N
proof-torque = { $operation }: torque { $value } N·m > { $percent } % of the permissible { $limit } N·m
proof-power = { $operation }: power { $value } kW > { $percent } % of the drive's { $limit } kW
not-proven = the plan is not proven: { $why }
ends-above-floor = over the flat floor or shoulder the last { $left } of { $depth } mm of Ø{ $diameter } are not finished: the tool stops above it so as not to run into it, a reamer or core drill by its lead, too
lost-by-preference = the tables are preferred; it would be quicker by { $quicker } min
tables-preferred = the tables are preferred: { $own } min; the best plan takes { $best } min and saves { $saves } min
no-vice = nothing holds the part: no vice of the table takes it either: { $why }
no-vice-known = no vice is known
vice-too-small = { $vice }: { $along } mm along jaws of { $jaws } mm, { $between } mm between jaws that open to { $opening } mm
vice-too-weak = { $vice }: { $force } N are needed > { $gives } N that it gives
vice-no-grip = { $vice }: of a part { $thickness } mm thick the jaws of { $jaws } mm may grip { $most } mm at most, { $below_face } mm below its face, and must grip { $least } mm at least; parallels of { $parallels } mm or more under it (a tool comes out { $below } mm below) do not leave that
vice-not-that-high = { $vice }: { $height } mm under the part by the file stands against it: its ways are { $ways } mm high, and no parallels make up the rest with a grip of { $least } to { $most } mm in jaws of { $jaws } mm; a tool comes out { $below } mm below
vice-parallels-in-the-way = { $vice }: { $beside } mm from a jaw to the nearest hole < { $thinnest } mm, the thinnest parallels: the tool would cut them
straps-of-number = { $clamps } straps: { $why }
no-place-for-clamps = none of the places that are tried for two, four or six straps on the face would hold the part: { $why }; give places under `clamps`, cut lighter, or take a vice or a special fixture, to hold against M = { $torque } N·m
holder-in-strap = T{ $tool }: what is above the cutter, Ø{ $diameter }, comes down to { $low } mm over the face at { $at }, beside a strap that stands { $height } mm over it
straps-in-the-way = straps at the places that are tried keep the job from running: { $why }; those proposed first stand { $height } mm over the face with their nuts, and neither lower ones nor a vice of the table help: hold the part by a fixture that stands no higher than { $most } mm over the face and give it in the file, as `own`, `clamps` with a height or `obstacles`; this plan has no clamps
in-second-set-up = in set-up 2: { $why }
# Chains of dimensions. $from (side or name), $term (chain-term)
chain-ordinarily = along { $axis } from { $from } the chain closes statistically only: { $sum } = { $worst } mm > { $tolerance } mm at worst, { $likely } mm as a root of squares; the most costs { $term }, { $most } mm: measure the first parts
chain-unconfirmed = along { $axis } from { $from } the chain does not close by figures that nothing confirms: { $sum } = { $worst } mm, as a root of squares { $likely } mm > { $tolerance } mm; the most costs { $term }, { $most } mm: measure it
chain-fails = along { $axis } from { $from } the chain does not close: { $sum } = { $worst } mm, as a root of squares { $likely } mm > { $tolerance } mm; the most costs { $term }, { $most } mm
chain-without-size = along { $axis } from { $from } the chain with { $tolerance } mm is not known to close: the zero is found at the opposite side, and nobody says the tolerance of the size between them: give it under `dimensions`, from side to side
chain-without-locating = along { $axis } from { $from } the chain with { $tolerance } mm is not known to close: how far the part is off in a fixture of your own nobody says
proof-too-hard = { $operation }: HB { $hardness } > HB { $limit }, where tools of high-speed steel end; carbide is needed, and the catalogs have no such tool here
proof-hard = HB { $hardness } > HB { $usual }: tools of ordinary high-speed steel cut it slowly and live short, and end at HB { $limit }; cobalt steel or carbide is the usual choice
proof-too-fast = { $operation }: speed { $value } m/min > { $percent } % of the upper end of practice, { $usual } m/min
proof-twists = { $operation }: torque { $value } N·m > { $limit } N·m that the drill of Ø{ $drill } bears
proof-buckles = { $operation }: thrust { $value } N > { $limit } N that the drill of Ø{ $drill } with flutes of { $flutes } mm bears without buckling
proof-flutes-close = { $operation }: the drill of Ø{ $drill } goes { $tip } mm into the metal and has flutes of { $flutes } mm: { $open } mm stay open < { $least } mm that chips need to get out
proof-holder-low = { $operation }: the cutter stands out { $overhang } mm and its tip goes { $tip } mm deep: its holder is { $over } mm over the face < { $least } mm
proof-bar-slender = { $operation }: the bar reaches out { $reach } mm > { $ratio } times its diameter of { $bar } mm
proof-bar-out-of-range = { $operation }: a pass at Ø{ $set } mm, and the bar is set from Ø{ $smallest } to Ø{ $largest } mm
proof-bar-beyond-machine = { $operation }: the bar is set to Ø{ $set } mm, and the machine takes tools up to Ø{ $largest } mm
proof-bar-enters = { $operation }: the bar of Ø{ $bar } mm does not enter the hole of Ø{ $hole } mm
proof-bar-springs = { $operation }: uneven stock deflects the bar by { $spring } mm on the diameter > { $tolerance } mm of tolerance
proof-wall-between = between this hole and { $other } { $wall } mm of wall are left, less than { $least } mm: it gives way under the cutter; move the holes apart or make them shallower
proof-wall-to-edge = to the edge of the blank { $wall } mm of wall are left, less than { $least } mm: it gives way under the cutter; move the hole inwards or take a larger blank
proof-wall-among = between two holes of this group { $wall } mm of wall are left, less than { $least } mm: it gives way under the cutter; move the holes apart or make them shallower
proof-no-wall-between = between this hole and { $other } { $wall } mm of wall are left, and the holes may lie { $shift } mm aside: at worst they run into each other; move them apart
proof-no-wall-among = between two holes of this group { $wall } mm of wall are left, and the holes may lie { $shift } mm aside: at worst they run into each other; move them apart
proof-no-wall-to-edge = to the edge of the blank { $wall } mm of wall are left, and the hole may lie { $shift } mm aside: at worst it breaks out of the edge; move the hole inwards or take a larger blank
proof-cast-stock = the cast hole Ø{ $cast } leaves { $stock } mm a side, less than { $least } mm: the first cut does not get under the skin nor clear a core that stood aside; have the hole cast smaller
proof-under-skin = { $operation }: the first cut in the cast hole is { $depth } mm a side; where its radius and axis take { $place } mm, { $thinnest } mm are left, less than { $least } mm: there the edge runs in the skin
proof-plate-springs = { $operation }: under { $thrust } N the part springs by { $spring } mm over { $span } mm between its clamps, as a beam on two supports, more than { $most } mm, a feed per revolution: the tool snatches as it breaks through; support the part beside the hole, or open it with a smaller drill first
