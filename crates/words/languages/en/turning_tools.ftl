# What is not known, and what does not fit.
lathe-lacks = the record of the lathe { $lathe } has no `{ $quantity }`
turning-tool-lacks = the row of the tool { $tool } has no `{ $quantity }`
bound-not-reckoned = limits by “{ $what }” are left out: the record of { $of } has no such figure
limit-not-known = the limiting depth of cut is not known: { $of } has no figure “{ $what }” ({ $bound })
angle-beyond-table = an angle of { $angle } degrees is outside the table { $table }
lathe-too-small = lathe { $lathe }: { $is } mm is more than its `{ $quantity }`, { $most } mm
shank-too-high = lathe { $lathe }: the shank of { $tool } is { $is } mm high, and its holder takes { $most } mm
nothing-to-cut = `{ $quantity }` is { $is }, but must be above 0
tool-has-no-depth = the tool { $tool } has no depth of cut to choose: a groove is as wide as its blade, a thread as deep as its profile
threads-not-reckoned = cutting conditions of threading with { $tool } are not calculated yet
too-fine-to-turn = { $roughness } is finer than the feed tables of turning go
too-fine-for-lathe = lathe { $lathe }: { $roughness } is finer than its best, { $best }
# Why a figure.
feed-bound-by-nose = the nose allows no more: { $feed } mm/rev = { $share } of its radius of { $radius } mm
turning-feed = feed { $feed } mm/rev, tool { $tool }
turning-finish-feed = feed by the roughness { $feed } mm/rev
force-coefficients = coefficients of the force { $component }
grade-factor = speed × { $factor }: grade { $grade } instead of { $reference }
internal-factor = speed × { $factor }: in a bore
angle-speed-factor = speed × { $factor }: angle { $angle } degrees
angle-force-factor = force × { $factor }: angle { $angle } degrees
rake-force-factor = force × { $factor }: rake { $angle } degrees
practice-range = public speed tables have { $low } to { $high } m/min; the handbook has no formula for this material
specific-force = specific cutting force of group { $group } of VDI 3323: kc1 = { $kc } MPa, mc = { $mc }
force-share = × { $factor }: share of the main force
lathe-limit = the lathe gives { $limit }
turning-limit = { $name } = { $value }
overhang = overhang { $length } mm
insert-edge = at most { $share } of the edge of { $edge } mm may cut: { $depth } mm of depth
chip-width = chips break up to a depth of { $ratio } feeds: { $depth } mm at { $feed } mm/rev
elastic-modulus = modulus of elasticity { $modulus } MPa
bar-too-long = { $tool }: the bar would stand out { $overhang } mm, and { $most } mm are allowed
part-too-slender = the part ({ $support }, { $ratio } diameters long) bends too far at any reasonable depth of cut; it needs: { $ask }
part-bears-little = the part ({ $support }, { $ratio } diameters long) bears passes of { $depth } mm only; deeper ones ask for: { $ask }
feed-of-nose = feed { $feed } mm/rev: the nose of { $radius } mm leaves no rougher surface, real roughness being { $factor } times the geometrical one
roughness-unsaid = the drawing says no roughness; finished as { $roughness }
cuts-back = { $tool }: its second edge cuts on the way back, φ1 = { $angle }°
cuts-not-back = { $tool }: its second edge would rub on the way back, φ1 = { $angle }°
feed-within-jaws = feed { $feed } (of { $before }) mm/rev at { $rpm } rpm, so that the jaws hold the cut of the blade
feed-within-part = feed { $feed } instead of { $before } mm/rev, so that the part bends within its share of the tolerance
