no-lathe = no lathe is named (`machine:`): what it can finish, depth, conditions and power are not checked
no-intermediate-contour = the intermediate allowance cannot be applied: { $why }
no-rough-contour = the rough contour cannot be built: { $why }
no-contour-of-nose = { $tool }: the contour cannot be offset for its nose: { $why }; its toolpaths are those of a sharp tip
set-up-not-held = set-up { $number }: no part of it is long enough for the jaws; hold it between centres or leave a longer blank
far-face-as-parted = nothing of the part is long enough to hold it turned over, so its far face stays as the blade leaves it: rough, hollow by some tenths, perhaps with a pip
far-face-cut-away = set-up { $number }: { $length } mm of the blank are left behind the part; they are faced away: it is cheaper to saw them off before this set-up down to a facing allowance; they are not parted off: { $why ->
        [no-bar] the blank is no bar or tube in a chuck
        [centre] a part that comes off between chuck and centre jams the blade
        [rest] the steady rest stands before the place
        [no-blade] no blade of the catalog goes deep enough
        [short] too little of the blank is left for the jaws behind the blade
       *[hole] the hole through the part comes out too narrow for the blade
    }
face-frees-slug = set-up { $number }: the hole of Ø{ $diameter } is there already, so the last passes over the face set a disc free, which may jam: saw or part the end off before this set-up, or stop and take the disc out
shoulder-allowance-less = allowance on the shoulder of the bore at Z{ $z } { $left } mm instead of { $wanted } mm: the secondary edge of a bar that goes towards the axis takes no more, and behind its end the bar would go into the metal
bottom-allowance-less = allowance on the bottom of the bore { $left } mm instead of { $wanted } mm: the secondary edge of a bar that goes towards the axis takes no more; with 0 mm the flat drill finishes the bottom
bore-drilled-first = the bore is drilled first: Ø{ $diameter }, { $depth } mm deep; the diameter is our choice: a multiple of { $step } mm, at least { $stock } mm a side below the rough bore, and not above { $largest } mm
bore-too-narrow-to-drill = the bore of Ø{ $diameter } is too narrow to be drilled and bored
no-limiting-depth = the limiting depth is not known: give `roughing: {"{"}limiting_depth: …{"}"}` or a lathe, `machine:`
no-depth-allowed = { $tool }: no depth is allowed by { $bound }; take a lower feed, a stronger tool or a more powerful lathe
one-feed-for-all = these feeds are not given: { $feeds }; the main one is taken, so times are approximate
no-bar-for-bore = zone { $zone }: the bore of Ø{ $bore } is too narrow for the bars of the catalog, the slimmest of which enters Ø{ $least }
surface-of-blank = { $surface }: it is the surface of the blank and stays as it is; a blank with stock is needed where the drawing asks for more
    .help = give the blank stock there; where the bar is bought so (drawn, ground), leave grade and roughness of this surface out
blank-thin-for-elsewhere = { $surface }: the blank has no more than the { $allowance } mm a side that are left for the later operation, so its skin stays on: take a thicker blank
no-tool-for-zone = zone { $zone } ({ $side }): no tool of the catalog fits: φ ≥ { $main }° and φ1 ≥ { $secondary }° are needed
scheme-not-possible = zone { $zone }: the scheme { $scheme } is not possible, for the reason in the next line; the quickest of those that leave an even allowance is taken, if there is one
face-stock-thin = the blank's stock on the face is { $lack } mm less than the finishing allowance: take a longer blank
zone-behind-standing = zone { $zone }: the tool cannot reach it, because zone { $before } in front of it is not cleared
groove-too-deep = it is { $depth } mm deep, more than the { $reach } mm of the tool
part-gives-way = { $tool }: at t_p = { $depth } mm and the least feed the part gives way by { $percent } % of its tolerance: go over it once more at the same setting, and measure both ends of the cylinder
bounds-exceeded = { $tool }: at t_p = { $depth } mm these limits are exceeded: { $bounds }
    .help = leave less for finishing (`allowance:` of the surface), support the part (tailstock, steady rest, a second set-up), or let it stand out less
passes-shallower = zone { $zone }: { $tool } takes { $depth } mm a pass, not { $limit } mm: at that these limits would be exceeded: { $bounds }
tool-order = of those that fit this one is taken: { $prefer }
turning-skin = blank: { $kind }, its surface: { $surface }
returns-saved = one zone instead of one over each part: on the same levels of { $depth } mm { $joined } passes and returns instead of { $split }
turning-tool-taken = { $tool }: it fits this many zones: { $zones }
set-up-of-lathe = --set-up is for turned parts: this control is of a mill
    .help = leave it out, or name the control of a lathe: --control linuxcnc-lathe
only-for-steps = this is shown for a stepped shaft (`steps:`) only
    .help = for a contour there are `--show operation`, `schemes`, `program`, `cycle`, `setting` and `tool-table`
no-tool-table = a tool table is a file of LinuxCNC alone
    .help = give --control linuxcnc, or see --show setting
surface-not-finished = set-up { $number }: { $surface } (from Z { $z }): keeps its finishing allowance; no job finishes it
thread-not-cut = set-up { $number }: { $surface } (from Z { $z }): the thread is not cut
groove-not-cut = set-up { $number }: { $surface } (from Z { $z }): the groove is not cut
hollow-left = set-up { $number }: { $surfaces }: a hollow into which no tool of this set-up goes: from the free end it takes a turning tool of φ ≥ { $main }° and φ1 ≥ { $secondary }°
    .help = turn it from the other end with a left-hand tool, or give its steep wall a groove
ends-centred-before = between centres no tool reaches the faces: before, { $near } mm are faced off the free end and { $far } mm off the far one, and both are centred, A{ $pilot } by ГОСТ 14034-74
ends-faced-before = between centres no tool reaches the faces: before, { $near } mm are faced off the free end and { $far } mm off the far one; no centre hole of the table fits so thin an end
end-centred-before = at a centre no tool reaches the face of the free end: before, { $near } mm are faced off it and it is centred, A{ $pilot } by ГОСТ 14034-74
end-faced-before = at a centre no tool reaches the face of the free end: before, { $near } mm are faced off it; no centre hole of the table fits so thin an end
ends-faced-hollow = between centres no tool reaches the faces: before, { $near } mm are faced off the free end and { $far } mm off the far one; the centres stand in the bore: chamfer its mouths by 60° for them, or plug it
end-faced-hollow = at a centre no tool reaches the face of the free end: before, { $near } mm are faced off it; the centre stands in the bore: chamfer its mouth by 60° for it, or plug it
bore-behind-centre = set-up { $number }: the tailstock centre stands in the free end, where the bore is: no tool goes in; bore it before, or hold the part in the chuck alone
faced-through-centre = zone { $zone }: the face is turned to the axis, where the tailstock centre stands
    .help = face the blank and drill its centre holes first (`blank: {"{"}face: 0, …{"}"}`), or hold it in a chuck
jaws-not-proven = the chuck is not part of the proof: its size is not known (the record of a lathe has it: name one, `machine:`); watch the first run near it
jaws-not-proven-of-lathe = the chuck is not part of the proof: the record of the lathe does not have its size; watch the first run near it
jaws-not-proven-none = the chuck is not part of the proof: no surface is long enough for its jaws; watch the first run near it
tool-barred = set-up { $number }: { $tool } is not taken, the proof rejected it: { $why }
cut-barred = set-up { $number }: { $surfaces }: left, because the proof rejects { $tool } there: { $why }
job-left-out = set-up { $number }: left out, because the proof rejects it with every tool that is tried: { $work } with { $tool }, and what stands on it: { $why }
tailstock-stands = the proof has a centre that grows from Ø{ $mouth } at the face to Ø{ $body }, with a quill of Ø{ $quill } { $off } mm before the face; where yours is thinner (a centre with a turned-down body) or the quill stands farther off, the tool may clear it: try it at reduced rapid
centre-not-proven = the proof knows the stock and the tools, not the tailstock centre and its quill: watch the approach past them
rest-seat = set-up { $number }: a steady rest of { $width } mm stands at Z { $z } on Ø{ $diameter } of the blank, which has to be round and run true there: turn a seat first, by hand or in an operation of its own
over-driver = set-up { $number }: between centres the tool goes { $past } mm past the far face, where the part is driven, and the driver is not known here: only a face driver of less than Ø{ $diameter } stays clear, a dog on the shaft would be struck
no-tool-to-finish = { $side }: no tool finishes this contour: it needs φ of at least { $main }° and φ1 of at least { $secondary }°
    .help = give the steep surfaces a groove or a second set-up, or add a tool to the catalog
finish-feed-of = finishing feed { $feed } mm/rev ({ $roughness }): { $surfaces }
finish-feed-of-others = finishing feed { $feed } mm/rev ({ $roughness }): the other surfaces
finish-one-speed = one step of the spindle for the whole pass, { $rpm } rpm, that of Ø{ $diameter }: a step that is changed in the cut marks the surface; Ø{ $least } is cut at { $speed } m/min only, its own step would be { $own } rpm
finish-tool-presses-less = { $tool } is taken instead of { $instead }, which presses harder and, because the part bends, would have to be fed slower
nose-fills-hollow = the nose of radius { $nose } mm fills the hollow of radius { $hollow } mm; no tool has a smaller one
    .help = draw the bore with the cone of a drill at its bottom, make it a through hole, or finish the bottom with a flat drill
lathe-unsafe = its program is not written, because the proof rejects it: { $why }
    .help = the page of the operation lists every finding; change the part, its blank, tool or scheme until there is none
turning-not-proven = set-up { $number }: what it does to the stock could not be proven: { $why }
field-off-size = { $surface }: the field { $field } does not contain Ø{ $diameter }, and that is the size that the program makes
    .help = give the middle of the field as the diameter, and the grade as a number: for Ø20 f7 (19.959 to 19.980) Ø19.97 and `grade: 7`
turret-too-small = { $tools } tools, and the turret of { $lathe } has { $places } places: they share places, T{ $place }/{ $offset } is tool { $offset } in place { $place }; { $stops ->
        [0] they are changed by hand between the set-ups
        [one] at one planned stop (M0) of the programs they are changed by hand
       *[other] at { $stops } planned stops (M0) of the programs they are changed by hand
    }, see the setting sheet
job-dry = cut dry, without coolant
