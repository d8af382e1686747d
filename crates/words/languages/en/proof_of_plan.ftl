# What of a plan is not proven: each inequality that does not hold.
proof-no-stock = { $operation }: no stock at worst: the hole of Ø{ $before } may be Ø{ $may_be }, the axes may lie { $shift } mm apart; { $least } mm is left, and it must be more than 0
proof-grade = { $operation } does not reach grade { $asked }: IT{ $ordinary } in practice, IT{ $best } at best
proof-grade-at-best = { $operation } reaches grade { $asked } only at best: ordinarily IT{ $ordinary }, at best IT{ $best }
proof-surface = { $operation } does not reach { $asked }: { $ordinary } in practice, { $best } at best
proof-surface-at-best = { $operation } reaches { $asked } only at best: ordinarily { $ordinary }, at best { $best }
proof-position = { $operation }: position of the axis { $best } to { $ordinary } mm > { $asked } mm permitted
proof-position-at-best = { $operation }: position of the axis ordinarily { $ordinary } mm > { $asked } mm permitted; at best { $best } mm
proof-too-wide = { $operation } Ø{ $diameter }: the hole may be Ø{ $may_be } > Ø{ $limit }, its upper limit
proof-not-finished = the last transition leaves Ø{ $left }, and the drawing requires Ø{ $smallest } to { $largest }
proof-enters = { $operation }: the tool of Ø{ $tool } is wider than the finished hole, Ø{ $limit }
proof-spot-stays = the centring spot of Ø{ $spot } is wider than the hole and its chamfer, Ø{ $limit }: it stays on the part
proof-too-shallow = { $operation }: full diameter down to { $depth } mm, and { $asked } mm are needed
proof-breaks-through = { $operation }: the tip at a depth of { $tip } mm comes out of the floor; the blank is { $thickness } mm thick
proof-floor = { $operation }: the tool goes down to { $tip } mm, and the hole is open at full diameter down to { $opened } mm
proof-tap-hole = the drill of Ø{ $diameter } under the thread is outside the minor diameter of 6H: { $smallest } to { $largest } mm
proof-thrust = { $operation }: thrust { $value } N > { $percent } % of the permissible { $limit } N
proof-torque = { $operation }: torque { $value } N·m > { $percent } % of the permissible { $limit } N·m
proof-power = { $operation }: power { $value } kW > { $percent } % of the drive's { $limit } kW
not-proven = the plan is not proven: { $why }
reamed-short = over the flat floor the reamer leaves { $lead } mm of the depth unreamed: its lead
lost-by-preference = the tables are preferred; it would be quicker by { $quicker } min
tables-preferred = the tables are preferred: { $own } min; the best plan takes { $best } min and saves { $saves } min
no-place-for-clamps = two or four straps find no place on the face that holds: { $why }; a vice, or a fixture of its own, is needed, against M = { $torque } N·m
proof-too-fast = { $operation }: speed { $value } m/min > { $percent } % of the upper end of practice, { $usual } m/min
proof-twists = { $operation }: torque { $value } N·m > { $limit } N·m that the drill of Ø{ $drill } bears
proof-bar-slender = { $operation }: the bar reaches out { $reach } mm > { $ratio } times its diameter of { $bar } mm
proof-bar-springs = { $operation }: the bar gives way by { $spring } mm on the diameter to uneven stock > { $tolerance } mm of tolerance
